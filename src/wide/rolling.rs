//! The Taylor series of a rolling disk, all products of one order side by side in the lanes of the registers.

use crate::integrate::{Expand, Series, TAYLOR_ORDER};
use crate::rolling::{RollingSeries, sin_cos_tilt};
use pulp::{Simd, WithSimd};

/// The coefficients of [`RollingSeries`], to rounding, several times as fast.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lanes(pub(crate) RollingSeries);

/// How many products the rates consist of, and room to spare.
const LANES: usize = 16;

/// One factor of each product, or the sum of what has been found of each.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
struct Row([f64; LANES]);

const NOTHING: Row = Row([0.0; LANES]);

/// Half of the orders: of two whose sum is one of them, the smaller lies below.
const HALF: usize = TAYLOR_ORDER / 2;

/// 1/(n + 1).
const OVER: [f64; TAYLOR_ORDER] = {
    let (mut over, mut n) = ([0.0; TAYLOR_ORDER], 0);
    while n < TAYLOR_ORDER {
        over[n] = 1.0 / (n + 1) as f64;
        n += 1;
    }
    over
};

impl Expand<8> for Lanes {
    fn expand(&self, series: &mut Series<8>) {
        pulp::Arch::new().dispatch(Expansion { disk: self.0, series });
    }
}

/// The work of [`Lanes::expand`], for registers of any width.
struct Expansion<'a> {
    disk: RollingSeries,
    series: &'a mut Series<8>,
}

impl WithSimd for Expansion<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { disk: RollingSeries { transverse: i1, axial: i3, film }, series } = self;
        let (ratio, rolling) = (i3 / i1, i3 + 1.0);
        let (over_1, over_1_rolling, over_3_rolling) = (1.0 / i1, 1.0 / (i1 + 1.0), 1.0 / rolling);
        let [y0, u0, o0, n0, ..] = series[0];
        let (sin, c0) = sin_cos_tilt(y0);
        let r0 = sin.recip();
        let h0 = sin * sin;
        let k0 = film * r0 * r0 * r0;
        let z0 = RollingSeries::from_curvature(o0, n0 + o0 * c0);
        (series[0][6], series[0][7]) = (z0.re, z0.im);

        let (mut r, mut h, mut c, mut k) = (r0, h0, c0, k0);
        let (mut left, mut right) = ([NOTHING; HALF], [NOTHING; HALF]);
        let mut sums = [NOTHING; TAYLOR_ORDER];
        for j in 0..TAYLOR_ORDER {
            let [_, u, o, n, _, _, re, im] = series[j];
            // Of a product's coefficient the sum holds all but what the first row and this one make. What is known last
            // comes last.
            let (sum, first) = (sums[j].0, right[0].0);
            let early = sum[0] + c * first[0];
            let g = early + c0 * u;
            let slow_o = (2.0 * early - k * over_1) + (2.0 * c0) * u;
            let slow_u = (early - k * over_1_rolling) + c0 * u;
            let oc = (sum[1] + o0 * c) + o * first[1];
            let gyro = i1 * oc + rolling * n;
            let un = (sum[2] + u * first[2]) + u0 * n;
            let cr = (sum[3] + c * first[3]) + c0 * r;
            let s = (sum[4] + u * first[4]) + u0 * h;
            let hg = (sum[5] + h * first[5]) + h0 * g;
            let rg = (sum[6] + r * first[6]) + r0 * g;
            let kg = (sum[7] + k * first[7]) + k0 * g;
            let o_slow = (sum[8] + o * first[8]) + o0 * slow_o;
            let u_slow = (sum[9] + u * first[9]) + u0 * slow_u;
            let o_gyro = (sum[10] + o * first[10]) + o0 * gyro;
            let os = (sum[11] + o * first[11]) + o0 * s;
            let o_re = (sum[12] + o * first[12]) + o0 * re;
            let o_im = (sum[13] + o * first[13]) + o0 * im;
            let l = Row([c, o, u, c, u, h, r, k, o, u, o, o, o, o, 0.0, 0.0]);
            let m = Row([u, c, n, r, h, g, g, g, slow_o, slow_u, gyro, s, re, im, 0.0, 0.0]);

            let over = OVER[j];
            let roll = n + oc;
            series[j + 1] = [
                -u * over,
                (cr - o_gyro) * (over_1_rolling * over) + u_slow * over,
                un * (ratio * over) + o_slow * over,
                os * (over_3_rolling * over),
                o * over,
                roll * over,
                (o_im - roll) * over,
                -o_re * over,
            ];
            c = s * over;
            h = hg * (-2.0 * over);
            r = rg * over;
            k = kg * (3.0 * over);
            // What this row and the earlier ones add to the products still to come.
            if j < HALF {
                (left[j], right[j]) = (l, m);
                if j > 0 {
                    add_products(simd, &mut sums[2 * j], [(&l, &m)]);
                }
            }
            for i in 1..j.min(TAYLOR_ORDER - j) {
                add_products(simd, &mut sums[j + i], [(&l, &right[i]), (&left[i], &m)]);
            }
        }
    }
}

/// Adds to `sum`, lane by lane, the products of these pairs.
#[inline(always)]
fn add_products<S: Simd, const N: usize>(simd: S, sum: &mut Row, pairs: [(&Row, &Row); N]) {
    let (sum, _) = S::as_mut_simd_f64s(&mut sum.0);
    let pairs = pairs.map(|(left, right)| (S::as_simd_f64s(&left.0).0, S::as_simd_f64s(&right.0).0));
    for (i, sum) in sum.iter_mut().enumerate() {
        let products = pairs.map(|(left, right)| simd.mul_f64s(left[i], right[i]));
        let together = products.into_iter().reduce(|a, b| simd.add_f64s(a, b));
        if let Some(together) = together {
            *sum = simd.add_f64s(*sum, together);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Expansion, Lanes};
    use crate::integrate::{Expand, TAYLOR_ORDER};
    use crate::rolling::RollingSeries;
    use pulp::WithSimd;

    const FILM: RollingSeries = RollingSeries { transverse: 0.4, axial: 0.5, film: 0.003 };

    /// The series of a hundred states, by the readable expansion, in lanes, and in lanes one after the other.
    fn series() -> impl Iterator<Item = [[[f64; 8]; TAYLOR_ORDER + 1]; 3]> {
        let mut random = fastrand::Rng::with_seed(6);
        (0..100).map(move |_| {
            let mut start = [[0.0; 8]; TAYLOR_ORDER + 1];
            start[0].fill_with(|| 2.0 * random.f64() - 1.0);
            let [mut plain, mut wide, mut narrow] = [start; 3];
            FILM.expand(&mut plain);
            Lanes(FILM).expand(&mut wide);
            Expansion { disk: FILM, series: &mut narrow }.with_simd(pulp::Scalar::new());
            [plain, wide, narrow]
        })
    }

    #[test]
    fn the_lanes_hold_the_coefficients_of_the_readable_series() {
        for [plain, wide, _] in series() {
            let size = |row: &[f64; 8]| row.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            for (plain, wide) in plain.iter().zip(wide) {
                for (a, b) in plain.iter().zip(wide) {
                    assert!((a - b).abs() < 1e-12 * size(plain), "{plain:?} {wide:?}");
                }
            }
        }
    }

    #[test]
    fn the_series_is_the_same_in_registers_of_any_width() {
        for [_, wide, narrow] in series() {
            assert_eq!(wide, narrow);
        }
    }
}

//! The Taylor series of a wheel that rolls without slipping, with the drag of a film of air under it.
//!
//! Lengths in radii, times in √(a/g), masses in the wheel's. The wheel's lean from lying flat is β, and
//!
//! - `y = ln tan(β/2)`, so that sin β = 1/cosh y and cos β = −tanh y;
//! - `u = β̇/sin β = ẏ` and `O = ω₂/sin β`, the rate of the heading ψ;
//! - `w`, the angular velocity about the upward normal, and φ, the turn about it relative to the frame, φ̇ = w − O cos β.
//!
//! In these variables the equations of motion are sums of products, without a quotient or a function of an angle.
//!
//! The contact moves with −φ̇ e^{iψ} in the plane of the table. Its path winds, and the series of e^{iψ} would ask for short steps. So it is
//! followed as z in `anchor + z e^{iψ}`, ż = −φ̇ − iOz, from an anchor that is chosen anew for each series: the centre of the path's
//! curvature, about which z is at rest to begin with and stays so for a steady motion.

use crate::integrate::{Expand, Series, TAYLOR_ORDER};
use nalgebra::Complex;
use pulp::{Simd, WithSimd};

/// A wheel and its drag, for [`crate::integrate::Taylor`]; the state is y, u, O, w, ψ, φ and both parts of z, which each series sets anew.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RollingSeries {
    /// The moment about a diameter.
    pub(crate) across: f64,
    /// The moment about the axis.
    pub(crate) along: f64,
    /// K: the film takes the torque K times ω₁ and ω₂ over sin³ β.
    pub(crate) drag: f64,
}

/// The anchor of a series that begins with the contact `here` and with the heading `facing`, e to the i times it.
pub(crate) fn anchor(series: &Series<8>, here: Complex<f64>, facing: Complex<f64>) -> Complex<f64> {
    here - from_anchor(&series[0]) * facing
}

/// Where the contact is in a state of the series with this anchor, and e to the i times the heading.
pub(crate) fn contact(anchor: Complex<f64>, state: &[f64; 8]) -> (Complex<f64>, Complex<f64>) {
    let facing = Complex::cis(state[4]);
    (anchor + from_anchor(state) * facing, facing)
}

/// The number z of a state.
fn from_anchor(&[.., re, im]: &[f64; 8]) -> Complex<f64> {
    Complex::new(re, im)
}

/// Sine and cosine of β, each to rounding: the cosine too, which is small where the wheel stands upright.
pub(crate) fn sin_cos_tilt(y: f64) -> (f64, f64) {
    let less_one = y.abs().exp_m1();
    let growing = less_one + 1.0;
    let falling = growing.recip();
    let sin = 2.0 / (growing + falling);
    (sin, (0.5 * (less_one + less_one * falling) * sin).copysign(-y))
}

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

/// Below this rate of the heading, in √(g/a), the anchor comes nearer than the centre of curvature.
const SLOW_HEADING: f64 = 0.3;

impl Expand<8> for RollingSeries {
    fn expand(&self, series: &mut Series<8>) {
        pulp::Arch::new().dispatch(Expansion { wheel: *self, series });
    }
}

/// The work of [`RollingSeries::expand`], for registers of any width.
struct Expansion<'a> {
    wheel: RollingSeries,
    series: &'a mut Series<8>,
}

impl WithSimd for Expansion<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { wheel: RollingSeries { across: a, along, drag }, series } = self;
        let (ratio, wheel) = (along / a, along + 1.0);
        let (over_a, over_a1, over_c1) = (1.0 / a, 1.0 / (a + 1.0), 1.0 / wheel);
        let [y0, u0, o0, w0, ..] = series[0];
        let (sin, c0) = sin_cos_tilt(y0);
        let q0 = sin.recip();
        let h0 = sin * sin;
        let k0 = drag * q0 * q0 * q0;
        let curved = (w0 - o0 * c0) * o0 / (o0 * o0 + SLOW_HEADING * SLOW_HEADING);
        (series[0][6], series[0][7]) = (0.0, curved);

        let (mut q, mut h, mut c, mut k) = (q0, h0, c0, k0);
        let (mut left, mut right) = ([NOTHING; HALF], [NOTHING; HALF]);
        let mut sums = [NOTHING; TAYLOR_ORDER];
        for n in 0..TAYLOR_ORDER {
            let [_, u, o, w, _, _, re, im] = series[n];
            // Of a product's coefficient the sum holds all but what the first row and this one make. What is known last comes last.
            let (sum, r0) = (sums[n].0, right[0].0);
            let early = sum[0] + c * r0[0];
            let g = early + c0 * u;
            let slow_o = (2.0 * early + k * over_a) + (2.0 * c0) * u;
            let slow_u = (early + k * over_a1) + c0 * u;
            let oc = (sum[1] + o0 * c) + o * r0[1];
            let gyro = a * oc - wheel * w;
            let uw = (sum[2] + u * r0[2]) + u0 * w;
            let cq = (sum[3] + c * r0[3]) + c0 * q;
            let s = (sum[4] + u * r0[4]) + u0 * h;
            let hg = (sum[5] + h * r0[5]) + h0 * g;
            let qg = (sum[6] + q * r0[6]) + q0 * g;
            let kg = (sum[7] + k * r0[7]) + k0 * g;
            let o_slow = (sum[8] + o * r0[8]) + o0 * slow_o;
            let u_slow = (sum[9] + u * r0[9]) + u0 * slow_u;
            let o_gyro = (sum[10] + o * r0[10]) + o0 * gyro;
            let os = (sum[11] + o * r0[11]) + o0 * s;
            let o_re = (sum[12] + o * r0[12]) + o0 * re;
            let o_im = (sum[13] + o * r0[13]) + o0 * im;
            let l = Row([c, o, u, c, u, h, q, k, o, u, o, o, o, o, 0.0, 0.0]);
            let r = Row([u, c, w, q, h, g, g, g, slow_o, slow_u, gyro, s, re, im, 0.0, 0.0]);

            let over = OVER[n];
            let spin = w - oc;
            series[n + 1] = [
                u * over,
                (o_gyro - cq) * (over_a1 * over) - u_slow * over,
                uw * (ratio * over) - o_slow * over,
                os * (over_c1 * over),
                o * over,
                spin * over,
                (o_im - spin) * over,
                -o_re * over,
            ];
            c = -s * over;
            h = hg * (2.0 * over);
            q = -qg * over;
            k = kg * (-3.0 * over);
            // What this row and the earlier ones add to the products still to come.
            if n < HALF {
                (left[n], right[n]) = (l, r);
                if n > 0 {
                    add_products(simd, &mut sums[2 * n], [(&l, &r)]);
                }
            }
            for j in 1..n.min(TAYLOR_ORDER - n) {
                add_products(simd, &mut sums[n + j], [(&l, &right[j]), (&left[j], &r)]);
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
    use super::{Expansion, RollingSeries};
    use crate::integrate::{Dop853, Expand, TAYLOR_ORDER, Taylor};
    use pulp::WithSimd;

    const FILM: RollingSeries = RollingSeries { across: 0.25, along: 0.5, drag: 0.003 };

    /// The rates of β, w₁, w₂, w₃, ψ, φ as they are derived.
    fn rates(film: &RollingSeries, _t: f64, &[beta, w1, w2, w3, _, _]: &[f64; 6]) -> [f64; 6] {
        let RollingSeries { across: a, along: c, drag } = *film;
        let (sin, cos) = beta.sin_cos();
        let o3 = w2 * cos / sin;
        let torque = drag / (sin * sin * sin);
        [
            w1,
            (a * w2 * o3 - (c + 1.0) * w2 * w3 - cos - torque * w1) / (a + 1.0),
            (c * w1 * w3 - a * w1 * o3 - torque * w2) / a,
            w1 * w2 / (c + 1.0),
            w2 / sin,
            w3 - o3,
        ]
    }

    #[test]
    fn the_series_is_the_motion() {
        let start = [0.9, 0.4, 0.3, -1.1, 0.0, 0.0];
        let [beta, w1, w2, w3, ..] = start;
        let state = [(0.5_f64 * beta).tan().ln(), w1 / beta.sin(), w2 / beta.sin(), w3, 0.0, 0.0, 0.0, 0.0];
        let end = Taylor::new(1e-16).unwrap().solve(&FILM, 0.0, state, 3.0).unwrap();
        let judge = Dop853::new(1e-14)
            .unwrap()
            .solve(|t, y: &[f64; 6]| rates(&FILM, t, y), 0.0, start, 3.0)
            .unwrap()
            .state;
        let [y, u, o, w, psi, phi, ..] = end.state;
        let beta = 2.0 * y.exp().atan();
        let ours = [beta, u * beta.sin(), o * beta.sin(), w, psi, phi];
        for (a, b) in ours.iter().zip(judge) {
            assert!((a - b).abs() < 1e-12, "{ours:?} {judge:?}");
        }
        assert!(end.work.accepted > 3);
    }

    #[test]
    fn the_series_is_the_same_in_registers_of_any_width() {
        let mut random = fastrand::Rng::with_seed(6);
        for _ in 0..100 {
            let mut wide = [[0.0; 8]; TAYLOR_ORDER + 1];
            wide[0].fill_with(|| 2.0 * random.f64() - 1.0);
            let mut narrow = wide;
            FILM.expand(&mut wide);
            Expansion { wheel: FILM, series: &mut narrow }.with_simd(pulp::Scalar::new());
            assert_eq!(wide, narrow);
        }
    }
}

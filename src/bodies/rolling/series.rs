//! The Taylor series of a rolling disk, in variables in which the equations of motion are sums of products
//! (`eq:rolling-series`).
//!
//! Lengths in radii, times in √(a/g), masses in the disk's. Instead of the tilt and two of the angular velocities there
//! are
//!
//! - `y = ln tan(α/2)`, so that sin α = 1/cosh y and cos α = −tanh y;
//! - `u = ω₁/sin α = −ẏ` and `Ω = ω₂/sin α`, the rate of the heading φ.
//!
//! The contact moves with `−ω_rel e^{iφ}` in the plane of the table. Its path winds, and the series of e^{iφ} would ask
//! for short steps. So it is followed as z in `anchor + z e^{iφ}`, `ż = −ω_rel − iΩz`, from an anchor that is chosen
//! anew for each series: the centre of the path's curvature, about which z is at rest to begin with and stays so for a
//! steady motion.

use super::{Disk, MomentFactors, Rolling, sin_cos_lean};
use crate::integrate::{Expand, Series, TAYLOR_ORDER};
use nalgebra::Complex;
use pulp::{Simd, WithSimd};

/// A disk for [`crate::integrate::Taylor`]; the state is y, u, Ω, n, φ, the roll angle and both parts
/// of z, which each series sets anew.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RollingSeries {
    pub(crate) transverse: f64,
    pub(crate) axial: f64,
    /// K of `eq:film-torque`.
    pub(crate) film: f64,
}

/// Below this rate of the heading, in √(g/a), the anchor comes nearer than the centre of curvature.
const SLOW_HEADING: f64 = 0.3;

/// How many products the rates consist of, and room to spare.
const PRODUCTS: usize = 16;

/// One factor of each product, or the sum of what has been found of each.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
struct Row([f64; PRODUCTS]);

const NOTHING: Row = Row([0.0; PRODUCTS]);

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

impl RollingSeries {
    /// z at the start of a series, from the centre of curvature.
    pub(crate) fn from_curvature(heading_rate: f64, roll_rate: f64) -> Complex<f64> {
        Complex::<f64>::i()
            * (roll_rate * heading_rate / (heading_rate * heading_rate + SLOW_HEADING * SLOW_HEADING))
    }
}

impl Expand<8> for RollingSeries {
    fn expand(&self, series: &mut Series<8>) {
        pulp::Arch::new().dispatch(Expansion { disk: *self, series });
    }
}

/// The work of [`RollingSeries::expand`], for registers of any width: all products of one order side by side.
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
        // c = cos α, r = 1/sin α, h = sin² α, k = K/sin³ α; o is Ω, and two letters together are a product.
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
            // eq:rolling-series
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
            // ċ = uh, ṙ = rcu, ḣ = −2hcu, k̇ = 3kcu
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

/// Adds to `sum`, number by number, the products of these pairs.
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

/// Sine and cosine of α, each to rounding: the cosine too, which is small where the disk stands upright.
fn sin_cos_tilt(y: f64) -> (f64, f64) {
    let less_one = y.abs().exp_m1();
    let growing = less_one + 1.0;
    let falling = growing.recip();
    let sin = 2.0 / (growing + falling);
    (sin, (0.5 * (less_one + less_one * falling) * sin).copysign(-y))
}

/// How a motion that the series follows from heading, roll angle and contact zero lies in the room.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Placed {
    radius: f64,
    unit_of_time: f64,
    heading: f64,
    roll_angle: f64,
    contact: Complex<f64>,
    facing: Complex<f64>,
}

impl Placed {
    /// A disk's series, its state at the start, and how that lies in the room.
    pub(crate) fn new(disk: &Disk, start: &Rolling) -> (RollingSeries, [f64; 8], Self) {
        let MomentFactors { transverse, axial } = disk.parameters.moments;
        let series = RollingSeries { transverse, axial, film: disk.film };
        let (radius, unit_of_time) = (disk.parameters.radius, disk.unit_of_time());
        let (sin, cos) = sin_cos_lean(start.tilt);
        let y = -(sin / cos).asinh();
        let [u, turn] = [start.omega_1, start.omega_2].map(|omega| omega * unit_of_time / cos);
        let state = [y, u, turn, start.omega_3 * unit_of_time, 0.0, 0.0, 0.0, 0.0];
        let Rolling { heading, roll_angle, .. } = *start;
        let (contact, facing) = (start.contact(radius), Complex::cis(heading));
        (series, state, Self { radius, unit_of_time, heading, roll_angle, contact, facing })
    }

    /// √(a/g), s.
    pub(crate) fn unit_of_time(&self) -> f64 {
        self.unit_of_time
    }

    /// A state of the series with its contact, in radii, and e to the i times its heading, in the room.
    pub(crate) fn in_room(&self, state: &[f64; 8], contact: Complex<f64>, facing: Complex<f64>) -> Rolling {
        let &[y, u, turn, n, heading, roll_angle, ..] = state;
        let (sin_tilt, cos_tilt) = sin_cos_tilt(y);
        let contact = self.contact + self.facing * contact * self.radius;
        // The centre is a sin θ inward of the contact.
        let outward = Complex::<f64>::i() * self.facing * facing;
        Rolling {
            tilt: sin_tilt.atan2(cos_tilt),
            omega_1: u * sin_tilt / self.unit_of_time,
            omega_2: turn * sin_tilt / self.unit_of_time,
            omega_3: n / self.unit_of_time,
            heading: self.heading + heading,
            roll_angle: self.roll_angle + roll_angle,
            centre: contact - outward * (self.radius * cos_tilt),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Expansion, RollingSeries};
    use crate::integrate::{Expand, TAYLOR_ORDER};
    use pulp::WithSimd;

    #[test]
    fn the_series_is_the_same_in_registers_of_any_width() {
        let disk = RollingSeries { transverse: 0.4, axial: 0.5, film: 0.003 };
        let mut random = fastrand::Rng::with_seed(6);
        for _ in 0..100 {
            let mut wide = [[0.0; 8]; TAYLOR_ORDER + 1];
            wide[0].fill_with(|| 2.0 * random.f64() - 1.0);
            let mut narrow = wide;
            disk.expand(&mut wide);
            Expansion { disk, series: &mut narrow }.with_simd(pulp::Scalar::new());
            assert_eq!(wide, narrow);
        }
    }
}

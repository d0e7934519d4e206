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

/// One coefficient for each order.
type Row = [f64; TAYLOR_ORDER + 1];

impl RollingSeries {
    /// z at the start of a series, from the centre of curvature.
    pub(crate) fn from_curvature(heading_rate: f64, roll_rate: f64) -> Complex<f64> {
        Complex::<f64>::i()
            * (roll_rate * heading_rate / (heading_rate * heading_rate + SLOW_HEADING * SLOW_HEADING))
    }
}

impl Expand<8> for RollingSeries {
    fn expand(&self, series: &mut Series<8>) {
        let &Self { transverse: i1, axial: i3, film } = self;
        let zero: Row = [0.0; TAYLOR_ORDER + 1];
        let [mut y, mut u, mut turn, mut n, mut heading, mut roll] = [zero; 6];
        // cos α, 1/sin α, sin² α, K/sin³ α
        let [mut c, mut r, mut h, mut k] = [zero; 4];
        // cos α u; the two rates of slowing; I₁Ω cos α + (1 + I₃)n; sin² α u
        let [mut g, mut slowing_u, mut slowing_turn, mut gyro, mut s] = [zero; 5];
        let mut z = [Complex::new(0.0, 0.0); TAYLOR_ORDER + 1];

        [y[0], u[0], turn[0], n[0], heading[0], roll[0], ..] = series[0];
        let (sin, cos) = sin_cos_tilt(y[0]);
        (c[0], r[0], h[0], k[0]) = (cos, sin.recip(), sin * sin, film / (sin * sin * sin));
        z[0] = Self::from_curvature(turn[0], n[0] + turn[0] * cos);
        (series[0][6], series[0][7]) = (z[0].re, z[0].im);

        for j in 0..TAYLOR_ORDER {
            // Coefficient j of a product, and coefficient j + 1 of what has this rate.
            let product = |a: &Row, b: &Row| (0..=j).map(|i| a[i] * b[j - i]).sum::<f64>();
            let over = 1.0 / (j + 1) as f64;

            g[j] = product(&c, &u);
            slowing_u[j] = g[j] - k[j] / (1.0 + i1);
            slowing_turn[j] = 2.0 * g[j] - k[j] / i1;
            s[j] = product(&h, &u);
            let frame_roll = product(&turn, &c);
            gyro[j] = (1.0 + i3) * n[j] + i1 * frame_roll;
            let roll_rate = n[j] + frame_roll;
            let turned: Complex<f64> = (0..=j).map(|i| z[i] * turn[j - i]).sum();

            // eq:rolling-series
            y[j + 1] = -u[j] * over;
            u[j + 1] =
                ((product(&c, &r) - product(&turn, &gyro)) / (1.0 + i1) + product(&u, &slowing_u)) * over;
            turn[j + 1] = (i3 / i1 * product(&u, &n) + product(&turn, &slowing_turn)) * over;
            n[j + 1] = product(&s, &turn) / (1.0 + i3) * over;
            heading[j + 1] = turn[j] * over;
            roll[j + 1] = roll_rate * over;
            z[j + 1] = -(roll_rate + Complex::<f64>::i() * turned) * over;
            // ċ = uh, ṙ = rcu, ḣ = −2hcu, k̇ = 3kcu
            c[j + 1] = s[j] * over;
            r[j + 1] = product(&r, &g) * over;
            h[j + 1] = -2.0 * product(&h, &g) * over;
            k[j + 1] = 3.0 * product(&k, &g) * over;
        }
        for (j, row) in series.iter_mut().enumerate().skip(1) {
            *row = [y[j], u[j], turn[j], n[j], heading[j], roll[j], z[j].re, z[j].im];
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
pub(crate) fn sin_cos_tilt(y: f64) -> (f64, f64) {
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

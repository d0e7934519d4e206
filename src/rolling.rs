//! The Taylor series of a wheel that rolls without slipping, with the drag of a film of air under it.
//!
//! Lengths in radii, times in √(a/g), masses in the wheel's. The wheel's lean from lying flat is β, and
//!
//! - `y = ln tan(β/2)`, so that sin β = 1/cosh y and cos β = −tanh y;
//! - `u = β̇/sin β = ẏ` and `O = ω₂/sin β`, the rate of the heading ψ;
//! - `w`, the angular velocity about the upward normal, and φ, the turn about it relative to the frame, φ̇ = w − O cos β.
//!
//! In these variables the equations of motion are sums of products, without a quotient or a function of an angle.

use crate::branchless::sin_cos_quarters;
use crate::integrate::{Expand, Series, TAYLOR_ORDER};
use nalgebra::Complex;
use std::f64::consts::FRAC_2_PI;
use wide::f64x4;

/// Products of which the rates consist.
const LANES: usize = 12;

/// One factor of each product. Left to itself the compiler works across the wrong index for some processors.
type Row = [f64x4; 3];

/// A wheel and its drag, for [`crate::integrate::Taylor`]; the state is y, u, O, w, ψ, φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RollingSeries {
    /// The moment about a diameter.
    pub(crate) across: f64,
    /// The moment about the axis.
    pub(crate) along: f64,
    /// K: the film takes the torque K times ω₁ and ω₂ over sin³ β.
    pub(crate) drag: f64,
}

impl Expand<6> for RollingSeries {
    fn expand(&self, series: &mut Series<6>) {
        let (a, c_moment) = (self.across, self.along);
        let ratio = c_moment / a;
        let (over_a, over_a1, over_c1) = (1.0 / a, 1.0 / (a + 1.0), 1.0 / (c_moment + 1.0));
        let growing = series[0][0].exp();
        let falling = growing.recip();
        let mut q = 0.5 * (growing + falling); // 1/sin β
        let mut h = (q * q).recip(); // sin² β
        let mut c = 0.5 * (falling - growing) / q; // cos β
        let mut k = self.drag * q * q * q;
        let mut left = [[f64x4::ZERO; 3]; TAYLOR_ORDER];
        let mut right = [[f64x4::ZERO; 3]; TAYLOR_ORDER];
        let mut sums = [[f64x4::ZERO; 3]; 2 * TAYLOR_ORDER];
        for n in 0..TAYLOR_ORDER {
            let [_, u, o, w, ..] = series[n];
            let (sum, l0, r0) = (scalars(&sums[n]), scalars(&left[0]), scalars(&right[0]));
            // Of a product's coefficient, the sum holds all but what the first row and this one make.
            let product = |lane: usize, x: f64, y: f64| {
                if n == 0 { x * y } else { sum[lane] + (x * r0[lane] + l0[lane] * y) }
            };
            let g = product(0, c, u);
            let oc = product(1, o, c);
            let uw = product(2, u, w);
            let cq = product(3, c, q);
            let s = product(4, u, h);
            let slowing = [2.0 * g + k * over_a, g + k * over_a1, a * oc - (c_moment + 1.0) * w];
            let hg = product(5, h, g);
            let qg = product(6, q, g);
            let kg = product(7, k, g);
            let o_slowing = product(8, o, slowing[0]);
            let u_slowing = product(9, u, slowing[1]);
            let o_precession = product(10, o, slowing[2]);
            let os = product(11, o, s);
            let l = row([c, o, u, c, u, h, q, k, o, u, o, o]);
            let r = row([u, c, w, q, h, g, g, g, slowing[0], slowing[1], slowing[2], s]);
            left[n] = l;
            right[n] = r;

            let over = 1.0 / (n + 1) as f64;
            series[n + 1] = [
                u * over,
                (o_precession - cq) * (over_a1 * over) - u_slowing * over,
                uw * (ratio * over) - o_slowing * over,
                os * (over_c1 * over),
                o * over,
                (w - oc) * over,
            ];
            c = -s * over;
            h = hg * (2.0 * over);
            q = -qg * over;
            k = kg * (-3.0 * over);
            // What this row and the earlier ones add to the products still to come.
            if n > 0 {
                for j in 1..n.min(TAYLOR_ORDER - n) {
                    for i in 0..3 {
                        sums[n + j][i] += l[i] * right[j][i] + left[j][i] * r[i];
                    }
                }
                for i in 0..3 {
                    sums[2 * n][i] += l[i] * r[i];
                }
            }
        }
    }
}

#[inline(always)]
fn row(v: [f64; LANES]) -> Row {
    let [a, b, c, d, e, f, g, h, i, j, k, l] = v;
    [[a, b, c, d].into(), [e, f, g, h].into(), [i, j, k, l].into()]
}

#[inline(always)]
fn scalars(row: &Row) -> [f64; LANES] {
    let [a, b, c, d] = row[0].to_array();
    let [e, f, g, h] = row[1].to_array();
    let [i, j, k, l] = row[2].to_array();
    [a, b, c, d, e, f, g, h, i, j, k, l]
}

/// How far the point of contact moves in the time `since` from the start of a step, in radii: `∫ −φ̇ e^{iψ} dt`.
///
/// By Gauss's rule with eight points, exact for polynomials of degree 15, on the step's series.
pub(crate) fn contact_path(series: &Series<6>, since: f64) -> Complex<f64> {
    let times = NODES.map(|node| 0.5 * since * (1.0 + node));
    let (mut turn, mut rate) = ([0.0; POINTS], [0.0; POINTS]);
    for (j, row) in series.iter().enumerate().skip(1).rev() {
        let order = j as f64;
        for n in 0..POINTS {
            rate[n] = rate[n] * times[n] + order * row[5];
            turn[n] = (turn[n] + row[4]) * times[n];
        }
    }
    let (mut x, mut y) = ([0.0; POINTS], [0.0; POINTS]);
    for n in 0..POINTS {
        let (sin, cos) = sin_cos_quarters(turn[n] * FRAC_2_PI, 0.0);
        (x[n], y[n]) = (WEIGHTS[n] * rate[n] * cos, WEIGHTS[n] * rate[n] * sin);
    }
    let sum = Complex::new(x.iter().sum::<f64>(), y.iter().sum::<f64>());
    let (sin, cos) = series[0][4].sin_cos();
    sum * Complex::new(cos, sin) * (-0.5 * since)
}

const POINTS: usize = 8;
/// Nodes and weights on −1 to 1 (*Digital Library of Mathematical Functions*, §3.5, table 3.5.3 onwards).
const NODES: [f64; POINTS] = [
    -0.960_289_856_497_536_2,
    -0.796_666_477_413_626_7,
    -0.525_532_409_916_329,
    -0.183_434_642_495_649_8,
    0.183_434_642_495_649_8,
    0.525_532_409_916_329,
    0.796_666_477_413_626_7,
    0.960_289_856_497_536_2,
];
const WEIGHTS: [f64; POINTS] = [
    0.101_228_536_290_376_26,
    0.222_381_034_453_374_48,
    0.313_706_645_877_887_3,
    0.362_683_783_378_362,
    0.362_683_783_378_362,
    0.313_706_645_877_887_3,
    0.222_381_034_453_374_48,
    0.101_228_536_290_376_26,
];

#[cfg(test)]
mod tests {
    use super::RollingSeries;
    use crate::integrate::{Dop853, Taylor};

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
        let state = [(0.5_f64 * beta).tan().ln(), w1 / beta.sin(), w2 / beta.sin(), w3, 0.0, 0.0];
        let end = Taylor::new(1e-16).unwrap().solve(&FILM, 0.0, state, 3.0).unwrap();
        let judge = Dop853::new(1e-14)
            .unwrap()
            .solve(|t, y: &[f64; 6]| rates(&FILM, t, y), 0.0, start, 3.0)
            .unwrap()
            .state;
        let [y, u, o, w, psi, phi] = end.state;
        let beta = 2.0 * y.exp().atan();
        let ours = [beta, u * beta.sin(), o * beta.sin(), w, psi, phi];
        for (a, b) in ours.iter().zip(judge) {
            assert!((a - b).abs() < 1e-12, "{ours:?} {judge:?}");
        }
        assert!(end.work.accepted > 3);
    }
}

//! The three theta functions of a top's motion, over the one that they share.
//!
//! `ϑ₁(v − iη)/ϑ₄(v)` for a number that vanishes where the axis hangs, `ϑ₂(v − iη)/ϑ₄(v)` for one that vanishes upright
//! and one that vanishes at a cusp (`eq:top-thetas`). As for a free body the nome `q = e^{−πK'/K}` is used where `k² ≤
//! ½`, else `q' = e^{−πK/K'}`. A number that is nearly zero keeps its digits: its direction is asked for at the start.

use crate::elementary::{exp, exp_and_exp_m1, sin_cos_quarters};
use crate::free_rotation::theta::{
    Cubic, Parts, alternating, cos_even, cos_odd, cubic, sin_odd, within_half_period,
};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

/// The first of the three is `ϑ₁`, the others are `ϑ₂`.
const NUMBERS: usize = 3;

/// What three functions are at one argument, up to a positive factor for each.
pub(super) struct Values {
    pub(super) thetas: [[f64; 2]; NUMBERS], // real and imaginary part, for η > 0
    pub(super) flip: u64,                   // the sign bit that all three still have to take
    pub(super) rest: f64,                   // times `drift`: by how much they turn on, in quarter turns
}

/// The theta functions of one side, without a branch; for `ONE` the argument may be of any size.
pub(super) trait Thetas: Copy {
    fn at<const ONE: bool>(&self, argument: f64, argument_low: f64) -> Values;

    /// The turn of each for a rest of one.
    fn drift(&self) -> [f64; NUMBERS];
}

/// Both sides.
#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "one for thousands of states")]
pub(super) enum Sides {
    /// The argument comes in quarter turns of `v = πu/2K`.
    Slow(Slow),
    /// The argument comes in half periods 2K; on the separatrix, where there are none, it is u.
    Fast(Fast),
}

/// Circular functions of v, polynomials in cos 2v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slow {
    parts: [[Cubic; 2]; NUMBERS],
    below: Cubic,
}

/// Polynomials in `E = e^{−2w}` and `F = q'e^{2w}`, with `w = πu/2K'`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fast {
    stretch: f64, // w is this times the rest of a half period
    twice: f64,   // ln F is this times the rest beyond a quarter period, less `cut`
    cut: f64,
    wraps: f64, // 1, or 0 on the separatrix, where nothing comes back
    drift: [f64; NUMBERS],
    below: Parts,
    first: [Parts; 2],
    factor: Parts, // of 1 − F in the second and the third, less one
    others: [[Parts; 2]; NUMBERS - 1],
}

impl Sides {
    /// From `k²`, K, K' and the three zeros y, `η = πy/2K`.
    pub(super) fn new(parameter: f64, [quarter, other_quarter]: [f64; 2], zeros: [f64; NUMBERS]) -> Self {
        if parameter <= 0.5 {
            let nome = (-PI * other_quarter / quarter).exp();
            Self::Slow(Slow::new(nome, zeros.map(|zero| FRAC_PI_2 * zero / quarter)))
        } else {
            let nome = (-PI * quarter / other_quarter).exp();
            let angles = zeros.map(|zero| FRAC_PI_2 * zero / other_quarter);
            Self::Fast(Fast::new(nome, angles, [quarter, other_quarter]))
        }
    }

    /// Three numbers that only turn.
    pub(super) fn still() -> Self {
        let one = [1.0, 0.0, 0.0, 0.0];
        Self::Slow(Slow { parts: [[[0.0; 4], one], [one, [0.0; 4]], [one, [0.0; 4]]], below: one })
    }
}

impl Slow {
    fn new(nome: f64, etas: [f64; NUMBERS]) -> Self {
        let power = |n: usize| nome.powi(n as i32);
        // cosh (2j+1)η and sinh (2j+1)η over e^η, times q^{j(j+1)}; η is infinite where nothing nods.
        let weights = |eta: f64, sign: f64, signs: fn(usize) -> f64| {
            std::array::from_fn(|j| {
                let weight = signs(j) * power(j * (j + 1));
                let (less, more) = (2.0 * j as f64, 2.0 * (j + 1) as f64);
                let grown = if j == 0 { 1.0 } else { (less * eta).exp() };
                let sum = if sign < 0.0 {
                    // Without a difference: e^{2jη} (1 − e^{−2(2j+1)η})
                    -grown * (-(less + more) * eta).exp_m1()
                } else {
                    grown + (-more * eta).exp()
                };
                if weight == 0.0 { 0.0 } else { 0.5 * weight * sum }
            })
        };
        let [first, second, third] = etas;
        let other = |eta| [cos_odd(weights(eta, 1.0, |_| 1.0)), sin_odd(weights(eta, -1.0, |_| 1.0))];
        Self {
            parts: [
                [
                    sin_odd(weights(first, 1.0, alternating)),
                    cos_odd(weights(first, -1.0, alternating)).map(|part| -part),
                ],
                other(second),
                other(third),
            ],
            below: cos_even(std::array::from_fn(|j| alternating(j) * power(j * j))),
        }
    }
}

impl Fast {
    fn new(nome: f64, angles: [f64; NUMBERS], [quarter, other_quarter]: [f64; 2]) -> Self {
        let limit = PI * quarter / other_quarter;
        let comes_back = quarter.is_finite();
        let power = |n: i32| nome.powi(n);
        let [first, second, third] = angles;
        let odd = |j: usize| (2 * j + 1) as f64;
        let other = |angle: f64| {
            let [s1, s2, s3] = [1.0, 2.0, 3.0].map(|n| 2.0 * (n * angle).sin().powi(2));
            let [t1, t2, t3] = [2.0, 4.0, 6.0].map(|n| (n * angle).sin());
            [
                Parts {
                    up: [0.0, s1, -power(2) * s2, power(6) * s3],
                    down: [power(1) * s1, -power(4) * s2, power(9) * s3, 0.0],
                },
                Parts {
                    up: [0.0, t1, -power(2) * t2, power(6) * t3],
                    down: [-power(1) * t1, power(4) * t2, -power(9) * t3, 0.0],
                },
            ]
        };
        Self {
            stretch: if comes_back { limit } else { FRAC_PI_2 / other_quarter },
            twice: if comes_back { 2.0 * limit } else { 0.0 },
            cut: if comes_back { 0.0 } else { 1e3 },
            wraps: if comes_back { 1.0 } else { 0.0 },
            drift: if comes_back { angles.map(|angle| 2.0 * FRAC_2_PI * angle) } else { [0.0; NUMBERS] },
            below: Parts::cosh(nome, &|_| 1.0),
            first: [
                Parts::sinh(nome, &|j| alternating(j) * (odd(j) * first).cos()),
                Parts::cosh(nome, &|j| -alternating(j) * (odd(j) * first).sin()),
            ],
            factor: Parts {
                up: [power(6) - power(2), power(6) - power(2), power(6), 0.0],
                down: [power(5) - power(1) - power(11), power(4) - power(10), -power(9), 0.0],
            },
            others: [other(second), other(third)],
        }
    }
}

impl Thetas for Slow {
    #[inline(always)]
    fn at<const ONE: bool>(&self, argument: f64, argument_low: f64) -> Values {
        let (sin, cos) = sin_cos_quarters::<ONE>(argument, argument_low);
        let x = 1.0 - 2.0 * sin * sin;
        let over = 1.0 / cubic(&self.below, x);
        let [first, second, third] = &self.parts;
        let part = |[re, im]: &[Cubic; 2], a: f64, b: f64| [a * cubic(re, x) * over, b * cubic(im, x) * over];
        Values {
            thetas: [part(first, sin, cos), part(second, cos, sin), part(third, cos, sin)],
            flip: 0,
            rest: 0.0,
        }
    }

    #[inline(always)]
    fn drift(&self) -> [f64; NUMBERS] {
        [0.0; NUMBERS]
    }
}

impl Thetas for Fast {
    #[inline(always)]
    fn at<const ONE: bool>(&self, high: f64, low: f64) -> Values {
        let (high, low, flip) = within_half_period::<ONE>(self.wraps, high, low);
        let rest = high + low;
        let sign = rest.to_bits() & (1 << 63);
        let signed = |value: f64| f64::from_bits(value.to_bits() ^ sign);
        let w = self.stretch * rest.abs();
        let falling = exp(-w);
        let down = falling * falling;
        let (_, less_one) = exp_and_exp_m1(-2.0 * w);
        // The distance from a quarter period keeps the digits of both parts.
        let beyond = (signed(high) - 0.5) + signed(low);
        let (up, up_less_one) = exp_and_exp_m1(self.twice * beyond - self.cut);
        let over = 1.0 / self.below.at(up, down);
        let [re, im] = &self.first;
        let first = [signed(-less_one * re.at(up, down)) * over, im.at(up, down) * over];
        let near_zero = -up_less_one * (1.0 + self.factor.at(up, down));
        let [second, third] = [0, 1].map(|n| {
            let [re, im] = &self.others[n];
            let size = falling * over;
            [(near_zero + re.at(up, down)) * size, signed(im.at(up, down)) * size]
        });
        Values { thetas: [first, second, third], flip, rest }
    }

    #[inline(always)]
    fn drift(&self) -> [f64; NUMBERS] {
        self.drift
    }
}

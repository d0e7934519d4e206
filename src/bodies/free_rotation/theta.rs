//! The four theta functions of a free body's motion as polynomials: of degree three in cos 2v, or in `e^{−2w}` and
//! `q'e^{2w}`.

use crate::elementary::{exp, nearest, remainder, sin_cos_quarters};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

/// The theta functions of `eq:free-jacobi`, and the factor `is ϑ₁(v − iη)` of `eq:beyond-steady`
/// (`eq:tip-theta`), up to positive numbers, with `v = πu/2K` and `η = πy₀/2K`.
///
/// Their nome `q = e^{−πK'/K}` is small where K is not much larger than K'. Elsewhere Jacobi's imaginary transformation
/// gives the same from the nome `q' = e^{−πK/K'}` (`eq:theta-imaginary`). So the nome is never above e^−π.
#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "one for thousands of states")]
pub(super) enum Theta {
    /// `k² ≤ ½`: circular functions of v, polynomials in cos 2v. The argument comes in quarter turns of v.
    Slow(Slow),
    /// `k² > ½`: hyperbolic functions of `w = πu/2K'`. The argument comes in half periods 2K; on the separatrix, where
    /// there are none, it is u.
    Fast(Fast),
}

impl Theta {
    /// From k², K, K' and the zero `y₀` of `eq:tip-zero`.
    pub(super) fn new(parameter: f64, [quarter, other_quarter]: [f64; 2], zero: f64) -> Self {
        let is_slow = parameter <= 0.5;
        let (first, second) = if is_slow { (quarter, other_quarter) } else { (other_quarter, quarter) };
        // η or η' = πy₀/2K'
        let (nome, shift) = ((-PI * second / first).exp(), (FRAC_PI_2 * zero / first).abs());
        if is_slow {
            Self::Slow(Slow::new(nome, shift))
        } else {
            Self::Fast(Fast::new(nome, shift, [quarter, other_quarter]))
        }
    }
}

/// Terms of the theta series (`eq:theta-series`): the nome is below 0.0433 on either side, and a term of number j at
/// most its power `j²`.
pub(crate) const TERMS: usize = 4;

/// Coefficients of a polynomial, the constant first.
pub(crate) type Cubic = [f64; TERMS];

/// Polynomials in cos 2v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slow {
    sn: Cubic,
    cn: Cubic,
    dn: Cubic,
    below: Cubic,
    re: Cubic,
    im: Cubic,
}

/// What a side's theta functions are at one argument.
pub(super) struct Values {
    pub(super) jacobi: [f64; 3], // cn, sn, dn
    pub(super) theta: [f64; 2],  // real and imaginary part, up to a positive factor
    pub(super) flip: u64,        // the sign bit that cn and sn still have to take
    pub(super) drift: f64,       // the angle that grows with u, in quarter turns of its half
}

/// The theta functions of one side, without a branch; for `ONE` the argument may be of any size.
pub(super) trait Polynomials {
    fn at<const ONE: bool>(&self, argument: f64, argument_low: f64) -> Values;
}

/// Polynomials in E = e^{−2w} and F = q' e^{2w}, both at most one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fast {
    stretch: f64, // w is this times the rest of a half period
    limit: f64,   // πK/K', infinite on the separatrix
    wraps: f64,   // 1, or 0 on the separatrix, where nothing comes back
    drift: f64,   // the angle that grows with u, in quarter turns of its half, for each half period
    odd: Parts,   // sinh series, over sinh
    even: Parts,  // cosh series
    third: Parts,
    fourth: Parts,
    re: Parts,
    im: Parts,        // a sinh series, over sinh
    scales: [f64; 3], // of cn, sn, dn
}

/// A polynomial in F and one in E.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Parts {
    pub(crate) up: Cubic,
    pub(crate) down: Cubic,
}

#[inline(always)]
pub(crate) fn cubic([c0, c1, c2, c3]: &Cubic, x: f64) -> f64 {
    ((c3 * x + c2) * x + c1) * x + c0
}

impl Slow {
    fn new(nome: f64, eta: f64) -> Self {
        let power = |n: usize| nome.powi(n as i32);
        let theta_2 = cos_odd(std::array::from_fn(|j| power(j * (j + 1))));
        let theta_1 = sin_odd(std::array::from_fn(|j| alternating(j) * power(j * (j + 1))));
        let theta_3 = cos_even(std::array::from_fn(|j| power(j * j)));
        let theta_4 = cos_even(std::array::from_fn(|j| alternating(j) * power(j * j)));
        let [at_2, at_3, at_4] = [theta_2, theta_3, theta_4].map(|theta| cubic(&theta, 1.0));
        let times = |theta: Cubic, factor: f64| theta.map(|coefficient| coefficient * factor);
        let weighted = |function: fn(f64) -> f64| {
            std::array::from_fn(|j| {
                let weight = alternating(j) * power(j * (j + 1));
                if weight == 0.0 { 0.0 } else { weight * function((2 * j + 1) as f64 * eta) }
            })
        };
        Self {
            sn: times(theta_1, at_3 / at_2),
            cn: times(theta_2, at_4 / at_2),
            dn: times(theta_3, at_4 / at_3),
            below: theta_4,
            re: cos_odd(weighted(f64::sinh)),
            im: sin_odd(weighted(f64::cosh)),
        }
    }
}

impl Fast {
    fn new(nome: f64, angle: f64, [quarter, other_quarter]: [f64; 2]) -> Self {
        let limit = PI * quarter / other_quarter;
        let power = |n: usize| nome.powi(n as i32);
        let cosh = |weight: &dyn Fn(usize) -> f64| Parts::cosh(nome, weight);
        let sinh = |weight: &dyn Fn(usize) -> f64| Parts::sinh(nome, weight);
        // Of q'^{j²} a_j (e^{2jw} + e^{−2jw}).
        let even = |weight: &dyn Fn(usize) -> f64| Parts {
            up: std::array::from_fn(|j| weight(j + 1) * power(j * (j + 1))),
            down: std::array::from_fn(|j| weight(j + 1) * power((j + 1) * (j + 1))),
        };
        let sum = |weight: &dyn Fn(usize) -> f64| (1..TERMS).rev().map(weight).sum::<f64>();
        let at_2 = 1.0 + sum(&|j| power(j * (j + 1)));
        let at_3 = 1.0 + 2.0 * sum(&|j| power(j * j));
        let at_4 = 1.0 + 2.0 * sum(&|j| alternating(j) * power(j * j));
        let comes_back = quarter.is_finite();
        Self {
            stretch: if comes_back { limit } else { FRAC_PI_2 / other_quarter },
            limit,
            wraps: if comes_back { 1.0 } else { 0.0 },
            drift: if comes_back { FRAC_2_PI * angle } else { 0.0 },
            odd: sinh(&alternating),
            even: cosh(&|_| 1.0),
            third: even(&|_| 1.0),
            fourth: even(&alternating),
            re: cosh(&|j| alternating(j) * ((2 * j + 1) as f64 * angle).sin()),
            im: sinh(&|j| alternating(j) * ((2 * j + 1) as f64 * angle).cos()),
            scales: [2.0 * at_2 / at_4, at_3 / at_4, 2.0 * at_2 / at_3],
        }
    }
}

impl Parts {
    /// For a sum of `q'^{j(j+1)} a_j (e^{(2j+1)w} + e^{−(2j+1)w})`, times `e^{−w}`.
    pub(crate) fn cosh(nome: f64, weight: &dyn Fn(usize) -> f64) -> Self {
        let power = |n: usize| nome.powi(n as i32);
        Self {
            up: std::array::from_fn(|j| weight(j) * power(j * j)),
            down: std::array::from_fn(|j| weight(j) * power(j * (j + 1))),
        }
    }

    /// For the same with a minus, over `e^w − e^{−w}`, which is the sum of all `q'^{j(j+1)} a_j e^{2iw}` with `|i| ≤ j`
    /// and has no difference that is small with w.
    pub(crate) fn sinh(nome: f64, weight: &dyn Fn(usize) -> f64) -> Self {
        let from = |i: usize, less: usize| {
            let power = |n: usize| nome.powi(n as i32);
            (i..TERMS).rev().map(|j| weight(j) * power(j * (j + 1) - less)).sum::<f64>()
        };
        Self { up: std::array::from_fn(|i| from(i, i)), down: std::array::from_fn(|i| from(i + 1, 0)) }
    }

    /// Either sum, from `F = q'e^{2w}` and `E = e^{−2w}`.
    #[inline(always)]
    pub(crate) fn at(&self, up: f64, down: f64) -> f64 {
        cubic(&self.up, up) + down * cubic(&self.down, down)
    }
}

impl Polynomials for Slow {
    #[inline(always)]
    fn at<const ONE: bool>(&self, argument: f64, argument_low: f64) -> Values {
        let (sin, cos) = sin_cos_quarters::<ONE>(argument, argument_low);
        let x = 1.0 - 2.0 * sin * sin;
        let over = 1.0 / cubic(&self.below, x);
        Values {
            jacobi: [
                cos * cubic(&self.cn, x) * over,
                sin * cubic(&self.sn, x) * over,
                cubic(&self.dn, x) * over,
            ],
            theta: [cos * cubic(&self.re, x), sin * cubic(&self.im, x)],
            flip: 0,
            drift: 0.0,
        }
    }
}

impl Polynomials for Fast {
    #[inline(always)]
    fn at<const ONE: bool>(&self, high: f64, low: f64) -> Values {
        let (high, low, flip) = within_half_period::<ONE>(self.wraps, high, low);
        let rest = high + low;
        let w = self.stretch * rest.abs();
        let falling = exp(-w);
        let down = falling * falling;
        // Of sn and im alike: a rounding of it turns Z by nothing that counts, a rounding of one of them would.
        let from_one = 1.0 - down;
        let up = exp(2.0 * w - self.limit);
        let odd = |parts: &Parts| parts.at(up, down);
        let even = |parts: &Parts| 1.0 + (up * cubic(&parts.up, up) + down * cubic(&parts.down, down));
        let over = 1.0 / odd(&self.even);
        let [cn, sn, dn] = self.scales;
        let jacobi = [
            cn * falling * over * even(&self.fourth),
            (sn * over * from_one * odd(&self.odd)).copysign(rest),
            dn * falling * over * even(&self.third),
        ];
        let im = from_one * odd(&self.im);
        let im = f64::from_bits(im.to_bits() ^ (rest.to_bits() & (1 << 63)));
        Values { jacobi, theta: [odd(&self.re), im], flip, drift: self.drift * rest }
    }
}

/// An argument in half periods, in two parts, without the whole ones, and the sign bit that these leave behind. `wraps`
/// is 0 where nothing comes back, else 1; for `ONE` the argument may be of any size.
#[inline(always)]
pub(crate) fn within_half_period<const ONE: bool>(wraps: f64, high: f64, low: f64) -> (f64, f64, u64) {
    let (high, low) = if ONE && wraps != 0.0 { remainder(high, low, 2.0) } else { (high, low) };
    let (whole, bits) = nearest(high);
    let high = high - wraps * whole;
    // After many periods the second part may carry half a period beyond its end, where |Z| + Z is another root.
    let (carried, more_bits) = nearest(high + low);
    let flip = if wraps == 0.0 { 0 } else { (bits ^ more_bits) << 63 };
    (high - wraps * carried, low, flip)
}

/// (−1)^j
pub(crate) fn alternating(j: usize) -> f64 {
    if j.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Σ aⱼ cos (2j+1)v / cos v in powers of cos 2v.
pub(crate) fn cos_odd([a0, a1, a2, a3]: [f64; TERMS]) -> Cubic {
    [a0 - a1 - a2 + a3, 2.0 * (a1 - a2) - 4.0 * a3, 4.0 * (a2 - a3), 8.0 * a3]
}

/// Σ aⱼ sin (2j+1)v / sin v in powers of cos 2v.
pub(crate) fn sin_odd([a0, a1, a2, a3]: [f64; TERMS]) -> Cubic {
    [a0 + a1 - a2 - a3, 2.0 * (a1 + a2) - 4.0 * a3, 4.0 * (a2 + a3), 8.0 * a3]
}

/// a₀ + 2 Σ aⱼ cos 2jv in powers of cos 2v.
pub(crate) fn cos_even([a0, a1, a2, a3]: [f64; TERMS]) -> Cubic {
    [a0 - 2.0 * a2, 2.0 * a1 - 6.0 * a3, 4.0 * a2, 8.0 * a3]
}

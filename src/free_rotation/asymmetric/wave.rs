//! The frames of a motion, by theta functions, without a branch: a loop over many of them does several in one instruction.
//!
//! Everything follows from two phases that grow at a constant rate: the argument u, which makes the angular velocity and the
//! theta function of the attitude, and half the steady angle about **L**. Of the angle that the theta function adds, the half is
//! found without the angle: a complex number Z has the same direction as the square of `|Z| + Z`.

use crate::two_part::TwoPart;
use crate::wide::BLOCK;
use crate::wide::functions::{Clock, ROUNDABLE, at_full_width, exp, nearest, sin_cos_quarters};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

/// Terms of the theta series. The nome is below 0.0433 on either side, and its sixteenth power times the growth of the
/// hyperbolic functions below 1e-17.
const TERMS: usize = 4;

/// Coefficients of a polynomial, the constant first.
type Cubic = [f64; TERMS];

/// What a motion's frames are made from. Times in units that make the largest rate about one; `scale` such units are a second.
pub(super) struct Constants {
    pub(super) moments: [f64; 3],
    pub(super) amplitudes: [f64; 3],
    pub(super) momentum: f64,
    pub(super) sense: f64,              // σ
    pub(super) rate: TwoPart,           // p
    pub(super) scale: f64,              // a power of two
    pub(super) first_argument: TwoPart, // u at the start
    pub(super) half_period: TwoPart,    // 2K/p; infinite on the separatrix
    pub(super) quarter: TwoPart,        // K
    pub(super) other_quarter: f64,      // K'
    pub(super) parameter: f64,          // k²
    pub(super) turn_rate: TwoPart,      // Λ
    pub(super) zeta: f64,
    pub(super) tilt: f64, // √(1 + n)
}

/// The motion, ready to be evaluated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wave {
    argument: Clock, // u in quarter turns of the theta functions, or in half periods, or as it is: see `Side`
    first_argument: TwoPart,
    half_turn: Clock, // half the steady angle about L
    reach: f64,
    sense: f64,
    tilt: f64,
    amplitudes: [f64; 3],          // per second
    momentum_over_omega: [f64; 3], // I/G
    side: Side,
}

/// The theta functions of one side, as polynomials.
#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a handful of motions, each used for thousands of frames")]
enum Side {
    /// k² ≤ ½: circular functions of v = πu/2K, the nome of K'/K, polynomials in cos 2v.
    Slow(Slow),
    /// k² > ½: hyperbolic functions of w = πu/2K', the nome of K/K'.
    Fast(Fast),
}

/// Polynomials in cos 2v.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Slow {
    sn: Cubic,
    cn: Cubic,
    dn: Cubic,
    below: Cubic,
    re: Cubic,
    im: Cubic,
}

/// What a side's theta functions are at one argument.
struct Values {
    jacobi: [f64; 3], // cn, sn, dn
    theta: [f64; 2],  // real and imaginary part, up to a positive factor
    flip: u64,        // the sign bit that cn and sn still have to take
    drift: f64,       // the angle that grows with u, in quarter turns of its half
}

/// The theta functions of one side, without a branch.
trait Theta {
    fn at(&self, argument: f64, argument_low: f64) -> Values;
}

/// Polynomials in E = e^{−2w} and F = q' e^{2w}, both at most one.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Fast {
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
struct Parts {
    up: Cubic,
    down: Cubic,
}

#[inline(always)]
fn cubic([c0, c1, c2, c3]: &Cubic, x: f64) -> f64 {
    ((c3 * x + c2) * x + c1) * x + c0
}

impl Wave {
    pub(super) fn new(constants: &Constants) -> Self {
        let Constants { moments, amplitudes, momentum, scale, first_argument, half_period, .. } = *constants;
        let (side, argument, first_argument) = if constants.parameter <= 0.5 {
            // v in quarter turns is u/K.
            let rate = TwoPart::from(2.0 * scale) / half_period;
            (Side::Slow(Slow::new(constants)), rate, first_argument / constants.quarter)
        } else if constants.quarter.rounded().is_finite() {
            let rate = TwoPart::from(scale) / half_period;
            (Side::Fast(Fast::new(constants)), rate, first_argument / (constants.quarter * 2.0))
        } else {
            (Side::Fast(Fast::new(constants)), constants.rate * scale, first_argument)
        };
        let argument = Clock::from_quarters(argument);
        let half_turn = Clock::from_rate(constants.turn_rate * (0.5 * scale));
        Self {
            argument,
            first_argument,
            half_turn,
            reach: argument.reach().min(half_turn.reach()),
            sense: constants.sense,
            tilt: constants.tilt,
            amplitudes: amplitudes.map(|amplitude| amplitude * scale),
            momentum_over_omega: moments.map(|moment| moment / (momentum * scale)),
            side,
        }
    }

    /// Up to which time, of either sign, [`Wave::fill`] can go.
    pub(super) fn reach(&self) -> f64 {
        self.reach
    }

    /// The quaternion of the renamed axes in axes of which the third lies along **L** (i, j, k, scalar, not of length one) and ω
    /// along the renamed axes, rad/s, at a time, s.
    pub(super) fn at(&self, time: f64) -> [f64; 7] {
        let (argument, half_turn) = (self.argument.at(time), self.half_turn.at(time));
        let comes_back = !matches!(self.side, Side::Fast(Fast { wraps: 0.0, .. }));
        // Beyond reach, whole periods are taken off first.
        let near = |(high, low): (f64, f64)| {
            if high.abs() < ROUNDABLE { (high, low) } else { (high % 4.0, low % 4.0) }
        };
        let argument = if comes_back { near(argument) } else { argument };
        match &self.side {
            Side::Slow(slow) => self.frame(slow, argument, near(half_turn)),
            Side::Fast(fast) => self.frame(fast, argument, near(half_turn)),
        }
    }

    /// [`Wave::at`] for up to [`BLOCK`] times within reach, one list for each number.
    pub(super) fn fill(&self, times: &[f64], block: &mut [[f64; BLOCK]; 7]) {
        let mut padded = [0.0; BLOCK];
        padded[..times.len()].copy_from_slice(times);
        at_full_width(
            #[inline(always)]
            || match &self.side {
                Side::Slow(slow) => self.fill_with(slow, &padded, block),
                Side::Fast(fast) => self.fill_with(fast, &padded, block),
            },
        );
    }

    #[inline(always)]
    fn fill_with(&self, theta: &impl Theta, times: &[f64; BLOCK], block: &mut [[f64; BLOCK]; 7]) {
        let [i, j, k, w, wa, wb, wc] = block;
        for n in 0..BLOCK {
            let (argument, half_turn) = (self.argument.at(times[n]), self.half_turn.at(times[n]));
            [i[n], j[n], k[n], w[n], wa[n], wb[n], wc[n]] = self.frame(theta, argument, half_turn);
        }
    }

    #[inline(always)]
    fn frame(
        &self,
        theta: &impl Theta,
        (high, low): (f64, f64),
        (turn_high, turn_low): (f64, f64),
    ) -> [f64; 7] {
        let (first, first_low) = self.first_argument.parts();
        let (argument, argument_low) = (TwoPart::sum(high, first) + (low + first_low)).parts();
        let Values { jacobi: [cn, sn, dn], theta: [re, im], flip, drift } = theta.at(argument, argument_low);
        // Z, the number whose direction is the angle beyond the steady turn, and |Z| + Z, without a difference.
        let (x, y) = (re * cn + im * self.tilt * sn, im * cn - re * self.tilt * sn);
        // x is a sum of two products of numbers with the same sign.
        let half_x = (x * x + y * y).sqrt() + x.abs();
        let half_y = self.sense * y;
        let (turn, turn_low) = (TwoPart::sum(turn_high, self.sense * drift) + turn_low).parts();
        let (sin, cos) = sin_cos_quarters(turn, turn_low);
        let (c, s) = (cos * half_x - sin * half_y, sin * half_x + cos * half_y);

        let turned = |value: f64| f64::from_bits(value.to_bits() ^ flip);
        let [size_a, size_b, size_c] = self.amplitudes;
        let omega = [turned(size_a * cn), turned(self.sense * size_b * sn), size_c * dn];
        // L along the renamed axes; the rotation that takes it upright; then the turn about the upright.
        let [la, lb, lc]: [f64; 3] = std::array::from_fn(|n| self.momentum_over_omega[n] * omega[n]);
        let (w, i, j) = (1.0 + lc, lb, -la);
        [c * i - s * j, c * j + s * i, s * w, c * w, omega[0], omega[1], omega[2]]
    }
}

impl Slow {
    fn new(constants: &Constants) -> Self {
        let quarter = constants.quarter.rounded();
        let nome = (-PI * constants.other_quarter / quarter).exp();
        let power = |n: usize| nome.powi(n as i32);
        let hyper = FRAC_PI_2 / quarter * constants.zeta;
        let theta_2 = cos_odd(std::array::from_fn(|j| power(j * (j + 1))));
        let theta_1 = sin_odd(std::array::from_fn(|j| alternating(j) * power(j * (j + 1))));
        let theta_3 = cos_even(std::array::from_fn(|j| power(j * j)));
        let theta_4 = cos_even(std::array::from_fn(|j| alternating(j) * power(j * j)));
        let [at_2, at_3, at_4] = [theta_2, theta_3, theta_4].map(|theta| cubic(&theta, 1.0));
        let times = |theta: Cubic, factor: f64| theta.map(|coefficient| coefficient * factor);
        let weighted = |function: fn(f64) -> f64| {
            std::array::from_fn(|j| {
                let weight = alternating(j) * power(j * (j + 1));
                if weight == 0.0 { 0.0 } else { weight * function((2 * j + 1) as f64 * hyper) }
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
    fn new(constants: &Constants) -> Self {
        let quarter = constants.quarter.rounded();
        let limit = PI * quarter / constants.other_quarter;
        let nome = (-limit).exp();
        let power = |n: usize| nome.powi(n as i32);
        let angle = FRAC_PI_2 / constants.other_quarter * constants.zeta;
        // For a sum of q'^{j(j+1)} a_j (e^{(2j+1)w} + e^{−(2j+1)w}), times e^{−w}; of the same with a minus, over e^w − e^{−w}, which is the sum of all
        // q'^{j(j+1)} a_j e^{2iw} with |i| ≤ j and has no difference that is small with w; and of q'^{j²} a_j (e^{2jw} + e^{−2jw}).
        let cosh = |weight: &dyn Fn(usize) -> f64| Parts {
            up: std::array::from_fn(|j| weight(j) * power(j * j)),
            down: std::array::from_fn(|j| weight(j) * power(j * (j + 1))),
        };
        let sinh = |weight: &dyn Fn(usize) -> f64| {
            let from = |i: usize, less: usize| {
                (i..TERMS).rev().map(|j| weight(j) * power(j * (j + 1) - less)).sum::<f64>()
            };
            Parts { up: std::array::from_fn(|i| from(i, i)), down: std::array::from_fn(|i| from(i + 1, 0)) }
        };
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
            stretch: if comes_back { limit } else { FRAC_PI_2 / constants.other_quarter },
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

impl Theta for Slow {
    #[inline(always)]
    fn at(&self, argument: f64, argument_low: f64) -> Values {
        let (sin, cos) = sin_cos_quarters(argument, argument_low);
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

impl Theta for Fast {
    #[inline(always)]
    fn at(&self, high: f64, low: f64) -> Values {
        let (whole, bits) = nearest(high);
        let rest = (high - self.wraps * whole) + low;
        let flip = if self.wraps == 0.0 { 0 } else { bits << 63 };
        let w = self.stretch * rest.abs();
        let falling = exp(-w);
        let down = falling * falling;
        // Of sn and im alike: a rounding of it turns Z by nothing that counts, a rounding of one of them would.
        let from_one = 1.0 - down;
        let up = exp(2.0 * w - self.limit);
        let odd = |parts: &Parts| cubic(&parts.up, up) + down * cubic(&parts.down, down);
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

/// (−1)^j
fn alternating(j: usize) -> f64 {
    if j.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Σ aⱼ cos (2j+1)v / cos v in powers of cos 2v.
fn cos_odd([a0, a1, a2, a3]: [f64; TERMS]) -> Cubic {
    [a0 - a1 - a2 + a3, 2.0 * (a1 - a2) - 4.0 * a3, 4.0 * (a2 - a3), 8.0 * a3]
}

/// Σ aⱼ sin (2j+1)v / sin v in powers of cos 2v.
fn sin_odd([a0, a1, a2, a3]: [f64; TERMS]) -> Cubic {
    [a0 + a1 - a2 - a3, 2.0 * (a1 + a2) - 4.0 * a3, 4.0 * (a2 + a3), 8.0 * a3]
}

/// a₀ + 2 Σ aⱼ cos 2jv in powers of cos 2v.
fn cos_even([a0, a1, a2, a3]: [f64; TERMS]) -> Cubic {
    [a0 - 2.0 * a2, 2.0 * a1 - 6.0 * a3, 4.0 * a2, 8.0 * a3]
}

//! A free body with three different moments, by polynomials in the theta series' own variables.
//!
//! A state follows from two phases that grow at a constant rate: the argument u, and half the steady angle about
//! **L**. All four theta functions that make sn, cn, dn and the direction of `eq:beyond-steady` are polynomials of
//! degree three in cos 2v, or in `e^{−2w}` and `q'e^{2w}`. Of the angle beyond the steady one the half is found
//! without the angle: a complex number Z has the direction of the square of `|Z| + Z`.

use super::functions::{Clock, at_full_width, exp, nearest, sin_cos_quarters};
use super::{BLOCK, in_blocks};
use crate::euler::Turning;
use crate::free_rotation::asymmetric::Asymmetric;
use crate::free_rotation::theta::{Side, Theta};
use crate::quantity::InvalidQuantity;
use crate::two_part::TwoPart;
use nalgebra::{Matrix3, Matrix4, Quaternion, UnitQuaternion, Vector3, Vector4};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

/// Terms of the theta series: the nome is below 0.0433 on either side, and a term of number j at most its power `j²`.
const TERMS: usize = 4;

/// Coefficients of a polynomial, the constant first.
type Cubic = [f64; TERMS];

/// The motion, ready to be evaluated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tumbling {
    argument: Clock, // u in quarter turns of v, or in half periods, or as it is: see `Series`
    first_argument: TwoPart,
    half_turn: Clock, // half the steady angle about L
    sense: f64,       // s
    ratio: f64,       // |I₂B/I₁A| = √(1 + n)
    amplitudes: Vector3<f64>,
    moments_by_l: Vector3<f64>,
    series: Series,
    /// Takes the quaternion of the renamed axes in upright ones, scalar last, to the attitude's.
    attitude: Matrix4<f64>,
    body_from_renamed: Matrix3<f64>,
}

/// The theta functions of one side, as polynomials.
#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "one for thousands of states")]
enum Series {
    /// Circular functions of v = πu/2K, polynomials in cos 2v.
    Slow(Slow),
    /// Hyperbolic functions of w = πu/2K'.
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
trait Polynomials {
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

impl Tumbling {
    pub(crate) fn new(motion: &Asymmetric) -> Self {
        let (argument_rate, first_argument, theta) =
            (motion.argument_rate, motion.first_argument, &motion.theta);
        let (series, per) = match (theta.side, motion.quarter) {
            (Side::Circular, Some(quarter)) => (Series::Slow(Slow::new(theta)), quarter), // v in quarter turns is u/K
            (_, Some(quarter)) => (Series::Fast(Fast::new(theta)), quarter * 2.0),
            (_, None) => (Series::Fast(Fast::new(theta)), TwoPart::from(1.0)),
        };
        let [a, b, _]: [f64; 3] = motion.amplitudes.component_mul(&motion.moments_by_l).into();
        let [left, right] = [&motion.world_from_upright, &motion.renamed_from_body];
        Self {
            argument: Clock::from_quarters(argument_rate / per),
            first_argument: first_argument / per,
            half_turn: Clock::from_rate(motion.steady_rate * 0.5),
            sense: theta.sense,
            ratio: (b / a).abs(),
            amplitudes: motion.amplitudes,
            moments_by_l: motion.moments_by_l,
            series,
            attitude: both_sides(left, right),
            body_from_renamed: motion.body_from_renamed,
        }
    }

    /// Fills the states at times within reach and says how many, as [`in_blocks`] does.
    pub(crate) fn fill(&self, times: &[f64], states: &mut [Turning]) -> usize {
        let reach = self.argument.reach().min(self.half_turn.reach());
        let reached = |time: f64| time.abs() <= reach && InvalidQuantity::check_time(time).is_ok();
        let mut block = [[0.0; BLOCK]; 7];
        in_blocks(times, states, reached, |times, states| {
            let mut padded = [0.0; BLOCK];
            padded[..times.len()].copy_from_slice(times);
            at_full_width(
                #[inline(always)]
                || match &self.series {
                    Series::Slow(slow) => self.fill_block(slow, &padded, &mut block),
                    Series::Fast(fast) => self.fill_block(fast, &padded, &mut block),
                },
            );
            for (n, state) in states.iter_mut().enumerate() {
                *state = self.turning(std::array::from_fn(|i| block[i][n]));
            }
            true
        })
    }

    #[inline(always)]
    fn fill_block(&self, series: &impl Polynomials, times: &[f64; BLOCK], block: &mut [[f64; BLOCK]; 7]) {
        let [i, j, k, w, w1, w2, w3] = block;
        for n in 0..BLOCK {
            [i[n], j[n], k[n], w[n], w1[n], w2[n], w3[n]] = self.numbers(series, times[n]);
        }
    }

    /// The quaternion of the renamed axes in upright ones (i, j, k, scalar, not of length one), and ω along the
    /// renamed axes, rad/s.
    #[inline(always)]
    fn numbers(&self, series: &impl Polynomials, time: f64) -> [f64; 7] {
        let ((high, low), (turn_high, turn_low)) = (self.argument.at(time), self.half_turn.at(time));
        let (first, first_low) = self.first_argument.parts();
        let (argument, argument_low) = (TwoPart::sum(high, first) + (low + first_low)).parts();
        let Values { jacobi: [cn, sn, dn], theta: [re, im], flip, drift } = series.at(argument, argument_low);
        // Z of eq:beyond-steady without the factor e^{iαu/K}, and |Z| + Z, without a difference.
        let (x, y) = (re * cn + im * self.ratio * sn, im * cn - re * self.ratio * sn);
        // x is a sum of two products of numbers with the same sign.
        let half_x = (x * x + y * y).sqrt() + x.abs();
        let half_y = self.sense * y;
        let (turn, turn_low) = (TwoPart::sum(turn_high, self.sense * drift) + turn_low).parts();
        let (sin, cos) = sin_cos_quarters(turn, turn_low);
        let (c, s) = (cos * half_x - sin * half_y, sin * half_x + cos * half_y);

        let turned = |value: f64| f64::from_bits(value.to_bits() ^ flip);
        let [size_1, size_2, size_3]: [f64; 3] = self.amplitudes.into();
        let omega = [turned(size_1 * cn), turned(size_2 * sn), size_3 * dn];
        // L̂ along the renamed axes; the rotation that takes it upright; then the turn about the upright.
        let [l1, l2, l3]: [f64; 3] = std::array::from_fn(|n| self.moments_by_l[n] * omega[n]);
        let (w, i, j) = (1.0 + l3, l2, -l1);
        [c * i - s * j, c * j + s * i, s * w, c * w, omega[0], omega[1], omega[2]]
    }

    fn turning(&self, [i, j, k, w, w1, w2, w3]: [f64; 7]) -> Turning {
        let q = self.attitude * Vector4::new(i, j, k, w);
        Turning {
            world_from_body: UnitQuaternion::new_unchecked(Quaternion::from(q / q.norm())),
            omega_body: self.body_from_renamed * Vector3::new(w1, w2, w3),
        }
    }
}

/// The matrix that multiplies a quaternion, as a column with the scalar last, by one from the left and one from the
/// right.
fn both_sides(left: &UnitQuaternion<f64>, right: &UnitQuaternion<f64>) -> Matrix4<f64> {
    let column = |n: usize| {
        let unit = Quaternion::from(Vector4::from_fn(|i, _| if i == n { 1.0 } else { 0.0 }));
        (left.quaternion() * unit * right.quaternion()).coords
    };
    Matrix4::from_columns(&[column(0), column(1), column(2), column(3)])
}

impl Slow {
    fn new(&Theta { nome, shift, .. }: &Theta) -> Self {
        let eta = shift.abs();
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
    fn new(&Theta { nome, shift, quarter, other_quarter, .. }: &Theta) -> Self {
        let angle = shift.abs();
        let limit = PI * quarter / other_quarter;
        let power = |n: usize| nome.powi(n as i32);
        // For a sum of q'^{j(j+1)} a_j (e^{(2j+1)w} + e^{−(2j+1)w}), times e^{−w}; of the same with a minus, over e^w
        // − e^{−w}, which is the sum of all q'^{j(j+1)} a_j e^{2iw} with |i| ≤ j and has no difference that is small
        // with w; and of q'^{j²} a_j (e^{2jw} + e^{−2jw}).
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

impl Polynomials for Slow {
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

impl Polynomials for Fast {
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

//! Sine, cosine and exponential without branches, tables or calls.
//!
//! A loop over many states that calls nothing and decides nothing is turned by the compiler into instructions
//! that work on two states at a time, or four, or eight, as the processor allows. The functions of the
//! standard library are calls; these are their like, to a unit or so in the last place, for arguments within
//! the limits stated.
//!
//! Angles come in quarter turns, in two parts. A motion of constant rate reaches them with a single product,
//! and reducing them is nothing but taking off whole quarters, which is exact; the reduction by a long π is
//! needed only once, in the rate. Polynomials: W. J. Cody & W. Waite, *Software Manual for the Elementary
//! Functions* (1980), with the coefficients of FDLIBM (K. C. Ng, Sun Microsystems, 1993).

use crate::two_part::TwoPart;
use std::f64::consts::FRAC_PI_2;

/// Adding this and taking it off again rounds to the nearest whole number; what is in between holds that
/// number in its last bits.
const WHOLE: f64 = 6_755_399_441_055_744.0; // 1.5 · 2^52

/// Numbers below this in size can be rounded so, and what rounding has left of them, half a unit in the last
/// place, is small.
pub(crate) const ROUNDABLE: f64 = 140_737_488_355_328.0; // 2^47

/// The nearest whole number, and its last bits. For numbers below [`ROUNDABLE`] in size.
#[inline(always)]
pub(crate) fn nearest(x: f64) -> (f64, u64) {
    let shifted = x + WHOLE;
    (shifted - WHOLE, shifted.to_bits())
}

/// What is left of `high + low` after whole multiples of `period`, a power of two, if it is not below [`ROUNDABLE`].
#[inline(always)]
pub(crate) fn remainder(high: f64, low: f64, period: f64) -> (f64, f64) {
    if high.abs() < ROUNDABLE { (high, low) } else { TwoPart::sum(high % period, low % period).parts() }
}

/// A polynomial, its constant first.
#[inline(always)]
fn polynomial<const N: usize>(coefficients: &[f64; N], x: f64) -> f64 {
    let [start @ .., last] = coefficients.as_slice() else { return 0.0 };
    start.iter().rev().fold(*last, |sum, coefficient| sum * x + coefficient)
}

/// Sine and cosine of `high + low` quarter turns, to about a unit in the last place of one. For `high` below
/// [`ROUNDABLE`] in size, where `low` is what rounding has left over, and small; a single number, `ONE`, may be of any
/// size, and costs a branch.
#[inline(always)]
pub(crate) fn sin_cos_quarters<const ONE: bool>(high: f64, low: f64) -> (f64, f64) {
    let (high, low) = if ONE { remainder(high, low, 4.0) } else { (high, low) };
    let (whole, quadrant) = nearest(high);
    let x = ((high - whole) + low) * FRAC_PI_2;
    let square = x * x;
    let fourth = square * square;
    let sine = x + x * square * polynomial(&SINE, square);
    let cosine = (1.0 - 0.5 * square) + fourth * polynomial(&COSINE, square);
    // An odd quarter exchanges the two; two quarters change both signs.
    let exchange = (quadrant & 1).wrapping_neg();
    let sine_sign = (quadrant & 2) << 62;
    let cosine_sign = (quadrant.wrapping_add(1) & 2) << 62;
    let (s, c) = (sine.to_bits(), cosine.to_bits());
    let differ = (s ^ c) & exchange;
    (f64::from_bits(s ^ differ ^ sine_sign), f64::from_bits(c ^ differ ^ cosine_sign))
}

/// e to the `x`, to about a unit in the last place, for `x` up to 709; zero below −708.
#[inline(always)]
pub(crate) fn exp(x: f64) -> f64 {
    let (less_one, bits) = reduced_exponential(x);
    let power = f64::from_bits((1.0 + less_one).to_bits().wrapping_add(bits << 52));
    if x > LEAST_EXPONENT { power } else { 0.0 }
}

/// The same for any `x`: infinite from 709 on.
#[inline(always)]
pub(crate) fn exp_or_infinity(x: f64) -> f64 {
    let power = exp(x);
    if x < LARGEST_EXPONENT { power } else { f64::INFINITY }
}

/// e to the `x` as [`exp`], and the same less one, to about a unit in its own last place.
#[inline(always)]
pub(crate) fn exp_and_exp_m1(x: f64) -> (f64, f64) {
    let (less_one, bits) = reduced_exponential(x);
    let power = f64::from_bits(1.0_f64.to_bits().wrapping_add(bits << 52));
    let whole = if x > LEAST_EXPONENT { power * (1.0 + less_one) } else { 0.0 };
    (whole, power * less_one + (power - 1.0))
}

/// `e^r − 1` for the rest r of `x` after whole multiples of ln 2, and the last bits of their number.
#[inline(always)]
fn reduced_exponential(x: f64) -> (f64, u64) {
    let x = if x > LEAST_EXPONENT { x } else { LEAST_EXPONENT };
    let (whole, bits) = nearest(x * std::f64::consts::LOG2_E);
    let (high, low) = (x - whole * LN_2_HIGH, whole * LN_2_LOW);
    let r = high - low;
    let square = r * r;
    let c = r - square * polynomial(&EXPONENTIAL, square);
    (high - (low - r * c / (2.0 - c)), bits)
}

const LEAST_EXPONENT: f64 = -708.0;
const LARGEST_EXPONENT: f64 = 709.0;

/// ln 2 with its last 21 bits zero, so that a product with a whole number below 2^20 is exact, and the rest.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// (sin x − x)/x³ in powers of x², |x| ≤ π/4.
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];

/// (cos x − 1 + x²/2)/x⁴ in powers of x², |x| ≤ π/4.
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// (r (e^r + 1)/(e^r − 1) − 2)/r² in powers of r², |r| ≤ ½ ln 2.
const EXPONENTIAL: [f64; 5] = [
    1.666_666_666_666_660_2e-1,
    -2.777_777_777_701_559_3e-3,
    6.613_756_321_437_934e-5,
    -1.653_390_220_546_525_2e-6,
    4.138_136_797_057_238_5e-8,
];

#[cfg(test)]
mod tests {
    use super::{exp, exp_and_exp_m1, exp_or_infinity, sin_cos_quarters};
    use crate::two_part::TwoPart;
    use std::f64::consts::FRAC_PI_2;

    /// Half a unit in the last place of numbers just below one.
    const ULP: f64 = 1.11e-16;

    #[test]
    fn sine_and_cosine_agree_with_the_standard_library() {
        let mut random = fastrand::Rng::with_seed(3);
        for _ in 0..100_000 {
            let x = 400.0 * (random.f64() - 0.5);
            let (sin, cos) = sin_cos_quarters::<false>(x, 0.0);
            // The same angle less whole turns, which is exact, in radians of 32 digits.
            let (s, c) = (TwoPart::PI * (0.5 * (x % 4.0))).sin_cos();
            assert!((sin - s).abs() < 3.0 * ULP && (cos - c).abs() < 3.0 * ULP, "{x}");
        }
    }

    #[test]
    fn quarter_turns_are_exact() {
        for (quarters, expected) in
            [(0.0, (0.0, 1.0)), (1.0, (1.0, 0.0)), (2.0, (0.0, -1.0)), (3.0, (-1.0, 0.0))]
        {
            for turns in [0.0, 4.0, -4.0, 4e12, -4e12] {
                assert_eq!(
                    sin_cos_quarters::<false>(quarters + turns, 0.0),
                    expected,
                    "{quarters} + {turns}"
                );
                // So many turns are too many for all but a single number.
                let many = if turns == 0.0 { (quarters, 0.0) } else { (turns * 1e90, quarters) };
                assert_eq!(sin_cos_quarters::<true>(many.0, many.1), expected, "{many:?}");
            }
        }
        // A second part counts, and where the angle is small it has all its digits.
        let (sin, cos) = sin_cos_quarters::<false>(4e12, 1e-20);
        assert!((sin / (1e-20 * FRAC_PI_2) - 1.0).abs() < 3e-16 && cos == 1.0);
    }

    #[test]
    fn the_exponential_agrees_with_the_standard_library() {
        let mut random = fastrand::Rng::with_seed(4);
        for n in 0..100_000 {
            let x = if n % 2 == 0 { 1416.0 * random.f64() - 708.0 } else { 4.0 * random.f64() - 2.0 };
            assert!((exp(x) / x.exp() - 1.0).abs() < 4.0 * ULP, "{x}: {} {}", exp(x), x.exp());
        }
        assert_eq!(exp(0.0), 1.0);
        for n in 0..100_000 {
            let x = (random.f64() - 0.5) * 10_f64.powi(2 - n % 20);
            let (whole, less_one) = exp_and_exp_m1(x);
            assert_eq!(whole, exp(x));
            assert!((less_one / x.exp_m1() - 1.0).abs() < 4.0 * ULP, "{x}: {less_one} {}", x.exp_m1());
        }
        assert_eq!(exp_and_exp_m1(0.0), (1.0, 0.0));
        assert!(
            exp(-800.0) < 1e-307
                && exp(f64::NEG_INFINITY) < 1e-307
                && exp_or_infinity(710.0) == f64::INFINITY
        );
    }
}

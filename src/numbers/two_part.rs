//! Numbers in two parts: an unevaluated sum of two `f64`, about 32 significant digits.
//!
//! Used where sixteen digits are not enough on the way to a result that should have sixteen: a phase
//! after many turns, the difference of two nearly equal squares. Sums and products of plain numbers are
//! exact (Knuth's and Dekker's error-free transformations; Muller et al., *Handbook of Floating-Point
//! Arithmetic*, 2nd ed., §4.3 and §4.4, and chapter 14 for the arithmetic of pairs).
//!
//! Exactness holds as long as nothing overflows or underflows: arguments between about 1e-140 and
//! 1e290 in size, or zero. The scenes see to that by refusing quantities far outside this world.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The sum `high + low`, where `low` is at most half a unit in the last place of `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TwoPart {
    high: f64,
    low: f64,
}

impl TwoPart {
    /// The number rounded to one `f64`.
    pub(crate) fn rounded(self) -> f64 {
        self.high
    }

    /// π to 32 digits.
    pub(crate) const PI: Self = Self { high: std::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 };

    /// The exact sum of two numbers.
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let b_kept = high - a;
        let a_kept = high - b_kept;
        Self { high, low: (a - a_kept) + (b - b_kept) }
    }

    /// The two parts.
    pub(crate) fn parts(self) -> (f64, f64) {
        (self.high, self.low)
    }

    /// The exact product of two numbers.
    #[inline]
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        if cfg!(target_feature = "fma") {
            return Self { high, low: a.mul_add(b, -high) };
        }
        let (a1, a2) = halves(a);
        let (b1, b2) = halves(b);
        Self { high, low: a2 * b2 - (((high - a1 * b1) - a2 * b1) - a1 * b2) }
    }

    /// The exact sum of two numbers of which the first is the larger in size.
    fn quick_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        Self { high, low: b - (high - a) }
    }

    /// The square root, of zero or more.
    pub(crate) fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::from(0.0);
        }
        let root = self.high.sqrt();
        let rest = self - Self::product(root, root);
        Self::quick_sum(root, rest.high / (2.0 * root))
    }

    /// The exponential, rounded.
    pub(crate) fn exp(self) -> f64 {
        let power = self.high.exp();
        if self.high.abs() < LARGEST_EXPONENT { power * (1.0 + self.low) } else { power }
    }

    /// Sine and cosine of this angle in radians, each to a unit in the last place or so of one, however many turns the
    /// angle makes.
    pub(crate) fn sin_cos(self) -> (f64, f64) {
        let (sin, cos) = self.high.sin_cos();
        let low = self.low;
        if low.abs() < SMALL_ANGLE {
            // sin(h + l) and cos(h + l) to first order in l; the second order is below 1e-16.
            return (sin + low * cos, cos - low * sin);
        }
        let (sin_low, cos_low) = low.sin_cos();
        (sin * cos_low + cos * sin_low, cos * cos_low - sin * sin_low)
    }
}

/// Beyond this an exponential is zero or infinite.
const LARGEST_EXPONENT: f64 = 1e3;
/// Below this an angle's square is lost in rounding.
const SMALL_ANGLE: f64 = 1e-9;

/// Veltkamp's splitting of a number into two of at most 26 bits each.
fn halves(a: f64) -> (f64, f64) {
    const SPLIT: f64 = 134_217_729.0; // 2^27 + 1
    let scaled = SPLIT * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

impl From<f64> for TwoPart {
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

impl Neg for TwoPart {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Add for TwoPart {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        let low = Self::sum(self.low, other.low);
        let first = Self::quick_sum(high.high, high.low + low.high);
        Self::quick_sum(first.high, first.low + low.low)
    }
}

impl Add<f64> for TwoPart {
    type Output = Self;

    /// For a number of the size of the second part. One that is larger than the first loses digits of that: for it
    /// there is `self + TwoPart::from(other)`.
    fn add(self, other: f64) -> Self {
        Self::quick_sum(self.high, self.low + other)
    }
}

impl Sub for TwoPart {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for TwoPart {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let exact = Self::product(self.high, other.high);
        Self::quick_sum(exact.high, exact.low + (self.high * other.low + self.low * other.high))
    }
}

impl Mul<f64> for TwoPart {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        let exact = Self::product(self.high, factor);
        Self::quick_sum(exact.high, exact.low + self.low * factor)
    }
}

impl Div for TwoPart {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * first;
        let second = rest.high / other.high;
        let rest = rest - other * second;
        Self::quick_sum(first, second) + Self::from(rest.high / other.high)
    }
}

#[cfg(test)]
mod tests {
    use super::TwoPart;

    /// A number of 53 random bits as an integer below 2^53, and as the same `f64`.
    fn whole(random: &mut fastrand::Rng) -> (i128, f64) {
        let n = random.u64(1 << 52..1 << 53);
        (i128::from(n), n as f64)
    }

    #[test]
    fn sums_and_products_are_exact() {
        let mut random = fastrand::Rng::with_seed(1);
        for _ in 0..10_000 {
            let ((m, a), (n, b)) = (whole(&mut random), whole(&mut random));
            let TwoPart { high, low } = TwoPart::product(a, b);
            assert_eq!(high as i128 + low as i128, m * n);
            assert_eq!(high, a * b);
            // A sum with a difference of thirty binary places between its terms.
            let TwoPart { high, low } = TwoPart::sum(a * 2.0_f64.powi(30), -b);
            assert_eq!(high as i128 + low as i128, (m << 30) - n);
        }
    }

    /// Relative size of what is left when `a` should equal `b`.
    fn difference(a: TwoPart, b: TwoPart) -> f64 {
        let rest = a - b;
        ((rest.high + rest.low) / b.high).abs()
    }

    #[test]
    fn quotients_and_roots_have_thirty_digits() {
        let mut random = fastrand::Rng::with_seed(2);
        for _ in 0..10_000 {
            let mut number = || {
                let TwoPart { high, low } = TwoPart::product(whole(&mut random).1, 1.0 / 3.0);
                TwoPart { high, low } + TwoPart::from(random.f64())
            };
            let (a, b) = (number(), number());
            assert!(difference(a / b * b, a) < 1e-30);
            assert!(difference(a.sqrt() * a.sqrt(), a) < 1e-30);
            assert!(
                difference((a + b) * (a - b), a * a - b * b) < 1e-29 * (a.high / (a - b).high).abs().max(1.0)
            );
        }
        assert_eq!(TwoPart::from(0.0).sqrt(), TwoPart::from(0.0));
        assert_eq!(TwoPart::from(4.0).sqrt(), TwoPart::from(2.0));
    }

    #[test]
    fn sine_and_cosine_see_the_second_part() {
        let turns = TwoPart::PI * 2_000_000_006.0;
        let (sin, cos) = turns.sin_cos();
        assert!(sin.abs() < 1e-15 && (cos - 1.0).abs() < 1e-15, "{sin} {cos}");
        assert!((2_000_000_006.0 * std::f64::consts::PI).sin().abs() > 1e-8);
        // A second part too large for the first-order formula.
        let (sin, cos) = TwoPart { high: 1e20, low: 1.0 }.sin_cos();
        let [s, c] = [1e20_f64.sin(), 1e20_f64.cos()];
        let one = 1.0_f64;
        assert!((sin - (s * one.cos() + c * one.sin())).abs() < 1e-15);
        assert!((cos - (c * one.cos() - s * one.sin())).abs() < 1e-15);
    }
}

//! Numbers of 32 digits, for judges: unevaluated sums of two `f64`, with what a judge needs of arithmetic and
//! functions.
//!
//! T. J. Dekker, *Numerische Mathematik* **18** (1971) 224–242; D. E. Knuth, *The Art of Computer Programming*, vol. 2,
//! §4.2.2. The library has such numbers too, private ones; these share no line with them.

use std::iter::Sum;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of 32 digits.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(crate) struct Long {
    high: f64,
    low: f64,
}

pub(crate) const PI: Long = Long { high: std::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 };
const LN_2: Long = Long { high: std::f64::consts::LN_2, low: 2.319_046_813_846_299_6e-17 };
/// Powers of a small argument after which a series has converged.
const TERMS: i32 = 22;

/// The same as a [`Long`].
pub(crate) fn long(value: f64) -> Long {
    Long { high: value, low: 0.0 }
}

fn normal(high: f64, low: f64) -> Long {
    let sum = high + low;
    Long { high: sum, low: low - (sum - high) }
}

fn exact_sum(a: f64, b: f64) -> Long {
    let sum = a + b;
    let part = sum - a;
    Long { high: sum, low: (a - (sum - part)) + (b - part) }
}

fn exact_product(a: f64, b: f64) -> Long {
    let product = a * b;
    Long { high: product, low: a.mul_add(b, -product) }
}

impl Long {
    /// The nearest `f64`.
    pub(crate) fn rounded(self) -> f64 {
        self.high
    }

    pub(crate) fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    pub(crate) fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return long(self.high.sqrt());
        }
        let first = long(self.high.sqrt());
        first + (self - first * first) / (first * 2.0)
    }

    /// Times a power of two.
    fn scaled(self, power: i32) -> Self {
        // In two steps, neither of which leaves the range alone.
        let (one, other) = (2.0_f64.powi(power / 2), 2.0_f64.powi(power - power / 2));
        Self { high: self.high * one * other, low: self.low * one * other }
    }

    pub(crate) fn exp(self) -> Self {
        let twos = (self.high / LN_2.high).round();
        if twos.is_nan() || twos.abs() >= 1050.0 {
            return long(self.high.exp());
        }
        // The series of a 256th, less one, squared up again.
        let x = (self - LN_2 * twos).scaled(-8);
        let mut grown = (1..=TERMS).rev().fold(long(0.0), |sum, n| (sum + 1.0) * x / f64::from(n));
        for _ in 0..8 {
            grown = grown * (grown + 2.0); // of (1 + e)² − 1
        }
        (grown + 1.0).scaled(twos as i32)
    }

    pub(crate) fn ln(self) -> Self {
        let first = long(self.high.ln());
        let second = first + self * (-first).exp() - 1.0;
        second + self * (-second).exp() - 1.0
    }

    /// Sine and cosine.
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        let quarter = PI * 0.5;
        let turns = (self.high / quarter.high).round();
        let x = (self - quarter * turns) * 0.125;
        let square = x * x;
        // Of an eighth: the sine, and the cosine less one; then doubled three times.
        let series = |first: i32| {
            (0..TERMS / 2).rev().fold(long(1.0), |sum, n| {
                let order = 2 * n + first;
                long(1.0) - square * sum / f64::from((order + 1) * (order + 2))
            })
        };
        let mut sin = x * series(1);
        let mut less = -square * 0.5 * series(2);
        for _ in 0..3 {
            (sin, less) = (sin * (less + 1.0) * 2.0, -sin * sin * 2.0);
        }
        let cos = less + 1.0;
        match turns.rem_euclid(4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }
}

impl From<f64> for Long {
    fn from(value: f64) -> Self {
        long(value)
    }
}

impl Neg for Long {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl<T: Into<Long>> Add<T> for Long {
    type Output = Self;
    fn add(self, other: T) -> Self {
        let other = other.into();
        let (high, low) = (exact_sum(self.high, other.high), exact_sum(self.low, other.low));
        let first = normal(high.high, high.low + low.high);
        normal(first.high, first.low + low.low)
    }
}

impl<T: Into<Long>> Sub<T> for Long {
    type Output = Self;
    fn sub(self, other: T) -> Self {
        self + -other.into()
    }
}

impl<T: Into<Long>> Mul<T> for Long {
    type Output = Self;
    fn mul(self, other: T) -> Self {
        let other = other.into();
        let product = exact_product(self.high, other.high);
        normal(product.high, product.low + (self.high * other.low + self.low * other.high))
    }
}

impl<T: Into<Long>> Div<T> for Long {
    type Output = Self;
    fn div(self, other: T) -> Self {
        let other = other.into();
        let first = self.high / other.high;
        if !first.is_finite() || first == 0.0 {
            return long(first);
        }
        let rest = self - other * first;
        let second = rest.high / other.high;
        let third = (rest - other * second).high / other.high;
        normal(first, second) + third
    }
}

impl Sum for Long {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(long(0.0), |sum, term| sum + term)
    }
}

#[test]
fn they_have_thirty_digits() {
    let mut random = fastrand::Rng::with_seed(1);
    for _ in 0..2000 {
        let x = long(40.0 * random.f64() - 20.0) / 3.0;
        let y = long(random.f64() + 0.1) / 7.0;
        let close = |a: Long, b: Long| (a - b).abs() < (b.abs() + 1e-300) * 3e-31;
        assert!(close(x / y * y, x) && close(y.sqrt() * y.sqrt(), y));
        assert!(close(x.exp() * (-x).exp(), long(1.0)), "{x:?}");
        assert!(close((x + y).exp(), x.exp() * y.exp()), "{x:?} {y:?}");
        assert!(
            ((y.exp()).ln() - y).abs() < long(1e-30) && (x.exp().ln() - x).abs() < long(1e-29),
            "{x:?} {y:?}"
        );
        let ((s, c), (s2, c2)) = (x.sin_cos(), (x * 2.0).sin_cos());
        assert!((s * s + c * c - 1.0).abs() < long(1e-30) && (s2 - s * c * 2.0).abs() < long(1e-30), "{x:?}");
        assert!(
            (c2 - (c * c - s * s)).abs() < long(1e-30) && (c.rounded() - x.rounded().cos()).abs() < 1e-14
        );
        assert!((x.exp().rounded() / x.rounded().exp() - 1.0).abs() < 1e-13);
    }
    // e, π and ln 2 to 31 digits, as texts.
    let text = |digits: &str| {
        let (whole, rest) = digits.split_at(16);
        let scale = |part: &str| long(part.parse::<f64>().unwrap());
        scale(whole) / 1e15 + scale(rest) / 1e15 / 10_f64.powi(rest.len() as i32)
    };
    assert!((long(1.0).exp() - text("2718281828459045235360287471352")).abs() < long(1e-29));
    assert!((PI - text("3141592653589793238462643383279")).abs() < long(1e-29));
    assert!((LN_2 * 10.0 - text("6931471805599453094172321214581")).abs() < long(1e-29));
}

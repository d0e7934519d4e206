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

    /// How far a number is off this, relative to it.
    pub(crate) fn off(self, found: f64) -> f64 {
        if self == long(found) { 0.0 } else { ((self - found) / self).abs().rounded() }
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

/// How far an angle is off that of these two components, relative to it.
pub(crate) fn off_angle((sin, cos): (Long, Long), angle: f64) -> f64 {
    let (s, c) = long(angle).sin_cos();
    let error = ((s * cos - c * sin) / (sin * sin + cos * cos).sqrt()).abs().rounded();
    if error == 0.0 { 0.0 } else { error / angle }
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

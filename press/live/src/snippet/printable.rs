//! What a page can print, and in which form. A number that a reader has changed is answered in the form of the page.

use std::fmt;

/// What a page can print: a number, or several.
#[diagnostic::on_unimplemented(
    message = "a page cannot print a `{Self}`",
    label = "behind `// →` stands a number of this line",
    note = "it can be an `f64`, an integer, or a pair or an array of them: print a word or a truth by an assertion"
)]
pub trait Printable {
    /// The numbers of the value, in their order.
    fn numbers(&self) -> Vec<Number>;
}

/// A number of a value.
#[derive(Clone, Copy, PartialEq)]
pub enum Number {
    /// One that a page rounds.
    Real(f64),
    /// One that a page prints as it is.
    Whole(i128),
}

impl fmt::Debug for Number {
    /// All digits.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Real(value) => fmt::Debug::fmt(value, out),
            Self::Whole(value) => fmt::Debug::fmt(value, out),
        }
    }
}

impl Number {
    /// The number with as many digits as `shown` has, and in its form.
    pub fn written_like(self, shown: &str) -> String {
        let decimals = |text: &str| text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        match (self, shown.split_once('e')) {
            (Self::Whole(value), _) => value.to_string(),
            (Self::Real(value), Some((digits, _))) => format!("{value:.*e}", decimals(digits)),
            (Self::Real(value), None) => format!("{value:.*}", decimals(shown)),
        }
    }
}

impl Printable for f64 {
    fn numbers(&self) -> Vec<Number> {
        vec![Number::Real(*self)]
    }
}

/// Whether a number in print is a zero, which has no sign on paper.
pub(super) fn is_zero(text: &str) -> bool {
    !text.contains(|c: char| c.is_ascii_digit() && c != '0')
}

macro_rules! whole {
    ($($integer:ty),+) => {$(
        impl Printable for $integer {
            fn numbers(&self) -> Vec<Number> {
                vec![Number::Whole(i128::try_from(*self).expect("a number that a page prints is small"))]
            }
        }
    )+};
}
whole!(i32, i64, u8, u32, u64, usize);

impl<T: Printable + ?Sized> Printable for &T {
    fn numbers(&self) -> Vec<Number> {
        (**self).numbers()
    }
}

impl<T: Printable, const N: usize> Printable for [T; N] {
    fn numbers(&self) -> Vec<Number> {
        self.iter().flat_map(Printable::numbers).collect()
    }
}

impl<A: Printable, B: Printable> Printable for (A, B) {
    fn numbers(&self) -> Vec<Number> {
        [self.0.numbers(), self.1.numbers()].concat()
    }
}

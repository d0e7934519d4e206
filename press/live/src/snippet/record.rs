//! What a snippet prints and what its assertions find, while it runs.

use super::printable::{Number, Printable, is_zero};
use std::cell::RefCell;

#[derive(Default)]
struct Record {
    printed: Vec<String>,
    checks: Vec<Option<bool>>,
}

thread_local! {
    static RECORD: RefCell<Record> = RefCell::default();
}

/// Begins a snippet that prints so many values and has so many assertions.
pub(super) fn begin(printed: usize, checks: usize) {
    RECORD.set(Record { printed: vec![String::new(); printed], checks: vec![None; checks] });
}

/// What was recorded, a line for each value and each assertion.
pub(super) fn lines() -> Vec<String> {
    let Record { printed, checks } = RECORD.take();
    let printed = printed.into_iter().map(|numbers| format!("={numbers}"));
    let checks = checks.into_iter().map(|found| match found {
        Some(true) => "+".to_owned(),
        Some(false) => "-".to_owned(),
        None => "?".to_owned(),
    });
    printed.chain(checks).collect()
}

/// Records a value in the form of `shown`, which the page prints.
pub fn printed(at: usize, value: &impl Printable, shown: &str) {
    let numbers = value.numbers().into_iter().zip(shown.split(", "));
    let written: Vec<String> = numbers.map(|(number, shown)| written(number, shown)).collect();
    RECORD.with_borrow_mut(|record| record.printed[at] = written.join(", "));
}

/// A number that counts, of the type that the snippet gives to the one in its text: where it does not say, that of a
/// literal.
///
/// # Panics
/// If the type has no such number.
pub fn whole<T: TryFrom<i64>>(_text: T, value: f64) -> T {
    T::try_from(value as i64)
        .unwrap_or_else(|_| panic!("the number that counts here cannot be {value}: its range is too wide"))
}

/// A number in the form of `shown`, or with two digits where this form has none left of it and the page shows no zero.
fn written(number: Number, shown: &str) -> String {
    let form = number.written_like(shown);
    match number {
        Number::Real(value) if value.is_nan() => "no number".to_owned(),
        Number::Real(value) if value.is_infinite() => if value > 0.0 { "∞" } else { "-∞" }.to_owned(),
        Number::Real(value) if is_zero(&form) && value != 0.0 && !is_zero(shown) => format!("{value:.1e}"),
        Number::Real(value) if value.abs() >= 1e9 => format!("{value:.2e}"),
        _ if is_zero(&form) => form.trim_start_matches('-').to_owned(),
        _ => form,
    }
}

/// Records what an assertion finds; it holds if it holds each time.
pub fn check(at: usize, holds: bool) {
    RECORD.with_borrow_mut(|record| record.checks[at] = Some(record.checks[at].unwrap_or(true) && holds));
}

/// The assertions by their own names. The build script has put their number before what they are given.
pub mod assertions {
    pub use crate::{
        recorded_assert as assert, recorded_assert_eq as assert_eq, recorded_assert_ne as assert_ne,
    };

    /// What snippets import from the crate `approx`.
    pub mod approx {
        pub use crate::{
            recorded_assert_abs_diff_eq as assert_abs_diff_eq,
            recorded_assert_relative_eq as assert_relative_eq, recorded_assert_ulps_eq as assert_ulps_eq,
        };
    }
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert {
    ($at:literal; $holds:expr $(, $($words:tt)*)?) => {
        $crate::snippet::record::check($at, $holds)
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert_eq {
    ($at:literal; $one:expr, $other:expr $(,)?) => {
        $crate::snippet::record::check($at, $one == $other)
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert_ne {
    ($at:literal; $one:expr, $other:expr $(,)?) => {
        $crate::snippet::record::check($at, $one != $other)
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert_relative_eq {
    ($at:literal; $one:expr, $other:expr $(, $option:ident = $value:expr)* $(,)?) => {
        $crate::snippet::record::check($at, $crate::approx::relative_eq!($one, $other $(, $option = $value)*))
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert_abs_diff_eq {
    ($at:literal; $one:expr, $other:expr $(, $option:ident = $value:expr)* $(,)?) => {
        $crate::snippet::record::check($at, $crate::approx::abs_diff_eq!($one, $other $(, $option = $value)*))
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert_ulps_eq {
    ($at:literal; $one:expr, $other:expr $(, $option:ident = $value:expr)* $(,)?) => {
        $crate::snippet::record::check($at, $crate::approx::ulps_eq!($one, $other $(, $option = $value)*))
    };
}

#[cfg(test)]
mod tests {
    use super::whole;

    #[test]
    fn a_number_that_counts_has_the_type_that_the_text_gives_it_or_that_of_a_literal() {
        let count = whole(3, 5.0);
        std::assert_eq!((count as f64, f64::from(count)), (5.0, 5.0));
        let places: usize = whole(3, 7.0);
        std::assert_eq!(places, 7);
    }
}

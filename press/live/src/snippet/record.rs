//! What a snippet prints and what its assertions find, while it runs.

use super::printable::{Number, Printable, is_zero};
use std::cell::RefCell;

#[derive(Default)]
struct Record {
    printed: Vec<String>,
    checks: Vec<Check>,
}

/// What an assertion has found.
#[derive(Clone, Default)]
enum Check {
    #[default]
    Unread,
    Holds,
    /// It failed, the first time by what was compared: words, or none.
    Fails(String),
}

thread_local! {
    static RECORD: RefCell<Record> = RefCell::default();
}

/// Begins a snippet that prints so many values and has so many assertions.
pub(super) fn begin(printed: usize, checks: usize) {
    RECORD.set(Record { printed: vec![String::new(); printed], checks: vec![Check::Unread; checks] });
}

/// What was recorded, a line for each value and each assertion.
pub(super) fn lines() -> Vec<String> {
    let Record { printed, checks } = RECORD.take();
    let printed = printed.into_iter().map(|numbers| format!("={numbers}"));
    let checks = checks.into_iter().map(|found| match found {
        Check::Holds => "+".to_owned(),
        Check::Fails(by) => format!("-{by}"),
        Check::Unread => "?".to_owned(),
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
    compared(at, holds, "", None, None);
}

/// Records what a comparison finds, and if it fails the two numbers, with words between them for that.
pub fn compared(at: usize, holds: bool, fails: &str, one: Option<Number>, other: Option<Number>) {
    RECORD.with_borrow_mut(|record| match &mut record.checks[at] {
        Check::Fails(_) => {}
        check if holds => *check = Check::Holds,
        check => {
            let [one, other] = apart(one, other);
            let is_number = !one.is_empty() && !other.is_empty();
            *check = Check::Fails(if is_number { format!("{one} {fails} {other}") } else { String::new() });
        }
    });
}

/// Two numbers with three digits that count, or as many as tell them apart.
fn apart(one: Option<Number>, other: Option<Number>) -> [String; 2] {
    let all = [one, other];
    let mut found = all.map(|number| short(number, 3));
    for digits in 4..=17 {
        if found[0] != found[1] || one == other {
            break;
        }
        found = all.map(|number| short(number, digits));
    }
    found
}

/// A number with so many digits that count, without zeros at its end; nothing for none.
fn short(number: Option<Number>, digits: usize) -> String {
    let value = match number {
        None => return String::new(),
        Some(Number::Whole(value)) => return value.to_string(),
        Some(Number::Real(value)) => value,
    };
    let power = value.abs().log10().floor();
    let text = match () {
        () if !value.is_finite() => written(Number::Real(value), ""),
        () if value == 0.0 => "0".to_owned(),
        () if !(-3.0..9.0).contains(&power) => format!("{value:.*e}", digits - 1),
        () => format!("{value:.*}", (digits as f64 - 1.0 - power).max(0.0) as usize),
    };
    let (number, power) = text.split_at(text.find('e').unwrap_or(text.len()));
    let number =
        if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number };
    format!("{number}{power}")
}

/// What stands on one side of a comparison. It is shown if it is a number.
#[derive(Debug)]
pub struct Beside<'a, T: ?Sized>(pub &'a T);

/// The number on one side of a comparison.
pub trait Shown {
    /// The number, if it is one.
    fn shown(&self) -> Option<Number>;
}

impl<T: Printable + ?Sized> Shown for Beside<'_, T> {
    fn shown(&self) -> Option<Number> {
        let numbers = self.0.numbers();
        numbers.first().copied().filter(|_| numbers.len() == 1)
    }
}

/// What is no number is not shown. (A call finds [`Shown`] first, as it needs no further reference.)
pub trait Hidden {
    /// None.
    fn shown(&self) -> Option<Number> {
        None
    }
}

impl<T: ?Sized> Hidden for &Beside<'_, T> {}

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
    ($at:literal; < $($whole:tt)*) => { $crate::recorded_whole!($at; < $($whole)*) };
    ($at:literal; $($code:tt)*) => { $crate::recorded_condition!($at; [] $($code)*) };
}

/// A condition that is taken as it is.
#[doc(hidden)]
#[macro_export]
macro_rules! recorded_whole {
    ($at:literal; $holds:expr $(, $($words:tt)*)?) => {
        $crate::snippet::record::check($at, $holds)
    };
}

/// Looks for a comparison in a condition, of which the part in brackets holds none.
#[doc(hidden)]
#[macro_export]
macro_rules! recorded_condition {
    ($at:literal; [$($one:tt)*] $(, $($words:tt)*)?) => { $crate::recorded_whole!($at; $($one)*) };
    ($at:literal; [$($one:tt)*] && $($more:tt)*) => { $crate::recorded_whole!($at; $($one)* && $($more)*) };
    ($at:literal; [$($one:tt)*] || $($more:tt)*) => { $crate::recorded_whole!($at; $($one)* || $($more)*) };
    ($at:literal; [$($one:tt)*] ::< $of:ty > $($more:tt)*) => {
        $crate::recorded_condition!($at; [$($one)* ::<$of>] $($more)*)
    };
    ($at:literal; [$($one:tt)*] < $($more:tt)*) => {
        $crate::recorded_sides!($at; [$($one)*] [<] "is not below"; [] $($more)*)
    };
    ($at:literal; [$($one:tt)*] <= $($more:tt)*) => {
        $crate::recorded_sides!($at; [$($one)*] [<=] "is above"; [] $($more)*)
    };
    ($at:literal; [$($one:tt)*] > $($more:tt)*) => {
        $crate::recorded_sides!($at; [$($one)*] [>] "is not above"; [] $($more)*)
    };
    ($at:literal; [$($one:tt)*] >= $($more:tt)*) => {
        $crate::recorded_sides!($at; [$($one)*] [>=] "is below"; [] $($more)*)
    };
    ($at:literal; [$($one:tt)*] == $($more:tt)*) => {
        $crate::recorded_sides!($at; [$($one)*] [==] "is not"; [] $($more)*)
    };
    ($at:literal; [$($one:tt)*] != $($more:tt)*) => {
        $crate::recorded_sides!($at; [$($one)*] [!=] "is"; [] $($more)*)
    };
    ($at:literal; [$($one:tt)*] $next:tt $($more:tt)*) => {
        $crate::recorded_condition!($at; [$($one)* $next] $($more)*)
    };
}

/// A comparison, if its other side goes on to the end of the condition.
#[doc(hidden)]
#[macro_export]
macro_rules! recorded_sides {
    ($at:literal; [$($one:tt)*] [$sign:tt] $fails:literal; [$($other:tt)*] $(, $($words:tt)*)?) => {
        match (&($($one)*), &($($other)*)) {
            (one, other) => $crate::recorded_pair!($at, *one $sign *other, $fails, one, other),
        }
    };
    ($at:literal; [$($one:tt)*] [$sign:tt] $fails:literal; [$($other:tt)*] && $($more:tt)*) => {
        $crate::recorded_whole!($at; $($one)* $sign $($other)* && $($more)*)
    };
    ($at:literal; [$($one:tt)*] [$sign:tt] $fails:literal; [$($other:tt)*] || $($more:tt)*) => {
        $crate::recorded_whole!($at; $($one)* $sign $($other)* || $($more)*)
    };
    ($at:literal; $one:tt $sign:tt $fails:literal; [$($other:tt)*] $next:tt $($more:tt)*) => {
        $crate::recorded_sides!($at; $one $sign $fails; [$($other)* $next] $($more)*)
    };
}

/// What a comparison of two references finds.
#[doc(hidden)]
#[macro_export]
macro_rules! recorded_pair {
    ($at:literal, $holds:expr, $fails:literal, $one:expr, $other:expr) => {{
        #[allow(unused_imports, reason = "one of the two traits, for a number or for what is none")]
        use $crate::snippet::record::{Beside, Hidden as _, Shown as _, compared};
        compared($at, $holds, $fails, (&Beside($one)).shown(), (&Beside($other)).shown())
    }};
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert_eq {
    ($at:literal; $one:expr, $other:expr $(,)?) => {
        match (&$one, &$other) {
            (one, other) => $crate::recorded_pair!($at, *one == *other, "is not", one, other),
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert_ne {
    ($at:literal; $one:expr, $other:expr $(,)?) => {
        match (&$one, &$other) {
            (one, other) => $crate::recorded_pair!($at, *one != *other, "is", one, other),
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert_relative_eq {
    ($at:literal; $one:expr, $other:expr $(, $option:ident = $value:expr)* $(,)?) => {
        match (&$one, &$other) {
            (one, other) => {
                let holds = $crate::approx::relative_eq!(*one, *other $(, $option = $value)*);
                $crate::recorded_pair!($at, holds, "is not", one, other)
            }
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert_abs_diff_eq {
    ($at:literal; $one:expr, $other:expr $(, $option:ident = $value:expr)* $(,)?) => {
        match (&$one, &$other) {
            (one, other) => {
                let holds = $crate::approx::abs_diff_eq!(*one, *other $(, $option = $value)*);
                $crate::recorded_pair!($at, holds, "is not", one, other)
            }
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! recorded_assert_ulps_eq {
    ($at:literal; $one:expr, $other:expr $(, $option:ident = $value:expr)* $(,)?) => {
        match (&$one, &$other) {
            (one, other) => {
                let holds = $crate::approx::ulps_eq!(*one, *other $(, $option = $value)*);
                $crate::recorded_pair!($at, holds, "is not", one, other)
            }
        }
    };
}

#[cfg(test)]
mod tests {
    use super::{begin, lines, whole};

    #[test]
    fn a_number_that_counts_has_the_type_that_the_text_gives_it_or_that_of_a_literal() {
        let count = whole(3, 5.0);
        std::assert_eq!((count as f64, f64::from(count)), (5.0, 5.0));
        let places: usize = whole(3, 7.0);
        std::assert_eq!(places, 7);
    }

    /// What the assertions say at one number.
    fn found(x: f64) -> [String; 14] {
        use crate::snippet::record::assertions::{approx::assert_relative_eq, assert, assert_eq, assert_ne};
        begin(0, 14);
        let (all, far) = ([1, 2, 3], Some(x));
        assert!(0; x < 2.0);
        assert!(1; x <= 2.0, "words and {x} < 3");
        assert!(2; 2.0 > x.abs() + 1.0);
        assert!(3; all.len() == x as usize);
        assert!(4; all.iter().map(|n| f64::from(*n)).sum::<f64>() >= 2.0 * x);
        assert!(5; x < 2.0 && all.len() < 9);
        assert!(6; x < 2.0 || all.len() > 9);
        assert!(7; far < Some(2.0));
        assert!(8; (0.0..2.0).contains(&x));
        assert_eq!(9; all.len(), x as usize);
        assert_ne!(10; x as i32, 4);
        assert_relative_eq!(11; x, 3.0, epsilon = 1e-9);
        assert!(12; (x - 3.0) * 1e-7 <= 0.0);
        for n in 0..3 {
            assert!(13; x < f64::from(n) + 3.0);
        }
        lines().try_into().unwrap()
    }

    #[test]
    fn an_assertion_that_fails_shows_the_numbers_that_it_compares() {
        std::assert_eq!(
            found(4.0),
            [
                "-4 is not below 2",
                "-4 is above 2",
                "-2 is not above 5",
                "-3 is not 4",
                "-6 is below 8",
                "-",
                "-",
                "-",
                "-",
                "-3 is not 4",
                "-4 is 4",
                "-4 is not 3",
                "-1e-7 is above 0",
                "-4 is not below 3",
            ]
        );
        std::assert_eq!(found(2.00004)[0], "-2.00004 is not below 2");
        std::assert_eq!(found(1e12)[0], "-1e12 is not below 2");
        std::assert_eq!(found(f64::NAN)[0], "-no number is not below 2");
        std::assert!(
            found(1.9)[..3].iter().zip(["+", "+", "-2 is not above 2.9"]).all(|(one, other)| one == other)
        );
    }
}

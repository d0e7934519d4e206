//! Numbers as they are written beside a picture.

use crate::numbers::with_power;
use crate::scene::Form;

/// A number with its unit, as HTML: a true minus, and powers of ten raised.
///
/// ```
/// use live::{Form, written};
/// assert_eq!(written(-2.0_f64.sqrt(), Form::Fixed(2), "rad/s"), "−1.41\u{a0}rad/s");
/// assert_eq!(written(1.26e-15, Form::Power(2), ""), "1.3·10<sup>−15</sup>");
/// assert_eq!(written(0.0, Form::Power(2), "J"), "0\u{a0}J");
/// assert_eq!(written(43.02, Form::Digits(3), "rad/s"), "43.0\u{a0}rad/s");
/// assert_eq!(written(0.00012345, Form::Digits(3), "s"), "1.23·10<sup>−4</sup>\u{a0}s");
/// assert_eq!(written(f64::NAN, Form::Fixed(0), "s"), "–");
/// ```
pub fn written(value: f64, form: Form, unit: &str) -> String {
    if !value.is_finite() {
        return "–".into();
    }
    let form = match form {
        Form::Digits(digits) => {
            let power = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
            let after = digits as f64 - 1.0 - power;
            if after >= 0.0 && power >= -3.0 { Form::Fixed(after as usize) } else { Form::Power(digits) }
        }
        form => form,
    };
    let number = match form {
        Form::Fixed(digits) => format!("{value:.digits$}"),
        Form::Power(_) if value == 0.0 => "0".into(),
        Form::Power(digits) | Form::Digits(digits) => format!("{value:.*e}", digits.saturating_sub(1)),
    };
    let number = match number.split_once('e') {
        Some((digits, power)) => with_power(digits, power),
        None if number.trim_start_matches(['-', '0', '.']).is_empty() => {
            number.trim_start_matches('-').into()
        }
        None => number,
    };
    let space = if unit.is_empty() || unit == "°" { "" } else { "\u{a0}" };
    format!("{}{space}{unit}", number.replace('-', "−"))
}

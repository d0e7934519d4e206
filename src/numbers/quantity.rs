//! Numbers with a name, a unit and a rule: what every scene checks before it computes.

use std::error::Error;
use std::fmt;
use std::ops::RangeInclusive;

/// Sizes that the library computes with, in SI units. Squares, fourth powers and products of such numbers neither
/// overflow nor underflow.
const RANGE: RangeInclusive<f64> = 1e-50..=1e50;

/// A quantity that breaks a rule of this world or of the computation.
///
/// Its message holds the name, the value, the unit and the rule.
///
/// ```
/// use mechanics::inertia::Body;
/// let refusal = Body::hoop(-2.0, 0.3).unwrap_err();
/// assert_eq!(refusal.to_string(), "mass -2 kg is not positive; it must be more than zero");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InvalidQuantity {
    /// What the number is.
    pub quantity: &'static str,
    /// The number.
    pub value: f64,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// The rule that it breaks.
    pub rule: Rule,
}

/// What is asked of a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Rule {
    /// It is a finite number.
    Finite,
    /// It is more than zero.
    Positive,
    /// It is zero or more.
    NotNegative,
    /// It is not zero.
    NotZero,
    /// Its size, if it is not zero, is from 1e-50 to 1e50 in its unit.
    InRange,
    /// It is at least so much.
    AtLeast(f64),
    /// It is at most so much.
    AtMost(f64),
    /// It is less than so much.
    LessThan(f64),
    /// It is more than so much.
    MoreThan(f64),
    /// It is so much, to rounding.
    EqualTo(f64),
    /// It does not exceed another quantity, of the same unit.
    NotAbove {
        /// What the other is.
        what: &'static str,
        /// How much that is.
        limit: f64,
    },
    /// It is no less than another quantity, of the same unit.
    NotBelow {
        /// What the other is.
        what: &'static str,
        /// How much that is.
        limit: f64,
    },
    /// With this value what is asked for does not exist, for the reason given.
    Because(&'static str),
}

impl InvalidQuantity {
    /// Whether a number is zero, or of a size that can be computed with.
    pub(crate) fn is_computable(value: f64) -> bool {
        value == 0.0 || RANGE.contains(&value.abs())
    }

    /// Checks that a number is finite and, if it is not zero, of a size that can be computed with.
    pub(crate) fn check(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, Self> {
        let rule = if !value.is_finite() {
            Rule::Finite
        } else if !Self::is_computable(value) {
            Rule::InRange
        } else {
            return Ok(value);
        };
        Err(Self { quantity, value, unit, rule })
    }

    /// The same, and that it is more than zero.
    pub(crate) fn check_positive(
        quantity: &'static str,
        value: f64,
        unit: &'static str,
    ) -> Result<f64, Self> {
        if value <= 0.0 && value.is_finite() {
            return Err(Self { quantity, value, unit, rule: Rule::Positive });
        }
        Self::check(quantity, value, unit)
    }

    /// The same, and that it is zero or more.
    pub(crate) fn check_not_negative(
        quantity: &'static str,
        value: f64,
        unit: &'static str,
    ) -> Result<f64, Self> {
        if value < 0.0 && value.is_finite() {
            return Err(Self { quantity, value, unit, rule: Rule::NotNegative });
        }
        Self::check(quantity, value, unit)
    }

    /// The number, if `result`, which follows from it, can be computed with and vanishes only with it: a message names
    /// what was given.
    pub(crate) fn require_computable(
        result: f64,
        quantity: &'static str,
        value: f64,
        unit: &'static str,
        because: &'static str,
    ) -> Result<f64, Self> {
        let computable = Self::is_computable(result) && (result != 0.0 || value == 0.0);
        Self::require(computable, quantity, value, unit, Rule::Because(because))
    }

    /// Checks that a number is finite, whatever its size.
    pub(crate) fn require_finite(
        quantity: &'static str,
        value: f64,
        unit: &'static str,
    ) -> Result<f64, Self> {
        Self::require(value.is_finite(), quantity, value, unit, Rule::Finite)
    }

    /// Checks a tolerance: positive, finite, and not below what rounding leaves of a step.
    pub(crate) fn check_tolerance(quantity: &'static str, value: f64, least: f64) -> Result<f64, Self> {
        Self::require_finite(quantity, value, "")?;
        Self::require(value > 0.0, quantity, value, "", Rule::Positive)?;
        Self::require(value >= least, quantity, value, "", Rule::AtLeast(least))
    }

    /// The size of the length of a step, in any unit of time: neither zero nor NaN.
    pub(crate) fn check_step(quantity: &'static str, length: f64) -> Result<f64, Self> {
        Self::require(!length.is_nan(), quantity, length, "", Rule::Finite)?;
        Self::require(length != 0.0, quantity, length, "", Rule::NotZero).map(f64::abs)
    }

    /// Checks a time, s: finite, and not too large to compute with.
    pub(crate) fn check_time(time: f64) -> Result<f64, Self> {
        if time.abs() < *RANGE.start() { Ok(time) } else { Self::check("time", time, "s") }
    }

    /// The number if a condition on it holds, else the rule.
    pub(crate) fn require(
        holds: bool,
        quantity: &'static str,
        value: f64,
        unit: &'static str,
        rule: Rule,
    ) -> Result<f64, Self> {
        if holds { Ok(value) } else { Err(Self { quantity, value, unit, rule }) }
    }
}

impl fmt::Display for InvalidQuantity {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { quantity, value, unit, rule } = *self;
        let unit = WithSpace(unit);
        if let Rule::Because(reason) = rule {
            return write!(out, "{quantity} {}{unit}: {reason}", Shown(value));
        }
        write!(out, "{quantity} {}{unit} ", Shown(value))?;
        match rule {
            Rule::Finite => write!(out, "is not a finite number"),
            Rule::Positive => write!(out, "is not positive; it must be more than zero"),
            Rule::NotNegative => write!(out, "is negative; it must be zero or more"),
            Rule::NotZero => write!(out, "must not be zero"),
            Rule::InRange => write!(
                out,
                "is outside the range from {:e} to {:e}{unit} in size that is computed with",
                RANGE.start(),
                RANGE.end()
            ),
            Rule::AtLeast(least) => write!(out, "is too small; it must be at least {}{unit}", Shown(least)),
            Rule::AtMost(limit) => write!(out, "is too large; it must be at most {}{unit}", Shown(limit)),
            Rule::LessThan(limit) => write!(out, "is too large; it must be less than {}{unit}", Shown(limit)),
            Rule::MoreThan(limit) => write!(out, "is too small; it must be more than {}{unit}", Shown(limit)),
            Rule::NotAbove { what, limit } => write!(out, "exceeds {what}, {}{unit}", Shown(limit)),
            Rule::NotBelow { what, limit } => write!(out, "is less than {what}, {}{unit}", Shown(limit)),
            Rule::Because(_) => Ok(()),
            Rule::EqualTo(only) => write!(out, "is not {}{unit} to rounding", Shown(only)),
        }
    }
}

impl Error for InvalidQuantity {}

/// A unit after its number: nothing for a pure number.
struct WithSpace(&'static str);

impl fmt::Display for WithSpace {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() { Ok(()) } else { write!(out, " {}", self.0) }
    }
}

/// A number in plain digits if that is short, else with an exponent.
pub(crate) struct Shown(pub(crate) f64);

impl fmt::Display for Shown {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        if value == 0.0 || (1e-4..1e7).contains(&value.abs()) {
            write!(out, "{value}")
        } else {
            write!(out, "{value:e}")
        }
    }
}

//! The one error of everything that checks numbers *and* integrates.

use crate::integrate::Failure;
use crate::quantity::InvalidQuantity;
use std::fmt;

/// Why there is no answer.
///
/// A function that only checks numbers returns an [`InvalidQuantity`], a stepping method a [`Failure`]; what
/// does both returns this. Its message is that of its cause, with the value, the unit and the rule broken, or
/// the time and the state at which an integration stopped.
///
/// ```
/// use mechanics::{Error, inertia::Body};
/// fn hoop() -> Result<Body, Error> {
///     Ok(Body::hoop(1.0, f64::NAN)?)
/// }
/// assert_eq!(hoop().unwrap_err().to_string(), "radius NaN m is not a finite number");
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A number breaks a rule of this world or of the computation.
    Quantity(InvalidQuantity),
    /// An integration stopped.
    Integration(Failure),
}

impl From<InvalidQuantity> for Error {
    fn from(error: InvalidQuantity) -> Self {
        Self::Quantity(error)
    }
}

impl From<Failure> for Error {
    fn from(error: Failure) -> Self {
        Self::Integration(error)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Quantity(error) => error.fmt(out),
            Self::Integration(error) => error.fmt(out),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Quantity(error) => Some(error),
            Self::Integration(error) => Some(error),
        }
    }
}

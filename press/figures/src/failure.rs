//! What can go wrong with a figure.

use crate::Cause;
use std::error::Error;
use std::fmt;

/// A figure that could not be drawn.
#[derive(Debug)]
pub struct Failure {
    pub(crate) chapter: &'static str,
    pub(crate) line: usize,
    pub(crate) figure: &'static str,
    pub(crate) cause: Cause,
}

impl fmt::Display for Failure {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "book/{}/figures.rs:{}: {}: {}", self.chapter, self.line, self.figure, self.cause)
    }
}

impl Error for Failure {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        Some(&*self.cause)
    }
}

/// An axis that no plot can have.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvalidAxis {
    /// The axis ends where it begins, or before, or at no number.
    Range {
        /// Where it begins.
        from: f64,
        /// Where it ends.
        to: f64,
    },
    /// A logarithmic axis that begins at zero or below.
    NotPositive {
        /// Where it begins.
        from: f64,
    },
    /// Ticks that are no distance apart, or more than a hundred.
    Step {
        /// The distance between ticks.
        step: f64,
    },
}

impl fmt::Display for InvalidAxis {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range { from, to } => {
                write!(out, "axis from {from} to {to}: it must end beyond its beginning")
            }
            Self::NotPositive { from } => {
                write!(out, "logarithmic axis from {from}: it must begin above zero")
            }
            Self::Step { step } => {
                write!(out, "ticks every {step}: the distance must be positive and give at most a hundred")
            }
        }
    }
}

impl Error for InvalidAxis {}

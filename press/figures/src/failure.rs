//! What can go wrong with a figure.

use crate::Cause;
use std::error::Error;
use std::fmt;

/// A figure that could not be drawn.
#[derive(Debug)]
pub struct Failure {
    pub(crate) file: &'static str,
    pub(crate) line: u32,
    pub(crate) figure: String,
    pub(crate) cause: Cause,
}

impl fmt::Display for Failure {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}:{}: {}: {}", self.file, self.line, self.figure, self.cause)
    }
}

impl Error for Failure {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        Some(&*self.cause)
    }
}

/// An axis that no plot can have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InvalidAxis {
    /// Where it would begin.
    pub from: f64,
    /// Where it would end.
    pub to: f64,
    /// The distance between its ticks: a difference of values, or a number of decades.
    pub step: f64,
}

impl fmt::Display for InvalidAxis {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            out,
            "axis from {} to {}, ticks every {}: it must end beyond its beginning, a logarithmic one begin above zero, \
             and ticks be a positive distance apart that gives at most a hundred",
            self.from, self.to, self.step
        )
    }
}

impl Error for InvalidAxis {}

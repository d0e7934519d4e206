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

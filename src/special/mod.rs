//! Special functions, by the arguments that keep their digits.

pub mod conical;
pub mod elliptic;
pub mod faddeeva;
pub(crate) mod gauss;

//! Rotation that nothing disturbs, in closed form.
//!
//! [`FreeSymmetricTop`] has an axis of symmetry and gives names to its two rates; [`FreeTop`] takes any body.

pub(crate) mod asymmetric;
pub(crate) mod symmetric;
pub(crate) mod theta;
mod top;

pub use symmetric::FreeSymmetricTop;
pub use top::FreeTop;

//! Rotation that nothing disturbs, in closed form.
//!
//! [`FreeSymmetricTop`] has an axis of symmetry and gives names to its two rates; [`FreeTop`] takes any body.

mod symmetric;
pub(crate) mod theta;
mod top;
mod tumbling;
mod two_turns;

pub use symmetric::FreeSymmetricTop;
pub use top::FreeTop;

//! The parts that schematics are made of.
//!
//! Angles are in radians, counter-clockwise on the page from the direction to the right; lengths are in pixels.

mod arrow;
mod device;
mod marker;
mod portrait;

pub(crate) use arrow::{HEAD, size};
pub use arrow::{Heads, angle, arrow, dimension, head};
pub use device::{damper, dampers, ground, spring};
pub use marker::{GRIP, Marker, grip, marker};
pub use portrait::portrait;

//! Moments of inertia: how a body's mass is spread.
//!
//! A [`Body`] knows its mass and its principal moments about its centre of mass; [`PrincipalMoments`] are all that its
//! free rotation depends on; an [`InertiaTensor`] is the same about any point ([`Body::about`]) and along any axes. A
//! matrix with products of inertia enters by [`InertiaTensor::new`], and its principal axes make a body of it.

mod body;
mod moments;
mod tensor;

pub use body::{Body, Cylinder, Ring, Spheroid};
pub use moments::{PrincipalMoments, SymmetricMoments};
pub use tensor::{InertiaTensor, PrincipalAxes};

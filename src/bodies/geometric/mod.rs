//! Stepping methods that know that the state is a rotation.
//!
//! A general method adds to the four numbers of a quaternion, which then is no longer of length one. These methods
//! only ever turn: the attitude is a product of exact rotations and stays an attitude, up to rounding.
//!
//! | method | for |
//! |---|---|
//! | [`Splitting`] | a free body over very many turns: keeps its angular momentum, and its energy error does not grow |
//! | [`commutator_free`] | any torque |
//!
//! [`crate::integrate::METHODS`] lists them with the others. A free body alone needs neither:
//! [`crate::free_rotation::FreeTop`] has no step.

mod commutator_free;
mod splitting;

pub use commutator_free::commutator_free;
pub use splitting::Splitting;

use crate::euler::Turning;
use crate::integrate::Failure;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// The rotation by a vector along its own direction, its length being the angle, rad, however small
/// (nalgebra's own takes angles below 4e-16 for none).
fn exp(scaled_axis: &Vector3<f64>) -> UnitQuaternion<f64> {
    let angle = scaled_axis.norm();
    if angle == 0.0 {
        return UnitQuaternion::identity();
    }
    let (sin, cos) = (0.5 * angle).sin_cos();
    UnitQuaternion::new_unchecked(Quaternion::from_parts(cos, scaled_axis * (sin / angle)))
}

/// Refuses what cannot be stepped: ends or a state that are not finite, no steps.
fn check(start: f64, state: &Turning, end: f64, steps: usize) -> Result<(), Failure> {
    Failure::check(start, &state.to_array(), end)?;
    if steps == 0 {
        return Err(Failure::NoSteps);
    }
    Ok(())
}

fn is_finite(state: &Turning) -> bool {
    state.to_array().iter().all(|number| number.is_finite())
}

//! Attitude: how a body stands in the room.
//!
//! An attitude is a rotation `world_from_body`: it takes the components of a vector along the body's axes to its components
//! along the axes of the room. It is kept as a unit quaternion, four numbers that know no singular direction. Its rows and
//! columns never have to be remembered: `v_world = world_from_body * v_body`.
//!
//! Angular velocities and momenta are along the body's axes (`_body`) or the room's (`_world`), as their names say; both
//! are those of the body relative to the room.

use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// How far from one the length of a unit quaternion may be: what thousands of roundings do.
const UNIT: f64 = 1e-12;

/// Checks that an attitude is one: four finite numbers, of length one to rounding.
pub(crate) fn check_attitude(world_from_body: &UnitQuaternion<f64>) -> Result<(), InvalidQuantity> {
    for component in world_from_body.coords.iter() {
        InvalidQuantity::require_finite("component of the attitude", *component, "")?;
    }
    let length = world_from_body.coords.norm();
    let is_one = (length - 1.0).abs() <= UNIT;
    let quantity = "length of the quaternion of the attitude";
    InvalidQuantity::require(is_one, quantity, length, "", Rule::EqualTo(1.0))?;
    Ok(())
}

/// The rate of change of a quaternion `world_from_body`, 1/s, of a body with angular velocity `omega_body`, rad/s, along the
/// body's axes: `½ q ω` (`eq:quaternion-rate`).
///
/// The rate is perpendicular to the quaternion, so the exact motion keeps its length; a stepping method does so only within
/// its error.
pub fn quaternion_rate(world_from_body: &Quaternion<f64>, omega_body: &Vector3<f64>) -> Quaternion<f64> {
    world_from_body * Quaternion::from_imag(0.5 * omega_body)
}

/// The angle between two vectors, rad, from 0 to π, in full relative accuracy at both ends: `atan2(|a × b|, a·b)`
/// (`eq:safe-angle`).
///
/// The inverse cosine of the normed scalar product has an error of 1e-8 near 0 and π. Zero if one of them is zero.
///
/// ```
/// use mechanics::attitude::angle_between;
/// use nalgebra::Vector3;
/// let [a, b] = [Vector3::new(0.0, 0.0, 1.0), Vector3::new(1e-12, 0.0, 1.0)];
/// assert_eq!(angle_between(&a, &b), 1e-12);
/// assert_eq!((a.dot(&b) / (a.norm() * b.norm())).acos(), 0.0); // lost
/// ```
pub fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}

/// The angle, rad, from 0 to π, of the shortest rotation from one attitude to another: how far apart they are.
///
/// Relative accuracy near zero; the sign of a quaternion does not matter.
pub fn rotation_between(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    let between = a.inverse() * b;
    2.0 * between.imag().norm().atan2(between.w.abs())
}

/// The rotation about a unit vector through `angle`, in radians, of any number of turns without loss.
pub(crate) fn turn(unit_axis: &Vector3<f64>, angle: TwoPart) -> UnitQuaternion<f64> {
    let (sin, cos) = (angle * 0.5).sin_cos();
    UnitQuaternion::new_unchecked(Quaternion::from_parts(cos, unit_axis * sin))
}

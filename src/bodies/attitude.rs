//! Attitude: how a body stands in the room.
//!
//! An attitude is a rotation `world_from_body`: it takes the components of a vector along the body's axes to its
//! components along the axes of the room. It is kept as a unit quaternion, four numbers that know no singular
//! direction. Its rows and columns never have to be remembered: `v_world = world_from_body * v_body`.
//!
//! Angular velocities and momenta are along the body's axes (`_body`) or the room's (`_world`), as their names say;
//! both are those of the body relative to the room.

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

/// The rate of change of a quaternion `world_from_body`, 1/s, of a body with angular velocity `omega_body`, rad/s,
/// along the body's axes: `½ q ω` (`eq:quaternion-rate`).
///
/// The rate is perpendicular to the quaternion, so the exact motion keeps its length; a stepping method does so only
/// within its error.
///
/// ```
/// use mechanics::attitude::quaternion_rate;
/// use mechanics::nalgebra::{Quaternion, Vector3};
/// // At 3 rad/s the quaternion moves with half of that: after two turns of the body it is back, after one it is −q.
/// let rate = quaternion_rate(&Quaternion::identity(), &Vector3::new(0.0, 0.0, 3.0));
/// assert_eq!(format!("{} 1/s", rate.norm()), "1.5 1/s");
/// ```
#[must_use]
pub fn quaternion_rate(world_from_body: &Quaternion<f64>, omega_body: &Vector3<f64>) -> Quaternion<f64> {
    world_from_body * Quaternion::from_imag(0.5 * omega_body)
}

/// The angle between two vectors of any size, rad, from 0 to π, to 9e-16 of itself however small:
/// `atan2(|a × b|, a·b)` (`eq:safe-angle`), where the differences in the cross product are those of exact products.
/// Near π the same holds of π.
///
/// The inverse cosine of the normed scalar product has an error of 1e-8 near 0 and π. Zero if one of them is zero.
///
/// ```
/// use mechanics::attitude::angle_between;
/// use mechanics::nalgebra::Vector3;
/// let [a, b] = [Vector3::new(0.0, 0.0, 1.0), Vector3::new(1e-12, 0.0, 1.0)];
/// assert_eq!(angle_between(&a, &b), 1e-12);
/// assert_eq!((a.dot(&b) / (a.norm() * b.norm())).acos(), 0.0); // lost
/// ```
pub fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    let [a, b] = [a, b].map(near_one);
    let minor = |i: usize, j: usize| TwoPart::product(a[i], b[j]) - TwoPart::product(a[j], b[i]);
    length([minor(1, 2), minor(2, 0), minor(0, 1)]).atan2(a.dot(&b))
}

/// A vector whose largest component is about one, by a power of two, which changes no digit.
fn near_one(vector: &Vector3<f64>) -> Vector3<f64> {
    let largest = vector.amax();
    if largest > 0.0 { vector / largest.log2().floor().exp2() } else { *vector }
}

/// The length of three rounded components, however small.
fn length(components: [TwoPart; 3]) -> f64 {
    components.map(TwoPart::rounded).into_iter().fold(0.0, f64::hypot)
}

/// The angle, rad, from 0 to π, of the shortest rotation from one attitude to another: how far apart they are.
///
/// To 9e-16 of itself however small; the sign of a quaternion does not matter.
///
/// ```
/// use mechanics::attitude::rotation_between;
/// use mechanics::nalgebra::{UnitQuaternion, Vector3};
/// // A quarter turn about x and one about z are together a third of a turn about a diagonal.
/// let [tip, spin] = [Vector3::x(), Vector3::z()]
///     .map(|axis| UnitQuaternion::from_scaled_axis(axis * std::f64::consts::FRAC_PI_2));
/// let apart = rotation_between(&UnitQuaternion::identity(), &(spin * tip));
/// assert_eq!(format!("{:.1}°", apart.to_degrees()), "120.0°");
/// ```
#[must_use]
pub fn rotation_between(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    // The imaginary part of a⁻¹b, a sum of differences of exact products.
    let minor = |p: f64, q: f64, r: f64, s: f64| TwoPart::product(p, s) - TwoPart::product(q, r);
    let imaginary = [
        minor(a.w, a.i, b.w, b.i) - minor(a.j, a.k, b.j, b.k),
        minor(a.w, a.j, b.w, b.j) - minor(a.k, a.i, b.k, b.i),
        minor(a.w, a.k, b.w, b.k) - minor(a.i, a.j, b.i, b.j),
    ];
    2.0 * length(imaginary).atan2(a.coords.dot(&b.coords).abs())
}

/// The rotation about a unit vector through `angle`, in radians, of any number of turns without loss.
pub(crate) fn turn(unit_axis: &Vector3<f64>, angle: TwoPart) -> UnitQuaternion<f64> {
    let (sin, cos) = (angle * 0.5).sin_cos();
    UnitQuaternion::new_unchecked(Quaternion::from_parts(cos, unit_axis * sin))
}

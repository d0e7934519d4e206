//! What is asked of the numbers of a scene.

use super::vector::{Place, Vec3};
use crate::flaw::Flaw;

/// Axes count as perpendicular up to this cosine: a rotation matrix after long integration still passes.
const PERPENDICULAR: f64 = 1e-6;

/// A finite point or vector.
pub(super) fn finite(what: &'static str, vector: impl Place) -> Result<Vec3, Flaw> {
    let vector = Vec3(vector.into());
    // Beyond this the squares that the geometry needs overflow.
    let sound = vector.0.iter().all(|component| component.abs() < 1e50);
    if sound { Ok(vector) } else { Err(Flaw::new(format!("{what} is infinite or no number"))) }
}

/// A direction, made a unit vector.
pub(super) fn direction(what: &'static str, vector: impl Place) -> Result<Vec3, Flaw> {
    let no_direction = || Flaw::new(format!("{what} has no length, so it has no direction"));
    finite(what, vector)?.unit().ok_or_else(no_direction)
}

/// A positive finite number.
pub(super) fn positive(what: &'static str, value: f64) -> Result<f64, Flaw> {
    finite(what, [value, 0.0, 0.0])?;
    if value > 0.0 { Ok(value) } else { Err(Flaw::new(format!("{what} is {value}, it must be positive"))) }
}

/// Three perpendicular directions, of either handedness.
pub(super) fn perpendicular(axes: [impl Place; 3]) -> Result<[Vec3; 3], Flaw> {
    let [first, second, third] = axes.map(|axis| direction("axis", axis));
    let [first, second, third] = [first?, second?, third?];
    let cosine = [first.dot(second), second.dot(third), third.dot(first)]
        .into_iter()
        .fold(0.0, |most: f64, cosine| most.max(cosine.abs()));
    if cosine > PERPENDICULAR {
        let said = format!("axes are not perpendicular: the cosine of an angle between two is {cosine}");
        return Err(Flaw::new(said));
    }
    Ok([first, second, third])
}

/// Two directions that fix a plane or an axis between them, and do not.
pub(super) fn no_plane() -> Flaw {
    Flaw::new("directions that are parallel or opposite fix no plane")
}

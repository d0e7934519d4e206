//! What can be wrong with a scene.

use super::vector::Vec3;
use crate::label::LabelError;
use std::error::Error;
use std::fmt;

/// A scene that cannot be drawn.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum SpaceError {
    /// A point, direction, length or angle that is infinite or no number.
    NotFinite {
        /// What it belongs to, as in `centre`.
        what: &'static str,
    },
    /// A direction without length.
    NoDirection {
        /// What it belongs to, as in `axis`.
        what: &'static str,
    },
    /// A length or scale that is zero or negative.
    NotPositive {
        /// What it is, as in `radius`.
        what: &'static str,
        /// Its value, in units of the world (a scale: px per unit).
        value: f64,
    },
    /// A ring whose hole is as wide as the ring, or wider.
    HoleTooWide {
        /// The radius of the hole, units of the world.
        inner: f64,
        /// The radius of the ring, units of the world.
        outer: f64,
    },
    /// A cone's half-angle outside the open interval from 0 to π/2.
    HalfAngle {
        /// Its value, rad.
        value: f64,
    },
    /// A camera that looks from beyond a pole.
    Elevation {
        /// Its value, rad.
        value: f64,
    },
    /// Three axes that are not perpendicular to each other.
    NotPerpendicular {
        /// The largest cosine of the angle between two of them.
        cosine: f64,
    },
    /// A curve of fewer than two points, or one whose points all coincide.
    NoCurve,
    /// Two directions that fix no plane: parallel, or opposite.
    NoPlane,
    /// A patch of fewer than three corners.
    NoPatch,
    /// A point that lies behind the eye or too close to it to be seen in perspective.
    BehindTheEye {
        /// The point, in the world.
        point: [f64; 3],
    },
    /// The eye inside a solid.
    EyeInside {
        /// What the solid is, as in `disc`.
        solid: &'static str,
    },
    /// A grid with more lines than can be told apart.
    GridTooFine {
        /// How many lines it would have.
        lines: f64,
    },
    /// A label that cannot be set.
    Label(LabelError),
}

impl fmt::Display for SpaceError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { what } => write!(out, "{what} is infinite or no number"),
            Self::NoDirection { what } => write!(out, "{what} has no length, so it has no direction"),
            Self::NotPositive { what, value } => write!(out, "{what} is {value}, it must be positive"),
            Self::HoleTooWide { inner, outer } => {
                write!(out, "the hole's radius {inner} is not less than the ring's, {outer}")
            }
            Self::HalfAngle { value } => {
                write!(out, "the cone's half-angle {value} rad is not between 0 and π/2")
            }
            Self::Elevation { value } => {
                write!(out, "the camera's elevation {value} rad is not between −π/2 and π/2")
            }
            Self::NotPerpendicular { cosine } => {
                write!(out, "axes are not perpendicular: the cosine of an angle between two is {cosine}")
            }
            Self::NoCurve => write!(out, "a curve needs two points that differ"),
            Self::NoPlane => write!(out, "directions that are parallel or opposite fix no plane"),
            Self::NoPatch => write!(out, "a patch needs at least three corners"),
            Self::BehindTheEye { point: [x, y, z] } => {
                write!(out, "the point ({x}, {y}, {z}) lies behind the eye or too close to it")
            }
            Self::EyeInside { solid } => write!(out, "the eye is inside the {solid}"),
            Self::GridTooFine { lines } => {
                write!(out, "a grid of {lines} lines; at most {MOST_LINES} can be told apart")
            }
            Self::Label(error) => error.fmt(out),
        }
    }
}

impl Error for SpaceError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Label(error) => Some(error),
            _ => None,
        }
    }
}

impl From<LabelError> for SpaceError {
    fn from(error: LabelError) -> Self {
        Self::Label(error)
    }
}

/// The most lines of a grid, both ways together.
pub(super) const MOST_LINES: f64 = 400.0;

/// Axes count as perpendicular up to this cosine: a rotation matrix after long integration still passes.
const PERPENDICULAR: f64 = 1e-6;

/// A finite point or vector.
pub(super) fn finite(what: &'static str, vector: impl Into<[f64; 3]>) -> Result<Vec3, SpaceError> {
    let vector = Vec3(vector.into());
    // Beyond this the squares that the geometry needs overflow.
    let sound = vector.is_finite() && vector.0.iter().all(|component| component.abs() < 1e50);
    if sound { Ok(vector) } else { Err(SpaceError::NotFinite { what }) }
}

/// A direction, made a unit vector.
pub(super) fn direction(what: &'static str, vector: impl Into<[f64; 3]>) -> Result<Vec3, SpaceError> {
    finite(what, vector)?.unit().ok_or(SpaceError::NoDirection { what })
}

/// A positive finite number.
pub(super) fn positive(what: &'static str, value: f64) -> Result<f64, SpaceError> {
    if !(value.is_finite() && value.abs() < 1e50) {
        return Err(SpaceError::NotFinite { what });
    }
    if value > 0.0 { Ok(value) } else { Err(SpaceError::NotPositive { what, value }) }
}

/// Three perpendicular directions, of either handedness.
pub(super) fn perpendicular(axes: [impl Into<[f64; 3]>; 3]) -> Result<[Vec3; 3], SpaceError> {
    let [first, second, third] = axes.map(|axis| direction("axis", axis));
    let [first, second, third] = [first?, second?, third?];
    let cosine = [first.dot(second), second.dot(third), third.dot(first)]
        .into_iter()
        .fold(0.0, |most: f64, cosine| most.max(cosine.abs()));
    if cosine > PERPENDICULAR {
        return Err(SpaceError::NotPerpendicular { cosine });
    }
    Ok([first, second, third])
}

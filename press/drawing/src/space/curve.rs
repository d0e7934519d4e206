//! Curves and straight lines that are drawn by themselves.

use super::checks::{direction, finite, no_plane, positive};
use super::track::{CHORDS, Track};
use super::vector::{Place, Vec3};
use crate::flaw::Flaw;

/// How much of a curve is drawn where a solid hides it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Hiding {
    /// All of it, dashed and pale.
    #[default]
    Dashed,
    /// All of it, thin and pale: for a path of many turns, whose dashes would be a scribble.
    Pale,
    /// Nothing.
    Omitted,
    /// All of it, as if no solid were there: for what begins inside a body but is to be read in front of it.
    Ignored,
}

/// A line in space. Units are those of the world, angles in rad.
///
/// Its points may lie on a solid's surface: what is not more than 0.3 % of the solid's least thickness behind
/// the surface counts as lying on it.
///
/// ```
/// use drawing::{Flaw, space::Curve};
/// // A quarter of a circle of radius 2 about z, from x to y.
/// Curve::between([0.0; 3], [1.0, 0.0, 0.0], [0.0, 3.0, 0.0], 2.0)?;
/// assert_eq!(Curve::segment([1.0; 3], [1.0; 3]), Err(Flaw::new("a curve needs two points that differ")));
/// # Ok::<(), Flaw>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub(super) track: Track,
    pub(super) hiding: Hiding,
}

impl Curve {
    pub(super) fn new(track: Track) -> Self {
        Self { track, hiding: Hiding::default() }
    }

    fn joined(points: impl IntoIterator<Item = impl Place>, smooth: bool) -> Result<Self, Flaw> {
        let mut kept: Vec<Vec3> = Vec::new();
        for point in points {
            let point = finite("point of the curve", point)?;
            if kept.last() != Some(&point) {
                kept.push(point);
            }
        }
        if kept.len() < 2 {
            return Err(Flaw::new("a curve needs two points that differ"));
        }
        Ok(Self::new(Track { points: kept, smooth }))
    }

    /// A straight line.
    pub fn segment(from: impl Place, to: impl Place) -> Result<Self, Flaw> {
        Self::joined([from.into(), to.into()], false)
    }

    /// A smooth curve through points that lie close enough for a cubic between neighbours: some hundred for a
    /// turn. It is closed if the last point is the first. Such a curve may lie on the surface of a solid.
    pub fn smooth(points: impl IntoIterator<Item = impl Place>) -> Result<Self, Flaw> {
        Self::joined(points, true)
    }

    /// A circle about an axis.
    pub fn circle(centre: impl Place, axis: impl Place, radius: f64) -> Result<Self, Flaw> {
        let (centre, axis) = (finite("centre", centre)?, direction("axis", axis)?);
        let (first, second) = axis.companions();
        let radius = positive("radius", radius)?;
        Ok(Self::new(Track::circle(centre, [first * radius, second * radius], CHORDS)))
    }

    /// The arc of an angle at `vertex`, from one direction to another, by the shorter way.
    ///
    /// # Errors
    /// [`Flaw`] also for directions that are parallel or opposite.
    pub fn between(vertex: impl Place, from: impl Place, to: impl Place, radius: f64) -> Result<Self, Flaw> {
        let vertex = finite("vertex", vertex)?;
        let (from, to) = (direction("side of the angle", from)?, direction("side of the angle", to)?);
        let normal = from.cross(to);
        let axis = normal.unit().filter(|_| normal.length() > 1e-9).ok_or_else(no_plane)?;
        let sweep = normal.length().atan2(from.dot(to));
        let radius = positive("radius", radius)?;
        Ok(Self::new(Track::arc(vertex, axis, from * radius, sweep)))
    }

    /// The curve drawn otherwise where a solid hides it.
    #[must_use]
    pub fn hiding(self, hiding: Hiding) -> Self {
        Self { hiding, ..self }
    }
}

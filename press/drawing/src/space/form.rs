//! What every solid can say of itself to those who draw it.

use super::camera::Camera;
use super::ray::{Ray, Spans};
use super::track::Track;
use super::vector::Vec3;
use crate::role::Fill;
use crate::shape::Shape;
use std::f64::consts::TAU;

/// The geometry of a solid.
pub(super) trait Form {
    /// What it is, for messages.
    fn name(&self) -> &'static str;

    /// Its least thickness, units of the world: the measure of what counts as lying on its surface.
    fn thinnest(&self) -> f64;

    /// Points whose convex hull holds it.
    fn corners(&self) -> Vec<Vec3>;

    /// Whether it, or the room that it encloses, holds a point.
    fn contains(&self, point: Vec3) -> bool;

    /// Where a ray is inside, in order.
    fn spans(&self, ray: &Ray) -> Spans;

    /// The values, at a point, of polynomials of at most second degree in the point, whose zeros hold all
    /// boundaries between what the solid hides and what it does not: its surfaces and the cones that the eye
    /// spans with its outline.
    fn boundaries(&self, camera: &Camera, point: Vec3, values: &mut Vec<f64>);

    /// Its edges and its outline.
    fn edges(&self, camera: &Camera) -> Vec<Edge>;

    /// The parts that are painted apart.
    fn parts(&self) -> Vec<Part> {
        vec![Part::Whole]
    }

    /// Smaller parts, for a solid that is behind another in one place and in front of it in another.
    fn sectors(&self) -> Vec<Part> {
        Vec::new()
    }

    /// Where a ray enters a part, if it does.
    fn enters(&self, ray: &Ray, part: &Part) -> Option<f64>;

    /// What is seen of a part, in the order in which it is painted.
    fn patches(&self, camera: &Camera, part: &Part) -> Vec<Patch>;
}

/// A line of a solid.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Edge {
    pub(super) track: Track,
    /// Whether it is part of the outline, which the solid itself cannot hide.
    pub(super) outline: bool,
}

/// A filled area on the page.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Patch {
    pub(super) fill: Fill,
    pub(super) shape: Shape,
}

/// A part of a solid.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Part {
    /// All of it.
    Whole,
    /// What of a rod lies above one line about it and below another.
    Between(Option<Belt>, Option<Belt>),
    /// From an angle about the axis, over an angle, rad.
    Sector(f64, f64),
    /// The part of a shell that is seen from outside.
    Outside,
    /// The part of a shell that is seen from inside.
    Inside,
}

/// A line that runs once about a rod: its height along the axis at equal steps of the angle about it, from 0 to a turn.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Belt(pub(super) Vec<f64>);

impl Belt {
    /// The height at an angle, rad.
    pub(super) fn at(&self, angle: f64) -> f64 {
        let count = self.0.len();
        let place = (angle / TAU).rem_euclid(1.0) * count as f64;
        let (first, part) = (place as usize % count, place.fract());
        self.0[first] * (1.0 - part) + self.0[(first + 1) % count] * part
    }
}

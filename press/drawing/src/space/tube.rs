//! Discs, rods and rings: cylinders, with or without a hole along the axis.

use super::camera::Camera;
use super::form::{Edge, Form, Part, Patch};
use super::ray::{Ray, Spans, below_zero, slab};
use super::rim::{Round, common_arcs};
use super::track::{Track, turns};
use super::vector::Vec3;
use crate::role::Fill;
use crate::shape::Shape;
use std::f64::consts::TAU;

/// Into how many sectors a ring is divided where it is threaded.
const SECTORS: u32 = 24;

/// A cylinder about an axis, from −half to half along it, with a hole of radius `inner` (0: none).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tube {
    pub(super) name: &'static str,
    /// The axis, and the middle of the cylinder as its origin.
    pub(super) round: Round,
    pub(super) outer: f64,
    pub(super) inner: f64,
    pub(super) half: f64,
}

impl Tube {
    /// Whether the end at this height shows its face.
    fn shows(&self, camera: &Camera, height: f64) -> bool {
        let sight = camera.sight(self.round.centre(height));
        self.round.axis.dot(sight) * height.signum() > 0.0
    }

    /// The direction to the eye about the axis, and half the angle over which a wall of this radius, seen
    /// from outside, shows.
    fn turned_to_eye(&self, camera: &Camera, radius: f64) -> (f64, f64) {
        let sight = camera.sight(self.round.origin).across(self.round.axis);
        let cosine = camera.nearness * radius / sight.length();
        let half = if cosine < 1.0 { cosine.acos() } else { 0.0 };
        (self.round.angle_of(sight), half)
    }

    /// The walls that show: radius, where they begin, and over which angle, rad.
    fn walls(&self, camera: &Camera) -> Vec<(f64, f64, f64)> {
        let (middle, half) = self.turned_to_eye(camera, self.outer);
        let mut walls = Vec::new();
        if self.inner > 0.0 {
            let (middle, half) = self.turned_to_eye(camera, self.inner);
            walls.push((self.inner, middle + half, TAU - 2.0 * half));
        }
        if half > 0.0 {
            walls.push((self.outer, middle - half, 2.0 * half));
        }
        walls
    }

    /// The radius, and that of the hole if there is one.
    fn radii(&self) -> impl Iterator<Item = f64> {
        [self.outer, self.inner].into_iter().filter(|&radius| radius > 0.0)
    }

    /// The heights between which the wall at an angle belongs to a part.
    fn heights(&self, part: &Part, angle: f64) -> (f64, f64) {
        match part {
            Part::Between(low, high) => (
                low.as_ref().map_or(-self.half, |belt| belt.at(angle)),
                high.as_ref().map_or(self.half, |belt| belt.at(angle)),
            ),
            _ => (-self.half, self.half),
        }
    }

    /// A wall from an angle over an angle.
    fn wall(&self, camera: &Camera, part: &Part, radius: f64, (from, sweep): (f64, f64)) -> Patch {
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        let count = self.round.steps(camera, radius, sweep);
        for (index, turn) in (0..).zip(turns(from, sweep, count)) {
            let (low, high) = self.heights(part, from + sweep * f64::from(index) / f64::from(count));
            lower.push(camera.land(self.round.turned(turn, radius, low)));
            upper.push(camera.land(self.round.turned(turn, radius, high)));
        }
        lower.extend(upper.into_iter().rev());
        Patch { fill: Fill::Side, shape: Shape::Polygon(lower) }
    }

    /// The face at a height: all of it, or a sector.
    fn face(&self, camera: &Camera, height: f64, sector: Option<(f64, f64)>) -> Patch {
        let shape = match sector {
            None if self.inner == 0.0 => self.round.ellipse(camera, self.outer, height),
            // Out along one rim and back along the other, so that the hole stays empty.
            _ => {
                let (from, sweep) = sector.unwrap_or((0.0, TAU));
                let out = self.round.arc(camera, self.outer, height, (from, sweep));
                let back = self.round.arc(camera, self.inner, height, (from + sweep, -sweep));
                Shape::Polygon([out, back].concat())
            }
        };
        Patch { fill: Fill::Face, shape }
    }
}

impl Form for Tube {
    fn name(&self) -> &'static str {
        self.name
    }

    fn thinnest(&self) -> f64 {
        (self.outer - self.inner).min(2.0 * self.half)
    }

    fn corners(&self) -> Vec<Vec3> {
        self.round.corners(self.outer, 0.0, self.half)
    }

    fn contains(&self, point: Vec3) -> bool {
        let (step, axis) = (point - self.round.origin, self.round.axis);
        let (height, radius) = (step.dot(axis).abs(), step.across(axis).length());
        height < self.half && radius < self.outer && radius > self.inner
    }

    fn spans(&self, ray: &Ray) -> Spans {
        let (step, direction, axis) = (ray.origin - self.round.origin, ray.direction, self.round.axis);
        let (level, slope) = (step.across(axis), direction.across(axis));
        let within =
            |radius: f64| below_zero(slope.square(), level.dot(slope), level.square() - radius * radius);
        let ends = slab(step.dot(axis), direction.dot(axis), self.half);
        let Some(span) = ends.and_then(|ends| ends.common(within(self.outer)?)) else { return Spans::new() };
        if self.inner > 0.0 { span.without(within(self.inner)) } else { Spans::from_iter([span]) }
    }

    fn boundaries(&self, camera: &Camera, point: Vec3, values: &mut Vec<f64>) {
        let (step, axis) = (point - self.round.origin, self.round.axis);
        let (height, level) = (step.dot(axis), step.across(axis));
        let sight = camera.sight(self.round.origin);
        let turned = step.cross(sight).dot(axis);
        let slope = (sight - step * camera.nearness).across(axis).square();
        values.extend([height - self.half, height + self.half]);
        for radius in self.radii() {
            let square = radius * radius;
            values.extend([level.square() - square, turned * turned - square * slope]);
            values.extend([-self.half, self.half].map(|end| self.round.shadow(camera, radius, end, point)));
        }
    }

    fn edges(&self, camera: &Camera) -> Vec<Edge> {
        let mut edges = Vec::new();
        for radius in self.radii() {
            for end in [self.half, -self.half] {
                edges.push(Edge { track: self.round.circle(camera, radius, end), outline: false });
            }
        }
        let (middle, half) = self.turned_to_eye(camera, self.outer);
        if half > 0.0 {
            for angle in [middle - half, middle + half] {
                let [low, high] = [-self.half, self.half].map(|end| self.round.point(angle, self.outer, end));
                edges.push(Edge { track: Track::segment(low, high), outline: true });
            }
        }
        edges
    }

    fn sectors(&self) -> Vec<Part> {
        if self.inner == 0.0 {
            return Vec::new();
        }
        let sweep = TAU / f64::from(SECTORS);
        (0..SECTORS).map(|index| Part::Sector(sweep * f64::from(index), sweep)).collect()
    }

    fn enters(&self, ray: &Ray, part: &Part) -> Option<f64> {
        self.spans(ray).into_iter().map(|span| span.enter).find(|&enter| {
            let step = ray.at(enter) - self.round.origin;
            match part {
                Part::Between(..) => {
                    let (low, high) = self.heights(part, self.round.angle_of(step));
                    (low..=high).contains(&step.dot(self.round.axis))
                }
                Part::Sector(from, sweep) => (self.round.angle_of(step) - from).rem_euclid(TAU) <= *sweep,
                _ => true,
            }
        })
    }

    fn patches(&self, camera: &Camera, part: &Part) -> Vec<Patch> {
        let sector = if let Part::Sector(from, sweep) = part { Some((*from, *sweep)) } else { None };
        let mut patches = Vec::new();
        for (radius, from, sweep) in self.walls(camera) {
            for arc in common_arcs((from, sweep), sector) {
                patches.push(self.wall(camera, part, radius, arc));
            }
        }
        for end in [-self.half, self.half] {
            let kept = match part {
                Part::Between(low, high) => (if end < 0.0 { low } else { high }).is_none(),
                _ => true,
            };
            if kept && self.shows(camera, end) {
                patches.push(self.face(camera, end, sector));
            }
        }
        patches
    }
}

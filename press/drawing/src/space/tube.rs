//! Discs, rods and rings: cylinders, with or without a hole along the axis.

use super::camera::Camera;
use super::form::{Edge, Form, Part, Patch};
use super::ray::{Ray, Spans, below_zero, slab};
use super::rim::{self, common_arcs, steps};
use super::track::Track;
use super::vector::Vec3;
use crate::point::Point;
use crate::role::Fill;
use crate::shape::Shape;
use crate::simplify::{TOLERANCE, simplify};
use std::f64::consts::TAU;

/// Into how many sectors a ring is divided where it is threaded.
const SECTORS: u32 = 24;

/// A cylinder about an axis, from −half to half along it, with a hole of radius `inner` (0: none).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tube {
    pub(super) name: &'static str,
    pub(super) centre: Vec3,
    pub(super) axis: Vec3,
    /// Two unit vectors that complete the axis to a right-handed triad; angles are counted from the first.
    pub(super) across: (Vec3, Vec3),
    pub(super) outer: f64,
    pub(super) inner: f64,
    pub(super) half: f64,
}

impl Tube {
    pub(super) fn new(
        name: &'static str,
        centre: Vec3,
        axis: Vec3,
        [outer, inner]: [f64; 2],
        half: f64,
    ) -> Self {
        Self { name, centre, axis, across: axis.companions(), outer, inner, half }
    }

    /// The radial unit vector at an angle.
    fn radial(&self, angle: f64) -> Vec3 {
        let (sin, cos) = angle.sin_cos();
        self.across.0 * cos + self.across.1 * sin
    }

    /// The point at an angle, on a radius, at a height along the axis.
    pub(super) fn point(&self, angle: f64, radius: f64, height: f64) -> Vec3 {
        self.centre + self.radial(angle) * radius + self.axis * height
    }

    fn angle_of(&self, point: Vec3) -> f64 {
        let step = point - self.centre;
        step.dot(self.across.1).atan2(step.dot(self.across.0))
    }

    /// Whether the end at this height shows its face.
    fn shows(&self, camera: &Camera, height: f64) -> bool {
        let sight = camera.sight(self.centre + self.axis * height);
        self.axis.dot(sight) * height.signum() > 0.0
    }

    /// The direction to the eye about the axis, and half the angle over which a wall of this radius, seen
    /// from outside, shows.
    fn turned_to_eye(&self, camera: &Camera, radius: f64) -> (f64, f64) {
        let sight = camera.sight(self.centre).across(self.axis);
        let cosine = camera.nearness() * radius / sight.length();
        let half = if cosine < 1.0 { cosine.acos() } else { 0.0 };
        (self.angle_of(self.centre + sight), half)
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
    fn wall(&self, camera: &Camera, part: &Part, (radius, from, sweep): (f64, f64, f64)) -> Patch {
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        for angle in steps(from, sweep) {
            let (low, high) = self.heights(part, angle);
            lower.push(camera.land(self.point(angle, radius, low)));
            upper.push(camera.land(self.point(angle, radius, high)));
        }
        upper.reverse();
        let outline = [simplify(&lower, TOLERANCE), simplify(&upper, TOLERANCE)].concat();
        Patch { fill: Fill::Side, shape: Shape::Polygon(outline) }
    }

    /// The face at a height: all of it, or a sector.
    fn face(&self, camera: &Camera, height: f64, sector: Option<(f64, f64)>) -> Patch {
        let rim = |radius: f64, from: f64, sweep: f64| -> Vec<Point> {
            let points: Vec<Point> = steps(from, sweep)
                .into_iter()
                .map(|angle| camera.land(self.point(angle, radius, height)))
                .collect();
            simplify(&points, TOLERANCE)
        };
        let shape = match sector {
            None if self.inner == 0.0 => {
                let (first, second) = (self.across.0 * self.outer, self.across.1 * self.outer);
                rim::ellipse(camera, self.centre + self.axis * height, first, second)
            }
            // Out along one rim and back along the other, so that the hole stays empty.
            _ => {
                let (from, sweep) = sector.unwrap_or((0.0, TAU));
                Shape::Polygon([rim(self.outer, from, sweep), rim(self.inner, from + sweep, -sweep)].concat())
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
        let (x, y, z) = (self.across.0 * self.outer, self.across.1 * self.outer, self.axis * self.half);
        rim::box_corners(self.centre, [x, y, z])
    }

    fn contains(&self, point: Vec3) -> bool {
        let step = point - self.centre;
        let (height, radius) = (step.dot(self.axis).abs(), step.across(self.axis).length());
        height < self.half && radius < self.outer && radius > self.inner
    }

    fn spans(&self, ray: &Ray) -> Spans {
        let (step, direction) = (ray.origin - self.centre, ray.direction);
        let (level, slope) = (step.across(self.axis), direction.across(self.axis));
        let within =
            |radius: f64| below_zero(slope.square(), level.dot(slope), level.square() - radius * radius);
        let ends = slab(step.dot(self.axis), direction.dot(self.axis), self.half);
        let Some(span) = ends.and_then(|ends| ends.common(within(self.outer)?)) else { return Spans::new() };
        if self.inner > 0.0 { span.without(within(self.inner)) } else { Spans::from_iter([span]) }
    }

    fn boundaries(&self, camera: &Camera, point: Vec3, values: &mut Vec<f64>) {
        let step = point - self.centre;
        let (height, level) = (step.dot(self.axis), step.across(self.axis));
        let sight = camera.sight(self.centre);
        let turned = step.cross(sight).dot(self.axis);
        let slope = (sight - step * camera.nearness()).across(self.axis).square();
        values.extend([height - self.half, height + self.half]);
        for radius in [self.outer, self.inner].into_iter().filter(|&radius| radius > 0.0) {
            let square = radius * radius;
            values.extend([level.square() - square, turned * turned - square * slope]);
            for end in [-self.half, self.half] {
                values.push(rim::shadow(camera, self.centre + self.axis * end, self.axis, radius, point));
            }
        }
    }

    fn edges(&self, camera: &Camera) -> Vec<Edge> {
        let mut edges = Vec::new();
        for radius in [self.outer, self.inner].into_iter().filter(|&radius| radius > 0.0) {
            let radii = [self.across.0 * radius, self.across.1 * radius];
            for end in [self.half, -self.half] {
                let centre = self.centre + self.axis * end;
                let track = Track::circle(centre, radii, camera.chords(centre, radius));
                edges.push(Edge { track, outline: false });
            }
        }
        let (middle, half) = self.turned_to_eye(camera, self.outer);
        if half > 0.0 {
            for angle in [middle - half, middle + half] {
                let [low, high] = [-self.half, self.half].map(|end| self.point(angle, self.outer, end));
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
        let spans = self.spans(ray);
        match part {
            Part::Between(..) => spans.into_iter().map(|span| span.enter).find(|&enter| {
                let point = ray.at(enter);
                let (low, high) = self.heights(part, self.angle_of(point));
                (low..=high).contains(&(point - self.centre).dot(self.axis))
            }),
            Part::Sector(from, sweep) => spans
                .into_iter()
                .map(|span| span.enter)
                .find(|&enter| (self.angle_of(ray.at(enter)) - from).rem_euclid(TAU) <= *sweep),
            _ => spans.first().map(|span| span.enter),
        }
    }

    fn patches(&self, camera: &Camera, part: &Part) -> Vec<Patch> {
        let sector = if let Part::Sector(from, sweep) = part { Some((*from, *sweep)) } else { None };
        let mut patches = Vec::new();
        for (radius, from, sweep) in self.walls(camera) {
            for (from, sweep) in common_arcs((from, sweep), sector) {
                patches.push(self.wall(camera, part, (radius, from, sweep)));
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

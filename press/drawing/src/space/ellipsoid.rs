//! Ellipsoids and spheres.

use super::camera::Camera;
use super::form::{Edge, Form, Part, Patch};
use super::ray::{Ray, Spans, below_zero};
use super::rim;
use super::track::Track;
use super::vector::Vec3;
use crate::role::Fill;
use crate::shape::Shape;

/// Where the light comes from: to the right on the page, up, and towards the eye.
const LIGHT: [f64; 3] = [-0.42, 0.55, 0.72];

/// An ellipsoid with three perpendicular semi-axes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ellipsoid {
    pub(super) name: &'static str,
    pub(super) centre: Vec3,
    /// Unit vectors.
    pub(super) axes: [Vec3; 3],
    /// The semi-axes along them.
    pub(super) radii: [f64; 3],
}

impl Ellipsoid {
    /// A vector in coordinates in which the ellipsoid is the unit sphere.
    fn shrunk(&self, vector: Vec3) -> Vec3 {
        Vec3([0, 1, 2].map(|index| self.axes[index].dot(vector) / self.radii[index]))
    }

    /// Back from those coordinates to a vector of the world.
    fn grown(&self, vector: Vec3) -> Vec3 {
        (0..3).fold(Vec3::ZERO, |sum, index| sum + self.axes[index] * (self.radii[index] * vector.0[index]))
    }

    /// The cap of the unit sphere that the eye sees: the unit vector to its middle, and how far its plane is
    /// from the centre.
    fn seen_cap(&self, camera: &Camera) -> (Vec3, f64) {
        let sight = self.shrunk(camera.sight(self.centre));
        let length = sight.length();
        (sight * (1.0 / length), camera.nearness / length)
    }

    /// The circle in which a plane cuts the unit sphere, in the world: its centre and two radii.
    fn circle(&self, (normal, offset): (Vec3, f64)) -> (Vec3, [Vec3; 2]) {
        let radius = (1.0 - offset * offset).max(0.0).sqrt();
        let (first, second) = normal.companions();
        let centre = self.centre + self.grown(normal * offset);
        (centre, [self.grown(first * radius), self.grown(second * radius)])
    }

    /// The point of the unit sphere where the light falls steepest, drawn towards the eye until it is well in sight.
    fn pole(&self, camera: &Camera, (middle, offset): (Vec3, f64)) -> Vec3 {
        let [right, up, back] = LIGHT;
        let light = camera.right * right + camera.up * up + camera.back * back;
        let pole = Vec3([0, 1, 2].map(|index| self.radii[index] * self.axes[index].dot(light)));
        let mut pole = pole.unit().unwrap_or(middle);
        while pole.dot(middle) < offset + 0.3 * (1.0 - offset) {
            pole = (pole + middle * 0.5).unit().unwrap_or(middle);
        }
        pole
    }
}

impl Form for Ellipsoid {
    fn name(&self) -> &'static str {
        self.name
    }

    fn thinnest(&self) -> f64 {
        self.radii.into_iter().fold(f64::INFINITY, f64::min)
    }

    fn corners(&self) -> Vec<Vec3> {
        rim::box_corners(self.centre, [0, 1, 2].map(|index| self.axes[index] * self.radii[index]))
    }

    fn contains(&self, point: Vec3) -> bool {
        self.shrunk(point - self.centre).square() < 1.0
    }

    fn spans(&self, ray: &Ray) -> Spans {
        let (step, slope) = (self.shrunk(ray.origin - self.centre), self.shrunk(ray.direction));
        below_zero(slope.square(), step.dot(slope), step.square() - 1.0).into_iter().collect()
    }

    fn boundaries(&self, camera: &Camera, point: Vec3, values: &mut Vec<f64>) {
        let (step, sight) = (self.shrunk(point - self.centre), self.shrunk(camera.sight(self.centre)));
        let slope = sight - step * camera.nearness;
        values.extend([step.square() - 1.0, step.cross(sight).square() - slope.square()]);
    }

    fn edges(&self, camera: &Camera) -> Vec<Edge> {
        let (centre, radii) = self.circle(self.seen_cap(camera));
        let chords = camera.chords(centre, radii[0].length().max(radii[1].length()));
        vec![Edge { track: Track::circle(centre, radii, chords), outline: true }]
    }

    fn enters(&self, ray: &Ray, _: &Part) -> Option<f64> {
        self.spans(ray).first().map(|span| span.enter)
    }

    fn patches(&self, camera: &Camera, _: &Part) -> Vec<Patch> {
        let cap = self.seen_cap(camera);
        let (centre, radii) = self.circle(cap);
        let light = camera.land(self.centre + self.grown(self.pole(camera, cap)));
        let shape = match rim::ellipse(camera, centre, radii) {
            Shape::Ellipse { centre, radii, turn } => Shape::Rounded { centre, radii, turn, light },
            other => other,
        };
        vec![Patch { fill: Fill::Round, shape }]
    }
}

//! Cuboids.

use super::camera::Camera;
use super::form::{Edge, Form, Part, Patch};
use super::ray::{Ray, Span, slab};
use super::rim;
use super::track::Track;
use super::vector::Vec3;
use crate::drawing::Shape;
use crate::role::Fill;

/// A cuboid with its half-edges along three perpendicular axes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cuboid {
    pub(super) centre: Vec3,
    /// Unit vectors.
    pub(super) axes: [Vec3; 3],
    pub(super) halves: [f64; 3],
}

impl Cuboid {
    /// The half-edge along an axis, as a vector.
    fn half(&self, index: usize) -> Vec3 {
        self.axes[index] * self.halves[index]
    }

    /// The twelve edges: the middle, and the half-edge along it.
    fn bars(&self) -> Vec<(Vec3, Vec3)> {
        let mut bars = Vec::new();
        for index in 0..3 {
            let (along, second, third) =
                (self.half(index), self.half((index + 1) % 3), self.half((index + 2) % 3));
            for (i, j) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                bars.push((self.centre + second * i + third * j, along));
            }
        }
        bars
    }
}

impl Form for Cuboid {
    fn name(&self) -> &'static str {
        "cuboid"
    }

    fn thinnest(&self) -> f64 {
        self.halves.into_iter().fold(f64::INFINITY, f64::min)
    }

    fn corners(&self) -> Vec<Vec3> {
        rim::box_corners(self.centre, [self.half(0), self.half(1), self.half(2)])
    }

    fn contains(&self, point: Vec3) -> bool {
        let step = point - self.centre;
        (0..3).all(|index| self.axes[index].dot(step).abs() < self.halves[index])
    }

    fn spans(&self, ray: &Ray) -> Vec<Span> {
        let step = ray.origin - self.centre;
        let mut span = Some(Span::ALL);
        for index in 0..3 {
            let axis = self.axes[index];
            let between = slab(axis.dot(step), axis.dot(ray.direction), self.halves[index]);
            span = span.and_then(|span| span.common(between?));
        }
        span.into_iter().collect()
    }

    fn boundaries(&self, camera: &Camera, point: Vec3, values: &mut Vec<f64>) {
        let step = point - self.centre;
        for index in 0..3 {
            let height = self.axes[index].dot(step);
            values.extend([height - self.halves[index], height + self.halves[index]]);
        }
        for (middle, along) in self.bars() {
            values.push((point - middle).dot(along.cross(camera.sight(middle))));
        }
    }

    fn edges(&self, _: &Camera) -> Vec<Edge> {
        let bar = |(middle, along): (Vec3, Vec3)| Track::segment(middle - along, middle + along);
        self.bars().into_iter().map(|ends| Edge { track: bar(ends), outline: false }).collect()
    }

    fn enters(&self, ray: &Ray, _: &Part) -> Option<f64> {
        self.spans(ray).first().map(|span| span.enter)
    }

    fn patches(&self, camera: &Camera, _: &Part) -> Vec<Patch> {
        let mut patches = Vec::new();
        for index in 0..3 {
            let (second, third) = (self.half((index + 1) % 3), self.half((index + 2) % 3));
            for sign in [-1.0, 1.0] {
                let (normal, middle) = (self.axes[index] * sign, self.centre + self.half(index) * sign);
                if normal.dot(camera.sight(middle)) <= 0.0 {
                    continue;
                }
                let corner = |(i, j)| camera.land(middle + second * i + third * j);
                let outline = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(corner);
                // What looks up is lit.
                let fill = if normal.dot(Vec3(camera.up())) > 0.6 { Fill::Face } else { Fill::Side };
                patches.push(Patch { fill, shape: Shape::Polygon(outline.into()) });
            }
        }
        patches
    }
}

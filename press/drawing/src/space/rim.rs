//! What several solids share: circles about an axis and their images, arcs of rims, and boxes.

use super::camera::Camera;
use super::track::{Track, turns};
use super::vector::Vec3;
use crate::point::{Point, at};
use crate::shape::Shape;
use std::f64::consts::{PI, TAU};

/// An axis and the circles about it. Heights are counted along the axis from its origin, angles from the first of two
/// directions across it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Round {
    pub(super) origin: Vec3,
    pub(super) axis: Vec3,
    /// Two unit vectors that complete the axis to a right-handed triad.
    across: (Vec3, Vec3),
}

impl Round {
    pub(super) fn new(origin: Vec3, axis: Vec3) -> Self {
        Self { origin, axis, across: axis.companions() }
    }

    /// The point on the axis at a height.
    pub(super) fn centre(&self, height: f64) -> Vec3 {
        self.origin + self.axis * height
    }

    /// The point at an angle, on a radius, at a height.
    pub(super) fn point(&self, angle: f64, radius: f64, height: f64) -> Vec3 {
        self.turned(angle.sin_cos(), radius, height)
    }

    /// The point at an angle of which sine and cosine are known.
    pub(super) fn turned(&self, (sin, cos): (f64, f64), radius: f64, height: f64) -> Vec3 {
        self.centre(height) + (self.across.0 * cos + self.across.1 * sin) * radius
    }

    /// The angle of a step from the axis.
    pub(super) fn angle_of(&self, step: Vec3) -> f64 {
        step.dot(self.across.1).atan2(step.dot(self.across.0))
    }

    /// The corners of a box that holds two circles of a radius, so far above and below a height.
    pub(super) fn corners(&self, radius: f64, height: f64, half: f64) -> Vec<Vec3> {
        let [first, second] = self.radii(radius);
        box_corners(self.centre(height), [first, second, self.axis * half])
    }

    /// A circle.
    pub(super) fn circle(&self, camera: &Camera, radius: f64, height: f64) -> Track {
        let centre = self.centre(height);
        Track::circle(centre, self.radii(radius), camera.chords(centre, radius))
    }

    /// A circle on the page.
    pub(super) fn ellipse(&self, camera: &Camera, radius: f64, height: f64) -> Shape {
        ellipse(camera, self.centre(height), self.radii(radius))
    }

    /// An arc on the page, from an angle over an angle.
    pub(super) fn arc(&self, camera: &Camera, radius: f64, height: f64, arc: (f64, f64)) -> Vec<Point> {
        let count = self.steps(camera, radius, arc.1);
        turns(arc.0, arc.1, count).map(|turn| camera.land(self.turned(turn, radius, height))).collect()
    }

    /// In how many steps an arc is drawn, as close as the chords of its circle.
    pub(super) fn steps(&self, camera: &Camera, radius: f64, sweep: f64) -> u32 {
        let chords = camera.chords(self.origin, radius);
        (f64::from(chords) * sweep.abs() / TAU).ceil().max(1.0) as u32
    }

    /// A polynomial in the point whose zeros are the cone that the eye spans with a circle (a cylinder for an eye
    /// at infinity).
    ///
    /// A point at the step d from the circle's centre, moved along its line of sight into the circle's plane,
    /// lands at the step (d·a − g·h)/(a − k·h), with g the sight at the centre, a its part along the axis, h the
    /// height of the point and k the nearness of the eye.
    pub(super) fn shadow(&self, camera: &Camera, radius: f64, height: f64, point: Vec3) -> f64 {
        let centre = self.centre(height);
        let (step, sight) = (point - centre, camera.sight(centre));
        let (height, rise) = (step.dot(self.axis), sight.dot(self.axis));
        let landed = step * rise - sight * height;
        landed.square() - (radius * (rise - camera.nearness * height)).powi(2)
    }

    fn radii(&self, radius: f64) -> [Vec3; 2] {
        [self.across.0 * radius, self.across.1 * radius]
    }
}

/// The corners of a box with these half-edges.
pub(super) fn box_corners(centre: Vec3, halves: [Vec3; 3]) -> Vec<Vec3> {
    let mut corners = vec![centre];
    for half in halves {
        corners = corners.iter().flat_map(|&corner| [corner - half, corner + half]).collect();
    }
    corners
}

/// What an arc has in common with a sector of less than half a turn: up to two arcs.
pub(super) fn common_arcs((from, sweep): (f64, f64), sector: Option<(f64, f64)>) -> Vec<(f64, f64)> {
    let Some((start, width)) = sector.filter(|&(_, width)| width < PI) else { return vec![(from, sweep)] };
    let offset = (start - from).rem_euclid(TAU);
    // The sector, and the same sector a turn earlier, as it may begin before the arc does.
    [offset, offset - TAU]
        .into_iter()
        .filter_map(|begin| {
            let (low, high) = (begin.max(0.0), (begin + width).min(sweep));
            (low < high).then_some((from + low, high - low))
        })
        .collect()
}

/// The ellipse on the page of the ellipse centre + first·cos φ + second·sin φ of the world.
///
/// The image of a circle in perspective is exactly an ellipse as long as all of it lies in front of the eye.
/// With h the linear map to homogeneous page coordinates and H = (h(first), h(second), h(centre)), the lines
/// that touch the image are those with lᵀ·D·l = 0, D = H·diag(1, 1, −1)·Hᵀ; centre and axes of the ellipse
/// are read off D.
pub(super) fn ellipse(camera: &Camera, centre: Vec3, [first, second]: [Vec3; 2]) -> Shape {
    let origin = camera.homogeneous(centre);
    let step = |radius: Vec3| {
        let [x, y, w] = camera.homogeneous(centre + radius);
        [x - origin[0], y - origin[1], w - origin[2]]
    };
    // Page coordinates about the image of the centre, or the square of a page's width would drown the ellipse.
    let middle = at(origin[0] / origin[2], origin[1] / origin[2]);
    let local = |[x, y, w]: [f64; 3]| [x - middle.x * w, y - middle.y * w, w];
    let (a, b, c) = (local(step(first)), local(step(second)), local(origin));
    let dual = |i: usize, j: usize| a[i] * a[j] + b[i] * b[j] - c[i] * c[j];
    let depth = dual(2, 2);
    let (x, y) = (dual(0, 2) / depth, dual(1, 2) / depth);
    // The matrix of mean squares of the ellipse: its eigenvalues are the squares of the semi-axes.
    let (xx, xy, yy) = (x * x - dual(0, 0) / depth, x * y - dual(0, 1) / depth, y * y - dual(1, 1) / depth);
    let (mean, half) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    let radii = (((mean + half).max(0.0)).sqrt(), ((mean - half).max(0.0)).sqrt());
    // A circle has no direction: rounding would give it another on each machine.
    if half < 1e-9 * mean {
        return Shape::Ellipse { centre: middle + at(x, y), radii: (mean.sqrt(), mean.sqrt()), turn: 0.0 };
    }
    // The page's y runs downwards; angles of drawings turn counter-clockwise.
    let turn = 0.5 * (-2.0 * xy).atan2(xx - yy);
    Shape::Ellipse { centre: middle + at(x, y), radii, turn }
}

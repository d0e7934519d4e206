//! What several solids share: rims and their images, arcs of rims, and boxes about them.

use super::camera::Camera;
use super::track::CHORDS;
use super::vector::Vec3;
use crate::point::at;
use crate::shape::Shape;
use std::f64::consts::{PI, TAU};

/// A polynomial in the point whose zeros are the cone that the eye spans with a circle (a cylinder for an eye
/// at infinity).
///
/// A point at the step d from the circle's centre, moved along its line of sight into the circle's plane,
/// lands at the step (d·a − g·h)/(a − k·h), with g the sight at the centre, a its part along the axis, h the
/// height of the point and k the nearness of the eye.
pub(super) fn shadow(camera: &Camera, centre: Vec3, axis: Vec3, radius: f64, point: Vec3) -> f64 {
    let (step, sight) = (point - centre, camera.sight(centre));
    let (height, rise) = (step.dot(axis), sight.dot(axis));
    let landed = step * rise - sight * height;
    landed.square() - (radius * (rise - camera.nearness() * height)).powi(2)
}

/// The corners of a box with these half-edges.
pub(super) fn box_corners(centre: Vec3, [x, y, z]: [Vec3; 3]) -> Vec<Vec3> {
    let mut corners = vec![centre];
    for half in [x, y, z] {
        corners = corners.iter().flat_map(|&corner| [corner - half, corner + half]).collect();
    }
    corners
}

/// Angles from one to another, as close as the chords of a circle.
pub(super) fn steps(from: f64, sweep: f64) -> Vec<f64> {
    let count = (f64::from(CHORDS) * sweep.abs() / TAU).ceil().max(1.0);
    (0..=count as u32).map(|index| from + sweep * f64::from(index) / count).collect()
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
pub(super) fn ellipse(camera: &Camera, centre: Vec3, first: Vec3, second: Vec3) -> Shape {
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

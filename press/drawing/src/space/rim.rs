//! What several solids share: rims, and boxes about them.

use super::camera::Camera;
use super::vector::Vec3;

/// A polynomial in the point whose zeros are the cone that the eye spans with a circle (a cylinder for an eye at infinity).
///
/// A point at the step d from the circle's centre, moved along its line of sight into the circle's plane, lands at the step
/// (d·a − g·h)/(a − k·h), with g the sight at the centre, a its part along the axis, h the height of the point and k the
/// nearness of the eye.
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

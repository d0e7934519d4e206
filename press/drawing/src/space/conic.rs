//! Circles of space as ellipses of the page.

use super::camera::Camera;
use super::vector::Vec3;
use crate::drawing::Shape;
use crate::point::at;

/// The ellipse on the page of the ellipse centre + first·cos φ + second·sin φ of the world.
///
/// The image of a circle in perspective is exactly an ellipse as long as all of it lies in front of the eye. With h the linear
/// map to homogeneous page coordinates and H = (h(first), h(second), h(centre)), the lines that touch the image are those
/// with lᵀ·D·l = 0, D = H·diag(1, 1, −1)·Hᵀ; centre and axes of the ellipse are read off D.
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
    // The page's y runs downwards; angles of drawings turn counter-clockwise.
    let turn = 0.5 * (-2.0 * xy).atan2(xx - yy);
    Shape::Ellipse { centre: middle + at(x, y), radii, turn }
}

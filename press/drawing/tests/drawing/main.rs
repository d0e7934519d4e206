//! Drawings and what they are made of: shapes and their SVG, labels, scenes in space.

mod judge;
mod labels;
mod shapes;
mod space;

use drawing::Point;

/// The least distance of a point from a polyline, px.
fn distance(polyline: &[Point], point: Point) -> f64 {
    let from_segment = |pair: &[Point]| {
        let (chord, far) = (pair[1] - pair[0], point - pair[0]);
        let square = chord.x * chord.x + chord.y * chord.y;
        let part =
            if square > 0.0 { ((far.x * chord.x + far.y * chord.y) / square).clamp(0.0, 1.0) } else { 0.0 };
        (far - chord * part).length()
    };
    polyline.windows(2).map(from_segment).fold(f64::INFINITY, f64::min)
}

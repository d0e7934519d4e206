//! Polylines thinned below what can be seen.

use crate::point::Point;

/// How far a thinned polyline may lie from the one it came from, px.
pub const TOLERANCE: f64 = 0.06;

/// A polyline of fewer points that nowhere lies further than `tolerance` (px) from the given one.
///
/// The method of Ramer (1972), and of Douglas and Peucker (1973): keep the point furthest from the chord, and ask again
/// on both sides. The first and the last point stay.
pub fn simplify(points: &[Point], tolerance: f64) -> Vec<Point> {
    if points.len() < 3 {
        return points.to_vec();
    }
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[points.len() - 1] = true;
    let mut spans = vec![(0, points.len() - 1)];
    while let Some((first, last)) = spans.pop() {
        let furthest = (first + 1..last)
            .map(|index| (index, distance(points[index], points[first], points[last])))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((index, far)) = furthest
            && far > tolerance
        {
            keep[index] = true;
            spans.push((first, index));
            spans.push((index, last));
        }
    }
    points.iter().zip(keep).filter_map(|(&point, keep)| keep.then_some(point)).collect()
}

/// The distance of a point from a segment.
fn distance(point: Point, start: Point, end: Point) -> f64 {
    let (chord, step) = (end - start, point - start);
    let square = chord.x * chord.x + chord.y * chord.y;
    let part =
        if square > 0.0 { ((step.x * chord.x + step.y * chord.y) / square).clamp(0.0, 1.0) } else { 0.0 };
    (step - chord * part).length()
}

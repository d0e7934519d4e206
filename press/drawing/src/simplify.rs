//! Polylines thinned below what can be seen.

use crate::point::Point;

/// How far a thinned polyline may lie from the one it came from, px: a quarter of what the curves that are written in its
/// place may miss.
pub const TOLERANCE: f64 = 0.02;

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
        let (mut index, mut far) = (first, 0.0);
        let distance = distance_from(points[first], points[last]);
        for (between, &point) in points.iter().enumerate().take(last).skip(first + 1) {
            let away = distance(point);
            if away >= far {
                (index, far) = (between, away);
            }
        }
        if far > tolerance * tolerance {
            keep[index] = true;
            spans.push((first, index));
            spans.push((index, last));
        }
    }
    points.iter().zip(keep).filter_map(|(&point, keep)| keep.then_some(point)).collect()
}

/// The square of a point's distance from a segment.
fn distance_from(start: Point, end: Point) -> impl Fn(Point) -> f64 {
    let chord = end - start;
    let square = chord.x * chord.x + chord.y * chord.y;
    let scale = if square > 0.0 { 1.0 / square } else { 0.0 };
    move |point| {
        let step = point - start;
        let part = ((step.x * chord.x + step.y * chord.y) * scale).clamp(0.0, 1.0);
        let away = step - chord * part;
        away.x * away.x + away.y * away.y
    }
}

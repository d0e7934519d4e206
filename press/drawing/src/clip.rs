//! Polylines cut at a frame.

use crate::point::{Point, Rect};

/// The pieces of a polyline inside a frame, px. Points that are not finite end a piece.
///
/// What leaves the frame is cut exactly at its edge and never drawn along it.
///
/// ```
/// use drawing::{Rect, at, clip};
/// let roof = [at(0.0, 20.0), at(10.0, -10.0), at(20.0, 20.0)];
/// let pieces = clip(&roof, &Rect::new(0.0, 0.0, 20.0, 20.0));
/// assert_eq!(pieces.len(), 2);
/// assert_eq!(pieces[0][1].y, 0.0); // cut where it leaves, no false plateau
/// ```
pub fn clip(points: &[Point], frame: &Rect) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut open = false;
    for pair in points.windows(2) {
        let [start, end] = [pair[0], pair[1]];
        let Some((enter, leave)) = inside(start, end, frame) else {
            open = false;
            continue;
        };
        let step = end - start;
        let last = if leave < 1.0 { start + step * leave } else { end };
        match pieces.last_mut() {
            Some(piece) if open && enter == 0.0 => piece.push(last),
            _ => pieces.push(vec![if enter > 0.0 { start + step * enter } else { start }, last]),
        }
        open = leave >= 1.0;
    }
    pieces
}

/// The part of the segment inside the frame, as fractions of its length (Liang and Barsky, ACM Trans.
/// Graphics 3, 1984).
fn inside(start: Point, end: Point, frame: &Rect) -> Option<(f64, f64)> {
    let step = end - start;
    if !(start.is_finite() && end.is_finite()) {
        return None;
    }
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (outward, room) in [
        (-step.x, start.x - frame.left),
        (step.x, frame.right - start.x),
        (-step.y, start.y - frame.top),
        (step.y, frame.bottom - start.y),
    ] {
        if outward == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if outward < 0.0 {
            enter = enter.max(room / outward);
        } else {
            leave = leave.min(room / outward);
        }
    }
    (enter < leave).then_some((enter, leave))
}

//! One figure in two widths.

use crate::Outcome;
use drawing::Room;

/// A figure that is drawn by one function for a wide page and for a phone. What takes long is computed before.
///
/// ```
/// # use drawing::{Drawing, Hue, Rect, Stroke};
/// # use figures::{Axis, Outcome, Plot, in_both};
/// fn parabola(id: &str) -> Outcome {
///     let curve: Vec<(f64, f64)> = (0..=100).map(|k| f64::from(k) / 100.0).map(|x| (x, x * x)).collect();
///     in_both(|room| {
///         let width = room.of(660.0, 400.0);
///         let mut drawing = Drawing::new(id, width, 360.0).titled("A parabola", "It goes up.");
///         let frame = Rect::new(50.0, 40.0, width - 80.0, 260.0);
///         let (x, y) = (Axis::linear(0.0, 1.0, room.of(0.1, 0.5)), Axis::linear(0.0, 1.0, 0.5));
///         let mut plot = Plot::new(&mut drawing, frame, x, y)?;
///         plot.curve("parabola", curve.iter().copied(), Stroke::Curve, Hue::Blue);
///         Ok(drawing)
///     })
/// }
/// assert_eq!(parabola("it").unwrap().all_parts()[1].id(), "it-narrow");
/// ```
pub fn in_both(draw: impl Fn(Room) -> Outcome) -> Outcome {
    Ok(draw(Room::Wide)?.with_narrow(draw(Room::Narrow)?))
}

//! The figures of the chapter "The pendulum": one function each.

use drawing::kit::{self, Heads};
use drawing::{Drawing, Hue, Point, Rect, Side, Stroke, at};
use figures::{Axis, Figure, Outcome, Plot, figures, linear_steps};
use pendulum::Pendulum;
use std::f64::consts::FRAC_PI_2;

/// All figures of this chapter.
pub const FIGURES: &[Figure] = figures![swing, period];

/// The figure `fig:swing`: the letters of eq:pendulum-small.
pub(crate) fn swing(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 240.0, 200.0).titled(
        "A pendulum held aside",
        "A rod of the length l hangs from a pivot and is held at the angle theta from the vertical, to the right. A mass \
         sits at its end.",
    );
    let (pivot, theta) = (at(80.0, 20.0), 0.6);
    let mass = pivot + Point::polar(150.0, theta - FRAC_PI_2);
    drawing.line(pivot, pivot + at(0.0, 170.0), Stroke::Reference, Hue::Muted);
    drawing.line(pivot, mass, Stroke::Outline, Hue::Ink);
    kit::angle(&mut drawing, pivot, 60.0, -FRAC_PI_2, theta, Heads::None, Hue::Ink);
    drawing.dot(mass, 8.0, Hue::Blue);
    drawing.label(pivot + Point::polar(60.0, 0.5 * theta - FRAC_PI_2), Side::Below, r"$\theta$", Hue::Ink)?;
    drawing.label(pivot.towards(mass, 0.6), Side::AboveRight, "$l$", Hue::Ink)?;
    Ok(drawing)
}

/// The figure `fig:period`: eq:pendulum-period.
pub(crate) fn period(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 260.0).titled(
        "The period of a pendulum",
        "The period in units of that of narrow swings, against the amplitude in degrees. It is 1 at zero and 1.18 at \
         90 degrees, and rises ever more steeply, to 2.9 at 175 degrees.",
    );
    let frame = Rect::new(50.0, 15.0, 330.0, 190.0);
    let x = Axis::linear(0.0, 180.0, 45.0).titled(r"amplitude $\theta_0$, degrees");
    let y = Axis::linear(0.0, 3.0, 1.0).titled("$T/T_0$");
    let mut plot = Plot::new(&mut drawing, frame, x, y)?;
    let one = Pendulum { length: 1.0, gravity: 1.0 };
    let ratio = |degrees: f64| one.period(degrees.to_radians()) / one.period(0.0);
    plot.level(1.0, Stroke::Reference);
    let values = linear_steps(0.0, 175.0, 300).map(|degrees| (degrees, ratio(degrees)));
    plot.curve("period", values, Stroke::Curve, Hue::Blue);
    plot.label((90.0, 1.0), Side::Below, "narrow swings", Hue::Muted)?;
    Ok(drawing)
}

//! Arrows, angles and dimensions, with the arrowhead of the house.

use crate::drawing::Drawing;
use crate::point::Point;
use crate::role::{Fill, Hue, Role, Stroke};
use crate::shape::Shape;

/// The arrowhead: its length, its width and the depth of the notch at its back, px.
pub(crate) const HEAD: (f64, f64, f64) = (10.0, 7.2, 2.2);
/// Arrowheads on arcs and dimension lines are this much smaller.
pub(crate) const SMALL: f64 = 0.8;

/// Which ends of an arc or line carry an arrowhead.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Heads {
    /// None.
    None,
    /// The far end.
    End,
    /// Both ends.
    Both,
}

/// An arrowhead with its tip at a point, pointing in a direction, `scale` times the size of the house.
pub fn head(drawing: &mut Drawing, tip: Point, direction: Point, scale: f64, hue: Hue) {
    let (length, width, notch) = (HEAD.0 * scale, HEAD.1 * scale, HEAD.2 * scale);
    let along = direction.unit();
    let across = along.quarter_turned() * (0.5 * width);
    let back = tip - along * length;
    drawing.polygon(vec![tip, back + across, back + along * notch, back - across], Fill::Solid, hue);
}

/// An arrow from a point to a point. One that is shorter than twice its head gets a smaller head.
pub fn arrow(drawing: &mut Drawing, from: Point, to: Point, hue: Hue) {
    let step = to - from;
    let scale = (0.5 * step.length() / HEAD.0).min(1.0);
    let neck = to - step.unit() * ((HEAD.0 - HEAD.2) * scale);
    drawing.line(from, neck, Stroke::Vector, hue);
    head(drawing, to, step, scale, hue);
}

/// The size of a head on a line of this stroke.
pub(crate) fn size(stroke: Stroke) -> f64 {
    if stroke.width() > 1.6 { 1.0 } else { SMALL }
}

/// The arc of an angle about `centre`, from one direction through `sweep` (positive counter-clockwise), rad.
pub fn angle(
    drawing: &mut Drawing,
    centre: Point,
    radius: f64,
    from: f64,
    sweep: f64,
    heads: Heads,
    hue: Hue,
) {
    // A head on an arc covers this angle; the line ends in its notch.
    let covered = ((HEAD.0 - HEAD.2) * SMALL / radius).min(0.5 * sweep.abs()) * sweep.signum();
    let far = if heads == Heads::None { 0.0 } else { covered };
    let near = if heads == Heads::Both { covered } else { 0.0 };
    let shape = Shape::Arc { centre, radius, from: from + near, sweep: sweep - near - far };
    drawing.push(Role::Line(Stroke::Outline, hue), shape);
    // The head lies along the chord that it covers, which looks tangent.
    let chord = |end: f64, inward: f64| {
        let tip = centre + Point::polar(radius, end);
        (tip, tip - (centre + Point::polar(radius, end - inward)))
    };
    if heads != Heads::None {
        let (tip, direction) = chord(from + sweep, covered);
        head(drawing, tip, direction, SMALL, hue);
    }
    if heads == Heads::Both {
        let (tip, direction) = chord(from, -covered);
        head(drawing, tip, direction, SMALL, hue);
    }
}

/// A dimension line: a thin line between two points with small heads.
pub fn dimension(drawing: &mut Drawing, from: Point, to: Point, heads: Heads, hue: Hue) {
    let along = (to - from).unit();
    let inset = along * ((HEAD.0 - HEAD.2) * SMALL);
    let start = if heads == Heads::Both { from + inset } else { from };
    let end = if heads == Heads::None { to } else { to - inset };
    drawing.line(start, end, Stroke::Outline, hue);
    if heads != Heads::None {
        head(drawing, to, along, SMALL, hue);
    }
    if heads == Heads::Both {
        head(drawing, from, -along, SMALL, hue);
    }
}

//! Why something cannot be drawn.

use crate::label::{Label, Piece};
use crate::point::{Point, at};
use crate::shape::{Item, Shape};
use std::error::Error;
use std::fmt;

/// Why something cannot be drawn, in words: a label that cannot be set, an axis without ticks, a direction without
/// length, a coordinate that is no number. Nothing is ever left out silently.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Flaw(String);

impl Flaw {
    /// A flaw with its reason.
    pub fn new(reason: impl Into<String>) -> Self {
        Self(reason.into())
    }

    /// The flaw of what goes through a place that is no pair of finite numbers, px or in the units of a plot.
    pub fn nowhere(what: &str, (x, y): (f64, f64)) -> Self {
        Self(format!("{what} goes through ({x}, {y}), which can be drawn nowhere"))
    }
}

impl fmt::Display for Flaw {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}

impl Error for Flaw {}

/// The flaw of a shape, if it has one.
pub(crate) fn of(item: &Item) -> Option<Flaw> {
    let astray = |points: &[Point]| points.iter().copied().find(|point| !point.is_finite());
    let found = match &item.shape {
        Shape::Polyline(points) | Shape::Polygon(points) => astray(points),
        Shape::Circle { centre, radius } => astray(&[*centre, at(*radius, 0.0)]),
        Shape::Arc { centre, radius, from, sweep } => astray(&[*centre, at(*radius, 0.0), at(*from, *sweep)]),
        Shape::Ellipse { centre, radii, turn } => astray(&[*centre, at(radii.0, radii.1), at(*turn, 0.0)]),
        Shape::Rounded { centre, radii, turn, light } => {
            astray(&[*centre, at(radii.0, radii.1), at(*turn, 0.0), *light])
        }
        Shape::Label(Label { bounds, .. }) => {
            astray(&[at(bounds.left, bounds.top), at(bounds.right, bounds.bottom)])
        }
    };
    found.map(|point| Flaw::nowhere(&what(item), (point.x, point.y)))
}

/// What a shape is, by name if it has one.
pub(crate) fn what(item: &Item) -> String {
    let kind = match &item.shape {
        Shape::Polyline(_) => "line",
        Shape::Polygon(_) => "polygon",
        Shape::Circle { .. } => "circle",
        Shape::Arc { .. } => "arc",
        Shape::Ellipse { .. } => "ellipse",
        Shape::Rounded { .. } => "rounded body",
        Shape::Label(_) => "label",
    };
    match (&item.name, &item.shape) {
        (Some(name), _) => format!("the {kind} {name}"),
        (None, Shape::Label(label)) => format!("the label {}", words(label)),
        (None, _) => format!("a {kind} ({})", item.role.classes()),
    }
}

/// The words of a label, or that it has none.
fn words(label: &Label) -> String {
    let words = label.pieces.iter().filter_map(|piece| match piece {
        Piece::Words { text, .. } => Some(text.trim()),
        Piece::Outline(_) => None,
    });
    let words: Vec<&str> = words.collect();
    if words.is_empty() { "in mathematics".into() } else { format!("`{}`", words.join(" … ")) }
}

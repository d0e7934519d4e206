//! What makes a drawing unfit to be shown.

use crate::drawing::{Item, Shape};
use crate::label::{Label, Piece, Segment};
use crate::point::Point;
use std::error::Error;
use std::fmt;

/// Why there is no SVG of a drawing. Nothing is ever left out silently.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Flaw {
    /// A shape with a coordinate that is no finite number.
    NoNumber {
        /// What it is, by name if it has one: `the curve body`.
        what: String,
        /// The place, px or in the units of a plot.
        place: (f64, f64),
    },
    /// A curve of which nothing lies inside its frame.
    NothingToSee {
        /// What it is.
        what: String,
    },
    /// A shape of a figure of panels that lies in none of them.
    BesidePanels {
        /// What it is.
        what: String,
    },
}

impl fmt::Display for Flaw {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoNumber { what, place: (x, y) } => {
                write!(out, "{what} goes through ({x}, {y}), which can be drawn nowhere")
            }
            Self::NothingToSee { what } => write!(out, "no part of {what} lies inside the frame"),
            Self::BesidePanels { what } => write!(out, "{what} lies in no panel of a figure of panels"),
        }
    }
}

impl Error for Flaw {}

/// The flaw of a shape, if it has one.
pub(crate) fn of(item: &Item) -> Option<Flaw> {
    let point =
        numbers(&item.shape).into_iter().find(|point| !(point.x.is_finite() && point.y.is_finite()))?;
    Some(Flaw::NoNumber { what: what(item), place: (point.x, point.y) })
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

/// All numbers that a shape is made of, in pairs.
fn numbers(shape: &Shape) -> Vec<Point> {
    let pair = |x, y| Point { x, y };
    match shape {
        Shape::Polyline(points) | Shape::Polygon(points) => points.clone(),
        Shape::Circle { centre, radius } => vec![*centre, pair(*radius, 0.0)],
        Shape::Arc { centre, radius, from, sweep } => vec![*centre, pair(*radius, 0.0), pair(*from, *sweep)],
        Shape::Ellipse { centre, radii, turn } => vec![*centre, pair(radii.0, radii.1), pair(*turn, 0.0)],
        Shape::Rounded { centre, radii, turn, light } => {
            vec![*centre, pair(radii.0, radii.1), pair(*turn, 0.0), *light]
        }
        Shape::Label(label) => label.pieces.iter().flat_map(corners).collect(),
    }
}

fn corners(piece: &Piece) -> Vec<Point> {
    match piece {
        Piece::Words { start, width, size, .. } => vec![*start, Point { x: *width, y: *size }],
        Piece::Outline(segments) => segments
            .iter()
            .flat_map(|segment| match *segment {
                Segment::Move(end) | Segment::Line(end) => vec![end],
                Segment::Quadratic(control, end) => vec![control, end],
                Segment::Cubic(first, second, end) => vec![first, second, end],
                Segment::Close => Vec::new(),
            })
            .collect(),
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

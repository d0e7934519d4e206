//! What makes a drawing unfit to be shown.

use crate::label::{Label, Piece, Segment};
use crate::point::Point;
use crate::shape::{Item, Shape};
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
    let mut found = None;
    each_number(&item.shape, &mut |point| {
        if found.is_none() && !(point.x.is_finite() && point.y.is_finite()) {
            found = Some(point);
        }
    });
    found.map(|point| Flaw::NoNumber { what: what(item), place: (point.x, point.y) })
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

/// Gives all numbers that a shape is made of, in pairs.
fn each_number(shape: &Shape, give: &mut impl FnMut(Point)) {
    let pair = |x, y| Point { x, y };
    match shape {
        Shape::Polyline(points) | Shape::Polygon(points) => points.iter().for_each(|&point| give(point)),
        Shape::Circle { centre, radius } => [*centre, pair(*radius, 0.0)].into_iter().for_each(give),
        Shape::Arc { centre, radius, from, sweep } => {
            [*centre, pair(*radius, 0.0), pair(*from, *sweep)].into_iter().for_each(give);
        }
        Shape::Ellipse { centre, radii, turn } => {
            [*centre, pair(radii.0, radii.1), pair(*turn, 0.0)].into_iter().for_each(give);
        }
        Shape::Rounded { centre, radii, turn, light } => {
            [*centre, pair(radii.0, radii.1), pair(*turn, 0.0), *light].into_iter().for_each(give);
        }
        Shape::Label(label) => label.pieces.iter().for_each(|piece| each_corner(piece, give)),
    }
}

fn each_corner(piece: &Piece, give: &mut impl FnMut(Point)) {
    match piece {
        Piece::Words { start, width, size, .. } => {
            [*start, Point { x: *width, y: *size }].into_iter().for_each(give);
        }
        Piece::Outline(segments) => {
            for segment in segments {
                match *segment {
                    Segment::Move(end) | Segment::Line(end) => give(end),
                    Segment::Quadratic(control, end) => [control, end].into_iter().for_each(&mut *give),
                    Segment::Cubic(first, second, end) => {
                        [first, second, end].into_iter().for_each(&mut *give);
                    }
                    Segment::Close => {}
                }
            }
        }
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

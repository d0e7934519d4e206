//! Shapes, and what each of them is on the page.

use crate::label::Label;
use crate::point::{Point, at};
use crate::role::Role;

/// A shape, in pixels.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// Straight lines from point to point.
    Polyline(Vec<Point>),
    /// Straight lines from point to point and back to the first.
    Polygon(Vec<Point>),
    /// A circle.
    Circle {
        /// Its centre.
        centre: Point,
        /// Its radius, px.
        radius: f64,
    },
    /// A part of a circle.
    Arc {
        /// The centre of the circle.
        centre: Point,
        /// Its radius, px.
        radius: f64,
        /// The direction in which the arc begins, rad, counter-clockwise on the page from the right.
        from: f64,
        /// How far it turns from there, rad, positive if counter-clockwise on the page; less than a full turn.
        sweep: f64,
    },
    /// An ellipse.
    Ellipse {
        /// Its centre.
        centre: Point,
        /// Its semi-axes, px.
        radii: (f64, f64),
        /// The direction of the first semi-axis, rad, counter-clockwise on the page from the right.
        turn: f64,
    },
    /// The image of a rounded body: an ellipse, shaded from its brightest point to its outline.
    Rounded {
        /// Its centre.
        centre: Point,
        /// Its semi-axes, px.
        radii: (f64, f64),
        /// The direction of the first semi-axis, rad, counter-clockwise on the page from the right.
        turn: f64,
        /// The point where it is brightest, inside.
        light: Point,
    },
    /// A label.
    Label(Label),
}

/// A shape with its role.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// What it is.
    pub role: Role,
    /// Its form.
    pub shape: Shape,
    /// Its name, unique in the drawing; becomes an id of the SVG, after the figure's.
    pub name: Option<String>,
}

impl Shape {
    /// The area of the shape, without its shading.
    pub(crate) fn unshaded(&self) -> Self {
        match *self {
            Self::Rounded { centre, radii, turn, .. } => Self::Ellipse { centre, radii, turn },
            _ => self.clone(),
        }
    }

    /// The shape's lines as points, circles, arcs and ellipses divided finely; a label's are the corners of its ink.
    pub fn points(&self) -> Vec<Point> {
        match self {
            Self::Polyline(points) => points.clone(),
            Self::Polygon(points) => points.iter().chain(points.first()).copied().collect(),
            Self::Circle { centre, radius } => arc_points(*centre, *radius, 0.0, std::f64::consts::TAU),
            Self::Arc { centre, radius, from, sweep } => arc_points(*centre, *radius, *from, *sweep),
            Self::Ellipse { centre, radii, turn } | Self::Rounded { centre, radii, turn, .. } => {
                ellipse_points(*centre, *radii, *turn)
            }
            Self::Label(Label { bounds, .. }) => vec![
                at(bounds.left, bounds.top),
                at(bounds.right, bounds.top),
                at(bounds.right, bounds.bottom),
                at(bounds.left, bounds.bottom),
            ],
        }
    }
}

fn arc_points(centre: Point, radius: f64, from: f64, sweep: f64) -> Vec<Point> {
    let steps = 120;
    (0..=steps)
        .map(|step| centre + Point::polar(radius, from + sweep * f64::from(step) / f64::from(steps)))
        .collect()
}

fn ellipse_points(centre: Point, radii: (f64, f64), turn: f64) -> Vec<Point> {
    let (first, second) = (Point::polar(radii.0, turn), Point::polar(radii.1, turn).quarter_turned());
    let steps = 120;
    (0..=steps)
        .map(|step| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(step) / f64::from(steps)).sin_cos();
            centre + first * cos + second * sin
        })
        .collect()
}

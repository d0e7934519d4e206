//! Markers of points.

use crate::drawing::Drawing;
use crate::point::{Point, at};
use crate::role::{Fill, Hue, Role, Stroke};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

/// The form of a marker. Markers are about 7 px across and of about equal weight.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// A filled disc.
    Disc,
    /// A filled square.
    Square,
    /// A filled triangle, tip up.
    Triangle,
    /// A filled square on its corner.
    Diamond,
    /// A ring, empty inside.
    Ring,
    /// An upright cross.
    Plus,
    /// A cross that lies.
    Cross,
    /// The mark of a centre of mass: a ring with two opposite quarters filled.
    Mass,
    /// The mark of an arrow that comes out of the page: a ring with a point, the tip.
    Out,
    /// The mark of an arrow that goes into the page: a ring with a cross, the feathers.
    Into,
}

/// Marks what a hand can take hold of in a scene, and nothing else looks like it: a disc in a ring.
pub fn grip(drawing: &mut Drawing, point: Point, hue: Hue) {
    drawing.circle(point, GRIP, Role::Area(Fill::Page, hue));
    drawing.circle(point, GRIP, Role::Line(Stroke::Outline, hue));
    drawing.dot(point, 4.0, hue);
}

/// The radius of the ring of a [`grip`], px.
pub const GRIP: f64 = 7.5;

/// Marks a point.
pub fn marker(drawing: &mut Drawing, point: Point, marker: Marker, hue: Hue) {
    let regular = |corners: u32, radius: f64, first: f64| -> Vec<Point> {
        (0..corners)
            .map(|k| point + Point::polar(radius, first + TAU * f64::from(k) / f64::from(corners)))
            .collect()
    };
    match marker {
        Marker::Disc => drawing.dot(point, 3.4, hue),
        Marker::Square => {
            let half = 3.1;
            let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
            drawing.polygon(corners.map(|(x, y)| point + at(x, y)).to_vec(), Fill::Solid, hue);
        }
        Marker::Triangle => drawing.polygon(regular(3, 4.4, FRAC_PI_2), Fill::Solid, hue),
        Marker::Diamond => drawing.polygon(regular(4, 4.4, 0.0), Fill::Solid, hue),
        Marker::Ring => {
            drawing.circle(point, 3.2, Role::Area(Fill::Page, hue));
            drawing.circle(point, 3.2, Role::Line(Stroke::Curve, hue));
        }
        Marker::Plus | Marker::Cross => {
            let first = if marker == Marker::Plus { 0.0 } else { FRAC_PI_4 };
            for way in [first, first + FRAC_PI_2] {
                let arm = Point::polar(4.0, way);
                drawing.line(point - arm, point + arm, Stroke::Curve, hue);
            }
        }
        Marker::Mass => {
            let radius = 6.0;
            drawing.circle(point, radius, Role::Area(Fill::Page, hue));
            for first in [0.0, PI] {
                let mut quarter = vec![point];
                quarter.extend(
                    (0..=16).map(|k| point + Point::polar(radius, first + FRAC_PI_2 * f64::from(k) / 16.0)),
                );
                drawing.polygon(quarter, Fill::Solid, hue);
            }
            drawing.circle(point, radius, Role::Line(Stroke::Outline, hue));
        }
        Marker::Out | Marker::Into => {
            let radius = 6.0;
            drawing.circle(point, radius, Role::Area(Fill::Page, hue));
            drawing.circle(point, radius, Role::Line(Stroke::Axis, hue));
            if marker == Marker::Out {
                drawing.dot(point, 2.2, hue);
            } else {
                for way in [FRAC_PI_4, 3.0 * FRAC_PI_4] {
                    let feather = Point::polar(radius, way);
                    drawing.line(point - feather, point + feather, Stroke::Axis, hue);
                }
            }
        }
    }
}

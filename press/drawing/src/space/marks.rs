//! Grounds, patches, points, labels, named vectors and angles of a scene.

use super::checks::{direction, finite, positive};
use super::curve::Curve;
use super::stage::{Dot, Stage};
use super::track::Track;
use super::vector::{Place, Vec3};
use crate::flaw::Flaw;
use crate::kit::Heads;
use crate::label::{Label, Side};
use crate::point::{Point, at};
use crate::role::{Fill, Hue, Role, Stroke};
use crate::shape::Shape;
use std::f64::consts::TAU;

/// The type size of a label, px; its gap from a point; its gap from the tip of an arrow or from an arc.
const SIZE: f64 = 14.0;
const GAP: f64 = 6.0;
const TIP_GAP: f64 = 5.0;
/// The most lines of a grid, both ways together.
const MOST_LINES: f64 = 400.0;
/// Where an arrow that turns begins and ends, rad behind and before the direction to the right.
const OPENING: (f64, f64) = (0.45, 0.25);

impl Stage {
    /// Adds a vector with its name beyond the tip.
    pub fn named_vector(
        &mut self,
        from: impl Place,
        to: impl Place,
        name: &str,
        hue: Hue,
    ) -> Result<(), Flaw> {
        let curve = Curve::segment(from, to)?;
        let [tail, tip] = [curve.track.points[0], curve.track.points[1]];
        self.arrow(curve, Stroke::Vector, Heads::End, hue)?;
        let along = self.camera.land(tip) - self.camera.land(tail);
        self.label_beyond(tip, along, name, hue)
    }

    /// Adds an arrow that turns about an axis, right-handed: most of a circle seen in perspective, open
    /// towards the right on the page. It shows the sense of a rotation.
    pub fn turning(
        &mut self,
        centre: impl Place,
        axis: impl Place,
        radius: f64,
        hue: Hue,
    ) -> Result<(), Flaw> {
        let (centre, axis) = (finite("centre", centre)?, direction("axis", axis)?);
        let radius = positive("radius", radius)?;
        let right = self.camera.right.across(axis);
        let right = right.unit().unwrap_or(axis.companions().0);
        let (sin, cos) = OPENING.0.sin_cos();
        let start = (right * cos + axis.cross(right) * sin) * radius;
        let track = Track::arc(centre, axis, start, TAU - OPENING.0 - OPENING.1);
        self.arrow(Curve::new(track), Stroke::Outline, Heads::End, hue)
    }

    /// Adds the arc of an angle between two directions at a vertex, by the shorter way, with its name outside
    /// the middle; an empty name is left out.
    pub fn angle(
        &mut self,
        vertex: impl Place,
        from: impl Place,
        to: impl Place,
        radius: f64,
        name: &str,
        hue: Hue,
    ) -> Result<(), Flaw> {
        let vertex = finite("vertex", vertex)?;
        let curve = Curve::between(vertex.0, from, to, radius)?;
        let middle = curve.track.points[curve.track.chords() / 2];
        self.camera.check(vertex)?;
        self.curve(curve, Stroke::Outline, hue)?;
        if name.is_empty() {
            return Ok(());
        }
        let outwards = self.camera.land(middle) - self.camera.land(vertex);
        self.label_beyond(middle, outwards, name, hue)
    }

    /// Adds a horizontal piece of ground, a rectangle between two opposite corners (x, y) at a height, with
    /// grid lines every `step` from the first corner. It is painted first and hides nothing.
    ///
    /// # Errors
    /// [`Flaw`] also for corners that enclose no area, and for more lines than can be told apart.
    pub fn ground(&mut self, from: [f64; 2], to: [f64; 2], height: f64, step: f64) -> Result<(), Flaw> {
        let corner = |x: f64, y: f64| finite("corner of the ground", [x, y, height]);
        let corners = [
            corner(from[0], from[1])?,
            corner(to[0], from[1])?,
            corner(to[0], to[1])?,
            corner(from[0], to[1])?,
        ];
        let step = positive("step of the grid", step)?;
        let sides = [(to[0] - from[0]).abs(), (to[1] - from[1]).abs()];
        for side in sides {
            positive("side of the ground", side)?;
        }
        let lines = (sides[0] + sides[1]) / step;
        if lines > MOST_LINES {
            let said = format!("a grid of {} lines; at most {MOST_LINES} can be told apart", lines.ceil());
            return Err(Flaw::new(said));
        }
        corners.into_iter().try_for_each(|corner| self.camera.check(corner))?;
        let land = |point: Vec3| self.camera.land(point);
        let floor = Shape::Polygon(corners.map(land).to_vec());
        self.grounds.push((Role::Area(Fill::Floor, Hue::Ink), floor));
        let [x, y] = [corners[1] - corners[0], corners[3] - corners[0]];
        for (side, along, across) in [(sides[0], x, y), (sides[1], y, x)] {
            let mut reached = 0.0;
            while reached < side * (1.0 + 1e-9) {
                let foot = corners[0] + along * (reached / side);
                let line = Shape::Polyline(vec![land(foot), land(foot + across)]);
                self.grounds.push((Role::Line(Stroke::Grid, Hue::Ink), line));
                reached += step;
            }
        }
        Ok(())
    }

    /// Adds a patch: a polygon in space, filled, and painted over every solid. It is meant for what lies on a
    /// face that is seen: a picture on a coin, a region of a sphere.
    pub fn patch(
        &mut self,
        corners: impl IntoIterator<Item = impl Place>,
        fill: Fill,
        hue: Hue,
    ) -> Result<(), Flaw> {
        let corners = corners.into_iter().map(|corner| self.camera.on_page(corner));
        let corners = corners.collect::<Result<Vec<Point>, Flaw>>()?;
        if corners.len() < 3 {
            return Err(Flaw::new("a patch needs at least three corners"));
        }
        self.patches.push((Role::Area(fill, hue), Shape::Polygon(corners)));
        Ok(())
    }

    /// Adds a filled dot of a radius on the page, px; a hollow dashed one where a solid hides it.
    pub fn dot(&mut self, point: impl Place, radius: f64, hue: Hue) -> Result<(), Flaw> {
        self.add_dot(point, radius, false, hue)
    }

    /// Adds a filled dot that is seen whatever stands before it, as a point of contact under a thick rim.
    pub fn dot_in_front(&mut self, point: impl Place, radius: f64, hue: Hue) -> Result<(), Flaw> {
        self.add_dot(point, radius, true, hue)
    }

    fn add_dot(&mut self, point: impl Place, radius: f64, in_front: bool, hue: Hue) -> Result<(), Flaw> {
        let (point, radius) = (finite("point", point)?, positive("radius", radius)?);
        self.camera.check(point)?;
        self.dots.push(Dot { point, radius, in_front, hue });
        Ok(())
    }

    /// Adds a label of 14 px beside a point. It has a rim in the colour of the page, unless it stands on an
    /// opaque solid.
    pub fn label(&mut self, point: impl Place, side: Side, text: &str, hue: Hue) -> Result<(), Flaw> {
        self.label_shifted(point, at(0.0, 0.0), side, text, hue)
    }

    /// Adds a label beside the page's point that lies a step away from the point, px.
    pub fn label_shifted(
        &mut self,
        point: impl Place,
        step: Point,
        side: Side,
        text: &str,
        hue: Hue,
    ) -> Result<(), Flaw> {
        finite("step on the page", [step.x, step.y, 0.0])?;
        let label = Label::new(text, SIZE)?.placed(self.camera.on_page(point)? + step, side, GAP);
        self.labels.push((label, hue));
        Ok(())
    }

    /// A label beyond a point in a direction of the page, centred on its ink.
    fn label_beyond(&mut self, point: Vec3, along: Point, text: &str, hue: Hue) -> Result<(), Flaw> {
        let label = Label::new(text, SIZE)?;
        let (ink, way) = (label.bounds, along.unit());
        // From its middle the ink reaches this far against the direction.
        let reach = (0.5 * ink.width() / way.x.abs()).min(0.5 * ink.height() / way.y.abs());
        let middle = self.camera.land(point) + way * (TIP_GAP + reach);
        let label = label.from_baseline(middle - ink.centre());
        self.labels.push((label, hue));
        Ok(())
    }
}

//! Points, labels, named vectors and angles of a scene.

use super::curve::Curve;
use super::error::{SpaceError, direction, finite, positive};
use super::stage::{Caption, Dot, Stage};
use super::track::Track;
use super::vector::Vec3;
use crate::kit::Heads;
use crate::label::{Label, Side};
use crate::point::{Point, at};
use crate::role::{Fill, Hue, Stroke};
use std::f64::consts::TAU;

/// The type size of a label, px; its gap from a point; its gap from the tip of an arrow or from an arc.
const SIZE: f64 = 14.0;
const GAP: f64 = 6.0;
const TIP_GAP: f64 = 5.0;
/// Where an arrow that turns begins and ends, rad behind and before the direction to the right.
const OPENING: (f64, f64) = (0.45, 0.25);

impl Stage {
    /// Adds a vector with its name beyond the tip.
    ///
    /// # Errors
    /// [`SpaceError`] as for [`Stage::vector`], and for a name that cannot be set.
    pub fn named_vector(
        &mut self,
        from: impl Into<[f64; 3]>,
        to: impl Into<[f64; 3]>,
        name: &str,
        hue: Hue,
    ) -> Result<(), SpaceError> {
        let curve = Curve::segment(from, to)?;
        let [tail, tip] = [curve.track.points[0], curve.track.points[1]];
        self.arrow(curve, Stroke::Vector, Heads::End, hue)?;
        let along = self.camera.land(tip) - self.camera.land(tail);
        self.caption_beyond(tip, along, name, hue)
    }

    /// Adds an arrow that turns about an axis, right-handed: most of a circle seen in perspective, open
    /// towards the right on the page. It shows the sense of a rotation.
    ///
    /// # Errors
    /// [`SpaceError`] for numbers that are not finite, an axis without length, a radius that is not positive,
    /// and what is behind the eye.
    pub fn turning(
        &mut self,
        centre: impl Into<[f64; 3]>,
        axis: impl Into<[f64; 3]>,
        radius: f64,
        hue: Hue,
    ) -> Result<(), SpaceError> {
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
    ///
    /// # Errors
    /// [`SpaceError`] as for [`Curve::between`], for what is behind the eye, and for a name that cannot be set.
    pub fn angle(
        &mut self,
        vertex: impl Into<[f64; 3]>,
        from: impl Into<[f64; 3]>,
        to: impl Into<[f64; 3]>,
        radius: f64,
        name: &str,
        hue: Hue,
    ) -> Result<(), SpaceError> {
        let vertex = finite("vertex", vertex)?;
        let curve = Curve::between(vertex.0, from, to, radius)?;
        let middle = curve.track.middle();
        self.camera.check(vertex)?;
        self.curve(curve, Stroke::Outline, hue)?;
        if name.is_empty() {
            return Ok(());
        }
        let outwards = self.camera.land(middle) - self.camera.land(vertex);
        self.caption_beyond(middle, outwards, name, hue)
    }

    /// Adds a patch: a polygon in space, filled, and painted over every solid. It is meant for what lies on a
    /// face that is seen: a picture on a coin, a region of a sphere.
    ///
    /// # Errors
    /// [`SpaceError`] for numbers that are not finite, fewer than three corners, and what is behind the eye.
    pub fn patch(
        &mut self,
        corners: impl IntoIterator<Item = impl Into<[f64; 3]>>,
        fill: Fill,
        hue: Hue,
    ) -> Result<(), SpaceError> {
        let corners = corners.into_iter().map(|corner| finite("corner of the patch", corner));
        let corners = corners.collect::<Result<Vec<Vec3>, SpaceError>>()?;
        if corners.len() < 3 {
            return Err(SpaceError::NoPatch);
        }
        corners.iter().try_for_each(|&corner| self.camera.check(corner))?;
        self.patches.push((corners, fill, hue));
        Ok(())
    }

    /// Adds a filled dot of a radius on the page, px; a hollow dashed one where a solid hides it.
    ///
    /// # Errors
    /// [`SpaceError`] for numbers that are not finite, a radius that is not positive, a point behind the eye.
    pub fn dot(&mut self, point: impl Into<[f64; 3]>, radius: f64, hue: Hue) -> Result<(), SpaceError> {
        let dot = Dot::Disc(positive("radius", radius)?);
        self.point(point, dot, hue)
    }

    /// Adds a filled dot that is seen whatever stands before it, as a point of contact under a thick rim.
    ///
    /// # Errors
    /// [`SpaceError`] as for [`Stage::dot`].
    pub fn dot_in_front(
        &mut self,
        point: impl Into<[f64; 3]>,
        radius: f64,
        hue: Hue,
    ) -> Result<(), SpaceError> {
        let dot = Dot::InFront(positive("radius", radius)?);
        self.point(point, dot, hue)
    }

    fn point(&mut self, point: impl Into<[f64; 3]>, dot: Dot, hue: Hue) -> Result<(), SpaceError> {
        let point = finite("point", point)?;
        self.camera.check(point)?;
        self.points.push((point, dot, hue));
        Ok(())
    }

    /// Adds a label of 14 px beside a point. It has a rim in the colour of the page, unless it stands on an
    /// opaque solid.
    ///
    /// # Errors
    /// [`SpaceError`] for a point that is not finite or lies behind the eye, and for a label that cannot be set.
    pub fn label(
        &mut self,
        point: impl Into<[f64; 3]>,
        side: Side,
        text: &str,
        hue: Hue,
    ) -> Result<(), SpaceError> {
        self.label_shifted(point, at(0.0, 0.0), side, text, hue)
    }

    /// Adds a label beside the page's point that lies a step away from the point, px.
    ///
    /// # Errors
    /// [`SpaceError`] as for [`Stage::label`].
    pub fn label_shifted(
        &mut self,
        point: impl Into<[f64; 3]>,
        step: Point,
        side: Side,
        text: &str,
        hue: Hue,
    ) -> Result<(), SpaceError> {
        let point = finite("point", point)?;
        finite("step on the page", [step.x, step.y, 0.0])?;
        self.camera.check(point)?;
        let label = Label::new(text, SIZE)?.placed(self.camera.land(point) + step, side, GAP);
        self.captions.push(Caption { label, hue });
        Ok(())
    }

    /// A label beyond a point in a direction of the page, centred on its ink.
    fn caption_beyond(&mut self, point: Vec3, along: Point, text: &str, hue: Hue) -> Result<(), SpaceError> {
        let label = Label::new(text, SIZE)?;
        let (ink, way) = (label.bounds, along.unit());
        // From its middle the ink reaches this far against the direction.
        let reach = (0.5 * ink.width() / way.x.abs()).min(0.5 * ink.height() / way.y.abs());
        let middle = self.camera.land(point) + way * (TIP_GAP + reach);
        let label = label.from_baseline(middle - ink.centre());
        self.captions.push(Caption { label, hue });
        Ok(())
    }
}

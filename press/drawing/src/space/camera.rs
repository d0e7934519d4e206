//! Where the eye is, and where the world lands on the page.

use super::checks::{finite, positive};
use super::ray::Ray;
use super::track::CHORDS;
use super::vector::{Place, Vec3};
use crate::flaw::Flaw;
use crate::point::{Point, at};
use std::f64::consts::FRAC_PI_2;

/// A point must be further from the eye's plane than this part of the distance between eye and target.
const NEAREST: f64 = 0.02;
/// The radius of a circle that has all its chords, px: they stay 0.05 px inside, and the curve that is written in their
/// place lies nearer.
const LARGE: f64 = 300.0;

/// How a scene is looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// The point that the eye looks at, in the world.
    pub target: [f64; 3],
    /// The direction from the target to the eye, seen from above: rad from the x axis, towards the y axis.
    pub azimuth: f64,
    /// How high the eye stands over the horizontal plane through the target, rad, from −π/2 to π/2.
    pub elevation: f64,
    /// From the target to the eye, units of the world; infinite for parallel lines of sight.
    pub distance: f64,
    /// Where the target lands on the page.
    pub centre: Point,
    /// The length of a unit of the world that lies across the line of sight at the target, px.
    pub scale: f64,
}

/// An eye with its page: a [`View`] that has been checked.
///
/// The world is right-handed and z points up. On the page x runs to the right and y downwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    target: Vec3,
    /// Unit vectors of the world: to the right and up on the page, and towards the eye.
    pub(super) right: Vec3,
    pub(super) up: Vec3,
    pub(super) back: Vec3,
    /// 1/distance, 0 for an eye at infinity: the eye's coordinate in formulas that hold for that too.
    pub(super) nearness: f64,
    centre: Point,
    scale: f64,
}

impl Camera {
    /// Checks a view.
    ///
    /// # Errors
    /// [`Flaw`] also for an elevation beyond ±π/2. Of its numbers only the distance may be infinite.
    pub fn new(view: View) -> Result<Self, Flaw> {
        let target = finite("target", view.target)?;
        finite("camera", [view.azimuth, view.elevation, 0.0])?;
        finite("page centre", [view.centre.x, view.centre.y, 0.0])?;
        let scale = positive("scale", view.scale)?;
        let nearness =
            if view.distance == f64::INFINITY { 0.0 } else { 1.0 / positive("distance", view.distance)? };
        if view.elevation.abs() > FRAC_PI_2 {
            let said = format!("the camera's elevation {} rad is not between −π/2 and π/2", view.elevation);
            return Err(Flaw::new(said));
        }
        let (sin_azimuth, cos_azimuth) = view.azimuth.sin_cos();
        let (sin_elevation, cos_elevation) = view.elevation.sin_cos();
        let right = Vec3([-sin_azimuth, cos_azimuth, 0.0]);
        let back = Vec3([cos_elevation * cos_azimuth, cos_elevation * sin_azimuth, sin_elevation]);
        let up = back.cross(right);
        Ok(Self { target, right, up, back, nearness, centre: view.centre, scale })
    }

    /// Where a point of the world lands on the page: for what is drawn there by hand, and for grips.
    pub fn on_page(&self, point: impl Place) -> Result<Point, Flaw> {
        let point = finite("point", point)?;
        self.check(point)?;
        Ok(self.land(point))
    }

    /// Where the eye is; none for an eye at infinity.
    pub(super) fn eye(&self) -> Option<Vec3> {
        (self.nearness > 0.0).then(|| self.target + self.back * (1.0 / self.nearness))
    }

    /// A point that must be seen.
    pub(super) fn check(&self, point: Vec3) -> Result<(), Flaw> {
        if self.weight(point) > NEAREST {
            return Ok(());
        }
        let [x, y, z] = point.0;
        Err(Flaw::new(format!("the point ({x}, {y}, {z}) lies behind the eye or too close to it")))
    }

    /// The page point of a point that has been checked.
    pub(super) fn land(&self, point: Vec3) -> Point {
        let [x, y, weight] = self.homogeneous(point);
        at(x / weight, y / weight)
    }

    /// Page coordinates times depth, and the depth in distances from eye to target: all linear in the point.
    pub(super) fn homogeneous(&self, point: Vec3) -> [f64; 3] {
        let (step, weight) = (point - self.target, self.weight(point));
        let x = self.centre.x * weight + self.scale * step.dot(self.right);
        let y = self.centre.y * weight - self.scale * step.dot(self.up);
        [x, y, weight]
    }

    /// How far the point lies in front of the eye's plane, in distances from eye to target.
    fn weight(&self, point: Vec3) -> f64 {
        1.0 - self.nearness * (point - self.target).dot(self.back)
    }

    /// How long a length at a point is on the page if it lies across the line of sight, px.
    pub(super) fn seen(&self, point: Vec3, length: f64) -> f64 {
        self.scale * length / self.weight(point)
    }

    /// Into how many chords a circle is divided: the smaller it is seen, the fewer, so that they stay as near to it.
    pub(super) fn chords(&self, centre: Vec3, radius: f64) -> u32 {
        let part = f64::min((self.seen(centre, radius) / LARGE).sqrt().max(0.2), 1.0); // 0.2 if it is no number
        2 * (0.5 * f64::from(CHORDS) * part).ceil() as u32
    }

    /// The direction from a point towards the eye, of a length that is linear in the point: the eye is
    /// `distance` of these steps away.
    pub(super) fn sight(&self, point: Vec3) -> Vec3 {
        self.back - (point - self.target) * self.nearness
    }

    /// The line of sight through a point of the page. It begins in the plane of the target and runs away from the eye.
    pub(super) fn ray(&self, page: Point) -> Ray {
        let step = (page - self.centre) * (1.0 / self.scale);
        let origin = self.target + self.right * step.x - self.up * step.y;
        Ray { origin, direction: -self.sight(origin) }
    }
}

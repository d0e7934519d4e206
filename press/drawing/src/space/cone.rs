//! Cones: open shells without thickness.

use super::camera::Camera;
use super::form::{Edge, Form, Part, Patch};
use super::ray::{Ray, Span, Spans, roots};
use super::rim::{self, steps};
use super::track::Track;
use super::vector::Vec3;
use crate::point::Point;
use crate::role::Fill;
use crate::shape::Shape;
use crate::simplify::{TOLERANCE, simplify};
use arrayvec::ArrayVec;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The shell of a cone from its apex to its rim, open at the rim; or half of it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cone {
    pub(super) apex: Vec3,
    pub(super) axis: Vec3,
    pub(super) across: (Vec3, Vec3),
    /// Sine and cosine of the half-angle.
    pub(super) opening: (f64, f64),
    /// From the apex to the rim along the side.
    pub(super) length: f64,
    /// The direction, across the axis, towards which half of the shell is cut away.
    pub(super) open: Option<Vec3>,
}

impl Cone {
    pub(super) fn new(apex: Vec3, axis: Vec3, half_angle: f64, length: f64) -> Self {
        Self { apex, axis, across: axis.companions(), opening: half_angle.sin_cos(), length, open: None }
    }

    /// Whether the half of a point (a step from the apex) is there.
    fn keeps(&self, step: Vec3) -> bool {
        self.open.is_none_or(|open| step.dot(open) <= 0.0)
    }

    /// The half of the rim that is there if the other is cut away: where it begins and how far it goes, rad.
    fn kept(&self) -> Option<(f64, f64)> {
        let towards = |open: Vec3| open.dot(self.across.1).atan2(open.dot(self.across.0));
        // A hair less than half a turn, as two arcs may have two pieces in common otherwise.
        self.open.map(|open| (towards(open) + FRAC_PI_2, PI.next_down()))
    }

    fn height(&self) -> f64 {
        self.length * self.opening.1
    }

    fn radius(&self) -> f64 {
        self.length * self.opening.0
    }

    fn rim_centre(&self) -> Vec3 {
        self.apex + self.axis * self.height()
    }

    /// The point of the rim at an angle.
    fn rim(&self, angle: f64) -> Vec3 {
        let (sin, cos) = angle.sin_cos();
        self.rim_centre() + (self.across.0 * cos + self.across.1 * sin) * self.radius()
    }

    /// The quadratic form of the cone as a bilinear one: zero for a vector along the side, taken twice.
    fn form(&self, first: Vec3, second: Vec3) -> f64 {
        self.axis.dot(first) * self.axis.dot(second) - self.opening.1.powi(2) * first.dot(second)
    }

    /// The arc of the rim whose generators are seen from outside: where it begins and how far it goes, rad;
    /// the rest is seen from inside. A tangent plane holds the apex, so one sight decides.
    fn outside(&self, camera: &Camera) -> (f64, f64) {
        let sight = camera.sight(self.apex);
        let level = sight.across(self.axis);
        let (sin, cos) = self.opening;
        let cosine = sin * sight.dot(self.axis) / (cos * level.length());
        let half = cosine.clamp(-1.0, 1.0).acos();
        let middle = level.dot(self.across.1).atan2(level.dot(self.across.0));
        (middle - half, 2.0 * half)
    }

    /// Where a ray meets the shell, in order, and whether from outside.
    fn meets(&self, ray: &Ray) -> ArrayVec<(f64, bool), 2> {
        let (step, direction) = (ray.origin - self.apex, ray.direction);
        let (a, b, c) = (self.form(direction, direction), self.form(step, direction), self.form(step, step));
        let mut meets: ArrayVec<(f64, bool), 2> = roots(a, b, c)
            .into_iter()
            .filter(|&t| (0.0..=self.height()).contains(&(step + direction * t).dot(self.axis)))
            .filter(|&t| self.keeps(step + direction * t))
            // Inside the cone the form is positive, so a ray that comes from outside meets it where the form grows.
            .map(|t| (t, b + a * t > 0.0))
            .collect();
        if let [first, second] = &meets[..]
            && first.0 > second.0
        {
            meets.swap(0, 1);
        }
        meets
    }
}

impl Form for Cone {
    fn name(&self) -> &'static str {
        "cone"
    }

    fn thinnest(&self) -> f64 {
        self.height().min(self.radius())
    }

    fn corners(&self) -> Vec<Vec3> {
        let (first, second) = (self.across.0 * self.radius(), self.across.1 * self.radius());
        let half = self.axis * (0.5 * self.height());
        rim::box_corners(self.apex + half, [first, second, half])
    }

    fn contains(&self, point: Vec3) -> bool {
        let step = point - self.apex;
        let height = step.dot(self.axis);
        height > 0.0 && height < self.height() && self.form(step, step) > 0.0
    }

    fn spans(&self, ray: &Ray) -> Spans {
        self.meets(ray).into_iter().map(|(t, _)| Span { enter: t, leave: t }).collect()
    }

    fn boundaries(&self, camera: &Camera, point: Vec3, values: &mut Vec<f64>) {
        let (step, sight) = (point - self.apex, camera.sight(self.apex));
        let (own, mixed, eye) = (self.form(step, step), self.form(step, sight), self.form(sight, sight));
        let shadow = rim::shadow(camera, self.rim_centre(), self.axis, self.radius(), point);
        values.extend([own, mixed * mixed - eye * own, step.dot(self.axis) - self.height(), shadow]);
        // The planes through the eye and the two cut sides.
        for angle in self.kept().into_iter().flat_map(|(from, sweep)| [from, from + sweep]) {
            values.push(step.dot(sight.cross(self.rim(angle) - self.apex)));
        }
    }

    fn edges(&self, camera: &Camera) -> Vec<Edge> {
        let (first, second) = (self.across.0 * self.radius(), self.across.1 * self.radius());
        let side = |angle: f64| Track::segment(self.apex, self.rim(angle));
        let mut edges = match self.kept() {
            None => {
                let chords = camera.chords(self.rim_centre(), self.radius());
                let rim = Track::circle(self.rim_centre(), [first, second], chords);
                vec![Edge { track: rim, outline: false }]
            }
            Some((from, sweep)) => {
                let start = self.rim(from) - self.rim_centre();
                let rim = Track::arc(self.rim_centre(), self.axis, start, sweep);
                [rim, side(from), side(from + sweep)].map(|track| Edge { track, outline: false }).to_vec()
            }
        };
        let (from, sweep) = self.outside(camera);
        if sweep > 0.0 && sweep < TAU {
            let angles = [from, from + sweep].into_iter();
            let there = angles.filter(|&angle| self.keeps(self.rim(angle) - self.apex));
            edges.extend(there.map(|angle| Edge { track: side(angle), outline: true }));
        }
        edges
    }

    fn parts(&self) -> Vec<Part> {
        vec![Part::Inside, Part::Outside]
    }

    fn enters(&self, ray: &Ray, part: &Part) -> Option<f64> {
        let wanted = *part == Part::Outside;
        self.meets(ray).into_iter().find(|&(_, outside)| outside == wanted).map(|(t, _)| t)
    }

    fn patches(&self, camera: &Camera, part: &Part) -> Vec<Patch> {
        let (from, sweep) = self.outside(camera);
        let (fill, from, sweep) = match part {
            Part::Inside => (Fill::Side, from + sweep, TAU - sweep),
            _ => (Fill::Face, from, sweep),
        };
        if sweep <= 0.0 {
            return Vec::new();
        }
        if sweep >= TAU && self.open.is_none() {
            let (first, second) = (self.across.0 * self.radius(), self.across.1 * self.radius());
            return vec![Patch { fill, shape: rim::ellipse(camera, self.rim_centre(), first, second) }];
        }
        let sector = |(from, sweep): (f64, f64)| {
            let rim: Vec<Point> =
                steps(from, sweep).into_iter().map(|angle| camera.land(self.rim(angle))).collect();
            let mut outline = vec![camera.land(self.apex)];
            outline.extend(simplify(&rim, TOLERANCE));
            Patch { fill, shape: Shape::Polygon(outline) }
        };
        rim::common_arcs((from, sweep), self.kept()).into_iter().map(sector).collect()
    }
}

//! Cones: open shells without thickness.

use super::camera::Camera;
use super::form::{Edge, Form, Part, Patch};
use super::ray::{Ray, Span, Spans, roots};
use super::rim::{Round, common_arcs};
use super::track::Track;
use super::vector::Vec3;
use crate::role::Fill;
use crate::shape::Shape;
use arrayvec::ArrayVec;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The shell of a cone from its apex to its rim, open at the rim; or half of it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cone {
    /// The axis, and the apex as its origin.
    pub(super) round: Round,
    /// Sine and cosine of the half-angle.
    opening: (f64, f64),
    /// The rim: its radius, and its height over the apex.
    radius: f64,
    height: f64,
    /// The direction, across the axis, towards which half of the shell is cut away.
    pub(super) open: Option<Vec3>,
}

impl Cone {
    /// A whole cone; `length` is measured along the side.
    pub(super) fn new(round: Round, half_angle: f64, length: f64) -> Self {
        let (sin, cos) = half_angle.sin_cos();
        Self { round, opening: (sin, cos), radius: length * sin, height: length * cos, open: None }
    }

    /// Whether the half of a point (a step from the apex) is there.
    fn keeps(&self, step: Vec3) -> bool {
        self.open.is_none_or(|open| step.dot(open) <= 0.0)
    }

    /// The half of the rim that is there if the other is cut away: where it begins and how far it goes, rad.
    fn kept(&self) -> Option<(f64, f64)> {
        // A hair less than half a turn, as two arcs may have two pieces in common otherwise.
        self.open.map(|open| (self.round.angle_of(open) + FRAC_PI_2, PI.next_down()))
    }

    /// The point of the rim at an angle.
    fn rim(&self, angle: f64) -> Vec3 {
        self.round.point(angle, self.radius, self.height)
    }

    /// The quadratic form of the cone as a bilinear one: zero for a vector along the side, taken twice.
    fn form(&self, first: Vec3, second: Vec3) -> f64 {
        let axis = self.round.axis;
        axis.dot(first) * axis.dot(second) - self.opening.1.powi(2) * first.dot(second)
    }

    /// The arc of the rim whose generators are seen from outside: where it begins and how far it goes, rad;
    /// the rest is seen from inside. A tangent plane holds the apex, so one sight decides.
    fn outside(&self, camera: &Camera) -> (f64, f64) {
        let sight = camera.sight(self.round.origin);
        let level = sight.across(self.round.axis);
        let (sin, cos) = self.opening;
        let cosine = sin * sight.dot(self.round.axis) / (cos * level.length());
        let half = cosine.clamp(-1.0, 1.0).acos();
        (self.round.angle_of(level) - half, 2.0 * half)
    }

    /// Where a ray meets the shell, in order, and whether from outside.
    fn meets(&self, ray: &Ray) -> ArrayVec<(f64, bool), 2> {
        let (step, direction) = (ray.origin - self.round.origin, ray.direction);
        let (a, b, c) = (self.form(direction, direction), self.form(step, direction), self.form(step, step));
        let mut meets: ArrayVec<(f64, bool), 2> = roots(a, b, c)
            .into_iter()
            .filter(|&t| {
                let met = step + direction * t;
                (0.0..=self.height).contains(&met.dot(self.round.axis)) && self.keeps(met)
            })
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
        self.height.min(self.radius)
    }

    fn corners(&self) -> Vec<Vec3> {
        let half = 0.5 * self.height;
        self.round.corners(self.radius, half, half)
    }

    fn contains(&self, point: Vec3) -> bool {
        let step = point - self.round.origin;
        let height = step.dot(self.round.axis);
        height > 0.0 && height < self.height && self.form(step, step) > 0.0
    }

    fn spans(&self, ray: &Ray) -> Spans {
        self.meets(ray).into_iter().map(|(t, _)| Span { enter: t, leave: t }).collect()
    }

    fn boundaries(&self, camera: &Camera, point: Vec3, values: &mut Vec<f64>) {
        let (step, sight) = (point - self.round.origin, camera.sight(self.round.origin));
        let (own, mixed, eye) = (self.form(step, step), self.form(step, sight), self.form(sight, sight));
        let shadow = self.round.shadow(camera, self.radius, self.height, point);
        values.extend([own, mixed * mixed - eye * own, step.dot(self.round.axis) - self.height, shadow]);
        // The planes through the eye and the two cut sides.
        for angle in self.kept().into_iter().flat_map(|(from, sweep)| [from, from + sweep]) {
            values.push(step.dot(sight.cross(self.rim(angle) - self.round.origin)));
        }
    }

    fn edges(&self, camera: &Camera) -> Vec<Edge> {
        let side = |angle: f64| Track::segment(self.round.origin, self.rim(angle));
        let tracks = match self.kept() {
            None => vec![self.round.circle(camera, self.radius, self.height)],
            Some((from, sweep)) => {
                let centre = self.round.centre(self.height);
                let rim = Track::arc(centre, self.round.axis, self.rim(from) - centre, sweep);
                vec![rim, side(from), side(from + sweep)]
            }
        };
        let mut edges: Vec<Edge> = tracks.into_iter().map(|track| Edge { track, outline: false }).collect();
        let (from, sweep) = self.outside(camera);
        if sweep > 0.0 && sweep < TAU {
            let angles = [from, from + sweep].into_iter();
            let there = angles.filter(|&angle| self.keeps(self.rim(angle) - self.round.origin));
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
            return vec![Patch { fill, shape: self.round.ellipse(camera, self.radius, self.height) }];
        }
        let sector = |arc: (f64, f64)| {
            let mut outline = vec![camera.land(self.round.origin)];
            outline.extend(self.round.arc(camera, self.radius, self.height, arc));
            Patch { fill, shape: Shape::Polygon(outline) }
        };
        common_arcs((from, sweep), self.kept()).into_iter().map(sector).collect()
    }
}

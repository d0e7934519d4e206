//! The picture: the drum with its load in a tub, between posts on a floor.

use super::course::{Course, Kick, State};
use live::prelude::*;
use nalgebra::Complex;
use std::f64::consts::FRAC_PI_4;

/// The unit of length is the radius of the drum. In it, the place of the load, and the length of a metre of swing: five
/// times that of a metre of the drum.
const LOAD: f64 = 0.82;
const METRE: f64 = 5.0 * LOAD / 0.25;
/// The length of a newton in it, and of a metre a second of a kick.
const FORCE: f64 = 0.01;
const KICK: f64 = 2.0;
/// The outer radius of the tub; the heights of its upper rim, of springs, and of the floor.
const TUB: f64 = 1.17;
const RIM: f64 = 0.02;
const MOUNT: f64 = -0.25;
const FLOOR: f64 = -0.55;

const ORIGIN: Complex<f64> = Complex::new(0.0, 0.0);

/// The machine at a moment, and the eye that looks at it. Places on the floor are complex numbers.
pub(super) struct Drum<'a> {
    course: &'a Course,
    time: f64,
    state: &'a State,
    on_drum: bool,
    camera: Camera,
    /// The azimuth of the eye: a rider's turns with the drum.
    eye: f64,
    /// How far the posts stand from O: room for the widest swing and for springs.
    posts: f64,
    /// The place of the shaft.
    shaft: Complex<f64>,
}

impl<'a> Drum<'a> {
    pub(super) fn new(
        course: &'a Course,
        state: &'a State,
        on_drum: bool,
        widest: f64,
        moment: &Moment,
    ) -> Result<Self, Cause> {
        let posts = (TUB + 0.4 + widest * METRE).max(2.5);
        let eye = moment.azimuth + if on_drum { state.azimuth } else { 0.0 };
        let (centre, scale) = moment.room.of((at(196.0, 216.0), 186.0), (at(190.0, 144.0), 142.0));
        let seen = moment.seen_from(eye, moment.elevation);
        let camera = seen.camera([0.0; 3], 14.0, centre, scale / posts)?;
        let shaft = state.shaft.position * METRE;
        Ok(Self { course, time: moment.time, state, on_drum, camera, eye, posts, shaft })
    }

    /// A place at a height on the page: all of them lie in front of the eye, which is far away.
    fn land(&self, place: Complex<f64>, height: f64) -> Point {
        self.camera.on_page([place.re, place.im, height]).unwrap_or_default()
    }

    /// The place at the height of the rim that is seen at a point. The eye is far away, so that the page is nearly a linear
    /// map of the floor.
    fn under(&self, point: Point) -> Complex<f64> {
        let mut place = self.shaft;
        for _ in 0..4 {
            let here = self.land(place, RIM);
            let [x, y] = [Complex::ONE, Complex::I].map(|step| self.land(place + step, RIM) - here);
            let (off, area) = (point - here, x.x * y.y - x.y * y.x);
            place += Complex::new(off.x * y.y - off.y * y.x, x.x * off.y - x.y * off.x) / area;
        }
        place
    }

    /// Where a hand takes hold of the tub, in its middle, and of the load, and how far around, px.
    pub(super) fn bodies(&self) -> Vec<(Point, f64)> {
        let load = self.state.load() * LOAD;
        vec![(self.land(self.shaft, RIM), 36.0), (self.land(self.shaft + load, RIM), 24.0)]
    }

    /// How far a hand has drawn the middle of the tub from where it is, m of swing.
    pub(super) fn pulled(&self, to: Point) -> Complex<f64> {
        (self.under(to) - self.shaft) / METRE
    }

    /// By which angle a hand has turned the load about O, and with it all that goes round steadily.
    pub(super) fn turned(&self, to: Point) -> f64 {
        (self.under(to) * (self.shaft + self.state.load() * LOAD).conj()).arg()
    }

    /// A level arc, with points closer together on a large one.
    fn arc(&self, centre: Complex<f64>, height: f64, radius: f64, from: f64, sweep: f64) -> Vec<Point> {
        let count = (2.0 + 8.0 * sweep.abs() * radius.sqrt()).ceil();
        let mut points = Vec::new();
        for n in 0..=count as u32 {
            let way = Complex::from_polar(radius, from + sweep * f64::from(n) / count);
            points.push(self.land(centre + way, height));
        }
        points
    }

    pub(super) fn draw(&self, drawing: &mut Drawing) -> Result<(), Cause> {
        self.draw_room(drawing);
        self.draw_suspension(drawing);
        if self.course.rotor.damping_rate_on_board() > 0.0 {
            self.draw_friction_on_board(drawing);
        }
        self.draw_tub(drawing);
        self.draw_load(drawing);
        self.draw_ways(drawing)?;
        self.draw_angle(drawing)?;
        self.draw_forces(drawing)
    }

    fn draw_room(&self, drawing: &mut Drawing) {
        let floor = self.posts + 0.12;
        drawing.polygon(self.arc(ORIGIN, FLOOR, floor, 0.0, TAU), Fill::Floor, Hue::Ink);
        let lines = (floor / 0.6) as i32;
        for n in -lines..=lines {
            let x = 0.6 * f64::from(n);
            let half = (floor * floor - x * x).sqrt();
            for along in [Complex::new(1.0, 0.0), Complex::new(0.0, 1.0)] {
                let [from, to] = [-half, half].map(|y| self.land(along * Complex::new(x, y), FLOOR));
                drawing.line(from, to, Stroke::Grid, Hue::Ink);
            }
        }
    }

    /// The posts, and between them and the tub springs and, if they resist the whole velocity, dampers.
    fn draw_suspension(&self, drawing: &mut Drawing) {
        // What is alike is drawn together, and is one element of the page.
        let ways = [0.0, 1.0, 2.0, 3.0].map(|side| Complex::from_polar(1.0, FRAC_PI_4 + FRAC_PI_2 * side));
        let [feet, heads] =
            [FLOOR, MOUNT + 0.1].map(|height| ways.map(|way| self.land(way * self.posts, height)));
        for foot in feet {
            drawing.dot(foot, 4.5, Hue::Muted);
        }
        for (foot, head) in feet.into_iter().zip(heads) {
            drawing.line(foot, head, Stroke::Curve, Hue::Ink);
        }
        for head in heads {
            drawing.dot(head, 3.0, Hue::Ink);
        }
        let [springs, dampers] = [0.13, -0.13].map(|aside| {
            ways.map(|way| {
                let aside = way * Complex::new(0.0, aside);
                [way * self.posts, self.shaft + way * TUB].map(|place| self.land(place + aside, MOUNT))
            })
        });
        for [from, to] in springs {
            kit::spring(drawing, from, to, 5, 8.0, 0.06 * (to - from).length(), Hue::Ink);
        }
        if !self.course.is_radial {
            kit::dampers(drawing, &dampers, 0.42, 8.0, Hue::Ink);
        }
    }

    /// The ring that turns with the drum, and two dampers between it and the tub.
    fn draw_friction_on_board(&self, drawing: &mut Drawing) {
        let ring = self.posts - 0.3;
        drawing.polyline(&self.arc(ORIGIN, MOUNT, ring, 0.0, TAU), Stroke::Outline, Hue::Orange);
        let dampers = [FRAC_PI_2, -FRAC_PI_2].map(|side| {
            let way = Complex::from_polar(1.0, self.state.azimuth + side);
            [way * ring, self.shaft + way * TUB].map(|place| self.land(place, MOUNT))
        });
        for [from, _] in dampers {
            drawing.dot(from, 3.4, Hue::Orange);
        }
        kit::dampers(drawing, &dampers, 0.5, 8.0, Hue::Orange);
    }

    /// The tub with the drum in it.
    fn draw_tub(&self, drawing: &mut Drawing) {
        let ring = |radius: f64| self.arc(self.shaft, RIM, radius, 0.0, TAU);
        // The wall is seen between the near half of its foot and the far half of its rim.
        let mut wall = self.arc(self.shaft, FLOOR + 0.1, TUB, self.eye - FRAC_PI_2, PI);
        wall.extend(self.arc(self.shaft, RIM, TUB, self.eye + FRAC_PI_2, PI));
        let faces = [
            (wall, Fill::Side, Hue::Muted),
            (ring(TUB), Fill::Face, Hue::Muted),
            (ring(1.07), Fill::Side, Hue::Muted),
            (ring(1.0), Fill::Face, Hue::Blue),
        ];
        for (mut face, fill, hue) in faces {
            drawing.polygon(face.clone(), Fill::Page, hue);
            drawing.polygon(face.clone(), fill, hue);
            face.extend(face.first().copied());
            drawing.polyline(&face, Stroke::Outline, hue);
        }
    }

    /// The load, a mat on the rim of the drum, and holes by which one sees it turn.
    fn draw_load(&self, drawing: &mut Drawing) {
        let State { azimuth, .. } = *self.state;
        for hole in 1..8 {
            let hole = self.shaft + Complex::from_polar(LOAD, azimuth + TAU * f64::from(hole) / 8.0);
            drawing.polygon(self.arc(hole, RIM, 0.05, 0.0, TAU), Fill::Side, Hue::Blue);
        }
        let mut mat = self.arc(self.shaft, RIM, 0.97, azimuth - 0.36, 0.72);
        mat.extend(self.arc(self.shaft, RIM, 0.67, azimuth + 0.36, -0.72));
        drawing.polygon(mat, Fill::Solid, Hue::Blue);
    }

    /// The steady circle, and the ways of shaft and centre of mass.
    fn draw_ways(&self, drawing: &mut Drawing) -> Result<(), Cause> {
        let (course, state) = (self.course, self.state);
        let steady =
            super::steady(&course.machine, course.is_radial).map_or(0.0, |steady| steady.radius() * METRE);
        if course.driven.is_none() && steady > 0.05 && steady < self.posts {
            drawing.polyline(&self.arc(ORIGIN, RIM, steady, 0.0, TAU), Stroke::Reference, Hue::Muted);
        }
        let turns = if course.is_kicked(self.time) { 1.8 } else { 0.8 };
        let turn = TAU / state.spin.max(course.machine.natural_frequency());
        let length = if self.on_drum { 2.0 } else { turns * turn };
        let steps = (length * state.spin.max(10.0) / 0.2).ceil();
        let (mut way, mut mass_way) = (Vec::new(), Vec::new());
        for n in 0..=steps as u32 {
            let then = self.time - length * (1.0 - f64::from(n) / steps);
            if then >= 0.0 {
                let then = course.at(then)?;
                let scale =
                    if self.on_drum { state.load() * then.load().conj() * METRE } else { METRE.into() };
                way.push(self.land(then.shaft.position * scale, RIM));
                let mass = then.shaft.position + then.load() * course.machine.offset();
                mass_way.push(self.land(mass * scale, RIM));
            }
        }
        if !self.on_drum {
            drawing.polyline(&mass_way, Stroke::Orbit, Hue::Ink);
        }
        drawing.polyline(&way, Stroke::Vector, Hue::Blue);
        Ok(())
    }

    /// The shaft, the tub, the drum and the load of the motion that is kept to compare.
    pub(super) fn draw_kept(&self, kept: &State, drawing: &mut Drawing) {
        let (shaft, azimuth) = (kept.shaft.position * METRE, kept.azimuth);
        for radius in [TUB, 1.0, 0.04] {
            drawing.polyline(&self.arc(shaft, RIM, radius, 0.0, TAU), Stroke::Pale, Hue::Ink);
        }
        let mut mat = self.arc(shaft, RIM, 0.97, azimuth - 0.36, 0.72);
        mat.extend(self.arc(shaft, RIM, 0.67, azimuth + 0.36, -0.72));
        mat.push(mat[0]);
        drawing.polyline(&mat, Stroke::Pale, Hue::Ink);
    }

    /// The line from O through the shaft, that from the shaft to the load, and the angle by which it leads.
    fn draw_angle(&self, drawing: &mut Drawing) -> Result<(), Cause> {
        let (shaft, load) = (self.shaft, self.state.load());
        let [origin, middle] = [ORIGIN, shaft].map(|place| self.land(place, RIM));
        let length = (middle - origin).length();
        if self.course.is_radial && length > 30.0 {
            kit::damper(drawing, origin, middle, 0.5, 9.0, Hue::Ink);
        }
        if shaft.norm() > 0.1 {
            let beyond = self.land(shaft * (1.0 + 0.62 / shaft.norm()), RIM);
            drawing.line(origin, beyond, Stroke::Outline, Hue::Ink);
            let (azimuth, lead) = (shaft.arg(), self.state.lead());
            drawing.polyline(&self.arc(shaft, RIM, 0.42, azimuth, lead), Stroke::Outline, Hue::Ink);
            let name = self.land(shaft + Complex::from_polar(0.58, azimuth + 0.72 * lead), RIM);
            drawing.label(name, Side::Over, r"$\phi_0$", Hue::Ink)?;
        }
        drawing.line(middle, self.land(shaft + load * 0.67, RIM), Stroke::Vector, Hue::Blue);
        Ok(())
    }

    /// The force on the floor, shaft and centre of mass, how the drum turns, and for a moment the kick.
    fn draw_forces(&self, drawing: &mut Drawing) -> Result<(), Cause> {
        let origin = self.land(ORIGIN, RIM);
        let force = self.course.force(self.state) * FORCE;
        let force = force * (0.94 * self.posts / force.norm().max(1e-9)).min(1.0);
        if force.norm() > 0.05 {
            let tip = self.land(force, RIM);
            kit::arrow(drawing, origin, tip, Hue::Purple);
            let beyond = tip + (tip - origin).unit() * 12.0;
            drawing.label(beyond, Side::Over, r"$\boldsymbol{F}$", Hue::Purple)?;
        }
        let mass = self.shaft + self.state.load() * (self.course.machine.offset() * METRE);
        kit::marker(drawing, self.land(mass, RIM), Marker::Mass, Hue::Ink);
        kit::marker(drawing, self.land(self.shaft, RIM), Marker::Ring, Hue::Ink);
        for arm in [Complex::new(0.09, 0.0), Complex::new(0.0, 0.09)] {
            drawing.line(self.land(-arm, RIM), self.land(arm, RIM), Stroke::Curve, Hue::Ink);
        }
        drawing.label(origin + at(-10.0, 12.0), Side::Over, "$O$", Hue::Ink)?;
        if self.state.spin > 0.0 {
            let turn = self.arc(self.shaft, RIM, TUB + 0.13, self.eye + FRAC_PI_2 + 0.25, 0.5);
            if let [line @ .., neck, tip] = &turn[..] {
                drawing.polyline(line, Stroke::Vector, Hue::Orange);
                kit::head(drawing, *tip, *tip - *neck, 1.0, Hue::Orange);
            }
        }
        let is_seen = |kick: &&Kick| (0.0..0.12).contains(&(self.time - kick.0)) && kick.1.norm() > 0.0;
        if let Some((_, change)) = self.course.kicks.iter().rev().find(is_seen) {
            let (way, length) = (change / change.norm(), KICK * change.norm());
            let places = [length, 0.0].map(|before| self.land(self.shaft - way * (TUB + before), RIM));
            kit::arrow(drawing, places[0], places[1], Hue::Pink);
            let beyond = self.land(self.shaft - way * (TUB + length + 0.1), RIM);
            drawing.label(beyond, Side::Over, "kick", Hue::Pink)?;
        }
        Ok(())
    }
}

//! Lines divided into what is seen and what is hidden.
//!
//! Along a straight line the boundaries between the two are zeros of polynomials of second degree, which
//! every solid names ([`Form::boundaries`]); between neighbouring zeros one ray from the middle to the eye
//! decides. A smooth curve is treated chord by chord, with rays from the curve itself, as the chord would lie
//! inside the body that the curve runs on; the boundary is then found on the curve by bisection.

use super::camera::Camera;
use super::form::Form;
use super::order::put_in_order;
use super::ray::{Ray, zeros};
use super::track::Track;
use super::vector::Vec3;
use crate::point::{Point, Rect};
use std::mem;

/// What lies this little behind a surface counts as lying on it, in least thicknesses of the solid.
const SURFACE: f64 = 3e-3;
/// Pieces shorter than this are joined to their neighbours, px: nobody sees them, and rounding makes some.
const SHORTEST: f64 = 1.2;
/// A chord on which a boundary's polynomial is nowhere larger, in least thicknesses of the solid, lies on that boundary
/// and does not cross it: its zeros are rounding's, and others on another machine.
const ROUNDING: f64 = 1e-12;
/// Chords from which a smooth curve bends away by less than this, px, are treated as one. What goes less than a fourth of it
/// past a straight outline may be missed: then neither the ends of the chords lie there nor their middle.
const BEND: f64 = 0.9;
/// How often the piece of a chord in which a boundary lies is halved: to a hundred-thousandth of a pixel.
const HALVINGS: u32 = 20;

/// What hides a point from the eye.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sight {
    Seen,
    /// A solid other than the line's own.
    BehindOther,
    /// The solid to which the line belongs.
    BehindSelf,
}

/// A piece of a line, all seen or all hidden; parameters count chords.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Run {
    pub(super) sight: Sight,
    pub(super) from: f64,
    pub(super) to: f64,
    /// Parameters inside, near the two ends, at which the sight was decided.
    pub(super) probes: (f64, f64),
}

/// A solid as something that may hide lines.
pub(super) struct Shield<'a> {
    pub(super) form: &'a dyn Form,
    /// Whether it hides at all: a ghost does not.
    pub(super) is_solid: bool,
    /// The part of the page that it can hide.
    bounds: Rect,
}

impl<'a> Shield<'a> {
    pub(super) fn new(form: &'a dyn Form, is_solid: bool, camera: &Camera) -> Self {
        let corners = form.corners().into_iter().map(|corner| camera.land(corner));
        Self { form, is_solid, bounds: Rect::around(corners).unwrap_or_default().grown(1.0) }
    }

    /// Whether the solid stands between a point and the eye. A point on its surface, or just below, is not hidden by
    /// it. No solid is behind the eye, so what is met on the way to it hides.
    pub(super) fn hides(&self, camera: &Camera, point: Vec3) -> bool {
        if !self.bounds.contains(camera.land(point)) {
            return false;
        }
        let direction = camera.sight(point);
        let surface = SURFACE * self.form.thinnest() / direction.length();
        let spans = self.form.spans(&Ray { origin: point, direction });
        spans.iter().any(|span| span.leave > surface)
    }
}

/// The pieces of a line, given all solids, and what hides a point of the line.
pub(super) fn runs(
    track: &Track,
    camera: &Camera,
    shields: &[Shield<'_>],
    judge: impl Fn(Vec3) -> Sight,
) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut room = vec![Boundaries::default(); shields.len()];
    let mut chord = 0;
    while chord < track.chords() {
        let count = nearly_one(track, chord, camera);
        let ends = breaks(track, [chord, chord + count], camera, shields, &mut room);
        for pair in ends.as_deref().unwrap_or(&[0.0, 1.0]).windows(2) {
            let [from, to, probe] =
                [pair[0], pair[1], 0.5 * (pair[0] + pair[1])].map(|part| chord as f64 + count as f64 * part);
            // What is far from all solids is seen.
            let sight = if ends.is_none() { Sight::Seen } else { judge(track.at(probe)) };
            match runs.last_mut() {
                Some(last) if last.sight == sight => (last.to, last.probes.1) = (to, probe),
                _ => runs.push(Run { sight, from, to, probes: (probe, probe) }),
            }
        }
        chord += count;
    }
    if track.smooth {
        for index in 1..runs.len() {
            let (before, after) = (runs[index - 1], runs[index]);
            let boundary = bisect(before.probes.1, after.probes.0, |at| judge(track.at(at)) == before.sight);
            (runs[index - 1].to, runs[index].from) = (boundary, boundary);
        }
    }
    join_short(track, camera, &mut runs);
    runs
}

/// How many chords from this one on are so nearly one that they are treated as one.
fn nearly_one(track: &Track, chord: usize, camera: &Camera) -> usize {
    let is_near = |&count: &usize| {
        let Some(&end) = track.points.get(chord + count) else { return false };
        let (middle, bend) = (track.points[chord + count / 2], track.points[chord].towards(end, 0.5));
        camera.seen(middle, (middle - bend).length()) < BEND
    };
    if track.smooth { [4, 2].into_iter().find(is_near).unwrap_or(1) } else { 1 }
}

/// Room to work in: the values that a solid's boundaries have at both ends of a chord and in its middle.
#[derive(Debug, Clone, Default)]
struct Boundaries {
    start: Vec<f64>,
    middle: Vec<f64>,
    end: Vec<f64>,
    /// The point at which the chord ends whose values these are.
    end_point: Option<usize>,
}

/// The fractions of the chord between two points at which what hides it may change, from 0 to 1, in order; none if no
/// solid is near.
fn breaks(
    track: &Track,
    [from, to]: [usize; 2],
    camera: &Camera,
    shields: &[Shield<'_>],
    room: &mut [Boundaries],
) -> Option<Vec<f64>> {
    let (start, end) = (track.points[from], track.points[to]);
    let seen =
        Rect::around([start, end].map(|point| camera.land(point))).unwrap_or_default().grown(1.0 + BEND);
    let mut breaks: Option<Vec<f64>> = None;
    for (shield, room) in shields.iter().zip(room) {
        if !shield.bounds.overlaps(&seen) {
            continue;
        }
        let value = |values: &mut Vec<f64>, point: Vec3| {
            values.clear();
            shield.form.boundaries(camera, point, values);
        };
        // One chord ends where the next begins.
        if room.end_point == Some(from) {
            mem::swap(&mut room.start, &mut room.end);
        } else {
            value(&mut room.start, start);
        }
        value(&mut room.middle, start.towards(end, 0.5));
        value(&mut room.end, end);
        room.end_point = Some(to);
        let breaks = breaks.get_or_insert_with(|| vec![0.0, 1.0]);
        let nothing = ROUNDING * shield.form.thinnest();
        for ((&first, &second), &third) in room.start.iter().zip(&room.middle).zip(&room.end) {
            if [first, second, third].iter().any(|value| value.abs() > nothing) {
                breaks.extend(zeros(first, second, third));
            }
        }
    }
    if let Some(breaks) = breaks.as_mut().filter(|breaks| breaks.len() > 2) {
        put_in_order(breaks, |part| *part);
        breaks.dedup_by(|later, earlier| *later - *earlier < 1e-12);
        // Of two that nearly coincide the first stays; the end must be the end.
        if let Some(last) = breaks.last_mut() {
            *last = 1.0;
        }
    }
    breaks
}

/// Where a condition that holds at `yes` and not at `no` ceases to hold.
fn bisect(mut yes: f64, mut no: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (yes + no);
        *(if holds(middle) { &mut yes } else { &mut no }) = middle;
    }
    0.5 * (yes + no)
}

/// Joins what is too short to be seen to the longer of its neighbours.
fn join_short(track: &Track, camera: &Camera, runs: &mut Vec<Run>) {
    while runs.len() > 1 {
        let lengths: Vec<f64> = runs.iter().map(|run| length(&landed(track, camera, run))).collect();
        let shortest = (0..runs.len()).min_by(|&a, &b| lengths[a].total_cmp(&lengths[b]));
        let Some(short) = shortest.filter(|&index| lengths[index] < SHORTEST) else { return };
        let before = short.checked_sub(1).map_or(-1.0, |index| lengths[index]);
        let after = lengths.get(short + 1).copied().unwrap_or(-1.0);
        runs[short].sight = runs[if before > after { short - 1 } else { short + 1 }].sight;
        runs.dedup_by(|later, earlier| {
            let same = later.sight == earlier.sight;
            if same {
                (earlier.to, earlier.probes.1) = (later.to, later.probes.1);
            }
            same
        });
    }
}

/// The piece as points of the page.
pub(super) fn landed(track: &Track, camera: &Camera, run: &Run) -> Vec<Point> {
    let (first, last) = (run.from.floor() as usize + 1, run.to.ceil() as usize);
    let mut points = vec![camera.land(track.at(run.from))];
    points.extend(track.points.get(first..last).unwrap_or(&[]).iter().map(|&point| camera.land(point)));
    points.push(camera.land(track.at(run.to)));
    points
}

/// The length of a polyline, px.
pub(super) fn length(points: &[Point]) -> f64 {
    points.windows(2).map(|pair| (pair[1] - pair[0]).length()).sum()
}

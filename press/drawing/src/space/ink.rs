//! The lines of a scene, seen and hidden, as shapes of the page.

use super::camera::Camera;
use super::curve::{Curve, Hiding};
use super::form::Form;
use super::hide::{Run, Shield, Sight, landed, length, runs};
use super::pierce::Junction;
use super::solid::Solid;
use super::track::Track;
use super::vector::Vec3;
use crate::drawing::Drawing;
use crate::kit::{self, HEAD, Heads, size};
use crate::point::Point;
use crate::role::{Hue, Role, Stroke};
use crate::shape::Shape;

/// A curve with its looks.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stroked {
    pub(super) curve: Curve,
    pub(super) stroke: Stroke,
    pub(super) heads: Heads,
    pub(super) hue: Hue,
}

/// All lines, the hidden ones apart: they are painted first.
pub(super) struct Ink<'a> {
    camera: &'a Camera,
    /// All solids.
    shields: Vec<Shield<'a>>,
    hidden: Vec<(Role, Shape)>,
    seen: Vec<(Role, Shape)>,
    heads: Vec<(Point, Point, f64, Hue)>,
}

/// A piece of a line on the page, and whether it is seen.
struct Piece {
    seen: bool,
    points: Vec<Point>,
}

impl<'a> Ink<'a> {
    pub(super) fn new(camera: &'a Camera, forms: Vec<(&'a dyn Form, bool)>) -> Self {
        let shield = |(form, is_solid): (&'a dyn Form, bool)| Shield::new(form, is_solid, camera);
        let shields = forms.into_iter().map(shield).collect();
        Self { camera, shields, hidden: Vec::new(), seen: Vec::new(), heads: Vec::new() }
    }

    /// Whether any solid stands before a point.
    pub(super) fn hidden(&self, point: Vec3) -> bool {
        self.shields.iter().any(|shield| shield.is_solid && shield.hides(self.camera, point))
    }

    /// The edges and the outline of a solid, and the lines where it passes through others.
    pub(super) fn solid(&mut self, index: usize, solid: &Solid, junctions: &[Vec<Junction>], hue: Hue) {
        let others = |point: Vec3| {
            let mut others = self.shields.iter().enumerate().filter(|&(other, _)| other != index);
            others.any(|(_, other)| other.is_solid && other.hides(self.camera, point))
        };
        let own = &self.shields[index];
        let stroke = if own.is_solid { Stroke::Outline } else { Stroke::Pale };
        let mut found: Vec<(Track, Vec<Run>)> = Vec::new();
        for edge in own.form.edges(self.camera) {
            let judge = |point: Vec3| {
                if !edge.outline && own.hides(self.camera, point) {
                    Sight::BehindSelf
                } else if others(point) {
                    Sight::BehindOther
                } else {
                    Sight::Seen
                }
            };
            let runs = runs(&edge.track, self.camera, &self.shields, judge);
            found.push((edge.track, runs));
        }
        for junction in junctions.iter().flatten() {
            let judge = |point: Vec3| if self.hidden(point) { Sight::BehindSelf } else { Sight::Seen };
            let runs = runs(&junction.track, self.camera, &self.shields, judge);
            found.push((junction.track.clone(), runs));
        }
        for (track, runs) in found {
            let dashed = |sight: Sight| solid.dashed && sight == Sight::BehindOther;
            let kept: Vec<Run> =
                runs.into_iter().filter(|run| run.sight == Sight::Seen || dashed(run.sight)).collect();
            let pieces = self.pieces(&track, &kept);
            self.put(pieces, stroke, Stroke::Hidden, hue);
        }
    }

    /// A curve with its heads.
    pub(super) fn line(&mut self, line: &Stroked) {
        let Stroked { curve: Curve { track, hiding }, stroke, heads, hue } = line;
        let judge = |point: Vec3| {
            if *hiding != Hiding::Ignored && self.hidden(point) { Sight::BehindOther } else { Sight::Seen }
        };
        let mut pieces = self.pieces(track, &runs(track, self.camera, &self.shields, judge));
        let whole: f64 = pieces.iter().map(|piece| length(&piece.points)).sum();
        let ends = if *heads == Heads::Both { 2.0 } else { 1.0 };
        let scale = size(*stroke).min(0.5 * whole / (HEAD.0 * ends));
        if *heads != Heads::None {
            self.head(&mut pieces, scale, *hiding, *hue);
        }
        if *heads == Heads::Both {
            turn(&mut pieces);
            self.head(&mut pieces, scale, *hiding, *hue);
            turn(&mut pieces);
        }
        if *hiding == Hiding::Omitted {
            pieces.retain(|piece| piece.seen);
        }
        let hidden = if *hiding == Hiding::Pale { Stroke::Pale } else { Stroke::Hidden };
        self.put(pieces, *stroke, hidden, *hue);
    }

    /// Shortens the line at its end by what the head covers, and puts the head there.
    fn head(&mut self, pieces: &mut Vec<Piece>, scale: f64, hiding: Hiding, hue: Hue) {
        let Some(last) = pieces.last() else { return };
        let (seen, Some(&tip)) = (last.seen, last.points.last()) else { return };
        let mut covered = (HEAD.0 - HEAD.2) * scale;
        while let Some(piece) = pieces.last_mut() {
            let here = length(&piece.points);
            if here > covered {
                shorten(&mut piece.points, covered);
                break;
            }
            covered -= here;
            pieces.pop();
        }
        let Some(&neck) = pieces.last().and_then(|piece| piece.points.last()) else { return };
        if seen {
            self.heads.push((tip, tip - neck, scale, hue));
        } else if hiding == Hiding::Dashed {
            let along = (tip - neck).unit();
            let (back, across) =
                (tip - along * (HEAD.0 * scale), along.quarter_turned() * (0.5 * HEAD.1 * scale));
            let barbs = Shape::Polyline(vec![back + across, tip, back - across]);
            self.hidden.push((Role::Line(Stroke::Hidden, hue), barbs));
        }
    }

    /// The pieces of a line on the page. Of a closed line, the last joins the first if both are seen or both
    /// are hidden.
    fn pieces(&self, track: &Track, runs: &[Run]) -> Vec<Piece> {
        let joins = runs.len() > 1
            && track.closed()
            && runs[0].from == 0.0
            && runs[runs.len() - 1].to == track.chords() as f64
            && runs[0].sight == runs[runs.len() - 1].sight;
        let piece =
            |run: &Run| Piece { seen: run.sight == Sight::Seen, points: landed(track, self.camera, run) };
        let mut pieces: Vec<Piece> = runs.iter().map(piece).collect();
        if joins && let Some(mut last) = pieces.pop() {
            last.points.extend(pieces[0].points.iter().skip(1));
            pieces[0] = last;
        }
        pieces
    }

    fn put(&mut self, pieces: Vec<Piece>, stroke: Stroke, hidden: Stroke, hue: Hue) {
        for piece in pieces {
            let mut points = piece.points;
            let closed = points.len() > 3 && points.first() == points.last();
            let shape = if closed {
                points.pop();
                Shape::Polygon(points)
            } else {
                Shape::Polyline(points)
            };
            if piece.seen {
                self.seen.push((Role::Line(stroke, hue), shape));
            } else {
                self.hidden.push((Role::Line(hidden, hue), shape));
            }
        }
    }

    /// Hidden lines first, then those that are seen, then the heads.
    pub(super) fn write(self, drawing: &mut Drawing) {
        for (role, shape) in self.hidden.into_iter().chain(self.seen) {
            drawing.push(role, shape);
        }
        for (tip, direction, scale, hue) in self.heads {
            kit::head(drawing, tip, direction, scale, hue);
        }
    }
}

/// Turns a line about, so that it begins at its end.
fn turn(pieces: &mut [Piece]) {
    pieces.reverse();
    pieces.iter_mut().for_each(|piece| piece.points.reverse());
}

/// Takes a length off the end of a polyline that is longer.
fn shorten(points: &mut Vec<Point>, mut by: f64) {
    while let [.., before, last] = points[..] {
        let step = (last - before).length();
        points.pop();
        if step > by {
            points.push(last.towards(before, by / step));
            return;
        }
        by -= step;
    }
}

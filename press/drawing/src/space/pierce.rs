//! Rods that pierce other solids: the lines where they enter and leave, and what of them stands outside.

use super::form::{Belt, Form, Part};
use super::order::put_in_order;
use super::ray::Ray;
use super::track::{CHORDS, Track};
use super::tube::Tube;
use super::vector::Vec3;
use std::f64::consts::TAU;

/// Ends of a rod closer than this to a surface only touch it, in lengths of the rod.
const TOUCH: f64 = 1e-6;

/// A closed line where the wall of a rod passes through a surface.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Junction {
    pub(super) track: Track,
    /// The same line as heights along the rod.
    belt: Belt,
    /// Which way the rod passes, seen along its axis.
    pub(super) passage: Passage,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Passage {
    Enters,
    Leaves,
    /// Through a shell without thickness.
    Crosses,
}

/// Where a rod passes with its whole wall through the surface of another solid, in order along the rod.
///
/// The wall's straight lines are followed one by one. If some miss the other solid, as where one rod grazes
/// another, there is no junction.
pub(super) fn junctions(rod: &Tube, other: &dyn Form) -> Vec<Junction> {
    let length = 2.0 * rod.half;
    let inside = TOUCH..1.0 - TOUCH;
    let mut lines: Vec<Vec<(Passage, Vec3)>> = Vec::new();
    for index in 0..CHORDS {
        let origin = rod.round.point(TAU * f64::from(index) / f64::from(CHORDS), rod.outer, -rod.half);
        let ray = Ray { origin, direction: rod.round.axis * length };
        let mut line = Vec::new();
        for span in other.spans(&ray) {
            let shell = span.enter == span.leave;
            let ends = if shell {
                vec![(Passage::Crosses, span.enter)]
            } else {
                vec![(Passage::Enters, span.enter), (Passage::Leaves, span.leave)]
            };
            line.extend(
                ends.into_iter().filter(|(_, at)| inside.contains(at)).map(|(how, at)| (how, ray.at(at))),
            );
        }
        if lines.first().is_some_and(|first| !first.iter().map(|end| end.0).eq(line.iter().map(|end| end.0)))
        {
            return Vec::new();
        }
        lines.push(line);
    }
    let ends = lines.first().map_or(0, Vec::len);
    let junction = |end: usize| {
        let mut points: Vec<Vec3> = lines.iter().map(|line| line[end].1).collect();
        let belt = Belt(points.iter().map(|&point| (point - rod.round.origin).dot(rod.round.axis)).collect());
        points.extend(points.first().copied());
        Junction { track: Track { points, smooth: true }, belt, passage: lines[0][end].0 }
    };
    (0..ends).map(junction).collect()
}

/// The parts of a rod that stand outside all solids that it pierces, cut along its junctions. If nothing is
/// pierced, the whole rod.
pub(super) fn parts(pierced: &[Vec<Junction>]) -> Vec<Part> {
    let starts_in = |junctions: &&Vec<Junction>| {
        junctions.first().is_some_and(|junction| junction.passage == Passage::Leaves)
    };
    let mut depth = pierced.iter().filter(starts_in).count();
    let mut ends: Vec<&Junction> = pierced.iter().flatten().collect();
    if ends.is_empty() {
        return vec![Part::Whole];
    }
    let height = |junction: &Junction| junction.belt.0.iter().sum::<f64>();
    put_in_order(&mut ends, |junction| height(junction));
    let mut parts = Vec::new();
    let mut low = None;
    for junction in ends {
        let belt = Some(junction.belt.clone());
        if depth == 0 && junction.passage != Passage::Leaves {
            parts.push(Part::Between(low, belt.clone()));
        }
        match junction.passage {
            Passage::Enters => depth += 1,
            Passage::Leaves => depth = depth.saturating_sub(1),
            Passage::Crosses => {}
        }
        low = belt;
    }
    if depth == 0 {
        parts.push(Part::Between(low, None));
    }
    parts
}

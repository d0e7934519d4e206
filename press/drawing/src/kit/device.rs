//! Springs, dampers and fixed points.

use crate::drawing::Drawing;
use crate::point::Point;
use crate::role::{Fill, Hue, Stroke};
use std::f64::consts::TAU;

/// A coil spring from a point to a point: straight leads, then `turns` coils `width` px across, seen from the side.
pub fn spring(drawing: &mut Drawing, from: Point, to: Point, turns: u32, width: f64, lead: f64, hue: Hue) {
    let (step, along) = (to - from, (to - from).unit());
    let across = along.quarter_turned();
    let radius = 0.5 * width;
    // A helix seen at a slant: each coil swings back a little along the axis, which makes the loops.
    let slant = 0.7 * radius;
    let coils = step.length() - 2.0 * lead - 2.0 * slant;
    let steps = 16 * turns;
    let mut points = vec![from];
    for index in 0..=steps {
        let part = f64::from(index) / f64::from(steps);
        let phase = TAU * f64::from(turns) * part;
        let forward = lead + slant * (1.0 - phase.cos()) + coils * part;
        points.push(from + along * forward + across * (radius * phase.sin()));
    }
    points.push(to);
    drawing.polyline(&points, Stroke::Outline, hue);
}

/// A damper from a point to a point: a cylinder, `length` of the way long and `width` px across, open towards the second end,
/// from which the rod with its piston comes.
pub fn damper(drawing: &mut Drawing, from: Point, to: Point, length: f64, width: f64, hue: Hue) {
    dampers(drawing, &[[from, to]], length, width, hue);
}

/// Dampers that do not cover one another, each from a point to a point. On a page all their cylinders are one element, and so
/// are all their lines.
pub fn dampers(drawing: &mut Drawing, ends: &[[Point; 2]], length: f64, width: f64, hue: Hue) {
    let parts = ends.iter().map(|&[from, to]| {
        let step = to - from;
        let along = |part: f64| from + step * (0.5 * (1.0 - length) + part * length);
        (step.unit().quarter_turned() * (0.5 * width), along(0.0), along(0.55), along(1.0))
    });
    let parts: Vec<_> = parts.collect();
    for &(half, bottom, _, mouth) in &parts {
        drawing.polygon(vec![bottom + half, mouth + half, mouth - half, bottom - half], Fill::Page, hue);
    }
    for &(half, bottom, piston, _) in &parts {
        drawing.polygon(vec![bottom + half, piston + half, piston - half, bottom - half], Fill::Face, hue);
    }
    for (&[from, to], &(half, bottom, piston, mouth)) in ends.iter().zip(&parts) {
        drawing.line(from, bottom, Stroke::Outline, hue);
        drawing.polyline(&[mouth + half, bottom + half, bottom - half, mouth - half], Stroke::Outline, hue);
        drawing.line(piston, to, Stroke::Outline, hue);
    }
    for &(half, _, piston, _) in &parts {
        drawing.line(piston + half * 0.72, piston - half * 0.72, Stroke::Vector, hue);
    }
}

/// A fixed wall: a line of this length through a point, hatched on the side to which `behind` (rad) points.
pub fn ground(drawing: &mut Drawing, point: Point, behind: f64, length: f64, hue: Hue) {
    let back = Point::polar(1.0, behind);
    let along = back.quarter_turned();
    let (spacing, depth) = (5.0, 6.0);
    drawing.line(point - along * (0.5 * length), point + along * (0.5 * length), Stroke::Outline, hue);
    let count = (length / spacing).floor();
    let mut offset = -0.5 * count * spacing;
    while offset < 0.5 * length - 0.5 * spacing {
        let foot = point + along * (offset + spacing);
        drawing.line(foot, foot + back * depth - along * depth, Stroke::Hatch, hue);
        offset += spacing;
    }
}

//! The tip of axis 3 of any free body: how it gets its place, and where it goes.

use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Finish, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Cause, Outcome, Plot, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// The direction of L in the body of the example on the page.
const DIRECTION: [f64; 3] = [0.6, 0.0, 0.8];
/// The angle of the last turn, as drawn, rad.
const LAST: f64 = 2.25;

/// Axis 3 and L before, between and after the two turns of the attitude.
pub(crate) fn two_turns(id: &str) -> Outcome {
    let direction = Vector3::from(DIRECTION);
    let upright = UnitQuaternion::rotation_between(&direction, &Vector3::z()).ok_or("L is not upright")?;
    let last = UnitQuaternion::from_scaled_axis(Vector3::z() * LAST) * upright;
    let mut panels = Vec::new();
    for (step, (attitude, below, words)) in [
        (
            UnitQuaternion::identity(),
            "(a) before",
            "A globe of directions. Axis 3 points up, axis 1 to the right; the direction of L leans by 37 degrees from axis 3 towards axis 1.",
        ),
        (
            upright,
            r"(b) after $R_{\boldsymbol{\ell}}$",
            "The direction of L points up. Axis 3 leans by 37 degrees to the left. A dotted line drops from its tip to a dot in the level plane, z.",
        ),
        (
            last,
            r"(c) after the turn by $\delta$",
            "L points up as before. Axis 3 and the dot have been turned about L by the angle delta, counter-clockwise from above.",
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let mut drawing = Drawing::new("", 196.0, 250.0).titled(below, words);
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0, 0.0, 0.2],
            azimuth: -1.25,
            elevation: 0.42,
            distance: 9.0,
            centre: at(96.0, 118.0),
            scale: 64.0,
        })?);
        stage.solid(Solid::sphere([0.0; 3], 1.0)?.finish(Finish::Ghost), Hue::Muted)?;
        let level = Curve::circle([0.0; 3], [0.0, 0.0, 1.0], 1.0)?;
        stage.curve(level.hiding(Hiding::Pale), Stroke::Outline, Hue::Muted)?;
        let [axis, momentum] = [Vector3::z(), direction].map(|vector| attitude * vector);
        let mut arrow = |tip: Vector3<f64>, name: &str, side: Side, hue: Hue| -> Result<(), Cause> {
            let shaft = Curve::segment([0.0; 3], tip)?.hiding(Hiding::Ignored);
            stage.arrow(shaft, Stroke::Vector, Heads::End, hue)?;
            Ok(stage.label(tip, side, name, hue)?)
        };
        let side = if step == 0 { Side::Above } else { Side::AboveLeft };
        arrow(axis * 1.3, r"$\hat{\mathbf{3}}$", if step == 2 { Side::BelowRight } else { side }, Hue::Ink)?;
        let side = if step == 0 { Side::AboveRight } else { Side::Above };
        let name = if step == 0 { r"$\boldsymbol{\ell}$" } else { r"$\boldsymbol{L}$" };
        arrow(momentum * 1.3, name, side, Hue::Green)?;
        if step == 0 {
            arrow(Vector3::x() * 1.3, r"$\hat{\mathbf{1}}$", Side::Right, Hue::Ink)?;
            let arc = Curve::between([0.0; 3], axis, momentum, 0.8)?.hiding(Hiding::Ignored);
            stage.curve(arc, Stroke::Outline, Hue::Ink)?;
        } else {
            // The tip on the globe, and z below it.
            let foot = Vector3::new(axis.x, axis.y, 0.0);
            stage.curve(Curve::segment(axis, foot)?.hiding(Hiding::Ignored), Stroke::Dotted, Hue::Muted)?;
            stage.dot_in_front(axis, 3.0, Hue::Ink)?;
            stage.dot_in_front(foot, 3.5, Hue::Ink)?;
            stage.label(foot, Side::Right, "$z$", Hue::Ink)?;
            if step == 2 {
                let before = upright * Vector3::z();
                let before = Vector3::new(before.x, before.y, 0.0);
                let way = linear_steps(0.06, 0.92, 40)
                    .map(|part| UnitQuaternion::from_scaled_axis(Vector3::z() * (LAST * part)) * before);
                let way = Curve::smooth(way)?.hiding(Hiding::Ignored);
                stage.arrow(way, Stroke::Outline, Heads::End, Hue::Ink)?;
                let middle = UnitQuaternion::from_scaled_axis(Vector3::z() * (0.45 * LAST)) * before;
                stage.label(middle * 0.55, Side::Over, r"$\delta$", Hue::Ink)?;
            }
        }
        stage.write(&mut drawing);
        drawing.label(at(96.0, 234.0), Side::Over, below, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels))
}

/// The free body of the judge on the page, in a room whose third axis lies along L.
fn example() -> Result<FreeTop, Cause> {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
    let omega_body = Vector3::new(0.6, 0.0, 1.0);
    let momentum = moments.angular_momentum(&omega_body);
    let world_from_body =
        UnitQuaternion::rotation_between(&momentum, &Vector3::z()).ok_or("L is not upright")?;
    Ok(FreeTop::new(moments, Turning { world_from_body, omega_body })?)
}

/// The path of the tip along L, and what the last turn does beyond a steady one.
pub(crate) fn tip_path(id: &str) -> Outcome {
    let top = example()?;
    let period = top.period().ok_or("it swings")?;
    let states = linear_steps(0.0, 2.0, 2000)
        .map(|periods| top.at(periods * period))
        .collect::<Result<Vec<Turning>, InvalidQuantity>>()?;
    let path: Vec<(f64, f64)> =
        states.iter().map(|state| (state.axis_3_world().x, state.axis_3_world().y)).collect();
    // −(ℓ₁ + iℓ₂), eq:tip.
    let opposite: Vec<(f64, f64)> = states
        .iter()
        .map(|state| {
            let momentum = top.moments().angular_momentum(&state.omega_body).normalize();
            (-momentum.x, -momentum.y)
        })
        .collect();
    Ok(Drawing::panels(id, vec![from_above(&path)?, beyond_steady(&path, &opposite)?]))
}

/// The heading of each place, rad, continuous from the first on.
fn headings(places: &[(f64, f64)]) -> Vec<f64> {
    let mut headings = vec![places[0].1.atan2(places[0].0)];
    for pair in places.windows(2) {
        let [from, to] = [pair[0], pair[1]].map(|(x, y)| y.atan2(x));
        let step = (to - from + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
        headings.push(headings[headings.len() - 1] + step);
    }
    headings
}

fn from_above(path: &[(f64, f64)]) -> Outcome {
    let mut drawing = Drawing::new("", 270.0, 320.0).titled(
        "The tip of axis 3 along L",
        "Seen along L, the tip of axis 3 goes round L, counter-clockwise, on a curve of loops that bulge, between two dashed circles. The first period is heavy \
         and has a dot at its beginning and at its end.",
    );
    let middle = at(135.0, 140.0);
    let mut plot = Plot::plane(&mut drawing, middle, 150.0, 0.85)?;
    let distance = |&(x, y): &(f64, f64)| x.hypot(y);
    let least = path.iter().map(distance).fold(f64::INFINITY, f64::min);
    let most = path.iter().map(distance).fold(0.0, f64::max);
    for (name, radius) in [("innermost", least), ("outermost", most)] {
        let circle = linear_steps(0.0, TAU, 180).map(|angle| (radius * angle.cos(), radius * angle.sin()));
        plot.curve(name, circle, Stroke::Reference, Hue::Muted);
    }
    plot.curve("tip", path[1000..].iter().copied(), Stroke::Axis, Hue::Muted);
    plot.curve("first-period", path[..=1000].iter().copied(), Stroke::Curve, Hue::Ink);
    plot.markers(&[path[0], path[1000]], Marker::Disc, Hue::Ink);
    let [before, here] = [plot.at(path[400]), plot.at(path[412])];
    kit::head(&mut drawing, here, here - before, 1.0, Hue::Ink);
    kit::marker(&mut drawing, middle, Marker::Out, Hue::Green);
    drawing.label(middle + at(4.0, 4.0), Side::BelowRight, r"$\boldsymbol{L}$", Hue::Green)?;
    drawing.label(at(135.0, 300.0), Side::Over, r"(a) the tip of $\hat{\mathbf{3}}$", Hue::Ink)?;
    Ok(drawing)
}

fn beyond_steady(path: &[(f64, f64)], opposite: &[(f64, f64)]) -> Outcome {
    let mut drawing = Drawing::new("", 300.0, 320.0).titled(
        "Two headings beyond a steady turn",
        "Two headings, each less its steady growth, in degrees, against time in periods, from 0 to 2. Both are waves with two swings in a period, and they lie nearly on each other.",
    );
    let time = Axis::linear(0.0, 2.0, 0.5).titled("time, in periods");
    let value = Axis::linear(-30.0, 30.0, 10.0).titled("beyond the steady turn, degrees");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 230.0, 204.0), time, value)?;
    plot.level(0.0, Stroke::Reference);
    for (name, places, stroke, hue) in
        [("tip-heading", path, Stroke::Heavy, Hue::Faint), ("body-heading", opposite, Stroke::Axis, Hue::Ink)]
    {
        let headings = headings(places);
        let steady = (headings[1000] - headings[0]) / 1000.0;
        let values = headings.iter().enumerate().map(|(n, heading)| {
            (n as f64 / 1000.0, (heading - headings[0] - steady * n as f64).to_degrees())
        });
        plot.curve(name, values, stroke, hue);
    }
    drawing.label(at(159.0, 300.0), Side::Over, "(b) its heading", Hue::Ink)?;
    Ok(drawing)
}

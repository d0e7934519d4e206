//! Rotation about the middle axis: where ω goes in a body, and a bat that flips.

use crate::scenes::middle_axis::{BAT, draw_bat};
use drawing::kit::Heads;
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Side, Stroke, at};
use figures::{Cause, Outcome, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};

/// The moments of the body on Poinsot's ellipsoid.
const FLAT: [f64; 3] = [1.0, 2.0, 3.0];
/// Where polhodes begin, in the plane of axes 1 and 3, degrees from axis 1 after the ellipsoid is made a sphere.
const BEGIN: [f64; 6] = [14.0, 27.0, 38.0, 52.0, 63.0, 76.0];
/// The one that is seen to roll.
const ROLLS: f64 = 38.0;

/// A free body, turning with 2T = 1, that begins so many degrees from axis 1.
fn begun(degrees: f64) -> Result<FreeTop, Cause> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let omega_body = Vector3::new(cos, 0.0, sin).component_div(&Vector3::from(FLAT).map(f64::sqrt));
    let [i1, i2, i3] = FLAT;
    let moments = PrincipalMoments::new(i1, i2, i3)?;
    let momentum = moments.angular_momentum(&omega_body);
    let downwards = UnitQuaternion::rotation_between(&momentum, &-Vector3::z()).ok_or("L is not upright")?;
    Ok(FreeTop::new(moments, Turning { world_from_body: downwards, omega_body })?)
}

/// Polhodes on Poinsot's ellipsoid, and the ellipsoid as it rolls.
pub(crate) fn polhodes(id: &str) -> Outcome {
    let mut left = Drawing::new("", 430.0, 376.0).titled(
        "Polhodes",
        "An ellipsoid, longest along axis 1. Closed curves on it go round the end of axis 1, named the hill, others round axis 3, the valley. Round the end of axis 2, the pass, there is none: \
         two curves cross there, the separatrix, and divide the others.",
    );
    let semi_axes = FLAT.map(|moment| 1.0 / moment.sqrt());
    let [e1, e2, e3] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0; 3],
        azimuth: 1.18,
        elevation: 0.42,
        distance: 9.0,
        centre: at(215.0, 188.0),
        scale: 162.0,
    })?);
    stage.solid(Solid::ellipsoid([0.0; 3], [e1, e2, e3], semi_axes)?, Hue::Blue)?;
    for degrees in BEGIN {
        let top = begun(degrees)?;
        let period = top.period().ok_or("a polhode closes")?;
        for sign in [1.0, -1.0] {
            let path = linear_steps(0.0, period, 360)
                .map(|time| Ok(sign * top.at(time)?.omega_body))
                .collect::<Result<Vec<_>, InvalidQuantity>>()?;
            stage.curve(Curve::smooth(path)?.hiding(Hiding::Omitted), Stroke::Curve, Hue::Orange)?;
        }
    }
    // The separatrix, L² = 2T I₂: two plane cuts through axis 2.
    let [i1, i2, i3] = FLAT;
    let slope = (i1 * (i2 - i1) / (i3 * (i3 - i2))).sqrt();
    for sign in [1.0, -1.0] {
        let aside = Vector3::new(1.0, 0.0, sign * slope);
        let aside = aside / (i1 + i3 * slope * slope).sqrt();
        let path =
            linear_steps(0.0, TAU, 360).map(|angle| aside * angle.cos() + e2 * (semi_axes[1] * angle.sin()));
        stage.curve(Curve::smooth(path)?.hiding(Hiding::Omitted), Stroke::Border, Hue::Ink)?;
    }
    for (axis, semi_axis, name) in [
        (e1, semi_axes[0], r"hill, $\hat{\mathbf{1}}$"),
        (e2, semi_axes[1], r"pass, $\hat{\mathbf{2}}$"),
        (e3, semi_axes[2], r"valley, $\hat{\mathbf{3}}$"),
    ] {
        let beyond = if axis == e2 { 0.62 } else { 0.34 };
        stage.named_vector(axis * semi_axis, axis * (semi_axis + beyond), name, Hue::Ink)?;
    }
    stage.write(&mut left);

    let mut right = Drawing::new("", 430.0, 376.0).titled(
        "The ellipsoid rolls",
        "The same ellipsoid on a level floor, which it touches from above. The angular velocity points from its centre down to the point of contact, the angular \
         momentum straight down. A closed curve on the ellipsoid passes through the point of contact, and so does a wavy curve that winds about a circle on the floor.",
    );
    let top = begun(ROLLS)?;
    let (period, moment) = (top.period().ok_or("a polhode closes")?, 0.62);
    let now = top.at(moment)?;
    let attitude = now.world_from_body;
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, -0.35],
        azimuth: -0.9,
        elevation: 0.24,
        distance: 9.0,
        centre: at(215.0, 188.0),
        scale: 156.0,
    })?);
    let floor = now.omega_world().z;
    stage.ground([-0.9, -0.9], [0.9, 0.9], floor, 0.2)?;
    stage
        .solid(Solid::ellipsoid([0.0; 3], [e1, e2, e3].map(|axis| attitude * axis), semi_axes)?, Hue::Blue)?;
    let polhode = linear_steps(0.0, period, 360)
        .map(|time| Ok(attitude * top.at(time)?.omega_body))
        .collect::<Result<Vec<_>, InvalidQuantity>>()?;
    stage.curve(Curve::smooth(polhode)?.hiding(Hiding::Pale), Stroke::Curve, Hue::Orange)?;
    let herpolhode = linear_steps(moment - period, moment + 0.5 * period, 720)
        .map(|time| Ok(top.at(time)?.omega_world()))
        .collect::<Result<Vec<_>, InvalidQuantity>>()?;
    stage.curve(Curve::smooth(herpolhode)?.hiding(Hiding::Pale), Stroke::Curve, Hue::Orange)?;
    let (omega, momentum) = (now.omega_world(), Vector3::z() * (floor - 0.32));
    for (tip, place, side, name, hue) in [
        (omega, omega * 0.5, Side::Left, r"$\boldsymbol{\omega}$", Hue::Orange),
        (momentum, momentum, Side::Below, r"$\boldsymbol{L}$", Hue::Green),
    ] {
        let arrow = Curve::segment([0.0; 3], tip)?.hiding(Hiding::Ignored);
        stage.arrow(arrow, Stroke::Vector, Heads::End, hue)?;
        stage.label_shifted(place, at(0.0, 2.0), side, name, hue)?;
    }
    stage.write(&mut right);
    Ok(Drawing::panels(id, vec![left, right]))
}

/// A bat that flips while it goes round once, in five stills, a quarter of a turn apart.
pub(crate) fn bat_flip(id: &str) -> Outcome {
    let [i1, i2, i3] = BAT;
    let moments = PrincipalMoments::new(i1, i2, i3)?;
    // On the separatrix, half-way through the flip; L points at the reader, more or less.
    let lean = (i1 * (i3 - i2) / (i3 * (i2 - i1))).sqrt().atan();
    let momentum_body = Vector3::new(lean.sin(), 0.0, -lean.cos());
    let omega_body = moments.angular_velocity(&(i2 * momentum_body));
    let towards =
        UnitQuaternion::rotation_between(&momentum_body, &-Vector3::y()).ok_or("L is not opposite")?;
    let half_way = FreeTop::new(moments, Turning { world_from_body: towards, omega_body })?;
    // Thrown level.
    let thrown = half_way.at(-PI)?.world_from_body * Vector3::x();
    let level = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), thrown.z.atan2(thrown.x));
    let mut panels = Vec::new();
    for (quarters, name) in [
        (0.0, "thrown"),
        (1.0, r"$\tfrac14$ turn"),
        (2.0, r"$\tfrac12$ turn"),
        (3.0, r"$\tfrac34$ turn"),
        (4.0, "caught"),
    ] {
        let now = half_way.at((0.5 * quarters - 1.0) * PI)?;
        let attitude = level * now.world_from_body;
        let [along, normal] = [Vector3::x(), Vector3::z()].map(|axis| attitude * axis);
        let mut drawing = Drawing::new("", 190.0, 250.0).titled(
            &format!("The bat {quarters} quarter turns after the throw"),
            "A bat in the air with one side pink, an arrow for its angular velocity and one for its angular momentum, which stands still.",
        );
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0; 3],
            azimuth: -1.12,
            elevation: 0.42,
            distance: 14.0,
            centre: at(95.0, 112.0),
            scale: 46.0,
        })?);
        draw_bat(&mut stage, along, -normal)?;
        let omega = level * now.omega_world();
        for (tip, name, hue) in [
            (-Vector3::y() * 2.3, r"$\boldsymbol{L}$", Hue::Green),
            (omega * 1.9, r"$\boldsymbol{\omega}$", Hue::Orange),
        ] {
            stage.vector([0.0; 3], tip, hue)?;
            if quarters == 2.0 {
                stage.label(tip, Side::Left, name, hue)?;
            }
        }
        stage.write(&mut drawing);
        drawing.label(at(95.0, 232.0), Side::Over, name, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels).titled(
        "A bat flips",
        "Five stills of a bat that is thrown to turn head over heels, a quarter turn apart. It is thrown level with its pink side up; while it goes round \
         once it also turns over about its handle, and arrives almost level with its pink side down.",
    ))
}

//! The figures of the pages without a number.

use crate::{Cause, Outcome};
use drawing::kit::Heads;
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Side, Stroke, at};
use mechanics::rolling::{DiskParameters, MomentFactors};
use mechanics::scenes::rolling_wheel::Wheel;
use nalgebra::Vector3;

/// What each colour stands for, on a wheel that rolls round a circle.
pub(crate) fn colours(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 320.0).titled(
        "What the colours stand for",
        "A wheel, blue, leans inward on a table and rolls round. From its centre come its axes 1, 2 and 3 in the colour of the text, \
         its angular velocity omega in orange, and its angular momentum L in green, which lies nearer to the axle. A pink dot marks \
         the contact with the table, and from it the force of the table points up and inward, in purple.",
    );
    let (lean, b) = (0.5_f64, 1.0);
    let wheel = Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments: MomentFactors::DISK, gravity: 1.0 })?;
    let steady = wheel.steady(lean, b)?;
    // Outward along y and up along z, as in the chapter of the wheel.
    let (sin, cos) = lean.sin_cos();
    let axes = [Vector3::x(), Vector3::new(0.0, -sin, cos), Vector3::new(0.0, -cos, -sin)];
    let centre = Vector3::new(0.0, b, cos);
    let contact = centre - axes[1];
    let in_room = |body: Vector3<f64>| axes[0] * body.x + axes[1] * body.y + axes[2] * body.z;
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.9, 0.7],
        azimuth: -1.1,
        elevation: 0.32,
        distance: 12.0,
        centre: at(190.0, 170.0),
        scale: 88.0,
    })?);
    stage.ground([-1.5, -0.5], [1.5, 2.5], 0.0, 0.5)?;
    stage.solid(Solid::ring(centre, axes[2], 1.0, 0.86, 0.12)?, Hue::Blue)?;
    for (axis, length, name) in [
        (axes[0], 1.3, r"$\hat{\mathbf{1}}$"),
        (axes[1], 1.35, r"$\hat{\mathbf{2}}$"),
        (axes[2], 0.8, r"$\hat{\mathbf{3}}$"),
    ] {
        stage.named_vector(centre, centre + axis * length, name, Hue::Ink)?;
    }
    let omega = in_room(steady.omega());
    let momentum = in_room(steady.angular_momentum());
    let force = Vector3::new(0.0, -steady.friction_needed(), 1.0);
    let mut named = |from: Vector3<f64>, way: Vector3<f64>, length: f64, side: Side, name: &str, hue: Hue| {
        let tip = from + way.normalize() * length;
        let arrow = Curve::segment(from, tip)?.hiding(Hiding::Ignored);
        stage.arrow(arrow, Stroke::Vector, Heads::End, hue)?;
        stage.label(tip, side, name, hue)?;
        Ok::<(), Cause>(())
    };
    named(centre, omega, 2.1, Side::Left, r"angular velocity $\boldsymbol{\omega}$", Hue::Orange)?;
    named(centre, momentum, 1.8, Side::Left, r"angular momentum $\boldsymbol{L}$", Hue::Green)?;
    named(contact, force, 0.55, Side::Right, "force", Hue::Purple)?;
    stage.dot_in_front(contact, 4.5, Hue::Pink)?;
    stage.label_shifted(contact, at(2.0, 6.0), Side::BelowRight, "contact", Hue::Pink)?;
    let rim = centre + axes[0] * 0.6 + axes[1] * 0.8;
    stage.label_shifted(rim, at(0.0, 0.0), Side::AboveRight, "body", Hue::Blue)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

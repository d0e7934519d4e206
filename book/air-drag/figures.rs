//! The figures of the chapter "Frisbee and pencil".

use crate::{Axis, Outcome, Plot, linear_steps};
use drawing::kit::{Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use mechanics::InvalidQuantity;
use mechanics::euler::Turning;
use mechanics::inertia::{Body, PrincipalMoments};
use mechanics::integrate::Dop853;
use mechanics::scenes::air_drag::{Drag, DraggedTop, Parameters};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// A body with I₁ = 1 and a ratio of the moments, under the same drag about all axes.
fn body(ratio: f64, drag: f64, omega_body: Vector3<f64>) -> Result<DraggedTop, InvalidQuantity> {
    let (moments, drag) = (PrincipalMoments::symmetric(1.0, ratio)?, Drag::isotropic(drag));
    DraggedTop::new(Parameters { moments, drag, omega_body })
}

/// A flat and a long body, and the way that drag sends the angular velocity.
pub(crate) fn two_bodies(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 660.0, 350.0).titled(
        "Where drag sends the angular velocity",
        "Left a flat disc, right a pencil, each with its axis 3 upright and an angular velocity omega at an angle theta to it. A heavy curve from \
         the tip of omega bends towards the axis for the disc, and away from it, down to the horizontal, for the pencil.",
    );
    let flat = Solid::disc([0.0; 3], Vector3::z(), 1.0, 0.14)?;
    let long = Solid::rod([0.0, 0.0, -1.1], [0.0, 0.0, 1.1], 0.085)?;
    for (x, ratio, solid) in [(170.0, 2.0, flat), (490.0, 0.4, long)] {
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0, 0.0, 0.2],
            azimuth: -1.25,
            elevation: 0.3,
            distance: 9.0,
            centre: at(x, 190.0),
            scale: 88.0,
        })?);
        stage.solid(solid, Hue::Blue)?;
        // The direction of ω in the plane through the axis; its turning about the axis is left out.
        let top = body(ratio, 1.0, Vector3::new(0.6, 0.0, 1.0))?;
        let length = 1.45;
        let path = linear_steps(0.0, 2.2, 120)
            .map(|time| {
                let (sin, cos) = top.axis_angle(time)?.sin_cos();
                Ok([length * sin, 0.0, length * cos])
            })
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        let start = path[0];
        let travelled = Curve::smooth(path)?.hiding(Hiding::Ignored);
        stage.named_vector([0.0; 3], [0.0, 0.0, 1.75], r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        stage.vector([0.0; 3], start, Hue::Orange)?;
        let (shift, side) =
            if ratio > 1.0 { (at(4.0, 2.0), Side::Right) } else { (at(-2.0, -4.0), Side::AboveLeft) };
        stage.label_shifted(start, shift, side, r"$\boldsymbol{\omega}$", Hue::Orange)?;
        stage.arrow(travelled, Stroke::Curve, Heads::End, Hue::Orange)?;
        stage.angle([0.0; 3], Vector3::z(), start, 0.75, r"$\theta$", Hue::Ink)?;
        stage.write(&mut drawing);
    }
    drawing.label(at(170.0, 338.0), Side::Over, r"flat: $\theta \to 0$", Hue::Ink)?;
    drawing.label(at(490.0, 338.0), Side::Over, r"long: $\theta \to 90°$", Hue::Ink)?;
    Ok(drawing)
}

/// The tangent of the angle against time, on a logarithmic scale.
pub(crate) fn tangent(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 350.0).titled(
        "Tangent of the angle against time",
        "The tangent of the angle between the angular velocity and the body's axis on a logarithmic scale, against time times C over \
         I1, from 0 to 6. Three straight lines from 0.3: for a thin disc falling by a factor of twenty, for a ball level, \
         for a thick rod rising by a factor of four hundred.",
    );
    let time = Axis::linear(0.0, 6.0, 1.0)?.minor(0.2).titled(r"time $Ct/I_1$");
    let value = Axis::log(1e-3, 1e3, 1)?.titled(r"$\tan\theta$");
    let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 34.0, 470.0, 262.0), time, value)?;
    plot.level(1.0, Stroke::Dotted);
    for (ratio, hue, side, name) in [
        (2.0, Hue::Blue, Side::Right, r"thin disc, $I_3 = 2I_1$"),
        (1.0, Hue::Green, Side::Right, "ball"),
        (0.5, Hue::Orange, Side::Right, r"rod, $I_3 = \tfrac12I_1$"),
    ] {
        let top = body(ratio, 1.0, Vector3::new(0.3, 0.0, 1.0))?;
        let values = linear_steps(0.0, 6.0, 60)
            .map(|t| Ok((t, top.axis_angle(t)?.tan())))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        let end = values.last().copied().ok_or("a curve has an end")?;
        plot.curve(&format!("ratio-{ratio}"), values, Stroke::Curve, hue);
        plot.label(end, side, name, hue)?;
    }
    plot.label((0.1, 1.0), Side::AboveRight, r"$\theta = 45°$", Hue::Muted)?;
    Ok(drawing)
}

/// The tangent of the angle against the spin that is left.
pub(crate) fn spin_tangent(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 350.0).titled(
        "Tangent of the angle against the spin that is left",
        "The tangent of the angle, divided by that at the start, against the spin divided by that at the start, from 0 to 1. All curves \
         end at one, one. For a thin disc it is the straight line through the origin; for a ratio of the moments of one and \
         a half a square root; for a ball level at one; \
         for a ratio of a half it rises without limit as the spin goes to zero.",
    );
    let spin = Axis::linear(0.0, 1.0, 0.2)?.minor(0.05).titled(r"spin that is left $\omega_3/\omega_{3,0}$");
    let value = Axis::linear(0.0, 2.0, 0.5)?.minor(0.1).titled(r"$\tan\theta/\tan\theta_0$");
    let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 34.0, 470.0, 262.0), spin, value)?;
    for (ratio, hue) in [(2.0, Hue::Blue), (1.5, Hue::Pink), (1.0, Hue::Green), (0.5, Hue::Orange)] {
        let top = body(ratio, 1.0, Vector3::new(1.0, 0.0, 1.0))?;
        // Evenly spaced in the spin: its logarithm is the time.
        let values = linear_steps(1e-4, 1.0, 300)
            .map(|left| {
                let time = -left.ln() * ratio;
                Ok((top.at(time)?.z, top.axis_angle(time)?.tan()))
            })
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(&format!("ratio-{ratio}"), values, Stroke::Curve, hue);
    }
    plot.label((0.47, 0.4), Side::BelowRight, r"$I_3/I_1 = 2$", Hue::Blue)?;
    plot.label((0.2, 0.47), Side::AboveLeft, r"$\tfrac32$", Hue::Pink)?;
    plot.label((0.62, 1.0), Side::Above, "1", Hue::Green)?;
    plot.label((0.4, 1.6), Side::AboveRight, r"$\tfrac12$", Hue::Orange)?;
    Ok(drawing)
}

/// The angular velocity across the axis, as seen from the body: a spiral with a finite number of turns.
pub(crate) fn wobble_turns(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 420.0, 400.0).titled(
        "The angular velocity spirals in with a finite number of turns",
        "The component omega 2 against omega 1 in the body. The curve begins at one on the axis of omega 1, winds inwards \
         counter-clockwise \
         and reaches the origin along a dashed line after exactly three turns in all.",
    );
    // Three turns in all: (I₃ − I₁) I₃ ω₃ / (2π I₁ C) = 3 with I₃ = 2 I₁.
    let drag = 2.0 / (3.0 * TAU) * 1.0;
    let top = body(2.0, drag, Vector3::new(1.0, 0.0, 1.0))?;
    let across = || Axis::linear(-1.0, 1.0, 0.5).map(|axis| axis.minor(0.1));
    let (x, y) = (across()?.titled(r"$\omega_1$"), across()?.titled(r"$\omega_2$"));
    let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 320.0, 320.0), x, y)?;
    let times: Vec<f64> = linear_steps(0.0, 12.0 / drag, 4000).collect();
    let values = top.sample(&times)?.into_iter().map(|omega| (omega.x, omega.y));
    // The direction of arrival, from the number of turns.
    let (sin, cos) = (TAU * top.total_body_turns()).sin_cos();
    plot.reference((0.0, 0.0), (cos, sin), Stroke::Reference);
    plot.curve("spiral", values, Stroke::Curve, Hue::Orange);
    plot.markers(&[(1.0, 0.0)], Marker::Disc, Hue::Orange);
    plot.label((0.98, 0.02), Side::AboveLeft, "start", Hue::Orange)?;
    Ok(drawing)
}

/// The tip of the axis and the direction of the angular momentum, seen along the angular momentum at the start.
pub(crate) fn axis_path(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 420.0, 400.0).titled(
        "Paths of the axis and of the angular momentum",
        "Seen along the angular momentum at the start. The tip of the axis begins at the left, at a distance of 0.15, and spirals in \
         about ten times; the direction of the angular momentum stays within a small distance of the middle.",
    );
    let moments = Body::thin_disk(0.175, 0.137)?.moments();
    let (drag, omega_body) = (Drag::isotropic(2e-3), Vector3::new(12.0, 0.0, 40.0));
    let top = DraggedTop::new(Parameters { moments, drag, omega_body })?;
    // Stand so that the angular momentum is upright at the start.
    let momentum = moments.angular_momentum(&omega_body);
    let upright =
        UnitQuaternion::rotation_between(&momentum, &Vector3::z()).ok_or("L is not opposite to z")?;
    let times: Vec<f64> = linear_steps(0.0, 6.0, 6000).collect();
    let states = top.thrown(upright, &Dop853::new(1e-10)?)?.sample(&times)?;
    let axis: Vec<(f64, f64)> = states.iter().map(Turning::axis_3_world).map(|n| (n.x, n.y)).collect();
    let momenta: Vec<(f64, f64)> = states
        .iter()
        .map(|state| state.angular_momentum_world(&moments).normalize())
        .map(|l| (l.x, l.y))
        .collect();
    let across = || Axis::linear(-0.16, 0.16, 0.08).map(|axis| axis.minor(0.02));
    let (x, y) = (across()?.titled("$x$"), across()?.titled("$y$"));
    let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 34.0, 320.0, 320.0), x, y)?;
    plot.curve("axis", axis.iter().copied(), Stroke::Orbit, Hue::Blue);
    plot.curve("momentum", momenta.iter().copied(), Stroke::Curve, Hue::Green);
    plot.markers(&axis[..1], Marker::Disc, Hue::Blue);
    plot.label((-0.145, 0.145), Side::Right, r"tip of $\hat{\mathbf{3}}$", Hue::Blue)?;
    plot.label((0.155, 0.145), Side::Left, r"$\hat{\boldsymbol{L}}$, in the middle", Hue::Green)?;
    Ok(drawing)
}

/// The relative error of the angle by the inverse cosine and by the arctangent of the two parts, against its
/// own exponential.
pub(crate) fn drag_fault(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 350.0).titled(
        "Error of the angle by the inverse cosine",
        "The relative error on a logarithmic scale against the angle, also logarithmic, from one radian down to 1e-12. By the inverse \
         cosine it rises from 1e-16 as the inverse square of the angle and reaches one near 1e-8, where the curve ends. \
         By the arctangent of the two parts it stays below 1e-15.",
    );
    let top = body(2.0, 1.0, Vector3::new(1.0, 0.0, 1.0))?;
    let (mut naive, mut better) = (Vec::new(), Vec::new());
    for t in linear_steps(1.0, 55.0, 90) {
        let omega = top.at(t)?;
        let cosine = (omega.z / omega.norm()).acos();
        let exact = top.axis_angle(t)?;
        if cosine > 0.0 {
            naive.push((exact, (cosine / exact - 1.0).abs().max(1e-17)));
        }
        let tangent = omega.x.hypot(omega.y).atan2(omega.z);
        better.push((exact, (tangent / exact - 1.0).abs().max(1e-17)));
    }
    let angle = Axis::log(1e-12, 1.0, 2)?.titled(r"angle $\theta$, rad");
    let error = Axis::log(1e-17, 10.0, 2)?.titled("relative error of the angle");
    let mut plot = Plot::new(&mut drawing, Rect::new(66.0, 34.0, 592.0, 262.0), angle, error)?;
    plot.series("cosine", &naive, Marker::Disc, Hue::Orange);
    plot.series("arctangent", &better, Marker::Square, Hue::Blue);
    plot.label((1e-6, 1e-3), Side::Right, "inverse cosine", Hue::Orange)?;
    plot.label((1e-9, 2e-15), Side::Above, "arctangent of the two parts", Hue::Blue)?;
    Ok(drawing)
}

//! The figures of the chapter "How a body turns".

use crate::{Axis, Cause, Outcome, Plot};
use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Point, Rect, Side, Stroke, at};
use mechanics::attitude::rotation_between;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, PrincipalMoments};
use mechanics::integrate::{Dop853, rk4};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// A plate after a careless throw: its axis and angular velocity on cones about the angular momentum.
pub(crate) fn plate(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 440.0, 356.0).titled(
        "A wobbling plate",
        "A flat round plate seen from the side and a little above, leaning to the right. The angular momentum L points straight \
         up. The axis 3 of the plate leans away from it to the right, the angular velocity omega to the left, and both go round \
         it \
         on circles, drawn thin, about the direction of L.",
    );
    let disc = Body::thin_disk(0.6, 0.13)?.moments();
    let omega_body = Vector3::new(1.15, 0.0, 1.5);
    let momentum_body = disc.angular_momentum(&omega_body);
    // Stand so that the momentum is upright and the axis leans to the right of the page.
    let upright =
        UnitQuaternion::rotation_between(&momentum_body, &Vector3::z()).ok_or("L is not opposite to z")?;
    let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), std::f64::consts::PI + 0.35);
    let top = FreeSymmetricTop::new(disc, Turning { world_from_body: turned * upright, omega_body })?;
    let now = top.at(0.0)?;
    let (axis, omega) = (now.axis_3_world(), now.omega_world());

    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.35],
        azimuth: -1.35,
        elevation: 0.36,
        distance: 8.0,
        centre: at(220.0, 215.0),
        scale: 118.0,
    })?);
    stage.solid(Solid::disc([0.0; 3], axis, 1.0, 0.05)?, Hue::Blue)?;
    let spin = omega.normalize() * 1.55;
    for (tip, hue) in [(axis * 1.5, Hue::Ink), (spin, Hue::Orange)] {
        let circle = Curve::circle([0.0, 0.0, tip.z], Vector3::z(), tip.x.hypot(tip.y))?;
        stage.curve(circle.hiding(Hiding::Omitted), Stroke::Outline, hue)?;
    }
    stage.named_vector([0.0; 3], [0.0, 0.0, 1.75], r"$\boldsymbol{L}$", Hue::Green)?;
    stage.vector([0.0; 3], axis * 1.5, Hue::Ink)?;
    stage.label_shifted(axis * 1.5, at(8.0, -4.0), Side::Right, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    stage.vector([0.0; 3], spin, Hue::Orange)?;
    stage.label_shifted(spin, at(-8.0, -2.0), Side::Left, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The plane of axis, angular momentum and angular velocity for a flat and for a long body.
pub(crate) fn split(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 660.0, 330.0).titled(
        "Axis, angular momentum and angular velocity lie in one plane",
        "Two panels, each with three arrows from one point. The axis 3 points straight up. Left, for a flat body, the angular \
         momentum divided by I1 points up and to the right at a small angle, and the angular velocity, obtained by going \
         straight down \
         from its tip by sigma, points more to the right: the momentum lies between the other two. Right, for a long body, the \
         momentum leans further than the angular velocity, which is reached by going up.",
    );
    let scale = 88.0;
    let panels =
        [(90.0, 2.0, 285.0, r"flat: $I_3 = 2I_1$"), (430.0, 1.0 / 3.0, 285.0, r"long: $I_3 = \tfrac13I_1$")];
    for (x, ratio, y, name) in panels {
        let moments = PrincipalMoments::symmetric(1.0, ratio)?;
        let start =
            Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(1.1, 0.0, 1.25) };
        let top = FreeSymmetricTop::new(moments, start)?;
        let momentum = top.angular_momentum_world() / moments.to_array()[0];
        let origin = at(x, y);
        let place = |v: Vector3<f64>| origin + at(v.x * scale, -v.z * scale);
        let tip_of_axis = origin - at(0.0, 268.0);
        let (tip_of_momentum, tip_of_omega) = (place(momentum), place(start.omega_body));
        drawing.line(tip_of_momentum, tip_of_omega, Stroke::Reference, Hue::Ink);
        kit::arrow(&mut drawing, origin, tip_of_axis, Hue::Ink);
        kit::arrow(&mut drawing, origin, tip_of_momentum, Hue::Green);
        kit::arrow(&mut drawing, origin, tip_of_omega, Hue::Orange);
        drawing.label(tip_of_axis, Side::Right, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        let (side_of_momentum, side_of_omega) =
            if ratio > 1.0 { (Side::AboveRight, Side::Right) } else { (Side::Right, Side::AboveRight) };
        drawing.label(tip_of_momentum, side_of_momentum, r"$\boldsymbol{L}/I_1$", Hue::Green)?;
        drawing.label(tip_of_omega, side_of_omega, r"$\boldsymbol{\omega}$", Hue::Orange)?;
        let middle = tip_of_momentum.towards(tip_of_omega, 0.5);
        drawing.label(middle, Side::Right, r"$-\sigma\,\hat{\mathbf{3}}$", Hue::Ink)?;

        // The angle that stays: between the axis and the momentum.
        let lean = top.momentum_angle();
        let upright = 0.25 * TAU;
        let radius = if ratio > 1.0 { 96.0 } else { 52.0 };
        kit::angle(&mut drawing, origin, radius, upright, -lean, Heads::None, Hue::Ink);
        let label = origin + Point::polar(radius, upright - 0.5 * lean);
        drawing.label(label, Side::Above, r"$\theta_L$", Hue::Ink)?;
        drawing.dot(origin, 3.0, Hue::Ink);
        drawing.label(at(x + 60.0, y + 26.0), Side::Over, name, Hue::Ink)?;
    }
    Ok(drawing)
}

/// What ten seconds of stepping do to the quaternion.
pub(crate) fn drift(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 372.0).titled(
        "Length and error of a stepped quaternion",
        "Both scales are logarithmic: along x the steps a wobble of the Runge-Kutta method of order four, from four to five hundred; \
         along y errors after 96 wobbles. The error of the attitude falls with the fourth power, from a tenth of a radian to \
         3e-10. The error of the length of the quaternion, \
         falling with the fifth power, lies below it, by a factor of forty at twenty steps. A horizontal line at 3e-13 \
         is the difference between the closed form and the judge.",
    );
    let plate = Body::thin_disk(0.6, 0.13)?.moments();
    let start =
        Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(1.5, 0.0, 30.0) };
    let seconds = 10.0;
    let top = FreeSymmetricTop::new(plate, start)?;
    let exact = top.at(seconds)?.world_from_body;
    let wobbles = seconds * top.precession_rate() / TAU;
    let free = || euler::turning_rates(plate, |_, _| Vector3::zeros());
    let (mut lengths, mut attitudes) = (Vec::new(), Vec::new());
    for half_octave in 4..=18 {
        let per_wobble = 2_f64.powf(0.5 * f64::from(half_octave));
        let steps = (per_wobble * wobbles).round() as usize;
        let state = rk4(free(), 0.0, start.to_array(), seconds, steps)?;
        let length = state[..4].iter().map(|part| part * part).sum::<f64>().sqrt();
        let per_wobble = steps as f64 / wobbles;
        lengths.push((per_wobble, (length - 1.0).abs()));
        let found = Turning::from_array(state).world_from_body;
        attitudes.push((per_wobble, rotation_between(&found, &exact)));
    }
    let judge = Dop853::new(1e-13)?.solve(free(), 0.0, start.to_array(), seconds)?;
    let closed = rotation_between(&Turning::from_array(judge.state).world_from_body, &exact);

    let steps = Axis::log(4.0, 600.0, 1)?.titled("steps a wobble");
    let error = Axis::log(1e-14, 10.0, 2)?.titled("error after 96 wobbles");
    let mut plot = Plot::new(&mut drawing, Rect::new(66.0, 34.0, 592.0, 286.0), steps, error)?;
    plot.level(closed, Stroke::Reference);
    plot.series("attitude", &attitudes, Marker::Disc, Hue::Orange);
    plot.series("length", &lengths, Marker::Square, Hue::Blue);
    let labelled = nearest(&attitudes, 45.0)?;
    plot.label(labelled, Side::AboveRight, "attitude, rad", Hue::Orange)?;
    let labelled = nearest(&lengths, 30.0)?;
    plot.label(labelled, Side::BelowLeft, "length of the quaternion", Hue::Blue)?;
    plot.label((5.0, closed), Side::AboveRight, "closed form, against DOP853", Hue::Muted)?;
    Ok(drawing)
}

/// The point of a curve whose x is nearest.
fn nearest(values: &[(f64, f64)], x: f64) -> Result<(f64, f64), Cause> {
    let far = |value: &(f64, f64)| (value.0 / x).ln().abs();
    let found = values.iter().min_by(|a, b| far(a).total_cmp(&far(b)));
    found.copied().ok_or_else(|| "an empty curve has no nearest point".into())
}

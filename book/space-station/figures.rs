//! The figures of the chapter "The struck space station".

use crate::{Axis, Outcome, Plot, linear_steps};
use drawing::kit::{Heads, Marker};
use drawing::space::{Camera, Curve, Finish, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use mechanics::InvalidQuantity;
use mechanics::euler::{self, Turning};
use mechanics::inertia::Body;
use mechanics::integrate::Dop853;
use mechanics::scenes::space_station::{Blow, Parameters, Station, StruckStation};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// Mass, kg, radius, m, spin, rad/s, and impulse, N·s, of the chapter.
const MASS: f64 = 4e5;
const RADIUS: f64 = 50.0;
const SPIN: f64 = 0.45;
const IMPULSE: f64 = 1.8e6;

/// The station after a blow on the rim.
fn struck(impulse: f64) -> Result<StruckStation, InvalidQuantity> {
    let station = Station::new(Parameters { body: Body::hoop(MASS, RADIUS)?, spin: SPIN })?;
    station.struck(Blow { radius: RADIUS, impulse })
}

/// The station at the moment of the blow: impulse, old and new angular velocity, angular momentum.
pub(crate) fn station(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 520.0, 400.0).titled(
        "The station at the moment of the blow",
        "A ring seen from above at an angle, with axes 1 and 2 in its plane and 3 upright. At the rim, where axis 2 meets it, the impulse P \
         points up. From the centre the new angular velocity omega leans from axis 3 towards axis 1 by the angle theta, and the \
         angular momentum L lies between the two.",
    );
    // A stronger blow than in the text, so that the angles can be seen.
    let struck = struck(3.6e6)?;
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.35],
        azimuth: 0.62,
        elevation: 0.42,
        distance: 8.0,
        centre: at(235.0, 215.0),
        scale: 118.0,
    })?);
    stage.solid(Solid::ring([0.0; 3], Vector3::z(), 1.0, 0.86, 0.14)?, Hue::Blue)?;
    let direction = |v: Vector3<f64>, length: f64| v.normalize() * length;
    let omega = direction(struck.at(0.0)?.omega_body, 1.6);
    let momentum = direction(struck.angular_momentum_world(), 1.75);
    stage.named_vector([0.0; 3], [1.75, 0.0, 0.0], r"$\hat{\mathbf{1}}$", Hue::Ink)?;
    stage.named_vector([0.0; 3], [0.0, 1.6, 0.0], r"$\hat{\mathbf{2}}$", Hue::Ink)?;
    stage.named_vector([0.0; 3], [0.0, 0.0, 1.75], r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    stage.named_vector([0.0; 3], omega, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.named_vector([0.0; 3], momentum, r"$\boldsymbol{L}$", Hue::Green)?;
    stage.angle([0.0; 3], Vector3::z(), omega, 0.8, "", Hue::Ink)?;
    let beside = (Vector3::z() + momentum.normalize() * 0.6).normalize() * 0.8;
    stage.label(beside, Side::Above, r"$\theta$", Hue::Ink)?;
    stage.named_vector([0.0, 0.93, 0.07], [0.0, 0.93, 0.8], r"$\boldsymbol{P}$", Hue::Pink)?;
    stage.dot([0.0, 0.93, 0.07], 3.5, Hue::Pink)?;
    stage.turning([0.0, 0.0, 1.35], [0.0, 0.0, 1.0], 0.16, Hue::Orange)?;
    stage.label_shifted([0.0, 0.0, 1.35], at(20.0, 0.0), Side::Right, r"$\omega_0$", Hue::Orange)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The cone fixed in the station rolling on the cone fixed in space.
pub(crate) fn cones_roll(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 480.0, 400.0).titled(
        "Body cone and space cone",
        "Two cones with a common tip that touch along the angular velocity omega. The narrow one stands upright about the angular \
         momentum L; it is fixed in space. The wide one, about the axis 3 of the station, is fixed in the station; the narrow one lies inside \
         it, and the wide one rolls round it.",
    );
    // ω₁/ω₃ = tan 40°.
    let added = SPIN * 40_f64.to_radians().tan();
    let struck = struck(added * MASS * RADIUS / 2.0)?;
    let momentum_body = struck.angular_momentum_world().normalize();
    let upright =
        UnitQuaternion::rotation_between(&momentum_body, &Vector3::z()).ok_or("L is not opposite to z")?;
    let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -0.5) * upright;
    let axis = turned * Vector3::z();
    let omega = turned * struck.at(0.0)?.omega_body.normalize();
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.75],
        azimuth: -1.2,
        elevation: 0.3,
        distance: 9.0,
        centre: at(250.0, 215.0),
        scale: 150.0,
    })?);
    let space_angle = struck.axis_angle() - struck.momentum_angle();
    stage.solid(Solid::cone([0.0; 3], axis, struck.axis_angle(), 1.3)?.finish(Finish::Glass), Hue::Blue)?;
    stage.solid(Solid::cone([0.0; 3], Vector3::z(), space_angle, 1.3)?.finish(Finish::Glass), Hue::Green)?;
    stage.named_vector([0.0; 3], [0.0, 0.0, 1.8], r"$\boldsymbol{L}$", Hue::Green)?;
    stage.named_vector([0.0; 3], axis * 1.7, r"$\hat{\mathbf{3}}$", Hue::Blue)?;
    let arrow = Curve::segment([0.0; 3], omega * 1.75)?.hiding(Hiding::Ignored);
    stage.arrow(arrow, Stroke::Vector, Heads::End, Hue::Orange)?;
    stage.label(omega * 1.75, Side::AboveLeft, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// How many times the axis has gone round L, and the axis of rotation round axis 3 on board.
pub(crate) fn nodding(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 372.0).titled(
        "Turns of the axis in the room and of the rotation axis on board",
        "Angles in turns against time in turns of the old spin, from 0 to 4. The axis of the station in the room rises to 8.2 \
         turns, along \
         dots from a simulation. The axis of rotation as seen on board rises to 4 turns, which is also the source's claim \
         for the axis in the room.",
    );
    let struck = struck(IMPULSE)?;
    let period = TAU / SPIN;
    let time = Axis::linear(0.0, 4.0, 1.0)?.minor(0.25).titled("time, turns of the old spin");
    let turns = Axis::linear(0.0, 9.0, 1.0)?.titled("angle, turns");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 34.0, 420.0, 286.0), time, turns)?;
    let line = |rate: f64| linear_steps(0.0, 4.0, 1).map(move |t| (t, t * rate * period / TAU));
    plot.curve("in-the-room", line(struck.nodding_rate()), Stroke::Curve, Hue::Blue);
    plot.curve("on-board", line(struck.body_rate()), Stroke::Curve, Hue::Orange);

    // The same two angles counted in a simulation that knows neither rate.
    let moments = Body::hoop(MASS, RADIUS)?.moments();
    let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
    let times: Vec<f64> = linear_steps(0.0, 4.0 * period, 256).collect();
    let (states, _) = Dop853::new(1e-11)?.sample(free, 0.0, struck.at(0.0)?.to_array(), &times)?;
    let turnings: Vec<Turning> = states.into_iter().map(Turning::from_array).collect();
    let momentum = struck.angular_momentum_world().normalize();
    let axes: Vec<Vector3<f64>> = turnings.iter().map(Turning::axis_3_world).collect();
    let omegas: Vec<Vector3<f64>> = turnings.iter().map(|turning| turning.omega_body).collect();
    for (about, vectors, form, hue) in
        [(momentum, &axes, Marker::Disc, Hue::Blue), (Vector3::z(), &omegas, Marker::Square, Hue::Orange)]
    {
        let angles = turns_about(&about, vectors);
        let counted: Vec<(f64, f64)> =
            times.iter().zip(angles).map(|(t, angle)| (t / period, angle)).step_by(16).collect();
        plot.markers(&counted, form, hue);
    }
    plot.label((4.0, 8.16), Side::Right, r"axis about $\boldsymbol{L}$, in the room", Hue::Blue)?;
    plot.label(
        (4.0, 4.3),
        Side::Right,
        r"$\boldsymbol{\omega}$ about $\hat{\mathbf{3}}$, on board",
        Hue::Orange,
    )?;
    plot.label((4.0, 3.5), Side::Right, "and the source's claim", Hue::Muted)?;
    plot.label((4.0, 2.9), Side::Right, "for the axis in the room", Hue::Muted)?;
    Ok(drawing)
}

/// The angle, in turns, through which each of a list of vectors has gone round an axis since the first.
fn turns_about(axis: &Vector3<f64>, vectors: &[Vector3<f64>]) -> Vec<f64> {
    let across = |v: &Vector3<f64>| v - axis * axis.dot(v);
    let mut sum = 0.0;
    let mut angles = vec![0.0];
    for pair in vectors.windows(2) {
        let (a, b) = (across(&pair[0]), across(&pair[1]));
        sum += axis.dot(&a.cross(&b)).atan2(a.dot(&b)) / TAU;
        angles.push(sum);
    }
    angles
}

//! The figures of the chapter "The coin toss".

use crate::{Axis, Cause, Outcome, Plot, linear_steps, log_steps};
use drawing::kit::Marker;
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use mechanics::attitude::angle_between;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::InvalidQuantity;
use mechanics::inertia::{Body, PrincipalMoments};
use mechanics::integrate::rk4;
use mechanics::scenes::coin_toss::{Toss, TossParameters, angle_for_probability};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// A thin coin; its mass and radius make no difference.
fn coin() -> Result<PrincipalMoments, InvalidQuantity> {
    Ok(Body::thin_disk(0.0075, 0.0122)?.moments())
}

/// That coin with a tumble and a twist, rad/s.
fn tossed(omega_1: f64, omega_3: f64) -> Result<Toss, InvalidQuantity> {
    Toss::new(TossParameters { moments: coin()?, omega_1, omega_3 })
}

/// The coin flat in the hand, and half a precession later.
pub(crate) fn toss(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 660.0, 330.0).titled(
        "The coin at the start and half a precession later",
        "Two pictures of the coin. Left, flat: its normal 3 points straight up, the axis 1 to the right, and the angular momentum L \
         leans to the right at the angle psi to the normal. Right, half a precession later: L is where it was, the normal has \
         gone to its other side, at the angle psi again, and points below the horizon, so the lower face is seen from above.",
    );
    let toss = tossed(1.0, 0.31)?;
    let half = 0.5 * TAU / toss.precession_rate();
    let momentum = Vector3::new(toss.momentum_angle().sin(), 0.0, toss.momentum_angle().cos());
    for (x, time) in [(170.0, 0.0), (490.0, half)] {
        let turning = toss.at(time)?;
        let normal = turning.axis_3_world();
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0; 3],
            azimuth: -1.3,
            elevation: 0.3,
            distance: 9.0,
            centre: at(x, 200.0),
            scale: 92.0,
        })?);
        stage.solid(Solid::disc([0.0; 3], normal, 1.0, 0.12)?, Hue::Blue)?;
        // A mark on the face that was up, so that one sees which side is which.
        for radius in [0.82, 0.86] {
            let ring = Curve::circle(normal * 0.061, normal, radius)?;
            stage.curve(ring.hiding(Hiding::Omitted), Stroke::Hatch, Hue::Blue)?;
        }
        stage.named_vector([0.0; 3], momentum * 1.7, r"$\boldsymbol{L}$", Hue::Green)?;
        stage.named_vector([0.0; 3], normal * 1.55, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        stage.angle([0.0; 3], normal, momentum, 0.8, r"$\psi$", Hue::Ink)?;
        if time == 0.0 {
            stage.named_vector([0.0; 3], [1.6, 0.0, 0.0], r"$\hat{\mathbf{1}}$", Hue::Ink)?;
        } else {
            let start = Vector3::z();
            stage.curve(Curve::segment([0.0; 3], start * 1.5)?, Stroke::Reference, Hue::Muted)?;
        }
        stage.write(&mut drawing);
    }
    drawing.label(at(170.0, 318.0), Side::Over, "at the start", Hue::Ink)?;
    drawing.label(at(490.0, 318.0), Side::Over, "half a precession later", Hue::Ink)?;
    Ok(drawing)
}

/// The path of the tip of the normal for three angles, on the unit sphere.
pub(crate) fn cones(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 440.0, 380.0).titled(
        "Paths of the tip of the normal on a sphere",
        "A unit sphere with its equator. Three circles on it pass through the north pole, where the normal starts. The smallest, for psi 30 \
         degrees, stays in the upper half; the middle one, for 45 degrees, touches the equator; the largest, for 75 degrees, goes \
         far below it. Dots mark the directions of the angular momentum at the centres of the circles.",
    );
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0; 3],
        azimuth: -0.9,
        elevation: 0.38,
        distance: 9.0,
        centre: at(215.0, 200.0),
        scale: 150.0,
    })?);
    stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
    stage.curve(Curve::circle([0.0; 3], Vector3::z(), 1.0)?, Stroke::Reference, Hue::Ink)?;
    for (degrees, hue) in [(30.0_f64, Hue::Blue), (45.0, Hue::Green), (75.0, Hue::Pink)] {
        let toss = tossed(2.0 * degrees.to_radians().tan(), 1.0)?;
        let period = TAU / toss.precession_rate();
        let path = linear_steps(0.0, period, 360)
            .map(|time| toss.normal(time))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        stage.curve(Curve::smooth(path)?, Stroke::Curve, hue)?;
        let momentum = Vector3::new(toss.momentum_angle().sin(), 0.0, toss.momentum_angle().cos());
        stage.dot(momentum, 3.0, hue)?;
        let name = format!("{degrees}°");
        stage.label(momentum, Side::Left, &name, hue)?;
    }
    stage.dot([0.0, 0.0, 1.0], 3.0, Hue::Ink)?;
    stage.label([0.0, 0.0, 1.0], Side::Above, "start, flat", Hue::Ink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// Height of the normal for a twist just below, at and just above the threshold.
pub(crate) fn threshold(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 690.0, 350.0).titled(
        "Height of the normal near the threshold",
        "Two plots of the height of the coin's normal against time in precessions. Left, from 0 to 2: the curves for the ratios of twist \
         to tumble 0.49, 0.50 and 0.51 lie so close together that they look like one, which begins at one and falls to about \
         zero after half a \
         precession; a fourth, for the ratio 0.2, falls to minus 0.7. Right, the neighbourhood of the lowest \
         point enlarged: the curve for 0.49 dips below zero, that for 0.50 touches it, that for 0.51 stays above.",
    );
    let curves = [(0.20, Hue::Muted), (0.49, Hue::Pink), (0.50, Hue::Green), (0.51, Hue::Blue)];
    let values = |ratio: f64, from: f64, to: f64| -> Result<Vec<(f64, f64)>, Cause> {
        let toss = tossed(1.0, ratio)?;
        let period = TAU / toss.precession_rate();
        linear_steps(from, to, 300).map(|turns| Ok((turns, toss.normal_height(turns * period)?))).collect()
    };
    let time = Axis::linear(0.0, 2.0, 0.5)?.minor(0.1).titled("time, precessions");
    let height = Axis::linear(-0.8, 1.0, 0.2)?.titled(r"height of the normal $n_z$");
    let mut plot = Plot::new(&mut drawing, Rect::new(54.0, 34.0, 330.0, 262.0), time, height)?;
    plot.level(0.0, Stroke::Reference);
    for (ratio, hue) in curves {
        plot.curve(&format!("whole-{ratio}"), values(ratio, 0.0, 2.0)?, Stroke::Curve, hue);
    }
    plot.label((1.0, -0.45), Side::Over, r"$\omega_3/\omega_1$", Hue::Ink)?;
    plot.label((1.0, -0.62), Side::Over, r"$= 0.20$", Hue::Muted)?;
    plot.label((0.5, 0.5), Side::Over, "0.49", Hue::Ink)?;
    plot.label((0.5, 0.36), Side::Over, "to 0.51", Hue::Ink)?;

    let time = Axis::linear(0.4, 0.6, 0.1)?.minor(0.02);
    let height = Axis::linear(-0.04, 0.1, 0.02)?.titled("enlarged");
    let mut plot = Plot::new(&mut drawing, Rect::new(450.0, 34.0, 190.0, 262.0), time, height)?;
    plot.level(0.0, Stroke::Reference);
    for (ratio, hue) in &curves[1..] {
        plot.curve(&format!("part-{ratio}"), values(*ratio, 0.4, 0.6)?, Stroke::Curve, *hue);
    }
    for ((ratio, hue), height) in curves[1..].iter().zip([-0.028, 0.008, 0.03]) {
        plot.label((0.5, height), Side::Over, &format!("{ratio:.2}"), *hue)?;
    }
    Ok(drawing)
}

/// Probability of the same face against the angle between normal and angular momentum.
pub(crate) fn bias(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 350.0).titled(
        "Probability of the same face",
        "The probability that a coin shows the same face, against the angle psi between its normal and its angular momentum in \
         degrees. Up to 45 degrees it is one. From there it falls, steeply at first, to one half at 90 degrees. The measured \
         0.508 lies on the curve at 81 degrees.",
    );
    let angle = Axis::linear(0.0, 90.0, 15.0)?
        .minor(5.0)
        .titled(r"angle $\psi$ of normal and $\boldsymbol{L}$, degrees");
    let probability = Axis::linear(0.5, 1.0, 0.1)?.minor(0.02).titled("probability of the same face");
    let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 34.0, 560.0, 262.0), angle, probability)?;
    plot.upright(45.0, Stroke::Dotted);
    // Dense near 45°, where the curve leaves with an upright tangent.
    let mut values = vec![(0.0, 1.0), (45.0, 1.0)];
    for step in linear_steps(0.0, 1.0, 400) {
        let toss = tossed(1.0, 0.5 * (1.0 - step * step))?;
        values.push((toss.momentum_angle().to_degrees(), toss.same_face_probability()));
    }
    plot.curve("probability", values, Stroke::Curve, Hue::Blue);
    let measured = (angle_for_probability(0.508)?.to_degrees(), 0.508);
    plot.markers(&[measured], Marker::Disc, Hue::Pink);
    plot.label((58.0, 0.527), Side::Over, "350,757 tosses: 0.508", Hue::Pink)?;
    plot.label((22.0, 0.98), Side::Below, "never turns over", Hue::Ink)?;
    Ok(drawing)
}

/// Error of the direction of the normal by Euler's angles and by the quaternion, against the tilt of the hand.
pub(crate) fn gimbal(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 372.0).titled(
        "Euler's angles against the quaternion",
        "Both scales are logarithmic: along x the tilt of the coin in the hand, from a millionth of a radian to a tenth; along y the \
         error in the direction of the normal after 0.45 seconds, with the same Runge-Kutta method and step. The quaternion's \
         error is about 1e-6 at every tilt. With Euler's angles the error is between a hundredth and two radians for every tilt below a hundredth.",
    );
    let (tumble, twist, seconds, steps) = (38.0 * TAU, 4.0 * TAU, 0.45, 4500);
    let moments = coin()?;
    let (mut angles, mut quaternions) = (Vec::new(), Vec::new());
    for tilt in log_steps(1e-6, 0.1, 50) {
        // Tilted sideways, about y: the turn begins at a right angle, and the coin's own angle at minus one.
        let start = Turning {
            world_from_body: UnitQuaternion::from_scaled_axis(Vector3::new(0.0, tilt, 0.0)),
            omega_body: Vector3::new(tumble, 0.0, twist),
        };
        let exact = FreeSymmetricTop::new(moments, start)?.axis_world(seconds)?;
        let rates = |t: f64, &[_, lean, own]: &[f64; 3]| {
            let (sin, cos) = (twist * t).sin_cos();
            let [w1, w2] = [tumble * cos, tumble * sin];
            let turn = (w1 * own.sin() + w2 * own.cos()) / lean.sin();
            [turn, w1 * own.cos() - w2 * own.sin(), twist - turn * lean.cos()]
        };
        if let Ok([turn, lean, _]) = rk4(rates, 0.0, [FRAC_PI_2, tilt, -FRAC_PI_2], seconds, steps) {
            let normal = Vector3::new(turn.sin() * lean.sin(), -turn.cos() * lean.sin(), lean.cos());
            angles.push((tilt, angle_between(&normal, &exact)));
        }
        let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
        let state = rk4(free, 0.0, start.to_array(), seconds, steps)?;
        quaternions.push((tilt, angle_between(&Turning::from_array(state).axis_3_world(), &exact)));
    }
    let tilt = Axis::log(1e-6, 0.1, 1)?.titled("tilt of the hand $d$, rad");
    let error = Axis::log(1e-8, 10.0, 1)?.titled("error of the normal, rad");
    let mut plot = Plot::new(&mut drawing, Rect::new(66.0, 34.0, 592.0, 286.0), tilt, error)?;
    plot.series("angles", &angles, Marker::Disc, Hue::Orange);
    plot.series("quaternion", &quaternions, Marker::Square, Hue::Blue);
    plot.label((1e-5, 3.0), Side::Right, "Euler's angles", Hue::Orange)?;
    plot.label((1e-5, 1e-7), Side::Right, "quaternion", Hue::Blue)?;
    Ok(drawing)
}

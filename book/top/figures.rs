//! The figures of the chapter "The top under gravity".

use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, linear_steps};
use mechanics::scenes::top::{Release, Top, TopMotion, TopParameters};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] =
    figures![top_torque, top_angles, top_well, top_tracks, top_steady, top_waking];

/// The toy of the text, and its spin.
const TOY: TopParameters =
    TopParameters { mass: 0.1, arm: 0.04, transverse: 2e-4, axial: 5e-5, gravity: 9.81 };
const SPIN: f64 = 150.0;
/// The tilt from which it is let go, degrees.
const TILT: f64 = 30.0;

fn let_go(precession: f64) -> Result<TopMotion, Cause> {
    let tilt = TILT.to_radians();
    Ok(Top::new(TOY)?.let_go(Release { tilt, tilt_rate: 0.0, precession, spin: SPIN })?)
}

/// A stage with a floor.
fn stage(centre: drawing::Point, scale: f64) -> Result<Stage, Cause> {
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.75],
        azimuth: -1.2,
        elevation: 0.3,
        distance: 10.0,
        centre,
        scale,
    })?);
    stage.ground([-1.2, -1.2], [1.2, 1.2], 0.0, 0.3)?;
    Ok(stage)
}

/// A top on the origin, with its axis in a direction.
fn draw_top(stage: &mut Stage, axis: Vector3<f64>) -> Result<(), Cause> {
    stage.solid(Solid::disc(axis * 0.62, axis, 0.5, 0.12)?, Hue::Blue)?;
    stage.solid(Solid::rod([0.0; 3], axis * 1.0, 0.035)?, Hue::Blue)?;
    Ok(())
}

/// The direction of an axis that leans to the right of the picture.
fn leaning(degrees: f64) -> Vector3<f64> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let azimuth = -0.35;
    Vector3::new(sin * f64::cos(azimuth), sin * f64::sin(azimuth), cos)
}

/// Weight, torque and angular momentum of a top that leans.
pub(crate) fn top_torque(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 340.0).titled(
        "The torque of the weight on a top",
        "A top leans to the right on its point, which stands on a floor. At its centre of mass the weight points down. The angular momentum points up along the axis. From its tip the torque, \
         level and at right angles to the lean, points away to the back, along a level circle on which the tip goes round.",
    );
    let axis = leaning(TILT);
    let mut stage = stage(at(200.0, 190.0), 110.0)?;
    draw_top(&mut stage, axis)?;
    let tip = axis * 1.55;
    let round = Curve::circle([0.0, 0.0, tip.z], Vector3::z(), tip.xy().norm())?.hiding(Hiding::Ignored);
    stage.curve(round, Stroke::Outline, Hue::Green)?;
    let segment = |from: Vector3<f64>, to: Vector3<f64>| -> Result<Curve, Cause> {
        Ok(Curve::segment(from, to)?.hiding(Hiding::Ignored))
    };
    stage.curve(segment(Vector3::zeros(), Vector3::z() * 1.75)?, Stroke::Reference, Hue::Muted)?;
    stage.arrow(segment(Vector3::zeros(), tip)?, Stroke::Vector, Heads::End, Hue::Green)?;
    stage.label_shifted(tip, at(3.0, 8.0), Side::Right, r"$\boldsymbol L$", Hue::Green)?;
    let centre = axis * 0.62;
    let weight = centre - Vector3::z() * 0.6;
    stage.arrow(segment(centre, weight)?, Stroke::Vector, Heads::End, Hue::Purple)?;
    stage.label(weight, Side::Right, r"$m\boldsymbol g$", Hue::Purple)?;
    let torque = Top::new(TOY)?;
    let lean = UnitQuaternion::rotation_between(&Vector3::z(), &axis).ok_or("no lean")?;
    let turning = mechanics::euler::Turning { world_from_body: lean, omega_body: Vector3::zeros() };
    let torque = lean * torque.torque_body(&turning);
    let end = tip + torque.normalize() * 0.75;
    stage.arrow(segment(tip, end)?, Stroke::Vector, Heads::End, Hue::Purple)?;
    stage.label(end, Side::Above, r"$\boldsymbol\tau$", Hue::Purple)?;
    stage.angle([0.0; 3], Vector3::z(), axis, 0.95, r"$\theta$", Hue::Ink)?;
    stage.dot_in_front(centre, 3.0, Hue::Ink)?;
    stage.dot_in_front([0.0; 3], 3.5, Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// Euler's angles.
pub(crate) fn top_angles(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 350.0).titled(
        "Euler’s angles",
        "A top leans on its point. The tilt theta is the angle between the vertical and its axis. An arrow round the vertical is the azimuth phi, an arrow round the axis the own turn psi. \
         A dashed level line through the point, at right angles to the lean, is the one about which the tilt grows.",
    );
    let axis = leaning(40.0);
    let mut stage = stage(at(195.0, 200.0), 110.0)?;
    draw_top(&mut stage, axis)?;
    let level = Vector3::z().cross(&axis).normalize();
    let line = Curve::segment(level * -0.9, level * 0.9)?.hiding(Hiding::Ignored);
    stage.curve(line, Stroke::Reference, Hue::Ink)?;
    stage.label(level * -0.9, Side::Left, "level line", Hue::Muted)?;
    stage.vector([0.0; 3], [0.0, 0.0, 1.8], Hue::Ink)?;
    stage.label([0.0, 0.0, 1.8], Side::Above, r"$\hat{\mathbf z}$", Hue::Ink)?;
    stage.vector(axis, axis * 1.6, Hue::Ink)?;
    stage.label(axis * 1.6, Side::AboveRight, r"$\hat{\mathbf 3}$", Hue::Ink)?;
    stage.turning([0.0, 0.0, 1.4], Vector3::z(), 0.2, Hue::Orange)?;
    stage.label_shifted([0.0, 0.0, 1.4], at(-24.0, 0.0), Side::Left, r"$\dot\varphi$", Hue::Orange)?;
    stage.turning(axis * 1.3, axis, 0.2, Hue::Orange)?;
    stage.label_shifted(axis * 1.3, at(20.0, 10.0), Side::Right, r"$\dot\psi$", Hue::Orange)?;
    stage.angle([0.0; 3], Vector3::z(), axis, 1.05, r"$\theta$", Hue::Ink)?;
    stage.dot_in_front([0.0; 3], 3.5, Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The well in which the tilt moves.
pub(crate) fn top_well(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 320.0).titled(
        "The well of the tilt",
        "The energy of the tilt in millijoule against the tilt from 20 to 60 degrees: a well with its bottom near 36 degrees. A level line at 34 millijoule cuts it at 30 and at \
         42.3 degrees, marked by dots.",
    );
    let motion = let_go(0.0)?;
    let tilt = Axis::linear(20.0, 60.0, 10.0).minor(2.0).titled(r"tilt $\theta$, degrees");
    let energy = Axis::linear(32.0, 38.0, 1.0).titled("$V$, mJ");
    let mut plot = Plot::new(&mut drawing, Rect::new(42.0, 34.0, 325.0, 236.0), tilt, energy)?;
    let values =
        linear_steps(20.0, 60.0, 400).map(|degrees| (degrees, 1e3 * motion.well(degrees.to_radians())));
    plot.curve("well", values, Stroke::Curve, Hue::Ink);
    let level = 1e3 * motion.well_energy();
    let [from, to] = motion.tilts().map(f64::to_degrees);
    plot.reference((from, level), (to, level), Stroke::Reference);
    plot.markers(&[(from, level), (to, level)], Marker::Disc, Hue::Ink);
    plot.label((from, level), Side::BelowLeft, "let go", Hue::Ink)?;
    plot.label((to, level), Side::BelowRight, "42.3°", Hue::Ink)?;
    Ok(drawing)
}

/// What the tip draws: waves, cusps, loops.
pub(crate) fn top_tracks(id: &str) -> Outcome {
    let panel = |name: &str, precession: f64, words: &str| -> Outcome {
        let mut drawing = Drawing::new("", 250.0, 244.0).titled(
            words,
            &format!(
                "From above: the tip of the axis goes round the vertical between two dotted circles and draws {name}."
            ),
        );
        let motion = let_go(precession)?;
        let mut plot = Plot::plane(&mut drawing, at(125.0, 112.0), 135.0, 0.8)?;
        let duration = 4.9 * motion.nod_period().ok_or("it nods")?;
        let tip = |time: f64| -> Result<(f64, f64), Cause> {
            let tip = motion.at(time)?.axis_3_world();
            Ok((tip.x, tip.y))
        };
        for (tilt, name) in motion.tilts().into_iter().zip(["inner", "outer"]) {
            let circle =
                linear_steps(0.0, TAU, 180).map(|angle| (tilt.sin() * angle.cos(), tilt.sin() * angle.sin()));
            plot.curve(name, circle, Stroke::Dotted, Hue::Muted);
        }
        let values = linear_steps(0.0, duration, 700).map(tip).collect::<Result<Vec<_>, Cause>>()?;
        let [before, end] = [values[values.len() - 8], values[values.len() - 1]].map(|tip| plot.at(tip));
        plot.curve(name, values, Stroke::Curve, Hue::Ink);
        plot.markers(&[tip(0.0)?], Marker::Disc, Hue::Ink);
        kit::head(&mut drawing, end, end - before, 1.0, Hue::Ink);
        drawing.label(at(125.0, 228.0), Side::Over, words, Hue::Muted)?;
        Ok(drawing)
    };
    let panels = vec![
        panel("waves", 3.0, "pushed on: waves")?,
        panel("cusps", 0.0, "let go: cusps")?,
        panel("loops", -3.0, "pushed back: loops")?,
    ];
    Ok(Drawing::panels(id, panels))
}

/// Both rates of steady precession against the spin.
pub(crate) fn top_steady(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 330.0).titled(
        "The two rates of steady precession",
        "The rate in radians a second against the spin from 0 to 300 radians a second, for a tilt of 30 degrees. No curve below 104. There two curves leave from one point at 15 radians a second: \
         the fast one rises nearly straight, the slow one falls and comes close to a dashed curve.",
    );
    let toy = Top::new(TOY)?;
    let tilt = TILT.to_radians();
    let spin = Axis::linear(0.0, 300.0, 100.0).minor(20.0).titled(r"spin $\omega_3$, rad/s");
    let rate = Axis::linear(0.0, 80.0, 20.0).minor(5.0).titled(r"$\Omega$, rad/s");
    let mut plot = Plot::new(&mut drawing, Rect::new(42.0, 34.0, 325.0, 246.0), spin, rate)?;
    let least = toy.sleeping_spin() * tilt.cos().sqrt(); // eq:steady-exists
    let (mut slow, mut fast) = (Vec::new(), Vec::new());
    for part in linear_steps(0.0, 1.0, 400) {
        let spin = least * (1.0 + 1e-12) + (300.0 - least) * part * part;
        let Some(steady) = toy.steady_precession(tilt, spin)? else { continue };
        slow.push((spin, steady.slow));
        fast.extend(steady.fast.map(|rate| (spin, rate)));
    }
    let estimate = linear_steps(9.0, 300.0, 600).map(|spin| (spin, toy.weight_torque() / (TOY.axial * spin)));
    plot.curve("estimate", estimate, Stroke::Reference, Hue::Muted);
    plot.curve("fast", fast, Stroke::Curve, Hue::Orange);
    plot.curve("slow", slow, Stroke::Curve, Hue::Orange);
    plot.upright(least, Stroke::Dotted);
    plot.label((220.0, 62.0), Side::AboveLeft, "fast", Hue::Orange)?;
    plot.label((240.0, 6.0), Side::AboveLeft, "slow", Hue::Orange)?;
    plot.label((52.0, 52.0), Side::Over, "none", Hue::Muted)?;
    Ok(drawing)
}

/// How far a top leans that has slept.
pub(crate) fn top_waking(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 330.0).titled(
        "How a sleeper wakes",
        "Two tilts in degrees, from 0 to 180, against the spin over the sleeping spin, from 0 to 1.3. Both are zero above 1 and rise below like a root: the tilt of rest up to 180 degrees where the \
         spin is zero, the tilt to which a top swings from the upright above it.",
    );
    let toy = Top::new(TOY)?;
    let sleeping = toy.sleeping_spin();
    let part = Axis::linear(0.0, 1.3, 0.5).minor(0.1).titled(r"spin $\omega_3/\omega_\text{s}$");
    let tilt = Axis::linear(0.0, 180.0, 45.0).minor(15.0).titled("tilt, degrees");
    let mut plot = Plot::new(&mut drawing, Rect::new(42.0, 34.0, 325.0, 246.0), part, tilt)?;
    let parts = || linear_steps(0.0, 1.0, 400).map(|part| 1.0 - (1.0 - part) * (1.0 - part)).chain([1.3]);
    let curve = |of: &dyn Fn(f64) -> Result<f64, mechanics::InvalidQuantity>| {
        parts().map(|part| Ok((part, of(part * sleeping)?.to_degrees()))).collect::<Result<Vec<_>, Cause>>()
    };
    plot.curve("furthest", curve(&|spin| toy.furthest_tilt(spin))?, Stroke::Outline, Hue::Ink);
    plot.curve("resting", curve(&|spin| toy.waking_tilt(spin))?, Stroke::Curve, Hue::Ink);
    plot.upright(1.0, Stroke::Dotted);
    plot.label((0.62, 103.0), Side::AboveRight, "swings so far", Hue::Ink)?;
    plot.label((0.42, 72.0), Side::Over, "can rest", Hue::Ink)?;
    plot.label((1.15, 30.0), Side::Over, "sleeps", Hue::Ink)?;
    Ok(drawing)
}

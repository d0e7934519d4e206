//! The figures of the chapter "The rolling wheel".

use crate::{Axis, Cause, Outcome, Plot, linear_steps, log_steps};
use drawing::kit::Marker;
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use mechanics::integrate::{Dop853, Taylor, rk4};
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// A wheel of mass, radius and gravity one.
fn wheel(moments: MomentFactors) -> Result<Wheel, Cause> {
    Ok(Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 })?)
}

/// The wheel on its circle, with axes and lengths.
pub(crate) fn wheel_circle(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 640.0, 470.0).titled(
        "The wheel on its circle",
        "A table with a circle, and a wheel that stands on it and leans inward by theta. Above the table a smaller dashed circle is the path of the centre, of radius b; the \
         upright axis through both carries Omega. At the centre of the wheel the axis 1 is level, along the path, 2 runs up the plane of the \
         wheel, and 3, the axle, inward and down. A dot marks the contact.",
    );
    let (lean, b) = (0.42_f64, 1.7);
    let (sin, cos) = lean.sin_cos();
    // Outward along y; the centre at b, one radius above the contact along axis 2.
    let centre = Vector3::new(0.0, b, cos);
    let axes = [Vector3::x(), Vector3::new(0.0, -sin, cos), Vector3::new(0.0, -cos, -sin)];
    let contact = centre - axes[1];
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.35, 0.75],
        azimuth: 0.45,
        elevation: 0.36,
        distance: 11.0,
        centre: at(296.0, 245.0),
        scale: 80.0,
    })?);
    stage.ground([-2.3, -2.4], [2.3, 3.1], 0.0, 8.0)?;
    stage.curve(Curve::circle([0.0; 3], Vector3::z(), contact.y)?, Stroke::Outline, Hue::Ink)?;
    let path = Curve::circle([0.0, 0.0, cos], Vector3::z(), b)?;
    stage.curve(path.hiding(Hiding::Dashed), Stroke::Reference, Hue::Muted)?;
    stage.curve(Curve::segment([0.0; 3], [0.0, 0.0, 2.05])?, Stroke::Dotted, Hue::Muted)?;
    stage.vector([0.0, 0.0, 2.05], [0.0, 0.0, 2.55], Hue::Orange)?;
    stage.label([0.0, 0.0, 2.55], Side::Right, r"$\boldsymbol{\Omega}$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 2.28], [0.0, 0.0, 1.0], 0.2, Hue::Orange)?;
    stage.solid(Solid::ring(centre, axes[2], 1.0, 0.9, 0.1)?, Hue::Blue)?;
    for (axis, length, name) in [
        (axes[0], 1.15, r"$\hat{\mathbf{1}}$"),
        (axes[1], 1.4, r"$\hat{\mathbf{2}}$"),
        (axes[2], 0.78, r"$\hat{\mathbf{3}}$"),
    ] {
        stage.named_vector(centre, centre + axis * length, name, Hue::Ink)?;
    }
    let upright = Curve::segment(contact, contact + Vector3::new(0.0, 0.0, 2.4))?;
    stage.curve(upright, Stroke::Reference, Hue::Muted)?;
    stage.angle(contact, Vector3::z(), axes[1], 2.2, r"$\theta$", Hue::Ink)?;
    stage.curve(Curve::segment(centre, contact)?, Stroke::Outline, Hue::Muted)?;
    stage.label_shifted(centre - axes[1] * 0.5, at(-2.0, 0.0), Side::Left, "$a$", Hue::Ink)?;
    let radius = Curve::segment([0.0, 0.0, cos], centre)?;
    stage.curve(radius, Stroke::Outline, Hue::Muted)?;
    stage.label([0.0, 0.5, cos], Side::Above, "$b$", Hue::Ink)?;
    stage.dot_in_front(contact, 4.5, Hue::Pink)?;
    stage.label_shifted(contact, at(10.0, 0.0), Side::Right, "contact", Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The leans that the plots compare, degrees, each with its hue.
const LEANS: [(f64, Hue); 3] = [(20.0, Hue::Blue), (45.0, Hue::Green), (70.0, Hue::Orange)];

/// Turn rate against the radius of the centre's circle.
pub(crate) fn turn_rate(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 690.0, 350.0).titled(
        "Rate of steady rolling against the radius of the circle",
        "The square of the turn rate, in g over a, against b over a from minus 0.2 to 1, for a disc leaning by 20, 45 and 70 degrees. Each curve falls from infinity at its own \
         bound, a small negative b marked by a dotted line, towards zero. Where b is positive the larger lean has the larger rate; left of zero the curves cross.",
    );
    let b = Axis::linear(-0.2, 1.0, 0.2)?.minor(0.05).titled("radius of the centre's circle $b/a$");
    let rate = Axis::linear(0.0, 20.0, 5.0)?.minor(1.0).titled(r"$\Omega^2$, in $g/a$");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 34.0, 540.0, 262.0), b, rate)?;
    let disc = wheel(MomentFactors::DISK)?;
    for (degrees, hue) in LEANS {
        let lean = f64::to_radians(degrees);
        let bound = -0.5 * lean.sin() / 3.0; // eq:existence
        let values = linear_steps(0.0, 1.0, 600)
            .map(|part| bound + 1e-3 + (1.0 - bound - 1e-3) * part * part)
            .map(|b| Ok((b, disc.steady(lean, b)?.turn_rate().powi(2))))
            .collect::<Result<Vec<_>, Cause>>()?;
        plot.upright(bound, Stroke::Dotted);
        plot.curve(&format!("lean-{degrees}"), values, Stroke::Curve, hue);
    }
    plot.label((0.33, 4.6), Side::AboveRight, r"$\theta = 70°$", Hue::Orange)?;
    plot.label((0.52, 1.15), Side::AboveRight, "45°", Hue::Green)?;
    plot.label((0.01, 1.0), Side::Over, "20°", Hue::Blue)?;
    Ok(drawing)
}

/// Friction needed against the radius of the circle.
pub(crate) fn friction(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 690.0, 350.0).titled(
        "Least coefficient of friction against the radius of the circle",
        "The least coefficient of friction against b over a from 0 to 3, for a disc leaning by 20, 45 and 60 degrees. Each curve starts at zero and rises towards a dashed level, two thirds \
         of the tangent of the lean.",
    );
    let b = Axis::linear(0.0, 3.0, 0.5)?.minor(0.1).titled("radius of the centre's circle $b/a$");
    let coefficient = Axis::linear(0.0, 1.25, 0.25)?.minor(0.05).titled("least coefficient of friction");
    let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 540.0, 262.0), b, coefficient)?;
    let disc = wheel(MomentFactors::DISK)?;
    for (degrees, hue) in [(20.0, Hue::Blue), (45.0, Hue::Green), (60.0, Hue::Orange)] {
        let lean = f64::to_radians(degrees);
        let values = linear_steps(0.0, 3.0, 300)
            .map(|b| Ok((b, disc.steady(lean, b)?.friction_needed())))
            .collect::<Result<Vec<_>, Cause>>()?;
        let end = values.last().copied().ok_or("a curve has an end")?;
        plot.level(lean.tan() / 1.5, Stroke::Reference);
        plot.curve(&format!("lean-{degrees}"), values, Stroke::Curve, hue);
        let name = format!(r"$\theta = {degrees}°$");
        plot.label(end, Side::Right, &name, hue)?;
    }
    Ok(drawing)
}

/// The boundary of instability in the plane of radius and lean.
pub(crate) fn tongue(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 690.0, 350.0).titled(
        "Where steady rolling is unstable",
        "The lean in degrees, from 0 to 25, against b over a from 0 to 4, with a curve for a hoop and one for a disc; below each the motion is unstable. Each rises from zero steeply to a tip near \
         19 degrees at small b, and comes down along a falling curve towards large b.",
    );
    let b = Axis::linear(0.0, 4.0, 1.0)?.minor(0.2).titled("radius of the centre's circle $b/a$");
    let lean = Axis::linear(0.0, 25.0, 5.0)?.minor(1.0).titled(r"lean $\theta$, degrees");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 34.0, 540.0, 262.0), b, lean)?;
    for (moments, name, hue, place) in [
        (MomentFactors::HOOP, "hoop", Hue::Orange, (0.5, 20.8)),
        (MomentFactors::DISK, "disc", Hue::Blue, (0.62, 16.6)),
    ] {
        let wheel = wheel(moments)?;
        // The largest unstable lean of each radius, found by halving between an unstable and a stable one.
        let mut boundary = Vec::new();
        for b in linear_steps(0.004, 4.0, 500) {
            let unstable =
                |degrees: f64| Ok::<bool, Cause>(!wheel.steady(degrees.to_radians(), b)?.is_stable());
            let candidates: Vec<f64> = linear_steps(0.05, 25.0, 250).collect();
            let mut last = None;
            for &degrees in &candidates {
                if unstable(degrees)? {
                    last = Some(degrees);
                }
            }
            let Some(mut low) = last else { continue };
            let mut high = low + 0.1;
            for _ in 0..30 {
                let middle = 0.5 * (low + high);
                if unstable(middle)? { low = middle } else { high = middle }
            }
            boundary.push((b, low));
        }
        plot.curve(name, boundary, Stroke::Curve, hue);
        plot.label(place, Side::Over, name, hue)?;
    }
    plot.label((2.2, 16.0), Side::Over, "stable", Hue::Ink)?;
    plot.label((0.7, 3.0), Side::Over, "unstable", Hue::Ink)?;
    Ok(drawing)
}

/// The motion of the text: a disc at a lean of 0.3 with q = 0.45 and n = 0.9.
const WOBBLING: Rolling = Rolling { tilt: FRAC_PI_2 - 0.3, omega_2: 0.45, omega_3: 0.9, ..Rolling::UPRIGHT };

/// The effective potential with the energy of one motion.
pub(crate) fn potential(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 690.0, 350.0).titled(
        "The effective potential of a disc",
        "The potential, in m g a, against the lean from minus 30 to 40 degrees: a well with its bottom near 5 degrees. A level line at the energy 1.588 cuts it at minus 7.6 and at 17.2 degrees, \
         marked by dots.",
    );
    let disc = wheel(MomentFactors::DISK)?;
    let (constants, energy) = (disc.constants(&WOBBLING), disc.energy(&WOBBLING));
    let lean = Axis::linear(-30.0, 40.0, 10.0)?.minor(2.0).titled(r"lean $\theta$, degrees");
    let height = Axis::linear(1.54, 1.66, 0.02)?.titled(r"potential $V$, in $mga$");
    let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 34.0, 540.0, 262.0), lean, height)?;
    plot.level(energy, Stroke::Reference);
    let values = linear_steps(-30.0, 40.0, 400)
        .map(|degrees| (degrees, disc.potential(&constants, FRAC_PI_2 - degrees.to_radians())));
    plot.curve("potential", values, Stroke::Curve, Hue::Purple);
    let wobble = disc.wobble(WOBBLING, &Taylor::new(1e-12)?)?;
    let other = wobble.at(0.5 * wobble.period())?;
    let marks = [WOBBLING, other].map(|state| (state.lean().to_degrees(), energy));
    plot.markers(&marks, Marker::Disc, Hue::Orange);
    plot.label((25.0, energy), Side::AboveRight, "energy", Hue::Muted)?;
    Ok(drawing)
}

/// The track of the contact over eleven wobbles, half of the first of them heavy.
pub(crate) fn contact_track(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 560.0, 330.0).titled(
        "Track of the contact of a wobbling disc",
        "Seen from above, a track that goes round a circle several times in eleven equal waves, so that its rounds cross one another. Half of a wave is drawn heavy, from a place farthest out to one farthest in.",
    );
    let disc = wheel(MomentFactors::DISK)?;
    let mut start = disc.steady(0.55, 1.6)?.state();
    start.omega_1 = 0.3;
    let wobble = disc.wobble(start, &Taylor::new(1e-16)?)?;
    let period = wobble.period();
    let track = |from: f64, to: f64, count: u32| -> Result<Vec<(f64, f64)>, Cause> {
        let times: Vec<f64> = linear_steps(from, to, count).collect();
        let states = wobble.sample(&times)?;
        Ok(states.iter().map(|state| state.contact(1.0)).map(|place| (place.re, place.im)).collect())
    };
    // The moment at which the lean turns, by bisection.
    let (mut before, mut turns) = (0.0, 0.5 * period);
    for _ in 0..50 {
        let middle = 0.5 * (before + turns);
        *(if wobble.at(middle)?.omega_1 > 0.0 { &mut before } else { &mut turns }) = middle;
    }
    let mut plot = Plot::plane(&mut drawing, at(233.0, 160.0), 50.0, 4.0)?;
    plot.curve("all", track(turns, turns + 11.0 * period, 4400)?, Stroke::Orbit, Hue::Blue);
    plot.curve("half", track(turns, turns + 0.5 * period, 200)?, Stroke::Vector, Hue::Orange);
    plot.label((0.94, 0.0), Side::Over, "eleven wobbles", Hue::Ink)?;
    plot.label((0.94, -0.35), Side::Over, "from half of one", Hue::Ink)?;
    Ok(drawing)
}

/// Error of the energy after a near-flat turn, by RK4 and DOP853.
pub(crate) fn near_flat(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 350.0).titled(
        "Error of the energy after a near-flat turn",
        "Both scales are logarithmic: along x the turn q that the disc is given, from 1e-4 to 0.3; along y the relative error of the energy after it has come up. By RK4 with steps of a \
         thousandth of the root of a over g the error grows from about 1e-12 to ten as q falls to 0.0011, and below that there is no value. By DOP853 it stays just below 1e-12.",
    );
    let disc = wheel(MomentFactors::DISK)?;
    let (mut naive, mut better) = (Vec::new(), Vec::new());
    for q in log_steps(1e-4, 0.3, 40) {
        let state = Rolling { tilt: 0.3, omega_2: q, ..Rolling::UPRIGHT };
        let rates = |t: f64, state: &[f64; 8]| disc.rates(t, state);
        let energy = disc.energy(&state);
        let error = |end: [f64; 8]| {
            let end = Rolling::from_array(end);
            (end.tilt > 0.0)
                .then(|| (disc.energy(&end) / energy - 1.0).abs().max(1e-16))
                .filter(|error| *error < 10.0)
        };
        if let Some(error) = rk4(rates, 0.0, state.to_array(), 1.3, 1300).ok().and_then(error) {
            naive.push((q, error));
        }
        let end = Dop853::new(1e-12)?.solve(rates, 0.0, state.to_array(), 1.3)?;
        if let Some(error) = error(end.state) {
            better.push((q, error));
        }
    }
    let turn = Axis::log(1e-4, 1.0, 1)?.titled(r"turn $q$ that the disc is given, in $\sqrt{g/a}$");
    let relative = Axis::log(1e-16, 10.0, 2)?.titled("relative error of the energy");
    let mut plot = Plot::new(&mut drawing, Rect::new(66.0, 34.0, 592.0, 262.0), turn, relative)?;
    plot.series("rk4", &naive, Marker::Disc, Hue::Orange);
    plot.series("dop853", &better, Marker::Square, Hue::Blue);
    plot.label((2e-2, 1e-3), Side::Right, "RK4", Hue::Orange)?;
    plot.label((2e-4, 1e-11), Side::Right, "DOP853", Hue::Blue)?;
    Ok(drawing)
}

//! The drum that speeds up.

use super::{NATURAL, Values, over_spin, washing_machine};
use drawing::kit::{self, Heads, Marker};
use drawing::{Drawing, Fill, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Cause, Outcome, Plot, Room, in_both, linear_steps, log_steps};
use mechanics::scenes::laundromat::Shaft;
use nalgebra::Complex;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A drum that speeds up: its path from above, and how far it swings as time goes on.
pub(crate) fn start(id: &str) -> Outcome {
    let machine = washing_machine(0.3, 0.0)?;
    let (acceleration, end) = (2.5, 13.0);
    let motion = machine.ramp(acceleration, Shaft::AT_REST)?;
    let centimetres = |from: f64, to: f64, count: u32| -> Result<Vec<(f64, Complex<f64>)>, Cause> {
        let times: Vec<f64> = linear_steps(from, to, count).collect();
        let shafts = motion.sample(&times)?;
        Ok(times.into_iter().zip(shafts.into_iter().map(|shaft| shaft.position * 100.0)).collect())
    };
    let plane =
        |way: Vec<(f64, Complex<f64>)>| way.into_iter().map(|(_, z)| (z.re, z.im)).collect::<Values>();
    let widest = 5.0; // s: where the swing is largest

    let mut path = Drawing::new("", 320.0, 330.0).titled(
        "The path of the drum’s centre, from above",
        "The centre of the drum starts at rest in the middle and spirals outwards, counter-clockwise, to more than five centimetres. Then it \
         spirals inwards again, and in the end goes round on a small circle with a radius of nearly two centimetres, drawn heavily.",
    );
    let (origin, scale) = (at(165.0, 150.0), 24.0);
    let mut plot = Plot::plane(&mut path, origin, scale, 6.0)?;
    // Chords that bend away from the path by a sixth of a pixel: of all figures its page carries this one weighs most.
    plot.curve("inwards", plane(centimetres(widest, end, 1600)?), Stroke::Orbit, Hue::Muted);
    plot.curve("outwards", plane(centimetres(0.0, widest, 4000)?), Stroke::Curve, Hue::Ink);
    let turn = TAU / motion.spin(end);
    let last = plane(centimetres(end - turn, end, 800)?);
    plot.curve("last", last.iter().copied(), Stroke::Heavy, Hue::Ink);
    let outermost = plane(centimetres(widest - 0.35, widest - 0.33, 1)?);
    let [before, tip] = [plot.at(outermost[0]), plot.at(outermost[1])];
    kit::head(plot.drawing(), tip, tip - before, 1.0, Hue::Ink);
    // Which is the last circle, and how large.
    let radius = last.iter().map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max);
    let named = at(250.0, 306.0);
    let ring = origin + (named - origin).unit() * (radius * scale);
    path.line(ring, named - at(0.0, 12.0), Stroke::Dotted, Hue::Ink);
    path.label(named, Side::Over, &format!("for ever: ${radius:.1}$ cm"), Hue::Ink)?;
    path.dot(origin, 3.4, Hue::Ink);
    let bar = [at(40.0, 306.0), at(40.0 + 2.0 * scale, 306.0)];
    kit::dimension(&mut path, bar[0], bar[1], Heads::Both, Hue::Muted);
    path.label(bar[1], Side::Right, "2 cm", Hue::Muted)?;

    let mut trace = Drawing::new("", 340.0, 330.0).titled(
        "The swing of the drum as it speeds up",
        "The displacement of the drum in one direction, in centimetres, against the time in seconds, like the trace of a pen on moving paper, \
         while the drum speeds up evenly to 310 turns a minute in 13 seconds. It is small at first, swells to more than five centimetres \
         at five seconds, and shrinks to nearly two centimetres, ever faster.",
    );
    let time = Axis::linear(0.0, end, 5.0).minor(1.0).titled("time, s");
    let swing = Axis::linear(-6.0, 6.0, 2.0).minor(1.0).titled("displacement to one side, cm");
    let mut plot = Plot::new(&mut trace, Rect::new(44.0, 34.0, 276.0, 244.0), time, swing)?;
    plot.level(0.0, Stroke::Dotted);
    let side = |way: Vec<(f64, Complex<f64>)>| way.into_iter().map(|(t, z)| (t, z.re)).collect::<Values>();
    plot.curve("shrinks", side(centimetres(widest, end, 4000)?), Stroke::Orbit, Hue::Muted);
    plot.curve("swells", side(centimetres(0.0, widest, 1500)?), Stroke::Curve, Hue::Ink);
    plot.label((0.3, 2.6), Side::AboveRight, "it shakes", Hue::Ink)?;
    plot.label((9.6, 3.2), Side::Above, "and grows calm", Hue::Muted)?;
    Ok(Drawing::panels(id, vec![path, trace]))
}

/// Speeding up through the resonance.
pub(crate) fn ramp(id: &str) -> Outcome {
    let machine = washing_machine(0.02, 0.0)?;
    let mut ramps = Vec::new();
    for (per_square, points, stroke, hue) in [
        (0.001, 8000, Stroke::Outline, Hue::Muted),
        (0.01, 2000, Stroke::Curve, Hue::Ink),
        (0.1, 600, Stroke::Heavy, Hue::Ink),
    ] {
        let motion = machine.ramp(per_square * NATURAL * NATURAL, Shaft::AT_REST)?;
        let end = 2.5 / (per_square * NATURAL);
        let times: Vec<f64> = linear_steps(0.0, end, points).collect();
        let values = times
            .iter()
            .zip(motion.sample(&times)?)
            .map(|(&t, shaft)| (motion.spin(t) / NATURAL, shaft.position.norm() / machine.offset()));
        ramps.push((per_square, stroke, hue, values.collect::<Values>()));
    }
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 400.0).titled(
            "Speeding up through the resonance",
            "The distance of the shaft from O over b against the spin in natural frequencies, from 0 to 2.5, while the drum speeds up, at \
             three rates. All three follow the curve of the steady motion at first. The slowest ramp reaches 29 at a spin of 1.06, the next \
             13 at 1.2, the fastest 5 at 1.7, and each then beats with the load, ever faster and ever less.",
        );
        let spin = Axis::linear(0.0, 2.5, 0.5).minor(0.1).titled(r"spin reached $\dot\phi/\omega_0$");
        let title =
            room.of("distance of the shaft from $O$, in units of $b$", "distance from $O$, in units of $b$");
        let radius = Axis::linear(0.0, 30.0, 10.0).minor(2.0).titled(title);
        let frame = Rect::new(58.0, 34.0, room.of(508.0, 316.0), 312.0);
        let mut plot = Plot::new(&mut drawing, frame, spin, radius)?;
        plot.upright(1.0, Stroke::Dotted);
        for (branch, from, to) in [("steady-below", 0.0, 0.99), ("steady-above", 1.01, 2.5)] {
            let values =
                over_spin(0.02, from, to, |machine| Ok(machine.steady()?.radius() / machine.offset()))?;
            plot.curve(branch, values, Stroke::Reference, Hue::Muted);
        }
        for (per_square, stroke, hue, values) in &ramps {
            plot.curve(&format!("ramp-{per_square}"), values.iter().copied(), *stroke, *hue);
        }
        plot.label((room.of(1.08, 1.1), 26.5), Side::Right, r"$\alpha/\omega_0^2 = 0.001$", Hue::Muted)?;
        plot.label((room.of(1.2, 1.24), 13.2), Side::AboveRight, "$0.01$", Hue::Ink)?;
        plot.label((1.72, 4.4), Side::Below, "$0.1$", Hue::Ink)?;
        plot.label((0.955, 11.0), Side::Left, "steady", Hue::Muted)?;
        Ok(drawing)
    })
}

/// The largest swing over acceleration and damping.
pub(crate) fn ramp_map(id: &str) -> Outcome {
    let [slowest, quickest, lightest, heaviest] = [1e-4_f64, 1.0, 1e-2, 1.0];
    // Along lines of constant Γ/√α the swing falls all the way; each level is met once.
    let levels = [2.0, 3.0, 5.0, 10.0, 20.0, 50.0];
    let mut lines = levels.map(|_| Values::new());
    for ratio in log_steps(lightest / quickest.sqrt(), heaviest / slowest.sqrt(), 240) {
        let from = slowest.max((lightest / ratio).powi(2));
        let to = quickest.min((heaviest / ratio).powi(2));
        let swings = log_steps(0.5 * from, 2.0 * to, 60)
            .map(|square| Ok((square, largest_swing(square, ratio * square.sqrt())?)))
            .collect::<Result<Values, Cause>>()?;
        for (level, line) in levels.iter().zip(&mut lines) {
            for pair in swings.windows(2) {
                let [(a, above), (b, below)] = [pair[0], pair[1]];
                if (below..above).contains(level) {
                    let part = (above / level).ln() / (above / below).ln();
                    let square = a * (b / a).powf(part);
                    line.push((square, ratio * square.sqrt()));
                }
            }
        }
    }
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 470.0).titled(
            "The largest swing on the way through the resonance",
            "A map with logarithmic scales: along x the acceleration over the square of the natural frequency, from 1e-4 to 1, along y the \
             damping over the natural frequency, from 0.01 to 1. Lines join the machines whose largest swing is 2, 3, 5, 10, 20 and 50 \
             times b. Each runs level from the left, bends at the dashed diagonal, where the damping is the root of the acceleration, and \
             then runs straight down. The half above the diagonal is called the damper's, that below the motor's. Three \
             rings near the lower edge, at the damping 0.02, are the ramps of the figure before.",
        );
        let acceleration = Axis::log(slowest, quickest, 1).titled(r"acceleration $\alpha/\omega_0^2$");
        let damping = Axis::log(lightest, heaviest, 1).titled(r"damping $\Gamma/\omega_0$");
        let mut plot = Plot::new(
            &mut drawing,
            Rect::new(58.0, 34.0, room.of(508.0, 316.0), 384.0),
            acceleration,
            damping,
        )?;
        let motors = [(slowest, lightest), (quickest, lightest), (quickest, heaviest)];
        let motors = motors.map(|value| plot.at(value));
        plot.drawing().polygon(motors.to_vec(), Fill::Ground, Hue::Muted);
        plot.reference((slowest, lightest), (quickest, heaviest), Stroke::Border);

        for (level, line) in levels.iter().zip(&lines) {
            plot.curve(&format!("swing-{level}"), line.iter().copied(), Stroke::Curve, Hue::Ink);
        }
        plot.markers(&[0.1, 0.01, 0.001].map(|square| (square, 0.02)), Marker::Ring, Hue::Ink);
        let steady = [
            (0.52, "$2b$"),
            (0.34, "$3b$"),
            (0.2, "$5b$"),
            (0.1, "$10b$"),
            (0.05, "$20b$"),
            (0.0177, "$50b$"),
        ];
        for (damping, text) in steady {
            let place = plot.at((1.25e-4, damping));
            plot.drawing().label_on_face(place, Side::AboveRight, text, Hue::Ink)?;
        }
        for (value, text) in [
            ((2.4e-3, 0.26), room.of("the damper decides", "the damper")),
            ((0.04, 0.04), room.of("the motor", "motor")),
        ] {
            let place = plot.at(value);
            plot.drawing().label_on_face(place, Side::Over, text, Hue::Ink)?;
        }
        let place = plot.at((2.5e-3, 0.05));
        plot.drawing().label_on_face(place, Side::AboveLeft, r"$\Gamma = \sqrt{\alpha}$", Hue::Ink)?;
        Ok(drawing)
    })
}

/// The largest distance from O over b of a drum that speeds up from rest, through its resonance and on until the
/// swing falls off, for α/ω₀² and Γ/ω₀.
fn largest_swing(per_square: f64, damping: f64) -> Result<f64, Cause> {
    let machine = washing_machine(damping, 0.0)?;
    let ramp = machine.ramp(per_square * NATURAL * NATURAL, Shaft::AT_REST)?;
    let largest = |from: f64, to: f64, count: u32| -> Result<(f64, f64), Cause> {
        let times: Vec<f64> = linear_steps(from, to, count).collect();
        let swings = ramp.sample(&times)?.into_iter().map(|shaft| shaft.position.norm());
        let largest = times.into_iter().zip(swings).max_by(|a, b| a.1.total_cmp(&b.1));
        largest.ok_or_else(|| "no states".into())
    };
    let (end, count) = ((1.6 + 6.0 * per_square.sqrt()) / (per_square * NATURAL), 800);
    let (time, _) = largest(0.0, end, count)?;
    let step = end / f64::from(count);
    Ok(largest((time - step).max(0.0), time + step, 40)?.1 / machine.offset())
}

/// A slow passage without damping, from so long before the resonance to so long after it, in units of 1/√α: the way of
/// its amplitude on Cornu's spiral, seen by who turns with ω₀, over what is left.
fn amplitude(from: f64, to: f64, count: u32) -> Result<Values, Cause> {
    let machine = washing_machine(0.0, 0.0)?;
    let square = NATURAL * NATURAL;
    let slowest = 1e-8 * square;
    let ramp = machine.ramp(slowest, Shaft::AT_REST)?;
    let met = NATURAL / slowest;
    let times: Vec<f64> = linear_steps(from, to, count).map(|time| met + time / slowest.sqrt()).collect();
    // Turned so that it sets out along x.
    let begun = Complex::from_polar(1.0, FRAC_PI_2 - 0.5 * square / slowest);
    let left = left_behind(machine.offset(), slowest);
    let seen = |(t, shaft): (&f64, Shaft)| {
        let seen = shaft.position * begun * Complex::from_polar(1.0, -NATURAL * (t - met)) / left;
        (seen.re, seen.im)
    };
    Ok(times.iter().zip(ramp.sample(&times)?).map(seen).collect())
}

/// Lewis's amplitude, which a slow passage leaves behind without damping, m.
fn left_behind(offset: f64, acceleration: f64) -> f64 {
    offset * NATURAL * (FRAC_PI_2 / acceleration).sqrt()
}

/// Cornu's spiral: from eye to eye what is left, and the longer way to its farthest point.
pub(crate) fn cornu(id: &str) -> Outcome {
    let spiral = amplitude(-7.0, 9.0, 6000)?;
    let far = |a: &&(f64, f64), b: &&(f64, f64)| a.0.hypot(a.1).total_cmp(&b.0.hypot(b.1));
    let farthest = *spiral.iter().max_by(far).ok_or("no spiral")?;
    let mut drawing = Drawing::new(id, 340.0, 320.0).titled(
        "Cornu’s spiral",
        "A row of short arrows, put end to end, unwinds from a point at the lower left, the first eye, runs almost straight to the upper right \
         and winds up again about a second eye. The straight way from eye to eye has the length one. The farthest point from the first \
         eye, marked with a disc, lies beyond the second eye, at the distance 1.17. The middle of the almost straight part is marked as the resonance.",
    );
    let origin = at(64.0, 244.0);
    let mut plot = Plot::plane(&mut drawing, origin, 236.0, 1.4)?;
    plot.curve("spiral", spiral.iter().copied(), Stroke::Outline, Hue::Ink);
    // The pushes of equal times, put end to end, where they can be told apart.
    for step in amplitude(-3.2, 2.8, 12)?.windows(2) {
        let [from, to] = [plot.at(step[0]), plot.at(step[1])];
        kit::head(plot.drawing(), to, to - from, 0.8, Hue::Ink);
    }
    let middle = plot.at(amplitude(-0.001, 0.0, 1)?[1]);
    let (eye, tip) = (plot.at((0.5_f64.sqrt(), 0.5_f64.sqrt())), plot.at(farthest));
    drawing.line(origin, eye, Stroke::Reference, Hue::Muted);
    drawing.line(origin, tip, Stroke::Curve, Hue::Ink);
    for place in [origin, eye] {
        drawing.dot(place, 3.4, Hue::Ink);
    }
    drawing.dot(tip, 4.5, Hue::Ink);
    drawing.label(tip + at(4.0, 0.0), Side::Right, "$1.17$", Hue::Ink)?;
    drawing.label(middle + at(6.0, 8.0), Side::BelowRight, "resonance", Hue::Muted)?;
    Ok(drawing)
}

/// How far less slow passages swing, over what they leave behind.
pub(crate) fn overshoot(id: &str) -> Outcome {
    let machine = washing_machine(0.0, 0.0)?;
    let mut factors = Values::new();
    for root in linear_steps(0.005, 0.2, 390) {
        let acceleration = root * root * NATURAL * NATURAL;
        let ramp = machine.ramp(acceleration, Shaft::AT_REST)?;
        let times: Vec<f64> = linear_steps(0.0, 4.0, 2000)
            .map(|time| NATURAL / acceleration + time / acceleration.sqrt())
            .collect();
        let swings = ramp.sample(&times)?.into_iter().map(|shaft| shaft.position.norm());
        factors.push((root, swings.fold(0.0, f64::max) / left_behind(machine.offset(), acceleration)));
    }
    let mut drawing = Drawing::new(id, 340.0, 300.0).titled(
        "The overshoot of a passage that is less slow",
        "The largest swing over the swing that is left behind, from 1.1 to 1.3, against the root of the acceleration over the natural frequency, from 0 to \
         0.2. The curve begins at 1.17 and rises to 1.3 along a straight dashed line, which it leaves by a hair at the right.",
    );
    let root =
        Axis::linear(0.0, 0.2, 0.1).minor(0.02).titled(r"root of the acceleration $\sqrt\alpha/\omega_0$");
    let factor = Axis::linear(1.1, 1.3, 0.1).minor(0.02).titled("largest swing over Lewis’s amplitude");
    let mut plot = Plot::new(&mut drawing, Rect::new(50.0, 34.0, 270.0, 214.0), root, factor)?;
    let line = [0.0, 0.2].map(|root| (root, OVERSHOOT + 0.75 * FRAC_PI_2.sqrt().recip() * root));
    plot.curve("line", line, Stroke::DashedCurve, Hue::Muted);
    plot.curve("overshoot", factors, Stroke::Curve, Hue::Ink);
    plot.markers(&[(0.0, OVERSHOOT)], Marker::Disc, Hue::Ink);
    plot.label((0.008, OVERSHOOT), Side::BelowRight, "$1.1707$", Hue::Ink)?;
    Ok(drawing)
}

/// The farthest point of Cornu's spiral from one eye, over the distance of the other.
const OVERSHOOT: f64 = 1.170_659;

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

    let mut path = Drawing::new("", 330.0, 330.0).titled(
        "The path of the drum’s centre, from above",
        "The centre of the drum starts at rest in the middle and spirals outwards, counter-clockwise, to more than five centimetres. Then it \
         spirals inwards again, and in the end goes round on a small circle with a radius of nearly two centimetres, drawn heavily.",
    );
    let (origin, scale) = (at(165.0, 150.0), 24.0);
    let mut plot = Plot::plane(&mut path, origin, scale, 6.0)?;
    plot.curve("outwards", plane(centimetres(0.0, widest, 4000)?), Stroke::Orbit, Hue::Orange);
    plot.curve("inwards", plane(centimetres(widest, end, 16000)?), Stroke::Orbit, Hue::Blue);
    let turn = TAU / motion.spin(end);
    plot.curve("last", plane(centimetres(end - turn, end, 800)?), Stroke::Curve, Hue::Ink);
    let outermost = plane(centimetres(widest - 0.35, widest - 0.33, 1)?);
    let [before, tip] = [plot.at(outermost[0]), plot.at(outermost[1])];
    kit::head(plot.drawing(), tip, tip - before, 1.0, Hue::Orange);
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
    plot.curve("swells", side(centimetres(0.0, widest, 1500)?), Stroke::Outline, Hue::Orange);
    plot.curve("shrinks", side(centimetres(widest, end, 4000)?), Stroke::Outline, Hue::Blue);
    plot.label((0.3, 2.6), Side::AboveRight, "it shakes", Hue::Orange)?;
    plot.label((9.6, 3.2), Side::Above, "and grows calm", Hue::Blue)?;
    Ok(Drawing::panels(id, vec![path, trace]))
}

/// Speeding up through the resonance.
pub(crate) fn ramp(id: &str) -> Outcome {
    let machine = washing_machine(0.02, 0.0)?;
    let mut ramps = Vec::new();
    for (per_square, points, hue) in
        [(0.1, 600, Hue::Green), (0.01, 2000, Hue::Orange), (0.001, 8000, Hue::Blue)]
    {
        let motion = machine.ramp(per_square * NATURAL * NATURAL, Shaft::AT_REST)?;
        let end = 2.5 / (per_square * NATURAL);
        let times: Vec<f64> = linear_steps(0.0, end, points).collect();
        let values = times
            .iter()
            .zip(motion.sample(&times)?)
            .map(|(&t, shaft)| (motion.spin(t) / NATURAL, shaft.position.norm() / machine.offset()));
        ramps.push((per_square, hue, values.collect::<Values>()));
    }
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 400.0).titled(
            "Speeding up through the resonance",
            "The distance of the shaft from O over b against the spin in natural frequencies, from 0 to 2.5, while the drum speeds up, at \
             three rates. All three follow the curve of the steady motion at first. The slowest ramp reaches 29 at a spin of 1.06, the next \
             13 at 1.2, the fastest 5 at 1.7, and each then beats with the load, ever faster and ever less.",
        );
        let spin = Axis::linear(0.0, 2.5, 0.5).minor(0.1).titled(r"spin reached $\dot\phi/\omega_0$");
        let title =
            room.of("distance of the shaft from $O$, in units of $b$", "distance from $O$, in units of $b$");
        let radius = Axis::linear(0.0, 30.0, 10.0).minor(2.0).titled(title);
        let frame = Rect::new(58.0, 34.0, room.of(580.0, 316.0), 312.0);
        let mut plot = Plot::new(&mut drawing, frame, spin, radius)?;
        plot.upright(1.0, Stroke::Dotted);
        for (branch, from, to) in [("steady-below", 0.0, 0.99), ("steady-above", 1.01, 2.5)] {
            let values =
                over_spin(0.02, from, to, |machine| Ok(machine.steady()?.radius() / machine.offset()))?;
            plot.curve(branch, values, Stroke::Dotted, Hue::Muted);
        }
        for (per_square, hue, values) in &ramps {
            plot.curve(&format!("ramp-{per_square}"), values.iter().copied(), Stroke::Curve, *hue);
        }
        plot.label((room.of(1.08, 1.1), 26.5), Side::Right, r"$\alpha/\omega_0^2 = 0.001$", Hue::Blue)?;
        plot.label((room.of(1.2, 1.24), 13.2), Side::AboveRight, "$0.01$", Hue::Orange)?;
        plot.label((1.72, 4.6), Side::Below, "$0.1$", Hue::Green)?;
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
    for ratio in log_steps(lightest / quickest.sqrt(), heaviest / slowest.sqrt(), 90) {
        let from = slowest.max((lightest / ratio).powi(2));
        let to = quickest.min((heaviest / ratio).powi(2));
        let swings = log_steps(0.5 * from, 2.0 * to, 40)
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
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 470.0).titled(
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
            Rect::new(58.0, 34.0, room.of(580.0, 316.0), 384.0),
            acceleration,
            damping,
        )?;
        let corner = |hue, value, plot: &mut Plot<'_>| {
            let corners = [(slowest, lightest), value, (quickest, heaviest)].map(|value| plot.at(value));
            plot.drawing().polygon(corners.to_vec(), Fill::Ground, hue);
        };
        corner(Hue::Blue, (slowest, heaviest), &mut plot);
        corner(Hue::Orange, (quickest, lightest), &mut plot);
        plot.reference((slowest, lightest), (quickest, heaviest), Stroke::Border);

        for (level, line) in levels.iter().zip(&lines) {
            plot.curve(&format!("swing-{level}"), line.iter().copied(), Stroke::Curve, Hue::Ink);
        }
        for (square, hue) in [(0.1, Hue::Green), (0.01, Hue::Orange), (0.001, Hue::Blue)] {
            plot.markers(&[(square, 0.02)], Marker::Ring, hue);
        }
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
        for (value, text, hue) in [
            ((1e-3, 0.25), "the damper", Hue::Blue),
            ((0.045, 0.04), room.of("the motor", "motor"), Hue::Orange),
        ] {
            let place = plot.at(value);
            plot.drawing().label_on_face(place, Side::Over, text, hue)?;
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

/// A slow passage without damping: where the swing goes on Cornu's spiral, and how far it goes if it is less slow.
pub(crate) fn cornu(id: &str) -> Outcome {
    let machine = washing_machine(0.0, 0.0)?;
    let (b, square) = (machine.offset(), NATURAL * NATURAL);
    // Times are counted from the resonance, in units of 1/√α.
    let slowest = 1e-8 * square;
    let lewis = |acceleration: f64| b * NATURAL * (FRAC_PI_2 / acceleration).sqrt();
    let slow = machine.ramp(slowest, Shaft::AT_REST)?;
    let met = NATURAL / slowest;
    let times: Vec<f64> = linear_steps(-7.0, 9.0, 6000).map(|time| time / slowest.sqrt()).collect();
    let late: Vec<f64> = times.iter().map(|time| met + time).collect();
    // Seen by who turns with ω₀, and turned so that it sets out along x.
    let begun = Complex::from_polar(1.0, FRAC_PI_2 - 0.5 * square / slowest);
    let spiral: Values = late
        .iter()
        .zip(slow.sample(&late)?)
        .map(|(t, shaft)| {
            let seen =
                shaft.position * begun * Complex::from_polar(1.0, -NATURAL * (t - met)) / lewis(slowest);
            (seen.re, seen.im)
        })
        .collect();
    let far = |a: &&(f64, f64), b: &&(f64, f64)| a.0.hypot(a.1).total_cmp(&b.0.hypot(b.1));
    let farthest = *spiral.iter().max_by(far).ok_or("no spiral")?;

    let mut left = Drawing::new("", 330.0, 330.0).titled(
        "Cornu’s spiral",
        "A curve that unwinds from a point at the lower left, the first eye, runs to the upper right and winds up again about a second eye, \
         at the distance one. Its farthest point from the first eye, marked with a disc, lies at a distance of 1.17, beyond the second eye.",
    );
    let origin = at(70.0, 244.0);
    let mut plot = Plot::plane(&mut left, origin, 210.0, 1.4)?;
    plot.curve("spiral", spiral.iter().copied(), Stroke::Outline, Hue::Blue);
    let (eye, tip) = (plot.at((0.5_f64.sqrt(), 0.5_f64.sqrt())), plot.at(farthest));
    left.line(origin, eye, Stroke::Reference, Hue::Muted);
    left.line(origin, tip, Stroke::Outline, Hue::Ink);
    left.dot(origin, 3.4, Hue::Ink);
    left.dot(eye, 3.4, Hue::Ink);
    left.dot(tip, 4.5, Hue::Orange);
    left.label(tip, Side::Right, "$1.1707$", Hue::Orange)?;
    left.label(at(165.0, 312.0), Side::Over, "seen turning with $\\omega_0$", Hue::Ink)?;

    let mut factors = Values::new();
    for root in linear_steps(0.005, 0.2, 59) {
        let acceleration = root * root * square;
        let ramp = machine.ramp(acceleration, Shaft::AT_REST)?;
        let times: Vec<f64> = linear_steps(0.0, 4.0, 4000)
            .map(|time| NATURAL / acceleration + time / acceleration.sqrt())
            .collect();
        let swings = ramp.sample(&times)?.into_iter().map(|shaft| shaft.position.norm());
        factors.push((root, swings.fold(0.0, f64::max) / lewis(acceleration)));
    }
    let limit = OVERSHOOT;
    let mut right = Drawing::new("", 340.0, 330.0).titled(
        "The overshoot of a passage that is less slow",
        "The largest swing over the swing that is left behind, from 1.1 to 1.3, against the root of the acceleration over the natural frequency, from 0 to \
         0.2. The curve begins at 1.17 and rises to 1.3 along a straight broken line, which it leaves by a hair at the right.",
    );
    let root = Axis::linear(0.0, 0.2, 0.1).minor(0.02).titled(r"$\sqrt\alpha/\omega_0$");
    let factor = Axis::linear(1.1, 1.3, 0.1).minor(0.02).titled("largest swing over what is left");
    let mut plot = Plot::new(&mut right, Rect::new(58.0, 34.0, 262.0, 244.0), root, factor)?;
    let line = [0.0, 0.2].map(|root| (root, limit + 0.75 * FRAC_PI_2.sqrt().recip() * root));
    plot.curve("line", line, Stroke::DashedCurve, Hue::Orange);
    plot.curve("overshoot", factors, Stroke::Curve, Hue::Blue);
    plot.markers(&[(0.0, limit)], Marker::Disc, Hue::Orange);
    plot.label((0.012, limit), Side::BelowRight, "$1.1707$", Hue::Orange)?;
    Ok(Drawing::panels(id, vec![left, right]))
}

/// The farthest point of Cornu's spiral from one eye, over the distance of the other.
const OVERSHOOT: f64 = 1.170_659;

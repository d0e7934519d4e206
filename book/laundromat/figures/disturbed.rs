//! The disturbed machine: does it return, and which way?

use super::{NATURAL, Values, cross, washing_machine};
use drawing::kit::{self, Heads, Marker};
use drawing::{Drawing, Hue, Rect, Role, Side, Stroke, at};
use figures::{Axis, Cause, Outcome, Plot, Room, in_both, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::scenes::laundromat::{LockedState, Machine, Mode, Polar, Shaft};
use nalgebra::Complex;
use std::f64::consts::TAU;

/// With its angle locked the machine runs away; free, it returns.
pub(crate) fn locked(id: &str) -> Outcome {
    let machine = washing_machine(0.3, 1.5)?;
    let (b, steady) = (machine.offset(), machine.steady()?);
    let (radius, azimuth, spin) = (1.3 * steady.radius(), -steady.phase(), machine.spin());
    let runaway = machine.locked(LockedState { radius, radius_rate: 0.0 })?;
    let start = Polar { radius, azimuth, radius_rate: 0.0, azimuth_rate: spin };
    let free = machine.transient(Shaft::from_polar(start))?;

    let times = || linear_steps(0.0, 2.5, 1500);
    let returning =
        times().map(|t| Ok((t, free.at(t)?.position.norm() / b))).collect::<Result<Vec<_>, Cause>>()?;
    let leaving = times().map(|t| Ok((t, runaway.at(t)?.radius / b))).collect::<Result<Vec<_>, Cause>>()?;
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 320.0).titled(
            "Locked and free motion after the same disturbance",
            "The distance of the shaft from O, over b, against time, at one and a half natural frequencies. Both motions start at rest \
             in the turning frame, three tenths beyond the steady radius of 1.7 b. With the angle locked the distance \
             grows exponentially \
             and leaves the plot after a quarter of a second. The free motion swings about the steady radius and comes \
             back to it within two seconds.",
        );
        let time = Axis::linear(0.0, 2.5, 0.5).minor(0.1).titled("time, s");
        let radius = Axis::linear(0.0, 5.0, 1.0).minor(0.5).titled("distance of the shaft from $O$, $r/b$");
        let frame = Rect::new(58.0, 34.0, room.of(580.0, 316.0), 234.0);
        let mut plot = Plot::new(&mut drawing, frame, time, radius)?;
        plot.level(steady.radius() / b, Stroke::Reference);
        plot.curve("locked", leaving.iter().copied(), Stroke::Curve, Hue::Orange);
        plot.curve("free", returning.iter().copied(), Stroke::Curve, Hue::Blue);
        plot.label((0.24, 3.8), Side::Right, "angle locked: it runs away", Hue::Orange)?;
        plot.label((0.55, 2.0), Side::AboveRight, "free: it returns", Hue::Blue)?;
        plot.label((2.48, steady.radius() / b), Side::BelowLeft, "steady radius $r_0$", Hue::Muted)?;
        Ok(drawing)
    })
}

/// One kick, seen from the turning drum and in the room.
pub(crate) fn frames(id: &str) -> Outcome {
    let machine = washing_machine(0.2, 2.2)?;
    let amplitude = machine.steady()?.amplitude();
    let radius = amplitude.norm();
    let spin = Complex::new(0.0, machine.spin());
    let kick = Complex::from(radius * NATURAL);
    let kicked = Shaft { position: amplitude, velocity: amplitude * spin + kick };
    let motion = machine.transient(kicked)?;
    let mut ways = [Values::new(), Values::new()];
    for time in linear_steps(0.0, 4.0, 4000) {
        let disturbance = motion.at(time)?.position - amplitude * machine.load_direction(time);
        let turning = disturbance * machine.load_direction(time).conj();
        ways[0].push((turning.re, turning.im));
        ways[1].push((disturbance.re, disturbance.im));
    }
    let mut panels = Vec::new();
    for ((name, text, words), way) in [
        (
            "turning",
            "riding on the drum",
            "As seen from the turning drum: the shaft leaves its steady place, passes it again and again on the loops of a rosette, and the \
             loops shrink to a point.",
        ),
        (
            "room",
            "standing in the room",
            "As seen in the room: the centre of the shaft’s circle swings to and fro on a straight line through the steady place, like a mass \
             on a spring. Dots mark where it turns back, each nearer than the one before.",
        ),
    ]
    .into_iter()
    .zip(&ways)
    {
        let mut drawing = Drawing::new("", 320.0, 340.0).titled(&format!("One kick, {text}"), words);
        let origin = at(160.0, 150.0);
        let mut plot = Plot::plane(&mut drawing, origin, 128.0 / (0.87 * radius), 1.1 * radius)?;
        plot.curve(name, way.iter().copied(), Stroke::Orbit, Hue::Blue);
        let [before, next] = [way[75], way[80]].map(|value| plot.at(value));
        kit::head(plot.drawing(), next, next - before, 0.8, Hue::Blue);
        plot.label(way[80], Side::Below, "after the kick", Hue::Blue)?;
        if name == "room" {
            let turns = way.windows(3).filter(|near| {
                near[1].0.abs() > near[0].0.abs() && near[1].0.abs() > near[2].0.abs()
            });
            for turn in turns {
                let place = plot.at(turn[1]);
                plot.drawing().dot(place, 2.6, Hue::Blue);
            }
        }
        drawing.dot(origin, 2.6, Hue::Ink);
        drawing.label(at(160.0, 282.0), Side::Over, text, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels))
}

/// One mode at a time: the circle’s centre goes backwards, or forwards.
pub(crate) fn annulus(id: &str) -> Outcome {
    let machine = washing_machine(0.0, 3.3)?;
    let (radius, size) = (machine.steady()?.radius(), 0.3);
    let scale = 108.0 / radius;
    let mut panels = Vec::new();
    for (mode, sense, name, words) in [
        (
            0,
            -1.0,
            r"$\omega = \Omega + \omega_1$: backwards",
            "The mode of frequency Omega plus omega one: the path fills the ring between two dashed circles, while the centre of the shaft’s \
             circle goes round the dotted one clockwise, against the drum.",
        ),
        (
            1,
            1.0,
            r"$\omega = \Omega - \omega_1$: forwards",
            "The mode of frequency Omega minus omega one: the path fills the same ring, and the centre goes round counter-clockwise, with the drum.",
        ),
    ] {
        let mut drawing = Drawing::new("", 320.0, 340.0).titled("The ring filled by one mode", words);
        let origin = at(160.0, 152.0);
        let start = disturbed(&machine, machine.modes()[mode], size)?;
        let turns = 7.0;
        let times = linear_steps(0.0, turns * TAU / machine.spin(), 4000);
        let (path, centres) = path_and_centre(&machine, start, times)?;
        let mut plot = Plot::plane(&mut drawing, origin, scale, 1.4 * radius)?;
        for bound in [1.0 - size, 1.0 + size] {
            plot.drawing().circle(origin, bound * radius * scale, Role::Line(Stroke::Reference, Hue::Muted));
        }
        plot.curve(&format!("path-{mode}"), path.iter().copied(), Stroke::Orbit, Hue::Blue);
        plot.drawing().circle(origin, size * radius * scale, Role::Line(Stroke::Dotted, Hue::Orange));
        if let (Some(&shaft), Some(&centre)) = (path.last(), centres.last()) {
            let [shaft, centre] = [plot.at(shaft), plot.at(centre)];
            let drawing = plot.drawing();
            let from = (centre - origin).angle() + sense * 0.35;
            let reach = size * radius * scale + 9.0;
            kit::angle(drawing, origin, reach, from, sense * 1.5, Heads::End, Hue::Orange);
            drawing.line(centre, shaft, Stroke::Outline, Hue::Ink);
            drawing.dot(centre, 4.0, Hue::Orange);
            kit::marker(drawing, shaft, Marker::Ring, Hue::Ink);
            cross(drawing, origin, 5.0);
        }
        drawing.label(at(160.0, 316.0), Side::Over, name, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels))
}

/// Where the shaft starts when one mode of the steady motion is excited with the size ε₀, a part of the steady radius.
fn disturbed(machine: &Machine, mode: Mode, size: f64) -> Result<Shaft, InvalidQuantity> {
    let amplitude = machine.steady()?.amplitude();
    let spin = Complex::new(0.0, machine.spin());
    let drift = Complex::new(0.0, -1.0) * mode.frequency.conj(); // ζ = ε + iδ = ε₀ e^{−iω*t}
    Ok(Shaft {
        position: amplitude * (1.0 + size),
        velocity: amplitude * (spin * (1.0 + size) + drift * size),
    })
}

/// The shaft's path and the path of the centre of its circle, m, at these times.
fn path_and_centre(
    machine: &Machine,
    start: Shaft,
    times: impl Iterator<Item = f64>,
) -> Result<(Values, Values), Cause> {
    let (motion, amplitude) = (machine.transient(start)?, machine.steady()?.amplitude());
    let (mut path, mut centres) = (Vec::new(), Vec::new());
    for time in times {
        let shaft = motion.at(time)?.position;
        let centre = shaft - amplitude * machine.load_direction(time);
        path.push((shaft.re, shaft.im));
        centres.push((centre.re, centre.im));
    }
    Ok((path, centres))
}

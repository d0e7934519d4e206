//! The disturbed machine: does it return, and which way?

use super::{NATURAL, Values, cross, washing_machine};
use drawing::kit::{self, Heads, Marker};
use drawing::{Drawing, Fill, Hue, Point, Rect, Role, Side, Stroke, at};
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
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 320.0).titled(
            "Locked and free motion after the same disturbance",
            "The distance of the shaft from O, over b, against time, at one and a half natural frequencies. Both motions start at rest \
             in the turning frame, three tenths beyond the steady radius of 1.7 b. With the angle locked the distance \
             grows exponentially \
             and leaves the plot after a quarter of a second. The free motion swings about the steady radius and comes \
             back to it within two seconds.",
        );
        let time = Axis::linear(0.0, 2.5, 0.5).minor(0.1).titled("time, s");
        let radius = Axis::linear(0.0, 5.0, 1.0).minor(0.5).titled("distance of the shaft from $O$, $r/b$");
        let frame = Rect::new(58.0, 34.0, room.of(508.0, 316.0), 234.0);
        let mut plot = Plot::new(&mut drawing, frame, time, radius)?;
        plot.level(steady.radius() / b, Stroke::Reference);
        plot.curve("locked", leaving.iter().copied(), Stroke::Curve, Hue::Muted);
        plot.curve("free", returning.iter().copied(), Stroke::Heavy, Hue::Ink);
        plot.label((0.24, 3.8), Side::Right, "angle locked: it runs away", Hue::Muted)?;
        plot.label((0.55, 2.0), Side::AboveRight, "free: it returns", Hue::Ink)?;
        plot.label((2.48, steady.radius() / b - 0.1), Side::BelowLeft, "steady radius $r_0$", Hue::Muted)?;
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
    let seen = |time: f64| -> Result<[(f64, f64); 2], Cause> {
        let apart = motion.at(time)?.position - amplitude * machine.load_direction(time);
        let turning = apart * machine.load_direction(time).conj();
        Ok([(turning.re, turning.im), (apart.re, apart.im)])
    };
    let mut ways = [Values::new(), Values::new()];
    // Where the swing turns back, at the same instants on both.
    let mut turns = Vec::new();
    for time in linear_steps(0.0, 4.0, 4000) {
        let places = seen(time)?;
        for (way, place) in ways.iter_mut().zip(places) {
            way.push(place);
        }
        if let [.., before, middle, after] = ways[1][..]
            && middle.0.abs() > before.0.abs()
            && middle.0.abs() > after.0.abs()
        {
            turns.push(ways.each_ref().map(|way| way[way.len() - 2]));
        }
    }
    let mut panels = Vec::new();
    for (panel, (name, text, words)) in [
        (
            "turning",
            "riding on the drum",
            "As seen from the turning drum: from its steady place, which the kick leads away from to the right, the shaft runs out on a wide loop, \
             passes the place again and again on the loops of a rosette, and the loops shrink to a point. Dots with the numbers 1 to 4 mark \
             where it is farthest, in one direction after another.",
        ),
        (
            "room",
            "standing in the room",
            "As seen in the room: the centre of the shaft’s circle swings to and fro on a straight line through the steady place, like a mass \
             on a spring. Dots with the numbers 1 to 4 mark where it turns back, on the right, on the left, on the right, on the left, each \
             nearer than the one before.",
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let mut drawing = Drawing::new("", 280.0, 244.0).titled(&format!("One kick, {text}"), words);
        let origin = at(140.0, 132.0);
        let mut plot = Plot::plane(&mut drawing, origin, 108.0 / (0.87 * radius), 1.1 * radius)?;
        plot.curve(name, ways[panel].iter().copied(), Stroke::Orbit, Hue::Ink);
        for (number, turn) in turns.iter().take(4).enumerate() {
            let place = plot.at(turn[panel]);
            plot.drawing().dot(place, 3.4, Hue::Ink);
            // Beside the line, or outside the loop.
            let outward = if panel == 1 { at(0.0, -14.0) } else { (place - origin).unit() * 13.0 };
            let number = format!("${}$", number + 1);
            plot.drawing().label(place + outward, Side::Over, &number, Hue::Ink)?;
        }
        // The blow itself, along the way on which it sends the shaft.
        let aside = at(0.0, if panel == 1 { 15.0 } else { 0.0 });
        kit::arrow(&mut drawing, origin + aside, origin + at(44.0, 0.0) + aside, Hue::Pink);
        if panel == 1 {
            drawing.label(origin + at(22.0, 17.0), Side::Below, "kick", Hue::Pink)?;
            drawing.label(origin + at(-30.0, -34.0), Side::Over, "steady place", Hue::Muted)?;
            drawing.line(origin + at(-8.0, -22.0), origin + at(-1.0, -6.0), Stroke::Dotted, Hue::Muted);
        }
        drawing.dot(origin, 3.4, Hue::Ink);
        drawing.label(at(140.0, 226.0), Side::Over, text, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels))
}

/// One mode at a time: the circle’s centre goes backwards, or forwards.
pub(crate) fn annulus(id: &str) -> Outcome {
    let machine = washing_machine(0.0, 3.3)?;
    let (radius, size) = (machine.steady()?.radius(), 0.3);
    let scale = 100.0 / radius;
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
        let mut drawing = Drawing::new("", 280.0, 330.0).titled("The ring filled by one mode", words);
        let origin = at(140.0, 140.0);
        let start = disturbed(&machine, machine.modes()[mode], size)?;
        let turns = 7.0;
        let times = linear_steps(0.0, turns * TAU / machine.spin(), 4000);
        let (path, centres) = path_and_centre(&machine, start, times)?;
        let mut plot = Plot::plane(&mut drawing, origin, scale, 1.4 * radius)?;
        for bound in [1.0 - size, 1.0 + size] {
            plot.drawing().circle(origin, bound * radius * scale, Role::Line(Stroke::Reference, Hue::Muted));
        }
        plot.curve(&format!("path-{mode}"), path.iter().copied(), Stroke::Orbit, Hue::Muted);
        plot.drawing().circle(origin, size * radius * scale, Role::Line(Stroke::Dotted, Hue::Ink));
        if let (Some(&shaft), Some(&centre)) = (path.last(), centres.last()) {
            let [shaft, centre] = [plot.at(shaft), plot.at(centre)];
            let drawing = plot.drawing();
            let from = (centre - origin).angle() + sense * 0.35;
            let reach = size * radius * scale + 9.0;
            kit::angle(drawing, origin, reach, from, sense * 1.5, Heads::End, Hue::Ink);
            drawing.line(centre, shaft, Stroke::Outline, Hue::Ink);
            drawing.dot(centre, 4.0, Hue::Ink);
            kit::marker(drawing, shaft, Marker::Ring, Hue::Ink);
            cross(drawing, origin, 5.0);
        }
        drawing.label(at(140.0, 300.0), Side::Over, name, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels))
}

/// A free circle as large as the steady one, run through with the drum and against it: what an exercise asks to sketch.
pub(crate) fn petals(id: &str) -> Outcome {
    let machine = washing_machine(0.0, 3.0)?;
    let steady = machine.steady()?.amplitude();
    let mut panels = Vec::new();
    for (sense, name, words, text) in [
        (
            1.0,
            "hearts",
            "with the drum",
            "The path of the shaft: two heart-shaped loops that overlap, one the mirror image of the other. Both pass through O, marked by a cross. An arrow shows how \
             it sets out, counter-clockwise.",
        ),
        (
            -1.0,
            "petals",
            "against it",
            "The path of the shaft: a flower of four petals that meet in O, marked by a cross. An arrow shows how it sets out from the tip of the right petal, counter-clockwise.",
        ),
    ] {
        let velocity = steady * Complex::new(0.0, machine.spin() + sense * NATURAL);
        let motion = machine.transient(Shaft { position: steady * 2.0, velocity })?;
        let path = linear_steps(0.0, TAU / NATURAL, 800).map(|time| {
            let place = motion.at(time)?.position / steady;
            Ok((place.re, place.im))
        });
        let path = path.collect::<Result<Values, InvalidQuantity>>()?;
        let mut drawing = Drawing::new("", 260.0, 284.0).titled(&format!("The free circle {words}"), text);
        let origin = at(130.0, 124.0);
        let mut plot = Plot::plane(&mut drawing, origin, 54.0, 2.1)?;
        plot.curve(name, path, Stroke::Curve, Hue::Ink);
        let start = plot.at((2.0, 0.0));
        cross(&mut drawing, origin, 10.0);
        kit::arrow(&mut drawing, start + at(8.0, 0.0), start + at(8.0, -34.0), Hue::Ink);
        drawing.dot(start, 4.0, Hue::Ink);
        drawing.label(at(130.0, 264.0), Side::Over, words, Hue::Ink)?;
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

/// The landscape of J about the steady place, a bowl or a hill, and which way dampers take circles about it.
pub(crate) fn landscape(id: &str) -> Outcome {
    let mut panels = Vec::new();
    for (spin, name, scale, words) in [
        (
            0.3,
            r"$\Omega < \omega_0$: a bowl",
            1.15,
            "A bowl, seen from the side. Two circles about its axis hang above its bottom, each on a bowl of its own; the one with the drum is the \
             lower one. Arrows on both sides lead down both bowls to the bottom.",
        ),
        (
            2.2,
            r"$\Omega > \omega_0$: a hill",
            0.42,
            "A hill, seen from the side. The circle that goes with the drum lies on the hill’s flank, below the top, on a hill of its own; the one \
             against the drum hangs above the top, on a bowl. On the right, for the dampers on the floor, arrows lead from both to the top. On the \
             left, for the damper on the radius, an arrow leads from the upper one down to the top, but from the lower one down and outwards.",
        ),
    ] {
        let machine = washing_machine(0.0, spin)?;
        let steady = machine.steady()?.amplitude();
        let omega = Complex::new(0.0, machine.spin());
        let rest = machine.jacobi_integral(0.0, &Shaft { position: steady, velocity: omega * steady });
        // J above the steady place at the distance s from it, for a disturbance that turns with so many rad/s in the room.
        let height = |distance: f64, rate: f64| {
            let (position, velocity) =
                (steady + distance, omega * steady + Complex::new(0.0, rate) * distance);
            machine.jacobi_integral(0.0, &Shaft { position, velocity }) - rest
        };
        let mut drawing = Drawing::new("", 280.0, 350.0).titled("The landscape of J", words);
        let (origin, reach) = (at(140.0, if spin > 1.0 { 190.0 } else { 250.0 }), 92.0);
        let place = |distance: f64, rate: f64| origin + at(reach * distance, -scale * height(distance, rate));
        let profile = |rate: f64, to: f64| -> Vec<Point> {
            linear_steps(-to, to, 120).map(|distance| place(distance, rate)).collect()
        };
        // What stands still for the rider is the ground.
        let ground = profile(machine.spin(), 1.25);
        let foot = if spin > 1.0 { ground[0].y } else { origin.y + 14.0 };
        let mut filled = ground.clone();
        filled.extend([at(ground[120].x, foot), at(ground[0].x, foot)]);
        drawing.polygon(filled, Fill::Ground, Hue::Muted);
        drawing.polyline(&ground, Stroke::Heavy, Hue::Ink);
        let radial = [height(1.0, NATURAL) > 0.0, true];
        for (rate, comes_back, text) in
            [(NATURAL, radial[0], "with the drum"), (-NATURAL, radial[1], "against it")]
        {
            drawing.polyline(&profile(rate, 1.0), Stroke::Outline, Hue::Muted);
            // The circle itself, seen from slightly above; the rider sees both go backwards.
            let [left, right] = [place(-1.0, rate), place(1.0, rate)];
            let ring: Vec<Point> = linear_steps(0.0, TAU, 120)
                .map(|angle| left.towards(right, 0.5) + at(reach * angle.cos(), -9.0 * angle.sin()))
                .collect();
            drawing.polyline(&ring, Stroke::Curve, Hue::Ink);
            let backwards = (rate - machine.spin()).signum();
            kit::head(&mut drawing, ring[90] + at(5.0 * backwards, 0.0), at(backwards, 0.0), 1.0, Hue::Ink);
            // On the hill's face, or above the ring.
            let lower = if rate > 0.0 && spin > 1.0 { 24.0 } else { -20.0 };
            drawing.label_on_face(left.towards(right, 0.5) + at(0.0, lower), Side::Over, text, Hue::Ink)?;
            // On the right the floor's dampers, which bring every circle home; on the left the radial one.
            for (sign, homeward) in [(1.0, true), (-1.0, comes_back)] {
                let [from, to] = if homeward { [0.86, 0.5] } else { [0.7, 1.0] };
                let [from, to] = [from, to].map(|distance: f64| place(sign * distance, rate));
                kit::arrow(&mut drawing, from, to, Hue::Purple);
            }
        }
        drawing.dot(origin, 4.0, Hue::Ink);
        drawing.label(at(140.0, 338.0), Side::Over, name, Hue::Ink)?;
        if spin > 1.0 {
            let level = place(1.0, NATURAL).y - 30.0;
            for (x, text) in [(30.0, "radius"), (250.0, "floor")] {
                drawing.label(at(x, level), Side::Over, text, Hue::Purple)?;
            }
        }
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels))
}

//! The figures of the chapter "Physics in the laundromat".
//!
//! Each function draws one claim from what the library computes. Captions stand on the page. One file a chapter,
//! however long: a reader can save it from the site and have everything.

use crate::speed_and_accuracy::measured::{Measurement, front};
use crate::speed_and_accuracy::measurements;
use crate::{Axis, Cause, Look, Outcome, Plot, Room, in_both, linear_steps, log_steps};
use drawing::kit::{self, Heads, Marker};
use drawing::{Drawing, Fill, Hue, Point, Rect, Role, Side, Stroke, at};
use mechanics::InvalidQuantity;
use mechanics::integrate::rk4;
use mechanics::scenes::laundromat::{LockedState, Machine, Mode, Parameters, Polar, Shaft};
use nalgebra::{Complex, Matrix4};
use std::f64::consts::{PI, SQRT_2, TAU};

/// The dampings Γ/ω₀ that the plots compare, each with its hue.
const DAMPINGS: [(f64, Hue); 4] = [(0.2, Hue::Blue), (0.4, Hue::Orange), (0.7, Hue::Green), (1.4, Hue::Pink)];

/// Points of a curve, (x, y).
type Values = Vec<(f64, f64)>;
/// The matrix of the small motions of a machine.
type MatrixOf = fn(&Machine) -> Matrix4<f64>;
/// What a measurement cost.
type WorkOf = fn(&Measurement) -> f64;

/// The natural frequency of the chapter's machine, rad/s.
const NATURAL: f64 = 10.0;

/// The chapter's machine, with other damping and spin, both in natural frequencies.
fn washing_machine(damping: f64, spin: f64) -> Result<Machine, InvalidQuantity> {
    let (drum_mass, load_mass) = (28.0, 2.0);
    Machine::new(Parameters {
        drum_mass,
        load_mass,
        load_radius: 0.25,
        stiffness: 3000.0,
        damping: damping * NATURAL * (drum_mass + load_mass),
        spin: spin * NATURAL,
    })
}

/// The machine from above, and what r, θ, φ, a and b are.
pub(crate) fn machine(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![suspension()?, lengths_and_angles()?]))
}

/// The tub between its springs and dampers.
fn suspension() -> Outcome {
    let mut drawing = Drawing::new("", 330.0, 330.0).titled(
        "The machine, seen from above",
        "A square frame, fixed to the floor. From the middle of each of its four walls a spring k and beside it a damper gamma run to a round tub, \
         which stands a little to the right of the middle O and above it. In the tub turns the drum with its shaft; the load m sits on \
         the drum.",
    );
    let (origin, half) = (at(165.0, 165.0), 144.0);
    let shaft = origin + at(13.0, -9.0);
    let (tub, drum) = (68.0, 56.0);
    for side in 0..4 {
        let way = Point::polar(1.0, 0.5 * PI * f64::from(side));
        let (wall, across) = (origin + way * half, way.quarter_turned());
        kit::ground(&mut drawing, wall, way.angle(), 92.0, Hue::Ink);
        // Both end on a bracket of the tub.
        let foot = shaft + way * (tub + 8.0);
        drawing.line(foot + across * 20.0, foot - across * 20.0, Stroke::Vector, Hue::Ink);
        drawing.line(shaft + way * tub, foot, Stroke::Vector, Hue::Ink);
        kit::spring(&mut drawing, wall + across * 14.0, foot + across * 14.0, 6, 13.0, 6.0, Hue::Ink);
        kit::damper(&mut drawing, wall - across * 14.0, foot - across * 14.0, 22.0, 13.0, Hue::Ink);
    }
    drawing.circle(shaft, tub, Role::Area(Fill::Page, Hue::Muted));
    drawing.circle(shaft, tub, Role::Line(Stroke::Curve, Hue::Muted));
    drawing.disc(shaft, drum, Hue::Blue);
    let outward = Point::polar(1.0, 84_f64.to_radians());
    drawing.dot(shaft + outward * 44.0, 8.0, Hue::Blue);
    drawing.label_on_face(shaft + outward * 44.0 + at(6.0, 0.0), Side::Right, "$m$", Hue::Blue)?;
    kit::arrow(&mut drawing, origin, shaft, Hue::Ink);
    kit::marker(&mut drawing, shaft, Marker::Ring, Hue::Ink);
    drawing.label_on_face(shaft, Side::Right, "shaft", Hue::Ink)?;
    cross(&mut drawing, origin, 6.0);
    drawing.label_on_face(origin + at(0.0, 4.0), Side::BelowLeft, "$O$", Hue::Ink)?;
    drawing.label_on_face(shaft + at(4.0, 36.0), Side::Over, "drum", Hue::Ink)?;
    drawing.label(shaft + Point::polar(tub, -0.8), Side::BelowRight, "tub", Hue::Muted)?;
    let left = origin - at(half, 0.0);
    drawing.label(left + at(42.0, 24.0), Side::Below, "$k$", Hue::Ink)?;
    drawing.label(left + at(42.0, -28.0), Side::Above, r"$\gamma$", Hue::Ink)?;
    kit::angle(&mut drawing, shaft, tub + 14.0, 0.55, 0.5, Heads::End, Hue::Orange);
    drawing.label(shaft + Point::polar(tub + 14.0, 0.8), Side::AboveRight, r"$\Omega$", Hue::Orange)?;
    Ok(drawing)
}

/// The drum with its load: lengths and angles.
fn lengths_and_angles() -> Outcome {
    let mut drawing = Drawing::new("", 330.0, 330.0).titled(
        "Lengths and angles",
        "The vector r leads from the fixed point O to the shaft, at the angle theta to the x axis. The load m sits on the drum at distance a from \
         the shaft, at the angle phi to the x direction. The common centre of mass lies on the same line, at the smaller distance b \
         from the shaft. The load leads the shaft by the angle phi zero, which is phi minus theta. The drum turns counter-clockwise \
         with the angular velocity Omega.",
    );
    let (theta, phi) = (36_f64.to_radians(), 96_f64.to_radians());
    let origin = at(38.0, 286.0);
    let along = Point::polar(1.0, theta);
    let shaft = origin + along * 158.0;
    let outward = Point::polar(1.0, phi);
    let load = shaft + outward * 104.0;
    let mass = shaft + outward * 76.0;
    drawing.disc(shaft, 128.0, Hue::Blue);

    // Directions: the x axis, its parallel through the shaft, and the radius carried on beyond the shaft.
    let axis_end = at(300.0, origin.y);
    kit::dimension(&mut drawing, origin, axis_end, Heads::End, Hue::Ink);
    drawing.label(axis_end, Side::Right, "$x$", Hue::Ink)?;
    drawing.line(shaft, shaft + at(118.0, 0.0), Stroke::Reference, Hue::Muted);
    drawing.line(shaft, shaft + along * 84.0, Stroke::Reference, Hue::Muted);
    kit::arrow(&mut drawing, origin, shaft - along * 4.0, Hue::Ink);
    drawing.label_on_face(origin + along * 92.0, Side::AboveLeft, r"$\boldsymbol{r}$", Hue::Ink)?;

    // The line from the shaft to the load, and what is measured along it.
    let left = outward.quarter_turned();
    for (end, reach) in [(shaft, 46.0), (mass, 24.0), (load, 46.0)] {
        drawing.line(end, end + left * reach, Stroke::Hatch, Hue::Muted);
    }
    drawing.line(shaft, load, Stroke::Vector, Hue::Blue);
    kit::dimension(&mut drawing, shaft + left * 20.0, mass + left * 20.0, Heads::Both, Hue::Ink);
    kit::dimension(&mut drawing, shaft + left * 42.0, load + left * 42.0, Heads::Both, Hue::Ink);
    for (end, offset, name) in [(mass, 20.0, "$b$"), (load, 42.0, "$a$")] {
        let middle = shaft.towards(end, 0.6) + left * offset;
        drawing.label_on_face(middle, Side::Left, name, Hue::Ink)?;
    }
    drawing.dot(load, 10.0, Hue::Blue);
    drawing.label_on_face(load + at(10.0, 0.0), Side::Right, "load, $m$", Hue::Blue)?;
    kit::marker(&mut drawing, mass, Marker::Mass, Hue::Ink);
    drawing.label_on_face(mass + at(2.0, -2.0), Side::Right, "centre of mass", Hue::Ink)?;
    kit::marker(&mut drawing, shaft, Marker::Ring, Hue::Ink);

    // Angles.
    kit::angle(&mut drawing, origin, 56.0, 0.0, theta, Heads::End, Hue::Ink);
    drawing.label(origin + Point::polar(56.0, 0.14), Side::Right, r"$\theta$", Hue::Ink)?;
    kit::angle(&mut drawing, shaft, 30.0, 0.0, phi, Heads::End, Hue::Ink);
    drawing.label_on_face(shaft + Point::polar(42.0, 0.5 * theta), Side::Over, r"$\phi$", Hue::Ink)?;
    kit::angle(&mut drawing, shaft, 48.0, theta, phi - theta, Heads::End, Hue::Ink);
    let lead_label = shaft + Point::polar(48.0, 0.5 * (theta + phi));
    drawing.label_on_face(lead_label, Side::AboveRight, r"$\phi_0$", Hue::Ink)?;
    kit::angle(&mut drawing, shaft, 139.0, 2.1, 0.5, Heads::End, Hue::Orange);
    drawing.label(shaft + Point::polar(139.0, 2.35), Side::AboveLeft, r"$\Omega$", Hue::Orange)?;
    drawing.dot(origin, 3.4, Hue::Ink);
    drawing.label(origin, Side::BelowLeft, "$O$", Hue::Ink)?;
    Ok(drawing)
}

/// The steady motion well below, at, and well above the natural frequency, to scale.
pub(crate) fn phases(id: &str) -> Outcome {
    // A load of twelve kilograms, so that the circles can be seen beside the drum.
    let base = Parameters {
        drum_mass: 18.0,
        load_mass: 12.0,
        load_radius: 0.25,
        stiffness: 3000.0,
        damping: 90.0,
        spin: 0.0,
    };
    let scale = 59.0 / base.load_radius;
    let theta = 0.32; // one direction of the shaft in all three
    let mut panels = Vec::new();
    for (ratio, width, name, words) in [
        (
            0.6,
            200.0,
            r"$\Omega = 0.6\,\omega_0$",
            "At 0.6 natural frequencies the load points outwards, nearly along the line from O to the shaft, and the centre of mass lies \
             beyond the shaft.",
        ),
        (
            1.0,
            300.0,
            r"$\Omega = \omega_0$",
            "At the natural frequency the circle on which the shaft goes round O is largest, and the load leads the shaft by a quarter turn.",
        ),
        (
            3.0,
            220.0,
            r"$\Omega = 3\,\omega_0$",
            "At three natural frequencies the load points inwards, and the centre of mass is almost at O.",
        ),
    ] {
        let mut drawing = Drawing::new("", width, 290.0).titled("The steady motion", words);
        let machine = Machine::new(Parameters { spin: ratio * NATURAL, ..base })?;
        let steady = machine.steady()?;
        let origin = at(if ratio == 1.0 { 100.0 } else { 90.0 }, 140.0);
        let shaft = origin + Point::polar(steady.radius() * scale, theta);
        let outward = Point::polar(1.0, theta + steady.phase());
        let load = shaft + outward * (base.load_radius * scale);
        let mass = shaft + outward * (machine.offset() * scale);
        let (reach, circle) = (base.load_radius * scale + 9.0, steady.radius() * scale);

        drawing.disc(shaft, reach, Hue::Blue);
        drawing.circle(origin, circle, Role::Line(Stroke::Reference, Hue::Ink));
        drawing.line(origin, origin + Point::polar(circle + 58.0, theta), Stroke::Hatch, Hue::Ink);
        drawing.line(shaft, load, Stroke::Vector, Hue::Blue);
        let radius = if steady.phase() < 0.5 { 46.0 } else { 24.0 };
        kit::angle(&mut drawing, shaft, radius, theta, steady.phase(), Heads::None, Hue::Ink);
        drawing.dot(load, 8.0, Hue::Blue);
        kit::marker(&mut drawing, mass, Marker::Mass, Hue::Ink);
        kit::marker(&mut drawing, shaft, Marker::Ring, Hue::Ink);
        cross(&mut drawing, origin, 7.0);
        // Drum and shaft turn alike.
        kit::angle(&mut drawing, shaft, reach + 9.0, -0.5, 0.55, Heads::End, Hue::Orange);
        let (place, below) = if ratio == 1.0 { (Side::BelowLeft, 6.0) } else { (Side::Below, circle) };
        drawing.label_on_face(origin + at(0.0, below), place, "$O$", Hue::Ink)?;
        if ratio == 1.0 {
            drawing.label_on_face(shaft, Side::BelowRight, "shaft", Hue::Ink)?;
            drawing.label(load + at(-10.0, -8.0), Side::Left, "load", Hue::Blue)?;
            let lead = shaft + Point::polar(24.0, theta + 0.5 * steady.phase());
            drawing.label_on_face(lead, Side::AboveRight, r"$\phi_0$", Hue::Ink)?;
            let sense = shaft + Point::polar(reach + 9.0, -0.25);
            drawing.label(sense, Side::Right, r"$\Omega$", Hue::Orange)?;
        }

        let middle =
            0.5 * ((origin.x - circle).min(shaft.x - reach) + (origin.x + circle).max(shaft.x + reach));
        let degrees = steady.phase().to_degrees();
        drawing.label(at(middle, 254.0), Side::Over, name, Hue::Ink)?;
        let lead = format!(r"$\phi_0 = {degrees:.0}°$");
        drawing.label(at(middle, 276.0), Side::Over, &lead, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels).titled(
        "Three phases of the steady motion",
        "Three pictures of one machine, to scale, at 0.6, at once and at three times the natural frequency. Each shows the \
         fixed point O, the circle on which the shaft goes round it, and the drum with its load, turning counter-clockwise. At low spin the \
         load points outwards, nearly along the line from O to the shaft, and the centre of mass lies beyond the shaft. At the natural \
         frequency the circle is largest and the load leads the shaft by a quarter turn. At high spin the load points inwards, \
         and the centre of mass is almost at O.",
    ))
}

/// A fixed point seen from above.
fn cross(drawing: &mut Drawing, centre: Point, reach: f64) {
    for arm in [at(reach, 0.0), at(0.0, reach)] {
        drawing.line(centre - arm, centre + arm, Stroke::Axis, Hue::Ink);
    }
}

/// Radius of the shaft’s circle and lead of the load against spin.
pub(crate) fn steady(id: &str) -> Outcome {
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 560.0).titled(
            "Steady motion against spin",
            "Two plots against the spin in natural frequencies, from 0 to 3, for four dampings Gamma over omega zero: 0.2, 0.4, 0.7 and \
             1.4. Above, the radius of the shaft’s circle over b: it begins at zero, has a peak near the natural \
             frequency, of height \
             5 for the smallest damping, with no peak within the plot for the largest, and tends to one for all. Below, the angle by which the \
             load leads: \
             it rises from 0 to 180 degrees, steeply for small damping, and all four curves pass 90 degrees at the natural \
             frequency.",
        );
        let spin = || Axis::linear(0.0, 3.0, room.of(0.5, 1.0)).map(|axis| axis.minor(0.1));
        let width = room.of(580.0, 316.0);
        let upper = Rect::new(58.0, 34.0, width, 262.0);
        let lower = Rect::new(58.0, 356.0, width, 152.0);

        let radius = Axis::linear(0.0, 5.5, 1.0)?.minor(0.5).titled(r"radius of the shaft’s circle $r_0/b$");
        let mut plot = Plot::new(&mut drawing, upper, spin()?.unlabelled(), radius)?;
        if room == Room::Wide {
            plot.upright(1.0, Stroke::Dotted); // on a phone two labels stand there
        }
        plot.level(1.0, Stroke::Reference);
        for (damping, hue) in DAMPINGS {
            let values =
                over_spin(damping, 0.0, 3.0, |machine| Ok(machine.steady()?.radius() / machine.offset()))?;
            plot.curve(&format!("radius-{damping}"), values, Stroke::Curve, hue);
        }
        plot.label((1.06, 4.9), Side::Right, r"$\Gamma/\omega_0 = 0.2$", Hue::Blue)?;
        plot.label((room.of(1.125, 1.035), 2.76), Side::Over, "$0.4$", Hue::Orange)?;
        plot.label((room.of(1.2, 1.04), 1.53), Side::Above, "$0.7$", Hue::Green)?;
        plot.label((1.75, 0.9), Side::Below, "$1.4$", Hue::Pink)?;
        plot.label((0.03, 1.0), Side::AboveRight, "$r_0 = b$", Hue::Muted)?;

        let lead = Axis::linear(0.0, 180.0, 90.0)?.minor(30.0).marked(&[
            (0.0, "0°"),
            (90.0, "90°"),
            (180.0, "180°"),
        ]);
        let lead = lead.titled(r"lead of the load $\phi_0$");
        let mut plot = Plot::new(&mut drawing, lower, spin()?.titled(r"spin $\Omega/\omega_0$"), lead)?;
        plot.upright(1.0, Stroke::Dotted);
        plot.level(90.0, Stroke::Dotted);
        for (damping, hue) in DAMPINGS {
            let values = over_spin(damping, 0.0, 3.0, |machine| Ok(machine.steady()?.phase().to_degrees()))?;
            plot.curve(&format!("lead-{damping}"), values, Stroke::Curve, hue);
        }
        plot.label((room.of(1.2, 1.26), 162.0), Side::AboveLeft, "$0.2$", Hue::Blue)?;
        plot.label((2.0, 137.0), Side::BelowRight, "$1.4$", Hue::Pink)?;
        Ok(drawing)
    })
}

/// A quantity of the chapter's machine against Ω/ω₀, for one damping Γ/ω₀.
fn over_spin(
    damping: f64,
    from: f64,
    to: f64,
    quantity: impl Fn(&Machine) -> Result<f64, InvalidQuantity>,
) -> Result<Values, Cause> {
    linear_steps(from, to, 1200)
        .map(|ratio| Ok((ratio, quantity(&washing_machine(damping, ratio)?)?)))
        .collect()
}

/// Radius of the centre of mass: the common point, and the rate of self-centring.
pub(crate) fn centring(id: &str) -> Outcome {
    // What the spring's force alone would do: b ω₀²/D, the source's (20), is the shaft's radius times ω₀²/Ω².
    let spring_alone = |machine: &Machine| -> Result<f64, InvalidQuantity> {
        let ratio = machine.natural_frequency() / machine.spin();
        Ok(machine.steady()?.radius() * ratio * ratio / machine.offset())
    };
    let true_radius = |machine: &Machine| -> Result<f64, InvalidQuantity> {
        Ok(machine.steady()?.centre_of_mass_radius() / machine.offset())
    };
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 604.0).titled(
            "Radius of the centre of mass against spin",
            "Two plots. Above, the radius of the centre of mass over b for spins up to three natural frequencies and four dampings. \
             All curves begin at one and cross in a single point, at the square root of two times the natural frequency, where the \
             radius is b; beyond it a larger damping gives a larger radius. Dashed in grey, what the force of the spring alone would give for \
             the dampings 0.4 and 1.4, which lies below the true curve and misses the point. Below, both scales logarithmic, up to a \
             thousand natural frequencies: the true radius falls as one over the spin, that of the spring alone as one over its square.",
        );
        let width = room.of(580.0, 316.0);
        let spin = Axis::linear(0.0, 3.0, room.of(0.5, 1.0))?.minor(0.1).titled(r"spin $\Omega/\omega_0$");
        let radius =
            Axis::linear(0.0, 3.4, 1.0)?.minor(0.5).titled(r"radius of the centre of mass $r_\text{cm}/b$");
        let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 34.0, width, 230.0), spin, radius)?;
        plot.upright(SQRT_2, Stroke::Dotted);
        for (damping, _) in [DAMPINGS[1], DAMPINGS[3]] {
            let values = over_spin(damping, 0.01, 3.0, spring_alone)?;
            plot.curve(&format!("spring-{damping}"), values, Stroke::DashedCurve, Hue::Muted);
        }
        for (damping, hue) in DAMPINGS {
            let values = over_spin(damping, 0.0, 3.0, true_radius)?;
            plot.curve(&format!("radius-{damping}"), values, Stroke::Curve, hue);
        }
        let common = plot.at((SQRT_2, 1.0));
        plot.drawing().circle(common, 4.5, Role::Area(Fill::Solid, Hue::Ink));
        plot.label((SQRT_2, 1.05), Side::AboveRight, r"one point for every damping", Hue::Ink)?;
        plot.label(
            (room.of(0.78, 0.76), 2.6),
            Side::Left,
            room.of(r"$\Gamma/\omega_0 = 0.2$", "$0.2$"),
            Hue::Blue,
        )?;
        plot.label((room.of(0.96, 0.97), 2.74), Side::Above, "$0.4$", Hue::Orange)?;
        plot.label((0.91, 1.8), Side::Above, "$0.7$", Hue::Green)?;
        plot.label((2.6, 0.56), Side::Above, "$1.4$", Hue::Pink)?;
        plot.label((0.62, 0.4), Side::Over, "spring alone", Hue::Muted)?;

        let spin = Axis::log(1.0, 1000.0, 1)?.titled(r"spin $\Omega/\omega_0$");
        let radius = Axis::log(1e-6, 10.0, 2)?.titled(r"$r_\text{cm}/b$ at high spin");
        let mut plot = Plot::new(&mut drawing, Rect::new(58.0, 348.0, width, 204.0), spin, radius)?;
        let high = |damping: f64, quantity: &dyn Fn(&Machine) -> Result<f64, InvalidQuantity>| {
            log_steps(1.0, 1000.0, 900)
                .map(|ratio| Ok((ratio, quantity(&washing_machine(damping, ratio)?)?)))
                .collect::<Result<Vec<_>, Cause>>()
        };
        plot.curve("spring-high", high(0.4, &spring_alone)?, Stroke::DashedCurve, Hue::Muted);
        for (damping, hue) in DAMPINGS {
            plot.curve(&format!("high-{damping}"), high(damping, &true_radius)?, Stroke::Curve, hue);
        }
        plot.label((60.0, 1.4 / 60.0), Side::AboveRight, r"falls as $\Gamma/\Omega$", Hue::Ink)?;
        plot.label(
            (60.0, 1.0 / 3600.0),
            Side::BelowLeft,
            r"spring alone: $\omega_0^2/\Omega^2$",
            Hue::Muted,
        )?;
        Ok(drawing)
    })
}

/// What the floor feels against spin.
pub(crate) fn floor_force(id: &str) -> Outcome {
    let force = |machine: &Machine| -> Result<f64, InvalidQuantity> {
        Ok(machine.total_mass() * machine.spin().powi(2) * machine.steady()?.centre_of_mass_radius())
    };
    let rad_per_second =
        |damping: f64, from: f64| over_spin(damping, from, 12.5, force).map(|values| scaled(values, NATURAL));
    let dampings = [(0.1, Hue::Blue), (0.3, Hue::Green), (1.0, Hue::Pink)];
    let mut curves = Vec::new();
    for (damping, _) in dampings {
        curves.push(rad_per_second(damping, 0.0)?);
    }
    let quietest = |values: &Values| {
        let beyond = values.iter().copied().filter(|value| value.0 > 1.2 * NATURAL);
        beyond.min_by(|a, b| a.1.total_cmp(&b.1)).ok_or("no values")
    };
    let Parameters { load_mass, load_radius, .. } = washing_machine(0.0, 0.0)?.parameters();
    let rigid = linear_steps(0.0, 125.0, 500).map(|spin| (spin, load_mass * load_radius * spin * spin));
    let rigid: Values = rigid.collect();
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 360.0).titled(
            "The force on the floor against spin",
            "The force with which the machine shakes the floor, in newtons, against the spin from 0 to 125 radians a second. A dashed curve, a \
             drum on rigid bearings, leaves the plot at 28 radians a second. For a damping of a tenth of the natural frequency the force has \
             a peak of 510 newtons at the natural frequency, out of the plot, falls to 55 and hardly rises again. For the chapter’s machine, \
             three tenths, it has a peak of 176, is least with 74 newtons at 25 radians a second, marked by a dot, and climbs back to 197. \
             For a damping of one the peak is lowest and the climb steepest.",
        );
        let spin = Axis::linear(0.0, 125.0, room.of(25.0, 25.0))?.minor(5.0).titled(r"spin $\Omega$, rad/s");
        let newtons = Axis::linear(0.0, 400.0, 100.0)?.minor(20.0).titled("force on the floor, N");
        let frame = Rect::new(58.0, 34.0, room.of(580.0, 316.0), 272.0);
        let mut plot = Plot::new(&mut drawing, frame, spin, newtons)?;
        plot.upright(NATURAL, Stroke::Dotted);
        plot.curve("rigid", rigid.iter().copied(), Stroke::Reference, Hue::Muted);
        for ((damping, hue), values) in dampings.into_iter().zip(&curves) {
            plot.curve(&format!("force-{damping}"), values.iter().copied(), Stroke::Curve, hue);
        }
        let rest = quietest(&curves[1])?;
        plot.markers(&[rest], Marker::Disc, Hue::Green);
        plot.label((28.5, 384.0), Side::Right, room.of("on rigid bearings", "rigid bearings"), Hue::Muted)?;
        let place = (room.of(48.0, 40.0), room.of(24.0, 24.0));
        plot.label(place, Side::Over, &format!(r"quietest, ${:.0}$ N", rest.1), Hue::Green)?;
        plot.label((57.0, 305.0), Side::AboveLeft, r"$\Gamma = \omega_0$", Hue::Pink)?;
        plot.label((100.0, 161.0), Side::AboveLeft, r"$0.3\,\omega_0$", Hue::Green)?;
        plot.label((122.0, 70.0), Side::BelowLeft, r"$0.1\,\omega_0$", Hue::Blue)?;
        Ok(drawing)
    })
}

/// The values with their x in other units.
fn scaled(values: Values, unit: f64) -> Values {
    values.into_iter().map(|(x, y)| (x * unit, y)).collect()
}

/// What the motor must give to keep the spin constant.
pub(crate) fn torque(id: &str) -> Outcome {
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 330.0).titled(
            "Torque of the motor against spin",
            "The torque, in newton metres, that keeps the spin of the chapter’s machine constant, for spins up to three natural \
             frequencies and four dampings. For the damping 0.2 it has a narrow peak of 4.3 near the natural frequency \
             and falls below 0.6 beyond it. For larger dampings the peak is lower and broader, and for the largest there \
             is none: the torque keeps \
             growing with the spin.",
        );
        let spin = Axis::linear(0.0, 3.0, room.of(0.5, 1.0))?.minor(0.1).titled(r"spin $\Omega/\omega_0$");
        let torque = Axis::linear(0.0, 4.5, 1.0)?.minor(0.5).titled(r"torque of the motor $\tau$, N m");
        let frame = Rect::new(58.0, 34.0, room.of(580.0, 316.0), 244.0);
        let mut plot = Plot::new(&mut drawing, frame, spin, torque)?;
        for (damping, hue) in DAMPINGS {
            let values = over_spin(damping, 0.0, 3.0, |machine| Ok(machine.steady()?.motor_torque()))?;
            plot.curve(&format!("torque-{damping}"), values, Stroke::Curve, hue);
        }
        plot.label((1.1, 3.9), Side::Right, r"$\Gamma/\omega_0 = 0.2$", Hue::Blue)?;
        plot.label((2.85, 1.2), Side::Below, "$0.4$", Hue::Orange)?;
        plot.label((2.85, 2.0), Side::Above, "$0.7$", Hue::Green)?;
        plot.label((2.4, 2.9), Side::AboveLeft, "$1.4$", Hue::Pink)?;
        Ok(drawing)
    })
}

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
        let time = Axis::linear(0.0, 2.5, 0.5)?.minor(0.1).titled("time, s");
        let radius = Axis::linear(0.0, 5.0, 1.0)?.minor(0.5).titled("distance of the shaft from $O$, $r/b$");
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

/// Four eigenvalues as the spin grows: a damper on the whole velocity, and one on ṙ only.
pub(crate) fn eigenvalues(id: &str) -> Outcome {
    let panels: [(&str, &str, MatrixOf, &str); 2] = [
        (
            "whole",
            r"damping $-\gamma\dot{\boldsymbol{r}}$",
            Machine::stability_matrix,
            "The damper resists the whole velocity. All four paths run along the vertical line at minus one half Gamma, in the half where motions \
             decay: from plus one the first goes up to plus 4 and the third down to minus 2, from minus one the second goes up to plus 2 and \
             the fourth down to minus 4.",
        ),
        (
            "radial",
            r"damping $-\gamma\dot{r}\,\hat{\boldsymbol{r}}$",
            Machine::radial_damping_matrix,
            "The damper resists the radial velocity only. Two paths stay on the left, and two pass through zero when the spin equals the natural \
             frequency and go on in the tinted right half, where motions grow.",
        ),
    ];
    let mut drawn = Vec::new();
    for (panel, name, matrix, words) in panels {
        let mut drawing = Drawing::new("", 350.0, 440.0).titled("Eigenvalues as the spin grows", words);
        let real = Axis::linear(-0.4, 0.2, 0.2)?.minor(0.1).titled(r"$\text{Re}\,s/\omega_0$");
        let imaginary = Axis::linear(-4.2, 4.2, 2.0)?.minor(1.0).titled(r"$\text{Im}\,s/\omega_0$");
        let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 54.0, 246.0, 334.0), real, imaginary)?;
        plot.region((0.0, -4.2), (0.2, 4.2), Hue::Orange);
        plot.reference((0.0, -4.2), (0.0, 4.2), Stroke::Outline);
        plot.reference((-0.4, 0.0), (0.0, 0.0), Stroke::Dotted);
        for (index, path) in eigenvalue_paths(0.3, 3.0, matrix)?.iter().enumerate() {
            plot.curve(&format!("path-{panel}-{index}"), path.iter().copied(), Stroke::Curve, Hue::Blue);
            let (Some(&first), Some(&last)) = (path.first(), path.last()) else { continue };
            plot.markers(&[first], Marker::Ring, Hue::Blue);
            plot.markers(&[last], Marker::Disc, Hue::Blue);
            let number = match (last.1 / first.1.abs()).round() as i32 {
                4.. => "$1$",
                0..4 => "$2$",
                -3..0 => "$3$",
                _ => "$4$",
            };
            if panel == "whole" {
                // All on one line: beside it, how each runs.
                let aside = at(if matches!(number, "$1$" | "$3$") { 14.0 } else { -14.0 }, 0.0);
                let [from, to] = [plot.at(first) + aside, plot.at(last) + aside];
                kit::dimension(plot.drawing(), from, to, Heads::End, Hue::Blue);
                let side = if aside.x > 0.0 { Side::Right } else { Side::Left };
                plot.drawing().label(from.towards(to, 0.62), side, number, Hue::Blue)?;
            } else {
                // Which way it goes as the spin grows.
                let [before, after] = [path[2300], path[2310]].map(|value| plot.at(value));
                kit::head(plot.drawing(), after, after - before, 0.8, Hue::Blue);
                let side = if last.0 > 0.0 { Side::Right } else { Side::Left };
                plot.label(last, side, number, Hue::Blue)?;
            }
        }
        let grows = plot.at((0.1, -3.0));
        plot.drawing().label_on_face(grows, Side::Over, "grows", Hue::Orange)?;
        if panel == "radial" {
            let crossing = plot.at((0.03, 0.0));
            plot.drawing().label_on_face(crossing, Side::Right, r"$\Omega = \omega_0$", Hue::Ink)?;
        }
        let top = at(plot.frame().centre().x + 16.0, 16.0);
        plot.drawing().label(top, Side::Over, name, Hue::Ink)?;
        drawn.push(drawing);
    }
    Ok(Drawing::panels(id, drawn))
}

/// The paths of four eigenvalues over ω₀ while Ω/ω₀ grows from 0, each value joined to the nearest of the step before.
fn eigenvalue_paths(damping: f64, to: f64, matrix: MatrixOf) -> Result<[Values; 4], InvalidQuantity> {
    let mut paths: [Values; 4] = Default::default();
    for ratio in linear_steps(0.0, to, 3000) {
        let machine = washing_machine(damping, ratio)?;
        let found = matrix(&machine).complex_eigenvalues();
        let mut free: Vec<Complex<f64>> = found.iter().map(|s| s / machine.natural_frequency()).collect();
        for path in &mut paths {
            // Straight on from the last two values, so that paths that cross do not swap.
            let expected = match path.as_slice() {
                [.., (x0, y0), (x1, y1)] => Complex::new(2.0 * x1 - x0, 2.0 * y1 - y0),
                [(x, y)] => Complex::new(*x, *y),
                [] => free[0],
            };
            let nearest = (0..free.len())
                .min_by(|&i, &j| (free[i] - expected).norm().total_cmp(&(free[j] - expected).norm()));
            if let Some(index) = nearest {
                let s = free.swap_remove(index);
                path.push((s.re, s.im));
            }
        }
    }
    Ok(paths)
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

/// One kick, seen from the turning drum and in the room.
pub(crate) fn frames(id: &str) -> Outcome {
    let machine = washing_machine(0.2, 2.2)?;
    let amplitude = machine.steady()?.amplitude();
    let radius = amplitude.norm();
    // The kick sets the shaft aside and gives it a little velocity across, so that one sees it go and return.
    let spin = Complex::new(0.0, machine.spin());
    let (aside, across) = (0.8 * radius, Complex::new(0.0, 0.22 * radius * NATURAL));
    let kicked = Shaft { position: amplitude + aside, velocity: amplitude * spin + across };
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
            "As seen from the turning drum: the shaft loops round its steady place in a rosette that shrinks to a point.",
        ),
        (
            "room",
            "standing in the room",
            "As seen in the room: the centre of the shaft’s circle swings to and fro along a slender ellipse that shrinks to a point, like a \
             mass on a spring.",
        ),
    ]
    .into_iter()
    .zip(&ways)
    {
        let mut drawing = Drawing::new("", 320.0, 340.0).titled(&format!("One kick, {text}"), words);
        let origin = at(160.0, 150.0);
        let mut plot = Plot::plane(&mut drawing, origin, 128.0 / (0.8 * radius), 1.1 * radius)?;
        plot.curve(name, way.iter().copied(), Stroke::Orbit, Hue::Blue);
        let [first, next] = [way[0], way[if name == "room" { 520 } else { 80 }]].map(|value| plot.at(value));
        let before = plot.at(way[if name == "room" { 510 } else { 75 }]);
        kit::head(plot.drawing(), next, next - before, 0.8, Hue::Blue);
        plot.drawing().dot(first, 3.4, Hue::Blue);
        plot.drawing().label(first, Side::Right, "kick", Hue::Blue)?;
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

/// At high spin the disturbed motion looks like a circle beside O.
pub(crate) fn displaced(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 310.0).titled(
        "A displaced circle at high spin",
        "The path of the disturbed shaft during two turns of the drum, at twenty natural frequencies: a circle of radius r zero, \
         drawn twice and nearly in the same place, whose centre lies beside O, 0.4 r zero away. The centre moves along a short \
         arc meanwhile. A dashed circle about O shows the steady motion.",
    );
    let machine = washing_machine(0.3, 20.0)?;
    let (radius, size) = (machine.steady()?.radius(), 0.4);
    let start = disturbed(&machine, machine.modes()[1], size)?;
    let times = linear_steps(0.0, 2.0 * TAU / machine.spin(), 2000);
    let (path, centres) = path_and_centre(&machine, start, times)?;
    let origin = at(246.0, 150.0);
    let mut plot = Plot::plane(&mut drawing, origin, 116.0 / radius, 1.6 * radius)?;
    plot.drawing().circle(origin, 116.0, Role::Line(Stroke::Reference, Hue::Muted));
    plot.curve("path", path, Stroke::Orbit, Hue::Blue);
    plot.curve("centre", centres.iter().copied(), Stroke::Curve, Hue::Orange);
    if let (Some(&first), Some(&last)) = (centres.first(), centres.last()) {
        let [first, last] = [plot.at(first), plot.at(last)];
        let drawing = plot.drawing();
        drawing.line(origin, first, Stroke::Outline, Hue::Ink);
        drawing.label(origin.towards(first, 0.5), Side::Above, r"$\epsilon_0 r_0$", Hue::Ink)?;
        let rim = first + Point::polar(116.0, 2.5);
        kit::dimension(drawing, first, rim, Heads::End, Hue::Ink);
        drawing.label(first.towards(rim, 0.55), Side::AboveRight, "$r_0$", Hue::Ink)?;
        drawing.dot(last, 3.4, Hue::Orange);
    }
    cross(&mut drawing, origin, 6.0);
    drawing.label(origin + at(2.0, 2.0), Side::BelowRight, "$O$", Hue::Ink)?;
    drawing.label(origin + Point::polar(116.0, 0.6), Side::AboveRight, "steady", Hue::Muted)?;
    Ok(drawing)
}

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
    let time = Axis::linear(0.0, end, 5.0)?.minor(1.0).titled("time, s");
    let swing = Axis::linear(-6.0, 6.0, 2.0)?.minor(1.0).titled("displacement to one side, cm");
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
        let spin = Axis::linear(0.0, 2.5, 0.5)?.minor(0.1).titled(r"spin reached $\dot\phi/\omega_0$");
        let title =
            room.of("distance of the shaft from $O$, in units of $b$", "distance from $O$, in units of $b$");
        let radius = Axis::linear(0.0, 30.0, 10.0)?.minor(2.0).titled(title);
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
        let acceleration = Axis::log(slowest, quickest, 1)?.titled(r"acceleration $\alpha/\omega_0^2$");
        let damping = Axis::log(lightest, heaviest, 1)?.titled(r"damping $\Gamma/\omega_0$");
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

/// The naive program near O, in polar and in Cartesian coordinates.
pub(crate) fn polar_fault(id: &str) -> Outcome {
    let machine = washing_machine(0.3, 3.0)?;
    let (speed, steps) = (1.0, 100);
    let step = 1e-3;
    // Pass O in the middle of a step: nothing is special about the instant.
    let (before, after) = (-50.3 * step, 49.7 * step);
    let (mut polar, mut cartesian) = (Vec::new(), Vec::new());
    for distance in log_steps(1e-5, 1e-1, 40) {
        let pass = Shaft { position: Complex::new(0.0, distance), velocity: Complex::new(speed, 0.0) };
        let motion = machine.transient(pass)?;
        let [start, exact] = [motion.at(before)?, motion.at(after)?];
        let error = |end: Shaft| (end.position - exact.position).norm();
        if let Ok(end) = rk4(
            |t, y: &[f64; 4]| machine.polar_rates(t, y),
            before,
            start.to_polar().to_array(),
            after,
            steps,
        ) {
            polar.push((distance, error(Shaft::from_polar(Polar::from_array(end)))));
        }
        let end =
            rk4(|t, y: &[f64; 4]| machine.cartesian_rates(t, y), before, start.to_array(), after, steps)?;
        cartesian.push((distance, error(Shaft::from_array(end))));
    }
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 360.0).titled(
            "Error of the polar and the Cartesian program after one pass near O",
            "Both scales are logarithmic. Along x the distance at which the shaft passes O, from ten micrometres to ten centimetres; along \
             y the error of the position after the pass, in metres, by the Runge-Kutta method with steps of a millisecond. In polar \
             coordinates the error grows from below 1e-9 at ten centimetres to almost 1e-2 at half a millimetre; nearer to O the \
             program returned no number. In x and y it is 3e-11 at every distance.",
        );
        let distance = Axis::log(1e-5, 1e-1, 1)?.titled("distance of the pass from $O$, m");
        let error = Axis::log(1e-12, 1.0, 2)?.titled("error of the position after the pass, m");
        let mut plot =
            Plot::new(&mut drawing, Rect::new(62.0, 34.0, room.of(576.0, 312.0), 274.0), distance, error)?;
        plot.upright(speed * step, Stroke::Dotted);
        plot.series("polar", &polar, Look::RK4.marker, Look::RK4.hue);
        plot.series("cartesian", &cartesian, Marker::Ring, Look::RK4.hue);
        plot.label(
            (1e-3, 1e-1),
            Side::Right,
            room.of("distance covered in one step", "covered in one step"),
            Hue::Muted,
        )?;
        plot.label((5e-3, 1e-6), Side::AboveRight, r"in $r$ and $\theta$", Hue::Orange)?;
        plot.label((1e-4, 3e-11), Side::Above, r"in $x$ and $y$", Look::RK4.hue)?;
        Ok(drawing)
    })
}

/// Error against work: evaluations of the rates, and time.
pub(crate) fn speed(id: &str) -> Outcome {
    let mut all = measurements()?;
    all.retain(|row| row.problem == "washer" && row.contestant == "mechanics");
    let error = || Axis::log(1e-16, 1.0, 4).map(|axis| axis.titled("largest error, in units of $b$"));
    let evaluations = Axis::log(1e3, 1e7, 1)?.titled("evaluations of the rates");
    let time = Axis::log(1e-3, 1e3, 1)?.titled("time, ms");
    let panels: [(&str, &str, Axis, WorkOf); 2] = [
        (
            "evaluations",
            "The evaluations of the rates against the error: the Runge-Kutta method of order four needs ten times as many for four more digits, \
             DOP853 about three times as many, the closed form none.",
            evaluations,
            |row| row.evaluations.map_or(0.0, |count| count as f64),
        ),
        (
            "time",
            "The time in milliseconds against the error: both integrators take longer for more digits, and the closed form is a single point far \
             down on the left, below both and more accurate than either.",
            time,
            |row| 1e3 * row.seconds,
        ),
    ];
    let mut drawn = Vec::new();
    for (panel, words, axis, work) in panels {
        let mut drawing = Drawing::new("", 340.0, 372.0).titled("Error against work", words);
        let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 256.0, 284.0), error()?, axis)?;
        for Look { name: method, marker, hue, .. } in [Look::RK4, Look::DOP853, Look::EXACT] {
            let rows = all.iter().filter(|row| row.method == method);
            let values = front(rows.map(|row| (row.error, work(row))).filter(|value| value.1 > 0.0));
            plot.series(&format!("{panel}-{}", method.replace(' ', "-")), &values, marker, hue);
            let Some(&most_exact) = values.last() else { continue };
            let side = if method == "closed form" { Side::Right } else { Side::Above };
            plot.label(most_exact, side, method, hue)?;
        }
        if panel == "evaluations" {
            plot.label((2e-16, 2e3), Side::Right, "closed form: none", Look::EXACT.hue)?;
        }
        drawn.push(drawing);
    }
    Ok(Drawing::panels(id, drawn))
}

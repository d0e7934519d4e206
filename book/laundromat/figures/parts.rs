//! The machine and its parts, from above: what is where.

use super::{NATURAL, cross};
use drawing::kit::{self, Heads, Marker};
use drawing::{Drawing, Fill, Hue, Point, Role, Side, Stroke, at};
use figures::Outcome;
use mechanics::scenes::laundromat::{Machine, MachineParameters};
use std::f64::consts::PI;

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
        let part = 22.0 / (foot - wall).length();
        kit::damper(&mut drawing, wall - across * 14.0, foot - across * 14.0, part, 13.0, Hue::Ink);
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
    let base = MachineParameters {
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
        let machine = Machine::new(MachineParameters { spin: ratio * NATURAL, ..base })?;
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
            drawing.label_on_face(load + at(8.0, 4.0), Side::Right, "load", Hue::Blue)?;
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

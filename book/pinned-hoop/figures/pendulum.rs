//! The pendulum in the hoop, and the plateau of its wait.

use super::pinning;
use drawing::kit;
use drawing::{Drawing, Hue, Point, Rect, Role, Side, Stroke, at};
use figures::{Axis, Outcome, Plot, in_both, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::scenes::pinned_hoop::Shape;
use std::f64::consts::FRAC_PI_2;

/// The hoop at five angles of ω, and the pendulum at twice the angle.
pub(crate) fn twice_the_angle(id: &str) -> Outcome {
    let hoop = pinning(Shape::Hoop, 89.0)?;
    let top = hoop.free_motion()?;
    let period = top.period().ok_or("it swings")?;
    // From the start to the other side, half a period.
    let angles = linear_steps(0.0, 0.5 * period, 4000)
        .map(|time| {
            let omega = top.at(time)?.omega_body;
            Ok((-omega.y).atan2(omega.x))
        })
        .collect::<Result<Vec<f64>, InvalidQuantity>>()?;
    let last = angles[angles.len() - 1];
    let stills: Vec<f64> = [0.0, 45.0, 90.0, 135.0, 180.0]
        .map(|degrees: f64| degrees.to_radians().clamp(angles[0], last))
        .into_iter()
        .map(|wanted| angles.iter().copied().find(|&angle| angle >= wanted).unwrap_or(last))
        .collect();
    in_both(|room| {
        let (cell, radius) = room.of((108.0, 34.0), (66.0, 19.0));
        let mut drawing = Drawing::new(id, 5.0 * cell + 20.0, room.of(290.0, 230.0)).titled(
            "The hoop and its pendulum",
            "Five stills. Above, the hoop in its own plane, A at its right, and from A the part of omega in this plane: it points up at first, then to the upper right, to the \
             right, to the lower right and down. Below each a pendulum: at first it stands almost upright, then it is level, hangs straight down, is level on the other side and stands almost upright again.",
        );
        for (still, &angle) in stills.iter().enumerate() {
            let left = cell * still as f64 + room.of(50.0, 30.0);
            let centre = at(left, room.of(60.0, 44.0));
            let pin = centre + at(radius, 0.0);
            drawing.circle(centre, radius, Role::Line(Stroke::Vector, Hue::Blue));
            drawing.circle(centre, radius - 4.0, Role::Line(Stroke::Outline, Hue::Blue));
            let way = Point::polar(room.of(34.0, 24.0), FRAC_PI_2 - angle);
            kit::arrow(&mut drawing, pin, pin + way, Hue::Orange);
            drawing.dot(pin, 3.5, Hue::Pink);
            let degrees = angle.to_degrees().round();
            let below = room.of(122.0, 90.0);
            let name = if still == 0 { format!(r"$\chi = {degrees}°$") } else { format!("${degrees}°$") };
            drawing.label(at(left, below), Side::Over, &name, Hue::Ink)?;
            // Its pendulum.
            let pivot = at(left, room.of(196.0, 150.0));
            let bob = pivot + Point::polar(room.of(38.0, 24.0), FRAC_PI_2 - 2.0 * angle);
            drawing.line(pivot, bob, Stroke::Vector, Hue::Ink);
            drawing.dot(pivot, 2.6, Hue::Ink);
            drawing.disc(bob, 7.0, Hue::Ink);
            let twice = (2.0 * angle).to_degrees().round();
            let name = if still == 0 { format!(r"$2\chi = {twice}°$") } else { format!("${twice}°$") };
            drawing.label(at(left, room.of(268.0, 208.0)), Side::Over, &name, Hue::Ink)?;
        }
        let first = at(room.of(50.0, 30.0) + radius, room.of(60.0, 44.0));
        drawing.label(first + at(1.0, 6.0), Side::Right, "$A$", Hue::Pink)?;
        drawing.label(
            first - at(0.0, room.of(30.0, 20.0)),
            Side::Right,
            r"$\boldsymbol{\omega}$",
            Hue::Orange,
        )?;
        Ok(drawing)
    })
}

/// The integrand of the quarter period for three gaps.
pub(crate) fn wait_plateau(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 260.0).titled(
        "The wait is the width of a plateau",
        "The integrand against zeta, from minus 12 to 12, for three gaps. Each is a plateau of height one about the middle with steep sides; half of its height is at half the logarithm of one over \
         the gap, to either side: 2.3 for a hundredth, 4.6 for a ten thousandth and 9.2 for a hundred millionth.",
    );
    let across = Axis::linear(-12.0, 12.0, 4.0).minor(1.0).titled(r"$\zeta$");
    let up = Axis::linear(0.0, 1.0, 0.5).titled("integrand");
    let mut plot = Plot::new(&mut drawing, Rect::new(36.0, 56.0, 284.0, 148.0), across, up)?;
    for (decades, hue) in [(2, Hue::Faint), (4, Hue::Muted), (8, Hue::Ink)] {
        let gap = 10_f64.powi(-decades);
        let integrand = |zeta: f64| (1.0 + gap * gap + 2.0 * gap * (2.0 * zeta).cosh()).sqrt().recip();
        plot.curve(
            &format!("gap-{decades}"),
            linear_steps(-12.0, 12.0, 600).map(|zeta| (zeta, integrand(zeta))),
            if decades == 8 { Stroke::Heavy } else { Stroke::Curve },
            hue,
        );
    }
    for (x, decades, hue) in [(0.0, 2, Hue::Muted), (3.7, 4, Hue::Muted), (8.0, 8, Hue::Ink)] {
        plot.label((x, 1.02), Side::Above, &format!("$10^{{-{decades}}}$"), hue)?;
    }
    plot.label((-1.4, 1.075), Side::Left, "$k' =$", Hue::Muted)?;
    Ok(drawing)
}

/// A hoop pinned at 60° over one period: what an exercise asks to sketch.
pub(crate) fn swing_at_sixty(id: &str) -> Outcome {
    let hoop = pinning(Shape::Hoop, 60.0)?;
    let top = hoop.free_motion()?;
    let period = top.period().ok_or("it swings")?;
    let rate = hoop.omega_after().norm();
    let mut drawing = Drawing::new(id, 390.0, 420.0).titled(
        "The swing of a hoop that was pinned at sixty degrees",
        "Three plots over one period, one below the other. Omega 1 over W is a wave from a half to minus a half and back. Omega 2 over W stays between minus 0.87, at the ends and in the \
         middle of the period, and minus one. Chi swings from 60 degrees to 120 and back.",
    );
    let values = linear_steps(0.0, 1.0, 400).map(|part| Ok((part, top.at(part * period)?.omega_body)));
    let values = values.collect::<Result<Vec<_>, InvalidQuantity>>()?;
    let rows = [
        ("tangent", r"$\omega_1/W$", Axis::linear(-0.5, 0.5, 0.5), Hue::Orange),
        ("diameter", r"$\omega_2/W$", Axis::linear(-1.0, 0.0, 0.5), Hue::Orange),
        ("angle", r"$\chi$, degrees", Axis::linear(60.0, 120.0, 30.0), Hue::Ink),
    ];
    for (row, (name, title, axis, hue)) in rows.into_iter().enumerate() {
        let time = Axis::linear(0.0, 1.0, 0.25);
        let time = if row == 2 { time.titled("time, in periods") } else { time.marked(&[]).minor(0.25) };
        let frame = Rect::new(58.0, 34.0 + 122.0 * row as f64, 316.0, 78.0);
        let mut plot = Plot::new(&mut drawing, frame, time, axis.titled(title))?;
        let curve = values.iter().map(|(part, omega)| {
            let value = match row {
                0 => omega.x / rate,
                1 => omega.y / rate,
                _ => (-omega.y).atan2(omega.x).to_degrees(),
            };
            (*part, value)
        });
        plot.curve(name, curve, Stroke::Curve, hue);
    }
    Ok(drawing)
}

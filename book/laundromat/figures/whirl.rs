//! Friction that turns with the drum: which way it pushes, and what comes of it.

use super::{NATURAL, Values, cross, washing_machine};
use drawing::kit::{self, Heads, Marker};
use drawing::{Drawing, Hue, Point, Rect, Role, Side, Stroke, at};
use figures::{Axis, Cause, Outcome, Plot, Room, in_both, linear_steps};

/// A whirl from above, with what floor and drum do to it: below the threshold and beyond it.
pub(crate) fn whirl_forces(id: &str) -> Outcome {
    let mut panels = Vec::new();
    // Γᵢ = Γ/2: the threshold is 3 ω₀. The drum's push over the floor's is Γᵢ(Ω − ω₀)/Γω₀.
    for (ratio, name, words) in [
        (
            2.0,
            r"$\Omega = 2\,\omega_0$: the floor wins",
            "At two natural frequencies the floor’s arrow, backwards, is twice as long as the drum’s, forwards.",
        ),
        (
            5.0,
            r"$\Omega = 5\,\omega_0$: the drum wins",
            "At five natural frequencies the drum’s arrow, forwards, is twice as long as the floor’s, backwards.",
        ),
    ] {
        let machine = washing_machine(0.3, ratio)?;
        let (floor, spin) = (machine.damping_rate(), machine.spin());
        let rotor = machine.rotor(0.5 * machine.parameters().damping)?;
        let push = rotor.damping_rate_on_board() * (spin - NATURAL) / (floor * NATURAL);
        let mut drawing = Drawing::new("", 320.0, 300.0).titled("A whirl and what pushes it", words);
        let (origin, radius, azimuth) = (at(160.0, 140.0), 70.0, 0.0);
        drawing.circle(origin, radius, Role::Line(Stroke::Reference, Hue::Muted));
        let shaft = origin + Point::polar(radius, azimuth);
        drawing.line(origin, shaft, Stroke::Outline, Hue::Ink);
        for (length, sense, text, side) in [
            (44.0, -1.0, r"$\gamma\,\omega_0\,r$, floor", Side::Right),
            (44.0 * push, 1.0, r"$\gamma_i(\Omega - \omega_0)\,r$, drum", Side::Right),
        ] {
            let tip = shaft + Point::polar(length, azimuth + sense * 0.5 * std::f64::consts::PI);
            kit::arrow(&mut drawing, shaft, tip, Hue::Purple);
            drawing.label(tip + at(4.0, 0.0), side, text, Hue::Purple)?;
        }
        // The whirl goes round at ω₀; the drum overtakes it.
        for (reach, sweep, text) in
            [(radius - 22.0, 0.6, r"$\omega_0$"), (radius + 22.0, 0.3 * ratio, r"$\Omega$")]
        {
            let from = azimuth + 2.3;
            kit::angle(&mut drawing, origin, reach, from, sweep, Heads::End, Hue::Orange);
            let place = origin + Point::polar(reach, from - 0.08);
            drawing.label(place, Side::AboveRight, text, Hue::Orange)?;
        }
        kit::marker(&mut drawing, shaft, Marker::Ring, Hue::Ink);
        cross(&mut drawing, origin, 6.0);
        drawing.label(origin + at(0.0, 4.0), Side::Below, "$O$", Hue::Ink)?;
        drawing.label(at(160.0, 256.0), Side::Over, name, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels).titled(
        "What floor and drum do to a whirl",
        "Two pictures from above of a shaft that goes round O on a circle, counter-clockwise, at the natural frequency, while the drum turns faster. \
         Two forces act along the circle: one of the floor’s damper, backwards, and one of the damper on board, forwards. At a spin of two natural \
         frequencies the first is twice the second, at five the second is twice the first.",
    ))
}

/// How fast a disturbance grows or dies, over the spin, for some dampers.
pub(crate) fn whirl_growth(id: &str) -> Outcome {
    let most = 6.0;
    let growth = |floor: f64, board: f64| -> Result<Values, Cause> {
        let found = linear_steps(0.0, most, 600).map(|ratio| {
            let machine = washing_machine(floor, ratio)?;
            Ok((ratio, machine.rotor(board * NATURAL * machine.total_mass())?.growth() / NATURAL))
        });
        found.collect()
    };
    let [none, third, equal, only] =
        [growth(0.3, 0.0)?, growth(0.3, 0.1)?, growth(0.3, 0.3)?, growth(0.0, 0.3)?];
    let radial = linear_steps(0.0, most, 600)
        .map(|ratio| Ok((ratio, washing_machine(0.3, ratio)?.radial_damping_growth() / NATURAL)))
        .collect::<Result<Values, Cause>>()?;
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), 430.0).titled(
            "Growth against spin, for dampers on the floor and on board",
            "The rate at which a disturbance grows, over the natural frequency, against the spin from 0 to 6 natural frequencies. Above zero the plot is \
             tinted: there disturbances grow. With a damper on the floor only, the rate is a level line at minus 0.15. With a third as much on board \
             it rises through zero at 4, with as much on board at 2, and with all of it on board at 1, from minus 0.15 to 0.58 at the right edge. \
             A pale line, for a damper that feels only the radius, passes zero at 1 too but rises half as steeply at first.",
        );
        let spin = Axis::linear(0.0, most, 1.0).minor(0.5).titled(r"spin $\Omega/\omega_0$");
        let rate = Axis::linear(-0.4, 0.6, 0.2).minor(0.1).titled(r"growth rate over $\omega_0$");
        let frame = Rect::new(62.0, 34.0, room.of(504.0, 312.0), 342.0);
        let mut plot = Plot::new(&mut drawing, frame, spin, rate)?;
        plot.region((0.0, 0.0), (most, 0.6), Hue::Muted);
        plot.level(0.0, Stroke::Outline);
        for (name, values, stroke, hue) in [
            ("radial", &radial, Stroke::Curve, Hue::Faint),
            ("floor", &none, Stroke::Outline, Hue::Ink),
            ("third", &third, Stroke::Outline, Hue::Ink),
            ("equal", &equal, Stroke::Curve, Hue::Ink),
            ("board", &only, Stroke::Heavy, Hue::Ink),
        ] {
            plot.curve(name, values.iter().copied(), stroke, hue);
        }
        for threshold in [1.0, 2.0, 4.0] {
            plot.markers(&[(threshold, 0.0)], Marker::Disc, Hue::Ink);
        }
        plot.label((3.4, -0.15), Side::Below, r"on the floor only, $\Gamma_i = 0$", Hue::Ink)?;
        let place = plot.at((4.8, 0.085));
        plot.drawing().label_on_face(place, Side::AboveRight, r"$\Gamma_i = \Gamma/3$", Hue::Ink)?;
        let place = plot.at((3.5, 0.175));
        plot.drawing().label_on_face(place, Side::BelowRight, r"$\Gamma_i = \Gamma$", Hue::Ink)?;
        let place = plot.at((3.2, 0.33));
        plot.drawing().label_on_face(place, Side::AboveLeft, "on board only", Hue::Ink)?;
        let place = plot.at((room.of(0.35, 0.2), 0.53));
        plot.drawing().label_on_face(place, Side::Right, "grows", Hue::Muted)?;
        let place = plot.at(room.of((4.6, 0.25), (4.2, 0.225)));
        plot.drawing().label_on_face(place, Side::BelowRight, "radius only", Hue::Muted)?;
        Ok(drawing)
    })
}

//! The small scene at the steady motion: the load and the shaft at three speeds, side by side.

use super::laundromat::machine;
use live::prelude::*;
use mechanics::scenes::laundromat::SteadyMotion;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "speeds",
    title: "Load and shaft at three speeds",
    description: "Three drums, seen from above, go round a fixed point O together. The load of the slow one lies outwards; that of the one at resonance a quarter turn ahead; that \
                  of the fast one inwards, towards O.",
    question: "Three drums, each filmed so that it turns once in four seconds. How much damping does it take to move the load of each?",
    size: [[640.0, 270.0], [380.0, 186.0]],
    view: None,
    still: 0.5,
    controls: &[Control::log_slider("damping", r"damping, $\Gamma/\omega_0$", [0.02, 2.0], "", 0.3)],
    presets: &[
        preset("the machine of the chapter", &[]),
        preset("hardly any damping", &[("damping", 0.02)]),
        preset("very much", &[("damping", 2.0)]),
    ],
    readings: &[
        reading("lead of the load, slow", Form::Fixed(1), "°"),
        reading("at resonance", Form::Fixed(1), "°"),
        reading("fast", Form::Fixed(1), "°"),
    ],
    symbols: formulas!["O", r"\Omega = \tfrac12\omega_0", r"\Omega = \omega_0", r"\Omega = 3\,\omega_0"],
    start,
};

/// Spins, in natural frequencies, and how long a turn takes in the film, s.
const SPINS: [f64; 3] = [0.5, 1.0, 3.0];
const TURN: f64 = 4.0;

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let still = machine(settings.of("damping")?)?;
    let steady = SPINS.map(|ratio| still.with_spin(ratio * still.natural_frequency())?.steady());
    let [slow, middle, fast] = steady;
    let all = [slow?, middle?, fast?];
    let radii = all.map(|steady| steady.radius() / still.offset());
    Ok(Box::new(Small {
        of: all,
        run: Run { duration: TURN, pace: 1.0, repeats: true },
        words: format!(
            "In truth the shafts go round on circles of {:.2}, {:.2} and {:.2} times b; here all are drawn alike.",
            radii[0], radii[1], radii[2]
        ),
        readings: |all, _| Ok(all.iter().map(|steady| steady.phase().to_degrees()).collect()),
        draw: |all: &[SteadyMotion; 3], moment, drawing| {
            let names = [r"$\Omega = \tfrac12\omega_0$", r"$\Omega = \omega_0$", r"$\Omega = 3\,\omega_0$"];
            for (place, (steady, name)) in all.iter().zip(names).enumerate() {
                let place = place as f64;
                let size = moment.room.of(1.0, 0.6);
                let origin = moment.room.of(at(112.0 + 208.0 * place, 112.0), at(62.0 + 128.0 * place, 66.0));
                let turned = TAU * moment.time / TURN;
                let shaft = origin + Point::polar(30.0 * size, turned);
                let load = shaft + Point::polar(50.0 * size, turned + steady.phase());
                drawing.disc(shaft, 60.0 * size, Hue::Blue);
                drawing.circle(origin, 30.0 * size, Role::Line(Stroke::Reference, Hue::Ink));
                drawing.line(origin, origin + Point::polar(74.0 * size, turned), Stroke::Hatch, Hue::Ink);
                drawing.line(shaft, load, Stroke::Vector, Hue::Blue);
                kit::angle(drawing, shaft, 20.0 * size, turned, steady.phase(), Heads::None, Hue::Ink);
                drawing.dot(load, moment.room.of(8.0, 6.0), Hue::Blue);
                kit::marker(drawing, shaft, Marker::Ring, Hue::Ink);
                kit::marker(drawing, origin, Marker::Plus, Hue::Ink);
                let below = at(0.0, moment.room.of(128.0, 98.0));
                drawing.label(origin + below, Side::Over, name, Hue::Ink)?;
            }
            Ok(())
        },
    }))
}

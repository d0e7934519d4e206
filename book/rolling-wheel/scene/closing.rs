//! The small scene at the closing circle: a disc is slowed, and sinks on a smaller and smaller circle.

use super::rolled::{Given, RADIUS, is_flat};
use super::{Rolled, stage};
use live::prelude::*;
use mechanics::rolling::Rolling;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "closing",
    title: "A circle that closes",
    description: "A disc leans and rolls on a table. Something slows its turning: the track of its contact is a spiral that winds inwards until the disc lies flat. Beside it two \
                  plots against time: the radius of the circle falls to nothing, and the speed of the centre rises a little before it falls.",
    question: "Something slows the rotation of a disc. Does its centre become slower?",
    size: [[640.0, 440.0], [380.0, 530.0]],
    view: None,
    still: 3.2,
    controls: &[Control::slider("loss", r"loss, $\Gamma$", [0.02, 0.4, 0.01], "1/s", 0.1)],
    presets: &[
        preset("the disc of the program", &[]),
        preset("slowed gently", &[("loss", 0.04)]),
        preset("slowed hard", &[("loss", 0.3)]),
    ],
    readings: &[
        reading(r"lean $\theta$", Form::Fixed(1), "°"),
        reading(r"circle $b/a$", Form::Fixed(2), ""),
        reading("speed of the centre", Form::Fixed(2), "m/s"),
    ],
    symbols: formulas![r"b/a", r"\boldsymbol{L}"],
    start,
};

/// The circle's radius in radii of the disc, and the speed of the centre, m/s.
fn now(state: &Rolling) -> (f64, f64) {
    (Rolled::on_map(state).0, RADIUS * state.omega_3)
}

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let (lean, loss) = (9_f64.to_radians(), settings.of("loss")?);
    let rolled = Rolled::of(Given { lean, circle: 4.0, loss, ..Given::default() })?;
    let (first, end) = (now(&rolled.start).1, rolled.duration());
    let most = rolled.states.iter().map(|(_, state)| now(state).1).fold(0.0, f64::max);
    Ok(Box::new(Small {
        words: format!(
            "The centre sets out at {first:.2} m/s. The weight speeds it up as it sinks, to {most:.2} m/s at most, \
             and after {end:.1} s the disc lies flat."
        ),
        run: Run { duration: end, pace: 1.0, repeats: false },
        of: rolled,
        readings: |rolled, time| {
            let state = rolled.at(time)?;
            let (circle, speed) = now(&state);
            Ok(vec![state.lean().to_degrees(), circle, speed])
        },
        draw: |rolled, moment, drawing| {
            let state = rolled.at(moment.time)?;
            rolled.draw_stage(&moment.seen_from(-1.2, 0.5), &state, drawing)?;
            let (end, left) = (rolled.duration(), stage(moment.room).right + 40.0);
            let time = Axis::linear(0.0, end, nice_step(end / 4.0)).titled("time, s");
            let circle = Axis::linear(0.0, 5.0, 1.0).titled(r"circle $b/a$");
            let speed = Axis::linear(0.0, 2.0, 1.0).titled("speed of the centre, m/s");
            for (axis, [top, across], index) in [(circle, [40.0, 44.0], 0), (speed, [260.0, 230.0], 1)] {
                let frames = [[left, top, 170.0, 130.0], [across, 340.0, 130.0, 130.0]];
                let mut graph = moment.graph(drawing, frames, time, axis)?;
                let value = |state: &Rolling| <[f64; 2]>::from(now(state))[index];
                let up = rolled.states.iter().take_while(|(_, state)| !is_flat(state)).step_by(4);
                graph.curve(up.map(|(time, state)| (*time, value(state))), Stroke::Curve, Hue::Ink);
                graph.dot((moment.time, value(&state)), 4.0, Hue::Ink);
            }
            Ok(())
        },
    }))
}

//! The small scene of the page "A motor of limited torque": a knob is turned, and where the drum ends depends on the way.

use super::laundromat::{DRUM_INERTIA, machine};
use live::prelude::*;
use mechanics::integrate::rk4;
use mechanics::scenes::laundromat::{DrivenState, Motor};

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "knob",
    title: "The knob of a weak motor",
    description: "Two plots. In one, torque against spin: a steep hill at the resonance, a valley behind it, and the falling line of the motor; a dot rests where the line \
                  meets the near side of the hill. In the other, spin against the knob: an S of steady speeds, and the way of the drum along its lower branch.",
    question: "The knob stands at six newton metres. How fast does the drum turn in the end, if it came to six from below, from above, or from rest?",
    size: [[640.0, 290.0], [380.0, 570.0]],
    view: None,
    still: 95.0,
    controls: &[
        Control::slider("first", "from rest, with the knob at", [0.5, 9.0, 0.1], "N·m", 3.0),
        Control::slider("torque", "turned then to", [0.5, 9.0, 0.1], "N·m", 6.0),
        Control { start: 25.0, ..Control::adding("turn", "Turn the knob", &["torque"]) },
    ],
    presets: &[
        preset("three, then six", &[]),
        preset("six at once", &[("first", 6.0), ("turn", -1.0)]),
        preset("nine, then six", &[("first", 9.0)]),
        preset("six, then one half", &[("first", 6.0), ("turn", 25.0), ("torque", 0.5)]),
    ],
    readings: &[reading("knob", Form::Fixed(1), "N·m"), reading("spin", Form::Fixed(2), "rad/s")],
    symbols: &[],
    start,
};

/// The spin at which the motor gives nothing, rad/s.
const IDLE: f64 = 40.0;

/// The knob, N·m, which leaps when it is turned, and the spin, rad/s, at a time of a way, s.
fn reached(way: &[[f64; 2]], time: f64) -> [f64; 2] {
    [way[(10.0 * time) as usize][0], interpolated(way, 10.0 * time)[1]]
}

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let motor = Motor { stall_torque: 1.0, idle_spin: IDLE, drum_inertia: DRUM_INERTIA };
    let (drive, mut state) = (machine(0.15)?.driven(motor)?, DrivenState::AT_REST.to_array());
    let needed = |spin: f64| Ok((drive.required_stall_torque(spin)?, spin));
    let steady = linear_steps(3.0, 38.0, 280).map(needed).collect::<Result<Vec<_>, Cause>>()?;
    // The way: the knob, N·m, and the spin, rad/s, ten times a second.
    let (first, turns, mut way) = (settings.of("first")?, settings.presses("turn")?, Vec::new());
    for time in linear_steps(0.0, 100.0, 1000) {
        let knob = turns.iter().rev().find(|turn| turn[0] <= time).map_or(first, |turn| turn[1]);
        let drive = drive.with_stall_torque(knob)?;
        way.push([knob, state[4]]);
        state = rk4(|_, state: &[f64; 5]| drive.rates(0.0, state), 0.0, state, 0.1, 10)?;
    }
    let [knob, spin] = way[1000];
    let speeds = match drive.with_stall_torque(knob)?.steady_spins()[..] {
        [slow, _, fast] => format!("{slow:.1} or {fast:.1} rad/s. By this way it comes to {spin:.1}"),
        ref spins => format!("{:.1} rad/s only, by any way", spins.first().unwrap_or(&spin)),
    };
    Ok(Box::new(Small {
        of: (steady, way),
        run: Run { duration: 100.0, pace: 5.0, repeats: false },
        words: format!("With the knob at {knob:.1} N·m the drum can stay at {speeds}."),
        readings: |(_, way), time| Ok(reached(way, time).to_vec()),
        draw: |(steady, way), moment, drawing| {
            let now = reached(way, moment.time);
            let [knob, spin] = now;
            let way = way[..=(10.0 * moment.time) as usize].iter().chain([&now]);
            let torques = Axis::linear(0.0, 9.0, 3.0);
            let spins = Axis::linear(0.0, IDLE, 10.0).titled("spin, rad/s");
            let frames = [[44.0, 34.0, 250.0, 200.0], [44.0, 34.0, 320.0, 200.0]];
            let mut graph = moment.graph(drawing, frames, spins, torques.titled("torque, N·m"))?;
            // What shaking takes is what the motor gives with the knob that holds this spin.
            let taken = steady.iter().map(|(knob, spin)| (*spin, knob * (1.0 - spin / IDLE)));
            graph.curve(taken, Stroke::Curve, Hue::Purple);
            graph.curve([(0.0, knob), (IDLE, 0.0)], Stroke::DashedCurve, Hue::Purple);
            graph.label((13.0, 8.6), Side::Right, "the motor gives (dashed)", Hue::Purple)?;
            graph.label((13.0, 7.4), Side::Right, "the shaking takes", Hue::Purple)?;
            graph.dot((spin, knob * (1.0 - spin / IDLE)), 5.0, Hue::Ink);
            let frames = [[366.0, 34.0, 250.0, 200.0], [44.0, 318.0, 320.0, 200.0]];
            let mut graph = moment.graph(drawing, frames, torques.titled("knob, N·m"), spins)?;
            graph.curve(steady.iter().copied(), Stroke::Outline, Hue::Purple);
            graph.curve(way.map(|&point| point.into()), Stroke::Curve, Hue::Ink);
            graph.dot(now.into(), 5.0, Hue::Ink);
            Ok(())
        },
    }))
}

//! The small scene of "Frisbee and pencil" at its two clocks: both parts of the angular velocity fade, each at its own rate.

use live::prelude::*;
use mechanics::inertia::PrincipalMoments;
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use nalgebra::Vector3;
use std::f64::consts::LN_2;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "clocks",
    title: "Two clocks",
    description: "At the left an arrow, the angular velocity of a long body, its part along the axis upwards and its part across the axis to the right; its tip has left a \
                  curve that leans away from the upright. Beside it both parts against time on a logarithmic scale: two straight lines, that of the spin twice as steep.",
    question: "Equal drag on a body that spins and wobbles: both parts of its rotation fade. For which shapes does the arrow lean away from the axis?",
    size: [[640.0, 300.0], [380.0, 570.0]],
    view: None,
    still: 20.0,
    controls: &[Control::log_slider("ratio", r"long to flat: moments $I_3/I_1$", [0.1, 2.0], "", 0.5)],
    presets: &[
        preset("a long body", &[]),
        preset("nearly a pencil", &[("ratio", 0.1)]),
        preset("neither flat nor long", &[("ratio", 1.0)]),
        preset("a disc", &[("ratio", 2.0)]),
    ],
    readings: &[
        reading("spin", Form::Digits(3), "rad/s"),
        reading("across the axis", Form::Digits(3), "rad/s"),
        reading(r"angle of $\boldsymbol\omega$ and the axis", Form::Fixed(1), "°"),
    ],
    symbols: formulas![r"\boldsymbol{\omega}"],
    start,
};

/// In how long the rotation across the axis is halved, s.
const HALVED: f64 = 20.0;

/// The parts of the angular velocity across the axis and along it, rad/s.
fn parts(top: &DraggedTop, time: f64) -> Result<(f64, f64), Cause> {
    let omega = top.at(time)?;
    Ok((omega.x.hypot(omega.y), omega.z))
}

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let (ratio, omega_body) = (settings.of("ratio")?, Vector3::new(12.0, 0.0, 20.0));
    let (moments, drag) = (PrincipalMoments::symmetric(1.0, ratio)?, Drag::isotropic(LN_2 / HALVED));
    let leans = if (ratio - 1.0).abs() < 0.002 {
        "Both die alike, and the arrow keeps its lean."
    } else {
        "The arrow leans away from the part that dies sooner."
    };
    Ok(Box::new(Small {
        of: DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?,
        run: Run { duration: 60.0, pace: 6.0, repeats: false },
        words: format!(
            "The spin is halved every {:.1} s, the rotation across the axis every {HALVED} s. {leans}",
            HALVED * ratio
        ),
        readings: |top, time| {
            let (across, spin) = parts(top, time)?;
            Ok(vec![spin, across, across.atan2(spin).to_degrees()])
        },
        draw: |top, moment, drawing| {
            let all = linear_steps(0.0, 60.0, 240).map(|time| Ok((time, parts(top, time)?)));
            let (all, now) = (all.collect::<Result<Vec<_>, Cause>>()?, parts(top, moment.time)?);
            let (across, along) = (Axis::linear(0.0, 12.0, 6.0), Axis::linear(0.0, 20.0, 10.0));
            let frames = [[60.0, 34.0, 126.0, 210.0], [120.0, 34.0, 126.0, 210.0]];
            let mut graph =
                moment.graph(drawing, frames, across.titled("across, rad/s"), along.titled("spin, rad/s"))?;
            graph.curve(all.iter().map(|(_, parts)| *parts), Stroke::Orbit, Hue::Orange);
            let [foot, tip] = [(0.0, 0.0), now].map(|parts| graph.at(parts));
            kit::arrow(drawing, foot, tip, Hue::Orange);
            drawing.label(tip, Side::Right, r"$\boldsymbol{\omega}$", Hue::Orange)?;
            let frames = [[290.0, 34.0, 320.0, 210.0], [48.0, 318.0, 310.0, 200.0]];
            let (time, rate) = (Axis::linear(0.0, 60.0, 20.0).titled("time, s"), Axis::log(0.1, 100.0, 1));
            let mut graph = moment.graph(drawing, frames, time, rate.titled("rad/s"))?;
            for (name, stroke, of) in [("spin", Stroke::Heavy, 1), ("across", Stroke::Curve, 0)] {
                let part = |parts: (f64, f64)| <[f64; 2]>::from(parts)[of];
                graph.curve(all.iter().map(|(time, parts)| (*time, part(*parts))), stroke, Hue::Orange);
                graph.dot((moment.time, part(now)), 5.0, Hue::Orange);
                // Clear of the dot, which runs along the line.
                let (side, away) = [(Side::BelowRight, 0.6), (Side::AboveRight, 1.6)][of];
                graph.label((2.0, away * part(all[8].1)), side, name, Hue::Orange)?;
            }
            Ok(())
        },
    }))
}

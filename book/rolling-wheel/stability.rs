//! The small scene of the page "Which circles last, and how a disc falls": a disc is let go almost flat.

use super::loss::draw_leaning;
use live::prelude::*;
use mechanics::integrate::Taylor;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::{Wheel, Wobble};
use nalgebra::Vector3;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "near-flat",
    title: "A disc that falls almost flat",
    description: "A disc leans a little over a table, with its heights magnified. Its lowest point has run once round on the table and an eighth further, which a pink \
                  spiral shows. Below, the tilt against the angle of the contact: it falls to almost nothing at half of that angle, and rises again to where it was.",
    question: "The disc is let go almost flat, and hardly turns. How far has its contact run round when it is up again? And if it turns ten times less?",
    size: [[640.0, 430.0], [380.0, 470.0]],
    view: None,
    still: 6.6,
    controls: &[
        Control::log_slider("turn", "its turn at first, over that of steady rolling", [1e-4, 0.9], "", 0.001),
        Control::choice("wheel", "what falls", &["a disc", "a hoop"]),
    ],
    presets: &[
        preset("hardly a turn", &[]),
        preset("ten times less", &[("turn", 1e-4)]),
        preset("a good turn", &[("turn", 0.6)]),
        preset("a hoop", &[("wheel", 1.0)]),
    ],
    readings: &[reading("run round by", Form::Fixed(1), "°"), reading("tilt", Form::Digits(3), "rad")],
    symbols: &[],
    start,
};

/// The tilt at first, rad, and how long the film shows it fall and get up again, s.
const TILT: f64 = 0.05;
const FILM: f64 = 8.0;

/// How far the contact has run round, degrees, and the tilt, 1 at first. The film is slow where the wheel lies flat.
fn now(wobble: &Wobble, turn: f64, time: f64) -> Result<(f64, f64), Cause> {
    let (part, steep) = (2.0 * time / FILM - 1.0, (1.0 / turn).asinh());
    let state = wobble.at(0.5 * wobble.period() * (1.0 + (steep * part).sinh() / steep.sinh()))?;
    Ok((state.heading.to_degrees(), state.tilt / TILT))
}

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let moments = [MomentFactors::DISK, MomentFactors::HOOP][settings.choice("wheel")?];
    let wheel = Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 })?;
    let turn = settings.of("turn")?;
    let omega_2 = turn * wheel.steady(FRAC_PI_2 - TILT, 0.0)?.state().omega_2;
    let wobble = wheel.wobble(Rolling { tilt: TILT, omega_2, ..Rolling::UPRIGHT }, &Taylor::new(1e-15)?)?;
    let [round, least] = [wobble.heading_advance(), wheel.near_flat_turn()].map(f64::to_degrees);
    Ok(Box::new(Small {
        of: (wobble, turn),
        run: Run { duration: FILM, pace: 1.0, repeats: false },
        words: format!("The contact runs round by {round:.1}°: for the slightest turn by {least:.1}°."),
        readings: |(wobble, turn), time| {
            now(wobble, *turn, time).map(|(round, tilt)| vec![round, TILT * tilt])
        },
        draw: |(wobble, turn), moment, drawing| {
            let (round, tilt) = now(wobble, *turn, moment.time)?;
            let (centre, scale) = moment.room.of((at(320.0, 120.0), 120.0), (at(190.0, 120.0), 104.0));
            let camera = moment.seen_from(-1.1, 0.5).camera([0.0, 0.0, 0.1], 9.0, centre, scale)?;
            let (mut stage, angle) = (Stage::new(camera), round.to_radians());
            let contact = draw_leaning(&mut stage, 0.35 * tilt.powf(0.4), angle)?;
            let way = linear_steps(0.0, angle.max(0.05), 90)
                .map(|angle| Vector3::new(angle.cos(), angle.sin(), 0.0) * (1.04 + 0.02 * angle));
            stage.curve(Curve::smooth(way)?, Stroke::Curve, Hue::Pink)?;
            stage.dot_in_front(contact, 5.0, Hue::Pink)?;
            stage.write(drawing);
            let frames = [[130.0, 276.0, 380.0, 100.0], [44.0, 310.0, 316.0, 106.0]];
            let angle = Axis::linear(0.0, 495.0, 90.0).titled("angle of the contact, degrees");
            let tilts = Axis::linear(0.0, 1.0, 0.5).titled("tilt, of that at first");
            let mut graph = moment.graph(drawing, frames, angle, tilts)?;
            let falls = linear_steps(0.0, FILM, 240).filter_map(|time| now(wobble, *turn, time).ok());
            graph.curve(falls, Stroke::Curve, Hue::Pink);
            graph.upright(360.0, Stroke::Reference, Hue::Muted);
            graph.label((355.0, 0.9), Side::Left, "once round", Hue::Muted)?;
            graph.dot((round, tilt), 5.0, Hue::Pink);
            Ok(())
        },
    }))
}

//! The small scene of the landscape on the drum: the steady place is the bottom of a bowl, or the top of a hill.

use super::laundromat::machine;
use live::prelude::*;
use mechanics::integrate::rk4;
use mechanics::scenes::laundromat::Shaft;
use nalgebra::Complex;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "hill",
    title: "A kick in the landscape",
    description: "At the left the drum seen by its rider: rings about the steady place are contours, and the shaft has drawn loops between them. At the right the height of the \
                  landscape against the distance from the steady place falls steeply, a hill; a dot on it is the shaft, and a level line above it says how much J it has.",
    question: "The shaft is kicked out of its steady place. On a hill, which of the dampers brings it back to the top?",
    size: [[640.0, 320.0], [380.0, 600.0]],
    view: None,
    still: 0.8,
    controls: &[
        Control::slider(
            "spin",
            r"spin, $\Omega$, with $\omega_0 = 10$ rad/s",
            [3.0, 30.0, 0.5],
            "rad/s",
            22.0,
        ),
        Control::choice("damper", "what resists", &["the radius only", "dampers on the floor", "nothing"]),
    ],
    presets: &[
        preset("a hill, the radius", &[]),
        preset("a hill, the floor", &[("damper", 1.0)]),
        preset("a hill, no damper", &[("damper", 2.0)]),
        preset("a bowl, the radius", &[("spin", 6.0)]),
    ],
    readings: &[
        reading("distance from the steady place", Form::Fixed(1), "mm"),
        reading(r"$J$ above that of the steady place", Form::Fixed(1), "mJ/kg"),
    ],
    symbols: formulas!["J"],
    start,
};

/// The kick, m/s; how far out the shaft is followed, m; for how long, s, and how often it is looked at, s.
const KICK: f64 = 0.25;
const REACH: f64 = 0.06;
const LASTS: f64 = 4.0;
const STEP: f64 = 0.01;

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let (spin, damper) = (settings.of("spin")?, settings.choice("damper")?);
    let damped = machine(0.15)?.with_spin(spin)?;
    let free = damped.with_damping(0.0)?;
    // A damper on the radius does nothing to a circle.
    let place = if damper == 1 { damped.steady()? } else { free.steady()? }.amplitude();
    let velocity = place * Complex::new(0.0, spin);
    let rest = free.jacobi_integral(0.0, &Shaft { position: place, velocity });
    let mut state = Shaft { position: place, velocity: velocity + Complex::new(0.0, KICK) }.to_array();
    // What the rider sees: the way from the steady place, x and y, m, and J above it, J/kg.
    let mut way: Vec<[f64; 3]> = Vec::new();
    while way.len() <= (LASTS / STEP) as usize && way.last().is_none_or(|[x, y, _]| x.hypot(*y) < REACH) {
        let (time, shaft) = (STEP * way.len() as f64, Shaft::from_array(state));
        let seen = shaft.position * Complex::cis(-spin * time) - place;
        way.push([seen.re, seen.im, free.jacobi_integral(time, &shaft) - rest]);
        let rates = |time: f64, state: &[f64; 4]| match damper {
            0 => damped.radial_damping_rates(time, state),
            1 => damped.cartesian_rates(time, state),
            _ => free.cartesian_rates(time, state),
        };
        state = rk4(rates, time, state, time + STEP, 5)?;
    }
    let growth = [damped.radial_damping_growth(), -0.5 * damped.damping_rate(), 0.0][damper];
    let fate = match growth {
        g if g > 0.0 => format!("runs down: its loops grow by a factor e in {:.2} s", 1.0 / g),
        g if g < 0.0 => format!("comes home: its loops shrink by a factor e in {:.2} s", -1.0 / g),
        _ => "neither comes home nor runs away".into(),
    };
    let ground = if spin < 10.0 { "bottom of a bowl" } else { "top of a hill" };
    let slope = 0.5 * (free.natural_frequency().powi(2) - spin * spin);
    Ok(Box::new(Small {
        run: Run { duration: STEP * (way.len() - 1) as f64, pace: 0.5, repeats: false },
        of: (way, slope),
        words: format!("The steady place is the {ground}. The shaft {fate}."),
        readings: |(way, _), time| {
            let [x, y, excess] = interpolated(way, time / STEP);
            Ok(vec![1e3 * x.hypot(y), 1e3 * excess])
        },
        draw: |(way, slope), moment, drawing| {
            let now = interpolated(way, moment.time / STEP);
            let [x, y, excess] = now;
            let (centre, scale) = (moment.room.of(at(140.0, 140.0), at(190.0, 140.0)), 124.0 / REACH);
            let on_page = |[x, y, _]: &[f64; 3]| centre + at(*x, -y) * scale;
            for ring in 1..=6 {
                drawing.circle(centre, 124.0 / 6.0 * f64::from(ring), Role::Line(Stroke::Grid, Hue::Ink));
            }
            let reached = (moment.time / STEP) as usize;
            let way = &way[reached.saturating_sub(120)..=reached];
            let trail: Vec<Point> = way.iter().chain([&now]).map(on_page).collect();
            drawing.polyline(&trail, Stroke::Outline, Hue::Muted);
            drawing.polyline(&trail[trail.len().saturating_sub(40)..], Stroke::Curve, Hue::Ink);
            drawing.dot(centre, 2.6, Hue::Muted);
            drawing.dot(on_page(&now), 5.0, Hue::Ink);
            drawing.label(centre + at(0.0, 146.0), Side::Over, "seen by the rider, from above", Hue::Ink)?;
            let edge = 1e3 * slope * REACH * REACH;
            let step = nice_step(0.25 * (edge.abs() + 60.0));
            let [low, high] = [(edge.min(0.0) / step).floor() * step, (edge.max(60.0) / step).ceil() * step];
            let frames = [[350.0, 34.0, 260.0, 212.0], [60.0, 340.0, 290.0, 200.0]];
            let far = Axis::linear(0.0, 1e3 * REACH, 20.0).titled("distance from the steady place, mm");
            let mut graph =
                moment.graph(drawing, frames, far, Axis::linear(low, high, step).titled("height, mJ/kg"))?;
            let height = |far: f64| 1e3 * slope * far * far;
            let ground = linear_steps(0.0, REACH, 60).map(|far| (1e3 * far, height(far)));
            graph.curve(ground, Stroke::Heavy, Hue::Muted);
            let (far, level) = (1e3 * x.hypot(y).min(REACH), 1e3 * excess);
            graph.level(level, Stroke::Reference, Hue::Ink);
            graph.label((1e3 * REACH, level), Side::AboveLeft, "$J$", Hue::Ink)?;
            graph.dot((far, height(1e-3 * far)), 5.0, Hue::Ink);
            Ok(())
        },
    }))
}

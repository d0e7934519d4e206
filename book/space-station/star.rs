//! The small scene of "Back to the stars": the place of a star on board as the sum of two arrows that turn against each other.

use live::prelude::*;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "star",
    title: "The star that stood on the cross",
    description: "A camera’s picture of the sky about a cross, which is the axis of the station. An arrow leads from the cross to L, another as long from there to a star. The star \
                  has drawn a line through the cross, to and fro, which turns slowly. Below, its distance from the cross against time: arches that come back to zero.",
    question: "How often is the star back on the cross in one old turn, and how often has the angular momentum gone round? And on a longer body?",
    size: [[640.0, 330.0], [380.0, 570.0]],
    view: None,
    still: 9.0,
    controls: &[
        Control::slider(
            "lean",
            r"lean of $\boldsymbol L$ after the blow, $\theta_L$",
            [0.5, 25.0, 0.5],
            "°",
            11.5,
        ),
        Control::slider("ratio", r"long to flat: moments $I_3/I_1$", [0.2, 2.0, 0.05], "", 2.0),
    ],
    presets: &[
        preset("the station", &[]),
        preset("a light blow", &[("lean", 0.5)]),
        preset("a long body", &[("ratio", 0.2)]),
        preset("equal moments", &[("ratio", 1.0)]),
    ],
    readings: &[
        reading("old turns", Form::Fixed(2), ""),
        reading("the star is off the cross by", Form::Fixed(1), "°"),
        reading(r"rounds of $\boldsymbol L$ on board", Form::Fixed(2), ""),
    ],
    symbols: formulas![r"\boldsymbol{L}", r"\theta_L"],
    start,
};

/// The spin, rad/s, which a blow across the axis does not change.
const SPIN: f64 = 0.45;

/// What is followed: the station and its L, and for how many old turns, with marks how far apart; the way of the star.
struct Sky {
    top: FreeTop,
    momentum: Vector3<f64>,
    lean: f64,
    ratio: f64,
    turns: f64,
    step: f64,
    way: Vec<(f64, f64)>,
}

/// Where a direction in the room stands in the camera's picture, in the lean of L.
fn seen(state: &Turning, direction: &Vector3<f64>, lean: f64) -> (f64, f64) {
    let on_board = state.world_from_body.inverse() * direction;
    let from_cross = on_board.xy().norm().atan2(on_board.z) / on_board.xy().norm().max(1e-300) / lean;
    (on_board.y * from_cross, on_board.x * from_cross)
}

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let (lean, ratio) = (settings.of("lean")?.to_radians(), settings.of("ratio")?);
    let across = SPIN * ratio * lean.tan();
    let omega_body = Vector3::new(across, 0.0, SPIN);
    let begin = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
    let top = FreeTop::new(PrincipalMoments::symmetric(1.0, ratio)?, begin)?;
    let momentum = Vector3::new(across, 0.0, ratio * SPIN).normalize();
    let nods = ratio / lean.cos();
    // Two nods at least, and two old turns.
    let (turns, step) = if nods < 1.0 { ((2.0 / nods).ceil(), 2.0) } else { (2.0, 0.5) };
    let times: Vec<f64> = linear_steps(0.0, turns * TAU / SPIN, 400).collect();
    let way = top.sample(&times)?.iter().map(|state| seen(state, &Vector3::z(), lean)).collect();
    Ok(Box::new(Small {
        of: Sky { top, momentum, lean, ratio, turns, step, way },
        run: Run { duration: turns * TAU / SPIN, pace: 1.5 * turns, repeats: false },
        words: format!(
            "The star is back on the cross every {:.2} old turns: in one it nods {nods:.2} times, and the angular \
             momentum goes round the cross {:.2} times.",
            1.0 / nods,
            (ratio - 1.0).abs()
        ),
        readings: |sky, time| {
            let (x, y) = seen(&sky.top.at(time)?, &Vector3::z(), sky.lean);
            let turns = time * SPIN / TAU;
            Ok(vec![turns, sky.lean.to_degrees() * x.hypot(y), (sky.ratio - 1.0) * turns])
        },
        draw: |sky, moment, drawing| {
            let (cross, unit) = moment.room.of((at(150.0, 150.0), 64.0), (at(190.0, 150.0), 64.0));
            let place = |(x, y): (f64, f64)| cross + at(x, -y) * unit;
            let (now, old_turns) = (sky.top.at(moment.time)?, moment.time * SPIN / TAU);
            let gone = (400.0 * old_turns / sky.turns) as usize;
            let star = seen(&now, &Vector3::z(), sky.lean);
            let trail: Vec<Point> =
                sky.way[..=gone.min(400)].iter().copied().chain([star]).map(place).collect();
            drawing.circle(cross, unit, Role::Line(Stroke::Dotted, Hue::Muted));
            drawing.polyline(&trail, Stroke::Outline, Hue::Muted);
            let [tip, end] = [seen(&now, &sky.momentum, sky.lean), star].map(place);
            for step in [at(5.0, 0.0), at(0.0, 5.0)] {
                drawing.line(cross - step, cross + step, Stroke::Vector, Hue::Blue);
            }
            kit::arrow(drawing, cross, tip, Hue::Green);
            kit::arrow(drawing, tip, end, Hue::Ink);
            drawing.dot(end, 4.5, Hue::Ink);
            drawing.label(tip + (tip - cross).unit() * 13.0, Side::Over, r"$\boldsymbol{L}$", Hue::Green)?;
            let frames = [[350.0, 50.0, 260.0, 200.0], [60.0, 344.0, 290.0, 170.0]];
            let turns = Axis::linear(0.0, sky.turns, sky.step).titled("old turns");
            let away = Axis::linear(0.0, 2.2, 1.0).titled(r"distance from the cross, in $\theta_L$");
            let mut graph = moment.graph(drawing, frames, turns, away)?;
            let arches = sky.way.iter().enumerate();
            let arches = arches.map(|(n, (x, y))| (sky.turns * n as f64 / 400.0, x.hypot(*y)));
            graph.curve(arches, Stroke::Curve, Hue::Ink);
            graph.dot((old_turns, star.0.hypot(star.1)), 5.0, Hue::Ink);
            Ok(())
        },
    }))
}

//! The small scene of "Turned by an area": the normal of the coin goes once round a cap, and its arrow comes back turned.

use super::loss::TOY;
use live::prelude::*;
use mechanics::scenes::spinning_coin::SpinningCoin;
use nalgebra::Vector3;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "cap",
    title: "An arrow that never turns, and comes back turned",
    description: "A sphere with a shaded cap about its top. A dot, the normal of the coin, has gone part of the way round the edge of the cap and has left arrows behind, each of which \
                  shows where the head points. Below, the angle by which the arrow is turned against the first one, over the part of the round: a straight line.",
    question: "The arrow never turns about the normal. By how much is it turned after a round, if the coin lies nearly flat, and if it stands nearly upright?",
    size: [[640.0, 330.0], [380.0, 560.0]],
    view: None,
    still: 4.4,
    controls: &[Control::slider("tilt", r"tilt, $\alpha$", [5.0, 85.0, 1.0], "°", 41.0)],
    presets: &[
        preset("a coin at 41°", &[]),
        preset("nearly flat", &[("tilt", 10.0)]),
        preset("by sixty degrees: half a turn", &[("tilt", 60.0)]),
        preset("nearly upright", &[("tilt", 85.0)]),
    ],
    readings: &[
        reading("part of the round", Form::Fixed(2), ""),
        reading("the arrow is turned by", Form::Fixed(1), "°"),
    ],
    symbols: formulas![r"\hat{\mathbf{n}}"],
    start,
};

/// How long a round takes in the film, s.
const ROUND: f64 = 6.0;

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let coin = SpinningCoin::new(TOY, settings.of("tilt")?.to_radians())?;
    let round = 360.0 * coin.figure_rate() / coin.turn_rate();
    Ok(Box::new(Small {
        of: (coin, round),
        run: Run { duration: ROUND, pace: 1.0, repeats: false },
        words: format!(
            "After a round the arrow is turned by {round:.1}°. That is the area of the cap, {:.3}, in radians.",
            round.to_radians()
        ),
        readings: |(_, round), time| Ok(vec![time / ROUND, time / ROUND * round]),
        draw: |(coin, round), moment, drawing| {
            let part = moment.time / ROUND;
            let (centre, scale) = moment.room.of((at(160.0, 165.0), 132.0), (at(190.0, 150.0), 125.0));
            let camera = moment.seen_from(-FRAC_PI_2, 1.0).camera([0.0, 0.0, 0.2], 8.0, centre, scale)?;
            let mut stage = Stage::new(camera);
            stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Muted)?;
            let normal = |turns: f64| coin.attitude(turns) * Vector3::z();
            let edge: Vec<Vector3<f64>> = linear_steps(0.0, 1.0, 90).map(normal).collect();
            stage.patch(edge.clone(), Fill::Face, Hue::Blue)?;
            stage.curve(Curve::smooth(edge)?, Stroke::Outline, Hue::Blue)?;
            // The head's way up, bent along the sphere.
            let arrow = |turns: f64| {
                let (foot, way) = (normal(turns), coin.attitude(turns) * Vector3::y());
                Curve::smooth(linear_steps(0.0, 0.4, 8).map(|arc| foot * arc.cos() + way * arc.sin()))
            };
            for left in (1..8).map(|n| f64::from(n) / 8.0).take_while(|left| *left < part) {
                stage.arrow(arrow(left)?, Stroke::Outline, Heads::End, Hue::Ink)?;
            }
            stage.arrow(arrow(0.0)?, Stroke::Reference, Heads::End, Hue::Ink)?;
            stage.arrow(arrow(part)?, Stroke::Vector, Heads::End, Hue::Ink)?;
            stage.dot_in_front(normal(part), 5.0, Hue::Blue)?;
            let outwards = normal(part).xy().normalize();
            let shift = at(outwards.x, -outwards.y) * 14.0;
            stage.label_shifted(normal(part), shift, Side::Over, r"$\hat{\mathbf{n}}$", Hue::Blue)?;
            stage.write(drawing);
            let frames = [[380.0, 60.0, 230.0, 200.0], [60.0, 330.0, 290.0, 170.0]];
            let done = Axis::linear(0.0, 1.0, 0.25).titled("part of the round");
            let turned = Axis::linear(0.0, 360.0, 90.0).titled("turned by, degrees");
            let mut graph = moment.graph(drawing, frames, done, turned)?;
            graph.curve([(0.0, 0.0), (1.0, *round)], Stroke::Curve, Hue::Muted);
            graph.dot((part, part * round), 5.0, Hue::Ink);
            Ok(())
        },
    }))
}

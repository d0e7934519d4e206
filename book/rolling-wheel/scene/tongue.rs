//! The small scene at the tongue: what a weak kick comes to, for a lean and a circle.

use super::rolled::{RADIUS, tongue, wheel};
use live::prelude::*;
use mechanics::integrate::Taylor;
use mechanics::scenes::rolling_wheel::Wobble;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "tongue",
    title: "Where a weak kick grows",
    description: "A map of circles and leans. A shaded tongue rises from small leans to a tip near 19 degrees, that of a disc; a thin curve bounds that of a hoop. A dot stands inside \
                  the tongue, for a disc that leans by 12 degrees. Beside it the lean of that disc against time, after a weak kick: it swings far away.",
    question: "A disc that leans by 12° is lost after the weakest kick, one that leans by 26° is not. Is that so on every circle? And how nearly upright may the safe one stand?",
    size: [[640.0, 330.0], [380.0, 540.0]],
    view: None,
    still: 2.4,
    controls: &[
        Control::slider("lean", r"lean, $\theta$", [1.0, 40.0, 0.1], "°", 12.0),
        Control::slider("circle", r"radius of the centre's circle, $b/a$", [0.02, 4.0, 0.01], "", 0.8),
    ],
    presets: &[
        preset("leaning by 12°", &[]),
        preset("by 26°", &[("lean", 26.0)]),
        preset("by 12°, on a wide circle", &[("circle", 3.6)]),
        preset("nearly on the spot", &[("circle", 0.06)]),
    ],
    readings: &[reading(r"lean $\theta$", Form::Fixed(1), "°")],
    symbols: formulas![r"b/a", r"\theta"],
    start,
};

/// The rate of lean that the kick gives, rad/s, and how long the film goes on, s.
const KICK: f64 = 0.05;
const FILM: f64 = 6.0;

/// A disc's circle and lean, °; how it wobbles after the kick; the tongues of a disc and of a hoop.
struct Kicked {
    place: (f64, f64),
    wobble: Wobble,
    tongues: [Vec<(f64, f64)>; 2],
}

impl Kicked {
    /// The lean at a time, °.
    fn lean(&self, time: f64) -> Result<f64, Cause> {
        Ok(self.wobble.at(time)?.lean().to_degrees())
    }
}

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let (lean, circle) = (settings.of("lean")?, settings.of("circle")?);
    let [disc, hoop] = [wheel(0, 1.0)?, wheel(1, 1.0)?];
    let steady = disc.steady(lean.to_radians(), circle * RADIUS)?;
    let mut state = steady.state();
    state.omega_1 += KICK;
    let wobble = disc.wobble(state, &Taylor::new(1e-13)?)?;
    let square = steady.wobble_square();
    let words = if steady.is_stable() {
        format!("It is held: the kick is a wobble that comes and goes in {:.2} s.", TAU / square.sqrt())
    } else {
        format!("It is lost: the kick grows by the factor e in {:.2} s.", 1.0 / (-square).sqrt())
    };
    Ok(Box::new(Small {
        of: Kicked { place: (circle, lean), wobble, tongues: [tongue(&disc), tongue(&hoop)] },
        run: Run { duration: FILM, pace: 1.0, repeats: false },
        words,
        readings: |kicked, time| Ok(vec![kicked.lean(time)?]),
        draw: |kicked, moment, drawing| {
            let frames = [[50.0, 40.0, 260.0, 220.0], [48.0, 34.0, 310.0, 180.0]];
            let circle = Axis::linear(0.0, 4.0, 1.0).titled(r"circle $b/a$");
            let lean = Axis::linear(0.0, 40.0, 10.0).titled(r"lean $\theta$, °");
            let mut map = moment.graph(drawing, frames, circle, lean)?;
            let [disc, hoop] = &kicked.tongues;
            let below = [(0.0, 0.0)].into_iter().chain(disc.iter().copied()).chain([(4.0, 0.0)]);
            map.area(below, Fill::Ground, Hue::Ink);
            map.curve(disc.iter().copied(), Stroke::Border, Hue::Ink);
            map.curve(hoop.iter().copied(), Stroke::Orbit, Hue::Muted);
            map.label((0.55, 19.6), Side::AboveRight, "hoop", Hue::Muted)?;
            map.label((2.2, 30.0), Side::Right, "stays small", Hue::Ink)?;
            map.label((1.6, 4.0), Side::Right, "grows", Hue::Ink)?;
            map.dot(kicked.place, 5.0, Hue::Blue);
            let frames = [[376.0, 40.0, 240.0, 220.0], [48.0, 304.0, 310.0, 190.0]];
            let times = linear_steps(0.0, FILM, 240);
            let leans =
                times.map(|time| Ok((time, kicked.lean(time)?))).collect::<Result<Vec<_>, Cause>>()?;
            let is_small = leans.iter().all(|(_, lean)| (0.0..=40.0).contains(lean));
            let time = Axis::linear(0.0, FILM, 2.0);
            let lean = if is_small { Axis::linear(0.0, 40.0, 10.0) } else { Axis::linear(-90.0, 90.0, 45.0) };
            let mut graph = moment.graph(
                drawing,
                frames,
                time.titled("time, s"),
                lean.titled("its lean after a weak kick, °"),
            )?;
            graph.level(kicked.place.1, Stroke::Reference, Hue::Muted);
            graph.curve(leans, Stroke::Curve, Hue::Blue);
            graph.dot((moment.time, kicked.lean(moment.time)?), 5.0, Hue::Blue);
            Ok(())
        },
    }))
}

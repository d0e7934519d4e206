//! The scene of the chapter "Methods": a book is thrown once, and four programs follow it.

use live::prelude::*;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::geometric::Splitting;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::rk4_step;
use nalgebra::{UnitQuaternion, Vector3};

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "methods",
    title: "One book, by four methods",
    description: "Four spheres with axis 1 of a book, and on each the way of the angular momentum by another method: the closed form and turns go round the axis on a small \
                  circle, and so does RK4; by Euler’s method the way spirals outwards. Below, the wobble against the time: three waves stay as they are, the fourth grows.",
    question: "Four programs follow the same book. Which of them goes wrong, and in which way, if their steps become longer?",
    size: [[640.0, 400.0], [380.0, 550.0]],
    view: None,
    still: 90.0,
    controls: &[Control::log_slider("step", "length of a step", [0.05, 3.0], "s", 0.1)],
    presets: &[
        preset("steps of a tenth of a second", &[]),
        preset("half as long", &[("step", 0.05)]),
        preset("steps of two seconds", &[("step", 2.0)]),
    ],
    readings: &[
        reading("energy (1 at first), exact", Form::Fixed(4), ""),
        reading("by Euler’s method", Form::Fixed(4), ""),
        reading("by RK4", Form::Fixed(4), ""),
        reading("by Strang’s splitting", Form::Fixed(4), ""),
    ],
    symbols: formulas![r"\hat{\mathbf{1}}"],
    start,
};

/// How long the book is followed, s.
const LASTS: f64 = 240.0;

/// What a method makes of an angular velocity on board in a step.
type Step = fn(&PrincipalMoments, Vector3<f64>, f64) -> Result<Vector3<f64>, Cause>;
const METHODS: [(Look, Step); 3] = [
    (Look::EULER, |book, omega, h| Ok(omega + euler::rates(book, &omega, &Vector3::zeros()) * h)),
    (Look::RK4, |book, omega, h| {
        let mut free = |_, omega: &[f64; 3]| euler::rates(book, &(*omega).into(), &Vector3::zeros()).into();
        Ok(rk4_step(&mut free, 0.0, &omega.into(), h).into())
    }),
    (Look::STRANG, |book, omega, h| Ok(Splitting::Strang.solve(book, thrown(omega), h, 1)?.omega_body)),
];

fn thrown(omega_body: Vector3<f64>) -> Turning {
    Turning { world_from_body: UnitQuaternion::identity(), omega_body }
}

/// The direction of the angular momentum on board, and its angle from axis 1, degrees.
fn aim(book: &PrincipalMoments, omega: &Vector3<f64>) -> (Vector3<f64>, f64) {
    let aim = book.angular_momentum(omega).normalize();
    (aim, aim.yz().norm().atan2(aim.x).to_degrees())
}

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let (book, throw) = (PrincipalMoments::new(1.0, 1.6, 2.1)?, Vector3::new(1.0, 0.12, 0.0));
    let step = settings.of("step")?;
    let times: Vec<f64> = (0..=(LASTS / step) as u32).map(|n| step * f64::from(n)).collect();
    let exact = FreeTop::new(book, thrown(throw))?.sample(&times)?;
    let mut runs: Vec<_> = vec![(Look::EXACT, exact.iter().map(|state| state.omega_body).collect())];
    for (look, next) in METHODS {
        let mut path = vec![throw];
        while path.len() < times.len() && path[path.len() - 1].norm() < 3.0 {
            path.push(next(&book, path[path.len() - 1], step)?);
        }
        runs.push((look, path));
    }
    let first = book.kinetic_energy(&throw);
    let tripled = runs[1].1.iter().position(|omega| book.kinetic_energy(omega) > 3.0 * first);
    let after = tripled.map_or("does not triple".into(), |n| format!("has tripled after {:.0} s", times[n]));
    let [truth, rk4, turns] = [0, 2, 3].map(|run: usize| {
        let last = runs[run].1.iter().skip(times.partition_point(|time| *time < LASTS - 30.0));
        last.map(|omega| aim(&book, omega).1).fold(0.0, f64::max)
    });
    Ok(Box::new(Small {
        of: (book, step, runs),
        run: Run { duration: LASTS, pace: 8.0, repeats: false },
        words: format!(
            "By Euler’s method the energy {after}. In the last half minute the axis swings out to {truth:.1}° in truth, \
             to {rk4:.1}° by RK4 and to {turns:.1}° by Strang’s splitting."
        ),
        readings: |(book, step, runs), time| {
            let energy =
                |omega: &Vector3<f64>| book.kinetic_energy(omega) / book.kinetic_energy(&runs[0].1[0]);
            let now = runs.iter().map(|(_, path)| path.get((time / step) as usize));
            Ok(now.map(|omega| omega.map_or(f64::NAN, energy)).collect())
        },
        draw: |(book, step, runs), moment, drawing| {
            for (place, (look, path)) in runs.iter().enumerate() {
                let (column, row) = moment.room.of((place, 0), (place % 2, place / 2));
                let (left, apart) = moment.room.of((84.0, 158.0), (95.0, 190.0));
                let centre = at(left + apart * column as f64, 84.0 + 180.0 * row as f64);
                let eye = moment.seen_from(0.5, 0.3);
                let mut stage = Stage::new(eye.camera([0.0; 3], 9.0, centre, 58.0)?);
                stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
                stage.named_vector([1.0, 0.0, 0.0], [1.6, 0.0, 0.0], r"$\hat{\mathbf{1}}$", Hue::Ink)?;
                let reached = ((moment.time / step) as usize + 1).min(path.len());
                let trail = &path[reached.saturating_sub((30.0 / step) as usize)..reached];
                if trail.len() > 1 {
                    let trail = trail.iter().step_by(1 + trail.len() / 150).map(|omega| aim(book, omega).0);
                    stage.curve(Curve::smooth(trail)?, look.stroke, look.hue)?;
                }
                stage.dot_in_front(aim(book, &path[reached - 1]).0, 4.0, look.hue)?;
                stage.write(drawing);
                drawing.label(centre + at(0.0, 76.0), Side::Over, look.name, look.hue)?;
                let sample = centre + at(-16.0, 90.0); // how its curve is drawn below
                drawing.line(sample, sample + at(32.0, 0.0), look.stroke, look.hue);
            }
            let frames = [[44.0, 232.0, 580.0, 120.0], [44.0, 394.0, 320.0, 110.0]];
            let time = Axis::linear(0.0, LASTS, 60.0).titled("time, s");
            let angle = Axis::linear(0.0, 90.0, 30.0).titled("wobble, degrees");
            let mut graph = moment.graph(drawing, frames, time, angle)?;
            for (look, path) in runs {
                let thinned = path.iter().enumerate().step_by(1 + path.len() / 400);
                let wobble = thinned.map(|(n, omega)| (step * n as f64, aim(book, omega).1));
                graph.curve(wobble, look.stroke, look.hue);
            }
            graph.upright(moment.time, Stroke::Outline, Hue::Muted);
            Ok(())
        },
    }))
}

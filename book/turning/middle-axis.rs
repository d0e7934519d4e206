//! The small scene of the page "The middle axis": a bat that waits, and turns over.

use live::prelude::*;
use mechanics::InvalidQuantity;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "middle-axis",
    title: "A bat waits, and turns over",
    description: "At the left a bat in the air with one side pink, an orange arrow for its angular velocity and a green one for its angular momentum. Beside it a sphere \
                  with the three axes of the bat; the tip of the angular momentum runs on it from beside axis 2 to beside its opposite end and back. Below, the angle \
                  between axis 2 and the momentum against the turns: it stays near zero for a turn, rises to 180 degrees, stays there for twice as long, and falls back.",
    question: "A bat is thrown to turn about its middle axis, and the throw misses the axis a little. How small must the miss be, if the bat is not to turn over within two \
               turns?",
    size: [[640.0, 420.0], [380.0, 590.0]],
    view: None,
    still: 0.74,
    controls: &[Control::log_slider("miss", r"the throw misses by $\epsilon$", [1e-4, 10.0], "°", 0.1)],
    presets: &[
        preset("a clumsy throw", &[("miss", 10.0)]),
        preset("a good one", &[("miss", 1.0)]),
        preset("ten times as careful", &[]),
        preset("and a hundred times more", &[("miss", 0.001)]),
    ],
    readings: &[
        reading("turns before it turns over", Form::Fixed(2), ""),
        reading(r"angle of axis 2 and $\boldsymbol{L}$", Form::Digits(3), "°"),
    ],
    symbols: formulas![r"\boldsymbol{L}", r"\hat{\mathbf{1}}", r"\hat{\mathbf{2}}", r"\hat{\mathbf{3}}"],
    start,
};

/// The bat of the page: about its handle, across it in the plane of the blade, and across the blade, kg·m².
pub(crate) const BAT: [f64; 3] = [1.83e-4, 7.89e-4, 9.72e-4];
/// How fast it is thrown, by its angular momentum: rad/s about axis 2.
const SPIN: f64 = 10.0;
/// Seconds of the bat in one of the reader.
const PACE: f64 = 0.2;
/// How often its path on board is computed.
const POINTS: u32 = 300;

/// The direction of the angular momentum on board.
fn momentum(top: &FreeTop, time: f64) -> Result<Vector3<f64>, InvalidQuantity> {
    Ok(top.moments().angular_momentum(&top.at(time)?.omega_body).normalize())
}

/// The angle between axis 2 and a direction on board, degrees.
fn from_axis_2(direction: &Vector3<f64>) -> f64 {
    direction.x.hypot(direction.z).atan2(direction.y).to_degrees()
}

/// A bat, the directions of its handle's end and of its pink side.
pub(crate) fn draw_bat(stage: &mut Stage, along: Vector3<f64>, pink: Vector3<f64>) -> Result<(), Flaw> {
    for (side, hue) in [(1.0, Hue::Pink), (-1.0, Hue::Blue)] {
        stage.solid(Solid::disc(along * 0.463 + pink * (0.04 * side), pink, 1.0, 0.08)?, hue)?;
    }
    stage.solid(Solid::rod(along * -0.5, along * -1.87, 0.13)?, Hue::Blue)
}

fn start(settings: &Settings<'_>) -> Result<Box<dyn Motion>, Cause> {
    let [i1, i2, i3] = BAT;
    let moments = PrincipalMoments::new(i1, i2, i3)?;
    let (sin, cos) = settings.of("miss")?.to_radians().sin_cos();
    let momentum_body = Vector3::new(sin, cos, 0.0); // off towards axis 1
    let start = Turning {
        world_from_body: UnitQuaternion::from_scaled_axis(Vector3::z() * sin.atan2(cos)), // L along y
        omega_body: moments.angular_velocity(&(i2 * SPIN * momentum_body)),
    };
    let top = FreeTop::new(moments, start)?;
    let period = top.period().ok_or("it never turns over")?;
    // From the throw until the bat is as it was.
    let path = linear_steps(0.0, period, POINTS).map(|time| momentum(&top, time));
    let path = path.collect::<Result<Vec<_>, _>>()?;
    let [turns, gain] = [SPIN * period, 10_f64.ln() / moments.growth_squared()[1].sqrt()].map(|x| x / TAU);
    Ok(Box::new(Small {
        of: (top, path, turns),
        run: Run { duration: period, pace: PACE, repeats: false },
        words: format!(
            "It turns over after {:.2} turns, and back after twice as many more. A throw that is ten times as \
             careful gains {gain:.2} turns.",
            0.25 * turns
        ),
        readings: |(top, _, turns), time| Ok(vec![0.25 * turns, from_axis_2(&momentum(top, time)?)]),
        draw: |(top, path, turns), moment, drawing| {
            let (room, now) = (moment.room, top.at(moment.time)?);
            let eye = moment.seen_from(2.02, 0.42);
            let centre = room.of(at(160.0, 150.0), at(190.0, 150.0));
            let mut stage = Stage::new(eye.camera([0.0; 3], 14.0, centre, 56.0)?);
            let [along, normal] = [Vector3::x(), Vector3::z()].map(|axis| now.world_from_body * axis);
            draw_bat(&mut stage, along, normal)?;
            stage.named_vector([0.0; 3], Vector3::y() * 2.9, r"$\boldsymbol{L}$", Hue::Green)?;
            let omega = now.omega_world() * (1.7 / SPIN);
            stage.vector([0.0; 3], omega, Hue::Orange)?;
            stage.write(drawing);

            // On board.
            let eye = moment.seen_from(0.75, 0.4);
            let centre = room.of(at(470.0, 150.0), at(190.0, 366.0));
            let mut stage = Stage::new(eye.camera([0.0; 3], 14.0, centre, room.of(100.0, 80.0))?);
            stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
            let axes = [r"$\hat{\mathbf{1}}$", r"$\hat{\mathbf{2}}$", r"$\hat{\mathbf{3}}$"];
            for (axis, name) in [Vector3::x(), Vector3::y(), Vector3::z()].into_iter().zip(axes) {
                stage.named_vector(axis, axis * 1.35, name, Hue::Ink)?;
            }
            let way = Curve::smooth(path.iter().copied())?.hiding(Hiding::Pale);
            stage.curve(way, Stroke::Curve, Hue::Green)?;
            stage.dot_in_front(momentum(top, moment.time)?, 5.0, Hue::Green)?;
            stage.write(drawing);

            let frames = [[48.0, 328.0, 560.0, 50.0], [48.0, 498.0, 310.0, 50.0]];
            let x = Axis::linear(0.0, *turns, if *turns > 6.0 { 2.0 } else { 1.0 }).titled("turns");
            let y = Axis::linear(0.0, 180.0, 90.0).titled(r"angle of axis 2 and $\boldsymbol{L}$, degrees");
            let mut graph = moment.graph(drawing, frames, x, y)?;
            let angles = linear_steps(0.0, *turns, POINTS).zip(path.iter().map(from_axis_2));
            graph.curve(angles, Stroke::Curve, Hue::Green);
            graph.dot((SPIN * moment.time / TAU, from_axis_2(&momentum(top, moment.time)?)), 5.0, Hue::Green);
            Ok(())
        },
    }))
}

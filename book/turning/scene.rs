//! The scene of the chapter "How a body turns": a plate is thrown.

use crate::{Cause, Control, Form, Moment, Motion, Preset, Reading, Run, Scene, Settings};
use drawing::space::{Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Side, Stroke, at};
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

pub(crate) const SCENE: Scene = Scene {
    name: "turning",
    title: "A wobbling plate",
    description: "A flat round plate in the air above a floor, leaning. The angular momentum L points straight up; the axis of the plate and \
                  its angular velocity lean away from it on opposite sides.",
    question: "Why does the plate wobble twice in a turn, and what happens as $I_3/I_1$ passes 1?",
    size: [[640.0, 400.0], [380.0, 380.0]],
    view: Some([-1.35, 0.36]),
    still: 0.0,
    controls: &[
        Control::slider("spin", r"spin about the axis, $\omega_3$", [-20.0, 20.0, 0.1], "rad/s", 10.0),
        Control::slider("across", r"spin about a diameter, $\omega_1$", [0.0, 20.0, 0.1], "rad/s", 6.0),
        Control::slider("ratio", r"$I_3/I_1$", [0.02, 2.0, 0.01], "", 2.0),
        Control::choice("camera", "camera", &["in the room", "on the body"]),
    ],
    presets: &[Preset { words: "a ball", settings: &[("ratio", 1.0)] }],
    readings: &[
        Reading { words: "wobbles", form: Form::Fixed(2), unit: "" },
        Reading { words: r"drift of the energy $T$", form: Form::Power(1), unit: "" },
    ],
    start: |settings| Ok(Box::new(Plate::new(settings)?)),
};

/// A body with an axis of symmetry, and its turning.
struct Plate {
    top: FreeSymmetricTop,
    on_board: bool,
}

impl Plate {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let moments = PrincipalMoments::symmetric(1.0, settings.of("ratio")?)?;
        let omega_body = Vector3::new(settings.of("across")?, 0.0, settings.of("spin")?);
        let momentum = moments.angular_momentum(&omega_body);
        let world_from_body = UnitQuaternion::rotation_between(&momentum, &Vector3::z()).unwrap_or_default();
        let top = FreeSymmetricTop::new(moments, Turning { world_from_body, omega_body })?;
        Ok(Self { top, on_board: settings.choice("camera")? == 1 })
    }
}

impl Motion for Plate {
    fn run(&self) -> Run {
        Run { duration: 10.0, pace: 0.1, repeats: true }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let now = self.top.at(moment.time)?;
        let seen_from =
            if self.on_board { now.world_from_body.inverse() } else { UnitQuaternion::identity() };
        let axis = seen_from * now.axis_3_world();
        let camera = moment.camera(View {
            target: [0.0, 0.0, 0.35],
            azimuth: 0.0,
            elevation: 0.0,
            distance: 8.0,
            centre: at(moment.room.of(320.0, 190.0), 225.0),
            scale: moment.room.of(118.0, 90.0),
        })?;
        let mut stage = Stage::new(camera);
        stage.solid(Solid::disc([0.0; 3], axis, 1.0, 0.05)?, Hue::Blue)?;
        let circle =
            Curve::circle([0.0, 0.0, 1.5 * axis.z], Vector3::z(), (1.5 * axis.x.hypot(axis.y)).max(1e-3))?;
        stage.curve(circle.hiding(Hiding::Omitted), Stroke::Outline, Hue::Muted)?;
        stage.named_vector(
            [0.0; 3],
            seen_from * Vector3::new(0.0, 0.0, 1.85),
            r"$\boldsymbol{L}$",
            Hue::Green,
        )?;
        stage.vector([0.0; 3], axis * 1.5, Hue::Ink)?;
        stage.label(axis * 1.5, Side::Right, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        stage.write(drawing);
        Ok(())
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let now = self.top.at(time)?;
        let energy = |turning: &Turning| self.top.moments().kinetic_energy(&turning.omega_body);
        let start = energy(&self.top.start());
        Ok(vec![self.top.precession_rate() * time / TAU, energy(&now) / start - 1.0])
    }

    fn words(&self, _time: f64) -> String {
        "The axis goes round the momentum.".into()
    }
}

//! The scene of the chapter "The ball": a cloth, a turning table, a hole.

use live::prelude::*;
use mechanics::InvalidQuantity;
use mechanics::scenes::ball::{
    Ball, BallParameters, BallState, Cloth, ClothParameters, Hole, HoleParameters, HoleRoll, HoleStart, Shot,
    ShotStart, Turntable, TurntableParameters, TurntableRoll, TurntableStart,
};
use nalgebra::Vector3;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "ball",
    title: "A ball slides and rolls",
    description: "A ball on a cloth, with its path, an arrow of its velocity and one of its slip. Below, two speeds against time, that of the centre and that at which its \
                  spin would roll: two straight lines that meet, and are one from there on.",
    question: "The ball is hit in the middle. How much of its speed is left when it rolls? Does that depend on the cloth? Can you make it come back?",
    size: [[640.0, 440.0], [380.0, 600.0]],
    view: Some([-1.1, 0.62]),
    still: 0.3,
    controls: &[
        Control::choice("place", "where", &["on a cloth", "on a turning table", "in a hole"]),
        Control::choice("kind", "the ball", &["solid", "hollow"]),
        Control::slider("speed", r"speed, $v$", [0.2, 4.0, 0.1], "m/s", 3.0),
        Control::slider("roll", r"cloth: its spin would roll at, along $v$", [-10.0, 10.0, 0.1], "m/s", 0.0)
            .when("place", [0.0, 0.0]),
        Control::slider("side", "cloth: and to the left at", [-6.0, 6.0, 0.1], "m/s", 0.0)
            .when("place", [0.0, 0.0]),
        Control::slider("friction", r"cloth: friction, $\mu$", [0.05, 0.5, 0.01], "", 0.2)
            .when("place", [0.0, 0.0]),
        Control::slider("rate", r"table: it turns at, $\Omega$", [0.0, 12.0, 0.1], "rad/s", 6.0)
            .when("place", [1.0, 1.0]),
        Control::slider("slope", r"table: slope, $\varepsilon$", [0.0, 5.0, 0.1], "°", 0.0)
            .when("place", [1.0, 1.0]),
        Control::slider("drop", "hole: sinks at first at", [0.0, 1.0, 0.05], "m/s", 0.0)
            .when("place", [2.0, 2.0]),
    ],
    presets: &[
        preset("hit in the middle", &[("place", 0.0), ("roll", 0.0), ("side", 0.0)]),
        preset("it comes back", &[("place", 0.0), ("speed", 2.0), ("roll", -9.0)]),
        preset("a massé", &[("place", 0.0), ("speed", 3.0), ("roll", -4.0), ("side", 3.0)]),
        preset("on a table", &[("place", 1.0), ("speed", 0.5), ("slope", 0.0)]),
        preset("on a tilted table", &[("place", 1.0), ("speed", 0.2), ("slope", 2.0)]),
        preset("in and out of a hole", &[("place", 2.0), ("speed", 1.0), ("drop", 0.3)]),
    ],
    readings: &[
        reading(r"speed of the centre, $v$", Form::Fixed(3), "m/s"),
        reading(r"its spin would roll at, $w$", Form::Fixed(3), "m/s"),
        reading(r"slip, $u$", Form::Fixed(3), "m/s"),
        reading("spin about the normal", Form::Fixed(1), "rad/s"),
        reading("drift of what is conserved", Form::Power(1), ""),
    ],
    symbols: formulas![r"\boldsymbol{v}", r"\boldsymbol{u}", r"\boldsymbol{\omega}", "v", "w"],
    start: |settings| Ok(Box::new(Rolls::new(settings)?)),
};

const GRAVITY: f64 = 9.81;
/// A corner of the cloth and of the table, as they are drawn.
const CORNER: [f64; 2] = [1.4, 1.0];
/// Radius of the ball, m: for billiards and for the table, and in the hole.
const BILLIARD: f64 = 0.028_6;
const GOLF: f64 = 0.021_35;
/// The hole of a golf course: radius and depth, m.
const HOLE: [f64; 2] = [0.054, 0.101_6];
/// Where the ball is put on the table, m from its axis.
const PUT: [f64; 2] = [0.3, 0.0];
/// The radius of the ball in the picture of cloth and table, where it is drawn larger than it is.
const DRAWN: f64 = 0.16;
/// Steps of a path.
const STEPS: u32 = 300;

enum Place {
    Cloth(Shot),
    Table(TurntableRoll, f64),
    Hole(HoleRoll, f64),
}

struct Rolls {
    ball: Ball,
    place: Place,
    slope: f64,
    duration: f64,
    path: Vec<(f64, BallState)>,
    /// Units of the picture to a metre, and what of the room stands in its middle, m.
    scale: f64,
    middle: Vector3<f64>,
}

impl Place {
    fn at(&self, time: f64) -> Result<BallState, InvalidQuantity> {
        match self {
            Self::Cloth(shot) => shot.at(time),
            Self::Table(roll, _) => roll.at(time),
            Self::Hole(roll, _) => roll.at(time),
        }
    }
}

impl Rolls {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let which = settings.choice("place")?;
        let moment_factor = [Ball::SOLID, Ball::SHELL][settings.choice("kind")?.min(1)];
        let radius = if which == 2 { GOLF } else { BILLIARD };
        let ball = Ball::new(BallParameters { radius, moment_factor })?;
        let speed = settings.of("speed")?;
        let slope = if which == 1 { settings.of("slope")?.to_radians() } else { 0.0 };
        let (place, duration) = match which {
            0 => {
                let friction = settings.of("friction")?;
                let cloth = Cloth::new(ClothParameters { ball, friction, gravity: GRAVITY })?;
                let omega = [-settings.of("side")? / radius, settings.of("roll")? / radius, 0.0];
                let shot = cloth.shot(ShotStart { velocity: [speed, 0.0], omega })?;
                let duration = (1.5 * shot.sliding_time()).max(0.8);
                (Place::Cloth(shot), duration)
            }
            1 => {
                let rate = settings.of("rate")?;
                let table = Turntable::new(TurntableParameters { ball, rate, slope, gravity: GRAVITY })?;
                let roll = table.roll(TurntableStart { place: PUT, velocity: [0.0, speed], pivot: 0.0 })?;
                let duration = roll.period().map_or(3.0, |period| (2.0 * period).min(12.0));
                (Place::Table(roll, rate), duration)
            }
            _ => {
                let hole = Hole::new(HoleParameters { ball, radius: HOLE[0], gravity: GRAVITY })?;
                let rate = speed / hole.gap();
                let roll = hole.roll(HoleStart { rate, rise: -settings.of("drop")?, pivot: 0.0 })?;
                let out = settings.of("drop")? > 0.0;
                let back = roll.first_return().unwrap_or_default();
                let end = if out { back } else { 2.0 * back };
                (Place::Hole(roll, rate), floor(&roll)?.map_or(end, |floor| floor.min(end)))
            }
        };
        let path = linear_steps(0.0, duration, STEPS).map(|time| Ok((time, place.at(time)?)));
        let path = path.collect::<Result<Vec<_>, InvalidQuantity>>()?;
        let (scale, middle) = if which == 2 {
            (1.0 / HOLE[0], Vector3::z() * (-0.5 * HOLE[1]))
        } else {
            let (mut low, mut high) = (Vector3::zeros(), Vector3::zeros());
            for (_, state) in &path {
                (low, high) = (low.inf(&state.centre), high.sup(&state.centre));
            }
            (1.9 / (high - low).norm().max(0.3), 0.5 * (low + high))
        };
        Ok(Self { ball, place, slope, duration, path, scale, middle })
    }

    /// A place of the room in the picture.
    fn shown(&self, place: Vector3<f64>) -> Vector3<f64> {
        (place - self.middle) * self.scale
    }

    fn is_hole(&self) -> bool {
        matches!(self.place, Place::Hole(..))
    }

    /// The direction from the centre to the contact, and the velocity at which the spin would roll.
    fn contact(&self, state: &BallState) -> (Vector3<f64>, Vector3<f64>) {
        let outward = if self.is_hole() {
            Vector3::new(state.centre.x, state.centre.y, 0.0).normalize()
        } else {
            -Vector3::z()
        };
        (outward, -state.omega.cross(&outward) * self.ball.radius())
    }

    /// The slip: the velocity of the point that touches, relative to what it touches.
    fn slip(&self, state: &BallState, time: f64) -> Result<Vector3<f64>, InvalidQuantity> {
        match &self.place {
            Place::Cloth(shot) => shot.slip(time),
            Place::Table(_, rate) => {
                let (down, _) = self.contact(state);
                Ok(self.ball.point_velocity(state, &down) - Vector3::z().cross(&state.centre) * *rate)
            }
            Place::Hole(..) => Ok(self.ball.point_velocity(state, &self.contact(state).0)),
        }
    }

    /// What friction cannot change: the momentum of both carts, on a slope less what the weight has given, or the energy.
    fn kept(&self, state: &BallState, time: f64) -> Vector3<f64> {
        let k = self.ball.moment_factor();
        match &self.place {
            Place::Hole(roll, _) => Vector3::x() * roll.energy(state),
            _ => {
                let given = Vector3::x() * (GRAVITY * self.slope.sin() * time);
                state.velocity + self.contact(state).1 * k - given
            }
        }
    }

    fn draw_room(&self, moment: &Moment, stage: &mut Stage) -> Result<(), Cause> {
        let wall = |stage: &mut Stage, from: Vector3<f64>, to: Vector3<f64>, stroke| -> Result<(), Cause> {
            let curve = Curve::segment(self.shown(from), self.shown(to))?;
            Ok(stage.curve(curve.hiding(Hiding::Ignored), stroke, Hue::Muted)?)
        };
        match &self.place {
            Place::Cloth(_) => stage.ground(CORNER.map(|x: f64| -x), CORNER, 0.0, 0.4)?,
            Place::Table(_, rate) => {
                stage.ground(CORNER.map(|x| -x), CORNER, 0.0, 0.4)?;
                // Marks on the table, which go round with it.
                for n in 0..6 {
                    let (sin, cos) = (rate * moment.time + TAU * f64::from(n) / 6.0).sin_cos();
                    let end = Vector3::new(cos, sin, 0.0) * (0.5 / self.scale);
                    wall(stage, Vector3::zeros(), end, Stroke::Dotted)?;
                }
                let axis = self.shown(Vector3::zeros());
                stage.turning(axis, [0.0, 0.0, 1.0], 0.55, Hue::Orange)?;
            }
            Place::Hole(..) => {
                // The rim is as high as the centre is at first.
                for height in [0.0, -HOLE[1]] {
                    let centre = self.shown(Vector3::z() * height);
                    let ring = Curve::circle(centre, [0.0, 0.0, 1.0], 1.0)?;
                    stage.curve(ring.hiding(Hiding::Ignored), Stroke::Outline, Hue::Muted)?;
                }
                for n in 0..8 {
                    let (sin, cos) = (TAU * f64::from(n) / 8.0).sin_cos();
                    let foot = Vector3::new(cos, sin, 0.0) * HOLE[0];
                    wall(stage, foot, foot - Vector3::z() * HOLE[1], Stroke::Dotted)?;
                }
            }
        }
        Ok(())
    }

    fn draw_ball(&self, moment: &Moment, stage: &mut Stage) -> Result<(), Cause> {
        let state = self.place.at(moment.time)?;
        let radius = if self.is_hole() { GOLF * self.scale } else { DRAWN };
        let up = if self.is_hole() { Vector3::zeros() } else { Vector3::z() * radius };
        let track = self.path.iter().map(|(_, state)| self.shown(state.centre));
        let track = Curve::smooth(track)?.hiding(Hiding::Ignored);
        stage.curve(track, Stroke::Outline, Hue::Ink)?;
        let centre = self.shown(state.centre) + up;
        stage.solid(Solid::sphere(centre, radius)?, Hue::Blue)?;
        let (down, _) = self.contact(&state);
        let touch = centre + down * radius;
        let slip = self.slip(&state, moment.time)?;
        let fastest = self.path[0].1.velocity.norm().max(0.2);
        let length = 0.6 / fastest.max(self.slip(&self.path[0].1, 0.0)?.norm());
        let mut arrow = |from: Vector3<f64>, along: Vector3<f64>, label: (Side, &str), hue: Hue| {
            // What would leave the picture is drawn shorter.
            let along = along * (0.6 / along.norm().max(0.6));
            if along.norm() > 0.03 {
                let curve = Curve::segment(from, from + along)?.hiding(Hiding::Ignored);
                stage.arrow(curve, Stroke::Vector, Heads::End, hue)?;
                stage.label(from + along, label.0, label.1, hue)?;
            }
            Ok::<_, Cause>(())
        };
        arrow(centre, state.velocity * length, (Side::Above, r"$\boldsymbol{v}$"), Hue::Ink)?;
        let spin = state.omega * (self.ball.radius() * length);
        arrow(centre, spin, (Side::Above, r"$\boldsymbol{\omega}$"), Hue::Orange)?;
        arrow(touch, slip * length, (Side::Below, r"$\boldsymbol{u}$"), Hue::Pink)?;
        stage.dot_in_front(touch, 3.5, Hue::Pink)?;
        Ok(())
    }

    /// What the graph shows of a state, with names: the speeds along the first slip, the places, or the height.
    fn curves(&self, state: &BallState) -> Vec<(f64, &'static str, Hue)> {
        match &self.place {
            Place::Cloth(shot) => {
                let along = shot.first_slip();
                let along = if along.norm() > 0.0 { along.normalize() } else { Vector3::x() };
                let (_, rolls) = self.contact(state);
                vec![(state.velocity.dot(&along), "$v$", Hue::Ink), (rolls.dot(&along), "$w$", Hue::Orange)]
            }
            Place::Table(..) => {
                vec![(state.centre.x, "down", Hue::Ink), (state.centre.y, "across", Hue::Muted)]
            }
            Place::Hole(..) => vec![(100.0 * state.centre.z, "", Hue::Ink)],
        }
    }

    fn draw_graph(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let all: Vec<_> = self.path.iter().map(|(time, state)| (*time, self.curves(state))).collect();
        let values = all.iter().flat_map(|(_, curves)| curves.iter().map(|curve| curve.0));
        let (low, high) = values.fold((0.0_f64, 0.0_f64), |(low, high), v| (low.min(v), high.max(v)));
        let step = nice_step((high - low) / 3.0);
        let (low, high) = ((low / step).floor() * step, (high / step).ceil().max(1.0) * step);
        let title = match &self.place {
            Place::Cloth(_) => "speeds along the slip, m/s",
            Place::Table(..) => "place of the centre, m",
            Place::Hole(..) => "height of the centre, cm",
        };
        let time = Axis::linear(0.0, self.duration, nice_step(self.duration / 3.0)).titled("time, s");
        let frames = [[440.0, 120.0, 180.0, 190.0], [60.0, 400.0, 300.0, 140.0]];
        let mut graph = moment.graph(drawing, frames, time, Axis::linear(low, high, step).titled(title))?;
        let now = self.place.at(moment.time)?;
        for (index, (value, name, hue)) in self.curves(&now).into_iter().enumerate() {
            let curve = all.iter().map(|(time, curves)| (*time, curves[index].0));
            graph.curve(curve.take_while(|(time, _)| *time <= moment.time), Stroke::Curve, hue);
            graph.dot((moment.time, value), 4.0, hue);
            let place = if matches!(self.place, Place::Cloth(_)) { all.len() / 6 } else { 0 };
            let sides = [Side::AboveRight, Side::BelowRight];
            if let Some((time, first)) = all.get(place)
                && !name.is_empty()
            {
                graph.label((*time, first[index].0), sides[index], name, hue)?;
            }
        }
        graph.upright(moment.time, Stroke::Outline, Hue::Muted);
        graph.answer(|graph| {
            for (index, (_, _, hue)) in self.curves(&now).into_iter().enumerate() {
                graph.curve(all.iter().map(|(time, curves)| (*time, curves[index].0)), Stroke::Outline, hue);
            }
            if let Place::Cloth(shot) = &self.place {
                graph.upright(shot.sliding_time(), Stroke::Reference, Hue::Pink);
            }
            Ok(())
        })?;
        Ok(())
    }
}

/// When the ball touches the floor of the hole, if it ever does.
fn floor(roll: &HoleRoll) -> Result<Option<f64>, InvalidQuantity> {
    let depth = GOLF - HOLE[1];
    if roll.lowest() > depth {
        return Ok(None);
    }
    // It sinks from the start to the lowest point, which it reaches within a half of the swing.
    let (mut above, mut below) = (0.0, 0.5 * roll.swing_period());
    let rise = roll.at(0.0)?.velocity.z;
    if rise < 0.0 {
        below = 0.5 * roll.first_return().unwrap_or(below);
    }
    for _ in 0..60 {
        let middle = 0.5 * (above + below);
        if roll.at(middle)?.centre.z > depth { above = middle } else { below = middle }
    }
    Ok(Some(above))
}

impl Motion for Rolls {
    fn run(&self) -> Run {
        Run { duration: self.duration, pace: (self.duration / 6.0).clamp(0.05, 1.0), repeats: true }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let (centre, scale) = moment.room.of((at(200.0, 215.0), 112.0), (at(190.0, 175.0), 100.0));
        let mut stage = Stage::new(moment.camera([0.0; 3], 9.0, centre, scale)?);
        self.draw_room(moment, &mut stage)?;
        self.draw_ball(moment, &mut stage)?;
        stage.write(drawing);
        self.draw_graph(moment, drawing)
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let state = self.place.at(time)?;
        let (outward, rolls) = self.contact(&state);
        let start = self.kept(&self.path[0].1, 0.0);
        let kept = self.kept(&state, time);
        let size = start.norm().max(0.1);
        Ok(vec![
            state.velocity.norm(),
            rolls.norm(),
            self.slip(&state, time)?.norm(),
            state.omega.dot(&outward),
            (kept - start).norm() / size,
        ])
    }

    fn words(&self, _time: f64) -> String {
        match &self.place {
            Place::Cloth(shot) => {
                let (end, speed) = (shot.sliding_time(), shot.rolling_velocity());
                let first = self.path[0].1.velocity.norm();
                if end < 1e-9 {
                    return "The spin and the speed agree: the ball rolls at once, and nothing slows it down.".into();
                }
                let what = if speed.norm() < 1e-9 {
                    "stops dead".into()
                } else if speed.x < -1e-9 {
                    format!("comes back at {:.2} m/s", speed.norm())
                } else {
                    format!(
                        "rolls at {:.2} m/s, {:.3} of its speed at first",
                        speed.norm(),
                        speed.norm() / first
                    )
                };
                format!(
                    "The ball slides for {end:.2} s, then it {what}. Sliding costs {:.2} J a kilogram.",
                    shot.energy_lost()
                )
            }
            Place::Table(roll, rate) => match roll.circle() {
                None => "The table is at rest: the ball rolls straight on, or down the slope.".into(),
                Some(circle) => {
                    let turns = rate.abs() * roll.period().unwrap_or_default() / TAU;
                    let drift = circle.drift.norm();
                    let round = format!(
                        "The ball goes round a circle of {:.2} m in {turns:.2} turns of the table.",
                        circle.radius
                    );
                    if drift > 0.0 {
                        format!("{round} The circle drifts at {drift:.3} m/s across the slope, and not down.")
                    } else {
                        round
                    }
                }
            },
            Place::Hole(roll, rate) => {
                let rounds = rate.abs() * roll.swing_period() / TAU;
                let depth = -100.0 * roll.lowest();
                let grip = roll.grip_needed();
                let ends = if -roll.lowest() + GOLF > HOLE[1] {
                    "A golf hole is not as deep: the ball lies on its floor."
                } else if self.path[0].1.velocity.z < 0.0 {
                    "At the rim it rises as fast as it sank, and is out."
                } else {
                    "It comes up to the rim, and not higher."
                };
                format!(
                    "The ball sinks by {depth:.1} cm, and each swing takes {rounds:.2} rounds. {ends} It needs a friction of {grip:.2}."
                )
            }
        }
    }
}

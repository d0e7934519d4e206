//! The scene of the chapter "The struck space station": a blow, what three observers count, and later blows.

use live::prelude::*;
use mechanics::euler::Turning;
use mechanics::inertia::Body;
use mechanics::scenes::space_station::{Blow, LaterBlow};
use nalgebra::{UnitQuaternion, Vector3};
use sky::{directions, draw_sky};
use std::sync::LazyLock;
use struck::{Blows, MASS, RADIUS, SPIN, STILL, Struck};
use wheel::{HUB, Wheel};

#[path = "scene/sky.rs"]
mod sky;
#[path = "scene/struck.rs"]
mod struck;
#[path = "scene/wheel.rs"]
mod wheel;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "space-station",
    title: "A station nods after a blow",
    description: "A wheel with hub and spokes, a moment after a blow on its rim. Its axis 3 goes round the angular momentum L on a circle; the angular velocity omega goes \
                  round on the other side. Beside it the crew’s sky: star trails curl round omega, away from the cross where axis 3 points; a ring marks the star that stood \
                  there. Below, two waves against time: how far the axis and omega are to one side, through four turns.",
    question: "The blow tips the station, and the circled star leaves the cross. After how many seconds is it back? And when must a thruster fire to keep it there?",
    size: [[640.0, 440.0], [380.0, 600.0]],
    view: Some([0.75, 0.40]),
    still: 1.7,
    controls: &[
        Control::slider("impulse", r"impulse of the blow, $P$", [0.0, 10.0, 0.1], "MN·s", 1.8),
        Control::slider("place", "its distance from the axis", [0.0, 50.0, 1.0], "m", 50.0),
        Control::choice("camera", "seen", &["in the room", "on board"]),
        Control::adding("fire", "Fire the thruster now", &["thruster", "thrust"]),
        Control::slider("thruster", "thruster, round the rim from the blow", [0.0, 360.0, 0.5], "°", 0.0),
        Control::slider("thrust", "its impulse", [-10.0, 10.0, 0.1], "MN·s", -1.8),
    ],
    presets: &[
        preset("twice as hard", &[("impulse", 3.6)]),
        preset("a push on the hub", &[("place", 0.0)]),
        preset("fire where it struck, after 13.96 s", &[("fire", 13.963)]),
        preset("fire after one nod, 176.5° round the rim", &[("fire", 6.846), ("thruster", 176.5)]),
    ],
    readings: &[
        reading("nods, counted in the room", Form::Fixed(2), ""),
        reading("turns of the mark in the room", Form::Fixed(2), ""),
        reading(r"turns of $\boldsymbol\omega$, counted on board", Form::Fixed(2), ""),
        reading("drift of the centre", Form::Fixed(2), "m/s"),
        reading(r"change of $L$ since the last blow", Form::Power(1), ""),
        reading(r"change of $T$ since the last blow", Form::Power(1), ""),
    ],
    symbols: formulas![r"\hat{\mathbf{3}}", r"\boldsymbol{L}", r"\boldsymbol{\omega}", r"\boldsymbol{P}"],
    start: |settings| Ok(Box::new(Nodding::new(settings)?)),
};

/// A million newton seconds, the unit of the sliders.
const MEGA: f64 = 1e6;
/// Four turns of the old spin, s.
const DURATION: f64 = 4.0 * TAU / SPIN;
/// How long a blow stays in the picture, s, and the length of its arrow, radii a MN·s.
const SHOWN: f64 = 1.2;
const ARROW: f64 = 0.14;
/// The cosine of the angle from the line of sight within which stars can be in the picture, as seen from the hub.
const AHEAD: f64 = 0.9;
/// Steps of the waves.
const STEPS: u32 = 240;

static BACKGROUND: LazyLock<Vec<Vector3<f64>>> = LazyLock::new(|| directions(2400));

struct Nodding {
    blows: Blows,
    station: Struck,
    on_board: bool,
    /// How far axis 3 is to one side in the room and the angular velocity on board, against time; at most 1.
    waves: [Vec<(f64, f64)>; 2],
    scales: [f64; 2],
}

/// What a hand can take hold of.
#[derive(Clone, Copy, PartialEq)]
enum Grip {
    Impulse,
    Place,
    Thruster,
    Fire,
}

/// What the eye looks at, and from how far.
const TARGET: Vector3<f64> = Vector3::new(0.0, 0.0, 0.45);
const DISTANCE: f64 = 9.0;

fn camera(moment: &Moment) -> Result<Camera, Flaw> {
    let (centre, scale) = moment.room.of((at(190.0, 220.0), 114.0), (at(190.0, 160.0), 94.0));
    moment.camera(TARGET, DISTANCE, centre, scale)
}

/// Two waves one above the other, and their middles.
fn waves(room: Room) -> Plot<'static> {
    let frame = room.of(Rect::new(396.0, 262.0, 232.0, 130.0), Rect::new(188.0, 372.0, 182.0, 180.0));
    let x = Axis::linear(0.0, DURATION, room.of(10.0, 20.0)).titled("time, s");
    Plot { frame, x, y: Axis::linear(1.0, 7.4, 10.0) }
}

const MIDDLES: [f64; 2] = [5.2, 2.1];

impl Nodding {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let later = |[time, azimuth, thrust]: Press| LaterBlow {
            time: time.min(DURATION),
            azimuth: azimuth.to_radians(),
            blow: Blow { radius: RADIUS, impulse: thrust * MEGA },
        };
        let mut between: Vec<LaterBlow> = settings.presses("fire")?.into_iter().map(later).collect();
        let last = between.pop();
        let next = later([0.0, settings.of("thruster")?, settings.of("thrust")?]);
        let blows = Blows {
            first: Blow { radius: settings.of("place")?, impulse: settings.of("impulse")? * MEGA },
            between,
            second: last.unwrap_or(next),
            is_fired: last.is_some(),
        };
        let station = Struck::new(&blows)?;
        let on_board = settings.choice("camera")? == 1;
        let (mut waves, mut scales) = ([Vec::new(), Vec::new()], [1.0; 2]);
        for time in linear_steps(0.0, DURATION, STEPS) {
            for (wave, aside) in waves.iter_mut().zip(station.aside(time)?) {
                wave.push((time, aside));
            }
        }
        for (wave, scale) in waves.iter_mut().zip(&mut scales) {
            let largest = wave.iter().map(|(_, aside)| aside.abs()).fold(0.0, f64::max);
            *scale = 1.0 / largest.max(STILL);
            wave.iter_mut().for_each(|(_, aside)| *aside *= *scale);
        }
        Ok(Self { blows, station, on_board, waves, scales })
    }

    /// What the camera of the picture turns with.
    fn seen(&self, now: &Turning) -> UnitQuaternion<f64> {
        if self.on_board { now.world_from_body.inverse() } else { UnitQuaternion::identity() }
    }

    /// Foot and tip of the arrow of the first blow, which stays where the blow was.
    fn impulse_arrow(&self) -> [Vector3<f64>; 2] {
        let Blow { radius, impulse } = self.blows.first;
        let foot = Vector3::new(0.0, radius / RADIUS * 0.93, 0.08);
        [foot, foot + Vector3::z() * (0.1 + ARROW * impulse / MEGA)]
    }

    /// Where the thruster is on the rim, along the body's axes.
    fn thruster(azimuth: f64) -> Vector3<f64> {
        Vector3::new(-azimuth.sin() * 0.93, azimuth.cos() * 0.93, 0.08)
    }

    fn draw_station(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let (camera, now) = (camera(moment)?, self.station.at(moment.time)?);
        let panel = moment.room.of(Rect::new(0.0, 0.0, 376.0, 440.0), Rect::new(0.0, 0.0, 380.0, 330.0));
        let seen = self.seen(&now);
        let attitude = seen * now.world_from_body;
        let sight = (TARGET + Vector3::from(moment.towards_eye()) * DISTANCE).normalize();
        // Most stars are behind the reader.
        let ahead = seen.inverse() * -sight;
        for star in BACKGROUND.iter().filter(|star| star.dot(&ahead) > AHEAD) {
            if let Ok(place) = camera.on_page(seen * star * 40.0)
                && panel.grown(-4.0).contains(place)
            {
                drawing.polyline(&[place, place], Stroke::Curve, Hue::Muted); // a dot: all of them are one element
            }
        }
        // What points out of the wheel lies above its plane: from above it is painted last, from below first.
        let wheel = Wheel { attitude, sight };
        let from_below = wheel.sight.dot(&(attitude * Vector3::z())) < 0.0;
        if !from_below {
            wheel.draw(&camera, drawing)?;
        }
        self.draw_marks(&camera, moment.time, &now, drawing)?;
        if from_below {
            wheel.draw(&camera, drawing)?;
        }
        Ok(())
    }

    /// The three directions and their circles, the marks on the rim, and the blows.
    fn draw_marks(
        &self,
        camera: &Camera,
        time: f64,
        now: &Turning,
        drawing: &mut Drawing,
    ) -> Result<(), Cause> {
        let seen = self.seen(now);
        let attitude = seen * now.world_from_body;
        let mut stage = Stage::new(*camera);
        let (axis, omega) = (attitude * Vector3::z(), (attitude * now.omega_body).normalize());
        let momentum = seen * self.station.momentum(time).normalize();
        // Round what stands still each of the others goes on a circle.
        let pivot = if self.on_board { axis } else { momentum };
        // L lies between the other two: the name of ω stands on one side, and theirs on the other.
        let is_left = camera.on_page(axis)?.x < camera.on_page(momentum)?.x;
        let (side, other) = if is_left { (Side::Left, Side::Right) } else { (Side::Right, Side::Left) };
        let directions = [
            (axis, 1.1, side, r"$\hat{\mathbf{3}}$", Hue::Blue),
            (momentum, 1.32, side, r"$\boldsymbol{L}$", Hue::Green),
            (omega, 1.54, other, r"$\boldsymbol{\omega}$", Hue::Orange),
        ];
        for (direction, length, side, name, hue) in directions {
            let along = direction.dot(&pivot) * length;
            let aside = (length * length - along * along).max(0.0).sqrt();
            if aside > 0.02 {
                stage.curve(Curve::circle(pivot * along, pivot, aside)?, Stroke::Outline, hue)?;
            }
            stage.vector(direction * HUB, direction * length, hue)?;
            stage.label(direction * length, side, name, hue)?;
        }
        let mark = attitude * Vector3::new(0.0, 0.93, 0.08);
        stage.dot(mark, 4.5, Hue::Pink)?;
        stage.label_shifted(mark, at(9.0, 0.0), Side::Right, "mark", Hue::Pink)?;
        if time < SHOWN && self.blows.first.impulse > 0.0 {
            let [foot, tip] = self.impulse_arrow();
            stage.named_vector(foot, tip, r"$\boldsymbol{P}$", Hue::Pink)?;
        }
        // Where it fires, and how, is seen before it does.
        let Blows { between, second, is_fired, .. } = &self.blows;
        for blow in between.iter().chain([second]) {
            let thruster = Self::thruster(blow.azimuth);
            let is_seen = (0.0..SHOWN).contains(&(time - blow.time)) || !is_fired;
            if is_seen && blow.blow.impulse != 0.0 {
                let push = Vector3::z() * (ARROW * blow.blow.impulse / MEGA);
                let hue = if *is_fired { Hue::Pink } else { Hue::Muted };
                stage.vector(attitude * thruster, attitude * (thruster + push), hue)?;
            }
        }
        stage.write(drawing);
        kit::grip(drawing, camera.on_page(attitude * Self::thruster(second.azimuth))?, Hue::Pink);
        if time < SHOWN && self.blows.first.impulse > 0.0 {
            for held in self.impulse_arrow() {
                kit::grip(drawing, camera.on_page(held)?, Hue::Pink);
            }
        }
        Ok(())
    }

    /// Where the two waves are at a moment, and when the thrusters fire.
    fn draw_places(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut graph = waves(moment.room).over(drawing);
        // Up each wave, and not through its name.
        let mark = |graph: &mut Graph<'_>, time: f64, stroke: Stroke, hue: Hue| {
            for middle in MIDDLES {
                graph.curve([(time, middle - 0.95), (time, middle + 0.95)], stroke, hue);
            }
        };
        mark(&mut graph, moment.time, Stroke::Outline, Hue::Muted);
        let now = self.station.aside(moment.time)?;
        for (index, hue) in [(0, Hue::Blue), (1, Hue::Orange)] {
            graph.dot((moment.time, MIDDLES[index] + 0.85 * now[index] * self.scales[index]), 4.0, hue);
        }
        if self.blows.is_fired {
            for blow in self.blows.between.iter().chain([&self.blows.second]) {
                mark(&mut graph, blow.time, Stroke::Reference, Hue::Pink);
            }
            kit::grip(drawing, self.fire_place(moment.room), Hue::Pink);
        }
        Ok(())
    }

    /// Where the time of the second blow stands in the graph.
    fn fire_place(&self, room: Room) -> Point {
        waves(room).point((self.blows.second.time, 1.0))
    }

    /// What can be held in the picture of a moment, and where.
    fn held(&self, moment: &Moment) -> Result<Vec<(Grip, Point)>, Cause> {
        let camera = camera(moment)?;
        let mut held = Vec::new();
        if moment.time < SHOWN && self.blows.first.impulse > 0.0 {
            let [foot, tip] = self.impulse_arrow();
            held.push((Grip::Place, camera.on_page(foot)?));
            held.push((Grip::Impulse, camera.on_page(tip)?));
        }
        let thruster = self.thruster_place(&camera, moment.time, self.blows.second.azimuth)?;
        held.push((Grip::Thruster, thruster));
        if self.blows.is_fired {
            held.push((Grip::Fire, self.fire_place(moment.room)));
        }
        Ok(held)
    }

    /// Where a thruster at another azimuth would be on the page at a time.
    fn thruster_place(&self, camera: &Camera, time: f64, azimuth: f64) -> Result<Point, Cause> {
        let second = LaterBlow { azimuth, ..self.blows.second };
        let now = Struck::new(&Blows { second, ..self.blows.clone() })?.at(time)?;
        Ok(camera.on_page(self.seen(&now) * (now.world_from_body * Self::thruster(azimuth)))?)
    }

    fn dragged(&self, grip: usize, to: Point, moment: &Moment) -> Result<Vec<(&'static str, f64)>, Cause> {
        let camera = camera(moment)?;
        let Some((grip, place)) = self.held(moment)?.get(grip).copied() else { return Ok(Vec::new()) };
        if (place - to).length() < 1e-6 {
            return Ok(Vec::new()); // a touch
        }
        let [foot, _] = self.impulse_arrow();
        let found = match grip {
            Grip::Impulse => {
                let tip = |impulse| Ok(camera.on_page(foot + Vector3::z() * (0.1 + ARROW * impulse))?);
                nearest(linear_steps(0.1, 10.0, 99), to, tip).map(|value| ("impulse", value))
            }
            Grip::Place => {
                let foot = |metres| Ok(camera.on_page([0.0, metres / RADIUS * 0.93, 0.08])?);
                nearest(linear_steps(0.0, 50.0, 50), to, foot).map(|value| ("place", value))
            }
            Grip::Thruster => {
                let place = |degrees: f64| self.thruster_place(&camera, moment.time, degrees.to_radians());
                nearest(linear_steps(0.0, 359.5, 719), to, place).map(|value| ("thruster", value))
            }
            Grip::Fire => {
                let before = self.blows.between.last().map_or(0.0, |blow| blow.time);
                Some(("fire", waves(moment.room).value(to).0.clamp(before, DURATION)))
            }
        };
        Ok(found.into_iter().collect())
    }
}

impl Motion for Nodding {
    fn run(&self) -> Run {
        Run { duration: DURATION, pace: 3.0, repeats: true }
    }

    fn draw_behind(&self, room: Room, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut graph = waves(room).on(drawing)?;
        let names = [
            r"in the room, $\hat{\mathbf{3}}$ about $\boldsymbol{L}$",
            r"on board, $\boldsymbol{\omega}$ about $\hat{\mathbf{3}}$",
        ];
        for (index, hue) in [(0, Hue::Blue), (1, Hue::Orange)] {
            let middle = MIDDLES[index];
            graph.level(middle, Stroke::Dotted, Hue::Muted);
            let wave = self.waves[index].iter().map(|&(time, aside)| (time, middle + 0.85 * aside));
            graph.curve(wave, Stroke::Curve, hue);
            let place = graph.at((0.0, middle + 1.0)) + at(12.0, -2.0);
            graph.drawing().label_set(place, Side::AboveRight, 2.0, 13.0, names[index], Role::Text(hue))?;
        }
        Ok(())
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        self.draw_places(moment, drawing)?;
        self.draw_station(moment, drawing)?;
        let sky = moment.room.of((at(508.0, 126.0), 98.0), (at(86.0, 462.0), 80.0));
        draw_sky(&self.station, sky, moment.time, drawing)
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let now = self.station.at(time)?;
        let moments = Body::hoop(MASS, RADIUS)?.moments();
        let [nods, mark, on_board] = self.station.counts(time);
        let last = self.station.last(time);
        let drift = last.map_or(self.station.first.centre_velocity(), |(_, _, velocity)| *velocity);
        // From the state, against what the last blow left.
        let momentum = self.station.momentum(time);
        let start = last.map_or(self.station.first.at(0.0)?, |(_, top, _)| top.start());
        let energy = |turning: &Turning| moments.kinetic_energy(&turning.omega_body);
        Ok(vec![
            nods,
            mark,
            on_board,
            drift.norm(),
            (now.angular_momentum_world(&moments) - momentum).norm() / momentum.norm(),
            energy(&now) / energy(&start) - 1.0,
        ])
    }

    fn words(&self, _time: f64) -> String {
        let first = &self.station.first;
        if let Some((time, top, velocity)) = self.station.later.last() {
            let which = if self.station.later.len() > 1 { "last" } else { "second" };
            let nod = 2.0 * top.momentum_angle().to_degrees();
            let after = Vector3::z().angle(&top.angular_momentum_world()).to_degrees();
            let drift = velocity.norm();
            let nodding = if nod < 0.1 { "no nod".into() } else { format!("a nod of {nod:.1}°") };
            if nod < 0.1 && after < 0.1 && drift < 0.01 {
                return format!(
                    "The {which} blow, after {time:.2} s, leaves nothing: no nod, the axis where it was, no drift."
                );
            }
            return format!(
                "The {which} blow, after {time:.2} s, leaves {nodding}. The angular momentum points {after:.1}° away from the old axis, and the \
                 centre drifts at {drift:.2} m/s."
            );
        }
        let lean = first.momentum_angle();
        if lean <= STILL {
            return if self.blows.first.impulse > 0.0 {
                let drift = first.centre_velocity().z;
                format!(
                    "A push on the axis turns nothing: the station drifts off at {drift:.2} m/s, and the stars go round the cross as before."
                )
            } else {
                "No blow: the stars go round the cross as before, once in 13.96 s.".into()
            };
        }
        let (nod, mark) = (TAU / first.nodding_rate(), TAU / (first.nodding_rate() - first.body_rate()));
        let ratio = first.nodding_rate() / SPIN;
        format!(
            "In the room the axis goes round L once in {nod:.2} s: {ratio:.2} nods in the time of one old turn. A mark on the rim comes round every \
             {mark:.2} s. On board ω goes round axis 3 once in {:.2} s, whatever the blow.",
            TAU / first.body_rate()
        )
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        self.held(moment).unwrap_or_default().into_iter().map(|(_, point)| point).collect()
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        self.dragged(grip, to, moment).unwrap_or_default()
    }
}

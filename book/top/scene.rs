//! The scene of the chapter "The top under gravity": a top is let go, pushed on or pushed back.

use live::prelude::*;
use mechanics::scenes::top::{Release, Top, TopMotion, TopParameters, Track};
use nalgebra::Vector3;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "top",
    title: "A top is let go",
    description: "A top leans on its point. Its tip has left a track behind it; the angular momentum points along the axis. Beside it a well: the energy of the tilt against \
                  the tilt, with a marble in it.",
    question: "A fast top leans and is let go, without a push. What does its tip draw? And if it is pushed on, or back? And with less and less spin?",
    size: [[640.0, 420.0], [360.0, 560.0]],
    view: Some([-1.2, 0.45]),
    still: 0.85,
    controls: &[
        Control::slider("spin", r"spin, $\omega_3$", [0.0, 300.0, 1.0], "rad/s", 150.0),
        Control::slider("tilt", r"tilt at the start, $\theta$", [0.0, 170.0, 0.1], "°", 30.0),
        Control::slider("push", r"push at the start, $\dot\varphi$", [-15.0, 15.0, 0.1], "rad/s", 0.0),
    ],
    presets: &[
        preset("let go", &[]),
        preset("pushed on", &[("push", 3.0)]),
        preset("pushed back", &[("push", -3.0)]),
        preset("pushed just right", &[("push", 6.1)]),
        preset("five times slower", &[("spin", 30.0)]),
        preset("nearly upright, asleep", &[("spin", 130.0), ("tilt", 1.0)]),
        preset("nearly upright, awake", &[("spin", 100.0), ("tilt", 1.0)]),
        preset("a pendulum without spin", &[("spin", 0.0), ("tilt", 120.0), ("push", 6.0)]),
    ],
    readings: &[
        reading(r"tilt $\theta$", Form::Fixed(1), "°"),
        reading("round the vertical", Form::Fixed(1), "°"),
        reading("nods", Form::Fixed(2), ""),
        reading(r"change of the energy, $E/E_0 - 1$", Form::Power(1), ""),
        reading(r"change of $L_z$, in $L$", Form::Power(1), ""),
    ],
    symbols: formulas![r"\boldsymbol{L}", r"\theta"],
    start: |settings| Ok(Box::new(Spun::new(settings)?)),
};

/// The toy of the chapter.
const TOY: TopParameters =
    TopParameters { mass: 0.1, arm: 0.04, transverse: 2e-4, axial: 5e-5, gravity: 9.81 };
/// For how long the track of the tip stays, s of the scene, and in how many pieces it is drawn.
const TRAIL: f64 = 1.25;
const PIECES: u32 = 260;
/// How far up the axis the tip is.
const TIP: f64 = 1.3;
/// A well is no shallower than this part of the weight's energy.
const SHALLOWEST: f64 = 1e-4;

/// A top that was let go at time zero.
struct Spun {
    motion: TopMotion,
    tilt: f64,
    spin: f64,
    /// The least energy of the tilt, and how much above it the marble is, J.
    least: f64,
    depth: f64,
}

impl Spun {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let (spin, degrees) = (settings.of("spin")?, settings.of("tilt")?);
        let precession = settings.of("push")?;
        let top = Top::new(TOY)?;
        let release = Release { tilt: degrees.to_radians(), tilt_rate: 0.0, precession, spin };
        let motion = top.let_go(release)?;
        let [from, to] = motion.tilts();
        let energy = motion.well_energy();
        // One bottom: halve the interval by thirds.
        let (mut low, mut high) = (from, to);
        for _ in 0..60 {
            let [one, other] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if motion.well(one) < motion.well(other) { high = other } else { low = one }
        }
        let least = motion.well(0.5 * (low + high)).min(energy);
        let depth = (energy - least).max(SHALLOWEST * top.weight_torque());
        Ok(Self { motion, tilt: degrees, spin, least, depth })
    }

    fn tip(&self, time: f64) -> Result<Vector3<f64>, Cause> {
        Ok(self.motion.at(time)?.axis_3_world() * TIP)
    }

    /// The tilt at a time, degrees.
    fn tilt_at(&self, time: f64) -> Result<f64, Cause> {
        Ok(self.motion.angles(time)?.tilt.to_degrees())
    }

    /// Where the well is drawn, and its axes.
    fn plot(&self, room: Room) -> Plot<'static> {
        let frame = room.of(Rect::new(440.0, 120.0, 180.0, 190.0), Rect::new(44.0, 384.0, 296.0, 124.0));
        let widest = if self.motion.tilts()[1] < 1.4 { 90.0 } else { 180.0 };
        let x = Axis::linear(0.0, widest, 0.5 * widest).titled(r"tilt $\theta$, degrees");
        Plot { frame, x, y: Axis::linear(0.0, 3.0, 1.0).titled("energy of the tilt") }
    }

    fn camera(&self, moment: &Moment) -> Result<Camera, Flaw> {
        let (centre, scale) = moment.room.of((at(200.0, 215.0), 112.0), (at(180.0, 165.0), 96.0));
        let height = if self.motion.tilts()[1] < 1.7 { 0.55 } else { 0.0 };
        moment.camera([0.0, 0.0, height], 10.0, centre, scale)
    }

    fn draw_top(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let now = self.motion.at(moment.time)?;
        let axis = now.axis_3_world();
        let mut stage = Stage::new(self.camera(moment)?);
        if self.motion.tilts()[1] < 1.4 {
            stage.ground([-1.2, -1.2], [1.2, 1.2], 0.0, 0.4)?;
        }
        let up = Curve::segment([0.0; 3], [0.0, 0.0, 1.6])?.hiding(Hiding::Ignored);
        stage.curve(up, Stroke::Reference, Hue::Muted)?;
        for tilt in self.motion.tilts() {
            let (sin, cos) = tilt.sin_cos();
            if sin > 0.02 {
                let circle = Curve::circle([0.0, 0.0, TIP * cos], Vector3::z(), TIP * sin)?;
                stage.curve(circle.hiding(Hiding::Pale), Stroke::Dotted, Hue::Muted)?;
            }
        }
        stage.solid(Solid::disc(axis * 0.62, axis, 0.46, 0.12)?, Hue::Blue)?;
        stage.solid(Solid::rod([0.0; 3], axis * TIP, 0.03)?, Hue::Blue)?;
        // A mark on the body, by which its own turn is seen.
        let mark = now.world_from_body * Vector3::new(0.36, 0.0, 0.69);
        stage.dot(mark, 4.0, Hue::Pink)?;
        let begin = (moment.time - TRAIL).max(0.0);
        let track = linear_steps(begin, moment.time, PIECES).map(|time| self.tip(time));
        let track = track.collect::<Result<Vec<_>, Cause>>()?;
        let is_long = track.iter().any(|tip| (tip - track[0]).norm() > 1e-2);
        if moment.time > 0.02 && is_long {
            stage.curve(Curve::smooth(track)?.hiding(Hiding::Pale), Stroke::Curve, Hue::Ink)?;
        }
        let momentum = now.angular_momentum_world(&self.motion.top().moments());
        if self.spin > 0.0 {
            let tip = momentum.normalize() * 1.6;
            let arrow = Curve::segment([0.0; 3], tip)?.hiding(Hiding::Ignored);
            stage.arrow(arrow, Stroke::Vector, Heads::End, Hue::Green)?;
            let side = if moment.rightward(tip) < 0.0 { Side::Left } else { Side::Right };
            stage.label(tip, side, r"$\boldsymbol{L}$", Hue::Green)?;
        }
        stage.dot_in_front([0.0; 3], 3.5, Hue::Pink)?;
        stage.write(drawing);
        Ok(())
    }

    fn draw_well(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let plot = self.plot(moment.room);
        let mut graph = plot.on(drawing)?;
        let height = |degrees: f64| (self.motion.well(degrees.to_radians()) - self.least) / self.depth;
        let values = linear_steps(0.0, plot.x.scale.to, 360);
        let values: Vec<(f64, f64)> = values.map(|degrees| (degrees, height(degrees))).collect();
        // Each stretch of it that is in the frame.
        for stretch in values.split(|value| !(value.1.is_finite() && value.1 < 3.0)) {
            if stretch.len() > 1 {
                graph.curve(stretch.iter().copied(), Stroke::Curve, Hue::Ink);
            }
        }
        let level = self.level();
        graph.level(level, Stroke::Reference, Hue::Muted);
        graph.dot((self.tilt_at(moment.time)?, level), 6.0, Hue::Blue);
        graph.grip((self.tilt, level), Hue::Ink);
        Ok(())
    }

    fn level(&self) -> f64 {
        (self.motion.well_energy() - self.least) / self.depth
    }
}

impl Motion for Spun {
    fn run(&self) -> Run {
        Run { duration: 6.0, pace: 0.2, repeats: false }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        self.draw_top(moment, drawing)?;
        self.draw_well(moment, drawing)
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let top = self.motion.top();
        let (start, now) = (self.motion.start(), self.motion.at(time)?);
        let [from, angles] = [self.motion.angles(0.0)?, self.motion.angles(time)?];
        let momentum = |state: &mechanics::euler::Turning| state.angular_momentum_world(&top.moments());
        let size = momentum(&start).norm();
        let change = (momentum(&now).z - momentum(&start).z) / if size > 0.0 { size } else { 1.0 };
        let energy = top.energy(&start);
        Ok(vec![
            angles.tilt.to_degrees(),
            (angles.azimuth - from.azimuth).to_degrees(),
            self.motion.nod_period().map_or(0.0, |nod| time / nod),
            (top.energy(&now) - energy) / energy.abs().max(top.weight_torque()),
            change,
        ])
    }

    fn words(&self, _time: f64) -> String {
        let [highest, lowest] = self.motion.tilts().map(f64::to_degrees);
        let sleeping = self.motion.top().sleeping_spin();
        if self.tilt == 0.0 {
            return if self.spin >= sleeping {
                format!("Upright, with more than {sleeping:.0} rad/s, it sleeps: no small push wakes it.")
            } else {
                format!(
                    "Exactly upright it stays. But below {sleeping:.0} rad/s the least push makes it leave: tilt it by a hair."
                )
            };
        }
        let (Some(nod), Some(swing)) = (self.motion.nod_period(), self.motion.swing_per_nod()) else {
            return "It comes up to rest upright, and never gets there.".into();
        };
        if self.tilt < 5.0 && self.spin >= sleeping {
            return format!(
                "It sleeps: with more than {sleeping:.0} rad/s the tilt stays below {lowest:.1}°, although the weight pulls all the time."
            );
        }
        if self.tilt < 5.0 {
            return format!(
                "Below {sleeping:.0} rad/s it does not sleep: it nods from {highest:.1}° out to {lowest:.1}°, once in {nod:.2} s, and comes back."
            );
        }
        let round = swing.abs().to_degrees();
        let nods = format!(
            "It nods between {highest:.1}° and {lowest:.1}°, once in {nod:.3} s, and each nod carries it {round:.0}° round."
        );
        let why = match self.motion.track() {
            _ if lowest - highest < 0.15 => {
                return format!(
                    "Pushed so, it hardly nods: going round at this rate uses up all of the weight’s torque, at a tilt of {lowest:.1}°."
                );
            }
            Track::Cusps if self.spin > 0.0 => "At the top of each nod it stops, as at the start: cusps.",
            Track::Loops => "At the top of each nod it goes back, as it was pushed: loops.",
            Track::Waves if self.spin > 0.0 => "It goes on all the time, fastest at its lowest: waves.",
            _ => "Without spin it is a pendulum.",
        };
        format!("{nods} {why}")
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        vec![self.plot(moment.room).point((self.tilt, self.level()))]
    }

    /// The tip of its axis: it is leant over.
    fn bodies(&self, moment: &Moment) -> Vec<(Point, f64)> {
        let tip = || Ok::<_, Cause>(self.camera(moment)?.on_page(self.tip(moment.time)?)?);
        tip().map_or(Vec::new(), |tip| vec![(tip, 24.0)])
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        if grip == 1 {
            let (Ok(tip), Ok(now), Ok(camera)) =
                (self.tip(moment.time), self.tilt_at(moment.time), self.camera(moment))
            else {
                return Vec::new();
            };
            let (away, more) = (tip.y.atan2(tip.x), self.tilt - now);
            let tilts = (0..=900).map(|k| 0.2 * f64::from(k) - more);
            let tilt = nearest(tilts, to, |tilt| {
                let (sin, cos) = tilt.to_radians().sin_cos();
                Ok(camera.on_page(Vector3::new(sin * away.cos(), sin * away.sin(), cos) * TIP)?)
            });
            return tilt.map_or(Vec::new(), |tilt| vec![("tilt", tilt + more)]);
        }
        vec![("tilt", self.plot(moment.room).value(to).0)]
    }
}

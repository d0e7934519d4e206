//! The small scene of the page "How Euler's disk ends": its last rounds, by a clock that slows down with it.

use super::spinning_coin::{seconds, small};
use live::prelude::*;
use mechanics::integrate::Dop853;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::spinning_coin::{BrakedDisk, Loss, SpinDown, SpinningCoin};
use nalgebra::Vector3;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "disk-end",
    title: "The end of Euler's disk",
    description: "A disc leans on a table, with its heights magnified and an arrow for the force of the table on its lowest point. Below, this force in weights against the \
                  tilt: by the law of slow sinking, dashed, it goes down to zero where the law demands a fall with g; by the motion it dips to 0.73 there and rises again.",
    question: "By the law of its loss the disc falls away from the table in the end. Does it?",
    size: [[640.0, 450.0], [380.0, 470.0]],
    view: None,
    still: 6.0,
    controls: &[Control::slider("power", r"loss like $\sin^{-p}\alpha$, $p$", [0.5, 2.0, 0.05], "", 2.0)],
    presets: &[
        preset("Moffatt's film", &[]),
        preset("a thin layer", &[("power", 1.25)]),
        preset("rolling friction", &[("power", 0.5)]),
    ],
    readings: &[
        reading("support, in weights", Form::Fixed(2), ""),
        reading(r"tilt $\alpha$", Form::Digits(3), "rad"),
        reading("time since the film began", Form::Digits(4), "s"),
    ],
    symbols: formulas![r"N", r"g"],
    start: |settings| {
        let of = Ending::new(settings)?;
        let least = of.sunk.iter().map(|[.., support]| *support).fold(f64::INFINITY, f64::min);
        let words = format!(
            "By its law the table would let go at a tilt of {}, {} before the end. The disc leans on the table with \
             {least:.2} of its weight at least, and then it creeps.",
            small(of.falls),
            seconds(of.left),
        );
        let run = Run { duration: FILM, pace: 1.0, repeats: false };
        let readings = |of: &Ending, time| {
            let now = of.at(time);
            Ok(vec![now.support, now.tilt, now.time])
        };
        Ok(Box::new(Small { of, run, words, readings, draw: Ending::draw }))
    },
};

/// The steel disc of the toy shops.
pub(super) const TOY: DiskParameters =
    DiskParameters { mass: 0.4, radius: 0.0375, moments: MomentFactors::DISK, gravity: 9.81 };
/// How long the toy lives by its law from a tilt of 0.1, s.
const LIFE: f64 = 100.0;
/// The tilts of the film, from the first to the last, in units of that at which the law demands a fall with g: in as
/// many steps of equal ratios, each as long for the reader. And the film, s of the reader.
const TILTS: [f64; 2] = [5.0, 0.45];
const STEPS: u32 = 120;
const FILM: f64 = 10.0;

/// The disc at a moment: time, s; tilt, rad; the angle by which its contact has gone round, rad; support, in weights.
#[derive(Clone, Copy)]
struct Sunk {
    time: f64,
    tilt: f64,
    round: f64,
    support: f64,
}

struct Ending {
    power: f64,
    /// Where its law demands a fall with g, rad, and how long before its end, s.
    falls: f64,
    left: f64,
    /// Time, logarithm of the tilt, round and support of [`Sunk`], at equal steps of the film.
    sunk: Vec<[f64; 4]>,
}

impl Ending {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let power = settings.of("power")?;
        let start = SpinningCoin::new(TOY, 0.1)?;
        let loss = Loss::new(SpinDown::new(start, Loss::new(1.0, power)?)?.life() / LIFE, power)?;
        let law = SpinDown::new(start, loss)?;
        let left = law.time_left_at_free_fall();
        let falls = law.with_time_left(left)?.tilt();
        // It is followed from above the film, where the law demands a fall with g/400 (eq:sinking-fall) or less, and
        // sinking as the law has it: so it does not wobble.
        let above = 400_f64.powf(1.0 / (2.0 * power + 1.0)).max(8.0);
        let begin = SpinningCoin::new(TOY, above * falls)?;
        let omega_1 = begin.tilt() / ((power + 1.0) * law.time_left(begin.tilt())?);
        let tilts: Vec<f64> = log_steps(falls * TILTS[0], falls * TILTS[1], STEPS).collect();
        let disk = BrakedDisk::new(TOY, loss)?;
        let solver = Dop853::with_tolerances(1e-8, 1e-11)?;
        let reached = disk.sink(Rolling { omega_1, ..begin.state() }, &tilts, &solver)?;
        let rate = |state: &Rolling| state.omega_2 / state.tilt.sin();
        let mut round = 0.0;
        let mut before = reached[0];
        let mut sunk = Vec::new();
        for there in &reached {
            round += 0.5 * (rate(&before.state) + rate(&there.state)) * (there.time - before.time);
            let support = disk.support(&there.state).z / (TOY.mass * TOY.gravity);
            sunk.push([there.time - reached[0].time, there.state.tilt.ln(), round, support]);
            before = *there;
        }
        Ok(Self { power, falls, left, sunk })
    }

    /// At a moment of the film, between two of its pictures.
    fn at(&self, time: f64) -> Sunk {
        let [time, log_tilt, round, support] = interpolated(&self.sunk, time / FILM * f64::from(STEPS));
        Sunk { time, tilt: log_tilt.exp(), round, support }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let (room, now) = (moment.room, self.at(moment.time));
        // Heights are magnified, the more the lower it stands, so that it can be seen to lean until the end.
        let shown = 0.3 * (now.tilt / self.at(0.0).tilt).powf(0.35);
        let (centre, scale) = room.of((at(320.0, 130.0), 120.0), (at(190.0, 120.0), 100.0));
        let eye = moment.seen_from(-1.1, 0.3);
        let mut stage = Stage::new(eye.camera([0.0, 0.0, 0.3], 9.0, centre, scale)?);
        stage.curve(Curve::circle([0.0; 3], Vector3::z(), shown.cos())?, Stroke::Pale, Hue::Pink)?;
        let contact = draw_leaning(&mut stage, shown, now.round)?;
        stage.dot_in_front(contact, 5.0, Hue::Pink)?;
        stage.named_vector(contact, contact + Vector3::z() * (0.7 * now.support), "$N$", Hue::Purple)?;
        stage.write(drawing);
        let text = format!("heights magnified {:.0} times", shown / now.tilt);
        let place = at(8.0, room.of(236.0, 250.0));
        drawing.note(place, Side::Right, &text, Hue::Muted)?;

        let frames = [[130.0, 276.0, 380.0, 116.0], [48.0, 296.0, 310.0, 116.0]];
        let x = Axis::log(0.3, 10.0, 1).titled("tilt, 1 where the law falls with $g$");
        let y = Axis::linear(0.0, 2.0, 0.5).titled("support, in weights");
        let mut graph = moment.graph(drawing, frames, x, y)?;
        // The fall that slow sinking asks for goes like the tilt to the power 1 − 2/s (eq:sinking-fall).
        let law = log_steps(1.0, 10.0, 60).map(|part| (part, 1.0 - part.powf(-2.0 * self.power - 1.0)));
        graph.curve(law, Stroke::DashedCurve, Hue::Ink);
        graph.level(1.0, Stroke::Reference, Hue::Muted);
        let point = |tilt: f64, support: f64| (tilt / self.falls, support);
        let all = self.sunk.iter().map(|&[_, log_tilt, _, support]| point(log_tilt.exp(), support));
        graph.curve(all, Stroke::Curve, Hue::Purple);
        graph.dot(point(now.tilt, now.support), 5.0, Hue::Purple);
        graph.label((1.3, 0.3), Side::Right, "the law", Hue::Ink)?;
        Ok(())
    }
}

/// A disc of radius one that leans on a table, its contact at an azimuth, rad; and that contact.
pub(crate) fn draw_leaning(stage: &mut Stage, tilt: f64, azimuth: f64) -> Result<Vector3<f64>, Flaw> {
    let ((sin, cos), (y, x)) = (tilt.sin_cos(), azimuth.sin_cos());
    stage.ground([-1.25, -1.25], [1.25, 1.25], 0.0, 0.25)?;
    stage.solid(Solid::disc([0.0, 0.0, sin], [sin * x, sin * y, cos], 1.0, 0.03)?, Hue::Blue)?;
    Ok(Vector3::new(cos * x, cos * y, 0.0))
}

//! The figures of the chapter "The coin toss".

use crate::{Axis, Cause, Outcome, Plot, linear_steps, log_steps};
use drawing::kit::Marker;
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Rect, Side, Stroke, at};
use mechanics::InvalidQuantity;
use mechanics::attitude::angle_between;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, PrincipalMoments};
use mechanics::integrate::rk4;
use mechanics::scenes::coin_toss::{Toss, TossParameters, angle_for_probability};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// A thin coin; its mass and radius make no difference.
fn coin() -> Result<PrincipalMoments, InvalidQuantity> {
    Ok(Body::thin_disk(0.0075, 0.0122)?.moments())
}

/// That coin with a tumble and a twist, rad/s.
fn tossed(omega_1: f64, omega_3: f64) -> Result<Toss, InvalidQuantity> {
    Toss::new(TossParameters { moments: coin()?, omega_1, omega_3 })
}

/// Half the thickness of a drawn coin, in radii.
const HALF: f64 = 0.07;

/// The letter on each face, as strokes from point to point along axes 1 and 2 of the coin, in radii. That of tails
/// is written so that it reads well from below.
const HEADS: [[[f64; 2]; 2]; 3] =
    [[[-0.22, -0.32], [-0.22, 0.32]], [[0.22, -0.32], [0.22, 0.32]], [[-0.22, 0.0], [0.22, 0.0]]];
const TAILS: [[[f64; 2]; 2]; 2] = [[[0.0, -0.3], [0.0, 0.3]], [[-0.26, -0.3], [0.26, -0.3]]];

/// Adds a coin of radius 1 about the origin: the half of the face that was up in the hue of the body, the other grey.
fn halves_in(stage: &mut Stage, attitude: &UnitQuaternion<f64>) -> Result<(), Cause> {
    let normal = attitude * Vector3::z();
    for (side, hue) in [(0.5, Hue::Blue), (-0.5, Hue::Muted)] {
        stage.solid(Solid::disc(normal * (side * HALF), normal, 1.0, HALF)?, hue)?;
    }
    Ok(())
}

/// Adds the letters of that coin: an H on the face that was up, a T on the other, a step aside from the middle along
/// axis 2.
fn letters_in(
    stage: &mut Stage,
    attitude: &UnitQuaternion<f64>,
    aside: f64,
    pen: Stroke,
) -> Result<(), Cause> {
    for (height, hue, letter) in [(HALF, Hue::Blue, &HEADS[..]), (-HALF, Hue::Ink, &TAILS[..])] {
        for stroke in letter {
            let [from, to] = stroke.map(|[x, y]| attitude * Vector3::new(x, y + aside, height));
            stage.curve(Curve::segment(from, to)?.hiding(Hiding::Omitted), pen, hue)?;
        }
    }
    Ok(())
}

/// The direction of the angular momentum, which lies in the plane of x and z.
fn momentum_of(toss: &Toss) -> Vector3<f64> {
    let (sin, cos) = toss.momentum_angle().sin_cos();
    Vector3::new(sin, 0.0, cos)
}

/// The coin flat in the hand, and half a precession later.
pub(crate) fn toss(id: &str) -> Outcome {
    let toss = tossed(1.0, 0.31)?;
    let half = 0.5 * TAU / toss.precession_rate();
    let momentum = momentum_of(&toss);
    let panel = |title: &str, description: &str, time: f64| -> Outcome {
        let mut drawing = Drawing::new("", 320.0, 330.0).titled(title, description);
        let attitude = toss.at(time)?.world_from_body;
        let normal = attitude * Vector3::z();
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0; 3],
            azimuth: -1.75,
            elevation: 0.45,
            distance: 9.0,
            centre: at(150.0, 185.0),
            scale: 90.0,
        })?);
        halves_in(&mut stage, &attitude)?;
        letters_in(&mut stage, &attitude, -0.5, Stroke::Vector)?;
        stage.named_vector([0.0; 3], momentum * 1.75, r"$\boldsymbol{L}$", Hue::Green)?;
        stage.named_vector([0.0; 3], normal * 1.55, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        if time == 0.0 {
            stage.named_vector([0.0; 3], [1.6, 0.0, 0.0], r"$\hat{\mathbf{1}}$", Hue::Ink)?;
            stage.angle([0.0; 3], normal, momentum, 0.8, r"$\psi$", Hue::Ink)?;
        } else {
            let start = Vector3::z();
            stage.curve(Curve::segment([0.0; 3], start * 1.5)?, Stroke::Reference, Hue::Muted)?;
            stage.label(start * 1.5, Side::Above, "the normal at the start", Hue::Muted)?;
            stage.angle([0.0; 3], start, normal, 1.15, "", Hue::Ink)?;
            stage.label(
                (start * 2.0 + momentum).normalize() * 1.13,
                Side::AboveRight,
                r"$2\psi$",
                Hue::Ink,
            )?;
            stage.angle([0.0; 3], normal, momentum, 0.7, r"$\psi$", Hue::Ink)?;
        }
        stage.write(&mut drawing);
        let name = if time == 0.0 { "at the start: heads" } else { "half a precession later: tails" };
        drawing.label(at(150.0, 304.0), Side::Over, name, Hue::Ink)?;
        Ok(drawing)
    };
    let start = panel(
        "The coin at the start",
        "The coin lies flat, heads up: its normal 3 points straight up, the axis 1 to the right, and the \
         angular momentum L leans to the right at the angle psi to the normal.",
        0.0,
    )?;
    let later = panel(
        "The coin half a precession later",
        "L is where it was. The normal has gone to its other side, at the angle psi again, so that it has \
         turned by two psi in all and points below the horizon: tails is seen from above.",
        half,
    )?;
    Ok(Drawing::panels(id, vec![start, later]))
}

/// Into how many parts a film strip divides a precession.
const FRAMES: u32 = 8;

/// Where the frames of a film strip stand, their time running to the right or down, px.
struct Film {
    size: (f64, f64),
    cell: (f64, f64),
    first: (f64, f64),
    down: bool,
}

impl Film {
    /// The middle of a frame of a strip.
    fn frame(&self, strip: usize, frame: u32) -> Point {
        let (strip, frame) = (strip as f64, f64::from(frame));
        let (column, row) = if self.down { (strip, frame) } else { (frame, strip) };
        at(self.first.0 + self.cell.0 * column, self.first.1 + self.cell.1 * row)
    }

    /// Three tosses through one precession, seen from straight above.
    fn draw(&self) -> Outcome {
        let mut drawing = Drawing::new("", self.size.0, self.size.1).titled(
            "Three tosses through one precession, seen from above",
            "Three strips of nine pictures of the coin. Without twist it goes over: heads, edge, three \
             times tails, edge, heads. Twisted a quarter as fast as it tumbles it shows tails in the three \
             pictures in the middle and heads in all others. Twisted three fifths as fast it shows heads \
             in every picture, leans to all sides, and is nearly on edge in the middle.",
        );
        let strips = [
            (0.0, r"$\omega_3 = 0$"),
            (0.25, r"$\omega_3 = \tfrac14\,\omega_1$"),
            (0.6, r"$\omega_3 = \tfrac35\,\omega_1$"),
        ];
        for (strip, (ratio, name)) in strips.into_iter().enumerate() {
            let toss = tossed(1.0, ratio)?;
            let period = TAU / toss.precession_rate();
            for frame in 0..=FRAMES {
                let (middle, radius) = (self.frame(strip, frame), 0.46 * self.cell.0.min(self.cell.1));
                let corner = |x: f64, y: f64| middle + at(radius * x, radius * y);
                let corners =
                    vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
                drawing.polygon(corners, Fill::Floor, Hue::Ink);
                let mut stage = Stage::new(Camera::new(View {
                    target: [0.0; 3],
                    azimuth: -FRAC_PI_2,
                    elevation: FRAC_PI_2,
                    distance: 9.0,
                    centre: middle,
                    scale: 0.8 * radius,
                })?);
                let attitude = toss.at(period * f64::from(frame) / f64::from(FRAMES))?.world_from_body;
                // So small a coin is of one hue, that of the face one sees; on edge it has both.
                let normal = attitude * Vector3::z();
                if normal.z.abs() < 1e-9 {
                    halves_in(&mut stage, &attitude)?;
                } else {
                    let hue = if normal.z > 0.0 { Hue::Blue } else { Hue::Muted };
                    stage.solid(Solid::disc([0.0; 3], normal, 1.0, 2.0 * HALF)?, hue)?;
                    letters_in(&mut stage, &attitude, 0.0, Stroke::Outline)?;
                }
                stage.write(&mut drawing);
            }
            let share = format!("heads {:.0} %", 100.0 * toss.same_face_probability());
            let start = self.frame(strip, 0);
            let [above, below] = if self.down {
                [start - at(0.0, 0.5 * self.cell.1 + 32.0), start - at(0.0, 0.5 * self.cell.1 + 12.0)]
            } else {
                [start - at(0.5 * self.cell.0 + 46.0, 10.0), start - at(0.5 * self.cell.0 + 46.0, -10.0)]
            };
            drawing.label(above, Side::Over, name, Hue::Ink)?;
            drawing.label(below, Side::Over, &share, Hue::Blue)?;
        }
        let quarters = ["$0$", r"$\tfrac14$", r"$\tfrac12$", r"$\tfrac34$", "$1$"];
        for (frame, name) in (0..=FRAMES).step_by(2).zip(quarters) {
            let place = if self.down {
                self.frame(0, frame) - at(0.5 * self.cell.0 + 8.0, 0.0)
            } else {
                self.frame(2, frame) + at(0.0, 0.5 * self.cell.1 + 12.0)
            };
            drawing.label(place, Side::Over, name, Hue::Ink)?;
        }
        let below = self.frame(2, FRAMES).y + 0.5 * self.cell.1 + 12.0;
        let (place, side, name) = if self.down {
            (at(self.frame(1, 0).x, below), Side::Over, "time, precessions")
        } else {
            (at(self.first.0 - 0.5 * self.cell.0, below), Side::Left, "precessions")
        };
        drawing.label(place, side, name, Hue::Ink)?;
        Ok(drawing)
    }
}

/// A film of three tosses.
pub(crate) fn toss_film(id: &str) -> Outcome {
    let across = Film { size: (590.0, 240.0), cell: (52.0, 60.0), first: (128.0, 44.0), down: false };
    let down = Film { size: (330.0, 660.0), cell: (94.0, 60.0), first: (80.0, 90.0), down: true };
    let (mut wide, narrow) = (across.draw()?, down.draw()?);
    wide = Drawing::panels(id, vec![wide]);
    Ok(wide.with_narrow(narrow))
}

/// The path of the tip of the normal for three angles, on the unit sphere.
pub(crate) fn cones(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 440.0, 380.0).titled(
        "Paths of the tip of the normal on a sphere",
        "A unit sphere with its equator. Three circles on it pass through the north pole, where the normal \
         starts. The smallest, for psi 30 degrees, stays in the upper half; the middle one, for 45 \
         degrees, touches the equator; the largest, for 75 degrees, goes far below it, and is grey there. \
         Dots mark the directions of the angular momentum at the centres of the circles.",
    );
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0; 3],
        azimuth: -0.9,
        elevation: 0.38,
        distance: 9.0,
        centre: at(215.0, 200.0),
        scale: 150.0,
    })?);
    stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
    stage.curve(Curve::circle([0.0; 3], Vector3::z(), 1.0)?, Stroke::Reference, Hue::Ink)?;
    for degrees in [30.0_f64, 45.0, 75.0] {
        let toss = tossed(2.0 * degrees.to_radians().tan(), 1.0)?;
        let period = TAU / toss.precession_rate();
        // Heads from one time on edge to the next, then tails.
        let edge = toss.first_edge().unwrap_or(0.5 * period);
        for (from, to, hue) in [(-edge, edge, Hue::Blue), (edge, period - edge, Hue::Muted)] {
            if to - from > 1e-9 * period {
                let path = linear_steps(from, to, 360)
                    .map(|time| toss.normal(time))
                    .collect::<Result<Vec<_>, InvalidQuantity>>()?;
                stage.curve(Curve::smooth(path)?, Stroke::Curve, hue)?;
            }
        }
        stage.dot(momentum_of(&toss), 3.5, Hue::Green)?;
        let step = at(if degrees > 60.0 { -9.0 } else { 0.0 }, 0.0);
        stage.label_shifted(momentum_of(&toss), step, Side::Left, &format!("${degrees}°$"), Hue::Green)?;
    }
    let wide = tossed(2.0 * 75_f64.to_radians().tan(), 1.0)?;
    let edge = wide.first_edge().ok_or("it goes over")?;
    stage.label(wide.normal(0.5 * edge)?, Side::Left, "heads up", Hue::Blue)?;
    stage.label_shifted(wide.normal(1.15 * edge)?, at(7.0, -2.0), Side::Right, "tails up", Hue::Muted)?;
    stage.dot([0.0, 0.0, 1.0], 3.5, Hue::Ink)?;
    stage.label_shifted([0.0, 0.0, 1.0], at(0.0, -7.0), Side::Above, "start, flat", Hue::Ink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// Height of the normal for a twist just below, at and just above the threshold.
pub(crate) fn threshold(id: &str) -> Outcome {
    let values = |ratio: f64, from: f64, to: f64| -> Result<Vec<(f64, f64)>, Cause> {
        let toss = tossed(1.0, ratio)?;
        let period = TAU / toss.precession_rate();
        linear_steps(from, to, 300).map(|turns| Ok((turns, toss.normal_height(turns * period)?))).collect()
    };
    let mut whole = Drawing::new("", 310.0, 330.0).titled(
        "Height of the normal for a small twist and near the threshold",
        "The height of the coin's normal against time in precessions, from 0 to 2. The curves for the \
         ratios of twist to tumble 0.49, 0.50 and 0.51 lie so close together that they look like one, \
         which begins at one and falls to about zero after half a precession; a fourth, for the ratio 0.2, \
         falls to minus 0.7, where tails is up.",
    );
    let time = Axis::linear(0.0, 2.0, 0.5)?.minor(0.1).titled("time, precessions");
    let height = Axis::linear(-1.0, 1.0, 0.5)?.minor(0.1).titled(r"height of the normal $n_z$");
    let mut plot = Plot::new(&mut whole, Rect::new(48.0, 34.0, 244.0, 240.0), time, height)?;
    plot.region((0.0, -1.0), (2.0, 0.0), Hue::Muted);
    for ratio in [0.20, 0.49, 0.50, 0.51] {
        plot.curve(&format!("whole-{ratio}"), values(ratio, 0.0, 2.0)?, Stroke::Curve, Hue::Blue);
    }
    plot.label((0.5, -0.73), Side::Below, "$0.20$", Hue::Blue)?;
    plot.label((0.5, 0.68), Side::Over, "$0.49$", Hue::Blue)?;
    plot.label((0.5, 0.51), Side::Over, "to $0.51$", Hue::Blue)?;
    plot.label((1.0, -0.7), Side::Over, "tails up", Hue::Muted)?;

    let mut part = Drawing::new("", 250.0, 330.0).titled(
        "The lowest point of the normal, enlarged",
        "The neighbourhood of the lowest point enlarged: the curve for the ratio 0.49 dips below zero, \
         that for 0.50 touches it, that for 0.51 stays above.",
    );
    let time = Axis::linear(0.4, 0.6, 0.1)?.minor(0.02).titled("time, precessions");
    let height = Axis::linear(-0.04, 0.1, 0.02)?.titled(r"$n_z$, enlarged");
    let mut plot = Plot::new(&mut part, Rect::new(48.0, 34.0, 176.0, 240.0), time, height)?;
    plot.region((0.4, -0.04), (0.6, 0.0), Hue::Muted);
    for ratio in [0.49, 0.50, 0.51] {
        plot.curve(&format!("part-{ratio}"), values(ratio, 0.4, 0.6)?, Stroke::Curve, Hue::Blue);
    }
    for (height, name) in [(-0.03, "$0.49$: over"), (0.008, "$0.50$"), (0.05, "$0.51$: never")] {
        plot.label((0.5, height), Side::Over, name, Hue::Blue)?;
    }
    Ok(Drawing::panels(id, vec![whole, part]))
}

/// Probability of the same face against the angle between normal and angular momentum.
pub(crate) fn bias(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 340.0).titled(
        "Probability of the same face",
        "The probability that a coin shows the same face, against the angle psi between its normal and its \
         angular momentum in degrees. Up to 45 degrees it is one. From there it falls, steeply at first, \
         to one half at 90 degrees. The measured 0.508 lies on the curve at 81 degrees.",
    );
    let angle = Axis::linear(0.0, 90.0, 15.0)?
        .minor(5.0)
        .titled(r"angle $\psi$ of normal and $\boldsymbol{L}$, degrees");
    let probability = Axis::linear(0.5, 1.0, 0.1)?.minor(0.02).titled("probability of the same face");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 34.0, 330.0, 252.0), angle, probability)?;
    plot.region((0.0, 0.5), (45.0, 1.0), Hue::Blue);
    // Dense near 45°, where the curve leaves with an upright tangent.
    let mut values = vec![(0.0, 1.0), (45.0, 1.0)];
    for step in linear_steps(0.0, 1.0, 400) {
        let toss = tossed(1.0, 0.5 * (1.0 - step * step))?;
        values.push((toss.momentum_angle().to_degrees(), toss.same_face_probability()));
    }
    plot.curve("probability", values, Stroke::Curve, Hue::Blue);
    let measured = (angle_for_probability(0.508)?.to_degrees(), 0.508);
    plot.markers(&[measured], Marker::Disc, Hue::Ink);
    plot.label((measured.0 + 1.0, 0.6), Side::Over, "real tosses", Hue::Ink)?;
    plot.label((measured.0 + 1.0, 0.565), Side::Over, "$0.508$", Hue::Ink)?;
    plot.label((22.5, 0.75), Side::Over, "never turns over", Hue::Ink)?;
    Ok(drawing)
}

/// Error of the direction of the normal by Euler's angles and by the quaternion, against the tilt of the hand.
pub(crate) fn gimbal(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 350.0).titled(
        "Euler's angles against the quaternion",
        "Both scales are logarithmic: along x the tilt of the coin in the hand, from a millionth of a \
         radian to a tenth; along y the error in the direction of the normal after 0.45 seconds, with the \
         same Runge-Kutta method and step. The quaternion's error is about 1e-6 at every tilt. With \
         Euler's angles the error is between a hundredth and two radians for every tilt below a hundredth.",
    );
    let (tumble, twist, seconds, steps) = (38.0 * TAU, 4.0 * TAU, 0.45, 4500);
    let moments = coin()?;
    let (mut angles, mut quaternions) = (Vec::new(), Vec::new());
    for tilt in log_steps(1e-6, 0.1, 50) {
        // Tilted sideways, about y: the turn begins at a right angle, and the coin's own angle at minus one.
        let start = Turning {
            world_from_body: UnitQuaternion::from_scaled_axis(Vector3::new(0.0, tilt, 0.0)),
            omega_body: Vector3::new(tumble, 0.0, twist),
        };
        let exact = FreeSymmetricTop::new(moments, start)?.axis_world(seconds)?;
        let rates = |t: f64, &[_, lean, own]: &[f64; 3]| {
            let (sin, cos) = (twist * t).sin_cos();
            let [w1, w2] = [tumble * cos, tumble * sin];
            let turn = (w1 * own.sin() + w2 * own.cos()) / lean.sin();
            [turn, w1 * own.cos() - w2 * own.sin(), twist - turn * lean.cos()]
        };
        if let Ok([turn, lean, _]) = rk4(rates, 0.0, [FRAC_PI_2, tilt, -FRAC_PI_2], seconds, steps) {
            let normal = Vector3::new(turn.sin() * lean.sin(), -turn.cos() * lean.sin(), lean.cos());
            angles.push((tilt, angle_between(&normal, &exact)));
        }
        let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
        let state = rk4(free, 0.0, start.to_array(), seconds, steps)?;
        quaternions.push((tilt, angle_between(&Turning::from_array(state).axis_3_world(), &exact)));
    }
    let tilt = Axis::log(1e-6, 0.1, 1)?.titled("tilt of the hand $d$, rad");
    let error = Axis::log(1e-8, 10.0, 1)?.titled("error of the normal, rad");
    let mut plot = Plot::new(&mut drawing, Rect::new(56.0, 34.0, 320.0, 262.0), tilt, error)?;
    plot.series("angles", &angles, Marker::Disc, Hue::Orange);
    plot.series("quaternion", &quaternions, Marker::Square, Hue::Blue);
    plot.label((1e-5, 3.0), Side::Right, "Euler’s angles", Hue::Orange)?;
    plot.label((1e-5, 1e-7), Side::Right, "quaternion", Hue::Blue)?;
    Ok(drawing)
}

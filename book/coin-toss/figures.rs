//! The figures of the chapter "The coin toss".

use drawing::kit::{self, Heads, Marker, head};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Rect, Role, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, linear_steps, log_steps};
use mechanics::InvalidQuantity;
use mechanics::attitude::angle_between;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, PrincipalMoments};
use mechanics::integrate::rk4;
use mechanics::scenes::coin_toss::{
    Toss, TossCount, TossParameters, Tossers, TossersParameters, ratio_for_probability,
};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    toss,
    toss_film,
    above,
    bias,
    chance::catch_window,
    turns::euler_turns,
    gimbal,
    people,
    edge::edge_band,
    edge::edge_chance,
    chance::pin_paths
];

#[path = "figures/chance.rs"]
pub(crate) mod chance;
#[path = "figures/edge.rs"]
pub(crate) mod edge;
#[path = "figures/turns.rs"]
pub(crate) mod turns;

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
            stage.angle([0.0; 3], normal, momentum, 0.8, r"$\theta_L$", Hue::Ink)?;
        } else {
            let start = Vector3::z();
            stage.curve(Curve::segment([0.0; 3], start * 1.5)?, Stroke::Reference, Hue::Muted)?;
            stage.label(start * 1.5, Side::Above, "the normal at the start", Hue::Muted)?;
            stage.angle([0.0; 3], start, normal, 1.15, "", Hue::Ink)?;
            stage.label(
                (start * 2.0 + momentum).normalize() * 1.13,
                Side::AboveRight,
                r"$2\theta_L$",
                Hue::Ink,
            )?;
            stage.angle([0.0; 3], normal, momentum, 0.7, r"$\theta_L$", Hue::Ink)?;
        }
        stage.write(&mut drawing);
        let name = if time == 0.0 { "at the start: heads" } else { "half a round later: tails" };
        drawing.label(at(150.0, 304.0), Side::Over, name, Hue::Ink)?;
        Ok(drawing)
    };
    let start = panel(
        "The coin at the start",
        "The coin lies flat, heads up: its normal 3 points straight up, the axis 1 to the right, and the \
         angular momentum L leans to the right at the angle theta L to the normal.",
        0.0,
    )?;
    let later = panel(
        "The coin half a precession later",
        "L is where it was. The normal has gone to its other side, at the angle theta L again, so that it has \
         turned by two theta L in all and points below the horizon: tails is seen from above.",
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

/// The circles of the normal: edge-on for five angles, and one of them face-on.
pub(crate) fn above(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![circles_edge_on()?, circle_face_on(60.0)?]))
}

/// A thin coin whose momentum leans by an angle, in degrees.
fn leaning(degrees: f64) -> Result<Toss, InvalidQuantity> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    tossed(2.0 * sin, cos)
}

/// The unit sphere seen along y: each circle is a straight line from the pole.
fn circles_edge_on() -> Outcome {
    let mut drawing = Drawing::new("", 280.0, 280.0).titled(
        "The circles of five tosses, seen edge-on",
        "A unit sphere seen from the side, with its equator as a level line and the lower half tinted. Five \
         straight lines run down from the pole, each the circle of a toss seen edge-on. That for theta L 30 \
         degrees ends above the equator, that for 45 degrees on it, those for 60, 75 and 90 degrees below; \
         what is above is blue, what is below grey. The middles of the lines are dots on a small circle \
         between the pole and the centre of the sphere, none of them below the equator.",
    );
    let (centre, radius) = (at(112.0, 140.0), 100.0);
    let place = |v: Vector3<f64>| centre + at(v.x, -v.z) * radius;
    let southern = linear_steps(0.0, 180.0, 90).map(|turn| centre + Point::polar(radius, -turn.to_radians()));
    drawing.polygon(southern.collect(), Fill::Ground, Hue::Muted);
    drawing.circle(centre, radius, Role::Line(Stroke::Outline, Hue::Muted));
    let [left, right] = [-1.0, 1.0].map(|x| place(Vector3::new(x, 0.0, 0.0)));
    drawing.line(left, right, Stroke::Reference, Hue::Ink);
    let middles = linear_steps(-90.0, 90.0, 60)
        .map(|turn| centre - at(0.0, 0.5 * radius) + Point::polar(0.5 * radius, turn.to_radians()));
    drawing.polyline(&middles.collect::<Vec<_>>(), Stroke::Dotted, Hue::Green);
    let pole = place(Vector3::z());
    let names = [
        (30.0, Side::Right, r"$\theta_L = 30°$"),
        (45.0, Side::Right, "$45°$"),
        (60.0, Side::Right, "$60°$"),
        (75.0, Side::BelowRight, "$75°$"),
        (90.0, Side::Below, "$90°$"),
    ];
    for (degrees, side, name) in names {
        let toss = leaning(degrees)?;
        let half = 0.5 * TAU / toss.precession_rate();
        let lowest = place(toss.normal(half)?);
        let edge = match toss.first_edge() {
            Some(time) => place(toss.normal(time)?),
            None => lowest,
        };
        drawing.line(pole, edge, Stroke::Curve, Hue::Blue);
        if (lowest - edge).length() > 0.5 {
            drawing.line(edge, lowest, Stroke::Curve, Hue::Muted);
        }
        drawing.label(lowest, side, name, Hue::Ink)?;
        drawing.dot(pole.towards(lowest, 0.5), 3.5, Hue::Green);
    }
    drawing.dot(pole, 3.5, Hue::Ink);
    drawing.label(pole, Side::Above, "start, flat", Hue::Ink)?;
    drawing.label(centre + at(-0.5, 0.0) * radius, Side::Above, "heads up", Hue::Blue)?;
    drawing.label(centre + at(-0.5, 0.0) * radius, Side::Below, "tails up", Hue::Muted)?;
    Ok(drawing)
}

/// The circle for an angle, in degrees, as one sees it when the momentum points to the eye.
fn circle_face_on(degrees: f64) -> Outcome {
    let mut drawing = Drawing::new("", 280.0, 280.0).titled(
        "One of the circles, seen face-on",
        "The circle for theta L 60 degrees, seen against the angular momentum. It begins at the top, where the \
         coin lies flat, and runs counter-clockwise. A level chord, the height of the equator, cuts it below \
         the middle, at a distance of cot squared theta L of the radius. The part above the chord is blue, the \
         part below grey. The angle at the middle from the top to the chord is Lambda t edge.",
    );
    let toss = leaning(degrees)?;
    let (centre, radius) = (at(118.0, 140.0), 100.0);
    // Up the circle's plane, and to the right in it for an eye that L points to.
    let (momentum, angle) = (momentum_of(&toss), toss.momentum_angle());
    let up = (Vector3::z() - momentum * angle.cos()) / angle.sin();
    let right = up.cross(&momentum);
    let place = |time: f64| -> Result<Point, InvalidQuantity> {
        let normal = toss.normal(time)?;
        Ok(centre + at(normal.dot(&right), -normal.dot(&up)) * (radius / angle.sin()))
    };
    let (period, edge) = (TAU / toss.precession_rate(), toss.first_edge().ok_or("it goes over")?);
    let arc = |from: f64, to: f64| linear_steps(from, to, 90).map(place).collect::<Result<Vec<_>, _>>();
    let [start, first, last] = [place(0.0)?, place(edge)?, place(-edge)?];
    let below = arc(edge, period - edge)?;
    drawing.polygon(below.clone(), Fill::Ground, Hue::Muted);
    let beyond = at(0.12 * radius, 0.0);
    drawing.line(first - beyond, last + beyond, Stroke::Reference, Hue::Ink);
    drawing.polyline(&below, Stroke::Curve, Hue::Muted);
    drawing.polyline(&arc(-edge, edge)?, Stroke::Curve, Hue::Blue);
    let [before, tip] = [0.42 * edge, 0.45 * edge].map(place);
    head(&mut drawing, tip?, tip? - before?, 1.0, Hue::Blue);
    for end in [start, first] {
        drawing.line(centre, end, Stroke::Outline, Hue::Ink);
    }
    let turned = toss.precession_rate() * edge;
    kit::angle(&mut drawing, centre, 34.0, FRAC_PI_2, turned, Heads::None, Hue::Ink);
    let name = centre + Point::polar(36.0, FRAC_PI_2 + 0.45 * turned);
    drawing.label(name, Side::AboveLeft, r"$\Lambda t_\text{edge}$", Hue::Ink)?;
    let chord = at(centre.x, first.y);
    kit::dimension(&mut drawing, centre, chord, Heads::Both, Hue::Ink);
    drawing.label(centre.towards(chord, 0.5), Side::Right, r"$\text{cot}^2\theta_L$", Hue::Ink)?;
    drawing.dot(centre, 3.5, Hue::Green);
    drawing.label(centre, Side::AboveRight, r"$\boldsymbol{L}$", Hue::Green)?;
    drawing.dot(start, 3.5, Hue::Ink);
    drawing.label(start, Side::Above, "start, flat", Hue::Ink)?;
    drawing.label(at(centre.x, 0.5 * (chord.y + centre.y + radius)), Side::Over, "tails up", Hue::Muted)?;
    drawing.label(centre + at(0.4, -0.5) * radius, Side::Over, "heads up", Hue::Blue)?;
    drawing.label(last + beyond, Side::Right, "equator", Hue::Ink)?;
    Ok(drawing)
}

/// Probability of the same face against the ratio of twist to tumble.
pub(crate) fn bias(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 330.0).titled(
        "Probability of the same face against the twist",
        "The probability that a thin coin shows the same face, against the ratio of twist to tumble. It \
         begins at one half with a level tangent, as a parabola does that is dashed; rises more and more \
         steeply; and reaches one with an upright tangent at the ratio one half, from which on it is one. \
         The measured 0.508 lies near the beginning, at the ratio 0.079.",
    );
    let twist = Axis::linear(0.0, 0.6, 0.1).minor(0.02).titled(r"twist over tumble, $\omega_3/\omega_1$");
    let probability = Axis::linear(0.5, 1.0, 0.1).minor(0.02).titled("probability of the same face");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 280.0, 242.0), twist, probability)?;
    plot.region((0.5, 0.5), (0.6, 1.0), Hue::Muted);
    let of = |ratio: f64| Ok::<_, InvalidQuantity>(tossed(1.0, ratio)?.same_face_probability());
    // The square law, from a twist at which nothing else is left.
    let curvature = (of(1e-3)? - 0.5) / 1e-6;
    plot.curve(
        "square",
        linear_steps(0.0, 0.6, 60).map(|ratio| (ratio, 0.5 + curvature * ratio * ratio)),
        Stroke::DashedCurve,
        Hue::Muted,
    );
    // Dense near the threshold, where the curve arrives with an upright tangent.
    let mut values = Vec::new();
    for step in linear_steps(1.0, 0.0, 400) {
        let ratio = 0.5 * (1.0 - step * step);
        values.push((ratio, of(ratio)?));
    }
    values.push((0.6, of(0.6)?));
    plot.curve("probability", values, Stroke::Heavy, Hue::Ink);
    let measured = (ratio_for_probability(coin()?, 0.508)?, 0.508);
    plot.markers(&[measured], Marker::Disc, Hue::Ink);
    let [from, to] = [(0.09, 0.509), (0.2, 0.518)].map(|value| plot.at(value));
    plot.drawing().line(from, to, Stroke::Dotted, Hue::Muted);
    plot.label((0.2, 0.519), Side::Right, "real tosses: $0.508$", Hue::Ink)?;
    plot.label((0.55, 0.78), Side::Over, "never", Hue::Ink)?;
    plot.label((0.55, 0.745), Side::Over, "tails", Hue::Ink)?;
    plot.label((0.285, 0.59), Side::Right, "as the square", Hue::Muted)?;
    Ok(drawing)
}

/// Error of the direction of the normal by Euler's angles and by the quaternion, against the tilt of the hand.
pub(crate) fn gimbal(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 330.0).titled(
        "Euler's angles against the quaternion",
        "Both scales are logarithmic: along x the tilt of the coin in the hand, from a millionth of a \
         radian to a tenth; along y the error in the direction of the normal after 0.45 seconds, with the \
         same Runge-Kutta method and step. The quaternion's error is about 2e-8 at every tilt. With \
         Euler's angles the error lies between two hundredths and three tenths of a radian for every tilt \
         below five thousandths.",
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
    let tilt = Axis::log(1e-6, 0.1, 1).titled(r"tilt of the hand $\alpha_0$, rad");
    let error = Axis::log(1e-8, 10.0, 1).titled("error of the normal, rad");
    let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 270.0, 242.0), tilt, error)?;
    plot.series("angles", &angles, Marker::Disc, Hue::Ink);
    plot.series("quaternion", &quaternions, Marker::Ring, Hue::Ink);
    plot.label((1e-5, 3.0), Side::Right, "Euler’s angles", Hue::Ink)?;
    plot.label((1e-5, 1e-7), Side::Right, "quaternion", Hue::Ink)?;
    Ok(drawing)
}

/// What 48 people counted: their tosses that showed the same face, and all.
fn people_counted() -> Result<Vec<TossCount>, Cause> {
    let rows = include_str!("flips.csv").lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|row| {
        let cells: Vec<u32> = row.split(',').map(str::parse).collect::<Result<_, _>>()?;
        let [heads, heads_same, tails, tails_same] = cells[..] else {
            return Err("four counts in a row".into());
        };
        let same = heads_same + tails_same;
        Ok(TossCount { same, other: heads + tails - same })
    })
    .collect()
}

/// The spread of twist over tumble that fits those counts best.
const FITTED_SPREAD: f64 = 0.0904;

/// Each person's part of tosses with the same face, beside one probability for all and a fitted spread of twists.
pub(crate) fn people(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![sorted_people()?, likely_spreads()?]))
}

/// The people in the order of what they counted.
fn sorted_people() -> Outcome {
    let mut drawing = Drawing::new("", 280.0, 310.0).titled(
        "Forty-eight people, sorted",
        "The part of tosses that showed the same face, for 48 people in ascending order, from 0.488 to 0.601, \
         each a dot with an upright bar of one standard deviation to either side. Ten are below one half, by \
         little more than their bars. Thirty-three follow a flat line, and the last five rise steeply. A \
         dashed level at 0.508 misses both ends by far. A curve, the spread of twists that fits best, begins \
         level at one half and rises ever more steeply to the right, through most bars.",
    );
    let mut people = people_counted()?;
    let share = |counted: &TossCount| f64::from(counted.same) / counted.tosses();
    people.sort_by(|one, other| share(one).total_cmp(&share(other)));
    let rank = Axis::linear(0.0, 48.0, 12.0).minor(4.0).titled("people, sorted");
    let probability = Axis::linear(0.46, 0.62, 0.02).titled("part of tosses with the same face");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 34.0, 224.0, 222.0), rank, probability)?;
    plot.level(0.5, Stroke::Axis);
    let same = f64::from(people.iter().map(|counted| counted.same).sum::<u32>());
    let all: f64 = people.iter().map(TossCount::tosses).sum();
    plot.curve("common", [(0.0, same / all), (48.0, same / all)], Stroke::DashedCurve, Hue::Muted);
    for (n, counted) in people.iter().enumerate() {
        let (p, x) = (share(counted), n as f64 + 0.5);
        let deviation = (p * (1.0 - p) / counted.tosses()).sqrt();
        let [low, high] = [p - deviation, p + deviation].map(|end| plot.at((x, end)));
        plot.drawing().line(low, high, Stroke::Outline, Hue::Ink);
        let place = plot.at((x, p));
        plot.drawing().dot(place, 2.2, Hue::Ink);
    }
    // The people with a twist below s, of either sign, are the part of the bell between −s and s, added up.
    let steps = 2000;
    let width = 4.5 * FITTED_SPREAD / f64::from(steps);
    let (mut below, mut values) = (0.0, Vec::new());
    for n in 0..steps {
        let twist = f64::from(n) * width;
        let p = tossed(1.0, twist)?.same_face_probability();
        if p > 0.62 {
            break;
        }
        values.push((48.0 * below, p));
        let middle = (twist + 0.5 * width) / FITTED_SPREAD;
        below += 2.0 / TAU.sqrt() * (-0.5 * middle * middle).exp() * width / FITTED_SPREAD;
    }
    plot.curve("spread", values, Stroke::Curve, Hue::Ink);
    plot.label((43.5, 0.58), Side::Left, "a bell of twists", Hue::Ink)?;
    plot.label((7.0, 0.517), Side::Over, "one $p$", Hue::Muted)?;
    Ok(drawing)
}

/// The likelihood of the counts against the spread of the twist.
fn likely_spreads() -> Outcome {
    let mut drawing = Drawing::new("", 280.0, 310.0).titled(
        "Likelihood of the spread",
        "The logarithm of the likelihood of what 48 people counted, less its largest value, against the \
         spread of the ratio of twist to tumble over the people. A hill with its top at 0.090, steeper to \
         the left than to the right. It is two below its top at 0.073 and at 0.114, and between these the \
         plot is tinted.",
    );
    let people = people_counted()?;
    let moments = coin()?;
    let of = |spread: f64| {
        Ok::<_, InvalidQuantity>(
            Tossers::new(TossersParameters { moments, mean: 0.0, spread })?.log_likelihood(&people),
        )
    };
    let top = of(FITTED_SPREAD)?;
    let spread = Axis::linear(0.06, 0.14, 0.02).minor(0.01).titled(r"spread $S$ of twist over tumble");
    let likelihood = Axis::linear(-8.0, 0.0, 2.0).minor(1.0).titled("log-likelihood, from its top");
    let mut plot = Plot::new(&mut drawing, Rect::new(40.0, 34.0, 226.0, 222.0), spread, likelihood)?;
    let values: Vec<(f64, f64)> = linear_steps(0.06, 0.14, 80)
        .map(|spread| Ok::<_, InvalidQuantity>((spread, of(spread)? - top)))
        .collect::<Result<_, _>>()?;
    // Where it is two below its top, on the straight line between two values.
    let ends: Vec<f64> = values
        .windows(2)
        .filter(|pair| (pair[0].1 > -2.0) != (pair[1].1 > -2.0))
        .map(|pair| pair[0].0 + (pair[1].0 - pair[0].0) * (-2.0 - pair[0].1) / (pair[1].1 - pair[0].1))
        .collect();
    let [from, to] = ends[..] else { return Err("a hill has two sides".into()) };
    plot.region((from, -8.0), (to, 0.0), Hue::Muted);
    plot.curve("likelihood", values, Stroke::Curve, Hue::Ink);
    plot.level(-2.0, Stroke::Reference);
    plot.label((0.094, -5.0), Side::Over, "95 %", Hue::Ink)?;
    Ok(drawing)
}

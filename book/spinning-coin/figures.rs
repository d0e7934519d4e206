//! The figures of the chapter "The spinning coin"; those of how it ends lie in `figures/`.

#[path = "figures/ending.rs"]
pub(crate) mod ending;
#[path = "figures/reasons.rs"]
pub(crate) mod reasons;

use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Rect, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, linear_steps, log_steps};
use mechanics::InvalidQuantity;
use mechanics::integrate::Taylor;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::spinning_coin::{EulersDisk, Loss, SpinDown, SpinningCoin};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    coin_circle,
    reasons::shorter_arrow,
    one_round,
    paper_cone,
    reasons::book_tips,
    swept_cap,
    reasons::paper_hat,
    spin_down,
    reasons::air_gap,
    reasons::drift_turns,
    circle_opens,
    reasons::lid,
    ending::four_exponents,
    ending::table_holds,
    rim_lamp
];

/// The disc of the text at a tilt.
fn disc(tilt: f64) -> Result<SpinningCoin, InvalidQuantity> {
    let (mass, radius, gravity) = (0.4, 0.0375, 9.81);
    SpinningCoin::new(DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity }, tilt)
}

/// Draws a head on the upper face of a coin that stands with this attitude, with its normal along the body's third
/// axis and the head upright along its second; `thick` is the coin's thickness.
fn draw_head(
    stage: &mut Stage,
    centre: Vector3<f64>,
    attitude: UnitQuaternion<f64>,
    thick: f64,
) -> Result<(), Cause> {
    let on_face = |(u, v): (f64, f64)| centre + attitude * Vector3::new(u, v, 0.5 * thick);
    let profile: Vec<Vector3<f64>> = kit::portrait().into_iter().map(on_face).collect();
    stage.patch(profile.clone(), Fill::Side, Hue::Blue)?;
    let outline = Curve::smooth(profile)?;
    Ok(stage.curve(outline.hiding(Hiding::Omitted), Stroke::Outline, Hue::Blue)?)
}

/// The coin with the circle of its contact.
pub(crate) fn coin_circle(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 340.0).titled(
        "The coin and the circle of its contact",
        "A coin with a head on its face leans on a table, its centre above the middle of a circle drawn on the table. Its lowest point touches the circle and runs along it, as an arrow shows. \
         The angular velocity points from the contact through the centre, along axis 2; Omega points straight up from the centre. The tilt alpha, drawn at the contact, is the angle between the \
         coin and the table, the lean theta that between axis 2 and the upright.",
    );
    let coin = disc(0.5)?;
    let (sin, cos) = coin.tilt().sin_cos();
    let attitude = coin.attitude(0.0);
    let thick = 0.06;
    let centre = Vector3::new(0.0, 0.0, sin);
    let normal = attitude * Vector3::z();
    // From the contact, which lies lowest, to the centre.
    let second = (Vector3::z() - normal * normal.z).normalize();
    let contact = centre - second;
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.5],
        azimuth: -2.55,
        elevation: 0.42,
        distance: 10.0,
        centre: at(200.0, 180.0),
        scale: 96.0,
    })?);
    stage.ground([-1.25, -1.25], [1.25, 1.25], 0.0, 0.25)?;
    stage.curve(Curve::circle([0.0; 3], Vector3::z(), cos)?, Stroke::Outline, Hue::Pink)?;
    let ahead = linear_steps(0.12, 0.75, 40).map(|angle| {
        let (sin, cos) = (angle * coin.turn_rate().signum()).sin_cos();
        Vector3::new(contact.x * cos - contact.y * sin, contact.x * sin + contact.y * cos, 0.0)
    });
    let travel = Curve::smooth(ahead)?.hiding(Hiding::Ignored);
    stage.arrow(travel, Stroke::Vector, Heads::End, Hue::Pink)?;
    stage.solid(Solid::disc(centre, normal, 1.0, thick)?, Hue::Blue)?;
    let upright = attitude * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -0.8);
    draw_head(&mut stage, centre, upright, thick)?;
    let top = centre + normal * (0.5 * thick);
    let axis = Curve::segment(top, top + second * 1.6)?;
    stage.arrow(axis.hiding(Hiding::Ignored), Stroke::Vector, Heads::End, Hue::Orange)?;
    let name = r"$\boldsymbol{\omega}$, axis $\hat{\mathbf{2}}$";
    stage.label_shifted(top + second * 1.6, at(14.0, 0.0), Side::Above, name, Hue::Orange)?;
    let upright = Curve::segment(top, top + Vector3::z() * 1.15)?;
    stage.arrow(upright.hiding(Hiding::Ignored), Stroke::Vector, Heads::End, Hue::Orange)?;
    stage.label(top + Vector3::z() * 1.1, Side::Left, r"$\boldsymbol{\Omega}$", Hue::Orange)?;
    stage.turning(top + Vector3::z() * 0.85, Vector3::z() * coin.turn_rate(), 0.14, Hue::Orange)?;
    let lean = Curve::between(top, Vector3::z(), second, 0.55)?;
    stage.curve(lean.hiding(Hiding::Ignored), Stroke::Outline, Hue::Ink)?;
    let halfway = (Vector3::z() + second).normalize();
    stage.label(top + halfway * 0.62, Side::Over, r"$\theta$", Hue::Ink)?;
    // The tilt, between the line across the table and the one up the coin.
    let level = Vector3::new(second.x, second.y, 0.0).normalize();
    let across = Curve::segment(contact, contact + level * cos)?;
    stage.curve(across.hiding(Hiding::Ignored), Stroke::Reference, Hue::Muted)?;
    let up_the_coin = Curve::segment(contact, centre)?;
    stage.curve(up_the_coin.hiding(Hiding::Ignored), Stroke::Reference, Hue::Muted)?;
    let tilted = Curve::between(contact, level, second, 0.62)?;
    stage.curve(tilted.hiding(Hiding::Ignored), Stroke::Outline, Hue::Ink)?;
    let middle = (level + second).normalize();
    stage.label(contact + middle * 0.78, Side::Over, r"$\alpha$", Hue::Ink)?;
    stage.dot_in_front(contact, 4.5, Hue::Pink)?;
    stage.label_shifted(contact, at(0.0, 10.0), Side::Right, "contact", Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The tilt at which one round is shown, rad.
const SHOWN: f64 = 0.5;

/// The coin at the quarters of one round.
pub(crate) fn one_round(id: &str) -> Outcome {
    Ok(quarters(id, 5)?.with_narrow(quarters("", 3)?))
}

/// Five stills, a quarter of a round apart, in rows of so many.
fn quarters(id: &str, in_a_row: usize) -> Outcome {
    let (wide, high) = (112.0, 132.0);
    let names = ["start", "a quarter", "half", "three quarters", "one round"];
    let rows = names.len().div_ceil(in_a_row);
    let mut drawing = Drawing::new(id, wide * in_a_row as f64 + 10.0, high * rows as f64 + 10.0).titled(
        "The head during one round of the contact",
        "Five stills of the coin from above, at a quarter of a round each. The contact runs once round its circle, counter-clockwise, and is back in the last still. The head, upright in the \
         first, has turned by 44 degrees in the last, the same way.",
    );
    let coin = disc(SHOWN)?;
    let (sin, cos) = coin.tilt().sin_cos();
    let (centre, thick) = (Vector3::new(0.0, 0.0, sin), 0.06);
    for (n, name) in names.into_iter().enumerate() {
        let turns = 0.25 * n as f64;
        let attitude = coin.attitude(turns);
        let normal = attitude * Vector3::z();
        let contact = centre - (Vector3::z() - normal * normal.z).normalize();
        let place = at(wide * ((n % in_a_row) as f64 + 0.5) + 5.0, high * (n / in_a_row) as f64 + 54.0);
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0, 0.0, 0.3],
            azimuth: -FRAC_PI_2,
            elevation: 1.0,
            distance: 9.0,
            centre: place,
            scale: 44.0,
        })?);
        stage.curve(Curve::circle([0.0; 3], Vector3::z(), cos)?, Stroke::Outline, Hue::Pink)?;
        stage.solid(Solid::disc(centre, normal, 1.0, thick)?, Hue::Blue)?;
        draw_head(&mut stage, centre, attitude, thick)?;
        if n == 4 {
            // The way up of the head, then and now: the coin stands as at the start, but for this turn.
            let face = centre + normal * (0.5 * thick);
            let [then, now] = [coin.attitude(0.0), attitude].map(|attitude| attitude * Vector3::y());
            for (way, stroke) in [(then, Stroke::Reference), (now, Stroke::Outline)] {
                let line = Curve::segment(face, face + way * 0.98)?.hiding(Hiding::Ignored);
                stage.curve(line, stroke, Hue::Ink)?;
            }
            let turned = Curve::between(face, then, now, 0.86)?.hiding(Hiding::Ignored);
            stage.arrow(turned, Stroke::Outline, Heads::End, Hue::Ink)?;
        }
        stage.dot_in_front(contact, 4.0, Hue::Pink)?;
        stage.write(&mut drawing);
        drawing.label(place + at(0.0, 62.0), Side::Over, name, Hue::Ink)?;
    }
    Ok(drawing)
}

/// The coin on its paper cone, and the paper laid flat.
pub(crate) fn paper_cone(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![on_the_cone("")?, cone_laid_flat("")?]))
}

/// A tilt at which the cone lacks a quarter of its disc, rad.
fn a_quarter_left_over() -> f64 {
    0.75_f64.acos()
}

fn on_the_cone(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 310.0, 260.0).titled(
        "The coin on a cone of paper",
        "A coin, seen from below its high side, leans on a table. Under it stands a cone with its top at the coin’s centre and its edge on the circle of the contact. They touch along the line from \
         the contact to the centre.",
    );
    let coin = disc(a_quarter_left_over())?;
    let (sin, cos) = coin.tilt().sin_cos();
    let centre = Vector3::new(0.0, 0.0, sin);
    let normal = coin.attitude(0.0) * Vector3::z();
    let second = (Vector3::z() - normal * normal.z).normalize();
    let contact = centre - second;
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.55],
        azimuth: 0.35,
        elevation: 0.16,
        distance: 9.0,
        centre: at(155.0, 130.0),
        scale: 104.0,
    })?);
    stage.ground([-1.0, -1.25], [1.0, 1.25], 0.0, 0.25)?;
    stage.solid(Solid::cone(centre, -Vector3::z(), FRAC_PI_2 - coin.tilt(), 1.0)?, Hue::Muted)?;
    let thick = 0.04;
    stage.solid(Solid::disc(centre + normal * (0.5 * thick + 0.004), normal, 1.0, thick)?, Hue::Blue)?;
    stage.dot_in_front(contact, 4.5, Hue::Pink)?;
    stage.dot_in_front(centre, 3.0, Hue::Ink)?;
    stage.label_shifted(contact, at(-18.0, 4.0), Side::Left, "contact", Hue::Pink)?;
    let side = Vector3::new(0.35 * cos, 0.1, 0.35 * sin);
    stage.label(side, Side::Over, "paper", Hue::Ink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

fn cone_laid_flat(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 300.0, 260.0).titled(
        "The paper of the cone, cut open and laid flat",
        "Three quarters of a disc as large as the coin. The edge of the paper is as long as the circle on the table; the quarter that it lacks is the angle by which the head turns in a round.",
    );
    let coin = disc(a_quarter_left_over())?;
    let left_over = TAU * coin.figure_rate() / coin.turn_rate();
    let (centre, radius, from) = (at(150.0, 130.0), 104.0, 0.25 * TAU - 0.5 * left_over);
    let sector = |from: f64, sweep: f64| {
        let rim =
            linear_steps(0.0, 1.0, 120).map(move |part| centre + Point::polar(radius, from + sweep * part));
        [centre].into_iter().chain(rim).collect::<Vec<Point>>()
    };
    drawing.polygon(sector(from + left_over, TAU - left_over), Fill::Face, Hue::Muted);
    drawing.arc(centre, radius, from + left_over, TAU - left_over, Stroke::Curve, Hue::Pink);
    drawing.polygon(sector(from, left_over), Fill::Ghost, Hue::Muted);
    drawing.arc(centre, radius, from, left_over, Stroke::Reference, Hue::Muted);
    for edge in [from, from + left_over] {
        drawing.line(centre, centre + Point::polar(radius, edge), Stroke::Outline, Hue::Ink);
    }
    kit::angle(&mut drawing, centre, 34.0, from, left_over, Heads::None, Hue::Ink);
    drawing.dot(centre, 3.0, Hue::Ink);
    drawing.label(centre + at(0.0, -66.0), Side::Over, r"$2\pi(1 - \cos\alpha)$", Hue::Ink)?;
    drawing.label_on_face(centre + at(0.0, 48.0), Side::Over, r"edge $2\pi a\cos\alpha$", Hue::Pink)?;
    Ok(drawing)
}

/// The cap of the unit sphere round which the normal of the coin goes, with the head's way up carried along.
pub(crate) fn swept_cap(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 380.0, 340.0).titled(
        "The area that the coin’s normal sweeps",
        "A sphere with a shaded cap about its top, of half-angle alpha. Along the edge of the cap the normal of the coin goes once round. At eight places an arrow on the sphere shows which way \
         the head points; nowhere does it turn about the normal. Back at the start it points another way, turned by the area of the cap.",
    );
    let coin = disc(0.72)?;
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.2],
        azimuth: -FRAC_PI_2,
        elevation: 1.0,
        distance: 8.0,
        centre: at(190.0, 175.0),
        scale: 145.0,
    })?);
    stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Muted)?;
    let normal = |turns: f64| coin.attitude(turns) * Vector3::z();
    let edge: Vec<Vector3<f64>> = linear_steps(0.0, 1.0, 180).map(normal).collect();
    stage.patch(edge.clone(), Fill::Face, Hue::Blue)?;
    stage.curve(Curve::smooth(edge)?, Stroke::Curve, Hue::Blue)?;
    let arrow = |turns: f64| {
        let foot = normal(turns);
        let way = coin.attitude(turns) * Vector3::y();
        let path = linear_steps(0.0, 0.4, 12).map(|part| foot * part.cos() + way * part.sin());
        Curve::smooth(path).map(|path| path.hiding(Hiding::Ignored))
    };
    for n in 1..8 {
        stage.arrow(arrow(f64::from(n) / 8.0)?, Stroke::Outline, Heads::End, Hue::Ink)?;
    }
    stage.arrow(arrow(0.0)?, Stroke::Reference, Heads::End, Hue::Ink)?;
    stage.arrow(arrow(1.0)?, Stroke::Vector, Heads::End, Hue::Ink)?;
    stage.dot_in_front(normal(0.0), 4.0, Hue::Blue)?;
    let top = Vector3::z();
    stage.dot_in_front(top, 2.4, Hue::Muted)?;
    let [then, now] = [0.0, 1.0].map(|turns| coin.attitude(turns) * Vector3::y());
    let angle = Curve::between(normal(0.0), then, now, 0.17)?.hiding(Hiding::Ignored);
    stage.arrow(angle, Stroke::Outline, Heads::End, Hue::Ink)?;
    stage.label_shifted(top, at(0.0, 2.0), Side::Above, r"$2\pi(1 - \cos\alpha)$", Hue::Ink)?;
    stage.label_shifted(normal(0.0), at(0.0, 2.0), Side::Below, r"$\hat{\mathbf{n}}$", Hue::Blue)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The laws of loss that the text compares: the power p, and its name in labels.
const LAWS: [(f64, &str); 4] = [(2.0, "2"), (1.25, "5/4"), (1.0, "1"), (0.5, "1/2")];

/// How the curve of a law is drawn: heavy for the one that was measured.
fn look(power: f64) -> (Stroke, Hue) {
    if power == 1.0 { (Stroke::Heavy, Hue::Ink) } else { (Stroke::Curve, Hue::Muted) }
}

/// The law of loss by which the toy lives for 100 s from a tilt of 0.1.
fn a_long_life(power: f64) -> Result<Loss, InvalidQuantity> {
    let life = SpinDown::new(disc(0.1)?, Loss::new(1.0, power)?)?.life();
    Loss::new(life / 100.0, power)
}

/// The toy on its way down from a tilt of 0.1 by such a law.
fn going_down(power: f64) -> Result<SpinDown, InvalidQuantity> {
    SpinDown::new(disc(0.1)?, a_long_life(power)?)
}

/// The time left, s, and the coin where the fall that a law of loss asks for reaches g.
fn law_ends(power: f64) -> Result<(f64, SpinningCoin), InvalidQuantity> {
    let down = going_down(power)?;
    let left = down.time_left_at_free_fall();
    Ok((left, down.with_time_left(left)?))
}

/// The tilt against time for each law, and against the time that is left.
pub(crate) fn spin_down(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![spin_down_whole("")?, spin_down_end("")?]))
}

fn spin_down_whole(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 290.0, 310.0).titled(
        "The tilt against time for four laws of loss",
        "The tilt from 0.1 rad to zero over about a hundred seconds, for p of 2, 5/4, 1 and 1/2. All four end at 100 s with an upright tangent, the more suddenly the larger p.",
    );
    let time = Axis::linear(0.0, 100.0, 25.0).minor(5.0).titled("time, s");
    let tilt = Axis::linear(0.0, 0.1, 0.02).minor(0.005).titled(r"tilt $\alpha$, rad");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 200.0, 226.0), time, tilt)?;
    for (power, _) in LAWS {
        let down = going_down(power)?;
        let mut values = linear_steps(0.0, 1.0, 400)
            .map(|part| {
                let left = down.life() * (1.0 - part).powi(3);
                let tilt = if left > 0.0 { down.with_time_left(left)?.tilt() } else { 0.0 };
                Ok((down.life() - left, tilt))
            })
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        values.dedup();
        let (stroke, hue) = look(power);
        plot.curve(&format!("law-{power}"), values, stroke, hue);
    }
    plot.label((54.0, 0.079), Side::AboveRight, "$p = 2$", Hue::Muted)?;
    plot.label((64.0, 0.051), Side::BelowLeft, "$p = 1/2$", Hue::Muted)?;
    plot.label((4.0, 0.01), Side::Right, "(a)", Hue::Ink)?;
    Ok(drawing)
}

fn spin_down_end(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 290.0, 310.0).titled(
        "The tilt against the time that is left",
        "Both scales logarithmic: the tilt against the time left, from ten microseconds to 100 s. Four straight lines with the slopes 1/3, 4/9, 1/2 and 2/3. A dot on each marks where the fall would \
         outrun g: for p = 2 at a millisecond and a half, for p = 1/2 at ninety microseconds.",
    );
    let left = Axis::log(1e-5, 100.0, 2).titled("time left, s");
    let tilt = Axis::log(1e-6, 0.1, 1).titled(r"tilt $\alpha$, rad");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 34.0, 196.0, 226.0), left, tilt)?;
    for (power, name) in LAWS {
        let down = going_down(power)?;
        let values = log_steps(1e-5, down.life().min(100.0), 200)
            .map(|left| Ok((left, down.with_time_left(left)?.tilt())))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        let (stroke, hue) = look(power);
        plot.curve(&format!("end-{power}"), values, stroke, hue);
        let (left, coin) = law_ends(power)?;
        plot.markers(&[(left, coin.tilt())], Marker::Disc, Hue::Ink);
        let name = if power == 2.0 { format!("$p = {name}$") } else { format!("${name}$") };
        let side = if power > 1.0 { Side::AboveLeft } else { Side::BelowRight };
        // Of the two lines that lie close, the upper has more room to its left.
        let (place, side) =
            if power == 1.25 { ((3.6e-5, 3.3e-4), Side::Over) } else { ((left, coin.tilt()), side) };
        plot.label(place, side, &name, hue)?;
    }
    plot.label((1.0, 4e-6), Side::Over, "dots: it falls with $g$", Hue::Ink)?;
    plot.label((2e-5, 0.07), Side::Right, "(b)", Hue::Ink)?;
    Ok(drawing)
}

/// The radius of the centre's circle while the disk sinks.
pub(crate) fn circle_opens(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 330.0).titled(
        "The circle of the centre opens and closes",
        "The radius of the centre's circle, in thousandths of the radius of the disk, against the tilt from 0 to 0.1. From zero at 0.1 it grows, as the tilt falls, to 2.1 at a tilt of 0.04, and \
         goes back to zero with the tilt; ten dots on it are ten seconds apart. The motion with its film of air and the law of slow sinking agree.",
    );
    let tilt = Axis::linear(0.0, 0.1, 0.02).minor(0.005).titled(r"tilt $\alpha$, rad");
    let radius = Axis::linear(0.0, 2.5, 0.5).minor(0.1).titled(r"radius of the centre’s circle, in $a/1000$");
    let mut plot = Plot::new(&mut drawing, Rect::new(40.0, 34.0, 325.0, 246.0), tilt, radius)?;
    let disk = EulersDisk::in_air(disc(0.1)?.parameters(), 1.78e-5)?;
    let sinking = disk.sinking(disk.steady(0.1)?, &Taylor::new(1e-12)?)?;
    let times: Vec<f64> = linear_steps(1.0, 0.0, 500).map(|left: f64| 95.36 * (1.0 - left.powi(3))).collect();
    let states = sinking.sample(&times)?;
    // eq:true-spin: b/a = ω₃/Ω, with Ω = ω₂/sin α.
    let centre = |at: &Rolling| (at.tilt, 1e3 * at.omega_3 * at.tilt.sin() / at.omega_2);
    plot.curve("motion", states.iter().map(centre), Stroke::Heavy, Hue::Faint);
    let law = linear_steps(0.0, 1.0, 200)
        .map(|part| 0.1 * part * part)
        .map(|tilt: f64| (tilt, 4e3 / 9.0 * (0.1_f64.powf(1.5) * tilt.sqrt() - tilt * tilt))); // eq:film-circle
    plot.curve("law", law, Stroke::DashedCurve, Hue::Ink);
    let seconds: Vec<f64> = (0..10).map(|n| 10.0 * f64::from(n)).collect();
    let dots: Vec<(f64, f64)> = sinking.sample(&seconds)?.iter().map(centre).collect();
    plot.markers(&dots, Marker::Disc, Hue::Ink);
    plot.label((0.047, 1.35), Side::Over, "sinking", Hue::Muted)?;
    let arrow = [plot.at((0.06, 1.2)), plot.at((0.034, 1.2))];
    kit::dimension(plot.drawing(), arrow[0], arrow[1], Heads::End, Hue::Muted);
    Ok(drawing)
}

/// The light of a lamp on the rim, from above, with the six places where the lamp stops.
pub(crate) fn rim_lamp(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 320.0, 320.0).titled(
        "The light of a lamp on the rim",
        "Seen from above: a closed curve of six arches that bulge out to a circle. Between them are six cusps that point to the middle and lie on a smaller circle. The cusps are numbered in the order \
         in which the lamp comes to them, once round: from 0 every second one is on the table, the others at the top of the coin.",
    );
    let coin = disc(0.75_f64.acos())?;
    let mut plot = Plot::plane(&mut drawing, at(160.0, 160.0), 140.0, 1.1)?;
    let lamp = |rounds: f64| {
        let place = coin.attitude(rounds) * -Vector3::y();
        (place.x, place.y)
    };
    for (name, radius) in
        [("stops", coin.attitude(0.0).transform_vector(&Vector3::y()).xy().norm()), ("rim", 1.0)]
    {
        let circle = linear_steps(0.0, TAU, 180).map(|angle| (radius * angle.cos(), radius * angle.sin()));
        plot.curve(name, circle, Stroke::Dotted, Hue::Muted);
    }
    plot.curve("light", linear_steps(0.0, 4.0, 720).map(lamp), Stroke::Curve, Hue::Ink);
    for (stop, rounds) in linear_steps(0.0, 10.0 / 3.0, 5).enumerate() {
        let (x, y) = lamp(rounds);
        let (form, hue) = if stop % 2 == 0 { (Marker::Disc, Hue::Pink) } else { (Marker::Ring, Hue::Ink) };
        plot.markers(&[(x, y)], form, hue);
        plot.label((0.82 * x, 0.82 * y), Side::Over, &format!("${stop}$"), hue)?;
    }
    Ok(drawing)
}

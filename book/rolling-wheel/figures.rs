//! The figures of the chapter "The rolling wheel".

use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, linear_steps, log_steps};
use mechanics::integrate::Taylor;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    why::wheel_forces,
    why::falling_turns,
    why::steepest_diameter,
    why::shrinking_track,
    wheel_circle,
    rim_and_table,
    turn_rate,
    tongue_tips,
    near_flat_turn,
    potential,
    wobble::contact_track,
    wobble::mirrored_film,
    wobble::two_wells,
    any_wheel::ledge,
    any_wheel::tip_of_shape,
    any_wheel::ways_down,
    why::beyond,
    why::two_points
];

#[path = "figures/any_wheel.rs"]
pub(crate) mod any_wheel;
#[path = "figures/why.rs"]
pub(crate) mod why;
#[path = "figures/wobble.rs"]
pub(crate) mod wobble;

/// A wheel of mass, radius and gravity one.
fn wheel(moments: MomentFactors) -> Result<Wheel, Cause> {
    Ok(Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 })?)
}

/// Axes 1, 2, 3 of a wheel that leans by an angle, with y outward and z up (`eq:wheel-axes`).
fn axes(lean: f64) -> [Vector3<f64>; 3] {
    let (sin, cos) = lean.sin_cos();
    [Vector3::x(), Vector3::new(0.0, -sin, cos), Vector3::new(0.0, -cos, -sin)]
}

/// Where a disc of radius one stands: its foot, its centre, and its axes 2 and 3.
fn placed(state: &Rolling) -> [Vector3<f64>; 4] {
    let (foot, turn) =
        (state.contact(1.0), UnitQuaternion::from_axis_angle(&Vector3::z_axis(), state.heading));
    let [_, second, third] = axes(state.lean()).map(|axis| turn * axis);
    let foot = Vector3::new(foot.re, foot.im, 0.0);
    [foot, foot + second, second, third]
}

/// The wheel on its circle, with axes and lengths.
pub(crate) fn wheel_circle(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 380.0).titled(
        "The wheel on its circle",
        "A table with a circle, and a wheel that stands on it and leans inward by theta. Above the table a smaller dashed circle is the path of the centre, of radius b; the \
         upright axis through both carries Omega. At the centre of the wheel the axis 1 is level, against the travel, 2 runs up the plane of the \
         wheel, and 3, the axle, inward and down. The whole angular velocity omega points between 2 and 3. A dot marks the contact, which travels counter-clockwise as \
         an arrow on the circle shows.",
    );
    let (lean, b) = (0.42_f64, 1.35);
    let steady = wheel(MomentFactors::HOOP)?.steady(lean, b)?;
    // Outward along y; the centre at b, one radius above the contact along axis 2.
    let cos = lean.cos();
    let centre = Vector3::new(0.0, b, cos);
    let axes = axes(lean);
    let contact = centre - axes[1];
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.1, 0.6],
        azimuth: -0.6,
        elevation: 0.4,
        distance: 12.0,
        centre: at(190.0, 200.0),
        scale: 92.0,
    })?);
    stage.curve(Curve::circle([0.0; 3], Vector3::z(), contact.y)?, Stroke::Outline, Hue::Pink)?;
    // The contact goes with Ω: the travel, ahead of it on the circle.
    let ahead = linear_steps(0.75, 1.25, 40).map(|angle| {
        let turned = angle * steady.turn_rate().signum();
        Vector3::new(-contact.y * turned.sin(), contact.y * turned.cos(), 0.0)
    });
    let travel = Curve::smooth(ahead)?.hiding(Hiding::Ignored);
    stage.arrow(travel, Stroke::Vector, Heads::End, Hue::Pink)?;
    let path = Curve::circle([0.0, 0.0, cos], Vector3::z(), b)?;
    stage.curve(path.hiding(Hiding::Dashed), Stroke::Reference, Hue::Muted)?;
    stage.curve(Curve::segment([0.0; 3], [0.0, 0.0, 1.9])?, Stroke::Dotted, Hue::Muted)?;
    stage.vector([0.0, 0.0, 1.9], [0.0, 0.0, 2.5], Hue::Orange)?;
    stage.label([0.0, 0.0, 2.45], Side::Right, r"$\boldsymbol{\Omega}$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 2.12], [0.0, 0.0, steady.turn_rate()], 0.2, Hue::Orange)?;
    stage.solid(Solid::ring(centre, axes[2], 1.0, 0.9, 0.1)?, Hue::Blue)?;
    for (axis, length, name) in [
        (axes[0], 1.3, r"$\hat{\mathbf{1}}$"),
        (axes[1], 1.45, r"$\hat{\mathbf{2}}$"),
        (axes[2], 1.65, r"$\hat{\mathbf{3}}$"),
    ] {
        stage.named_vector(centre, centre + axis * length, name, Hue::Ink)?;
    }
    let omega = steady.omega();
    let whole = axes[0] * omega.x + axes[1] * omega.y + axes[2] * omega.z;
    let tip = centre + whole.normalize() * 1.55;
    let arrow = Curve::segment(centre, tip)?.hiding(Hiding::Ignored);
    stage.arrow(arrow, Stroke::Vector, Heads::End, Hue::Orange)?;
    stage.label(tip, Side::Left, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    let upright = Curve::segment(contact + Vector3::z() * 1.3, contact + Vector3::z() * 2.4)?;
    stage.curve(upright.hiding(Hiding::Omitted), Stroke::Reference, Hue::Muted)?;
    stage.angle(contact, Vector3::z(), axes[1], 2.25, r"$\theta$", Hue::Ink)?;
    stage.curve(Curve::segment(centre, contact)?, Stroke::Outline, Hue::Muted)?;
    stage.label(centre - axes[1] * 0.48, Side::Left, "$a$", Hue::Ink)?;
    // To the left on the page, where it is clear of the wheel.
    let end = Vector3::new(-0.565 * b, -0.825 * b, cos);
    stage.curve(Curve::segment([0.0, 0.0, cos], end)?, Stroke::Outline, Hue::Muted)?;
    stage.label([0.72 * end.x, 0.72 * end.y, cos], Side::Above, "$b$", Hue::Ink)?;
    let radius = Curve::segment([0.0; 3], contact)?;
    stage.curve(radius.hiding(Hiding::Ignored), Stroke::Outline, Hue::Muted)?;
    stage.label([0.0, 0.7, 0.0], Side::Below, "$r$", Hue::Ink)?;
    stage.dot_in_front(contact, 4.5, Hue::Pink)?;
    stage.label_shifted(contact, at(40.0, 18.0), Side::Right, "contact", Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// A wheel with marks of ink on its rim, and their prints on the table.
pub(crate) fn rim_and_table(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 340.0).titled(
        "Along the table as along the rim",
        "A wheel on its circle, with seven marks of ink at equal distances along its rim. The first is at the contact, the others follow up the side that has just rolled. Their prints \
         on the table lie at the same distances along the circle, behind the contact. The stretch on the rim and the one on the table are drawn heavy.",
    );
    let (lean, b, marks, apart) = (0.42_f64, 1.7, 6, 0.45);
    let steady = wheel(MomentFactors::HOOP)?.steady(lean, b)?;
    let [first, second, third] = axes(lean);
    let centre = Vector3::new(0.0, b, lean.cos());
    let mut stage = Stage::new(Camera::new(View {
        target: [0.6, 0.8, 0.5],
        azimuth: 1.0,
        elevation: 0.4,
        distance: 12.0,
        centre: at(195.0, 180.0),
        scale: 84.0,
    })?);
    let contact_radius = steady.contact_radius();
    stage.solid(Solid::ring(centre, third, 1.0, 0.9, 0.1)?, Hue::Blue)?;
    // What touched the table a time ago: on the table it lies back by Ωt, on the rim by ω_rel t.
    let printed = |ago: f64| {
        let back = -steady.turn_rate() * ago;
        Vector3::new(-back.sin(), back.cos(), 0.0) * contact_radius
    };
    let on_rim = |ago: f64| {
        let back = steady.relative_spin() * ago;
        centre - second * back.cos() + first * back.sin()
    };
    let ago = |length: f64| length / steady.relative_spin(); // in radii along the rim
    let circle = Curve::smooth(linear_steps(ago(-1.5), ago(3.3), 120).map(printed))?;
    stage.curve(circle, Stroke::Outline, Hue::Pink)?;
    let far = ago(f64::from(marks) * apart);
    for line in [
        Curve::smooth(linear_steps(0.0, far, 120).map(printed))?,
        Curve::smooth(linear_steps(0.0, far, 120).map(on_rim))?,
    ] {
        stage.curve(line.hiding(Hiding::Ignored), Stroke::Curve, Hue::Pink)?;
    }
    for mark in 0..=marks {
        let time = ago(f64::from(mark) * apart);
        for place in [printed(time), on_rim(time)] {
            stage.dot_in_front(place, 3.4, Hue::Pink)?;
        }
        if mark > 0 {
            let name = format!("${mark}$");
            stage.label_shifted(printed(time), at(0.0, 1.0), Side::Below, &name, Hue::Pink)?;
        }
        if mark > 0 {
            let inward = (on_rim(time) - centre) * 0.74 + centre;
            stage.label(inward, Side::Over, &format!("${mark}$"), Hue::Pink)?;
        }
    }
    let ahead = linear_steps(-ago(0.3), -ago(1.4), 40).map(printed);
    stage.arrow(Curve::smooth(ahead)?.hiding(Hiding::Ignored), Stroke::Vector, Heads::End, Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The leans that the plots compare, degrees.
const LEANS: [f64; 3] = [20.0, 45.0, 70.0];

/// One over the square of the turn rate against the radius of the centre's circle.
pub(crate) fn turn_rate(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 330.0).titled(
        "Steady rolling against the radius of the circle",
        "One over the square of the turn rate, in a over g, against b over a from minus 0.2 to 0.8, for a disc leaning by 20, 45 and 70 degrees: three straight lines. Each begins on the abscissa, at a dot, its own \
         bound, at a small negative b; the larger the lean, the farther to the left it begins and the less steeply it rises.",
    );
    let b = Axis::linear(-0.2, 0.8, 0.2).minor(0.05).titled("radius of the centre’s circle $b/a$");
    let slowness = Axis::linear(0.0, 4.0, 1.0).minor(0.2).titled(r"$1/\Omega^2$, in $a/g$");
    let mut plot = Plot::new(&mut drawing, Rect::new(36.0, 34.0, 300.0, 246.0), b, slowness)?;
    plot.upright(0.0, Stroke::Dotted);
    let disc = wheel(MomentFactors::DISK)?;
    let mut bounds = Vec::new();
    for (degrees, hue) in LEANS.into_iter().zip([Hue::Faint, Hue::Muted, Hue::Ink]) {
        let lean = f64::to_radians(degrees);
        let bound = -0.5 * lean.sin() / 3.0; // eq:existence
        let values = linear_steps(bound + 1e-6, 0.8, 40)
            .map(|b| Ok((b, disc.steady(lean, b)?.turn_rate().powi(-2))))
            .collect::<Result<Vec<_>, Cause>>()?;
        let end = values[values.len() - 1];
        plot.curve(&format!("lean-{degrees}"), values, Stroke::Curve, hue);
        plot.label(
            end,
            Side::Right,
            &format!("${degrees}°$"),
            if degrees > 60.0 { Hue::Ink } else { Hue::Muted },
        )?;
        bounds.push((bound, 0.0));
    }
    plot.markers(&bounds, Marker::Disc, Hue::Ink);
    plot.label((0.8, 3.85), Side::Right, "lean", Hue::Muted)?;
    Ok(drawing)
}

/// The edge of the tongue of unstable motions, as radius and lean in degrees, from near the upright up to the tip and
/// down again.
fn edge(wheel: &Wheel) -> Result<Vec<(f64, f64)>, Cause> {
    let tip = wheel.safe_lean();
    let (mut inner, mut outer) = (Vec::new(), Vec::new());
    // Closer together towards the upright and towards the tip, where the edges meet.
    let leans = linear_steps(0.0, 1.0, 400).skip(1).map(|part| tip * (1.0 - (1.0 - part * part).powi(2)));
    for lean in leans {
        if let Some([small, large]) = wheel.unstable_circles(lean)? {
            inner.push((small, lean.to_degrees()));
            outer.push((large, lean.to_degrees()));
        }
    }
    Ok(inner.into_iter().chain(outer.into_iter().rev()).collect())
}

/// Draws the tongue of unstable motions over a map of circles and leans, with its edge: a tint of ink and a border, wherever it is drawn.
fn draw_tongue(plot: &mut Plot<'_>, edge: Vec<(f64, f64)>, [from, to]: [f64; 2]) {
    let edge: Vec<_> = edge.into_iter().filter(|(b, _)| (from..=to).contains(b)).collect();
    let corners = edge.iter().chain(&[(to, 0.0), (from, 0.0)]).map(|&corner| plot.at(corner)).collect();
    plot.drawing().polygon(corners, Fill::Ground, Hue::Ink);
    plot.curve("disc", edge, Stroke::Border, Hue::Ink);
}

/// Wheels whose tongues are compared: name, label and its place, moments, stroke and hue.
type Compared = (&'static str, (f64, f64), MomentFactors, Stroke, Hue);
const COMPARED: [Compared; 3] = [
    ("hoop", (0.11, 20.3), MomentFactors::HOOP, Stroke::Orbit, Hue::Muted),
    ("weights", (16.0, 25.4), MomentFactors { transverse: 2.0, axial: 0.5 }, Stroke::Curve, Hue::Muted),
    ("beads", (90.0, 38.0), MomentFactors { transverse: 0.1, axial: 0.002 }, Stroke::Curve, Hue::Ink),
];

/// The tongues of four wheels, over six decades of the circle's radius.
pub(crate) fn tongue_tips(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 350.0).titled(
        "The tongues of four wheels",
        "The lean, from 0 to 50 degrees, against the radius of the centre’s circle over a, from 0.01 to 10000 on a logarithmic scale. Four curves rise to a rounded tip and come down again; \
         below each its wheel is unstable. The tips of hoop and disc are near 19 degrees at half a radius, that of a disc with weights on its axle is at 25.8 degrees, that of two beads on \
         an axle at 40.5 degrees and six radii. Dashed lines at 17.6 and 45 degrees bound all tips.",
    );
    let b = Axis::log(0.01, 1e4, 1).titled("radius of the centre’s circle $b/a$");
    let lean = Axis::linear(0.0, 50.0, 10.0).minor(5.0).titled(r"lean $\theta$, degrees");
    let mut plot = Plot::new(&mut drawing, Rect::new(40.0, 34.0, 325.0, 262.0), b, lean)?;
    draw_tongue(&mut plot, edge(&wheel(MomentFactors::DISK)?)?, [0.01, 1e4]);
    plot.label((0.57, 12.5), Side::Over, "disc", Hue::Ink)?;
    for (name, place, moments, stroke, hue) in COMPARED {
        let boundary = edge(&wheel(moments)?)?;
        plot.curve(name, boundary.into_iter().filter(|(b, _)| (0.01..=1e4).contains(b)), stroke, hue);
        plot.label(place, Side::Over, name, hue)?;
    }
    let least = ((3.0 - 6_f64.sqrt()) / 6.0).sqrt().asin().to_degrees(); // eq:safe-lean of a point
    for bound in [least, 45.0] {
        plot.level(bound, Stroke::Reference);
    }
    plot.label((2500.0, 45.0), Side::AboveRight, "$45°$", Hue::Muted)?;
    plot.label((1500.0, least), Side::AboveRight, "$17.6°$", Hue::Muted)?;
    plot.label((1.0, 5.0), Side::Over, "unstable", Hue::Ink)?;
    Ok(drawing)
}

/// How far the contact runs round while a wheel that is let go almost flat falls and gets up again.
pub(crate) fn near_flat_turn(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 320.0).titled(
        "How far the contact runs round",
        "The angle in degrees, from 270 to 500, against the turn at the start over that of steady rolling, from a ten-thousandth to one on a logarithmic scale. For the disc it rises \
         from the level of 402.5 degrees to 465 degrees, for the hoop from 311.8 to 360; below a hundredth both curves lie on their levels. A dotted line marks 360 degrees.",
    );
    let part = Axis::log(1e-4, 1.0, 1).titled("turn at the start, in that of steady rolling");
    let angle = Axis::linear(270.0, 500.0, 50.0).minor(10.0).titled("angle of the contact, degrees");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 320.0, 236.0), part, angle)?;
    plot.level(360.0, Stroke::Dotted);
    let tilt = 0.05;
    for (moments, name, hue, place) in
        [(MomentFactors::DISK, "disc", Hue::Ink, 415.0), (MomentFactors::HOOP, "hoop", Hue::Muted, 324.0)]
    {
        let wheel = wheel(moments)?;
        let steady = wheel.steady(FRAC_PI_2 - tilt, 0.0)?.state().omega_2;
        plot.level(wheel.near_flat_turn().to_degrees(), Stroke::Reference);
        let solver = Taylor::new(1e-15)?;
        let values = log_steps(1e-4, 0.999, 160)
            .map(|part| {
                let start = Rolling { tilt, omega_2: part * steady, ..Rolling::UPRIGHT };
                Ok((part, wheel.wobble(start, &solver)?.heading_advance().to_degrees()))
            })
            .collect::<Result<Vec<_>, Cause>>()?;
        plot.curve(name, values, Stroke::Curve, hue);
        plot.label((3e-4, place), Side::Over, name, hue)?;
    }
    plot.label((0.012, 364.0), Side::AboveRight, "once round", Hue::Muted)?;
    Ok(drawing)
}

/// The motion of the text: a disc at a lean of 0.3 with q = 0.45 and n = 0.9.
const WOBBLING: Rolling = Rolling { tilt: FRAC_PI_2 - 0.3, omega_2: 0.45, omega_3: 0.9, ..Rolling::UPRIGHT };

/// The effective potential with the energy of one motion.
pub(crate) fn potential(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 330.0).titled(
        "The effective potential of a disc",
        "The potential, in m g a, against the lean from minus 30 to 40 degrees: a well with its bottom near 5 degrees. A level line at the energy 1.588 cuts it at minus 7.6 and at 17.2 degrees, \
         marked by dots.",
    );
    let disc = wheel(MomentFactors::DISK)?;
    let (constants, energy) = (disc.constants(&WOBBLING), disc.energy(&WOBBLING));
    let lean = Axis::linear(-30.0, 40.0, 10.0).minor(2.0).titled(r"lean $\theta$, degrees");
    let height = Axis::linear(1.54, 1.66, 0.02).titled(r"potential $V$, in $mga$");
    let mut plot = Plot::new(&mut drawing, Rect::new(46.0, 34.0, 320.0, 246.0), lean, height)?;
    plot.level(energy, Stroke::Reference);
    let values = linear_steps(-30.0, 40.0, 400)
        .map(|degrees| (degrees, disc.potential(&constants, FRAC_PI_2 - degrees.to_radians())));
    plot.curve("potential", values, Stroke::Heavy, Hue::Ink);
    let wobble = disc.wobble(WOBBLING, &Taylor::new(1e-12)?)?;
    let other = wobble.at(0.5 * wobble.period())?;
    let marks = [WOBBLING, other].map(|state| (state.lean().to_degrees(), energy));
    let ends = marks.map(|(lean, energy)| plot.at((lean, energy + 0.012)));
    kit::dimension(plot.drawing(), ends[0], ends[1], Heads::Both, Hue::Ink);
    plot.label((4.8, energy + 0.012), Side::Above, "the lean swings", Hue::Ink)?;
    plot.markers(&marks[1..], Marker::Disc, Hue::Ink);
    plot.label((24.0, energy), Side::AboveRight, "energy $E$", Hue::Muted)?;
    plot.label((-15.0, 1.65), Side::Right, r"$V(\theta)$", Hue::Ink)?;
    // The marble, as it rests on the curve at its farthest.
    let slope = plot.at((17.2, energy))
        - plot.at((15.2, disc.potential(&constants, FRAC_PI_2 - 15.2_f64.to_radians())));
    let place = plot.at(marks[0]) + slope.quarter_turned() * (6.5 / slope.length());
    plot.drawing().disc(place, 5.5, Hue::Blue);
    Ok(drawing)
}

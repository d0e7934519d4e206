//! The figures of the chapter "The rolling wheel".

use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Rect, Role, Shape, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, linear_steps, log_steps};
use mechanics::integrate::Taylor;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    wheel_circle,
    wheel_forces,
    rim_and_table,
    turn_rate,
    tongue,
    tongue_tips,
    near_flat_turn,
    potential,
    contact_track,
    any_wheel::tip_of_shape,
    any_wheel::ways_down
];

#[path = "figures/any_wheel.rs"]
pub(crate) mod any_wheel;

/// A wheel of mass, radius and gravity one.
fn wheel(moments: MomentFactors) -> Result<Wheel, Cause> {
    Ok(Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 })?)
}

/// Axes 1, 2, 3 of a wheel that leans by an angle, with y outward and z up (`eq:wheel-axes`).
fn axes(lean: f64) -> [Vector3<f64>; 3] {
    let (sin, cos) = lean.sin_cos();
    [Vector3::x(), Vector3::new(0.0, -sin, cos), Vector3::new(0.0, -cos, -sin)]
}

/// The wheel on its circle, with axes and lengths.
pub(crate) fn wheel_circle(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 340.0).titled(
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
        elevation: 0.36,
        distance: 12.0,
        centre: at(190.0, 190.0),
        scale: 68.0,
    })?);
    stage.ground([-2.0, -2.0], [2.0, 2.0], 0.0, 0.4)?;
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
    stage.label(centre - axes[1] * 0.68, Side::Right, "$a$", Hue::Ink)?;
    // To the left on the page, where it is clear of the wheel.
    let end = Vector3::new(-0.565 * b, -0.825 * b, cos);
    stage.curve(Curve::segment([0.0, 0.0, cos], end)?, Stroke::Outline, Hue::Muted)?;
    stage.label([0.72 * end.x, 0.72 * end.y, cos], Side::Above, "$b$", Hue::Ink)?;
    let radius = Curve::segment([0.0; 3], contact)?;
    stage.curve(radius.hiding(Hiding::Ignored), Stroke::Outline, Hue::Muted)?;
    stage.label([0.0, 0.7, 0.0], Side::Below, "$r$", Hue::Ink)?;
    stage.dot_in_front(contact, 4.5, Hue::Pink)?;
    stage.label_shifted(contact, at(32.0, 16.0), Side::Right, "contact", Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The lean, and the radius of the centre's circle in radii, of the disc whose forces are drawn.
const PUSHED: (f64, f64) = (0.55, 1.2);

/// The forces on the wheel, and what their torque does to the angular momentum.
pub(crate) fn wheel_forces(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![forces("")?, momentum_turned("")?]))
}

/// The wheel seen from behind, with weight, support and friction.
fn forces(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 320.0, 330.0).titled(
        "The forces on the wheel",
        "The wheel edge on, seen from behind, leans to the left, towards the axis of its circle. At the centre the weight points down. At the contact the table supports it with an arrow as \
         long, upwards, and friction points to the left, towards the axis. The torque about the centre comes out of the page.",
    );
    let (lean, b) = PUSHED;
    let steady = wheel(MomentFactors::DISK)?.steady(lean, b)?;
    let (sin, cos) = lean.sin_cos();
    // The page holds y to the right and z up, so that axis 1 comes out of it: one travels into the page.
    let (contact, radius) = (at(205.0, 262.0), 118.0);
    let up = at(-sin, -cos);
    let (centre, top) = (contact + up * radius, contact + up * (2.0 * radius));
    drawing.line(at(40.0, contact.y), at(300.0, contact.y), Stroke::Axis, Hue::Ink);
    let across = up.quarter_turned() * 4.0;
    let corners = vec![contact + across, contact - across, top - across, top + across];
    drawing.polygon(corners.clone(), Fill::Face, Hue::Blue);
    drawing.push(Role::Line(Stroke::Outline, Hue::Blue), Shape::Polygon(corners));
    drawing.line(contact, contact - at(0.0, 190.0), Stroke::Reference, Hue::Muted);
    kit::angle(&mut drawing, contact, 172.0, FRAC_PI_2, lean, Heads::None, Hue::Ink);
    let middle = contact + Point::polar(172.0, FRAC_PI_2 + 0.5 * lean);
    drawing.label(middle, Side::Above, "lean", Hue::Ink)?;
    let weight = 92.0;
    let friction = weight * steady.friction_needed();
    kit::arrow(&mut drawing, centre, centre + at(0.0, weight), Hue::Purple);
    drawing.label(centre + at(0.0, weight - 6.0), Side::Left, "weight", Hue::Purple)?;
    kit::arrow(&mut drawing, contact, contact - at(0.0, weight), Hue::Purple);
    drawing.label(contact - at(-2.0, weight - 8.0), Side::Right, "support", Hue::Purple)?;
    kit::arrow(&mut drawing, contact, contact - at(friction, 0.0), Hue::Purple);
    drawing.label(contact + at(-0.5 * friction, 4.0), Side::Below, "friction", Hue::Purple)?;
    let mark = if steady.torque() > 0.0 { Marker::Out } else { Marker::Into };
    kit::marker(&mut drawing, centre, mark, Hue::Purple);
    drawing.label(centre + at(-4.0, 8.0), Side::Left, r"$\boldsymbol{\tau}$", Hue::Purple)?;
    drawing.dot(contact, 4.5, Hue::Pink);
    let axis = at(36.0, contact.y);
    drawing.label(axis + at(4.0, 14.0), Side::Right, "to the axis", Hue::Muted)?;
    kit::head(&mut drawing, axis, at(-1.0, 0.0), 0.8, Hue::Muted);
    Ok(drawing)
}

/// The angular momentum of the wheel, and the torque that turns it about the upright.
fn momentum_turned(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 320.0, 330.0).titled(
        "What the torque does",
        "The wheel in perspective. From its centre the angular momentum points inward and up, and its tip goes round the upright on a level circle. At the tip a small piece, torque times dt, points \
         along that circle, in the sense of Omega.",
    );
    let (lean, b) = PUSHED;
    let steady = wheel(MomentFactors::DISK)?.steady(lean, b)?;
    let axes = axes(lean);
    let momentum = {
        let found = steady.angular_momentum();
        axes[0] * found.x + axes[1] * found.y + axes[2] * found.z
    };
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.2],
        azimuth: 0.6,
        elevation: 0.42,
        distance: 10.0,
        centre: at(205.0, 165.0),
        scale: 80.0,
    })?);
    stage.solid(Solid::disc([0.0; 3], axes[2], 1.0, 0.07)?, Hue::Blue)?;
    let long = 1.25 / momentum.norm();
    let tip = momentum * long;
    let level = Vector3::new(tip.x, tip.y, 0.0).norm();
    let upright = Curve::segment([0.0; 3], [0.0, 0.0, 1.55])?.hiding(Hiding::Ignored);
    stage.arrow(upright, Stroke::Vector, Heads::End, Hue::Orange)?;
    stage.label([0.0, 0.0, 1.5], Side::Right, r"$\boldsymbol{\Omega}$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 1.25], Vector3::z() * steady.turn_rate(), 0.16, Hue::Orange)?;
    let round = Curve::circle([0.0, 0.0, tip.z], Vector3::z(), level)?;
    stage.curve(round.hiding(Hiding::Dashed), Stroke::Reference, Hue::Green)?;
    let arrow = Curve::segment([0.0; 3], tip)?.hiding(Hiding::Ignored);
    stage.arrow(arrow, Stroke::Vector, Heads::End, Hue::Green)?;
    stage.label(tip * 0.5, Side::Below, r"$\boldsymbol{L}$", Hue::Green)?;
    // The torque is along axis 1; drawn at the tip of L, which it moves.
    let push = axes[0] * (0.75 * steady.torque().signum());
    let torque = Curve::segment(tip, tip + push)?.hiding(Hiding::Ignored);
    stage.arrow(torque, Stroke::Vector, Heads::End, Hue::Purple)?;
    let name = r"$\boldsymbol{\tau}\,dt$";
    stage.label_shifted(tip + push, at(4.0, 4.0), Side::Left, name, Hue::Purple)?;
    let contact = -axes[1];
    stage.dot_in_front(contact, 4.5, Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// A wheel with marks of ink on its rim, and their prints on the table.
pub(crate) fn rim_and_table(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 320.0).titled(
        "Along the table as along the rim",
        "A wheel on its circle, with seven marks of ink at equal distances along its rim. The first is at the contact, the others follow up the side that has just rolled. Their prints \
         on the table lie at the same distances along the circle, behind the contact. The stretch on the rim and the one on the table are drawn heavy.",
    );
    let (lean, b, marks, apart) = (0.42_f64, 1.7, 6, 0.45);
    let steady = wheel(MomentFactors::HOOP)?.steady(lean, b)?;
    let [first, second, third] = axes(lean);
    let centre = Vector3::new(0.0, b, lean.cos());
    let mut stage = Stage::new(Camera::new(View {
        target: [0.6, 0.4, 0.4],
        azimuth: 0.75,
        elevation: 0.36,
        distance: 12.0,
        centre: at(200.0, 170.0),
        scale: 65.0,
    })?);
    stage.ground([-1.5, -1.0], [2.75, 2.75], 0.0, 0.25)?;
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
    let circle = Curve::smooth(linear_steps(ago(-2.0), ago(4.3), 120).map(printed))?;
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
        if mark > 1 {
            let outward = (on_rim(time) - centre) * 1.2 + centre;
            stage.label(outward, Side::Over, &format!("${mark}$"), Hue::Pink)?;
        }
    }
    let ahead = linear_steps(-ago(0.3), -ago(1.4), 40).map(printed);
    stage.arrow(Curve::smooth(ahead)?.hiding(Hiding::Ignored), Stroke::Vector, Heads::End, Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The leans that the plots compare, degrees.
const LEANS: [f64; 3] = [20.0, 45.0, 70.0];

/// Turn rate against the radius of the centre's circle.
pub(crate) fn turn_rate(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 330.0).titled(
        "Rate of steady rolling against the radius of the circle",
        "The square of the turn rate, in g over a, against b over a from minus 0.2 to 0.8, for a disc leaning by 20, 45 and 70 degrees. Each curve falls from infinity at its own \
         bound, a small negative b marked by a dotted line of the same hue, towards zero. Where b is positive the larger lean has the larger rate; left of zero the curves cross.",
    );
    let b = Axis::linear(-0.2, 0.8, 0.2).minor(0.05).titled("radius of the centre’s circle $b/a$");
    let rate = Axis::linear(0.0, 20.0, 5.0).minor(1.0).titled(r"$\Omega^2$, in $g/a$");
    let mut plot = Plot::new(&mut drawing, Rect::new(36.0, 34.0, 330.0, 246.0), b, rate)?;
    let disc = wheel(MomentFactors::DISK)?;
    for degrees in LEANS {
        let lean = f64::to_radians(degrees);
        let bound = -0.5 * lean.sin() / 3.0; // eq:existence
        let values = linear_steps(0.0, 1.0, 600)
            .map(|part| bound + 1e-3 + (0.8 - bound - 1e-3) * part * part)
            .map(|b| Ok((b, disc.steady(lean, b)?.turn_rate().powi(2))))
            .collect::<Result<Vec<_>, Cause>>()?;
        let ends = [plot.at((bound, 0.0)), plot.at((bound, 20.0))];
        plot.drawing().line(ends[0], ends[1], Stroke::Dotted, Hue::Orange);
        plot.curve(&format!("lean-{degrees}"), values, Stroke::Curve, Hue::Orange);
    }
    plot.label((0.25, 6.2), Side::AboveRight, r"$\theta = 70°$", Hue::Orange)?;
    plot.label((0.2, 2.3), Side::AboveRight, "$45°$", Hue::Orange)?;
    plot.label((0.02, 0.9), Side::Over, "$20°$", Hue::Orange)?;
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

/// The boundary of instability in the plane of radius and lean.
pub(crate) fn tongue(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 330.0).titled(
        "Where steady rolling is unstable",
        "The lean in degrees, from 0 to 25, against b over a from 0 to 4, with a curve for a hoop and one for a disc; below each the motion is unstable, and the region below the disc’s is shaded. Each rises from zero steeply to a tip near \
         19 degrees at small b, and comes down along a falling curve towards large b.",
    );
    let b = Axis::linear(0.0, 4.0, 1.0).minor(0.2).titled("radius of the centre’s circle $b/a$");
    let lean = Axis::linear(0.0, 25.0, 5.0).minor(1.0).titled(r"lean $\theta$, degrees");
    let mut plot = Plot::new(&mut drawing, Rect::new(40.0, 34.0, 325.0, 246.0), b, lean)?;
    for (moments, name, hue, place) in [
        (MomentFactors::DISK, "disc", Hue::Blue, (0.85, 15.2)),
        (MomentFactors::HOOP, "hoop", Hue::Ink, (0.62, 20.9)),
    ] {
        let wheel = wheel(moments)?;
        let boundary = edge(&wheel)?;
        let boundary: Vec<_> = boundary.into_iter().filter(|&(b, _)| b <= 4.0).collect();
        if name == "disc" {
            let corners = [(0.0, 0.0)].iter().chain(&boundary).chain(&[(4.0, 0.0)]);
            let corners = corners.map(|&corner| plot.at(corner)).collect();
            plot.drawing().polygon(corners, Fill::Ground, hue);
        }
        plot.curve(name, boundary, Stroke::Curve, hue);
        plot.label(place, Side::Over, name, hue)?;
    }
    plot.label((2.6, 17.0), Side::Over, "stable", Hue::Ink)?;
    plot.label((1.5, 5.0), Side::Over, "unstable", Hue::Ink)?;
    Ok(drawing)
}

/// Wheels whose tongues are compared: name, label and its place, moments, hue.
type Compared = (&'static str, &'static str, (f64, f64), MomentFactors, Hue);
const COMPARED: [Compared; 4] = [
    ("disc", "disc", (0.57, 12.5), MomentFactors::DISK, Hue::Blue),
    ("hoop", "hoop", (0.11, 20.3), MomentFactors::HOOP, Hue::Ink),
    ("weights", "weights", (16.0, 25.4), MomentFactors { transverse: 2.0, axial: 0.5 }, Hue::Purple),
    ("beads", "beads", (90.0, 38.0), MomentFactors { transverse: 0.1, axial: 0.002 }, Hue::Green),
];

/// The tongues of four wheels, over seven decades of the circle's radius.
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
    for (name, label, place, moments, hue) in COMPARED {
        let wheel = wheel(moments)?;
        let within = |&(b, _): &(f64, f64)| (0.01..=1e4).contains(&b);
        let boundary: Vec<_> = edge(&wheel)?.into_iter().filter(within).collect();
        if name == "disc" {
            let corners = boundary.iter().map(|&corner| plot.at(corner));
            let ends = [plot.at((1e4, 0.0)), plot.at((0.01, 0.0))];
            let corners = corners.chain(ends).collect();
            plot.drawing().polygon(corners, Fill::Ground, hue);
        }
        let tip = boundary.iter().copied().fold((0.0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
        plot.curve(name, boundary, Stroke::Curve, hue);
        plot.markers(&[tip], Marker::Disc, hue);
        plot.label(place, Side::Over, label, hue)?;
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
        [(MomentFactors::DISK, "disc", Hue::Blue, 415.0), (MomentFactors::HOOP, "hoop", Hue::Ink, 324.0)]
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
    plot.curve("potential", values, Stroke::Curve, Hue::Blue);
    let wobble = disc.wobble(WOBBLING, &Taylor::new(1e-12)?)?;
    let other = wobble.at(0.5 * wobble.period())?;
    let marks = [WOBBLING, other].map(|state| (state.lean().to_degrees(), energy));
    let ends = marks.map(|(lean, energy)| plot.at((lean, energy + 0.006)));
    kit::dimension(plot.drawing(), ends[0], ends[1], Heads::Both, Hue::Ink);
    plot.label((4.8, energy + 0.006), Side::Above, "the lean swings", Hue::Ink)?;
    plot.markers(&marks, Marker::Disc, Hue::Blue);
    plot.label((24.0, energy), Side::AboveRight, "energy $E$", Hue::Muted)?;
    plot.label((-15.0, 1.65), Side::Right, r"$V(\theta)$", Hue::Blue)?;
    Ok(drawing)
}

/// The track of the contact over eleven wobbles, half of the first of them heavy.
pub(crate) fn contact_track(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 340.0).titled(
        "Track of the contact of a wobbling disc",
        "Seen from above, a track that goes round a circle several times in eleven equal waves, so that its rounds cross one another. Half of a wave is drawn heavy, from a place farthest out to one farthest in.",
    );
    let disc = wheel(MomentFactors::DISK)?;
    let mut start = disc.steady(0.55, 1.6)?.state();
    start.omega_1 = 0.3;
    let wobble = disc.wobble(start, &Taylor::new(1e-16)?)?;
    let period = wobble.period();
    let track = |from: f64, to: f64, count: u32| -> Result<Vec<(f64, f64)>, Cause> {
        let times: Vec<f64> = linear_steps(from, to, count).collect();
        let states = wobble.sample(&times)?;
        Ok(states.iter().map(|state| state.contact(1.0)).map(|place| (place.re, place.im)).collect())
    };
    // The moment at which the lean turns, by bisection.
    let (mut before, mut turns) = (0.0, 0.5 * period);
    for _ in 0..50 {
        let middle = 0.5 * (before + turns);
        *(if wobble.at(middle)?.omega_1 > 0.0 { &mut before } else { &mut turns }) = middle;
    }
    let mut plot = Plot::plane(&mut drawing, at(125.0, 165.0), 50.0, 4.0)?;
    plot.curve("all", track(turns, turns + 11.0 * period, 4400)?, Stroke::Orbit, Hue::Pink);
    let half = track(turns, turns + 0.5 * period, 200)?;
    let ends = [half[0], half[200]];
    plot.curve("half", half, Stroke::Curve, Hue::Pink);
    plot.markers(&ends, Marker::Disc, Hue::Pink);
    plot.label((0.94, 0.0), Side::Over, "eleven wobbles", Hue::Ink)?;
    plot.label((0.94, -0.35), Side::Over, "from half of one", Hue::Ink)?;
    Ok(drawing)
}

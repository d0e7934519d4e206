//! Why a leaning wheel does not fall over, and why its circles shrink.

use super::{axes, placed, wheel};
use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Finish, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Role, Shape, Side, Stroke, at};
use figures::{Cause, Outcome, in_both, linear_steps};
use mechanics::integrate::Dop853;
use mechanics::rolling::{MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::RollingConstants;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;

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
        "The wheel in perspective, leaning towards the upright axis of the circle that its contact runs on. From its centre the angular momentum points inward and up. At its tip a small piece, torque \
         times dt, points along a level circle, in the sense in which the wheel goes round.",
    );
    let (lean, b) = PUSHED;
    let steady = wheel(MomentFactors::DISK)?.steady(lean, b)?;
    let axes = axes(lean);
    let momentum = {
        let found = steady.angular_momentum();
        axes[0] * found.x + axes[1] * found.y + axes[2] * found.z
    };
    let centre = Vector3::new(0.0, b, lean.cos());
    let contact = centre - axes[1];
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.3, 0.75],
        azimuth: 0.55,
        elevation: 0.36,
        distance: 11.0,
        centre: at(165.0, 170.0),
        scale: 68.0,
    })?);
    stage.curve(Curve::circle([0.0; 3], Vector3::z(), contact.y)?, Stroke::Outline, Hue::Pink)?;
    stage.solid(Solid::disc(centre, axes[2], 1.0, 0.07)?, Hue::Blue)?;
    let axis = Curve::segment([0.0; 3], [0.0, 0.0, 1.75])?.hiding(Hiding::Ignored);
    stage.curve(axis, Stroke::Dotted, Hue::Muted)?;
    stage.vector([0.0, 0.0, 1.75], [0.0, 0.0, 2.4], Hue::Orange)?;
    stage.label([0.0, 0.0, 2.35], Side::Right, r"$\boldsymbol{\Omega}$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 2.0], Vector3::z() * steady.turn_rate(), 0.2, Hue::Orange)?;
    let arm = momentum * (0.95 / momentum.norm());
    let tip = centre + arm;
    // Where the tip goes, seen from the centre: the centre's own way is left out.
    let level = linear_steps(0.0, 1.6, 60).map(|angle| {
        let (sin, cos) = (angle * steady.turn_rate().signum()).sin_cos();
        centre + Vector3::new(arm.x * cos - arm.y * sin, arm.x * sin + arm.y * cos, arm.z)
    });
    let round = Curve::smooth(level)?.hiding(Hiding::Ignored);
    stage.curve(round, Stroke::Reference, Hue::Green)?;
    let arrow = Curve::segment(centre, tip)?.hiding(Hiding::Ignored);
    stage.arrow(arrow, Stroke::Vector, Heads::End, Hue::Green)?;
    stage.label(centre + arm * 0.55, Side::Above, r"$\boldsymbol{L}$", Hue::Green)?;
    // The torque is along axis 1; drawn at the tip of L, which it moves.
    let push = axes[0] * (0.8 * steady.torque().signum());
    let torque = Curve::segment(tip, tip + push)?.hiding(Hiding::Ignored);
    stage.arrow(torque, Stroke::Vector, Heads::End, Hue::Purple)?;
    let name = r"$\boldsymbol{\tau}\,dt$";
    stage.label_shifted(tip + push, at(0.0, 4.0), Side::Left, name, Hue::Purple)?;
    stage.dot_in_front(contact, 4.5, Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// How far the wheel of the three stills has tipped, and how far it has then turned, rad.
const TIPPED: f64 = 0.42;
const TURNED: f64 = 0.6;

/// Falling makes it turn, turning holds it up: a wheel that rolls away, that tips, that has turned.
pub(crate) fn falling_turns(id: &str) -> Outcome {
    let rolls = still(
        "A wheel rolls away",
        "An upright wheel, seen from behind, rolls away along a line. Its angular momentum L is level and points to the left.",
        "(a) it rolls away",
        |stage, disc| {
            let [_, _, axle] = disc.axes;
            disc.momentum(stage, axle * disc.spin, Stroke::Vector, r"$\boldsymbol{L}$", Side::Above)
        },
        0.0,
        0.0,
    )?;
    let tips = still(
        "It tips to the left",
        "The wheel leans to the left, and the part of L that is its spin points down with the left end of the axle. From its tip a dashed arrow points up: the part of the turning to the left, which an orange \
         arrow shows. Together they are L, as level as before.",
        "(b) it tips, and turns",
        |stage, disc| {
            let [_, second, axle] = disc.axes;
            let spin = axle * disc.spin;
            let turning = second * disc.turning;
            disc.momentum(stage, spin, Stroke::Outline, "spin", Side::BelowLeft)?;
            disc.momentum(stage, spin + turning, Stroke::Vector, r"$\boldsymbol{L}$", Side::Above)?;
            let missing = Curve::segment(disc.centre + spin, disc.centre + spin + turning)?;
            stage.arrow(missing.hiding(Hiding::Ignored), Stroke::Reference, Heads::End, Hue::Green)?;
            stage.label(disc.centre + spin + turning * 0.5, Side::Left, "turning", Hue::Green)?;
            goes_round(stage, disc.centre)?;
            Ok(())
        },
        TIPPED,
        0.0,
    )?;
    let swings = still(
        "It has turned to the left",
        "The wheel has turned to the left. A dashed arrow shows where L was; L now points to the left and towards us. A purple arrow leads from the old tip to the new one: what the torque has added.",
        r"(c) $\boldsymbol{L}$ has swung: that took torque",
        |stage, disc| {
            let [_, second, axle] = disc.axes;
            let now = axle * disc.spin + second * disc.turning;
            let before = disc.turned.inverse() * now;
            let old = Curve::segment(disc.centre, disc.centre + before)?.hiding(Hiding::Ignored);
            stage.arrow(old, Stroke::Reference, Heads::End, Hue::Green)?;
            disc.momentum(stage, now, Stroke::Vector, r"$\boldsymbol{L}$", Side::Below)?;
            let push = Curve::segment(disc.centre + before, disc.centre + now)?.hiding(Hiding::Ignored);
            stage.arrow(push, Stroke::Vector, Heads::End, Hue::Purple)?;
            let name = r"$\boldsymbol{\tau}\,dt$";
            stage.label_shifted(disc.centre + before, at(4.0, 6.0), Side::Below, name, Hue::Purple)?;
            goes_round(stage, disc.centre)?;
            Ok(())
        },
        TIPPED,
        TURNED,
    )?;
    Ok(Drawing::panels(id, vec![rolls, tips, swings]))
}

/// A short arrow upwards above the wheel, with the sense in which it goes round.
fn goes_round(stage: &mut Stage, centre: Vector3<f64>) -> Result<(), Cause> {
    let [from, to] = [1.0, 1.55].map(|height| centre + Vector3::z() * height);
    stage.vector(from, to, Hue::Orange)?;
    Ok(stage.turning(from + Vector3::z() * 0.22, Vector3::z(), 0.18, Hue::Orange)?)
}

/// A wheel of the three stills: where it is, and its angular momentum, in parts along the axle and along axis 2.
struct Fallen {
    centre: Vector3<f64>,
    axes: [Vector3<f64>; 3],
    turned: UnitQuaternion<f64>,
    spin: f64,
    turning: f64,
}

impl Fallen {
    fn momentum(
        &self,
        stage: &mut Stage,
        arm: Vector3<f64>,
        stroke: Stroke,
        name: &str,
        side: Side,
    ) -> Result<(), Cause> {
        let arrow = Curve::segment(self.centre, self.centre + arm)?.hiding(Hiding::Ignored);
        stage.arrow(arrow, stroke, Heads::End, Hue::Green)?;
        Ok(stage.label(self.centre + arm, side, name, Hue::Green)?)
    }
}

/// A still of a wheel that leans to the left, having rolled upright and straight, and has turned to the left.
fn still(
    title: &str,
    description: &str,
    name: &str,
    draw: impl Fn(&mut Stage, &Fallen) -> Result<(), Cause>,
    lean: f64,
    turned: f64,
) -> Outcome {
    let mut drawing = Drawing::new("", 310.0, 300.0).titled(title, description);
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, -0.35, 0.85],
        azimuth: -0.5,
        elevation: 0.3,
        distance: 11.0,
        centre: at(160.0, 130.0),
        scale: 66.0,
    })?);
    // An upright wheel that falls: what is constant is its spin where it was upright (eq:chaplygin).
    let disc = wheel(MomentFactors::DISK)?;
    let state = disc.at_tilt(&RollingConstants { even: 1.0, odd: 0.0 }, FRAC_PI_2 - lean);
    let MomentFactors { transverse, axial } = MomentFactors::DISK;
    let scale = 1.6 / axial; // the drawn length of the first L
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), turned);
    let axes = axes(lean).map(|axis| turn * axis);
    let centre = axes[1]; // the foot in the middle
    let fallen = Fallen {
        centre,
        axes,
        turned: turn,
        spin: scale * axial * state.omega_3,
        turning: scale * transverse * state.omega_2,
    };
    stage.ground([-1.4, -1.5], [1.8, 1.1], 0.0, 0.4)?;
    // The way that it came: straight, and then round a circle.
    let came = if turned > 0.0 {
        let radius = 2.2;
        let middle = axes[0].cross(&Vector3::z()) * radius; // to its left
        let arc = linear_steps(0.0, turned, 30)
            .map(|back| middle + UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -back) * -middle);
        let arc: Vec<Vector3<f64>> = arc.collect();
        let end = arc[arc.len() - 1];
        arc.into_iter().chain([end + Vector3::x() * 0.3]).collect()
    } else {
        linear_steps(0.0, 1.7, 2).map(|back| Vector3::x() * back).collect::<Vec<_>>()
    };
    stage.curve(Curve::smooth(came)?.hiding(Hiding::Omitted), Stroke::Curve, Hue::Pink)?;
    stage.solid(Solid::disc(centre, axes[2], 1.0, 0.08)?, Hue::Blue)?;
    draw(&mut stage, &fallen)?;
    stage.dot_in_front([0.0; 3], 4.5, Hue::Pink)?;
    stage.write(&mut drawing);
    drawing.label(at(160.0, 262.0), Side::Over, name, Hue::Ink)?;
    Ok(drawing)
}

/// The wheel edge on at two leans, the angular momentum the same: more and more of it lies along the steepest diameter.
pub(crate) fn steepest_diameter(id: &str) -> Outcome {
    let first = 0.2;
    let found = wheel(MomentFactors::DISK)?.steady(first, 3.0)?.angular_momentum();
    let [_, second, third] = axes(first);
    let momentum = second * found.y + third * found.z;
    let panel = |title: &str, description: &str, name: &str, lean: f64| -> Outcome {
        let mut drawing = Drawing::new("", 270.0, 290.0).titled(title, description);
        // The page holds y to the right and z up.
        let (contact, radius) = (at(205.0, 232.0), 96.0);
        let on_page = |way: Vector3<f64>| at(way.y, -way.z);
        let second = axes(lean)[1];
        let up = on_page(second);
        let (centre, top) = (contact + up * radius, contact + up * (2.0 * radius));
        drawing.line(at(50.0, contact.y), at(260.0, contact.y), Stroke::Axis, Hue::Ink);
        let across = up.quarter_turned() * 4.0;
        let corners = vec![contact + across, contact - across, top - across, top + across];
        drawing.polygon(corners.clone(), Fill::Face, Hue::Blue);
        drawing.push(Role::Line(Stroke::Outline, Hue::Blue), Shape::Polygon(corners));
        let drawn = 150.0 / momentum.norm();
        let tip = centre + on_page(momentum) * drawn;
        let part = centre + up * (drawn * momentum.dot(&second));
        drawing.line(tip, part, Stroke::Reference, Hue::Muted);
        kit::arrow(&mut drawing, centre, tip, Hue::Green);
        drawing.label(tip, Side::Below, r"$\boldsymbol{L}$", Hue::Green)?;
        kit::arrow(&mut drawing, centre, part, Hue::Green);
        drawing.label(centre.towards(part, 0.6) + at(4.0, -2.0), Side::Right, "$L_2$", Hue::Green)?;
        drawing.dot(contact, 4.5, Hue::Pink);
        drawing.label(at(150.0, 268.0), Side::Over, name, Hue::Ink)?;
        Ok(drawing)
    };
    let upright = panel(
        "A wheel that leans a little",
        "The wheel edge on, seen from behind, leans a little to the left. L points to the left and a little up, nearly along the axle. A dashed line at right angles to the wheel leads from its tip to the \
         wheel, and cuts a short piece, L2, off the steepest diameter.",
        "(a) a small lean",
        first,
    )?;
    let sunk = panel(
        "The same wheel sunk lower, with the same L",
        "The wheel leans more; L is the same arrow. The piece that the dashed line cuts off is now three times as long.",
        "(b) the same $\\boldsymbol{L}$, more lean",
        0.62,
    )?;
    Ok(Drawing::panels(id, vec![upright, sunk]))
}

/// The track of a disc that something slows, with the disc at six moments.
pub(crate) fn shrinking_track(id: &str) -> Outcome {
    let disc = wheel(MomentFactors::DISK)?;
    let start = disc.steady(6_f64.to_radians(), 6.5)?.state();
    let slowing = 0.0022; // Γ, in √(g/a)
    let times: Vec<f64> = linear_steps(0.0, 65.0, 1300).collect();
    let (path, _) = Dop853::new(1e-10)?.sample(disc.slowed_rates(slowing), 0.0, start.to_array(), &times)?;
    let states: Vec<Rolling> = path.iter().map(|state| Rolling::from_array(*state)).collect();
    in_both(|room| {
        let size = room.of((580.0, 380.0), (400.0, 280.0));
        let mut drawing = Drawing::new(id, size.0, size.1).titled(
            "The circles of a disc shrink",
            "A disc has rolled on a floor along a track that winds inward like a spiral. At five earlier moments it stands there pale: at first nearly upright on a wide circle, each time leaning more on a smaller one. \
             Now it leans the most, on the smallest circle.",
        );
        let mut stage = Stage::new(Camera::new(View {
            target: [-2.0, 4.0, 0.0],
            azimuth: 2.75,
            elevation: 0.72,
            distance: 24.0,
            centre: room.of(at(290.0, 195.0), at(200.0, 140.0)),
            scale: room.of(52.0, 36.0),
        })?);
        let track = Curve::smooth(states.iter().map(|state| placed(state)[0]))?;
        stage.curve(track.hiding(Hiding::Omitted), Stroke::Curve, Hue::Pink)?;
        let last = states.len() - 1;
        for still in [0, 190, 420, 590, 850] {
            let [_, centre, _, axle] = placed(&states[still]);
            stage.solid(Solid::disc(centre, axle, 1.0, 0.1)?.finish(Finish::Ghost), Hue::Blue)?;
        }
        let [foot, centre, _, axle] = placed(&states[last]);
        stage.solid(Solid::disc(centre, axle, 1.0, 0.1)?, Hue::Blue)?;
        stage.dot_in_front(foot, 4.5, Hue::Pink)?;
        let [first, ..] = placed(&states[0]);
        stage.label_shifted(first, at(-4.0, 8.0), Side::BelowLeft, "start", Hue::Pink)?;
        stage.write(&mut drawing);
        Ok(drawing)
    })
}

/// A disc edge on, that stands on this contact and leans to the left by the angle to this place of its top.
fn disc_edge_on(drawing: &mut Drawing, contact: Point, top: Point) {
    let across = (top - contact).unit().quarter_turned() * 3.0;
    let corners = vec![contact + across, contact - across, top - across, top + across];
    drawing.polygon(corners.clone(), Fill::Face, Hue::Blue);
    drawing.push(Role::Line(Stroke::Outline, Hue::Blue), Shape::Polygon(corners));
}

/// A disc whose centre is beyond the axis of its circle.
pub(crate) fn beyond(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 270.0).titled(
        "A disc with its centre beyond the axis",
        "A disc edge on leans by 60 degrees to the left. The dotted vertical axis crosses it just below its middle, between the centre, at the left of the axis, and the contact, far at the right of it.",
    );
    let lean = 60_f64.to_radians();
    let steady = wheel(MomentFactors::DISK)?.steady(lean, -0.05)?;
    // The page holds y to the right and z up.
    let (foot, scale) = (at(165.0, 215.0), 150.0);
    let second = axes(lean)[1];
    let contact = foot + at(steady.contact_radius() * scale, 0.0);
    let up = at(second.y, -second.z) * scale;
    let centre = contact + up;
    drawing.line(at(20.0, foot.y), at(320.0, foot.y), Stroke::Axis, Hue::Ink);
    disc_edge_on(&mut drawing, contact, contact + up * 2.0);
    drawing.line(foot, foot - at(0.0, 175.0), Stroke::Dotted, Hue::Ink);
    drawing.label(foot - at(-4.0, 168.0), Side::Right, "axis of the circle", Hue::Muted)?;
    drawing.dot(centre, 4.0, Hue::Ink);
    drawing.label(centre + at(-4.0, 8.0), Side::BelowLeft, "centre", Hue::Ink)?;
    drawing.dot(contact, 4.5, Hue::Pink);
    drawing.label(contact - at(0.0, 8.0), Side::AboveRight, "contact", Hue::Pink)?;
    kit::dimension(&mut drawing, foot + at(0.0, 14.0), contact + at(0.0, 14.0), Heads::Both, Hue::Ink);
    drawing.label(
        (foot + at(0.0, 18.0)).towards(contact + at(0.0, 18.0), 0.5),
        Side::Below,
        "$r$",
        Hue::Ink,
    )?;
    Ok(drawing)
}

/// The two points of a wheel that are at rest, and the angular velocity along the line through both.
pub(crate) fn two_points(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 310.0).titled(
        "Two points of a wheel that are at rest",
        "A wheel edge on leans to the left. From its centre the axle leads down to the left, at right angles to the wheel, and meets the vertical axis at a dot. A dashed line joins this dot to the contact; \
         on it the angular velocity points from the contact to the dot. The wheel's radius is a, the axle's length b over the cosine of the lean, the level distance from the axis to the centre b.",
    );
    let (lean, b) = (0.5, 1.1);
    let steady = wheel(MomentFactors::DISK)?.steady(lean, b)?;
    // The page holds y to the right and z up.
    let (foot, scale) = (at(50.0, 262.0), 118.0);
    let on_page = |way: Vector3<f64>| at(way.y, -way.z) * scale;
    let [_, second, third] = axes(lean);
    let contact = foot + at(steady.contact_radius() * scale, 0.0);
    let centre = contact + on_page(second);
    let crossing = centre + on_page(third * (b / lean.cos()));
    let omega = steady.omega();
    let along = on_page(second * omega.y + third * omega.z).unit();
    drawing.line(at(24.0, foot.y), at(310.0, foot.y), Stroke::Axis, Hue::Ink);
    drawing.line(foot, foot - at(0.0, 230.0), Stroke::Dotted, Hue::Ink);
    disc_edge_on(&mut drawing, contact, contact + on_page(second * 2.0));
    drawing.line(centre, crossing, Stroke::Curve, Hue::Ink);
    drawing.line(contact + along * 110.0, crossing, Stroke::Reference, Hue::Muted);
    kit::arrow(&mut drawing, contact, contact + along * 110.0, Hue::Orange);
    drawing.label(
        contact + along * 78.0 + at(0.0, -4.0),
        Side::Above,
        r"$\boldsymbol{\omega}$",
        Hue::Orange,
    )?;
    kit::dimension(&mut drawing, at(foot.x, centre.y), centre - at(6.0, 0.0), Heads::Both, Hue::Ink);
    drawing.label(at(0.6 * foot.x + 0.4 * centre.x, centre.y - 3.0), Side::Above, "$b$", Hue::Ink)?;
    drawing.label(
        centre.towards(crossing, 0.45) + at(2.0, 4.0),
        Side::BelowRight,
        r"$b/\cos\theta$",
        Hue::Ink,
    )?;
    drawing.label(centre.towards(contact, 0.45) + at(7.0, 0.0), Side::Right, "$a$", Hue::Ink)?;
    drawing.dot(centre, 3.5, Hue::Ink);
    drawing.dot(crossing, 4.5, Hue::Ink);
    drawing.dot(contact, 4.5, Hue::Pink);
    drawing.label(contact + at(0.0, 8.0), Side::Below, "contact", Hue::Pink)?;
    Ok(drawing)
}

//! The figures of the chapter "The wobble plate".

use crate::{Axis, Cause, Outcome, Plot, in_both, linear_steps, log_steps};
use drawing::kit::{self, Marker};
use drawing::space::{Camera, Curve, Edges, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Rect, Role, Side, Stroke, at};
use mechanics::InvalidQuantity;
use mechanics::inertia::SymmetricMoments;
use mechanics::scenes::wobble_plate::{Engine, PistonParameters, Pistons, Plate, PlateParameters};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The spin of the chapter's shaft, rad/s, and the tilt of its plate, degrees.
const SPIN: f64 = 100.0;
const TILT: f64 = 25.0;

/// The chapter's plate: 2 kg, 10 cm, with a tilt in degrees.
fn plate(degrees: f64) -> Result<Plate, InvalidQuantity> {
    plate_at(degrees.to_radians())
}

fn plate_at(tilt: f64) -> Result<Plate, InvalidQuantity> {
    Plate::new(PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.0, tilt })
}

/// So many pistons on the chapter's plate, all of them together with a multiple of the mass that balances three and
/// more.
fn with_pistons(plate: Plate, count: u32, part: f64) -> Result<Engine, Cause> {
    let SymmetricMoments { transverse, axial } = plate.moments().as_symmetric()?;
    let distance = 0.07;
    // eq:many-pistons, whether it works for this number or not.
    let cosine = plate.tilt().cos();
    let needed = 2.0 * (axial - transverse) * cosine * cosine / (f64::from(count) * distance * distance);
    let pistons = PistonParameters { count, mass: part * needed, distance, rod: 0.2 };
    Ok(Engine::new(plate, Pistons::new(pistons)?))
}

/// The plate on its shaft, with its axes, the angular momentum and the two angles.
pub(crate) fn wobble_plate(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 500.0, 470.0).titled(
        "The wobble plate on its shaft",
        "A round plate on an upright shaft that stands on the floor, tilted so that its left side is low. Its normal i3 leans to the left of \
         the shaft by the angle alpha. The axis i1 lies in the plate and rises to the right. The angular velocity omega points up along the \
         shaft; the angular momentum L lies between shaft and normal, at the angle beta to the shaft. A radius of the plate is marked R. \
         Beside it stand the axes that turn with the shaft: x prime to the right, y prime away from the reader, z upwards.",
    );
    let plate = plate(32.0)?;
    let (sin, cos) = plate.tilt().sin_cos();
    let normal = Vector3::new(-sin, 0.0, cos);
    let first = Vector3::new(cos, 0.0, sin);
    let momentum = plate.angular_momentum_rotating(1.0).normalize();
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.35],
        azimuth: -1.25,
        elevation: 0.34,
        distance: 9.0,
        centre: at(250.0, 255.0),
        scale: 108.0,
    })?);
    let floor = -1.15;
    stage.ground([-1.5, -1.2], [1.5, 1.2], floor, 0.3)?;
    stage.solid(Solid::disc([0.0; 3], normal, 1.0, 0.07)?, Hue::Blue)?;
    let shaft = Solid::rod([0.0, 0.0, floor], [0.0, 0.0, 1.45], 0.045)?;
    stage.solid(shaft.edges(Edges::BehindOthers), Hue::Muted)?;
    stage.named_vector([0.0, 0.0, 1.45], [0.0, 0.0, 2.0], r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 1.68], [0.0, 0.0, 1.0], 0.2, Hue::Orange)?;
    for (tip, name, hue) in [
        (normal * 1.75, r"$\hat{\imath}_3$", Hue::Ink),
        (first * 1.5, r"$\hat{\imath}_1$", Hue::Ink),
        (momentum * 1.8, r"$\boldsymbol{L}$", Hue::Green),
    ] {
        stage.named_vector([0.0; 3], tip, name, hue)?;
    }
    stage.angle([0.0; 3], [0.0, 0.0, 1.0], normal, 1.2, "", Hue::Ink)?;
    let beside = (normal * 0.75 + Vector3::z() * 0.25).normalize() * 1.2;
    stage.label_shifted(beside, at(2.0, -2.0), Side::Above, r"$\alpha$", Hue::Ink)?;
    stage.angle([0.0; 3], [0.0, 0.0, 1.0], momentum, 0.72, r"$\beta$", Hue::Green)?;
    // A radius on the upper face.
    let across = Vector3::new(0.0, -1.0, 0.0);
    let towards = across * 0.8 - first * 0.6;
    let face = normal * 0.036;
    stage.curve(Curve::segment(face, face + towards)?, Stroke::Outline, Hue::Ink)?;
    stage.label(face - first * 0.5 - across * 0.05, Side::Over, "$R$", Hue::Ink)?;
    // The axes that turn with the shaft.
    let corner = Vector3::new(-2.15, 0.0, -0.2);
    for (axis, name) in [
        (Vector3::x(), r"$\hat{\mathbf{x}}'$"),
        (Vector3::y(), r"$\hat{\mathbf{y}}'$"),
        (Vector3::z(), r"$\hat{\mathbf{z}}$"),
    ] {
        stage.named_vector(corner, corner + axis * 0.45, name, Hue::Muted)?;
    }
    stage.write(&mut drawing);
    Ok(drawing)
}

/// Lean of the angular momentum against the tilt, for four thicknesses.
pub(crate) fn beta(id: &str) -> Outcome {
    let radius = 0.1;
    let mut curves = Vec::new();
    for thickness in [0.0, 0.5, 1.0, 2.0] {
        let lean_at = |degrees: f64| -> Result<(f64, f64), InvalidQuantity> {
            let (thickness, tilt) = (thickness * radius, degrees.to_radians());
            let plate = Plate::new(PlateParameters { mass: 2.0, radius, thickness, tilt })?;
            Ok((degrees, plate.momentum_angle().to_degrees()))
        };
        curves.push(linear_steps(0.0, 89.999, 300).map(lean_at).collect::<Result<Vec<_>, _>>()?);
    }
    let largest = plate(10.0)?.largest_momentum_angle();
    let top = (largest.tilt.to_degrees(), largest.momentum_angle.to_degrees());
    in_both(|room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 372.0).titled(
            "Lean of the angular momentum against the tilt",
            "The lean beta in degrees, from minus 10 to 20, against the tilt alpha from 0 to 90 degrees. For the thin plate the curve rises \
             from zero at half the slope of the diagonal to a maximum of 19.47 degrees at 54.74 and falls to zero. For a thickness of half \
             the radius and of one radius the curves are lower; for two radii the curve is negative.",
        );
        let step = room.of(15.0, 30.0);
        let tilt = Axis::linear(0.0, 90.0, step)?.minor(5.0).titled(r"tilt $\alpha$, degrees");
        let lean =
            Axis::linear(-10.0, 22.0, 5.0)?.minor(1.0).titled(r"lean of the momentum $\beta$, degrees");
        let frame = Rect::new(52.0, 34.0, room.of(580.0, 320.0), 286.0);
        let mut plot = Plot::new(&mut drawing, frame, tilt, lean)?;
        plot.level(0.0, Stroke::Reference);
        let names = [
            (0.0, Hue::Blue, "thin", (20.0, 11.9)),
            (0.5, Hue::Green, r"$h = \tfrac12R$", (45.0, 13.5)),
            (1.0, Hue::Pink, "$h = R$", (45.0, 8.6)),
            (2.0, Hue::Orange, "$h = 2R$", (45.0, -6.3)),
        ];
        for ((thickness, hue, name, place), values) in names.into_iter().zip(&curves) {
            let name_of_curve = format!("thickness-{thickness}");
            plot.curve(&name_of_curve, values.iter().copied(), Stroke::Curve, hue);
            plot.label(place, Side::Over, name, hue)?;
        }
        plot.markers(&[top], Marker::Disc, Hue::Blue);
        plot.label(top, Side::Above, "$19.47°$ at $54.74°$", Hue::Blue)?;
        Ok(drawing)
    })
}

/// Why the shaft pulls at its bearings: the centrifugal forces on the plate, and what holds against them.
pub(crate) fn bearings(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 480.0, 430.0).titled(
        "The forces of the bearings",
        "The tilted plate on its upright shaft, as it looks from a frame that turns with it. The shaft runs in two bearings, one above and one \
         below the plate. Thin arrows on the high right half of the plate point outwards to the right, thin arrows on the low left half \
         outwards to the left: together they would turn the plate flat, clockwise as it is seen. The upper bearing pushes the shaft to the \
         left, the lower one equally to the right, and so they hold against it.",
    );
    let plate = plate(TILT)?;
    let (sin, cos) = plate.tilt().sin_cos();
    let (normal, first) = (Vector3::new(-sin, 0.0, cos), Vector3::new(cos, 0.0, sin));
    // A pair of forces at ±h along the shaft with the torque that is wanted: 2h z × F = τ.
    let half = 1.3;
    let force = plate.bearing_torque_rotating(SPIN).cross(&Vector3::z());
    let force = force.normalize() * 0.85;
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.0],
        azimuth: -1.35,
        elevation: 0.27,
        distance: 9.0,
        centre: at(240.0, 215.0),
        scale: 112.0,
    })?);
    stage.solid(Solid::disc([0.0; 3], normal, 1.0, 0.07)?, Hue::Blue)?;
    let shaft = Solid::rod([0.0, 0.0, -1.6], [0.0, 0.0, 1.6], 0.045)?;
    stage.solid(shaft.edges(Edges::BehindOthers), Hue::Muted)?;
    for (side, name) in [(1.0, r"$\boldsymbol{F}$"), (-1.0, r"$-\boldsymbol{F}$")] {
        let place = Vector3::z() * (side * half);
        stage.solid(Solid::ring(place, Vector3::z(), 0.2, 0.05, 0.16)?, Hue::Muted)?;
        let way = force * side;
        let start = place - way.normalize() * 0.22 - way; // it ends at the rim of the bearing
        stage.vector(start, start + way, Hue::Purple)?;
        let above = if side > 0.0 { Side::Above } else { Side::Below };
        stage.label(start + way * 0.4, above, name, Hue::Purple)?;
    }
    // On specks of the upper face: away from the shaft, as far as they are from it.
    let face = normal * 0.037;
    for along in [-0.88, -0.5, 0.5, 0.88] {
        let speck = first * along;
        let outwards = Vector3::new(speck.x, speck.y, 0.0) * 0.8;
        stage.dot(face + speck, 2.6, Hue::Blue)?;
        let arrow = Curve::segment(face + speck, face + speck + outwards)?.hiding(Hiding::Ignored);
        stage.arrow(arrow, Stroke::Outline, kit::Heads::End, Hue::Purple)?;
    }
    for (side, where_to) in [(1.0, Side::Above), (-1.0, Side::Below)] {
        let tip = face + first * (0.88 * side) + Vector3::x() * (0.88 * cos * 0.8 * side);
        stage.label_shifted(tip, at(4.0 * side, 0.0), where_to, "centrifugal", Hue::Purple)?;
        let beside = if side > 0.0 { Side::Left } else { Side::Right };
        stage.label_shifted(
            Vector3::z() * (side * half),
            at(-22.0 * side, 0.0),
            beside,
            "bearing",
            Hue::Ink,
        )?;
    }
    stage.named_vector([0.0, 0.0, 1.6], [0.0, 0.0, 2.0], r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The engine with four pistons, and their heights during a turn.
pub(crate) fn engine(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![pistons_under_the_plate()?, heights()?]))
}

fn pistons_under_the_plate() -> Outcome {
    let mut drawing = Drawing::new("", 330.0, 400.0).titled(
        "The plate with four pistons",
        "A tilted plate of radius R on an upright shaft, with its normal at the angle alpha to the shaft. Four rods, a quarter turn \
         apart, stand upright below it at the distance r from the shaft and touch its lower side, each with a cylindrical piston at its lower \
         end. The pistons, numbered 1 to 4 counter-clockwise from above, stand at different heights, lowest where the plate is low.",
    );
    let tilt = 24_f64.to_radians();
    let plate = Plate::new(PlateParameters { mass: 2.0, radius: 1.0, thickness: 0.0, tilt })?;
    let pistons = PistonParameters { count: 4, mass: 0.4, distance: 0.72, rod: 1.15 };
    let engine = Engine::new(plate, Pistons::new(pistons)?);
    let phase = 0.45_f64;
    let (s, c) = phase.sin_cos();
    let normal = Vector3::new(-tilt.sin() * c, -tilt.sin() * s, tilt.cos());
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, -0.3],
        azimuth: -1.15,
        elevation: 0.3,
        distance: 9.0,
        centre: at(160.0, 215.0),
        scale: 106.0,
    })?);
    stage.solid(Solid::disc([0.0; 3], normal, 1.0, 0.07)?, Hue::Blue)?;
    let shaft = Solid::rod([0.0, 0.0, -1.75], [0.0, 0.0, 0.75], 0.045)?;
    stage.solid(shaft.edges(Edges::BehindOthers), Hue::Muted)?;
    for n in 1..=4 {
        let (contact, centre) = (engine.contact(n, phase), engine.centre(n, phase));
        let half = Vector3::new(0.0, 0.0, 0.17);
        let touch = contact - Vector3::new(0.0, 0.0, 0.05);
        stage.solid(Solid::rod(centre + half, touch, 0.028)?, Hue::Muted)?;
        stage.solid(Solid::rod(centre - half, centre + half, 0.14)?, Hue::Muted)?;
        let line = Curve::segment(centre - half * 1.2, centre - half * 2.6)?;
        stage.curve(line, Stroke::Dotted, Hue::Muted)?;
        stage.label_shifted(centre, at(0.0, 2.0), Side::Over, &format!("${n}$"), Hue::Ink)?;
    }
    // The normal and its angle, a radius of the plate, and the distance of a rod from the shaft.
    stage.vector([0.0; 3], normal * 1.1, Hue::Ink)?;
    stage.label(normal * 1.1, Side::Left, r"$\hat{\imath}_3$", Hue::Ink)?;
    stage.angle([0.0; 3], [0.0, 0.0, 1.0], normal, 0.68, r"$\alpha$", Hue::Ink)?;
    let face = normal * 0.037;
    let rim = normal.cross(&Vector3::new(-0.35, 1.0, 0.0)).normalize();
    stage.curve(Curve::segment(face, face + rim)?, Stroke::Outline, Hue::Ink)?;
    stage.label(face + rim * 0.5, Side::Above, "$R$", Hue::Ink)?;
    let centre = engine.centre(1, phase) - Vector3::z() * 0.17;
    let foot = Vector3::new(0.0, 0.0, centre.z);
    stage.arrow(Curve::segment(foot, centre)?, Stroke::Outline, kit::Heads::Both, Hue::Ink)?;
    stage.label(foot + (centre - foot) * 0.25, Side::Below, "$r$", Hue::Ink)?;
    stage.named_vector([0.0, 0.0, 0.75], [0.0, 0.0, 1.25], r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 0.97], [0.0, 0.0, 1.0], 0.2, Hue::Orange)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

fn heights() -> Outcome {
    let mut drawing = Drawing::new("", 340.0, 400.0).titled(
        "The heights of the pistons during a turn",
        "The heights of four pistons above the middle, in units of r tan alpha, against the phase from 0 to 360 degrees: four sines, each a \
         quarter turn after the one before. Pistons 1 and 3, and 2 and 4, are mirror images of each other, so the sum is zero all the time.",
    );
    let engine = with_pistons(plate(TILT)?, 4, 1.0)?;
    let stroke = engine.pistons().distance() * engine.plate().tilt().tan();
    let phase = Axis::linear(0.0, 360.0, 90.0)?.minor(30.0).titled(r"phase $\omega t$, degrees");
    let height = Axis::linear(-1.2, 1.2, 0.5)?.minor(0.1).titled(r"height over $r\tan\alpha$");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 70.0, 250.0, 240.0), phase, height)?;
    plot.level(0.0, Stroke::Reference);
    for (n, place, side) in [
        (1, (360.0, 1.0), Side::Right),
        (2, (90.0, 1.0), Side::Above),
        (3, (180.0, 1.0), Side::Above),
        (4, (270.0, 1.0), Side::Above),
    ] {
        let values = linear_steps(0.0, 360.0, 360)
            .map(|degrees| (degrees, engine.contact(n, degrees.to_radians()).z / stroke));
        plot.curve(&format!("height-{n}"), values, Stroke::Curve, Hue::Blue);
        plot.label(place, side, &format!("${n}$"), Hue::Blue)?;
    }
    plot.label((360.0, 0.0), Side::Right, "sum", Hue::Muted)?;
    Ok(drawing)
}

/// The two parts of the momentum across the shaft, at four moments, seen along it.
pub(crate) fn antiphase(id: &str) -> Outcome {
    let engine = with_pistons(plate(TILT)?, 4, 0.75)?;
    let scale = 54.0 / engine.plate().angular_momentum_rotating(SPIN).x.abs();
    let mut panels = Vec::new();
    for (name, eighths) in [("0", 0.0), ("45°", 1.0), ("90°", 2.0), ("135°", 3.0)] {
        let mut drawing = Drawing::new("", 148.0, 180.0).titled(
            &format!("Momenta of plate and pistons at the phase {name}"),
            "A circle, the view along the shaft. From its centre a long arrow shows the plate’s angular momentum across the shaft, and a \
             shorter one, three quarters as long, points exactly the other way: that of the pistons.",
        );
        let phase = TAU * eighths / 8.0;
        let centre = at(74.0, 76.0);
        drawing.circle(centre, 61.0, Role::Line(Stroke::Grid, Hue::Ink));
        let pistons = engine.piston_momentum(phase, SPIN);
        let plate = engine.angular_momentum(phase, SPIN) - pistons;
        let tip = |momentum: Vector3<f64>| centre + at(momentum.x, -momentum.y) * scale;
        kit::arrow(&mut drawing, centre, tip(plate), Hue::Green);
        kit::dimension(&mut drawing, centre, tip(pistons), kit::Heads::End, Hue::Green);
        if eighths == 0.0 {
            for (momentum, word) in [(plate, "plate"), (pistons, "pistons")] {
                drawing.label(centre.towards(tip(momentum), 0.6), Side::Above, word, Hue::Green)?;
            }
        }
        drawing.dot(centre, 3.0, Hue::Ink);
        let from = (tip(pistons) - centre).angle();
        kit::angle(&mut drawing, centre, 61.0, from - 0.35, 0.7, kit::Heads::End, Hue::Orange);
        drawing.label(at(74.0, 164.0), Side::Over, &format!(r"$\omega t = {name}$"), Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels).titled(
        "Momenta of plate and pistons across the shaft",
        "Four circles, views along the shaft at four moments an eighth of a turn apart. In each an arrow from the centre shows the plate’s \
         angular momentum across the shaft, another, three quarters as long and opposite, that of the pistons; both turn \
         counter-clockwise together.",
    ))
}

/// Torque on the frame against the mass of the pistons: three and more, and the band of one or two.
pub(crate) fn residual(id: &str) -> Outcome {
    let plate = plate(TILT)?;
    let alone = plate.bearing_torque_rotating(SPIN).norm();
    let [mut many, mut least, mut most] = [(); 3].map(|()| Vec::new());
    for part in linear_steps(0.0, 2.0, 200) {
        many.push((part, with_pistons(plate, 4, part)?.frame_torque(0.3, SPIN).norm()));
        let pair = with_pistons(plate, 2, part)?;
        let torques = linear_steps(0.0, 180.0, 72)
            .map(|degrees| pair.frame_torque(f64::to_radians(degrees), SPIN).norm());
        let (low, high) = torques.fold((f64::MAX, 0.0_f64), |(low, high), t| (low.min(t), high.max(t)));
        least.push((part, low));
        most.push((part, high));
    }
    in_both(|room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 350.0).titled(
            "Torque on the frame against the mass of the pistons",
            "The torque on the frame, in newton metres, against the mass of all pistons in units of the mass that balances, from 0 to 2. The plate \
             alone gives 19, a dashed level line. With three pistons or more a line runs straight down to zero at the balancing mass and \
             straight up again, to 19 at twice the mass. With one piston, or two, the torque swings during each turn between two lines, \
             and the band between them is tinted; its upper edge is never below the plate alone, and at the balancing mass the band is \
             pinched to a point on that level.",
        );
        let step = room.of(0.5, 0.5);
        let mass =
            Axis::linear(0.0, 2.0, step)?.minor(0.1).titled("mass of all pistons, in units of what balances");
        let torque = Axis::linear(0.0, 40.0, 10.0)?.minor(2.0).titled("torque on the frame, N m");
        let frame = Rect::new(52.0, 34.0, room.of(580.0, 320.0), 260.0);
        let mut plot = Plot::new(&mut drawing, frame, mass, torque)?;
        let ends = |limit: f64| 40.0_f64.min(limit);
        let band = most.iter().map(|&(x, y)| (x, ends(y)));
        let band =
            band.chain(least.iter().rev().map(|&(x, y)| (x, ends(y)))).map(|value| plot.at(value)).collect();
        plot.drawing().polygon(band, Fill::Ground, Hue::Orange);
        plot.level(alone, Stroke::Reference);
        plot.curve("pair-least", least.iter().copied(), Stroke::Outline, Hue::Orange);
        plot.curve("pair-most", most.iter().copied(), Stroke::Outline, Hue::Orange);
        plot.curve("torque", many.iter().copied(), Stroke::Curve, Hue::Purple);
        let label = |plot: &mut Plot<'_>, value, side, text: &str, hue| {
            let place = plot.at(value);
            plot.drawing().label_on_face(place, side, text, hue)
        };
        label(&mut plot, (1.76, 29.0), Side::Over, "one or two", Hue::Orange)?;
        label(&mut plot, (1.28, 2.4), Side::Right, "three or more", Hue::Purple)?;
        plot.label((0.03, alone), Side::AboveRight, "the plate alone", Hue::Muted)?;
        Ok(drawing)
    })
}

/// Errors of three programs for β.
pub(crate) fn beta_error(id: &str) -> Outcome {
    type Program = fn(&Plate) -> f64;
    let programs: [(&str, Program, Hue, Marker); 3] = [
        ("cosine", by_cosine, Hue::Orange, Marker::Disc),
        ("difference", by_difference, Hue::Pink, Marker::Triangle),
        ("arctangent", Plate::momentum_angle, Hue::Blue, Marker::Square),
    ];
    let panels = [
        (
            "tilt",
            r"tilt $\alpha$, rad",
            "Against the tilt from 1e-9 to one: the inverse cosine loses digits as the tilt shrinks and has none left at 1e-8; the \
             difference of angles and the arctangent stay at the last digit.",
        ),
        (
            "rest",
            r"$\tfrac12\pi - \alpha$, rad",
            "Against the distance of the tilt from a right angle, from 1e-9 to one: both the inverse cosine and the difference of angles \
             lose digits, the arctangent none.",
        ),
    ];
    let mut drawn = Vec::new();
    for (side, title, description) in panels {
        let mut drawing = Drawing::new("", 350.0, 350.0)
            .titled("Relative errors of three programs for the lean", description);
        let x = Axis::log(1e-9, 1.0, 3)?.titled(title);
        let y = Axis::log(1e-17, 10.0, 4)?.titled(r"relative error of $\beta$");
        let mut plot = Plot::new(&mut drawing, Rect::new(54.0, 34.0, 252.0, 262.0), x, y)?;
        for (name, program, hue, form) in programs {
            let mut values = Vec::new();
            for small in log_steps(1e-9, 1.0, 36) {
                let plate = plate_at(if side == "tilt" { small } else { FRAC_PI_2 - small })?;
                // The judge: tan β = sin α cos α/(1 + cos² α), in which nothing is lost.
                let (sin, cos) = plate.tilt().sin_cos();
                let exact = (sin * cos / (1.0 + cos * cos)).atan();
                values.push((small, (program(&plate) / exact - 1.0).abs().max(1e-17)));
            }
            plot.series(&format!("{side}-{name}"), &values, form, hue);
        }
        plot.label((3e-6, 1e-1), Side::Right, "inverse cosine", Hue::Orange)?;
        plot.label((1.3e-9, 1e-12), Side::Right, "difference", Hue::Pink)?;
        plot.label((1.3e-9, 1e-14), Side::Right, "arctangent", Hue::Blue)?;
        drawn.push(drawing);
    }
    Ok(Drawing::panels(id, drawn))
}

fn by_cosine(plate: &Plate) -> f64 {
    let momentum = plate.angular_momentum_rotating(1.0);
    (momentum.z / momentum.norm()).acos()
}

/// eq:momentum-from-normal, and a subtraction.
fn by_difference(plate: &Plate) -> f64 {
    plate.tilt() - (0.5 * plate.tilt().tan()).atan()
}

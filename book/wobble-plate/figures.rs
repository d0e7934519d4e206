//! The figures of the chapter "The wobble plate".

use crate::{Axis, Cause, Outcome, Plot, linear_steps, log_steps};
use drawing::kit::{self, Marker};
use drawing::space::{Camera, Curve, Edges, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Role, Side, Stroke, at};
use mechanics::InvalidQuantity;
use mechanics::inertia::SymmetricMoments;
use mechanics::scenes::wobble_plate::{Engine, PistonParameters, Pistons, Plate, PlateParameters};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The chapter's plate: 2 kg, 10 cm, with a tilt in degrees.
fn plate(degrees: f64) -> Result<Plate, InvalidQuantity> {
    plate_at(degrees.to_radians())
}

/// So many pistons on the chapter's plate, each with a multiple of the mass that balances three and more.
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
    let mut drawing = Drawing::new(id, 460.0, 430.0).titled(
        "The wobble plate on its shaft",
        "A round plate on an upright shaft, tilted so that its left side is low. Its normal i3 leans to the left of the shaft by the angle \
         alpha. The axis i1 lies in the plate and rises to the right. The angular velocity omega points up along the shaft; the angular momentum \
         L lies between shaft and normal, at the angle beta to the shaft. A radius of the plate is marked R.",
    );
    let tilt = 32_f64;
    let plate = plate(tilt)?;
    let (sin, cos) = plate.tilt().sin_cos();
    let normal = Vector3::new(-sin, 0.0, cos);
    let first = Vector3::new(cos, 0.0, sin);
    let momentum = plate.angular_momentum_rotating(1.0).normalize();
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.35],
        azimuth: -1.25,
        elevation: 0.34,
        distance: 9.0,
        centre: at(235.0, 245.0),
        scale: 112.0,
    })?);
    stage.solid(Solid::disc([0.0; 3], normal, 1.0, 0.07)?, Hue::Blue)?;
    let shaft = Solid::rod([0.0, 0.0, -1.15], [0.0, 0.0, 1.45], 0.045)?;
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
    stage.label(face + towards * 0.5, Side::Above, "$R$", Hue::Ink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// Lean of the angular momentum against the tilt, for four thicknesses.
pub(crate) fn beta(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 372.0).titled(
        "Lean of the angular momentum against the tilt",
        "The lean beta in degrees, from minus 10 to 20, against the tilt alpha from 0 to 90 degrees. For the thin plate the curve rises from zero \
         at half the slope of the diagonal to a maximum of 19.47 degrees at 54.74 and falls to zero. For a thickness of half the radius and \
         of one radius the curves are lower; for two radii the curve is negative.",
    );
    let tilt = Axis::linear(0.0, 90.0, 15.0)?.minor(5.0).titled(r"tilt $\alpha$, degrees");
    let lean = Axis::linear(-10.0, 22.0, 5.0)?.minor(1.0).titled(r"lean of the momentum $\beta$, degrees");
    let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 520.0, 286.0), tilt, lean)?;
    plot.level(0.0, Stroke::Reference);
    let radius = 0.1;
    for (thickness, hue, name, place) in [
        (0.0, Hue::Blue, "thin", (22.0, 12.6)),
        (0.5, Hue::Green, r"$h = \tfrac12R$", (43.0, 13.9)),
        (1.0, Hue::Pink, "$h = R$", (24.0, 5.4)),
        (2.0, Hue::Orange, "$h = 2R$", (20.0, -5.6)),
    ] {
        let lean_at = |degrees: f64| -> Result<(f64, f64), InvalidQuantity> {
            let (thickness, tilt) = (thickness * radius, degrees.to_radians());
            let plate = Plate::new(PlateParameters { mass: 2.0, radius, thickness, tilt })?;
            Ok((degrees, plate.momentum_angle().to_degrees()))
        };
        let values = linear_steps(0.0, 89.999, 300).map(lean_at).collect::<Result<Vec<_>, _>>()?;
        plot.curve(&format!("thickness-{thickness}"), values, Stroke::Curve, hue);
        plot.label(place, Side::Over, name, hue)?;
    }
    let largest = plate(10.0)?.largest_momentum_angle();
    let top = (largest.tilt.to_degrees(), largest.momentum_angle.to_degrees());
    plot.markers(&[top], Marker::Disc, Hue::Blue);
    plot.label(top, Side::Above, "19.47° at 54.74°", Hue::Blue)?;
    Ok(drawing)
}

/// The engine with four pistons.
pub(crate) fn engine(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 460.0, 470.0).titled(
        "The plate with four pistons",
        "A tilted plate on an upright shaft. Four rods, a quarter turn apart, stand upright below it and touch its lower side, each with a \
         cylindrical piston at its lower end. The pistons stand at different heights, lowest where the plate is low.",
    );
    let tilt = 24_f64.to_radians();
    let plate = Plate::new(PlateParameters { mass: 2.0, radius: 1.0, thickness: 0.0, tilt })?;
    let pistons = PistonParameters { count: 4, mass: 0.4, distance: 0.72, rod: 1.15 };
    let engine = Engine::new(plate, Pistons::new(pistons)?);
    let phase = 0.45_f64;
    let (s, c) = phase.sin_cos();
    let normal = Vector3::new(-tilt.sin() * c, -tilt.sin() * s, tilt.cos());
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, -0.45],
        azimuth: -1.15,
        elevation: 0.3,
        distance: 9.0,
        centre: at(230.0, 245.0),
        scale: 112.0,
    })?);
    stage.solid(Solid::disc([0.0; 3], normal, 1.0, 0.07)?, Hue::Blue)?;
    let shaft = Solid::rod([0.0, 0.0, -1.75], [0.0, 0.0, 0.75], 0.045)?;
    stage.solid(shaft.edges(Edges::BehindOthers), Hue::Muted)?;
    for n in 1..=4 {
        let (contact, centre) = (engine.contact(n, phase), engine.centre(n, phase));
        let half = Vector3::new(0.0, 0.0, 0.17);
        let touch = contact - Vector3::new(0.0, 0.0, 0.05);
        stage.solid(Solid::rod(centre + half, touch, 0.028)?, Hue::Muted)?;
        stage.solid(Solid::rod(centre - half, centre + half, 0.14)?, Hue::Green)?;
        let line = Curve::segment(centre - half * 1.2, centre - half * 3.2)?;
        stage.curve(line, Stroke::Dotted, Hue::Muted)?;
    }
    stage.named_vector([0.0, 0.0, 0.75], [0.0, 0.0, 1.25], r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.turning([0.0, 0.0, 0.97], [0.0, 0.0, 1.0], 0.2, Hue::Orange)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The two parts of the momentum across the shaft, at four moments, seen along it.
pub(crate) fn antiphase(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 214.0).titled(
        "Momenta of plate and pistons across the shaft",
        "Four circles, views along the shaft at four moments an eighth of a turn apart. In each an arrow from the centre shows the plate's \
         angular momentum across the shaft, another, three quarters as long and opposite, that of the pistons; both turn \
         counter-clockwise together.",
    );
    let engine = with_pistons(plate(25.0)?, 4, 0.75)?;
    let spin = 100.0;
    let scale = 68.0 / engine.plate().angular_momentum_rotating(spin).x.abs();
    for k in 0..4_u32 {
        let phase = TAU * f64::from(k) / 8.0;
        let centre = at(90.0 + 167.0 * f64::from(k), 92.0);
        drawing.circle(centre, 76.0, Role::Line(Stroke::Reference, Hue::Muted));
        let pistons = engine.piston_momentum(phase, spin);
        let plate = engine.angular_momentum(phase, spin) - pistons;
        let tip = |momentum: Vector3<f64>| centre + at(momentum.x, -momentum.y) * scale;
        let arrows = [(plate, "plate", Hue::Blue), (pistons, "pistons", Hue::Orange)];
        for (momentum, name, hue) in arrows {
            kit::arrow(&mut drawing, centre, tip(momentum), hue);
            if k == 0 {
                let middle = centre.towards(tip(momentum), 0.55);
                drawing.label(middle, Side::Above, name, hue)?;
            }
        }
        drawing.dot(centre, 3.0, Hue::Ink);
        let name = ["$t = 0$", r"$\omega t = 45°$", r"$\omega t = 90°$", r"$\omega t = 135°$"][k as usize];
        drawing.label(centre + at(0.0, 100.0), Side::Over, name, Hue::Ink)?;
    }
    let [from, to] = [0.35, 0.95];
    kit::angle(&mut drawing, at(90.0, 92.0), 60.0, from, to - from, kit::Heads::End, Hue::Muted);
    Ok(drawing)
}

/// Torque on the frame against the mass of each piston.
pub(crate) fn residual(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 320.0).titled(
        "Torque on the frame against the mass of the pistons",
        "The torque on the frame, in units of that of the plate alone, against the mass of each piston in units of the balancing mass, from 0 to 2.5. \
         A V: from one at zero mass straight down to zero at the balancing mass, and straight up again, to one at twice the mass. A dashed level \
         line at one is the plate without pistons.",
    );
    let mass = Axis::linear(0.0, 2.5, 0.5)?.minor(0.1).titled("mass of each piston over the balancing mass");
    let torque = Axis::linear(0.0, 1.6, 0.5)?.minor(0.1).titled("torque on the frame");
    let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 520.0, 234.0), mass, torque)?;
    plot.level(1.0, Stroke::Reference);
    let (plate, spin) = (plate(25.0)?, 100.0);
    let alone = plate.bearing_torque_rotating(spin).norm();
    let values = linear_steps(0.0, 2.5, 250)
        .map(|part| Ok((part, with_pistons(plate, 4, part)?.frame_torque(0.3, spin).norm() / alone)))
        .collect::<Result<Vec<_>, Cause>>()?;
    plot.curve("torque", values, Stroke::Curve, Hue::Purple);
    plot.label((0.02, 1.0), Side::AboveRight, "without pistons", Hue::Muted)?;
    plot.label((1.0, 0.16), Side::Above, "balanced", Hue::Purple)?;
    Ok(drawing)
}

/// The torque left during one turn, for one to seven pistons.
pub(crate) fn number(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 340.0).titled(
        "Torque left on the frame during a turn, by number of pistons",
        "The torque left on the frame, in units of the plate alone, against the phase from 0 to 360 degrees. With one piston, or two, the curve stays \
         at one. With two of half the mass it swings between zero and one. With three, five and seven pistons it is zero all the way.",
    );
    let phase = Axis::linear(0.0, 360.0, 90.0)?.minor(30.0).titled(r"phase $\omega t$, degrees");
    let torque = Axis::linear(0.0, 1.6, 0.5)?.minor(0.1).titled("torque on the frame");
    let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 470.0, 254.0), phase, torque)?;
    let (plate, spin) = (plate(25.0)?, 100.0);
    let alone = plate.bearing_torque_rotating(spin).norm();
    for (count, part, hue) in [
        (1, 1.0, Hue::Orange),
        (2, 0.5, Hue::Pink),
        (3, 1.0, Hue::Blue),
        (5, 1.0, Hue::Blue),
        (7, 1.0, Hue::Blue),
    ] {
        let engine = with_pistons(plate, count, part)?;
        let values = linear_steps(0.0, 360.0, 180)
            .map(|degrees| (degrees, engine.frame_torque(degrees.to_radians(), spin).norm() / alone));
        plot.curve(&format!("pistons-{count}"), values, Stroke::Curve, hue);
    }
    plot.label((360.0, 1.0), Side::Right, "one or two", Hue::Orange)?;
    plot.label((90.0, 0.86), Side::Over, "two, half the mass", Hue::Pink)?;
    plot.label((360.0, 0.0), Side::Right, "three, five, seven", Hue::Blue)?;
    Ok(drawing)
}

/// Errors of three programs for β.
pub(crate) fn beta_error(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 690.0, 350.0).titled(
        "Relative errors of three programs for the lean",
        "Two plots with logarithmic scales. Left, against the tilt from 1e-9 to one: the inverse cosine loses digits as the tilt shrinks and has \
         none left at 1e-8; the other two stay at the last digit. Right, against the distance of the tilt from a right angle, from \
         1e-9 to one: both the inverse cosine and the difference of angles lose digits, the arctangent none.",
    );
    let error = || Axis::log(1e-17, 10.0, 4);
    type Program = fn(&Plate) -> f64;
    let programs: [(&str, Program, Hue, Marker); 3] = [
        ("cosine", by_cosine, Hue::Orange, Marker::Disc),
        ("difference", by_difference, Hue::Pink, Marker::Triangle),
        ("arctangent", Plate::momentum_angle, Hue::Blue, Marker::Square),
    ];
    for (side, left, title) in
        [("tilt", 54.0, r"tilt $\alpha$, rad"), ("rest", 404.0, r"$\tfrac12\pi - \alpha$, rad")]
    {
        let x = Axis::log(1e-9, 1.0, 3)?.titled(title);
        let y = if side == "tilt" { error()?.titled(r"relative error of $\beta$") } else { error()? };
        let mut plot = Plot::new(&mut drawing, Rect::new(left, 34.0, 268.0, 262.0), x, y)?;
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
        if side == "tilt" {
            plot.label((3e-6, 1e-2), Side::Right, "inverse cosine", Hue::Orange)?;
        } else {
            plot.label((1.3e-9, 1e-14), Side::Right, "difference of angles", Hue::Pink)?;
            plot.label((3e-6, 1e-1), Side::Right, "inverse cosine", Hue::Orange)?;
        }
    }
    Ok(drawing)
}

fn plate_at(tilt: f64) -> Result<Plate, InvalidQuantity> {
    Plate::new(PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.0, tilt })
}

fn by_cosine(plate: &Plate) -> f64 {
    let momentum = plate.angular_momentum_rotating(1.0);
    (momentum.z / momentum.norm()).acos()
}

/// eq:momentum-from-normal, and a subtraction.
fn by_difference(plate: &Plate) -> f64 {
    plate.tilt() - (0.5 * plate.tilt().tan()).atan()
}

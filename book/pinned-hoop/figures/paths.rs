//! Paths in the room: the tip of ω, and the centres of a hoop and of a ball.

use super::{along_momentum, pinning};
use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Outcome, Plot, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::scenes::pinned_hoop::Shape;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// The tips of ω and L from the hoop, and that of ω from the room.
pub(crate) fn herpolhode(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![from_the_hoop("")?, from_the_room("")?]))
}

/// ω and L as the hoop sees them, along its diameter through A.
fn from_the_hoop(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 290.0, 320.0).titled(
        "ω and L as the hoop sees them",
        "Seen along the diameter through A, with the hoop edge on along axis 1. The tip of omega goes round one oval, that of the angular momentum round a larger one.",
    );
    let hoop = pinning(Shape::Hoop, 60.0)?;
    let top = hoop.free_motion()?;
    let period = top.period().ok_or("it swings")?;
    let side = Axis::linear(-0.5, 0.5, 0.5).minor(0.1);
    let (x, y) = (side.titled(r"along $\hat{\mathbf{1}}$"), side.titled(r"along $\hat{\mathbf{3}}$"));
    let mut plot = Plot::new(&mut drawing, Rect::new(46.0, 34.0, 196.0, 196.0), x, y)?;
    let moments = hoop.moments_about_pin();
    let mut curve = |name: &str, hue: Hue, of: &dyn Fn(&Vector3<f64>) -> Vector3<f64>| {
        let values = linear_steps(0.0, period, 720)
            .map(|time| Ok(of(&top.at(time)?.omega_body)))
            .map(|found| found.map(|vector: Vector3<f64>| (vector.x, vector.z)))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(name, values, Stroke::Curve, hue);
        Ok::<(), InvalidQuantity>(())
    };
    curve("omega-in-hoop", Hue::Orange, &|omega| *omega)?;
    curve("momentum-in-hoop", Hue::Green, &|omega| moments.angular_momentum(omega))?;
    plot.label((0.0, 0.12), Side::Over, r"tip of $\boldsymbol{\omega}$", Hue::Orange)?;
    plot.label((0.0, 0.47), Side::Over, r"tip of $\boldsymbol{L}_A$", Hue::Green)?;
    let ends = [plot.at((-0.2, 0.0)), plot.at((0.2, 0.0))];
    plot.drawing().line(ends[0], ends[1], Stroke::Vector, Hue::Blue);
    plot.markers(&[(0.0, 0.0)], Marker::Disc, Hue::Pink);
    plot.label((0.0, -0.02), Side::Below, "$A$", Hue::Pink)?;
    drawing.label(at(144.0, 304.0), Side::Over, "(a) from the hoop", Hue::Ink)?;
    Ok(drawing)
}

/// The tip of ω in the room, seen along the angular momentum.
fn from_the_room(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 290.0, 320.0).titled(
        "The herpolhode of a hoop pinned at 60 degrees",
        "Seen along the angular momentum, the tip of omega traces a rosette of twelve loops between two dashed circles about the middle. Of its six periods the first is heavy, from a dot, \
         counter-clockwise, to another dot.",
    );
    let hoop = pinning(Shape::Hoop, 60.0)?;
    let (top, upright) = along_momentum(&hoop)?;
    let period = top.period().ok_or("it swings")?;
    let values = linear_steps(0.0, 6.0 * period, 6000)
        .map(|time| {
            let omega = upright * top.at(time)?.omega_world();
            Ok((omega.x, omega.y))
        })
        .collect::<Result<Vec<(f64, f64)>, InvalidQuantity>>()?;
    let reach = values.iter().map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max);
    let least = values.iter().map(|(x, y)| x.hypot(*y)).fold(f64::INFINITY, f64::min);
    let middle = at(145.0, 146.0);
    let mut plot = Plot::plane(&mut drawing, middle, 320.0, 0.42)?;
    for (radius, name) in [(least, "circle-inner"), (reach, "circle-outer")] {
        let circle =
            linear_steps(0.0, 2.0 * PI, 180).map(|angle| (radius * angle.cos(), radius * angle.sin()));
        plot.curve(name, circle, Stroke::Reference, Hue::Muted);
    }
    plot.curve("rosette", values[1000..].to_vec(), Stroke::Pale, Hue::Orange);
    plot.curve("first-period", values[..=1000].to_vec(), Stroke::Curve, Hue::Orange);
    plot.markers(&[values[0], values[1000]], Marker::Disc, Hue::Orange);
    let [before, here] = [plot.at(values[500]), plot.at(values[508])];
    kit::head(plot.drawing(), here, here - before, 1.0, Hue::Orange);
    kit::marker(plot.drawing(), middle, Marker::Out, Hue::Green);
    plot.label((0.01, -0.02), Side::BelowRight, r"$\boldsymbol{L}_A$", Hue::Green)?;
    plot.label((0.0, 0.08), Side::Over, r"tip of $\boldsymbol{\omega}$", Hue::Orange)?;
    drawing.label(at(145.0, 304.0), Side::Over, "(b) from the room", Hue::Ink)?;
    Ok(drawing)
}

/// Paths of the centres of a hoop and of a ball, pinned at the same place.
pub(crate) fn hoop_and_sphere(id: &str) -> Outcome {
    let hoop = path_of_centre(Shape::Hoop, "(a) hoop")?.titled(
        "Path of the centre of a pinned hoop",
        "A hoop, pinned at A. In the period that is drawn its centre goes more than once round the upright angular momentum, and nods as it goes, down and up again between two level dashed circles.",
    );
    let ball = path_of_centre(Shape::Sphere, "(b) ball")?.titled(
        "Path of the centre of a pinned ball",
        "A ball, pinned at A. Its centre goes round the upright angular momentum on one level circle.",
    );
    Ok(Drawing::panels(id, vec![hoop, ball]))
}

fn path_of_centre(shape: Shape, name: &str) -> Outcome {
    let mut drawing = Drawing::new("", 300.0, 300.0);
    let body = pinning(shape, 80.0)?;
    let (top, upright) = along_momentum(&body)?;
    // A period of the hoop, once round for the ball.
    let last = top.period().unwrap_or(7.0 * PI);
    let end = if shape == Shape::Hoop { last } else { 0.93 * last };
    let attitude = |time: f64| Ok::<_, InvalidQuantity>(upright * top.at(time)?.world_from_body);
    let centre = |time: f64| Ok::<_, InvalidQuantity>(attitude(time)? * body.centre());
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, -0.1],
        azimuth: 0.15,
        elevation: 0.32,
        distance: 12.0,
        centre: at(150.0, 170.0),
        scale: 76.0,
    })?);
    let path =
        linear_steps(0.0, end, 2000).map(centre).collect::<Result<Vec<Vector3<f64>>, InvalidQuantity>>()?;
    let place = |height: f64| {
        let radius = (1.0 - height * height).sqrt();
        Curve::circle([0.0, 0.0, height], [0.0, 0.0, 1.0], radius)
            .map(|circle| circle.hiding(Hiding::Ignored))
    };
    let heights = || path.iter().map(|place| place.z);
    let (lowest, highest) =
        (heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max));
    if highest - lowest > 1e-6 {
        for height in [lowest, highest] {
            stage.curve(place(height)?, Stroke::Reference, Hue::Muted)?;
        }
    }
    let solid = if shape == Shape::Hoop {
        Solid::ring(centre(end)?, attitude(end)? * Vector3::z(), 1.0, 0.9, 0.1)?
    } else {
        Solid::sphere(centre(end)?, 1.0)?
    };
    stage.solid(solid, Hue::Blue)?;
    let tip = path[path.len() - 1];
    stage.arrow(Curve::smooth(path)?.hiding(Hiding::Ignored), Stroke::Vector, Heads::End, Hue::Ink)?;
    stage.named_vector([0.0; 3], [0.0, 0.0, 1.15], r"$\boldsymbol{L}_A$", Hue::Green)?;
    stage.dot_in_front(tip, 2.5, Hue::Ink)?;
    stage.dot_in_front([0.0; 3], 4.5, Hue::Pink)?;
    stage.label_shifted([0.0; 3], at(2.0, -26.0), Side::Right, "$A$", Hue::Pink)?;
    stage.write(&mut drawing);
    drawing.label(at(150.0, 282.0), Side::Over, name, Hue::Ink)?;
    Ok(drawing)
}

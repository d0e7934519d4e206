//! What the page works out by hand: where the high spot is, a cross of four balls, a plate held at a corner, a ride on
//! the carousel, a quarter turn by two mirrors; and the brick that an exercise asks to draw.

use drawing::kit::{self, Heads};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Side, Stroke, at};
use figures::Outcome;
use mechanics::attitude::angle_between;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, PrincipalMoments};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// A flat and a long body with L upright: the side that is high is that of ω.
pub(crate) fn high_spot(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 270.0).titled(
        "Where the high spot is",
        "A plate seen from the side, and beside it a tall body. On both the angular momentum stands upright and the axis 3 leans to the left, so \
         that the left of the body is low and its right is high. On the plate the angular velocity leans to the right of the momentum, on the tall body \
         it lies between the axis and the momentum: both times on the right of the axis, on the high side.",
    );
    for (ratio, half, origin, name) in
        [(2.0, [74.0, 5.0], at(92.0, 158.0), "flat"), (1.0 / 3.0, [24.0, 64.0], at(264.0, 158.0), "long")]
    {
        let moments = PrincipalMoments::symmetric(1.0, ratio)?;
        let omega_body =
            if ratio > 1.0 { Vector3::new(0.75, 0.0, 1.0) } else { Vector3::new(0.13, 0.0, 1.15) };
        let momentum = moments.angular_momentum(&omega_body);
        let upright = UnitQuaternion::rotation_between(&momentum, &Vector3::z()).ok_or("L is not upright")?;
        let top = FreeSymmetricTop::new(moments, Turning { world_from_body: upright, omega_body })?;
        let now = top.start();
        let place = |v: Vector3<f64>| origin + at(v.x, -v.z);
        let [across, axis] = [Vector3::x(), Vector3::z()].map(|along| now.world_from_body * along);
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, z)| place(across * (x * half[0]) + axis * (z * half[1])));
        drawing.polygon(corners.to_vec(), Fill::Face, Hue::Blue);
        drawing.polyline(&[&corners[..], &corners[..1]].concat(), Stroke::Outline, Hue::Blue);
        for (tip, text, side, hue) in [
            (axis * 118.0, r"$\hat{\mathbf{3}}$", Side::AboveLeft, Hue::Ink),
            (Vector3::z() * 134.0, r"$\boldsymbol{L}$", Side::Above, Hue::Green),
            (now.omega_world().normalize() * 112.0, r"$\boldsymbol{\omega}$", Side::AboveRight, Hue::Orange),
        ] {
            kit::arrow(&mut drawing, origin, place(tip), hue);
            drawing.label(place(tip), side, text, hue)?;
        }
        drawing.dot(origin, 3.0, Hue::Ink);
        // The ends of the level line across, or the corners of the top.
        let [low, high] = [corners[3], corners[2]];
        let lift = if ratio > 1.0 { 12.0 } else { 0.0 };
        drawing.label(
            high + at(0.0, -lift),
            if ratio > 1.0 { Side::Over } else { Side::Right },
            "high",
            Hue::Blue,
        )?;
        if ratio > 1.0 {
            drawing.label(low + at(0.0, 20.0), Side::Over, "low", Hue::Blue)?;
        }
        drawing.label(at(origin.x, 254.0), Side::Over, name, Hue::Ink)?;
    }
    Ok(drawing)
}

/// A cross of four balls that turns at 45° to its axis: L is nearer to the axis than ω.
pub(crate) fn cross(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 320.0).titled(
        "A cross of four balls",
        "Two level rods that cross, with balls at their ends, along the axes 1 and 2; axis 3 points up. The angular velocity leans from axis 3 by 45 \
         degrees towards axis 1, the angular momentum by 26.6 degrees in the same plane.",
    );
    let moments = PrincipalMoments::symmetric(2.0, 4.0)?; // of four balls of 1 kg, 1 m from the middle
    let omega = Vector3::new(2.0, 0.0, 2.0);
    let momentum = moments.angular_momentum(&omega);
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.5],
        azimuth: -1.95,
        elevation: 0.3,
        distance: 9.0,
        centre: at(150.0, 165.0),
        scale: 92.0,
    })?);
    for arm in [Vector3::x(), Vector3::y()] {
        stage.solid(Solid::rod(-arm, arm, 0.025)?, Hue::Blue)?;
        for end in [arm, -arm] {
            stage.solid(Solid::sphere(end, 0.12)?, Hue::Blue)?;
        }
    }
    for (from, to, name) in [
        (Vector3::x() * 1.12, Vector3::x() * 1.5, r"$\hat{\mathbf{1}}$"),
        (Vector3::y() * 1.12, Vector3::y() * 1.6, r"$\hat{\mathbf{2}}$"),
        (Vector3::zeros(), Vector3::z() * 1.65, r"$\hat{\mathbf{3}}$"),
    ] {
        stage.named_vector(from, to, name, Hue::Ink)?;
    }
    stage.named_vector([0.0; 3], omega.normalize() * 1.6, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.named_vector([0.0; 3], momentum.normalize() * 1.6, r"$\boldsymbol{L}$", Hue::Green)?;
    let degrees = |v: &Vector3<f64>| angle_between(v, &Vector3::z()).to_degrees();
    for (vector, radius, hue, text) in [
        (&omega, 1.1, Hue::Orange, format!("{:.0}°", degrees(&omega))),
        (&momentum, 0.8, Hue::Green, format!("{:.1}°", degrees(&momentum))),
    ] {
        let arc = Curve::between([0.0; 3], Vector3::z(), *vector, radius)?;
        stage.curve(arc.hiding(Hiding::Ignored), Stroke::Outline, hue)?;
        if radius < 1.0 {
            stage.label_shifted(Vector3::z() * radius, at(-6.0, 0.0), Side::Left, &text, hue)?;
        } else {
            // Beyond its arc, between L and axis 3.
            let part = (momentum.normalize() + Vector3::z()).normalize() * 1.28;
            stage.label(part, Side::Over, &text, hue)?;
        }
    }
    stage.write(&mut drawing);
    Ok(drawing)
}

/// A square plate that is held at a corner and turned about an edge.
pub(crate) fn corner(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 300.0).titled(
        "A plate held at a corner",
        "A square plate hangs below its upper edge, the hinge. The angular velocity points along the hinge, from the upper right corner outwards to \
         the right. The angular momentum leans from it by 37 degrees downwards, to the side of the plate. Two dashed lines through the corner, the \
         plate’s diagonal and the line across it, are the principal axes.",
    );
    // The tensor of the page, over mh²: about the corner, along the edges.
    let inertia: Matrix3<f64> = Matrix3::new(4.0, -3.0, 0.0, -3.0, 4.0, 0.0, 0.0, 0.0, 8.0) / 12.0;
    let momentum = inertia * Vector3::x();
    let (origin, edge) = (at(170.0, 40.0), 150.0);
    let place = |v: Vector3<f64>| origin + at(v.x, -v.y);
    let corners = [(0.0, 0.0), (-1.0, 0.0), (-1.0, -1.0), (0.0, -1.0)]
        .map(|(x, y)| place(Vector3::new(x, y, 0.0) * edge));
    drawing.polygon(corners.to_vec(), Fill::Face, Hue::Blue);
    drawing.polyline(&[&corners[..], &corners[..1]].concat(), Stroke::Outline, Hue::Blue);
    for principal in inertia.symmetric_eigen().eigenvectors.column_iter().filter(|axis| axis.z.abs() < 0.5) {
        let along = Vector3::new(principal.x, principal.y, 0.0) * -principal.y.signum();
        let [back, out] = if along.x < 0.0 { [28.0, 190.0] } else { [28.0, 120.0] };
        drawing.line(place(along * -back), place(along * out), Stroke::Reference, Hue::Ink);
    }
    let name = place(Vector3::new(1.0, -1.0, 0.0) * 90.0);
    drawing.label(name, Side::Below, "principal axes", Hue::Ink)?;
    kit::arrow(&mut drawing, origin, place(Vector3::x() * 128.0), Hue::Orange);
    let tip = place(momentum.normalize() * 136.0);
    kit::arrow(&mut drawing, origin, tip, Hue::Green);
    drawing.label(place(Vector3::x() * 128.0), Side::Right, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    drawing.label(tip, Side::Right, r"$\boldsymbol{L}$", Hue::Green)?;
    let lean = angle_between(&momentum, &Vector3::x());
    kit::angle(&mut drawing, origin, 72.0, 0.0, -lean, Heads::None, Hue::Ink);
    let text = format!("{:.0}°", lean.to_degrees());
    drawing.label(origin + Point::polar(74.0, -0.45 * lean), Side::Right, &text, Hue::Ink)?;
    drawing.dot(origin, 4.0, Hue::Ink);
    drawing.label(place(Vector3::x() * -75.0), Side::Above, "hinge", Hue::Muted)?;
    drawing.label_on_face(place(Vector3::new(-0.68, -0.3, 0.0) * edge), Side::Over, "plate", Hue::Blue)?;
    Ok(drawing)
}

/// The carousel of axis and momentum turns with Λ, and on it the plate turns back with σ.
pub(crate) fn carousel(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 340.0).titled(
        "The rider’s carousel",
        "A level disc, the carousel, which turns counter-clockwise about the upright angular momentum with Lambda. Above it floats a plate whose axis leans from the \
         momentum. The upright plane through both, drawn as a frame, turns with the carousel. About the plate’s own axis an arrow goes \
         round the other way, minus sigma.",
    );
    let lean = 0.5_f64;
    let axis = Vector3::new(-lean.sin(), 0.0, lean.cos());
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.1],
        azimuth: -1.25,
        elevation: 0.5,
        distance: 9.0,
        centre: at(170.0, 180.0),
        scale: 92.0,
    })?);
    let floor = -0.85;
    stage.solid(Solid::disc([0.0, 0.0, floor], [0.0, 0.0, 1.0], 1.35, 0.05)?, Hue::Muted)?;
    stage.solid(Solid::disc([0.0; 3], axis, 0.8, 0.05)?, Hue::Blue)?;
    // The plane of the axis and L, which rides along.
    let frame = [(-1.2, floor + 0.03), (-1.2, 1.42), (0.0, 1.42), (0.0, floor + 0.03)];
    let frame = frame.map(|(x, z)| Vector3::new(x, 0.0, z));
    for edge in frame.windows(2) {
        stage.curve(
            Curve::segment(edge[0], edge[1])?.hiding(Hiding::Omitted),
            Stroke::Outline,
            Hue::Muted,
        )?;
    }
    stage.named_vector([0.0; 3], Vector3::z() * 1.65, r"$\boldsymbol{L}$", Hue::Green)?;
    stage.named_vector([0.0; 3], axis * 1.3, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    stage.turning([0.0, 0.0, floor + 0.03], Vector3::z(), 1.08, Hue::Orange)?;
    stage.label_shifted([1.08, 0.0, floor], at(2.0, 0.0), Side::Right, r"$\Lambda$", Hue::Orange)?;
    stage.turning(axis * 0.78, -axis, 0.26, Hue::Orange)?;
    stage.label_shifted(axis * 0.78, at(-27.0, 4.0), Side::Left, r"$-\sigma$", Hue::Orange)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The numbers of the page: two mirrors at 45° take axis 1 to axis 2.
pub(crate) fn quarter_turn(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 250.0).titled(
        "A quarter turn by two mirrors",
        "Two mirrors, seen end on along axis 3: the first is upright, its normal points to the right, the second falls to the right at 45 degrees, its \
         normal points up and to the right. An arrow along axis 1 points to the right. Its image in the first mirror points to the left, and the \
         image of that in the second points up, along axis 2.",
    );
    let origin = at(170.0, 140.0);
    let normals: [Vector3<f64>; 2] = [Vector3::x(), (Vector3::x() + Vector3::y()).normalize()];
    let reflected = |u: &Vector3<f64>, r: &Vector3<f64>| r - 2.0 * u.dot(r) * u;
    let place = |v: Vector3<f64>| origin + at(v.x, -v.y);
    for (u, text, side) in [(normals[0], "mirror 1", Side::Right), (normals[1], "mirror 2", Side::Right)] {
        let along = Vector3::new(-u.y, u.x, 0.0) * -96.0;
        drawing.line(place(along), place(-along), Stroke::Curve, Hue::Muted);
        drawing.label(place(along), side, text, Hue::Muted)?;
    }
    let start = Vector3::x() * 112.0;
    let image = reflected(&normals[0], &start);
    let end = reflected(&normals[1], &image);
    for (tip, text, side) in [
        (start, r"$\hat{\mathbf{1}}$", Side::Right),
        (image, "image in 1", Side::Above),
        (end, r"$\hat{\mathbf{2}}$, image in 2", Side::Right),
    ] {
        kit::arrow(&mut drawing, origin, place(tip), Hue::Ink);
        let shift = if side == Side::Above { at(18.0, 0.0) } else { at(0.0, 0.0) };
        drawing.label(place(tip) + shift, side, text, Hue::Ink)?;
    }
    kit::angle(&mut drawing, origin, 44.0, 0.0, FRAC_PI_2, Heads::End, Hue::Ink);
    drawing.label(origin + Point::polar(46.0, FRAC_PI_4), Side::AboveRight, "90°", Hue::Ink)?;
    drawing.dot(origin, 3.0, Hue::Ink);
    Ok(drawing)
}

/// A brick that turns about its diagonal: what an exercise asks to draw.
pub(crate) fn brick_momentum(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 270.0).titled(
        "The angular momentum of a brick that turns about its diagonal",
        "A brick, its long edge to the right. From its middle the angular velocity points through the corner at the right, far and above. The angular momentum leaves it by 33 degrees, away from the \
         long edge and towards the two short ones.",
    );
    let half = Vector3::new(1.0, 0.5, 0.3); // in 10 cm
    let omega = half.normalize();
    let momentum = Body::cuboid(1.0, [2.0, 1.0, 0.6])?.moments().angular_momentum(&omega).normalize();
    let mut stage = Stage::new(Camera::new(View {
        target: [0.25, 0.0, 0.2],
        azimuth: -1.25,
        elevation: 0.42,
        distance: 9.0,
        centre: at(160.0, 140.0),
        scale: 96.0,
    })?);
    let far = Vector3::new(-1.0, 1.0, -1.0); // the corner that cannot be seen
    for axis in 0..3 {
        for (one, other) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let mut corner = Vector3::zeros();
            corner[(axis + 1) % 3] = one;
            corner[(axis + 2) % 3] = other;
            let [from, to] = [-1.0, 1.0].map(|end| {
                let mut corner = corner;
                corner[axis] = end;
                corner
            });
            let is_hidden = from == far || to == far;
            let edge = Curve::segment(from.component_mul(&half), to.component_mul(&half))?;
            let stroke = if is_hidden { Stroke::Dotted } else { Stroke::Curve };
            stage.curve(edge.hiding(Hiding::Ignored), stroke, Hue::Blue)?;
        }
    }
    for (place, side, name) in [
        ([0.0, -0.5, -0.3], Side::Below, "20 cm"),
        ([1.0, 0.0, -0.3], Side::BelowRight, "10 cm"),
        ([-1.0, -0.5, 0.0], Side::Left, "6 cm"),
    ] {
        stage.label(place, side, name, Hue::Blue)?;
    }
    stage.named_vector([0.0; 3], omega * 1.7, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.named_vector([0.0; 3], momentum * 1.5, r"$\boldsymbol{L}$", Hue::Green)?;
    let arc = Curve::between([0.0; 3], omega, momentum, 0.95)?;
    stage.curve(arc.hiding(Hiding::Ignored), Stroke::Outline, Hue::Ink)?;
    let degrees = format!("{:.0}°", angle_between(&omega, &momentum).to_degrees());
    stage.label((omega + momentum).normalize() * 1.15, Side::Over, &degrees, Hue::Ink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

//! The figures of the chapter "How a body turns".

use crate::{Axis, Cause, Look, Outcome, Plot, Room, in_both, linear_steps};
use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Rect, Role, Side, Stroke, at};
use mechanics::InvalidQuantity;
use mechanics::attitude::rotation_between;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, Cylinder, PrincipalMoments, Spheroid};
use mechanics::integrate::{Dop853, rk4};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};

/// The chapter's plate, thrown so that its momentum is upright and its axis leans to one side by a good angle.
fn careless_plate(omega_body: Vector3<f64>, turned: f64) -> Result<FreeSymmetricTop, Cause> {
    let disc = Body::thin_disk(0.6, 0.13)?.moments();
    let momentum_body = disc.angular_momentum(&omega_body);
    let upright =
        UnitQuaternion::rotation_between(&momentum_body, &Vector3::z()).ok_or("L is not opposite to z")?;
    let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), turned);
    Ok(FreeSymmetricTop::new(disc, Turning { world_from_body: turned * upright, omega_body })?)
}

/// The way of a tip until it is this part of a round after its start, from what the library says.
fn way(top: &FreeSymmetricTop, seconds: f64, tip: impl Fn(&Turning) -> Vector3<f64>) -> Result<Curve, Cause> {
    let points = linear_steps(0.0, seconds, 120)
        .map(|time| Ok(tip(&top.at(time)?)))
        .collect::<Result<Vec<_>, InvalidQuantity>>()?;
    Ok(Curve::smooth(points)?.hiding(Hiding::Omitted))
}

/// The careless throw at five moments of one turn: the axis has gone round twice when the mark is back.
pub(crate) fn wobbles(id: &str) -> Outcome {
    let top = careless_plate(Vector3::new(0.62, 0.0, 1.5), 0.0)?;
    // A mark on a plate that wobbles but slightly goes round with ω₃: Λ cos θ − σ.
    let quarter = 0.25 * TAU / top.start().omega_body.z;
    let mut panels = Vec::new();
    for (quarters, name) in [
        (0.0, "start"),
        (1.0, r"$\tfrac14$ turn"),
        (2.0, r"$\tfrac12$ turn"),
        (3.0, r"$\tfrac34$ turn"),
        (4.0, "1 turn"),
    ] {
        let now = top.at(quarters * quarter)?;
        let (axis, mark) = (now.axis_3_world(), now.world_from_body * Vector3::new(-0.86, 0.0, 0.03));
        let round = (quarters * quarter * top.precession_rate() / TAU * 100.0).round() / 100.0;
        let mut drawing = Drawing::new("", 124.0, 190.0).titled(
            &format!("The plate after {quarters} quarter turns"),
            &format!("A leaning plate with a red mark near its rim and its axis; the axis has gone round {round} times."),
        );
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0, 0.0, 0.3],
            azimuth: -1.57,
            elevation: 0.42,
            distance: 8.0,
            centre: at(62.0, 92.0),
            scale: 46.0,
        })?);
        stage.solid(Solid::disc([0.0; 3], axis, 1.0, 0.06)?, Hue::Blue)?;
        stage.vector([0.0; 3], [0.0, 0.0, 1.45], Hue::Green)?;
        let circle = Curve::circle([0.0, 0.0, 1.3 * axis.z], Vector3::z(), 1.3 * axis.x.hypot(axis.y))?;
        stage.curve(circle.hiding(Hiding::Omitted), Stroke::Outline, Hue::Muted)?;
        stage.vector([0.0; 3], axis * 1.3, Hue::Ink)?;
        stage.dot_in_front(mark, 4.0, Hue::Pink)?;
        stage.write(&mut drawing);
        drawing.label(at(62.0, 152.0), Side::Over, name, Hue::Pink)?;
        let wobbles =
            ["", r"$\tfrac12$ wobble", "1 wobble", r"$1\tfrac12$ wobbles", "2 wobbles"][panels.len()];
        if !wobbles.is_empty() {
            drawing.label(at(62.0, 178.0), Side::Over, wobbles, Hue::Ink)?;
        }
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels).titled(
        "Two wobbles a turn",
        "Five stills of a plate after a careless throw, a quarter turn of the plate apart. A mark near the rim is at the left, in front, at the \
         right, behind, and at the left again. The axis leans to the left, to the right, to the left, to the right and to the left: it goes \
         half round for each quarter turn of the plate, and twice round for one turn.",
    ))
}

/// What stands still and what goes round, in the room and for a passenger on the plate.
pub(crate) fn views(id: &str) -> Outcome {
    let top = careless_plate(Vector3::new(1.15, 0.0, 1.5), PI + 0.35)?;
    let rounds = [TAU / top.precession_rate(), TAU / top.body_rate()];
    let momentum = top.angular_momentum_world();
    let length = 1.5 / top.start().omega_body.norm();
    let mut panels = Vec::new();
    for (on_board, name, words) in [
        (
            false,
            r"in the room: $\boldsymbol{L}$ stands still",
            "The plate leans. The momentum L points straight up; the axis 3 and the angular velocity go round it, on opposite sides, \
             counter-clockwise as seen from above.",
        ),
        (
            true,
            r"on the plate: $\hat{\mathbf{3}}$ stands still",
            "The plate lies level and its axis 3 points straight up. Both L and the angular velocity lean to the same side, the angular \
             velocity further, and go round the axis, counter-clockwise as seen from above.",
        ),
    ] {
        let mut drawing = Drawing::new("", 320.0, 330.0).titled(name_of(on_board), words);
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0, 0.0, 0.45],
            azimuth: -1.35,
            elevation: 0.36,
            distance: 8.0,
            centre: at(160.0, 170.0),
            scale: 92.0,
        })?);
        // What is seen of a state: turned into the room, or along the axes of the plate.
        let seen = |turning: &Turning, vector: Vector3<f64>| {
            if on_board { vector } else { turning.world_from_body * vector }
        };
        let axis = |turning: &Turning| seen(turning, Vector3::z() * 1.5);
        let omega = |turning: &Turning| seen(turning, turning.omega_body * length);
        let steady = |turning: &Turning| {
            let body = turning.world_from_body.inverse() * momentum.normalize() * 1.7;
            seen(turning, body)
        };
        let now = top.at(0.0)?;
        stage.solid(Solid::disc([0.0; 3], axis(&now), 1.0, 0.05)?, Hue::Blue)?;
        let most = 0.86 * rounds[usize::from(on_board)];
        stage.arrow(way(&top, most, omega)?, Stroke::Outline, Heads::End, Hue::Orange)?;
        if on_board {
            stage.arrow(way(&top, most, steady)?, Stroke::Outline, Heads::End, Hue::Green)?;
        } else {
            stage.arrow(way(&top, most, axis)?, Stroke::Outline, Heads::End, Hue::Ink)?;
        }
        let (beside_omega, beside_momentum) =
            if on_board { (Side::Right, Side::Right) } else { (Side::Left, Side::Above) };
        for (tip, side, name, hue) in [
            (axis(&now), if on_board { Side::Above } else { Side::Right }, r"$\hat{\mathbf{3}}$", Hue::Ink),
            (steady(&now), beside_momentum, r"$\boldsymbol{L}$", Hue::Green),
            (omega(&now), beside_omega, r"$\boldsymbol{\omega}$", Hue::Orange),
        ] {
            stage.vector([0.0; 3], tip, hue)?;
            let step = match side {
                Side::Left => at(-10.0, -4.0),
                Side::Right => at(8.0, -6.0),
                _ => at(0.0, 2.0),
            };
            stage.label_shifted(tip, step, side, name, hue)?;
        }
        stage.write(&mut drawing);
        drawing.label(at(160.0, 300.0), Side::Over, name, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels))
}

fn name_of(on_board: bool) -> &'static str {
    if on_board { "The motion on the plate" } else { "The motion in the room" }
}

/// The plane of axis, angular momentum and angular velocity for a flat and for a long body.
pub(crate) fn split(id: &str) -> Outcome {
    let panels = [
        (
            2.0,
            r"flat: $I_3 = 2I_1$",
            "A flat body: the axis 3 points straight up. The angular momentum divided by I1 points up and to the right at a small angle. \
             A dashed line straight down from its tip, minus sigma along the axis, leads to the tip of the angular velocity, which leans \
             further: the momentum lies between the other two.",
        ),
        (
            1.0 / 3.0,
            r"long: $I_3 = \tfrac13I_1$",
            "A long body with the same angular velocity: the momentum leans further than the angular velocity, which is reached from its tip \
             by going up.",
        ),
    ];
    let mut drawn = Vec::new();
    for (ratio, name, words) in panels {
        let scale = 82.0;
        let mut drawing = Drawing::new("", 300.0, 350.0).titled("Axis, momentum and angular velocity", words);
        let moments = PrincipalMoments::symmetric(1.0, ratio)?;
        let start =
            Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(1.1, 0.0, 1.25) };
        let top = FreeSymmetricTop::new(moments, start)?;
        let momentum = top.angular_momentum_world() / moments.to_array()[0];
        let origin = at(110.0, 268.0);
        let place = |v: Vector3<f64>| origin + at(v.x * scale, -v.z * scale);
        let tip_of_axis = origin - at(0.0, 250.0);
        let (tip_of_momentum, tip_of_omega) = (place(momentum), place(start.omega_body));
        // The body itself, edge on, behind its arrows.
        let [half_width, half_height] = if ratio > 1.0 { [72.0, 7.0] } else { [13.0, 46.0] };
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| origin + at(x * half_width, y * half_height));
        drawing.polygon(corners.to_vec(), Fill::Face, Hue::Blue);
        let outline: Vec<Point> = corners.into_iter().chain([corners[0]]).collect();
        drawing.polyline(&outline, Stroke::Outline, Hue::Blue);
        drawing.line(tip_of_momentum, tip_of_omega, Stroke::Reference, Hue::Ink);
        kit::arrow(&mut drawing, origin, tip_of_axis, Hue::Ink);
        kit::arrow(&mut drawing, origin, tip_of_momentum, Hue::Green);
        kit::arrow(&mut drawing, origin, tip_of_omega, Hue::Orange);
        drawing.label(tip_of_axis, Side::Right, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        let (side_of_momentum, side_of_omega) =
            if ratio > 1.0 { (Side::AboveRight, Side::Right) } else { (Side::Right, Side::AboveRight) };
        drawing.label(tip_of_momentum, side_of_momentum, r"$\boldsymbol{L}/I_1$", Hue::Green)?;
        drawing.label(tip_of_omega, side_of_omega, r"$\boldsymbol{\omega}$", Hue::Orange)?;
        let middle = tip_of_momentum.towards(tip_of_omega, 0.5);
        drawing.label(middle, Side::Right, r"$-\sigma\,\hat{\mathbf{3}}$", Hue::Ink)?;

        // The angle that stays: between the axis and the momentum.
        let lean = top.momentum_angle();
        let upright = 0.25 * TAU;
        let radius = if ratio > 1.0 { 96.0 } else { 70.0 };
        kit::angle(&mut drawing, origin, radius, upright, -lean, Heads::None, Hue::Ink);
        let label = origin + Point::polar(radius, upright - 0.45 * lean);
        drawing.label(label, Side::Above, r"$\theta_L$", Hue::Ink)?;
        drawing.dot(origin, 3.0, Hue::Ink);
        drawing.label(origin + at(if ratio > 1.0 { 0.0 } else { 30.0 }, 68.0), Side::Over, name, Hue::Ink)?;
        drawn.push(drawing);
    }
    Ok(Drawing::panels(id, drawn))
}

/// Bodies in the order of I₃/I₁, from the pencil to the coin.
pub(crate) fn bodies(id: &str) -> Outcome {
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), room.of(300.0, 620.0)).titled(
            "Bodies in the order of their moments",
            "An axis of the ratio I3 over I1 from 0 to 2 with small pictures of bodies at their places, all with their axis 3 upright. Cylinders: a \
             pencil at almost nothing, one as long as three of its radii at a half, one as long as the root of three at 1, a thick disc as \
             high as its radius at one and a half, a coin at almost 2. Spheroids: a long one at a fifth, an egg at a half, a ball at 1, a \
             lentil at 1.6. A hoop stands at 2. Those below 1 are called long, those above flat.",
        );
        // Along the axis: to the right on a wide page, downwards on a narrow one.
        let (start, unit) = room.of((at(50.0, 152.0), at(275.0, 0.0)), (at(206.0, 50.0), at(0.0, 250.0)));
        let aside = room.of(at(0.0, -1.0), at(-1.0, 0.0));
        let place = |ratio: f64| start + unit * ratio;
        drawing.line(place(0.0), place(2.0), Stroke::Axis, Hue::Ink);
        for tick in 0..=4 {
            let ratio = 0.5 * f64::from(tick);
            let foot = place(ratio);
            drawing.line(foot - aside * 5.0, foot, Stroke::Axis, Hue::Ink);
            let side = room.of(Side::Below, Side::Right);
            let number = ["0", "0.5", "1.0", "1.5", "2.0"][tick as usize];
            drawing.label_set(foot - aside * 5.0, side, 4.0, 13.0, number, Role::PlainText(Hue::Ink))?;
        }
        let cylinder = |height: f64| Body::cylinder(1.0, Cylinder { radius: 1.0, height });
        let spheroid =
            |polar: f64| Body::spheroid(1.0, Spheroid { equatorial_radius: 1.0, polar_radius: polar });
        let upper = [
            (cylinder(20.0)?, Form::Cylinder(20.0), "pencil"),
            (cylinder(3.0)?, Form::Cylinder(3.0), "can"),
            (cylinder(3_f64.sqrt())?, Form::Cylinder(3_f64.sqrt()), "short can"),
            (cylinder(1.0)?, Form::Cylinder(1.0), "thick disc"),
            (cylinder(0.12)?, Form::Cylinder(0.12), "coin"),
        ];
        let lower = [
            (spheroid(3.0)?, Form::Spheroid(3.0), "cigar"),
            (spheroid(3_f64.sqrt())?, Form::Spheroid(3_f64.sqrt()), "egg"),
            (Body::sphere(1.0, 1.0)?, Form::Spheroid(1.0), "ball"),
            (spheroid(0.5)?, Form::Spheroid(0.5), "lentil"),
            (Body::hoop(1.0, 1.0)?, Form::Hoop, "hoop"),
        ];
        for (row, sign) in [(upper, 1.0), (lower, -1.0)] {
            for (body, form, name) in row {
                let [i1, _, i3] = body.moments().to_array();
                let foot = place(i3 / i1);
                let centre = foot + aside * (sign * room.of(72.0, 88.0));
                let (near, far) = if sign > 0.0 { (4.0, 34.0) } else { room.of((26.0, 36.0), (32.0, 50.0)) };
                drawing.line(
                    foot + aside * (sign * near),
                    foot + aside * (sign * far),
                    Stroke::Dotted,
                    Hue::Muted,
                );
                icon(&mut drawing, centre, form)?;
                let (step, side) = match (room, sign > 0.0) {
                    (Room::Wide, true) => (at(0.0, -46.0), Side::Above),
                    (Room::Wide, false) => (at(0.0, 46.0), Side::Below),
                    (Room::Narrow, true) => (at(-34.0, 0.0), Side::Left),
                    (Room::Narrow, false) => (at(34.0, 0.0), Side::Right),
                };
                drawing.label(centre + step, side, name, Hue::Ink)?;
            }
        }
        // What the ratio decides.
        let end = place(2.0) + room.of(at(36.0, 0.0), at(0.0, 40.0));
        drawing.label(end, room.of(Side::Over, Side::Over), "$I_3/I_1$", Hue::Ink)?;
        Ok(drawing)
    })
}

/// What is drawn for a body, with lengths in radii.
#[derive(Clone, Copy)]
enum Form {
    Cylinder(f64),
    Spheroid(f64),
    Hoop,
}

/// A small picture of a body with its axis upright.
fn icon(drawing: &mut Drawing, centre: Point, form: Form) -> Result<(), Cause> {
    let scale = match form {
        Form::Cylinder(height) => 34.0 / (0.5 * height).max(1.0),
        Form::Spheroid(polar) => 32.0 / polar.max(1.0),
        Form::Hoop => 32.0,
    };
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0; 3],
        azimuth: -1.2,
        elevation: 0.36,
        distance: 40.0,
        centre,
        scale,
    })?);
    let axis = [0.0, 0.0, 1.0];
    stage.solid(
        match form {
            Form::Cylinder(height) => Solid::disc([0.0; 3], axis, 1.0, height)?,
            Form::Spheroid(polar) => {
                let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], axis];
                Solid::ellipsoid([0.0; 3], [x, y, z], [1.0, 1.0, polar])?
            }
            Form::Hoop => Solid::ring([0.0; 3], axis, 1.0, 0.86, 0.1)?,
        },
        Hue::Blue,
    )?;
    stage.write(drawing);
    Ok(())
}

/// The triangle of possible moments.
pub(crate) fn possible_moments(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 400.0).titled(
        "Which three numbers are moments",
        "A square with the smaller two moments over the largest along its sides, from 0 to 1. Only the half above the falling diagonal is \
         tinted: there are bodies. A ball stands in its upper right corner, a pencil near the upper left one, a coin in the middle of the \
         diagonal, on which all flat bodies lie, a brick of 20 by 10 by 6 inside. The numbers 2, 3, 9 lie in the empty half.",
    );
    let over_largest = |moments: PrincipalMoments| {
        let mut sorted = moments.to_array();
        sorted.sort_by(f64::total_cmp);
        (sorted[0] / sorted[2], sorted[1] / sorted[2])
    };
    let first = Axis::linear(0.0, 1.0, 0.5)?.minor(0.1).titled("$I_1/I_3$");
    let second = Axis::linear(0.0, 1.0, 0.5)?.minor(0.1).titled("$I_2/I_3$, where $I_3$ is the largest");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 40.0, 300.0, 300.0), first, second)?;
    let corners = [(0.0, 1.0), (1.0, 0.0), (1.0, 1.0)].map(|corner| plot.at(corner));
    plot.drawing().polygon(corners.to_vec(), Fill::Ground, Hue::Blue);
    plot.curve("flat", [(0.0, 1.0), (1.0, 0.0)], Stroke::Curve, Hue::Blue);
    let cylinder = |height: f64| Body::cylinder(1.0, Cylinder { radius: 1.0, height });
    for (body, name, side) in [
        (Body::sphere(1.0, 1.0)?, "ball", Side::BelowLeft),
        (cylinder(20.0)?, "pencil", Side::BelowRight),
        (cylinder(0.0)?, "coin", Side::AboveRight),
        (Body::cuboid(2.0, [0.20, 0.10, 0.06])?, "brick", Side::Right),
    ] {
        let place = over_largest(body.moments());
        plot.markers(&[place], Marker::Disc, Hue::Blue);
        let clear_of_the_edge = at(if name == "pencil" { 12.0 } else { 0.0 }, 0.0);
        let place = plot.at(place) + clear_of_the_edge;
        plot.drawing().label_on_face(place, side, name, Hue::Ink)?;
    }
    let place = plot.at((0.62, 0.22));
    plot.drawing().label(place, Side::BelowLeft, "flat bodies", Hue::Blue)?;
    let nothing = (2.0 / 9.0, 3.0 / 9.0);
    plot.markers(&[nothing], Marker::Ring, Hue::Muted);
    plot.label(nothing, Side::Below, "$(2, 3, 9)$: no body", Hue::Muted)?;
    Ok(drawing)
}

/// What ten seconds of stepping do to the quaternion.
pub(crate) fn drift(id: &str) -> Outcome {
    let plate = Body::thin_disk(0.6, 0.13)?.moments();
    let start =
        Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(1.5, 0.0, 30.0) };
    let seconds = 10.0;
    let top = FreeSymmetricTop::new(plate, start)?;
    let exact = top.at(seconds)?.world_from_body;
    let wobbles = seconds * top.precession_rate() / TAU;
    let free = || euler::turning_rates(plate, |_, _| Vector3::zeros());
    let (mut lengths, mut attitudes) = (Vec::new(), Vec::new());
    for half_octave in 4..=18 {
        let per_wobble = 2_f64.powf(0.5 * f64::from(half_octave));
        let steps = (per_wobble * wobbles).round() as usize;
        let state = rk4(free(), 0.0, start.to_array(), seconds, steps)?;
        let length = state[..4].iter().map(|part| part * part).sum::<f64>().sqrt();
        let per_wobble = steps as f64 / wobbles;
        lengths.push((per_wobble, (length - 1.0).abs()));
        let found = Turning::from_array(state).world_from_body;
        attitudes.push((per_wobble, rotation_between(&found, &exact)));
    }
    let judge = Dop853::new(1e-13)?.solve(free(), 0.0, start.to_array(), seconds)?;
    let closed = rotation_between(&Turning::from_array(judge.state).world_from_body, &exact);

    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(660.0, 400.0), 372.0).titled(
            "Length and error of a stepped quaternion",
            "Both scales are logarithmic: along x the steps a wobble of the Runge-Kutta method of order four, from four to five hundred; \
             along y errors after 96 wobbles. The error of the attitude falls with the fourth power, from a tenth of a radian to \
             3e-10. The error of the length of the quaternion, \
             falling with the fifth power, lies below it, by a factor of forty at twenty steps. A horizontal line at 3e-13 \
             is the difference between the closed form and the judge.",
        );
        let steps = Axis::log(4.0, 600.0, 1)?.titled("steps a wobble");
        let error = Axis::log(1e-14, 10.0, 2)?.titled("error after 96 wobbles");
        let frame = Rect::new(60.0, 34.0, room.of(570.0, 316.0), 286.0);
        let mut plot = Plot::new(&mut drawing, frame, steps, error)?;
        plot.level(closed, Stroke::Reference);
        plot.series("attitude", &attitudes, Look::RK4.marker, Look::RK4.hue);
        plot.series("length", &lengths, Marker::Ring, Look::RK4.hue);
        let labelled = nearest(&attitudes, 45.0)?;
        plot.label(labelled, Side::AboveRight, "attitude, rad", Look::RK4.hue)?;
        let labelled = nearest(&lengths, room.of(30.0, 45.0))?;
        plot.label(labelled, Side::BelowLeft, "length", Look::RK4.hue)?;
        plot.label((5.0, closed), Side::AboveRight, "closed form, against DOP853", Hue::Muted)?;
        Ok(drawing)
    })
}

/// The point of a curve whose x is nearest.
fn nearest(values: &[(f64, f64)], x: f64) -> Result<(f64, f64), Cause> {
    let far = |value: &(f64, f64)| (value.0 / x).ln().abs();
    let found = values.iter().min_by(|a, b| far(a).total_cmp(&far(b)));
    found.copied().ok_or_else(|| "an empty curve has no nearest point".into())
}

//! The figures of the chapter "How a body turns".

use drawing::kit::{self, Heads, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Rect, Role, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, Room, figures, in_both, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, Cylinder, PrincipalMoments, Spheroid};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    specks,
    shares,
    by_hand::cross,
    by_hand::corner,
    by_hand::high_spot,
    by_hand::brick_momentum,
    split,
    by_hand::carousel,
    wobbles,
    mirrors,
    by_hand::quarter_turn,
    bodies,
    possible_moments,
    middle_axis::polhodes,
    middle_axis::bat_flip
];

#[path = "figures/by_hand.rs"]
pub(crate) mod by_hand;
#[path = "figures/middle_axis.rs"]
pub(crate) mod middle_axis;

/// The chapter's plate, thrown so that its momentum is upright and its axis leans to one side by a good angle.
fn careless_plate(omega_body: Vector3<f64>) -> Result<FreeSymmetricTop, Cause> {
    let disc = Body::thin_disk(0.6, 0.13)?.moments();
    let momentum_body = disc.angular_momentum(&omega_body);
    let upright =
        UnitQuaternion::rotation_between(&momentum_body, &Vector3::z()).ok_or("L is not opposite to z")?;
    Ok(FreeSymmetricTop::new(disc, Turning { world_from_body: upright, omega_body })?)
}

/// The way of a point from the start for some seconds, from what the library says.
fn way(top: &FreeSymmetricTop, seconds: f64, tip: impl Fn(&Turning) -> Vector3<f64>) -> Result<Curve, Cause> {
    let points = linear_steps(0.0, seconds, 120)
        .map(|time| Ok(tip(&top.at(time)?)))
        .collect::<Result<Vec<_>, InvalidQuantity>>()?;
    Ok(Curve::smooth(points)?.hiding(Hiding::Pale))
}

/// The careless throw at five moments of one turn: the axis has gone round twice when the mark is back. Below each the
/// cones from above: the hoop in the plate, the waist in the room.
pub(crate) fn wobbles(id: &str) -> Outcome {
    let top = careless_plate(Vector3::new(0.62, 0.0, 1.5))?;
    // A mark on a plate that wobbles but slightly goes round with ω₃: Λ cos θ − σ.
    let quarter = 0.25 * TAU / top.start().omega_body.z;
    // So slight that rims are circles from above; all is drawn in units of the tangent of the waist's half-angle.
    let slight = careless_plate(Vector3::new(0.015, 0.0, 1.5))?;
    let mut panels = Vec::new();
    for (quarters, name, wobbles) in [
        (0.0, "start", ""),
        (1.0, r"$\tfrac14$ turn", r"$\tfrac12$ wobble"),
        (2.0, r"$\tfrac12$ turn", "1 wobble"),
        (3.0, r"$\tfrac34$ turn", r"$1\tfrac12$ wobbles"),
        (4.0, "1 turn", "2 wobbles"),
    ] {
        let now = top.at(quarters * quarter)?;
        let (axis, mark) = (now.axis_3_world(), now.world_from_body * Vector3::new(-0.86, 0.0, 0.03));
        let round = (quarters * quarter * top.precession_rate() / TAU * 100.0).round() / 100.0;
        let mut drawing = Drawing::new("", 184.0, 330.0).titled(
            &format!("Plate and hoop after {quarters} quarter turns"),
            &format!(
                "Above, a leaning plate with a mark near its rim and its axis; the axis has gone round {round} times. Below, a small circle, and a \
                 circle twice as wide round it that touches it from outside at one side, with a mark on its rim."
            ),
        );
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0, 0.0, 0.3],
            azimuth: -1.57,
            elevation: 0.36,
            distance: 8.0,
            centre: at(92.0, 100.0),
            scale: 64.0,
        })?);
        stage.solid(Solid::disc([0.0; 3], axis, 1.0, 0.06)?, Hue::Blue)?;
        stage.vector([0.0; 3], [0.0, 0.0, 1.45], Hue::Green)?;
        let circle = Curve::circle([0.0, 0.0, 1.3 * axis.z], Vector3::z(), 1.3 * axis.x.hypot(axis.y))?;
        stage.curve(circle.hiding(Hiding::Omitted), Stroke::Outline, Hue::Muted)?;
        stage.vector([0.0; 3], axis * 1.3, Hue::Ink)?;
        stage.dot_in_front(mark, 4.5, Hue::Pink)?;
        if quarters == 0.0 {
            stage.label(Vector3::z() * 1.45, Side::AboveRight, r"$\boldsymbol{L}$", Hue::Green)?;
            stage.label_shifted(axis * 1.3, at(-6.0, 0.0), Side::Left, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        }
        stage.write(&mut drawing);
        hoop(&mut drawing, at(92.0, 226.0), &slight, quarters)?;
        drawing.label(at(92.0, 296.0), Side::Over, name, Hue::Pink)?;
        if !wobbles.is_empty() {
            drawing.label(at(92.0, 322.0), Side::Over, wobbles, Hue::Ink)?;
        }
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels).titled(
        "Two wobbles a turn",
        "Two rows of five stills of a plate after a careless throw, a quarter turn of the plate apart. In the upper row a mark near the rim is at \
         the left, in front, at the right, behind, and at the left again. The axis leans to the left, to the right, to the left, to the right and \
         to the left: it goes half round for each quarter turn of the plate, and twice round for one turn. The lower row is seen from above. A \
         small circle stands still; a circle of twice its size hangs round it, and touches it at one point. The point of contact is at the right, \
         at the left, at the right, at the left, and at the right again; the mark on the large circle goes round once.",
    ))
}

/// The cones of a slight wobble from above, so many quarter turns of the plate after the start, with the waist about a
/// point.
fn hoop(drawing: &mut Drawing, middle: Point, top: &FreeSymmetricTop, quarters: f64) -> Result<(), Cause> {
    let [theta, theta_l] = [top.omega_angle(), top.momentum_angle()];
    let [hoop, waist] = [theta.sin(), (theta - theta_l).sin()];
    let scale = 17.0 / waist;
    let now = top.at(0.25 * quarters * TAU / top.start().omega_body.z)?;
    let place = |v: Vector3<f64>| middle + at(v.x, -v.y) * scale;
    let axis = place(now.axis_3_world());
    let reach = at(51.0, 0.0); // of the hoop, on any side: what stands still in the room
    drawing.line(middle - reach, middle + reach, Stroke::Dotted, Hue::Muted);
    drawing.circle(middle, waist * scale, Role::Line(Stroke::Curve, Hue::Green));
    drawing.circle(axis, hoop * scale, Role::Line(Stroke::Curve, Hue::Blue));
    drawing.dot(middle, 3.0, Hue::Green);
    drawing.dot(axis, 3.0, Hue::Ink);
    drawing.dot(place(now.omega_world().normalize()), 6.0, Hue::Orange);
    let mark = now.world_from_body * (Vector3::new(-hoop, 0.0, theta.cos()));
    drawing.circle(place(mark), 5.5, Role::Area(Fill::Page, Hue::Pink));
    drawing.dot(place(mark), 4.0, Hue::Pink);
    if quarters == 0.0 {
        drawing.label(middle + at(0.0, 50.0), Side::Over, "from above", Hue::Muted)?;
    }
    Ok(())
}

/// Two specks of a plate on circles of their own, in four stills a quarter turn apart, and the high spot.
pub(crate) fn specks(id: &str) -> Outcome {
    let top = careless_plate(Vector3::new(0.4, 0.0, 1.5))?;
    let turn = TAU / top.start().omega_body.z;
    // One where the plate is high at the start, one a quarter of the plate ahead of it.
    let specks = [(Vector3::x(), Hue::Pink), (Vector3::y(), Hue::Ink)];
    let mut panels = Vec::new();
    for (quarters, turned, high, words) in [
        (
            0.0,
            "plate: 0",
            "high spot: 0",
            "A leaning plate with two specks on its rim, each on its path, a tilted circle: the pink speck is on the right, at the top of its \
             circle; the other is behind, half-way up a circle that is high on the left. An arrow points to the high spot on the right.",
        ),
        (
            1.0,
            r"plate: $\tfrac14$ turn",
            r"high spot: $\tfrac12$ turn",
            "A quarter turn later: the pink speck is behind, half-way down; the other is on the left at the top of its circle, where the arrow is \
             now.",
        ),
        (
            2.0,
            r"plate: $\tfrac12$ turn",
            "high spot: 1 turn",
            "Another quarter turn later: the pink speck is on the left, at the bottom of its circle; the other is in front, half-way down. The arrow \
             is on the right again.",
        ),
        (
            3.0,
            r"plate: $\tfrac34$ turn",
            r"high spot: $1\tfrac12$ turns",
            "Three quarters after the start: the pink speck is in front, half-way up; the other is on the right, at the bottom of its circle. The \
             arrow is on the left.",
        ),
    ] {
        let now = top.at(0.25 * quarters * turn)?;
        let axis = now.axis_3_world();
        let mut drawing = Drawing::new("", 240.0, 210.0).titled("Two specks and the high spot", words);
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0; 3],
            azimuth: -1.57,
            elevation: 0.3,
            distance: 9.0,
            centre: at(120.0, 92.0),
            scale: 98.0,
        })?);
        stage.solid(Solid::disc([0.0; 3], axis, 0.93, 0.03)?, Hue::Blue)?;
        for (speck, hue) in specks {
            let place = now.world_from_body * speck;
            let path = way(&top, turn, |state| state.world_from_body * speck)?.hiding(Hiding::Dashed);
            stage.curve(path, Stroke::Curve, hue)?;
            stage.curve(Curve::segment([0.0; 3], place)?.hiding(Hiding::Ignored), Stroke::Outline, hue)?;
            stage.dot_in_front(place, 5.0, hue)?;
        }
        let up = (Vector3::z() - axis * axis.z).normalize();
        let arrow = Curve::segment(up + Vector3::z() * 0.62, up + Vector3::z() * 0.12)?;
        stage.arrow(arrow.hiding(Hiding::Ignored), Stroke::Vector, Heads::End, Hue::Ink)?;
        if quarters == 0.0 {
            stage.label(up + Vector3::z() * 0.62, Side::Left, "high spot", Hue::Ink)?;
        }
        stage.write(&mut drawing);
        drawing.label(at(120.0, 168.0), Side::Over, turned, Hue::Ink)?;
        drawing.label(at(120.0, 194.0), Side::Over, high, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels).titled(
        "One turn of the plate, two of its high spot",
        "Four stills, a quarter turn apart, of a leaning plate with two specks a quarter of it apart, each on a tilted circle of its own that stands \
         still. At the start the plate is high on the right, where the pink speck is at the top of its circle; then on the left, where the \
         other is at the top of its own; then on the right again, and then on the left: the high spot goes half round in each quarter turn.",
    ))
}

/// How far the plate of `shares` leans from the upright line about which it is turned.
const LEAN: f64 = 0.62;

/// Each speck's share of the angular momentum of a plate that is turned about an upright line, and the pulls it takes.
pub(crate) fn shares(id: &str) -> Outcome {
    let slope = Vector3::new(LEAN.cos(), 0.0, LEAN.sin());
    let axis = Vector3::new(-LEAN.sin(), 0.0, LEAN.cos());
    let specks = [slope, -slope, Vector3::y(), -Vector3::y()];
    let share = |r: &Vector3<f64>| r.cross(&Vector3::z().cross(r));
    let sum: Vector3<f64> = specks.iter().map(share).sum();
    let stage_of = |azimuth: f64, elevation: f64| -> Result<Stage, Cause> {
        Ok(Stage::new(Camera::new(View {
            target: [0.0, 0.0, 0.35],
            azimuth,
            elevation,
            distance: 8.0,
            centre: at(160.0, 150.0),
            scale: 96.0,
        })?))
    };

    let mut left = Drawing::new("", 320.0, 310.0).titled(
        "Shares of the angular momentum",
        "A plate that leans, its right side high, and four specks on its rim: left, right, in front and behind. Thin arrows at the specks show \
         their shares of the angular momentum: in front and behind they point straight up, on the slope they lean to the left. The angular \
         velocity points straight up from the centre; the angular momentum, the sum, leans to the left of it, and the axis 3 leans further.",
    );
    let mut stage = stage_of(-1.2, 0.36)?;
    stage.solid(Solid::disc([0.0; 3], axis, 1.0, 0.04)?, Hue::Blue)?;
    for speck in &specks {
        let arrow = Curve::segment(*speck, speck + 0.55 * share(speck))?.hiding(Hiding::Ignored);
        stage.arrow(arrow, Stroke::Outline, Heads::End, Hue::Green)?;
        stage.curve(
            Curve::segment([0.0; 3], *speck)?.hiding(Hiding::Ignored),
            Stroke::Outline,
            Hue::Muted,
        )?;
        stage.dot_in_front(*speck, 4.0, Hue::Ink)?;
    }
    for (vector, name, hue) in [
        (Vector3::z() * 1.55, r"$\boldsymbol{\omega}$", Hue::Orange),
        (sum.normalize() * 1.45, r"$\boldsymbol{L}$", Hue::Green),
        (axis * 1.35, r"$\hat{\mathbf{3}}$", Hue::Ink),
    ] {
        stage.vector([0.0; 3], vector, hue)?;
        stage.label_shifted(vector, at(0.0, 2.0), Side::Above, name, hue)?;
    }
    stage.write(&mut left);
    left.label(at(160.0, 286.0), Side::Over, "shares, and their sum", Hue::Ink)?;

    let mut right = Drawing::new("", 320.0, 310.0).titled(
        "The pulls that the specks need",
        "The same plate from the side, a line that rises to the right. From the high speck on the right an arrow points level to the left, \
         towards the upright line; from the low speck on the left one points level to the right, along a lower line.",
    );
    let mut stage = stage_of(-0.25 * TAU, 0.0)?;
    stage.solid(Solid::disc([0.0; 3], axis, 1.0, 0.04)?, Hue::Blue)?;
    stage.vector([0.0; 3], Vector3::z() * 1.55, Hue::Orange)?;
    stage.label_shifted(
        Vector3::z() * 1.55,
        at(0.0, 2.0),
        Side::Above,
        r"$\boldsymbol{\omega}$",
        Hue::Orange,
    )?;
    for speck in [slope, -slope] {
        // What keeps it on its circle: ω × (ω × r).
        let pull = Vector3::z().cross(&Vector3::z().cross(&speck));
        let arrow = Curve::segment(speck, speck + 0.8 * pull)?.hiding(Hiding::Ignored);
        stage.arrow(arrow, Stroke::Vector, Heads::End, Hue::Purple)?;
        stage.dot_in_front(speck, 4.0, Hue::Ink)?;
    }
    stage.write(&mut right);
    right.label(at(160.0, 286.0), Side::Over, "pulls that nobody provides", Hue::Ink)?;
    Ok(Drawing::panels(id, vec![left, right]))
}

/// A flag, its image in one mirror, and the image of that in another.
pub(crate) fn mirrors(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 300.0).titled(
        "Two mirrors are a turn",
        "Two lines through one point, mirrors seen end on, at 35 degrees to each other. A flag below the first; its image above it, pale, the \
         other way round; and the image of that in the second mirror, the same way round as the flag and turned from it by 70 degrees.",
    );
    let origin = at(40.0, 250.0);
    let [first, half] = [28_f64.to_radians(), 35_f64.to_radians()];
    let normal = |angle: f64| Vector3::new(-angle.sin(), angle.cos(), 0.0);
    let [u1, u2] = [normal(first), normal(first + half)];
    // A mirror with the normal u, and both of them: the quaternion of eq:quaternion-turn.
    let reflected = |u: &Vector3<f64>, r: &Vector3<f64>| r - 2.0 * u.dot(r) * u;
    let turn = UnitQuaternion::from_quaternion(Quaternion::from_parts(u1.dot(&u2), u1.cross(&u2)));
    let flag = [(130.0, 0.0), (220.0, 0.0), (220.0, 30.0), (189.0, 15.0), (189.0, 0.0)];
    let flag = flag
        .map(|(x, y)| UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.06) * Vector3::new(x, y, 0.0));
    let image = flag.map(|r| reflected(&u1, &r));
    let turned = flag.map(|r| turn * r);
    let place = |v: &Vector3<f64>| origin + at(v.x, -v.y);
    for (angle, name, mirror) in [
        (first, r"$\hat{\boldsymbol{u}}_1$", "mirror 1"),
        (first + half, r"$\hat{\boldsymbol{u}}_2$", "mirror 2"),
    ] {
        let end = origin + Point::polar(240.0, angle);
        drawing.line(origin, end, Stroke::Curve, Hue::Muted);
        let tip = place(&(Vector3::new(angle.cos(), angle.sin(), 0.0) * 240.0 + normal(angle) * 38.0));
        kit::arrow(&mut drawing, end, tip, Hue::Ink);
        drawing.label(end, Side::Right, mirror, Hue::Muted)?;
        drawing.label(tip, Side::Above, name, Hue::Ink)?;
    }
    for (points, fill, stroke) in [
        (image, Fill::Ghost, Stroke::Outline),
        (flag, Fill::Face, Stroke::Curve),
        (turned, Fill::Face, Stroke::Curve),
    ] {
        let points: Vec<Point> = points.iter().map(place).collect();
        drawing.polygon(points[1..].to_vec(), fill, Hue::Blue);
        drawing.polyline(&[&points[..], &points[1..2]].concat(), stroke, Hue::Blue);
    }
    kit::angle(&mut drawing, origin, 62.0, first, half, Heads::None, Hue::Ink);
    let label = origin + Point::polar(66.0, first + 0.5 * half);
    drawing.label(label, Side::AboveRight, r"$\tfrac12\chi$", Hue::Ink)?;
    kit::angle(&mut drawing, origin, 112.0, 0.06, 2.0 * half, Heads::End, Hue::Ink);
    let label = origin + Point::polar(116.0, 0.06 + half - 0.25);
    drawing.label(label, Side::Right, r"$\chi$", Hue::Ink)?;
    drawing.dot(origin, 3.0, Hue::Ink);
    Ok(drawing)
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
        drawing.line(tip_of_momentum, tip_of_omega, Stroke::Reference, Hue::Orange);
        kit::arrow(&mut drawing, origin, tip_of_axis, Hue::Ink);
        kit::arrow(&mut drawing, origin, tip_of_momentum, Hue::Green);
        kit::arrow(&mut drawing, origin, tip_of_omega, Hue::Orange);
        drawing.label(tip_of_axis, Side::Right, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        let (side_of_momentum, side_of_omega) =
            if ratio > 1.0 { (Side::AboveRight, Side::Right) } else { (Side::Right, Side::AboveRight) };
        drawing.label(tip_of_momentum, side_of_momentum, r"$\boldsymbol{L}/I_1$", Hue::Green)?;
        drawing.label(tip_of_omega, side_of_omega, r"$\boldsymbol{\omega}$", Hue::Orange)?;
        let middle = tip_of_momentum.towards(tip_of_omega, 0.5);
        drawing.label(middle, Side::Right, r"$-\sigma\,\hat{\mathbf{3}}$", Hue::Orange)?;

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
        let mut drawing = Drawing::new(id, room.of(580.0, 400.0), room.of(300.0, 620.0)).titled(
            "Bodies in the order of their moments",
            "An axis of the ratio I3 over I1 from 0 to 2 with small pictures of bodies at their places, all with their axis 3 upright. Cylinders: a \
             pencil at almost nothing, one as long as three of its radii at a half, one as long as the root of three at 1, a thick disc as \
             high as its radius at one and a half, a coin at almost 2. Spheroids: a long one at a fifth, an egg at a half, a ball at 1, a \
             lentil at 1.6. A hoop stands at 2. Those below 1 are called long, those above flat.",
        );
        // Along the axis: to the right on a wide page, downwards on a narrow one.
        let (start, unit) = room.of((at(36.0, 152.0), at(238.0, 0.0)), (at(206.0, 50.0), at(0.0, 250.0)));
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
                // In a row all names stand on one line.
                let (step, side) = match (room, sign > 0.0) {
                    (Room::Wide, true) => (at(0.0, -56.0), Side::Over),
                    (Room::Wide, false) => (at(0.0, 60.0), Side::Over),
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
    let mut drawing = Drawing::new(id, 340.0, 350.0).titled(
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
    let first = Axis::linear(0.0, 1.0, 0.5).minor(0.1).titled("$I_1/I_3$");
    let second = Axis::linear(0.0, 1.0, 0.5).minor(0.1).titled("$I_2/I_3$, where $I_3$ is the largest");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 40.0, 260.0, 260.0), first, second)?;
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
        let clear_of_the_edge = at(if name == "pencil" { 20.0 } else { 0.0 }, 0.0);
        let place = plot.at(place) + clear_of_the_edge;
        plot.drawing().label_on_face(place, side, name, Hue::Ink)?;
    }
    let place = plot.at((0.71, 0.31));
    plot.drawing().label_on_face(place, Side::Right, "thin plates", Hue::Blue)?;
    let line = [(0.69, 0.31), (0.715, 0.31)].map(|value| plot.at(value));
    plot.drawing().line(line[0], line[1], Stroke::Outline, Hue::Blue);
    let nothing = (2.0 / 9.0, 3.0 / 9.0);
    plot.markers(&[nothing], Marker::Ring, Hue::Muted);
    plot.label(nothing, Side::BelowRight, "no body", Hue::Muted)?;
    plot.label(nothing, Side::AboveLeft, "$(2, 3, 9)$", Hue::Muted)?;
    Ok(drawing)
}

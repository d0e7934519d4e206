//! The figures of the chapter "The struck space station".

use drawing::kit::{self, Heads, head};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Rect, Role, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, PrincipalMoments};
use mechanics::integrate::Dop853;
use mechanics::scenes::space_station::{Blow, Station, StationParameters, StruckStation};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] =
    figures![station, equal_speed, crew_sky, two_arrows, station_views, cones_roll, nodding, tube_sky];

/// Mass, kg, radius, m, spin, rad/s, and impulse, N·s, of the chapter.
const MASS: f64 = 4e5;
const RADIUS: f64 = 50.0;
const SPIN: f64 = 0.45;
const IMPULSE: f64 = 1.8e6;
/// Twice that, N·s, so that angles can be seen.
const STRONG: f64 = 2.0 * IMPULSE;

/// The station after a blow on the rim.
fn struck(impulse: f64) -> Result<StruckStation, InvalidQuantity> {
    let station = Station::new(StationParameters { body: Body::hoop(MASS, RADIUS)?, spin: SPIN })?;
    station.struck(Blow { radius: RADIUS, impulse })
}

/// Adds the station about the origin: a rim of radius 1, a hub and four spokes.
fn station_in(stage: &mut Stage, attitude: &UnitQuaternion<f64>) -> Result<(), Cause> {
    let axis = attitude * Vector3::z();
    stage.solid(Solid::ring([0.0; 3], axis, 1.0, 0.86, 0.16)?, Hue::Blue)?;
    stage.solid(Solid::sphere([0.0; 3], 0.15)?, Hue::Blue)?;
    for quarter in 0..4 {
        let (sin, cos) = (0.25 * TAU * (f64::from(quarter) + 0.5)).sin_cos();
        let outwards = attitude * Vector3::new(cos, sin, 0.0);
        stage.solid(Solid::rod(outwards * 0.1, outwards * 0.9, 0.03)?, Hue::Blue)?;
    }
    Ok(())
}

/// The station at the moment of the blow: impulse, old and new angular velocity, angular momentum.
pub(crate) fn station(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 400.0).titled(
        "The station at the moment of the blow",
        "A wheel with hub and spokes, seen from above at an angle, with axes 1 and 2 in its plane and 3 \
         upright. From below a ship comes to the rim where axis 2 meets it, and the impulse P points up \
         there. From the hub the new angular velocity omega leans from axis 3 towards axis 1 by the angle \
         theta, and the angular momentum L by the smaller angle theta L.",
    );
    let struck = struck(STRONG)?;
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.35],
        azimuth: 0.85,
        elevation: 0.42,
        distance: 8.0,
        centre: at(190.0, 205.0),
        scale: 112.0,
    })?);
    station_in(&mut stage, &struck.at(0.0)?.world_from_body)?;
    let omega = struck.at(0.0)?.omega_body.normalize();
    let momentum = struck.angular_momentum_world().normalize();
    stage.named_vector([0.0; 3], [1.75, 0.0, 0.0], r"$\hat{\mathbf{1}}$", Hue::Ink)?;
    stage.named_vector([0.0; 3], [0.0, 1.5, 0.0], r"$\hat{\mathbf{2}}$", Hue::Ink)?;
    stage.named_vector([0.0; 3], [0.0, 0.0, 1.9], r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    stage.named_vector([0.0; 3], omega * 1.75, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.named_vector([0.0; 3], momentum * 1.8, r"$\boldsymbol{L}$", Hue::Green)?;
    for (to, radius, name) in [(momentum, 0.98, r"$\theta_L$"), (omega, 1.32, r"$\theta$")] {
        stage.angle([0.0; 3], Vector3::z(), to, radius, "", Hue::Ink)?;
        let between = if to == omega { omega + momentum } else { momentum + Vector3::z() };
        let middle = between.normalize() * radius;
        stage.label_shifted(middle, at(0.0, -1.0), Side::Above, name, Hue::Ink)?;
    }
    let rim = [0.0, 0.93, 0.08];
    stage.solid(Solid::sphere([0.0, 0.93, -0.72], 0.045)?, Hue::Muted)?;
    stage.curve(Curve::segment([0.0, 0.93, -0.67], [0.0, 0.93, -0.08])?, Stroke::Dotted, Hue::Muted)?;
    stage.label_shifted([0.0, 0.93, -0.72], at(4.0, 0.0), Side::Right, "ship", Hue::Muted)?;
    stage.named_vector(rim, [0.0, 0.93, 0.85], r"$\boldsymbol{P}$", Hue::Pink)?;
    stage.dot(rim, 3.5, Hue::Pink)?;
    stage.turning([0.0, 0.0, 1.6], [0.0, 0.0, 1.0], 0.17, Hue::Orange)?;
    stage.label_shifted([0.0, 0.0, 1.6], at(20.0, 0.0), Side::Right, r"$\omega_0$", Hue::Orange)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// Half the field of view of the camera at the hub, rad; the middle of its picture and the radius, px.
const FIELD: f64 = 50.0 * TAU / 360.0;
const MIDDLE: Point = Point { x: 110.0, y: 112.0 };
const RADIUS_OF_PICTURE: f64 = 98.0;

/// Where the camera, which looks along axis 3, sees a direction of the body: axis 2 to the right and axis 1 up, circles
/// on the sky as circles, the edge of the field at 1.
fn in_picture(direction: &Vector3<f64>) -> (f64, f64) {
    let scale = 1.0 / ((1.0 + direction.z) * (0.5 * FIELD).tan());
    (direction.y * scale, direction.x * scale)
}

/// Stars all over the half of the sky about axis 3, spread evenly: steps of the golden angle, equal areas.
fn stars(count: u32) -> impl Iterator<Item = Vector3<f64>> {
    (0..count).map(move |k| {
        let part = (f64::from(k) + 0.5) / f64::from(count);
        let (z, turn) = (1.0 - part, 2.399_963 * f64::from(k));
        let across = (1.0 - z * z).sqrt();
        Vector3::new(across * turn.cos(), across * turn.sin(), z)
    })
}

/// One picture of the sky from the hub: the trails of stars while the shutter is open, but about a place that is kept
/// clear for a name, and the pole about which they turn.
fn sky(
    [name, below, description]: [&str; 3],
    station: &StruckStation,
    (open, exposure): (f64, f64),
    count: u32,
    clear: (f64, f64),
) -> Result<(Drawing, Point), Cause> {
    let title = format!("The sky from the hub {}", &below[4..]);
    let mut drawing = Drawing::new("", 220.0, 260.0).titled(&title, description);
    let mut plot = Plot::plane(&mut drawing, MIDDLE, RADIUS_OF_PICTURE, 1.0)?;
    let mut ends = Vec::new();
    for (star, direction) in stars(count).enumerate() {
        let trail = linear_steps(open, open + exposure, 400)
            .map(|time| Ok(in_picture(&(station.at(time)?.world_from_body.inverse() * direction))))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        let shown = |&(x, y): &(f64, f64)| x.hypot(y) < 0.985 && (x - clear.0).hypot(y - clear.1) > 0.14;
        if trail.iter().all(shown) {
            plot.curve(&format!("{name}-{star}"), trail.iter().copied(), Stroke::Outline, Hue::Ink);
            ends.extend(trail.last().copied());
        }
    }
    let places: Vec<Point> = ends.into_iter().map(|end| plot.at(end)).collect();
    let pole = plot.at(in_picture(&station.at(open)?.omega_body.normalize()));
    for place in places {
        drawing.dot(place, 1.6, Hue::Ink);
    }
    drawing.circle(MIDDLE, RADIUS_OF_PICTURE, Role::Line(Stroke::Outline, Hue::Muted));
    for step in [at(5.0, 0.0), at(0.0, 5.0)] {
        drawing.line(MIDDLE - step, MIDDLE + step, Stroke::Vector, Hue::Ink);
    }
    drawing.label(MIDDLE + at(0.0, RADIUS_OF_PICTURE + 22.0), Side::Over, below, Hue::Ink)?;
    Ok((drawing, pole))
}

/// What a camera at the hub sees: star trails before the blow, just after it, and over a whole turn.
pub(crate) fn crew_sky(id: &str) -> Outcome {
    let (calm, struck) = (struck(0.0)?, struck(IMPULSE)?);
    let turn = TAU / SPIN;
    let (mut before, middle) = sky(
        [
            "before",
            "(a) before the blow",
            "Short arcs of circles about the middle of the picture, where axis 3 points; stars go round it \
             counter-clockwise.",
        ],
        &calm,
        (0.0, turn / 9.0),
        130,
        (0.1, 0.09),
    )?;
    before.label(middle + at(1.0, -1.0), Side::AboveRight, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    let exposure = turn / 18.0;
    let (mut after, pole) = sky(
        [
            "after",
            "(b) just after it",
            "Short arcs again, but about a pole above the middle, in the direction of the angular velocity \
             omega. An arrow shows that this pole itself goes round the middle, clockwise.",
        ],
        &struck,
        (0.0, exposure),
        130,
        (-0.14, 0.4),
    )?;
    after.label(pole, Side::Left, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    after.dot(pole, 3.5, Hue::Orange);
    let mut plot = Plot::plane(&mut after, MIDDLE, RADIUS_OF_PICTURE, 1.0)?;
    let poles = linear_steps(0.0, 0.2 * turn, 60)
        .map(|time| Ok(in_picture(&struck.at(time)?.omega_body.normalize())))
        .collect::<Result<Vec<_>, InvalidQuantity>>()?;
    plot.curve("pole", poles.iter().copied(), Stroke::Outline, Hue::Orange);
    let [from, to] = [poles.len() - 3, poles.len() - 1].map(|index| plot.at(poles[index]));
    head(&mut after, to + (to - from).unit() * 6.0, to - from, 0.8, Hue::Orange);
    let later = whole_turn(&struck, turn)?;
    Ok(Drawing::panels(id, vec![before, after, later]))
}

/// The third picture of the sky: four stars by their distance from L, in units of its lean, and their heading from L at
/// the start, in turns from the cross.
const CHOSEN: [(&str, f64, f64); 4] =
    [("at-momentum", 0.0, 0.0), ("old-pole", 1.0, 0.0), ("ellipse-1", 2.6, 0.0), ("ellipse-2", 2.6, 0.5)];

/// The trails of a few stars while the shutter is open for a whole turn.
fn whole_turn(struck: &StruckStation, turn: f64) -> Outcome {
    let mut drawing = Drawing::new("", 220.0, 260.0).titled(
        "The sky from the hub, a whole turn",
        "Four trails about the cross. A star in the direction of L draws a small circle. The star that stood on the cross \
         draws nearly a straight line through it, to both sides. Two others draw nearly ellipses, which cross each other.",
    );
    let momentum = struck.angular_momentum_world().normalize();
    // From L towards the place of axis 3 at the start, and across.
    let towards = (Vector3::z() - momentum * momentum.z).normalize();
    let across = momentum.cross(&towards);
    let mut plot = Plot::plane(&mut drawing, MIDDLE, RADIUS_OF_PICTURE, 1.0)?;
    for (name, distance, heading) in CHOSEN {
        let (sin, cos) = (TAU * heading).sin_cos();
        let (from_momentum, along) =
            ((distance * struck.momentum_angle()).sin_cos(), towards * cos + across * sin);
        let star = momentum * from_momentum.1 + along * from_momentum.0;
        let trail = linear_steps(0.0, turn, 400)
            .map(|time| Ok(in_picture(&(struck.at(time)?.world_from_body.inverse() * star))))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        let stroke = if name == "old-pole" { Stroke::Curve } else { Stroke::Axis };
        plot.curve(name, trail.iter().copied(), stroke, Hue::Ink);
        let end = plot.at(trail[trail.len() - 1]);
        plot.drawing().dot(end, if name == "old-pole" { 2.6 } else { 1.9 }, Hue::Ink);
    }
    drawing.circle(MIDDLE, RADIUS_OF_PICTURE, Role::Line(Stroke::Outline, Hue::Muted));
    for step in [at(5.0, 0.0), at(0.0, 5.0)] {
        drawing.line(MIDDLE - step, MIDDLE + step, Stroke::Vector, Hue::Ink);
    }
    drawing.label(
        MIDDLE + at(0.0, RADIUS_OF_PICTURE + 22.0),
        Side::Over,
        "(c) a whole turn, shutter open",
        Hue::Ink,
    )?;
    Ok(drawing)
}

/// A blow so small that the sky about axis 3 is flat: a hundredth of that of the text.
fn tapped() -> Result<StruckStation, InvalidQuantity> {
    struck(0.01 * IMPULSE)
}

/// The tip of axis 3 just after a blow: one speed, on a circle about ω and on one half as wide about L.
pub(crate) fn equal_speed(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 330.0, 300.0).titled(
        "One speed on two circles",
        "Looking down on the tips of three directions. On the right is the tip of axis 3. To its left, at half of the way and at \
         the whole, are L and omega. A small circle about L and a dashed one, twice as wide, about omega touch at axis 3, and \
         one arrow, the velocity of the tip, is tangent to both.",
    );
    let struck = tapped()?;
    // Looking down, axis 1 of the first moment to the left, in units of the lean of ω.
    let theta = struck.axis_angle();
    let place = |direction: Vector3<f64>| (-direction.x / theta, -direction.y / theta);
    let mut plot = Plot::plane(&mut drawing, at(210.0, 150.0), 112.0, 2.5)?;
    let nod = TAU / struck.nodding_rate();
    let nodding = linear_steps(0.0, nod, 200)
        .map(|time| Ok(place(struck.at(time)?.axis_3_world())))
        .collect::<Result<Vec<_>, InvalidQuantity>>()?;
    // What it would do if ω stayed in its place.
    let omega = struck.at(0.0)?.omega_world().normalize();
    let kept = linear_steps(0.0, TAU, 200)
        .map(|angle| place(UnitQuaternion::from_scaled_axis(omega * angle) * Vector3::z()));
    plot.curve("about-omega", kept, Stroke::DashedCurve, Hue::Muted);
    plot.curve("about-momentum", nodding.iter().copied(), Stroke::Curve, Hue::Ink);
    let [tip, spin, momentum] = [
        plot.at(nodding[0]),
        plot.at(place(omega)),
        plot.at(place(struck.angular_momentum_world().normalize())),
    ];
    // The way that its speed would make in an eighth of an old turn.
    let speed = struck.at(0.0)?.omega_world().cross(&Vector3::z()) * (TAU / SPIN / 8.0);
    let ahead = plot.at(place(speed + Vector3::z()));
    let middle = plot.at(nodding[76]);
    let before = plot.at(nodding[70]);
    for (end, name, side) in [(spin, r"$\theta$", -15.0), (momentum, r"$\tfrac12\theta$", 17.0)] {
        let step = at(0.0, side);
        kit::dimension(&mut drawing, end + step, tip + step, Heads::Both, Hue::Muted);
        let place = (end + step).towards(tip + step, if side > 0.0 { 0.5 } else { 0.25 });
        let beside = if side > 0.0 { Side::Below } else { Side::Above };
        drawing.label(place, beside, name, Hue::Ink)?;
    }
    kit::arrow(&mut drawing, tip, ahead, Hue::Ink);
    drawing.label(tip.towards(ahead, 0.6), Side::Right, "speed", Hue::Ink)?;
    head(&mut drawing, middle, middle - before, 0.8, Hue::Ink);
    for (point, name, side, hue) in [
        (spin, r"$\boldsymbol{\omega}$", Side::Left, Hue::Orange),
        (momentum, r"$\boldsymbol{L}$", Side::Left, Hue::Green),
        (tip, r"$\hat{\mathbf{3}}$", Side::Right, Hue::Ink),
    ] {
        drawing.dot(point, 4.0, hue);
        drawing.label(point, side, name, hue)?;
    }
    drawing.label(spin - at(0.0, 66.0), Side::Over, r"if $\boldsymbol{\omega}$ stayed", Hue::Muted)?;
    Ok(drawing)
}

/// The star that stood on the cross, as the sum of two arrows of one length: four moments.
pub(crate) fn two_arrows(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 336.0, 310.0).titled(
        "The star is the sum of two arrows that turn against each other",
        "Four pictures of the sky about the cross, a quarter of a nod apart, from an eighth of a nod on. A green arrow from the cross to L \
         turns clockwise on a circle. From its tip an arrow of the same length to the star turns the other way. At an \
         eighth the star is a little to one side of the cross, at three eighths and five eighths farther off, at seven eighths \
         near it again, all the time nearly on one straight line.",
    );
    let struck = tapped()?;
    // The length of either arrow, px.
    const SHORT: f64 = 44.0;
    let lean = struck.momentum_angle();
    let place = |direction: &Vector3<f64>| (direction.y / lean, direction.x / lean);
    let nod = TAU / struck.nodding_rate();
    let momentum = struck.angular_momentum_world().normalize();
    for (still, name) in
        [r"$\tfrac18$ nod", r"$\tfrac38$", r"$\tfrac58$", r"$\tfrac78$"].into_iter().enumerate()
    {
        let cross = at(54.0 + 166.0 * (still % 2) as f64, 62.0 + 152.0 * (still / 2) as f64);
        let mut plot = Plot::plane(&mut drawing, cross, SHORT, 2.2)?;
        let time = (still as f64 / 4.0 + 0.125) * nod;
        let on_board = struck.at(time)?.world_from_body.inverse();
        let trail = linear_steps(0.0, time, 100)
            .map(|time| Ok(place(&(struck.at(time)?.world_from_body.inverse() * Vector3::z()))))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(&format!("star-{still}"), trail, Stroke::Orbit, Hue::Muted);
        let [tip, star] = [momentum, Vector3::z()].map(|direction| plot.at(place(&(on_board * direction))));
        drawing.circle(cross, SHORT, Role::Line(Stroke::Dotted, Hue::Muted));
        for step in [at(5.0, 0.0), at(0.0, 5.0)] {
            drawing.line(cross - step, cross + step, Stroke::Vector, Hue::Ink);
        }
        kit::arrow(&mut drawing, cross, tip, Hue::Green);
        kit::arrow(&mut drawing, tip, star, Hue::Ink);
        drawing.dot(star, 4.0, Hue::Ink);
        drawing.label(tip + (tip - cross).unit() * 13.0, Side::Over, r"$\boldsymbol{L}$", Hue::Green)?;
        if still == 0 {
            drawing.label(star + at(14.0, 0.0), Side::Right, "star", Hue::Ink)?;
        }
        drawing.label(cross + at(22.0, 76.0), Side::Over, name, Hue::Ink)?;
    }
    Ok(drawing)
}

/// The same motion in the room and on board.
pub(crate) fn station_views(id: &str) -> Outcome {
    let struck = struck(STRONG)?;
    let momentum = struck.angular_momentum_world().normalize();
    let upright =
        UnitQuaternion::rotation_between(&momentum, &Vector3::z()).ok_or("L is not opposite to z")?;
    let view = |title: &str, description: &str| -> Result<(Drawing, Stage), Cause> {
        let drawing = Drawing::new("", 320.0, 360.0).titled(title, description);
        let camera = Camera::new(View {
            target: [0.0, 0.0, 0.4],
            azimuth: -1.2,
            elevation: 0.36,
            distance: 9.0,
            centre: at(160.0, 165.0),
            scale: 96.0,
        })?;
        Ok((drawing, Stage::new(camera)))
    };
    // Where a direction goes in most of a period, so that an arrow shows its sense.
    let path = |stage: &mut Stage, to: f64, place: &dyn Fn(f64) -> Result<Vector3<f64>, Cause>, hue: Hue| {
        let path = linear_steps(0.0, 0.93 * to, 150)
            .map(|time| Ok(place(time)? * 0.85))
            .collect::<Result<Vec<_>, Cause>>()?;
        stage.arrow(Curve::smooth(path)?.hiding(Hiding::Ignored), Stroke::Outline, Heads::End, hue)?;
        Ok::<(), Cause>(())
    };
    // Begins where axis 3 leans to the left on the page and towards the eye.
    let nod = TAU / struck.nodding_rate();
    let (in_room, on_board) = (0.02 * nod, 0.1 * TAU / struck.body_rate());

    let (mut room, mut stage) = view(
        "The struck station in the room",
        "The angular momentum L stands upright and still. The wheel leans; its axis 3 goes round L on a \
         circle, counter-clockwise from above, and the angular velocity omega, on the other side of L, \
         goes round with it.",
    )?;
    let start = struck.at(in_room)?;
    station_in(&mut stage, &(upright * start.world_from_body))?;
    let length = 1.65;
    let axis = |time: f64| Ok(upright * struck.at(in_room + time)?.axis_3_world() * length);
    let omega = |time: f64| Ok(upright * struck.at(in_room + time)?.omega_world().normalize() * length);
    path(&mut stage, nod, &axis, Hue::Ink)?;
    path(&mut stage, nod, &omega, Hue::Orange)?;
    stage.named_vector([0.0; 3], [0.0, 0.0, 1.9], r"$\boldsymbol{L}$", Hue::Green)?;
    stage.named_vector([0.0; 3], axis(0.0)?, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    stage.named_vector([0.0; 3], omega(0.0)?, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.write(&mut room);
    room.label(at(160.0, 306.0), Side::Over, "in the room:", Hue::Ink)?;
    let rate = struck.nodding_rate() / SPIN;
    let name = format!(r"$\hat{{\mathbf{{3}}}}$ goes round $\boldsymbol{{L}}$ at ${rate:.1}\,\omega_0$");
    room.label(at(160.0, 327.0), Side::Over, &name, Hue::Ink)?;

    let (mut board, mut stage) = view(
        "The struck station on board",
        "The wheel lies level and its axis 3 stands upright. The angular velocity omega and, nearer to the \
         axis, the angular momentum L go round it on circles, counter-clockwise from above.",
    )?;
    station_in(&mut stage, &UnitQuaternion::identity())?;
    let omega = |time: f64| Ok(struck.at(on_board + time)?.omega_body.normalize() * length);
    let momentum = |time: f64| {
        let state = struck.at(on_board + time)?;
        Ok(state.world_from_body.inverse() * struck.angular_momentum_world().normalize() * length)
    };
    let turn = TAU / struck.body_rate();
    path(&mut stage, turn, &omega, Hue::Orange)?;
    path(&mut stage, turn, &momentum, Hue::Green)?;
    stage.named_vector([0.0; 3], [0.0, 0.0, 1.9], r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    stage.named_vector([0.0; 3], omega(0.0)?, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.named_vector([0.0; 3], momentum(0.0)?, r"$\boldsymbol{L}$", Hue::Green)?;
    stage.write(&mut board);
    board.label(at(160.0, 306.0), Side::Over, "on board:", Hue::Ink)?;
    board.label(
        at(160.0, 327.0),
        Side::Over,
        r"$\boldsymbol{\omega}$ and $\boldsymbol{L}$ go round $\hat{\mathbf{3}}$ at $\omega_0$",
        Hue::Ink,
    )?;
    Ok(Drawing::panels(id, vec![room, board]))
}

/// A body cone that rolls on a space cone, both seen across the plane of the three axes: the momentum upright, the
/// axis of the body to the left.
fn rolling_cones(
    [title, description, name]: [&str; 3],
    top: &FreeSymmetricTop,
    target: [f64; 3],
    cut: bool,
) -> Outcome {
    let mut drawing = Drawing::new("", 320.0, 350.0).titled(title, description);
    let mut stage = Stage::new(Camera::new(View {
        target,
        azimuth: -FRAC_PI_2,
        elevation: 0.3,
        distance: 9.0,
        centre: at(165.0, 170.0),
        scale: 130.0,
    })?);
    let (body_angle, lean) = (top.omega_angle(), top.momentum_angle());
    let towards = |angle: f64| Vector3::new(angle.sin(), 0.0, angle.cos());
    let (axis, omega) = (towards(-lean), towards(body_angle - lean));
    let length = 1.3;
    let body_cone = if cut {
        Solid::half_cone([0.0; 3], axis, body_angle, length, [0.0, -1.0, 0.0])?
    } else {
        Solid::cone([0.0; 3], axis, body_angle, length)?
    };
    stage.solid(body_cone, Hue::Blue)?;
    stage.solid(Solid::cone([0.0; 3], Vector3::z(), (body_angle - lean).abs(), length)?, Hue::Green)?;
    stage.named_vector([0.0; 3], [0.0, 0.0, 1.75], r"$\boldsymbol{L}$", Hue::Green)?;
    stage.named_vector([0.0; 3], axis * 1.75, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
    let arrow = Curve::segment([0.0; 3], omega * 1.85)?.hiding(Hiding::Ignored);
    stage.arrow(arrow, Stroke::Vector, Heads::End, Hue::Orange)?;
    let contact = Curve::segment([0.0; 3], omega * length)?.hiding(Hiding::Ignored);
    stage.curve(contact, Stroke::Curve, Hue::Orange)?;
    let side = if cut { Side::Right } else { Side::Above };
    stage.label(omega * 1.85, side, r"$\boldsymbol{\omega}$", Hue::Orange)?;
    stage.write(&mut drawing);
    drawing.label(at(165.0, 304.0), Side::Over, name, Hue::Ink)?;
    Ok(drawing)
}

/// The cone fixed in the body rolling on the cone fixed in space, for the station and for a long body.
pub(crate) fn cones_roll(id: &str) -> Outcome {
    let top = |ratio: f64, degrees: f64| -> Result<FreeSymmetricTop, InvalidQuantity> {
        let omega_body = Vector3::new(degrees.to_radians().tan(), 0.0, 1.0);
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
        FreeSymmetricTop::new(PrincipalMoments::symmetric(1.0, ratio)?, start)
    };
    let flat = rolling_cones(
        [
            "The cones of the station",
            "A narrow cone stands upright about the angular momentum L; it is fixed in space. A wide cone, \
             about the axis 3 of the station, which leans to the left, is cut open; the narrow one stands \
             inside it, and the two touch along the angular velocity omega, to the right of L.",
            "flat: rolls round it like a hula hoop",
        ],
        &top(2.0, 40.0)?,
        [0.0, 0.0, 0.75],
        true,
    )?;
    let long = rolling_cones(
        [
            "The cones of a long body",
            "The cone about the angular momentum L, fixed in space, stands upright; the cone about the \
             axis 3 of the body lies beside it, to the left. They touch from outside along the angular \
             velocity omega, between L and 3.",
            "long: rolls on its outside",
        ],
        &top(0.4, 20.0)?,
        [-0.3, 0.0, 0.75],
        false,
    )?;
    Ok(Drawing::panels(id, vec![flat, long]))
}

/// How far the axis is to one side of L, in the room, and omega to one side of axis 3, on board.
pub(crate) fn nodding(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 320.0).titled(
        "Nods in the room and turns on board",
        "Two waves against time in turns of the old spin, from 0 to 4, one above the other. Above, how \
         far the axis of the station is to one side of the angular momentum: a wave with eight numbered \
         crests, a little closer than two a turn, through rings from a simulation. Below, how far the angular velocity is to \
         one side of the axis on board: a wave with four numbered crests.",
    );
    let struck = struck(IMPULSE)?;
    let period = TAU / SPIN;
    let momentum = struck.angular_momentum_world().normalize();
    // To one side: across L in the plane in which the axis begins, in units of the farthest.
    let aside = (Vector3::z() - momentum * momentum.z).normalize();
    let in_room = |axis: &Vector3<f64>| axis.dot(&aside) / struck.momentum_angle().sin();
    let on_board = |omega: &Vector3<f64>| omega.x / struck.added_rate();
    // A simulation that knows neither rate.
    let moments = Body::hoop(MASS, RADIUS)?.moments();
    let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
    let times: Vec<f64> = linear_steps(0.0, 4.0 * period, 32).collect();
    let (states, _) = Dop853::new(1e-11)?.sample(free, 0.0, struck.at(0.0)?.to_array(), &times)?;
    let simulated: Vec<Turning> = states.into_iter().map(Turning::from_array).collect();
    let sampled = |of: &dyn Fn(&Turning) -> f64| {
        linear_steps(0.0, 4.0, 800)
            .map(|t| Ok((t, of(&struck.at(t * period)?))))
            .collect::<Result<Vec<_>, InvalidQuantity>>()
    };
    let turns = Axis::linear(0.0, 4.0, 1.0).minor(0.25);
    let side = Axis::linear(-1.0, 1.0, 1.0);
    type Aside<'a> = &'a dyn Fn(&Turning) -> f64;
    let strips: [(&str, &str, f64, Aside<'_>, f64); 2] = [
        (
            "in-the-room",
            r"in the room: rounds of $\hat{\mathbf{3}}$ about $\boldsymbol{L}$",
            60.0,
            &|state| in_room(&state.axis_3_world()),
            struck.nodding_rate(),
        ),
        (
            "on-board",
            r"on board: rounds of $\boldsymbol{\omega}$ about $\hat{\mathbf{3}}$",
            190.0,
            &|state| on_board(&state.omega_body),
            struck.body_rate(),
        ),
    ];
    for (name, title, top, aside, rate) in strips {
        let time = if name == "on-board" {
            turns.titled("time, in turns of the old spin")
        } else {
            turns.unlabelled()
        };
        let frame = Rect::new(36.0, top, 284.0, 66.0);
        let mut plot = Plot::new(&mut drawing, frame, time, side)?;
        plot.curve(name, sampled(aside)?, Stroke::Curve, Hue::Ink);
        let dots: Vec<(f64, f64)> =
            simulated.iter().zip(&times).map(|(state, t)| (t / period, aside(state))).collect();
        for &dot in &dots {
            let place = plot.at(dot);
            plot.drawing().circle(place, 2.2, Role::Area(Fill::Page, Hue::Ink));
            plot.drawing().circle(place, 2.2, Role::Line(Stroke::Outline, Hue::Ink));
        }
        // Every return to where it began has a number.
        let waves = (4.0 * rate * period / TAU + 1e-9).floor() as u32;
        for count in 1..=waves {
            let turns = f64::from(count) * TAU / rate / period;
            plot.label((turns, 1.06), Side::Above, &count.to_string(), Hue::Ink)?;
        }
        plot.drawing().label(at(14.0, top - 42.0), Side::Right, title, Hue::Ink)?;
    }
    Ok(drawing)
}

/// The sky of a struck tube, as its camera sees it: what an exercise asks to sketch.
pub(crate) fn tube_sky(id: &str) -> Outcome {
    let moments = PrincipalMoments::symmetric(1.0, 0.4)?;
    let start =
        Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(0.001, 0.0, 1.0) };
    let tube = FreeSymmetricTop::new(moments, start)?;
    let momentum = moments.angular_momentum(&start.omega_body);
    let lean = (momentum.x / momentum.z).atan();
    let place = |direction: &Vector3<f64>| (direction.y / lean, direction.x / lean);
    // How a direction of the room is seen on board.
    let seen = |time: f64, direction: Vector3<f64>| -> Result<(f64, f64), InvalidQuantity> {
        Ok(place(&(tube.at(time)?.world_from_body.inverse() * direction)))
    };
    let sky = |title: &str, text: &str| Drawing::new("", 260.0, 290.0).titled(title, text);
    let (origin, scale) = (at(130.0, 130.0), 56.0);
    let draw_cross = |drawing: &mut Drawing| {
        for step in [at(5.0, 0.0), at(0.0, 5.0)] {
            drawing.line(origin - step, origin + step, Stroke::Vector, Hue::Ink);
        }
    };

    let mut arrows = sky(
        "Where omega and L lie in the sky of a tube",
        "A cross, and two dotted circles about it. Above the cross, on the small circle, lies omega; farther up, on the large one, L. Both go round counter-clockwise on the picture.",
    );
    for (name, direction, hue) in [
        (r"$\boldsymbol{\omega}$", start.omega_body, Hue::Orange),
        (r"$\boldsymbol{L}$", momentum, Hue::Green),
    ] {
        let plot = Plot::plane(&mut arrows, origin, scale * 1.7, 1.2)?;
        let tip = plot.at(place(&direction.normalize()));
        let radius = (tip - origin).length();
        arrows.circle(origin, radius, Role::Line(Stroke::Dotted, Hue::Muted));
        // The sense in which L goes round; ω lies on the same side all the time.
        let (from, to) = (seen(0.0, momentum.normalize())?, seen(0.1, momentum.normalize())?);
        let sense = (from.0 * to.1 - from.1 * to.0).signum();
        kit::angle(&mut arrows, origin, radius, FRAC_PI_2 + 0.25 * sense, 0.9 * sense, Heads::End, hue);
        arrows.dot(tip, 4.5, hue);
        arrows.label(tip, Side::AboveRight, name, hue)?;
    }
    draw_cross(&mut arrows);
    arrows.label(at(130.0, 268.0), Side::Over, r"(a) $\boldsymbol\omega$ and $\boldsymbol L$", Hue::Ink)?;

    let mut star = sky(
        "The way of the star that stood on the cross",
        "A spiral that sets out from the cross and winds outwards counter-clockwise for one round, and inwards for another, to the cross again.",
    );
    let nod = TAU / tube.precession_rate();
    let way = linear_steps(0.0, nod, 600).map(|time| seen(time, Vector3::z()));
    let way = way.collect::<Result<Vec<_>, InvalidQuantity>>()?;
    let mut plot = Plot::plane(&mut star, origin, scale, 2.2)?;
    plot.curve("star", way.iter().copied(), Stroke::Curve, Hue::Ink);
    let [from, to] = [way[116], way[120]].map(|value| plot.at(value));
    head(&mut star, to, to - from, 1.0, Hue::Ink);
    draw_cross(&mut star);
    star.label(at(130.0, 268.0), Side::Over, "(b) the star", Hue::Ink)?;
    Ok(Drawing::panels(id, vec![arrows, star]))
}

//! Why a coin goes round faster, why its head turns, and what moves in the air under it.

use super::disc;
use drawing::kit::{self, Heads};
use drawing::space::{Camera, Curve, Finish, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Role, Shape, Side, Stroke, at};
use figures::{Cause, Outcome, linear_steps};
use mechanics::rolling::Rolling;
use mechanics::scenes::spinning_coin::EulersDisk;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// The same torque swings a shorter angular momentum through a larger angle.
pub(crate) fn shorter_arrow(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 250.0).titled(
        "The same torque on a long and on a short angular momentum",
        "Two circles seen from above, the second half as large. On each an angular momentum points from the middle to the edge, and a torque, as long in both, adds a piece along the edge. The same piece is twice the \
         angle on the smaller circle.",
    );
    let longest = disc(0.2)?.angular_momentum().norm();
    for (centre, tilt, name) in [
        (at(110.0, 110.0), 0.2, r"(a) tilt $\alpha$"),
        (at(258.0, 110.0), 0.05, r"(b) tilt $\tfrac14\alpha$"),
    ] {
        let coin = disc(tilt)?;
        let radius = 92.0 * coin.angular_momentum().norm() / longest;
        // What the torque adds in a time: Ω × L, which is level.
        let swept = 0.35 * coin.turn_rate() / disc(0.2)?.turn_rate();
        let from = 0.7;
        drawing.circle(centre, radius, Role::Line(Stroke::Reference, Hue::Muted));
        let [tip, then] = [from, from + swept].map(|angle| centre + Point::polar(radius, angle));
        drawing.line(centre, then, Stroke::Reference, Hue::Green);
        kit::arrow(&mut drawing, centre, tip, Hue::Green);
        kit::arrow(&mut drawing, tip, tip + (then - tip), Hue::Purple);
        kit::angle(&mut drawing, centre, 0.5 * radius, from, swept, Heads::None, Hue::Orange);
        drawing.dot(centre, 2.4, Hue::Ink);
        drawing.label(
            centre.towards(tip, 0.62) + at(2.0, 2.0),
            Side::BelowRight,
            r"$\boldsymbol{L}$",
            Hue::Green,
        )?;
        let beside = tip.towards(then, 0.5) + at(3.0, -2.0);
        drawing.label(beside, Side::AboveRight, r"$\boldsymbol{\tau}\,dt$", Hue::Purple)?;
        drawing.label(at(centre.x, 226.0), Side::Over, name, Hue::Ink)?;
    }
    Ok(drawing)
}

/// By how much the book is tipped each time, rad.
const TIP: f64 = std::f64::consts::FRAC_PI_6;

/// A book that is tipped four times, with the arrows of the tips, and these set end to end.
pub(crate) fn book_tips(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 398.0, 330.0).titled(
        "A book that is tipped four times",
        "Five stills of a book seen from above its near edge, in two rows: at the start, and after it has been tipped towards us, to the right, away and to the left. An orange arrow at each still shows the line of the tip. \
         In the last, the book is turned clockwise against a dashed outline of how it lay at the start. In the sixth place the four arrows are set end to end and make a square.",
    );
    let tips = [Vector3::x(), Vector3::y(), -Vector3::x(), -Vector3::y()];
    let names = ["start", "1 towards you", "2 to the right", "3 away", "4 to the left"];
    let mut book = UnitQuaternion::identity();
    for (still, name) in names.into_iter().enumerate() {
        let place = at(66.0 + 132.0 * (still % 3) as f64, 64.0 + 160.0 * (still / 3) as f64);
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0; 3],
            azimuth: -FRAC_PI_2,
            elevation: 0.95,
            distance: 9.0,
            centre: place,
            scale: 42.0,
        })?);
        if still > 0 {
            book = UnitQuaternion::from_scaled_axis(tips[still - 1] * TIP) * book;
        }
        draw_book(&mut stage, book)?;
        if still == 4 {
            let corners = outline().map(|corner| corner + Vector3::z() * THICK);
            for side in 0..4 {
                let line = Curve::segment(corners[side], corners[(side + 1) % 4])?.hiding(Hiding::Ignored);
                stage.curve(line, Stroke::Reference, Hue::Ink)?;
            }
        }
        stage.write(&mut drawing);
        if still > 0 {
            let way = tips[still - 1];
            // Beside the book, on the side to which it has been tipped.
            let away = at(way.y * 48.0, way.x * 50.0);
            let along = at(way.x, -way.y) * 24.0;
            kit::arrow(&mut drawing, place + away - along, place + away + along, Hue::Orange);
        }
        drawing.label(at(place.x, place.y + 80.0), Side::Over, name, Hue::Ink)?;
    }
    // The arrows end to end.
    let (mut corner, side) = (at(300.0, 252.0), 58.0);
    let square = [corner, corner + at(side, 0.0), corner + at(side, -side), corner - at(0.0, side)];
    drawing.polygon(square.to_vec(), Fill::Ground, Hue::Ink);
    for (tip, (beside, name)) in
        tips.into_iter().zip([(Side::Below, "1"), (Side::Right, "2"), (Side::Above, "3"), (Side::Left, "4")])
    {
        let next = corner + at(tip.x, -tip.y) * side;
        kit::arrow(&mut drawing, corner, next, Hue::Orange);
        drawing.label(corner.towards(next, 0.5), beside, name, Hue::Orange)?;
        corner = next;
    }
    drawing.label(square[0].towards(square[2], 0.5), Side::Over, "area", Hue::Ink)?;
    drawing.label(at(330.0, 304.0), Side::Over, "end to end", Hue::Ink)?;
    Ok(drawing)
}

/// Half of the book's thickness.
const THICK: f64 = 0.11;

/// The corners of the book's cover, at the level of its middle.
fn outline() -> [Vector3<f64>; 4] {
    [(-0.7, -0.95), (0.7, -0.95), (0.7, 0.95), (-0.7, 0.95)].map(|(x, y)| Vector3::new(x, y, 0.0))
}

/// A book with this attitude: its cover with a title, and those of its sides that are seen.
fn draw_book(stage: &mut Stage, book: UnitQuaternion<f64>) -> Result<(), Cause> {
    let eye = Vector3::new(0.0, -0.95_f64.cos(), 0.95_f64.sin());
    let up = Vector3::z() * THICK;
    let corners = outline();
    for side in 0..4 {
        let [one, other] = [corners[side], corners[(side + 1) % 4]];
        let outward = (other - one).cross(&Vector3::z());
        if (book * outward).dot(&eye) > 0.0 {
            face(stage, book, [one - up, other - up, other + up, one + up], Fill::Side)?;
        }
    }
    face(stage, book, corners.map(|corner| corner + up), Fill::Face)?;
    for (height, half) in [(0.5, 0.36), (0.28, 0.22)] {
        let ends = [-half, half].map(|x| book * (Vector3::new(x, height, 0.0) + up));
        stage.curve(Curve::segment(ends[0], ends[1])?.hiding(Hiding::Ignored), Stroke::Curve, Hue::Blue)?;
    }
    Ok(())
}

fn face(
    stage: &mut Stage,
    book: UnitQuaternion<f64>,
    corners: [Vector3<f64>; 4],
    fill: Fill,
) -> Result<(), Cause> {
    let corners = corners.map(|corner| book * corner);
    stage.patch(corners, fill, Hue::Blue)?;
    for side in 0..4 {
        let line = Curve::segment(corners[side], corners[(side + 1) % 4])?.hiding(Hiding::Ignored);
        stage.curve(line, Stroke::Outline, Hue::Blue)?;
    }
    Ok(())
}

/// The tilt at which the hat is shown, rad.
const HAT: f64 = 0.72;

/// The paper hat on the sphere of normals, with the arrows that are carried along, and the hat laid flat.
pub(crate) fn paper_hat(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![hat_on_the_sphere("")?, hat_laid_flat("")?]))
}

fn hat_on_the_sphere(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 300.0, 300.0).titled(
        "A paper hat on the sphere of normals",
        "A sphere with a cone of paper on it like a hat; they touch along a circle. From eight places of the circle arrows lie on the paper, the way up of the head.",
    );
    let coin = disc(HAT)?;
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.25],
        azimuth: -FRAC_PI_2,
        elevation: 0.62,
        distance: 8.0,
        centre: at(150.0, 150.0),
        scale: 112.0,
    })?);
    stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Muted)?;
    let apex = Vector3::z() / HAT.cos();
    stage.solid(
        Solid::cone(apex, -Vector3::z(), FRAC_PI_2 - HAT, HAT.tan())?.finish(Finish::Glass),
        Hue::Ink,
    )?;
    let normal = |turns: f64| coin.attitude(turns) * Vector3::z();
    for n in 0..8 {
        let turns = f64::from(n) / 8.0;
        let way = coin.attitude(turns) * Vector3::y();
        let arrow = Curve::segment(normal(turns), normal(turns) + way * 0.36)?;
        let (stroke, heads) =
            if n == 0 { (Stroke::Vector, Heads::End) } else { (Stroke::Outline, Heads::End) };
        stage.arrow(arrow.hiding(Hiding::Ignored), stroke, heads, Hue::Ink)?;
    }
    let way = coin.attitude(1.0) * Vector3::y();
    let last = Curve::segment(normal(1.0), normal(1.0) + way * 0.36)?.hiding(Hiding::Ignored);
    stage.arrow(last, Stroke::Vector, Heads::End, Hue::Ink)?;
    stage.dot_in_front(normal(0.0), 4.0, Hue::Blue)?;
    stage.label_shifted(normal(0.0), at(0.0, 4.0), Side::Below, r"$\hat{\mathbf{n}}$", Hue::Blue)?;
    stage.write(&mut drawing);
    drawing.label(at(26.0, 34.0), Side::Over, "(a)", Hue::Ink)?;
    Ok(drawing)
}

fn hat_laid_flat(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 270.0, 300.0).titled(
        "The hat cut open and laid flat",
        "A disc of paper that lacks a sector. Nine arrows at equal distances along its edge, the first and the last at the two sides of the cut, are all parallel.",
    );
    let coin = disc(HAT)?;
    let left_over = TAU * coin.figure_rate() / coin.turn_rate();
    let (centre, radius) = (at(135.0, 140.0), 100.0);
    let from = 0.5 * left_over - FRAC_PI_2;
    let edge = |part: f64| from + (TAU - left_over) * part;
    let rim = linear_steps(0.0, 1.0, 120).map(|part| centre + Point::polar(radius, edge(part)));
    let paper: Vec<Point> = [centre].into_iter().chain(rim).collect();
    drawing.polygon(paper.clone(), Fill::Face, Hue::Muted);
    drawing.push(Role::Line(Stroke::Outline, Hue::Muted), Shape::Polygon(paper));
    for n in 0..9 {
        let turns = f64::from(n) / 8.0;
        let normal = coin.attitude(turns) * Vector3::z();
        let way = coin.attitude(turns) * Vector3::y();
        // On the paper an arrow makes the same angle with the side of the cone as on the sphere.
        let along = Vector3::z().cross(&normal).normalize() * coin.turn_rate().signum();
        let down = along.cross(&normal) * coin.turn_rate().signum();
        let out = Point::polar(1.0, edge(turns));
        let step = out * way.dot(&down) + Point::polar(1.0, edge(turns) + FRAC_PI_2) * way.dot(&along);
        let foot = centre + out * radius;
        kit::arrow(&mut drawing, foot, foot + step * 36.0, Hue::Ink);
        if n == 0 || n == 8 {
            drawing.dot(foot, 4.0, Hue::Blue);
        }
    }
    kit::angle(&mut drawing, centre, 34.0, -FRAC_PI_2 - 0.5 * left_over, left_over, Heads::None, Hue::Ink);
    drawing.dot(centre, 2.4, Hue::Ink);
    drawing.label(centre + at(0.0, 78.0), Side::Over, r"$2\pi(1 - \cos\alpha)$", Hue::Ink)?;
    drawing.label_on_face(centre - at(0.0, 30.0), Side::Over, "(b) paper", Hue::Ink)?;
    Ok(drawing)
}

/// The wedge of air under the coin, and the coin half a round later.
pub(crate) fn air_gap(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 190.0).titled(
        "The wedge of air under the coin",
        "A coin edge on, tilted, touches the table at its left end. Between coin and table is a wedge of air, as high as a times alpha under the centre and twice as high at the far rim. A pale coin, tilted the other way, is the \
         same half a round later; the wedge is open then where it was closed.",
    );
    let tilt: f64 = disc(0.22)?.tilt();
    let (sin, cos) = tilt.sin_cos();
    let radius = 124.0;
    let contact = at(30.0, 132.0);
    let centre = contact + at(radius * cos, -radius * sin);
    let thick = 7.0;
    drawing.line(
        contact - at(14.0, 0.0),
        contact + at(2.0 * radius * cos + 22.0, 0.0),
        Stroke::Axis,
        Hue::Ink,
    );
    let far = contact + at(2.0 * radius * cos, -2.0 * radius * sin);
    drawing.polygon(vec![contact, far, at(far.x, contact.y)], Fill::Ground, Hue::Ink);
    let plate = |from: Point, to: Point| {
        let across = at((to - from).y, -(to - from).x).unit() * thick;
        vec![from, to, to + across, from + across]
    };
    let later = plate(at(contact.x, far.y), at(far.x, contact.y));
    drawing.polygon(later.clone(), Fill::Ghost, Hue::Blue);
    drawing.push(Role::Line(Stroke::Pale, Hue::Blue), Shape::Polygon(later));
    let now = plate(contact, far);
    drawing.polygon(now.clone(), Fill::Face, Hue::Blue);
    drawing.push(Role::Line(Stroke::Outline, Hue::Blue), Shape::Polygon(now));
    for (foot, height, name, side) in [
        (at(centre.x, contact.y), radius * sin, r"$a\alpha$", Side::Right),
        (at(far.x + 10.0, contact.y), 2.0 * radius * sin, r"$2a\alpha$", Side::Right),
    ] {
        kit::dimension(&mut drawing, foot, foot - at(0.0, height), Heads::Both, Hue::Ink);
        drawing.label(foot - at(-3.0, 0.5 * height), side, name, Hue::Ink)?;
    }
    let level = at(0.0, 30.0);
    kit::dimension(&mut drawing, contact + level, at(centre.x, contact.y) + level, Heads::Both, Hue::Ink);
    drawing.label(at(0.5 * (contact.x + centre.x), contact.y) + level, Side::Below, "$a$", Hue::Ink)?;
    drawing.label(at(0.5 * (centre.x + far.x), contact.y - 33.0), Side::Over, "air", Hue::Ink)?;
    drawing.dot(contact, 4.5, Hue::Pink);
    drawing.label(contact + at(-10.0, 15.0), Side::Right, "contact", Hue::Pink)?;
    drawing.label(at(contact.x + 4.0, far.y - 12.0), Side::Right, "half a round later", Hue::Muted)?;
    Ok(drawing)
}

/// A disc that is let go on its edge, nearly flat, as a lid on its hinge.
pub(crate) fn lid(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 330.0, 200.0).titled(
        "A disc on its edge is a lid on its hinge",
        "A disc edge on, a little tilted, hangs by its left end on a table, as by a hinge. At its middle the weight points down; at the contact a force a fifth as long points up. An \
         arrow at the middle says that it falls with four fifths of g, another at the free end that it falls twice as fast.",
    );
    let coin = disc(0.1)?.parameters();
    let at_rest = Rolling { tilt: 1e-4, ..Rolling::UPRIGHT };
    let carried = EulersDisk::new(coin, 0.0)?.normal_force(&at_rest) / (coin.mass * coin.gravity);
    let (contact, radius, tilt, weight) = (at(40.0, 128.0), 112.0, 0.2, 60.0);
    let along = Point::polar(1.0, tilt);
    let [centre, far] = [contact + along * radius, contact + along * (2.0 * radius)];
    drawing.line(contact - at(26.0, 0.0), contact + at(262.0, 0.0), Stroke::Axis, Hue::Ink);
    let up = along.quarter_turned() * -7.0;
    let up = if up.y < 0.0 { up } else { up * -1.0 };
    let plate = vec![contact, far, far + up, contact + up];
    drawing.polygon(plate.clone(), Fill::Face, Hue::Blue);
    drawing.push(Role::Line(Stroke::Outline, Hue::Blue), Shape::Polygon(plate));
    kit::angle(&mut drawing, contact, 2.0 * radius + 12.0, tilt, -tilt, Heads::End, Hue::Ink);
    drawing.label(far + at(22.0, 14.0), Side::Right, r"$\tfrac85g$", Hue::Ink)?;
    kit::arrow(&mut drawing, centre, centre + at(0.0, weight), Hue::Purple);
    drawing.label(centre + at(5.0, 0.75 * weight), Side::Right, r"weight, $mg$", Hue::Purple)?;
    drawing.dot(centre, 3.6, Hue::Ink);
    drawing.label(centre + at(0.0, -14.0), Side::Above, r"falls with $\tfrac45g$", Hue::Ink)?;
    kit::arrow(&mut drawing, contact, contact - at(0.0, carried * weight + 16.0), Hue::Purple);
    drawing.label(contact - at(0.0, carried * weight + 20.0), Side::Above, r"$\tfrac15mg$", Hue::Purple)?;
    drawing.dot(contact, 4.5, Hue::Pink);
    drawing.label(contact + at(-6.0, 16.0), Side::Right, "hinge", Hue::Pink)?;
    Ok(drawing)
}

/// Why a sinking disc gains spin: the drift of its centre changes direction, and friction does it, with a lever arm.
pub(crate) fn drift_turns(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 310.0, 310.0).titled(
        "Friction turns the drift, and spins the disc up",
        "A disc seen from above. Its contact has gone from a pale dot counter-clockwise along the rim to a dot. From the centre a pale arrow, the drift then, and an arrow, the drift now, \
         each lead away from the contact of their moment; a short arrow between their tips is the change. At the contact friction has the direction of that change, along the rim, \
         and an arc about the centre shows that it turns the disc clockwise.",
    );
    let (centre, radius, drift) = (at(155.0, 160.0), 116.0, 74.0);
    let (then, now) = (-2.15, -1.15);
    drawing.disc(centre, radius, Hue::Blue);
    let foot = |angle: f64| centre + Point::polar(radius, angle);
    let tip = |angle: f64| centre - Point::polar(drift, angle);
    kit::angle(&mut drawing, centre, radius + 24.0, then, now - then, Heads::End, Hue::Orange);
    let beside = centre + Point::polar(radius + 30.0, 0.5 * (then + now));
    drawing.label(beside, Side::Below, r"$\Omega$", Hue::Orange)?;
    drawing.line(centre, tip(then), Stroke::Reference, Hue::Ink);
    kit::head(&mut drawing, tip(then), tip(then) - centre, 1.0, Hue::Muted);
    kit::arrow(&mut drawing, centre, tip(now), Hue::Ink);
    drawing.label_on_face(tip(now) + at(-4.0, 30.0), Side::Left, "drift", Hue::Ink)?;
    kit::arrow(&mut drawing, tip(then), tip(now), Hue::Purple);
    drawing.label_on_face(
        tip(then).towards(tip(now), 0.5) + at(0.0, -19.0),
        Side::Over,
        "its change",
        Hue::Purple,
    )?;
    // Friction, a quarter turn behind the contact: along the rim.
    let push = Point::polar(56.0, now - FRAC_PI_2);
    kit::arrow(&mut drawing, foot(now), foot(now) + push, Hue::Purple);
    drawing.label_on_face(foot(now) + push * 0.5 + at(-14.0, -22.0), Side::Over, "friction", Hue::Purple)?;
    kit::angle(&mut drawing, centre, 34.0, 0.6, -1.5, Heads::End, Hue::Purple);
    drawing.dot(foot(then), 3.4, Hue::Muted);
    drawing.dot(foot(now), 4.5, Hue::Pink);
    drawing.label(foot(now) + at(8.0, 8.0), Side::Right, "contact", Hue::Pink)?;
    drawing.dot(centre, 3.0, Hue::Ink);
    Ok(drawing)
}

//! The figures of the chapter "The ball".

use drawing::kit::{self, Marker};
use drawing::{Drawing, Hue, Point, Rect, Role, Side, Stroke, at};
use figures::{Axis, Figure, Outcome, Plot, figures, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::scenes::ball::{
    Ball, BallParameters, Cloth, ClothParameters, Hole, HoleParameters, HoleRoll, HoleStart, Shot, ShotStart,
    Turntable, TurntableParameters, TurntableRoll, TurntableStart,
};
use std::f64::consts::{PI, TAU};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] =
    figures![ball_carts, ball_masse, ball_circles, ball_drifts, ball_hole, ball_swing];

const GRAVITY: f64 = 9.81;

fn solid(radius: f64) -> Result<Ball, InvalidQuantity> {
    Ball::new(BallParameters { radius, moment_factor: Ball::SOLID })
}

/// The ball with the friction at its contact, and the two carts.
pub(crate) fn ball_carts(id: &str) -> Outcome {
    let mut ball = Drawing::new("", 260.0, 210.0).titled(
        "A ball that slides",
        "A ball on a cloth, from the side. An arrow v from its centre points to the right, an arrow F at its lowest point to the left. \
         A turning arrow shows the spin that F gives it.",
    );
    let (centre, radius) = (at(110.0, 100.0), 62.0);
    ball.circle(centre, radius, Role::Line(Stroke::Curve, Hue::Blue));
    ball.line(at(20.0, 162.0), at(240.0, 162.0), Stroke::Outline, Hue::Ink);
    kit::arrow(&mut ball, centre, centre + at(110.0, 0.0), Hue::Ink);
    ball.label(centre + at(112.0, 0.0), Side::Right, r"$\boldsymbol v$", Hue::Ink)?;
    kit::arrow(&mut ball, at(110.0, 162.0), at(46.0, 162.0), Hue::Purple);
    ball.label(at(44.0, 164.0), Side::BelowLeft, r"$\boldsymbol F$", Hue::Purple)?;
    let turning: Vec<Point> = linear_steps(-2.6, -0.5, 40)
        .map(|angle| centre + at(38.0 * f64::cos(angle), 38.0 * f64::sin(angle)))
        .collect();
    ball.polyline(&turning, Stroke::Outline, Hue::Orange);
    let [before, tip] = [turning[turning.len() - 3], turning[turning.len() - 1]];
    kit::head(&mut ball, tip + (tip - before).unit() * 5.0, tip - before, 0.8, Hue::Orange);
    ball.label(centre + at(-8.0, -15.0), Side::Over, r"$\omega$", Hue::Orange)?;
    ball.dot(at(110.0, 162.0), 3.5, Hue::Pink);

    let mut carts = Drawing::new("", 300.0, 210.0).titled(
        "Two carts",
        "Two carts on one track. The left one has the mass m and the velocity v to the right, and is pushed to the left by F; the other, with the mass km \
         and the velocity w, is pushed to the right by the same force.",
    );
    carts.line(at(10.0, 162.0), at(290.0, 162.0), Stroke::Outline, Hue::Ink);
    for (left, width, height, name) in [(30.0, 96.0, 56.0, "$m$"), (186.0, 74.0, 36.0, "$km$")] {
        let (top, floor) = (148.0 - height, 148.0);
        let corners =
            [at(left, top), at(left + width, top), at(left + width, floor), at(left, floor), at(left, top)];
        carts.polyline(&corners, Stroke::Curve, Hue::Blue);
        for wheel in [left + 18.0, left + width - 18.0] {
            carts.circle(at(wheel, 155.0), 6.5, Role::Line(Stroke::Outline, Hue::Blue));
        }
        carts.label(at(left + 0.5 * width, 0.5 * (top + floor)), Side::Over, name, Hue::Blue)?;
    }
    kit::arrow(&mut carts, at(78.0, 74.0), at(168.0, 74.0), Hue::Ink);
    carts.label(at(170.0, 74.0), Side::Right, r"$\boldsymbol v$", Hue::Ink)?;
    kit::arrow(&mut carts, at(223.0, 98.0), at(253.0, 98.0), Hue::Orange);
    carts.label(at(255.0, 98.0), Side::Right, r"$\boldsymbol w$", Hue::Orange)?;
    kit::arrow(&mut carts, at(156.0, 120.0), at(128.0, 120.0), Hue::Purple);
    kit::arrow(&mut carts, at(156.0, 134.0), at(184.0, 134.0), Hue::Purple);
    carts.label(at(156.0, 117.0), Side::Above, r"$\boldsymbol F$", Hue::Purple)?;
    Ok(Drawing::panels(id, vec![ball, carts]))
}

/// The massé of the figure: velocity (3, 0), a spin that would roll at (−4, 3) m/s.
fn masse() -> Result<Shot, InvalidQuantity> {
    let ball = solid(0.03)?;
    let cloth = Cloth::new(ClothParameters { ball, friction: 0.2, gravity: GRAVITY })?;
    cloth.shot(ShotStart { velocity: [3.0, 0.0], omega: [-3.0 / 0.03, -4.0 / 0.03, 0.0] })
}

/// The way of a massé, with the slip.
pub(crate) fn ball_masse(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 290.0).titled(
        "A massé from above",
        "The path of the centre on a cloth, in metres: it begins along x, curves to the left while the ball slides, and goes on straight where it rolls. Dots at \
         equal times. Arrows of the slip all point the same way, to the right and down, each shorter than the one before.",
    );
    let shot = masse()?;
    let frame = Rect::new(44.0, 36.0, 340.0, 200.0);
    let (x, y) =
        (Axis::linear(0.0, 3.4, 1.0).titled("$x$, m"), Axis::linear(-0.6, 1.4, 1.0).titled("$y$, m"));
    let y = y.marked(&[(0.0, "0"), (1.0, "1")]);
    let mut plot = Plot::new(&mut drawing, frame, x, y)?;
    let end = shot.sliding_time();
    let path = |from: f64, to: f64| {
        linear_steps(from, to, 200)
            .map(|time| shot.at(time).map(|state| (state.centre.x, state.centre.y)))
            .collect::<Result<Vec<_>, InvalidQuantity>>()
    };
    plot.curve("slides", path(0.0, end)?, Stroke::Curve, Hue::Ink);
    plot.curve("rolls", path(end, 2.2)?, Stroke::Outline, Hue::Ink);
    for n in 0..11 {
        let time = 0.2 * f64::from(n);
        let state = shot.at(time)?;
        let place = (state.centre.x, state.centre.y);
        let foot = plot.at(place);
        if n % 2 == 0 && time < end {
            let slip = shot.slip(time)?;
            kit::arrow(plot.drawing(), foot, foot + at(slip.x, -slip.y) * 9.0, Hue::Pink);
        }
        plot.markers(&[place], Marker::Disc, Hue::Blue);
    }
    let last = shot.end_of_sliding();
    plot.label((last.x, last.y), Side::BelowRight, "here it rolls", Hue::Ink)?;
    let first = plot.at((0.0, 0.0)) + at(63.0, 27.0);
    drawing.label(first + at(4.0, -4.0), Side::Right, r"slip $\boldsymbol u$", Hue::Pink)?;
    Ok(drawing)
}

fn table(rate: f64, slope: f64, start: TurntableStart) -> Result<TurntableRoll, InvalidQuantity> {
    Turntable::new(TurntableParameters { ball: solid(0.02)?, rate, slope, gravity: GRAVITY })?.roll(start)
}

/// Five balls pushed from one place.
pub(crate) fn ball_circles(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 350.0).titled(
        "Circles on a turning table",
        "A round table from above, with an arrow for its turning. From one place off its axis, a disc, five arrows of one length point in five directions. A ball that is pushed along \
         one of them runs round a circle; the five circles have one size.",
    );
    let middle = at(170.0, 180.0);
    drawing.circle(middle, 150.0, Role::Line(Stroke::Outline, Hue::Muted));
    let mut plot = Plot::plane(&mut drawing, middle, 150.0, 1.0)?;
    for n in 0..5 {
        let (sin, cos) = (TAU * f64::from(n) / 5.0 + 0.3).sin_cos();
        let start = TurntableStart { place: [0.3, 0.1], velocity: [0.5 * cos, 0.5 * sin], pivot: 0.0 };
        let roll = table(7.0, 0.0, start)?;
        let path = linear_steps(0.0, PI, 200)
            .map(|time| roll.at(time).map(|state| (state.centre.x, state.centre.y)))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(&format!("circle-{n}"), path, Stroke::Outline, Hue::Ink);
    }
    let start = plot.at((0.3, 0.1));
    for n in 0..5 {
        let push = Point::polar(34.0, TAU * f64::from(n) / 5.0 + 0.3);
        kit::arrow(&mut drawing, start, start + push, Hue::Ink);
    }
    for step in [at(5.0, 0.0), at(0.0, 5.0)] {
        drawing.line(middle - step, middle + step, Stroke::Outline, Hue::Muted);
    }
    drawing.dot(start, 5.0, Hue::Blue);
    let arc: Vec<Point> = linear_steps(-2.5, -2.0, 20)
        .map(|angle| middle + at(162.0 * f64::cos(angle), 162.0 * f64::sin(angle)))
        .collect();
    drawing.polyline(&arc, Stroke::Outline, Hue::Orange);
    kit::head(&mut drawing, arc[0] + (arc[0] - arc[2]).unit() * 5.0, arc[0] - arc[2], 0.8, Hue::Orange);
    drawing.label(arc[10], Side::AboveLeft, r"$\Omega$", Hue::Orange)?;
    Ok(drawing)
}

/// Arches across a slope.
pub(crate) fn ball_drifts(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 180.0).titled(
        "The drift across a slope",
        "A path from above, with the slope down the page. Three arches hang side by side from one level line, like a clothes line; a dashed level line through \
         their middle is the drift.",
    );
    let slope = 2_f64.to_radians();
    let roll = table(6.0, slope, TurntableStart { place: [0.0; 2], velocity: [0.0; 2], pivot: 0.0 })?;
    let period = roll.period().ok_or("the table is at rest")?;
    let drift = roll.circle().ok_or("the table is at rest")?;
    let frame = Rect::new(50.0, 40.0, 330.0, 76.0);
    let x = Axis::linear(0.0, 1.65, 0.5).titled("across the slope, m");
    let y = Axis::linear(-0.3, 0.08, 0.1).marked(&[(0.0, "0"), (-0.2, "−0.2")]).titled("up the slope, m");
    let mut plot = Plot::new(&mut drawing, frame, x, y)?;
    let path = linear_steps(0.0, 3.0 * period, 600)
        .map(|time| roll.at(time).map(|state| (state.centre.y, -state.centre.x)))
        .collect::<Result<Vec<_>, InvalidQuantity>>()?;
    plot.reference((0.0, -drift.centre.x), (1.6, -drift.centre.x), Stroke::DashedCurve);
    plot.curve("path", path, Stroke::Curve, Hue::Ink);
    plot.markers(&[(0.0, 0.0)], Marker::Disc, Hue::Blue);
    Ok(drawing)
}

/// A ball in a hole at two moments, with the spin that it has by rolling down.
pub(crate) fn ball_hole(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 310.0).titled(
        "A spin becomes a spin about the normal",
        "A round hole from above, with a ball that touches its wall at the right, and the same ball a quarter of a round later at the top. At both places the \
         same arrow of spin points up the page: at the right along the wall, at the top at the wall, along the normal, which is dashed.",
    );
    let (axis, radius, ball) = (at(140.0, 160.0), 118.0, 36.0);
    drawing.circle(axis, radius, Role::Line(Stroke::Curve, Hue::Muted));
    let gap = radius - ball;
    let way: Vec<Point> = linear_steps(0.52, 1.05, 40)
        .map(|angle| axis + at(gap * f64::cos(angle), -gap * f64::sin(angle)))
        .collect();
    drawing.polyline(&way, Stroke::Outline, Hue::Ink);
    let [before, tip] = [way[way.len() - 3], way[way.len() - 1]];
    kit::head(&mut drawing, tip, tip - before, 0.8, Hue::Ink);
    let places = [(at(1.0, 0.0), Side::Right, r"$\omega_2$"), (at(0.0, -1.0), Side::Left, r"$\omega_1$")];
    for (outward, side, name) in places {
        let centre = axis + outward * gap;
        drawing.line(axis, centre + outward * 66.0, Stroke::Reference, Hue::Muted);
        drawing.circle(centre, ball, Role::Line(Stroke::Curve, Hue::Blue));
        kit::arrow(&mut drawing, centre, centre + at(0.0, -62.0), Hue::Orange);
        drawing.label(centre + at(0.0, -56.0), side, name, Hue::Orange)?;
        drawing.dot(axis + outward * radius, 3.5, Hue::Pink);
    }
    Ok(drawing)
}

/// The golf ball at 1 m/s, with this velocity downwards at the start.
fn golf(drop: f64) -> Result<HoleRoll, InvalidQuantity> {
    let hole = Hole::new(HoleParameters { ball: solid(0.021_35)?, radius: 0.054, gravity: GRAVITY })?;
    hole.roll(HoleStart { rate: 1.0 / hole.gap(), rise: -drop, pivot: 0.0 })
}

/// The height of a golf ball in its hole.
pub(crate) fn ball_swing(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 260.0).titled(
        "A golf ball goes down and comes up",
        "Two curves of the height in centimetres against rounds, from 0 to 4. A thick one hangs from zero in equal arches down to minus 5.2, each 1.87 rounds long. \
         A thin one begins steeper, goes down to minus 5.8, and ends at zero, on its way up, after one round and a half.",
    );
    let round = TAU / (1.0 / 0.032_65);
    let frame = Rect::new(50.0, 36.0, 330.0, 165.0);
    let rounds = Axis::linear(0.0, 4.0, 1.0).titled("rounds");
    let height = Axis::linear(-7.6, 1.0, 2.0).marked(&[(0.0, "0"), (-2.0, "−2"), (-4.0, "−4"), (-6.0, "−6")]);
    let mut plot = Plot::new(&mut drawing, frame, rounds, height.titled("height of the centre, cm"))?;
    plot.reference((0.0, 0.0), (4.0, 0.0), Stroke::Reference);
    let curve = |roll: HoleRoll, to: f64| {
        linear_steps(0.0, to, 500)
            .map(move |time| roll.at(time).map(|state| (time / round, 100.0 * state.centre.z)))
            .collect::<Result<Vec<_>, InvalidQuantity>>()
    };
    plot.curve("level", curve(golf(0.0)?, 4.0 * round)?, Stroke::Curve, Hue::Ink);
    let pushed = golf(0.3)?;
    let back = pushed.first_return().ok_or("it stays")?;
    plot.curve("pushed", curve(pushed, back)?, Stroke::Outline, Hue::Ink);
    plot.markers(&[(back / round, 0.0)], Marker::Disc, Hue::Blue);
    plot.label((back / round, 0.1), Side::Above, "out", Hue::Ink)?;
    plot.label((0.75, -6.65), Side::Over, "pushed down", Hue::Ink)?;
    plot.label((2.8, -5.9), Side::Over, "from level", Hue::Ink)?;
    Ok(drawing)
}

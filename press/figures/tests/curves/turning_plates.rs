//! The figures of the chapters on turning and on the wobble plate: curves lie on formulas that are written
//! out here, and arrows point and turn as they should.

use crate::{figures, lies_on};
use drawing::{Drawing, Hue, Point, Role, Shape, Stroke};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// The drawings of a figure.
fn parts(figure: &str) -> Vec<&'static Drawing> {
    let id = format!("fig:{figure}");
    figures().iter().find(|other| other.id == id).expect("the figure").drawing.parts()
}

/// The polylines of a drawing with this role, in the order in which they were painted.
fn lines(part: &Drawing, stroke: Stroke, hue: Hue) -> Vec<&[Point]> {
    let items = part.items().iter().filter(|item| item.role == Role::Line(stroke, hue));
    let points = items.filter_map(|item| match &item.shape {
        Shape::Polyline(points) => Some(&points[..]),
        _ => None,
    });
    points.collect()
}

/// From the first point of a line to its last, to the right and upwards, px.
fn step(line: &[Point]) -> (f64, f64) {
    let [first, last] = [line[0], line[line.len() - 1]];
    (last.x - first.x, first.y - last.y)
}

/// What the bearings give the chapter's plate alone, N m, eq:bearing-torque.
fn alone() -> f64 {
    let (mass, radius, spin, tilt) = (2.0, 0.1, 100.0, 25_f64.to_radians());
    mass * radius * radius * spin * spin * (2.0 * tilt).sin() / 8.0
}

#[test]
fn many_pistons_leave_a_v_and_one_or_two_a_band() {
    let whole = alone();
    lies_on("residual", "torque", |mass| whole * (1.0 - mass).abs());
    // Of a pair half goes round with the plate and half backwards: they add up at two phases and oppose at two others.
    lies_on("residual", "pair-most", |mass| whole * ((1.0 - mass).abs() + mass));
    lies_on("residual", "pair-least", |mass| whole * ((1.0 - mass).abs() - mass).abs());
}

#[test]
fn the_heights_are_four_sines() {
    for n in [1.0, 2.0, 3.0, 4.0] {
        lies_on("engine", &format!("height-{n}"), |degrees| (n * TAU / 4.0 - degrees.to_radians()).sin());
    }
}

#[test]
fn the_pulls_of_the_plate_are_held_by_the_bearings_and_opposed_by_the_pistons() {
    // The torque of the centrifugal forces on specks of the plate, in its own frame: x′, y′, z.
    let (spin, mass, radius, tilt) = (100.0, 2.0, 0.1, 25_f64.to_radians());
    let (rings, around) = (100, 500);
    let mut couple = Vector3::zeros();
    for k in 0..rings * around {
        let r = radius * ((f64::from(k / around) + 0.5) / f64::from(rings)).sqrt();
        let (y, x) = (TAU * f64::from(k % around) / f64::from(around)).sin_cos();
        let place = Vector3::new(x * tilt.cos(), y, x * tilt.sin()) * r;
        let force = Vector3::new(place.x, place.y, 0.0) * (spin * spin * mass / f64::from(rings * around));
        couple += place.cross(&force);
    }
    // Clockwise as it is seen, along y′, away from the reader; and the bearings 40 cm apart.
    assert!((couple - Vector3::y() * alone()).norm() < 1e-3 * alone(), "{couple}");
    assert!((alone() / 0.4 - 48.0).abs() < 0.2);
    let [plate, pistons] = parts("opposition")[..] else { panic!("two drawings") };
    let forces = lines(plate, Stroke::Vector, Hue::Purple);
    let [upper, lower] = forces[..] else { panic!("two forces") };
    assert!(upper[0].y < lower[0].y && step(upper).0 < -40.0 && step(lower).0 > 40.0, "against it");
    let pulls = lines(plate, Stroke::Outline, Hue::Purple);
    let middle = 0.5 * (upper[0].x + lower[0].x);
    assert_eq!(pulls.len(), 4);
    for pull in pulls {
        // Away from the shaft, in proportion to the distance from it but for the head.
        let (along, rise) = step(pull);
        let distance = pull[0].x - middle;
        assert!(
            rise == 0.0 && (along + 6.3 * along.signum() - 0.5 * distance).abs() < 1.0,
            "{along}, {distance}"
        );
    }
    let pushes = lines(pistons, Stroke::Vector, Hue::Purple);
    let [high, low] = pushes[..] else { panic!("two pushes") };
    assert!(high[0].x > low[0].x && step(high).1 > 30.0 && step(low).1 < -30.0, "up at the high end");
}

#[test]
fn two_pistons_share_unevenly_and_three_evenly() {
    let square = |degrees: f64, n: f64, count: f64| (n * TAU / count - degrees.to_radians()).sin().powi(2);
    // Piston n of N is at its highest when ωt has come to its azimuth, and at its lowest half a turn later.
    lies_on("sharing", "two-1", |degrees| square(degrees, 1.0, 2.0));
    lies_on("sharing", "two", |degrees| 1.0 - (2.0 * degrees.to_radians()).cos());
    for n in [1.0, 2.0, 3.0] {
        lies_on("sharing", &format!("three-{n}"), |degrees| square(degrees, n, 3.0));
    }
    lies_on("sharing", "three", |_| 1.5);
}

#[test]
fn the_momentum_of_the_plate_leans_by_beta_and_the_pistons_take_it_back_to_the_shaft() {
    let [part] = parts("lean")[..] else { panic!("one drawing") };
    let arrows = lines(part, Stroke::Vector, Hue::Green);
    let [plate, pistons] = arrows[..] else { panic!("two arrows") };
    let tangent = 35_f64.to_radians().tan();
    let (across, along) = step(plate);
    assert!((-across / along - tangent / (2.0 + tangent * tangent)).abs() < 1e-6, "(39)");
    let (back, rise) = step(pistons);
    let shaft = lines(part, Stroke::Vector, Hue::Orange)[0];
    // Up to the heads, of which the lines show but the beginnings.
    assert!(back > 20.0 && rise.abs() < 1e-9 && (pistons[0].x + back + 7.8 - shaft[0].x).abs() < 0.1);
}

#[test]
fn everything_goes_round_counter_clockwise() {
    let mut checked = 0;
    for part in parts("views") {
        for hue in [Hue::Ink, Hue::Orange, Hue::Green] {
            // In front, low on the page, what turns counter-clockwise as seen from above runs to the right.
            let ways: Vec<_> =
                lines(part, Stroke::Outline, hue).into_iter().filter(|way| way.len() > 4).collect();
            let pairs = ways.iter().flat_map(|way| way.windows(2)).filter(|pair| pair[0].x != pair[1].x);
            let Some(front) = pairs.max_by(|a, b| a[0].y.total_cmp(&b[0].y)) else { continue };
            assert!(front[1].x > front[0].x, "{hue:?}");
            checked += 1;
        }
    }
    assert_eq!(checked, 4, "ways");
}

#[test]
fn the_plate_wobbles_twice_while_its_mark_goes_round_once() {
    let parts = parts("wobbles");
    let mut leans = Vec::new();
    let mut marks = Vec::new();
    for part in &parts {
        let axis = lines(part, Stroke::Vector, Hue::Ink)[0];
        leans.push(step(axis).0 > 0.0);
        let mark = part.items().iter().find_map(|item| match item.shape {
            Shape::Circle { centre, .. } if item.role == Role::Area(drawing::Fill::Solid, Hue::Pink) => {
                Some(centre)
            }
            _ => None,
        });
        let mark = mark.expect("a mark");
        marks.push((mark.x - axis[0].x, axis[0].y - mark.y));
    }
    assert_eq!(leans, [false, true, false, true, false]);
    let [left, front, right, behind, again] = marks[..] else { panic!("five stills") };
    assert!(
        left.0 < -30.0 && front.1 < -8.0 && right.0 > 30.0 && behind.1 > 0.0 && again.0 < -30.0,
        "{marks:?}"
    );
}

#[test]
fn bodies_stand_at_their_ratios() {
    let [part] = parts("bodies")[..] else { panic!("one drawing") };
    // The axis is the longest level line, from 0 to 2.
    let axis = lines(part, Stroke::Axis, Hue::Ink).into_iter().max_by(|a, b| step(a).0.total_cmp(&step(b).0));
    let axis = axis.expect("an axis");
    let places: Vec<f64> = lines(part, Stroke::Dotted, Hue::Muted)
        .iter()
        .map(|line| 2.0 * (line[0].x - axis[0].x) / step(axis).0)
        .collect();
    let cylinder = |h: f64| 0.5 / (0.25 + h * h / 12.0);
    let spheroid = |c: f64| 2.0 / (1.0 + c * c);
    let expected = [20.0, 3.0, 3_f64.sqrt(), 1.0, 0.12].map(cylinder).into_iter();
    let expected: Vec<f64> =
        expected.chain([3.0, 3_f64.sqrt(), 1.0, 0.5].map(spheroid)).chain([2.0]).collect();
    assert_eq!(places.len(), expected.len());
    for (place, ratio) in places.iter().zip(expected) {
        assert!((place - ratio).abs() < 1e-9, "{place} for {ratio}");
    }
}

#[test]
fn the_brick_stands_where_its_program_has_it() {
    let [part] = parts("possible-moments")[..] else { panic!("one drawing") };
    let axes = &part.axes()[0];
    let square = |a: f64, b: f64| a * a + b * b;
    let [small, middle, large] = [square(0.1, 0.06), square(0.2, 0.06), square(0.2, 0.1)];
    let wanted = crate::place(axes, (small / large, middle / large));
    let discs = part.items().iter().filter_map(|item| match item.shape {
        Shape::Circle { centre, .. } if item.role == Role::Area(drawing::Fill::Solid, Hue::Blue) => {
            Some(centre)
        }
        _ => None,
    });
    let nearest =
        discs.map(|centre| (centre.x - wanted.0).hypot(centre.y - wanted.1)).fold(f64::MAX, f64::min);
    assert!(nearest < 0.01, "{nearest} px off");
    lies_on("possible-moments", "flat", |first| 1.0 - first);
}

//! The figures of the chapters on turning and on the wobble plate: curves lie on formulas that are written
//! out here, and arrows point and turn as they should.

use crate::{curve, dots, lies_on, lines, parts, passes, step};
use drawing::space::{Camera, View};
use drawing::{Drawing, Fill, Hue, Point, Role, Shape, Stroke, at};
use std::f64::consts::TAU;

/// What the bearings give the chapter's plate alone, N·m, eq:bearing-torque.
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
fn the_balancing_mass_falls_as_the_square_of_the_thickness_and_ends_at_root_three() {
    // ½Σ m r² = M (R²/4 − h²/12) cos² α, with M = 2 kg, R = 10 cm, r = 7 cm.
    let needed = |h: f64| 4.0 * (0.25 - h * h / 12.0) * (25_f64.to_radians().cos() * 0.1 / 0.07).powi(2);
    for (name, from, to) in [("balancing", 0.0, 1.73), ("impossible", 1.74, 2.35)] {
        let steps = (0..200).map(|step| from + (to - from) * (f64::from(step) + 0.37) / 200.0);
        passes("any-thickness", name, steps.map(|thickness| (thickness, needed(thickness))));
    }
}

#[test]
fn faults_draw_a_circle_a_line_and_a_circle_run_backwards() {
    // Hundredths of the torque of the plate alone: one piston of three that is a tenth too heavy leaves 2/3 of a tenth
    // along one line; one that is 6° aside leaves (e^{2i·6°} − 1)/3, which turns the other way.
    let aside = 200.0 / 3.0 * 6_f64.to_radians().sin();
    for (name, radius, turned) in [("all-heavy", 10.0, 360.0), ("one-aside", aside, -360.0)] {
        let path = curve("any-faults", name).values();
        assert!(path.iter().all(|(x, y)| (x.hypot(*y) - radius).abs() < 0.1), "{name}: {path:?}");
        let way = |pair: &[(f64, f64)]| {
            let [(x0, y0), (x1, y1)] = [pair[0], pair[1]];
            (x0 * y1 - y0 * x1).atan2(x0 * x1 + y0 * y1).to_degrees()
        };
        let round: f64 = path.windows(2).map(way).sum();
        assert!((round - turned).abs() < 1.0, "{name} goes round by {round}°");
    }
    let line = curve("any-faults", "one-heavy").values();
    let reach = line.iter().map(|(_, y)| y.abs()).fold(0.0, f64::max);
    assert!(line.iter().all(|(x, _)| x.abs() < 0.05) && (reach - 20.0 / 3.0).abs() < 0.05, "{reach}");
}

#[test]
fn the_heights_are_sines_and_two_pistons_share_unevenly_and_three_evenly() {
    // Piston n of N is at its highest when ωt has come to its azimuth, and at its lowest half a turn later.
    let sine = |degrees: f64, n: f64, count: f64| (n * TAU / count - degrees.to_radians()).sin();
    for n in [1.0, 2.0, 3.0, 4.0] {
        lies_on("engine", &format!("height-{n}"), |degrees| sine(degrees, n, 4.0));
    }
    lies_on("sharing", "two-1", |degrees| sine(degrees, 1.0, 2.0).powi(2));
    lies_on("sharing", "two", |degrees| 1.0 - (2.0 * degrees.to_radians()).cos());
    for n in [1.0, 2.0, 3.0] {
        lies_on("sharing", &format!("three-{n}"), |degrees| sine(degrees, n, 3.0).powi(2));
    }
    lies_on("sharing", "three", |_| 1.5);
}

#[test]
fn the_pulls_of_the_plate_are_held_by_the_bearings_and_opposed_by_the_pistons() {
    let [plate, pistons] = parts("opposition")[..] else { panic!("two drawings") };
    let [upper, lower] = lines(plate, Stroke::Vector, Hue::Purple)[..] else { panic!("two forces") };
    assert!(upper[0].y < lower[0].y && step(upper).0 < -40.0 && step(lower).0 > 40.0, "against the pulls");
    let pulls = lines(plate, Stroke::Outline, Hue::Purple);
    assert_eq!(pulls.len(), 4);
    for pull in pulls {
        // Away from the shaft, in proportion to the distance from it but for the head.
        let ((along, rise), distance) = (step(pull), pull[0].x - 0.5 * (upper[0].x + lower[0].x));
        let off = along + 6.3 * along.signum() - 0.5 * distance;
        assert!(rise == 0.0 && off.abs() < 1.0, "{along}, {distance}");
    }
    let [high, low] = lines(pistons, Stroke::Vector, Hue::Purple)[..] else { panic!("two pushes") };
    assert!(high[0].x > low[0].x && step(high).1 > 30.0 && step(low).1 < -30.0, "up at the high end");
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
fn the_hoop_rolls_once_round_while_it_touches_the_waist_twice_on_each_side() {
    let mut before: Option<[f64; 2]> = None;
    for (quarters, part) in parts("wobbles").into_iter().enumerate() {
        let circle = |hue| {
            let items = part.items().iter().filter(|item| item.role == Role::Line(Stroke::Curve, hue));
            let found = items.map(|item| &item.shape).find_map(|shape| match shape {
                Shape::Circle { centre, radius } => Some((*centre, *radius)),
                _ => None,
            });
            found.expect("a circle")
        };
        let ((middle, waist), (axis, hoop)) = (circle(Hue::Green), circle(Hue::Blue));
        let [contact] = dots(part, Hue::Orange)[..] else { panic!("one contact") };
        let [_, mark] = dots(part, Hue::Pink)[..] else { panic!("a mark above and one below") };
        assert!((hoop / waist - 2.0).abs() < 1e-3);
        assert!(
            ((contact - middle).length() - waist).abs() < 0.1
                && ((contact - axis).length() - hoop).abs() < 0.1
        );
        assert!(((mark - axis).length() - hoop).abs() < 0.1);
        // Rolling: the arc from mark to contact grows on the hoop by as much as the contact's way round the waist.
        let angle = |of: Point, about: Point| (about.y - of.y).atan2(of.x - about.x);
        let now = [angle(contact, middle), angle(contact, axis) - angle(mark, axis)];
        if let Some(then) = before {
            let way = |k: usize| (now[k] - then[k]).rem_euclid(TAU);
            assert!((waist * way(0) - hoop * way(1)).abs() < 0.3, "{quarters}: {now:?} after {then:?}");
        }
        before = Some(now);
    }
    assert!(before.is_some());
}

#[test]
fn two_mirrors_turn_a_flag_by_twice_their_angle() {
    let [part] = parts("mirrors")[..] else { panic!("one drawing") };
    let [first, second] = lines(part, Stroke::Curve, Hue::Muted)[..] else { panic!("two mirrors") };
    let direction = |line: &[Point]| step(line).1.atan2(step(line).0);
    let between = direction(second) - direction(first);
    let flags: Vec<_> = lines(part, Stroke::Curve, Hue::Blue);
    let [flag, turned] = flags[..] else { panic!("a flag before and after") };
    let [image] = lines(part, Stroke::Outline, Hue::Blue)[..] else { panic!("its image") };
    let origin = first[0];
    let polar = |point: &Point| {
        let arm = *point - origin;
        (arm.length(), (-arm.y).atan2(arm.x))
    };
    for ((before, mirrored), after) in flag.iter().zip(image).zip(turned) {
        let [(r, phi), (r1, phi1), (r2, phi2)] = [before, mirrored, after].map(polar);
        assert!((r1 - r).abs() < 0.01 && (r2 - r).abs() < 0.01);
        assert!((phi1 - (2.0 * direction(first) - phi)).abs() < 1e-3);
        assert!((phi2 - phi - 2.0 * between).abs() < 1e-3);
    }
}

#[test]
fn the_plate_wobbles_twice_while_its_mark_goes_round_once() {
    let parts = parts("wobbles");
    let mut leans = Vec::new();
    let mut marks = Vec::new();
    for part in &parts {
        let axis = lines(part, Stroke::Vector, Hue::Ink)[0];
        leans.push(step(axis).0 > 0.0);
        let [mark, _] = dots(part, Hue::Pink)[..] else { panic!("a mark above and one below") };
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
    let square = |a: f64, b: f64| a * a + b * b;
    let [small, middle, large] = [square(0.1, 0.06), square(0.2, 0.06), square(0.2, 0.1)];
    let wanted = part.axes()[0].point((small / large, middle / large));
    let nearest =
        dots(part, Hue::Blue).into_iter().map(|dot| (dot - wanted).length()).fold(f64::MAX, f64::min);
    assert!(nearest < 0.01, "{nearest} px off");
}

#[test]
fn polhodes_lie_on_both_ellipsoids_and_the_separatrix_between_them() {
    let left = parts("polhodes")[0];
    let camera = Camera::new(View {
        target: [0.0; 3],
        azimuth: 1.18,
        elevation: 0.42,
        distance: 9.0,
        centre: at(215.0, 188.0),
        scale: 162.0,
    });
    let camera = camera.expect("a view");
    // Poinsot's ellipsoid, moments 1 : 2 : 3 and 2T = 1: a ball of the places x, y, z that is stretched.
    let on_page = |[x, y, z]: [f64; 3]| {
        camera.on_page([x, y / 2_f64.sqrt(), z / 3_f64.sqrt()]).expect("before the eye")
    };
    // All places with x² + y² + z² = 1 and x² + 2y² + 3z² = L² of the six curves and their images, finely; the
    // separatrix, L² = 2, is two great circles of the ball.
    let level = |square: f64| {
        let widest = (square - 1.0).min(3.0 - square).sqrt();
        (0..4000).flat_map(move |n| {
            let y = widest * (TAU * f64::from(n) / 4000.0).sin();
            let z = (0.5 * (square - 1.0 - y * y)).max(0.0).sqrt();
            let x = (1.0 - y * y - z * z).max(0.0).sqrt();
            [[x, y, z], [-x, y, z], [x, y, -z], [-x, y, -z]]
        })
    };
    let squares = [14.0_f64, 27.0, 38.0, 52.0, 63.0, 76.0].map(|a| 1.0 + 2.0 * a.to_radians().sin().powi(2));
    for (stroke, hue, squares, least) in
        [(Stroke::Curve, Hue::Orange, &squares[..], 6), (Stroke::Border, Hue::Ink, &[2.0], 2)]
    {
        let truth: Vec<Point> = squares.iter().flat_map(|square| level(*square)).map(on_page).collect();
        let drawn = lines(left, stroke, hue);
        assert!(drawn.len() >= least, "{} lines", drawn.len());
        for point in drawn.into_iter().flatten() {
            let off = truth.iter().map(|place| (*place - *point).length()).fold(f64::INFINITY, f64::min);
            assert!(off < 0.2, "{off} px off at {point:?}");
        }
    }
}

#[test]
fn the_bat_is_thrown_with_one_side_up_and_caught_with_the_other() {
    let stills = parts("bat-flip");
    assert_eq!(stills.len(), 5);
    // Of the two faces the one that is seen is painted last.
    let seen = |still: &Drawing| {
        let mut faces = still.items().iter().filter_map(|item| match item.role {
            Role::Area(Fill::Face, hue) if matches!(item.shape, Shape::Ellipse { .. }) => Some(hue),
            _ => None,
        });
        faces.next_back()
    };
    assert_eq!((seen(stills[0]), seen(stills[4])), (Some(Hue::Pink), Some(Hue::Blue)));
    // L stands still: its arrow, which comes out of the blade, has its tip in one place.
    let tips: Vec<Point> = stills
        .iter()
        .map(|still| {
            *lines(still, Stroke::Vector, Hue::Green).last().and_then(|line| line.last()).expect("L")
        })
        .collect();
    assert!(tips.iter().all(|tip| (*tip - tips[0]).length() < 0.01), "{tips:?}");
}

//! The figures of the chapters on turning and on the wobble plate: curves lie on formulas that are written
//! out here, and arrows point and turn as they should.

use crate::{curve, lies_on, lines, parts};
use drawing::space::{Camera, View};
use drawing::{Drawing, Fill, Hue, Point, Role, Shape, Stroke, at};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// From the first point of a line to its last, to the right and upwards, px.
fn step(line: &[Point]) -> (f64, f64) {
    let [first, last] = [line[0], line[line.len() - 1]];
    (last.x - first.x, first.y - last.y)
}

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
        let drawn = curve("any-thickness", name);
        for step in 0..200 {
            let thickness = from + (to - from) * (f64::from(step) + 0.37) / 200.0;
            assert!(drawn.distance((thickness, needed(thickness))) < crate::PIXELS, "{name} at {thickness}");
        }
    }
    assert!(needed(3_f64.sqrt()).abs() < 1e-12 && (needed(0.0) - 1.676).abs() < 1e-3);
}

#[test]
fn faults_draw_a_circle_a_line_and_a_circle_run_backwards() {
    // By Newton: the push of each piston times its lever, and the pull of the plate, in hundredths of it.
    let slope = 25_f64.to_radians().tan();
    let path = |parts: [f64; 3], aside: f64, turned: f64| {
        let azimuths = [aside, TAU / 3.0, 2.0 * TAU / 3.0];
        let mut sum = Vector3::new(-turned.sin(), turned.cos(), 0.0) * -1.0;
        for (part, azimuth) in parts.into_iter().zip(azimuths) {
            let place = Vector3::new(azimuth.cos(), azimuth.sin(), slope * (azimuth - turned).cos());
            let push = place.cross(&(Vector3::z() * place.z * part / slope)) * (2.0 / 3.0);
            sum -= push;
        }
        (100.0 * sum.x, 100.0 * sum.y)
    };
    for (name, parts, aside) in [
        ("all-heavy", [1.1; 3], 0.0),
        ("one-heavy", [1.1, 1.0, 1.0], 0.0),
        ("one-aside", [1.0; 3], 6_f64.to_radians()),
    ] {
        let drawn = curve("any-faults", name);
        for n in 0..360 {
            let place = path(parts, aside, TAU * (f64::from(n) + 0.37) / 360.0);
            assert!(drawn.distance(place) < crate::PIXELS, "{name}: {place:?}");
        }
    }
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

/// The dots of a hue, in the order in which they were painted.
fn dots(part: &Drawing, hue: Hue) -> Vec<Point> {
    let items = part.items().iter().filter(|item| item.role == Role::Area(drawing::Fill::Solid, hue));
    let centres = items.filter_map(|item| match item.shape {
        Shape::Circle { centre, .. } => Some(centre),
        _ => None,
    });
    centres.collect()
}

#[test]
fn a_speck_is_at_the_top_of_its_circle_when_its_side_of_the_plate_is_high() {
    let [start, later] = parts("specks")[..] else { panic!("two moments") };
    for (part, hue, side) in [(start, Hue::Pink, 1.0), (later, Hue::Ink, -1.0)] {
        let [speck] = dots(part, hue)[..] else { panic!("one speck") };
        // Of the two sides of its tilted circle, the speck is on the one that is higher on the page.
        let path = lines(part, Stroke::Outline, hue).into_iter().filter(|line| line.len() > 4).flatten();
        let end =
            |sign: f64| path.clone().copied().max_by(|p, q| (sign * p.x).total_cmp(&(sign * q.x))).unwrap();
        assert!((speck.x - end(side).x).abs() < 2.0, "{hue:?}: {speck:?}, {:?}", end(side));
        assert!(speck.y < end(-side).y - 20.0, "{hue:?}: y grows downwards");
    }
}

#[test]
fn shares_are_perpendicular_to_their_arms_and_the_pulls_are_a_couple() {
    let [shares, pulls] = parts("shares")[..] else { panic!("shares and pulls") };
    // L, the sum, is between the angular velocity and the axis.
    let lean = |hue| step(lines(shares, Stroke::Vector, hue)[0]).0;
    assert!(lean(Hue::Ink) < lean(Hue::Green) && lean(Hue::Green) < lean(Hue::Orange) - 5.0);
    assert_eq!(lines(shares, Stroke::Outline, Hue::Green).len(), 4);
    // From the side: level, towards each other, on two lines.
    let [first, second] = lines(pulls, Stroke::Vector, Hue::Purple)[..] else { panic!("two pulls") };
    for (pull, other) in [(first, second), (second, first)] {
        let (across, up) = step(pull);
        assert!(up.abs() < 0.5 && across * (other[0].x - pull[0].x) > 0.0);
    }
    assert!((first[0].y - second[0].y).abs() > 50.0);
}

#[test]
fn the_hoop_rolls_once_round_while_it_touches_the_waist_twice_on_each_side() {
    let mut before: Option<[f64; 2]> = None;
    for (quarters, part) in parts("waist").into_iter().enumerate() {
        let circle = |hue| {
            let found = part.items().iter().find_map(|item| match item.shape {
                Shape::Circle { centre, radius } if item.role == Role::Line(Stroke::Curve, hue) => {
                    Some((centre, radius))
                }
                _ => None,
            });
            found.expect("a circle")
        };
        let ((middle, waist), (axis, hoop)) = (circle(Hue::Green), circle(Hue::Blue));
        let [contact] = dots(part, Hue::Orange)[..] else { panic!("one contact") };
        let [mark] = dots(part, Hue::Pink)[..] else { panic!("one mark") };
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
        let [mark] = dots(part, Hue::Pink)[..] else { panic!("a mark") };
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
    let wanted = axes.point((small / large, middle / large));
    let discs = part.items().iter().filter_map(|item| match item.shape {
        Shape::Circle { centre, .. } if item.role == Role::Area(drawing::Fill::Solid, Hue::Blue) => {
            Some(centre)
        }
        _ => None,
    });
    let nearest =
        discs.map(|centre| (centre.x - wanted.x).hypot(centre.y - wanted.y)).fold(f64::MAX, f64::min);
    assert!(nearest < 0.01, "{nearest} px off");
    lies_on("possible-moments", "flat", |first| 1.0 - first);
}

/// A point of Poinsot's ellipsoid, moments 1 : 2 : 3 and 2T = 1, on the page of the left drawing of `polhodes`.
fn on_ellipsoid(camera: &Camera, [x, y, z]: [f64; 3]) -> Point {
    camera.on_page([x, y / 2_f64.sqrt(), z / 3_f64.sqrt()]).expect("before the eye")
}

#[test]
fn polhodes_lie_on_both_ellipsoids_and_the_separatrix_between_them() {
    let left = parts("polhodes")[0];
    let camera = Camera::new(View {
        target: [0.0; 3],
        azimuth: 1.18,
        elevation: 0.42,
        distance: 9.0,
        centre: at(190.0, 165.0),
        scale: 148.0,
    });
    let camera = camera.expect("a view");
    // All places with x² + y² + z² = 1 and x² + 2y² + 3z² = L² of the six curves and their images, finely.
    let mut polhodes = Vec::new();
    for degrees in [14.0_f64, 27.0, 38.0, 52.0, 63.0, 76.0] {
        let square = 1.0 + 2.0 * degrees.to_radians().sin().powi(2);
        let widest = (square - 1.0).min(3.0 - square).sqrt();
        for n in 0..4000 {
            let y = widest * (TAU * f64::from(n) / 4000.0).sin();
            let z = (0.5 * (square - 1.0 - y * y)).max(0.0).sqrt();
            let x = (1.0 - y * y - z * z).max(0.0).sqrt();
            let images = [[x, y, z], [-x, y, z], [x, y, -z], [-x, y, -z]];
            polhodes.extend(images.map(|place| on_ellipsoid(&camera, place)));
        }
    }
    // On the separatrix x² = z²: two great circles of the ball that becomes the ellipsoid.
    let mut separatrix = Vec::new();
    for n in 0..4000 {
        let (y, aside) = (TAU * f64::from(n) / 4000.0).sin_cos();
        let aside = aside * 0.5_f64.sqrt();
        separatrix.extend([[aside, y, aside], [aside, y, -aside]].map(|place| on_ellipsoid(&camera, place)));
    }
    for (stroke, hue, truth, least) in
        [(Stroke::Curve, Hue::Orange, polhodes, 6), (Stroke::Border, Hue::Ink, separatrix, 2)]
    {
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

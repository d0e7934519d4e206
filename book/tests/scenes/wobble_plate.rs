//! The scene of the chapter "The wobble plate": its numbers by the momenta of specks, its extremes, its grips.

use drawing::{Fill, Hue, Point, Role, Room, Shape, Stroke, at};
use live::{Moment, Player, Scene};
use mechanics::scenes::wobble_plate::{Engine, PistonParameters, Pistons, Plate, PlateParameters};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, TAU};

fn scene() -> &'static Scene {
    pages::scenes::named("wobble-plate").expect("the scene")
}

fn played(settings: &[(&str, f64)]) -> Player {
    Player::new(scene()).and_then(|player| player.changed(settings)).expect("settings with an answer")
}

/// The number of a reading that is written with digits after its point.
fn reading(player: &Player, name: &str, time: f64) -> f64 {
    let index =
        scene().readings.iter().position(|reading| reading.words.starts_with(name)).expect("a reading");
    let text = player.readings(time).expect("readings")[index].replace('−', "-");
    let number = text.split(['\u{a0}', '°']).next().unwrap_or_default();
    number.parse().unwrap_or_else(|_| panic!("`{text}` is no number"))
}

/// The angular momentum at a time, from specks of the plate that turn with the shaft, and pistons whose ends lie in
/// the plane of the plate.
fn momentum([tilt, count, mass, spin]: [f64; 4], time: f64) -> Vector3<f64> {
    let (rings, around, phase) = (30, 120, spin * time);
    let place = |x: f64, y: f64| {
        let (x, z) = (x * tilt.cos(), x * tilt.sin());
        Vector3::new(x * phase.cos() - y * phase.sin(), x * phase.sin() + y * phase.cos(), z)
    };
    let mut sum = Vector3::zeros();
    for k in 0..rings * around {
        let radius = 0.1 * ((f64::from(k / around) + 0.5) / f64::from(rings)).sqrt();
        let angle = TAU * f64::from(k % around) / f64::from(around);
        let speck = place(radius * angle.cos(), radius * angle.sin());
        sum += speck.cross(&(Vector3::z() * spin).cross(&speck)) * (2.0 / f64::from(rings * around));
    }
    for n in 0..count as u32 {
        let angle = TAU * f64::from(n) / count - 0.25 * TAU;
        let (x, y) = (0.07 * angle.cos(), 0.07 * angle.sin());
        let height = |phase: f64| tilt.tan() * (x * phase.cos() + y * phase.sin());
        let step = 1e-4;
        let speed = spin * (height(phase + step) - height(phase - step)) / (2.0 * step);
        sum += Vector3::new(x, y, 0.0).cross(&(Vector3::z() * speed)) * (mass / count);
    }
    sum
}

#[test]
fn the_torque_is_the_rate_of_the_momentum_of_specks_and_pistons() {
    let mut random = fastrand::Rng::with_seed(14);
    for _ in 0..40 {
        let tilt = 0.5 * f64::from(random.u32(0..=90));
        let (count, mass) = (f64::from(random.u32(1..=7)), 0.004 * f64::from(random.u32(0..=850)));
        let spin = f64::from(random.u32(10..=150));
        let player = played(&[("tilt", tilt), ("pistons", count), ("mass", mass), ("spin", spin)]);
        let (time, step) = (random.f64() * player.run().duration, 1e-4 / spin);
        let at = |time| momentum([tilt.to_radians(), count, mass, spin], time);
        let rate = (at(time + step) - at(time - step)) / (2.0 * step);
        let shown = reading(&player, "torque", time);
        assert!((shown - rate.norm()).abs() < 0.006 + 1e-3 * rate.norm(), "{shown} for {}", rate.norm());
    }
}

#[test]
fn the_frame_leans_as_the_momentum_that_it_lacks_makes_it() {
    for (count, spin) in [(4.0, 100.0), (2.0, 60.0), (1.0, 145.0)] {
        let settings = [25_f64.to_radians(), count, 0.8, spin];
        let player = played(&[("pistons", count), ("mass", 0.8), ("spin", spin)]);
        // Frame and engine have no momentum across the shaft together: the frame turns by minus its integral over the
        // moment of the frame, 0.02 kg·m², about a middle where it stands when nothing shakes.
        let steps = 200;
        let step = TAU / spin / f64::from(steps);
        let mut leans = vec![Vector3::zeros()];
        for k in 0..steps {
            let momentum = momentum(settings, (f64::from(k) + 0.5) * step);
            let rate = Vector3::new(momentum.x, momentum.y, 0.0) / -0.02;
            leans.push(leans[leans.len() - 1] + rate * step);
        }
        let middle = leans[1..].iter().sum::<Vector3<f64>>() / f64::from(steps);
        for k in [0, 31, 90, 177] {
            let expected = (leans[k] - middle).norm().to_degrees();
            let shown = reading(&player, "lean", k as f64 * step);
            assert!((shown - expected).abs() < 0.02, "{shown}° for {expected}°");
        }
    }
}

#[test]
fn three_do_what_two_cannot() {
    let plate =
        Plate::new(PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.0, tilt: 25_f64.to_radians() });
    let plate = plate.expect("a plate");
    for count in 1..=7 {
        let pistons = PistonParameters { count, mass: 1.676 / f64::from(count), distance: 0.07, rod: 0.2 };
        let engine = Engine::new(plate, Pistons::new(pistons).expect("pistons"));
        for spin in [20.0, 100.0, 150.0] {
            let player = played(&[("pistons", f64::from(count)), ("mass", 1.676), ("spin", spin)]);
            let alone = reading(&player, "without", 0.0);
            let torque = reading(&player, "torque", 0.0013);
            assert!((torque - engine.frame_torque(0.0013 * spin, spin).norm()).abs() < 0.006);
            let words = player.words(0.0);
            if count < 3 {
                assert!((torque - alone).abs() < 0.02, "{torque} of {alone}");
                assert!(words.contains("backwards"), "{words}");
            } else {
                assert!(torque < 0.02, "{torque}");
                assert!(words.starts_with("Balanced"), "{words}");
            }
        }
    }
    // Balance does not survive a change of the tilt.
    let words = played(&[("mass", 1.676), ("tilt", 40.0)]).words(0.0);
    assert!(words.contains("too heavy"), "{words}");
}

#[test]
fn extremes_say_so() {
    for (settings, said) in
        [([("spin", 0.0)], "At rest"), ([("tilt", 0.0)], "flywheel"), ([("mass", 0.0)], "The plate alone")]
    {
        let words = played(&settings).words(0.0);
        assert!(words.contains(said), "{words}");
    }
    assert_eq!(reading(&played(&[("spin", 0.0)]), "lean", 0.1), 0.0);
}

/// Draws grips to where they stand, which changes nothing, and elsewhere, and they follow.
#[test]
fn grips_follow_the_hand() {
    for room in [Room::Wide, Room::Narrow] {
        let mut player = played(&[("mass", 1.0)]);
        let [azimuth, elevation] = scene().view.expect("a view");
        let moment = Moment { time: 0.006, azimuth, elevation, room };
        player.draw(moment).expect("a picture");
        let grips = player.grips();
        assert_eq!(grips.len(), 2);
        for (grip, place) in grips.iter().enumerate() {
            assert_eq!(player.drag(grip, *place).expect("values"), player.values(), "grip {grip}");
        }
        // The mass along its axis, the tilt to where the grip of another tilt stands.
        let follows = |grip: usize, to: Point, near: fn(Point) -> f64| {
            let values = player.drag(grip, to).expect("values");
            assert_ne!(values, player.values());
            let mut moved = Player::with(scene(), values).expect("values in range");
            moved.draw(moment).expect("a picture");
            let distance = near(moved.grips()[grip] - to);
            assert!(distance < 1.0, "{distance} px from the hand");
        };
        follows(0, grips[0] + at(40.0, 7.0), |step| step.x.abs());
        let mut steeper = played(&[("mass", 1.0), ("tilt", 37.5)]);
        steeper.draw(moment).expect("a picture");
        follows(1, steeper.grips()[1], Point::length);
    }
}

#[test]
fn a_plate_of_root_three_radii_shakes_nothing_and_a_longer_one_asks_for_no_pistons() {
    for tilt in [10.0, 25.0, 45.0] {
        for (thickness, alone, said) in [(17.32, true, "three equal moments"), (22.0, false, "too thick")] {
            let player = played(&[("tilt", tilt), ("mass", 0.0), ("thickness", thickness), ("spin", 150.0)]);
            let torque = reading(&player, "torque", 0.003);
            assert_eq!(torque < 0.006, alone, "{torque} at {tilt}° and {thickness} cm");
            assert!(player.words(0.0).contains(said), "{}", player.words(0.0));
        }
        // A long one is pulled as pistons pull: each of them adds to it. ΔI by the formula of a cylinder.
        let difference = |thickness: f64| 2.0 * (0.01 / 4.0 - thickness * thickness / 12.0);
        for (thickness, mass) in [(5.0, 0.4), (17.32, 1.0), (22.0, 0.6)] {
            let settings = [("tilt", tilt), ("mass", mass), ("thickness", thickness), ("spin", 60.0)];
            let (sin, cos) = f64::to_radians(tilt).sin_cos();
            let pistons = 0.5 * mass * 0.07 * 0.07 * sin / cos;
            let expected = (difference(0.01 * thickness) * sin * cos - pistons).abs() * 3600.0;
            let player = played(&settings);
            assert!((reading(&player, "torque", 0.002) - expected).abs() < 0.006, "{settings:?}");
        }
        assert!(played(&[("thickness", 22.0)]).words(0.0).contains("weights on its rim"));
    }
}

#[test]
fn the_floor_is_never_cut_off() {
    for thickness in [0.0, 17.32] {
        let mut player = played(&[("thickness", thickness)]);
        for (step, room) in (0..=72).flat_map(|step| [(step, Room::Wide), (step, Room::Narrow)]) {
            let [azimuth, elevation] = [0.1 * f64::from(step), FRAC_PI_2 * (f64::from(step) / 36.0 - 1.0)];
            let drawing = player.draw(Moment { time: 0.006, azimuth, elevation, room }).unwrap();
            let page = drawing.frame();
            let floors = drawing.items().iter().filter(|item| item.role == Role::Area(Fill::Floor, Hue::Ink));
            let corners: Vec<_> = floors
                .flat_map(|item| match &item.shape {
                    Shape::Polygon(corners) => corners.clone(),
                    shape => panic!("a floor of {shape:?}"),
                })
                .collect();
            assert!(corners.len() > 3);
            for corner in corners {
                assert!(
                    page.contains(corner),
                    "{corner:?} from {azimuth}, {elevation}, {room:?}, {thickness} cm"
                );
            }
        }
    }
}

#[test]
fn pistons_that_are_nearly_right_are_told_from_those_that_are() {
    let words = played(&[("mass", 1.7)]).words(0.0);
    let [own, right] = ["0.425\u{a0}kg each are too heavy", "with 0.419\u{a0}kg each"];
    assert!(words.contains(own) && words.contains(right), "{words}");
}

#[test]
fn the_arrow_of_the_momentum_comes_out_of_a_thick_plate() {
    // Seen from the side of a tall cylinder, nothing of it is drawn over the middle.
    let mut player = played(&[("thickness", 24.0), ("tilt", 0.0), ("mass", 0.0)]);
    let moment = |elevation| Moment { time: 0.0, azimuth: 0.0, elevation, room: Room::Wide };
    let shaft = |player: &mut Player, elevation: f64| {
        let drawing = player.draw(moment(elevation)).unwrap();
        let green = drawing.items().iter().enumerate().filter_map(|(place, item)| match &item.shape {
            Shape::Polyline(points) if item.role == Role::Line(Stroke::Vector, Hue::Green) => {
                Some((place, points[0].y))
            }
            _ => None,
        });
        let (place, foot) = green.max_by(|one, other| one.1.total_cmp(&other.1)).expect("an arrow");
        let is_plate = |role: Role| role == Role::Area(Fill::Side, Hue::Blue);
        let plate = drawing.items().iter().rposition(|item| is_plate(item.role)).expect("a plate");
        (foot, place < plate)
    };
    let (foot, is_behind) = shaft(&mut player, 0.3);
    let drawing = player.draw(moment(0.3)).unwrap();
    let grip = player.grips()[1]; // the high end of the plate's middle plane, at the height of its centre for no tilt
    assert!(!is_behind && foot < grip.y - 20.0, "{foot} and {grip:?} of {}", drawing.height());
    assert!(shaft(&mut player, -0.3).1, "from below the plate hides its foot");
}

//! The scene of the spinning coin: its rounds, its head, its ends, and what a hand takes hold of.

use drawing::{Fill, Hue, Point, Rect, Role, Room, Shape, at};
use fastrand::Rng;
use live::{Moment, Player, Scene};
use mechanics::euler::{self, Turning};
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

const A: f64 = 0.0375;
const G: f64 = 9.81;

fn scene() -> &'static Scene {
    let found = pages::scenes::named("spinning-coin");
    found.expect("a scene of the spinning coin")
}

fn set(settings: &[(&str, f64)]) -> Player {
    Player::new(scene()).expect("it begins").changed(settings).expect("a motion")
}

/// The number that is written in the reading that begins with these words.
fn reading(player: &Player, words: &str, time: f64) -> f64 {
    let place = scene().readings.iter().position(|reading| reading.words.starts_with(words)).expect(words);
    let text = player.readings(time).expect("readings").swap_remove(place);
    let number = text
        .split('\u{a0}')
        .next()
        .expect("a number")
        .replace('−', "-")
        .replace("·10<sup>", "e")
        .replace("10<sup>", "1e");
    number.replace("</sup>", "").replace('°', "").parse().unwrap_or(f64::NAN)
}

#[test]
fn the_head_turns_as_a_simulated_coin_does() {
    let mut random = Rng::with_seed(9);
    for _ in 0..12 {
        let (tilt, which) = (0.2 + 1.0 * random.f64(), random.u8(0..2));
        let player = set(&[("tilt", tilt), ("coin", f64::from(which))]);
        // A free body on its lowest point, with the support of its weight: gravity has no torque about the centre.
        let diameter = [0.25, 0.5][usize::from(which)] * A * A;
        let moments = PrincipalMoments::symmetric(diameter, 2.0 * diameter).expect("a coin");
        let torque = |_: f64, turning: &Turning| {
            let n = turning.axis_3_world();
            let lowest = (n * n.z - Vector3::z()).normalize() * A;
            turning.world_from_body.inverse() * lowest.cross(&Vector3::new(0.0, 0.0, G))
        };
        let start = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), tilt);
        let rate = (G * A * A / (diameter * A * tilt.sin())).sqrt();
        // About the line from contact to centre, which rises along y of the body.
        let begin = Turning { world_from_body: start, omega_body: Vector3::y() * (rate * tilt.sin()) };
        let rounds = 2.0;
        let rates = euler::turning_rates(moments, torque);
        let solver = Dop853::new(1e-12).expect("a tolerance");
        let end = solver.solve(rates, 0.0, begin.to_array(), rounds * TAU / rate).expect("it turns");
        let end = Turning::from_array(end.state).world_from_body;
        let turned = (start.inverse() * end).scaled_axis().z.to_degrees();
        let time = rounds * 6.0; // six seconds of the film show a round
        assert!((reading(&player, "rounds", time) - rounds).abs() < 1e-9);
        let difference = (reading(&player, "head turned", time) - turned) / 360.0;
        assert!((difference - difference.round()).abs() * 360.0 < 0.06, "tilt {tilt}: {turned}°");
        assert!(reading(&player, "slip", time).abs() < 1e-13);
        assert!((reading(&player, "real time gone", time) * rate / TAU / rounds - 1.0).abs() < 6e-3);
    }
}

#[test]
fn what_is_left_over_of_the_rim_is_told_and_vanishes_when_flat() {
    let words = |tilt: f64| set(&[("tilt", tilt)]).words(0.0);
    assert!(words(60_f64.to_radians()).contains("The 180° that are left over"), "{}", words(1.047));
    assert!(words(0.01).contains("314 µrad"), "{}", words(0.01)); // π/10⁴
    assert!(words(1.5).contains("goes round 1.08 times"));
}

#[test]
fn each_law_ends_where_the_book_says() {
    for (which, power, mach) in [(1, 2.0, 0.07), (2, 1.25, 0.157), (3, 1.0, 0.243), (4, 0.5, 1.165)] {
        let player = set(&[("tilt", 0.1), ("loss", f64::from(which))]);
        let end = player.run().duration;
        let found = reading(&player, "contact, in", end);
        assert!((found / mach - 1.0).abs() < 0.04, "p = {power}: Mach {found}");
        let words = player.words(0.0);
        assert_eq!(words.contains("Sound is not reached"), mach < 1.0, "{words}");
        // The tilt goes as the power 1/(p + 1) of the time left; the film shortens that to a tenth in six seconds.
        let (early, late) = (reading(&player, "tilt", 6.0), reading(&player, "tilt", 12.0));
        let fall = 10_f64.powf(-1.0 / (power + 1.0));
        assert!((late / early / fall - 1.0).abs() < 6e-3, "p = {power}");
        // The head turns by the sum of √(g/a) α^{3/2}: added up by steps of a thousandth of the life.
        let sum: f64 = (0..90_000)
            .map(|k| {
                let left = 100.0 - 1e-3 * (f64::from(k) + 0.5);
                let alpha = 0.1 * (left / 100.0).powf(1.0 / (power + 1.0));
                1e-3 * 2.0 * (G / (0.25 * A * alpha.sin())).sqrt() * (0.5 * alpha).sin().powi(2)
            })
            .sum();
        let turned = reading(&player, "head turned", 6.0); // 90 s are gone
        assert!(
            (turned / sum.to_degrees() - 1.0).abs() < 1e-3,
            "p = {power}: {turned}° for {}°",
            sum.to_degrees()
        );
    }
    // Below the end of the law there is no way down by it.
    let words = set(&[("tilt", 1e-5), ("loss", 1.0)]).words(0.0);
    assert!(words.contains("faster than falling"), "{words}");
}

#[test]
fn a_hand_takes_the_tilt() {
    for loss in [0.0, 3.0] {
        let mut player = set(&[("loss", loss)]);
        for room in [Room::Wide, Room::Narrow] {
            let moment = Moment { time: 2.0, azimuth: -FRAC_PI_2, elevation: 0.8, room };
            player.draw(moment).expect("a picture");
            let grip = player.grips()[0];
            let tilt = player.drag(0, grip).expect("a drag")[0];
            assert!((tilt / 0.6 - 1.0).abs() < 1e-9);
            for step in [-60.0, -11.0, 5.0] {
                let drawn = player.drag(0, grip + at(step, 0.0)).expect("a drag")[0];
                let mut moved = player.changed(&[("tilt", drawn)]).expect("a motion");
                moved.draw(moment).expect("a picture");
                assert!((moved.grips()[0].x - grip.x - step).abs() < 1.0);
            }
        }
    }
}

#[test]
fn a_hoop_is_drawn_with_a_hole() {
    // Straight from above and nearly flat: what covers the middle of the coin there is its face.
    let covers = |which: f64| {
        let mut player = set(&[("tilt", 0.05), ("coin", which)]);
        let moment = Moment { time: 1.0, azimuth: -FRAC_PI_2, elevation: FRAC_PI_2, room: Room::Wide };
        let drawing = player.draw(moment).expect("a picture");
        let faces = drawing.items().iter().filter(|item| item.role == Role::Area(Fill::Face, Hue::Blue));
        let middle = Rect::new(4.0, 4.0, 400.0, 432.0).centre();
        let is_round = |points: &[Point]| {
            let nearest = points.iter().map(|point| (*point - middle).length()).fold(f64::INFINITY, f64::min);
            points.len() > 12 && nearest > 60.0
        };
        // A ring's face goes round and back on the inside: its middle is not in it.
        faces
            .filter(|item| match &item.shape {
                Shape::Polygon(points) => is_round(points) && winds(points, middle),
                Shape::Ellipse { centre, .. } | Shape::Circle { centre, .. } => {
                    (*centre - middle).length() < 60.0
                }
                _ => false,
            })
            .count()
    };
    assert_eq!([covers(0.0), covers(1.0)], [1, 0]);
}

/// Whether a closed line goes round a point.
fn winds(points: &[Point], middle: Point) -> bool {
    let angle = |point: &Point| (point.y - middle.y).atan2(point.x - middle.x);
    let turned: f64 = (0..points.len())
        .map(|k| angle(&points[(k + 1) % points.len()]) - angle(&points[k]))
        .map(|step| step - TAU * (step / TAU).round())
        .sum();
    turned.abs() > 3.0
}

#[test]
fn great_numbers_are_told_in_words_that_fit_them() {
    let words = |tilt: f64| set(&[("tilt", tilt)]).words(0.0);
    assert!(words(1e-5).contains("20.0 billion times"), "{}", words(1e-5)); // 2/α²
    assert!(words(1e-3).contains("2.00 million times"), "{}", words(1e-3));
}

//! The scene of the spinning coin: its rounds, its head, and its ends.

use crate::hand::Hand;
use drawing::{Fill, Hue, Point, Rect, Role, Room, Shape};
use fastrand::Rng;
use mechanics::euler::{self, Turning};
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

const A: f64 = 0.0375;
const G: f64 = 9.81;

fn set(settings: &[(&str, f64)]) -> Hand {
    Hand::with("spinning-coin", settings)
}

#[test]
fn the_head_turns_as_a_simulated_coin_does() {
    let mut random = Rng::with_seed(9);
    for _ in 0..12 {
        let (tilt, which) = (0.2 + 1.0 * random.f64(), random.u8(0..2));
        let hand = set(&[("tilt", tilt), ("coin", f64::from(which))]);
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
        assert!((hand.reading(time, "rounds") - rounds).abs() < 1e-9);
        let difference = (hand.reading(time, "head turned") - turned) / 360.0;
        assert!((difference - difference.round()).abs() * 360.0 < 0.06, "tilt {tilt}: {turned}°");
        assert!(hand.reading(time, "slip").abs() < 1e-13);
        assert!((hand.reading(time, "real time gone") * rate / TAU / rounds - 1.0).abs() < 6e-3);
    }
}

#[test]
fn the_coin_whirs_as_often_as_its_contact_comes_round() {
    for settings in [&[][..], &[("tilt", 0.1), ("loss", 1.0)], &[("tilt", 0.1), ("loss", 4.0)]] {
        let hand = set(settings);
        for part in [0.0, 0.4, 0.99] {
            let time = part * hand.duration();
            let (heard, told) = (hand.sound(time).expect("a sound").frequency, hand.reading(time, "whir"));
            assert!((heard - told).abs() <= 0.051, "{settings:?} at {time}: {heard} and {told} Hz");
        }
    }
}

#[test]
fn each_law_ends_where_the_book_says() {
    for (which, power, mach) in [(1, 2.0, 0.07), (2, 1.25, 0.157), (3, 1.0, 0.243), (4, 0.5, 1.165)] {
        let hand = set(&[("tilt", 0.1), ("loss", f64::from(which))]);
        let found = hand.reading(hand.duration(), "contact, in");
        assert!((found / mach - 1.0).abs() < 0.04, "p = {power}: Mach {found}");
        let words = hand.words();
        assert_eq!(words.contains("Sound is not reached"), mach < 1.0, "{words}");
        // The tilt goes as the power 1/(p + 1) of the time left; the film shortens that to a tenth in six seconds.
        let (early, late) = (hand.reading(6.0, "tilt"), hand.reading(12.0, "tilt"));
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
        let turned = hand.reading(6.0, "head turned"); // 90 s are gone
        assert!((turned / sum.to_degrees() - 1.0).abs() < 1e-3, "p = {power}: {turned}° for {sum} rad");
    }
}

#[test]
fn a_hoop_is_drawn_with_a_hole() {
    // Straight from above and nearly flat: what covers the middle of the coin there is its face.
    let covers = |which: f64| {
        let mut hand = set(&[("tilt", 0.05), ("coin", which)]);
        let drawing = hand.draw_from([-FRAC_PI_2, FRAC_PI_2], 1.0, Room::Wide);
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

//! The scene of the chapter "The ball": each place by forces that are written out here.

use crate::hand::Hand;
use fastrand::Rng;

const G: f64 = 9.81;

fn set(settings: &[(&str, f64)]) -> Hand {
    Hand::with("ball", settings)
}

#[test]
fn a_ball_on_a_cloth_slides_as_two_carts_do() {
    let mut random = Rng::with_seed(31);
    for n in 0..12 {
        let mut draw = |low: f64, high: f64| (10.0 * (low + (high - low) * random.f64())).round() / 10.0;
        let (speed, roll, side) = (draw(0.5, 4.0), draw(-8.0, 8.0), draw(-5.0, 5.0));
        let kind = f64::from(n % 2);
        let hand = set(&[("kind", kind), ("speed", speed), ("roll", roll), ("side", side)]);
        let k = [0.4, 2.0 / 3.0][n as usize % 2];
        let (mut v, mut w) = ([speed, 0.0], [roll, side]);
        let time = 0.4;
        let steps = 20_000;
        for _ in 0..steps {
            let slip = [v[0] - w[0], v[1] - w[1]];
            let size = slip[0].hypot(slip[1]);
            // What a step can take, and no more than there is.
            let most = size * k / (1.0 + k);
            let push = (0.2 * G * time / f64::from(steps)).min(most);
            for axis in 0..2 {
                let force = if size > 0.0 { -push * slip[axis] / size } else { 0.0 };
                v[axis] += force;
                w[axis] -= force / k;
            }
        }
        let found = [hand.reading(time, "speed of the centre"), hand.reading(time, "its spin would roll at")];
        for (found, [x, y]) in found.into_iter().zip([v, w]) {
            assert!((found - x.hypot(y)).abs() < 1e-3, "{speed} {roll} {side}: {found} {x} {y}");
        }
        let slip = (v[0] - w[0]).hypot(v[1] - w[1]);
        assert!((hand.reading(time, "slip") - slip).abs() < 1e-3);
        assert!(hand.reading(time, "drift of what is") < 1e-12);
    }
}

#[test]
fn on_the_table_nothing_slips_and_the_circle_takes_three_and_a_half_turns() {
    for (kind, turns) in [(0.0, "3.50"), (1.0, "2.50")] {
        let hand = set(&[("place", 1.0), ("speed", 0.5), ("kind", kind)]);
        assert!(hand.words().contains(turns), "{}", hand.words());
        for part in [0.1, 0.5, 0.9] {
            assert!(hand.reading(part * hand.duration(), "slip") < 1e-12);
            assert!((hand.reading(part * hand.duration(), "speed of the centre") - 0.5).abs() < 1e-3);
            assert!(hand.reading(part * hand.duration(), "drift of what is") < 1e-12);
        }
    }
    let tilted = Hand::preset("ball", "tilted table");
    let drift = 2.5 * G * 2_f64.to_radians().sin() / 6.0;
    assert!(tilted.words().contains(&format!("{drift:.3}\u{a0}m/s")), "{}", tilted.words());
    assert!(tilted.reading(0.7 * tilted.duration(), "drift of what is") < 1e-12);
}

#[test]
fn a_ball_comes_out_of_the_hole_as_fast_as_it_went_in() {
    let hand = Hand::preset("ball", "in and out");
    assert!(hand.words().contains("5.8\u{a0}cm") && hand.words().contains("and is out"), "{}", hand.words());
    for part in [0.2, 0.6, 1.0] {
        assert!(hand.reading(part * hand.duration(), "slip") < 1e-12);
        assert!(hand.reading(part * hand.duration(), "drift of what is") < 1e-12);
    }
    let end = hand.reading(hand.duration(), "speed of the centre");
    assert!((end - 1.09_f64.sqrt()).abs() < 1e-3);
    // Too slow: it meets the floor, where the scene ends.
    let slow = set(&[("place", 2.0), ("speed", 0.5)]);
    assert!(slow.words().contains("lies on its floor"));
}

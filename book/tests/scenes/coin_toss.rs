//! The scene of "The coin toss" against a simulation, the book's formulas, and a hand that draws its grips.

use crate::hand::Hand;
use drawing::at;
use fastrand::Rng;
use live::Room;
use mechanics::euler::{self, Turning};
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::PI;

const HEIGHT: usize = 0;
const ABOVE: usize = 2;
const TOSSES: usize = 3;
const HEADS: usize = 4;
const DRIFT: usize = 5;

#[test]
fn heights_are_those_of_a_simulation() {
    let mut random = Rng::with_seed(15);
    for _ in 0..15 {
        let (tumble, twist) = (f64::from(random.u32(1..=600)) / 2.0, f64::from(random.u32(0..=600)) / 2.0);
        let ratio = f64::from(random.u32(50..=200)) / 100.0;
        let hand = Hand::with("coin-toss", &[("tumble", tumble), ("twist", twist), ("ratio", ratio)]);
        let moments = PrincipalMoments::symmetric(1.0, ratio).unwrap();
        let start = Turning {
            world_from_body: UnitQuaternion::identity(),
            omega_body: Vector3::new(tumble, 0.0, twist),
        };
        let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
        let time = 0.4 * random.f64();
        let end = Dop853::new(1e-12).unwrap().solve(free, 0.0, start.to_array(), time).unwrap();
        let height = Turning::from_array(end.state).axis_3_world().z;
        assert!((hand.reading(time, HEIGHT) - height).abs() < 1e-8, "{tumble} {twist} {ratio} at {time}");
        assert!(hand.reading(time, DRIFT) < 1e-14);
    }
}

#[test]
fn the_part_above_is_the_part_of_the_moments_at_which_heads_shows() {
    let mut random = Rng::with_seed(16);
    for _ in 0..15 {
        let (tumble, twist) = (f64::from(random.u32(100..=600)) / 2.0, f64::from(random.u32(0..=300)) / 2.0);
        let hand = Hand::with("coin-toss", &[("tumble", tumble), ("twist", twist)]);
        // A thousand moments of one precession.
        let period = 2.0 * PI / tumble.hypot(2.0 * twist);
        let heads =
            (0..1000).filter(|k| hand.reading(period * (f64::from(*k) + 0.5) / 1e3, HEIGHT) >= 0.0).count();
        let above = hand.reading(0.0, ABOVE);
        assert!(
            (above - heads as f64 / 1e3).abs() < 3e-3,
            "tumble {tumble}, twist {twist}: the scene says {above}, and heads shows at {heads} of 1000 moments"
        );
        assert!(hand.reading(0.0, ABOVE) >= 0.5);
    }
}

#[test]
fn thousands_of_tosses_come_near_the_probability_if_the_hand_is_unsure() {
    let mut random = Rng::with_seed(17);
    for _ in 0..10 {
        let twist = f64::from(random.u32(0..=280)) / 2.0;
        let settings = [("twist", twist), ("toss", 0.4 * random.f64())];
        let tossed = |hand: f64| Hand::with("coin-toss", &[&settings[..], &[("hand", hand)]].concat());
        let hand = tossed(0.0);
        // Four standard deviations of five thousand tosses, and half a per cent for what is left of the last window.
        let (heads, p) = (hand.reading(0.0, HEADS), hand.reading(0.0, ABOVE));
        assert!(
            (heads - p).abs() < 4.0 * (p * (1.0 - p) / 5e3).sqrt() + 0.01,
            "twist {twist}: {heads} of the tosses, and not {p}"
        );
        assert_eq!(hand.reading(0.0, TOSSES), 5000.0);
        // A machine knows no chance: all show what the coin shows at the end.
        let machine = tossed(2.0);
        let caught = machine.reading(2.0 * 2.4 / 9.81, HEIGHT);
        assert_eq!(machine.reading(0.0, HEADS), if caught >= 0.0 { 1.0 } else { 0.0 });
        assert!(machine.words().contains("no chance in it"));
    }
}

#[test]
fn tosses_are_made_one_after_another_and_always_the_same() {
    let hand = Hand::with("coin-toss", &[("toss", 0.1)]);
    let made: Vec<f64> = [0.1, 0.11, 0.15, 0.3].map(|time| hand.reading(time, TOSSES)).to_vec();
    assert!(made.is_sorted() && made[0] >= 100.0 && made[0] < made[1] && made[3] == 5000.0, "{made:?}");
    let again = Hand::with("coin-toss", &[("toss", 0.1)]);
    assert_eq!(hand.reading(0.13, HEADS), again.reading(0.13, HEADS));
    let others = Hand::with("coin-toss", &[("toss", 0.11)]);
    assert_ne!(hand.reading(0.3, HEADS), others.reading(0.3, HEADS));
    let none = Hand::with("coin-toss", &[]);
    assert!(none.reading(0.3, TOSSES) == 0.0 && none.reading(0.3, HEADS).is_nan());
}

#[test]
fn a_sure_hand_and_a_thick_coin_say_so() {
    for (settings, words) in [
        (&[("toss", 0.0), ("hand", 1.0)][..], "too sure of itself"),
        (&[("toss", 0.0)], "as chance will have it"),
        (&[("twist", 144.0)], "heads shows all the time"),
        (&[("twist", 120.0)], "stands on edge for an instant"),
        (&[("twist", 144.0), ("ratio", 1.0)], "less than 1.00 times"),
        (&[("tumble", 0.0)], "the circle is a point"),
        (&[("tumble", 0.0), ("twist", 0.0), ("toss", 0.0)], "does not turn at all"),
    ] {
        let said = Hand::with("coin-toss", settings).words();
        assert!(said.contains(words), "{said}");
    }
}

#[test]
fn the_dot_and_the_momentum_follow_the_hand() {
    for room in [Room::Wide, Room::Narrow] {
        let mut hand = Hand::with("coin-toss", &[]);
        hand.draw(0.03, room);
        // The dot keeps to its curve: only sideways it is where the hand is.
        for step in [-20.0, -45.0, 12.0] {
            let off = hand.draws(0, at(step, 7.0)).x.abs();
            assert!(off < 1.0, "the dot is {off} px aside");
        }
        assert!(hand.words().contains("all the time"), "{}", hand.words());
        assert_eq!(hand.value("ratio"), 2.0);
        // The momentum keeps to its arc: from there it can be drawn back to the same angle.
        let angle = |hand: &Hand| hand.value("tumble").atan2(2.0 * hand.value("twist"));
        let before = angle(&hand);
        hand.draws(1, at(6.0, 25.0));
        assert!(angle(&hand) > before + 0.1);
        let after = hand.draws(1, at(-6.0, -25.0));
        assert!((angle(&hand) - before).abs() < 0.06 && after.length() < 12.0, "{after:?}");
    }
}

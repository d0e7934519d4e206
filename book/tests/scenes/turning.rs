//! The scene of "How a body turns" against a simulation and counts of its own.

use crate::hand::Hand;
use drawing::{Fill, Hue, Role, Room};
use fastrand::Rng;
use mechanics::euler::{self, Turning};
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

const WOBBLES: &str = "wobbles";
const TURNS: &str = "turns about";
const WOBBLES_A_TURN: &str = "wobbles a turn";
const TO_MOMENTUM: &str = r"angle of axis and $\boldsymbol{L}$";
const TO_OMEGA: &str = r"angle of axis and $\boldsymbol{\omega}$";

/// Wobbles counted in a simulation that has never heard of the split: how often the axis goes round the momentum.
fn counted(ratio: f64, across: f64, spin: f64, seconds: f64) -> f64 {
    let moments = PrincipalMoments::symmetric(1.0, ratio).unwrap();
    let start =
        Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(across, 0.0, spin) };
    let momentum = start.angular_momentum_world(&moments).normalize();
    let first = (Vector3::z() - momentum * momentum.z).normalize();
    let second = momentum.cross(&first);
    let times: Vec<f64> = (0..=400).map(|k| seconds * f64::from(k) / 400.0).collect();
    let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
    let (states, _) = Dop853::new(1e-11).unwrap().sample(free, 0.0, start.to_array(), &times).unwrap();
    let (mut angle, mut before) = (0.0, 0.0);
    for state in states {
        let axis = Turning::from_array(state).axis_3_world();
        let now = axis.dot(&second).atan2(axis.dot(&first));
        angle += (now - before + 1.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
        before = now;
    }
    angle / TAU
}

#[test]
fn wobbles_are_those_of_a_simulation() {
    let mut random = Rng::with_seed(14);
    for _ in 0..25 {
        let tenths = |random: &mut Rng| f64::from(random.u32(5..=150)) / 10.0;
        let (across, spin) = (tenths(&mut random), tenths(&mut random));
        let ratio = f64::from(random.u32(2..=200)) / 100.0;
        let hand = Hand::with("turning", &[("across", across), ("spin", spin), ("ratio", ratio)]);
        let (time, wobbles) = (1.5, counted(ratio, across, spin, 1.5));
        let turns = spin * time / TAU;
        for (words, expected, slack) in [
            (WOBBLES, wobbles, 1e-7),
            (TURNS, turns, 1e-12),
            (WOBBLES_A_TURN, wobbles / turns, 1e-6 * (1.0 + wobbles / turns)),
            (r"drift of $\boldsymbol{L}$", 0.0, 1e-14),
            ("drift of the energy", 0.0, 1e-14),
        ] {
            let found = hand.reading(time, words);
            assert!((found - expected).abs() < slack, "{across} {spin} {ratio}: {words} {found}");
        }
    }
}

#[test]
fn a_slight_wobble_of_a_flat_body_is_two_to_one_and_of_a_ball_one_to_one() {
    for (ratio, wobbles) in [(2.0, 2.0), (1.0, 1.0), (0.5, 0.5)] {
        let hand = Hand::with("turning", &[("across", 0.1), ("spin", 15.0), ("ratio", ratio)]);
        assert!((hand.reading(0.0, WOBBLES_A_TURN) - wobbles).abs() < 1e-4); // a wobble of 0.4°, squared
    }
    // L is nearer to the axis than ω is, or not, as the words say.
    for ratio in [1.5, 1.0, 0.5] {
        let hand = Hand::with("turning", &[("ratio", ratio)]);
        let [to_momentum, to_omega] = [TO_MOMENTUM, TO_OMEGA].map(|words| hand.reading(0.7, words));
        assert_eq!(to_momentum.total_cmp(&to_omega), 1.0_f64.total_cmp(&ratio), "{ratio}");
    }
    // Where nothing wobbles no wobbles are counted, and where nothing spins none a turn.
    let perfect = Hand::with("turning", &[("across", 0.0)]);
    assert!(perfect.reading(2.0, WOBBLES).is_nan() && perfect.reading(2.0, WOBBLES_A_TURN).is_nan());
    assert!(perfect.reading(2.0, TURNS) > 3.0);
    assert!(Hand::with("turning", &[("spin", 0.0)]).reading(1.0, WOBBLES_A_TURN).is_nan());
}

#[test]
fn the_floor_stays_above_the_plot() {
    for room in [Room::Wide, Room::Narrow] {
        let drawing = Hand::with("turning", &[]).draw(0.0, room);
        // The plot of time below it has a line of words above its frame.
        let title = drawing.axes()[1].frame.top - 22.0;
        let floors = drawing.items().iter().filter(|item| item.role == Role::Area(Fill::Floor, Hue::Ink));
        let corners = floors.flat_map(|item| item.shape.points());
        let lowest = corners.map(|corner| corner.y).fold(0.0, f64::max);
        assert!(lowest > 200.0 && lowest < title, "{lowest} and {title}, {room:?}");
    }
}

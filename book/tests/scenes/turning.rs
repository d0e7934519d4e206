//! The scene of "How a body turns" against a simulation, counts of its own, and a hand that draws its grips.

use crate::hand::Hand;
use drawing::{Fill, Hue, Role, Shape, at};
use fastrand::Rng;
use live::{Moment, Player, Room};
use mechanics::euler::{self, Turning};
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

const WOBBLES: usize = 0;
const TURNS: usize = 1;
const WOBBLES_A_TURN: usize = 2;
const TO_MOMENTUM: usize = 3;
const DRIFTS: [usize; 2] = [5, 6];

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
        let (time, case) = (1.5, format!("{across} {spin} {ratio}"));
        let wobbles = counted(ratio, across, spin, time);
        assert!((hand.reading(time, WOBBLES) - wobbles).abs() < 1e-7, "{case}");
        assert!((hand.reading(time, TURNS) - spin * time / TAU).abs() < 1e-12, "{case}");
        let a_turn = wobbles / (spin * time / TAU);
        assert!((hand.reading(time, WOBBLES_A_TURN) - a_turn).abs() < 1e-6 * (1.0 + a_turn), "{case}");
        for drift in DRIFTS {
            assert!(hand.reading(time, drift).abs() < 1e-14, "{case}");
        }
    }
}

#[test]
fn a_slight_wobble_of_a_flat_body_is_two_to_one_and_of_a_ball_one_to_one() {
    for (ratio, wobbles) in [(2.0, 2.0), (1.0, 1.0), (0.5, 0.5)] {
        let hand = Hand::with("turning", &[("across", 0.1), ("spin", 15.0), ("ratio", ratio)]);
        assert!((hand.reading(0.0, WOBBLES_A_TURN) - wobbles).abs() < 1e-4); // a wobble of 0.4°, squared
    }
}

#[test]
fn words_tell_which_arrow_is_in_the_middle() {
    for (ratio, words) in [
        (1.5, "L/I₁ reaches 1.50 times as high along the axis as ω does, and lies between the axis and ω"),
        (1.0, "L lies along ω"),
        (0.5, "ω has come between the axis and L"),
    ] {
        let said = Hand::with("turning", &[("ratio", ratio)]).words();
        assert!(said.contains(words), "{said}");
        // And so it is: L is nearer to the axis than ω is, or not.
        let hand = Hand::with("turning", &[("ratio", ratio)]);
        let [to_momentum, to_omega] = [TO_MOMENTUM, TO_MOMENTUM + 1].map(|place| hand.reading(0.7, place));
        assert_eq!(to_momentum.total_cmp(&to_omega), 1.0_f64.total_cmp(&ratio), "{ratio}");
    }
}

#[test]
fn extremes_say_what_they_are() {
    for (settings, words) in [
        (&[("across", 0.0), ("spin", 0.0)][..], "Nothing turns"),
        (&[("across", 0.0)], "A perfect throw"),
        (&[("spin", 0.0)], "tumbles about a diameter"),
        (&[("camera", 1.0), ("ratio", 0.5)], "backwards"),
        (&[("camera", 1.0)], "forwards"),
        (&[("cones", 1.0)], "like a hula hoop"),
    ] {
        let said = Hand::with("turning", settings).words();
        assert!(said.contains(words), "{said}");
    }
    let still = Hand::with("turning", &[("spin", 0.0)]);
    assert!(still.reading(1.0, WOBBLES_A_TURN).is_nan());
}

#[test]
fn cones_roll_without_slipping() {
    // What of its rim each cone has rolled off while the axis goes round once is as long as the other's.
    let hand = Hand::with("turning", &[("cones", 1.0), ("across", 6.0), ("spin", 9.0), ("ratio", 1.6)]);
    let [to_momentum, to_omega] =
        [TO_MOMENTUM, TO_MOMENTUM + 1].map(|place| hand.reading(0.0, place).to_radians());
    let rims = to_omega.sin() / (to_omega - to_momentum).sin();
    let said = hand.words();
    let told = said.split("Its rim is ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
    assert!((told.parse::<f64>().unwrap() - rims).abs() < 0.03, "{said}: {rims}");
}

#[test]
fn the_tips_follow_the_hand() {
    for room in [Room::Wide, Room::Narrow] {
        let mut hand = Hand::with("turning", &[]);
        hand.draw(0.3, room);
        // ω to wherever there is room, L up and down.
        for (grip, step) in [(0, at(20.0, -20.0)), (0, at(5.0, 12.0)), (1, at(0.0, 40.0)), (1, at(0.0, 15.0))]
        {
            let off = hand.draws(grip, step).length();
            assert!(off < 1.0, "grip {grip} is {off} px from the hand");
        }
        assert!(hand.value("ratio") < 1.6 && hand.value("across") > 6.5, "{}", hand.words());
    }
}

#[test]
fn where_nothing_wobbles_no_wobbles_are_counted() {
    let hand = Hand::with("turning", &[("across", 0.0)]);
    assert!(hand.words().contains("nothing to wobble"));
    assert!(hand.reading(2.0, WOBBLES).is_nan() && hand.reading(2.0, WOBBLES_A_TURN).is_nan());
    assert!(hand.reading(2.0, TURNS) > 3.0);
}

#[test]
fn the_floor_stays_above_the_plot() {
    let scene = pages::scenes::named("turning").unwrap();
    let [azimuth, elevation] = scene.view.unwrap();
    for room in [Room::Wide, Room::Narrow] {
        let drawing =
            Player::new(scene).unwrap().draw(Moment { time: 0.0, azimuth, elevation, room }).unwrap();
        // The plot below it has a line of words above its frame: on a phone that of the plane, otherwise that of time.
        let below = room.of(1, 0);
        let title = drawing.axes()[below].frame.top - 22.0;
        let floors = drawing.items().iter().filter(|item| item.role == Role::Area(Fill::Floor, Hue::Ink));
        let lowest = floors.flat_map(|item| match &item.shape {
            Shape::Polygon(corners) => corners.clone(),
            shape => panic!("a floor of {shape:?}"),
        });
        let lowest = lowest.map(|corner| corner.y).fold(0.0, f64::max);
        assert!(lowest > 200.0 && lowest < title, "{lowest} and {title}, {room:?}");
    }
}

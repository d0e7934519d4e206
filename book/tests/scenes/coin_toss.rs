//! The scene of "The coin toss" against a simulation, and its tosses against chance.

use crate::hand::Hand;
use drawing::{Fill, Hue, Role, Shape};
use fastrand::Rng;
use live::Room;
use mechanics::euler::{self, Turning};
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::PI;

const HEIGHT: &str = "height of the normal";
const ABOVE: &str = "part of the circle";
const TOSSES: &str = "tosses";
const HEADS: &str = "part that were heads";

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
        assert!(hand.reading(time, "drift of") < 1e-14);
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
        let moments = (0..1000).map(|k| period * (f64::from(k) + 0.5) / 1e3);
        let heads = moments.filter(|moment| hand.reading(*moment, HEIGHT) >= 0.0).count() as f64 / 1e3;
        let above = hand.reading(0.0, ABOVE);
        let of =
            format!("tumble {tumble}, twist {twist}: the scene says {above}, and heads shows in {heads}");
        assert!((above - heads).abs() < 3e-3 && above >= 0.5, "{of}");
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
    }
}

#[test]
fn what_five_thousand_tosses_gave_stays_on_the_plot() {
    let results = |hand: &mut Hand| {
        let drawing = hand.draw(0.2, Room::Wide);
        let dots = drawing.items().iter().filter_map(|item| match item.shape {
            Shape::Circle { centre, radius: 2.5 } if item.role == Role::Area(Fill::Solid, Hue::Pink) => {
                Some(centre)
            }
            _ => None,
        });
        dots.collect::<Vec<_>>()
    };
    let mut hand = Hand::with("coin-toss", &[("twist", 60.0), ("toss", 0.0)]);
    assert_eq!(results(&mut hand), []);
    let (time, heads) = (0.48, hand.reading(0.48, HEADS));
    hand.draw(time, Room::Wide); // until all have been made
    let mut other = hand.changed(&[("twist", 19.0), ("toss", -1.0)]);
    let [result] = results(&mut other)[..] else { panic!("one result") };
    // 0.5 at the foot, 104 px below one; θ_L to the right, 90° on 170 px.
    let angle = (240_f64 / 120.0).atan().to_degrees();
    let [x, p] = [(result.x - 444.0) / 170.0 * 90.0, 1.0 - (result.y - 364.0) / 208.0];
    assert!((x - angle).abs() < 0.1 && (p - heads).abs() < 1e-3, "{x}° and {p}, not {angle}° and {heads}");
    // A machine knows no chance: there is nothing to remember.
    let mut machine = Hand::with("coin-toss", &[("toss", 0.0), ("hand", 2.0)]);
    machine.draw(0.1, Room::Wide);
    machine.draw(time, Room::Wide);
    assert_eq!(results(&mut machine.changed(&[("twist", 19.0)])), []);
}

#[test]
fn a_toss_at_the_moment_of_a_frame_is_made_however_its_time_is_rounded() {
    let pressed = 0.147;
    let hand = Hand::with("coin-toss", &[("toss", pressed)]);
    // The reader sees a precession in 1.6 s, and 950 tosses in each second: 19 in 20 ms.
    let pace = 2.0 * PI / 240_f64.hypot(2.0 * 60.0) / 1.6;
    for frame in 0..250 {
        let time = pressed + f64::from(frame) * 0.02 * pace;
        let made = [time - 1e-12 * pace, time, time + 1e-12 * pace].map(|time| hand.reading(time, TOSSES));
        assert_eq!(made, [250.0 + 19.0 * f64::from(frame); 3], "frame {frame}");
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

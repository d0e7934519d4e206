//! The scene of the chapter "The struck space station": its counters by a simulation, and the second blow.

use crate::hand::Hand;
use drawing::{Hue, Role, Room, Shape, at};
use mechanics::euler::{self, Turning};
use mechanics::inertia::Body;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

const SPIN: f64 = 0.45;
const NODS: &str = "nods";
const MARK: &str = "turns of the mark";
const ON_BOARD: &str = r"turns of $";

fn played(settings: &[(&str, f64)]) -> Hand {
    Hand::with("space-station", settings)
}

/// Turns that a direction makes about an axis, from one of some moments to the next; they lie close.
fn turns(directions: &[Vector3<f64>], axis: &Vector3<f64>) -> f64 {
    let across = |direction: &Vector3<f64>| direction - axis * direction.dot(axis);
    let step = |pair: &[Vector3<f64>]| {
        let [from, to] = [across(&pair[0]), across(&pair[1])];
        from.cross(&to).dot(axis).atan2(from.dot(&to))
    };
    directions.windows(2).map(step).sum::<f64>() / TAU
}

#[test]
fn a_simulation_counts_the_same() {
    let mut random = fastrand::Rng::with_seed(48);
    let moments = Body::hoop(4e5, 50.0).expect("a ring").moments();
    for _ in 0..8 {
        let (impulse, place) = (0.1 * f64::from(random.u32(4..=60)), f64::from(random.u32(20..=50)));
        let hand = played(&[("impulse", impulse), ("place", place)]);
        let omega = Vector3::new(place * impulse * 1e6 / moments.to_array()[0], 0.0, SPIN);
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body: omega };
        let time = 5.0 + 45.0 * random.f64();
        let times: Vec<f64> = (0..=600).map(|step| time * f64::from(step) / 600.0).collect();
        let rates = euler::turning_rates(moments, |_, _| Vector3::zeros());
        let sampled = Dop853::new(1e-11).expect("a solver").sample(rates, 0.0, start.to_array(), &times);
        let states = sampled.expect("a simulation").0;
        let states: Vec<Turning> = states.into_iter().map(Turning::from_array).collect();
        let momentum = start.angular_momentum_world(&moments).normalize();
        let seen = |what: fn(&Turning) -> Vector3<f64>| states.iter().map(what).collect::<Vec<_>>();
        for (words, expected, slack) in [
            (NODS, turns(&seen(Turning::axis_3_world), &momentum), 0.006),
            (ON_BOARD, turns(&seen(|state| state.omega_body), &Vector3::z()), 0.006),
            // A mark goes round unevenly; over so long a time it has made as many turns to within a part of one.
            (MARK, turns(&seen(|state| state.world_from_body * Vector3::y()), &momentum), 0.2),
        ] {
            assert!((hand.reading(time, words) - expected).abs() < slack, "{words}: {expected}");
        }
    }
}

#[test]
fn blows_nod_it_stop_it_or_do_nothing() {
    let turn = TAU / SPIN;
    let near = |hand: &Hand, time: f64, words: &str, expected: f64| {
        let found = hand.reading(time, words);
        assert!((found - expected).abs() < 0.005, "{words} after {time} s: {found}, not {expected}");
    };
    // Two waves in the room make one on board.
    for (words, expected) in [(NODS, 8.16), (ON_BOARD, 4.0), (MARK, 4.16)] {
        near(&played(&[]), 4.0 * turn, words, expected);
    }
    for settings in [("impulse", 0.0), ("place", 0.0)] {
        near(&played(&[settings]), 30.0, NODS, 0.0);
        near(&played(&[settings]), 4.0 * turn, MARK, 4.0);
    }
    // After one nod a second blow leaves nothing.
    let later = Hand::preset("space-station", "after one nod");
    near(&later, 20.0, "drift", 0.0);
    near(&later, 50.0, NODS, later.reading(20.0, NODS));
}

#[test]
fn a_blow_that_is_taken_back_at_once_leaves_what_was() {
    let both =
        played(&[("fire", 9.0), ("thruster", 120.0), ("thrust", -1.5)]).pressed("fire", &[[9.0, 120.0, 1.5]]);
    let once = played(&[("fire", 9.0), ("thruster", 120.0), ("thrust", -1.5)]);
    for words in [NODS, ON_BOARD, MARK, "drift"] {
        let [never, twice] = [&played(&[]), &both].map(|hand| hand.reading(30.0, words));
        assert!((never - twice).abs() < 1e-9, "{words}: {never} and {twice}");
    }
    assert!(
        (once.reading(30.0, "drift") - played(&[]).reading(30.0, "drift")).abs() > 0.1,
        "one alone pushes"
    );
}

#[test]
fn an_axis_of_rotation_beyond_the_sky_is_pointed_to() {
    for room in [Room::Wide, Room::Narrow] {
        for impulse in [1.8, 4.0, 5.4, 9.0, 10.0] {
            let drawing = played(&[("impulse", impulse)]).draw(5.0, room);
            let (sky, radius) = room.of((at(508.0, 126.0), 98.0), (at(86.0, 462.0), 80.0));
            let orange = drawing.items().iter().filter(|item| item.role == Role::Text(Hue::Orange));
            let names = orange.filter(|item| match &item.shape {
                Shape::Label(label) => (label.bounds.centre() - sky).length() < radius,
                _ => false,
            });
            assert_eq!(names.count(), 1, "{impulse} MN·s, {room:?}");
        }
    }
}

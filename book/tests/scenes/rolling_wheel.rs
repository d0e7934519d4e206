//! The scene of the rolling wheel: against the general rates followed from its start, and against limits.

use crate::hand::{Hand, number_behind};
use drawing::{Hue, Role, Room, Shape, Stroke, at};
use fastrand::Rng;
use mechanics::integrate::Dop853;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use std::f64::consts::{FRAC_PI_2, TAU};

const A: f64 = 0.3;
const G: f64 = 9.81;

fn set(settings: &[(&str, f64)]) -> Hand {
    Hand::with("rolling-wheel", settings)
}

fn wheel(which: f64, reach: f64) -> Wheel {
    // The third is a hoop and, with as much mass, two points on its axle.
    let weighted = MomentFactors { transverse: 0.5 * (0.5 + reach * reach), axial: 0.5 };
    let moments = [MomentFactors::DISK, MomentFactors::HOOP, weighted][which as usize];
    Wheel::new(DiskParameters { mass: 2.0, radius: A, moments, gravity: G }).expect("a wheel")
}

/// The state at a time, followed by the rates from the steady motion, with a kick on the way.
fn judge(wheel: &Wheel, [circle, lean, push, kick, loss]: [f64; 5], time: f64) -> Rolling {
    // The balance of torques gives the rate of the circle, eq:steady-moments.
    let MomentFactors { transverse, axial } = wheel.parameters().moments;
    let rate = (G / A * lean.tan() / ((1.0 + axial) * circle + transverse * lean.sin())).sqrt();
    let start = Rolling {
        tilt: FRAC_PI_2 - lean,
        omega_2: rate * lean.cos(),
        omega_3: rate * circle,
        ..Rolling::UPRIGHT
    };
    let rates = wheel.slowed_rates(loss);
    let solver = Dop853::new(1e-13).expect("a tolerance");
    let before = kick.min(time);
    let mut state = solver.solve(rates, 0.0, start.to_array(), before).expect("it rolls").state;
    if time >= kick {
        state[1] += push;
    }
    Rolling::from_array(solver.solve(rates, before, state, time).expect("it rolls").state)
}

#[test]
fn the_readings_are_those_of_a_motion_followed_step_by_step() {
    let mut random = Rng::with_seed(8);
    for trial in 0..60 {
        let between = |random: &mut Rng, from: f64, to: f64| from + (to - from) * random.f64();
        let lean = (10.0 * between(&mut random, 22.0, 45.0)).round() / 10.0;
        let circle = (100.0 * between(&mut random, 0.5, 2.5)).round() / 100.0;
        let push = (20.0 * between(&mut random, -0.6, 0.6)).round() / 20.0;
        let kick = if trial % 2 == 0 { 0.0 } else { 0.5 };
        let loss = if trial % 3 == 0 { 0.05 } else { 0.0 };
        let which = f64::from(random.u8(0..3));
        let reach = (100.0 * between(&mut random, 0.3, 0.9)).round() / 100.0;
        let settings = [
            ("circle", circle),
            ("lean", lean),
            ("wheel", which),
            ("reach", reach),
            ("push", push),
            ("kick", kick),
            ("loss", loss),
        ];
        let (hand, wheel) = (set(&settings), wheel(which, reach));
        for time in [0.0, 0.3, 0.777, 2.1] {
            let state = judge(&wheel, [circle, lean.to_radians(), push, kick, loss], time);
            let near = |words: &str, expected: f64, slack: f64| {
                let found = hand.reading(time, words);
                assert!((found - expected).abs() < slack, "{settings:?}, {time} s, {words}: {found}");
            };
            near("lean", state.lean().to_degrees(), 0.06);
            near("times round", state.heading / TAU, 0.006);
            if loss == 0.0 {
                let (force, normal) = (wheel.contact_force(&state), wheel.normal_force(&state));
                let friction = (force.norm_squared() - normal.powi(2)).max(0.0).sqrt() / normal;
                near("friction", friction, 0.006);
                near("change of the energy", 0.0, 1e-12);
                near("change of Chaplygin", 0.0, 1e-9);
            } else {
                assert!(hand.reading(time, "change of Chaplygin").is_nan(), "nothing keeps A and B");
                let lost = hand.reading(time, "change of the energy") < -1e-3;
                assert!(lost || time <= kick + 0.2, "{settings:?}: it loses energy");
            }
        }
    }
}

#[test]
fn a_second_kick_acts_on_the_motion_as_it_is_and_a_changed_circle_turns_nothing() {
    let lean = 28_f64.to_radians();
    for loss in [0.0, 0.05] {
        let settings = [("push", -0.4), ("kick", 1.5), ("loss", loss)];
        let (hand, wheel) = (set(&settings).pressed("kick", &[[0.5, 0.8, 0.0]]), wheel(0.0, 1.0));
        for end in [1.2_f64, 2.4] {
            let mut state = judge(&wheel, [1.0, lean, 0.8, 0.5, loss], end.min(1.5));
            if end > 1.5 {
                state.omega_1 -= 0.4;
                let solver = Dop853::new(1e-13).expect("a tolerance");
                let rates = wheel.slowed_rates(loss);
                let end = solver.solve(rates, 1.5, state.to_array(), end).expect("it rolls");
                state = Rolling::from_array(end.state);
            }
            let off = hand.reading(end, "lean") - state.lean().to_degrees();
            assert!(off.abs() < 0.06, "after {end} s, with a loss of {loss}: {off}°");
        }
    }
    // The heading and the roll are what they were: at once, and together with what the new circle adds.
    let before = set(&[("kick", -1.0)]);
    let rounds = |hand: &Hand| hand.value("heading") / TAU + hand.reading(3.0, "times round");
    for (name, value) in [("lean", 31.0), ("circle", 1.4)] {
        let gap = rounds(&before) - rounds(&before.moved(name, value, 3.0));
        assert!((gap - gap.round()).abs() < 1e-4, "{name}: {gap} rounds");
    }
}

#[test]
fn a_nudge_grows_at_the_rate_that_is_told() {
    let told = number_behind(&set(&[("lean", 10.0), ("circle", 0.8)]).words(), "at the rate ");
    let growth = |time: f64| {
        let nudged = judge(&wheel(0.0, 1.0), [0.8, 10_f64.to_radians(), 1e-8, 0.0, 0.0], time);
        nudged.lean() - 10_f64.to_radians()
    };
    let rate = (growth(1.6) / growth(1.1)).ln() / 0.5;
    assert!((told - rate).abs() < 0.02, "{told}, {rate}");
}

#[test]
fn a_wheel_that_is_slowed_goes_to_smaller_circles_and_ends_flat() {
    let hand = set(&[("lean", 9.0), ("circle", 4.0), ("push", 0.0), ("loss", 0.1)]);
    let end = hand.duration();
    assert!(end > 5.0 && end < 20.0);
    let lean = |part: f64| hand.reading(part * end, "lean");
    assert!(lean(0.25) > 10.0 && lean(0.5) > lean(0.25) + 5.0 && lean(0.75) > lean(0.5) + 5.0);
    assert!(lean(1.0) > 85.0, "{}", lean(1.0));
}

#[test]
fn a_hand_takes_the_level_of_the_energy() {
    for room in [Room::Wide, Room::Narrow] {
        // The well is drawn anew on a scale of its own: its energy follows.
        for (step, is_harder) in [(-14.0, true), (11.0, false)] {
            let mut hand = set(&[]);
            hand.draw(1.0, room);
            hand.draw_grip(1, hand.grips()[1] + at(0.0, step));
            assert_eq!(hand.value("push") > 1.0, is_harder, "{} for {step}", hand.value("push"));
        }
    }
}

#[test]
fn the_way_on_the_map_never_crosses_it_at_once() {
    // A strong kick makes the wheel run straight on for instants: b/a leaves on one side and comes back on the other.
    let (mut crossings, mut pieces) = (0, 0);
    for push in [1.0, 2.0, 3.0] {
        let wheel = wheel(0.0, 1.0);
        let start = [1.0, 28_f64.to_radians(), push, 0.0, 0.0];
        let sign = |k: u32| judge(&wheel, start, 0.02 * f64::from(k)).omega_2.signum();
        let signs: Vec<f64> = (0..=300).map(sign).collect();
        crossings += signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
        let drawing = set(&[("push", push)]).draw(6.0, Room::Wide);
        let map = drawing.axes()[0].frame;
        for item in drawing.items().iter().filter(|item| item.role == Role::Line(Stroke::Orbit, Hue::Blue)) {
            let Shape::Polyline(points) = &item.shape else { panic!("{:?}", item.shape) };
            pieces += 1;
            for pair in points.windows(2) {
                let across = (pair[1].x - pair[0].x).abs();
                assert!(across < 0.95 * map.width(), "push {push}: {pair:?}");
            }
        }
    }
    assert!(crossings > 3 && pieces > 3, "{crossings} crossings, {pieces} pieces");
}

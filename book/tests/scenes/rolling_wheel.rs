//! The scene of the rolling wheel: against the general rates followed from its start, and against limits.

use approx::assert_relative_eq;
use drawing::{Hue, Role, Room, Shape, Stroke, at};
use fastrand::Rng;
use live::{Moment, Player, Scene};
use mechanics::integrate::Dop853;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use std::f64::consts::{FRAC_PI_2, TAU};

const A: f64 = 0.3;
const G: f64 = 9.81;

fn scene() -> &'static Scene {
    let found = pages::scenes::named("rolling-wheel");
    found.expect("a scene of the rolling wheel")
}

fn set(settings: &[(&str, f64)]) -> Player {
    Player::new(scene()).expect("it begins").changed(settings).expect("a motion")
}

/// The number that is written in a reading.
fn reading(player: &Player, which: usize, time: f64) -> f64 {
    let text = player.readings(time).expect("readings").swap_remove(which);
    let number = text
        .split('\u{a0}')
        .next()
        .expect("a number")
        .replace('−', "-")
        .replace("·10<sup>", "e")
        .replace("10<sup>", "1e");
    number.replace("</sup>", "").replace('°', "").parse().unwrap_or(f64::NAN)
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
        let player = set(&[
            ("circle", circle),
            ("lean", lean),
            ("wheel", which),
            ("reach", reach),
            ("push", push),
            ("kick", kick),
            ("loss", loss),
        ]);
        let of = format!("{circle} {lean}° {which} {push} at {kick} s, {loss}");
        for time in [0.0, 0.3, 0.777, 2.1] {
            let wheel = wheel(which, reach);
            let state = judge(&wheel, [circle, lean.to_radians(), push, kick, loss], time);
            let found = reading(&player, 0, time);
            assert!((found - state.lean().to_degrees()).abs() < 0.06, "{of}, {time} s: {found}");
            assert!((reading(&player, 1, time) - state.heading / TAU).abs() < 0.006, "{of}, {time} s");
            if loss == 0.0 {
                let force = wheel.contact_force(&state);
                let friction = (force.norm_squared() - wheel.normal_force(&state).powi(2)).max(0.0).sqrt();
                let friction = friction / wheel.normal_force(&state);
                assert!((reading(&player, 3, time) - friction).abs() < 0.006, "{of}, {time} s");
                assert!(reading(&player, 4, time).abs() < 1e-12, "{of}, {time} s");
                assert!(reading(&player, 5, time).abs() < 1e-9, "{of}, {time} s");
            } else {
                assert!(reading(&player, 5, time).is_nan(), "{of}: nothing keeps A and B");
                if time > kick + 0.2 {
                    assert!(reading(&player, 4, time) < -1e-3, "{of}: it loses energy");
                }
            }
        }
    }
}

#[test]
fn words_tell_the_fate_of_a_kick_and_of_what_is_no_circle() {
    let words = |settings: &[(&str, f64)]| set(settings).words(0.0);
    // The tongue of a disc has its tip at 18.62°.
    assert!(words(&[("lean", 18.0), ("circle", 0.6)]).contains("unstable"));
    for circle in [0.1, 0.6, 1.5, 4.0] {
        assert!(!words(&[("lean", 19.0), ("circle", circle)]).contains("unstable"), "{circle}");
        assert!(words(&[("lean", 1.0), ("circle", circle)]).contains("unstable"), "{circle}");
    }
    let strong = words(&[("lean", 20.0), ("circle", 0.6), ("push", 1.0)]);
    assert!(strong.contains("too strong"), "{strong}");
    let weak = words(&[("lean", 30.0), ("circle", 1.6), ("push", 0.1)]);
    assert!(!weak.contains("too strong"), "{weak}");
    // Upright; beyond what a circle can be, eq:existence; slowed; left alone.
    assert!(words(&[("lean", 0.0)]).contains("no circle"));
    let beyond = words(&[("lean", 60.0), ("circle", -0.2)]);
    assert!(beyond.contains("No rate of turning") && beyond.contains("0.144"), "{beyond}");
    let slowed = words(&[("lean", 30.0), ("push", 0.0), ("loss", 0.1)]);
    assert!(
        slowed.contains("smaller circle") && slowed.contains("With no loss it would be stable"),
        "{slowed}"
    );
    assert!(!slowed.contains("stay small"), "{slowed}");
    assert!(words(&[("push", 0.0)]).contains("for ever"));
    // Weights on the axle lift the tip: to 25.8° for I₁ = 2. And the rate at which a nudge grows there is that of the
    // general motion.
    let weighted =
        |lean: f64| words(&[("wheel", 2.0), ("reach", 3.5_f64.sqrt()), ("lean", lean), ("circle", 1.5)]);
    assert!(weighted(24.0).contains("unstable") && !weighted(27.0).contains("unstable"));
    let told = words(&[("lean", 10.0), ("circle", 0.8)]);
    let told = told.split("at the rate ").nth(1).expect("a rate").split('/').next().expect("a number");
    let growth = |time: f64| {
        let nudged = judge(&wheel(0.0, 1.0), [0.8, 10_f64.to_radians(), 1e-8, 0.0, 0.0], time);
        nudged.lean() - 10_f64.to_radians()
    };
    let rate = (growth(1.6) / growth(1.1)).ln() / 0.5;
    assert!((told.parse::<f64>().expect("a number") - rate).abs() < 0.02, "{told}, {rate}");
}

#[test]
fn a_wheel_that_is_slowed_goes_to_smaller_circles_and_ends_flat() {
    let player = set(&[("lean", 9.0), ("circle", 4.0), ("push", 0.0), ("loss", 0.1)]);
    let end = player.run().duration;
    assert!(end > 5.0 && end < 20.0);
    let lean = |part: f64| reading(&player, 0, part * end);
    assert!(lean(0.25) > 10.0 && lean(0.5) > lean(0.25) + 5.0 && lean(0.75) > lean(0.5) + 5.0);
    assert!(lean(1.0) > 85.0, "{}", lean(1.0));
}

#[test]
fn hands_take_the_point_of_the_map_and_the_level_of_the_energy() {
    let mut player = set(&[]);
    for room in [Room::Wide, Room::Narrow] {
        player.draw(Moment { time: 1.0, azimuth: -1.1, elevation: 0.6, room }).expect("a picture");
        let values = player.values().to_vec();
        for (grip, place) in player.grips().into_iter().enumerate() {
            let same = player.drag(grip, place).expect("a drag");
            for (before, after) in values.iter().zip(&same) {
                assert_relative_eq!(before, after, epsilon = 1e-9);
            }
            for step in [at(-9.0, -14.0), at(6.0, 11.0)] {
                let to = place + step;
                let drawn = player.drag(grip, to).expect("a drag");
                let settings: Vec<(&str, f64)> =
                    scene().controls.iter().map(|control| control.name).zip(drawn).collect();
                let mut moved = player.changed(&settings).expect("a motion");
                moved.draw(Moment { time: 1.0, azimuth: -1.1, elevation: 0.6, room }).expect("a picture");
                let found = moved.grips()[grip];
                if grip == 0 {
                    assert!((found - to).length() < 1.0, "{found:?} for {to:?}");
                } else {
                    // The well is drawn anew on a scale of its own: its energy follows.
                    let push = reading_of(&settings, "push");
                    assert!((push > 1.0) == (step.y < 0.0), "{push} for {step:?}");
                }
            }
        }
    }
}

fn reading_of(settings: &[(&str, f64)], name: &str) -> f64 {
    settings.iter().find(|(own, _)| *own == name).expect("a setting").1
}

#[test]
fn the_way_on_the_map_never_crosses_it_at_once() {
    // A strong kick makes the wheel run straight on for instants: b/a leaves on one side and comes back on the other.
    let (mut crossings, mut pieces) = (0, 0);
    for push in [1.0, 2.0, 3.0] {
        let mut player = set(&[("push", push)]);
        let wheel = wheel(0.0, 1.0);
        let start = [1.0, 28_f64.to_radians(), push, 0.0, 0.0];
        let sign = |k: u32| judge(&wheel, start, 0.02 * f64::from(k)).omega_2.signum();
        let signs: Vec<f64> = (0..=300).map(sign).collect();
        crossings += signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
        let drawing =
            player.draw(Moment { time: 6.0, azimuth: -1.3, elevation: 0.6, room: Room::Wide }).unwrap();
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

#[test]
fn a_weight_that_goes_below_the_table_is_owned_to() {
    let words = |settings: &[(&str, f64)]| set(settings).words(0.0);
    // A weight 1.87 radii out is below the table beyond a lean of arctan(1/1.87).
    let falls = [("wheel", 2.0), ("reach", 1.87), ("lean", 22.0), ("circle", 4.0), ("push", 0.1)];
    assert!(words(&falls).contains("more than 28.1°, its lower weight is in a slot"), "{}", words(&falls));
    assert!(!words(&[("wheel", 2.0), ("reach", 0.5), ("push", 0.0)]).contains("slot"));
    assert!(!words(&[("wheel", 1.0), ("reach", 1.87), ("lean", 60.0)]).contains("slot"));
}

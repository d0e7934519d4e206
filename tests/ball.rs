//! The ball on a cloth, on a turning table and in a hole, against Newton's and Euler's laws for the whole ball in the
//! room: one point touches, and its force is what sliding friction gives, or what keeps it from slipping.

use crate::common::any;
use approx::assert_relative_eq;
use mechanics::InvalidQuantity;
use mechanics::integrate::Dop853;
use mechanics::scenes::ball::{
    Ball, BallParameters, BallState, Circle, Cloth, ClothParameters, Cue, Hole, HoleParameters, HoleStart,
    Shot, ShotStart, Turntable, TurntableParameters, TurntableStart,
};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::{PI, TAU};

const GRAVITY: f64 = 9.81;
/// What stepping at 1e-13 leaves over some hundreds of steps.
const STEPPED: f64 = 2e-11;
/// What a few operations leave.
const ROUNDING: f64 = 2e-15;
/// Solid, hollow, and one that has most of its mass near the centre.
const FACTORS: [f64; 3] = [Ball::SOLID, Ball::SHELL, 0.1];

fn ball(moment_factor: f64) -> Ball {
    Ball::new(BallParameters { radius: 0.03, moment_factor }).expect("a ball")
}

fn to_array(state: &BallState) -> [f64; 9] {
    let BallState { centre, velocity, omega } = state;
    [centre, velocity, omega].map(|v| <[f64; 3]>::from(*v)).concat().try_into().expect("nine")
}

fn from_array(state: &[f64; 9]) -> BallState {
    let [centre, velocity, omega] = [0, 3, 6].map(|n| Vector3::from_row_slice(&state[n..n + 3]));
    BallState { centre, velocity, omega }
}

/// How far two states differ, with spins as the velocities of the ball's surface.
fn difference(ball: &Ball, one: &BallState, other: &BallState) -> f64 {
    let spin = (one.omega - other.omega).norm() * ball.radius();
    (one.centre - other.centre).norm().max((one.velocity - other.velocity).norm()).max(spin)
}

/// What the ball touches, as seen from its centre.
enum Wall {
    /// A plane with the normal z that turns at a rate.
    Plane(f64),
    /// An upright cylinder at rest.
    Cylinder,
}

/// The rates of a ball of mass one that does not slip: its contact is accelerated as the wall is, and the force at the
/// contact is whatever brings that about, found by elimination.
fn rolling(ball: Ball, wall: Wall, gravity: Vector3<f64>) -> impl FnMut(f64, &[f64; 9]) -> [f64; 9] {
    move |_, state| {
        let BallState { centre, velocity, omega } = from_array(state);
        let a = ball.radius();
        let level = |v: Vector3<f64>| Vector3::new(v.x, v.y, 0.0);
        // From the centre to the contact, how that turns, and how the wall's velocity changes along the ball's path.
        let (lever, lever_rate, wall_rate) = match wall {
            Wall::Plane(rate) => (-Vector3::z() * a, Vector3::zeros(), Vector3::z().cross(&velocity) * rate),
            Wall::Cylinder => {
                let [place, speed] = [level(centre), level(velocity)];
                let outward = place.normalize();
                let turning = (speed - outward * outward.dot(&speed)) / place.norm();
                (outward * a, turning * a, Vector3::zeros())
            }
        };
        let moment = ball.moment_factor() * a * a;
        let answer = |force: Vector3<f64>| (force + gravity, lever.cross(&force) / moment);
        let contact = |force: Vector3<f64>| {
            let (linear, angular) = answer(force);
            linear + angular.cross(&lever) + omega.cross(&lever_rate) - wall_rate
        };
        let none = contact(Vector3::zeros());
        let columns = [Vector3::x(), Vector3::y(), Vector3::z()].map(|direction| contact(direction) - none);
        let force = Matrix3::from_columns(&columns).lu().solve(&-none).expect("a force");
        let (linear, angular) = answer(force);
        to_array(&BallState { centre: velocity, velocity: linear, omega: angular })
    }
}

/// The rates of a ball of mass one that slides on a plane at rest.
fn sliding(ball: Ball, friction: f64) -> impl FnMut(f64, &[f64; 9]) -> [f64; 9] {
    move |_, state| {
        let BallState { velocity, omega, .. } = from_array(state);
        let lever = -Vector3::z() * ball.radius();
        let slip = velocity + omega.cross(&lever);
        let force = -slip.normalize() * (friction * GRAVITY);
        let moment = ball.moment_factor() * ball.radius() * ball.radius();
        let omega = lever.cross(&force) / moment;
        to_array(&BallState { centre: velocity, velocity: force, omega })
    }
}

fn cloth(moment_factor: f64, friction: f64) -> Cloth {
    Cloth::new(ClothParameters { ball: ball(moment_factor), friction, gravity: GRAVITY }).expect("a cloth")
}

/// A ball that is hit hard, with spin of all kinds.
fn masse(moment_factor: f64) -> Shot {
    cloth(moment_factor, 0.2)
        .shot(ShotStart { velocity: [2.0, 0.3], omega: [90.0, -40.0, 25.0] })
        .expect("a shot")
}

#[test]
fn ball_slide_is_that_of_newton_and_euler_and_ends_when_they_say() {
    for factor in FACTORS {
        let shot = masse(factor);
        let time = shot.sliding_time();
        let start = to_array(&shot.at(0.0).unwrap());
        // It begins as it was hit.
        let hit = [0.0, 0.0, 0.0, 2.0, 0.3, 0.0, 90.0, -40.0, 25.0];
        assert!(start.iter().zip(hit).all(|(found, given)| (found - given).abs() < 5e-14), "{start:?}");
        let solver = Dop853::new(1e-13).unwrap();
        for part in [0.1, 0.5, 0.9, 0.999] {
            let end = solver.solve(any(sliding(ball(factor), 0.2)), 0.0, start, part * time).unwrap();
            let (end, found) = (from_array(&end.state), shot.at(part * time).unwrap());
            assert!(difference(&ball(factor), &end, &found) < STEPPED, "{factor} {part}: {end:?} {found:?}");
            // The slip that is left, along its first direction.
            let slip = ball(factor).point_velocity(&end, &-Vector3::z());
            assert_relative_eq!(slip, shot.slip(part * time).unwrap(), epsilon = STEPPED);
            assert_relative_eq!(slip, shot.first_slip() * (1.0 - part), epsilon = STEPPED);
        }
        // From there on it rolls, and Newton and Euler find no force.
        let rolls = shot.at(1.5 * time).unwrap();
        assert!(ball(factor).point_velocity(&rolls, &-Vector3::z()).norm() < ROUNDING);
        let rates = rolling(ball(factor), Wall::Plane(0.0), Vector3::z() * -GRAVITY)(0.0, &to_array(&rolls));
        assert!(rates[3..].iter().all(|rate| rate.abs() < 1e-10), "{rates:?}");
        assert_relative_eq!(rolls.velocity, shot.rolling_velocity());
        let walked = shot.end_of_sliding() + shot.rolling_velocity() * (0.5 * time);
        assert_relative_eq!(rolls.centre, walked, epsilon = 1e-14);
    }
}

#[test]
fn ball_final_keeps_what_friction_cannot_change() {
    // The angular momentum about the line along which the contact runs, whatever the friction.
    for factor in FACTORS {
        let kept = |state: &BallState| {
            let upright = Vector3::z() * ball(factor).radius();
            let own = state.omega * (factor * ball(factor).radius().powi(2));
            upright.cross(&state.velocity) + own
        };
        let shot = masse(factor);
        let times = [0.0, 0.3, 0.8, 1.0, 4.0].map(|part| part * shot.sliding_time());
        let states = shot.sample(&times).unwrap();
        for state in &states {
            assert_relative_eq!(kept(state), kept(&states[0]), max_relative = 4e-15);
        }
    }
}

#[test]
fn ball_final_of_reference_values() {
    let solid = cloth(Ball::SOLID, 0.2);
    let straight = solid.shot(ShotStart { velocity: [3.0, 0.0], omega: [0.0; 3] }).unwrap();
    assert_relative_eq!(straight.rolling_velocity().x, 15.0 / 7.0, max_relative = ROUNDING);
    assert_relative_eq!(straight.sliding_time(), 6.0 / (7.0 * 0.2 * GRAVITY), max_relative = ROUNDING);
    assert_relative_eq!(straight.energy_lost(), 9.0 / 7.0, max_relative = ROUNDING);
    for factor in FACTORS {
        let shot = cloth(factor, 0.3).shot(ShotStart { velocity: [0.0, -2.0], omega: [0.0; 3] }).unwrap();
        assert_relative_eq!(shot.rolling_velocity().y, -2.0 / (1.0 + factor), max_relative = ROUNDING);
    }
}

#[test]
fn ball_heat_is_what_the_energy_lacks() {
    for factor in FACTORS {
        let shot = masse(factor);
        let energy = |time| ball(factor).kinetic_energy(&shot.at(time).unwrap());
        let lost = energy(0.0) - energy(2.0 * shot.sliding_time());
        assert_relative_eq!(shot.energy_lost(), lost, max_relative = 1e-13);
    }
}

#[test]
fn ball_cue_rolls_at_once_from_two_fifths_above_the_centre() {
    for factor in FACTORS {
        let cloth = cloth(factor, 0.2);
        let height = ball(factor).rolling_height();
        // The blow gives momentum P and the angular momentum (h − a)P about the centre.
        let (speed, push) = (1.7, 1.7);
        let spin = (height - 0.03) * push / (factor * 0.03 * 0.03);
        assert_relative_eq!(spin * 0.03, speed, max_relative = ROUNDING);
        let shot = cloth.struck(Cue { speed, height }).unwrap();
        assert!(shot.first_slip().norm() < ROUNDING && shot.sliding_time() < ROUNDING);
        // A little higher the contact slips back, and the ball gains speed; a little lower it loses some.
        let [high, low] = [1.1, 0.9].map(|part| cloth.struck(Cue { speed, height: part * height }).unwrap());
        assert!(high.rolling_velocity().x > speed && low.rolling_velocity().x < speed);
        // In the middle there is no spin.
        let middle = cloth.struck(Cue { speed, height: 0.03 }).unwrap();
        assert_relative_eq!(middle.first_slip().x, speed);
    }
}

#[test]
fn a_ball_that_nearly_rolls_has_all_digits_of_its_slip() {
    let cloth = cloth(Ball::SOLID, 0.2);
    // The slip as a whole number of 2^-59 m/s: 0.03 and the velocities are whole numbers of 2^-58, the spins halves.
    let whole = |value: f64| (value * 2.0_f64.powi(58)) as i128;
    for (spin, units) in [(40.0, 0), (40.0, 3), (40.0, -1), (12.5, 17)] {
        let velocity = f64::from_bits((f64::to_bits(0.03 * spin) as i64 + units) as u64);
        let exact = 2 * whole(velocity) - whole(0.03) * (spin * 2.0) as i128;
        let shot = cloth.shot(ShotStart { velocity: [velocity, 0.0], omega: [0.0, spin, 0.0] }).unwrap();
        let slip = exact as f64 * 2.0_f64.powi(-59);
        assert_relative_eq!(shot.first_slip().x, slip, max_relative = ROUNDING);
        assert_relative_eq!(
            shot.sliding_time(),
            2.0 / 7.0 * slip.abs() / (0.2 * GRAVITY),
            max_relative = ROUNDING
        );
    }
}

#[test]
fn sliding_ends_at_one_time_and_not_before() {
    for shot in [masse(Ball::SOLID), masse(Ball::SHELL)] {
        let end = shot.sliding_time();
        let before = shot.slip(end.next_down()).unwrap();
        let expected = shot.first_slip() * ((end - end.next_down()) / end);
        // The end lies within half a unit of its f64.
        assert!(before.norm() > 0.4 * expected.norm() && before.norm() < 1.6 * expected.norm());
        assert_eq!(shot.slip(end.next_up()).unwrap(), Vector3::zeros());
        let [one, other] = [end.next_down(), end.next_up()].map(|time| shot.at(time).unwrap());
        assert!(difference(&ball(Ball::SOLID), &one, &other) < 1e-14);
    }
    // A ball that rolls from the start never slides.
    let start = ShotStart { velocity: [0.03 * 32.0, 0.0], omega: [0.0, 32.0, 3.0] };
    let rolls = cloth(Ball::SOLID, 0.2).shot(start).unwrap();
    assert!(rolls.sliding_time() < 1e-15);
}

fn table(moment_factor: f64, rate: f64, slope: f64) -> Turntable {
    let ball = ball(moment_factor);
    Turntable::new(TurntableParameters { ball, rate, slope, gravity: GRAVITY }).expect("a table")
}

const TABLE_START: TurntableStart = TurntableStart { place: [0.2, -0.1], velocity: [0.3, 0.5], pivot: 4.0 };

#[test]
fn ball_table_motion_is_that_of_newton_and_euler() {
    for factor in FACTORS {
        for (rate, slope) in [(6.0, 0.0), (-4.0, 0.1), (0.01, -0.2), (0.0, 0.05)] {
            let roll = table(factor, rate, slope).roll(TABLE_START).unwrap();
            let gravity = Vector3::new(slope.sin(), 0.0, -slope.cos()) * GRAVITY;
            let rates = rolling(ball(factor), Wall::Plane(rate), gravity);
            let start = to_array(&roll.at(0.0).unwrap());
            let end = Dop853::new(1e-13).unwrap().solve(any(rates), 0.0, start, 3.0).unwrap();
            let (end, found) = (from_array(&end.state), roll.at(3.0).unwrap());
            let size = end.centre.norm().max(1.0);
            assert!(
                difference(&ball(factor), &end, &found) < STEPPED * size,
                "{factor} {rate} {slope}: {end:?} {found:?}"
            );
            // Nothing slips.
            let touch = ball(factor).point_velocity(&found, &-Vector3::z());
            assert_relative_eq!(touch, Vector3::z().cross(&found.centre) * rate, epsilon = 1e-13 * size);
        }
    }
}

#[test]
fn ball_table_rate_is_two_sevenths_of_the_table_and_the_circle_stays() {
    let roll = table(Ball::SOLID, 7.0, 0.0).roll(TABLE_START).unwrap();
    assert_relative_eq!(roll.period().unwrap(), PI, max_relative = ROUNDING);
    let Circle { centre, radius, drift } = roll.circle().unwrap();
    assert_relative_eq!(radius, 0.34_f64.sqrt() / 2.0, max_relative = ROUNDING); // 7v/2Ω
    assert_eq!(drift.norm(), 0.0);
    for n in 0..40 {
        let place = roll.at(0.37 * f64::from(n)).unwrap().centre;
        assert_relative_eq!((place - centre).norm(), radius, max_relative = 1e-14);
    }
    assert_relative_eq!(table(Ball::SHELL, 7.0, 0.0).circle_rate(), 2.8, max_relative = ROUNDING);
    assert!(table(1e-9, 7.0, 0.0).circle_rate() < 1e-8); // no moment, no circle
}

#[test]
fn ball_drift_is_across_the_slope() {
    for factor in FACTORS {
        let (rate, slope) = (5.0, 0.02_f64);
        let roll = table(factor, rate, slope).roll(TABLE_START).unwrap();
        let period = roll.period().unwrap();
        let gone = roll.at(1000.0 * period).unwrap().centre - roll.at(0.0).unwrap().centre;
        let speed = gone / (1000.0 * period);
        assert!(speed.x.abs() < 1e-14);
        assert_relative_eq!(speed.y, GRAVITY * slope.sin() / (factor * rate), max_relative = 1e-14);
        assert_relative_eq!(speed.y, roll.circle().unwrap().drift.y, max_relative = 1e-14);
    }
}

#[test]
fn ball_table_grip_is_the_force_along_over_the_force_across() {
    for (rate, slope) in [(6.0, 0.0), (-4.0, 0.1), (0.0, 0.2)] {
        let roll = table(Ball::SHELL, rate, slope).roll(TABLE_START).unwrap();
        let state = roll.at(0.7).unwrap();
        let gravity = Vector3::new(slope.sin(), 0.0, -slope.cos()) * GRAVITY;
        let rates = rolling(ball(Ball::SHELL), Wall::Plane(rate), gravity)(0.0, &to_array(&state));
        let force = Vector3::from_row_slice(&rates[3..6]) - gravity;
        assert_relative_eq!(roll.grip_needed(&state), force.x.hypot(force.y) / force.z, max_relative = 1e-12);
    }
}

fn hole(moment_factor: f64) -> Hole {
    Hole::new(HoleParameters { ball: ball(moment_factor), radius: 0.08, gravity: GRAVITY }).expect("a hole")
}

const HOLE_STARTS: [HoleStart; 4] = [
    HoleStart { rate: 20.0, rise: 0.0, pivot: 0.0 },
    HoleStart { rate: -30.0, rise: -0.4, pivot: 3.0 },
    HoleStart { rate: 15.0, rise: 0.7, pivot: -80.0 },
    HoleStart { rate: -15.0, rise: -0.1, pivot: 90.0 },
];

#[test]
fn ball_hole_motion_is_that_of_newton_and_euler() {
    for factor in FACTORS {
        for start in HOLE_STARTS {
            let roll = hole(factor).roll(start).unwrap();
            let rates = rolling(ball(factor), Wall::Cylinder, Vector3::z() * -GRAVITY);
            let first = roll.at(0.0).unwrap();
            let end = Dop853::new(1e-13).unwrap().solve(any(rates), 0.0, to_array(&first), 2.0).unwrap();
            let (end, found) = (from_array(&end.state), roll.at(2.0).unwrap());
            assert!(
                difference(&ball(factor), &end, &found) < 20.0 * STEPPED,
                "{factor} {start:?}: {end:?} {found:?}"
            );
            let outward = Vector3::new(found.centre.x, found.centre.y, 0.0).normalize();
            assert!(ball(factor).point_velocity(&found, &outward).norm() < 1e-14);
            assert_relative_eq!(roll.energy(&found), roll.energy(&first), max_relative = 1e-13);
        }
    }
}

#[test]
fn ball_hole_rate_is_the_root_of_two_sevenths() {
    let roll = hole(Ball::SOLID).roll(HOLE_STARTS[0]).unwrap();
    assert_relative_eq!(roll.swing_rate(), 20.0 * (2.0_f64 / 7.0).sqrt(), max_relative = ROUNDING);
    let rounds = hole(Ball::SOLID).rounds_per_swing();
    assert_relative_eq!(rounds, 1.870_828_693_386_970_7, max_relative = ROUNDING);
    assert_relative_eq!(roll.swing_period() * 20.0 / TAU, rounds, max_relative = ROUNDING);
    // From level it sinks to 5 g/Ω² below the start, by (5/2) g/Ω² to either side of the middle.
    assert_relative_eq!(roll.middle(), -2.5 * GRAVITY / 400.0, max_relative = ROUNDING);
    assert_relative_eq!(roll.lowest(), -5.0 * GRAVITY / 400.0, max_relative = ROUNDING);
    assert_eq!(roll.highest(), 0.0);
}

#[test]
fn ball_hole_back_and_the_lowest_point_are_where_a_search_finds_them() {
    for factor in FACTORS {
        for start in HOLE_STARTS {
            let roll = hole(factor).roll(start).unwrap();
            let back = roll.first_return().unwrap();
            let height = |time: f64| roll.at(time).unwrap().centre.z;
            assert!(height(back).abs() < 1e-15);
            let steps: Vec<f64> = (1..2000).map(|n| height(back * f64::from(n) / 2000.0)).collect();
            assert!(steps.iter().all(|z| *z > 0.0) || steps.iter().all(|z| *z < 0.0), "{start:?}");
            let round = (0..20_000).map(|n| height(roll.swing_period() * f64::from(n) / 20_000.0));
            let [low, high] = round.fold([0.0_f64; 2], |[low, high], z| [low.min(z), high.max(z)]);
            assert!((low - roll.lowest()).abs() < 1e-7 * roll.amplitude(), "{low} {}", roll.lowest());
            assert!((high - roll.highest()).abs() < 1e-7 * roll.amplitude());
        }
    }
}

#[test]
fn ball_hole_grip_is_the_largest_that_newton_asks_for() {
    for start in HOLE_STARTS {
        let roll = hole(Ball::SOLID).roll(start).unwrap();
        let mut rates = rolling(ball(Ball::SOLID), Wall::Cylinder, Vector3::z() * -GRAVITY);
        let most = (0..4000)
            .map(|n| {
                let state = roll.at(roll.swing_period() * f64::from(n) / 4000.0).unwrap();
                let rates = rates(0.0, &to_array(&state));
                let force = Vector3::from_row_slice(&rates[3..6]) + Vector3::z() * GRAVITY;
                force.z.abs() / force.x.hypot(force.y)
            })
            .fold(0.0, f64::max);
        assert_relative_eq!(roll.grip_needed(), most, max_relative = 1e-5);
    }
}

fn message<T: std::fmt::Debug>(result: Result<T, InvalidQuantity>) -> String {
    result.expect_err("this should be refused").to_string()
}

#[test]
fn what_is_not_of_this_world_is_refused() {
    let parameters = BallParameters { radius: 0.03, moment_factor: 0.7 };
    assert_eq!(
        message(Ball::new(parameters)),
        "moment of the ball over ma² 0.7 exceeds that of a thin shell, 0.6666666666666666"
    );
    for (radius, moment_factor) in [(0.0, 0.4), (f64::NAN, 0.4), (0.03, 0.0), (0.03, f64::NAN), (1e60, 0.4)] {
        assert!(Ball::new(BallParameters { radius, moment_factor }).is_err());
    }
    let on = |friction, gravity| Cloth::new(ClothParameters { ball: ball(0.4), friction, gravity });
    assert_eq!(
        message(on(0.0, GRAVITY)),
        "coefficient of friction 0 is not positive; it must be more than zero"
    );
    assert_eq!(message(on(0.2, f64::NAN)), "gravity NaN m/s² is not a finite number");
    let cloth = cloth(0.4, 0.2);
    for bad in [f64::NAN, f64::INFINITY, 1e60] {
        assert!(cloth.shot(ShotStart { velocity: [1.0, bad], omega: [0.0; 3] }).is_err());
        assert!(cloth.shot(ShotStart { velocity: [1.0, 0.0], omega: [0.0, 0.0, bad] }).is_err());
        assert!(cloth.struck(Cue { speed: bad, height: 0.03 }).is_err());
        assert!(cloth.struck(Cue { speed: 1.0, height: bad }).is_err());
        assert!(table(0.4, 1.0, 0.0).roll(TurntableStart { place: [bad, 0.0], ..TABLE_START }).is_err());
        assert!(table(0.4, 1.0, 0.0).roll(TurntableStart { velocity: [bad, 0.0], ..TABLE_START }).is_err());
        assert!(table(0.4, 1.0, 0.0).roll(TurntableStart { pivot: bad, ..TABLE_START }).is_err());
        for start in [
            HoleStart { rate: bad, ..HOLE_STARTS[0] },
            HoleStart { rise: bad, ..HOLE_STARTS[0] },
            HoleStart { pivot: bad, ..HOLE_STARTS[0] },
        ] {
            assert!(hole(0.4).roll(start).is_err());
        }
        assert!(masse(0.4).at(bad).is_err() && masse(0.4).slip(bad).is_err());
        assert!(table(0.4, 1.0, 0.0).roll(TABLE_START).unwrap().at(bad).is_err());
        assert!(hole(0.4).roll(HOLE_STARTS[0]).unwrap().at(bad).is_err());
    }
    let high = message(cloth.struck(Cue { speed: 1.0, height: 0.07 }));
    assert_eq!(high, "height of the cue 0.07 m exceeds the height of the ball, 0.06 m");
    assert_eq!(message(masse(0.4).at(-1.0)), "time -1 s is negative; it must be zero or more");
    let steep = TurntableParameters { ball: ball(0.4), rate: 1.0, slope: -1.6, gravity: GRAVITY };
    assert_eq!(message(Turntable::new(steep)), "slope -1.6 rad: a table slopes by less than a right angle");
    let narrow = HoleParameters { ball: ball(0.4), radius: 0.03, gravity: GRAVITY };
    assert_eq!(
        message(Hole::new(narrow)),
        "radius of the hole 0.03 m is too small; it must be more than 0.03 m"
    );
    let still = hole(0.4).roll(HoleStart { rate: 0.0, ..HOLE_STARTS[0] });
    assert_eq!(message(still), "rate of going round 0 rad/s must not be zero");
    let slow = hole(0.4).roll(HoleStart { rate: 1e-40, rise: 0.0, pivot: 0.0 });
    assert!(message(slow).contains("farther than 1e50 m"));
    // A table at rest has no circle, and a ball where its weight is carried no swing.
    let rest = table(0.4, 0.0, 0.1).roll(TABLE_START).unwrap();
    assert!(rest.circle().is_none() && rest.period().is_none());
}

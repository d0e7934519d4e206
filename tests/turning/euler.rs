//! Euler's equations and the rate of the quaternion.

use super::{attitude, moments, turning, vector};
use crate::common::any;
use approx::assert_relative_eq;
use mechanics::attitude::quaternion_rate;
use mechanics::euler::{self, FreeSeries, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{Dop853, Taylor};
use nalgebra::{UnitQuaternion, Vector3};

/// A step over which a rotation is small but its rounding is smaller.
const STEP: f64 = 1e-5;

#[test]
fn quaternion_rate_turns_the_body_with_its_angular_velocity() {
    let mut random = fastrand::Rng::with_seed(1);
    for _ in 0..1000 {
        let (world_from_body, omega_body) = (attitude(&mut random), vector(&mut random, 3.0));
        let rate = quaternion_rate(&world_from_body, &omega_body);
        // The velocity of a point fixed in the body, by differences and by ω × r in the room.
        let point_body = vector(&mut random, 2.0);
        let moved = |h: f64| {
            let quaternion = world_from_body.into_inner() + rate * h;
            UnitQuaternion::from_quaternion(quaternion) * point_body
        };
        let velocity = (moved(STEP) - moved(-STEP)) / (2.0 * STEP);
        let omega_world = world_from_body * omega_body;
        let expected = omega_world.cross(&(world_from_body * point_body));
        assert_relative_eq!(velocity, expected, epsilon = 1e-8);
    }
}

#[test]
fn euler_rates_are_those_of_a_momentum_that_changes_by_the_torque() {
    let mut random = fastrand::Rng::with_seed(2);
    for _ in 0..1000 {
        let moments = moments(&mut random, 1.0);
        let Turning { world_from_body, omega_body } = turning(&mut random, 3.0);
        let torque_body = vector(&mut random, 2.0);
        let rates = euler::rates(&moments, &omega_body, &torque_body);
        // d/dt of R I ω by differences, with R turned about ω and ω advanced by its rate, is the torque in the room.
        let momentum = |h: f64| {
            let turned = world_from_body * UnitQuaternion::from_scaled_axis(omega_body * h);
            turned * moments.angular_momentum(&(omega_body + rates * h))
        };
        let change = (momentum(STEP) - momentum(-STEP)) / (2.0 * STEP);
        assert_relative_eq!(change, world_from_body * torque_body, epsilon = 1e-8);
    }
}

#[test]
fn a_torque_does_work_on_the_angular_velocity() {
    // A constant torque in the room, given along the body's axes: momentum grows by τt, energy by ∫τ·ω dt.
    let mut random = fastrand::Rng::with_seed(4);
    let moments = moments(&mut random, 1.0);
    let start = turning(&mut random, 3.0);
    let torque = Vector3::new(0.3, -0.2, 0.5);
    let driven = euler::turning_rates(moments, move |_, turning| turning.world_from_body.inverse() * torque);
    let end = Dop853::new(1e-13).unwrap().solve(any(driven), 0.0, start.to_array(), 2.0).unwrap();
    let end = Turning::from_array(end.state);
    let change = end.angular_momentum_world(&moments) - start.angular_momentum_world(&moments);
    assert_relative_eq!(change, torque * 2.0, epsilon = 1e-10);
}

#[test]
fn the_series_of_a_free_body_is_its_motion_whatever_its_moments() {
    for moments in [[3.0, 1.5, 2.0], [0.2, 0.25, 0.4], [7.0, 7.0, 1.0]] {
        let moments = PrincipalMoments::new(moments[0], moments[1], moments[2]).unwrap();
        let omega_body = Vector3::new(0.4, 1.1, -0.7);
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
        let series = FreeSeries::new(&moments);
        let end = Taylor::new(1e-16).unwrap().solve(&series, 0.0, start.to_array(), 5.0).unwrap();
        let closed = FreeTop::new(moments, start).unwrap().at(5.0).unwrap().to_array();
        // A quaternion and its negative are one attitude.
        let sign = if end.state[0] * closed[0] < 0.0 { -1.0 } else { 1.0 };
        for (i, (a, b)) in end.state.iter().zip(closed).enumerate() {
            let sign = if i < 4 { sign } else { 1.0 };
            assert!((a - sign * b).abs() < 1e-13, "{i}: {a} {b}");
        }
    }
}

//! Rotation about the middle axis: what grows, and the half turn.

use super::moments;
use crate::common::any;
use mechanics::attitude::rotation_between;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::PI;

/// The angular velocity after a time, stepped.
fn stepped(moments: &PrincipalMoments, start: [f64; 3], time: f64) -> [f64; 3] {
    let rates =
        |_: f64, omega: &[f64; 3]| euler::rates(moments, &Vector3::from(*omega), &Vector3::zeros()).into();
    Dop853::new(1e-13).unwrap().solve(any(rates), 0.0, start, time).unwrap().state
}

/// Two neighbouring motions, one of them steady: over one radian their distance along the next axis is multiplied by
/// the hyperbolic cosine of the growth rate, or by the cosine of the rate of swinging: eq:middle-growth.
#[test]
fn a_disturbance_grows_about_the_middle_axis_and_swings_about_the_others() {
    let (mut random, mut seen) = (fastrand::Rng::with_seed(164), [0, 0]);
    for n in 0..300 {
        let body = moments(&mut random, [0.3, 1.0, 2.0][n % 3]);
        let growth = body.growth_squared();
        for axis in 0..3 {
            let next = (axis + 1) % 3;
            let mut start = [0.0; 3];
            (start[axis], start[next]) = (1.0, 1e-6);
            let after = stepped(&body, start, 1.0);
            let expected =
                if growth[axis] > 0.0 { growth[axis].sqrt().cosh() } else { (-growth[axis]).sqrt().cos() };
            let found = after[next] / 1e-6;
            assert!((found - expected).abs() < 1e-6, "{body:?} about axis {axis}: {found} for {expected}");
            let mut sorted = body.to_array();
            sorted.sort_by(f64::total_cmp);
            let is_middle = body.to_array()[axis] == sorted[1];
            assert_eq!(growth[axis] > 0.0, is_middle, "{body:?} about axis {axis}");
            assert!(growth[axis] < 1.0, "no body is faster than its rotation");
            seen[usize::from(is_middle)] += 1;
        }
    }
    assert_eq!(seen, [600, 300]);
}

#[test]
fn equal_moments_leave_a_disturbance_as_it_is() {
    let growth = PrincipalMoments::symmetric(2.0, 3.0).unwrap().growth_squared();
    assert_eq!(growth[..2], [0.0, 0.0]);
    // About axis 3 it goes round with the body rate, (I₃ − I₁)/I₁ of the spin.
    assert!((growth[2] + 0.25).abs() < 1e-15);
}

/// Moments that ascend, and the angle β between axis 1 and the line of the half turn.
fn ascending(random: &mut fastrand::Rng) -> (PrincipalMoments, f64) {
    let mut sorted = moments(random, 0.7).to_array();
    sorted.sort_by(f64::total_cmp);
    let [i1, i2, i3] = sorted;
    let tangent = (i1 * (i3 - i2) / (i3 * (i2 - i1))).sqrt();
    (PrincipalMoments::new(i1, i2, i3).unwrap(), tangent.atan())
}

/// A start on the way from −axis 2 to axis 2 with L along the upright.
fn upright_start(body: PrincipalMoments, momentum_body: Vector3<f64>) -> Turning {
    let upright = UnitQuaternion::rotation_between(&momentum_body, &Vector3::z());
    Turning {
        world_from_body: upright.unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 3.0)),
        omega_body: body.angular_velocity(&momentum_body),
    }
}

/// On the separatrix, against Euler's equations and the quaternion stepped: eq:flip.
#[test]
fn the_flip_is_a_half_turn_in_a_frame_that_turns_steadily() {
    let mut random = fastrand::Rng::with_seed(165);
    let mut seen = 0;
    for _ in 0..200 {
        let (body, tilt) = ascending(&mut random);
        let [_, i2, _] = body.to_array();
        let (sin, cos) = tilt.sin_cos();
        let rate = body.growth_squared()[1].sqrt(); // for W = 1
        let direction = |x: f64| Vector3::new(sin / x.cosh(), x.tanh(), cos / x.cosh());
        let angle = |x: f64| x.sinh().atan(); // from −π/2 to π/2
        let [from, to] = [-2.5, 2.0];
        let start = upright_start(body, i2 * direction(from));
        let time = (to - from) / rate;
        if time > 40.0 {
            continue; // nearly equal moments
        }
        seen += 1;
        let free = euler::turning_rates(body, |_, _| Vector3::zeros());
        let end = Dop853::new(1e-13).unwrap().solve(any(free), 0.0, start.to_array(), time).unwrap();
        let end = Turning::from_array(end.state);
        let line = Vector3::new(cos, 0.0, -sin);
        let expected = UnitQuaternion::from_scaled_axis(Vector3::z() * time)
            * start.world_from_body
            * UnitQuaternion::from_scaled_axis(line * (angle(to) - angle(from)));
        let off = rotation_between(&end.world_from_body, &expected);
        assert!(off < 1e-9, "{body:?}: {off} rad off");
        assert!((end.omega_body - body.angular_velocity(&(i2 * direction(to)))).norm() < 1e-9);
    }
    assert!(seen > 100, "only {seen} bodies");
}

/// The finer the throw, the more exact the half turn and the logarithm of the wait: eq:flip-wait.
#[test]
fn a_fine_throw_waits_for_a_logarithm_and_makes_half_a_turn() {
    let mut random = fastrand::Rng::with_seed(166);
    for _ in 0..100 {
        let (body, tilt) = ascending(&mut random);
        let rate = body.growth_squared()[1].sqrt();
        if !(0.2..1.3).contains(&tilt) || rate < 0.1 {
            continue;
        }
        let [_, i2, _] = body.to_array();
        for towards_3 in [false, true] {
            for fine in [1e-3, 1e-5, 1e-7] {
                let aside: Vector3<f64> = if towards_3 { Vector3::z() } else { Vector3::x() };
                let momentum = (Vector3::y() + fine * aside).normalize() * i2;
                let start = upright_start(body, momentum);
                let top = FreeTop::new(body, start).unwrap();
                let half = 0.5 * top.period().unwrap();
                let share = if towards_3 { tilt.cos() } else { tilt.sin() };
                let wait = (4.0 * share / fine).ln() / rate;
                assert!((0.5 * half - wait).abs() * rate < 30.0 * fine, "{body:?} {fine}");
                // On the way from 2 to −2 the line leans from 1 towards 3.
                let line = Vector3::new(tilt.cos(), 0.0, tilt.sin());
                let expected = UnitQuaternion::from_scaled_axis(Vector3::z() * half)
                    * start.world_from_body
                    * UnitQuaternion::from_scaled_axis(line * PI);
                let off = rotation_between(&top.at(half).unwrap().world_from_body, &expected);
                assert!(off < 30.0 * fine, "{body:?} {fine}: {off} rad off");
            }
        }
    }
}

/// However rough the throw: what goes round axis 1 has made half a turn about it after half a period, but for a turn
/// about L.
#[test]
fn half_a_period_is_half_a_turn_about_the_axis_that_is_circled() {
    let mut random = fastrand::Rng::with_seed(167);
    for _ in 0..100 {
        let (body, _) = ascending(&mut random);
        let [i1, i2, i3] = body.to_array();
        if i2 / i1 < 1.05 || i3 / i2 < 1.05 {
            continue;
        }
        let momentum = Vector3::new(0.05 + 0.9 * random.f64(), 1.0, 0.0);
        let start = upright_start(body, momentum);
        let half = 0.5 * FreeTop::new(body, start).unwrap().period().unwrap();
        let free = euler::turning_rates(body, |_, _| Vector3::zeros());
        let end = Dop853::new(1e-13).unwrap().solve(any(free), 0.0, start.to_array(), half).unwrap();
        let end = Turning::from_array(end.state);
        // Undo the start and the half turn: what is left turns about the upright.
        let rest = end.world_from_body
            * UnitQuaternion::from_scaled_axis(Vector3::x() * PI)
            * start.world_from_body.inverse();
        assert!((rest * Vector3::z() - Vector3::z()).norm() < 1e-8, "{body:?} {momentum}");
    }
}

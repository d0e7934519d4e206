//! The free symmetric top in closed form.

use super::{between, turning};
use crate::common::any;
use approx::assert_relative_eq;
use mechanics::attitude::rotation_between;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, Cylinder, PrincipalMoments};
use mechanics::integrate::Dop853;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// A few units in the last place: what the closed form may lose, at any time.
const FEW_ULP: f64 = 2e-15;

/// The motion from the angular momentum alone: in the room L stands still, `ω = R I⁻¹ Rᵀ L`, and each axis of the body
/// moves with `ω × axis`. Nine numbers, no quaternion, none of Euler's equations.
fn matrix_motion(moments: &PrincipalMoments, start: &Turning, time: f64, tolerance: f64) -> Matrix3<f64> {
    let momentum = start.angular_momentum_world(moments);
    let inverse = moments.to_array().map(f64::recip);
    let rates = |_: f64, state: &[f64; 9]| {
        let axes = Matrix3::from_column_slice(state);
        let omega: Vector3<f64> =
            (0..3).map(|i| axes.column(i) * (axes.column(i).dot(&momentum) * inverse[i])).sum();
        let mut rates = [0.0; 9];
        for (i, rate) in rates.chunks_mut(3).enumerate() {
            rate.copy_from_slice(omega.cross(&axes.column(i).into_owned()).as_slice());
        }
        rates
    };
    let axes = start.world_from_body.to_rotation_matrix();
    let state: [f64; 9] = axes.matrix().as_slice().try_into().unwrap();
    let end = Dop853::new(tolerance).unwrap().solve(any(rates), 0.0, state, time).unwrap();
    Matrix3::from_column_slice(&end.state)
}

#[test]
fn the_closed_form_is_the_motion_that_keeps_the_angular_momentum() {
    let mut random = fastrand::Rng::with_seed(6);
    for _ in 0..100 {
        // From plates to thick rods: for a needle R I⁻¹ Rᵀ magnifies the errors of the axes too much to be a judge.
        let axial = between(&mut random, 0.2, 2.0);
        let moments = PrincipalMoments::symmetric(1.0, axial).unwrap();
        let start = turning(&mut random, 1.0);
        let top = FreeSymmetricTop::new(moments, start).unwrap();
        // Some two turns of the faster of the two rotations.
        let time = 12.0 / top.precession_rate().max(top.body_rate().abs());
        let axes = matrix_motion(&moments, &start, time, 1e-13);
        let closed = top.at(time).unwrap();
        assert_relative_eq!(*closed.world_from_body.to_rotation_matrix().matrix(), axes, epsilon = 1e-10);
        let omega = moments.angular_velocity(&(axes.transpose() * start.angular_momentum_world(&moments)));
        assert_relative_eq!(closed.omega_body, omega, epsilon = 1e-9);
        assert_relative_eq!(top.axis_world(time).unwrap(), axes.column(2).into_owned(), epsilon = 1e-10);
    }
}

/// How far specks of a plate that turns with this lean of ω are, after one turn and at the worst, from where they would
/// be on threads of their own to the centre: each on a great circle, at a constant rate. `height` is theirs over it.
fn missed_by_threads(lean: f64, height: f64) -> f64 {
    let disc = Body::cylinder(1.0, Cylinder { radius: 1.0, height: 2.0 * height }).unwrap();
    let omega = Vector3::new(lean, 0.0, 1.0);
    let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body: omega };
    let now = FreeSymmetricTop::new(disc.moments(), start).unwrap().at(TAU).unwrap();
    let specks =
        (0..12).map(|k| (TAU * f64::from(k) / 12.0).sin_cos()).map(|(y, x)| Vector3::new(x, y, height));
    let missed = specks.map(|speck| {
        let velocity = omega.cross(&speck);
        let (sin, cos) = (TAU * velocity.norm() / speck.norm()).sin_cos();
        let on_thread = speck * cos + velocity.normalize() * (speck.norm() * sin);
        (on_thread - now.world_from_body * speck).norm()
    });
    missed.fold(0.0, f64::max)
}

#[test]
fn a_slightly_wobbling_plate_needs_no_stiffness_and_a_thick_one_does() {
    // To the first order the specks of a flat plate stay together by themselves: what is left goes with the square.
    for lean in [1e-2, 1e-3, 1e-4] {
        let miss = missed_by_threads(lean, 0.0);
        assert!(miss < 1.7 * lean * lean && miss > 1.4 * lean * lean, "{lean}: {miss}");
        assert!(missed_by_threads(lean, 0.5) > 0.3, "on a thread a speck above the middle leaves at once");
    }
}

#[test]
fn wobbles_in_a_turn_are_the_ratio_of_the_moments_over_a_cosine() {
    // By a simulation that counts nothing of the kind: the axis, followed round L for a turn about itself.
    let mut random = fastrand::Rng::with_seed(15);
    for _ in 0..50 {
        let ratio = between(&mut random, 0.1, 2.0);
        let moments = PrincipalMoments::symmetric(1.0, ratio).unwrap();
        let omega_body = Vector3::new(between(&mut random, 0.01, 2.0), 0.0, 1.0);
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
        let momentum = start.angular_momentum_world(&moments).normalize();
        let free = mechanics::euler::turning_rates(moments, |_, _| Vector3::zeros());
        let times: Vec<f64> = (0..=200).map(|k| TAU * f64::from(k) / 200.0).collect();
        let (states, _) =
            Dop853::new(1e-12).unwrap().sample(any(free), 0.0, start.to_array(), &times).unwrap();
        let aside = momentum.cross(&Vector3::z());
        let ahead = aside.cross(&momentum);
        let azimuths = states.into_iter().map(Turning::from_array).map(|state| {
            let axis = state.axis_3_world();
            axis.dot(&aside).atan2(axis.dot(&ahead))
        });
        let (mut round, mut before) = (0.0, 0.0);
        for azimuth in azimuths {
            round += (azimuth - before + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
            before = azimuth;
        }
        let cosine = momentum.z; // of the angle between L and axis 3
        assert_relative_eq!(round / TAU, ratio / cosine, max_relative = 1e-8);
    }
}

#[test]
fn a_sphere_turns_about_its_axis_and_a_body_at_rest_stays() {
    let ball = PrincipalMoments::symmetric(2.0, 2.0).unwrap();
    let omega_body = Vector3::new(1.0, 2.0, 2.0);
    let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
    let top = FreeSymmetricTop::new(ball, start).unwrap();
    let turning = top.at(1.0).unwrap();
    assert_eq!(turning.omega_body, omega_body);
    let expected = UnitQuaternion::from_scaled_axis(omega_body);
    assert!(rotation_between(&turning.world_from_body, &expected) < FEW_ULP);

    let rest = Turning { omega_body: Vector3::zeros(), ..start };
    let top = FreeSymmetricTop::new(ball, rest).unwrap();
    assert_eq!(top.at(1e9).unwrap(), rest);
    assert_eq!((top.precession_rate(), top.momentum_angle()), (0.0, 0.0));
}

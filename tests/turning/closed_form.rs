//! The free symmetric top in closed form.

use crate::{between, symmetric_moments, turning};
use approx::assert_relative_eq;
use mechanics::attitude::{angle_between, rotation_between};
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
    let end = Dop853::new(tolerance).unwrap().solve(rates, 0.0, state, time).unwrap();
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

#[test]
fn the_closed_form_is_the_integration_of_eulers_equations() {
    let mut random = fastrand::Rng::with_seed(7);
    for _ in 0..100 {
        let moments = symmetric_moments(&mut random);
        let start = turning(&mut random, 1.0);
        let top = FreeSymmetricTop::new(moments, start).unwrap();
        let time = -30.0 / top.precession_rate().max(top.body_rate().abs());
        let free = mechanics::euler::turning_rates(moments, |_, _| Vector3::zeros());
        let end = Dop853::new(1e-13).unwrap().solve(free, 0.0, start.to_array(), time).unwrap();
        let (end, closed) = (Turning::from_array(end.state), top.at(time).unwrap());
        assert!(rotation_between(&end.world_from_body, &closed.world_from_body) < 1e-10);
        assert_relative_eq!(end.omega_body, closed.omega_body, epsilon = 1e-10);
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
        let (states, _) = Dop853::new(1e-12).unwrap().sample(free, 0.0, start.to_array(), &times).unwrap();
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
fn momentum_energy_spin_and_angle_stay_for_a_million_turns() {
    let mut random = fastrand::Rng::with_seed(8);
    for _ in 0..300 {
        let moments = symmetric_moments(&mut random);
        let start = turning(&mut random, 10.0);
        let top = FreeSymmetricTop::new(moments, start).unwrap();
        let momentum = start.angular_momentum_world(&moments);
        let energy = moments.kinetic_energy(&start.omega_body);
        for n in 0..30 {
            let turns = 1e6 * random.f64() * if n % 2 == 0 { 1.0 } else { -1.0 };
            let turning = top.at(turns * TAU / top.precession_rate()).unwrap();
            let error = (turning.angular_momentum_world(&moments) - momentum).norm() / momentum.norm();
            assert!(error < FEW_ULP, "angular momentum changes by {error:e}");
            assert_relative_eq!(moments.kinetic_energy(&turning.omega_body), energy, max_relative = FEW_ULP);
            assert_eq!(turning.omega_body.z, start.omega_body.z);
            let angle = angle_between(&turning.axis_3_world(), &turning.angular_momentum_world(&moments));
            assert_relative_eq!(angle, top.momentum_angle(), epsilon = FEW_ULP);
            assert!((turning.world_from_body.coords.norm() - 1.0).abs() < FEW_ULP);
        }
    }
}

#[test]
fn attitude_has_sixteen_digits_after_a_billion_radians() {
    // I₃ = 2 I₁ and ω = (3, 0, 2): Λ = 5 and σ = 2 exactly, L along (3, 0, 4), and whole numbers of seconds are exact
    // angles.
    let moments = PrincipalMoments::symmetric(1.0, 2.0).unwrap();
    let start =
        Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(3.0, 0.0, 2.0) };
    let top = FreeSymmetricTop::new(moments, start).unwrap();
    assert_eq!((top.precession_rate(), top.body_rate()), (5.0, 2.0));
    for time in [1.0, 1e3, 1e6, 123_456_789.0, 1e9, 1e15] {
        let about = |axis: Vector3<f64>, half: f64| {
            let (sin, cos) = half.sin_cos();
            UnitQuaternion::new_unchecked(nalgebra::Quaternion::from_parts(cos, axis * sin))
        };
        let expected = about(Vector3::new(0.6, 0.0, 0.8), 2.5 * time) * about(Vector3::z(), -time);
        let found = top.at(time).unwrap();
        assert!(rotation_between(&found.world_from_body, &expected) < FEW_ULP, "at {time} s");
        let (sin, cos) = (2.0 * time).sin_cos();
        assert_relative_eq!(
            found.omega_body,
            Vector3::new(3.0 * cos, 3.0 * sin, 2.0),
            epsilon = 3.0 * FEW_ULP
        );
    }
}

#[test]
fn an_odd_ratio_of_moments_keeps_its_digits_too() {
    // Λ is irrational here: the judge is the motion carried on from a restart at an earlier time, in steps of an exact
    // time.
    let moments = PrincipalMoments::symmetric(3.0, 1.7).unwrap();
    let start =
        Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(0.4, -1.1, 2.3) };
    let top = FreeSymmetricTop::new(moments, start).unwrap();
    let mut turning = start;
    let steps = 4096;
    let step = 0.25;
    for _ in 0..steps {
        turning = FreeSymmetricTop::new(moments, turning).unwrap().at(step).unwrap();
    }
    let end = top.at(step * f64::from(steps)).unwrap();
    // Four thousand roundings that add up like a random walk, and turn the phase a little each.
    assert!(rotation_between(&turning.world_from_body, &end.world_from_body) < 1e-11);
}

#[test]
fn the_angle_of_the_rotation_is_that_between_two_vectors() {
    let mut random = fastrand::Rng::with_seed(9);
    for n in 0..300 {
        let mut start = turning(&mut random, 1.0);
        if n % 2 == 0 {
            start.omega_body[n % 3] = 0.0;
        }
        let top = FreeSymmetricTop::new(symmetric_moments(&mut random), start).unwrap();
        assert_relative_eq!(
            top.omega_angle(),
            angle_between(&start.omega_body, &Vector3::z()),
            epsilon = FEW_ULP
        );
        let momentum = top.moments().angular_momentum(&start.omega_body);
        assert_relative_eq!(top.momentum_angle(), angle_between(&momentum, &Vector3::z()), epsilon = FEW_ULP);
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

//! The free body of any shape in closed form.

use crate::{moments, turning};
use approx::assert_relative_eq;
use mechanics::attitude::rotation_between;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// The judge, Euler's equations to 1e-13 a step, over some twenty radians.
const JUDGE: f64 = 2e-11;

fn integrated(moments: PrincipalMoments, start: &Turning, time: f64) -> Turning {
    let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
    let end = Dop853::new(1e-13).unwrap().solve(free, 0.0, start.to_array(), time).unwrap();
    Turning::from_array(end.state)
}

/// How far the closed form is from the judge: angular velocity over its size, and attitude, rad.
fn errors(moments: PrincipalMoments, start: &Turning, time: f64) -> (f64, f64) {
    let closed = FreeTop::new(moments, *start).unwrap().at(time).unwrap();
    let judge = integrated(moments, start, time);
    (
        (closed.omega_body - judge.omega_body).norm() / start.omega_body.norm(),
        rotation_between(&closed.world_from_body, &judge.world_from_body),
    )
}

#[test]
fn on_the_separatrix_the_body_comes_to_the_middle_axis_and_stays() {
    // Exactly on it: for I = (3, 5, 6) that is ω₁ = ω₃.
    let moments = PrincipalMoments::new(3.0, 5.0, 6.0).unwrap();
    let omega_body = Vector3::new(0.5, 0.1, 0.5);
    let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
    let (omega, attitude) = errors(moments, &start, 5.0);
    assert!(omega < 1e-11 && attitude < 1e-11, "{omega:e} {attitude:e}");
    let top = FreeTop::new(moments, start).unwrap();
    assert_eq!(top.period(), None);
    let late = top.at(200.0).unwrap();
    let total = start.angular_momentum_world(&moments).norm() / 5.0;
    assert_relative_eq!(late.omega_body.y.abs(), total, max_relative = 1e-6);
}

#[test]
fn a_hundred_million_periods_keep_thirteen_digits_of_the_angular_velocity() {
    let mut random = fastrand::Rng::with_seed(86);
    for _ in 0..200 {
        let moments = moments(&mut random, 1.0);
        let start = turning(&mut random, 1.0);
        let top = FreeTop::new(moments, start).unwrap();
        let Some(period) = top.period() else { continue };
        // A power of two of periods, so that the time is exact, and a quarter of one more by another route: the same
        // motion, restarted from where the first quarter ends. The period is rounded, and so many periods are late by
        // so much of it.
        let many = 2_f64.powi(27);
        let early = top.at(0.25 * period).unwrap();
        let late = top.at(0.25 * period + many * period).unwrap();
        let slip = many * period * f64::EPSILON;
        let rate = euler::rates(&moments, &early.omega_body, &Vector3::zeros()).norm();
        let error = (late.omega_body - early.omega_body).norm();
        assert!(error <= 1e-13 + rate * slip, "{error:e} against {:e}", rate * slip);
        // What the rounding of the period and of the time cannot explain is compared at the exact time.
        let energy = moments.kinetic_energy(&late.omega_body);
        assert_relative_eq!(energy, moments.kinetic_energy(&start.omega_body), max_relative = 3e-15);
        let momentum = start.angular_momentum_world(&moments);
        let change = late.angular_momentum_world(&moments) - momentum;
        assert!(change.norm() < 6e-15 * momentum.norm(), "{:e}", change.norm() / momentum.norm());
    }
}

#[test]
fn rotation_about_a_principal_axis_is_steady_and_a_hair_off_it_is_not() {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5).unwrap();
    for axis in 0..3 {
        let mut omega_body = Vector3::zeros();
        omega_body[axis] = -1.7;
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
        let top = FreeTop::new(moments, start).unwrap();
        assert_eq!((top.at(1e5).unwrap().omega_body, top.period()), (omega_body, None));
        let expected = UnitQuaternion::from_scaled_axis(omega_body * 2.0);
        assert!(rotation_between(&top.at(2.0).unwrap().world_from_body, &expected) < 1e-14);
        for hair in [1e-3, 1e-8, 1e-15] {
            omega_body[(axis + 1) % 3] = hair;
            let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
            let (omega, attitude) = errors(moments, &start, 4.0);
            assert!(omega < JUDGE && attitude < JUDGE, "axis {axis}, {hair:e}: {omega:e} {attitude:e}");
        }
    }
}

#[test]
fn the_period_of_a_symmetric_body_is_that_of_its_wobble_whatever_the_sense() {
    // I₃ = 2 I₁: ω goes round the axis at σ = ω₃, whichever axis it is.
    for axis in 0..3 {
        let mut moments = [1.0; 3];
        moments[axis] = 2.0;
        let [i1, i2, i3] = moments;
        let moments = PrincipalMoments::new(i1, i2, i3).unwrap();
        let period = |spin: f64, wobble: f64, next: usize| {
            let mut omega_body = Vector3::zeros();
            omega_body[axis] = spin;
            omega_body[(axis + next) % 3] = wobble;
            FreeTop::new(moments, Turning { world_from_body: UnitQuaternion::identity(), omega_body })
                .unwrap()
                .period()
        };
        for spin in [5.0, -5.0, 0.3] {
            assert_eq!(period(spin, 0.0, 1), None, "steady about its axis");
            for (wobble, next) in [(0.3, 1), (-0.3, 1), (0.3, 2), (1e-50, 2)] {
                let expected = TAU / f64::abs(spin);
                assert_relative_eq!(period(spin, wobble, next).unwrap(), expected, max_relative = 4e-16);
            }
        }
        assert_eq!(period(0.0, 1.0, 1), None, "steady across its axis");
    }
}

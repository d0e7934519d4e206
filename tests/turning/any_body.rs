//! The free body of any shape in closed form.

use crate::{between, moments, turning};
use approx::assert_relative_eq;
use mechanics::attitude::rotation_between;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::{FreeSymmetricTop, FreeTop};
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde_json::Value;
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
fn the_closed_form_agrees_with_an_integration_for_thousands_of_bodies() {
    let mut random = fastrand::Rng::with_seed(84);
    let mut worst = [0.0_f64; 2];
    for n in 0..3000 {
        // Moments in any order, bodies from round to as flat and long as the triangle rule allows.
        let moments = moments(&mut random, [0.5, 1.0, 2.0][n % 3]);
        let start = turning(&mut random, 1.0);
        let [small, _, _] = {
            let mut sorted = moments.to_array();
            sorted.sort_by(f64::total_cmp);
            sorted
        };
        let (omega, attitude) = errors(moments, &start, 20.0 * random.f64() - 10.0);
        worst = [worst[0].max(omega), worst[1].max(attitude)];
        assert!(omega < JUDGE && attitude < JUDGE, "{moments:?} {start:?}: {omega:e} {attitude:e} {small}");
    }
    assert!(worst[1] > 0.0);
}

/// A body and a start at a given distance from the separatrix, whose complementary parameter is about `gap`, on either
/// side.
fn near_the_separatrix(random: &mut fastrand::Rng, gap: f64, side: f64) -> (PrincipalMoments, Turning) {
    let [i1, i2, i3] = [1.0, 1.0 + between(random, 0.1, 0.6), 1.9];
    // L² = 2 T I₂ on it: I₁ω₁²(I₁ − I₂) + I₃ω₃²(I₃ − I₂) = 0.
    let w3 = between(random, 0.1, 1.0);
    let w1 = w3 * (i3 * (i3 - i2) / (i1 * (i2 - i1))).sqrt() * (1.0 + side * gap);
    let w2 = 2.0 * random.f64() - 1.0;
    let start = Turning {
        world_from_body: UnitQuaternion::from_euler_angles(0.4, -0.9, 2.2),
        omega_body: Vector3::new(w1, w2, w3),
    };
    (PrincipalMoments::new(i1, i2, i3).unwrap(), start)
}

#[test]
fn next_to_the_separatrix_no_digit_is_lost_on_either_side() {
    let mut random = fastrand::Rng::with_seed(85);
    for exponent in 1..=15 {
        for side in [1.0, -1.0] {
            for _ in 0..10 {
                let (moments, start) = near_the_separatrix(&mut random, 10_f64.powi(-exponent), side);
                // The motion itself magnifies an error of the judge near the middle axis: keep to the first swing.
                let (omega, attitude) = errors(moments, &start, 6.0);
                assert!(omega < 1e-10 && attitude < 1e-10, "1e-{exponent}, {side}: {omega:e} {attitude:e}");
            }
        }
    }
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
fn a_thousand_periods_are_met_to_thirteen_digits() {
    let file: Value =
        serde_json::from_str(include_str!("../data/thousand-periods.json")).expect("a valid file");
    let row = |value: &Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let y0 = row(&file["y0"]);
    let moments = PrincipalMoments::new(1.5, 0.5, 2.0).unwrap();
    let start = Turning {
        world_from_body: UnitQuaternion::identity(),
        omega_body: Vector3::new(y0[0], y0[1], y0[2]),
    };
    let top = FreeTop::new(moments, start).unwrap();
    let period: f64 = file["par"]["period"].as_str().unwrap().parse().unwrap();
    assert_relative_eq!(top.period().unwrap(), period, max_relative = 4e-16);
    let dt = file["dt"].as_f64().unwrap();
    let (mut worst, mut count) = (0.0_f64, 0);
    for (index, hi) in file["index"].as_array().unwrap().iter().zip(file["grid_hi"].as_array().unwrap()) {
        let found = top.at(index.as_f64().unwrap() * dt).unwrap();
        let y = row(hi);
        let attitude = UnitQuaternion::from_quaternion(Quaternion::new(y[3], y[4], y[5], y[6]));
        worst = worst.max((found.omega_body - Vector3::new(y[0], y[1], y[2])).norm());
        worst = worst.max(rotation_between(&found.world_from_body, &attitude));
        count += 1;
    }
    assert!(count > 120 && worst < 1e-13, "{worst:e} over {count} times");
}

#[test]
fn the_hoop_pinned_next_to_its_separatrix_is_met() {
    let file: Value = serde_json::from_str(include_str!("../data/hoop-pinned.json")).expect("a valid file");
    let value = |name: &str| file["values"][name].as_str().unwrap().parse::<f64>().unwrap();
    let theta = 89.9_f64.to_radians();
    let start = Turning {
        world_from_body: UnitQuaternion::identity(),
        omega_body: Vector3::new(theta.sin() / 3.0, -theta.cos(), 0.0),
    };
    let top = FreeTop::new(PrincipalMoments::new(1.5, 0.5, 2.0).unwrap(), start).unwrap();
    let found = top.at(50.0).unwrap();
    // cos 89.9° carries the rounding of the angle, 1e-13 of itself, which the motion multiplies by up to e^{ωt}.
    for (i, name) in ["omega1", "omega2", "omega3"].into_iter().enumerate() {
        assert_relative_eq!(found.omega_body[i], value(name), epsilon = 3e-14);
    }
    let centre = found.world_from_body * Vector3::y();
    for (i, name) in ["centre_1", "centre_2", "centre_3"].into_iter().enumerate() {
        assert_relative_eq!(centre[i], value(name), epsilon = 1e-13);
    }
    assert_relative_eq!(top.period().unwrap(), value("full_period"), max_relative = 1e-14);
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
fn bodies_with_an_axis_of_symmetry_anywhere_are_symmetric_tops() {
    let mut random = fastrand::Rng::with_seed(87);
    for n in 0..300 {
        let (transverse, axial) = (between(&mut random, 0.5, 5.0), 0.9 * random.f64() + 0.05);
        let moments = match n % 3 {
            0 => PrincipalMoments::new(transverse, transverse, axial),
            1 => PrincipalMoments::new(axial, transverse, transverse),
            _ => PrincipalMoments::new(transverse, axial, transverse),
        }
        .unwrap();
        let start = turning(&mut random, 1.0);
        let (omega, attitude) = errors(moments, &start, 6.0);
        assert!(omega < JUDGE && attitude < JUDGE, "{moments:?}: {omega:e} {attitude:e}");
        if n % 3 == 0 {
            let same = FreeSymmetricTop::new(moments, start).unwrap().at(6.0).unwrap();
            assert_eq!(FreeTop::new(moments, start).unwrap().at(6.0).unwrap().omega_body, same.omega_body);
        }
    }
}

#[test]
fn nearly_symmetric_bodies_go_over_into_symmetric_ones() {
    let mut random = fastrand::Rng::with_seed(88);
    for exponent in 1..=15 {
        for _ in 0..10 {
            let gap = 1.0 + 10_f64.powi(-exponent);
            for moments in [[1.0, gap, 1.7], [1.7, 1.0, gap], [0.4, gap, 1.0], [gap, 1.0 + 1e-9, 1.0]] {
                let [i1, i2, i3] = moments;
                let moments = PrincipalMoments::new(i1, i2, i3).unwrap();
                let start = turning(&mut random, 1.0);
                let (omega, attitude) = errors(moments, &start, 5.0);
                assert!(omega < JUDGE && attitude < JUDGE, "{moments:?} {start:?}: {omega:e} {attitude:e}");
            }
        }
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

//! Bodies, free tops and their scenes.

use super::{any, between};
use approx::assert_relative_eq;
use mechanics::attitude::angle_between;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, PrincipalMoments};
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use mechanics::scenes::coin_toss::{Flight, FlightParameters, Toss, TossParameters};
use mechanics::scenes::space_station::{Blow, Station, StationParameters};
use nalgebra::{UnitQuaternion, Vector3};

/// A few units in the last place, relative to the largest number that took part.
const ROUNDING: f64 = 4e-15;

fn finite(turning: &Turning) -> bool {
    turning.to_array().iter().all(|number| number.is_finite())
}

#[test]
fn no_numbers_panic_or_give_what_is_not_a_number() {
    let mut random = fastrand::Rng::with_seed(1988);
    let mut made = [0; 4];
    for _ in 0..100_000 {
        let mut number = || any(&mut random);
        let [a, b, c, d, e, time] = std::array::from_fn(|_| number());
        let omega_body = Vector3::new(c, d, e);
        let Ok(moments) = PrincipalMoments::symmetric(a.abs(), b.abs()) else { continue };
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
        if let Ok(top) = FreeSymmetricTop::new(moments, start) {
            made[0] += 1;
            assert!(
                top.at(time).is_ok_and(|turning| finite(&turning)) || time.abs() > 1e50,
                "{top:?} {time:e}"
            );
            assert!(top.momentum_angle().is_finite() && top.omega_angle().is_finite());
            assert!(top.precession_rate().is_finite() && top.body_rate().is_finite());
        }
        if let Ok(toss) = Toss::new(TossParameters { moments, omega_1: c, omega_3: d }) {
            made[1] += 1;
            let probability = toss.same_face_probability();
            assert!((0.5..=1.0).contains(&probability), "{toss:?} {probability}");
            assert!((-1.0..=1.0).contains(&toss.lowest_normal()));
            assert!(toss.normal_height(time).is_ok_and(f64::is_finite) || time.abs() > 1e50);
        }
        if let Ok(struck) = Body::hoop(a.abs(), b.abs())
            .and_then(|body| Station::new(StationParameters { body, spin: c }))
            .and_then(|station| station.struck(Blow { radius: b.abs(), impulse: d }))
        {
            made[2] += 1;
            assert!(struck.axis_angle() >= struck.momentum_angle() * (1.0 - ROUNDING), "{struck:?}");
            assert!(struck.at(time).is_ok_and(|turning| finite(&turning)) || time.abs() > 1e50);
        }
        let drag = Drag { transverse: number().abs(), axial: number().abs() };
        if let Ok(top) = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body }) {
            made[3] += 1;
            let time = time.abs();
            if time <= 1e50 {
                let omega = top.at(time).unwrap();
                assert!(omega.iter().all(|part| part.is_finite()), "{top:?} {time:e} {omega}");
                assert!(top.axis_angle(time).unwrap().is_finite(), "{top:?} {time:e}");
            }
            assert!(!top.total_body_turns().is_nan() && top.alignment_rate().is_finite());
        }
        let flight = FlightParameters { speed: a.abs(), gravity: b.abs(), catch_height: c };
        if let Ok(flight) = Flight::new(flight) {
            assert!(flight.duration() >= 0.0);
        }
    }
    assert!(made.iter().all(|&count| count > 500), "{made:?}");
}

#[test]
fn every_free_top_keeps_what_it_must() {
    let mut random = fastrand::Rng::with_seed(1);
    for _ in 0..20_000 {
        let transverse = between(&mut random, 1e-20, 1e20);
        let axial = transverse * between(&mut random, 1e-6, 2.0);
        let spin = between(&mut random, 1e-15, 1e15);
        let omega_body = Vector3::from_fn(|_, _| spin * (2.0 * random.f64() - 1.0));
        let start = Turning {
            world_from_body: UnitQuaternion::from_euler_angles(random.f64(), 2.0, 6.0 * random.f64()),
            omega_body,
        };
        let moments = PrincipalMoments::symmetric(transverse, axial).unwrap();
        let top = FreeSymmetricTop::new(moments, start).unwrap();
        let late = top.at(between(&mut random, 1e-6, 1e6) / spin).unwrap();
        let momentum = top.angular_momentum_world();
        let change = late.angular_momentum_world(&moments) - momentum;
        assert!(change.norm() < ROUNDING * momentum.norm(), "{top:?}");
        let energy = moments.kinetic_energy(&late.omega_body);
        assert_relative_eq!(energy, top.kinetic_energy(), max_relative = ROUNDING);
        let angle = angle_between(&late.axis_3_world(), &late.angular_momentum_world(&moments));
        assert_relative_eq!(angle, top.momentum_angle(), epsilon = ROUNDING);
        // Axis, momentum and angular velocity stay in one plane.
        let triple = late.axis_3_world().cross(&momentum).dot(&late.omega_world());
        assert!(triple.abs() < 2.0 * ROUNDING * momentum.norm() * late.omega_body.norm());
    }
}

#[test]
fn drag_only_ever_slows_a_body_down() {
    let mut random = fastrand::Rng::with_seed(2);
    for _ in 0..20_000 {
        let transverse = between(&mut random, 1e-6, 1e6);
        let moments =
            PrincipalMoments::symmetric(transverse, transverse * between(&mut random, 1e-3, 2.0)).unwrap();
        let drag =
            Drag { transverse: between(&mut random, 1e-9, 1e3), axial: between(&mut random, 1e-9, 1e3) };
        let omega = Vector3::from_fn(|_, _| 10.0 * random.f64() - 5.0);
        let top = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body: omega }).unwrap();
        let mut energy = moments.kinetic_energy(&omega);
        let mut time = 0.0;
        for _ in 0..5 {
            time += between(&mut random, 1e-3, 1e3);
            let next = moments.kinetic_energy(&top.at(time).unwrap());
            assert!(next <= energy * (1.0 + ROUNDING));
            energy = next;
        }
    }
}

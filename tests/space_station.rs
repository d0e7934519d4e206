//! The struck space station: equations (48) to (52), the printed ones that fail, and what the station does afterwards.

use crate::common::any;
use crate::printed::corrected_holds_and_printed_fails;
use approx::assert_relative_eq;
use mechanics::attitude::angle_between;
use mechanics::euler::{self, Turning};
use mechanics::inertia::Body;
use mechanics::integrate::Dop853;
use mechanics::scenes::space_station::{Blow, LaterBlow, Station, StationParameters, StruckStation};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;
use std::ops::AddAssign;

/// A ring of 400 t, 50 m in radius, turning in fourteen seconds: mass, radius, spin.
const RING: (f64, f64, f64) = (4e5, 50.0, 0.45);
const ROUNDING: f64 = 1e-13;

/// The ring struck on its rim.
fn struck(impulse: f64) -> StruckStation {
    struck_at(RING.1, impulse)
}

fn struck_at(distance: f64, impulse: f64) -> StruckStation {
    let (mass, radius, spin) = RING;
    let body = Body::hoop(mass, radius).expect("a ring");
    let station = Station::new(StationParameters { body, spin }).expect("a station");
    station.struck(Blow { radius: distance, impulse }).expect("a blow")
}

/// The blow from first principles: a chain of point masses gets, besides its spin, the one rigid velocity `v + ω × r`
/// whose momentum is P and whose angular momentum is r × P. Six equations for six numbers, solved by elimination.
fn blow(mass: f64, radius: f64, impulse: f64) -> (Vector3<f64>, Vector3<f64>) {
    let points: Vec<Vector3<f64>> = (0..360)
        .map(|n| {
            let (sin, cos) = (TAU * f64::from(n) / 360.0).sin_cos();
            Vector3::new(radius * cos, radius * sin, 0.0)
        })
        .collect();
    let share = mass / points.len() as f64;
    let mut matrix = nalgebra::SMatrix::<f64, 6, 6>::zeros();
    for column in 0..6 {
        let mut unit = nalgebra::SVector::<f64, 6>::zeros();
        unit[column] = 1.0;
        let (v, omega) = (unit.fixed_rows::<3>(0).into_owned(), unit.fixed_rows::<3>(3).into_owned());
        let mut response = nalgebra::SVector::<f64, 6>::zeros();
        for r in &points {
            let momentum = (v + omega.cross(r)) * share;
            response.fixed_rows_mut::<3>(0).add_assign(&momentum);
            response.fixed_rows_mut::<3>(3).add_assign(&r.cross(&momentum));
        }
        matrix.set_column(column, &response);
    }
    let push = Vector3::new(0.0, 0.0, impulse);
    let twist = Vector3::new(0.0, radius, 0.0).cross(&push);
    let given = nalgebra::SVector::<f64, 6>::from_iterator(push.iter().chain(&twist).copied());
    let gained = matrix.lu().solve(&given).expect("a ring can be moved in every way");
    (gained.fixed_rows::<3>(0).into_owned(), gained.fixed_rows::<3>(3).into_owned())
}

#[test]
fn eq48_the_blow_adds_twice_the_impulse_over_mass_and_radius() {
    let (mass, radius, _) = RING;
    let cases = [1.0, 1.8e6, -5e6].map(|impulse| {
        let (velocity, omega) = blow(mass, radius, impulse);
        let struck = struck(impulse);
        assert_relative_eq!(struck.added_rate(), omega.x, max_relative = ROUNDING);
        assert_relative_eq!(struck.centre_velocity(), velocity, max_relative = ROUNDING);
        assert!(omega.y.abs() + omega.z.abs() < ROUNDING * omega.x.abs());
        let corrected = 2.0 * impulse / (mass * radius);
        // Too large by the square of the radius in metres, and not even a rate.
        let printed = 2.0 * radius * impulse / mass;
        assert_relative_eq!(printed / omega.x, radius * radius, max_relative = ROUNDING);
        ((corrected / omega.x - 1.0).abs(), (printed / omega.x - 1.0).abs())
    });
    corrected_holds_and_printed_fails(cases, ROUNDING, 1000.0);
}

#[test]
fn eq48_a_blow_along_the_axis_at_the_centre_only_pushes() {
    // "at radius a ẑ", as printed, would be a point of the axis: no torque, no wobble.
    let (_, radius, _) = RING;
    let push = Vector3::new(0.0, 0.0, 1.8e6);
    assert_eq!(Vector3::new(0.0, 0.0, radius).cross(&push), Vector3::zeros());
    let pushed = struck_at(0.0, 1.8e6);
    assert_eq!((pushed.added_rate(), pushed.axis_angle()), (0.0, 0.0));
    assert!(struck(1.8e6).added_rate() != 0.0);
}

#[test]
fn eq49_the_new_axis_is_where_the_station_does_not_move() {
    // Turning alone, without the drift, leaves only the points of the axis at rest: search for that direction.
    let (mass, radius, spin) = RING;
    let cases = [2e5, 1.8e6, 6e6].map(|impulse| {
        let (_, gained) = blow(mass, radius, impulse);
        let omega = gained + Vector3::new(0.0, 0.0, spin);
        let speed = |angle: f64| omega.cross(&Vector3::new(angle.sin(), 0.0, angle.cos())).norm();
        let (mut low, mut high) = (0.0, 1.57);
        for _ in 0..200 {
            let third = (high - low) / 3.0;
            if speed(low + third) < speed(high - third) { high -= third } else { low += third }
        }
        assert_relative_eq!(struck(impulse).axis_angle(), low, max_relative = 1e-7);
        let corrected = (2.0 * impulse / (mass * radius * spin)).atan();
        let printed = (2.0 * radius * impulse / (spin * mass)).atan();
        ((corrected - low).abs(), (printed - low).abs())
    });
    corrected_holds_and_printed_fails(cases, 1e-7, 0.1);
}

#[test]
fn eq50_the_angular_momentum_gains_lever_arm_times_impulse() {
    let (mass, radius, spin) = RING;
    for impulse in [2e5, 1.8e6, -6e6] {
        let struck = struck(impulse);
        let before = Vector3::new(0.0, 0.0, mass * radius * radius * spin);
        let gained = Vector3::new(0.0, radius, 0.0).cross(&Vector3::new(0.0, 0.0, impulse));
        assert_relative_eq!(struck.angular_momentum_world(), before + gained, max_relative = ROUNDING);
        assert_relative_eq!(
            struck.momentum_angle(),
            angle_between(&before, &(before + gained)),
            max_relative = ROUNDING
        );
        assert_relative_eq!(
            2.0 * struck.momentum_angle().tan(),
            struck.axis_angle().tan(),
            max_relative = ROUNDING
        );
        assert_eq!(struck.centre_velocity().z, impulse / mass);
    }
}

/// The simulated motion at `times`, by Euler's equations and a quaternion.
fn simulated(struck: &StruckStation, times: &[f64]) -> Vec<Turning> {
    let (mass, radius, _) = RING;
    let moments = Body::hoop(mass, radius).unwrap().moments();
    let start = struck.at(0.0).unwrap();
    let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
    let (states, _) = Dop853::new(1e-13).unwrap().sample(any(free), 0.0, start.to_array(), times).unwrap();
    states.into_iter().map(Turning::from_array).collect()
}

/// How fast the projections of a vector across an axis go round, from many small steps, rad/s.
fn rate_about(axis: &Vector3<f64>, vectors: &[Vector3<f64>], step: f64) -> f64 {
    let across = |v: &Vector3<f64>| v - axis * axis.dot(v);
    let angle: f64 = vectors
        .windows(2)
        .map(|pair| {
            let (a, b) = (across(&pair[0]), across(&pair[1]));
            axis.dot(&a.cross(&b)).atan2(a.dot(&b))
        })
        .sum();
    angle / (step * (vectors.len() - 1) as f64)
}

#[test]
fn eq51_on_board_the_axis_of_rotation_goes_round_with_the_old_spin() {
    let (_, _, spin) = RING;
    let struck = struck(1.8e6);
    let step = 0.05;
    let times: Vec<f64> = (0..=2000).map(|n| step * f64::from(n)).collect();
    let turnings = simulated(&struck, &times);
    let omegas: Vec<Vector3<f64>> = turnings.iter().map(|turning| turning.omega_body).collect();
    assert_relative_eq!(rate_about(&Vector3::z(), &omegas, step), spin, max_relative = 1e-10);
    assert_relative_eq!(struck.body_rate(), spin, max_relative = 1e-15);
    for ((time, turning), sample) in times.iter().zip(&turnings).zip(struck.sample(&times).unwrap()) {
        assert_relative_eq!(struck.at(*time).unwrap().omega_body, turning.omega_body, epsilon = 1e-10);
        assert_relative_eq!(sample.omega_body, turning.omega_body, epsilon = 1e-10);
    }
    // The printed ẑ is not the station's axis but, if anything, the room's, along the old spin: seen from on board it
    // wanders.
    let cases = rates_on_board(&struck).into_iter().map(|(turning, rate)| {
        let corrected = (Vector3::z() * spin).cross(&turning.omega_body);
        let printed = (turning.world_from_body.inverse() * Vector3::z() * spin).cross(&turning.omega_body);
        ((corrected - rate).norm() / rate.norm(), (printed - rate).norm() / rate.norm())
    });
    corrected_holds_and_printed_fails(cases, 1e-6, 0.1);
}

/// Attitude and ω̇ along the station's axes, by differences of the simulation, at many moments of a minute.
fn rates_on_board(struck: &StruckStation) -> Vec<(Turning, Vector3<f64>)> {
    let h = 1e-3;
    let moments = (1..=40).map(|n| 1.5 * f64::from(n) - 0.7);
    let times: Vec<f64> = moments.flat_map(|t| [t - h, t, t + h]).collect();
    let turnings = simulated(struck, &times);
    let rate = |three: &[Turning]| (three[1], (three[2].omega_body - three[0].omega_body) / (2.0 * h));
    turnings.chunks(3).map(rate).collect()
}

#[test]
fn eq52_the_rate_on_board_is_a_vector_along_the_axis_of_the_station() {
    // ω̇ = Ω × ω. The printed number ω₀ says how long Ω is; along L, to which the source's next sentence puts it, it
    // fails.
    let (_, _, spin) = RING;
    let struck = struck(1.8e6);
    let momentum = struck.angular_momentum_world().normalize();
    let cases = rates_on_board(&struck).into_iter().map(|(turning, rate)| {
        let corrected = Vector3::z() * spin;
        let printed = turning.world_from_body.inverse() * momentum * spin;
        let miss = |omega: Vector3<f64>| (omega.cross(&turning.omega_body) - rate).norm() / rate.norm();
        (miss(corrected), miss(printed))
    });
    corrected_holds_and_printed_fails(cases, 1e-6, 0.1);
}

#[test]
fn eq52_in_the_room_the_station_nods_twice_as_fast_and_not_at_the_old_spin() {
    let (_, _, spin) = RING;
    for (impulse, about) in [(1e4, 2.0), (1.8e6, 2.04), (9e6, 2.828)] {
        let struck = struck(impulse);
        let step = 0.02;
        let times: Vec<f64> = (0..=5000).map(|n| step * f64::from(n)).collect();
        let turnings = simulated(&struck, &times);
        let momentum = struck.angular_momentum_world().normalize();
        let axes: Vec<Vector3<f64>> = turnings.iter().map(Turning::axis_3_world).collect();
        let rate = rate_about(&momentum, &axes, step);
        // The tilt of the smallest blow is a thousandth, and so much larger is its error.
        assert_relative_eq!(rate, struck.nodding_rate(), max_relative = 1e-8);
        let expected = (4.0 * spin * spin + struck.added_rate().powi(2)).sqrt();
        assert_relative_eq!(rate, expected, max_relative = 1e-8);
        assert_relative_eq!(rate / spin, about, max_relative = 1e-2);
        assert!(
            rate > 1.99 * spin,
            "the printed rate in the room is {spin} rad/s, the station nods at {rate}"
        );
    }
}

#[test]
fn a_mark_on_the_rim_goes_round_as_much_slower_than_the_nod_as_the_axis_of_rotation_on_board() {
    let (_, _, spin) = RING;
    for impulse in [1e5, 1.8e6, 9e6] {
        let struck = struck(impulse);
        // The mark goes round unevenly; after whole rounds on board it has the same place among the axes again.
        let step = TAU / spin / 1000.0;
        let times: Vec<f64> = (0..=3000).map(|n| step * f64::from(n)).collect();
        let momentum = struck.angular_momentum_world().normalize();
        let marks: Vec<Vector3<f64>> =
            simulated(&struck, &times).iter().map(|turning| turning.world_from_body * Vector3::y()).collect();
        let rate = rate_about(&momentum, &marks, step);
        let expected = (4.0 * spin * spin + struck.added_rate().powi(2)).sqrt() - spin; // eq:mark-rate
        assert_relative_eq!(rate, expected, max_relative = 1e-9);
        assert_relative_eq!(rate, struck.nodding_rate() - struck.body_rate(), max_relative = 1e-9);
    }
}

#[test]
fn the_cones_roll_off_equal_lengths() {
    // Both rates counted in a simulation, the angles from the blow: eq:cones-roll, and the third side of its triangle.
    let struck = struck(5e6);
    let step = 0.02;
    let times: Vec<f64> = (0..=5000).map(|n| step * f64::from(n)).collect();
    let turnings = simulated(&struck, &times);
    let momentum = struck.angular_momentum_world().normalize();
    let axes: Vec<Vector3<f64>> = turnings.iter().map(Turning::axis_3_world).collect();
    let omegas: Vec<Vector3<f64>> = turnings.iter().map(|turning| turning.omega_body).collect();
    let nods = rate_about(&momentum, &axes, step);
    let on_board = rate_about(&Vector3::z(), &omegas, step);
    let (axis, lean) = (struck.axis_angle(), struck.momentum_angle());
    assert_relative_eq!(nods * (axis - lean).sin(), on_board * axis.sin(), max_relative = 1e-8);
    assert_relative_eq!(nods * lean.sin(), omegas[0].norm() * axis.sin(), max_relative = 1e-8);
}

#[test]
fn a_mark_on_the_rim_drifts_and_turns_as_simulated() {
    let struck = struck(1.8e6);
    let times: Vec<f64> = (0..=100).map(|n| 0.5 * f64::from(n)).collect();
    let mark = Vector3::new(0.0, 50.0, 0.0);
    for (time, turning) in times.iter().zip(simulated(&struck, &times)) {
        let expected = Vector3::new(0.0, 0.0, 4.5 * time) + turning.world_from_body * mark;
        assert_relative_eq!(struck.position(&mark, *time).unwrap(), expected, epsilon = 1e-7);
    }
    assert_eq!(struck.at(0.0).unwrap().world_from_body, UnitQuaternion::identity());
}

/// In the room a later blow adds `r × P` to the angular momentum, and turns nothing while it strikes.
#[test]
fn a_later_blow_adds_its_moment() {
    let mut random = fastrand::Rng::with_seed(17);
    let (mass, radius, _) = RING;
    let moments = Body::hoop(mass, radius).expect("a ring").moments();
    for _ in 0..100 {
        let struck = struck(4e6 * random.f64());
        let (time, azimuth) = (100.0 * random.f64(), TAU * random.f64());
        let blow = Blow { radius: radius * random.f64(), impulse: 4e6 * (random.f64() - 0.5) };
        let before = struck.at(time).expect("a time");
        let top = struck.struck_again(LaterBlow { time, azimuth, blow }).expect("a blow");
        let after = top.start();
        assert_eq!(after.world_from_body, before.world_from_body);
        // Axis 2 turned about axis 3.
        let arm = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), azimuth) * Vector3::y() * blow.radius;
        let arm = before.world_from_body * arm;
        let twist = arm.cross(&(before.axis_3_world() * blow.impulse));
        let gained = after.angular_momentum_world(&moments) - before.angular_momentum_world(&moments);
        assert_relative_eq!(gained, twist, epsilon = ROUNDING * struck.angular_momentum_world().norm());
    }
    let blow = Blow { radius, impulse: 1e6 };
    for bad in [
        LaterBlow { time: f64::NAN, azimuth: 0.0, blow },
        LaterBlow { time: 1.0, azimuth: f64::INFINITY, blow },
        LaterBlow { time: 1.0, azimuth: 0.0, blow: Blow { radius: -1.0, ..blow } },
        LaterBlow { time: 1.0, azimuth: 0.0, blow: Blow { impulse: f64::NAN, ..blow } },
    ] {
        assert!(struck(1e6).struck_again(bad).is_err(), "{bad:?}");
    }
}

//! The pistons, and the balance of the engine.

use super::{ROUNDING, between, engine, numbers, pistons, plate, summed_momentum, thin};
use crate::printed::corrected_holds_and_printed_fails;
use approx::assert_relative_eq;
use mechanics::Rule;
use mechanics::scenes::wobble_plate::{Engine, in_room};
use nalgebra::Vector3;
use num_dual::DualNum;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

#[test]
fn the_torque_of_the_frame_is_the_rate_of_the_momentum_for_every_number_of_pistons() {
    let mut random = fastrand::Rng::with_seed(451);
    for count in 1..=7 {
        let (engine, spin, phase) = engine(&mut random, count);
        let h = 1e-5;
        let rate = (engine.angular_momentum(phase + h, spin) - engine.angular_momentum(phase - h, spin))
            * (spin / (2.0 * h));
        let size = spin * engine.angular_momentum(phase, spin).norm();
        assert_relative_eq!(engine.frame_torque(phase, spin), rate, epsilon = 1e-8 * size);
    }
}

#[test]
fn one_piston_shakes_along_the_shaft_with_its_mass_times_its_acceleration() {
    let (distance, tilt, spin, mass) = (0.07, 0.4_f64, 50.0, 0.3);
    let plate = thin(2.0, 0.1, tilt);
    let engine = Engine::new(plate, pistons(1, mass, distance, 0.2));
    // The piston stands at the azimuth −π/2, so its height is −r tan α sin ωt.
    for n in 0..20 {
        let phase = 0.3 * f64::from(n);
        let force = mass * spin * spin * distance * tilt.tan() * phase.sin();
        assert_relative_eq!(engine.shaking_force(phase, spin), force, epsilon = 1e-13 * mass * spin * spin);
    }
}

/// What the bearings give the plate, and what the walls give the pistons, N·m, when the rods slide without friction:
/// from the forces at each rod.
fn shares(engine: &Engine, phase: f64, spin: f64, distance: f64) -> (Vector3<f64>, Vector3<f64>) {
    let (tilt, mass, count) = (engine.plate().tilt(), engine.pistons().mass(), engine.pistons().count());
    let normal = in_room(&Vector3::new(-tilt.sin(), 0.0, tilt.cos()), phase);
    let (mut on_plate, mut rate) = (Vector3::zeros(), Vector3::zeros());
    for n in 1..=count {
        let azimuth = TAU * f64::from(n) / f64::from(count) - FRAC_PI_2;
        let (y, x) = azimuth.sin_cos();
        let place = Vector3::new(x, y, tilt.tan() * (azimuth - phase).cos()) * distance;
        let push = normal * (-mass * spin * spin * place.z / normal.z); // on the rod
        on_plate -= place.cross(&push);
        rate += Vector3::new(place.x, place.y, 0.0).cross(&(Vector3::z() * push.z));
    }
    let plate = in_room(&engine.plate().bearing_torque_rotating(spin), phase);
    (plate - on_plate, rate + on_plate)
}

#[test]
fn a_balanced_engine_leaves_bearings_and_walls_a_torque_each_that_cancel() {
    for tilt in [0.1_f64, 0.4, 1.0] {
        let plate = thin(2.0, 0.1, tilt);
        let pistons = pistons(5, 0.0, 0.07, 0.2);
        let needed = plate.balancing_mass(&pistons).unwrap();
        let alone = plate.bearing_torque_rotating(50.0).norm();
        for (part, on_bearings) in [(1.0, tilt.tan().powi(2)), (tilt.cos().powi(2), 0.0)] {
            let engine = Engine::new(plate, pistons.with_mass(part * needed).unwrap());
            let (bearings, walls) = shares(&engine, 0.7, 50.0, 0.07);
            assert_relative_eq!(bearings.norm(), on_bearings * alone, epsilon = 1e-12 * alone);
            let frame = engine.frame_torque(0.7, 50.0);
            assert_relative_eq!(bearings + walls, frame, epsilon = 1e-12 * alone);
            assert_relative_eq!(frame.norm(), (1.0 - part) * alone, epsilon = 1e-12 * alone);
        }
    }
}

#[test]
fn eq40_the_rods_touch_the_middle_plane_at_their_own_distance() {
    let mut random = fastrand::Rng::with_seed(40);
    for count in 1..=7 {
        let (engine, _, phase) = engine(&mut random, count);
        let tilt = engine.plate().tilt();
        let normal = in_room(&Vector3::new(-tilt.sin(), 0.0, tilt.cos()), phase);
        for n in 1..=count {
            let contact = engine.contact(n, phase);
            assert!(normal.dot(&contact).abs() < ROUNDING * (1.0 + tilt.tan()));
            // The same for every phase in x and y: the rod only slides along the shaft.
            assert_eq!(contact.xy(), engine.contact(n, 0.0).xy());
            let azimuth = TAU * f64::from(n) / f64::from(count) - FRAC_PI_2;
            let distance = contact.xy().norm();
            assert_relative_eq!(contact.x, distance * azimuth.cos(), epsilon = 1e-14);
            assert_relative_eq!(contact.y, distance * azimuth.sin(), epsilon = 1e-14);
        }
    }
}

#[test]
fn eq41_the_centres_hang_one_rod_below() {
    let mut random = fastrand::Rng::with_seed(41);
    let pistons = pistons(4, 1.0, 0.07, 0.2);
    let engine = Engine::new(plate(numbers(&mut random)), pistons);
    for n in 1..=4 {
        let step = engine.contact(n, 0.3) - engine.centre(n, 0.3);
        assert_relative_eq!(step, Vector3::new(0.0, 0.0, 0.2), epsilon = 1e-14);
    }
}

#[test]
fn eq42_the_velocity_is_the_derivative_of_the_height_and_the_motion_is_harmonic() {
    let mut random = fastrand::Rng::with_seed(42);
    for count in 1..=7 {
        let (engine, spin, phase) = engine(&mut random, count);
        let distance = engine.contact(1, 0.0).xy().norm();
        let slope = engine.plate().tilt().tan();
        for n in 1..=count {
            // The height by plane geometry, with dual numbers for its two derivatives in time.
            let azimuth = TAU * f64::from(n) / f64::from(count) - FRAC_PI_2;
            let height = |t: num_dual::Dual2_64| ((t * spin + phase - azimuth).cos()) * (distance * slope);
            let (value, velocity, acceleration) = num_dual::second_derivative(height, 0.0);
            let size = distance * slope;
            assert_relative_eq!(engine.contact(n, phase).z, value, epsilon = 1e-14 * size);
            assert_relative_eq!(engine.velocity(n, phase, spin), velocity, epsilon = 1e-14 * size * spin);
            assert_relative_eq!(
                engine.acceleration(n, phase, spin),
                acceleration,
                epsilon = 1e-14 * size * spin * spin
            );
        }
    }
}

/// The pistons' angular momentum, each a point, by `r × m v` with velocities from differences.
fn summed_pistons(engine: &Engine, phase: f64, spin: f64) -> Vector3<f64> {
    let h = 1e-6;
    (1..=engine.pistons().count())
        .map(|n| {
            let velocity = (engine.centre(n, phase + h) - engine.centre(n, phase - h)) * (spin / (2.0 * h));
            engine.centre(n, phase).cross(&velocity) * engine.pistons().mass()
        })
        .sum()
}

#[test]
fn eq43_the_momentum_of_the_pistons_turns_with_the_plate() {
    let mut random = fastrand::Rng::with_seed(43);
    for count in 1..=9 {
        let (engine, spin, phase) = engine(&mut random, count);
        let momentum = engine.piston_momentum(phase, spin);
        let size = spin * engine.pistons().mass() * engine.contact(1, 0.0).norm().powi(2);
        assert_relative_eq!(momentum, summed_pistons(&engine, phase, spin), epsilon = 1e-8 * size);
        if count >= 3 {
            let distance = engine.contact(1, 0.0).xy().norm();
            let half = 0.5 * f64::from(count) * engine.pistons().mass() * distance * distance;
            let along = half * spin * engine.plate().tilt().tan();
            let expected = in_room(&Vector3::new(along, 0.0, 0.0), phase);
            assert_relative_eq!(momentum, expected, epsilon = ROUNDING * along);
        }
    }
    // The third line, term by term: the y of one piston's momentum is −x m v, in units of m r²ω tan α.
    let plate = thin(2.0, 0.1, 0.4);
    let (distance, spin) = (0.07, 50.0);
    let engine = Engine::new(plate, pistons(4, 0.3, distance, 0.2));
    let unit = distance * distance * spin * plate.tilt().tan();
    let mut cases = Vec::new();
    for phase in [0.3_f64, 1.0, 2.5, 4.0] {
        let mut sums = [0.0; 2];
        for n in 1..=4 {
            let term = -engine.contact(n, phase).x * engine.velocity(n, phase, spin) / unit;
            let corrected = 0.5 * (phase.sin() + (f64::from(n) * PI - phase).sin());
            let printed = 0.5 * (phase.sin() - (f64::from(n) * PI - phase).sin());
            cases.push(((term - corrected).abs(), (term - printed).abs()));
            sums = [sums[0] + corrected, sums[1] + printed];
        }
        assert_relative_eq!(sums[1], sums[0], epsilon = 1e-14); // the slip cancels in the sum
    }
    corrected_holds_and_printed_fails(cases, 1e-14, 0.2);
}

#[test]
fn eq44_the_chain_of_equalities_holds_link_by_link() {
    let mut random = fastrand::Rng::with_seed(44);
    let cases: Vec<(f64, f64)> = (0..200)
        .map(|_| {
            let [mass, radius, _, tilt, spin] = numbers(&mut random);
            let thin = thin(mass, radius, tilt);
            let (unit, tangent) = (0.25 * mass * radius * radius * spin, tilt.tan());
            let beta = thin.momentum_angle();
            // The part across the shaft, added up over the mass.
            let across = summed_momentum([mass, radius, 0.0, tilt, spin], 0.3).xy().norm();
            let links = [
                unit * (tilt.sin().powi(2) + 4.0 * tilt.cos().powi(2)).sqrt() * beta.sin(),
                unit * tilt.cos() * (tangent * tangent + 4.0).sqrt() * tangent
                    / (tangent * tangent + (2.0 + tangent * tangent).powi(2)).sqrt(),
                unit * tilt.sin() * (tangent * tangent + 4.0).sqrt()
                    / ((4.0 + tangent * tangent) * (1.0 + tangent * tangent)).sqrt(),
                unit * tilt.sin() * tilt.cos(),
            ];
            for link in links {
                assert_relative_eq!(link, across, max_relative = 1e-11);
            }
            // Its first link: the whole momentum times sin β. Printed is the part across, times sin β once more.
            let corrected = thin.angular_momentum_body(spin).norm() * beta.sin();
            let printed = across * beta.sin();
            ((corrected / across - 1.0).abs(), (printed / across - 1.0).abs())
        })
        .collect();
    corrected_holds_and_printed_fails(cases, 1e-11, 0.1);
}

#[test]
fn eq45_and_eq02_the_balancing_mass_leaves_nothing_across_the_shaft() {
    let mut random = fastrand::Rng::with_seed(45);
    for count in 3..=9 {
        for thin in [true, false] {
            let mut numbers = numbers(&mut random);
            numbers[2] = if thin { 0.0 } else { 0.9 * numbers[1] };
            let [mass, radius, _, tilt, spin] = numbers;
            let distance = between(&mut random, 0.1, 0.9) * radius;
            let pistons = pistons(count, 0.0, distance, 0.1);
            let needed = plate(numbers).balancing_mass(&pistons).unwrap();
            let balanced = Engine::new(plate(numbers), pistons.with_mass(needed).unwrap());
            for n in 0..10 {
                let phase = f64::from(n) * 0.7;
                // Plate by its mass elements, pistons as points: neither uses the formulas of the library.
                let whole = summed_momentum(numbers, phase) + summed_pistons(&balanced, phase, spin);
                let across = whole.xy();
                assert_relative_eq!(
                    balanced.angular_momentum(phase, spin),
                    whole,
                    epsilon = 1e-7 * whole.norm()
                );
                let size = summed_momentum(numbers, phase).norm() * (1.0 + tilt.tan().powi(2));
                assert!(across.norm() < 1e-7 * size, "{count} pistons leave {across}");
                assert!(balanced.frame_torque(phase, spin).norm() < 1e-11 * size * spin);
            }
            if thin && count == 4 {
                let expected = mass * radius * radius * tilt.cos().powi(2) / (8.0 * distance * distance);
                assert_relative_eq!(needed, expected, max_relative = ROUNDING);
            }
        }
    }
}

#[test]
fn one_and_two_pistons_fail_and_three_to_nine_work() {
    let mut random = fastrand::Rng::with_seed(450);
    let thin = thin(2.0, 0.1, 0.4);
    for count in 1..=9 {
        let pistons = pistons(count, 1.0, 0.07, 0.2);
        // Whatever the mass, some phase has at least half of the plate's torque left for one and two pistons.
        let mut best = f64::INFINITY;
        for _ in 0..300 {
            let mass = between(&mut random, 0.01, 10.0);
            let engine = Engine::new(thin, pistons.with_mass(mass).unwrap());
            let worst = (0..64)
                .map(|n| engine.frame_torque(TAU * f64::from(n) / 64.0, 50.0).norm())
                .fold(0.0, f64::max);
            best = f64::min(best, worst / thin.bearing_torque_rotating(50.0).norm());
        }
        if count < 3 {
            assert!(best > 0.99, "{count} pistons leave {best}");
            let refused = thin.balancing_mass(&pistons).unwrap_err();
            assert_eq!((refused.value, refused.rule), (f64::from(count), Rule::AtLeast(3.0)));
        } else {
            assert!(best < 0.05, "{count} pistons leave {best}");
        }
    }
}

#[test]
fn three_and_more_pistons_shake_nothing_and_keep_their_energy() {
    let mut random = fastrand::Rng::with_seed(451);
    for count in 1..=9 {
        let (engine, spin, phase) = engine(&mut random, count);
        let distance = engine.contact(1, 0.0).xy().norm();
        let slope = engine.plate().tilt().tan();
        let mass = engine.pistons().mass();
        let force = mass * spin * spin * distance * slope;
        assert!(count == 1 || engine.shaking_force(phase, spin).abs() < 1e-13 * force * f64::from(count));
        let quarter = 0.25 * f64::from(count) * mass * (spin * distance * slope).powi(2);
        let energy = engine.piston_energy(phase, spin);
        let torque = engine.drive_torque(phase, spin);
        // The torque about the shaft is the rate of the energy over the spin, whatever the number.
        let h = 1e-5;
        let rate =
            (engine.piston_energy(phase + h, spin) - engine.piston_energy(phase - h, spin)) / (2.0 * h);
        assert_relative_eq!(torque, rate, epsilon = 1e-8 * quarter);
        if count >= 3 {
            assert_relative_eq!(energy, quarter, max_relative = ROUNDING);
            assert!(torque.abs() < ROUNDING * quarter);
        } else {
            let spread =
                (0..100).map(|n| engine.piston_energy(TAU * f64::from(n) / 100.0, spin)).fold(0.0, f64::max);
            assert!(spread > 1.9 * quarter);
        }
    }
}

#[test]
fn a_plate_as_thick_as_root_three_radii_needs_no_balance() {
    let radius = 0.1;
    let pistons = pistons(4, 1.0, 0.07, 0.2);
    let round = plate([2.0, radius, radius * 3_f64.sqrt() * (1.0 - 1e-15), 0.4, 0.0]);
    assert!(round.momentum_angle().abs() < 1e-14);
    assert!(round.balancing_mass(&pistons).unwrap().abs() < 1e-14);
    let thicker = plate([2.0, radius, 0.2, 0.4, 0.0]);
    assert!(thicker.momentum_angle() < 0.0);
    let refused = thicker.balancing_mass(&pistons).unwrap_err();
    assert!(matches!(refused.rule, Rule::NotAbove { .. }), "{refused}");
}

//! The wobble plate: equations (34) to (45), (1) and (2), each by a route that shares no code with it.

use approx::assert_relative_eq;
use mechanics::attitude::angle_between;
use mechanics::scenes::wobble_plate::{Engine, NoBalance, Pistons, Plate, in_room};
use nalgebra::Vector3;
use num_dual::{DualNum, first_derivative};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const ROUNDING: f64 = 1e-13;

fn between(random: &mut fastrand::Rng, low: f64, high: f64) -> f64 {
    low * (high / low).powf(random.f64())
}

/// Mass, radius, thickness, tilt and spin of any plate.
fn numbers(random: &mut fastrand::Rng) -> [f64; 5] {
    let radius = between(random, 0.01, 10.0);
    [
        between(random, 0.01, 100.0),
        radius,
        radius * random.f64(),
        1.5 * random.f64(),
        between(random, 0.1, 1e3),
    ]
}

/// Elements of mass of a plate that stands in the room at a phase, with Gauss's points along radius and thickness and equal
/// steps round the axis, which add up all squares exactly. Built from the cylinder and two plain rotations.
fn elements([mass, radius, thickness, tilt, _]: [f64; 5], phase: f64) -> Vec<(f64, Vector3<f64>)> {
    const GAUSS: [(f64, f64); 3] =
        [(-0.774_596_669_241_483_4, 5.0), (0.0, 8.0), (0.774_596_669_241_483_4, 5.0)];
    let mut elements = Vec::new();
    for (place_r, weight_r) in GAUSS {
        for (place_z, weight_z) in GAUSS {
            for n in 0..8 {
                let r = 0.5 * radius * (1.0 + place_r);
                let (sin, cos) = (TAU * f64::from(n) / 8.0).sin_cos();
                let flat = Vector3::new(r * cos, r * sin, 0.5 * thickness * place_z);
                // Tilt about y so that the normal leans towards −x, then turn about z.
                let (s, c) = tilt.sin_cos();
                let tilted = Vector3::new(c * flat.x - s * flat.z, flat.y, s * flat.x + c * flat.z);
                let (s, c) = phase.sin_cos();
                let turned = Vector3::new(c * tilted.x - s * tilted.y, s * tilted.x + c * tilted.y, tilted.z);
                elements.push((weight_r * weight_z * r, turned));
            }
        }
    }
    let total: f64 = elements.iter().map(|(weight, _)| weight).sum();
    elements.iter().map(|(weight, place)| (weight * mass / total, *place)).collect()
}

/// `Σ r × (ω × r) dm` in the room.
fn summed_momentum(numbers: [f64; 5], phase: f64) -> Vector3<f64> {
    let omega = Vector3::new(0.0, 0.0, numbers[4]);
    elements(numbers, phase).iter().map(|(mass, r)| r.cross(&omega.cross(r)) * *mass).sum()
}

fn plate([mass, radius, thickness, tilt, _]: [f64; 5]) -> Plate {
    Plate::thick(mass, radius, thickness, tilt).expect("a plate")
}

fn engine(random: &mut fastrand::Rng, count: u32) -> (Engine, f64, f64) {
    let pistons =
        Pistons::new(count, between(random, 0.01, 10.0), between(random, 0.01, 1.0), random.f64()).unwrap();
    let numbers = numbers(random);
    (Engine::new(plate(numbers), pistons), numbers[4], TAU * random.f64())
}

#[test]
fn eq34_and_eq35_the_moments_are_sums_over_the_mass() {
    let mut random = fastrand::Rng::with_seed(34);
    for _ in 0..100 {
        let [mass, radius, _, _, _] = numbers(&mut random);
        let thin = [mass, radius, 0.0, 0.0, 1.0];
        let sum = |distance: fn(&Vector3<f64>) -> f64| -> f64 {
            elements(thin, 0.0).iter().map(|(mass, r)| mass * distance(r)).sum()
        };
        let [about_1, about_2, about_3] = plate(thin).moments().to_array();
        assert_relative_eq!(about_3, sum(|r| r.x * r.x + r.y * r.y), max_relative = ROUNDING);
        assert_relative_eq!(about_3, 0.5 * mass * radius * radius, max_relative = ROUNDING); // (34)
        assert_relative_eq!(about_1, sum(|r| r.y * r.y + r.z * r.z), max_relative = ROUNDING);
        assert_relative_eq!(about_1, 0.25 * mass * radius * radius, max_relative = ROUNDING); // (35)
        assert_eq!(about_1, about_2);
    }
}

#[test]
fn eq36_the_spin_along_the_principal_axes_is_the_shaft_seen_from_the_plate() {
    let mut random = fastrand::Rng::with_seed(36);
    for _ in 0..100 {
        let numbers = numbers(&mut random);
        let [_, _, _, tilt, spin] = numbers;
        // The three axes as vectors of the rotating frame; î₂ = î₃ × î₁ must come out as y'.
        let third = Vector3::new(-tilt.sin(), 0.0, tilt.cos());
        let first = Vector3::new(tilt.cos(), 0.0, tilt.sin());
        assert_relative_eq!(third.cross(&first), Vector3::y(), epsilon = 1e-15);
        let shaft = Vector3::z() * spin;
        let expected = Vector3::new(shaft.dot(&first), shaft.y, shaft.dot(&third));
        assert_relative_eq!(plate(numbers).spin_body(spin), expected, epsilon = 1e-15 * spin);
        // For a diameter on the side of -x' the sign of the first component is the other one.
        let other = Vector3::new(tilt.cos(), 0.0, -tilt.sin());
        assert!(shaft.dot(&other) < 0.0);
    }
}

#[test]
fn eq37_the_momentum_along_the_principal_axes_is_the_sum_over_the_mass() {
    let mut random = fastrand::Rng::with_seed(37);
    for _ in 0..100 {
        let numbers = numbers(&mut random);
        let [_, _, _, tilt, spin] = numbers;
        let momentum = summed_momentum(numbers, 0.0);
        let third = Vector3::new(-tilt.sin(), 0.0, tilt.cos());
        let first = Vector3::new(tilt.cos(), 0.0, tilt.sin());
        let expected = Vector3::new(momentum.dot(&first), momentum.y, momentum.dot(&third));
        let found = plate(numbers).angular_momentum_body(spin);
        assert_relative_eq!(found, expected, epsilon = ROUNDING * momentum.norm());
    }
}

#[test]
fn the_momentum_in_the_room_is_the_sum_over_the_mass_and_leans_towards_the_normal() {
    let mut random = fastrand::Rng::with_seed(370);
    for _ in 0..100 {
        let numbers = numbers(&mut random);
        let [mass, radius, thickness, tilt, spin] = numbers;
        let phase = TAU * random.f64();
        let momentum = summed_momentum(numbers, phase);
        let rotating = plate(numbers).angular_momentum_rotating(spin);
        assert_relative_eq!(in_room(&rotating, phase), momentum, epsilon = ROUNDING * momentum.norm());
        let difference = mass * (radius * radius / 4.0 - thickness * thickness / 12.0);
        let across = -difference * tilt.sin() * tilt.cos() * spin;
        assert_relative_eq!(rotating.x, across, max_relative = 1e-12);
        assert!(rotating.x < 0.0); // the normal leans towards −x'
        // (44) writes this part as L sin β with the momentum of the plate.
        assert_relative_eq!(
            -rotating.x,
            rotating.norm() * plate(numbers).momentum_angle().sin(),
            max_relative = 1e-12
        );
    }
}

#[test]
fn eq38_the_momentum_leans_by_beta_from_the_shaft() {
    let mut random = fastrand::Rng::with_seed(38);
    for _ in 0..200 {
        let numbers = numbers(&mut random);
        let momentum = summed_momentum(numbers, TAU * random.f64());
        let expected = angle_between(&momentum, &Vector3::z());
        assert_relative_eq!(plate(numbers).momentum_angle(), expected, epsilon = 1e-14);
        // Between shaft and normal.
        assert!((0.0..=numbers[3]).contains(&plate(numbers).momentum_angle()));
    }
}

#[test]
fn eq39_and_eq01_the_tangent_of_beta_for_a_thin_plate() {
    for degrees in 1..90 {
        let tilt = f64::from(degrees).to_radians();
        let thin = [2.0, 0.1, 0.0, tilt, 30.0];
        let momentum = summed_momentum(thin, 0.0);
        let tangent = tilt.tan() / (2.0 + tilt.tan().powi(2));
        assert_relative_eq!(-momentum.x / momentum.z, tangent, max_relative = 1e-11);
        assert_relative_eq!(plate(thin).momentum_angle().tan(), tangent, max_relative = 1e-13);
    }
    // Small tilts keep their digits: β = α/2 − α³/8 + …
    for exponent in -49..-4 {
        let tilt = 10_f64.powi(exponent);
        let beta = Plate::thin(1.0, 1.0, tilt).unwrap().momentum_angle();
        let expected = 0.5 * tilt - 0.125 * tilt.powi(3);
        assert_relative_eq!(beta, expected, max_relative = 4.0 * f64::EPSILON);
    }
    // So do tilts near a right angle: with γ = π/2 − α, β = γ − 2γ³ + …
    for exponent in -8..-3 {
        let tilt = FRAC_PI_2 - 10_f64.powi(exponent);
        let gap = (FRAC_PI_2 - tilt) + 6.123_233_995_736_766e-17; // π/2 less its f64
        let beta = Plate::thin(1.0, 1.0, tilt).unwrap().momentum_angle();
        let expected = gap - 2.0 * gap.powi(3);
        assert_relative_eq!(beta, expected, max_relative = 4.0 * f64::EPSILON);
    }
}

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
    let plate = Plate::thin(2.0, 0.1, tilt).unwrap();
    let engine = Engine::new(plate, Pistons::new(1, mass, distance, 0.2).unwrap());
    // The piston stands at the azimuth −π/2, so its height is −r tan α sin ωt.
    for n in 0..20 {
        let phase = 0.3 * f64::from(n);
        let force = mass * spin * spin * distance * tilt.tan() * phase.sin();
        assert_relative_eq!(engine.shaking_force(phase, spin), force, epsilon = 1e-13 * mass * spin * spin);
    }
}

/// What the bearings give the plate, and what the walls give the pistons, N·m, when the rods slide without friction: from
/// the forces at each rod.
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
        let plate = Plate::thin(2.0, 0.1, tilt).unwrap();
        let pistons = Pistons::new(5, 0.0, 0.07, 0.2).unwrap();
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
fn eq39_beta_has_its_maximum_where_its_derivative_vanishes() {
    let beta = |tilt: f64, slope: bool| {
        let (value, derivative) = first_derivative(
            |alpha| {
                let tangent = alpha.tan();
                (tangent / (tangent * tangent + 2.0)).atan()
            },
            tilt,
        );
        if slope { derivative } else { value }
    };
    let (largest, at) = Plate::thin(1.0, 1.0, 0.1).unwrap().largest_momentum_angle();
    assert!(beta(at, true).abs() < 1e-15);
    assert_relative_eq!(beta(at, false), largest, max_relative = 1e-15);
    assert_relative_eq!(largest, (1.0_f64 / 3.0).asin(), max_relative = 1e-15);
    assert_relative_eq!(at.tan(), 2_f64.sqrt(), max_relative = 1e-15);
    // Thick plates: no tilt of a fine grid gives more.
    let mut random = fastrand::Rng::with_seed(39);
    for _ in 0..20 {
        let [mass, radius, thickness, _, _] = numbers(&mut random);
        let (largest, at) = plate([mass, radius, thickness, 0.3, 0.0]).largest_momentum_angle();
        let angle = |tilt: f64| plate([mass, radius, thickness, tilt, 0.0]).momentum_angle();
        assert_relative_eq!(angle(at), largest, max_relative = 1e-13);
        assert!((0..1000).all(|n| angle(FRAC_PI_2 * f64::from(n) / 1000.0) <= largest * (1.0 + 1e-14)));
    }
}

#[test]
fn the_bearing_torque_is_the_rate_of_the_summed_momentum() {
    let mut random = fastrand::Rng::with_seed(390);
    for _ in 0..100 {
        let numbers = numbers(&mut random);
        let [mass, radius, _, tilt, spin] = numbers;
        let (phase, h) = (TAU * random.f64(), 1e-5);
        let rate =
            (summed_momentum(numbers, phase + h) - summed_momentum(numbers, phase - h)) * (spin / (2.0 * h));
        let torque = in_room(&plate(numbers).bearing_torque_rotating(spin), phase);
        assert_relative_eq!(
            torque,
            rate,
            epsilon = 1e-8 * (torque.norm() + spin * summed_momentum(numbers, phase).norm())
        );
        let thin = Plate::thin(mass, radius, tilt).unwrap().bearing_torque_rotating(spin).norm();
        let expected = 0.125 * mass * radius * radius * spin * spin * (2.0 * tilt).sin();
        assert_relative_eq!(thin, expected, max_relative = 1e-12);
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
    let pistons = Pistons::new(4, 1.0, 0.07, 0.2).unwrap();
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
}

#[test]
fn eq43_the_printed_third_line_has_a_wrong_sign_that_cancels_in_the_sum() {
    for phase in [0.3_f64, 1.0, 2.5] {
        let mut sums = [0.0; 2];
        for n in 1..=4 {
            let azimuth = f64::from(n) * FRAC_PI_2;
            let second_line = azimuth.sin() * (azimuth - phase).cos();
            let corrected = 0.5 * (phase.sin() + (f64::from(n) * PI - phase).sin());
            let printed = 0.5 * (phase.sin() - (f64::from(n) * PI - phase).sin());
            assert_relative_eq!(second_line, corrected, epsilon = 1e-15);
            assert!((second_line - printed).abs() > 0.2, "the printed term would be {printed}");
            sums[0] += corrected;
            sums[1] += printed;
        }
        assert_relative_eq!(sums[0], 2.0 * phase.sin(), epsilon = 1e-14);
        assert_relative_eq!(sums[1], sums[0], epsilon = 1e-14);
    }
}

#[test]
fn eq44_the_chain_of_equalities_holds_link_by_link() {
    let mut random = fastrand::Rng::with_seed(44);
    for _ in 0..200 {
        let [mass, radius, _, tilt, spin] = numbers(&mut random);
        let thin = Plate::thin(mass, radius, tilt).unwrap();
        let (unit, tangent) = (0.25 * mass * radius * radius * spin, tilt.tan());
        let beta = thin.momentum_angle();
        let links = [
            thin.angular_momentum_body(spin).norm() * beta.sin(),
            unit * (tilt.sin().powi(2) + 4.0 * tilt.cos().powi(2)).sqrt() * beta.sin(),
            unit * tilt.cos() * (tangent * tangent + 4.0).sqrt() * tangent
                / (tangent * tangent + (2.0 + tangent * tangent).powi(2)).sqrt(),
            unit * tilt.sin() * (tangent * tangent + 4.0).sqrt()
                / ((4.0 + tangent * tangent) * (1.0 + tangent * tangent)).sqrt(),
            unit * tilt.sin() * tilt.cos(),
        ];
        for link in links {
            assert_relative_eq!(link, -thin.angular_momentum_rotating(spin).x, max_relative = 1e-11);
        }
    }
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
            let pistons = Pistons::new(count, 0.0, distance, 0.1).unwrap();
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
    let thin = Plate::thin(2.0, 0.1, 0.4).unwrap();
    for count in 1..=9 {
        let pistons = Pistons::new(count, 1.0, 0.07, 0.2).unwrap();
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
            assert_eq!(thin.balancing_mass(&pistons), Err(NoBalance::TooFewPistons { count }));
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
    let pistons = Pistons::new(4, 1.0, 0.07, 0.2).unwrap();
    let round = Plate::thick(2.0, radius, radius * 3_f64.sqrt() * (1.0 - 1e-15), 0.4).unwrap();
    assert!(round.momentum_angle().abs() < 1e-14);
    assert!(round.balancing_mass(&pistons).unwrap().abs() < 1e-14);
    let thicker = Plate::thick(2.0, radius, 0.2, 0.4).unwrap();
    assert!(thicker.momentum_angle() < 0.0);
    assert!(matches!(thicker.balancing_mass(&pistons), Err(NoBalance::ThickPlate { .. })));
}

#[test]
fn another_mass_leaves_everything_else_of_the_pistons_as_it_was() {
    let pistons = Pistons::new(5, 0.3, 0.07, 0.2).unwrap();
    assert_eq!(pistons.with_mass(0.8), Pistons::new(5, 0.8, 0.07, 0.2));
}

//! The plate: moments, momentum, its lean, and the torque of the bearings.

use super::{ROUNDING, elements, numbers, plate, summed_momentum, thin};
use approx::assert_relative_eq;
use mechanics::attitude::angle_between;
use mechanics::scenes::wobble_plate::{LargestMomentumAngle, in_room};
use nalgebra::Vector3;
use num_dual::{DualNum, first_derivative};
use std::f64::consts::{FRAC_PI_2, TAU};

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
        let beta = thin(1.0, 1.0, tilt).momentum_angle();
        let expected = 0.5 * tilt - 0.125 * tilt.powi(3);
        assert_relative_eq!(beta, expected, max_relative = 4.0 * f64::EPSILON);
    }
    // So do tilts near a right angle: with γ = π/2 − α, β = γ − 2γ³ + …
    for exponent in -8..-3 {
        let tilt = FRAC_PI_2 - 10_f64.powi(exponent);
        let gap = (FRAC_PI_2 - tilt) + 6.123_233_995_736_766e-17; // π/2 less its f64
        let beta = thin(1.0, 1.0, tilt).momentum_angle();
        let expected = gap - 2.0 * gap.powi(3);
        assert_relative_eq!(beta, expected, max_relative = 4.0 * f64::EPSILON);
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
    let LargestMomentumAngle { momentum_angle: largest, tilt: at } =
        thin(1.0, 1.0, 0.1).largest_momentum_angle();
    assert!(beta(at, true).abs() < 1e-15);
    assert_relative_eq!(beta(at, false), largest, max_relative = 1e-15);
    assert_relative_eq!(largest, (1.0_f64 / 3.0).asin(), max_relative = 1e-15);
    assert_relative_eq!(at.tan(), 2_f64.sqrt(), max_relative = 1e-15);
    // Thick plates: no tilt of a fine grid gives more.
    let mut random = fastrand::Rng::with_seed(39);
    for _ in 0..20 {
        let [mass, radius, thickness, _, _] = numbers(&mut random);
        let LargestMomentumAngle { momentum_angle: largest, tilt: at } =
            plate([mass, radius, thickness, 0.3, 0.0]).largest_momentum_angle();
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
        let thin = thin(mass, radius, tilt).bearing_torque_rotating(spin).norm();
        let expected = 0.125 * mass * radius * radius * spin * spin * (2.0 * tilt).sin();
        assert_relative_eq!(thin, expected, max_relative = 1e-12);
    }
}

//! What a wobble makes of its start: also where the motion is unstable, and where it would take for ever.

use mechanics::integrate::{Failure, Taylor};
use mechanics::nalgebra::Complex;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::{Wheel, Wobble};
use mechanics::{Error, InvalidQuantity, Rule};
use std::f64::consts::FRAC_PI_2;

const UPRIGHT: Rolling =
    Rolling { heading: 0.4, roll_angle: -0.7, centre: Complex::new(0.3, -0.1), ..Rolling::UPRIGHT };

/// A wheel in units in which mass, radius and gravity are one.
fn wheel(moments: MomentFactors) -> Wheel {
    Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 }).expect("a wheel")
}

fn disc() -> Wheel {
    wheel(MomentFactors::DISK)
}

fn wobble(wheel: &Wheel, start: Rolling, tolerance: f64) -> Result<Wobble, Error> {
    wheel.wobble(start, &Taylor::new(tolerance).expect("a tolerance"))
}

#[test]
fn a_wobble_begins_with_its_start_to_rounding_even_next_to_an_unstable_motion() {
    let mut random = fastrand::Rng::with_seed(41);
    for n in 0..300 {
        // Upright and slow, pushed by hardly anything; and anything.
        let mut small = || 10_f64.powf(-30.0 * random.f64()) * if random.bool() { 1.0 } else { -1.0 };
        let start = match n % 3 {
            0 => Rolling { omega_1: small(), omega_3: 0.1 * small(), ..UPRIGHT },
            1 => Rolling {
                tilt: FRAC_PI_2 - small(),
                omega_1: small(),
                omega_2: small(),
                omega_3: 0.3,
                ..UPRIGHT
            },
            _ => Rolling {
                tilt: FRAC_PI_2 - 1.5 * small(),
                omega_1: small(),
                omega_2: small(),
                omega_3: 3.0,
                ..UPRIGHT
            },
        };
        let Ok(wobble) = wobble(&disc(), start, 1e-16) else { continue };
        let found = wobble.at(0.0).unwrap();
        for (found, given) in found.to_array().into_iter().zip(start.to_array()).take(6) {
            assert!((found - given).abs() <= 1e-15 * given.abs(), "{found:e} for {given:e} of {start:?}");
        }
        assert!((found.centre - start.centre).norm() < 1e-15, "{} for {}", found.centre, start.centre);
        assert_eq!(wobble.sample(&[0.0]).unwrap(), [found]);
    }
}

#[test]
fn the_period_of_a_wheel_that_falls_from_all_but_upright_grows_by_the_logarithm_of_what_is_left() {
    // Small leans obey (1 + k/2) θ̈ = (1 − 2(1 + k) n²) θ, and four times in a wobble the way goes from the least to
    // the largest.
    let period = |push: f64, along: f64| {
        wobble(&disc(), Rolling { omega_1: push, omega_3: along, ..UPRIGHT }, 1e-16).unwrap().period()
    };
    for along in [0.1, 0.2, 0.5] {
        let growth = ((1.0 - 3.0 * along * along) / 1.25_f64).sqrt();
        for (more, less) in [(1e-10, 1e-14), (1e-12, 1e-13), (1e-14, 1e-40)] {
            let longer = period(less, along) - period(more, along);
            let expected = 4.0 * f64::ln(more / less) / growth;
            assert!((longer / expected - 1.0).abs() < 1e-12, "along {along}: {longer} and not {expected}");
        }
    }
}

#[test]
fn whirls_that_would_take_for_ever_are_given_up_or_followed_as_the_caller_says() {
    // Almost without moments a wheel turns back almost flat, after π√(2/k) of whirling.
    let falling = |k: f64| {
        let start = Rolling { tilt: FRAC_PI_2 - 0.3, omega_2: 1e-3, ..UPRIGHT };
        (wheel(MomentFactors::flat(k)), start)
    };
    for k in [1e-20, 1e-41] {
        let (wheel, start) = falling(k);
        let Err(refused) = wobble(&wheel, start, 1e-16) else { panic!("a whirl without end") };
        // Within the hundred thousand series that a solver allows, a fraction of a second.
        assert!(
            matches!(
                refused,
                Error::Integration(Failure::TooMuchWork { .. } | Failure::StepUnderflow { .. })
            ),
            "{refused}"
        );
    }
    let (wheel, start) = falling(1e-9);
    let by = |most: usize| wheel.wobble(start, &Taylor::new(1e-16).unwrap().with_max_expansions(most));
    assert!(matches!(by(1000), Err(Error::Integration(Failure::TooMuchWork { evaluations: 1000, .. }))));
    let wobble = by(100_000).unwrap();
    assert!((wobble.heading_advance() / wheel.near_flat_turn() - 1.0).abs() < 1e-2);
}

#[test]
fn a_tolerance_without_sense_is_refused() {
    let start = Rolling { tilt: FRAC_PI_2 - 0.3, omega_2: 0.45, omega_3: 0.9, ..UPRIGHT };
    assert!(wobble(&disc(), start, 1.0).is_ok());
    for tolerance in [1.1, 1e10, 1e300] {
        let refused = wobble(&disc(), start, tolerance).unwrap_err();
        let rule = Rule::AtMost(1.0);
        let (quantity, value, unit) = ("tolerance", tolerance, "");
        assert_eq!(refused, Error::Quantity(InvalidQuantity { quantity, value, unit, rule }));
    }
}

#[test]
fn the_energy_is_that_of_centre_turning_and_height() {
    let (mass, radius, gravity) = (2.5, 0.3, 9.81);
    let moments = MomentFactors { transverse: 0.6, axial: 0.7 };
    let wheel = Wheel::new(DiskParameters { mass, radius, moments, gravity }).unwrap();
    let mut random = fastrand::Rng::with_seed(4);
    for _ in 0..100 {
        let mut number = || 3.0 * random.f64() - 1.5;
        let mut state = Rolling::from_array(std::array::from_fn(|_| number()));
        state.tilt += FRAC_PI_2;
        let Rolling { omega_1, omega_2, omega_3, .. } = state;
        // The point of contact is at rest, a below the centre along axis 2.
        let centre = 0.5 * mass * radius * radius * (omega_1 * omega_1 + omega_3 * omega_3);
        let [transverse, axial] = [0.6, 0.7].map(|factor| factor * mass * radius * radius);
        let turning =
            0.5 * transverse * (omega_1 * omega_1 + omega_2 * omega_2) + 0.5 * axial * omega_3 * omega_3;
        let expected = centre + turning + mass * gravity * radius * state.lean().cos();
        assert!((wheel.energy(&state) / expected - 1.0).abs() < 1e-14, "{state:?}");
    }
}

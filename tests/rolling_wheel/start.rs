//! What a wobble makes of its start: also where the motion is unstable, and where it would take for ever.

use mechanics::integrate::{Failure, InvalidTolerance, Taylor};
use mechanics::scenes::rolling_wheel::{NoWobble, Rolling, Wheel};

const UPRIGHT: Rolling = Rolling {
    lean: 0.0,
    lean_rate: 0.0,
    across: 0.0,
    along: 0.0,
    heading: 0.4,
    spin: -0.7,
    centre: [0.3, -0.1],
};

/// A disc in units in which mass, radius and gravity are one.
fn disc() -> Wheel {
    Wheel::new(1.0, 1.0, 0.5, 1.0).expect("a disc")
}

#[test]
fn a_wobble_begins_with_its_start_to_rounding_even_next_to_an_unstable_motion() {
    let mut random = fastrand::Rng::with_seed(41);
    for n in 0..300 {
        // Upright and slow, pushed by hardly anything; and anything.
        let mut small = || 10_f64.powf(-30.0 * random.f64()) * if random.bool() { 1.0 } else { -1.0 };
        let start = match n % 3 {
            0 => Rolling { lean_rate: small(), along: 0.1 * small(), ..UPRIGHT },
            1 => Rolling { lean: small(), lean_rate: small(), across: small(), along: 0.3, ..UPRIGHT },
            _ => Rolling { lean: 1.5 * small(), lean_rate: small(), across: small(), along: 3.0, ..UPRIGHT },
        };
        let Ok(wobble) = disc().wobble(start, 1e-16) else { continue };
        let found = wobble.at(0.0).unwrap();
        for (found, given) in found.to_array().into_iter().zip(start.to_array()).take(6) {
            assert!((found - given).abs() <= 1e-15 * given.abs(), "{found:e} for {given:e} of {start:?}");
        }
        for (found, given) in found.centre.into_iter().zip(start.centre) {
            assert!((found - given).abs() < 1e-15, "{found} for {given}");
        }
        let mut frame = [UPRIGHT];
        wobble.fill(&[0.0], &mut frame).unwrap();
        assert_eq!((frame[0], wobble.sample(&[0.0]).unwrap()[0]), (found, found));
    }
}

#[test]
fn the_period_of_a_wheel_that_falls_from_all_but_upright_grows_by_the_logarithm_of_what_is_left() {
    // Small leans obey (1 + k/2) θ̈ = (1 − 2(1 + k) n²) θ, and four times in a wobble the way goes from the least to the largest.
    let period = |push: f64, along: f64| {
        let wobble = disc().wobble(Rolling { lean_rate: push, along, ..UPRIGHT }, 1e-16).unwrap();
        wobble.period()
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
        let start = Rolling { lean: 0.3, across: 1e-3, ..UPRIGHT };
        (Wheel::new(1.0, 1.0, k, 1.0).expect("a wheel"), start)
    };
    for k in [1e-12, 1e-41] {
        let (wheel, start) = falling(k);
        let refused = wheel.wobble(start, 1e-16).unwrap_err();
        let NoWobble::Integration(Failure::TooMuchWork { evaluations, .. }) = refused else {
            panic!("{refused}")
        };
        assert!(evaluations <= 50_000, "{evaluations} series, a fraction of a second");
    }
    let (wheel, start) = falling(1e-9);
    let by = |most: usize| wheel.wobble_by(start, &Taylor::new(1e-16).unwrap().with_max_expansions(most));
    assert!(matches!(by(1000), Err(NoWobble::Integration(Failure::TooMuchWork { evaluations: 1000, .. }))));
    let wobble = by(100_000).unwrap();
    assert!((wobble.heading_advance() / wheel.near_flat_turn() - 1.0).abs() < 1e-2);
}

#[test]
fn a_tolerance_without_sense_is_refused() {
    let start = Rolling { lean: 0.3, across: 0.45, along: 0.9, ..UPRIGHT };
    assert!(disc().wobble(start, 1.0).is_ok());
    for tolerance in [1.1, 1e10, 1e300] {
        let refused = disc().wobble(start, tolerance).unwrap_err();
        assert!(matches!(refused, NoWobble::Tolerance(InvalidTolerance::TooLoose { .. })), "{refused}");
        assert!(refused.to_string().ends_with("is too large; it must be at most 1e0"), "{refused}");
    }
}

#[test]
fn the_moment_factor_is_at_most_one() {
    let message = Wheel::new(1.0, 1.0, 1.0 + 1e-15, 9.81).unwrap_err().to_string();
    assert!(
        message.starts_with("moment factor k 1.000000000000001 is too large; it must be at most 1"),
        "{message}"
    );
    assert_eq!(Wheel::new(2.5, 1.0, 1.0, 9.81).unwrap().mass(), 2.5);
}

#[test]
fn the_energy_is_that_of_centre_turning_and_height() {
    let (mass, radius, factor, gravity) = (2.5, 0.3, 0.7, 9.81);
    let wheel = Wheel::new(mass, radius, factor, gravity).unwrap();
    let mut random = fastrand::Rng::with_seed(4);
    for _ in 0..100 {
        let mut number = || 3.0 * random.f64() - 1.5;
        let [lean, lean_rate, across, along, heading, spin, x, y] = std::array::from_fn(|_| number());
        let state = Rolling { lean, lean_rate, across, along, heading, spin, centre: [x, y] };
        // The point of contact is at rest, a below the centre along axis 2.
        let centre = 0.5 * mass * radius * radius * (lean_rate * lean_rate + along * along);
        let axial = factor * mass * radius * radius;
        let turning = 0.25 * axial * (lean_rate * lean_rate + across * across) + 0.5 * axial * along * along;
        let expected = centre + turning + mass * gravity * radius * lean.cos();
        assert!((wheel.energy(&state) / expected - 1.0).abs() < 1e-14, "{state:?}");
    }
}

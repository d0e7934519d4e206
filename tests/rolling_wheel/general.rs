//! The general motion: against the whole body with its contact force, against its constants, and against references.

use super::whole_body::{State, axle, placed, solve, solve_slowed};
use super::{GRAVITY, MASS, RADIUS, parameters, wheel};
use crate::common::any;
use approx::assert_relative_eq;
use mechanics::integrate::{Dop853, Taylor};
use mechanics::nalgebra::Complex;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::{Error, Rule};
use serde_json::Value;
use std::f64::consts::FRAC_PI_2;

pub(crate) fn start(random: &mut fastrand::Rng) -> Rolling {
    let mut number = |size: f64| size * (2.0 * random.f64() - 1.0);
    Rolling {
        tilt: FRAC_PI_2 - number(0.9),
        omega_1: number(2.0),
        omega_2: number(5.0),
        omega_3: number(8.0),
        heading: number(3.0),
        roll_angle: 0.0,
        centre: Complex::new(number(1.0), number(1.0)),
    }
}

/// A disc in units in which mass, radius and gravity are one.
fn disc() -> Wheel {
    let moments = MomentFactors::DISK;
    Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 }).expect("a disc")
}

fn taylor(tolerance: f64) -> Taylor {
    Taylor::new(tolerance).expect("a tolerance")
}

/// Hoop, disc, something flat between, and two that are not flat: a wheel with a hub, and one with a long axle.
const MOMENTS: [MomentFactors; 5] = [
    MomentFactors::HOOP,
    MomentFactors::DISK,
    MomentFactors::flat(0.3),
    MomentFactors { transverse: 0.5, axial: 0.7 },
    MomentFactors { transverse: 2.0 / 3.0, axial: 1.0 / 3.0 },
];

/// The whole body in that state.
fn whole(state: &Rolling) -> State {
    placed(state.lean(), state.heading, [state.omega_1, state.omega_2, state.omega_3], state.centre)
}

/// The state that the rates of the library lead to in six tenths of a second, and that of the whole body, which must
/// agree; nothing where the wheel lies almost flat by then.
pub(crate) fn as_the_whole_body(
    state: &Rolling,
    reduced: impl FnMut(f64, &[f64; 8]) -> [f64; 8],
    judge: impl FnMut(f64, &State) -> State,
) -> Option<(Rolling, State)> {
    let solver = Dop853::new(1e-12).unwrap();
    let reduced = Rolling::from_array(solver.solve(any(reduced), 0.0, state.to_array(), 0.6).ok()?.state);
    if reduced.lean().abs() > 1.4 {
        return None;
    }
    let judge = solver.solve(any(judge), 0.0, whole(state), 0.6).unwrap().state;
    assert_relative_eq!(reduced.lean(), (-axle(&judge).z).asin(), epsilon = 1e-8);
    assert_relative_eq!(reduced.centre.re, judge[0], epsilon = 1e-8);
    assert_relative_eq!(reduced.centre.im, judge[1], epsilon = 1e-8);
    Some((reduced, judge))
}

#[test]
fn the_reduced_motion_is_that_of_the_whole_body_and_so_is_the_contact_force() {
    let mut random = fastrand::Rng::with_seed(72);
    let mut compared = 0;
    for n in 0..60 {
        let moments = MOMENTS[n % 5];
        let wheel = Wheel::new(parameters(moments)).unwrap();
        let rates = |t: f64, y: &[f64; 8]| wheel.rates(t, y);
        let judge = |_: f64, y: &State| solve(moments, y).0;
        let Some((reduced, judge)) = as_the_whole_body(&start(&mut random), rates, judge) else { continue };
        let (_, force) = solve(moments, &judge);
        let size = MASS * GRAVITY + force.norm();
        assert_relative_eq!(wheel.normal_force(&reduced), force.z, epsilon = 1e-7 * size);
        assert_relative_eq!(wheel.contact_force(&reduced).norm(), force.norm(), epsilon = 1e-7 * size);
        compared += 1;
    }
    assert!(compared > 40, "{compared}");
}

#[test]
fn a_wheel_that_slows_down_is_the_whole_body_with_that_torque_and_loses_its_power() {
    let mut random = fastrand::Rng::with_seed(74);
    let mut compared = 0;
    for n in 0..60 {
        let moments = MOMENTS[n % 5];
        let wheel = Wheel::new(parameters(moments)).unwrap();
        let (state, slowing) = (start(&mut random), 2.0 * random.f64());
        let rates = wheel.slowed_rates(slowing);
        let judge = |_: f64, y: &State| solve_slowed(moments, slowing, y).0;
        if as_the_whole_body(&state, rates, judge).is_none() {
            continue;
        }
        // The power, from the energy a moment later and a moment before.
        let h = 1e-4;
        let energy = |time: f64| {
            let end = Dop853::new(1e-12).unwrap().solve(any(rates), 0.0, state.to_array(), time).unwrap();
            wheel.energy(&Rolling::from_array(end.state))
        };
        let square = state.omega_1.powi(2) + state.omega_2.powi(2) + state.omega_3.powi(2);
        let power = (energy(h) - energy(-h)) / (2.0 * h);
        assert_relative_eq!(power, -slowing * MASS * RADIUS * RADIUS * square, max_relative = 1e-5);
        compared += 1;
    }
    assert!(compared > 40, "{compared}");
}

#[test]
fn energy_and_both_constants_stay() {
    let mut random = fastrand::Rng::with_seed(73);
    for n in 0..60 {
        let wheel = Wheel::new(parameters(MOMENTS[n % 5])).unwrap();
        let state = start(&mut random);
        let solver = Dop853::new(1e-13).unwrap();
        let Ok(end) = solver.solve(any(|t, y: &[f64; 8]| wheel.rates(t, y)), 0.0, state.to_array(), 2.0)
        else {
            continue;
        };
        let end = Rolling::from_array(end.state);
        assert_relative_eq!(wheel.energy(&end), wheel.energy(&state), max_relative = 1e-9);
        let (before, after) = (wheel.constants(&state), wheel.constants(&end));
        let size = 1.0 + before.even.abs() + before.odd.abs();
        assert!(
            (after.even - before.even).abs() < 1e-9 * size && (after.odd - before.odd).abs() < 1e-9 * size
        );
        let there = wheel.at_tilt(&before, end.tilt);
        assert_relative_eq!(there.omega_2, end.omega_2, epsilon = 1e-8 * size);
        assert_relative_eq!(there.omega_3, end.omega_3, epsilon = 1e-8 * size);
        // The potential is the energy without the rate of lean.
        let rest = Rolling { omega_1: 0.0, ..end };
        assert_relative_eq!(wheel.potential(&before, end.tilt), wheel.energy(&rest), max_relative = 1e-8);
    }
}

#[test]
fn the_reference_wobble_is_met_to_the_digits_of_a_double() {
    let file: Value = serde_json::from_str(include_str!("../data/rolling-disk.json")).expect("a valid file");
    let value = |name: &str| file["values"][name].as_str().unwrap().parse::<f64>().unwrap();
    let disc = disc();
    let state = Rolling { tilt: FRAC_PI_2 - 0.3, omega_2: 0.45, omega_3: 0.9, ..Rolling::UPRIGHT };
    let constants = disc.constants(&state);
    assert_relative_eq!(constants.even, value("Chaplygin_A"), max_relative = 1e-15);
    assert_relative_eq!(constants.odd, value("Chaplygin_B"), max_relative = 1e-15);
    assert_relative_eq!(disc.energy(&state), value("energy"), max_relative = 1e-15);
    let wobble = disc.wobble(state, &taylor(1e-16)).unwrap();
    assert_relative_eq!(wobble.period(), value("nutation_period"), max_relative = 1e-15);
    assert_relative_eq!(
        wobble.heading_advance(),
        value("azimuth_advance_per_nutation"),
        max_relative = 1e-15
    );
    assert_relative_eq!(wobble.roll_advance(), value("psi_advance"), max_relative = 1e-15);
    let after = wobble.sample(&[wobble.period(), 0.5 * wobble.period()]).unwrap();
    assert_relative_eq!(after[0].centre.re, value("centre_dx"), max_relative = 1e-15);
    assert_relative_eq!(after[0].centre.im, value("centre_dy"), max_relative = 1e-15);
    assert_relative_eq!(after[1].lean(), value("theta_other_turning_point"), max_relative = 1e-15);
    assert_relative_eq!(after[1].omega_3, value("n_at_other_turning_point"), max_relative = 1e-15);
    assert_relative_eq!(after[1].omega_2, value("q_at_other_turning_point"), max_relative = 1e-15);
}

#[test]
fn a_wobble_is_found_by_series_with_few_terms_of_use() {
    // Loose tolerances make steps longer than half a wobble.
    let mut random = fastrand::Rng::with_seed(13);
    for _ in 0..200 {
        let wheel = wheel(0.5);
        let mut state = start(&mut random);
        state.omega_3 += 8.0_f64.copysign(state.omega_3); // fast enough for a wobble that is nearly harmonic
        let [loose, tight] =
            [0.1, 1e-13].map(|tolerance| wheel.wobble(state, &taylor(tolerance)).unwrap().period());
        assert_relative_eq!(loose, tight, max_relative = 0.1);
    }
}

#[test]
fn a_billion_wobbles_leave_the_phase_its_digits() {
    // In units in which the time is not rounded, from a moment at which the lean turns.
    let disc = disc();
    let state = Rolling { omega_1: 0.0, tilt: FRAC_PI_2 - 0.6, ..disc.steady(0.5, 3.0).unwrap().state() };
    let wobble = disc.wobble(state, &taylor(1e-16)).unwrap();
    for count in [1e3, 1e6, 1e9, -1e9] {
        let time = wobble.period() * (count + 0.3);
        let rest = wobble.period().mul_add(-count, time); // exact
        let [late, early] = [time, rest].map(|time| wobble.at(time).unwrap());
        assert!((late.tilt - early.tilt).abs() < 1e-15, "{count:e}: {} and {}", late.tilt, early.tilt);
        assert!((late.omega_1 - early.omega_1).abs() < 1e-15);
    }
}

#[test]
fn a_wheel_that_wobbles_about_the_upright_goes_straight_on() {
    let hoop = wheel(1.0);
    let state = Rolling { omega_1: 0.2, omega_3: 20.0, ..Rolling::UPRIGHT };
    let wobble = hoop.wobble(state, &taylor(1e-16)).unwrap();
    assert!(wobble.heading_advance().abs() < 1e-14);
    let [one, many] = [1.0, 1e6].map(|count| wobble.at(count * wobble.period()).unwrap().centre);
    assert!(one.re.abs() > 1.0);
    // Of where it begins, only the way across its path matters.
    assert_relative_eq!(many.re, 1e6 * one.re, max_relative = 1e-10);
    assert!((many.im - 1e6 * one.im).abs() < 1e-8 * many.re.abs());

    // A trace of a turn makes it a circle, a very large one.
    let state = Rolling { omega_2: 0.1, ..state };
    let wobble = hoop.wobble(state, &taylor(1e-16)).unwrap();
    let advance = wobble.heading_advance();
    assert!((1e-5..1e-3).contains(&advance.abs()), "{advance}");
    let time = 300.0 * wobble.period();
    let judge = Dop853::new(1e-14)
        .unwrap()
        .solve(any(|t, y: &[f64; 8]| hoop.rates(t, y)), 0.0, state.to_array(), time)
        .unwrap()
        .state;
    assert!((wobble.at(time).unwrap().centre - Complex::new(judge[6], judge[7])).norm() < 1e-7);
}

#[test]
fn a_wobble_needs_a_lean_that_swings_and_times_that_mean_something() {
    let disc = wheel(0.5);
    let message = |start: Rolling| disc.wobble(start, &taylor(1e-13)).unwrap_err().to_string();
    let upright = Rolling { omega_3: 3.0, ..Rolling::UPRIGHT };
    assert_eq!(
        message(upright),
        "angular velocity ω₁ 0 rad/s: the lean does not swing, and a steady motion has no wobble to repeat"
    );
    assert_eq!(
        message(Rolling { tilt: 3.2, ..upright }),
        "tilt from lying flat 3.2 rad is too large; it must be less than 3.141592653589793 rad"
    );
    assert_eq!(
        message(Rolling { omega_3: f64::INFINITY, ..upright }),
        "angular velocity ω₃ inf rad/s is not a finite number"
    );
    // Without a turn it falls flat.
    let falling = Rolling { tilt: FRAC_PI_2 - 0.3, ..Rolling::UPRIGHT };
    assert!(matches!(disc.wobble(falling, &taylor(1e-13)), Err(Error::Integration(_))));

    let mut state = disc.steady(0.5, 0.6).unwrap().state();
    state.omega_1 = 0.7;
    let wobble = disc.wobble(state, &taylor(1e-13)).unwrap();
    let refused = wobble.sample(&[1.0, -1e30]).unwrap_err();
    assert_eq!((refused.quantity, refused.value), ("size of the time", 1e30));
    assert_eq!(refused.rule, Rule::AtMost(2_f64.powi(47) * wobble.period()));
}

#[test]
fn a_disc_that_falls_from_rest_lifts_at_sixty_degrees_and_a_hoop_never() {
    // From nearly upright at rest, by energy: N = mg (3c² − 2c + k/2)/(1 + k/2).
    for (k, lifts) in [(0.5, true), (1.0, false)] {
        let wheel = wheel(k);
        let fallen = |lean: f64| {
            let drop = MASS * 9.81 * RADIUS * (1.0 - lean.cos());
            let rate = (2.0 * drop / (MASS * RADIUS * RADIUS * (1.0 + 0.5 * k))).sqrt();
            wheel.normal_force(&Rolling { tilt: FRAC_PI_2 - lean, omega_1: rate, ..Rolling::UPRIGHT })
        };
        let least = (1..155).map(|n| fallen(0.01 * f64::from(n))).fold(f64::INFINITY, f64::min);
        assert_eq!(least < 0.0, lifts);
        if lifts {
            let sixty = 60_f64.to_radians();
            assert!(fallen(sixty).abs() < 1e-12 && fallen(sixty - 0.01) > 0.0 && fallen(sixty + 0.01) < 0.0);
        } else {
            assert_relative_eq!(least, MASS * 9.81 / 9.0, max_relative = 1e-3);
        }
    }
}

//! The general motion: against the whole body with its contact force, against its constants, and against references.

use crate::whole_body::{axle, placed, solve, solve_slowed};
use crate::{GRAVITY, MASS, RADIUS, parameters, wheel};
use approx::assert_relative_eq;
use mechanics::conical::Conical;
use mechanics::integrate::{Dop853, Taylor};
use mechanics::nalgebra::Complex;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::{Error, Rule};
use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, PI};

/// What an integration to 1e-14 is worth as a judge.
const JUDGE: f64 = 1e-10;

fn start(random: &mut fastrand::Rng) -> Rolling {
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

#[test]
fn the_reduced_motion_is_that_of_the_whole_body_and_so_is_the_contact_force() {
    let mut random = fastrand::Rng::with_seed(72);
    let mut compared = 0;
    for n in 0..60 {
        let moments = MOMENTS[n % 5];
        let wheel = Wheel::new(parameters(moments)).unwrap();
        let state = start(&mut random);
        let omega = [state.omega_1, state.omega_2, state.omega_3];
        let whole = placed(state.lean(), state.heading, omega, state.centre);
        let time = 0.6;
        let solver = Dop853::new(1e-12).unwrap();
        let Ok(reduced) = solver.solve(|t, y: &[f64; 8]| wheel.rates(t, y), 0.0, state.to_array(), time)
        else {
            continue;
        };
        let reduced = Rolling::from_array(reduced.state);
        if reduced.lean().abs() > 1.4 {
            continue;
        }
        let judge = solver.solve(|_, y: &[f64; 13]| solve(moments, y).0, 0.0, whole, time).unwrap().state;
        assert_relative_eq!(reduced.lean(), (-axle(&judge).z).asin(), epsilon = 1e-8);
        assert_relative_eq!(reduced.centre.re, judge[0], epsilon = 1e-8);
        assert_relative_eq!(reduced.centre.im, judge[1], epsilon = 1e-8);
        let (_, force) = solve(moments, &judge);
        let size = MASS * 9.81 + force.norm();
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
        let omega = [state.omega_1, state.omega_2, state.omega_3];
        let solver = Dop853::new(1e-12).unwrap();
        let rates = wheel.slowed_rates(slowing);
        let Ok(reduced) = solver.solve(rates, 0.0, state.to_array(), 0.6) else { continue };
        let reduced = Rolling::from_array(reduced.state);
        if reduced.lean().abs() > 1.4 {
            continue;
        }
        let whole = placed(state.lean(), state.heading, omega, state.centre);
        let judge = |_: f64, y: &[f64; 13]| solve_slowed(moments, slowing, y).0;
        let judge = solver.solve(judge, 0.0, whole, 0.6).unwrap().state;
        assert_relative_eq!(reduced.lean(), (-axle(&judge).z).asin(), epsilon = 1e-8);
        assert_relative_eq!(reduced.centre.re, judge[0], epsilon = 1e-8);
        assert_relative_eq!(reduced.centre.im, judge[1], epsilon = 1e-8);
        // The power, from the energy a moment later and a moment before.
        let h = 1e-4;
        let energy = |time: f64| {
            let end = solver.solve(rates, 0.0, state.to_array(), time).unwrap();
            wheel.energy(&Rolling::from_array(end.state))
        };
        let square: f64 = omega.iter().map(|omega| omega * omega).sum();
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
        let Ok(end) = solver.solve(|t, y: &[f64; 8]| wheel.rates(t, y), 0.0, state.to_array(), 2.0) else {
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
fn the_conical_functions_satisfy_their_equation_to_the_very_ends() {
    for a in [1.0, 4.0 / 3.0, 1.9] {
        let conical = Conical::new(a);
        // Stepped from the middle outwards in y = artanh X, where the ends are at infinity and nothing is singular.
        let rates = |y: f64, &[e, de, o, d_o]: &[f64; 4]| {
            let square = y.cosh().powi(-2);
            [de, a * square * e, d_o, a * square * o]
        };
        for y in [0.2, 0.5, 0.6, 1.0, 3.0, 8.0, 15.0] {
            let end = Dop853::new(1e-13).unwrap().solve(rates, 0.0, [1.0, 0.0, 0.0, 1.0], y).unwrap().state;
            let x = f64::tanh(y);
            let gap = 2.0 / (1.0 + (2.0 * y).exp());
            let values = conical.at(x, gap);
            let square = gap * (2.0 - gap); // 1 − X², the factor from slopes in X to slopes in y
            for (found, judge) in [
                (values.even, end[0]),
                (values.even_slope * square, end[1]),
                (values.odd, end[2]),
                (values.odd_slope * square, end[3]),
            ] {
                assert_relative_eq!(found, judge, max_relative = 3e-12, epsilon = 1e-12);
            }
            let mirrored = conical.at(-x, gap);
            assert_eq!((mirrored.even, mirrored.odd), (values.even, -values.odd));
        }
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
fn two_hundred_precessions_are_met_from_one_wobble() {
    let file: Value =
        serde_json::from_str(include_str!("../data/rolling-two-hundred.json")).expect("a valid file");
    let row = |value: &Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    // The reference's normal is the opposite one: e₃ = −3̂, e₂ = 2̂, e₁ = −1̂, and its place is that of the contact.
    let disc = disc();
    let y0 = row(&file["y0"]);
    let upright = Rolling { tilt: y0[0], heading: y0[4] + PI, ..Rolling::UPRIGHT };
    let state = Rolling {
        omega_1: -y0[1],
        omega_2: y0[2],
        omega_3: -y0[3],
        centre: Complex::new(y0[5], y0[6]) - upright.contact(1.0),
        ..upright
    };
    let dt = file["dt"].as_f64().unwrap();
    let wobble = disc.wobble(state, &taylor(1e-16)).unwrap();
    let times: Vec<f64> = row(&file["index"]).iter().map(|i| i * dt).collect();
    let found = wobble.sample(&times).unwrap();
    let mut worst = 0.0_f64;
    for (rolling, hi) in found.iter().zip(file["grid_hi"].as_array().unwrap()) {
        let y = row(hi);
        let contact = rolling.contact(1.0);
        let errors = [
            rolling.tilt - y[0],
            -rolling.omega_1 - y[1],
            rolling.omega_2 - y[2],
            -rolling.omega_3 - y[3],
            rolling.heading - PI - y[4],
            contact.re - y[5],
            contact.im - y[6],
            -rolling.roll_angle - y[7],
        ];
        worst = errors.iter().map(|error| error.abs()).fold(worst, f64::max);
    }
    assert!(found.len() > 100 && worst < 1e-11, "{worst:e}");
}

#[test]
fn wobbles_repeat_themselves_turned_and_shifted_in_both_directions_of_time() {
    let disc = wheel(0.5);
    let mut state = disc.steady(0.5, 0.6).unwrap().state();
    (state.omega_1, state.heading, state.centre) = (0.7, 1.1, Complex::new(0.3, -0.2));
    let wobble = disc.wobble(state, &taylor(1e-13)).unwrap();
    let times = [-7.3, 12.9, 0.0, 3.3, 40.0];
    let found = wobble.sample(&times).unwrap();
    for (&time, rolling) in times.iter().zip(&found) {
        let judge = Dop853::new(1e-13)
            .unwrap()
            .solve(|t, y: &[f64; 8]| disc.rates(t, y), 0.0, state.to_array(), time)
            .unwrap()
            .state;
        for (found, judge) in rolling.to_array().into_iter().zip(judge) {
            assert_relative_eq!(found, judge, epsilon = 3e-9);
        }
    }
    assert_eq!(wobble.sample(&[f64::NAN]).unwrap_err().rule, Rule::Finite);
    assert_eq!(wobble.sample(&[]).unwrap().len(), 0);
}

#[test]
fn any_motion_is_its_half_wobble_mirrored_turned_and_shifted() {
    let mut random = fastrand::Rng::with_seed(12);
    let mut between = |low: f64, high: f64| low + (high - low) * random.f64();
    for n in 0..60 {
        let transverse = between(0.05, 1.0);
        let moments = MomentFactors { transverse, axial: transverse * between(0.2, 2.0) };
        let (mass, radius) = (between(0.5, 2.0), between(0.2, 2.0));
        let wheel = Wheel::new(DiskParameters { mass, radius, moments, gravity: GRAVITY }).unwrap();
        let rate = (GRAVITY / radius).sqrt();
        let state = Rolling {
            tilt: FRAC_PI_2 + between(-0.8, 0.8),
            // Every third begins where the lean turns.
            omega_1: if n % 3 == 0 { 0.0 } else { rate * between(-0.5, 0.5) },
            omega_2: rate * between(-1.0, 1.0),
            omega_3: rate * between(-3.0, 3.0),
            heading: between(-4.0, 4.0),
            roll_angle: between(-4.0, 4.0),
            centre: Complex::new(between(-3.0, 3.0), between(-3.0, 3.0)),
        };
        let wobble = wheel.wobble(state, &taylor(1e-16)).unwrap();
        let mut times: Vec<f64> = (0..5).map(|_| between(-6.0, 6.0) / rate).collect();
        times.push(0.0);
        for (&time, found) in times.iter().zip(wobble.sample(&times).unwrap()) {
            let judge = Dop853::new(1e-14)
                .unwrap()
                .solve(|t, y: &[f64; 8]| wheel.rates(t, y), 0.0, state.to_array(), time)
                .unwrap()
                .state;
            for (found, judge) in found.to_array().into_iter().zip(judge) {
                let error = (found - judge).abs() / (1.0 + judge.abs());
                assert!(error < JUDGE, "motion {n} at {time} s: {found} and {judge}: {state:?}");
            }
        }
    }
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
        .solve(|t, y: &[f64; 8]| hoop.rates(t, y), 0.0, state.to_array(), time)
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
        "angular velocity about axis 1 0 rad/s: the lean does not swing, and a steady motion has no wobble to repeat"
    );
    assert_eq!(
        message(Rolling { tilt: 3.2, ..upright }),
        "tilt from lying flat 3.2 rad is too large; it must be less than 3.141592653589793 rad"
    );
    assert_eq!(
        message(Rolling { omega_3: f64::INFINITY, ..upright }),
        "angular velocity about axis 3 inf rad/s is not a finite number"
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

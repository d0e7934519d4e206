//! The general motion: against the whole body with its contact force, against its constants, and against references.

use crate::whole_body::{axle, placed, solve};
use crate::{MASS, RADIUS, wheel};
use approx::assert_relative_eq;
use mechanics::conical::Conical;
use mechanics::integrate::Dop853;
use mechanics::scenes::rolling_wheel::{NoWobble, Rolling, Wheel};
use serde_json::Value;

/// What an integration to 1e-14 is worth as a judge.
const JUDGE: f64 = 1e-10;

fn start(random: &mut fastrand::Rng) -> Rolling {
    let mut number = |size: f64| size * (2.0 * random.f64() - 1.0);
    Rolling {
        lean: number(0.9),
        lean_rate: number(2.0),
        across: number(5.0),
        along: number(8.0),
        heading: number(3.0),
        spin: 0.0,
        centre: [number(1.0), number(1.0)],
    }
}

#[test]
fn the_reduced_motion_is_that_of_the_whole_body_and_so_is_the_contact_force() {
    let mut random = fastrand::Rng::with_seed(72);
    let mut compared = 0;
    for n in 0..40 {
        let k = [1.0, 0.5, 0.3][n % 3];
        let wheel = wheel(k);
        let state = start(&mut random);
        let whole =
            placed(state.lean, state.heading, [state.lean_rate, state.across, state.along], state.centre);
        let time = 0.6;
        let solver = Dop853::new(1e-12).unwrap();
        let Ok(reduced) = solver.solve(|t, y: &[f64; 8]| wheel.rates(t, y), 0.0, state.to_array(), time)
        else {
            continue;
        };
        let reduced = Rolling::from_array(reduced.state);
        if reduced.lean.abs() > 1.4 {
            continue;
        }
        let judge = solver.solve(|_, y: &[f64; 13]| solve(k, y).0, 0.0, whole, time).unwrap().state;
        assert_relative_eq!(reduced.lean, (-axle(&judge).z).asin(), epsilon = 1e-8);
        assert_relative_eq!(reduced.centre[0], judge[0], epsilon = 1e-8);
        assert_relative_eq!(reduced.centre[1], judge[1], epsilon = 1e-8);
        let (_, force) = solve(k, &judge);
        let size = MASS * 9.81 + force.norm();
        assert_relative_eq!(wheel.normal_force(&reduced), force.z, epsilon = 1e-7 * size);
        assert_relative_eq!(wheel.contact_force(&reduced).norm(), force.norm(), epsilon = 1e-7 * size);
        compared += 1;
    }
    assert!(compared > 25, "{compared}");
}

#[test]
fn energy_and_both_constants_stay() {
    let mut random = fastrand::Rng::with_seed(73);
    for n in 0..60 {
        let wheel = wheel([1.0, 0.5, 0.8][n % 3]);
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
        let [q, n] = wheel.at_lean(&before, end.lean);
        assert_relative_eq!(q, end.across, epsilon = 1e-8 * size);
        assert_relative_eq!(n, end.along, epsilon = 1e-8 * size);
        // The potential is the energy without the rate of lean.
        let rest = Rolling { lean_rate: 0.0, ..end };
        assert_relative_eq!(wheel.potential(&before, end.lean), wheel.energy(&rest), max_relative = 1e-8);
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
fn the_reference_wobble_is_met() {
    let file: Value = serde_json::from_str(include_str!("../data/rolling-disk.json")).expect("a valid file");
    let value = |name: &str| file["values"][name].as_str().unwrap().parse::<f64>().unwrap();
    let disc = Wheel::new(1.0, 1.0, 0.5, 1.0).unwrap();
    let state = Rolling {
        lean: 0.3,
        lean_rate: 0.0,
        across: 0.45,
        along: 0.9,
        heading: 0.0,
        spin: 0.0,
        centre: [0.0, 0.0],
    };
    let constants = disc.constants(&state);
    assert_relative_eq!(constants.even, value("Chaplygin_A"), max_relative = 1e-14);
    assert_relative_eq!(constants.odd, value("Chaplygin_B"), max_relative = 1e-13);
    assert_relative_eq!(disc.energy(&state), value("energy"), max_relative = 1e-14);
    let wobble = disc.wobble(state, 1e-14).unwrap();
    assert_relative_eq!(wobble.period(), value("nutation_period"), max_relative = 1e-11);
    assert_relative_eq!(
        wobble.heading_advance(),
        value("azimuth_advance_per_nutation"),
        max_relative = 1e-10
    );
    assert_relative_eq!(wobble.spin_advance(), value("psi_advance"), max_relative = 1e-11);
    let after = wobble.sample(&[wobble.period(), 0.5 * wobble.period()]).unwrap();
    assert_relative_eq!(after[0].centre[0], value("centre_dx"), max_relative = 1e-11);
    assert_relative_eq!(after[0].centre[1], value("centre_dy"), max_relative = 1e-10);
    assert_relative_eq!(after[1].lean, value("theta_other_turning_point"), max_relative = 1e-10);
    assert_relative_eq!(after[1].along, value("n_at_other_turning_point"), max_relative = 1e-11);
    assert_relative_eq!(after[1].across, value("q_at_other_turning_point"), max_relative = 1e-11);
}

#[test]
fn two_hundred_precessions_are_met_from_one_wobble() {
    let file: Value =
        serde_json::from_str(include_str!("../data/rolling-two-hundred.json")).expect("a valid file");
    let row = |value: &Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    // The reference's normal is the opposite one: e₃ = −3̂, e₂ = 2̂, e₁ = −1̂, β = π/2 − θ.
    let disc = Wheel::new(1.0, 1.0, 0.5, 1.0).unwrap();
    let y0 = row(&file["y0"]);
    let heading = y0[4] + std::f64::consts::PI;
    let lean = std::f64::consts::FRAC_PI_2 - y0[0];
    let (sin, cos) = heading.sin_cos();
    // The reference starts with the contact at the origin; the centre is a sin θ inward of it.
    let state = Rolling {
        lean,
        lean_rate: -y0[1],
        across: y0[2],
        along: -y0[3],
        heading,
        spin: 0.0,
        centre: [y0[5] + sin * lean.sin(), y0[6] - cos * lean.sin()],
    };
    let dt = file["dt"].as_f64().unwrap();
    let wobble = disc.wobble(state, 1e-16).unwrap();
    let times: Vec<f64> = row(&file["index"]).iter().map(|i| i * dt).collect();
    let found = wobble.sample(&times).unwrap();
    let mut worst = 0.0_f64;
    for (rolling, hi) in found.iter().zip(file["grid_hi"].as_array().unwrap()) {
        let y = row(hi);
        let [cx, cy] = disc.contact_point(rolling);
        let errors = [
            std::f64::consts::FRAC_PI_2 - rolling.lean - y[0],
            -rolling.lean_rate - y[1],
            rolling.across - y[2],
            -rolling.along - y[3],
            rolling.heading - std::f64::consts::PI - y[4],
            cx - y[5],
            cy - y[6],
            -rolling.spin - y[7],
        ];
        worst = errors.iter().map(|error| error.abs()).fold(worst, f64::max);
    }
    assert!(found.len() > 100 && worst < 1e-11, "{worst:e}");
}

#[test]
fn wobbles_repeat_themselves_turned_and_shifted_in_both_directions_of_time() {
    let disc = wheel(0.5);
    let mut state = disc.steady(0.5, 0.6).unwrap().state();
    (state.lean_rate, state.heading, state.centre) = (0.7, 1.1, [0.3, -0.2]);
    let wobble = disc.wobble(state, 1e-13).unwrap();
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
    assert!(matches!(
        disc.wobble(disc.steady(0.5, 0.6).unwrap().state(), 1e-30),
        Err(NoWobble::Tolerance(_))
    ));
    assert!(matches!(wobble.sample(&[f64::NAN]), Err(NoWobble::Time { .. })));
    assert_eq!(wobble.sample(&[]).unwrap().len(), 0);
}

#[test]
fn any_motion_is_its_half_wobble_mirrored_turned_and_shifted() {
    let mut random = fastrand::Rng::with_seed(12);
    let mut between = |low: f64, high: f64| low + (high - low) * random.f64();
    for n in 0..60 {
        let wheel = Wheel::new(between(0.5, 2.0), between(0.2, 2.0), between(0.1, 1.0), 9.81).unwrap();
        let rate = (wheel.gravity() / wheel.radius()).sqrt();
        let state = Rolling {
            lean: between(-0.8, 0.8),
            // Every third begins where the lean turns.
            lean_rate: if n % 3 == 0 { 0.0 } else { rate * between(-0.5, 0.5) },
            across: rate * between(-1.0, 1.0),
            along: rate * between(-3.0, 3.0),
            heading: between(-4.0, 4.0),
            spin: between(-4.0, 4.0),
            centre: [between(-3.0, 3.0), between(-3.0, 3.0)],
        };
        let wobble = wheel.wobble(state, 1e-16).unwrap();
        let mut times: Vec<f64> = (0..5).map(|_| between(-6.0, 6.0) / rate).collect();
        times.push(0.0);
        let mut frames = vec![state; times.len()];
        wobble.fill(&times, &mut frames).unwrap();
        for (&time, frame) in times.iter().zip(&frames) {
            let judge = Dop853::new(1e-14)
                .unwrap()
                .solve(|t, y: &[f64; 8]| wheel.rates(t, y), 0.0, state.to_array(), time)
                .unwrap()
                .state;
            for (found, judge) in frame.to_array().into_iter().zip(judge) {
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
        state.along += 8.0_f64.copysign(state.along); // fast enough for a wobble that is nearly harmonic
        let [loose, tight] = [0.1, 1e-13].map(|tolerance| wheel.wobble(state, tolerance).unwrap().period());
        assert_relative_eq!(loose, tight, max_relative = 0.1);
    }
}

#[test]
fn a_billion_wobbles_leave_the_phase_its_digits() {
    // In units in which the time is not rounded, from a moment at which the lean turns.
    let disc = Wheel::new(1.0, 1.0, 0.5, 1.0).unwrap();
    let state = Rolling { lean_rate: 0.0, lean: 0.6, ..disc.steady(0.5, 3.0).unwrap().state() };
    let wobble = disc.wobble(state, 1e-16).unwrap();
    for count in [1e3, 1e6, 1e9, -1e9] {
        let time = wobble.period() * (count + 0.3);
        let rest = wobble.period().mul_add(-count, time); // exact
        let [late, early] = [time, rest].map(|time| wobble.at(time).unwrap());
        assert!((late.lean - early.lean).abs() < 1e-15, "{count:e}: {} and {}", late.lean, early.lean);
        assert!((late.lean_rate - early.lean_rate).abs() < 1e-15);
    }
}

#[test]
fn a_wheel_that_wobbles_about_the_upright_goes_straight_on() {
    let hoop = wheel(1.0);
    let state = Rolling {
        lean: 0.0,
        lean_rate: 0.2,
        across: 0.0,
        along: 20.0,
        heading: 0.0,
        spin: 0.0,
        centre: [0.0; 2],
    };
    let wobble = hoop.wobble(state, 1e-16).unwrap();
    assert!(wobble.heading_advance().abs() < 1e-14);
    let [one, many] = [1.0, 1e6].map(|count| wobble.at(count * wobble.period()).unwrap().centre);
    assert!(one[0].abs() > 1.0);
    // Of where it begins, only the way across its path matters.
    assert_relative_eq!(many[0], 1e6 * one[0], max_relative = 1e-10);
    assert!((many[1] - 1e6 * one[1]).abs() < 1e-8 * many[0].abs());

    // A trace of a turn makes it a circle, a very large one.
    let state = Rolling { across: 0.1, ..state };
    let wobble = hoop.wobble(state, 1e-16).unwrap();
    let advance = wobble.heading_advance();
    assert!((1e-5..1e-3).contains(&advance.abs()), "{advance}");
    let time = 300.0 * wobble.period();
    let judge = Dop853::new(1e-14)
        .unwrap()
        .solve(|t, y: &[f64; 8]| hoop.rates(t, y), 0.0, state.to_array(), time)
        .unwrap()
        .state;
    for (found, judge) in wobble.at(time).unwrap().centre.into_iter().zip([judge[6], judge[7]]) {
        assert_relative_eq!(found, judge, epsilon = 1e-7);
    }
}

#[test]
fn a_wobble_needs_a_lean_that_swings_and_times_that_mean_something() {
    let disc = wheel(0.5);
    let upright = Rolling {
        lean: 0.0,
        lean_rate: 0.0,
        across: 0.0,
        along: 3.0,
        heading: 0.0,
        spin: 0.0,
        centre: [0.0; 2],
    };
    assert!(matches!(disc.wobble(upright, 1e-13), Err(NoWobble::Steady)));
    let flat = Rolling { lean: -1.6, ..upright };
    let message = disc.wobble(flat, 1e-13).unwrap_err().to_string();
    assert_eq!(message, "size of the lean 1.6 rad is too large; it must be less than 1.5707963267948966 rad");
    let nowhere = Rolling { along: f64::INFINITY, ..upright };
    let message = disc.wobble(nowhere, 1e-13).unwrap_err().to_string();
    assert_eq!(message, "angular velocity about axis 3 inf rad/s is not a finite number");
    // Without a turn it falls flat.
    let falling = Rolling { lean: 0.3, along: 0.0, ..upright };
    assert!(matches!(disc.wobble(falling, 1e-13), Err(NoWobble::Integration(_))));

    let mut state = disc.steady(0.5, 0.6).unwrap().state();
    state.lean_rate = 0.7;
    let wobble = disc.wobble(state, 1e-13).unwrap();
    let mut frames = [state; 2];
    let message = wobble.fill(&[1.0, 1e30], &mut frames).unwrap_err().to_string();
    assert_eq!(message, "time number 1: time 1e30 s must be finite, and at most 2^50 wobbles away");
    let message = wobble.fill(&[1.0], &mut frames).unwrap_err().to_string();
    assert_eq!(message, "1 times but room for 2 frames; there must be one frame for each time");
}

#[test]
fn a_disc_that_falls_from_rest_lifts_at_sixty_degrees_and_a_hoop_never() {
    // From nearly upright at rest, by energy: N = mg (3c² − 2c + k/2)/(1 + k/2).
    for (k, lifts) in [(0.5, true), (1.0, false)] {
        let wheel = wheel(k);
        let fallen = |lean: f64| {
            let state = Rolling {
                lean,
                lean_rate: 0.0,
                across: 0.0,
                along: 0.0,
                heading: 0.0,
                spin: 0.0,
                centre: [0.0; 2],
            };
            let drop = MASS * 9.81 * RADIUS * (1.0 - lean.cos());
            let rate = (2.0 * drop / (MASS * RADIUS * RADIUS * (1.0 + 0.5 * k))).sqrt();
            wheel.normal_force(&Rolling { lean_rate: rate, ..state })
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

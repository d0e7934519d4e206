//! The adaptive integrator against another implementation of the same method, against exact solutions, and in
//! its limits.

use crate::common::any;
use mechanics::integrate::{Direction, Dop853, Failure, Outcome};
use mechanics::measure::{Counter, max_error};
use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::ControlFlow;

/// Kepler's ellipse.
fn ellipse(_t: f64, &[x, y, vx, vy]: &[f64; 4]) -> [f64; 4] {
    let cube = x.hypot(y).powi(3);
    [vx, vy, -x / cube, -y / cube]
}

/// Eccentricity 0.6, semi-axis 1.
const PERICENTRE: [f64; 4] = [0.4, 0.0, 0.0, 2.0];

/// Van der Pol's oscillator with a push: nonlinear, driven, and hard enough for steps to be rejected.
fn van_der_pol(t: f64, &[x, v]: &[f64; 2]) -> [f64; 2] {
    [v, 8.0 * (1.0 - x * x) * v - x + 0.5 * (1.3 * t).cos()]
}

/// Two orders of the same sums differ by rounding, carried along for some hundred steps.
const SAME: f64 = 1e-10;

/// Compares solutions with those of the crate `ivp`, which also evaluates the dense output, three times a
/// step; how many steps were rejected.
fn assert_same_as_ivp<const N: usize>(
    rates: fn(f64, &[f64; N]) -> [f64; N],
    start: [f64; N],
    end: f64,
    theirs: &Value,
) -> usize {
    let cases = theirs.as_array().expect("a list");
    assert_eq!(cases.len(), 8);
    let mut rejected = 0;
    for theirs in cases {
        let count = |name: &str| theirs[name].as_u64().expect("a number") as usize;
        let tolerance = 10.0_f64.powi(-(count("digits") as i32));
        // The first step is given to both: the estimate in `ivp` 0.6.0 lacks a factor of 100 (`h.min(100 h)`).
        let solver = Dop853::new(tolerance).unwrap().with_first_step(1e-3).unwrap();
        let ours = solver.solve(any(rates), 0.0, start, end).unwrap();
        assert_eq!(ours.work.accepted, count("accepted"), "accepted steps at {tolerance:e}");
        assert_eq!(ours.work.rejected, count("rejected"), "rejected steps at {tolerance:e}");
        let evaluations = ours.work.evaluations + 3 * ours.work.accepted;
        assert_eq!(evaluations, count("evaluations"), "evaluations at {tolerance:e}");
        let size = ours.state.iter().fold(0.0_f64, |size, y| size.max(y.abs()));
        let last = |i: usize| theirs["state"][i].as_f64().expect("a number");
        let difference = (0..N).map(|i| (ours.state[i] - last(i)).abs()).fold(0.0, f64::max);
        assert!(difference < SAME * size, "states differ by {difference:e} at {tolerance:e}");
        rejected += ours.work.rejected;
    }
    rejected
}

#[test]
fn dop853_takes_the_same_steps_as_the_crate_ivp() {
    let theirs: Value = serde_json::from_str(include_str!("data/dop853.json")).expect("a valid file");
    let rejected = assert_same_as_ivp(ellipse, PERICENTRE, 20.0, &theirs["ellipse"])
        + assert_same_as_ivp(van_der_pol, [1.0, 0.0], 12.0, &theirs["van_der_pol"]);
    assert!(rejected > 10, "the problems should make both reject steps; {rejected} is no test of it");
}

#[test]
fn first_step_is_found_without_help() {
    // Half a swing takes some fifteen steps, whether it lasts a nanosecond or thirty years.
    for exponent in -9..=9 {
        let scale = 10.0_f64.powi(exponent);
        let swing = |_t: f64, &[x, v]: &[f64; 2]| [v / scale, -x / scale];
        let solver = Dop853::new(1e-10).unwrap();
        let end = solver.solve(any(swing), 0.0, [1.0, 0.0], scale * PI).unwrap();
        assert!((end.state[0] + 1.0).abs() < 1e-9, "scale {scale:e}: {:?}", end.state);
        assert!(end.work.evaluations < 260, "scale {scale:e}: {:?}", end.work);
    }
}

#[test]
fn first_step_follows_the_rule_of_the_book() {
    // Hairer, Nørsett & Wanner, section II.4. ẏ = 1 from 1: a hundredth of |y|/|ẏ| is 0.01, and a first step
    // is at most a hundred times that. With a tolerance so loose the rule by the order, (0.01 · 2000)^(1/8),
    // would allow 1.45.
    let mut first = None;
    let solver = Dop853::new(1e3).unwrap();
    let end = solver.solve_with(any(|_, _: &[f64; 1]| [1.0]), 0.0, [1.0], 50.0, |step| {
        first.get_or_insert(step.end() - step.start());
        ControlFlow::Continue(())
    });
    assert!((end.unwrap().state[0] - 51.0).abs() < 1e-12);
    assert_eq!(first, Some(1.0));
}

#[test]
fn component_that_stays_zero_needs_no_absolute_tolerance() {
    let solver = Dop853::with_tolerances(1e-10, 0.0).unwrap();
    let end = solver.solve(any(|_, &[x, y]: &[f64; 2]| [-x, 3.0 * y]), 0.0, [1.0, 0.0], 2.0).unwrap();
    assert!((end.state[0] - (-2.0_f64).exp()).abs() < 1e-10 && end.state[1] == 0.0);
}

#[test]
fn integration_backwards_undoes_integration_forwards() {
    let solver = Dop853::new(1e-12).unwrap();
    let there = solver.solve(any(van_der_pol), 0.0, [1.0, 0.0], 2.0).unwrap();
    let back = solver.solve(any(van_der_pol), 2.0, there.state, 0.0).unwrap();
    assert!(max_error(&[back.state], &[[1.0, 0.0]]) < 1e-6); // backwards this oscillator is unstable: e^{16}
    let circle = |_t: f64, &[x, v]: &[f64; 2]| [v, -x];
    let back = solver.solve(any(circle), 3.0, [3.0_f64.cos(), -(3.0_f64.sin())], 0.0).unwrap();
    assert!(max_error(&[back.state], &[[1.0, 0.0]]) < 1e-11);
}

#[test]
fn the_last_of_the_times_is_never_missed() {
    // Each step of a gentle motion is several times as long as all before, and what the last one's start and
    // length add up to is often the number beside its end.
    let gentle = |_t: f64, &[x]: &[f64; 1]| [-1e-3 * x];
    let solver = Dop853::new(1e-9).unwrap().with_first_step(1e-3).unwrap();
    for n in 1..3000 {
        let end = f64::from(n) / 3341.7;
        let (states, _) = solver.sample(any(gentle), 0.0, [1.0], &[0.5 * end, end]).unwrap();
        let alone = solver.solve(any(gentle), 0.0, [1.0], end).unwrap();
        assert_eq!((states.len(), states.last()), (2, Some(&alone.state)), "until {end}");
    }
}

#[test]
fn samples_agree_with_separate_solutions_in_both_directions() {
    let solver = Dop853::new(1e-11).unwrap();
    for sign in [1.0, -1.0] {
        let times = [0.0, 0.3, 0.3, 1.7, 4.0, 4.000_001, 9.0].map(|t| sign * t);
        let (samples, work) = solver.sample(any(ellipse), 0.0, PERICENTRE, &times).unwrap();
        assert_eq!(samples.len(), times.len());
        assert_eq!((samples[0], samples[1]), (PERICENTRE, samples[2]));
        for (t, sample) in times.iter().zip(&samples).skip(1) {
            let separate = solver.solve(any(ellipse), 0.0, PERICENTRE, *t).unwrap();
            assert!(max_error(&[*sample], &[separate.state]) < 1e-9, "t = {t}");
        }
        // Five steps at most are looked into, and cost three evaluations each.
        let plain = solver.solve(any(ellipse), 0.0, PERICENTRE, sign * 9.0).unwrap().work;
        assert!(work.evaluations > plain.evaluations && work.evaluations <= plain.evaluations + 15);
    }
    assert_eq!(solver.sample(any(ellipse), 1.0, PERICENTRE, &[]).unwrap().0, Vec::<[f64; 4]>::new());
}

#[test]
fn work_is_counted_as_it_is_done() {
    let counter = Counter::new();
    let end =
        Dop853::new(1e-8).unwrap().solve(any(counter.count(van_der_pol)), 0.0, [1.0, 0.0], 12.0).unwrap();
    let work = end.work;
    assert_eq!(work.evaluations, counter.evaluations());
    // Two to begin with, twelve for a step taken, eleven for a step given up.
    assert_eq!(work.evaluations, 2 + 12 * work.accepted + 11 * work.rejected);
    assert!(work.rejected > 0);
}

#[test]
fn event_is_found_to_the_accuracy_of_the_integration() {
    // ẋ = v, v̇ = −x from (0, 1): x = sin t. x falls through zero at π, rises at 2π; v falls at π/2.
    let circle = |_t: f64, &[x, v]: &[f64; 2]| [v, -x];
    let solver = Dop853::new(1e-13).unwrap();
    let expected = [
        (Direction::Falling, 0, PI),
        (Direction::Rising, 0, 2.0 * PI),
        (Direction::Either, 0, PI),
        (Direction::Falling, 1, FRAC_PI_2),
        (Direction::Rising, 1, 3.0 * FRAC_PI_2),
    ];
    for (direction, component, time) in expected {
        let event = |_t: f64, y: &[f64; 2]| y[component];
        let outcome = solver.solve_until(any(circle), 0.0, [0.0, 1.0], 20.0, event, direction).unwrap();
        let Outcome::Event(found) = outcome else { panic!("no event for {direction:?}") };
        assert!((found.time - time).abs() < 2e-12, "{direction:?}: {} for {time}", found.time);
        assert!(found.state[component].abs() < 1e-14);
        assert!((found.state[0] - found.time.sin()).abs() < 2e-12);
    }
    // Backwards in time "falling" is meant along the way: sin t falls from 0 as t falls from 0, and comes up
    // through zero at −π.
    let event = |_t: f64, y: &[f64; 2]| y[0];
    let outcome = solver.solve_until(any(circle), 0.0, [0.0, 1.0], -20.0, event, Direction::Rising).unwrap();
    let Outcome::Event(found) = outcome else { panic!("no event backwards") };
    assert!((found.time + PI).abs() < 2e-12);
    // None in reach.
    let outcome = solver.solve_until(any(circle), 0.0, [0.0, 1.0], 3.0, event, Direction::Falling).unwrap();
    assert!(matches!(outcome, Outcome::NoEvent(end) if end.time == 3.0));
}

#[test]
fn only_passages_of_the_direction_asked_for_count_and_a_zero_at_the_end_of_a_step_is_one() {
    let solver = Dop853::new(1e-13).unwrap();
    let circle = |_t: f64, &[x, v]: &[f64; 2]| [v, -x];
    let event = |_t: f64, y: &[f64; 2]| y[0];
    // −sin t rises at π and falls at 2π; sin t the other way round.
    for (start, direction) in [([0.0, -1.0], Direction::Falling), ([0.0, 1.0], Direction::Rising)] {
        let outcome = solver.solve_until(any(circle), 0.0, start, 20.0, event, direction).unwrap();
        let Outcome::Event(found) = outcome else { panic!("no event") };
        assert!((found.time - 2.0 * PI).abs() < 2e-12, "{direction:?}: {}", found.time);
    }
    // The second of steps of a half meets t = 1 exactly.
    let halves = solver.with_first_step(0.5).unwrap().with_max_step(0.5).unwrap();
    for (sign, direction) in [(1.0, Direction::Rising), (-1.0, Direction::Falling)] {
        for direction in [direction, Direction::Either] {
            let event = |t: f64, _: &[f64; 1]| sign * (t - 1.0);
            let outcome = halves.solve_until(any(|_, _| [1.0]), 0.0, [0.0], 3.0, event, direction).unwrap();
            assert!(matches!(outcome, Outcome::Event(found) if found.time == 1.0), "{outcome:?}");
        }
    }
}

#[test]
fn events_are_found_to_a_few_units_in_the_last_place_of_the_time() {
    // A function of the time alone whose zero is known exactly, and which no interpolation hits at once.
    let mut random = fastrand::Rng::with_seed(4);
    let solver = Dop853::new(1e-10).unwrap().with_first_step(10.0).unwrap();
    for n in 0..300 {
        let start = [0.0, 1.0, 1e3, -1e6][n % 4];
        let root = start + 10.0 * random.f64();
        let (stretch, bend) = (10_f64.powf(6.0 * random.f64() - 3.0), 20.0 * random.f64() - 10.0);
        let event = |t: f64, _: &[f64; 1]| stretch * (bend * (t - root)).exp_m1() * bend.signum();
        let outcome = solver
            .solve_until(any(|_, _| [1.0]), start, [0.0], start + 10.0, event, Direction::Rising)
            .unwrap();
        let Outcome::Event(found) = outcome else { panic!("no event at {root}") };
        let units = (found.time - root).abs() / (f64::EPSILON * root.abs());
        assert!(units <= 2.0, "{units} units in the last place of {root}");
    }
}

#[test]
fn what_is_not_a_number_between_the_ends_of_a_step_is_refused() {
    // A hole at a tenth of the first step, where only the dense output looks.
    let holed = |t: f64, _: &[f64; 1]| [if (t - 0.1).abs() < 1e-3 { f64::NAN } else { 1.0 }];
    let solver = Dop853::new(1e-10).unwrap().with_first_step(1.0).unwrap();
    let whole = Failure::NotFinite { time: 0.0, state: vec![0.0], step: 1.0 };
    assert_eq!(solver.sample(any(holed), 0.0, [0.0], &[0.5, 1.0]).unwrap_err(), whole);
    for event in [|t: f64, _: &[f64; 1]| t - 0.5, |_: f64, &[x]: &[f64; 1]| x - 0.5] {
        assert_eq!(
            solver.solve_until(any(holed), 0.0, [0.0], 1.0, event, Direction::Rising).unwrap_err(),
            whole
        );
    }
    // The ends themselves need no dense output.
    let outcome = solver.solve_until(any(holed), 0.0, [0.0], 3.0, |t, _| t - 1.0, Direction::Rising).unwrap();
    assert!(matches!(outcome, Outcome::Event(found) if found.time == 1.0 && found.state[0].is_finite()));
    assert!((solver.sample(any(holed), 0.0, [0.0], &[1.0]).unwrap().0[0][0] - 1.0).abs() < 1e-15);
}

#[test]
fn a_given_first_step_is_taken_in_either_direction() {
    let circle = |_t: f64, &[x, v]: &[f64; 2]| [v, -x];
    for direction in [1.0, -1.0] {
        let mut first = None;
        let solver = Dop853::new(1e-8).unwrap().with_first_step(0.125).unwrap();
        let end = solver.solve_with(any(circle), 0.0, [1.0, 0.0], 3.0 * direction, |step| {
            first.get_or_insert(step.end() - step.start());
            ControlFlow::Continue(())
        });
        assert_eq!(first, Some(0.125 * direction));
        assert!((end.unwrap().state[0] - 3.0_f64.cos()).abs() < 1e-6);
    }
}

#[test]
fn steep_events_are_found_too() {
    // A function of the state that is flat, then very steep: false position alone would creep.
    let drift = |_t: f64, _: &[f64; 1]| [1.0];
    for root in [1e-6, 0.123, 5.0, 9.999_999] {
        let mut looks = 0;
        let event = |_t: f64, &[x]: &[f64; 1]| {
            looks += 1;
            (30.0 * (x - root)).exp() - 1.0
        };
        let solver = Dop853::new(1e-12).unwrap().with_first_step(10.0).unwrap();
        let outcome = solver.solve_until(any(drift), 0.0, [0.0], 10.0, event, Direction::Rising).unwrap();
        let Outcome::Event(found) = outcome else { panic!("no event at {root}") };
        println!("{looks} looks");
        assert!(looks < 20, "{looks} looks at the event for {root}");
        assert!((found.time - root).abs() < 1e-14 * root.max(1.0), "{} for {root}", found.time);
    }
}

#[test]
fn observer_stops_the_integration_where_it_says() {
    let mut seen = 0;
    let end = Dop853::new(1e-10)
        .unwrap()
        .solve_with(any(ellipse), 0.0, PERICENTRE, 100.0, |step| {
            seen += 1;
            assert_eq!(step.at(step.start()), *step.initial_state());
            assert!(max_error(&[step.at(step.end())], &[*step.final_state()]) < 1e-14);
            if seen == 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })
        .unwrap();
    assert_eq!((seen, end.work.accepted), (5, 5));
    assert!(end.time < 100.0);
}

#[test]
fn running_into_a_singularity_says_when_and_where() {
    // ẏ = y² from 1 reaches infinity at t = 1.
    let failure =
        Dop853::new(1e-10).unwrap().solve(any(|_, &[y]: &[f64; 1]| [y * y]), 0.0, [1.0], 2.0).unwrap_err();
    let (time, state) = match &failure {
        Failure::StepUnderflow { time, state, .. } | Failure::NotFinite { time, state, .. } => (time, state),
        other => panic!("{other}"),
    };
    assert!((time - 1.0).abs() < 1e-9 && state[0] > 1e9, "stopped at t = {time}, y = {state:?}");
    assert!(failure.to_string().contains(&format!("time {time}")), "{failure}");
}

#[test]
fn rates_that_cease_to_be_finite_say_when_and_where() {
    // ẏ = √(1 − t) ends at t = 1; beyond, the rates are NaN.
    let rates = |t: f64, _: &[f64; 1]| [(1.0 - t).sqrt()];
    let failure = Dop853::new(1e-8).unwrap().solve(any(rates), 0.0, [0.0], 2.0).unwrap_err();
    let Failure::NotFinite { time, state, .. } = failure else { panic!("{failure}") };
    assert!((time - 1.0).abs() < 1e-6 && (state[0] - 2.0 / 3.0).abs() < 1e-6);
}

#[test]
fn too_much_work_says_how_far_it_got() {
    let solver = Dop853::new(1e-12).unwrap().with_max_evaluations(1000);
    let counter = Counter::new();
    let failure = solver.solve(any(counter.count(ellipse)), 0.0, PERICENTRE, 1e6).unwrap_err();
    let Failure::TooMuchWork { time, evaluations, .. } = failure else { panic!("{failure}") };
    assert!(time > 0.0 && time < 1e6);
    assert_eq!(evaluations, counter.evaluations());
    assert!((1000..1012).contains(&evaluations), "{evaluations}");
}

#[test]
fn the_next_step_follows_from_the_two_differences_of_a_step() {
    // Prey and predators, 2 and 2, one step of 0.2. The state after it and its differences from those of
    // orders 5 and 3 are those of the stages and weights of scipy 1.17.1 (`scipy.integrate._ivp`).
    let rates = |_: f64, &[x, y]: &[f64; 2]| [x * (1.0 - y), y * (x - 1.0)];
    let (before, after, h) = ([2.0, 2.0], [1.578_832_361_755_685_2, 2.342_984_296_936_917], 0.2);
    let fifth = [-1.724_178_509_687_757e-7, 4.209_519_726_572_353e-7];
    let third = [-7.818_600_257_559_761e-5, 2.494_832_600_716_923e-4];
    for (relative, absolute) in [(1e-7, 1e-10), (1e-8, 1e-9), (1e-8, 1e-7)] {
        let norm = |difference: [f64; 2]| {
            let part = |i: usize| difference[i] / (absolute + relative * f64::max(before[i], after[i]));
            (0.5 * (part(0).powi(2) + part(1).powi(2))).sqrt() // eq:error-norm
        };
        let (five, three) = (norm(fifth), norm(third));
        let error = five * five / (five * five + three * three / 100.0).sqrt(); // eq:error-estimate
        let mut steps = Vec::new();
        let solver = Dop853::with_tolerances(relative, absolute).unwrap().with_first_step(h).unwrap();
        solver
            .solve_with(any(rates), 0.0, before, 10.0, |step| {
                steps.push((step.end() - step.start(), *step.final_state()));
                if steps.len() < 2 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            })
            .unwrap();
        assert!((steps[0].0 - h).abs() < 1e-15, "the step is good");
        for (found, expected) in steps[0].1.iter().zip(after) {
            assert!((found - expected).abs() < 1e-14);
        }
        let next = 0.9 * h * error.powf(-0.125); // eq:next-step
        assert!((steps[1].0 / next - 1.0).abs() < 1e-8, "{} for {next}", steps[1].0);
    }
}

#[test]
fn a_tenth_of_the_tolerance_shortens_the_steps_by_its_eighth_root() {
    // On a circle every place is like every other: after the first few steps all are of one length, 0.9 of the longest
    // that would meet the tolerance (eq:next-step).
    let length = |tolerance: f64| {
        let mut lengths = Vec::new();
        let circle = |_: f64, &[x, v]: &[f64; 2]| [v, -x];
        Dop853::new(tolerance)
            .unwrap()
            .solve_with(any(circle), 0.0, [1.0, 0.0], 2000.0, |step| {
                lengths.push(step.end() - step.start());
                ControlFlow::Continue(())
            })
            .unwrap();
        lengths.pop(); // cut short by the end
        lengths[50..].iter().sum::<f64>() / (lengths.len() - 50) as f64
    };
    for tolerance in [1e-7, 1e-8, 1e-9, 1e-10] {
        let ratio = length(tolerance) / length(0.1 * tolerance);
        println!("{tolerance:e}: {ratio}");
        assert!((ratio - 10_f64.powf(0.125)).abs() < 0.05, "{ratio}");
    }
}

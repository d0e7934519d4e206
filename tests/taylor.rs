//! The Taylor method: its clock, its limits, and what it refuses.

use mechanics::integrate::{Expand, Failure, Series, TAYLOR_ORDER, Taylor};
use std::ops::ControlFlow;

/// ẋ = 1: the state is the time since the start.
struct Clock;

impl Expand<1> for Clock {
    fn expand(&self, series: &mut Series<1>) {
        series[1] = [1.0];
        series[2..].fill([0.0]);
    }
}

/// ẏ = y², which from 1 reaches infinity at t = 1.
struct Runaway;

impl Expand<1> for Runaway {
    fn expand(&self, series: &mut Series<1>) {
        for n in 0..TAYLOR_ORDER {
            let square: f64 = (0..=n).map(|j| series[j][0] * series[n - j][0]).sum();
            series[n + 1] = [square / (n + 1) as f64];
        }
    }
}

/// A state whose rates are no numbers.
struct Nowhere;

impl Expand<1> for Nowhere {
    fn expand(&self, series: &mut Series<1>) {
        series[1..].fill([f64::NAN]);
    }
}

#[test]
fn thousands_of_steps_lose_nothing_of_a_late_time() {
    // A millionth second, of which a tenth cannot be told from its neighbours by 1e-10, and ten thousand
    // steps of about a tenth.
    let (start, end) = (1e6, 1e6 + 1000.0);
    for direction in [1.0, -1.0] {
        let (start, end) = (direction * start, direction * end);
        let solver = Taylor::new(1e-16).unwrap().with_max_step(0.1).unwrap();
        let mut looked = 0;
        let reached = solver
            .solve_with(&Clock, start, [0.0], end, |step| {
                let middle = 0.5 * (step.start() + step.end());
                assert!(
                    (step.at(middle)[0] - (middle - start)).abs() < 3e-13,
                    "{} at {middle}",
                    step.at(middle)[0]
                );
                assert!((step.since(middle) / step.length() - 0.5).abs() < 1e-8);
                looked += 1;
                ControlFlow::Continue(())
            })
            .unwrap();
        assert!((10_000..10_010).contains(&looked), "{looked}");
        assert_eq!((reached.time, reached.state), (end, [end - start]));
    }
}

#[test]
fn the_way_is_gone_from_any_time_to_any_other() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut time = || 10.0 * random.f64() - 5.0;
    let (mut back, mut ahead) = ([0; 4], [0; 4]);
    for _ in 0..400 {
        let (start, end) = (time(), time());
        let reached = Taylor::new(1e-16)
            .unwrap()
            .with_max_step(0.7)
            .unwrap()
            .solve(&Clock, start, [start], end)
            .unwrap();
        assert!(reached.time == end && (reached.state[0] - end).abs() < 1e-14, "{start} to {end}");
        let sides = usize::from(start > 0.0) + 2 * usize::from(end > 0.0);
        if end < start {
            back[sides] += 1;
        } else {
            ahead[sides] += 1;
        }
        // Of ẏ = y² from −1/start it is −1/time.
        if start * end > 0.0 {
            let found = Taylor::new(1e-16).unwrap().solve(&Runaway, start, [-1.0 / start], end).unwrap();
            assert!((found.state[0] * end + 1.0).abs() < 1e-11, "{start} to {end}: {}", found.state[0]);
        }
    }
    // Within either sign of the time both ways were gone, and across zero the only one there is.
    let least = [back[0], back[3], ahead[0], ahead[3], back[1], ahead[2]].into_iter().min();
    assert!(least > Some(20), "{back:?} {ahead:?}");
}

#[test]
fn running_into_a_singularity_stops_at_once() {
    let solver = Taylor::new(1e-16).unwrap().with_max_expansions(10_000);
    let failure = solver.solve(&Runaway, 0.0, [1.0], 2.0).unwrap_err();
    let Failure::StepUnderflow { time, ref state, step } = failure else { panic!("{failure}") };
    assert!((time - 1.0).abs() < 1e-13 && state[0] > 1e13 && step.abs() < 1e-15, "{failure}");
}

#[test]
fn a_limit_of_series_and_tolerances_without_sense_say_so() {
    let short = Taylor::new(1e-16).unwrap().with_max_step(0.1).unwrap().with_max_expansions(7);
    let failure = short.solve(&Clock, 0.0, [0.0], 9.0).unwrap_err();
    let Failure::TooMuchWork { time, evaluations: 7, .. } = failure else { panic!("{failure}") };
    assert!((time - 0.7).abs() < 1e-15);
    assert!(failure.to_string().starts_with("the limit of series was reached after 7 of them"), "{failure}");
    // Small times have an exponent, and where there are no rates no step is named.
    let soon = short.with_max_step(1e-70).unwrap().solve(&Clock, 0.0, [0.0], 9.0).unwrap_err().to_string();
    assert!(soon.contains("after 7 of them at time 7e-70, state"), "{soon}");
    let nowhere = short.solve(&Nowhere, 0.0, [1e30], 2.0).unwrap_err().to_string();
    assert_eq!(nowhere, "the rates are not finite at time 0, state [1e30]");
    for (tolerance, message) in [
        (0.0, "tolerance 0 is not positive; it must be more than zero"),
        (-1.0, "tolerance -1 is not positive; it must be more than zero"),
        (f64::NAN, "tolerance NaN is not a finite number"),
        (f64::INFINITY, "tolerance inf is not a finite number"),
        (1e-18, "tolerance 1e-18 is too small; it must be at least 1e-17"),
    ] {
        assert_eq!(Taylor::new(tolerance).unwrap_err().to_string(), message);
    }
}

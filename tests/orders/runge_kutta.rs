//! RK4 and DOP853 on nonlinear problems with exact solutions: their orders, between the steps too, and their work.

use super::{LOOSE, assert_order, method, observed};
use crate::common::any;
use mechanics::integrate::methods::Cost;
use mechanics::integrate::{Dop853, rk4};
use mechanics::measure::{Counter, max_error};
use std::ops::ControlFlow;

/// A problem with an exact solution from another source.
struct Problem<const N: usize> {
    rates: fn(f64, &[f64; N]) -> [f64; N],
    exact: fn(f64) -> [f64; N],
    start: f64,
    end: f64,
}

/// Kepler's ellipse of eccentricity 0.3, from the pericentre: position from Kepler's equation, solved by Newton.
const ELLIPSE: Problem<4> = Problem {
    rates: |_, &[x, y, vx, vy]| {
        let cube = x.hypot(y).powi(3);
        [vx, vy, -x / cube, -y / cube]
    },
    exact: |t| {
        let e = 0.3_f64;
        let mut u = t;
        for _ in 0..40 {
            u -= (u - e * u.sin() - t) / (1.0 - e * u.cos());
        }
        let (rate, minor) = (1.0 / (1.0 - e * u.cos()), (1.0 - e * e).sqrt());
        [u.cos() - e, minor * u.sin(), -u.sin() * rate, minor * u.cos() * rate]
    },
    start: 0.0,
    end: 5.0,
};

/// ẏ = −2ty², y = 1/(1 + t²): the rates depend on the time, so wrong nodes show.
const BELL: Problem<1> = Problem {
    rates: |t, &[y]| [-2.0 * t * y * y],
    exact: |t| [1.0 / (1.0 + t * t)],
    start: 0.0, // from −1 to 1 the errors of the two halves cancel and the order seems to be nine
    end: 3.0,
};

/// ẋ = xy sin t, ẏ = −y² sin t: x = 2 − cos t and y = 1/x, two coupled variables and the time.
const PAIR: Problem<2> = Problem {
    rates: |t, &[x, y]| [x * y * t.sin(), -y * y * t.sin()],
    exact: |t| [2.0 - t.cos(), 1.0 / (2.0 - t.cos())],
    start: 0.0,
    end: 3.0,
};

fn rk4_error<const N: usize>(problem: &Problem<N>, steps: usize) -> f64 {
    let end = rk4(problem.rates, problem.start, (problem.exact)(problem.start), problem.end, steps).unwrap();
    max_error(&[end], &[(problem.exact)(problem.end)])
}

/// Errors of DOP853 with steps of fixed length: at the end, and largest between the steps.
fn dop853_errors<const N: usize>(problem: &Problem<N>, steps: usize) -> (f64, f64) {
    let h = (problem.end - problem.start) / steps as f64;
    let solver = Dop853::new(LOOSE).unwrap().with_first_step(h).unwrap().with_max_step(h).unwrap();
    let (mut between, mut count) = (0.0_f64, 0);
    let end = solver
        .solve_with(any(problem.rates), problem.start, (problem.exact)(problem.start), problem.end, |step| {
            count += 1;
            for part in 1..8 {
                let t = step.start() + f64::from(part) / 8.0 * (step.end() - step.start());
                between = between.max(max_error(&[step.at(t)], &[(problem.exact)(t)]));
            }
            ControlFlow::Continue(())
        })
        .unwrap();
    assert!(count >= steps && count <= steps + 1, "{count} steps instead of {steps}");
    (max_error(&[end.state], &[(problem.exact)(problem.end)]), between)
}

#[test]
fn rk4_has_its_order() {
    let promised = method("RK4").order;
    let steps = [100, 141, 200, 283, 400, 566, 800, 1131];
    assert_order("RK4, ellipse", observed(&steps, |n| rk4_error(&ELLIPSE, n)), promised);
    assert_order("RK4, bell", observed(&steps, |n| rk4_error(&BELL, n)), promised);
    assert_order("RK4, pair", observed(&steps, |n| rk4_error(&PAIR, n)), promised);
}

/// By which factor one step of RK4 multiplies an oscillation of rate one, and a decay of rate one.
fn rk4_factors(step: f64) -> (f64, f64) {
    let [x, v] = rk4(|_t, &[x, v]| [v, -x], 0.0, [1.0, 0.0], step, 1).unwrap();
    let [left] = rk4(|_t, &[y]| [-y], 0.0, [1.0], step, 1).unwrap();
    (x.hypot(v), left)
}

#[test]
fn rk4_damps_a_swing_up_to_a_step_of_two_root_two_and_a_decay_up_to_its_own_limit() {
    for z in [0.03_f64, 0.3, 1.0, 2.0, 3.0] {
        let square = 1.0 - z.powi(6) / 72.0 + z.powi(8) / 576.0; // eq:rk4-amplitude
        assert!((rk4_factors(z).0.powi(2) - square).abs() < 1e-14 * (1.0 + square), "{z}");
    }
    let limit = 2.0 * std::f64::consts::SQRT_2; // eq:rk4-limit
    assert!(rk4_factors(limit - 0.01).0 < 1.0 && rk4_factors(limit + 0.01).0 > 1.0);
    assert!(rk4_factors(2.78).1 < 1.0 && rk4_factors(2.79).1 > 1.0);
}

#[test]
fn dop853_has_its_order() {
    let promised = method("DOP853").order;
    let long = [52, 60, 68, 76, 86, 98, 110];
    let short = [10, 12, 14, 16, 18, 20, 22];
    assert_order("DOP853, ellipse", observed(&long, |n| dop853_errors(&ELLIPSE, n).0), promised);
    assert_order("DOP853, bell", observed(&short, |n| dop853_errors(&BELL, n).0), promised);
    assert_order("DOP853, pair", observed(&short, |n| dop853_errors(&PAIR, n).0), promised);
}

#[test]
fn frames_between_the_steps_are_as_good_as_the_steps() {
    // A dense output of order seven, whose own error within a step is of the eighth power, keeps up with a
    // method of order eight.
    let method = method("DOP853");
    assert_eq!(method.dense_order.map(|dense| dense + 1), Some(method.order));
    let steps = [52, 60, 68, 76, 86, 98, 110];
    assert_order("DOP853 dense, ellipse", observed(&steps, |n| dop853_errors(&ELLIPSE, n).1), method.order);
}

#[test]
fn within_one_step_the_dense_output_has_its_own_order() {
    // One step of length (end − start)/n from the exact start: the end is of order eight, the inside of order
    // seven, each seen as the next power of the length.
    fn one<const N: usize>(problem: &Problem<N>, offset: f64, n: usize) -> (f64, f64) {
        let start = problem.start + offset;
        let short = Problem { start, end: start + (problem.end - problem.start) / n as f64, ..*problem };
        dop853_errors(&short, 1)
    }
    let method = method("DOP853");
    let dense = method.dense_order.expect("DOP853 has dense output");
    let steps = [18, 20, 22, 24, 26, 28, 30];
    assert_order("DOP853 one step, ellipse", observed(&steps, |n| one(&ELLIPSE, 0.0, n).0), method.order + 1);
    assert_order("DOP853 inside one step, ellipse", observed(&steps, |n| one(&ELLIPSE, 0.0, n).1), dense + 1);
    let steps = [8, 9, 10, 11, 12, 13];
    assert_order("DOP853 one step, pair", observed(&steps, |n| one(&PAIR, 1.0, n).0), method.order + 1);
    assert_order("DOP853 inside one step, pair", observed(&steps, |n| one(&PAIR, 1.0, n).1), dense + 1);
}

#[test]
fn evaluations_of_a_step_are_as_the_table_says() {
    let evaluations = |name| match method(name).cost {
        Cost::Evaluations(count) => count as usize,
        other => panic!("{name} is measured in {other}"),
    };
    let rk4_counter = Counter::new();
    rk4(rk4_counter.count(ELLIPSE.rates), 0.0, (ELLIPSE.exact)(0.0), 1.0, 10).unwrap();
    assert_eq!(rk4_counter.evaluations(), 10 * evaluations("RK4"));

    // One evaluation at the start (the first step is given), then 12 a step: the last stage is the next step's first.
    let counter = Counter::new();
    let solver = Dop853::new(LOOSE).unwrap().with_first_step(0.125).unwrap().with_max_step(0.125).unwrap();
    let end = solver.solve(any(counter.count(ELLIPSE.rates)), 0.0, (ELLIPSE.exact)(0.0), 1.0).unwrap();
    assert_eq!(end.work.accepted, 8);
    assert_eq!(counter.evaluations(), 1 + 8 * evaluations("DOP853"));
    assert_eq!(end.work.evaluations, counter.evaluations());

    // Dense output costs three more on the steps that are looked into, and nothing on the others.
    let looked = Counter::new();
    let (_, work) = solver
        .sample(any(looked.count(ELLIPSE.rates)), 0.0, (ELLIPSE.exact)(0.0), &[0.3, 0.31, 1.0])
        .unwrap();
    assert_eq!(looked.evaluations(), counter.evaluations() + 3);
    assert_eq!(work.evaluations, looked.evaluations());
}

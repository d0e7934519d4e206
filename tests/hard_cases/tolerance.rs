//! Steps and tolerances at the edge of rounding, and steps that heavy damping forces to be short.

use super::{ROUNDOFF, assert_slope, machine};
use crate::common::any;
use mechanics::integrate::{Dop853, rk4};
use mechanics::scenes::laundromat::Shaft;
use std::f64::consts::TAU;

fn oscillator(_t: f64, &[x, v]: &[f64; 2]) -> [f64; 2] {
    [v, -x]
}

/// Error of one turn of an oscillator by RK4 with equal steps.
fn one_turn(steps: usize) -> f64 {
    let [x, v] = rk4(oscillator, 0.0, [1.0, 0.0], TAU, steps).unwrap();
    (x - TAU.cos()).hypot(v + TAU.sin())
}

#[test]
fn smaller_steps_help_until_rounding_and_then_they_hurt() {
    let falling: Vec<(f64, f64)> =
        [20, 50, 100, 200, 500, 1000].map(|steps| (TAU / steps as f64, one_turn(steps))).into();
    assert_slope("one turn by RK4", &falling, 4.0, 0.1);
    // The error of the method, 2π h⁴/120, meets that of some √n roundings near n = 1e4.
    let best = [4000, 6000, 8000, 10_000, 16_000].map(one_turn).iter().fold(1.0, |a: f64, b| a.min(*b));
    assert!(best < 2e-14, "{best:e}");
    for steps in [1_000_000, 3_000_000, 10_000_000] {
        let (error, roundings) = (one_turn(steps), steps as f64);
        println!("{steps} steps: {error:e}, {:.2} √n u", error / (ROUNDOFF * roundings.sqrt()));
        assert!(error > 3.0 * best && error < ROUNDOFF * roundings, "{steps}: {error:e}");
    }
    // Order eight arrives with less than a fortieth of the evaluations.
    let end = Dop853::new(1e-15).unwrap().solve(any(oscillator), 0.0, [1.0, 0.0], TAU).unwrap();
    let [x, v] = end.state;
    assert!((x - TAU.cos()).hypot(v + TAU.sin()) < 1e-15 && 40 * end.work.evaluations < 4 * 10_000);
}

#[test]
fn tighter_tolerances_help_until_rounding_and_then_only_cost() {
    let machine = machine(0.01, 3.0);
    let end = 200.0 * TAU / 3.0;
    let exact = machine.transient(Shaft::AT_REST).unwrap().at(end).unwrap().position;
    let solve = |tolerance: f64| {
        let solver = Dop853::new(tolerance).unwrap();
        let end =
            solver.solve(any(|t, y: &[f64; 4]| machine.cartesian_rates(t, y)), 0.0, [0.0; 4], end).unwrap();
        ((Shaft::from_array(end.state).position - exact).norm(), end.work.evaluations)
    };
    let errors: Vec<(f64, f64)> = (4..=11).map(|n| 10_f64.powi(-n)).map(|t| (t, solve(t).0)).collect();
    assert_slope("two hundred turns by DOP853", &errors, 1.0, 0.06);
    let (_, enough) = solve(1e-12);
    for tolerance in [1e-12, 3e-13, 1e-13, 3e-14, 1e-14, 3e-15, 1e-15] {
        let (error, evaluations) = solve(tolerance);
        println!("{tolerance:e}: {error:e}, {evaluations}");
        assert!((1e-13..3e-11).contains(&error), "{tolerance:e}: {error:e}");
        assert!(tolerance > 2e-15 || evaluations as f64 > 2.0 * enough as f64);
    }
}

#[test]
fn heavy_damping_costs_steps_in_proportion_whatever_the_tolerance() {
    let mut work = Vec::new();
    for damping in [30.0, 100.0, 300.0, 1000.0] {
        let machine = machine(damping, 0.0);
        let evaluations = |tolerance: f64| {
            let rates = |t: f64, y: &[f64; 4]| machine.cartesian_rates(t, y);
            let solver = Dop853::new(tolerance).unwrap();
            solver.solve(any(rates), 0.0, [1.0, 0.0, 0.0, 0.0], 100.0).unwrap().work.evaluations as f64
        };
        let [coarse, fine] = [1e-4, 1e-8].map(evaluations);
        assert!((0.8..1.25).contains(&(coarse / fine)), "Γ = {damping}: {coarse} and {fine}");
        // Twelve evaluations a step, and no step longer than 6.4/Γ.
        let step = 12.0 * 100.0 * damping / fine;
        assert!((5.5..6.8).contains(&step), "Γ = {damping}: steps of {step}/Γ");
        assert!(damping < 999.0 || (fine - 190e3).abs() < 5e3, "{fine}");
        work.push((damping, 1.0 / fine));
    }
    assert_slope("work against damping", &work, -1.0, 0.03);
}

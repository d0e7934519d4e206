//! The table of methods: every entry is measured.

use super::{DURATION, Run, assert_order, brick, method, observed, run};
use mechanics::attitude::rotation_between;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::geometric::{Splitting, commutator_free};
use mechanics::integrate::METHODS;
use mechanics::integrate::methods::{Cost, Method};
use mechanics::measure::ObservedOrder;
use nalgebra::Vector3;

/// How far from the table the page says that the orders are at most.
const PRINTED: f64 = 0.15;

/// The larger of the errors of attitude, rad, and of angular velocity, relative, against the closed form.
fn error(run: Run, steps: usize) -> f64 {
    let (moments, start) = brick();
    let exact = FreeTop::new(moments, start).unwrap().at(DURATION).unwrap();
    let found = Turning::from_array(run(start, DURATION, steps));
    let spin = (found.omega_body - exact.omega_body).norm() / exact.omega_body.norm();
    rotation_between(&found.world_from_body, &exact.world_from_body).max(spin)
}

/// The error of single steps of the length `DURATION / steps` from exact states along the motion, in the root
/// mean square.
fn single_step_error(run: Run, steps: usize) -> f64 {
    let (moments, start) = brick();
    let exact = FreeTop::new(moments, start).unwrap();
    let length = DURATION / steps as f64;
    let starts = 60;
    let sum: f64 = (0..starts)
        .map(|n| {
            let time = DURATION * f64::from(n) / f64::from(starts);
            let found = Turning::from_array(run(exact.at(time).unwrap(), length, 1));
            let after = exact.at(time + length).unwrap();
            let spin = (found.omega_body - after.omega_body).norm() / after.omega_body.norm();
            rotation_between(&found.world_from_body, &after.world_from_body).max(spin).powi(2)
        })
        .sum();
    (sum / f64::from(starts)).sqrt()
}

/// The order as the errors at the end show it. Those of a Taylor method's steps are high derivatives of the
/// motion, which nearly cancel over a round and the more so the shorter the steps: it is judged by its single
/// steps, whose order is one more.
fn measured(method: &Method) -> ObservedOrder {
    let (run, steps) = run(method.name);
    if matches!(method.cost, Cost::Series(_)) {
        let found = observed(&steps, |steps| single_step_error(run, steps));
        return ObservedOrder { slope: found.slope - 1.0, ..found };
    }
    observed(&steps, |steps| error(run, steps))
}

#[test]
fn every_method_has_its_order_on_a_free_asymmetric_body() {
    for method in METHODS {
        let found = measured(&method);
        assert_order(method.name, found, method.order);
        let miss = (found.slope - f64::from(method.order)).abs();
        assert!(
            miss < PRINTED,
            "{}: the page says that no order misses by {PRINTED}, this by {miss}",
            method.name
        );
    }
}

#[test]
fn the_methods_that_turn_cost_what_the_table_says() {
    for (splitting, name) in [(Splitting::Strang, "Strang"), (Splitting::BlanesMoan, "Blanes–Moan")] {
        assert_eq!(method(name).cost, Cost::Turns(splitting.turns_per_step() as u32));
    }
    let (moments, start) = brick();
    let mut evaluations = 0;
    let free = |_: f64, _: &Turning| {
        evaluations += 1;
        Vector3::zeros()
    };
    commutator_free(&moments, free, 0.0, start, 1.0, 10).unwrap();
    assert_eq!(Cost::Evaluations(evaluations / 10), method("CF4").cost);
}

//! A free hoop next to its middle axis: what no stepping method can keep.

use super::{FEW_ULPS, ROUNDOFF, assert_level, assert_slope, number, numbers, rows};
use crate::common::any;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{Dop853, rk4};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde_json::Value;

/// The closed form near the separatrix: the roundings of a phase of some twenty radians.
const SOME_ULPS: f64 = 1e-14;

fn moments() -> PrincipalMoments {
    PrincipalMoments::new(1.5, 0.5, 2.0).expect("a body")
}

fn start(row: &Value) -> Turning {
    let omega_body = numbers::<3>(&row["omega_start"]).into();
    Turning { world_from_body: UnitQuaternion::identity(), omega_body }
}

/// Error of ω by DOP853 at a tolerance, and the evaluations that it took.
fn by_dop853(row: &Value, tolerance: f64) -> (f64, usize) {
    let rates = euler::turning_rates(moments(), |_, _| Vector3::zeros());
    let solver = Dop853::new(tolerance).unwrap();
    let end = solver.solve(any(rates), 0.0, start(row).to_array(), number(&row["t"])).unwrap();
    let exact: Vector3<f64> = numbers::<3>(&row["omega"]).into();
    ((Turning::from_array(end.state).omega_body - exact).norm(), end.work.evaluations)
}

#[test]
fn closed_form_is_exact_down_to_a_billionth_from_the_separatrix() {
    for row in rows("separatrix") {
        let top = FreeTop::new(moments(), start(row)).unwrap();
        let now = top.at(number(&row["t"])).unwrap();
        let exact: Vector3<f64> = numbers::<3>(&row["omega"]).into();
        let [w, x, y, z] = numbers(&row["attitude"]);
        let attitude = Quaternion::new(w, x, y, z);
        let found = now.world_from_body.into_inner();
        let off = (found - attitude).norm().min((found + attitude).norm());
        let omega_off = (now.omega_body - exact).norm();
        assert!(omega_off < SOME_ULPS && off < SOME_ULPS, "{}: {omega_off:e}, {off:e}", row["complement"]);
        let length = found.norm() - 1.0;
        assert!(length.abs() < FEW_ULPS);
    }
}

#[test]
fn thousandth_flip_is_known_as_well_as_the_time() {
    for row in rows("separatrix").iter().step_by(3) {
        let top = FreeTop::new(moments(), start(row)).unwrap();
        let [tangent, diameter, _] = numbers(&row["omega_start"]);
        let w = f64::hypot(tangent, diameter);
        // In the midst of a flip, where ω₁ changes most, at W²/√2, and all else is at its extreme.
        let time = 1000.25 * number(&row["period"]);
        let omega = top.at(time).unwrap().omega_body;
        let error = (omega - Vector3::new(0.0, -w, -tangent / 2_f64.sqrt())).norm();
        let by_time = w * w / 2_f64.sqrt() * f64::EPSILON * time; // rounding of the period, a thousand times, and of the product
        assert!(error < by_time + SOME_ULPS, "{error:e}, {by_time:e}");
    }
}

#[test]
fn stepped_motion_past_the_separatrix_loses_two_digits_a_decade_at_any_tolerance() {
    // Rows in threes: a quarter, a half and five quarters of the period. At five quarters the hoop is in the
    // middle of its third flip, after two visits to the middle axis.
    let mut errors = Vec::new();
    for (near, late) in rows("separatrix").iter().step_by(3).zip(rows("separatrix").iter().skip(2).step_by(3))
    {
        let modulus = number(&late["complement"]).sqrt();
        let (first_flip, _) = by_dop853(near, 1e-13);
        assert!(
            first_flip < 1e-11,
            "k' = {modulus:e}: {first_flip:e} in the first flip, which starts from exact data"
        );
        let (error, evaluations) = by_dop853(late, 1e-13);
        assert!(evaluations < 10_000);
        if (5e-8..2e-3).contains(&modulus) {
            errors.push((modulus, error));
        }
        if modulus < 2e-5 {
            // Neither another tolerance nor another method does better: what is lost is lost in the numbers.
            let others = [1e-11, 3e-12, 1e-14, 1e-15].map(|tolerance| by_dop853(late, tolerance).0);
            let best = others.iter().fold(error, |best, other| best.min(*other));
            let predicted = (ROUNDOFF / modulus.powi(2)).min(1.0);
            assert!((0.01..10.0).contains(&(best / predicted)), "k' = {modulus:e}: {best:e}");
        }
        if modulus < 2e-8 {
            assert!(error > 0.1, "k' = {modulus:e}: {error:e}");
        }
    }
    assert_slope("stepped past the separatrix", &errors, -2.0, 0.25);
    assert_level("stepped past the separatrix", &errors, |modulus| ROUNDOFF / modulus.powi(2), 2.0..20.0);
}

#[test]
fn classical_steps_fail_by_as_much() {
    let late = rows("separatrix").iter().skip(2).step_by(3);
    let mut failed = 0;
    for row in late.filter(|row| (5e-8..2e-6).contains(&number(&row["complement"]).sqrt())) {
        let rates = euler::turning_rates(moments(), |_, _| Vector3::zeros());
        let t = number(&row["t"]);
        let end = rk4(rates, 0.0, start(row).to_array(), t, (20.0 * t) as usize).unwrap();
        let exact: Vector3<f64> = numbers::<3>(&row["omega"]).into();
        let error = (Turning::from_array(end).omega_body - exact).norm();
        let ratio = error / by_dop853(row, 1e-13).0;
        assert!((0.02..50.0).contains(&ratio), "{error:e}, {ratio}");
        failed += 1;
    }
    assert_eq!(failed, 2);
}

//! The methods that only turn.

use super::{brick, turning};
use mechanics::euler::Turning;
use mechanics::geometric::{Splitting, commutator_free};
use mechanics::integrate::Failure;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

fn free(_: f64, _: &Turning) -> Vector3<f64> {
    Vector3::zeros()
}

type Outcome = Result<Turning, Failure>;

/// Every method on the same input, over a duration in so many steps.
fn all(start: Turning, duration: f64, steps: usize) -> [Outcome; 3] {
    [
        Splitting::Strang.solve(&brick(), start, duration, steps),
        Splitting::BlanesMoan.solve(&brick(), start, duration, steps),
        commutator_free(&brick(), free, 0.0, start, duration, steps),
    ]
}

#[test]
fn what_cannot_be_stepped_is_refused_with_a_reason() {
    let start = turning(Vector3::new(1.0, 2.0, 3.0));
    for outcome in all(start, 1.0, 0) {
        assert_eq!(outcome, Err(Failure::NoSteps));
    }
    for outcome in all(start, f64::INFINITY, 3) {
        assert_eq!(outcome, Err(Failure::Interval { start: 0.0, end: f64::INFINITY }));
    }
    for outcome in all(start, f64::NAN, 3) {
        assert_eq!(
            outcome.expect_err("no time").to_string(),
            "the interval from 0 to NaN must have finite ends"
        );
    }
    for outcome in all(turning(Vector3::new(1.0, f64::NEG_INFINITY, 3.0)), 1.0, 3) {
        assert_eq!(
            outcome.expect_err("no motion").to_string(),
            "the initial state [1.0, 0.0, 0.0, 0.0, 1.0, -inf, 3.0] must be finite"
        );
    }
    let nowhere = UnitQuaternion::new_unchecked(Quaternion::new(f64::NAN, 0.0, 0.0, 0.0));
    for outcome in all(Turning { world_from_body: nowhere, ..start }, 1.0, 3) {
        assert!(matches!(outcome, Err(Failure::InitialState { .. })));
    }
    let late = commutator_free(&brick(), free, f64::NAN, start, 1.0, 3);
    assert!(matches!(late, Err(Failure::Interval { .. })));
}

#[test]
fn a_motion_that_leaves_the_numbers_stops_with_the_last_that_was_finite() {
    // 1e300 rad/s: the squares in the length of a turn overflow, and with them everything.
    for outcome in all(turning(Vector3::new(1e300, 2e300, 3e300)), 1e10, 2) {
        let Err(Failure::NotFinite { time, state, step }) = outcome else { panic!("{outcome:?}") };
        assert_eq!((time, state[4], step), (0.0, 1e300, 5e9));
    }
    // A torque that is lost on the way.
    let torque = |time: f64, _: &Turning| Vector3::new(if time > 0.55 { f64::NAN } else { 0.1 }, 0.0, 0.0);
    let outcome = commutator_free(&brick(), torque, 0.0, turning(Vector3::zeros()), 1.0, 10);
    let Err(Failure::NotFinite { time, state, .. }) = outcome else { panic!("{outcome:?}") };
    assert!((time - 0.5).abs() < 1e-15 && (state[4] - 0.05).abs() < 1e-15);
}

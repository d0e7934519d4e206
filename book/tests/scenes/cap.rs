//! The small scene of the cap against an arrow that is carried along in small steps.

use crate::hand::{Hand, number_behind};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// By how much an arrow is turned, degrees, that is carried once round a circle of the sphere along short
/// pieces of great circles.
fn carried(tilt: f64) -> f64 {
    let normal = |angle: f64| Vector3::new(tilt.sin() * angle.cos(), tilt.sin() * angle.sin(), tilt.cos());
    let first = Vector3::new(-tilt.cos(), 0.0, tilt.sin()); // uphill, at angle zero
    let (mut arrow, steps) = (first, 20_000);
    for step in 1..=steps {
        let [foot, next] = [step - 1, step].map(|n| normal(TAU * f64::from(n) / f64::from(steps)));
        arrow = UnitQuaternion::rotation_between(&foot, &next).unwrap() * arrow;
    }
    let turned = first.cross(&arrow).dot(&normal(0.0)).atan2(first.dot(&arrow)).to_degrees();
    turned.rem_euclid(360.0)
}

#[test]
fn after_a_round_the_arrow_is_turned_as_one_that_is_carried() {
    for tilt in [5.0, 41.0, 60.0, 85.0_f64] {
        let hand = Hand::with("cap", &[("tilt", tilt)]);
        let turned = carried(tilt.to_radians());
        assert!((hand.reading(6.0, "the arrow is") - turned).abs() < 1e-3, "{tilt}: {turned}");
        assert!((hand.reading(3.0, "the arrow is") - 0.5 * turned).abs() < 1e-3, "{tilt}");
        let area = number_behind(&hand.words(), "area of the cap,");
        assert!((area - TAU * (1.0 - tilt.to_radians().cos())).abs() < 6e-4, "{}", hand.words());
    }
}

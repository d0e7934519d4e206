//! The small scene at the two clocks of drag against Euler's equations with the torque of the air.

use crate::hand::{Hand, number_behind};
use mechanics::inertia::PrincipalMoments;
use mechanics::{euler, integrate::Dop853};
use nalgebra::Vector3;
use std::f64::consts::LN_2;

#[test]
fn both_parts_fade_as_by_eulers_equations() {
    for ratio in [0.1, 0.33, 1.0, 2.0] {
        let moments = PrincipalMoments::symmetric(1.0, ratio).unwrap();
        let rates = |_: f64, omega: &[f64; 3]| {
            let omega = Vector3::from(*omega);
            <[f64; 3]>::from(euler::rates(&moments, &omega, &(omega * (-LN_2 / 20.0))))
        };
        let (states, _) = Dop853::new(1e-12)
            .unwrap()
            .sample(rates, 0.0, [12.0, 0.0, 20.0], &[0.0, 7.0, 31.0, 60.0])
            .unwrap();
        let hand = Hand::with("clocks", &[("ratio", ratio)]);
        for ([w1, w2, w3], time) in states.into_iter().zip([0.0, 7.0, 31.0, 60.0]) {
            let (across, angle) = (w1.hypot(w2), w1.hypot(w2).atan2(w3).to_degrees());
            assert!((hand.reading(time, "spin") - w3).abs() < 1e-8, "{ratio}, {time}");
            assert!((hand.reading(time, "across the axis") - across).abs() < 1e-8, "{ratio}, {time}");
            assert!((hand.reading(time, "angle of") - angle).abs() < 1e-6, "{ratio}, {time}");
        }
        assert_eq!(hand.words().contains("keeps its lean"), ratio == 1.0, "{}", hand.words());
        let halved = number_behind(&hand.words(), "spin is halved every");
        assert!((hand.reading(halved, "spin") - 10.0).abs() < 0.2, "{}", hand.words());
    }
}

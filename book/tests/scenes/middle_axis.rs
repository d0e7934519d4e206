//! The small scene of "The middle axis" against a simulation of Euler's equations.

use crate::hand::{Hand, number_behind};
use fastrand::Rng;
use mechanics::euler;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// The bat of the page, thrown with L at an angle from axis 2 towards axis 1: its angular momentum on board at some
/// times, in that of 10 rad/s about axis 2.
fn thrown(off: f64, times: &[f64]) -> Vec<Vector3<f64>> {
    let [i1, i2, i3] = [1.83e-4, 7.89e-4, 9.72e-4];
    let bat = PrincipalMoments::new(i1, i2, i3).unwrap();
    let start = [10.0 * off.sin() * i2 / i1, 10.0 * off.cos(), 0.0];
    let rates = |_: f64, omega: &[f64; 3]| {
        <[f64; 3]>::from(euler::rates(&bat, &Vector3::from(*omega), &Vector3::zeros()))
    };
    let (states, _) = Dop853::new(1e-13).unwrap().sample(rates, 0.0, start, times).unwrap();
    states.iter().map(|[w1, w2, w3]| Vector3::new(w1 * i1, w2 * i2, w3 * i3) / (10.0 * i2)).collect()
}

#[test]
fn the_bat_turns_over_when_a_simulation_does() {
    for miss in [0.001, 0.01, 0.1, 1.0, 10.0_f64] {
        let hand = Hand::with("middle-axis", &[("miss", miss)]);
        let times: Vec<f64> = (0..=20_000).map(|k| 1e-4 * f64::from(k)).collect();
        let momenta = thrown(miss.to_radians(), &times);
        let over = momenta.iter().position(|momentum| momentum.y < 0.0).expect("it turns over");
        let turns = hand.reading(0.0, "turns before");
        assert!(
            (turns - 10.0 * times[over] / TAU).abs() < 2e-4,
            "{miss}: {turns} turns, and {}",
            times[over]
        );
    }
}

#[test]
fn the_angle_is_that_of_a_simulation() {
    let mut random = Rng::with_seed(31);
    for _ in 0..20 {
        let (miss, time) = (10_f64.powf(3.0 * random.f64() - 2.0), 0.2 + random.f64());
        let hand = Hand::with("middle-axis", &[("miss", miss)]);
        let momentum = thrown(miss.to_radians(), &[0.0, time])[1];
        let (angle, found) = (momentum.y.acos().to_degrees(), hand.reading(time, "angle of axis 2"));
        assert!((angle - found).abs() < 1e-4, "{miss} after {time} s: {found}, not {angle}");
    }
}

#[test]
fn ten_times_the_care_gains_as_much_each_time() {
    let turns = |miss: f64| Hand::with("middle-axis", &[("miss", miss)]).reading(0.0, "turns before");
    let said = number_behind(&Hand::with("middle-axis", &[]).words(), "careful gains");
    for miss in [0.1, 0.01, 0.001] {
        assert!((turns(0.1 * miss) - turns(miss) - said).abs() < 0.006, "{miss}: not {said}");
    }
    // The answer to its question.
    assert!(turns(0.003) < 2.0 && turns(0.002) > 2.0);
}

//! The small scene of the star on board against Euler's equations, stepped.

use crate::hand::{Hand, number_behind};
use mechanics::inertia::PrincipalMoments;
use mechanics::{euler, euler::Turning, integrate::Dop853};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

#[test]
fn the_star_is_where_a_stepped_station_sees_it() {
    for (lean, ratio) in [(11.5, 2.0), (25.0, 0.2), (0.5, 1.0), (25.0, 2.0_f64)] {
        let moments = PrincipalMoments::symmetric(1.0, ratio).unwrap();
        let omega_body = Vector3::new(0.45 * ratio * f64::to_radians(lean).tan(), 0.0, 0.45);
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
        let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
        let times = [0.0, 2.0, 3.0, 9.0, 25.0];
        let (states, _) = Dop853::new(1e-12).unwrap().sample(free, 0.0, start.to_array(), &times).unwrap();
        let hand = Hand::with("star", &[("lean", lean), ("ratio", ratio)]);
        for (time, state) in times.iter().zip(&states) {
            let axis = Turning::from_array(*state).axis_3_world();
            let off = axis.xy().norm().atan2(axis.z).to_degrees();
            let read = hand.reading(*time, "the star is off");
            assert!((read - off).abs() < 1e-6, "{lean}°, {ratio}, at {time} s: {read}, not {off}");
        }
        // The angle of L about axis 3, as it goes on board.
        let omega = Turning::from_array(states[1]).omega_body;
        let round = omega.y.atan2(omega.x) / TAU;
        assert!((hand.reading(2.0, "rounds of") - round).abs() < 1e-9, "{lean}°, {ratio}");
        let nods = number_behind(&hand.words(), "it nods");
        let back = TAU / 0.45 / nods;
        let before = [0.99, 1.0, 1.01].map(|part| hand.reading(part * back, "the star is off"));
        assert!(before[1] < before[0] && before[1] < before[2], "{}", hand.words());
    }
}

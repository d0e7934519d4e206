//! The small scene of "A coin with an edge" against a plumb line in a simulation.

use crate::hand::Hand;
use fastrand::Rng;
use mechanics::euler::{self, Turning};
use mechanics::inertia::{Body, Cylinder};
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};

#[test]
fn shares_are_those_of_a_plumb_line_in_a_simulation() {
    let mut random = Rng::with_seed(32);
    for _ in 0..12 {
        let [thickness, twist] = [f64::from(random.u32(20..1500)) / 1e3, f64::from(random.u32(0..150)) / 1e2];
        let hand = Hand::with("edge", &[("thickness", thickness), ("twist", twist)]);
        let coin = Cylinder { radius: 1.0, height: 2.0 * thickness };
        let moments = Body::cylinder(1.0, coin).unwrap().moments();
        let start = Turning {
            world_from_body: UnitQuaternion::identity(),
            omega_body: Vector3::new(200.0, 0.0, 200.0 * twist),
        };
        let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
        let times: Vec<f64> = (0..20_000).map(|n| 1e-4 * f64::from(n)).collect();
        let (states, _) = Dop853::new(1e-9).unwrap().sample(free, 0.0, start.to_array(), &times).unwrap();
        let mut counted = [0.0; 3];
        for state in &states {
            let down = Turning::from_array(*state).world_from_body.inverse() * -Vector3::z();
            let by_edge = coin.radius / down.xy().norm() < 0.5 * coin.height / down.z.abs();
            counted[if by_edge {
                1
            } else if down.z < 0.0 {
                0
            } else {
                2
            }] += 1.0 / 20_000.0;
        }
        for (words, share) in ["heads", "edge", "tails"].into_iter().zip(counted) {
            let found = hand.reading(0.0, words);
            // Some sixty precessions, of which the last is broken off.
            assert!((found - share).abs() < 0.015, "{thickness} {twist}: {words} {found}, counted {share}");
        }
    }
}

#[test]
fn a_little_twist_spoils_the_third_of_a_tumble() {
    let edge =
        |twist: f64| Hand::with("edge", &[("thickness", 0.577), ("twist", twist)]).reading(0.0, "edge");
    assert!((edge(0.0) - 1.0 / 3.0).abs() < 1e-3 && edge(0.3) > 0.4, "{} and {}", edge(0.0), edge(0.3));
}

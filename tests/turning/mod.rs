//! How a body turns: moments, attitude, Euler's equations and the free symmetric top, each against a route that shares
//! no code with it.

mod any_body;
mod closed_form;
mod euler;
mod inertia;
mod middle_axis;

use crate::common::between;
use mechanics::euler::Turning;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// What a few dozen operations in `f64` may cost, relative to the largest term.
const ROUNDING: f64 = 1e-13;

/// Moments that obey the triangle rule: sums of pairs of three positive numbers over `decades` decades.
fn moments(random: &mut fastrand::Rng, decades: f64) -> PrincipalMoments {
    let [x, y, z] = std::array::from_fn(|_| between(random, 10_f64.powf(-decades), 1.0));
    PrincipalMoments::new(y + z, x + z, x + y).expect("three integrals of squares make a body")
}

fn vector(random: &mut fastrand::Rng, size: f64) -> Vector3<f64> {
    Vector3::from_fn(|_, _| size * (2.0 * random.f64() - 1.0))
}

fn attitude(random: &mut fastrand::Rng) -> UnitQuaternion<f64> {
    let [w, i, j, k] = std::array::from_fn(|_| 2.0 * random.f64() - 1.0);
    UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k))
}

fn turning(random: &mut fastrand::Rng, spin: f64) -> Turning {
    Turning { world_from_body: attitude(random), omega_body: vector(random, spin) }
}

//! The rolling wheel: equations (72) to (90) and (5), each by a route that shares no code with it, and the general
//! motion.

mod coin;
mod general;
mod sinking;
mod stability;
mod start;
mod steady;
mod whole_body;

use mechanics::rolling::{DiskParameters, MomentFactors};
use mechanics::scenes::rolling_wheel::Wheel;

/// Mass, radius and gravity of the tests: nothing is one.
const MASS: f64 = 1.7;
const RADIUS: f64 = 0.4;
const GRAVITY: f64 = 9.81;

fn parameters(moments: MomentFactors) -> DiskParameters {
    DiskParameters { mass: MASS, radius: RADIUS, moments, gravity: GRAVITY }
}

/// A flat wheel with this moment factor k.
fn wheel(k: f64) -> Wheel {
    Wheel::new(parameters(MomentFactors::flat(k))).expect("a wheel")
}

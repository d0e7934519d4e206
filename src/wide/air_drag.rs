//! The angular velocity of a body that spins down in air, many times at once.

use super::functions::{Clock, exp, exp_and_exp_m1, sin_cos_quarters};
use super::{Branchless, several_at_once};
use crate::scenes::air_drag::DraggedTop;
use nalgebra::Vector3;

/// What [`DraggedTop::at`] is made of.
#[derive(Clone, Copy)]
struct Motion {
    clock: Clock, // of the wobble's phase, in the time that the spin would have needed at its first rate
    start: Vector3<f64>,
    transverse_decay: f64,
    axial_decay: f64,
}

/// Fills the states at times from zero to within reach and says how many, as [`several_at_once`] does.
pub(crate) fn fill(top: &DraggedTop, times: &[f64], states: &mut [Vector3<f64>]) -> usize {
    let clock = Clock::from_rate(top.body_rate);
    let DraggedTop { start, transverse_decay, axial_decay, .. } = *top;
    let motion = Motion { clock, start, transverse_decay, axial_decay };
    several_at_once(motion, 0.0..=clock.reach(), times, states)
}

impl Branchless for Motion {
    type State = Vector3<f64>;

    #[inline(always)]
    fn at(&self, time: f64) -> Vector3<f64> {
        let x = self.axial_decay * time;
        let (left, less_one) = exp_and_exp_m1(-x);
        let fraction = if x == 0.0 { 1.0 } else { -less_one / x };
        let (high, low) = self.clock.at(time * fraction); // eq:wobble-phase
        let (sin, cos) = sin_cos_quarters(high, low);
        let [w1, w2, w3]: [f64; 3] = self.start.into();
        let wobble = exp(-self.transverse_decay * time); // eq:wobble-decay
        let spin = w3 * left; // eq:spin-decay
        Vector3::new(wobble * (w1 * cos - w2 * sin), wobble * (w1 * sin + w2 * cos), spin)
    }
}

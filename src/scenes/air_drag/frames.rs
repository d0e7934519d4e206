//! Many angular velocities at once.

use super::DraggedTop;
use crate::wide::functions::{Clock, exp, exp_and_exp_m1, sin_cos_quarters};
use crate::wide::{Branchless, several_at_once};
use nalgebra::Vector3;

/// What a frame is made of.
#[derive(Clone, Copy)]
pub(super) struct Frames {
    clock: Clock, // of the phase, in the time that the spin would have needed at its first rate
    start: Vector3<f64>,
    transverse_decay: f64,
    axial_decay: f64,
}

impl Frames {
    pub(super) fn new(top: &DraggedTop) -> Self {
        Self {
            clock: Clock::from_rate(top.body_rate),
            start: top.start,
            transverse_decay: top.transverse_decay,
            axial_decay: top.axial_decay,
        }
    }

    /// Fills the frames at times from zero to within reach and says how many, as [`several_at_once`] does.
    pub(super) fn fill(&self, times: &[f64], frames: &mut [Vector3<f64>]) -> usize {
        several_at_once(*self, 0.0..=self.clock.reach(), times, frames)
    }
}

impl Branchless for Frames {
    type State = Vector3<f64>;

    #[inline(always)]
    fn at(&self, time: f64) -> Vector3<f64> {
        let x = self.axial_decay * time;
        let (along, less_one) = exp_and_exp_m1(-x);
        let fraction = if x == 0.0 { 1.0 } else { -less_one / x };
        let (high, low) = self.clock.at(time * fraction); // eq:wobble-phase
        let (sin, cos) = sin_cos_quarters(high, low);
        let across = exp(-self.transverse_decay * time);
        let [w1, w2, w3]: [f64; 3] = self.start.into();
        Vector3::new(across * (w1 * cos - w2 * sin), across * (w1 * sin + w2 * cos), w3 * along)
    }
}

//! What the force of the load of a drum that speeds up does to the shaft.

use super::drum::Drum;
use super::early::Early;
use super::root::Root;
use super::together::Together;
use crate::scenes::laundromat::Shaft;
use crate::scenes::laundromat::oscillator::{Oscillator, Roots};
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// The ways to form (λ₁ⁿS₁ − λ₂ⁿS₂)/(λ₁ − λ₂) of `eq:ramp-motion`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Forced {
    /// As it stands.
    Apart([Root; 2]),
    /// For two roots next to each other.
    Together(Together),
    /// For a drum that has not yet left the resonance in which it starts.
    Early(Early),
}

/// The difference of two roots that are apart may lose this factor of the digits, not more.
const MOST_LOST: f64 = 8.0;

impl Forced {
    /// For all times.
    pub(super) fn new(drum: &Drum, free: &Oscillator) -> Self {
        let zero = TwoPart::from(0.0);
        let decay = 0.5 * drum.damping;
        // λ₁ and λ₂ as −Re λ and Im λ, and half their difference.
        let (one, other, half_difference) = match free.roots() {
            Roots::Turning { frequency } => {
                ((decay, frequency), (decay, -frequency), Complex::new(0.0, frequency.rounded()))
            }
            Roots::Real { slow, fast, gap } => ((slow, zero), (fast, zero), Complex::new(0.5 * gap, 0.0)),
        };
        // S varies over this width of λ, so that λ²S and its change from root to root are as λ² to λ₁ − λ₂ times the
        // width.
        let width = drum.acceleration.sqrt().max(decay).max(half_difference.norm());
        let largest = decay + half_difference.norm();
        if largest * largest > MOST_LOST * half_difference.norm() * width {
            return Self::Together(Together::new(drum, -decay, half_difference));
        }
        let difference = half_difference * 2.0;
        Self::Apart([Root::new(drum, one, difference), Root::new(drum, other, -difference)])
    }

    /// What the force makes of a shaft that is otherwise free: `eq:ramp-motion` without its last term.
    pub(super) fn motion(&self, drum: &Drum, time: f64) -> Shaft {
        let mut sum = [[0.0]; 4];
        let integrals = match self {
            Self::Apart(roots) => {
                through_roots::<1, true>(drum, roots, &[time], &mut sum);
                Shaft::AT_REST
            }
            Self::Together(together) => together.motion(drum, drum.load::<1, true>(&[time], &mut sum), time),
            Self::Early(early) => early.motion(drum, drum.load::<1, true>(&[time], &mut sum), time),
        };
        Shaft::from_array(sum.map(|[number]| number)).plus(integrals).times(-drum.offset)
    }
}

/// The same for two roots apart: x, y, ẋ, ẏ over −b at many times, without a branch, or at any `ONE`.
#[inline(always)]
pub(super) fn through_roots<const N: usize, const ONE: bool>(
    drum: &Drum,
    roots: &[Root; 2],
    times: &[f64; N],
    sum: &mut [[f64; N]; 4],
) {
    let load = drum.load::<N, ONE>(times, sum);
    for root in roots {
        root.add_to::<N, ONE>(sum, times, &load);
    }
}

//! How the drum turns, and what the force of its load does to the shaft.

use super::early::Early;
use super::root::Root;
use super::together::Together;
use crate::scenes::laundromat::Shaft;
use crate::scenes::laundromat::machine::direction;
use crate::scenes::laundromat::oscillator::{Oscillator, Roots};
use crate::two_part::TwoPart;
use nalgebra::Complex;
use std::f64::consts::PI;

/// A drum that turns with φ = Ωt + ½αt², α > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Drum {
    pub(crate) spin: f64,         // Ω
    pub(crate) acceleration: f64, // α
    pub(crate) offset: f64,       // b
    pub(crate) damping: f64,      // Γ
}

impl Drum {
    /// e^{iφ}, the angle formed from 32 digits.
    pub(super) fn direction(&self, time: f64) -> Complex<f64> {
        direction((TwoPart::product(0.5 * self.acceleration, time) + TwoPart::from(self.spin)) * time)
    }

    /// φ̇ to 32 digits.
    pub(super) fn rate(&self, time: f64) -> TwoPart {
        TwoPart::product(self.acceleration, time) + TwoPart::from(self.spin)
    }

    /// G of `eq:ramp-faddeeva`.
    pub(crate) fn scale(&self) -> Complex<f64> {
        Complex::new(0.5, 0.5) * (PI / self.acceleration).sqrt()
    }

    /// dξ/dλ = (1 − i)/2√α of `eq:ramp-arguments`.
    pub(super) fn slope(&self) -> Complex<f64> {
        Complex::new(0.5, -0.5) / self.acceleration.sqrt()
    }
}

/// The ways to form (λ₁ⁿS₁ − λ₂ⁿS₂)/(λ₁ − λ₂) of `eq:ramp-motion`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Forced {
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
        let load = drum.direction(time);
        let [squares, cubes] = match self {
            Self::Apart([one, other]) => {
                let [a, b] = [one.weighted(drum, load, time), other.weighted(drum, load, time)];
                [a[0] + b[0], a[1] + b[1]]
            }
            Self::Together(together) => together.quotients(drum, load, time),
            Self::Early(early) => early.quotients(drum, load, time),
        };
        // The rate of S is λS + e^{iφ}, and λ₁ + λ₂ = −Γ.
        let rate = Complex::new(-drum.damping, drum.rate(time).rounded());
        Shaft { position: -drum.offset * (load + squares), velocity: -drum.offset * (rate * load + cubes) }
    }
}

//! A drum that speeds up slowly and starts near its resonance: what the force does before the drum has left it.
//!
//! Through the root that it resonates with it will do much, and in the form for all times the free motion nearly
//! cancels that until it is done. So here it is counted from the start (`eq:ramp-early`).

use super::drum::Drum;
use super::root::Root;
use crate::gauss::GAUSS;
use crate::scenes::laundromat::Shaft;
use crate::scenes::laundromat::machine::direction;
use crate::scenes::laundromat::oscillator::{Oscillator, Roots};
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// How near to resonance this form is used: drum's spin and root apart by less than this part of ω₀, and √α less than
/// it. Further away, no more than two binary digits are lost.
const NEAR: f64 = 0.25;

/// The resonant root λ = −Γ/2 ± iω₁, and the other one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Early {
    /// Up to which time, of either sign, this form holds: until the drum has drifted by about a radian.
    pub(super) reach: f64,
    decay: f64,                 // −Re λ
    turning: TwoPart,           // Im λ
    off_resonance: f64,         // Ω − Im λ
    weights: [Complex<f64>; 2], // λ²/(λ₁ − λ₂), and λ times it
    other: Root,
}

impl Early {
    /// `None` away from resonance and for critical and heavy damping.
    pub(super) fn new(drum: &Drum, free: &Oscillator) -> Option<Self> {
        let Roots::Turning { frequency } = free.roots() else {
            return None;
        };
        let decay = 0.5 * drum.damping;
        let turning = if drum.spin < 0.0 { -frequency } else { frequency };
        let off_resonance = (TwoPart::from(drum.spin) - turning).rounded();
        let root = Complex::new(-decay, turning.rounded());
        let drift = off_resonance.hypot(decay).max(drum.acceleration.sqrt());
        let difference = Complex::new(0.0, 2.0 * turning.rounded());
        let weight = root * root / difference;
        (drift <= NEAR * root.norm()).then(|| Self {
            reach: drift.recip(),
            decay,
            turning,
            off_resonance,
            weights: [weight, weight * root],
            other: Root::new(drum, (decay, -turning), -difference),
        })
    }

    /// (λ₁ⁿS₁ − λ₂ⁿS₂)/(λ₁ − λ₂) for n = 2 and 3, as position and velocity, S of the resonant root counted from the
    /// start.
    pub(super) fn motion(&self, drum: &Drum, load: [[f64; 1]; 2], time: f64) -> Shaft {
        let resonant = self.integral(drum, time);
        let mut other = [[0.0]; 4];
        self.other.add_to::<1, true>(&mut other, &[time], &load);
        let resonant = Shaft { position: self.weights[0] * resonant, velocity: self.weights[1] * resonant };
        resonant.plus(Shaft::from_array(other.map(|[number]| number)))
    }

    /// `eq:ramp-early` by Gauss's quadrature, to rounding.
    fn integral(&self, drum: &Drum, time: f64) -> Complex<f64> {
        let integrand = |s: f64| {
            Complex::new(self.decay * s, (self.off_resonance + 0.5 * drum.acceleration * s) * s).exp()
        };
        let pair = |&(node, weight): &(f64, f64)| {
            (integrand(0.5 * (1.0 - node) * time) + integrand(0.5 * (1.0 + node) * time)) * (0.5 * weight)
        };
        let mean: Complex<f64> = GAUSS.iter().map(pair).sum();
        direction(self.turning * time) * (-self.decay * time).exp() * mean * time
    }
}

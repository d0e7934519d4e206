//! A drum that speeds up slowly and starts near its resonance: what the force does before the drum has left it.
//!
//! Through the root that it resonates with it will do much, and in the form for all times the free motion nearly cancels that until it is
//! done. So here it is counted from the start.

use super::drum::Drum;
use super::root::Root;
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// How near to resonance this form is used: drum's spin and root apart by less than this part of ω₀, and √α less than it. Further
/// away, no more than two binary digits are lost.
const NEAR: f64 = 0.25;

/// The resonant root, the other one, and the start of the free motion to be added.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Early {
    /// Up to which time, of either sign, this form holds: until the drum has drifted by about a radian.
    pub(super) reach: f64,
    other: Root,
    pub(super) displacement: Complex<f64>,
    pub(super) velocity: Complex<f64>,
    decay: f64,
    frequency: TwoPart,
    detuning: f64,
    acceleration: f64,
    weights: [Complex<f64>; 2],
}

impl Early {
    /// For the roots `−decay ± i·frequency` and a start; `None` away from resonance.
    pub(super) fn new(
        drum: &Drum,
        (decay, frequency): (f64, TwoPart),
        position: Complex<f64>,
        velocity: Complex<f64>,
    ) -> Option<Self> {
        let frequency = if drum.spin < 0.0 { -frequency } else { frequency };
        let detuning = (TwoPart::from(drum.spin) - frequency).rounded();
        let drift = detuning.hypot(decay).max(drum.acceleration.sqrt());
        let root = Complex::new(-decay, frequency.rounded());
        if drift > NEAR * root.norm() {
            return None;
        }
        let difference = Complex::new(0.0, 2.0 * frequency.rounded());
        let weight = root * root / difference;
        let other = Root::new(drum, (decay, -frequency), -difference);
        let [[x], [y], [vx], [vy]] = drum.driven(&[other], &[0.0]);
        Some(Self {
            reach: drift.recip(),
            other,
            displacement: position - Complex::new(x, y),
            velocity: velocity - Complex::new(vx, vy),
            decay,
            frequency,
            detuning,
            acceleration: drum.acceleration,
            weights: [weight, weight * root],
        })
    }

    /// Position and velocity of the motion that the force makes through both roots.
    pub(super) fn motion(&self, drum: &Drum, time: f64) -> [Complex<f64>; 2] {
        let [[x], [y], [vx], [vy]] = drum.driven(&[self.other], &[time]);
        let [position, velocity] = self.resonant(time);
        [Complex::new(x, y) - position * drum.offset, Complex::new(vx, vy) - velocity * drum.offset]
    }

    /// What the force has done through the resonant root since the start: c P and cλ P with `P = ∫₀ᵗ e^{λ(t−s)} e^{iφ(s)} ds`, by
    /// Gauss's quadrature, to rounding.
    fn resonant(&self, time: f64) -> [Complex<f64>; 2] {
        let integrand =
            |s: f64| Complex::new(self.decay * s, (self.detuning + 0.5 * self.acceleration * s) * s).exp();
        let sum: Complex<f64> = NODES
            .iter()
            .map(|&[node, weight]| {
                let aside = node * time;
                (integrand(0.5 * time - aside) + integrand(0.5 * time + aside)) * weight
            })
            .sum();
        let (sin, cos) = (self.frequency * time).sin_cos();
        let carried = Complex::new(cos, sin) * (time * (-self.decay * time).exp());
        self.weights.map(|weight| weight * carried * sum)
    }
}

/// Gauss's twelve nodes on an interval of length one, as distances from its middle, and their weights.
const NODES: [[f64; 2]; 6] = [
    [0.06261670425573446, 0.12457352290670139],
    [0.1839157494990901, 0.1167462682691774],
    [0.29365897714330874, 0.10158371336153296],
    [0.38495133709715235, 0.08003916427167311],
    [0.45205862818523745, 0.05346966299765921],
    [0.4907803171233596, 0.023587668193255914],
];

//! One root of the suspension, and what the force of a drum that speeds up does through it.

use super::drum::Drum;
use crate::faddeeva::faddeeva;
use crate::scenes::laundromat::machine::direction;
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// A root λ, and its weight ±λ²/(λ₁ − λ₂) in `eq:ramp-motion`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Root {
    pub(crate) decay: f64,           // −Re λ
    pub(crate) turning: TwoPart,     // Im λ
    pub(crate) weight: Complex<f64>, // ±λ²/(λ₁ − λ₂)
    pub(crate) phase: TwoPart,       // of what the passing leaves behind, carried back to time zero
    pub(crate) passed: bool,         // before the start
}

impl Root {
    /// For −Re λ, Im λ and the difference of λ from the other root.
    pub(super) fn new(drum: &Drum, (decay, turning): (f64, TwoPart), difference: Complex<f64>) -> Self {
        let ahead = turning - TwoPart::from(drum.spin);
        let square = TwoPart::product(decay, decay) - ahead * ahead;
        let lambda = Complex::new(-decay, turning.rounded());
        Self {
            decay,
            turning,
            weight: lambda * lambda / difference,
            phase: square / (TwoPart::from(drum.acceleration) * 2.0),
            passed: (drum.slope() * Complex::new(-decay, ahead.rounded())).im < 0.0,
        }
    }

    /// λ.
    pub(crate) fn lambda(&self) -> Complex<f64> {
        Complex::new(-self.decay, self.turning.rounded())
    }

    /// S and λS with the root's weight.
    pub(super) fn weighted(&self, drum: &Drum, load: Complex<f64>, time: f64) -> [Complex<f64>; 2] {
        let part = self.weight * self.integral(drum, load, time);
        [part, part * self.lambda()]
    }

    /// S of `eq:ramp-integral`; of a passing before the start, less what that leaves behind, which the free motion
    /// then has.
    fn integral(&self, drum: &Drum, load: Complex<f64>, time: f64) -> Complex<f64> {
        let x = self.argument(drum, time);
        let around = if x.im >= 0.0 { load * faddeeva(x) } else { -load * faddeeva(-x) };
        drum.scale()
            * match (x.im < 0.0, self.passed) {
                (true, false) => around + self.left_behind(drum, time) * 2.0,
                (false, true) => around - self.left_behind(drum, time) * 2.0,
                _ => around,
            }
    }

    /// λ − iφ̇, of which the imaginary part loses no digits near resonance.
    fn off_resonance(&self, drum: &Drum, time: f64) -> Complex<f64> {
        Complex::new(-self.decay, (self.turning - drum.rate(time)).rounded())
    }

    /// ξ of `eq:ramp-arguments`.
    fn argument(&self, drum: &Drum, time: f64) -> Complex<f64> {
        drum.slope() * self.off_resonance(drum, time)
    }

    /// e^{λφ̇/α + i(λ² − Ω²)/2α}. The real part of the exponent is Re λ (φ̇ − Im λ)/α; the imaginary
    /// part, of any size, is Im λ t + ½((Re λ)² − (Im λ − Ω)²)/α, from 32 digits.
    fn left_behind(&self, drum: &Drum, time: f64) -> Complex<f64> {
        let off = self.off_resonance(drum, time);
        direction(self.turning * time + self.phase) * (-off.re * off.im / drum.acceleration).exp()
    }
}

//! How the drum turns.

use crate::elementary::{ROUNDABLE, sin_cos_quarters};
use crate::two_part::TwoPart;
use nalgebra::Complex;
use std::f64::consts::PI;

/// A drum that turns with φ = Ωt + ½αt², α > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Drum {
    pub(super) spin: f64,              // Ω
    pub(super) acceleration: f64,      // α
    pub(super) offset: f64,            // b
    pub(super) damping: f64,           // Γ
    spin_in_quarters: TwoPart,         // 2Ω/π
    acceleration_in_quarters: TwoPart, // α/π
}

impl Drum {
    pub(super) fn new(spin: f64, acceleration: f64, offset: f64, damping: f64) -> Self {
        let spin_in_quarters = TwoPart::from(2.0 * spin) / TwoPart::PI;
        let acceleration_in_quarters = TwoPart::from(acceleration) / TwoPart::PI;
        Self { spin, acceleration, offset, damping, spin_in_quarters, acceleration_in_quarters }
    }

    /// Until when, of either sign, the angle can be reduced for many times at once.
    pub(super) fn reach(&self) -> f64 {
        let by_acceleration = (0.25 * ROUNDABLE / self.acceleration_in_quarters.rounded()).sqrt();
        by_acceleration.min(0.25 * ROUNDABLE / self.spin_in_quarters.rounded().abs())
    }

    /// φ̇.
    #[inline(always)]
    pub(super) fn rate(&self, time: f64) -> f64 {
        self.spin + self.acceleration * time
    }

    /// Cosine and sine of the load's direction at these times; `sum` becomes x, y, ẋ, ẏ of what is no integral in
    /// `eq:ramp-motion`, over −b.
    #[inline(always)]
    pub(super) fn load<const N: usize, const ONE: bool>(
        &self,
        times: &[f64; N],
        sum: &mut [[f64; N]; 4],
    ) -> [[f64; N]; 2] {
        let mut load = [[0.0; N]; 2];
        for (n, &time) in times.iter().enumerate() {
            // The angle from 32 digits.
            let angle = (self.acceleration_in_quarters * time + self.spin_in_quarters) * time;
            let (high, low) = angle.parts();
            let (sin, cos) = sin_cos_quarters::<ONE>(high, low);
            (load[0][n], load[1][n]) = (cos, sin);
            // The rate of S is λS + e^{iφ}, and λ₁ + λ₂ = −Γ.
            let rate = self.rate(time);
            (sum[0][n], sum[1][n]) = (cos, sin);
            (sum[2][n], sum[3][n]) = (-rate * sin - self.damping * cos, rate * cos - self.damping * sin);
        }
        load
    }

    /// G of `eq:ramp-faddeeva`.
    pub(super) fn scale(&self) -> Complex<f64> {
        Complex::new(0.5, 0.5) * (PI / self.acceleration).sqrt()
    }

    /// dξ/dλ = (1 − i)/2√α of `eq:ramp-arguments`.
    pub(super) fn slope(&self) -> Complex<f64> {
        Complex::new(0.5, -0.5) / self.acceleration.sqrt()
    }
}

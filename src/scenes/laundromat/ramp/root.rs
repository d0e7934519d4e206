//! What the force of a drum that speeds up does through one root of the suspension.

use super::drum::Drum;
use crate::faddeeva::upper_half;
use crate::scenes::laundromat::frames::LARGEST_EXPONENT;
use crate::two_part::TwoPart;
use crate::wide::functions::{ROUNDABLE, exp, sin_cos_quarters};
use nalgebra::Complex;
use std::f64::consts::PI;

/// What the force does through one root λ: `P = ∫ e^{λ(t−s)} e^{iφ(s)} ds` and its weights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Root {
    decay: f64,            // −Re λ
    passing: TwoPart,      // the time at which Faddeeva's argument crosses the real axis
    slope: f64,            // ½√α
    lift: f64,             // Re λ/√α
    left_behind: [f64; 4], // of what remains of the passing: x, y, ẋ, ẏ in the direction of its phase
    beside: [f64; 4],      // and of Faddeeva's function times the load's direction
    phase_rate: TwoPart,   // quarter turns
    phase: TwoPart,
    late: f64, // 1 if the passing lies before the start
}

impl Root {
    /// For the root −decay + i·turning, and its difference from the other.
    pub(super) fn new(drum: &Drum, (decay, turning): (f64, TwoPart), difference: Complex<f64>) -> Self {
        let alpha = TwoPart::from(drum.acceleration);
        let width = drum.acceleration.sqrt();
        let root = Complex::new(-decay, turning.rounded());
        let ahead = turning - TwoPart::from(drum.spin);
        let passing = (ahead + TwoPart::from(decay)) / alpha;
        // The phase of what is left behind: Im λ t + ((Re λ)² − (Im λ − Ω)²)/2α.
        let square = TwoPart::product(decay, decay) - ahead * ahead;
        let quarters = TwoPart::from(2.0) / TwoPart::PI;
        let phase = square / (alpha * 2.0) * quarters;
        // A phase that cannot be reduced is that of a passing beyond reach, or of one that damping leaves nothing of.
        let phase = if phase.rounded().abs() < ROUNDABLE { phase } else { TwoPart::from(0.0) };
        let kappa = Complex::new(1.0, 1.0) * (PI.sqrt() / (2.0 * width));
        let position = root * root * kappa / difference;
        let velocity = position * root;
        let numbers = [position.re, position.im, velocity.re, velocity.im];
        Self {
            decay,
            passing,
            slope: 0.5 * width,
            lift: -decay / width,
            left_behind: numbers.map(|number| 2.0 * number),
            beside: numbers,
            phase_rate: turning * quarters,
            phase,
            late: if passing.rounded() < 0.0 { 1.0 } else { 0.0 },
        }
    }

    /// Before this time what would have to be taken away leaves the range of the exponential.
    pub(super) fn earliest(&self) -> f64 {
        if self.late == 0.0 {
            f64::NEG_INFINITY
        } else {
            self.passing.rounded() - LARGEST_EXPONENT / self.decay
        }
    }

    /// Adds c P and cλ P for this root, c = ±λ²/(λ₁ − λ₂), to x, y, ẋ, ẏ.
    #[inline(always)]
    pub(super) fn add<const N: usize>(
        &self,
        times: &[f64; N],
        g_cos: &[f64; N],
        g_sin: &[f64; N],
        sum: &mut [[f64; N]; 4],
    ) {
        let (passing, passing_low) = self.passing.parts();
        let (phase, phase_low) = self.phase.parts();
        let (mut re, mut im, mut side) = ([0.0; N], [0.0; N], [0.0; N]);
        for n in 0..N {
            let past = (times[n] - passing) - passing_low;
            side[n] = if past < 0.0 { 1.0 } else { -1.0 };
            re[n] = side[n] * (self.lift - self.slope * past);
            im[n] = self.slope * past.abs();
        }
        let [w_re, w_im] = upper_half(&[re, im]);
        for n in 0..N {
            let past = (times[n] - passing) - passing_low;
            let (beside_re, beside_im) = (
                side[n] * (w_re[n] * g_cos[n] - w_im[n] * g_sin[n]),
                side[n] * (w_re[n] * g_sin[n] + w_im[n] * g_cos[n]),
            );
            let (turned, turned_low) = (self.phase_rate * times[n]).parts();
            let (high, low) = (TwoPart::sum(turned, phase) + (turned_low + phase_low)).parts();
            let (sin, cos) = sin_cos_quarters(high, low);
            let counts = (0.5 - 0.5 * side[n]) - self.late;
            let exponent = -self.lift * self.lift - self.decay * past;
            let size = counts * exp(if counts == 0.0 { 0.0 } else { exponent });
            let (left_re, left_im) = (size * cos, size * sin);
            for i in [0, 2] {
                let ([a, b], [c, d]) =
                    ([self.beside[i], self.beside[i + 1]], [self.left_behind[i], self.left_behind[i + 1]]);
                sum[i][n] += (a * beside_re - b * beside_im) + (c * left_re - d * left_im);
                sum[i + 1][n] += (a * beside_im + b * beside_re) + (c * left_im + d * left_re);
            }
        }
    }
}

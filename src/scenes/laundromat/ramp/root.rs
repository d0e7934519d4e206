//! One root of the suspension, and what the force of a drum that speeds up does through it.

use super::drum::Drum;
use crate::elementary::{exp_or_infinity, remainder, sin_cos_quarters};
use crate::faddeeva::upper_half;
use crate::scenes::laundromat::Shaft;
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// A root λ with its weight ±λ²/(λ₁ − λ₂) in `eq:ramp-motion`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Root {
    decay: f64,            // −Re λ
    passing: TwoPart,      // the time at which ξ of eq:ramp-arguments crosses the real axis
    slope: f64,            // ½√α
    lift: f64,             // Re λ/√α
    around: [f64; 4],      // of Faddeeva's function times the load's direction: x, y, ẋ, ẏ
    left_behind: [f64; 4], // and of what remains of the passing, in the direction of its phase
    phase_rate: TwoPart,   // quarter turns
    phase: (f64, f64),
    passed: f64, // 1 if the passing lies before the start
}

impl Root {
    /// For −Re λ, Im λ and the difference of λ from the other root.
    pub(super) fn new(drum: &Drum, (decay, turning): (f64, TwoPart), difference: Complex<f64>) -> Self {
        let acceleration = TwoPart::from(drum.acceleration);
        let ahead = turning - TwoPart::from(drum.spin);
        let passing = (ahead + TwoPart::from(decay)) / acceleration;
        // Of what the passing leaves behind, carried back to time zero.
        let phase = (TwoPart::product(decay, decay) - ahead * ahead) / (acceleration * TwoPart::PI);
        let (high, low) = phase.parts();
        let lambda = Complex::new(-decay, turning.rounded());
        let position = lambda * lambda / difference * drum.scale();
        let around = Shaft { position, velocity: position * lambda }.to_array();
        let width = drum.acceleration.sqrt();
        Self {
            decay,
            passing,
            slope: 0.5 * width,
            lift: -decay / width,
            around,
            left_behind: around.map(|number| 2.0 * number),
            phase_rate: turning * 2.0 / TwoPart::PI,
            phase: remainder(high, low, 4.0),
            passed: if passing.rounded() < 0.0 { 1.0 } else { 0.0 },
        }
    }

    /// Adds S and λS of `eq:ramp-integral`, with the weight, to x, y, ẋ, ẏ; of a passing before the start, less what
    /// that leaves behind, which the free motion then has. Infinite or NaN so long before the start that this is
    /// beyond the largest number.
    #[inline(always)]
    pub(super) fn add_to<const N: usize, const ONE: bool>(
        &self,
        sum: &mut [[f64; N]; 4],
        times: &[f64; N],
        [load_cos, load_sin]: &[[f64; N]; 2],
    ) {
        let (passing, passing_low) = self.passing.parts();
        let (phase, phase_low) = self.phase;
        let (mut re, mut im, mut side) = ([0.0; N], [0.0; N], [0.0; N]);
        for n in 0..N {
            let past = (times[n] - passing) - passing_low;
            side[n] = if past < 0.0 { 1.0 } else { -1.0 };
            // ξ of eq:ramp-arguments, or −ξ once it is below the real axis
            re[n] = side[n] * (self.lift - self.slope * past);
            im[n] = self.slope * past.abs();
        }
        let [w_re, w_im] = upper_half::<N, ONE>(&[re, im]);
        for n in 0..N {
            let past = (times[n] - passing) - passing_low;
            let (cos, sin) = (load_cos[n], load_sin[n]);
            let around_re = side[n] * (w_re[n] * cos - w_im[n] * sin);
            let around_im = side[n] * (w_re[n] * sin + w_im[n] * cos);
            // e^{λφ̇/α + i(λ² − Ω²)/2α}: the real part of the exponent is Re λ (φ̇ − Im λ)/α; the imaginary part, of
            // any size, is Im λ t + ½((Re λ)² − (Im λ − Ω)²)/α, from 32 digits.
            let (turned, turned_low) = (self.phase_rate * times[n]).parts();
            let (high, low) = (TwoPart::sum(turned, phase) + (turned_low + phase_low)).parts();
            let (sin, cos) = sin_cos_quarters::<ONE>(high, low);
            let counts = (0.5 - 0.5 * side[n]) - self.passed;
            let exponent = -self.lift * self.lift - self.decay * past;
            let size = counts * exp_or_infinity(if counts == 0.0 { 0.0 } else { exponent });
            let (left_re, left_im) = (size * cos, size * sin);
            for i in [0, 2] {
                let ([a, b], [c, d]) =
                    ([self.around[i], self.around[i + 1]], [self.left_behind[i], self.left_behind[i + 1]]);
                sum[i][n] += (a * around_re - b * around_im) + (c * left_re - d * left_im);
                sum[i + 1][n] += (a * around_im + b * around_re) + (c * left_im + d * left_re);
            }
        }
    }
}

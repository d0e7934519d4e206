//! The free motion of a damped oscillator, exact from no damping through critical to very heavy damping, for a spring
//! that pulls or pushes.

use crate::two_part::TwoPart;
use nalgebra::Complex;

/// ẍ + Γẋ + κx = 0 with Γ ≥ 0 and κ of any sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Oscillator {
    damping: f64,
    stiffness: f64,
    roots: Roots,
}

/// The solutions e^{λt}.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Roots {
    /// λ = −Γ/2 ± iω₁ with ω₁ > 0.
    Turning { frequency: TwoPart },
    /// λ = −slow and −fast, and their difference `gap` = fast − slow ≥ 0. A pushing spring has slow < 0.
    Real { slow: f64, fast: f64, gap: f64 },
}

/// Two real exponentials further apart than e to this are out of all proportion.
const STEEP: f64 = 350.0;

/// A displacement and its rate, both still to be multiplied by e^{exponent}.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scaled {
    pub(crate) position: Complex<f64>,
    pub(crate) velocity: Complex<f64>,
    pub(crate) exponent: f64,
}

impl Oscillator {
    pub(crate) fn new(damping: TwoPart, stiffness: TwoPart) -> Self {
        // ω₁² to 32 digits, so that it has 16 left when Γ is within rounding of 2ω₀.
        let frequency_squared = stiffness - damping * damping * 0.25;
        let roots = if frequency_squared.rounded() > 0.0 {
            Roots::Turning { frequency: frequency_squared.sqrt() }
        } else {
            let half_gap = (-frequency_squared).sqrt();
            let fast = damping * 0.5 + half_gap;
            let slow = stiffness / fast; // eq:slow-root
            Roots::Real { slow: slow.rounded(), fast: fast.rounded(), gap: 2.0 * half_gap.rounded() }
        };
        Self { damping: damping.rounded(), stiffness: stiffness.rounded(), roots }
    }

    /// Γ.
    pub(crate) fn damping(&self) -> f64 {
        self.damping
    }

    /// κ.
    pub(crate) fn stiffness(&self) -> f64 {
        self.stiffness
    }

    pub(crate) fn roots(&self) -> Roots {
        self.roots
    }

    /// The two ω of the solutions e^{iωt}: ±ω₁ + iΓ/2, or i times the fast and the slow rate.
    pub(crate) fn frequencies(&self) -> [Complex<f64>; 2] {
        match self.roots {
            Roots::Turning { frequency } => {
                let decay = 0.5 * self.damping;
                [Complex::new(frequency.rounded(), decay), Complex::new(-frequency.rounded(), decay)]
            }
            Roots::Real { slow, fast, .. } => [Complex::new(0.0, fast), Complex::new(0.0, slow)],
        }
    }

    /// The free motion of `eq:transient` that passes through `position` with `velocity` at time zero, at time `t`
    /// before or after.
    pub(crate) fn at(&self, position: Complex<f64>, velocity: Complex<f64>, t: f64) -> Scaled {
        match self.roots {
            Roots::Turning { frequency } => {
                let (sin, cos) = (frequency * t).sin_cos();
                let quotient = sin / frequency.rounded(); // t sinc(ω₁t), down to the smallest ω₁
                let half = 0.5 * self.damping; // Γ/2
                Scaled {
                    position: position * cos + (velocity + position * half) * quotient,
                    velocity: velocity * cos - (position * self.stiffness + velocity * half) * quotient,
                    exponent: -half * t,
                }
            }
            Roots::Real { slow, fast, gap } => {
                // Take out the slow exponential; long before the start, where the other is out of all proportion,
                // that one.
                let steep = -gap * t > STEEP;
                let (rate, gap) = if steep { (fast, -gap) } else { (slow, gap) };
                let left = (-gap * t).exp();
                let passed = if gap == 0.0 { t } else { -(-gap * t).exp_m1() / gap }; // ∫ of `left` over time
                Scaled {
                    // Twice the same number, each time without a difference of what may be almost equal.
                    position: if steep {
                        position * left + (velocity + position * slow) * passed
                    } else {
                        position + (velocity + position * slow) * passed
                    },
                    velocity: velocity * left - (position * self.stiffness + velocity * rate) * passed,
                    exponent: -rate * t,
                }
            }
        }
    }
}

impl Scaled {
    /// Position and velocity multiplied out. Infinite where they overflow, and never NaN for finite contents.
    pub(crate) fn multiplied(self) -> (Complex<f64>, Complex<f64>) {
        let factor = self.exponent.exp();
        if factor.is_finite() {
            return (self.position * factor, self.velocity * factor);
        }
        // In two halves, neither of them infinite: zero stays zero, and what is representable is found.
        let half = (0.5 * self.exponent).exp().min(f64::MAX);
        (self.position * half * half, self.velocity * half * half)
    }
}

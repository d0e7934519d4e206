//! The free motion of a damped oscillator, exact from no damping through critical to very heavy damping, for a spring
//! that pulls or pushes.

use super::shaft::Shaft;
use crate::clock::Clock;
use crate::elementary::exp_or_infinity;
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// ẍ + Γẋ + κx = 0 with Γ ≥ 0 and κ of any sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Oscillator {
    damping: f64,
    stiffness: f64,
    roots: Roots,
}

/// The solutions e^{λt}.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Roots {
    /// λ = −Γ/2 ± iω₁ with ω₁ > 0.
    Turning { frequency: TwoPart },
    /// λ = −slow and −fast, and their difference `gap` = fast − slow ≥ 0. A pushing spring has slow < 0.
    Real { slow: f64, fast: f64, gap: f64 },
}

/// Two real exponentials further apart than e to this are out of all proportion.
const STEEP: f64 = 350.0;

/// The free motion of `eq:transient` through a displacement with a velocity at time zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum FreeMotion {
    /// Of light damping.
    Turning(Swing),
    /// Of critical and heavy damping, and of a spring that pushes.
    Real { start: Shaft, stiffness: f64, slow: f64, fast: f64, gap: f64 },
}

/// A constant times cosine and another times sine, each the four numbers x, y, ẋ, ẏ, and their decay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Swing {
    clock: Clock,
    half_damping: f64, // Γ/2
    cos: [f64; 4],
    sin: [f64; 4],
}

/// A displacement and its rate, both still to be multiplied by e^{exponent}.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scaled {
    pub(super) shaft: Shaft,
    pub(super) exponent: f64,
}

impl Oscillator {
    pub(super) fn new(damping: TwoPart, stiffness: TwoPart) -> Self {
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

    pub(super) fn roots(&self) -> Roots {
        self.roots
    }

    /// The two ω of the solutions e^{iωt}: ±ω₁ + iΓ/2, or i times the fast and the slow rate.
    pub(super) fn frequencies(&self) -> [Complex<f64>; 2] {
        match self.roots {
            Roots::Turning { frequency } => {
                let decay = 0.5 * self.damping;
                [Complex::new(frequency.rounded(), decay), Complex::new(-frequency.rounded(), decay)]
            }
            Roots::Real { slow, fast, .. } => [Complex::new(0.0, fast), Complex::new(0.0, slow)],
        }
    }

    /// The free motion from a start.
    pub(super) fn from(&self, start: Shaft) -> FreeMotion {
        let Self { damping, stiffness, roots } = *self;
        match roots {
            Roots::Turning { frequency } => {
                let half_damping = 0.5 * damping;
                let push = start.velocity + start.position * half_damping;
                let pull = start.position * stiffness + start.velocity * half_damping;
                let per_turn = frequency.rounded(); // over it sin ω₁t is t sinc(ω₁t), down to the smallest ω₁
                let sin = Shaft { position: push / per_turn, velocity: -pull / per_turn };
                let clock = Clock::from_rate(frequency);
                FreeMotion::Turning(Swing { clock, half_damping, cos: start.to_array(), sin: sin.to_array() })
            }
            Roots::Real { slow, fast, gap } => FreeMotion::Real { start, stiffness, slow, fast, gap },
        }
    }
}

impl FreeMotion {
    /// The motion at a time, s, before or after the start.
    pub(super) fn at(&self, time: f64) -> Scaled {
        match *self {
            Self::Turning(swing) => Scaled {
                shaft: Shaft::from_array(swing.turned::<true>(time)),
                exponent: -swing.half_damping * time,
            },
            Self::Real { start: Shaft { position, velocity }, stiffness, slow, fast, gap } => {
                // Take out the slow exponential; long before the start, where the other is out of all proportion,
                // that one.
                let steep = -gap * time > STEEP;
                let (rate, gap) = if steep { (fast, -gap) } else { (slow, gap) };
                let left = (-gap * time).exp();
                let passed = if gap == 0.0 { time } else { -(-gap * time).exp_m1() / gap }; // ∫ of `left` over time
                let shaft = Shaft {
                    // Twice the same number, each time without a difference of what may be almost equal.
                    position: if steep {
                        position * left + (velocity + position * slow) * passed
                    } else {
                        position + (velocity + position * slow) * passed
                    },
                    velocity: velocity * left - (position * stiffness + velocity * rate) * passed,
                };
                Scaled { shaft, exponent: -rate * time }
            }
        }
    }
}

impl Swing {
    /// Up to which time, of either sign, it can be had for many times at once.
    pub(super) fn reach(&self) -> f64 {
        self.clock.reach()
    }

    /// x, y, ẋ, ẏ without the decay.
    #[inline(always)]
    fn turned<const ONE: bool>(&self, time: f64) -> [f64; 4] {
        let (sin, cos) = self.clock.sin_cos::<ONE>(time);
        std::array::from_fn(|i| self.cos[i] * cos + self.sin[i] * sin)
    }

    /// x, y, ẋ, ẏ at a time within reach, without a branch. Infinite or NaN long before the start.
    #[inline(always)]
    pub(super) fn at(&self, time: f64) -> [f64; 4] {
        let decay = exp_or_infinity(-self.half_damping * time);
        self.turned::<false>(time).map(|number| decay * number)
    }
}

impl Scaled {
    /// Position and velocity multiplied out. Infinite where they overflow, and never NaN for finite contents.
    pub(super) fn multiplied(self) -> Shaft {
        let Self { shaft, exponent } = self;
        let factor = exponent.exp();
        if factor.is_finite() {
            return shaft.times(factor);
        }
        // In two halves, neither of them infinite: zero stays zero, and what is representable is found.
        let half = (0.5 * exponent).exp().min(f64::MAX);
        shaft.times(half).times(half)
    }
}

/// The square of an argument beside which one is all that is left.
const MIN_SQUARE: f64 = 1e-40;

/// (eˣ − 1)/x, the mean of eˣ over a way from 0 to x.
pub(super) fn mean_exponential(x: Complex<f64>) -> Complex<f64> {
    if x.norm_sqr() < MIN_SQUARE {
        return 1.0.into(); // and ½x more, which is lost; the division would lose all
    }
    let half = (0.5 * x.im).sin();
    let less_one = Complex::new(x.re.exp_m1() * x.im.cos() - 2.0 * half * half, x.re.exp() * x.im.sin());
    less_one / x
}

//! Many frames of a lightly damped machine at once.

use super::oscillator::{Oscillator, Roots};
use super::shaft::Shaft;
use super::transient::{Form, Transient};
use crate::two_part::TwoPart;
use crate::wide::functions::{Clock, exp, sin_cos_quarters};
use crate::wide::{Branchless, several_at_once};
use nalgebra::Complex;

/// Beyond this size of the exponent e^{−Γt/2} nears the ends of the range of `f64`.
pub(super) const LARGEST_EXPONENT: f64 = 650.0;

/// A free, lightly damped motion as a constant times cosine and another times sine, each the four numbers of x, y, ẋ, ẏ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Swing {
    clock: Clock,
    half_damping: f64,
    reach: f64,
    cos: [f64; 4],
    sin: [f64; 4],
}

/// The motion of `eq:transient` as a steady circle and a free swing.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frames {
    load: Clock,
    reach: f64,
    circle_cos: [f64; 4],
    circle_sin: [f64; 4],
    swing: Swing,
}

fn numbers(position: Complex<f64>, velocity: Complex<f64>) -> [f64; 4] {
    [position.re, position.im, velocity.re, velocity.im]
}

impl Swing {
    /// The free motion through a displacement with a velocity at time zero; `None` for critical and heavy damping.
    pub(super) fn new(free: &Oscillator, displacement: Complex<f64>, velocity: Complex<f64>) -> Option<Self> {
        let Roots::Turning { frequency } = free.roots() else {
            return None;
        };
        let half_damping = 0.5 * free.damping();
        let bent = displacement * free.stiffness() + velocity * half_damping;
        let clock = Clock::from_rate(frequency);
        let frequency = frequency.rounded();
        let pushed = (velocity + displacement * half_damping) / frequency;
        Some(Self {
            clock,
            half_damping,
            reach: clock.reach().min(LARGEST_EXPONENT / half_damping),
            cos: numbers(displacement, velocity),
            sin: numbers(pushed, -bent / frequency),
        })
    }

    /// Up to which time, of either sign, [`Swing::at`] can go.
    pub(super) fn reach(&self) -> f64 {
        self.reach
    }

    /// x, y, ẋ, ẏ at a time, without a branch.
    #[inline(always)]
    pub(super) fn at(&self, time: f64) -> [f64; 4] {
        let (high, low) = self.clock.at(time);
        let (sin, cos) = sin_cos_quarters(high, low);
        let decay = exp(-self.half_damping * time);
        let (sin, cos) = (decay * sin, decay * cos);
        std::array::from_fn(|i| self.cos[i] * cos + self.sin[i] * sin)
    }
}

impl Frames {
    /// `None` for heavy damping and near resonance without damping, which have forms of their own.
    pub(super) fn new(transient: &Transient) -> Option<Self> {
        let Form::Circle { amplitude, displacement, velocity, .. } = transient.form else {
            return None;
        };
        let swing = Swing::new(&transient.free, displacement, velocity)?;
        let spin = transient.spin;
        let quarter = Complex::new(-amplitude.im, amplitude.re); // i Z
        let load = Clock::from_rate(TwoPart::from(spin));
        Some(Self {
            load,
            reach: load.reach().min(swing.reach()),
            circle_cos: numbers(amplitude, quarter * spin),
            circle_sin: numbers(quarter, -amplitude * spin),
            swing,
        })
    }

    /// Fills the frames at times within reach and says how many, as [`several_at_once`] does.
    pub(super) fn fill(&self, times: &[f64], frames: &mut [Shaft]) -> usize {
        several_at_once(*self, -self.reach..=self.reach, times, frames)
    }
}

impl Branchless for Frames {
    type State = Shaft;

    #[inline(always)]
    fn at(&self, time: f64) -> Shaft {
        let (high, low) = self.load.at(time);
        let (sin, cos) = sin_cos_quarters(high, low);
        let free = self.swing.at(time);
        let number = |i: usize| (self.circle_cos[i] * cos + self.circle_sin[i] * sin) + free[i];
        Shaft { position: Complex::new(number(0), number(1)), velocity: Complex::new(number(2), number(3)) }
    }

    #[inline(always)]
    fn is_finite(frame: &Shaft) -> bool {
        frame.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::{Frames, Shaft};
    use crate::scenes::laundromat::{Machine, Parameters};

    #[test]
    fn a_light_machine_away_from_resonance_is_filled_at_once() {
        let times: Vec<f64> = (0..640).map(|n| 2.0 * f64::from(n) - 640.0).collect();
        for (damping, spin) in [(0.0, 3.0), (0.5, -3.0), (1.9, 0.0), (0.0, -0.2)] {
            let (drum_mass, load_mass, load_radius, stiffness) = (0.0, 1.0, 1.0, 1.0);
            let parameters = Parameters { drum_mass, load_mass, load_radius, stiffness, damping, spin };
            let motion = Machine::new(parameters).unwrap().transient(Shaft::AT_REST).unwrap();
            let mut frames = vec![Shaft::AT_REST; times.len()];
            assert_eq!(Frames::new(&motion).unwrap().fill(&times, &mut frames), 640, "{damping} {spin}");
        }
    }
}

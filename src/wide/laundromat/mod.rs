//! The drum's shaft at many times at once, of lightly damped machines: turning steadily away from resonance,
//! and speeding up.

mod ramp;

pub(crate) use ramp::sample_ramp;

use super::functions::{Clock, exp, sin_cos_quarters};
use super::{Branchless, sample, several_at_once};
use crate::quantity::InvalidQuantity;
use crate::scenes::laundromat::oscillator::{Oscillator, Roots};
use crate::scenes::laundromat::{Shaft, Transient};
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// Beyond this size of the exponent e^{−Γt/2} nears the ends of the range of `f64`.
const LARGEST_EXPONENT: f64 = 650.0;

/// The states of a motion at constant speed.
pub(crate) fn sample_transient(motion: &Transient, times: &[f64]) -> Result<Vec<Shaft>, InvalidQuantity> {
    let kernel = Steady::new(motion);
    let quick = |times: &[f64], states: &mut [Shaft]| kernel.map_or(0, |kernel| kernel.fill(times, states));
    sample(times, Shaft::AT_REST, quick, |time| motion.at(time))
}

/// A position and a velocity as x, y, ẋ, ẏ.
fn numbers(position: Complex<f64>, velocity: Complex<f64>) -> [f64; 4] {
    Shaft { position, velocity }.to_array()
}

/// A free, lightly damped motion as a constant times cosine and another times sine, each the four numbers of x, y, ẋ,
/// ẏ.
#[derive(Debug, Clone, Copy)]
struct Swing {
    clock: Clock,
    half_damping: f64,
    reach: f64,
    cos: [f64; 4],
    sin: [f64; 4],
}

impl Swing {
    /// The free motion through a displacement with a velocity at time zero; `None` for critical and heavy damping.
    fn new(free: &Oscillator, displacement: Complex<f64>, velocity: Complex<f64>) -> Option<Self> {
        let Roots::Turning { frequency } = free.roots() else {
            return None;
        };
        let half_damping = 0.5 * free.damping();
        let pull = displacement * free.stiffness() + velocity * half_damping;
        let clock = Clock::from_rate(frequency);
        let frequency = frequency.rounded();
        let push = velocity + displacement * half_damping;
        Some(Self {
            clock,
            half_damping,
            reach: clock.reach().min(LARGEST_EXPONENT / half_damping),
            cos: numbers(displacement, velocity),
            sin: numbers(push / frequency, -pull / frequency),
        })
    }

    /// x, y, ẋ, ẏ at a time within reach, without a branch.
    #[inline(always)]
    fn at(&self, time: f64) -> [f64; 4] {
        let (high, low) = self.clock.at(time);
        let (sin, cos) = sin_cos_quarters(high, low);
        let decay = exp(-self.half_damping * time);
        let (sin, cos) = (decay * sin, decay * cos);
        std::array::from_fn(|i| self.cos[i] * cos + self.sin[i] * sin)
    }
}

/// The steady circle and a free swing.
#[derive(Debug, Clone, Copy)]
struct Steady {
    load: Clock,
    reach: f64,
    circle_cos: [f64; 4],
    circle_sin: [f64; 4],
    swing: Swing,
}

impl Steady {
    fn new(motion: &Transient) -> Option<Self> {
        let (spin, circle, free) = motion.circle()?;
        let swing = Swing::new(&free, circle.displacement, circle.velocity)?;
        let amplitude = circle.amplitude;
        let quarter = Complex::<f64>::i() * amplitude;
        let load = Clock::from_rate(TwoPart::from(spin));
        Some(Self {
            load,
            reach: load.reach().min(swing.reach),
            circle_cos: numbers(amplitude, quarter * spin),
            circle_sin: numbers(quarter, -amplitude * spin),
            swing,
        })
    }

    fn fill(&self, times: &[f64], states: &mut [Shaft]) -> usize {
        several_at_once(*self, -self.reach..=self.reach, times, states)
    }
}

impl Branchless for Steady {
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
    fn is_finite(state: &Shaft) -> bool {
        state.is_finite()
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::Steady;
    use crate::scenes::laundromat::{Machine, Parameters, Shaft};

    pub(super) fn machine(damping: f64, spin: f64) -> Machine {
        let (drum_mass, load_mass, load_radius, stiffness) = (0.0, 1.0, 1.0, 1.0);
        Machine::new(Parameters { drum_mass, load_mass, load_radius, stiffness, damping, spin }).unwrap()
    }

    #[test]
    fn a_light_machine_away_from_resonance_is_done_at_once() {
        let times: Vec<f64> = (0..640).map(|n| 2.0 * f64::from(n) - 640.0).collect();
        for (damping, spin) in [(0.0, 3.0), (0.5, -3.0), (1.9, 0.0), (0.0, -0.2)] {
            let motion = machine(damping, spin).transient(Shaft::AT_REST).unwrap();
            let mut states = vec![Shaft::AT_REST; times.len()];
            assert_eq!(Steady::new(&motion).unwrap().fill(&times, &mut states), 640, "{damping} {spin}");
        }
    }
}

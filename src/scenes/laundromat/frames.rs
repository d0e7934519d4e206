//! Many frames of a lightly damped machine at once.

use super::oscillator::Roots;
use super::shaft::Shaft;
use super::transient::{Form, Transient};
use crate::branchless::{Clock, exp, sin_cos_quarters};
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// Frames are computed in blocks of this many: enough for the widest registers, and small enough for the nearest memory.
const BLOCK: usize = 32;

/// Beyond this size of the exponent e^{−Γt/2} nears the ends of the range of `f64`.
const LARGEST_EXPONENT: f64 = 650.0;

/// The motion of `eq:transient` as a steady circle and a free swing, each a constant times cosine and another times sine:
/// four numbers of x, y, ẋ, ẏ for each of the four functions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frames {
    load: Clock,
    swing: Clock,
    half_damping: f64,
    reach: f64,
    circle_cos: [f64; 4],
    circle_sin: [f64; 4],
    swing_cos: [f64; 4],
    swing_sin: [f64; 4],
}

fn numbers(position: Complex<f64>, velocity: Complex<f64>) -> [f64; 4] {
    [position.re, position.im, velocity.re, velocity.im]
}

impl Frames {
    /// `None` for heavy damping and near resonance without damping, which have forms of their own.
    pub(super) fn new(transient: &Transient) -> Option<Self> {
        let (Form::Circle { amplitude, displacement, velocity, .. }, Roots::Turning { frequency }) =
            (transient.form, transient.free.roots())
        else {
            return None;
        };
        let (spin, half_damping) = (transient.spin, 0.5 * transient.free.damping());
        let quarter = Complex::new(-amplitude.im, amplitude.re); // i Z
        let bent = displacement * transient.free.stiffness() + velocity * half_damping;
        let frequency_rounded = frequency.rounded();
        let load = Clock::from_rate(TwoPart::from(spin));
        let swing = Clock::from_rate(frequency);
        let reach = load.reach().min(swing.reach()).min(LARGEST_EXPONENT / half_damping);
        Some(Self {
            load,
            swing,
            half_damping,
            reach,
            circle_cos: numbers(amplitude, quarter * spin),
            circle_sin: numbers(quarter, -amplitude * spin),
            swing_cos: numbers(displacement, velocity),
            swing_sin: numbers(
                (velocity + displacement * half_damping) / frequency_rounded,
                -bent / frequency_rounded,
            ),
        })
    }

    /// Fills as many frames as there are times and says so; leaves alone, and counts not, the block in which a time is out of
    /// reach or not a number, and what follows it.
    pub(super) fn fill(&self, times: &[f64], frames: &mut [Shaft]) -> usize {
        let mut done = 0;
        for (times, frames) in times.chunks(BLOCK).zip(frames.chunks_mut(BLOCK)) {
            if !times.iter().all(|time| time.abs() <= self.reach) {
                break;
            }
            for (&time, frame) in times.iter().zip(frames) {
                *frame = self.at(time);
            }
            done += times.len();
        }
        done
    }

    /// One frame, without a branch: the loop above does several in one instruction.
    #[inline(always)]
    fn at(&self, time: f64) -> Shaft {
        let (high, low) = self.load.at(time);
        let (load_sin, load_cos) = sin_cos_quarters(high, low);
        let (high, low) = self.swing.at(time);
        let (sin, cos) = sin_cos_quarters(high, low);
        let decay = exp(-self.half_damping * time);
        let (sin, cos) = (decay * sin, decay * cos);
        let number = |i: usize| {
            (self.circle_cos[i] * load_cos + self.circle_sin[i] * load_sin)
                + (self.swing_cos[i] * cos + self.swing_sin[i] * sin)
        };
        Shaft { position: Complex::new(number(0), number(1)), velocity: Complex::new(number(2), number(3)) }
    }
}

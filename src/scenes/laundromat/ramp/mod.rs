//! A drum that speeds up steadily, through its resonance.

mod drum;
mod early;
mod pair;
mod root;

use super::frames::Swing;
use super::machine::Machine;
use super::oscillator::{InvalidTime, Oscillator, Roots, check_time};
use super::shaft::{InvalidStart, Shaft};
use crate::frames::{InvalidFrames, fill};
use crate::quantity::{InvalidQuantity, Rule};
use crate::wide::functions::at_full_width;
use crate::wide::{BLOCK, in_blocks};
use drum::{Drum, Forced};
use early::Early;
use nalgebra::Complex;
use root::Root;
use std::error::Error;
use std::fmt;

/// The motion of the shaft while the drum turns with `φ = Ωt + ½αt²`, in closed form (`eq:ramp-motion`).
///
/// From [`Machine::ramp`]. The drum meets its resonance at `t = (ω₁ − Ω)/α`; what is left behind of it is an error function of a
/// complex argument. An evaluation costs two of those, next to critical damping up to sixty-four.
///
/// The error of the position is at most forty units in the last place (`f64::EPSILON`) of the sum of b, of the motion itself, of what the free
/// motion has made of b and of the start, and of what a change of the time by such a unit makes of it; most often ten. That of
/// the velocity is as many units of the same for velocities, with b times the largest of the rates ω₀, Γ, √α and of the drum's spin,
/// then and at the start, for b. It holds whether the resonance lies ahead or behind or is where the drum starts.
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, Parameters, Shaft};
/// let machine = Machine::new(Parameters {
///     drum_mass: 28.0, load_mass: 2.0, load_radius: 0.25,
///     stiffness: 3000.0, damping: 3.0, spin: 0.0,
/// })?;
/// let ramp = machine.ramp(0.2, Shaft::AT_REST)?; // 0.2 rad/s², past the 10 rad/s of the resonance at 50 s
/// let largest = (0..1000)
///     .map(|n| Ok(ramp.at(0.1 * f64::from(n))?.position.norm()))
///     .try_fold(0.0_f64, |most, r: Result<f64, Box<dyn std::error::Error>>| Ok::<f64, Box<dyn std::error::Error>>(most.max(r?)))?;
/// // It does not stay long enough to shake as it would at a steady 10 rad/s.
/// assert!(largest < 0.5 * machine.with_spin(10.0)?.steady()?.radius());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramp {
    /// What is conjugated where the drum slows down: then everything is the mirror image of speeding up.
    mirrored: bool,
    drum: Drum,
    free: Oscillator,
    displacement: Complex<f64>,
    velocity: Complex<f64>,
    swing: Option<Swing>,
    forced: Forced,
    early: Option<Early>,
}

impl Machine {
    /// The motion from a given start while the drum speeds up from the machine's spin at the rate `acceleration`, rad/s², or slows
    /// down if that is negative; the load starts at azimuth zero.
    ///
    /// # Errors
    /// [`InvalidRamp`] unless the acceleration over the square of the natural frequency is between 1e-12 and 1e12 in size, and for
    /// a start that is not finite or beyond 1e50 m or m/s.
    pub fn ramp(&self, acceleration: f64, start: Shaft) -> Result<Ramp, InvalidRamp> {
        start.check_start()?;
        InvalidQuantity::check("angular acceleration", acceleration, "rad/s²")?;
        let ratio = acceleration.abs() / (self.natural_frequency() * self.natural_frequency());
        for (bound, holds) in [(Rule::AtLeast(1e-12), ratio >= 1e-12), (Rule::AtMost(1e12), ratio <= 1e12)] {
            let name = "angular acceleration over the square of the natural frequency";
            InvalidQuantity::require(holds, name, ratio, "", bound)?;
        }
        let mirrored = acceleration < 0.0;
        let reflect = |z: Complex<f64>| if mirrored { z.conj() } else { z };
        let drum = Drum::new(
            if mirrored { -self.spin() } else { self.spin() },
            acceleration.abs(),
            self.offset(),
            self.damping_rate(),
        );
        let free = Oscillator::new(self.precise_damping_rate(), self.stiffness_rate());
        let forced = drum.forced(&free);
        let [begin, begin_rate] = [reflect(start.position), reflect(start.velocity)];
        let (position, velocity) = drum.motion(&forced, 0.0);
        let (displacement, velocity) = (begin - position, begin_rate - velocity);
        let swing = Swing::new(&free, displacement, velocity);
        let early = match free.roots() {
            Roots::Turning { frequency } => {
                Early::new(&drum, (0.5 * self.damping_rate(), frequency), begin, begin_rate)
            }
            Roots::Real { .. } => None,
        };
        Ok(Ramp { mirrored, drum, free, displacement, velocity, swing, forced, early })
    }

    /// Rates of `[x, y, ẋ, ẏ]` at time `t`, s, while the drum turns with `φ = Ωt + ½αt²` (`eq:ramp-equation`), for an integrator. SI
    /// units.
    pub fn ramp_rates(&self, acceleration: f64, t: f64, &[x, y, vx, vy]: &[f64; 4]) -> [f64; 4] {
        let spin = self.spin() + acceleration * t;
        let (sin, cos) = ((self.spin() + 0.5 * acceleration * t) * t).sin_cos();
        let [stiffness, damping] = [self.stiffness_rate().rounded(), self.damping_rate()];
        let (inward, along) = (self.offset() * spin * spin, self.offset() * acceleration);
        [
            vx,
            vy,
            inward * cos + along * sin - stiffness * x - damping * vx,
            inward * sin - along * cos - stiffness * y - damping * vy,
        ]
    }
}

impl Ramp {
    /// The drum's angular velocity at time `t`, s, rad/s.
    pub fn spin(&self, t: f64) -> f64 {
        let spin = self.drum.spin + self.drum.acceleration * t;
        if self.mirrored { -spin } else { spin }
    }

    /// Position and velocity of the shaft at time `t`, s, in the laboratory.
    ///
    /// # Errors
    /// [`InvalidTime`] if the time is not finite, or so far from the start that the drum has made some 1e13 turns, or so long before it
    /// that the motion there has grown by e⁶⁵⁰ or is beyond the largest number.
    pub fn at(&self, t: f64) -> Result<Shaft, InvalidTime> {
        check_time(t)?;
        let earliest = match &self.forced {
            Forced::Apart([one, other]) => one.earliest().max(other.earliest()),
            Forced::Together(_) => f64::NEG_INFINITY,
        };
        if t.abs() > self.drum.reach() {
            return Err(InvalidTime::TooManyTurns { time: t });
        }
        if t < earliest {
            return Err(InvalidTime::OutOfRange { time: t });
        }
        let ([displacement, rate], [position, velocity]) = match self.early(t) {
            Some(early) => ([early.displacement, early.velocity], early.motion(&self.drum, t)),
            None => ([self.displacement, self.velocity], self.drum.motion(&self.forced, t).into()),
        };
        let (s, s_dot) = self.free.at(displacement, rate, t).multiplied();
        let shaft = self.reflected(position + s, velocity + s_dot);
        if shaft.is_finite() { Ok(shaft) } else { Err(InvalidTime::OutOfRange { time: t }) }
    }

    /// The form for the time before the drum has left its resonance, if it is that early.
    fn early(&self, t: f64) -> Option<&Early> {
        self.early.as_ref().filter(|early| t.abs() < early.reach)
    }

    /// The shaft at each of `times`, s, written to `frames` without allocating; lightly damped machines several frames at once.
    ///
    /// # Errors
    /// [`InvalidFrames::Length`] if there are not as many frames as times, and then nothing is written;
    /// [`InvalidFrames::Time`] at the first time that [`Ramp::at`] refuses.
    pub fn fill(&self, times: &[f64], frames: &mut [Shaft]) -> Result<(), InvalidFrames<InvalidTime>> {
        let quick = |times: &[f64], frames: &mut [Shaft]| match (&self.swing, &self.forced) {
            (Some(swing), Forced::Apart(roots)) => self.fill_swinging(swing, roots, times, frames),
            _ => 0,
        };
        fill(times, frames, quick, |t| self.at(t))
    }

    fn fill_swinging(&self, swing: &Swing, roots: &[Root; 2], times: &[f64], frames: &mut [Shaft]) -> usize {
        let reach = swing.reach().min(self.drum.reach());
        let earliest = roots[0].earliest().max(roots[1].earliest());
        let reached = |time: f64| time.abs() <= reach && time >= earliest && self.early(time).is_none();
        in_blocks(times, frames, reached, |times, frames| {
            let mut padded = [0.0; BLOCK];
            padded[..times.len()].copy_from_slice(times);
            let forced = at_full_width(
                #[inline(always)]
                || self.drum.driven(roots, &padded),
            );
            for (n, frame) in frames.iter_mut().enumerate() {
                let free = swing.at(times[n]);
                let [x, y, vx, vy] = std::array::from_fn(|i| forced[i][n] + free[i]);
                *frame = self.reflected(Complex::new(x, y), Complex::new(vx, vy));
            }
            frames.iter().all(Shaft::is_finite)
        })
    }

    fn reflected(&self, position: Complex<f64>, velocity: Complex<f64>) -> Shaft {
        if self.mirrored {
            Shaft { position: position.conj(), velocity: velocity.conj() }
        } else {
            Shaft { position, velocity }
        }
    }
}

/// Why there is no ramp.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvalidRamp {
    /// The acceleration breaks its rule.
    Acceleration(InvalidQuantity),
    /// The start breaks its rule.
    Start(InvalidStart),
}

impl From<InvalidQuantity> for InvalidRamp {
    fn from(error: InvalidQuantity) -> Self {
        Self::Acceleration(error)
    }
}

impl From<InvalidStart> for InvalidRamp {
    fn from(error: InvalidStart) -> Self {
        Self::Start(error)
    }
}

impl fmt::Display for InvalidRamp {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Acceleration(error) => error.fmt(out),
            Self::Start(error) => error.fmt(out),
        }
    }
}

impl Error for InvalidRamp {}

#[cfg(test)]
mod tests {
    use super::{Forced, Shaft};
    use crate::scenes::laundromat::{Machine, Parameters};

    #[test]
    fn a_light_machine_is_filled_at_once_but_for_what_its_resonance_is_still_to_do() {
        let times: Vec<f64> = (0..640).map(|n| 0.3 * f64::from(n) - 96.0).collect();
        for (damping, spin, acceleration, expected) in
            [(0.0, 0.0, 0.02, 640), (0.5, 3.0, 0.02, 640), (1.5, -3.0, -0.02, 640), (0.0, 1.0, 1e-6, 0)]
        {
            let (drum_mass, load_mass, load_radius, stiffness) = (0.0, 1.0, 1.0, 1.0);
            let parameters = Parameters { drum_mass, load_mass, load_radius, stiffness, damping, spin };
            let ramp = Machine::new(parameters).unwrap().ramp(acceleration, Shaft::AT_REST).unwrap();
            let (Some(swing), Forced::Apart(roots)) = (&ramp.swing, &ramp.forced) else {
                panic!("{damping} is light damping")
            };
            let mut frames = vec![Shaft::AT_REST; times.len()];
            let filled = ramp.fill_swinging(swing, roots, &times, &mut frames);
            assert_eq!(filled, expected, "{damping} {spin} {acceleration}");
        }
    }
}

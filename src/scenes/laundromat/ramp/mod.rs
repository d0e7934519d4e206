//! A drum that speeds up steadily, through its resonance.

mod drum;
mod early;
mod root;
mod together;

pub(crate) use drum::{Drum, Forced};
pub(crate) use root::Root;

use super::machine::Machine;
use super::oscillator::Oscillator;
use super::shaft::Shaft;
use crate::quantity::{InvalidQuantity, Rule};
use crate::wide;
use early::Early;
use nalgebra::Complex;

/// The motion of the shaft while the drum turns with `φ = Ωt + ½αt²`, in closed form (`eq:ramp-motion`).
///
/// From [`Machine::ramp`]. The drum meets its resonance at `t = (ω₁ − Ω)/α`; what is left behind of it is an error
/// function of a complex argument. An evaluation costs two of those, next to critical damping up to thirty-two.
///
/// The error of the position is at most forty units in the last place (`f64::EPSILON`) of the sum of b, of the motion
/// itself, of what the free motion has made of b and of the start, and of what a change of the time by such a unit
/// makes of it; most often ten. That of the velocity is as many units of the same for velocities, with b times the
/// largest of the rates ω₀, Γ, √α and of the drum's spin, then and at the start, for b. It holds whether the
/// resonance lies ahead or behind or is where the drum starts.
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, Parameters, Shaft};
/// let machine = Machine::new(Parameters {
///     drum_mass: 28.0, load_mass: 2.0, load_radius: 0.25,
///     stiffness: 3000.0, damping: 3.0, spin: 0.0,
/// })?;
/// let ramp = machine.ramp(0.2, Shaft::AT_REST)?; // 0.2 rad/s², past the 10 rad/s of the resonance at 50 s
/// let times: Vec<f64> = (0..1000).map(|n| 0.1 * f64::from(n)).collect();
/// let largest = ramp.sample(&times)?.iter().map(|shaft| shaft.position.norm()).fold(0.0, f64::max);
/// // It does not stay long enough to shake as it would at a steady 10 rad/s.
/// assert!(largest < 0.5 * machine.with_spin(10.0)?.steady()?.radius());
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramp {
    /// Everything is the mirror image of a drum that speeds up: this one slows down.
    pub(crate) mirrored: bool,
    pub(crate) drum: Drum,
    pub(crate) free: Oscillator,
    pub(crate) late: Motion,
    early: Option<(f64, Motion)>,
}

/// `eq:ramp-motion`: what the force does, and the free motion that this leaves of the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Motion {
    pub(crate) forced: Forced,
    pub(crate) displacement: Complex<f64>,
    pub(crate) velocity: Complex<f64>,
}

impl Motion {
    fn new(forced: Forced, drum: &Drum, start: Shaft) -> Self {
        let at_start = forced.motion(drum, 0.0);
        Self {
            forced,
            displacement: start.position - at_start.position,
            velocity: start.velocity - at_start.velocity,
        }
    }
}

impl Machine {
    /// The motion from a given start while the drum speeds up from the machine's spin at the rate `acceleration`,
    /// rad/s², or slows down if that is negative; the load starts at azimuth zero.
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless the acceleration over the square of the natural frequency is between 1e-12 and 1e12
    /// in size, and for a start that is not finite or beyond 1e50 m or m/s.
    pub fn ramp(&self, acceleration: f64, start: Shaft) -> Result<Ramp, InvalidQuantity> {
        start.check_start()?;
        InvalidQuantity::check("angular acceleration", acceleration, "rad/s²")?;
        let ratio = acceleration.abs() / (self.natural_frequency() * self.natural_frequency());
        for (bound, holds) in [(Rule::AtLeast(1e-12), ratio >= 1e-12), (Rule::AtMost(1e12), ratio <= 1e12)] {
            let name = "angular acceleration over the square of the natural frequency";
            InvalidQuantity::require(holds, name, ratio, "", bound)?;
        }
        let mirrored = acceleration < 0.0;
        let start = if mirrored { start.mirror_image() } else { start };
        let drum = Drum {
            spin: if mirrored { -self.spin() } else { self.spin() },
            acceleration: acceleration.abs(),
            offset: self.offset(),
            damping: self.damping_rate(),
        };
        let free = Oscillator::new(self.precise_damping_rate(), self.stiffness_rate());
        let late = Motion::new(Forced::new(&drum, &free), &drum, start);
        let early = Early::new(&drum, &free)
            .map(|early| (early.reach, Motion::new(Forced::Early(early), &drum, start)));
        Ok(Ramp { mirrored, drum, free, late, early })
    }

    /// Rates of `[x, y, ẋ, ẏ]` at time `t`, s, while the drum turns with `φ = Ωt + ½αt²` (`eq:ramp-equation`), for an
    /// integrator. SI units.
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

    /// Position and velocity of the shaft at a time, s, in the laboratory.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the time is not finite or beyond 1e50 s, or if it lies so long before the start of a
    /// damped machine that the motion there is beyond the largest number.
    pub fn at(&self, time: f64) -> Result<Shaft, InvalidQuantity> {
        InvalidQuantity::check_time(time)?;
        let motion = match &self.early {
            Some((until, early)) if time.abs() < *until => early,
            _ => &self.late,
        };
        let forced = motion.forced.motion(&self.drum, time);
        let (s, s_dot) = self.free.at(motion.displacement, motion.velocity, time).multiplied();
        let shaft = Shaft { position: forced.position + s, velocity: forced.velocity + s_dot };
        if self.mirrored { shaft.mirror_image() } else { shaft }.in_range(time)
    }

    /// The shaft at each of these times, s: as [`Ramp::at`], to rounding, and several times as quick for lightly
    /// damped machines. The same time may differ by rounding from place to place in a list: it is computed together
    /// with its neighbours.
    ///
    /// # Errors
    /// As [`Ramp::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Shaft>, InvalidQuantity> {
        wide::laundromat::sample_ramp(self, times)
    }

    /// Until when, s, the drum has not left the resonance in which it starts; zero if it starts in none.
    pub(crate) fn early_until(&self) -> f64 {
        self.early.map_or(0.0, |(until, _)| until)
    }
}

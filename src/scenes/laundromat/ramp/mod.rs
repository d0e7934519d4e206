//! A drum that speeds up steadily, through its resonance.

mod drum;
mod early;
mod forced;
mod root;
mod together;

use super::machine::Machine;
use super::oscillator::{FreeMotion, Oscillator, Swing};
use super::shaft::Shaft;
use crate::lanes::{BLOCK, at_full_width, in_blocks, sample};
use crate::quantity::{InvalidQuantity, Rule};
use drum::Drum;
use early::Early;
use forced::{Forced, through_roots};
use root::Root;

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
/// use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
/// let machine = Machine::new(MachineParameters {
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
    mirrored: bool,
    drum: Drum,
    late: Motion,
    early: Option<(f64, Motion)>,
}

/// `eq:ramp-motion`: what the force does, and the free motion that this leaves of the start.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Motion {
    forced: Forced,
    free: FreeMotion,
}

impl Motion {
    fn new(forced: Forced, drum: &Drum, free: &Oscillator, start: Shaft) -> Self {
        let left = start.plus(forced.motion(drum, 0.0).times(-1.0));
        Self { forced, free: free.from(left) }
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
        let spin = if mirrored { -self.spin() } else { self.spin() };
        let drum = Drum::new(spin, acceleration.abs(), self.offset(), self.damping_rate());
        let free = Oscillator::new(self.precise_damping_rate(), self.stiffness_rate());
        let late = Motion::new(Forced::new(&drum, &free), &drum, &free, start);
        let early = Early::new(&drum, &free)
            .map(|early| (early.reach, Motion::new(Forced::Early(early), &drum, &free, start)));
        Ok(Ramp { mirrored, drum, late, early })
    }

    /// Rates of `[x, y, ẋ, ẏ]` while the drum turns with `φ = Ωt + ½αt²` (`eq:ramp-equation`), for an integrator, at an
    /// angular `acceleration`, rad/s². SI units.
    pub fn ramp_rates(&self, acceleration: f64) -> impl Fn(f64, &[f64; 4]) -> [f64; 4] + Copy + use<> {
        let (start, offset) = (self.spin(), self.offset());
        let [stiffness, damping] = [self.stiffness_rate().rounded(), self.damping_rate()];
        move |time, &[x, y, vx, vy]| {
            let spin = start + acceleration * time;
            let (sin, cos) = ((start + 0.5 * acceleration * time) * time).sin_cos();
            let (inward, along) = (offset * spin * spin, offset * acceleration);
            [
                vx,
                vy,
                inward * cos + along * sin - stiffness * x - damping * vx,
                inward * sin - along * cos - stiffness * y - damping * vy,
            ]
        }
    }
}

impl Ramp {
    /// The drum's angular velocity at `time`, s, rad/s.
    #[must_use]
    pub fn spin(&self, time: f64) -> f64 {
        let spin = self.drum.rate(time);
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
        let shaft = motion.forced.motion(&self.drum, time).plus(motion.free.at(time).multiplied());
        if self.mirrored { shaft.mirror_image() } else { shaft }.in_range(time)
    }

    /// The shaft at each of these times, s: as [`Ramp::at`], to rounding, and several times as quick for lightly
    /// damped machines. The same time may differ by rounding from place to place in a list: it is computed together
    /// with its neighbours.
    ///
    /// # Errors
    /// As [`Ramp::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Shaft>, InvalidQuantity> {
        let quick = |times: &[f64], states: &mut [Shaft]| match &self.late {
            Motion { forced: Forced::Apart(roots), free: FreeMotion::Turning(swing) } => {
                self.fill(roots, swing, times, states)
            }
            _ => 0,
        };
        sample(times, Shaft::AT_REST, quick, |time| self.at(time))
    }

    /// Fills the states of a lightly damped machine at times within reach, after it has left the resonance in which it
    /// starts, and says how many, as [`in_blocks`] does.
    fn fill(&self, roots: &[Root; 2], swing: &Swing, times: &[f64], states: &mut [Shaft]) -> usize {
        let early = self.early.map_or(0.0, |(until, _)| until);
        let reach = swing.reach().min(self.drum.reach());
        let reached =
            |time: f64| (early..=reach).contains(&time.abs()) && InvalidQuantity::check_time(time).is_ok();
        in_blocks(times, states, reached, |times, states| {
            let mut padded = [0.0; BLOCK];
            padded[..times.len()].copy_from_slice(times);
            let mut numbers = [[0.0; BLOCK]; 4];
            at_full_width(
                #[inline(always)]
                || {
                    through_roots::<BLOCK, false>(&self.drum, roots, &padded, &mut numbers);
                    for (n, &time) in padded.iter().enumerate() {
                        let free = swing.at(time);
                        for i in 0..4 {
                            numbers[i][n] = free[i] - self.drum.offset * numbers[i][n];
                        }
                    }
                },
            );
            for (n, state) in states.iter_mut().enumerate() {
                let shaft = Shaft::from_array(std::array::from_fn(|i| numbers[i][n]));
                *state = if self.mirrored { shaft.mirror_image() } else { shaft };
            }
            states.iter().all(Shaft::is_finite)
        })
    }
}

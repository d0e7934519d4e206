//! The locked motion: what the shaft would do if it could move along the radius only.

use super::machine::Machine;
use super::oscillator::{FreeMotion, Oscillator};
use super::shaft::{Shaft, check_start, out_of_range};
use crate::quantity::InvalidQuantity;

/// Distance of the shaft from O, and its rate. A negative radius is a point on the other side of O.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LockedState {
    /// r, m.
    pub radius: f64,
    /// ṙ, m/s.
    pub radius_rate: f64,
}

impl LockedState {
    /// From `[r, ṙ]` in m and m/s, the state that integrators step with [`LockedMotion::rates`].
    #[must_use]
    pub fn from_array([radius, radius_rate]: [f64; 2]) -> Self {
        Self { radius, radius_rate }
    }

    /// To `[r, ṙ]` in m and m/s.
    #[must_use]
    pub fn to_array(&self) -> [f64; 2] {
        [self.radius, self.radius_rate]
    }
}

/// Radial motion with the azimuth held at θ = Ωt − φ₀, in closed form.
///
/// From [`Machine::locked`]. It comes back to r₀ below the natural frequency and runs away above it. The error is at
/// most eight units in the last place of the sum of r₀, of what the start has become, and of what a change of the
/// time or of the damping by such a unit makes of the motion.
///
/// ```
/// use mechanics::scenes::laundromat::{LockedState, Machine, MachineParameters};
/// let (drum_mass, load_mass, load_radius) = (28.0, 2.0, 0.25);
/// let (stiffness, damping, spin) = (3000.0, 90.0, 30.0);
/// let made = MachineParameters { drum_mass, load_mass, load_radius, stiffness, damping, spin };
/// let machine = Machine::new(made)?; // 10 rad/s by itself, turned at 30
/// let steady = machine.steady()?.radius();
/// // A tenth of a millimetre too far out; a tenth of a second later the locked shaft is nearly eight times as far.
/// let start = LockedState { radius: steady + 1e-4, radius_rate: 0.0 };
/// let later = machine.locked(start)?.at(0.1)?;
/// assert_eq!(format!("{:.2} mm", 1e3 * (later.radius - steady)), "0.77 mm");
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LockedMotion {
    steady_radius: f64,
    beside: FreeMotion, // of r − r₀, along x
    push: f64,          // bΩ² cos φ₀
    stiffness: f64,     // ω₀² − Ω²
    damping: f64,       // Γ
}

impl Machine {
    /// The locked motion from a state at time zero (`eq:locked-motion`).
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the start is not finite or beyond 1e50 m or m/s; and as [`Machine::steady`].
    pub fn locked(&self, start: LockedState) -> Result<LockedMotion, InvalidQuantity> {
        check_start("radius of the start", start.radius, "m")?;
        check_start("radial velocity of the start", start.radius_rate, "m/s")?;
        let steady = self.steady()?;
        let position = (start.radius - steady.radius()).into();
        let free = Oscillator::new(self.precise_damping_rate(), self.precise_detuning());
        Ok(LockedMotion {
            steady_radius: steady.radius(),
            beside: free.from(Shaft { position, velocity: start.radius_rate.into() }),
            push: self.offset() * self.spin() * self.spin() * steady.phase().cos(),
            stiffness: self.detuning(),
            damping: self.damping_rate(),
        })
    }
}

impl LockedMotion {
    /// Rates of `[r, ṙ]` in m and m/s, for an integrator (`eq:locked-motion`). They do not contain the time.
    #[must_use]
    pub fn rates(&self, _time: f64, &[r, r_dot]: &[f64; 2]) -> [f64; 2] {
        [r_dot, self.push - self.stiffness * r - self.damping * r_dot]
    }

    /// Radius and radial velocity at a time, s, before or after the start.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the time is not finite or beyond 1e50 s, or if the shaft has run away beyond the
    /// largest number by then.
    pub fn at(&self, time: f64) -> Result<LockedState, InvalidQuantity> {
        InvalidQuantity::check_time(time)?;
        let Shaft { position, velocity } = self.beside.at(time).multiplied();
        let state = LockedState { radius: self.steady_radius + position.re, radius_rate: velocity.re };
        let finite = state.radius.is_finite() && state.radius_rate.is_finite();
        if finite { Ok(state) } else { Err(out_of_range(time)) }
    }

    /// The states at these times, s.
    ///
    /// # Errors
    /// As [`LockedMotion::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<LockedState>, InvalidQuantity> {
        times.iter().map(|&time| self.at(time)).collect()
    }
}

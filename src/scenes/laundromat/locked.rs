//! The locked motion: what the shaft would do if it could move along the radius only.

use super::machine::Machine;
use super::oscillator::{InvalidTime, Oscillator, check_time};
use super::shaft::{InvalidStart, Shaft};
use super::steady::NoSteadyMotion;
use nalgebra::Complex;
use std::error::Error;
use std::fmt;

/// Radial motion with the azimuth held at θ = Ωt − φ₀, in closed form.
///
/// From [`Machine::locked`]. It comes back to r₀ below the natural frequency and runs away above it; a negative
/// radius is a point on the other side of O. The error is at most eight units in the last place of the sum of r₀, of what the start
/// has become, and of what a change of the time or of the damping by such a unit makes of the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LockedMotion {
    oscillator: Oscillator,
    steady_radius: f64,
    displacement: Complex<f64>,
    velocity: Complex<f64>,
}

impl Machine {
    /// Rates of `[r, ṙ]` in m and m/s with the azimuth locked to the drum (`eq:locked-motion`).
    ///
    /// # Errors
    /// [`NoSteadyMotion`] at undamped resonance, where there is no phase φ₀ to lock to.
    pub fn locked_rates(&self, &[r, r_dot]: &[f64; 2]) -> Result<[f64; 2], NoSteadyMotion> {
        let spin = self.spin();
        let push = self.offset() * spin * spin * self.steady()?.phase().cos();
        Ok([r_dot, push - self.detuning() * r - self.damping_rate() * r_dot])
    }

    /// The locked motion from radius `r`, m, and radial velocity `r_dot`, m/s, at time zero (`eq:locked-motion`).
    ///
    /// # Errors
    /// [`LockedError`] if the start is not finite or beyond 1e50, or if there is no steady motion.
    pub fn locked(&self, r: f64, r_dot: f64) -> Result<LockedMotion, LockedError> {
        Shaft::from_array([r, 0.0, r_dot, 0.0]).check_start().map_err(LockedError::Start)?;
        let steady_radius = self.steady().map_err(LockedError::Steady)?.radius();
        Ok(LockedMotion {
            oscillator: Oscillator::new(self.precise_damping_rate(), self.precise_detuning()),
            steady_radius,
            displacement: (r - steady_radius).into(),
            velocity: r_dot.into(),
        })
    }
}

impl LockedMotion {
    /// `[r, ṙ]` in m and m/s at time `t`, s, before or after the start.
    ///
    /// # Errors
    /// [`InvalidTime`] if the time is not finite or is further than 1e150 s from the start, or if the shaft has run
    /// away beyond the largest number by then.
    pub fn at(&self, t: f64) -> Result<[f64; 2], InvalidTime> {
        check_time(t)?;
        let (displacement, velocity) = self.oscillator.at(self.displacement, self.velocity, t).multiplied();
        let state = [self.steady_radius + displacement.re, velocity.re];
        if state.iter().all(|value| value.is_finite()) {
            Ok(state)
        } else {
            Err(InvalidTime::OutOfRange { time: t })
        }
    }
}

/// Why there is no locked motion.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum LockedError {
    /// The start is not finite or too far out.
    Start(InvalidStart),
    /// There is no steady motion, so no phase to lock to.
    Steady(NoSteadyMotion),
}

impl fmt::Display for LockedError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start(error) => write!(out, "no locked motion: {error}"),
            Self::Steady(error) => write!(out, "no phase to lock to: {error}"),
        }
    }
}

impl Error for LockedError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Start(error) => Some(error),
            Self::Steady(error) => Some(error),
        }
    }
}

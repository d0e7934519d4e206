//! Where the shaft is and how it moves.

use crate::quantity::Shown;
use nalgebra::Complex;
use std::error::Error;
use std::fmt;

/// Position and velocity of the drum's shaft in the laboratory, as complex numbers x + iy.
///
/// ```
/// use mechanics::scenes::laundromat::Shaft;
/// // Going round O at 2 m with 3 rad/s: no radial velocity, and θ̇ = 3 rad/s.
/// let shaft = Shaft::from_polar([2.0, 0.5, 0.0, 3.0]);
/// assert_eq!(shaft.velocity.norm(), 6.0);
/// let [r, theta, r_dot, theta_dot] = shaft.to_polar();
/// assert!((r - 2.0).abs() < 1e-15 && (theta - 0.5).abs() < 1e-15);
/// assert!(r_dot.abs() < 1e-15 && (theta_dot - 3.0).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaft {
    /// Position z from the fixed point O, m.
    pub position: Complex<f64>,
    /// Velocity ż, m/s.
    pub velocity: Complex<f64>,
}

/// Starts are at most this far from O, m, and at most this fast, m/s.
const LARGEST_START: f64 = 1e50;

impl Shaft {
    /// At rest at O, where every washing machine starts.
    pub const AT_REST: Self = Self { position: Complex::new(0.0, 0.0), velocity: Complex::new(0.0, 0.0) };

    /// From `[x, y, ẋ, ẏ]` in m and m/s, the state that integrators step.
    pub fn from_array([x, y, vx, vy]: [f64; 4]) -> Self {
        Self { position: Complex::new(x, y), velocity: Complex::new(vx, vy) }
    }

    /// To `[x, y, ẋ, ẏ]` in m and m/s.
    #[inline]
    pub fn to_array(&self) -> [f64; 4] {
        [self.position.re, self.position.im, self.velocity.re, self.velocity.im]
    }

    /// From polar coordinates and their rates, `[r, θ, ṙ, θ̇]` in m, rad, m/s, rad/s.
    pub fn from_polar([r, theta, r_dot, theta_dot]: [f64; 4]) -> Self {
        let (sin, cos) = theta.sin_cos();
        let direction = Complex::new(cos, sin);
        Self { position: r * direction, velocity: Complex::new(r_dot, r * theta_dot) * direction }
    }

    /// To polar coordinates and their rates, `[r, θ, ṙ, θ̇]` in m, rad, m/s, rad/s; θ from −π to π.
    ///
    /// At O itself θ is the direction of the velocity and θ̇, which has no value there, is given as zero. Very
    /// close to O, θ̇ may be beyond the largest number and come back infinite: polar coordinates are like that.
    pub fn to_polar(&self) -> [f64; 4] {
        let r = self.position.re.hypot(self.position.im);
        if r == 0.0 {
            return [0.0, self.velocity.arg(), self.velocity.re.hypot(self.velocity.im), 0.0];
        }
        let theta = self.position.arg();
        let (sin, cos) = (self.position.im / r, self.position.re / r);
        let r_dot = self.velocity.re * cos + self.velocity.im * sin;
        let across = self.velocity.im * cos - self.velocity.re * sin;
        [r, theta, r_dot, across / r]
    }

    /// Whether all four numbers are finite.
    #[inline(always)]
    pub(super) fn is_finite(&self) -> bool {
        self.to_array().iter().all(|number| number.is_finite())
    }

    /// Refuses a start that is not finite or further out or faster than the closed forms can follow.
    pub(super) fn check_start(&self) -> Result<(), InvalidStart> {
        for (quantity, value, unit) in [
            ("x", self.position.re, "m"),
            ("y", self.position.im, "m"),
            ("velocity along x", self.velocity.re, "m/s"),
            ("velocity along y", self.velocity.im, "m/s"),
        ] {
            if !value.is_finite() || value.abs() > LARGEST_START {
                return Err(InvalidStart { quantity, value, unit });
            }
        }
        Ok(())
    }
}

/// A start that no motion can be computed from: not finite, or beyond 1e50 m or 1e50 m/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InvalidStart {
    /// Which component.
    pub quantity: &'static str,
    /// What was given.
    pub value: f64,
    /// Its unit.
    pub unit: &'static str,
}

impl fmt::Display for InvalidStart {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { quantity, value, unit } = *self;
        let value = Shown(value);
        write!(
            out,
            "start with {quantity} = {value} {unit}: it must be finite and at most {LARGEST_START:e} {unit} in size"
        )
    }
}

impl Error for InvalidStart {}

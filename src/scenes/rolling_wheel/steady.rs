//! Steady rolling on a circle.

use super::motion::Rolling;
use super::wheel::Wheel;
use crate::quantity::{InvalidQuantity, Shown};
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::fmt;

/// A wheel that rolls steadily round a circle.
///
/// ```
/// use mechanics::scenes::rolling_wheel::Wheel;
/// // A hoop leaning by 30° whose centre goes round on half its radius.
/// let hoop = Wheel::new(1.0, 1.0, 1.0, 9.81)?;
/// let steady = hoop.steady(30_f64.to_radians(), 0.5)?;
/// let expected = 2.0 * 9.81 * 30_f64.to_radians().tan() / (4.0 * 0.5 + 0.5);
/// assert!((steady.turn_rate().powi(2) / expected - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyRolling {
    wheel: Wheel,
    lean: f64,
    centre_radius: f64,
    turn_rate: f64,
}

impl Wheel {
    /// Steady rolling with a lean θ, rad, and the centre on a circle of radius `centre_radius`, m; negative if the centre is
    /// beyond the axis (`eq:steady-rolling`). Of the two senses, the one with positive Ω.
    ///
    /// Rates and [`SteadyRolling::wobble_square`] are exact to 4 units in the last place, of the largest term where terms cancel, and lose
    /// what `2(1 + k)b + ka sin θ` loses near the least radius, where it vanishes.
    ///
    /// # Errors
    /// [`NoSteadyRolling`] for an upright or a flat wheel, and where no turn rate balances the lean.
    pub fn steady(&self, lean: f64, centre_radius: f64) -> Result<SteadyRolling, NoSteadyRolling> {
        InvalidQuantity::check("lean", lean, "rad")?;
        InvalidQuantity::check("radius of the centre's circle", centre_radius, "m")?;
        if lean.abs() >= FRAC_PI_2 {
            return Err(NoSteadyRolling::Flat { lean });
        }
        if lean == 0.0 {
            return Err(NoSteadyRolling::Upright { centre_radius });
        }
        let (sin, k) = (lean.sin(), self.factor);
        let below = 2.0 * (1.0 + k) * centre_radius + k * self.radius * sin;
        let square = 2.0 * self.gravity * lean.tan() / below;
        if !(square > 0.0 && square.is_finite()) {
            let bound = -k * self.radius * sin / (2.0 * (1.0 + k));
            return Err(NoSteadyRolling::ForbiddenSide { lean, centre_radius, bound });
        }
        Ok(SteadyRolling { wheel: *self, lean, centre_radius, turn_rate: square.sqrt() })
    }
}

impl SteadyRolling {
    /// The rate Ω at which the wheel goes round, rad/s (`eq:steady-rolling`).
    pub fn turn_rate(&self) -> f64 {
        self.turn_rate
    }

    /// The spin ω about the axle relative to the frame that goes round, rad/s (`eq:rolling-constraint`).
    pub fn relative_spin(&self) -> f64 {
        self.turn_rate * (self.centre_radius / self.wheel.radius + self.lean.sin())
    }

    /// The component of the whole angular velocity along the axle, `Ωb/a`, rad/s (`eq:true-spin`).
    pub fn true_spin(&self) -> f64 {
        self.turn_rate * self.centre_radius / self.wheel.radius
    }

    /// Radius of the contact point's circle, `b + a sin θ`, m; negative if it lies beyond the axis (`eq:contact-speed`).
    pub fn contact_radius(&self) -> f64 {
        self.centre_radius + self.wheel.radius * self.lean.sin()
    }

    /// The whole angular velocity along axes 1, 2, 3, rad/s (`eq:total-spin`).
    pub fn omega(&self) -> Vector3<f64> {
        Vector3::new(0.0, self.turn_rate * self.lean.cos(), self.true_spin())
    }

    /// The angular momentum about the centre along axes 1, 2, 3, kg·m²/s (`eq:rolling-momentum`).
    pub fn angular_momentum(&self) -> Vector3<f64> {
        let unit = self.wheel.factor * self.wheel.mass * self.wheel.radius * self.wheel.radius;
        let omega = self.omega();
        Vector3::new(0.0, 0.5 * unit * omega.y, unit * omega.z)
    }

    /// The torque about the centre, along axis 1, N·m (`eq:rolling-torque`).
    pub fn torque(&self) -> f64 {
        let Wheel { mass, radius, gravity, .. } = self.wheel;
        let inward = self.turn_rate * self.turn_rate * self.centre_radius;
        mass * radius * (gravity * self.lean.sin() - inward * self.lean.cos())
    }

    /// The least coefficient of friction, `Ω²|b|/g` (`eq:friction-needed`).
    pub fn friction_needed(&self) -> f64 {
        self.turn_rate * self.turn_rate * self.centre_radius.abs() / self.wheel.gravity
    }

    /// The square of the angular frequency of small wobbles about the steady motion, 1/s²; negative if it is unstable
    /// (`eq:nutation`).
    pub fn wobble_square(&self) -> f64 {
        let k = self.wheel.factor;
        let (s, c) = self.lean.sin_cos();
        let b = self.centre_radius / self.wheel.radius;
        let bracket = s * (c * c + 1.5 * k * s * s)
            + b * ((1.0 + 3.0 * k) * s * s - (1.0 + k) * c * c)
            + 2.0 * (1.0 + k) * b * b * s;
        self.turn_rate * self.turn_rate * bracket / ((1.0 + 0.5 * k) * s)
    }

    /// Whether small disturbances stay small.
    pub fn is_stable(&self) -> bool {
        self.wobble_square() > 0.0
    }

    /// This motion as a state of the general one, with the centre at `(0, b)` and axis 1 along x.
    pub fn state(&self) -> Rolling {
        let q = self.turn_rate * self.lean.cos();
        Rolling {
            lean: self.lean,
            lean_rate: 0.0,
            across: q,
            along: self.true_spin(),
            heading: 0.0,
            spin: 0.0,
            centre: [0.0, self.centre_radius],
        }
    }
}

/// Why a wheel does not roll steadily so.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum NoSteadyRolling {
    /// A number that cannot be computed with.
    Quantity(InvalidQuantity),
    /// The wheel lies flat, or is past that.
    Flat {
        /// The lean, rad.
        lean: f64,
    },
    /// An upright wheel rolls straight on, or stands and turns at any rate.
    Upright {
        /// The radius that was asked for, m.
        centre_radius: f64,
    },
    /// The circle is on the side, or so small, that no rate balances this lean.
    ForbiddenSide {
        /// The lean, rad.
        lean: f64,
        /// The radius that was asked for, m.
        centre_radius: f64,
        /// The radius that it has to be above (for a negative lean, below), m.
        bound: f64,
    },
}

impl From<InvalidQuantity> for NoSteadyRolling {
    fn from(error: InvalidQuantity) -> Self {
        Self::Quantity(error)
    }
}

impl fmt::Display for NoSteadyRolling {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Quantity(error) => error.fmt(out),
            Self::Flat { lean } => {
                write!(out, "lean {} rad: a wheel rolls at less than π/2 from the upright", Shown(lean))
            }
            Self::Upright { centre_radius } => write!(
                out,
                "lean 0 rad: an upright wheel goes round on no circle of radius {} m; it rolls straight, or turns in place at any rate",
                Shown(centre_radius)
            ),
            Self::ForbiddenSide { lean, centre_radius, bound } => write!(
                out,
                "radius {} m of the centre's circle: with a lean of {} rad it must be {} {} m",
                Shown(centre_radius),
                Shown(lean),
                if lean > 0.0 { "above" } else { "below" },
                Shown(bound)
            ),
        }
    }
}

impl Error for NoSteadyRolling {}

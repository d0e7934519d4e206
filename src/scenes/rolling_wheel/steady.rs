//! Steady rolling on a circle.

use super::wheel::Wheel;
use crate::quantity::{InvalidQuantity, Rule};
use crate::rolling::{DiskParameters, MomentFactors, Rolling};
use nalgebra::{Complex, Vector3};
use std::f64::consts::FRAC_PI_2;

/// A wheel that rolls steadily round a circle.
///
/// ```
/// use mechanics::rolling::{DiskParameters, MomentFactors};
/// use mechanics::scenes::rolling_wheel::Wheel;
/// // A hoop leaning by 30° whose centre goes round on half its radius.
/// let (mass, radius, gravity) = (1.0, 1.0, 9.81);
/// let hoop = Wheel::new(DiskParameters { mass, radius, moments: MomentFactors::HOOP, gravity })?;
/// let steady = hoop.steady(30_f64.to_radians(), 0.5)?;
/// let expected = 2.0 * 9.81 * 30_f64.to_radians().tan() / (4.0 * 0.5 + 0.5);
/// assert!((steady.turn_rate().powi(2) / expected - 1.0).abs() < 1e-14);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyRolling {
    pub(super) wheel: Wheel,
    pub(super) lean: f64,
    centre_radius: f64,
    turn_rate: f64,
}

impl Wheel {
    /// Steady rolling with a lean θ, rad, and the centre on a circle of radius b = `centre_radius`, m; negative if the
    /// centre is beyond the axis (`eq:steady-moments`). Of the two senses, the one with positive Ω.
    ///
    /// Rates are exact to 4 units in the last place, and [`SteadyRolling::wobble_square`] to 8 of its largest term, and
    /// they lose what `(1 + I₃)b + I₁a sin θ` loses near the least radius, where it vanishes.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for an upright or a flat wheel, and where no turn rate balances the lean.
    pub fn steady(&self, lean: f64, centre_radius: f64) -> Result<SteadyRolling, InvalidQuantity> {
        InvalidQuantity::check("lean", lean, "rad")?;
        InvalidQuantity::check(CIRCLE, centre_radius, "m")?;
        let flat = Rule::Because("a wheel rolls at less than π/2 from the upright");
        InvalidQuantity::require(lean.abs() < FRAC_PI_2, "lean", lean, "rad", flat)?;
        let upright = Rule::Because(
            "an upright wheel goes round on no circle; it rolls straight, or turns in place at any rate",
        );
        InvalidQuantity::require(lean != 0.0, "lean", lean, "rad", upright)?;
        let DiskParameters { radius: a, moments, gravity: g, .. } = self.disk.parameters;
        let MomentFactors { transverse: i1, axial: i3 } = moments;
        let sin = lean.sin();
        let square = g * lean.tan() / ((1.0 + i3) * centre_radius + i1 * a * sin); // eq:steady-moments
        let bound = -i1 * a * sin / (1.0 + i3); // eq:existence
        let side = if lean > 0.0 { Rule::MoreThan(bound) } else { Rule::LessThan(bound) };
        InvalidQuantity::require(square > 0.0 && square.is_finite(), CIRCLE, centre_radius, "m", side)?;
        Ok(SteadyRolling { wheel: *self, lean, centre_radius, turn_rate: square.sqrt() })
    }
}

/// The radius b by its name.
const CIRCLE: &str = "radius of the centre's circle";

impl SteadyRolling {
    /// The rate Ω at which the wheel goes round, rad/s (`eq:steady-rolling`).
    #[must_use]
    pub fn turn_rate(&self) -> f64 {
        self.turn_rate
    }

    /// The spin `ω_rel` about the axle relative to the frame that goes round, rad/s (`eq:rolling-constraint`).
    #[must_use]
    pub fn relative_spin(&self) -> f64 {
        self.turn_rate * (self.centre_radius / self.radius() + self.lean.sin())
    }

    /// The component of the whole angular velocity along the axle, `Ωb/a`, rad/s (`eq:true-spin`).
    #[must_use]
    pub fn true_spin(&self) -> f64 {
        self.turn_rate * self.centre_radius / self.radius()
    }

    /// Radius of the contact point's circle, `b + a sin θ`, m; negative if it lies beyond the axis
    /// (`eq:contact-speed`).
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.centre_radius + self.radius() * self.lean.sin()
    }

    /// The whole angular velocity along axes 1, 2, 3, rad/s (`eq:total-spin`).
    #[must_use]
    pub fn omega(&self) -> Vector3<f64> {
        Vector3::new(0.0, self.turn_rate * self.lean.cos(), self.true_spin())
    }

    /// The angular momentum about the centre along axes 1, 2, 3, kg·m²/s (`eq:rolling-momentum`).
    #[must_use]
    pub fn angular_momentum(&self) -> Vector3<f64> {
        let DiskParameters { mass: m, radius: a, moments, .. } = self.wheel.parameters();
        let omega = self.omega();
        Vector3::new(0.0, moments.transverse * omega.y, moments.axial * omega.z) * (m * a * a)
    }

    /// The torque about the centre, along axis 1, N·m (`eq:rolling-torque`).
    #[must_use]
    pub fn torque(&self) -> f64 {
        let DiskParameters { mass: m, radius: a, gravity: g, .. } = self.wheel.parameters();
        let (sin, cos) = self.lean.sin_cos();
        m * a * (g * sin - self.turn_rate * self.turn_rate * self.centre_radius * cos)
    }

    /// The least coefficient of friction, `Ω²|b|/g` (`eq:friction-needed`).
    #[must_use]
    pub fn friction_needed(&self) -> f64 {
        self.turn_rate * self.turn_rate * self.centre_radius.abs() / self.wheel.parameters().gravity
    }

    /// The square of the angular frequency of small wobbles about the steady motion, 1/s²; negative if it is unstable
    /// (`eq:nutation`).
    #[must_use]
    pub fn wobble_square(&self) -> f64 {
        let MomentFactors { transverse: i1, axial: i3 } = self.wheel.parameters().moments;
        let (s, c) = self.lean.sin_cos();
        let b = self.centre_radius / self.radius();
        let brace = s * (c * c + 3.0 * i1 * s * s)
            + b * ((1.0 + 3.0 * i3) * s * s - (1.0 + i3) * c * c)
            + (1.0 + i3) * (i3 / i1) * b * b * s;
        self.turn_rate * self.turn_rate * brace / ((1.0 + i1) * s)
    }

    /// Whether small disturbances stay small.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.wobble_square() > 0.0
    }

    /// This motion as a state of the general one, with the centre at `(0, b)` and axis 1 along x.
    #[must_use]
    pub fn state(&self) -> Rolling {
        let omega = self.omega();
        Rolling {
            tilt: FRAC_PI_2 - self.lean,
            omega_2: omega.y,
            omega_3: omega.z,
            centre: Complex::new(0.0, self.centre_radius),
            ..Rolling::UPRIGHT
        }
    }

    fn radius(&self) -> f64 {
        self.wheel.parameters().radius
    }
}

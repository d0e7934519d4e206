//! A symmetric body that spins down in air. Chapter "Frisbee and pencil".
//!
//! The drag is a torque `−C₁ω₁, −C₁ω₂, −C₃ω₃` along the body's axes, 3 being the axis of symmetry; the source has one
//! coefficient C for both.

mod spheroid;
mod thrown;

pub use thrown::ThrownTop;

use crate::clock::Clock;
use crate::elementary::{exp, exp_and_exp_m1};
use crate::inertia::PrincipalMoments;
use crate::lanes::{Branchless, sample_branchless};
use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::Vector3;

/// Drag coefficients, N·m·s: torque per angular velocity. Zero or more.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drag {
    /// C₁, against turning about any axis across the body's own.
    pub transverse: f64,
    /// C₃, against turning about the body's axis.
    pub axial: f64,
}

impl Drag {
    /// The same coefficient about every axis, as in the source.
    #[must_use]
    pub const fn isotropic(coefficient: f64) -> Self {
        Self { transverse: coefficient, axial: coefficient }
    }
}

/// A body, what the air does to it, and how it turns at time zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DraggedTopParameters {
    /// Principal moments; the axis of symmetry is axis 3.
    pub moments: PrincipalMoments,
    /// The drag.
    pub drag: Drag,
    /// Angular velocity along the body's axes at time zero, rad/s, not zero.
    pub omega_body: Vector3<f64>,
}

/// The angular velocity of a symmetric body under drag, in closed form.
///
/// ```
/// use mechanics::inertia::PrincipalMoments;
/// use mechanics::scenes::air_drag::{AxisTrend, Drag, DraggedTop, DraggedTopParameters};
/// use mechanics::nalgebra::Vector3;
/// let (drag, omega_body) = (Drag::isotropic(0.1), Vector3::new(3.0, 0.0, 10.0));
/// let moments = PrincipalMoments::symmetric(1.0, 2.0)?;
/// let frisbee = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?;
/// assert_eq!(frisbee.axis_trend(), AxisTrend::Aligning);
/// let moments = PrincipalMoments::symmetric(2.0, 0.1)?;
/// let pencil = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?;
/// assert_eq!(pencil.axis_trend(), AxisTrend::Tumbling);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DraggedTop {
    moments: PrincipalMoments,
    drag: Drag,
    start: Vector3<f64>,
    transverse_decay: f64,   // C₁/I₁
    axial_decay: f64,        // C₃/I₃
    alignment_rate: TwoPart, // δ
    body_turn: Clock,        // with σ at time zero
}

/// Which way the axis of rotation goes in the body as the body slows down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisTrend {
    /// To the axis of symmetry: the wobble dies before the spin.
    Aligning,
    /// To a right angle with it: the spin dies before the tumbling.
    Tumbling,
    /// Nowhere: the angle stays as it is.
    Unchanged,
}

impl DraggedTop {
    /// The body from time zero on.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the body has no axis of symmetry along 3, a drag coefficient is negative, a number is not
    /// finite or of a size that cannot be computed with, or the body does not turn.
    pub fn new(parameters: DraggedTopParameters) -> Result<Self, InvalidQuantity> {
        let DraggedTopParameters { moments, drag, omega_body } = parameters;
        let moments = moments.evened()?;
        let [i1, _, i3] = moments.to_array();
        let Drag { transverse: c1, axial: c3 } = drag;
        InvalidQuantity::check_not_negative("transverse drag coefficient", c1, "N·m·s")?;
        InvalidQuantity::check_not_negative("axial drag coefficient", c3, "N·m·s")?;
        for component in &omega_body {
            InvalidQuantity::check("angular velocity", *component, "rad/s")?;
        }
        let turns = omega_body != Vector3::zeros();
        InvalidQuantity::require(turns, "angular velocity", 0.0, "rad/s", Rule::NotZero)?;
        let [transverse_decay, axial_decay] = [c1 / i1, c3 / i3];
        for (decay, name, drag) in [
            (transverse_decay, "transverse drag coefficient", c1),
            (axial_decay, "axial drag coefficient", c3),
        ] {
            let because = "over the moment of inertia it gives a rate of decay outside 1e-50 to 1e50 1/s";
            InvalidQuantity::require_computable(decay, name, drag, "N·m·s", because)?;
        }
        let [c1, c3, i1, i3] = [c1, c3, i1, i3].map(TwoPart::from);
        Ok(Self {
            moments,
            drag,
            start: omega_body,
            transverse_decay,
            axial_decay,
            alignment_rate: c1 / i1 - c3 / i3, // eq:alignment-rate
            body_turn: Clock::from_rate((i3 - i1) / i1 * omega_body.z), // eq:wobble-complex
        })
    }

    /// The angular velocity along the body's axes at `time`, s, zero or later (`eq:spin-decay`, `eq:wobble-decay`).
    ///
    /// Each component to 9e-16 of the size of the angular velocity at the start. To that comes, with axial drag, an
    /// error of the angle through which the transverse part has turned, below 5e-16 of that angle: as much as the
    /// rounding of a time is worth. Without axial drag there is none, up to 1e15 rad.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is negative, not finite or larger than 1e50 s.
    pub fn at(&self, time: f64) -> Result<Vector3<f64>, InvalidQuantity> {
        InvalidQuantity::check_time(time)?;
        InvalidQuantity::require(time >= 0.0, "time", time, "s", Rule::NotNegative)?;
        Ok(self.state::<true>(time))
    }

    /// The angular velocity along the body's axes at each of `times`, s: the states of [`DraggedTop::at`], several at
    /// once.
    ///
    /// # Errors
    /// As [`DraggedTop::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Vector3<f64>>, InvalidQuantity> {
        sample_branchless(*self, [0.0, self.body_turn.reach()], times, self.start, |time| self.at(time))
    }

    /// What is left of the spin at a time, as a part, and the time in which the body would have turned as far at the
    /// first rate.
    #[inline(always)]
    fn slowed(&self, time: f64) -> (f64, f64) {
        let x = self.axial_decay * time;
        let (left, less_one) = exp_and_exp_m1(-x);
        // eq:wobble-phase with C₃t/I₃ taken out as x: no loss for small drag, and σt for none.
        let fraction = if x == 0.0 { 1.0 } else { -less_one / x };
        (left, time * fraction)
    }

    /// How often the axis of rotation goes round the body's axis, seen from the body, before the body stands still:
    /// `|(I₃ − I₁) I₃ ω₃ / (2π I₁ C₃)|` (`eq:total-turns`). Infinite without axial drag, unless the body is a sphere or
    /// has no spin about its axis.
    #[must_use]
    pub fn total_body_turns(&self) -> f64 {
        let turns_per_time = 0.25 * self.body_turn.quarters_per_time().abs();
        if turns_per_time == 0.0 { 0.0 } else { turns_per_time / self.axial_decay } // eq:total-turns
    }

    /// The angle between the angular velocity and the body's axis, rad, from 0 to π, at `time`, s, zero or later
    /// (`eq:drag-angle`). To 9e-16 of itself, however small, even when the angular velocity itself has become too small
    /// for `f64`; near π to 9e-16 of that.
    ///
    /// # Errors
    /// As [`DraggedTop::at`].
    pub fn axis_angle(&self, time: f64) -> Result<f64, InvalidQuantity> {
        self.at(time)?;
        let [w1, w2, w3]: [f64; 3] = self.start.into();
        let wobble = w1.hypot(w2);
        if wobble == 0.0 || w3 == 0.0 {
            return Ok(wobble.atan2(w3));
        }
        Ok((wobble * (-self.alignment_rate * time).exp()).atan2(w3)) // eq:drag-angle
    }

    /// The rate δ = C₁/I₁ − C₃/I₃, 1/s, at which the tangent of [`DraggedTop::axis_angle`] decays; negative if it grows
    /// (`eq:alignment-rate`).
    #[must_use]
    pub fn alignment_rate(&self) -> f64 {
        self.alignment_rate.rounded()
    }

    /// Where the axis of rotation goes in the body.
    ///
    /// A body that turns exactly about its axis, or exactly across it, keeps doing so whatever the drag.
    #[must_use]
    pub fn axis_trend(&self) -> AxisTrend {
        let [w1, w2, w3]: [f64; 3] = self.start.into();
        let rate = self.alignment_rate();
        if rate == 0.0 || (w1 == 0.0 && w2 == 0.0) || w3 == 0.0 {
            AxisTrend::Unchanged
        } else if rate > 0.0 {
            AxisTrend::Aligning
        } else {
            AxisTrend::Tumbling
        }
    }

    /// The torque along the body's axes, N·m, at an angular velocity along the same axes, rad/s (`eq:drag-torque`).
    #[must_use]
    pub fn torque_body(&self, omega_body: &Vector3<f64>) -> Vector3<f64> {
        let Drag { transverse, axial } = self.drag;
        -Vector3::new(transverse, transverse, axial).component_mul(omega_body)
    }

    /// The moments of the body.
    #[must_use]
    pub fn moments(&self) -> PrincipalMoments {
        self.moments
    }
}

impl Branchless for DraggedTop {
    type State = Vector3<f64>;

    /// The angular velocity at a time that has been checked.
    #[inline(always)]
    fn state<const ONE: bool>(&self, time: f64) -> Vector3<f64> {
        let (left, slowed_time) = self.slowed(time);
        let (sin, cos) = self.body_turn.sin_cos::<ONE>(slowed_time); // eq:wobble-phase
        let [w1, w2, w3]: [f64; 3] = self.start.into();
        let wobble = exp(-self.transverse_decay * time); // eq:wobble-decay
        let spin = w3 * left; // eq:spin-decay
        Vector3::new(wobble * (w1 * cos - w2 * sin), wobble * (w1 * sin + w2 * cos), spin)
    }
}

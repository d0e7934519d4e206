//! A symmetric body that spins down in air. Chapter "Frisbee and pencil".
//!
//! The drag is a torque `−C₁ω₁, −C₁ω₂, −C₃ω₃` along the body's axes, 3 being the axis of symmetry; the source has one
//! coefficient C for both.

mod frames;

use crate::attitude::check_attitude;
use crate::euler::Turning;
use crate::frames::{InvalidFrames, fill};
use crate::inertia::{PrincipalMoments, SymmetricMoments};
use crate::integrate::{Dop853, Failure};
use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::error::Error;
use std::fmt;

/// How many evaluations of the rates [`DraggedTop::sample`] allows.
const MOST_EVALUATIONS: usize = 1_000_000;

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
    pub const fn isotropic(coefficient: f64) -> Self {
        Self { transverse: coefficient, axial: coefficient }
    }
}

/// A symmetric body under drag: angular velocity in closed form, attitude by integration.
///
/// ```
/// use mechanics::inertia::PrincipalMoments;
/// use mechanics::scenes::air_drag::{Drag, DraggedTop, Fate};
/// use nalgebra::Vector3;
/// let omega = Vector3::new(3.0, 0.0, 10.0);
/// let frisbee = DraggedTop::new(PrincipalMoments::symmetric(1.0, 2.0)?, Drag::isotropic(0.1), omega)?;
/// assert_eq!(frisbee.fate(), Fate::AlongAxis);
/// let pencil = DraggedTop::new(PrincipalMoments::symmetric(2.0, 0.1)?, Drag::isotropic(0.1), omega)?;
/// assert_eq!(pencil.fate(), Fate::AcrossAxis);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DraggedTop {
    moments: PrincipalMoments,
    drag: Drag,
    start: Vector3<f64>,
    transverse_decay: f64,   // C₁/I₁
    axial_decay: f64,        // C₃/I₃
    alignment_rate: TwoPart, // δ = C₁/I₁ − C₃/I₃
    body_rate: TwoPart,      // σ₀ = ω₃₀(I₃ − I₁)/I₁
}

/// Which way the axis of rotation goes in the body as the body slows down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    /// To the axis of symmetry: the wobble dies before the spin.
    AlongAxis,
    /// To a right angle with it: the spin dies before the tumbling.
    AcrossAxis,
    /// Nowhere: the angle stays as it is.
    Unchanged,
}

impl DraggedTop {
    /// A body of these moments under this drag, with the angular velocity `omega_body`, rad/s, along its axes at time zero.
    ///
    /// # Errors
    /// [`InvalidDragTop`] if the body has no axis of symmetry along 3, a drag coefficient is negative, a number is not
    /// finite or of a size that cannot be computed with, or the body does not turn.
    pub fn new(
        moments: PrincipalMoments,
        drag: Drag,
        omega_body: Vector3<f64>,
    ) -> Result<Self, InvalidDragTop> {
        let SymmetricMoments { transverse, axial } = moments.as_symmetric()?;
        InvalidQuantity::check_not_negative("transverse drag coefficient", drag.transverse, "N·m·s")?;
        InvalidQuantity::check_not_negative("axial drag coefficient", drag.axial, "N·m·s")?;
        for component in &omega_body {
            InvalidQuantity::check("angular velocity", *component, "rad/s")?;
        }
        if omega_body == Vector3::zeros() {
            return Err(InvalidDragTop::NoSpin);
        }
        let [across, along] = [drag.transverse / transverse, drag.axial / axial];
        InvalidQuantity::check("decay rate across the axis", across, "1/s")?;
        InvalidQuantity::check("decay rate along the axis", along, "1/s")?;
        let difference = TwoPart::from(drag.transverse) / TwoPart::from(transverse)
            - TwoPart::from(drag.axial) / TwoPart::from(axial);
        let spread = TwoPart::sum(axial, -transverse) / TwoPart::from(transverse);
        Ok(Self {
            moments,
            drag,
            start: omega_body,
            transverse_decay: across,
            axial_decay: along,
            alignment_rate: difference,
            body_rate: spread * omega_body.z,
        })
    }

    /// The angular velocity along the body's axes at `time`, s, zero or later (`eq:spin-decay`, `eq:wobble-decay`).
    ///
    /// Each component to 9e-16 of the size of the angular velocity at the start. To that comes, with axial drag, an error of the angle through
    /// which the transverse part has turned, below 5e-16 of that angle: as much as the rounding of a time is worth. Without axial drag there is
    /// none, up to 1e15 rad.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is negative, not finite or larger than 1e50 s.
    pub fn omega_body(&self, time: f64) -> Result<Vector3<f64>, InvalidQuantity> {
        InvalidQuantity::check_time(time)?;
        InvalidQuantity::require(time >= 0.0, "time", time, "s", Rule::NotNegative)?;
        Ok(self.omega_after(time))
    }

    /// The angular velocity along the body's axes at each of `times`, s, written to `frames` without allocating, several at once.
    ///
    /// # Errors
    /// [`InvalidFrames::Length`] if there are not as many frames as times, and then nothing is written;
    /// [`InvalidFrames::Time`] at the first time that [`DraggedTop::omega_body`] refuses.
    pub fn fill_omega_body(
        &self,
        times: &[f64],
        frames: &mut [Vector3<f64>],
    ) -> Result<(), InvalidFrames<InvalidQuantity>> {
        let quick =
            |times: &[f64], frames: &mut [Vector3<f64>]| frames::Frames::new(self).fill(times, frames);
        fill(times, frames, quick, |time| self.omega_body(time))
    }

    fn omega_after(&self, time: f64) -> Vector3<f64> {
        let (sin, cos) = self.body_turn(time).sin_cos();
        let across = (-self.transverse_decay * time).exp();
        let along = (-self.axial_decay * time).exp();
        let [w1, w2, w3]: [f64; 3] = self.start.into();
        Vector3::new(across * (w1 * cos - w2 * sin), across * (w1 * sin + w2 * cos), w3 * along)
    }

    /// The angle through which the transverse part of the angular velocity has turned in the body at `time`, s, in rad:
    /// `σ₀ (1 − e^{−C₃t/I₃}) I₃/C₃`, with no loss for small drag and `σ₀t` for none (`eq:wobble-phase`).
    fn body_turn(&self, time: f64) -> TwoPart {
        let x = self.axial_decay * time;
        let fraction = if x == 0.0 { 1.0 } else { -(-x).exp_m1() / x };
        self.body_rate * (time * fraction)
    }

    /// How often the axis of rotation goes round the body's axis, seen from the body, before the body stands still:
    /// `|(I₃ − I₁) I₃ ω₃ / (2π I₁ C₃)|` (`eq:total-turns`). Infinite without axial drag, unless the body is a sphere or has
    /// no spin about its axis.
    pub fn total_body_turns(&self) -> f64 {
        let rate = self.body_rate.rounded();
        if rate == 0.0 {
            return 0.0;
        }
        (rate / self.axial_decay / std::f64::consts::TAU).abs()
    }

    /// The angle between the angular velocity and the body's axis, rad, from 0 to π, at `time`, s, zero or later
    /// (`eq:drag-angle`). To 9e-16 of itself, however small, even when the angular velocity itself has become too small for `f64`; near
    /// π to 9e-16 of that.
    ///
    /// # Errors
    /// As [`DraggedTop::omega_body`].
    pub fn axis_angle(&self, time: f64) -> Result<f64, InvalidQuantity> {
        self.omega_body(time)?;
        let across = self.start.x.hypot(self.start.y);
        if across == 0.0 || self.start.z == 0.0 {
            return Ok(across.atan2(self.start.z));
        }
        Ok((across * (-self.alignment_rate * time).exp()).atan2(self.start.z)) // eq:drag-angle
    }

    /// The rate δ = C₁/I₁ − C₃/I₃, 1/s, at which the tangent of [`DraggedTop::axis_angle`] decays; negative if it grows
    /// (`eq:alignment-rate`).
    pub fn alignment_rate(&self) -> f64 {
        self.alignment_rate.rounded()
    }

    /// Where the axis of rotation goes in the body.
    ///
    /// A body that turns exactly about its axis, or exactly across it, keeps doing so whatever the drag.
    pub fn fate(&self) -> Fate {
        let [w1, w2, w3]: [f64; 3] = self.start.into();
        let rate = self.alignment_rate();
        if rate == 0.0 || (w1 == 0.0 && w2 == 0.0) || w3 == 0.0 {
            Fate::Unchanged
        } else if rate > 0.0 {
            Fate::AlongAxis
        } else {
            Fate::AcrossAxis
        }
    }

    /// The torque along the body's axes, N·m, at an angular velocity along the same axes, rad/s (`eq:drag-torque`).
    pub fn torque_body(&self, omega_body: &Vector3<f64>) -> Vector3<f64> {
        let Drag { transverse, axial } = self.drag;
        -omega_body.component_mul(&Vector3::new(transverse, transverse, axial))
    }

    /// The moments of the body.
    pub fn moments(&self) -> PrincipalMoments {
        self.moments
    }

    /// Attitudes and angular velocities at `times`, s, in order, from `world_from_body` at time zero.
    ///
    /// The angular velocity is the closed form; only the four numbers of the attitude are integrated, to `tolerance` a step
    /// ([`Dop853`]). There is no closed form for the attitude. A million evaluations of the rates are allowed, a fraction of a second;
    /// [`DraggedTop::sample_by`] takes any limit.
    ///
    /// # Errors
    /// [`InvalidDragTop`] for times that do not ascend from zero, a quaternion that is not of length one to 1e-12, a bad tolerance, or
    /// if the integration fails.
    pub fn sample(
        &self,
        world_from_body: UnitQuaternion<f64>,
        times: &[f64],
        tolerance: f64,
    ) -> Result<Vec<Turning>, InvalidDragTop> {
        let solver = Dop853::new(tolerance)?.with_max_evaluations(MOST_EVALUATIONS);
        self.sample_by(&solver, world_from_body, times)
    }

    /// The same by an integrator with tolerances and a limit of the caller's.
    ///
    /// # Errors
    /// As [`DraggedTop::sample`].
    pub fn sample_by(
        &self,
        solver: &Dop853,
        world_from_body: UnitQuaternion<f64>,
        times: &[f64],
    ) -> Result<Vec<Turning>, InvalidDragTop> {
        check_attitude(&world_from_body)?;
        if let Some(&bad) = times.iter().find(|time| self.omega_body(**time).is_err()) {
            self.omega_body(bad)?;
        }
        let rates = |time: f64, &[w, i, j, k]: &[f64; 4]| {
            let quaternion = Quaternion::new(w, i, j, k);
            let rate = crate::attitude::quaternion_rate(&quaternion, &self.omega_after(time)); // eq:quaternion-rate
            [rate.w, rate.i, rate.j, rate.k]
        };
        let q = world_from_body;
        let (states, _) =
            solver.sample(rates, 0.0, [q.w, q.i, q.j, q.k], times).map_err(InvalidDragTop::Integration)?;
        let pairs = times.iter().zip(states);
        Ok(pairs
            .map(|(&time, [w, i, j, k])| Turning {
                world_from_body: UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k)),
                omega_body: self.omega_after(time),
            })
            .collect())
    }
}

/// Why there is no such body, or no answer.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum InvalidDragTop {
    /// The body does not turn.
    NoSpin,
    /// A number breaks a rule.
    Quantity(InvalidQuantity),
    /// The integration of the attitude stopped.
    Integration(Failure),
}

impl From<InvalidQuantity> for InvalidDragTop {
    fn from(error: InvalidQuantity) -> Self {
        Self::Quantity(error)
    }
}

impl fmt::Display for InvalidDragTop {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSpin => write!(out, "angular velocity 0 rad/s: a body that spins down must spin"),
            Self::Quantity(error) => error.fmt(out),
            Self::Integration(error) => error.fmt(out),
        }
    }
}

impl Error for InvalidDragTop {}

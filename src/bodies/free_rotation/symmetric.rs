//! A free body with an axis of symmetry: its whole motion in a handful of operations.

use super::two_turns::TwoTurns;
use crate::attitude::check_attitude;
use crate::euler::Turning;
use crate::inertia::PrincipalMoments;
use crate::quantity::InvalidQuantity;
use crate::two_part::TwoPart;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A body that is symmetric about its axis 3 and turns with no torque about its centre of mass.
///
/// Its axis goes round the angular momentum **L**, which stands still in the room, at the constant rate `Λ = L/I₁`,
/// while the body turns about that axis, relative to the plane of the two, at the rate `−σ` with `σ = ω₃(I₃ − I₁)/I₁`
/// (`eq:top-motion`). Both angles are formed to 32 digits before whole turns are taken off, so attitude and angular
/// velocity are as exact after a hundred million million turns as after one. [`FreeSymmetricTop::at`] allocates
/// nothing.
///
/// ```
/// use mechanics::{euler::Turning, free_rotation::FreeSymmetricTop, inertia::Body};
/// use mechanics::nalgebra::{UnitQuaternion, Vector3};
/// // A plate thrown with a slight wobble wobbles twice while it turns once.
/// let start = Turning {
///     world_from_body: UnitQuaternion::identity(),
///     omega_body: Vector3::new(0.01, 0.0, 10.0),
/// };
/// let plate = FreeSymmetricTop::new(Body::thin_disk(0.3, 0.1)?.moments(), start)?;
/// assert!((plate.precession_rate() / 10.0 - 2.0).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeSymmetricTop {
    moments: PrincipalMoments,
    start: Turning,
    momentum_direction_body: Vector3<f64>, // L̂ at t = 0; axis 3 for a body at rest
    precession_rate: f64,                  // Λ
    body_rate: f64,                        // σ
    motion: TwoTurns,
}

impl FreeSymmetricTop {
    /// A body of these moments, and its attitude and angular velocity at time zero. A body at rest is allowed.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the moments about axes 1 and 2 differ by more than rounding
    /// ([`PrincipalMoments::as_symmetric`]), if a number of `start` is not finite or of a size that
    /// cannot be computed with, or if its quaternion is not of length one to 1e-12.
    pub fn new(moments: PrincipalMoments, start: Turning) -> Result<Self, InvalidQuantity> {
        let moments = moments.evened()?;
        for component in &start.omega_body {
            InvalidQuantity::check("angular velocity", *component, "rad/s")?;
        }
        check_attitude(&start.world_from_body)?;
        Ok(Self::from_checked(moments, start, 0, &UnitQuaternion::identity()))
    }

    /// The top from numbers that have been checked; the moments about axes 1 and 2 are equal. Its motion is given for a
    /// body of which axis 1 of the top is the axis number `shift`, counted from 0.
    pub(super) fn from_checked(
        moments: PrincipalMoments,
        start: Turning,
        shift: usize,
        top_from_body: &UnitQuaternion<f64>,
    ) -> Self {
        let [transverse, _, axial] = moments.to_array();
        let [w1, w2, w3]: [f64; 3] = start.omega_body.into();
        let axial_part = TwoPart::product(axial, w3) / TwoPart::from(transverse); // L₃/I₁
        let square = TwoPart::product(w1, w1) + TwoPart::product(w2, w2) + axial_part * axial_part;
        let precession_rate = square.sqrt(); // eq:precession-rate
        let difference = TwoPart::sum(axial, -transverse) / TwoPart::from(transverse);
        let body_rate = difference * w3; // eq:body-rate
        let momentum_direction_body =
            Vector3::new(w1, w2, axial_part.rounded()).try_normalize(0.0).unwrap_or_else(Vector3::z);
        let omega = [[0.0, 0.0, w3], [w1, w2, 0.0], [-w2, w1, 0.0]];
        let motion = TwoTurns::new(
            &start.world_from_body,
            (momentum_direction_body, precession_rate),
            (Vector3::z(), body_rate),
            top_from_body,
            omega.map(|of_top| Vector3::from_fn(|axis, _| of_top[(axis + 3 - shift) % 3])),
        );
        let [precession_rate, body_rate] = [precession_rate, body_rate].map(TwoPart::rounded);
        Self { moments, start, momentum_direction_body, precession_rate, body_rate, motion }
    }

    /// Attitude and angular velocity at `time`, s: to 4e-15 rad, and 4e-15 of the size of the angular velocity, until
    /// the body has turned by 1e15 rad. Then the 32 digits of the rates run out; each further decade costs one, and
    /// from 1e30 rad on only what is constant is known.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is not finite or larger than 1e50 s in size.
    pub fn at(&self, time: f64) -> Result<Turning, InvalidQuantity> {
        self.motion.at(time)
    }

    /// Attitude and angular velocity at each of `times`, s, as [`FreeSymmetricTop::at`], several at once.
    ///
    /// # Errors
    /// As [`FreeSymmetricTop::at`], of the first time that is refused.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Turning>, InvalidQuantity> {
        self.motion.sample(times)
    }

    /// The direction of the axis of symmetry in the room at `time`, s; cheaper than the whole attitude
    /// (`eq:axis-motion`).
    ///
    /// # Errors
    /// As [`FreeSymmetricTop::at`].
    pub fn axis_world(&self, time: f64) -> Result<Vector3<f64>, InvalidQuantity> {
        let (sin, cos) = self.half_precession(time)?;
        let about_momentum = Quaternion::from_parts(cos, self.momentum_direction_body * sin);
        Ok(self.start.world_from_body * (UnitQuaternion::new_unchecked(about_momentum) * Vector3::z()))
    }

    /// Sine and cosine of half the angle through which the axis has gone round **L** at `time`, s.
    pub(crate) fn half_precession(&self, time: f64) -> Result<(f64, f64), InvalidQuantity> {
        Ok(self.motion.half_of_first(InvalidQuantity::check_time(time)?))
    }

    /// The motion, for the body that it has been made for.
    pub(super) fn motion(&self) -> TwoTurns {
        self.motion
    }

    /// The moments of the body.
    #[must_use]
    pub fn moments(&self) -> PrincipalMoments {
        self.moments
    }

    /// Attitude and angular velocity at time zero.
    #[must_use]
    pub fn start(&self) -> Turning {
        self.start
    }

    /// The rate `Λ = L/I₁`, rad/s, at which the axis of symmetry goes round **L** in the room (`eq:precession-rate`).
    #[must_use]
    pub fn precession_rate(&self) -> f64 {
        self.precession_rate
    }

    /// The rate `σ = ω₃(I₃ − I₁)/I₁`, rad/s, at which the angular velocity goes round axis 3 as seen from the body,
    /// counter-clockwise about that axis if positive (`eq:body-rate`).
    #[must_use]
    pub fn body_rate(&self) -> f64 {
        self.body_rate
    }

    /// The angle between the axis of symmetry and **L**, rad, from 0 to π; constant (`eq:momentum-angle`). Zero for a
    /// body at rest.
    #[must_use]
    pub fn momentum_angle(&self) -> f64 {
        let [l1, l2, l3]: [f64; 3] = self.momentum_direction_body.into();
        l1.hypot(l2).atan2(l3)
    }

    /// The angle between the axis of symmetry and the angular velocity, rad, from 0 to π; constant. Zero for a body at
    /// rest.
    #[must_use]
    pub fn omega_angle(&self) -> f64 {
        let omega = self.start.omega_body;
        omega.x.hypot(omega.y).atan2(omega.z)
    }

    /// The angular momentum in the room, kg·m²/s; constant.
    #[must_use]
    pub fn angular_momentum_world(&self) -> Vector3<f64> {
        self.start.angular_momentum_world(&self.moments)
    }

    /// The kinetic energy of rotation, J; constant.
    #[must_use]
    pub fn kinetic_energy(&self) -> f64 {
        self.moments.kinetic_energy(&self.start.omega_body)
    }
}

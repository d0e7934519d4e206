//! A spinning body that is suddenly pinned at a point of its surface. Chapter "The pinned hoop".
//!
//! Before, the centre is at rest and the body turns with ω₀ about a diameter. Axes 1, 2, 3 are those of the body at the
//! moment of the snap, and of the room: 2 from the pinned point A to the centre, 1 along the tangent on the side of ω₀,
//! 3 = 1 × 2. The pole of ω₀ is at the polar angle θ from A, and `ω₀ = ω₀ (sin θ, −cos θ, 0)`. A hoop and a disc lie in
//! the plane of 1 and 2.

use crate::euler::Turning;
use crate::free_rotation::FreeTop;
use crate::inertia::{Body, PrincipalMoments};
use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::PI;

/// How far, relative to the radius, a point may be from the surface through rounding.
const ON_THE_SURFACE: f64 = 1e-12;

/// What spins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A thin hoop, about a diameter.
    Hoop,
    /// A thin disc, about a diameter.
    Disk,
    /// A ball of even density.
    Sphere,
}

/// A spinning body and where it is pinned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PinningParameters {
    /// What spins.
    pub shape: Shape,
    /// Mass m, kg, more than zero.
    pub mass: f64,
    /// Radius a, m, more than zero.
    pub radius: f64,
    /// Angular velocity ω₀ about a diameter, rad/s, of either sign, not zero.
    pub spin: f64,
    /// The pinned point A.
    pub pin: Pin,
}

/// A point of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pin {
    /// The angle θ from the axis of rotation, rad, from 0 to π.
    ///
    /// Near a right angle the motion afterwards hangs on its cosine, of which few digits survive the rounding of θ in
    /// radians: at 89.999° eleven. [`Pin::Point`] keeps all.
    Angle(f64),
    /// The place of the point, which has to be at the distance of the radius from the centre, to rounding.
    Point {
        /// How far from the axis of rotation, `a sin θ`, m, zero or more.
        from_axis: f64,
        /// How far from the centre along that axis, `a cos θ`, m, of either sign.
        height: f64,
    },
}

/// A spinning body that is pinned. What it says of the snap is good to 1.4e-15 of itself, and the velocities of B and
/// of the point opposite, which vanish where the two components of the rotation balance, of the sum of what these give.
///
/// ```
/// use mechanics::scenes::pinned_hoop::{PinningParameters, Pin, Pinning, Shape};
/// let pin = Pin::Angle(60_f64.to_radians());
/// let hoop = Pinning::new(PinningParameters { shape: Shape::Hoop, mass: 1.0, radius: 1.0, spin: 1.0, pin })?;
/// // A third of the component along the tangent survives, and all of that along the diameter (eq:spin-after).
/// let omega = hoop.omega_after();
/// assert!((omega.x - 60_f64.to_radians().sin() / 3.0).abs() < 1e-15 && (omega.y + 0.5).abs() < 1e-15);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pinning {
    mass: f64,
    radius: f64,
    spin: f64,
    angle: f64,
    sin: f64,
    cos: f64,
    about_centre: PrincipalMoments,
    about_pin: PrincipalMoments,
}

impl Pinning {
    /// The body at the moment of the snap.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: PinningParameters) -> Result<Self, InvalidQuantity> {
        let PinningParameters { shape, mass, radius, spin, pin } = parameters;
        let about_centre = match shape {
            Shape::Hoop => Body::hoop(mass, radius),
            Shape::Disk => Body::thin_disk(mass, radius),
            Shape::Sphere => Body::sphere(mass, radius),
        }?
        .moments();
        InvalidQuantity::check("spin", spin, "rad/s")?;
        InvalidQuantity::require(spin != 0.0, "spin", spin, "rad/s", Rule::NotZero)?;
        let (angle, (sin, cos)) = pin.direction(radius)?;
        let [tangent, diameter, normal] = about_centre.to_array();
        let shift = mass * radius * radius;
        // eq:moments-about-pin
        let about_pin = PrincipalMoments::new(tangent + shift, diameter, normal + shift)?;
        Ok(Self { mass, radius, spin, angle, sin, cos, about_centre, about_pin })
    }

    /// The angle θ, rad.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// The principal moments about the pinned point, along 1, 2, 3 (`eq:moments-about-pin`).
    #[must_use]
    pub fn moments_about_pin(&self) -> PrincipalMoments {
        self.about_pin
    }

    /// The angular velocity before, along 1, 2, 3, rad/s.
    #[must_use]
    pub fn omega_before(&self) -> Vector3<f64> {
        Vector3::new(self.sin, -self.cos, 0.0) * self.spin
    }

    /// The angular momentum about A, before and after, kg·m²/s (`eq:pin-momentum`).
    #[must_use]
    pub fn angular_momentum(&self) -> Vector3<f64> {
        self.about_centre.angular_momentum(&self.omega_before())
    }

    /// The part of the rotation about the tangent that survives, the moment about the centre over that about A: 1/3,
    /// 1/5 or 2/7 (`eq:pin-components`).
    #[must_use]
    pub fn survival(&self) -> f64 {
        self.about_centre.to_array()[0] / self.about_pin.to_array()[0]
    }

    /// The angular velocity just after, rad/s (`eq:spin-after`).
    #[must_use]
    pub fn omega_after(&self) -> Vector3<f64> {
        Vector3::new(self.survival() * self.sin, -self.cos, 0.0) * self.spin
    }

    /// The velocity along axis 3, m/s, just after, of the point B a quarter of the circle from A, at the polar angle θ
    /// + 90° (`eq:speed-of-b`).
    #[must_use]
    pub fn velocity_of_b(&self) -> f64 {
        let omega = self.omega_after();
        self.radius * (omega.x + omega.y)
    }

    /// The velocity along axis 3, m/s, just after, of the point opposite B, at the polar angle θ − 90°.
    #[must_use]
    pub fn velocity_opposite_b(&self) -> f64 {
        let omega = self.omega_after();
        self.radius * (omega.x - omega.y)
    }

    /// The velocity of the centre just after, m/s (`eq:centre-after`).
    #[must_use]
    pub fn centre_velocity(&self) -> Vector3<f64> {
        self.omega_after().cross(&self.centre())
    }

    /// The impulse at A that pins it, N·s (`eq:pin-impulse`).
    #[must_use]
    pub fn impulse(&self) -> Vector3<f64> {
        self.centre_velocity() * self.mass
    }

    /// The energy that the snap takes, J (`eq:energy-lost`).
    #[must_use]
    pub fn energy_lost(&self) -> f64 {
        let diameter = self.about_centre.to_array()[0];
        0.5 * diameter * (self.spin * self.sin).powi(2) * (1.0 - self.survival()) // eq:energy-lost
    }

    /// The torque about A, N·m, that would keep the angular velocity as it is just after (`eq:holding-torque`).
    #[must_use]
    pub fn holding_torque(&self) -> Vector3<f64> {
        self.omega_after().cross(&self.angular_momentum())
    }

    /// The force at A, N, that this steady rotation needs (`eq:holding-force`).
    #[must_use]
    pub fn holding_force(&self) -> Vector3<f64> {
        let omega = self.omega_after();
        omega.cross(&omega.cross(&self.centre())) * self.mass
    }

    /// The angle χ₀ from axis 1, the tangent at A, to the axis of rotation after the snap, rad; for the hoop `tan χ₀ =
    /// 3 cot θ` (`eq:pin-angles`). For positive spin.
    #[must_use]
    pub fn axis_angle(&self) -> f64 {
        self.cos.atan2(self.survival() * self.sin)
    }

    /// The angle φ from the axis of rotation before the snap to that after it, towards A, rad: `χ₀ + θ − φ = π/2`
    /// (`eq:pin-angles`). For positive spin.
    #[must_use]
    pub fn axis_shift(&self) -> f64 {
        let left = self.survival();
        // eq:pin-angles with this for ⅓.
        ((1.0 - left) * self.sin * self.cos).atan2(self.cos * self.cos + left * self.sin * self.sin)
    }

    /// The motion afterwards if nothing but the pin holds the body: free rotation about A, in closed form.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the spin is of a size that cannot be computed with.
    pub fn free_motion(&self) -> Result<FreeTop, InvalidQuantity> {
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body: self.omega_after() };
        FreeTop::new(self.about_pin, start)
    }

    /// How fast a small disturbance of the rotation about the tangent grows when nothing but the pin holds the body:
    /// as `e^{λt}`, with λ of the rotation that is left in the plane of 1 and 2, 1/s (`eq:pinned-growth`). Zero for a
    /// ball.
    #[must_use]
    pub fn growth_rate(&self) -> f64 {
        let [about_tangent, _, _] = self.about_pin.growth_squared();
        self.omega_after().xy().norm() * about_tangent.max(0.0).sqrt()
    }

    /// The time from the snap until for the first time nothing is left of the rotation about the tangent, s: a
    /// quarter of the period of [`Pinning::free_motion`], with a relative error below 4e-15 (`eq:hoop-wait` in the
    /// limit). `None` if that never comes.
    ///
    /// A pin very near a right angle has to be given by its place, [`Pin::Point`].
    ///
    /// # Errors
    /// As [`Pinning::free_motion`].
    pub fn wait(&self) -> Result<Option<f64>, InvalidQuantity> {
        Ok(self.free_motion()?.period().map(|period| 0.25 * period))
    }

    /// The centre as seen from A, in the body, m.
    #[must_use]
    pub fn centre(&self) -> Vector3<f64> {
        Vector3::new(0.0, self.radius, 0.0)
    }
}

impl Pin {
    /// The angle θ, rad, and its sine and cosine, on a body of a radius, m.
    fn direction(self, radius: f64) -> Result<(f64, (f64, f64)), InvalidQuantity> {
        match self {
            Self::Angle(angle) => {
                InvalidQuantity::check_not_negative("angle from the axis", angle, "rad")?;
                InvalidQuantity::require(angle <= PI, "angle from the axis", angle, "rad", Rule::AtMost(PI))?;
                Ok((angle, angle.sin_cos()))
            }
            Self::Point { from_axis, height } => {
                InvalidQuantity::check_not_negative("distance of the point from the axis", from_axis, "m")?;
                InvalidQuantity::check("height of the point", height, "m")?;
                let distance = from_axis.hypot(height);
                let is_on_surface = (distance - radius).abs() <= ON_THE_SURFACE * radius;
                let name = "distance of the point from the centre";
                InvalidQuantity::require(is_on_surface, name, distance, "m", Rule::EqualTo(radius))?;
                Ok((from_axis.atan2(height), (from_axis / distance, height / distance)))
            }
        }
    }
}

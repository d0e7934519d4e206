//! A spinning body that is suddenly pinned at a point of its surface. Chapter "The pinned hoop".
//!
//! Before, the centre is at rest and the body turns with ω₀ about a diameter. Axes 1, 2, 3 are those of the body at the
//! moment of the snap, and of the room: 2 from the pinned point A to the centre, 1 along the tangent on the side of ω₀,
//! 3 = 1 × 2. The pole of ω₀ is at the polar angle θ from A, and `ω₀ = ω₀ (sin θ, −cos θ, 0)`. A hoop and a disc lie in the plane
//! of 1 and 2.

use crate::euler::Turning;
use crate::free_rotation::FreeTop;
use crate::inertia::{Body, PrincipalMoments};
use crate::quantity::{InvalidQuantity, Rule, Shown};
use nalgebra::{UnitQuaternion, Vector3};
use std::error::Error;
use std::f64::consts::PI;
use std::fmt;

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

/// A spinning body and the point at which it is pinned. What it says of the snap is good to 1.4e-15 of itself.
///
/// ```
/// use mechanics::scenes::pinned_hoop::{Pinning, Shape};
/// let hoop = Pinning::new(Shape::Hoop, 1.0, 1.0, 1.0, 60_f64.to_radians())?;
/// // A third of the component across A survives, and all of the component along it (eq:spin-after).
/// let omega = hoop.omega_after();
/// assert!((omega.x - 60_f64.to_radians().sin() / 3.0).abs() < 1e-15 && (omega.y + 0.5).abs() < 1e-15);
/// # Ok::<(), mechanics::scenes::pinned_hoop::InvalidPinning>(())
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
    /// A body of mass, kg, and radius, m, that turns with `spin`, rad/s, of either sign, about a diameter, and the angle θ,
    /// rad, from 0 to π, of the pinned point from the axis of rotation.
    ///
    /// Near a right angle the motion afterwards hangs on the cosine of θ, and few digits of it survive the rounding of θ in radians: at
    /// 89.999° eleven. [`Pinning::at_point`] takes both components as they are and keeps all.
    ///
    /// # Errors
    /// [`InvalidPinning`] if a number breaks its rule.
    pub fn new(shape: Shape, mass: f64, radius: f64, spin: f64, angle: f64) -> Result<Self, InvalidPinning> {
        InvalidQuantity::check_not_negative("angle from the axis", angle, "rad")?;
        InvalidQuantity::require(angle <= PI, "angle from the axis", angle, "rad", Rule::AtMost(PI))?;
        let (sin, cos) = angle.sin_cos();
        Self::with_direction(shape, mass, radius, spin, angle, sin, cos)
    }

    /// The same with the pinned point given by its position from the centre, m: its first component across the axis of
    /// rotation, its second along it.
    ///
    /// # Errors
    /// [`InvalidPinning::NotOnSurface`] if the point is not at the distance of the radius, to rounding; else as
    /// [`Pinning::new`].
    pub fn at_point(
        shape: Shape,
        mass: f64,
        radius: f64,
        spin: f64,
        point: [f64; 2],
    ) -> Result<Self, InvalidPinning> {
        for component in point {
            InvalidQuantity::check("position of the point", component, "m")?;
        }
        let [across, along] = point;
        let distance = across.hypot(along);
        InvalidQuantity::check_positive("radius", radius, "m")?;
        if (distance - radius).abs() > ON_THE_SURFACE * radius {
            return Err(InvalidPinning::NotOnSurface { distance, radius });
        }
        let (sin, cos) = (across.abs() / distance, along / distance);
        Self::with_direction(shape, mass, radius, spin, sin.atan2(cos), sin, cos)
    }

    fn with_direction(
        shape: Shape,
        mass: f64,
        radius: f64,
        spin: f64,
        angle: f64,
        sin: f64,
        cos: f64,
    ) -> Result<Self, InvalidPinning> {
        InvalidQuantity::check("spin", spin, "rad/s")?;
        InvalidQuantity::require(spin != 0.0, "spin", spin, "rad/s", Rule::NotZero)?;
        let body = match shape {
            Shape::Hoop => Body::hoop(mass, radius),
            Shape::Disk => Body::thin_disk(mass, radius),
            Shape::Sphere => Body::sphere(mass, radius),
        }?;
        let about_centre = body.moments();
        let [tangent, diameter, normal] = about_centre.to_array();
        let shift = mass * radius * radius; // eq:steiner
        let about_pin = PrincipalMoments::new(tangent + shift, diameter, normal + shift)?;
        Ok(Self { mass, radius, spin, angle, sin, cos, about_centre, about_pin })
    }

    /// The angle θ, rad.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// The principal moments about the pinned point, along 1, 2, 3 (`eq:moments-about-pin`).
    pub fn moments_about_pin(&self) -> PrincipalMoments {
        self.about_pin
    }

    /// The angular velocity before, along 1, 2, 3, rad/s.
    pub fn omega_before(&self) -> Vector3<f64> {
        Vector3::new(self.sin, -self.cos, 0.0) * self.spin
    }

    /// The angular momentum about A, before and after, kg·m²/s (`eq:pin-momentum`).
    pub fn angular_momentum(&self) -> Vector3<f64> {
        self.about_centre.angular_momentum(&self.omega_before())
    }

    /// κ = I₁/(I₁ + ma²): the part of the rotation about the tangent that survives; 1/3, 1/5 or 2/7.
    pub fn survival(&self) -> f64 {
        self.about_centre.to_array()[0] / self.about_pin.to_array()[0]
    }

    /// The angular velocity just after, rad/s (`eq:spin-after`).
    pub fn omega_after(&self) -> Vector3<f64> {
        Vector3::new(self.survival() * self.sin, -self.cos, 0.0) * self.spin
    }

    /// The velocities along axis 3, m/s, just after, of the two points B a quarter of the circle from A: first that at polar
    /// angle θ + 90°, then that at θ − 90° (`eq:speed-of-b`).
    pub fn velocities_of_b(&self) -> [f64; 2] {
        let omega = self.omega_after();
        [self.radius * (omega.x + omega.y), self.radius * (omega.x - omega.y)]
    }

    /// The velocity of the centre just after, m/s (`eq:centre-after`).
    pub fn centre_velocity(&self) -> Vector3<f64> {
        self.omega_after().cross(&self.centre())
    }

    /// The impulse at A that pins it, N·s (`eq:pin-impulse`).
    pub fn impulse(&self) -> Vector3<f64> {
        self.centre_velocity() * self.mass
    }

    /// The energy that the snap takes, J (`eq:energy-lost`).
    pub fn energy_lost(&self) -> f64 {
        let transverse = self.about_centre.to_array()[0];
        0.5 * transverse * (self.spin * self.sin).powi(2) * (1.0 - self.survival())
    }

    /// The torque about A, N·m, that would keep the angular velocity as it is just after (`eq:holding-torque`).
    pub fn holding_torque(&self) -> Vector3<f64> {
        self.omega_after().cross(&self.angular_momentum())
    }

    /// The force at A, N, that this steady rotation needs (`eq:holding-force`).
    pub fn holding_force(&self) -> Vector3<f64> {
        let omega = self.omega_after();
        omega.cross(&omega.cross(&self.centre())) * self.mass
    }

    /// The angle α from axis 1 to the axis of rotation after the snap, rad, and the angle φ between the axes of rotation
    /// before and after, rad: `α + θ − φ = π/2` (`eq:pin-angles`). Both for positive spin.
    pub fn axis_angles(&self) -> [f64; 2] {
        let kappa = self.survival();
        let turned =
            ((1.0 - kappa) * self.sin * self.cos).atan2(kappa * self.sin * self.sin + self.cos * self.cos);
        [self.cos.atan2(kappa * self.sin), turned]
    }

    /// The motion afterwards if nothing but the pin holds the body: free rotation about A, in closed form.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the spin is of a size that cannot be computed with.
    pub fn free_motion(&self) -> Result<FreeTop, InvalidQuantity> {
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body: self.omega_after() };
        FreeTop::new(self.about_pin, start)
    }

    /// The centre as seen from A, in the body, m.
    pub fn centre(&self) -> Vector3<f64> {
        Vector3::new(0.0, self.radius, 0.0)
    }
}

/// Why there is no such snap.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvalidPinning {
    /// Another number breaks a rule.
    Quantity(InvalidQuantity),
    /// The point is not on the rim.
    NotOnSurface {
        /// Its distance from the centre, m.
        distance: f64,
        /// The radius, m.
        radius: f64,
    },
}

impl From<InvalidQuantity> for InvalidPinning {
    fn from(error: InvalidQuantity) -> Self {
        Self::Quantity(error)
    }
}

impl fmt::Display for InvalidPinning {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Quantity(error) => error.fmt(out),
            Self::NotOnSurface { distance, radius } => write!(
                out,
                "the point at {} m from the centre is not on the rim, at {} m",
                Shown(distance),
                Shown(radius)
            ),
        }
    }
}

impl Error for InvalidPinning {}

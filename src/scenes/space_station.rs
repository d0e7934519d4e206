//! A turning ring struck by a meteor. Chapter "The struck space station".
//!
//! Axes 1, 2, 3 are fixed in the station, 3 along its axis; at time zero, the moment of the blow, they are the axes x, y, z
//! of the room, whose origin is where the station's centre then is. The station turns with ω₀ about 3 and is struck at
//! `+r` along axis 2 with an impulse P along axis 3. Only the impulse counts: no mass is added.

use crate::euler::Turning;
use crate::free_rotation::FreeSymmetricTop;
use crate::inertia::Body;
use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::{UnitQuaternion, Vector3};

/// A station that turns about its axis of symmetry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    body: Body,
    spin: f64,
}

/// The station after the blow: a free symmetric top whose centre drifts. Its angles and rates are good to 9e-16 of themselves.
///
/// ```
/// use mechanics::scenes::space_station::Station;
/// // A ring of 400 t and 50 m radius that turns in about fourteen seconds, struck on the rim.
/// let struck = Station::ring(4e5, 50.0, 0.45)?.struck(50.0, 1.8e6)?;
/// // The angular momentum tilts by half as much as the axis of rotation (eq:struck-angle, eq:struck-momentum).
/// let ratio = struck.momentum_angle().tan() / struck.axis_angle().tan();
/// assert!((ratio - 0.5).abs() < 1e-14);
/// // It nods twice as often as one sees it turn (eq:nodding-rate).
/// assert!((struck.nodding_rate() / 0.45 - 2.0).abs() < 0.04);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Struck {
    top: FreeSymmetricTop,
    drift: f64,
    spin: f64,
}

impl Station {
    /// A station with its mass and moments that turns with `spin`, rad/s, of either sign, about axis 3.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the body has no axis of symmetry, or the spin is zero, not finite or of a size that cannot be
    /// computed with.
    pub fn new(body: Body, spin: f64) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check("spin", spin, "rad/s")?;
        InvalidQuantity::require(spin != 0.0, "spin", spin, "rad/s", Rule::NotZero)?;
        let station = Self { body, spin };
        station.turning_with(0.0)?;
        Ok(station)
    }

    /// A station in the form of a thin ring of mass, kg, and radius, m, with its spin, rad/s.
    ///
    /// # Errors
    /// As [`Station::new`], and for a mass or radius that is not positive.
    pub fn ring(mass: f64, radius: f64, spin: f64) -> Result<Self, InvalidQuantity> {
        Self::new(Body::hoop(mass, radius)?, spin)
    }

    /// The mass and the moments.
    pub fn body(&self) -> Body {
        self.body
    }

    /// The angular velocity ω₀ before the blow, rad/s.
    pub fn spin(&self) -> f64 {
        self.spin
    }

    /// The station just after a blow with `impulse`, N·s, along axis 3, at the distance `radius`, m, from the axis, in the
    /// direction of axis 2 (`eq:struck-rate`).
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a negative radius, and for numbers that are not finite or of a size that cannot be computed
    /// with.
    pub fn struck(&self, radius: f64, impulse: f64) -> Result<Struck, InvalidQuantity> {
        InvalidQuantity::check_not_negative("radius of the blow", radius, "m")?;
        InvalidQuantity::check("impulse", impulse, "N·s")?;
        let [transverse, _, _] = self.body.moments().to_array();
        let gained = InvalidQuantity::check("angular velocity", radius * impulse / transverse, "rad/s")?;
        let drift = InvalidQuantity::check("drift", impulse / self.body.mass(), "m/s")?;
        Ok(Struck { top: self.turning_with(gained)?, drift, spin: self.spin })
    }

    fn turning_with(&self, omega_1: f64) -> Result<FreeSymmetricTop, InvalidQuantity> {
        let start = Turning {
            world_from_body: UnitQuaternion::identity(),
            omega_body: Vector3::new(omega_1, 0.0, self.spin),
        };
        FreeSymmetricTop::new(self.body.moments(), start)
    }
}

impl Struck {
    /// The angular velocity `ω_P` about axis 1 that the blow adds, rad/s (`eq:struck-rate`).
    pub fn added_rate(&self) -> f64 {
        self.top.start().omega_body.x
    }

    /// The angle between the spin before and the angular velocity after the blow, rad, from 0 to π/2
    /// (`eq:struck-angle`).
    pub fn axis_angle(&self) -> f64 {
        self.added_rate().abs().atan2(self.spin.abs())
    }

    /// The angle between the spin before the blow and the angular momentum after it, rad, from 0 to π/2
    /// (`eq:struck-momentum`). The station's axis keeps this angle to the angular momentum.
    pub fn momentum_angle(&self) -> f64 {
        let momentum = self.top.angular_momentum_world();
        momentum.x.abs().atan2(momentum.z.abs())
    }

    /// The angular momentum about the moving centre, in the room, kg·m²/s; constant (`eq:struck-momentum`).
    pub fn angular_momentum_world(&self) -> Vector3<f64> {
        self.top.angular_momentum_world()
    }

    /// The rate Λ, rad/s, at which the station's axis goes round the angular momentum, in a frame that moves with the centre
    /// and does not turn (`eq:nodding-rate`).
    pub fn nodding_rate(&self) -> f64 {
        self.top.precession_rate()
    }

    /// The rate σ, rad/s, at which the axis of rotation goes round the station's axis, as seen on board
    /// (`eq:struck-body-rate`).
    pub fn body_rate(&self) -> f64 {
        self.top.body_rate()
    }

    /// Attitude and angular velocity at `time`, s, after the blow.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is not finite, or larger than 1e50 s.
    pub fn at(&self, time: f64) -> Result<Turning, InvalidQuantity> {
        self.top.at(time)
    }

    /// The velocity of the centre, m/s: `P/m` along the old axis, constant (`eq:drift`).
    pub fn centre_velocity(&self) -> Vector3<f64> {
        Vector3::new(0.0, 0.0, self.drift)
    }

    /// The position at `time`, s, of the point of the station that was at `point_body`, m, along its axes, in the room.
    ///
    /// # Errors
    /// As [`Struck::at`], and for a point that is not finite or of a size that cannot be computed with.
    pub fn position(&self, point_body: &Vector3<f64>, time: f64) -> Result<Vector3<f64>, InvalidQuantity> {
        for component in point_body {
            InvalidQuantity::check("position of the point", *component, "m")?;
        }
        Ok(self.centre_velocity() * time + self.at(time)?.world_from_body * point_body)
    }
}

//! A turning ring that is struck. Chapter "The struck space station".
//!
//! Axes 1, 2, 3 are fixed in the station, 3 along its axis; at time zero, the moment of the blow, they are the axes x,
//! y, z of the room, whose origin is where the station's centre then is. The station turns with ω₀ about 3 and is
//! struck at `+r` along axis 2 with an impulse P along axis 3. Only the impulse counts: no mass is added.

use crate::euler::Turning;
use crate::free_rotation::FreeSymmetricTop;
use crate::inertia::Body;
use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::{UnitQuaternion, Vector3};

/// A station that turns about its axis of symmetry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station(StationParameters);

/// What turns, and how fast.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StationParameters {
    /// Mass and moments; the axis of symmetry is axis 3.
    pub body: Body,
    /// Angular velocity ω₀ about axis 3, rad/s, of either sign, not zero.
    pub spin: f64,
}

/// A blow along axis 3, on axis 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blow {
    /// How far from axis 3 it strikes, m, zero or more; the radius a for one on the rim.
    pub radius: f64,
    /// The impulse P along axis 3, N·s, of either sign.
    pub impulse: f64,
}

/// A later blow along axis 3, anywhere on the station: a thruster that is fired once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaterBlow {
    /// When it strikes, s after the first.
    pub time: f64,
    /// Its azimuth about axis 3 from axis 2, where the first one struck, rad.
    pub azimuth: f64,
    /// How far from axis 3 it strikes, and its impulse.
    pub blow: Blow,
}

impl LaterBlow {
    /// What it makes of a station that has turned as `top` until then, as [`StruckStation::struck_again`]: a third blow
    /// strikes what the second one left. Its time is counted from the beginning of `top`.
    ///
    /// # Errors
    /// As [`StruckStation::struck_again`].
    pub fn on(&self, top: &FreeSymmetricTop) -> Result<FreeSymmetricTop, InvalidQuantity> {
        let Self { time, azimuth, blow: Blow { radius, impulse } } = *self;
        InvalidQuantity::check("azimuth of the blow", azimuth, "rad")?;
        InvalidQuantity::check_not_negative("radius of the blow", radius, "m")?;
        InvalidQuantity::check("impulse", impulse, "N·s")?;
        let Turning { world_from_body, omega_body } = top.at(time)?;
        let added = radius * impulse / top.moments().as_symmetric()?.transverse; // eq:struck-rate
        let gained = Vector3::new(azimuth.cos(), azimuth.sin(), 0.0) * added;
        FreeSymmetricTop::new(top.moments(), Turning { world_from_body, omega_body: omega_body + gained })
    }
}

/// The station after the blow: a free symmetric top whose centre drifts. Its angles and rates are good to 9e-16 of
/// themselves.
///
/// ```
/// use mechanics::{inertia::Body, scenes::space_station::{Blow, StationParameters, Station}};
/// // A ring of 400 t and 50 m radius that turns in about fourteen seconds, struck on the rim.
/// let station = Station::new(StationParameters { body: Body::hoop(4e5, 50.0)?, spin: 0.45 })?;
/// let struck = station.struck(Blow { radius: 50.0, impulse: 1.8e6 })?;
/// // The angular momentum tilts by half as much as the axis of rotation (eq:struck-angle, eq:struck-momentum).
/// let ratio = struck.momentum_angle().tan() / struck.axis_angle().tan();
/// assert!((ratio - 0.5).abs() < 1e-14);
/// // It nods twice as often as one sees it turn (eq:nodding-rate).
/// assert!((struck.nodding_rate() / 0.45 - 2.0).abs() < 0.04);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StruckStation {
    top: FreeSymmetricTop,
    drift: f64,
    spin: f64,
}

impl Station {
    /// The station before the blow.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the body has no axis of symmetry along 3, or the spin is zero, not finite or of a size
    /// that cannot be computed with.
    pub fn new(parameters: StationParameters) -> Result<Self, InvalidQuantity> {
        let StationParameters { body, spin } = parameters;
        body.moments().as_symmetric()?;
        InvalidQuantity::check("spin", spin, "rad/s")?;
        InvalidQuantity::require(spin != 0.0, "spin", spin, "rad/s", Rule::NotZero)?;
        Ok(Self(parameters))
    }

    /// The mass and the moments.
    #[must_use]
    pub fn body(&self) -> Body {
        self.0.body
    }

    /// The angular velocity ω₀ before the blow, rad/s.
    #[must_use]
    pub fn spin(&self) -> f64 {
        self.0.spin
    }

    /// The station just after a blow (`eq:struck-rate`).
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a negative radius, and for numbers that are not finite or of a size that cannot be
    /// computed with.
    pub fn struck(&self, Blow { radius, impulse }: Blow) -> Result<StruckStation, InvalidQuantity> {
        let Self(StationParameters { body, spin }) = *self;
        InvalidQuantity::check_not_negative("radius of the blow", radius, "m")?;
        InvalidQuantity::check("impulse", impulse, "N·s")?;
        let i1 = body.moments().as_symmetric()?.transverse;
        let added = radius * impulse / i1; // eq:struck-rate
        let drift = impulse / body.mass(); // eq:drift
        let because =
            "for this station it gives an angular velocity, rad/s, or a drift, m/s, outside 1e-50 to 1e50";
        let computable = [added, drift].iter().all(|&result| InvalidQuantity::is_computable(result));
        InvalidQuantity::require(computable, "impulse", impulse, "N·s", Rule::Because(because))?;
        let start = Turning {
            world_from_body: UnitQuaternion::identity(),
            omega_body: Vector3::new(added, 0.0, spin),
        };
        Ok(StruckStation { top: FreeSymmetricTop::new(body.moments(), start)?, drift, spin })
    }
}

impl StruckStation {
    /// The angular velocity `ω_P` about axis 1 that the blow adds, rad/s (`eq:struck-rate`).
    #[must_use]
    pub fn added_rate(&self) -> f64 {
        self.top.start().omega_body.x
    }

    /// The angle between the spin before and the angular velocity after the blow, rad, from 0 to π/2
    /// (`eq:struck-angle`).
    #[must_use]
    pub fn axis_angle(&self) -> f64 {
        self.added_rate().abs().atan2(self.spin.abs()) // eq:struck-angle
    }

    /// The angle between the spin before the blow and the angular momentum after it, rad, from 0 to π/2
    /// (`eq:struck-momentum`). The station's axis keeps this angle to the angular momentum.
    #[must_use]
    pub fn momentum_angle(&self) -> f64 {
        let momentum = self.top.angular_momentum_world();
        momentum.x.abs().atan2(momentum.z.abs())
    }

    /// The angular momentum about the moving centre, in the room, kg·m²/s; constant (`eq:struck-momentum`).
    #[must_use]
    pub fn angular_momentum_world(&self) -> Vector3<f64> {
        self.top.angular_momentum_world()
    }

    /// The rate Λ, rad/s, at which the station's axis goes round the angular momentum, in a frame that moves with the
    /// centre and does not turn (`eq:nodding-rate`).
    #[must_use]
    pub fn nodding_rate(&self) -> f64 {
        self.top.precession_rate()
    }

    /// The rate σ, rad/s, at which the axis of rotation goes round the station's axis, as seen on board
    /// (`eq:struck-body-rate`).
    #[must_use]
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

    /// Attitude and angular velocity at each of `times`, s, after the blow: the states of [`StruckStation::at`].
    ///
    /// # Errors
    /// As [`StruckStation::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Turning>, InvalidQuantity> {
        self.top.sample(times)
    }

    /// The velocity of the centre, m/s: `P/m` along the old axis, constant (`eq:drift`).
    #[must_use]
    pub fn centre_velocity(&self) -> Vector3<f64> {
        Vector3::new(0.0, 0.0, self.drift)
    }

    /// The station as a free top after a later blow, in the frame that moves along with its centre. The times
    /// of the top begin at that blow. As the first does (`eq:struck-rate`), the blow adds `r × P` to the
    /// angular momentum.
    ///
    /// # Errors
    /// As [`StruckStation::at`], and [`InvalidQuantity`] for a negative radius and for numbers that are not finite or
    /// of a size that cannot be computed with.
    pub fn struck_again(&self, later: LaterBlow) -> Result<FreeSymmetricTop, InvalidQuantity> {
        later.on(&self.top)
    }

    /// The position at `time`, s, of the point of the station that was at `point_body`, m, along its axes, in the room.
    ///
    /// # Errors
    /// As [`StruckStation::at`], and for a point that is not finite or of a size that cannot be computed with.
    pub fn position(&self, point_body: &Vector3<f64>, time: f64) -> Result<Vector3<f64>, InvalidQuantity> {
        for component in point_body {
            InvalidQuantity::check("position of the point", *component, "m")?;
        }
        Ok(self.centre_velocity() * time + self.at(time)?.world_from_body * point_body)
    }
}

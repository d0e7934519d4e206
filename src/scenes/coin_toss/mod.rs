//! A coin tossed from a flat hand: which face it shows, and when. Chapter "The coin toss".
//!
//! The coin starts flat, its heads side up, with angular velocity ω₁ about a diameter and ω₃ about its axis. In the
//! room z is up and x lies along that diameter at time zero. The flight of the centre of mass is another matter
//! ([`Flight`]): it decides only when the coin is caught. Air and bounces are left out, and the edge everywhere but in
//! [`Toss::landings`].

mod landing;
mod people;

pub use landing::{Landings, edge_at_random};
pub use people::{TossCount, Tossers, TossersParameters};

use crate::euler::Turning;
use crate::free_rotation::FreeSymmetricTop;
use crate::inertia::{PrincipalMoments, SymmetricMoments};
use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

/// A coin in the air, in closed form.
///
/// ```
/// use mechanics::inertia::Body;
/// use mechanics::scenes::coin_toss::{Toss, TossParameters};
/// let moments = Body::thin_disk(0.0075, 0.0122)?.moments();
/// let toss = |omega_3: f64| Toss::new(TossParameters { moments, omega_1: 100.0, omega_3 });
/// // Twice as much tumbling as spinning is the limit for a thin coin (eq:never-flips).
/// assert!(toss(51.0)?.keeps_its_face());
/// assert!(!toss(49.0)?.keeps_its_face());
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Toss {
    top: FreeSymmetricTop,
    cosine_of_double_angle: f64, // cos 2θ_L, exact near the threshold, where it vanishes
}

/// A coin, and what the thumb gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TossParameters {
    /// Principal moments of the coin, whose axis of symmetry is axis 3.
    pub moments: PrincipalMoments,
    /// The tumble ω₁, rad/s, about a diameter, of either sign; not zero together with the twist.
    pub omega_1: f64,
    /// The twist ω₃, rad/s, about the axis, of either sign.
    pub omega_3: f64,
}

/// What an observer straight above sees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Face {
    /// The side that was up in the hand.
    Same,
    /// The other side.
    Other,
    /// The coin stands exactly on edge.
    Edge,
}

impl Toss {
    /// The coin as it leaves the hand.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the coin has no axis of symmetry along 3, a number is not finite or of a size that cannot
    /// be computed with, or the coin does not turn at all.
    pub fn new(parameters: TossParameters) -> Result<Self, InvalidQuantity> {
        let TossParameters { moments, omega_1, omega_3 } = parameters;
        let SymmetricMoments { transverse: i1, axial: i3 } = moments.as_symmetric()?;
        let turns = omega_1 != 0.0 || omega_3 != 0.0;
        let rule = Rule::Because("the twist is zero as well, and a tossed coin turns");
        InvalidQuantity::require(turns, "tumble", omega_1, "rad/s", rule)?;
        let start = Turning {
            world_from_body: UnitQuaternion::identity(),
            omega_body: Vector3::new(omega_1, 0.0, omega_3),
        };
        let top = FreeSymmetricTop::new(moments, start)?;
        // cos 2θ_L = (L₃² − L₁²)/L² of eq:toss-angle, with exact products.
        let (l1, l3) = (TwoPart::product(i1, omega_1), TwoPart::product(i3, omega_3));
        let cosine_of_double_angle = (l3 - l1) * (l3 + l1) / (l3 * l3 + l1 * l1);
        Ok(Self { top, cosine_of_double_angle: cosine_of_double_angle.rounded() })
    }

    /// Attitude and angular velocity at `time`, s.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is not finite, or larger than 1e50 s.
    pub fn at(&self, time: f64) -> Result<Turning, InvalidQuantity> {
        self.top.at(time)
    }

    /// Attitude and angular velocity at each of `times`, s: the states of [`Toss::at`].
    ///
    /// # Errors
    /// As [`Toss::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Turning>, InvalidQuantity> {
        self.top.sample(times)
    }

    /// The normal of the side that was up, in the room, at `time`, s (`eq:axis-motion`); as exact as
    /// [`FreeSymmetricTop::at`].
    ///
    /// # Errors
    /// As [`Toss::at`].
    pub fn normal(&self, time: f64) -> Result<Vector3<f64>, InvalidQuantity> {
        self.top.axis_world(time)
    }

    /// How high the normal points, `n_z = cos²θ_L + sin²θ_L cos Λt`, at `time`, s (`eq:normal-height`): to 2e-15 for as
    /// long as [`FreeSymmetricTop::at`] has its digits. Never below zero if the coin keeps its face.
    ///
    /// # Errors
    /// As [`Toss::at`].
    pub fn normal_height(&self, time: f64) -> Result<f64, InvalidQuantity> {
        // eq:normal-height as eq:lowest-normal and 2 sin²θ_L cos² ½Λt: of a coin that keeps its face neither is negative.
        let (_, cos) = self.top.half_precession(time)?;
        Ok(self.cosine_of_double_angle + (1.0 - self.cosine_of_double_angle) * cos * cos)
    }

    /// What is seen from above at `time`, s.
    ///
    /// # Errors
    /// As [`Toss::at`].
    pub fn face(&self, time: f64) -> Result<Face, InvalidQuantity> {
        let height = self.normal_height(time)?;
        Ok(if height > 0.0 {
            Face::Same
        } else if height < 0.0 {
            Face::Other
        } else {
            Face::Edge
        })
    }

    /// The angle `θ_L` between the coin's axis and its angular momentum, rad, from 0 to π (`eq:toss-angle`).
    #[must_use]
    pub fn momentum_angle(&self) -> f64 {
        self.top.momentum_angle()
    }

    /// The rate Λ, rad/s, at which the normal goes round the angular momentum (`eq:precession-rate`).
    #[must_use]
    pub fn precession_rate(&self) -> f64 {
        self.top.precession_rate()
    }

    /// The lowest height of the normal, `cos 2θ_L`, reached half a precession after the start (`eq:lowest-normal`). To
    /// 9e-16 of itself, next to the threshold too, where it vanishes; and so are the time and the probability that
    /// follow from it.
    #[must_use]
    pub fn lowest_normal(&self) -> f64 {
        self.cosine_of_double_angle
    }

    /// Whether the side that was up is seen from above at all times: `|I₃ω₃| ≥ |I₁ω₁|` (`eq:never-flips`). At equality
    /// the coin stands on edge once in a precession and turns back.
    #[must_use]
    pub fn keeps_its_face(&self) -> bool {
        self.cosine_of_double_angle >= 0.0
    }

    /// The first time, s, at which the coin stands on edge on its way over; `None` if it never goes over
    /// (`eq:edge-time`).
    #[must_use]
    pub fn first_edge(&self) -> Option<f64> {
        self.half_edge_angle().map(|half| 2.0 * half / self.precession_rate())
    }

    /// The part of the time during which the side that was up is seen from above; if the moment of the catch is as good
    /// as random, the probability that the coin shows the same face (`eq:same-face`). From 1/2 to 1.
    #[must_use]
    pub fn same_face_probability(&self) -> f64 {
        self.half_edge_angle().map_or(1.0, |half| FRAC_2_PI * half) // eq:same-face
    }

    /// Half the angle Λt at which the coin first stands on edge, rad (`eq:edge-half`).
    fn half_edge_angle(&self) -> Option<f64> {
        (!self.keeps_its_face()).then(|| 1_f64.atan2((-self.cosine_of_double_angle).sqrt())) // eq:edge-half
    }
}

/// The ratio ω₃/ω₁ from which on a coin with these moments never shows its other face: I₁/I₃, one half for a thin disc
/// (`eq:never-flips`).
///
/// # Errors
/// [`InvalidQuantity`] if the body has no axis of symmetry along 3.
///
/// ```
/// use mechanics::inertia::{Body, Cylinder};
/// use mechanics::scenes::coin_toss::steady_face_ratio;
/// // A thick slice of a rod, 2 cm in radius and 1 cm high, must spin a little faster than a thin coin for that.
/// let slice = Body::cylinder(0.1, Cylinder { radius: 0.02, height: 0.01 })?.moments();
/// assert_eq!(format!("{:.3}", steady_face_ratio(slice)?), "0.542");
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
pub fn steady_face_ratio(moments: PrincipalMoments) -> Result<f64, InvalidQuantity> {
    let SymmetricMoments { transverse, axial } = moments.as_symmetric()?;
    Ok(transverse / axial)
}

/// The ratio ω₃/ω₁ at which a coin shows the same face with a given probability: `(I₁/I₃) √(−cos πp)`
/// (`eq:ratio-for-bias`).
///
/// # Errors
/// [`InvalidQuantity`] if the body has no axis of symmetry along 3, or the probability is not from 1/2 to 1.
///
/// ```
/// use mechanics::{inertia::Body, scenes::coin_toss::ratio_for_probability};
/// let coin = Body::thin_disk(0.0075, 0.0122)?.moments();
/// assert_eq!(format!("{:.4}", ratio_for_probability(coin, 0.51)?), "0.0886");
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
pub fn ratio_for_probability(moments: PrincipalMoments, probability: f64) -> Result<f64, InvalidQuantity> {
    Ok(steady_face_ratio(moments)? * cotangent_for_probability(probability)?) // eq:ratio-for-bias
}

/// The angle `θ_L`, rad, between axis and angular momentum at which a coin shows the same face with a given probability:
/// from π/2 at 1/2 down to π/4 at 1 (`eq:ratio-for-bias`).
///
/// # Errors
/// [`InvalidQuantity`] if the probability is not from 1/2 to 1.
///
/// ```
/// use mechanics::scenes::coin_toss::angle_for_probability;
/// // A bias of one in a hundred takes no more than ten degrees of wobble.
/// assert_eq!(format!("{:.1}°", angle_for_probability(0.51)?.to_degrees()), "79.9°");
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
pub fn angle_for_probability(probability: f64) -> Result<f64, InvalidQuantity> {
    Ok(1_f64.atan2(cotangent_for_probability(probability)?))
}

/// `cot θ_L = √(−cos πp)`.
fn cotangent_for_probability(probability: f64) -> Result<f64, InvalidQuantity> {
    let name = "probability of the same face";
    InvalidQuantity::require_finite(name, probability, "")?;
    InvalidQuantity::require(probability >= 0.5, name, probability, "", Rule::AtLeast(0.5))?;
    InvalidQuantity::require(probability <= 1.0, name, probability, "", Rule::AtMost(1.0))?;
    // −cos πp = sin π(p − ½), of a small angle near one half.
    Ok((PI * (probability - 0.5)).min(FRAC_PI_2).sin().sqrt())
}

/// The flight of the coin's centre of mass: thrown straight up, caught on the way down.
///
/// ```
/// use mechanics::scenes::coin_toss::{Flight, FlightParameters};
/// // Caught where it was thrown.
/// let flight = Flight::new(FlightParameters { speed: 2.4, gravity: 9.81, catch_height: 0.0 })?;
/// assert!((flight.duration() - 2.0 * 2.4 / 9.81).abs() < 1e-15);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    speed: f64,
    gravity: f64,
    duration: f64,
}

/// A throw and a catch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlightParameters {
    /// Speed v, m/s, straight up, zero or more.
    pub speed: f64,
    /// Gravity g, m/s², more than zero.
    pub gravity: f64,
    /// How far above the throwing hand the coin is caught, `z_catch`, m; below, if negative.
    pub catch_height: f64,
}

impl Flight {
    /// The flight from hand to hand.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule or the coin never gets so high.
    pub fn new(parameters: FlightParameters) -> Result<Self, InvalidQuantity> {
        let FlightParameters { speed, gravity, catch_height } = parameters;
        InvalidQuantity::check_not_negative("speed", speed, "m/s")?;
        InvalidQuantity::check_positive("gravity", gravity, "m/s²")?;
        InvalidQuantity::check("catch height", catch_height, "m")?;
        let square = speed * speed - 2.0 * gravity * catch_height;
        let limit = 0.5 * speed * speed / gravity;
        let rule = Rule::NotAbove { what: "the highest point of the flight", limit };
        InvalidQuantity::require(square >= 0.0, "catch height", catch_height, "m", rule)?;
        Ok(Self { speed, gravity, duration: (speed + square.sqrt()) / gravity }) // eq:flight-time
    }

    /// The time from hand to hand, s (`eq:flight-time`), to 9e-16 of itself. Just below the highest point it hangs on
    /// the root of what is missing, and has half the digits of the height of the catch.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// Height above the throwing hand at `time`, s, in m.
    #[must_use]
    pub fn height(&self, time: f64) -> f64 {
        (self.speed - 0.5 * self.gravity * time) * time
    }
}

//! A coin tossed from a flat hand: which face it shows, and when. Chapter "The coin toss".
//!
//! The coin starts flat, its heads side up, with angular velocity ω₁ about a diameter and ω₃ about its axis. In the room z is
//! up and x lies along that diameter at time zero. The flight of the centre of mass is another matter ([`Flight`]): it
//! decides only when the coin is caught. Air, edges and bounces are left out.

use crate::euler::Turning;
use crate::free_rotation::FreeSymmetricTop;
use crate::inertia::{PrincipalMoments, SymmetricMoments};
use crate::quantity::{InvalidQuantity, Shown};
use crate::two_part::TwoPart;
use nalgebra::{UnitQuaternion, Vector3};
use std::error::Error;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};
use std::fmt;

/// A coin in the air, in closed form.
///
/// ```
/// use mechanics::inertia::Body;
/// use mechanics::scenes::coin_toss::{Face, Toss};
/// let coin = Body::thin_disk(0.0075, 0.0122)?.moments();
/// // Twice as much tumbling as spinning is the limit for a thin coin (eq:never-flips).
/// assert!(Toss::new(coin, 100.0, 51.0)?.keeps_its_face());
/// assert!(!Toss::new(coin, 100.0, 49.0)?.keeps_its_face());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Toss {
    top: FreeSymmetricTop,
    cosine_of_double_angle: f64, // cos 2ψ, exact near the threshold, where it vanishes
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
    /// A coin with these moments, its axis along 3, tossed with `omega_1` about a diameter and `omega_3` about its axis,
    /// rad/s, of any sign.
    ///
    /// # Errors
    /// [`InvalidToss`] if the coin has no axis of symmetry, a number is not finite or of a size that cannot be computed with,
    /// or the coin does not turn at all.
    pub fn new(moments: PrincipalMoments, omega_1: f64, omega_3: f64) -> Result<Self, InvalidToss> {
        if omega_1 == 0.0 && omega_3 == 0.0 {
            return Err(InvalidToss::NoSpin);
        }
        let start = Turning {
            world_from_body: UnitQuaternion::identity(),
            omega_body: Vector3::new(omega_1, 0.0, omega_3),
        };
        let top = FreeSymmetricTop::new(moments, start)?;
        let [i1, _, i3] = moments.to_array();
        // (L₃ − L₁)(L₃ + L₁)/L², with exact products.
        let (across, along) = (TwoPart::product(i1, omega_1), TwoPart::product(i3, omega_3));
        let square = along * along + across * across;
        let cosine_of_double_angle = (along - across) * (along + across) / square;
        Ok(Self { top, cosine_of_double_angle: cosine_of_double_angle.rounded() })
    }

    /// Attitude and angular velocity at `time`, s.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is not finite, or larger than 1e50 s.
    pub fn at(&self, time: f64) -> Result<Turning, InvalidQuantity> {
        self.top.at(time)
    }

    /// The normal of the side that was up, in the room, at `time`, s (`eq:axis-motion`); as exact as [`FreeSymmetricTop::at`].
    ///
    /// # Errors
    /// As [`Toss::at`].
    pub fn normal(&self, time: f64) -> Result<Vector3<f64>, InvalidQuantity> {
        self.top.axis_world(time)
    }

    /// How high the normal points, `n_z = cos²ψ + sin²ψ cos Λt`, at `time`, s (`eq:normal-height`): to 2e-15 for as long as
    /// [`FreeSymmetricTop::at`] has its digits. Never below zero if the coin keeps its face.
    ///
    /// # Errors
    /// As [`Toss::at`].
    pub fn normal_height(&self, time: f64) -> Result<f64, InvalidQuantity> {
        // Above the lowest by 2 sin²ψ cos² ½Λt, which is not negative.
        let (_, cos) = (self.top.precession(time)? * 0.5).sin_cos();
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

    /// The angle ψ between the coin's axis and its angular momentum, rad, from 0 to π (`eq:toss-angle`).
    pub fn momentum_angle(&self) -> f64 {
        self.top.momentum_angle()
    }

    /// The rate Λ, rad/s, at which the normal goes round the angular momentum (`eq:precession-rate`).
    pub fn precession_rate(&self) -> f64 {
        self.top.precession_rate()
    }

    /// The lowest height of the normal, `cos 2ψ`, reached half a precession after the start (`eq:lowest-normal`). To 9e-16 of itself, next to
    /// the threshold too, where it vanishes; and so are the time and the probability that follow from it.
    pub fn lowest_normal(&self) -> f64 {
        self.cosine_of_double_angle
    }

    /// Whether the side that was up is seen from above at all times: `|I₃ω₃| ≥ |I₁ω₁|` (`eq:never-flips`). At equality
    /// the coin stands on edge once in a precession and turns back.
    pub fn keeps_its_face(&self) -> bool {
        self.cosine_of_double_angle >= 0.0
    }

    /// The first time, s, at which the coin stands on edge on its way over; `None` if it never goes over
    /// (`eq:edge-time`).
    pub fn first_edge(&self) -> Option<f64> {
        self.same_face_half_angle().map(|half| 2.0 * half / self.precession_rate())
    }

    /// The part of the time during which the side that was up is seen from above; if the moment of the catch is as good as
    /// random, the probability that the coin shows the same face (`eq:same-face`). From 1/2 to 1.
    pub fn same_face_probability(&self) -> f64 {
        self.same_face_half_angle().map_or(1.0, |half| FRAC_2_PI * half)
    }

    /// Half the angle Λt at which the coin first stands on edge, rad: `atan2(1, √(−cos 2ψ))`.
    fn same_face_half_angle(&self) -> Option<f64> {
        (!self.keeps_its_face()).then(|| 1_f64.atan2((-self.cosine_of_double_angle).sqrt()))
    }
}

/// The ratio ω₃/ω₁ from which on a coin with these moments never shows its other face: I₁/I₃, one half for a thin disc
/// (`eq:never-flips`).
///
/// # Errors
/// [`InvalidToss`] if the body has no axis of symmetry along 3.
pub fn steady_face_ratio(moments: PrincipalMoments) -> Result<f64, InvalidToss> {
    let SymmetricMoments { transverse, axial } = moments.as_symmetric()?;
    Ok(transverse / axial)
}

/// The ratio ω₃/ω₁ at which a coin shows the same face with a given probability: `(I₁/I₃) √(−cos πp)`
/// (`eq:ratio-for-bias`).
///
/// # Errors
/// [`InvalidToss`] if the body has no axis of symmetry along 3, or the probability is not from 1/2 to 1.
pub fn ratio_for_probability(moments: PrincipalMoments, probability: f64) -> Result<f64, InvalidToss> {
    Ok(steady_face_ratio(moments)? * cotangent_for_probability(probability)?)
}

/// The angle ψ, rad, between axis and angular momentum at which a coin shows the same face with a given probability: from
/// π/2 at 1/2 down to π/4 at 1 (`eq:ratio-for-bias`).
///
/// # Errors
/// [`InvalidToss`] if the probability is not from 1/2 to 1.
pub fn angle_for_probability(probability: f64) -> Result<f64, InvalidToss> {
    Ok(1_f64.atan2(cotangent_for_probability(probability)?))
}

fn cotangent_for_probability(probability: f64) -> Result<f64, InvalidToss> {
    if !(0.5..=1.0).contains(&probability) {
        return Err(InvalidToss::Probability { probability });
    }
    // −cos πp, by the sine of a small angle near 1/2.
    Ok((PI * (probability - 0.5)).min(FRAC_PI_2).sin().sqrt())
}

/// The flight of the coin's centre of mass: thrown straight up, caught on the way down.
///
/// ```
/// use mechanics::scenes::coin_toss::Flight;
/// let flight = Flight::new(2.4, 9.81, 0.0)?; // caught where it was thrown
/// assert!((flight.duration() - 2.0 * 2.4 / 9.81).abs() < 1e-15);
/// # Ok::<(), mechanics::scenes::coin_toss::InvalidToss>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    speed: f64,
    gravity: f64,
    duration: f64,
}

impl Flight {
    /// Thrown upwards with `speed`, m/s, under `gravity`, m/s², and caught `catch_height`, m, above the hand that threw it;
    /// below, if negative.
    ///
    /// # Errors
    /// [`InvalidToss`] for a speed that is negative, a gravity that is not positive, a number that is not finite or of a size
    /// that cannot be computed with, and a catch above the highest point.
    pub fn new(speed: f64, gravity: f64, catch_height: f64) -> Result<Self, InvalidToss> {
        InvalidQuantity::check_not_negative("speed", speed, "m/s")?;
        InvalidQuantity::check_positive("gravity", gravity, "m/s²")?;
        InvalidQuantity::check("catch height", catch_height, "m")?;
        let highest = 0.5 * speed * speed / gravity;
        let square = speed * speed - 2.0 * gravity * catch_height;
        if square < 0.0 {
            return Err(InvalidToss::CatchTooHigh { catch_height, highest });
        }
        Ok(Self { speed, gravity, duration: (speed + square.sqrt()) / gravity })
    }

    /// The time from hand to hand, s (`eq:flight-time`), to 9e-16 of itself. Just below the highest point it hangs on the root of what is missing,
    /// and has half the digits of the height of the catch.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// Height above the throwing hand at `time`, s, in m.
    pub fn height(&self, time: f64) -> f64 {
        (self.speed - 0.5 * self.gravity * time) * time
    }
}

/// Why there is no such toss.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvalidToss {
    /// The coin does not turn.
    NoSpin,
    /// A number of the flight breaks a rule.
    Quantity(InvalidQuantity),
    /// A probability of the same face that no toss has.
    Probability {
        /// The probability.
        probability: f64,
    },
    /// The coin never gets so high.
    CatchTooHigh {
        /// Where it should be caught, m above the throwing hand.
        catch_height: f64,
        /// The highest point of the flight, m above the throwing hand.
        highest: f64,
    },
}

impl From<InvalidQuantity> for InvalidToss {
    fn from(error: InvalidQuantity) -> Self {
        Self::Quantity(error)
    }
}

impl fmt::Display for InvalidToss {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoSpin => {
                write!(out, "angular velocities ω₁ = 0 rad/s and ω₃ = 0 rad/s: a tossed coin turns")
            }
            Self::Quantity(error) => error.fmt(out),
            Self::Probability { probability } => write!(
                out,
                "probability {} of the same face is outside the range from 0.5 to 1 that tosses have",
                Shown(probability)
            ),
            Self::CatchTooHigh { catch_height, highest } => write!(
                out,
                "catch height {} m is above the highest point of the flight, {} m",
                Shown(catch_height),
                Shown(highest)
            ),
        }
    }
}

impl Error for InvalidToss {}

//! A ball on a cloth: how it slides, and when it rolls.

use super::solid::{Ball, BallState};
use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::Vector3;

/// A level cloth, and a ball on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cloth(ClothParameters);

/// A ball, and what it slides on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClothParameters {
    /// The ball.
    pub ball: Ball,
    /// The coefficient μ of sliding friction, more than zero.
    pub friction: f64,
    /// Gravity g, m/s², more than zero.
    pub gravity: f64,
}

/// How a shot begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShotStart {
    /// The velocity of the centre along x and y, m/s.
    pub velocity: [f64; 2],
    /// The angular velocity along x, y and z, rad/s.
    pub omega: [f64; 3],
}

/// A short blow with a level cue along x, in the upright plane through the centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cue {
    /// The speed that it gives to the centre, m/s, more than zero.
    pub speed: f64,
    /// How high above the cloth it strikes, m, from zero to the diameter.
    pub height: f64,
}

/// A ball on the cloth, from the blow on: it slides for [`Shot::sliding_time`], and then it rolls for ever, because
/// nothing here stops a ball that rolls (`eq:ball-slide`).
///
/// Velocities, and spins times the radius, are good to 2e-15 of the sum of both at the start, `|v₀| + a|ω₀|`; places to
/// as much of that times the time. The slip is good to 2e-15 of itself, however little is left of it.
///
/// ```
/// use mechanics::scenes::ball::{Ball, BallParameters, Cloth, ClothParameters, ShotStart};
/// // A billiard ball that is hit in the middle, at 3 m/s: it slides for 0.44 s, and keeps five sevenths.
/// let ball = Ball::new(BallParameters { radius: 0.028_6, moment_factor: Ball::SOLID })?;
/// let cloth = Cloth::new(ClothParameters { ball, friction: 0.2, gravity: 9.81 })?;
/// let shot = cloth.shot(ShotStart { velocity: [3.0, 0.0], omega: [0.0; 3] })?;
/// assert_eq!(format!("{:.3} s", shot.sliding_time()), "0.437 s");
/// assert!((shot.at(1.0)?.velocity.x - 3.0 * 5.0 / 7.0).abs() < 1e-15);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shot {
    ball: Ball,
    deceleration: f64,       // μg
    duration: TwoPart,       // T
    slip: Vector3<f64>,      // u₀
    direction: Vector3<f64>, // of u₀; zero if there is none
    rolling: Vector3<f64>,   // the velocity at the end
    pivot: f64,              // ω_z
}

impl Cloth {
    /// A cloth.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: ClothParameters) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check_positive("coefficient of friction", parameters.friction, "")?;
        InvalidQuantity::check_positive("gravity", parameters.gravity, "m/s²")?;
        Ok(Self(parameters))
    }

    /// The ball.
    #[must_use]
    pub fn ball(&self) -> Ball {
        self.0.ball
    }

    /// The motion that begins so.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a number that is not finite or of a size that cannot be computed with, and if the ball
    /// slides for more than 1e50 s.
    pub fn shot(&self, start: ShotStart) -> Result<Shot, InvalidQuantity> {
        let ClothParameters { ball, friction, gravity } = self.0;
        let ShotStart { velocity, omega } = start;
        for component in velocity {
            InvalidQuantity::check("velocity", component, "m/s")?;
        }
        for component in omega {
            InvalidQuantity::check("angular velocity", component, "rad/s")?;
        }
        let (a, k) = (ball.radius(), ball.moment_factor());
        // What rolling with this spin would be, aω × ẑ, and the slip, as exact differences: a ball that nearly rolls
        // has all the digits of how much it does not.
        let spun = [TwoPart::product(a, omega[1]), TwoPart::product(-a, omega[0])];
        let slip = [0, 1].map(|axis| TwoPart::from(velocity[axis]) - spun[axis]); // eq:ball-slip
        let one_and_k = TwoPart::sum(1.0, k);
        let rolling = [0, 1].map(|axis| (TwoPart::from(velocity[axis]) + spun[axis] * k) / one_and_k); // eq:ball-final
        let speed = length(slip);
        let duration = ball.exact_share() * speed / TwoPart::product(friction, gravity); // eq:ball-slide-time
        let because = "with this friction the ball slides for more than 1e50 s";
        let ends = duration.rounded() <= 1e50;
        InvalidQuantity::require(ends, "coefficient of friction", friction, "", Rule::Because(because))?;
        let [x, y] =
            slip.map(|component| if speed.rounded() > 0.0 { (component / speed).rounded() } else { 0.0 });
        Ok(Shot {
            ball,
            deceleration: friction * gravity,
            duration,
            slip: Vector3::new(slip[0].rounded(), slip[1].rounded(), 0.0),
            direction: Vector3::new(x, y, 0.0),
            rolling: Vector3::new(rolling[0].rounded(), rolling[1].rounded(), 0.0),
            pivot: omega[2],
        })
    }

    /// The motion after a blow with a cue (`eq:ball-cue`).
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule, and as [`Cloth::shot`].
    pub fn struck(&self, Cue { speed, height }: Cue) -> Result<Shot, InvalidQuantity> {
        let ball = self.0.ball;
        InvalidQuantity::check_positive("speed", speed, "m/s")?;
        InvalidQuantity::check_not_negative("height of the cue", height, "m")?;
        let (a, top) = (ball.radius(), 2.0 * ball.radius());
        let over = Rule::NotAbove { what: "the height of the ball", limit: top };
        InvalidQuantity::require(height <= top, "height of the cue", height, "m", over)?;
        let spin = (height - a) * speed / (ball.moment_factor() * a * a); // eq:ball-cue
        self.shot(ShotStart { velocity: [speed, 0.0], omega: [0.0, spin, 0.0] })
    }
}

/// The length of a level vector, whatever the size of its components.
fn length([x, y]: [TwoPart; 2]) -> TwoPart {
    let (large, small) = if x.rounded().abs() < y.rounded().abs() { (y, x) } else { (x, y) };
    if large.rounded() == 0.0 {
        return large;
    }
    let large = if large.rounded() < 0.0 { -large } else { large };
    let ratio = small / large;
    large * (TwoPart::from(1.0) + ratio * ratio).sqrt()
}

impl Shot {
    /// How long the ball slides, s (`eq:ball-slide-time`): to 9e-16 of itself, and zero if it rolls from the start.
    #[must_use]
    pub fn sliding_time(&self) -> f64 {
        self.duration.rounded()
    }

    /// The velocity of the centre, m/s, from the end of sliding on (`eq:ball-final`): each component to 9e-16 of itself
    /// and 1e-31 of those at the start.
    #[must_use]
    pub fn rolling_velocity(&self) -> Vector3<f64> {
        self.rolling
    }

    /// The slip at the start, m/s in the room: the velocity of the point of the ball that touches the cloth.
    #[must_use]
    pub fn first_slip(&self) -> Vector3<f64> {
        self.slip
    }

    /// Where the centre is when sliding ends, m.
    #[must_use]
    pub fn end_of_sliding(&self) -> Vector3<f64> {
        let duration = self.duration.rounded();
        self.rolling * duration + self.direction * (self.deceleration * 0.5 * duration * duration)
    }

    /// The energy over the mass, J/kg, that sliding turns into heat: `½ u₀² k/(1 + k)` (`eq:ball-heat`).
    #[must_use]
    pub fn energy_lost(&self) -> f64 {
        0.5 * self.ball.share() * self.slip.norm_squared()
    }

    /// The velocity, m/s in the room, of the point of the ball that touches the cloth, at `time`, s
    /// (`eq:ball-slide`). Zero from [`Shot::sliding_time`] on.
    ///
    /// # Errors
    /// As [`Shot::at`].
    pub fn slip(&self, time: f64) -> Result<Vector3<f64>, InvalidQuantity> {
        let (_, left) = self.slid_and_left(time)?;
        Ok(if left > 0.0 { self.slip * (left / self.duration.rounded()) } else { Vector3::zeros() })
    }

    /// The ball at `time`, s, zero or more.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is negative, not finite, or larger than 1e50 s.
    pub fn at(&self, time: f64) -> Result<BallState, InvalidQuantity> {
        let (slid, left) = self.slid_and_left(time)?;
        let (a, k) = (self.ball.radius(), self.ball.moment_factor());
        // eq:ball-slide, counted from the rolling that it ends in: neither phase needs the other.
        let excess = self.direction * (self.deceleration * left);
        let mean = self.duration.rounded() - 0.5 * slid; // of T at the start and T − s now
        let gained = self.direction * (self.deceleration * slid * mean);
        let spun = self.rolling - excess / k;
        Ok(BallState {
            centre: self.rolling * time + gained,
            velocity: self.rolling + excess,
            omega: Vector3::new(-spun.y / a, spun.x / a, self.pivot),
        })
    }

    /// The ball at each of `times`, s: the states of [`Shot::at`].
    ///
    /// # Errors
    /// As [`Shot::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<BallState>, InvalidQuantity> {
        times.iter().map(|&time| self.at(time)).collect()
    }

    /// How long the ball has been sliding at `time`, and how long it will be, s. The end is known to 32 digits, so the
    /// time that is left has all its digits until none is left.
    fn slid_and_left(&self, time: f64) -> Result<(f64, f64), InvalidQuantity> {
        InvalidQuantity::check_time(time)?;
        InvalidQuantity::require(time >= 0.0, "time", time, "s", Rule::NotNegative)?;
        let left = (self.duration - TwoPart::from(time)).rounded();
        Ok(if left > 0.0 { (time, left) } else { (self.duration.rounded(), 0.0) })
    }
}

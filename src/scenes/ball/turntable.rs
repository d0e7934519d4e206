//! A ball that rolls on a table which turns at a constant rate.

use super::solid::{Ball, BallState};
use crate::clock::Clock;
use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI};

/// A rough flat table that turns about its normal, and a ball on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turntable(TurntableParameters);

/// A ball, and the table on which it rolls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurntableParameters {
    /// The ball.
    pub ball: Ball,
    /// The rate Ω at which the table turns about its normal z, rad/s, of either sign; zero for a table at rest.
    pub rate: f64,
    /// The angle ε by which the table slopes down along x, rad, of either sign, less than a right angle.
    pub slope: f64,
    /// Gravity g, m/s², more than zero.
    pub gravity: f64,
}

/// How a ball begins to roll on the table. Its spin about level axes follows, because nothing slips.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurntableStart {
    /// Where the centre is, along x and y from the axis of the table, m.
    pub place: [f64; 2],
    /// The velocity of the centre, along x and y of the room, m/s.
    pub velocity: [f64; 2],
    /// The spin about the normal, rad/s, which stays as it is.
    pub pivot: f64,
}

/// The circle on which the ball goes round, whose centre drifts if the table slopes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Its centre at time zero, m.
    pub centre: Vector3<f64>,
    /// Its radius, m.
    pub radius: f64,
    /// The velocity at which it drifts across the slope, m/s (`eq:ball-drift`).
    pub drift: Vector3<f64>,
}

/// A ball that rolls on a turning table, at any time before or after the start (`eq:ball-table-motion`).
///
/// Velocities are good to 2e-15 of `|v₀| + f min(t, 2/λ)`, and places to as much of `|r₀| + |v₀| min(t, 2/λ) + f t
/// min(t, 2/λ)`, with λ the rate of the circles and f the acceleration down the slope that a table at rest would give,
/// at any time.
///
/// ```
/// use mechanics::scenes::ball::{Ball, BallParameters, Turntable, TurntableParameters, TurntableStart};
/// // A record turns 33⅓ times a minute; a ball on it is back after three and a half turns, wherever it was pushed.
/// let ball = Ball::new(BallParameters { radius: 0.01, moment_factor: Ball::SOLID })?;
/// let rate = 100.0 / 90.0 * std::f64::consts::PI;
/// let record = Turntable::new(TurntableParameters { ball, rate, slope: 0.0, gravity: 9.81 })?;
/// let roll = record.roll(TurntableStart { place: [0.05, 0.0], velocity: [0.0, 0.1], pivot: 0.0 })?;
/// assert_eq!(format!("{:.1} s", roll.period().ok_or("it turns")?), "6.3 s");
/// assert!((roll.at(6.3)?.centre.x - 0.05).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurntableRoll {
    table: Turntable,
    start: TurntableStart,
    half: Clock,                // of λt/2
    lambda: f64,                // kΩ/(1 + k)
    acceleration: Vector3<f64>, // f
}

impl Turntable {
    /// A table.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: TurntableParameters) -> Result<Self, InvalidQuantity> {
        let TurntableParameters { rate, slope, gravity, .. } = parameters;
        InvalidQuantity::check("rate of the table", rate, "rad/s")?;
        InvalidQuantity::check("slope", slope, "rad")?;
        let rule = Rule::Because("a table slopes by less than a right angle");
        InvalidQuantity::require(slope.abs() < FRAC_PI_2, "slope", slope, "rad", rule)?;
        InvalidQuantity::check_positive("gravity", gravity, "m/s²")?;
        Ok(Self(parameters))
    }

    /// What the table is made of.
    #[must_use]
    pub fn parameters(&self) -> TurntableParameters {
        self.0
    }

    /// The rate `λ = kΩ/(1 + k)`, rad/s, at which every ball goes round its circle, of the sign of Ω
    /// (`eq:ball-table-rate`).
    #[must_use]
    pub fn circle_rate(&self) -> f64 {
        self.exact_rate().rounded()
    }

    /// The same with all its digits.
    fn exact_rate(&self) -> TwoPart {
        self.0.ball.exact_share() * self.0.rate
    }

    /// The motion that begins so.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a number that is not finite or of a size that cannot be computed with.
    pub fn roll(&self, start: TurntableStart) -> Result<TurntableRoll, InvalidQuantity> {
        for component in start.place {
            InvalidQuantity::check("place", component, "m")?;
        }
        for component in start.velocity {
            InvalidQuantity::check("velocity", component, "m/s")?;
        }
        InvalidQuantity::check("spin about the normal", start.pivot, "rad/s")?;
        let TurntableParameters { ball, slope, gravity, .. } = self.0;
        let rate = self.exact_rate();
        let down = gravity * slope.sin() / (1.0 + ball.moment_factor());
        Ok(TurntableRoll {
            table: *self,
            start,
            half: Clock::from_rate(rate * 0.5),
            lambda: rate.rounded(),
            acceleration: Vector3::new(down, 0.0, 0.0),
        })
    }
}

/// `ẑ × v`.
fn turned(v: Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-v.y, v.x, 0.0)
}

/// `(x − sin x)/x²`, by its series where the difference would lose digits.
fn lag(x: f64, sin: f64) -> f64 {
    if x.abs() > 2.0 {
        return (x - sin) / (x * x);
    }
    let square = x * x;
    // x/3! (1 − x²/(4·5) (1 − x²/(6·7) (1 − …)))
    (2..15).rev().fold(1.0, |rest, n| 1.0 - square / f64::from((2 * n) * (2 * n + 1)) * rest) * x / 6.0
}

impl TurntableRoll {
    /// The ball at `time`, s.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is not finite, or larger than 1e50 s.
    pub fn at(&self, time: f64) -> Result<BallState, InvalidQuantity> {
        InvalidQuantity::check_time(time)?;
        let TurntableStart { place, velocity, pivot } = self.start;
        let TurntableParameters { ball, rate, .. } = self.table.0;
        let (place, push) =
            (Vector3::new(place[0], place[1], 0.0), Vector3::new(velocity[0], velocity[1], 0.0));
        let (sin, cos) = self.half.sin_cos::<true>(time);
        let half = 0.5 * self.lambda * time;
        let sinc = if half == 0.0 { 1.0 } else { sin / half };
        let by = |v: Vector3<f64>, cos: f64, sin: f64| v * cos + turned(v) * sin;
        // eq:ball-table-motion, without dividing by the rate: a table at rest is a case like any other.
        let chord = |v: Vector3<f64>| by(v, cos, sin) * (sinc * time);
        let velocity = by(push, (cos - sin) * (cos + sin), 2.0 * sin * cos) + chord(self.acceleration);
        let slid = by(self.acceleration * time, 0.5 * sinc * sinc, lag(2.0 * half, 2.0 * sin * cos)) * time;
        let centre = place + chord(push) + slid;
        let spun = (turned(velocity) + centre * rate) / ball.radius(); // eq:ball-table-roll
        Ok(BallState { centre, velocity, omega: Vector3::new(spun.x, spun.y, pivot) })
    }

    /// The ball at each of `times`, s: the states of [`TurntableRoll::at`].
    ///
    /// # Errors
    /// As [`TurntableRoll::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<BallState>, InvalidQuantity> {
        times.iter().map(|&time| self.at(time)).collect()
    }

    /// The time of one round, s, `2π(1 + k)/(kΩ)`, to 9e-16 of itself; `None` on a table at rest.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        (self.lambda != 0.0).then(|| 2.0 * PI / self.lambda.abs())
    }

    /// The circle (`eq:ball-circle`); `None` on a table at rest, where the ball rolls straight or down.
    #[must_use]
    pub fn circle(&self) -> Option<Circle> {
        if self.lambda == 0.0 {
            return None;
        }
        let TurntableStart { place, velocity, .. } = self.start;
        let drift = turned(self.acceleration) / self.lambda; // eq:ball-drift
        let arm = turned(Vector3::new(velocity[0], velocity[1], 0.0) - drift) / self.lambda;
        let centre = Vector3::new(place[0], place[1], 0.0) + arm; // eq:ball-circle
        Some(Circle { centre, radius: arm.norm(), drift })
    }

    /// The coefficient of friction without which the ball would slip in this state: the force along the table over the
    /// one across it (`eq:ball-table-grip`).
    #[must_use]
    pub fn grip_needed(&self, state: &BallState) -> f64 {
        let TurntableParameters { ball, slope, gravity, .. } = self.table.0;
        let force = turned(state.velocity) * self.lambda - self.acceleration * ball.moment_factor();
        force.norm() / (gravity * slope.cos())
    }
}

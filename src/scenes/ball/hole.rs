//! A ball that rolls round inside an upright cylinder.

use super::solid::{Ball, BallState};
use crate::clock::Clock;
use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// An upright cylinder, rough inside, and a ball in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hole(HoleParameters);

/// A ball, and the cylinder in which it rolls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HoleParameters {
    /// The ball.
    pub ball: Ball,
    /// The radius of the cylinder, m, more than that of the ball.
    pub radius: f64,
    /// Gravity g, m/s², more than zero.
    pub gravity: f64,
}

/// How a ball begins to roll round the wall. The other two components of its spin follow, because nothing slips.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HoleStart {
    /// The rate Ω at which the centre goes round the axis, rad/s, of either sign, not zero. It stays as it is.
    pub rate: f64,
    /// The velocity with which it rises, m/s; negative downwards.
    pub rise: f64,
    /// The component of its angular velocity along the outward normal of the wall, rad/s.
    pub pivot: f64,
}

/// A ball that rolls round a hole, at any time before or after the start, as if the wall had no ends and enough
/// friction (`eq:ball-hole-motion`).
///
/// With A the height of the start above the middle of the swing and B the speed of rising over the rate of the swing,
/// heights are good to 2e-15 of `|A| + |B|` and 1e-31 of `g/kΩ²`, their rates to as much times the rate of the swing,
/// and the places and velocities round the axis to 2e-15, at any time.
///
/// ```
/// use mechanics::scenes::ball::{Ball, BallParameters, Hole, HoleParameters, HoleStart};
/// // A golf ball that goes round its hole at 1 m/s, and is level at first, sinks by 5 cm and comes up again.
/// let ball = Ball::new(BallParameters { radius: 0.021_35, moment_factor: Ball::SOLID })?;
/// let hole = Hole::new(HoleParameters { ball, radius: 0.054, gravity: 9.81 })?;
/// let roll = hole.roll(HoleStart { rate: 1.0 / hole.gap(), rise: 0.0, pivot: 0.0 })?;
/// assert_eq!(format!("{:.1} cm", 100.0 * roll.lowest()), "-5.2 cm");
/// assert!(roll.at(roll.swing_period())?.centre.z.abs() < 1e-16);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HoleRoll {
    ball: Ball,
    gravity: f64,
    start: HoleStart,
    gap: f64,
    round: Clock,      // of Ωt
    half: Clock,       // of st/2
    swing: f64,        // s = |Ω| √(k/(1 + k))
    above_middle: f64, // A
    by_the_start: f64, // B = ż₀/s
}

impl Hole {
    /// A hole.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: HoleParameters) -> Result<Self, InvalidQuantity> {
        let HoleParameters { ball, radius, gravity } = parameters;
        InvalidQuantity::check_positive("radius of the hole", radius, "m")?;
        let rule = Rule::MoreThan(ball.radius());
        InvalidQuantity::require(radius > ball.radius(), "radius of the hole", radius, "m", rule)?;
        InvalidQuantity::check_positive("gravity", gravity, "m/s²")?;
        Ok(Self(parameters))
    }

    /// How far the centre is from the axis, ρ, m.
    #[must_use]
    pub fn gap(&self) -> f64 {
        self.0.radius - self.0.ball.radius()
    }

    /// How often the ball goes round while it goes down and up once: `√((1 + k)/k)`, 1.87 for a solid ball
    /// (`eq:ball-hole-rate`).
    #[must_use]
    pub fn rounds_per_swing(&self) -> f64 {
        (TwoPart::from(1.0) / self.0.ball.exact_share()).sqrt().rounded()
    }

    /// The motion that begins so.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a number that is not finite or of a size that cannot be computed with, a rate of zero,
    /// and where the swing would be of a size that cannot be computed with.
    pub fn roll(&self, start: HoleStart) -> Result<HoleRoll, InvalidQuantity> {
        let HoleParameters { ball, gravity, .. } = self.0;
        let HoleStart { rate, rise, pivot } = start;
        InvalidQuantity::check("rate of going round", rate, "rad/s")?;
        InvalidQuantity::require(rate != 0.0, "rate of going round", rate, "rad/s", Rule::NotZero)?;
        InvalidQuantity::check("velocity of rising", rise, "m/s")?;
        InvalidQuantity::check("spin about the normal", pivot, "rad/s")?;
        let swing = ball.exact_share().sqrt() * rate.abs(); // eq:ball-hole-rate
        // eq:ball-hole-middle, as exact as its parts allow where they cancel.
        let weight = TwoPart::from(gravity) / (TwoPart::product(rate, rate) * ball.moment_factor());
        let pivoted = TwoPart::product(ball.radius(), pivot) / TwoPart::from(rate);
        let above_middle = (weight + pivoted).rounded();
        let by_the_start = (TwoPart::from(rise) / swing).rounded();
        let because = "with it the ball would swing farther than 1e50 m";
        let computable = above_middle.abs().max(by_the_start.abs()) < 1e50;
        InvalidQuantity::require(computable, "rate of going round", rate, "rad/s", Rule::Because(because))?;
        Ok(HoleRoll {
            ball,
            gravity,
            start,
            gap: self.gap(),
            round: Clock::from_rate(TwoPart::from(rate)),
            half: Clock::from_rate(swing * 0.5),
            swing: swing.rounded(),
            above_middle,
            by_the_start,
        })
    }
}

impl HoleRoll {
    /// The ball at `time`, s.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is not finite, or larger than 1e50 s.
    pub fn at(&self, time: f64) -> Result<BallState, InvalidQuantity> {
        InvalidQuantity::check_time(time)?;
        let HoleStart { rate, rise, pivot } = self.start;
        let (sin_round, cos_round) = self.round.sin_cos::<true>(time);
        let (sin, cos) = self.half.sin_cos::<true>(time);
        let outward = Vector3::new(cos_round, sin_round, 0.0);
        let along = Vector3::new(-sin_round, cos_round, 0.0);
        // eq:ball-hole-motion by half the angle: what has hardly begun to swing loses no digits.
        let height = 2.0 * sin * (self.by_the_start * cos - self.above_middle * sin);
        let rising = rise * ((cos - sin) * (cos + sin)) - self.swing * self.above_middle * (2.0 * sin * cos);
        let a = self.ball.radius();
        let pivot = pivot + rate * height / a; // eq:ball-pivot
        let upright = -self.gap * rate / a;
        Ok(BallState {
            centre: outward * self.gap + Vector3::z() * height,
            velocity: along * (self.gap * rate) + Vector3::z() * rising,
            omega: outward * pivot + along * (rising / a) + Vector3::z() * upright,
        })
    }

    /// The ball at each of `times`, s: the states of [`HoleRoll::at`].
    ///
    /// # Errors
    /// As [`HoleRoll::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<BallState>, InvalidQuantity> {
        times.iter().map(|&time| self.at(time)).collect()
    }

    /// The rate `|Ω| √(k/(1 + k))` of going up and down, rad/s (`eq:ball-hole-rate`).
    #[must_use]
    pub fn swing_rate(&self) -> f64 {
        self.swing
    }

    /// The time, s, in which it goes down and up once.
    #[must_use]
    pub fn swing_period(&self) -> f64 {
        2.0 * PI / self.swing
    }

    /// The height of the middle of the swing above the start, m; mostly negative (`eq:ball-hole-middle`).
    #[must_use]
    pub fn middle(&self) -> f64 {
        -self.above_middle
    }

    /// How far it swings to either side of the middle, m.
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        self.above_middle.hypot(self.by_the_start)
    }

    /// The height of the lowest point above the start, m: never positive, to 2e-15 of itself.
    #[must_use]
    pub fn lowest(&self) -> f64 {
        -self.beyond(self.above_middle)
    }

    /// The height of the highest point above the start, m: never negative, to 2e-15 of itself.
    #[must_use]
    pub fn highest(&self) -> f64 {
        self.beyond(-self.above_middle)
    }

    /// `√(A² + B²) + A`, without the difference if A is negative.
    fn beyond(&self, above: f64) -> f64 {
        let far = self.amplitude() + above.abs();
        if above >= 0.0 || far == 0.0 { far } else { self.by_the_start * (self.by_the_start / far) }
    }

    /// The first time, s, after the start at which the ball is at the height of the start again
    /// (`eq:ball-hole-back`); `None` if it stays there.
    #[must_use]
    pub fn first_return(&self) -> Option<f64> {
        let (a, b) = (self.above_middle, self.by_the_start);
        if a == 0.0 && b == 0.0 {
            return None;
        }
        let half = b.atan2(a);
        let half = if b < 0.0 {
            half + PI
        } else if half == 0.0 {
            PI
        } else {
            half
        };
        Some(2.0 * half / self.swing)
    }

    /// The coefficient of friction without which the ball would slip somewhere in its swing: `(g + s²C)/(ρΩ²)` with the
    /// amplitude C, at the lowest point (`eq:ball-hole-grip`).
    #[must_use]
    pub fn grip_needed(&self) -> f64 {
        let most = self.gravity + self.swing * self.swing * self.amplitude();
        most / (self.gap * self.start.rate * self.start.rate)
    }

    /// The energy over the mass, J/kg, with the height counted from the start: constant.
    #[must_use]
    pub fn energy(&self, state: &BallState) -> f64 {
        self.ball.kinetic_energy(state) + self.gravity * state.centre.z
    }
}

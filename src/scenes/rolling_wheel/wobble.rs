//! The motion at any time from one wobble.
//!
//! Lean and angular velocities come back after one wobble, whatever the heading and the place. So the wheel repeats one and the same
//! path, turned and shifted: it is enough to integrate a single wobble.

use super::motion::Rolling;
use super::wheel::Wheel;
use crate::integrate::{Direction, Dop853, Failure, InvalidTolerance, Outcome};
use nalgebra::Complex;
use std::error::Error;
use std::f64::consts::TAU;
use std::fmt;

/// How long, in units of √(a/g), a turning point of the lean is waited for.
const PATIENCE: f64 = 1e4;

/// A motion that repeats itself after one wobble.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wobble {
    wheel: Wheel,
    solver: Dop853,
    start: Rolling,
    period: f64,
    heading_advance: f64,
    spin_advance: f64,
    step: Complex<f64>, // of the centre in one wobble, seen from the heading at its start
}

impl Wheel {
    /// Integrates one wobble of the motion from `start`, to `tolerance` a step ([`Dop853`]).
    ///
    /// By the lean: a wheel that comes nearer to flat than about a millionth of a radian gets lost in its rounding and is refused after
    /// much work; step such a one by [`Wheel::rates_by_tilt`].
    ///
    /// # Errors
    /// [`NoWobble`] if the lean does not swing (a steady motion, or one that falls flat), the tolerance cannot be met, or the
    /// integration fails.
    pub fn wobble(&self, start: Rolling, tolerance: f64) -> Result<Wobble, NoWobble> {
        let solver = Dop853::new(tolerance)?;
        let rates = |time: f64, state: &[f64; 8]| self.rates(time, state);
        let patience = PATIENCE * (self.radius / self.gravity).sqrt();
        let turning_point = |from: f64, state: [f64; 8], direction: Direction| {
            let event = |_: f64, state: &[f64; 8]| state[1];
            match solver.solve_until(rates, from, state, from + patience, event, direction) {
                Ok(Outcome::Event(end)) => Ok(end),
                Ok(Outcome::NoEvent(_)) => Err(NoWobble::Steady),
                Err(failure) => Err(NoWobble::Integration(failure)),
            }
        };
        if start.lean_rate == 0.0 && self.rates(0.0, &start.to_array())[1] == 0.0 {
            return Err(NoWobble::Steady);
        }
        // By way of the other turning point: the located one may lie a hair before its zero, and would be found again.
        let first = turning_point(0.0, start.to_array(), Direction::Falling)?;
        let other = turning_point(first.time, first.state, Direction::Rising)?;
        let second = turning_point(other.time, other.state, Direction::Falling)?;
        let period = second.time - first.time;
        // Between two equal turning points everything that repeats has repeated.
        let [before, after] = [first, second].map(|end| Rolling::from_array(end.state));
        let heading_advance = after.heading - before.heading;
        // What happens in one wobble, a turn and a shift of the plane, is the same wherever in it one begins: found between the
        // turning points, it gives the step of the centre from the start.
        let [begin, before_centre, after_centre] =
            [start.centre, before.centre, after.centre].map(|[x, y]| Complex::new(x, y));
        let turn = Complex::from_polar(1.0, heading_advance);
        let step = (after_centre - turn * before_centre) + (turn - 1.0) * begin;
        let step = step * Complex::from_polar(1.0, -start.heading);
        Ok(Wobble {
            wheel: *self,
            solver,
            start,
            period,
            heading_advance,
            spin_advance: after.spin - before.spin,
            step,
        })
    }
}

impl Wobble {
    /// The time of one wobble, s.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// How far the heading goes on in one wobble, rad.
    pub fn heading_advance(&self) -> f64 {
        self.heading_advance
    }

    /// How far the wheel turns about its axle in one wobble, relative to its frame, rad.
    pub fn spin_advance(&self) -> f64 {
        self.spin_advance
    }

    /// The states at `times`, s, in any order and of either sign, at the cost of one wobble.
    ///
    /// # Errors
    /// [`NoWobble`] if a time is not finite, or the integration fails.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Rolling>, NoWobble> {
        if let Some(&time) = times.iter().find(|time| !time.is_finite()) {
            return Err(NoWobble::Time { time });
        }
        let parts: Vec<(f64, f64)> = times
            .iter()
            .map(|time| {
                let whole = (time / self.period).floor();
                (whole, (time - whole * self.period).clamp(0.0, self.period))
            })
            .collect();
        let mut order: Vec<usize> = (0..times.len()).collect();
        order.sort_by(|&i, &j| parts[i].1.total_cmp(&parts[j].1));
        let sorted: Vec<f64> = order.iter().map(|&i| parts[i].1).collect();
        let rates = |time: f64, state: &[f64; 8]| self.wheel.rates(time, state);
        let (within, _) =
            self.solver.sample(rates, 0.0, self.start.to_array(), &sorted).map_err(NoWobble::Integration)?;
        let mut states = vec![self.start; times.len()];
        for (&place, state) in order.iter().zip(within) {
            states[place] = self.moved(&Rolling::from_array(state), parts[place].0);
        }
        Ok(states)
    }

    /// A state of the first wobble as it is so many wobbles later.
    fn moved(&self, state: &Rolling, wobbles: f64) -> Rolling {
        let turn = wobbles * self.heading_advance;
        let origin = Complex::new(self.start.centre[0], self.start.centre[1]);
        let here = Complex::new(state.centre[0], state.centre[1]) - origin;
        let facing = Complex::from_polar(1.0, self.start.heading);
        let centre = origin
            + facing * self.step * turned_sum(self.heading_advance, wobbles)
            + here * Complex::from_polar(1.0, turn);
        Rolling {
            heading: state.heading + turn,
            spin: state.spin + wobbles * self.spin_advance,
            centre: [centre.re, centre.im],
            ..*state
        }
    }
}

/// `1 + e^{iα} + … + e^{i(N−1)α}`, for negative N its continuation.
fn turned_sum(angle: f64, count: f64) -> Complex<f64> {
    // Whole turns make no difference.
    let angle = angle - TAU * (angle / TAU).round();
    let half = 0.5 * angle;
    let ratio = if half == 0.0 { count } else { (count * half).sin() / half.sin() };
    Complex::from_polar(1.0, (count - 1.0) * half) * ratio
}

/// Why there is no wobble.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum NoWobble {
    /// The lean does not swing.
    Steady,
    /// A time is not a finite number.
    Time {
        /// The time, s.
        time: f64,
    },
    /// The tolerance cannot be met.
    Tolerance(InvalidTolerance),
    /// The integration stopped.
    Integration(Failure<8>),
}

impl From<InvalidTolerance> for NoWobble {
    fn from(error: InvalidTolerance) -> Self {
        Self::Tolerance(error)
    }
}

impl fmt::Display for NoWobble {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Steady => write!(out, "the lean does not swing: a steady motion has no wobble to repeat"),
            Self::Time { time } => write!(out, "time {time} s is not a finite number"),
            Self::Tolerance(error) => error.fmt(out),
            Self::Integration(error) => error.fmt(out),
        }
    }
}

impl Error for NoWobble {}

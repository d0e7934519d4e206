//! The motion at any time from half a wobble.
//!
//! Lean and angular velocities come back after one wobble, whatever the heading and the place. So the wheel repeats one and the same
//! path, turned and shifted. And from a moment at which the lean turns, what follows is the mirror image of what came before. So it
//! is enough to know the motion between two such moments: those before and after the start, found by stepping away from it, back and
//! ahead. What is known best is then the start itself, which matters where a motion is unstable.

use super::motion::Rolling;
use super::swing::{Moment, Swing};
use super::wheel::Wheel;
use crate::frames::{InvalidFrames, fill};
use crate::integrate::{Failure, Taylor};
use crate::quantity::{InvalidQuantity, Rule, Shown};
use crate::rolling::{RollingSeries, sin_cos_tilt};
use crate::two_part::TwoPart;
use crate::wide::functions::{Clock, ROUNDABLE, sin_cos_quarters};
use nalgebra::Complex;
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt;

/// Series are given up after so many each way, unless the caller says otherwise.
const MOST_SERIES: usize = 50_000;
/// A looser tolerance, in radii and √(a/g), would be no number of the motion at all.
const LOOSEST_TOLERANCE: f64 = 1.0;

/// A motion that repeats itself after one wobble.
///
/// ```
/// use mechanics::scenes::rolling_wheel::Wheel;
/// let disc = Wheel::disk(1.0, 0.1)?;
/// let mut start = disc.steady(0.5, 0.3)?.state();
/// start.lean_rate = 1.0;
/// let wobble = disc.wobble(start, 1e-16)?;
/// let late = wobble.at(1000.0 * wobble.period())?;
/// assert!((late.lean - start.lean).abs() < 1e-11);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Wobble {
    radius: f64,
    unit: f64, // √(a/g), s
    // The start, in the room:
    heading: f64,
    spin: f64,
    contact: Complex<f64>, // m
    facing: Complex<f64>,  // e to the i times the heading of the series' frame
    // From there, in radii and √(a/g), back to where the lean turned (nothing, if it turns at the start) and ahead to where it turns:
    back: Option<Swing>,
    ahead: Swing,
    turned: (f64, Moment), // when it turned, zero or less, and the state in which it did
    turns: (f64, Moment),  // when it turns, and how
    heading_advance: f64,
    spin_advance: f64,
    half_turns: Clock,  // half of the heading's advance, less whole turns, for each wobble
    sin_half_turn: f64, // its sine after one
    stride: f64,        // how far the contact moves on in a wobble, in radii
}

impl Wheel {
    /// The motion from `start`, from half a wobble by a Taylor method of order sixteen whose last terms are as small as `tolerance`
    /// (in radii and √(a/g)), from 1e-17 to 1.
    ///
    /// A wheel that almost falls flat whirls round the more often the smaller k is. Whirls of more than fifty thousand series are given
    /// up, in a fraction of a second; [`Wheel::wobble_by`] sets another limit.
    ///
    /// # Errors
    /// [`NoWobble`] if a number of `start` cannot be computed with, the lean does not swing (a steady motion, one whose lean does not
    /// turn within ten thousand √(a/g), or one that falls flat to about 1e-16), the tolerance cannot be met, or the integration fails.
    pub fn wobble(&self, start: Rolling, tolerance: f64) -> Result<Wobble, NoWobble> {
        self.wobble_by(start, &Taylor::new(tolerance)?.with_max_expansions(MOST_SERIES))
    }

    /// The same with a solver of one's own, whose limits hold for the way ahead and for the way back.
    ///
    /// # Errors
    /// As [`Wheel::wobble`].
    pub fn wobble_by(&self, start: Rolling, solver: &Taylor) -> Result<Wobble, NoWobble> {
        solver.check_at_most(LOOSEST_TOLERANCE)?;
        let series = RollingSeries { across: 0.5 * self.factor, along: self.factor, drag: 0.0 };
        let state = self.series_state(&start)?;
        let ahead = Swing::new(solver, &series, state, 1.0)?;
        let back = (state[1] != 0.0).then(|| Swing::new(solver, &series, state, -1.0)).transpose()?;
        let opening = back.as_ref().map_or(0.0, Swing::duration);
        let at_start = Moment { state, contact: Complex::new(0.0, 0.0), facing: Complex::new(1.0, 0.0) };
        let turned = back.as_ref().map_or(at_start, Swing::end);
        let turns = ahead.end();

        // Whole turns make no difference.
        let half_advance = turns.state[4] - turned.state[4];
        let half_turn = half_advance - PI * (half_advance / PI).round();
        let (sin, cos) = half_turn.sin_cos();
        let way = (turns.contact - turned.contact) * turned.facing.conj();
        let [x, y] = self.contact_point(&start);
        Ok(Wobble {
            radius: self.radius,
            unit: (self.radius / self.gravity).sqrt(),
            heading: start.heading,
            spin: start.spin,
            contact: Complex::new(x, y),
            // The axes of the series are turned by π about the wheel's axis 2.
            facing: -Complex::cis(start.heading),
            heading_advance: 2.0 * half_advance,
            spin_advance: -2.0 * (turns.state[5] - turned.state[5]),
            half_turns: Clock::from_rate(TwoPart::from(half_turn)),
            sin_half_turn: sin,
            stride: 2.0 * (way.re * cos + way.im * sin),
            turned: (opening, turned),
            turns: (ahead.duration(), turns),
            back,
            ahead,
        })
    }

    /// The state of [`RollingSeries`], with heading and spin zero.
    fn series_state(&self, start: &Rolling) -> Result<[f64; 8], NoWobble> {
        let Rolling { lean, lean_rate, across, along, heading, spin, centre: [x, y] } = *start;
        let rule = Rule::LessThan(FRAC_PI_2);
        InvalidQuantity::check("lean", lean, "rad")?;
        InvalidQuantity::require(lean.abs() < FRAC_PI_2, "size of the lean", lean.abs(), "rad", rule)?;
        for (name, value, unit) in [
            ("rate of the lean", lean_rate, "rad/s"),
            ("angular velocity about axis 2", across, "rad/s"),
            ("angular velocity about axis 3", along, "rad/s"),
            ("heading", heading, "rad"),
            ("spin", spin, "rad"),
            ("position of the centre", x, "m"),
            ("position of the centre", y, "m"),
        ] {
            InvalidQuantity::check(name, value, unit)?;
        }
        let unit = (self.radius / self.gravity).sqrt();
        let over = unit / lean.cos();
        Ok([-lean.tan().asinh(), -lean_rate * over, across * over, -along * unit, 0.0, 0.0, 0.0, 0.0])
    }
}

impl Wobble {
    /// The time of one wobble, s.
    pub fn period(&self) -> f64 {
        2.0 * (self.turns.0 - self.turned.0) * self.unit
    }

    /// How far the heading goes on in one wobble, rad.
    pub fn heading_advance(&self) -> f64 {
        self.heading_advance
    }

    /// How far the wheel turns about its axle in one wobble, relative to its frame, rad.
    pub fn spin_advance(&self) -> f64 {
        self.spin_advance
    }

    /// The state at `time`, s, of either sign. At zero it is the start, to rounding.
    ///
    /// Within a few wobbles an error is at most 30 times what a change of the start and of the time by a part ε makes, and of 30 ε of the
    /// numbers themselves and of one in the units a, √(g/a) and rad, where ε is the tolerance or 2.2e-16, whichever is larger; the
    /// place has in addition 30 ε radii for each radian by which the heading has gone on. Later errors grow in proportion to the time. What
    /// a change of the start makes may be large: a wheel that comes near an unstable motion after its start leaves it as its last digits say.
    ///
    /// # Errors
    /// [`NoWobble::Time`] if the time is not finite, or so far away that it cannot be said where in a wobble it falls.
    pub fn at(&self, time: f64) -> Result<Rolling, NoWobble> {
        let (turned, turns) = (&self.turned, &self.turns);
        let (now, period) = (time / self.unit, 2.0 * (turns.0 - turned.0));
        // Whole wobbles, each from turn to turn of the lean, so that what one adds is not taken off again.
        let count = if now < 0.0 {
            ((now - turns.0) / period).ceil() + 0.0 // and not −0
        } else {
            ((now - turned.0) / period).floor()
        };
        if count.is_nan() || count.abs() > ROUNDABLE {
            return Err(NoWobble::Time { time });
        }
        // The rest: what follows a turn of the lean is what came before it, seen in a mirror.
        let (whole, rest) = TwoPart::product(count, period).parts();
        let since = (now - whole) - rest;
        let moment = if since < turned.0 {
            turned.1.mirror(self.between_turns(2.0 * turned.0 - since))
        } else if since > turns.0 {
            turns.1.mirror(self.between_turns(2.0 * turns.0 - since))
        } else {
            self.between_turns(since)
        };
        let Moment { state: [y, u, o, w, psi, phi, ..], contact, facing } = moment;

        // As many wobbles turn the frame and move it on.
        let (high, low) = self.half_turns.at(count);
        let (sin, cos) = sin_cos_quarters(high, low);
        let half_turned = Complex::new(cos, sin);
        // 1 + e^{iα} + … of so many terms is e^{i(N−1)α/2} times this.
        let ratio = if self.sin_half_turn == 0.0 { count } else { sin / self.sin_half_turn };
        // From where the lean turned; and 1 − e^{iNα} times the way there.
        let stride = turned.1.facing * (self.stride * ratio);
        let moved = half_turned * (stride - turned.1.contact * Complex::new(0.0, 2.0 * sin));
        let turn = half_turned * half_turned;
        let contact = self.contact + self.facing * (moved + turn * contact) * self.radius;
        let facing = self.facing * turn * facing;

        let (sin_tilt, cos_tilt) = sin_cos_tilt(y);
        // The centre is a sin θ from above the contact, to the left of the series' heading.
        let centre = contact + Complex::new(-facing.im, facing.re) * (self.radius * cos_tilt);
        Ok(Rolling {
            lean: cos_tilt.atan2(sin_tilt),
            lean_rate: -u * sin_tilt / self.unit,
            across: o * sin_tilt / self.unit,
            along: -w / self.unit,
            heading: self.heading + count * self.heading_advance + psi,
            spin: self.spin + count * self.spin_advance - phi,
            centre: [centre.re, centre.im],
        })
    }

    /// The motion from a turn of the lean to the next, by the time from the start, in √(a/g).
    fn between_turns(&self, time: f64) -> Moment {
        match &self.back {
            Some(back) if time < 0.0 => back.at(time),
            _ => self.ahead.at(time),
        }
    }

    /// The states at each of `times`, s, in any order and of either sign, written to `frames` without allocating.
    ///
    /// # Errors
    /// [`InvalidFrames::Length`] if there are not as many frames as times, and then nothing is written;
    /// [`InvalidFrames::Time`] at the first time that [`Wobble::at`] refuses.
    pub fn fill(&self, times: &[f64], frames: &mut [Rolling]) -> Result<(), InvalidFrames<NoWobble>> {
        fill(times, frames, |_, _| 0, |time| self.at(time))
    }

    /// The states at `times`, s, in any order and of either sign.
    ///
    /// # Errors
    /// As [`Wobble::at`].
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Rolling>, NoWobble> {
        times.iter().map(|&time| self.at(time)).collect()
    }
}

/// Why there is no wobble.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum NoWobble {
    /// The lean does not swing.
    Steady,
    /// A number of the start breaks its rule.
    Quantity(InvalidQuantity),
    /// A time is not finite, or so far away that it cannot be said where in a wobble it falls.
    Time {
        /// The time, s.
        time: f64,
    },
    /// The integration stopped. Time and state are its own, in units of √(a/g).
    Integration(Failure),
}

impl From<InvalidQuantity> for NoWobble {
    fn from(error: InvalidQuantity) -> Self {
        Self::Quantity(error)
    }
}

impl fmt::Display for NoWobble {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Steady => write!(out, "the lean does not swing: a steady motion has no wobble to repeat"),
            Self::Quantity(error) => error.fmt(out),
            Self::Time { time } => {
                write!(out, "time {} s must be finite, and at most 2^50 wobbles away", Shown(*time))
            }
            Self::Integration(error) => error.fmt(out),
        }
    }
}

impl Error for NoWobble {}

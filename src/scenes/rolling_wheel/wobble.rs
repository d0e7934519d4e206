//! The motion at any time from half a wobble.
//!
//! Lean and angular velocities come back after one wobble, whatever the heading and the place. So the wheel repeats one
//! and the same path, turned and shifted. And from a moment at which the lean turns, what follows is the mirror image
//! of what came before. So it is enough to know the motion between two such moments: those before and after the start,
//! found by stepping away from it, back and ahead. What is known best is then the start itself, which matters where a
//! motion is unstable.

use super::swing::{Moment, Swing};
use super::wheel::Wheel;
use crate::error::Error;
use crate::integrate::Taylor;
use crate::quantity::{InvalidQuantity, Rule};
use crate::rolling::{Placed, Rolling};
use crate::two_part::TwoPart;
use nalgebra::Complex;
use std::f64::consts::PI;

/// A looser tolerance, in radii and √(a/g), would be no number of the motion at all.
const LOOSEST_TOLERANCE: f64 = 1.0;
/// Beyond so many a rounded time does not say where in a wobble it falls.
const MOST_WOBBLES: f64 = 140_737_488_355_328.0; // 2^47

/// A motion that repeats itself after one wobble.
///
/// ```
/// use mechanics::integrate::Taylor;
/// use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
/// use mechanics::scenes::rolling_wheel::Wheel;
/// let (mass, radius, gravity) = (1.0, 0.1, 9.81);
/// let disc = Wheel::new(DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity })?;
/// let start = Rolling { omega_1: 1.0, ..disc.steady(0.5, 0.3)?.state() };
/// let wobble = disc.wobble(start, &Taylor::new(1e-16)?)?;
/// let late = wobble.at(1000.0 * wobble.period())?;
/// assert!((late.tilt - start.tilt).abs() < 1e-11);
/// # Ok::<(), mechanics::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Wobble {
    placed: Placed,
    // From the start, in radii and √(a/g), back to where the lean turned (nothing, if it turns at the start) and ahead
    // to where it turns:
    back: Option<Swing>,
    ahead: Swing,
    turned: (f64, Moment), // when it turned, zero or less, and the state in which it did
    turns: (f64, Moment),  // when it turns, and how
    heading_advance: f64,
    roll_advance: f64,
    half_turn: f64,     // half of the heading's advance, less whole turns
    sin_half_turn: f64, // its sine
    stride: f64,        // how far the contact moves on in a wobble, in radii
}

impl Wheel {
    /// The motion from `start`, from half a wobble by a Taylor method whose tolerance, at most 1, is in radii and
    /// √(a/g). Its limit on the number of series holds for the way ahead and for the way back: a wheel that almost
    /// falls flat whirls round the more often the smaller I₁ is, and whirls of more than a hundred thousand series are
    /// given up unless the solver says otherwise.
    ///
    /// # Errors
    /// [`Error::Quantity`] if a number of `start` cannot be computed with, the tolerance is too loose, or the lean does
    /// not swing (a steady motion, one whose lean does not turn within ten thousand √(a/g), or one that falls flat to
    /// about 1e-16); [`Error::Integration`], with time and state in units of √(a/g), if the solver fails.
    pub fn wobble(&self, start: Rolling, solver: &Taylor) -> Result<Wobble, Error> {
        solver.check_at_most(LOOSEST_TOLERANCE)?;
        start.check()?;
        let (series, state, placed) = Placed::new(&self.disk, &start);
        let rule = Rule::Because("the lean does not swing, and a steady motion has no wobble to repeat");
        let steady =
            InvalidQuantity { quantity: "angular velocity ω₁", value: start.omega_1, unit: "rad/s", rule };
        let swing = |direction: f64| -> Result<Swing, Error> {
            Ok(Swing::new(solver, series, state, direction)?.ok_or(steady)?)
        };
        let ahead = swing(1.0)?;
        let back = if state[1] == 0.0 { None } else { Some(swing(-1.0)?) };
        let opening = back.as_ref().map_or(0.0, Swing::duration);
        let at_start = Moment { state, contact: Complex::new(0.0, 0.0), facing: Complex::new(1.0, 0.0) };
        let turned = back.as_ref().map_or(at_start, Swing::end);
        let turns = ahead.end();

        // Whole turns make no difference.
        let half_advance = turns.state[4] - turned.state[4];
        let half_turn = half_advance - PI * (half_advance / PI).round();
        let (sin, cos) = half_turn.sin_cos();
        let way = (turns.contact - turned.contact) * turned.facing.conj();
        Ok(Wobble {
            placed,
            heading_advance: 2.0 * half_advance,
            roll_advance: 2.0 * (turns.state[5] - turned.state[5]),
            half_turn,
            sin_half_turn: sin,
            stride: 2.0 * (way.re * cos + way.im * sin),
            turned: (opening, turned),
            turns: (ahead.duration(), turns),
            back,
            ahead,
        })
    }
}

impl Wobble {
    /// The time of one wobble, s.
    #[must_use]
    pub fn period(&self) -> f64 {
        2.0 * (self.turns.0 - self.turned.0) * self.placed.unit_of_time()
    }

    /// How far the heading goes on in one wobble, rad.
    #[must_use]
    pub fn heading_advance(&self) -> f64 {
        self.heading_advance
    }

    /// How far the wheel turns about its axle in one wobble, relative to its frame, rad.
    #[must_use]
    pub fn roll_advance(&self) -> f64 {
        self.roll_advance
    }

    /// The state at `time`, s, of either sign. At zero it is the start, to rounding.
    ///
    /// Within a few wobbles an error is at most what a change of the start and of the time by a part 30 ε makes, and of
    /// the state anywhere on the way by 3 ε; and 30 ε of the numbers themselves and of one in the units a, √(g/a) and
    /// rad, where ε is the tolerance or 2.2e-16, whichever is larger. The place has in addition 30 ε radii for each
    /// radian by which the heading has gone on. With a looser tolerance than rounding a number of a state that is
    /// smaller than one changes by such a part of those units. Later errors grow in proportion to the time. What a
    /// change makes may be large: a wheel that comes near an unstable motion on its way leaves it as its last digits
    /// say. Of heading and roll angle the larger counts for both: near flat they whirl round together, and one that has
    /// whirled round and back has the rounding of all that way.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the time is not finite, or so far away that it cannot be said where in a wobble it falls.
    pub fn at(&self, time: f64) -> Result<Rolling, InvalidQuantity> {
        InvalidQuantity::require_finite("time", time, "s")?;
        let (turned, turns) = (&self.turned, &self.turns);
        let (now, period) = (time / self.placed.unit_of_time(), 2.0 * (turns.0 - turned.0));
        // Whole wobbles, each from turn to turn of the lean, so that what one adds is not taken off again.
        let count = if now < 0.0 {
            ((now - turns.0) / period).ceil() + 0.0 // and not −0
        } else {
            ((now - turned.0) / period).floor()
        };
        let rule = Rule::AtMost(MOST_WOBBLES * self.period());
        InvalidQuantity::require(count.abs() <= MOST_WOBBLES, "size of the time", time.abs(), "s", rule)?;
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

        // As many wobbles turn the frame and move it on.
        let (sin, cos) = TwoPart::product(count, self.half_turn).sin_cos();
        let half_turned = Complex::new(cos, sin);
        // 1 + e^{iα} + … of so many terms is e^{i(N−1)α/2} times this.
        let ratio = if self.sin_half_turn == 0.0 { count } else { sin / self.sin_half_turn };
        // From where the lean turned; and 1 − e^{iNα} times the way there.
        let stride = turned.1.facing * (self.stride * ratio);
        let moved = half_turned * (stride - turned.1.contact * Complex::new(0.0, 2.0 * sin));
        let turn = half_turned * half_turned;
        let mut state = moment.state;
        state[4] += count * self.heading_advance;
        state[5] += count * self.roll_advance;
        Ok(self.placed.in_room(&state, moved + turn * moment.contact, turn * moment.facing))
    }

    /// The states at `times`, s, in any order and of either sign.
    ///
    /// # Errors
    /// As [`Wobble::at`].
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Rolling>, InvalidQuantity> {
        times.iter().map(|&time| self.at(time)).collect()
    }

    /// The motion from a turn of the lean to the next, by the time from the start, in √(a/g).
    fn between_turns(&self, time: f64) -> Moment {
        match &self.back {
            Some(back) if time < 0.0 => back.at(time),
            _ => self.ahead.at(time),
        }
    }
}

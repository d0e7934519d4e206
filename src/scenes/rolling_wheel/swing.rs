//! From a start to the turning point of the lean before or after it.

use crate::integrate::{Failure, Series, Taylor, TaylorStep, increment};
use crate::rolling::{RollingSeries, anchor, contact};
use nalgebra::Complex;
use std::ops::ControlFlow;

/// How long, in units of √(a/g), a turning point of the lean is waited for.
const PATIENCE: f64 = 1e4;
/// The longest step, in that unit. A wheel that hardly leans falls like e^t at most, and the series of that has then
/// converged to rounding of itself, however small it is beside the tolerance.
const LONGEST_STEP: f64 = 0.75;
/// At how many moments of a step it is looked for.
const LOOKS: u32 = 8;
/// Newton's method has found it, or never will.
const MOST_CORRECTIONS: u32 = 100;

/// The motion from its start to the next moment at which the lean turns, or back to the last, in units of the series.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Swing {
    pieces: Vec<Piece>,
    last: f64, // how long the last piece is followed
}

/// One step of it.
#[derive(Debug, Clone, PartialEq)]
struct Piece {
    start: (f64, f64), // in two parts: near flat a step may be shorter than the rounding of the time
    length: f64,
    series: Series<8>,
    anchor: Complex<f64>,
}

/// The state at a moment, with the contact's way from the start of the swing and e to the i times the heading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moment {
    pub(super) state: [f64; 8],
    pub(super) contact: Complex<f64>,
    pub(super) facing: Complex<f64>,
}

impl Swing {
    /// From a state of heading zero to the next moment at which the lean turns, or back to the last if `direction` is
    /// negative, not counting the start; nothing if there is none.
    pub(super) fn new(
        solver: &Taylor,
        wheel: RollingSeries,
        state: [f64; 8],
        direction: f64,
    ) -> Result<Option<Self>, Failure> {
        let mut pieces: Vec<Piece> = Vec::new();
        let (mut here, mut facing) = (Complex::new(0.0, 0.0), Complex::new(1.0, 0.0));
        let mut turning = None;
        let observer = |step: &TaylorStep<'_, 8>| {
            let series = *step.series();
            let piece = Piece {
                start: step.start_in_two(),
                length: step.length(),
                series,
                anchor: anchor(&series, here, facing),
            };
            let mut rates = series.map(|row| row[1]); // u, which is zero where the lean turns
            let at_rest = pieces.is_empty() && rates[0] == 0.0;
            if direction < 0.0 {
                rates.iter_mut().skip(1).step_by(2).for_each(|odd| *odd = -*odd);
            }
            // A swing that starts at a turning point waits for the other zero.
            let rates = if at_rest { &rates[1..] } else { &rates[..] };
            turning = zero(rates, step.length().abs());
            (here, facing) = contact(piece.anchor, &step.last());
            pieces.push(piece);
            let stays = at_rest && rates[0] == 0.0;
            if turning.is_some() || stays { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        solver.with_step_at_most(LONGEST_STEP).solve_with(
            &wheel,
            0.0,
            state,
            PATIENCE.copysign(direction),
            observer,
        )?;
        Ok(turning.map(|last| Self { pieces, last: last.copysign(direction) }))
    }

    /// How long it takes, negative backwards.
    pub(super) fn duration(&self) -> f64 {
        self.pieces.last().map_or(0.0, |Piece { start: (high, low), .. }| high + (low + self.last))
    }

    /// The end of it. (A wheel that turns back almost flat whirls round so fast that a rounded time would not do.)
    pub(super) fn end(&self) -> Moment {
        self.pieces[self.pieces.len() - 1].after(self.last)
    }

    /// The motion at a time from the start, 0, to the duration.
    pub(super) fn at(&self, time: f64) -> Moment {
        let reached = |piece: &Piece| piece.start.0.abs() <= time.abs();
        let place = self.pieces.partition_point(reached).saturating_sub(1);
        let piece = &self.pieces[place];
        let since = (time - piece.start.0) - piece.start.1;
        // A series says nothing beyond its step, where a rounded time may lie.
        piece.after(if since.abs() > piece.length.abs() { piece.length } else { since })
    }
}

impl Moment {
    /// Another moment as in a mirror, with this one, at which the lean turns, between the two.
    pub(super) fn mirror(&self, Moment { state, contact, facing }: Moment) -> Moment {
        let [y, u, turn, n, heading, roll, re, im] = state;
        let double = self.facing * self.facing;
        Moment {
            state: [y, -u, turn, n, 2.0 * self.state[4] - heading, 2.0 * self.state[5] - roll, re, im],
            contact: self.contact - double * (contact - self.contact).conj(),
            facing: double * facing.conj(),
        }
    }
}

impl Piece {
    fn after(&self, since: f64) -> Moment {
        let gained = increment(&self.series, since);
        let state: [f64; 8] = std::array::from_fn(|i| self.series[0][i] + gained[i]);
        let (contact, facing) = contact(self.anchor, &state);
        Moment { state, contact, facing }
    }
}

/// The first zero, up to `length`, of the polynomial with these coefficients, the constant first and not zero.
fn zero(coefficients: &[f64], length: f64) -> Option<f64> {
    let value_and_slope = |x: f64| {
        coefficients
            .iter()
            .rev()
            .fold((0.0, 0.0), |(value, slope), coefficient| (value * x + coefficient, slope * x + value))
    };
    let sign = coefficients[0] > 0.0;
    let before = |value: f64| (value > 0.0) == sign;
    let mut looks = (1..=LOOKS).map(|look| length * f64::from(look) / f64::from(LOOKS));
    let mut high = looks.find(|&x| !before(value_and_slope(x).0))?;
    let mut low = high - length / f64::from(LOOKS);
    let mut x = 0.5 * (low + high);
    for _ in 0..MOST_CORRECTIONS {
        let (value, slope) = value_and_slope(x);
        if before(value) {
            low = x;
        } else {
            high = x;
        }
        let correction = value / slope;
        if correction.abs() <= f64::EPSILON * x {
            break;
        }
        let next = x - correction;
        x = if next > low && next < high { next } else { 0.5 * (low + high) };
    }
    Some(x)
}

//! The moment at which a function of the state passes zero.

use super::failure::is_finite;
use super::{Dop853, End, Failure, Rates, Step};
use std::ops::ControlFlow;

/// Bisection alone would need about 60 looks at the event for the last bit; interpolation rarely needs ten.
const MOST_LOOKS: usize = 200;

/// Which passages through zero count, in the direction of the integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// Both.
    Either,
}

/// How an integration that waited for an event ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outcome<const N: usize> {
    /// The event took place; time and state are those of the event.
    Event(End<N>),
    /// The end of the interval came first.
    NoEvent(End<N>),
}

impl Direction {
    fn counts(self, before: f64, after: f64) -> bool {
        let rising = before < 0.0 && after >= 0.0;
        let falling = before > 0.0 && after <= 0.0;
        match self {
            Self::Rising => rising,
            Self::Falling => falling,
            Self::Either => rising || falling,
        }
    }
}

impl Dop853 {
    /// Integrates until `event(time, state)` passes zero in the given direction, or until `end`.
    ///
    /// The moment is found on the dense output to a few units in the last place of the time, so its error is
    /// that of the integration. Passages are seen as changes of sign over a step: two within one step go
    /// unnoticed, for which [`Dop853::with_max_step`] is the cure. A zero exactly at the start is not an
    /// event.
    ///
    /// # Errors
    /// As [`Dop853::solve`], also if the state at a moment that is looked at is not finite; and
    /// [`Failure::EventNotANumber`] if the event function is NaN.
    ///
    /// ```
    /// use mechanics::integrate::{Direction, Dop853, Outcome};
    /// // A stone dropped from 5 m at g = 10 m/s² lands after one second.
    /// let fall = |_t: f64, &[_height, speed]: &[f64; 2]| [speed, -10.0];
    /// let outcome = Dop853::new(1e-12)?.solve_until(
    ///     fall, 0.0, [5.0, 0.0], 9.0, |_t, &[height, _]| height, Direction::Falling)?;
    /// let Outcome::Event(landing) = outcome else { panic!("it never lands") };
    /// assert!((landing.time - 1.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn solve_until<const N: usize>(
        &self,
        rates: impl Rates<N>,
        start: f64,
        state: [f64; N],
        end: f64,
        mut event: impl FnMut(f64, &[f64; N]) -> f64,
        direction: Direction,
    ) -> Result<Outcome<N>, Failure> {
        let mut found = None;
        let mut fault = None;
        let mut before = event(start, &state);
        if before.is_nan() {
            return Err(Failure::EventNotANumber { time: start, state: state.to_vec() });
        }
        let last = self.solve_with(rates, start, state, end, |step| {
            let after = event(step.end(), step.final_state());
            if after.is_nan() {
                fault = Some(not_a_number(step));
                return ControlFlow::Break(());
            }
            if direction.counts(before, after) {
                match locate(step, &mut event, before, after) {
                    Ok(event) => found = Some(event),
                    Err(failure) => fault = Some(failure),
                }
                return ControlFlow::Break(());
            }
            before = after;
            ControlFlow::Continue(())
        })?;
        if let Some(failure) = fault {
            return Err(failure);
        }
        Ok(match found {
            Some((time, state)) => Outcome::Event(End { time, state, ..last }),
            None => Outcome::NoEvent(last),
        })
    }
}

/// The zero within a step, by Chandrupatla's method (*Advances in Engineering Software* 28 (1997) 145):
/// inverse quadratic interpolation where three points show that it can be trusted, else bisection; always
/// bracketed. Fails if the state or the event is not a number on the way.
fn locate<const N: usize, F: Rates<N>>(
    step: &mut Step<'_, N, F>,
    event: &mut impl FnMut(f64, &[f64; N]) -> f64,
    before: f64,
    after: f64,
) -> Result<(f64, [f64; N]), Failure> {
    // The newest point, the one across the zero from it, and the one that was given up last.
    let (mut new, mut f_new) = (step.end(), after);
    let (mut across, mut f_across) = (step.start(), before);
    let mut part = 0.5_f64;
    for _ in 0..MOST_LOOKS {
        let resolution = 2.0 * f64::EPSILON * new.abs().max(across.abs()) / (across - new).abs();
        if f_new == 0.0 || resolution > 0.5 {
            break;
        }
        let next = new + part.clamp(resolution, 1.0 - resolution) * (across - new);
        let state = step.at(next);
        if !is_finite(&state) {
            return Err(step.not_finite());
        }
        let f_next = event(next, &state);
        if f_next.is_nan() {
            return Err(not_a_number(step));
        }
        let (given_up, f_given_up) = if (f_next > 0.0) == (f_new > 0.0) {
            (new, f_new)
        } else {
            let old = (across, f_across);
            (across, f_across) = (new, f_new);
            old
        };
        (new, f_new) = (next, f_next);
        let xi = (new - across) / (given_up - across);
        let phi = (f_new - f_across) / (f_given_up - f_across);
        part = if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
            f_new / (f_across - f_new) * (f_given_up / (f_across - f_given_up))
                + (given_up - new) / (across - new)
                    * (f_new / (f_given_up - f_new))
                    * (f_across / (f_given_up - f_across))
        } else {
            0.5
        };
    }
    let time = if f_new.abs() <= f_across.abs() { new } else { across };
    // The ends are known without looking between them, where it has been looked already.
    let state = match time {
        end if end == step.end() => *step.final_state(),
        start if start == step.start() => *step.initial_state(),
        between => step.at(between),
    };
    Ok((time, state))
}

/// What to say where the event is not a number.
fn not_a_number<const N: usize, F: Rates<N>>(step: &Step<'_, N, F>) -> Failure {
    Failure::EventNotANumber { time: step.start(), state: step.initial_state().to_vec() }
}

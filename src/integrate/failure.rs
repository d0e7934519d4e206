//! Why an integration could not be carried out, with the time and the state at which it stopped.

use crate::quantity::Shown;
use std::{error::Error, fmt};

/// An integration that did not reach its end.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Failure {
    /// The start or the end of the interval is not a finite number.
    Interval {
        /// Where the integration was to start.
        start: f64,
        /// Where it was to end.
        end: f64,
    },
    /// The state at the start holds an infinity or NaN.
    InitialState {
        /// The state as it was given.
        state: Vec<f64>,
    },
    /// A fixed-step method was asked to take no step at all.
    NoSteps,
    /// A sample time lies outside the interval or before its predecessor.
    SampleTime {
        /// Its place in the list of times.
        index: usize,
        /// The time itself.
        time: f64,
    },
    /// The rates, or the state they lead to, ceased to be finite.
    NotFinite {
        /// The last time that was reached.
        time: f64,
        /// The state there.
        state: Vec<f64>,
        /// The step that was tried from there.
        step: f64,
    },
    /// The function whose zero is sought is not a number within a step.
    EventNotANumber {
        /// The last time that was reached.
        time: f64,
        /// The state there.
        state: Vec<f64>,
    },
    /// The tolerance asks for a step below the spacing of floating-point numbers.
    StepUnderflow {
        /// The last time that was reached.
        time: f64,
        /// The state there.
        state: Vec<f64>,
        /// The step that would have been needed.
        step: f64,
    },
    /// The allowed number of evaluations, or of series, is used up.
    TooMuchWork {
        /// The last time that was reached.
        time: f64,
        /// The state there.
        state: Vec<f64>,
        /// The evaluations, or series, that were made.
        evaluations: usize,
        /// What was counted: evaluations or series.
        counted: &'static str,
    },
}

/// Whether all numbers of a state are finite. As a slice, whose length no compiler knows, the state cost RK4 an eighth of
/// its time where the rates are cheap.
pub(super) fn is_finite<const N: usize>(state: &[f64; N]) -> bool {
    state.iter().all(|value| value.is_finite())
}

impl Failure {
    /// Refuses an interval or a state at its start that is not finite.
    pub(crate) fn check<const N: usize>(start: f64, state: &[f64; N], end: f64) -> Result<(), Self> {
        if !(start.is_finite() && end.is_finite()) {
            return Err(Self::Interval { start, end });
        }
        if is_finite(state) { Ok(()) } else { Err(Self::InitialState { state: state.to_vec() }) }
    }

    /// The same after so many evaluations that were made before.
    pub(crate) fn after(mut self, before: usize) -> Self {
        if let Self::TooMuchWork { evaluations, .. } = &mut self {
            *evaluations += before;
        }
        self
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Interval { start, end } => {
                write!(out, "the interval from {} to {} must have finite ends", Shown(*start), Shown(*end))
            }
            Self::InitialState { state } => {
                write!(out, "the initial state {state:?} must be finite")
            }
            Self::NoSteps => write!(out, "0 steps: a fixed-step method needs at least one"),
            Self::SampleTime { index, time } => write!(
                out,
                "sample time {} (number {index}) must lie in the interval and not before its predecessor",
                Shown(*time)
            ),
            Self::NotFinite { time, state, step } => write!(
                out,
                "the rates are not finite {} time {}, state {state:?}",
                if step.is_nan() { "at".into() } else { format!("within a step of {} from", Shown(*step)) },
                Shown(*time)
            ),
            Self::EventNotANumber { time, state } => {
                let time = Shown(*time);
                write!(out, "the event is not a number within the step from time {time}, state {state:?}")
            }
            Self::StepUnderflow { time, state, step } => write!(
                out,
                "at time {}, state {state:?} the tolerance asks for a step of {}, too small to change the time",
                Shown(*time),
                Shown(*step)
            ),
            Self::TooMuchWork { time, state, evaluations, counted } => write!(
                out,
                "the limit of {counted} was reached after {evaluations} of them at time {}, state {state:?}",
                Shown(*time)
            ),
        }
    }
}

impl Error for Failure {}

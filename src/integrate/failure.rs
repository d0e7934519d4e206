//! Why an integration could not be carried out, with the time and the state at which it stopped.

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
    /// The allowed number of evaluations is used up.
    TooMuchWork {
        /// The last time that was reached.
        time: f64,
        /// The state there.
        state: Vec<f64>,
        /// The evaluations that were made.
        evaluations: usize,
    },
}

impl fmt::Display for Failure {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Interval { start, end } => {
                write!(out, "the interval from {start} to {end} must have finite ends")
            }
            Self::InitialState { state } => {
                write!(out, "the initial state {state:?} must be finite")
            }
            Self::NoSteps => write!(out, "0 steps: a fixed-step method needs at least one"),
            Self::SampleTime { index, time } => write!(
                out,
                "sample time {time} (number {index}) must lie in the interval and not before its predecessor"
            ),
            Self::NotFinite { time, state, step } => write!(
                out,
                "the rates are not finite within a step of {step} from time {time}, state {state:?}"
            ),
            Self::EventNotANumber { time, state } => {
                write!(out, "the event is not a number within the step from time {time}, state {state:?}")
            }
            Self::StepUnderflow { time, state, step } => write!(
                out,
                "at time {time}, state {state:?} the tolerance asks for a step of {step}, too small to change the time"
            ),
            Self::TooMuchWork { time, state, evaluations } => write!(
                out,
                "the limit of evaluations was reached after {evaluations} of them at time {time}, state {state:?}"
            ),
        }
    }
}

impl Error for Failure {}

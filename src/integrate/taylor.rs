//! A Taylor method of order sixteen: each step is a power series, whose coefficients the system itself supplies.

use super::failure::is_finite;
use super::{End, Failure, Work};
use crate::quantity::{InvalidQuantity, Rule};
use std::ops::ControlFlow;

/// The order of the series.
pub const TAYLOR_ORDER: usize = 16;

/// Coefficients of the series, the state first: entry `j` belongs to the power `j` of the time since the step's start.
pub type Series<const N: usize> = [[f64; N]; TAYLOR_ORDER + 1];

/// Relative tolerances below this ask for more than `f64` can give.
const SMALLEST_TOLERANCE: f64 = 1e-17;
/// How many series are allowed unless the caller says otherwise.
const DEFAULT_EXPANSIONS: usize = 100_000;

/// A system that knows its own Taylor series.
///
/// Products, quotients and functions of series have coefficients that follow from earlier ones by short
/// recurrences, so that all derivatives together cost about as much as a few hundred evaluations of the rates
/// (R. E. Moore, *Interval Analysis* (1966); À. Jorba & M. Zou, *Experimental Mathematics* **14** (2005)
/// 99–117).
pub trait Expand<const N: usize> {
    /// Fills rows 1 to [`TAYLOR_ORDER`] of `series` from the state in row 0.
    ///
    /// Numbers that count from the step's start, like a place in a frame of the step's own, may be set anew in row 0.
    fn expand(&self, series: &mut Series<N>);
}

/// The Taylor method of order sixteen for an autonomous system, with a step from the size of the last two coefficients.
///
/// The tolerance is the size that the last terms of the series may have at the end of a step, in the unit of
/// the state: scale a system so that its variables are about one. No step is ever rejected, the series itself
/// is the dense output, and the state is summed in two parts, so that thousands of steps do not add up their
/// rounding.
///
/// ```
/// use mechanics::integrate::{Expand, Series, TAYLOR_ORDER, Taylor};
/// // ẋ = v, v̇ = −x.
/// struct Swing;
/// impl Expand<2> for Swing {
///     fn expand(&self, series: &mut Series<2>) {
///         for j in 0..TAYLOR_ORDER {
///             let [x, v] = series[j];
///             series[j + 1] = [v, -x].map(|rate| rate / (j + 1) as f64);
///         }
///     }
/// }
/// let end = Taylor::new(1e-16)?.solve(&Swing, 0.0, [0.0, 1.0], 1000.0)?;
/// assert!((end.state[0] - 1000_f64.sin()).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taylor {
    tolerance: f64,
    max_step: f64,
    max_expansions: usize,
}

/// One step: the series that runs through it.
#[derive(Debug, Clone, Copy)]
pub struct TaylorStep<'a, const N: usize> {
    start: f64,
    start_rest: f64,
    end: f64,
    length: f64,
    series: &'a Series<N>,
    increment: [f64; N],
}

impl Taylor {
    /// With this size of the last terms, in the unit of the state.
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless it is finite and at least 1e-17.
    pub fn new(tolerance: f64) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check_tolerance("tolerance", tolerance, SMALLEST_TOLERANCE)?;
        Ok(Self { tolerance, max_step: f64::INFINITY, max_expansions: DEFAULT_EXPANSIONS })
    }

    /// The same with no step longer than `length`, unless it has a shorter limit already.
    pub(crate) fn with_step_at_most(self, length: f64) -> Self {
        Self { max_step: self.max_step.min(length), ..self }
    }

    /// Refuses a tolerance above the size of what is computed.
    pub(crate) fn check_at_most(&self, size: f64) -> Result<(), InvalidQuantity> {
        let holds = self.tolerance <= size;
        InvalidQuantity::require(holds, "tolerance", self.tolerance, "", Rule::AtMost(size)).map(drop)
    }

    /// The same with no step longer than `length`, whose sign is ignored; infinite for no limit.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a length that is zero or NaN.
    pub fn with_max_step(self, length: f64) -> Result<Self, InvalidQuantity> {
        Ok(Self { max_step: InvalidQuantity::check_step("longest step", length)?, ..self })
    }

    /// The same with a limit on the number of series (a hundred thousand unless set).
    #[must_use]
    pub fn with_max_expansions(self, max_expansions: usize) -> Self {
        Self { max_expansions, ..self }
    }

    /// The state at time `end`, from `state` at time `start`; `end` may be the earlier of the two.
    ///
    /// # Errors
    /// [`Failure`], with the time and the state that were reached.
    pub fn solve<const N: usize>(
        &self,
        system: &impl Expand<N>,
        start: f64,
        state: [f64; N],
        end: f64,
    ) -> Result<End<N>, Failure> {
        self.solve_with(system, start, state, end, |_| ControlFlow::Continue(()))
    }

    /// Like [`Taylor::solve`], showing every step to `observer`, which may stop the integration there.
    ///
    /// # Errors
    /// As [`Taylor::solve`].
    pub fn solve_with<const N: usize>(
        &self,
        system: &impl Expand<N>,
        start: f64,
        state: [f64; N],
        end: f64,
        mut observer: impl FnMut(&TaylorStep<'_, N>) -> ControlFlow<()>,
    ) -> Result<End<N>, Failure> {
        Failure::check(start, &state, end)?;
        let direction = (end - start).signum();
        let mut series = [[0.0; N]; TAYLOR_ORDER + 1];
        let (mut time, mut time_rest) = (start, 0.0);
        let mut rest = [0.0; N];
        let mut work = Work::default();
        series[0] = state;
        while time != end {
            if work.evaluations >= self.max_expansions {
                return Err(Failure::TooMuchWork {
                    time,
                    state: series[0].to_vec(),
                    evaluations: work.evaluations,
                    counted: "series",
                });
            }
            system.expand(&mut series);
            work.evaluations += 1;
            let length = direction * self.length(&series);
            if length.is_nan() {
                return Err(Failure::NotFinite { time, state: series[0].to_vec(), step: length });
            }
            let left = (end - time) - time_rest;
            let last = length.abs() >= left.abs();
            let length = if last { left } else { length };
            let (next, next_rest) = if last { (end, 0.0) } else { add(time, time_rest, length) };
            if (next, next_rest) == (time, time_rest) {
                return Err(Failure::StepUnderflow { time, state: series[0].to_vec(), step: length });
            }
            work.accepted += 1;
            let increment = increment(&series, length);
            let step = TaylorStep {
                start: time,
                start_rest: time_rest,
                end: next,
                length,
                series: &series,
                increment,
            };
            let flow = observer(&step);
            let mut state = series[0];
            for i in 0..N {
                (state[i], rest[i]) = add(state[i], rest[i], increment[i]);
            }
            if !is_finite(&state) {
                return Err(Failure::NotFinite { time, state: series[0].to_vec(), step: length });
            }
            series[0] = state;
            (time, time_rest) = (next, next_rest);
            if flow.is_break() {
                break;
            }
        }
        Ok(End { time, state: series[0], work })
    }

    /// The length at which the last two terms have the size of the tolerance.
    fn length<const N: usize>(&self, series: &Series<N>) -> f64 {
        let size = |row: &[f64; N]| {
            row.iter()
                .fold(0.0_f64, |largest, x| if x.abs() > largest || x.is_nan() { x.abs() } else { largest })
        };
        let last = size(&series[TAYLOR_ORDER]) / self.tolerance;
        let before = size(&series[TAYLOR_ORDER - 1]) / self.tolerance;
        if last.is_nan() || before.is_nan() {
            return f64::NAN;
        }
        let shorter = (last.log2() / TAYLOR_ORDER as f64).max(before.log2() / (TAYLOR_ORDER - 1) as f64);
        (-shorter).exp2().min(self.max_step)
    }
}

/// A sum of three numbers in two parts, of which the last two are small beside the first.
#[inline(always)]
fn add(high: f64, low: f64, increment: f64) -> (f64, f64) {
    let addend = low + increment;
    let sum = high + addend;
    (sum, addend - (sum - high))
}

impl<const N: usize> TaylorStep<'_, N> {
    /// The time at which the step starts.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start
    }

    /// The time at which it ends.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The time from the step's start to `time`. More exact than their difference: the start is kept in two parts.
    #[must_use]
    pub fn since(&self, time: f64) -> f64 {
        (time - self.start) - self.start_rest
    }

    /// The start in its two parts.
    pub(crate) fn start_in_two(&self) -> (f64, f64) {
        (self.start, self.start_rest)
    }

    /// How long it is, negative backwards.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The coefficients.
    #[must_use]
    pub fn series(&self) -> &Series<N> {
        self.series
    }

    /// The state at a time from the step's start to its end.
    #[must_use]
    pub fn at(&self, time: f64) -> [f64; N] {
        let increment = increment(self.series, self.since(time));
        std::array::from_fn(|i| self.series[0][i] + increment[i])
    }

    /// The state at its end.
    #[must_use]
    pub fn last(&self) -> [f64; N] {
        std::array::from_fn(|i| self.series[0][i] + self.increment[i])
    }
}

/// What the state has gained after `since` from the start of the series. The odd and the even powers are summed side by
/// side: one sum of all would wait for each of its terms.
#[inline]
pub(crate) fn increment<const N: usize>(series: &Series<N>, since: f64) -> [f64; N] {
    let square = since * since;
    let (mut odd, mut even) = ([0.0; N], [0.0; N]);
    for pair in series[1..].chunks_exact(2).rev() {
        for i in 0..N {
            odd[i] = odd[i] * square + pair[0][i];
            even[i] = even[i] * square + pair[1][i];
        }
    }
    std::array::from_fn(|i| (even[i] * since + odd[i]) * since)
}

//! DOP853: the explicit Runge–Kutta method of order eight of Dormand and Prince with step control.

use super::failure::is_finite;
use super::step::{Step, advance};
use super::tableau::{A, B, C};
use super::{Failure, Rates};
use crate::quantity::{InvalidQuantity, Rule};
use std::ops::ControlFlow;

/// Relative tolerances below this ask for more than `f64` can give.
const SMALLEST_TOLERANCE: f64 = 1e-15;
/// Step control (Hairer, Nørsett & Wanner 1993, code DOP853): safety factor, and how far a step may shrink or grow.
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 0.333;
const GROW: f64 = 6.0;
/// How many evaluations are allowed unless the caller says otherwise.
const DEFAULT_EVALUATIONS: usize = 10_000_000;

/// An adaptive integrator of order eight with dense output of order seven and event location.
///
/// The tolerance bounds the estimated error of each step, per component, by `absolute + relative·|y|` in the
/// root mean square. It is not a bound on the error at the end, which is usually within a few orders of
/// magnitude of it and shrinks in proportion, down to a floor set by rounding: that of the state, and where
/// the rates depend on the time that of the time, magnified some ten times by the large weights of the
/// method.
///
/// From Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, 2nd ed. (1993), sections II.5 and II.10.
/// The default step control is that of their program, without its test for stiffness.
///
/// ```
/// use mechanics::integrate::Dop853;
/// // A pendulum let go at 2 rad comes back after its period, 4 K(sin² 1) = 8.349 843 131...
/// let pendulum = |_t: f64, &[angle, rate]: &[f64; 2]| [rate, -angle.sin()];
/// let end = Dop853::new(1e-12)?.solve(pendulum, 0.0, [2.0, 0.0], 8.349_843_131)?;
/// assert!((end.state[0] - 2.0).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dop853 {
    pub(super) relative: f64,
    pub(super) absolute: f64,
    first_step: Option<f64>,
    pub(super) max_step: f64,
    max_evaluations: usize,
}

/// How much an integration has cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Work {
    /// Evaluations of the rates, those for dense output included.
    pub evaluations: usize,
    /// Steps taken.
    pub accepted: usize,
    /// Steps tried and given up because their error was too large.
    pub rejected: usize,
}

/// Where an integration ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct End<const N: usize> {
    /// The time.
    pub time: f64,
    /// The state at that time.
    pub state: [f64; N],
    /// What it cost to get there.
    pub work: Work,
}

impl Dop853 {
    /// An integrator with `tolerance` as both relative and absolute tolerance.
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless the tolerance is finite and at least 1e-15.
    pub fn new(tolerance: f64) -> Result<Self, InvalidQuantity> {
        Self::with_tolerances(tolerance, tolerance)
    }

    /// An integrator with separate tolerances; the absolute one has the unit of the state and may be zero.
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless the relative tolerance is finite and at least 1e-15, and the absolute one
    /// finite and not negative.
    pub fn with_tolerances(relative: f64, absolute: f64) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check_tolerance("relative tolerance", relative, SMALLEST_TOLERANCE)?;
        InvalidQuantity::require_finite("absolute tolerance", absolute, "")?;
        InvalidQuantity::require(absolute >= 0.0, "absolute tolerance", absolute, "", Rule::NotNegative)?;
        Ok(Self {
            relative,
            absolute,
            first_step: None,
            max_step: f64::INFINITY,
            max_evaluations: DEFAULT_EVALUATIONS,
        })
    }

    /// The same with a given length of the first step instead of an estimated one; its sign is ignored.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a length that is zero or not finite.
    pub fn with_first_step(self, length: f64) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::require_finite("first step", length, "")?;
        let first_step = Some(InvalidQuantity::check_step("first step", length)?);
        Ok(Self { first_step, ..self })
    }

    /// The same with no step longer than `length`, whose sign is ignored; infinite for no limit.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a length that is zero or NaN.
    pub fn with_max_step(self, length: f64) -> Result<Self, InvalidQuantity> {
        Ok(Self { max_step: InvalidQuantity::check_step("longest step", length)?, ..self })
    }

    /// The same with a limit on the evaluations of the rates (ten million unless set).
    #[must_use]
    pub fn with_max_evaluations(self, max_evaluations: usize) -> Self {
        Self { max_evaluations, ..self }
    }

    /// The limit on the evaluations of the rates.
    pub(crate) fn max_evaluations(&self) -> usize {
        self.max_evaluations
    }

    /// The state at time `end`, from `state` at time `start`; `end` may be the earlier of the two.
    ///
    /// # Errors
    /// [`Failure`], with the time and the state that were reached.
    pub fn solve<const N: usize>(
        &self,
        rates: impl Rates<N>,
        start: f64,
        state: [f64; N],
        end: f64,
    ) -> Result<End<N>, Failure> {
        self.solve_with(rates, start, state, end, |_| ControlFlow::Continue(()))
    }

    /// The states at `times`, which must run from `start` in one direction; the integration ends at the last of them.
    ///
    /// # Errors
    /// [`Failure::SampleTime`] for times out of order; otherwise as [`Dop853::solve`].
    pub fn sample<const N: usize>(
        &self,
        rates: impl Rates<N>,
        start: f64,
        state: [f64; N],
        times: &[f64],
    ) -> Result<(Vec<[f64; N]>, Work), Failure> {
        let end = times.last().copied().unwrap_or(start);
        let mut before = start;
        for (index, &time) in times.iter().enumerate() {
            if !time.is_finite()
                || (time != before && (time > before) != (end > start))
                || (end == start && time != start)
            {
                return Err(Failure::SampleTime { index, time });
            }
            before = time;
        }
        let mut states = Vec::with_capacity(times.len());
        while states.len() < times.len() && times[states.len()] == start {
            states.push(state);
        }
        let mut fault = None;
        let last = self.solve_with(rates, start, state, end, |step| {
            let forward = step.length > 0.0;
            while let Some(&time) = times.get(states.len()) {
                if if forward { time > step.end() } else { time < step.end() } {
                    break;
                }
                let exact = time == step.end();
                let state = if exact { *step.final_state() } else { step.at(time) };
                if !is_finite(&state) {
                    fault = Some(step.not_finite());
                    return ControlFlow::Break(());
                }
                states.push(state);
            }
            ControlFlow::Continue(())
        })?;
        if let Some(fault) = fault {
            return Err(fault);
        }
        debug_assert_eq!(states.len(), times.len(), "the last step ends at the last time");
        Ok((states, last.work))
    }

    /// Like [`Dop853::solve`], showing every accepted step to `observer`, which may stop the integration there.
    ///
    /// # Errors
    /// As [`Dop853::solve`].
    pub fn solve_with<const N: usize, F: Rates<N>>(
        &self,
        mut rates: F,
        start: f64,
        state: [f64; N],
        end: f64,
        mut observer: impl FnMut(&mut Step<'_, N, F>) -> ControlFlow<()>,
    ) -> Result<End<N>, Failure> {
        Failure::check(start, &state, end)?;
        let mut work = Work::default();
        let (mut t, mut y) = (start, state);
        if start == end {
            return Ok(End { time: t, state: y, work });
        }
        let direction = (end - start).signum();
        let mut k = [[0.0; N]; 16];
        k[0] = rates(t, &y);
        work.evaluations += 1;
        if !is_finite(&k[0]) {
            return Err(Failure::NotFinite { time: t, state: y.to_vec(), step: f64::NAN });
        }
        let mut h = match self.first_step {
            Some(length) => length.min(self.max_step) * direction,
            None => {
                work.evaluations += 1;
                self.estimate_first_step(&mut rates, t, &y, &k[0], end)
            }
        };
        let mut just_rejected = false;
        let mut was_finite = true;
        loop {
            if work.evaluations >= self.max_evaluations {
                return Err(Failure::TooMuchWork {
                    time: t,
                    state: y.to_vec(),
                    evaluations: work.evaluations,
                    counted: "evaluations",
                });
            }
            if 0.1 * h.abs() <= t.abs() * f64::EPSILON || h.abs() < f64::MIN_POSITIVE {
                return Err(if was_finite {
                    Failure::StepUnderflow { time: t, state: y.to_vec(), step: h }
                } else {
                    Failure::NotFinite { time: t, state: y.to_vec(), step: h }
                });
            }
            let last = (t + 1.01 * h - end) * direction > 0.0;
            let next = if last { end } else { t + h };
            h = next - t; // the step that the clock really makes: its rounding would add up over many steps
            let new = stages(&mut rates, t, &y, h, &mut k);
            work.evaluations += 11;
            let error = self.error(&y, &new, h, &k);
            was_finite = error.is_finite() && is_finite(&new);
            if !was_finite {
                work.rejected += 1;
                just_rejected = true;
                h *= 0.1;
                continue;
            }
            let wanted = error.powf(1.0 / 8.0) / SAFETY; // one over the factor by which the step should change
            if error > 1.0 {
                work.rejected += 1;
                just_rejected = true;
                h /= wanted.min(1.0 / SHRINK);
                continue;
            }
            k[12] = rates(next, &new);
            work.evaluations += 1;
            work.accepted += 1;
            if !is_finite(&k[12]) {
                return Err(Failure::NotFinite { time: next, state: new.to_vec(), step: h });
            }
            let flow = observer(&mut Step {
                rates: &mut rates,
                work: &mut work,
                start: t,
                end: next,
                length: next - t,
                y0: &y,
                y1: &new,
                k: &mut k,
                dense: None,
            });
            (t, y) = (next, new);
            if last || flow.is_break() {
                return Ok(End { time: t, state: y, work });
            }
            k[0] = k[12];
            let mut longer = h / wanted.clamp(1.0 / GROW, 1.0 / SHRINK);
            if just_rejected {
                longer = direction * longer.abs().min(h.abs());
            }
            h = direction * longer.abs().min(self.max_step);
            just_rejected = false;
        }
    }
}

/// Stages two to twelve, and the state at the end of the step.
#[inline]
fn stages<const N: usize>(
    rates: &mut impl Rates<N>,
    t: f64,
    y: &[f64; N],
    h: f64,
    k: &mut [[f64; N]; 16],
) -> [f64; N] {
    k[1] = rates(t + C[1] * h, &advance!(y, h, A[1], k; 0));
    k[2] = rates(t + C[2] * h, &advance!(y, h, A[2], k; 0, 1));
    k[3] = rates(t + C[3] * h, &advance!(y, h, A[3], k; 0, 2));
    k[4] = rates(t + C[4] * h, &advance!(y, h, A[4], k; 0, 2, 3));
    k[5] = rates(t + C[5] * h, &advance!(y, h, A[5], k; 0, 3, 4));
    k[6] = rates(t + C[6] * h, &advance!(y, h, A[6], k; 0, 3, 4, 5));
    k[7] = rates(t + C[7] * h, &advance!(y, h, A[7], k; 0, 3, 4, 5, 6));
    k[8] = rates(t + C[8] * h, &advance!(y, h, A[8], k; 0, 3, 4, 5, 6, 7));
    k[9] = rates(t + C[9] * h, &advance!(y, h, A[9], k; 0, 3, 4, 5, 6, 7, 8));
    k[10] = rates(t + C[10] * h, &advance!(y, h, A[10], k; 0, 3, 4, 5, 6, 7, 8, 9));
    k[11] = rates(t + C[11] * h, &advance!(y, h, A[11], k; 0, 3, 4, 5, 6, 7, 8, 9, 10));
    advance!(y, h, B, k; 0, 5, 6, 7, 8, 9, 10, 11)
}

//! The classical Runge–Kutta method of order four with a fixed step.

use super::failure::is_finite;
use super::{Failure, Rates};

/// One step of length `h` from `state` at `time`.
///
/// Four evaluations; the error of one step is of order `h^5` (Kutta 1901; Hairer, Nørsett & Wanner 1993, section
/// II.1). Nothing is checked: infinities and NaN pass through.
pub fn rk4_step<const N: usize>(rates: &mut impl Rates<N>, time: f64, state: &[f64; N], h: f64) -> [f64; N] {
    let ahead = |slope: &[f64; N], by: f64| std::array::from_fn(|i| state[i] + by * slope[i]);
    let k1 = rates(time, state);
    let k2 = rates(time + h / 2.0, &ahead(&k1, h / 2.0));
    let k3 = rates(time + h / 2.0, &ahead(&k2, h / 2.0));
    let k4 = rates(time + h, &ahead(&k3, h));
    std::array::from_fn(|i| state[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
}

/// The state at time `end`, by `steps` equal steps from `state` at time `start`.
///
/// The error is of order four in the step. Works in either direction of time.
///
/// # Errors
/// [`Failure::Interval`], [`Failure::InitialState`] or [`Failure::NoSteps`] for bad input;
/// [`Failure::NotFinite`] as soon as a step leads to an infinity or NaN.
///
/// ```
/// // A harmonic oscillator returns after one period, up to the error of the method.
/// let swing = |_t: f64, &[x, v]: &[f64; 2]| [v, -x];
/// let [x, v] = mechanics::integrate::rk4(swing, 0.0, [1.0, 0.0], std::f64::consts::TAU, 100)?;
/// assert!((x - 1.0).abs() < 1e-6 && v.abs() < 1e-6);
/// # Ok::<(), mechanics::integrate::Failure>(())
/// ```
pub fn rk4<const N: usize>(
    mut rates: impl Rates<N>,
    start: f64,
    state: [f64; N],
    end: f64,
    steps: usize,
) -> Result<[f64; N], Failure> {
    Failure::check(start, &state, end)?;
    if steps == 0 {
        return Err(Failure::NoSteps);
    }
    let h = (end - start) / steps as f64;
    let mut now = state;
    for n in 0..steps {
        let time = start + n as f64 * h; // counted, not accumulated
        let next = rk4_step(&mut rates, time, &now, h);
        if !is_finite(&next) {
            return Err(Failure::NotFinite { time, state: now.to_vec(), step: h });
        }
        now = next;
    }
    Ok(now)
}

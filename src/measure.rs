//! What "error", "drift" and "order" mean: one definition for the tests, the benchmarks and the book.

use std::cell::Cell;

/// The largest absolute difference between two lists of states, over all times and components; NaN if any is NaN.
///
/// The unit is that of the state. Lists that are empty or differ in length give NaN: then nothing has been judged.
///
/// ```
/// use mechanics::{integrate::rk4, measure::max_error};
/// // A pendulum of 1 rad/s, let go at 10 cm, after one second in ten steps.
/// let swing = |_: f64, &[x, v]: &[f64; 2]| [v, -x];
/// let computed = [rk4(swing, 0.0, [0.1, 0.0], 1.0, 10)?];
/// let exact = [[0.1 * 1_f64.cos(), -0.1 * 1_f64.sin()]];
/// assert_eq!(format!("{:.0} nm", 1e9 * max_error(&computed, &exact)), "66 nm");
/// # Ok::<(), mechanics::integrate::Failure>(())
/// ```
pub fn max_error<const N: usize>(computed: &[[f64; N]], reference: &[[f64; N]]) -> f64 {
    if computed.len() != reference.len() || computed.is_empty() {
        return f64::NAN;
    }
    let differences =
        computed.iter().zip(reference).flat_map(|(a, b)| a.iter().zip(b)).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, max_or_nan)
}

/// The largest departure of a quantity from its first value, relative to `scale`: how well a constant is kept.
///
/// Returns 0 for an empty list, NaN if any value is NaN, and infinity or NaN for a scale of zero.
///
/// ```
/// use mechanics::{integrate::rk4, measure::drift};
/// // What a hundred steps a turn do to the energy of 1 kg on 1 N/m in ten turns: RK4 loses
/// // not quite a millionth of it.
/// let swing = |_: f64, &[x, v]: &[f64; 2]| [v, -x];
/// let [x, v] = rk4(swing, 0.0, [1.0, 0.0], 20.0 * std::f64::consts::PI, 1000)?;
/// let energies = [0.5, 0.5 * (x * x + v * v)]; // J
/// assert_eq!(format!("{:.1e}", drift(&energies, energies[0])), "8.5e-7");
/// # Ok::<(), mechanics::integrate::Failure>(())
/// ```
pub fn drift(values: &[f64], scale: f64) -> f64 {
    let first = values.first().copied().unwrap_or(0.0);
    values.iter().map(|value| (value - first).abs()).fold(0.0, max_or_nan) / scale
}

fn max_or_nan(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// The order of a method as its errors show it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ObservedOrder {
    /// The slope of log(error) against log(step), fitted by least squares.
    pub slope: f64,
    /// How many points the fit used: those above the plateau of rounding.
    pub points: usize,
}

/// Fits the order of a method to pairs of step and error, leaving out errors at or below `plateau`, where
/// rounding rules, and errors of one or more, where no order shows yet: give errors relative to the size of
/// the solution.
///
/// `None` with fewer than three usable points, or if an error or a step is not a number: that is no evidence.
///
/// ```
/// let steps = [0.1, 0.05, 0.025, 0.0125];
/// let pairs = steps.map(|h: f64| (h, 3.0 * h.powi(4)));
/// let order = mechanics::measure::observed_order(&pairs, 1e-14).unwrap();
/// assert!((order.slope - 4.0).abs() < 1e-12 && order.points == 4);
/// ```
#[must_use]
pub fn observed_order(steps_and_errors: &[(f64, f64)], plateau: f64) -> Option<ObservedOrder> {
    if steps_and_errors.iter().any(|(step, error)| step.is_nan() || error.is_nan()) {
        return None;
    }
    let points: Vec<(f64, f64)> = steps_and_errors
        .iter()
        .filter(|(step, error)| *step > 0.0 && *error > plateau && *error < 1.0)
        .map(|(step, error)| (step.ln(), error.ln()))
        .collect();
    if points.len() < 3 {
        return None;
    }
    let count = points.len() as f64;
    let (mean_x, mean_y) = points.iter().fold((0.0, 0.0), |(x, y), p| (x + p.0 / count, y + p.1 / count));
    let (mut covariance, mut variance) = (0.0, 0.0);
    for (x, y) in &points {
        covariance += (x - mean_x) * (y - mean_y);
        variance += (x - mean_x).powi(2);
    }
    (variance > 0.0).then(|| ObservedOrder { slope: covariance / variance, points: points.len() })
}

/// Counts how often a function of time and state is evaluated.
///
/// ```
/// use mechanics::{integrate::rk4, measure::Counter};
/// let counter = Counter::new();
/// rk4(counter.count(|_t, y: &[f64; 1]| [-y[0]]), 0.0, [1.0], 1.0, 25)?;
/// assert_eq!(counter.evaluations(), 100);
/// # Ok::<(), mechanics::integrate::Failure>(())
/// ```
#[derive(Debug, Default)]
pub struct Counter {
    evaluations: Cell<usize>,
}

impl Counter {
    /// A counter at zero.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The same rates, counted.
    pub fn count<const N: usize>(
        &self,
        mut rates: impl FnMut(f64, &[f64; N]) -> [f64; N],
    ) -> impl FnMut(f64, &[f64; N]) -> [f64; N] {
        move |time, state| {
            self.evaluations.set(self.evaluations.get() + 1);
            rates(time, state)
        }
    }

    /// How many evaluations there have been.
    pub fn evaluations(&self) -> usize {
        self.evaluations.get()
    }
}

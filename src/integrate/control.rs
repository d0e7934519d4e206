//! What DOP853 makes its steps by: the estimate of a step's error, and of a first step.

use super::step::advance;
use super::tableau::{E3, E5};
use super::{Dop853, Rates};

impl Dop853 {
    /// The size that an error in a component of size `y` may have.
    fn scale(&self, y: f64) -> f64 {
        self.absolute + self.relative * y.abs()
    }

    /// The estimated error of a step in units of the tolerance (`eq:error-estimate`); at most one is good.
    pub(super) fn error<const N: usize>(
        &self,
        y: &[f64; N],
        new: &[f64; N],
        h: f64,
        k: &[[f64; N]; 16],
    ) -> f64 {
        let zero = &[0.0; N];
        let fifth: [f64; N] = advance!(zero, 1.0, E5, k; 0, 5, 6, 7, 8, 9, 10, 11);
        let third: [f64; N] = advance!(zero, 1.0, E3, k; 0, 5, 6, 7, 8, 9, 10, 11);
        let (mut sum5, mut sum3) = (0.0, 0.0);
        for i in 0..N {
            let scale = self.scale(y[i].abs().max(new[i].abs()));
            if scale == 0.0 {
                continue; // a component that is exactly zero before and after
            }
            // eq:error-norm, but for the factor h/√N of the last line
            sum5 += (fifth[i] / scale).powi(2);
            sum3 += (third[i] / scale).powi(2);
        }
        let denominator = sum5 + 0.01 * sum3;
        if denominator == 0.0 {
            return 0.0;
        }
        h.abs() * sum5 / (denominator * N as f64).sqrt()
    }

    /// A first step from the sizes of the state, of its rates and of their change over a trial Euler step.
    pub(super) fn estimate_first_step<const N: usize>(
        &self,
        rates: &mut impl Rates<N>,
        t: f64,
        y: &[f64; N],
        rate: &[f64; N],
        end: f64,
    ) -> f64 {
        let longest = self.max_step.min((end - t).abs());
        let norm = |values: &[f64; N]| -> f64 {
            let sum: f64 =
                (0..N).map(|i| (values[i] / self.scale(y[i]).max(f64::MIN_POSITIVE)).powi(2)).sum();
            sum.sqrt()
        };
        let (size, slope) = (norm(y), norm(rate));
        let mut h = if size <= 1e-5 || slope <= 1e-5 { 1e-6 } else { 0.01 * size / slope };
        h = h.min(longest).copysign(end - t);
        let trial: [f64; N] = std::array::from_fn(|i| y[i] + h * rate[i]);
        let rate_there = rates(t + h, &trial);
        let bend = norm(&std::array::from_fn(|i| rate_there[i] - rate[i])) / h.abs();
        let largest = slope.max(bend);
        let by_order = if largest.is_nan() || largest <= 1e-15 {
            (h.abs() * 1e-3).max(1e-6)
        } else {
            (0.01 / largest).powf(1.0 / 8.0)
        };
        (100.0 * h.abs()).min(by_order).min(longest).max(f64::MIN_POSITIVE).copysign(end - t)
    }
}

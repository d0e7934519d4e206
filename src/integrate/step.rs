//! One accepted step of DOP853, and the polynomial that runs through it.

use super::tableau::{A, C, D};
use super::{Failure, Rates, Work};
use std::fmt;

/// The sum of a state and of `h` times a weighted sum of stages; the weights name the tableau's row.
#[cfg(not(target_arch = "wasm32"))]
macro_rules! advance {
    ($y:expr, $h:expr, $row:expr, $k:expr; $first:literal $(, $j:literal)*) => {{
        let mut sum = $k[$first].map(|rate| $row[$first] * rate);
        $(
            for (sum, rate) in sum.iter_mut().zip(&$k[$j]) {
                *sum += $row[$j] * rate;
            }
        )*
        for (sum, y) in sum.iter_mut().zip($y) {
            *sum = y + $h * *sum;
        }
        sum
    }};
}

/// The same sum, term by term the same, by one function: a page has to wait for every line of code that it runs.
#[cfg(target_arch = "wasm32")]
macro_rules! advance {
    ($y:expr, $h:expr, $row:expr, $k:expr; $($j:literal),+) => {
        super::step::sum_of_stages($y, $h, &$row[..], &$k[..], &[$($j),+])
    };
}
pub(super) use advance;

#[cfg(target_arch = "wasm32")]
#[inline(never)]
pub(super) fn sum_of_stages<const N: usize>(
    y: &[f64; N],
    h: f64,
    row: &[f64],
    k: &[[f64; N]],
    which: &[usize],
) -> [f64; N] {
    let mut sum = k[which[0]].map(|rate| row[which[0]] * rate);
    for &j in &which[1..] {
        for (sum, rate) in sum.iter_mut().zip(&k[j]) {
            *sum += row[j] * rate;
        }
    }
    for (sum, y) in sum.iter_mut().zip(y) {
        *sum = y + h * *sum;
    }
    sum
}

/// One accepted step, as an observer sees it.
///
/// The ends are there at once. [`Step::at`] gives the state between them; the first call costs three more
/// evaluations of the rates, which a step that is never looked into does not pay.
pub struct Step<'a, const N: usize, F> {
    pub(super) rates: &'a mut F,
    pub(super) work: &'a mut Work,
    pub(super) start: f64,
    /// Start and length together may round to a neighbour of this.
    pub(super) end: f64,
    pub(super) length: f64,
    pub(super) y0: &'a [f64; N],
    pub(super) y1: &'a [f64; N],
    pub(super) k: &'a mut [[f64; N]; 16],
    pub(super) dense: Option<[[f64; N]; 7]>,
}

impl<const N: usize, F> fmt::Debug for Step<'_, N, F> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { start, end, y0, y1, .. } = self;
        out.debug_struct("Step")
            .field("start", start)
            .field("end", end)
            .field("from", y0)
            .field("to", y1)
            .finish()
    }
}

impl<const N: usize, F: Rates<N>> Step<'_, N, F> {
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

    /// The state at the start.
    #[must_use]
    pub fn initial_state(&self) -> &[f64; N] {
        self.y0
    }

    /// The state at the end.
    #[must_use]
    pub fn final_state(&self) -> &[f64; N] {
        self.y1
    }

    /// The state at `time`, of order seven (Hairer, Nørsett & Wanner 1993, section II.10).
    ///
    /// Accurate between [`Step::start`] and [`Step::end`]; outside it extrapolates. The step control watches
    /// the ends only. Where a fast decay and not accuracy limits the step, at about five times the shortest
    /// decay time, the state between the ends can be digits worse than at them;
    /// [`super::Dop853::with_max_step`] helps. Not a number where the three evaluations are not.
    pub fn at(&mut self, time: f64) -> [f64; N] {
        let x = (time - self.start) / self.length;
        let y0 = self.y0;
        let terms = self.terms();
        std::array::from_fn(|i| {
            let mut value = 0.0;
            for (n, term) in terms.iter().enumerate().rev() {
                value = (value + term[i]) * if n % 2 == 0 { x } else { 1.0 - x };
            }
            y0[i] + value
        })
    }

    /// What to say where the state between the ends is not finite.
    pub(super) fn not_finite(&self) -> Failure {
        Failure::NotFinite { time: self.start, state: self.y0.to_vec(), step: self.length }
    }

    /// The coefficients of the polynomial in the nested products of x and 1 − x.
    fn terms(&mut self) -> &[[f64; N]; 7] {
        if self.dense.is_none() {
            let (t, h, y0, k) = (self.start, self.length, self.y0, &mut *self.k);
            k[13] = (self.rates)(t + C[13] * h, &advance!(y0, h, A[13], k; 0, 6, 7, 8, 9, 10, 11, 12));
            k[14] = (self.rates)(t + C[14] * h, &advance!(y0, h, A[14], k; 0, 5, 6, 7, 10, 11, 12, 13));
            k[15] = (self.rates)(t + C[15] * h, &advance!(y0, h, A[15], k; 0, 5, 6, 7, 8, 12, 13, 14));
            self.work.evaluations += 3;
            let mut terms = [[0.0; N]; 7];
            for i in 0..N {
                let rise = self.y1[i] - y0[i];
                terms[0][i] = rise;
                terms[1][i] = h * k[0][i] - rise;
                terms[2][i] = 2.0 * rise - h * (k[0][i] + k[12][i]);
            }
            for (term, weights) in terms[3..].iter_mut().zip(&D) {
                *term = advance!(&[0.0; N], h, weights, k; 0, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
            }
            self.dense = Some(terms);
        }
        self.dense.get_or_insert([[0.0; N]; 7])
    }
}

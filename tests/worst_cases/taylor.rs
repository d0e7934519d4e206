//! A judge with 32 digits: Taylor series of any system made of sums, products and quotients.
//!
//! Sines and exponentials are states of their own: the sine of φ and its cosine obey s′ = φ′c, c′ = −φ′s.

use crate::long::{Long, long};

/// The order of the series, and the size of its last terms.
const ORDER: usize = 30;
const TOLERANCE: f64 = 1e-31;
/// How much shorter the unit of time becomes if coefficients leave the range of numbers.
const SHORTER: f64 = 1e-4;
/// A judge that needs more steps has been asked too much.
const MOST_STEPS: usize = 100_000;

/// A system of rates, written down once as a list of operations on series.
pub(crate) struct System {
    states: usize,
    operations: Vec<Operation>,
    rates: Vec<Vec<(Long, Term)>>,
}

/// A state, or what an operation gives.
#[derive(Clone, Copy)]
pub(crate) struct Term(usize);

enum Operation {
    Constant(Long),
    Sum(Vec<(Long, Term)>),
    Product(Term, Term),
    Quotient(Term, Term),
}

impl System {
    /// A system of so many states, whose terms are given.
    pub(crate) fn new<const N: usize>() -> (Self, [Term; N]) {
        let system = Self { states: N, operations: Vec::new(), rates: vec![Vec::new(); N] };
        (system, std::array::from_fn(Term))
    }

    fn push(&mut self, operation: Operation) -> Term {
        self.operations.push(operation);
        Term(self.states + self.operations.len() - 1)
    }

    /// A constant.
    pub(crate) fn constant(&mut self, value: Long) -> Term {
        self.push(Operation::Constant(value))
    }

    /// A sum of terms with constant factors.
    pub(crate) fn sum(&mut self, terms: &[(Long, Term)]) -> Term {
        self.push(Operation::Sum(terms.to_vec()))
    }

    /// A product.
    pub(crate) fn product(&mut self, a: Term, b: Term) -> Term {
        self.push(Operation::Product(a, b))
    }

    /// A quotient.
    pub(crate) fn quotient(&mut self, a: Term, b: Term) -> Term {
        self.push(Operation::Quotient(a, b))
    }

    /// The rate of a state, as a sum of terms with constant factors.
    pub(crate) fn rate(&mut self, state: Term, terms: &[(Long, Term)]) {
        self.rates[state.0] = terms.to_vec();
    }

    /// The rates of a quaternion that turns with an angular velocity along the axes of the body.
    pub(crate) fn turn(&mut self, [q0, q1, q2, q3]: [Term; 4], [w1, w2, w3]: [Term; 3]) {
        let half = long(0.5);
        let turned = [
            [(-half, q1, w1), (-half, q2, w2), (-half, q3, w3)],
            [(half, q0, w1), (half, q2, w3), (-half, q3, w2)],
            [(half, q0, w2), (half, q3, w1), (-half, q1, w3)],
            [(half, q0, w3), (half, q1, w2), (-half, q2, w1)],
        ];
        for (state, terms) in [q0, q1, q2, q3].into_iter().zip(turned) {
            let terms = terms.map(|(factor, q, w)| (factor, self.product(q, w)));
            self.rate(state, &terms);
        }
    }

    /// The states at `times`, which run away from zero in one direction, from `start` at zero.
    pub(crate) fn sample(&self, start: &[Long], times: &[Long]) -> Vec<Vec<Long>> {
        self.attempt(start, times).unwrap_or_else(|| panic!("the judge gave up before {times:?}"))
    }

    /// The same, or nothing if it takes too many steps.
    pub(crate) fn attempt(&self, start: &[Long], times: &[Long]) -> Option<Vec<Vec<Long>>> {
        self.follow(start, times, |_, _| {})
    }

    /// The same; the time and the state where each step begins are told.
    pub(crate) fn follow(
        &self,
        start: &[Long],
        times: &[Long],
        mut begins: impl FnMut(Long, &[Long]),
    ) -> Option<Vec<Vec<Long>>> {
        let mut samples: Vec<Vec<Long>> = Vec::new();
        let mut state = start.to_vec();
        let mut now = long(0.0);
        let mut unit = 1.0;
        for _ in 0..MOST_STEPS {
            if samples.len() == times.len() {
                return Some(samples);
            }
            begins(now, &state);
            let series = self.series(&state, unit);
            let part = step(&series[..self.states]);
            if part == 0.0 {
                unit *= SHORTER; // the coefficients have left the range
                assert!(
                    unit > f64::MIN_POSITIVE,
                    "the judge stands still at {:?} of {times:?}: {state:?}",
                    now.rounded()
                );
                continue;
            }
            let length = part * unit;
            let direction = if times[samples.len()].rounded() < 0.0 { -1.0 } else { 1.0 };
            while let Some(&time) = times.get(samples.len()) {
                let since = time - now;
                if since.abs() > long(length) {
                    break;
                }
                samples.push(series[..self.states].iter().map(|row| value(row, since / unit)).collect());
            }
            let length = long(direction * length);
            state = series[..self.states].iter().map(|row| value(row, length / unit)).collect();
            now = now + length;
            unit = length.abs().rounded().min(1.0);
        }
        None
    }

    /// The coefficients of all states and operations, in powers of the time over `unit`.
    fn series(&self, state: &[Long], unit: f64) -> Vec<[Long; ORDER + 1]> {
        let mut rows = vec![[long(0.0); ORDER + 1]; self.states + self.operations.len()];
        for (row, &value) in rows.iter_mut().zip(state) {
            row[0] = value;
        }
        for n in 0..=ORDER {
            for (place, operation) in self.operations.iter().enumerate() {
                let coefficient = match operation {
                    Operation::Constant(value) => {
                        if n == 0 {
                            *value
                        } else {
                            long(0.0)
                        }
                    }
                    Operation::Sum(terms) => weighted(terms, &rows, n),
                    Operation::Product(a, b) => (0..=n).map(|j| rows[a.0][j] * rows[b.0][n - j]).sum(),
                    Operation::Quotient(a, b) => {
                        let known =
                            (0..n).map(|j| rows[self.states + place][j] * rows[b.0][n - j]).sum::<Long>();
                        (rows[a.0][n] - known) / rows[b.0][0]
                    }
                };
                rows[self.states + place][n] = coefficient;
            }
            if n < ORDER {
                for (place, terms) in self.rates.iter().enumerate() {
                    rows[place][n + 1] = weighted(terms, &rows, n) * unit / (n + 1) as f64;
                }
            }
        }
        rows
    }
}

fn weighted(terms: &[(Long, Term)], rows: &[[Long; ORDER + 1]], n: usize) -> Long {
    terms.iter().map(|(factor, term)| *factor * rows[term.0][n]).sum()
}

/// How far the series are good, from their last two terms beside the largest value; zero if they are not numbers.
fn step(rows: &[[Long; ORDER + 1]]) -> f64 {
    let size = |n: usize| rows.iter().map(|row| row[n].rounded().abs()).fold(0.0, f64::max);
    let scale = TOLERANCE * size(0);
    let by = |n: usize| (scale / size(n)).powf(1.0 / n as f64);
    let length = by(ORDER).min(by(ORDER - 1));
    if length.is_nan() { 0.0 } else { length.min(1e300) }
}

fn value(row: &[Long; ORDER + 1], since: Long) -> Long {
    row.iter().rev().fold(long(0.0), |sum, &coefficient| sum * since + coefficient)
}

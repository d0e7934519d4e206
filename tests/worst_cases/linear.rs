//! A judge with some 25 digits for systems of constant coefficients, at any time: the exponential of their matrix.

use crate::long::{Long, long};

type Matrix<const N: usize> = [[Long; N]; N];

/// The state at `time` from `state` at zero, for the rates `matrix · state`.
pub(crate) fn carried<const N: usize>(matrix: &[[Long; N]; N], state: &[Long; N], time: Long) -> [Long; N] {
    let size = matrix.iter().flatten().map(|number| number.abs().rounded()).fold(0.0, f64::max);
    // A step so short that the series converges in a few terms, and the rest by doubling it. The exponential
    // less one is what is doubled, so that a short step loses nothing beside the one.
    let doublings = (size * time.abs().rounded() * 4.0).log2().ceil().max(0.0) as i32;
    let step = time / 2.0_f64.powi(doublings);
    let mut power = unit::<N>();
    let mut grown = [[long(0.0); N]; N];
    for term in 1..30 {
        power = product(&power, matrix);
        power = power.map(|row| row.map(|number| number * step / f64::from(term)));
        grown = sum(&grown, &power);
    }
    for _ in 0..doublings {
        grown = sum(&sum(&grown, &grown), &product(&grown, &grown));
    }
    let whole = sum(&grown, &unit());
    std::array::from_fn(|i| (0..N).map(|j| whole[i][j] * state[j]).sum())
}

fn unit<const N: usize>() -> Matrix<N> {
    std::array::from_fn(|i| std::array::from_fn(|j| long(if i == j { 1.0 } else { 0.0 })))
}

fn sum<const N: usize>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] + b[i][j]))
}

fn product<const N: usize>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..N).map(|k| a[i][k] * b[k][j]).sum()))
}

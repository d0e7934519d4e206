//! Faddeeva's function of several numbers at once.

use super::functions::{exp, nearest, sin_cos_quarters};
use crate::faddeeva::{FAR, NODES, SPACING, WEIGHTS};
use std::f64::consts::{FRAC_2_PI, PI};

const PER_SPACING: f64 = 1.954_410_047_611_679_7; // 1/SPACING

/// Beyond this real part the Gaussian is zero and no node is near.
const AMONG_NODES: f64 = 40.0;

/// Real and imaginary parts of many numbers.
pub(crate) type Parts<const N: usize> = [[f64; N]; 2];

/// w of many numbers in the upper half-plane, up to 1e70 in size. The loops have no branch and do several numbers in
/// one instruction.
#[inline(always)]
pub(crate) fn upper_half<const N: usize>([z_re, y]: &Parts<N>) -> Parts<N> {
    // In the first quadrant; w of the mirror image in the imaginary axis is the conjugate.
    let x: [f64; N] = std::array::from_fn(|n| z_re[n].abs());
    let [mut re, mut im] = if y.iter().all(|&y| y >= FAR) { far(&x, y) } else { near(&x, y) };
    for n in 0..N {
        let (a, b) = (re[n], if z_re[n] < 0.0 { -im[n] } else { im[n] });
        (re[n], im[n]) = (a, b);
    }
    [re, im]
}

/// The midpoint rule alone.
#[inline(always)]
fn far<const N: usize>(x: &[f64; N], y: &[f64; N]) -> Parts<N> {
    let mut sums = [[0.0; N]; 2];
    let (square, twice) = squares(x, y);
    for ([_, node], [_, weight]) in SQUARES.iter().zip(&WEIGHTS) {
        for n in 0..N {
            let across = square[n] - node;
            let part = weight / (across * across + twice[n] * twice[n]);
            sums[0][n] += part * across;
            sums[1][n] -= part * twice[n];
        }
    }
    times_iz(x, y, &sums)
}

/// The rule whose nodes are away from the pole, and the pole's residue.
#[inline(always)]
fn near<const N: usize>(x: &[f64; N], y: &[f64; N]) -> Parts<N> {
    let mut whole = [0.0; N]; // 1 for nodes at whole multiples of the spacing, 0 for those between
    for n in 0..N {
        let place = x[n] * PER_SPACING;
        let place = if x[n] < AMONG_NODES { place } else { 0.0 };
        let from_node = (place - nearest(place).0).abs();
        let between = if from_node >= 0.25 { 1.0 } else { 0.0 };
        whole[n] = if y[n] < x[n] { between } else { 0.0 };
    }
    let (square, twice) = squares(x, y);
    let mut sums = [[0.0; N]; 2];
    for ([node, half_node], [weight, half_weight]) in SQUARES.iter().zip(&WEIGHTS) {
        for n in 0..N {
            let node = half_node + whole[n] * (node - half_node);
            let weight = half_weight + whole[n] * (weight - half_weight);
            let across = square[n] - node;
            let part = weight / (across * across + twice[n] * twice[n]);
            sums[0][n] += part * across;
            sums[1][n] -= part * twice[n];
        }
    }
    let [mut re, mut im] = times_iz(x, y, &sums);
    for n in 0..N {
        // The residue 2 e^{−z²} E/(E ∓ 1) with E = e^{2πiz/h}.
        let counts = y[n] < FAR;
        let height = if counts { y[n] } else { 0.0 };
        let aside = if x[n] < AMONG_NODES { x[n] } else { 0.0 };
        let size = exp(-2.0 * PI * PER_SPACING * height);
        let (sin, cos) = sin_cos_quarters(4.0 * PER_SPACING * aside, 0.0);
        let (e_re, e_im) = (size * cos, size * sin);
        let below_re = e_re + (1.0 - 2.0 * whole[n]);
        let over = 1.0 / (below_re * below_re + e_im * e_im);
        let (q_re, q_im) = ((e_re * below_re + e_im * e_im) * over, (e_im * below_re - e_re * e_im) * over);
        let gauss = 2.0 * exp((height - x[n]) * (height + x[n]));
        let gauss = if counts { gauss } else { 0.0 };
        let (sin, cos) = sin_cos_quarters(-2.0 * FRAC_2_PI * aside * height, 0.0);
        re[n] += gauss * (cos * q_re - sin * q_im);
        im[n] += gauss * (cos * q_im + sin * q_re);
    }
    [re, im]
}

/// Real and imaginary part of z².
#[inline(always)]
fn squares<const N: usize>(x: &[f64; N], y: &[f64; N]) -> ([f64; N], [f64; N]) {
    let (mut square, mut twice) = ([0.0; N], [0.0; N]);
    for n in 0..N {
        square[n] = (x[n] - y[n]) * (x[n] + y[n]);
        twice[n] = 2.0 * x[n] * y[n];
    }
    (square, twice)
}

/// The sums of the rule, times 2ihz/π.
#[inline(always)]
fn times_iz<const N: usize>(x: &[f64; N], y: &[f64; N], [sum_re, sum_im]: &Parts<N>) -> Parts<N> {
    let (mut re, mut im) = ([0.0; N], [0.0; N]);
    for n in 0..N {
        let (a, b) = (2.0 * SPACING / PI * sum_re[n], 2.0 * SPACING / PI * sum_im[n]);
        (re[n], im[n]) = (-(x[n] * b + y[n] * a), x[n] * a - y[n] * b);
    }
    [re, im]
}

/// Squares of the nodes, π/12 times those of whole numbers, and of the numbers half-way between.
const SQUARES: [[f64; 2]; NODES] = {
    let mut squares = [[0.0; 2]; NODES];
    let mut k = 0;
    while k < NODES {
        let (whole, between) = (k as f64, k as f64 + 0.5);
        squares[k] = [whole * whole * PI / 12.0, between * between * PI / 12.0];
        k += 1;
    }
    squares
};

#[cfg(test)]
mod tests {
    use super::upper_half;
    use crate::faddeeva::faddeeva;
    use nalgebra::Complex;

    #[test]
    fn several_at_once_are_faddeevas_function() {
        let mut random = fastrand::Rng::with_seed(5);
        for round in 0..2000 {
            // All above the last residue, or anywhere; near, among and beyond the nodes.
            let lowest = if round % 2 == 0 { 6.2 } else { 0.0 };
            let spread = [0.1, 2.0, 9.0, 100.0][round % 4];
            let x: [f64; 8] = std::array::from_fn(|_| spread * (2.0 * random.f64() - 1.0));
            let y: [f64; 8] = std::array::from_fn(|_| lowest + spread * random.f64());
            let [re, im] = upper_half(&[x, y]);
            for n in 0..8 {
                let (ours, one) = (Complex::new(re[n], im[n]), faddeeva(Complex::new(x[n], y[n])));
                assert!((ours - one).norm() < 16.0 * f64::EPSILON * one.norm(), "{} {}", x[n], y[n]);
            }
        }
    }
}

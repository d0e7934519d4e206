//! Faddeeva's function, the error function of a complex argument: what a rotor that speeds up through its resonance
//! obeys.
//!
//! `w(z) = e^{−z²} erfc(−iz)`. The trapezium or the midpoint rule for its integral, whichever keeps its nodes away
//! from the pole, with the residue of the pole added (M. Al Azah & S. N. Chandler-Wilde, *SIAM Journal on Numerical
//! Analysis* **59** (2021) 2346–2367).

use crate::elementary::{exp, nearest, sin_cos_quarters};
use nalgebra::Complex;
use std::f64::consts::{FRAC_2_PI, PI};

/// Nodes on one side.
const NODES: usize = 12;
/// Their distance h, √(π/12).
const SPACING: f64 = 0.511_663_353_973_244_3;
const PER_SPACING: f64 = 1.954_410_047_611_679_7; // 1/SPACING
/// Above this imaginary part, π/h, the residue counts for nothing.
const FAR: f64 = 6.139_960_247_678_931;
/// Beyond this real part the Gaussian is zero and no node is near.
const AMONG_NODES: f64 = 40.0;
/// Beyond this size only the pole i/√π z is left, to sixteen digits.
const POLE_ONLY: f64 = 1e9;

/// w(z), with an error of at most eight units in the last place of `|w|` (`f64::EPSILON`, relative) in the upper
/// half-plane and on the real axis.
///
/// In the lower half-plane it is `2e^{−z²} − w(−z)`, with so many units of the two together, and of what a unit in
/// the last place of z² makes of the first, which grows: beyond the largest number it is infinite. For |z| above 1e8
/// or so its phase is lost there, and it is NaN where z² itself is beyond the largest number.
///
/// ```
/// use mechanics::faddeeva::faddeeva;
/// use mechanics::nalgebra::Complex;
/// // On the imaginary axis it is e^{y²} erfc y, 0.427 583 576... at i.
/// let w = faddeeva(Complex::new(0.0, 1.0));
/// assert!((w.re - 0.427_583_576_155_807).abs() < 1e-15 && w.im == 0.0);
/// ```
#[must_use]
pub fn faddeeva(z: Complex<f64>) -> Complex<f64> {
    if z.im >= 0.0 {
        return above(z);
    }
    let size = 2.0 * ((z.im - z.re) * (z.im + z.re)).exp();
    let (sin, cos) = (-2.0 * z.re * z.im).sin_cos();
    let part = |share: f64| if share == 0.0 { 0.0 } else { size * share };
    Complex::new(part(cos), part(sin)) - above(-z)
}

/// w of one number in the upper half-plane.
fn above(z: Complex<f64>) -> Complex<f64> {
    let [[re], [im]] = upper_half::<1, true>(&[[z.re], [z.im]]);
    Complex::new(re, im)
}

/// Real and imaginary parts of many numbers.
pub(crate) type Parts<const N: usize> = [[f64; N]; 2];

/// w of many numbers in the upper half-plane, up to 1e70 in size, or of `ONE`, of any size: 2ihz/π Σ e^{−t²}/(z² − t²)
/// over the nodes t, whole multiples of h or half-way between, whichever are further from z; and the residue of the
/// integrand's pole at z. The loops have no branch and do several numbers in one instruction.
#[inline(always)]
pub(crate) fn upper_half<const N: usize, const ONE: bool>([z_re, y]: &Parts<N>) -> Parts<N> {
    if ONE && z_re[0].hypot(y[0]) > POLE_ONLY {
        let pole = Complex::new(0.0, PI.sqrt().recip()).fdiv(Complex::new(z_re[0], y[0]));
        return [[pole.re; N], [pole.im; N]];
    }
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
        let (sin, cos) = sin_cos_quarters::<false>(4.0 * PER_SPACING * aside, 0.0);
        let (e_re, e_im) = (size * cos, size * sin);
        let below_re = e_re + (1.0 - 2.0 * whole[n]);
        let over = 1.0 / (below_re * below_re + e_im * e_im);
        let (q_re, q_im) = ((e_re * below_re + e_im * e_im) * over, (e_im * below_re - e_re * e_im) * over);
        let gauss = 2.0 * exp((height - x[n]) * (height + x[n]));
        let gauss = if counts { gauss } else { 0.0 };
        let (sin, cos) = sin_cos_quarters::<false>(-2.0 * FRAC_2_PI * aside * height, 0.0);
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

/// `e^{−t²}` at the nodes that are whole multiples of h, of the one at zero half, and at those half-way between.
const WEIGHTS: [[f64; 2]; NODES] = [
    [5.0e-1, 9.366_460_212_365_959e-1],
    [7.696_654_124_932_398e-1, 5.548_549_101_598_534e-1],
    [3.509_198_071_784_11e-1, 1.947_095_780_852_903e-1],
    [9.478_022_484_215_486e-2, 4.047_614_460_380_574e-2],
    [1.516_461_986_454_657e-2, 4.984_423_132_468_586e-3],
    [1.437_306_080_407_531_7e-3, 3.636_089_863_893_044_6e-4],
    [8.069_951_757_030_46e-5, 1.571_296_901_780_048e-5],
    [2.684_086_793_096_743e-6, 4.022_405_421_564_814e-7],
    [5.288_422_116_944_157_6e-8, 6.099_824_915_912_159_6e-9],
    [6.172_478_865_224_31e-10, 5.479_650_239_757_527e-11],
    [4.267_731_135_455_224e-12, 2.916_031_755_179_499e-13],
    [1.747_987_940_565_501_4e-14, 9.192_541_525_134_372e-16],
];

//! Faddeeva's function, the error function of a complex argument: what a rotor that speeds up through its resonance
//! obeys.
//!
//! `w(z) = e^{−z²} erfc(−iz)`. The trapezium or the midpoint rule for its integral, whichever keeps its nodes away
//! from the pole, with the residue of the pole added (M. Al Azah & S. N. Chandler-Wilde, *SIAM Journal on Numerical
//! Analysis* **59** (2021) 2346–2367).

use nalgebra::Complex;
use std::f64::consts::PI;

/// Nodes on one side.
pub(crate) const NODES: usize = 12;
/// Their distance h, √(π/12).
pub(crate) const SPACING: f64 = 0.511_663_353_973_244_3;
/// Above this imaginary part, π/h, the residue counts for nothing.
pub(crate) const FAR: f64 = 6.139_960_247_678_931;
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
/// use nalgebra::Complex;
/// // On the imaginary axis it is e^{y²} erfc y, 0.427 583 576... at i.
/// let w = faddeeva(Complex::new(0.0, 1.0));
/// assert!((w.re - 0.427_583_576_155_807).abs() < 1e-15 && w.im == 0.0);
/// ```
pub fn faddeeva(z: Complex<f64>) -> Complex<f64> {
    if z.im >= 0.0 {
        return upper_half(z);
    }
    let size = 2.0 * ((z.im - z.re) * (z.im + z.re)).exp();
    let (sin, cos) = (-2.0 * z.re * z.im).sin_cos();
    let part = |share: f64| if share == 0.0 { 0.0 } else { size * share };
    Complex::new(part(cos), part(sin)) - upper_half(-z)
}

fn upper_half(z: Complex<f64>) -> Complex<f64> {
    if z.norm() > POLE_ONLY {
        return Complex::new(0.0, PI.sqrt().recip()).fdiv(z);
    }
    if z.re < 0.0 {
        return first_quadrant(-z.conj()).conj(); // the mirror image in the imaginary axis
    }
    first_quadrant(z)
}

/// 2ihz/π Σ e^{−t²}/(z² − t²) over the nodes t, whole multiples of h or half-way between, whichever are further from
/// z; and the residue of the integrand's pole at z, 2e^{−z²}E/(E ∓ 1) with E = e^{2πiz/h}.
fn first_quadrant(z: Complex<f64>) -> Complex<f64> {
    let whole = z.im < z.re && (0.25..=0.75).contains(&(z.re / SPACING).fract());
    let (shift, column, sign) = if whole { (0.0, 0, -1.0) } else { (0.5, 1, 1.0) };
    let mut sum = Complex::new(0.0, 0.0);
    for (k, weights) in WEIGHTS.iter().enumerate() {
        let node = (k as f64 + shift) * SPACING;
        let difference = (z - node) * (z + node); // z² − t²
        sum += difference.conj() * (weights[column] / difference.norm_sqr());
    }
    let rule = Complex::new(0.0, 2.0 * SPACING / PI) * z * sum;
    if z.im >= FAR {
        return rule;
    }
    let e = (Complex::new(0.0, 2.0 * PI / SPACING) * z).exp();
    rule + (-z * z).exp() * e / (e + sign) * 2.0
}

/// `e^{−t²}` at the nodes that are whole multiples of h, of the one at zero half, and at those half-way between.
pub(crate) const WEIGHTS: [[f64; 2]; NODES] = [
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

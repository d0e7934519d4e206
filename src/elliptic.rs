//! Elliptic functions and integrals, from the complementary modulus.
//!
//! All functions take the complementary parameter `k'² = 1 − k²` where the usual ones take `k²`: near the separatrix of a
//! pendulum or of a spinning body `k²` is so near to one that the difference, which is all that matters there, would be lost in it.
//!
//! Methods: Landen's transformation and the arithmetic-geometric mean (R. Bulirsch, *Numerische Mathematik* **7** (1965)
//! 78–90 and **13** (1969) 305–315); Carlson's duplication for `R_F` (B. C. Carlson, *Numerical Algorithms* **10** (1995) 13–26).

use crate::two_part::TwoPart;

/// Jacobi's sn, cn and dn of `u` for the complementary parameter `complement` = k'² between 0 and 1.
///
/// Each to 1e-15 for `|u|` up to K. Beyond, the rounding of the period counts as often as there are periods in `u`: to `1e-15 (1 + |u|)`.
/// A complement outside 0 to 1 gives NaN, and so does an argument that is not finite.
///
/// ```
/// use mechanics::elliptic::jacobi;
/// // At k'² = 1 they are sine, cosine and one, at 0 the hyperbolic functions of the separatrix.
/// assert!((jacobi(0.7, 1.0)[0] - 0.7_f64.sin()).abs() < 1e-15);
/// assert!((jacobi(0.7, 0.0)[0] - 0.7_f64.tanh()).abs() < 1e-15);
/// ```
pub fn jacobi(u: f64, complement: f64) -> [f64; 3] {
    if !(0.0..=1.0).contains(&complement) {
        return [f64::NAN; 3];
    }
    if complement == 0.0 {
        let sech = u.cosh().recip();
        return [u.tanh(), sech, sech];
    }
    if u.abs() < SMALL {
        return [u, 1.0, 1.0]; // below, 1/u² is too large for f64 sooner or later
    }
    // Arithmetic and geometric means, until they agree to half of the digits: one more step would agree to all.
    let (mut arithmetic, mut geometric) = ([0.0; MEANS], [0.0; MEANS]);
    let (mut mean, mut square, mut last) = (1.0, complement, 0);
    let mut next = 1.0;
    for step in 0..MEANS {
        let root = f64::sqrt(square);
        arithmetic[step] = mean;
        geometric[step] = root;
        next = 0.5 * (mean + root);
        last = step;
        if (mean - root).abs() <= HALF_OF_THE_DIGITS * mean {
            break;
        }
        square = root * mean;
        mean = next;
    }
    let (sin, cos) = (next * u).sin_cos();
    if sin == 0.0 {
        return [sin, cos, 1.0];
    }
    // Back up: c is the cotangent of the amplitude times the mean.
    let mut ratio = cos / sin;
    let mut c = next * ratio;
    let mut dn = 1.0;
    for step in (0..=last).rev() {
        ratio *= c;
        c *= dn;
        dn = (geometric[step] + ratio) / (arithmetic[step] + ratio);
        ratio = c / arithmetic[step];
    }
    let sn = c.hypot(1.0).recip().copysign(sin);
    [sn, c * sn, dn]
}

/// The square of an argument below this is lost beside one.
const SMALL: f64 = 1e-9;
/// Steps of the means: enough for every complement that `f64` has.
const MEANS: usize = 16;
/// The square root of half a unit in the last place.
const HALF_OF_THE_DIGITS: f64 = 1e-8;

/// The quarter period `K` for the complementary parameter k'² between 0 and 1, with a relative error below 1e-15; infinite at 0, NaN
/// outside.
///
/// ```
/// use mechanics::elliptic::quarter_period;
/// assert_eq!(quarter_period(1.0), std::f64::consts::FRAC_PI_2);
/// assert!((quarter_period(0.5) - 1.854_074_677_301_371_9).abs() < 1e-15);
/// ```
pub fn quarter_period(complement: f64) -> f64 {
    if !(0.0..=1.0).contains(&complement) {
        return f64::NAN;
    }
    if complement == 0.0 {
        return f64::INFINITY;
    }
    let (mut a, mut g) = (1.0, complement.sqrt());
    while (a - g).abs() > HALF_OF_THE_DIGITS * a {
        (a, g) = (0.5 * (a + g), f64::sqrt(a * g));
    }
    std::f64::consts::PI / (a + g)
}

/// Carlson's symmetric integral `R_F(x, y, z)` for arguments of zero or more, at most one of them zero, of any size, with a relative
/// error below 1.5e-15. Infinite if two are zero, zero if one is infinite, NaN for negative ones.
pub fn carlson_rf(x: f64, y: f64, z: f64) -> f64 {
    if !(x >= 0.0 && y >= 0.0 && z >= 0.0) {
        return f64::NAN;
    }
    if [x, y, z].iter().filter(|&&value| value == 0.0).count() > 1 {
        return f64::INFINITY;
    }
    if x.max(y).max(z) == f64::INFINITY {
        return 0.0;
    }
    // Where all three are tiny their products are lost: R_F(λx, λy, λz) = R_F(x, y, z)/√λ.
    let enlarged = if x.max(y).max(z) < TINY { ENLARGED } else { 1.0 };
    let [mut x, mut y, mut z] = [x, y, z].map(|value| value * enlarged * enlarged);
    loop {
        // Not the sum, which may be too large for f64.
        let mean = x / 3.0 + y / 3.0 + z / 3.0;
        let (dx, dy) = ((mean - x) / mean, (mean - y) / mean);
        if dx.abs().max(dy.abs()).max((dx + dy).abs()) <= SPREAD {
            return (1.0 + series(dx, dy)) / mean.sqrt() * enlarged;
        }
        // x + √x√y + √y√z + √z√x is a product, and so are the two others.
        let [rx, ry, rz] = [x, y, z].map(|value| 0.5 * value.sqrt());
        let (xy, yz, zx) = (rx + ry, ry + rz, rz + rx);
        (x, y, z) = (xy * zx, xy * yz, yz * zx);
    }
}

/// The same to some twenty digits, for numbers from zero to about one.
pub(crate) fn carlson_rf_in_two_parts([mut x, mut y, mut z]: [TwoPart; 3]) -> TwoPart {
    loop {
        let mean = (x + y + z) / TwoPart::from(3.0);
        let [dx, dy] = [x, y].map(|value| (mean - value).rounded() / mean.rounded());
        if dx.abs().max(dy.abs()).max((dx + dy).abs()) <= 0.25 * SPREAD {
            return (TwoPart::from(1.0) + series(dx, dy)) / mean.sqrt();
        }
        let [rx, ry, rz] = [x, y, z].map(|value| value.sqrt() * 0.5);
        let (xy, yz, zx) = (rx + ry, ry + rz, rz + rx);
        (x, y, z) = (xy * zx, xy * yz, yz * zx);
    }
}

/// `R_F` times the root of the mean, less one, from how far two of its arguments are from the mean.
fn series(dx: f64, dy: f64) -> f64 {
    let dz = -(dx + dy);
    let (e2, e3) = (dx * dy - dz * dz, dx * dy * dz);
    (-0.1 + e2 / 24.0 - 3.0 / 44.0 * e3) * e2 + e3 / 14.0
}

/// The series is exact to a thousandth of the sixth power of how far the arguments differ from their mean.
const SPREAD: f64 = 2e-3;
const TINY: f64 = 1e-250;
const ENLARGED: f64 = 1_267_650_600_228_229_401_496_703_205_376.0; // 2^100

/// Bulirsch's complete integral `cel(k', p, a, b) = ∫₀^{π/2} (a cos² + b sin²)/((cos² + p sin²)√(cos² + k'² sin²)) dθ` for `p > 0` and
/// `k' > 0`, to about 30 digits.
pub(crate) fn complete_integral(root_complement: TwoPart, p: TwoPart, a: TwoPart, b: TwoPart) -> TwoPart {
    let mut p = p.sqrt();
    let (mut a, mut b) = (a, b / p);
    let (mut qc, mut e, mut em) = (root_complement, root_complement, TwoPart::from(1.0));
    for _ in 0..MEANS {
        let f = a;
        a = a + b / p;
        let g = e / p;
        b = (b + f * g) * 2.0;
        p = p + g;
        let before = em;
        em = em + qc;
        if (before - qc).rounded().abs() <= 1e-16 * before.rounded() {
            break;
        }
        qc = e.sqrt() * 2.0;
        e = qc * em;
    }
    TwoPart::PI * 0.5 * (b + a * em) / (em * (em + p))
}

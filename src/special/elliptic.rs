//! Elliptic functions and integrals, from the complementary modulus.
//!
//! All functions take the complementary parameter `k'² = 1 − k²` where the usual ones take `k²`: near the separatrix
//! of a pendulum or of a spinning body `k²` is so near to one that the difference, which is all that matters there,
//! would be lost in it.
//!
//! Methods: Landen's transformation and the arithmetic-geometric mean (R. Bulirsch, *Numerische Mathematik* **7**
//! (1965) 78–90 and **13** (1969) 305–315; DLMF §§ 19.8 and 22.7); Carlson's duplication for `R_F` (B. C. Carlson,
//! *Numerische Mathematik* **33** (1979) 1–16, and *Numerical Algorithms* **10** (1995) 13–26).

use crate::two_part::TwoPart;

/// Jacobi's sn, cn and dn of `u` for the complementary parameter `complement` = k'² between 0 and 1.
///
/// Each to 1e-15 for `|u|` up to K. Beyond, the rounding of the period counts as often as there are periods in `u`: to
/// `1e-15 (1 + |u|)`. A complement outside 0 to 1 gives NaN, and so does an argument that is not finite.
///
/// ```
/// use mechanics::elliptic::jacobi;
/// // At k'² = 1 they are sine, cosine and one, at 0 the hyperbolic functions of the separatrix.
/// assert!((jacobi(0.7, 1.0)[0] - 0.7_f64.sin()).abs() < 1e-15);
/// assert!((jacobi(0.7, 0.0)[0] - 0.7_f64.tanh()).abs() < 1e-15);
/// ```
#[must_use]
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
    // The means a and g of 1 and k'. The modulus that belongs to them is √(a² − g²)/a; after the next step, (a − g)/(a
    // + g).
    let (mut means, mut count) = ([(0.0, 0.0); STEPS], 0);
    let (mut mean, mut product) = (1.0, complement);
    loop {
        let (arithmetic, geometric) = (mean, f64::sqrt(product));
        means[count] = (arithmetic, geometric);
        count += 1;
        (mean, product) = (0.5 * (arithmetic + geometric), arithmetic * geometric);
        if (arithmetic - geometric).abs() <= HALF_OF_THE_DIGITS * arithmetic {
            break; // the square of the next modulus is below 3e-17, and so is the difference between sn and sine
        }
    }
    let (sin, cos) = (mean * u).sin_cos();
    if sin == 0.0 {
        return [sin, cos, 1.0];
    }
    // Back up, by Landen's transformation (DLMF 22.7(i)) for cs = cn/sn: with a dash for the later mean and its
    // functions, a cs = a' cs' dn' and dn = (g + a' cs'²)/(a + a' cs'²).
    let (mut mean_cs, mut dn) = (mean * (cos / sin), 1.0);
    for &(arithmetic, geometric) in means[..count].iter().rev() {
        let mean_cs_square = mean_cs * (mean_cs / mean);
        mean_cs *= dn;
        dn = (geometric + mean_cs_square) / (arithmetic + mean_cs_square);
        mean = arithmetic;
    }
    let sn = mean_cs.hypot(1.0).recip().copysign(sin);
    [sn, mean_cs * sn, dn]
}

/// The square of an argument below this is lost beside one.
const SMALL: f64 = 1e-9;
/// Steps of the means. A ratio x of the two becomes ½√x in a step while it is large, and a relative difference d
/// becomes `d²/8` once it is small: from k' = 2e-162, the least that `f64` has, twelve steps are enough.
const STEPS: usize = 16;
/// Means that agree to this agree to 2e-17 after a step, and to 1e-17 with their limit.
const HALF_OF_THE_DIGITS: f64 = 1e-8;

/// The quarter period `K` for the complementary parameter k'² between 0 and 1, with a relative error below 1e-15;
/// infinite at 0, NaN outside.
///
/// ```
/// use mechanics::elliptic::quarter_period;
/// assert_eq!(quarter_period(1.0), std::f64::consts::FRAC_PI_2);
/// assert!((quarter_period(0.5) - 1.854_074_677_301_371_9).abs() < 1e-15);
/// ```
#[must_use]
pub fn quarter_period(complement: f64) -> f64 {
    if !(0.0..=1.0).contains(&complement) {
        return f64::NAN;
    }
    if complement == 0.0 {
        return f64::INFINITY;
    }
    // ½π over the arithmetic-geometric mean of 1 and k' (DLMF 19.8.5).
    let (mut arithmetic, mut geometric) = (1.0, complement.sqrt());
    while (arithmetic - geometric).abs() > HALF_OF_THE_DIGITS * arithmetic {
        (arithmetic, geometric) = (0.5 * (arithmetic + geometric), f64::sqrt(arithmetic * geometric));
    }
    std::f64::consts::PI / (arithmetic + geometric)
}

/// Carlson's symmetric integral `R_F(x, y, z)` for arguments of zero or more, at most one of them zero, of any size,
/// with a relative error below 1.5e-15. Infinite if two are zero, zero if one is infinite, NaN for negative ones.
#[must_use]
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

/// `R_F` times the root of the mean, less one, from how far two of its arguments are from the mean (DLMF 19.36.1).
fn series(dx: f64, dy: f64) -> f64 {
    let dz = -(dx + dy);
    let (e2, e3) = (dx * dy - dz * dz, dx * dy * dz);
    (-0.1 + e2 / 24.0 - 3.0 / 44.0 * e3) * e2 + e3 / 14.0
}

/// How far the arguments may be from their mean, relative, for the series. What it leaves out is below a quarter of
/// the sixth power of that (Carlson 1979): 2e-17, and with a quarter of the spread 4e-21.
const SPREAD: f64 = 2e-3;
const TINY: f64 = 1e-250;
const ENLARGED: f64 = 1_267_650_600_228_229_401_496_703_205_376.0; // 2^100

/// Bulirsch's complete integral `cel(k', p, a, b) = ∫₀^{π/2} (a cos² + b sin²)/((cos² + p sin²)√(cos² + k'² sin²)) dθ`
/// for `p > 0` and `k' > 0`, to about 30 digits.
///
/// It is `J = ∫₀^{π/2} (c m² cos² + d r sin²)/((m² cos² + r² sin²)√(m² cos² + g² sin²)) dθ` for m = 1, g = k', r = √p,
/// c = a and d = b/r. Bulirsch's step (1969) leads m and g to their means and r, c, d to others, with the same J.
/// Where m and g are equal, `J = ½π (cm + d)/(m(m + r))`.
pub(crate) fn complete_integral(root_complement: TwoPart, p: TwoPart, a: TwoPart, b: TwoPart) -> TwoPart {
    let (mut m, mut g) = (TwoPart::from(1.0), root_complement);
    let mut r = p.sqrt();
    let (mut c, mut d) = (a, b / r);
    loop {
        // A difference of 1e-16 is one of 1e-33 after this step.
        let last = (m - g).rounded().abs() <= 1e-16 * m.rounded();
        let product = m * g;
        (c, d) = ((c + d / r) * 0.5, (d + c * product / r) * 0.5);
        r = (r + product / r) * 0.5;
        (m, g) = ((m + g) * 0.5, product.sqrt());
        if last {
            return TwoPart::PI * 0.5 * (c * m + d) / (m * (m + r));
        }
    }
}

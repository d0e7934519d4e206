//! Elliptic functions and integrals, against series that know neither Landen's transformation nor the mean: Fourier's,
//! their counterpart in hyperbolic functions, the logarithmic series of K, and sums for `R_F`.

use crate::long::{Long, PI, long};
use crate::search::{Case, Draw, keeps_its_promise, worse};
use mechanics::elliptic::{carlson_rf, jacobi, quarter_period};

const EPS: f64 = f64::EPSILON;
/// Terms of the series: of q, at most e^−π, and of a parameter that is at most one half.
const NOMES: i32 = 26;
const POWERS: i32 = 110;

/// The logarithm of a number of any size.
fn ln(x: Long) -> Long {
    let tiny = 2_f64.powi(200);
    if x < long(1e-200) { (x * tiny).ln() - long(2.0).ln() * 200.0 } else { x.ln() }
}

/// K for the parameter and its complement, in powers of the one that is at most one half.
fn quarter(parameter: Long, complement: Long) -> Long {
    let mut sum = long(0.0);
    let (mut coefficient, mut power) = (long(1.0), long(1.0));
    if complement > long(0.5) {
        for n in 0..POWERS {
            sum = sum + coefficient * coefficient * power;
            power = power * parameter;
            coefficient = coefficient * f64::from(2 * n + 1) / f64::from(2 * n + 2);
        }
        return sum * PI * 0.5;
    }
    let mut logarithm = long(2.0).ln() * 2.0 - ln(complement) * 0.5;
    for n in 0..POWERS {
        sum = sum + coefficient * coefficient * power * logarithm;
        power = power * complement;
        coefficient = coefficient * f64::from(2 * n + 1) / f64::from(2 * n + 2);
        logarithm = logarithm - long(2.0) / (f64::from(2 * n + 1) * f64::from(2 * n + 2));
    }
    sum
}

fn hyperbolic(x: Long) -> (Long, Long) {
    let falling = (-x.abs()).exp();
    let below = falling * falling + 1.0;
    let tanh = (long(1.0) - falling * falling) / below;
    (if x < long(0.0) { -tanh } else { tanh }, falling * 2.0 / below)
}

/// sn, cn, dn.
fn judge(u: f64, complement: f64) -> [Long; 3] {
    let (c, m) = (long(complement), long(1.0) - complement);
    let u = long(u);
    if complement == 0.0 {
        let (tanh, sech) = hyperbolic(u);
        return [tanh, sech, sech];
    }
    if complement == 1.0 {
        let (sin, cos) = u.sin_cos();
        return [sin, cos, long(1.0)];
    }
    let (k, quarter_u, other) = (m.sqrt(), quarter(m, c), quarter(c, m));
    let halves = (u / (quarter_u * 2.0)).rounded().round();
    let rest = u - quarter_u * (2.0 * halves);
    let sign = if halves.rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 };
    let [mut sn, mut cn, mut dn] = [long(0.0); 3];
    if complement > 0.5 {
        let x = PI * rest / (quarter_u * 2.0);
        let root = (-(PI * other / (quarter_u * 2.0))).exp(); // of the nome
        let mut odd = root;
        let mut even = root * root;
        for n in 0..NOMES {
            let (sin, cos) = (x * f64::from(2 * n + 1)).sin_cos();
            sn = sn + odd / (long(1.0) - odd * odd) * sin;
            cn = cn + odd / (odd * odd + 1.0) * cos;
            dn = dn + even / (even * even + 1.0) * (x * f64::from(2 * n + 2)).sin_cos().1;
            odd = odd * root * root;
            even = even * root * root;
        }
        let whole = PI * 2.0 / quarter_u;
        return [sn * whole / k * sign, cn * whole / k * sign, dn * whole + PI / (quarter_u * 2.0)];
    }
    let (x, step) = (PI * rest / (other * 2.0), PI * quarter_u / other);
    for n in 0..NOMES {
        for side in if n == 0 { &[1.0][..] } else { &[1.0, -1.0] } {
            let (tanh, sech) = hyperbolic(x - step * (side * f64::from(n)));
            let alternating = if n % 2 == 0 { 1.0 } else { -1.0 };
            sn = sn + tanh * alternating;
            cn = cn + sech * alternating;
            dn = dn + sech;
        }
    }
    let whole = PI / (other * 2.0);
    [sn * whole / k * sign, cn * whole / k * sign, dn * whole]
}

fn complement(draw: &mut Draw<'_>) -> f64 {
    match draw.below(8) {
        0 => draw.one_of(&[0.0, 1.0, 5e-324, f64::MIN_POSITIVE, 1.0 - EPS / 2.0, 0.5]),
        1 => 1.0 - draw.decades(1e-16, 0.5),
        2 => draw.beside(0.5).min(1.0),
        3 => draw.decades(1e-320, 1e-20),
        4 => draw.between(0.0, 1.0),
        _ => draw.decades(1e-20, 1.0),
    }
}

#[test]
fn sn_cn_and_dn_are_good_to_a_few_units_of_one_and_the_roundings_of_a_large_argument() {
    keeps_its_promise("jacobi", 4000, &["hyperbolic", "small argument", "up to K", "beyond K"], |draw| {
        let complement = complement(draw);
        let quarter = quarter_period(complement).min(1e3);
        let u = match draw.below(6) {
            0 => draw.signed(1e-320, 1e-5),
            1 => {
                let n = draw.below(9) as f64 - 4.0;
                draw.beside(n * quarter)
            }
            2 => draw.signed(1.0, 1e8) * quarter,
            _ => quarter * draw.between(-1.0, 1.0),
        };
        let (truth, found) = (judge(u, complement), jacobi(u, complement));
        let error = (0..3).map(|n| (truth[n] - found[n]).abs().rounded()).fold(0.0, worse);
        let error = if found.iter().all(|x| x.is_finite()) { error } else { f64::INFINITY };
        let way = match (complement, u.abs() <= quarter) {
            (0.0, _) => "hyperbolic",
            _ if u.abs() < 1e-9 => "small argument",
            (_, true) => "up to K",
            (_, false) => "beyond K",
        };
        let beyond = if u.abs() <= quarter { 0.0 } else { u.abs() };
        let ratio = error / (1e-15 * (1.0 + beyond));
        Some(Case { ratio, way, said: format!("jacobi({u:?}, {complement:?}) = {found:?}, error {error:e}") })
    });
}

#[test]
fn the_quarter_period_is_good_to_a_few_units_in_the_last_place() {
    keeps_its_promise("quarter period", 4000, &["separatrix", "circular", "hyperbolic"], |draw| {
        let complement = complement(draw);
        let (found, c) = (quarter_period(complement), long(complement));
        if complement == 0.0 {
            let ratio = if found == f64::INFINITY { 0.0 } else { f64::INFINITY };
            return Some(Case { ratio, way: "separatrix", said: format!("{found:?}") });
        }
        let truth = quarter(long(1.0) - complement, c);
        let error = truth.off(found);
        let way = if complement > 0.5 { "circular" } else { "hyperbolic" };
        let said = format!("K({complement:?}) = {found:?}, error {error:e}");
        Some(Case { ratio: error / 1e-15, way, said })
    });
}

/// ½∫dt/√((t+x)(t+y)(t+z)) by sums of equal steps of ln t, exact to e^{−2π²/step}; of numbers between 1e-110 and one.
fn by_sums(arguments: [f64; 3]) -> Long {
    const STEP: f64 = 0.375;
    let smallest = arguments.iter().copied().filter(|&x| x > 0.0).fold(1.0, f64::min);
    let (first, last) = (((smallest.ln() - 90.0) / STEP) as i32, (90.0 / STEP) as i32);
    let (ratio, mut t) = (long(STEP).exp(), long(f64::from(first) * STEP).exp());
    let mut sum = long(0.0);
    for _ in first..=last {
        let product = arguments.iter().fold(long(1.0), |product, &x| product * (t + x));
        sum = sum + t / product.sqrt();
        t = t * ratio;
    }
    sum * (0.5 * STEP)
}

#[test]
fn carlsons_integral_is_good_to_a_few_units_in_the_last_place_at_any_size() {
    keeps_its_promise("Carlson's integral", 400, &["tiny", "huge", "between"], |draw| {
        let mut arguments = [1.0; 3];
        for argument in &mut arguments[1..] {
            *argument = match draw.below(4) {
                0 => draw.beside(1.0).clamp(0.5, 1.0),
                1 => draw.between(0.0, 1.0),
                _ => draw.decades(1e-110, 1.0),
            };
        }
        if draw.below(4) == 0 {
            arguments[1] = 0.0;
        }
        if arguments.iter().filter(|&&x| x == 0.0).count() > 1 {
            return None;
        }
        let [shift, power] = [draw.below(3), draw.below(1070)];
        arguments.rotate_left(shift);
        // Powers of four scale the arguments exactly, and the integral by powers of two.
        let power = power as i32 - 560;
        let half = 2_f64.powi(power);
        let scaled = arguments.map(|x| x * half * half);
        let exact = scaled.iter().zip(arguments).all(|(s, x)| s.is_finite() && s / half / half == x);
        if !exact {
            return None;
        }
        let (truth, found) = (by_sums(arguments), carlson_rf(scaled[0], scaled[1], scaled[2]) * half);
        let error = truth.off(found);
        let way = match scaled.iter().copied().fold(0.0, f64::max) {
            x if x < 1e-250 => "tiny",
            x if x > 1e300 => "huge",
            _ => "between",
        };
        Some(Case { ratio: error / 1.5e-15, way, said: format!("{scaled:?}: {found:?}, error {error:e}") })
    });
}

#[test]
fn functions_know_their_ends() {
    // For y and z far below x it is ln(4√x/(√y + √z))/√x · (1 + ...): sizes that no common scale brings into one range.
    for (x, y, z) in [(1e308, 1e-308, 1e-308), (1e300, 5e-324, 1e-300), (1e10, 1e-300, 0.0)] {
        let expected = long(x).sqrt().ln() + long(16.0).ln() * 0.5
            - (long(y).sqrt() * 0.5 + long(z).sqrt() * 0.5).ln()
            - long(2.0).ln();
        let found = carlson_rf(x, y, z) * x.sqrt();
        assert!(
            (expected - found).abs().rounded() < 1.5e-15 * found,
            "{x:e} {y:e} {z:e}: {found} {expected:?}"
        );
    }
    // The smallest numbers there are: one, two and three times 2^−1074.
    let [x, y, z] = [1, 2, 3].map(f64::from_bits);
    let found = carlson_rf(x, y, z) * 2_f64.powi(-537);
    assert!((by_sums([1.0, 2.0, 3.0]) - found).abs().rounded() < 1.5e-15 * found, "{found}");
    assert_eq!(carlson_rf(f64::MAX, f64::MAX, f64::MAX), f64::MAX.sqrt().recip());
    assert_eq!(carlson_rf(1.0, 2.0, f64::INFINITY), 0.0);
    assert!(carlson_rf(f64::INFINITY, f64::NAN, 1.0).is_nan());
    assert_eq!(carlson_rf(0.0, 0.0, 1.0), f64::INFINITY);
    assert!(carlson_rf(-1.0, 1.0, 1.0).is_nan() && carlson_rf(f64::NAN, 1.0, 1.0).is_nan());
    for outside in [-0.1, -1e-300, 1.0_f64.next_up(), 1.5, f64::NAN] {
        assert!(quarter_period(outside).is_nan() && jacobi(0.3, outside).iter().all(|x| x.is_nan()));
    }
}

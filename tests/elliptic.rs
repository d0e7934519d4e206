//! The elliptic functions against their differential equations, identities and integrals.

use approx::assert_relative_eq;
use mechanics::elliptic::{carlson_rf, jacobi, quarter_period};
use mechanics::integrate::Dop853;
use std::f64::consts::FRAC_PI_2;

/// Complementary parameters from the circular to the hyperbolic end.
fn complements() -> impl Iterator<Item = f64> {
    (0..=18).map(|exponent| 10_f64.powi(-exponent)).chain([0.75, 0.5, 0.25])
}

/// The trapezoidal rule for `∫₀^{π/2} (1 − k² sin²)^{−1/2}` converges geometrically, since the integrand is periodic.
fn quarter_by_sums(complement: f64) -> f64 {
    let steps = 400;
    let sum: f64 = (0..steps)
        .map(|n| {
            let (sin, cos) = (FRAC_PI_2 * (f64::from(n) + 0.5) / f64::from(steps)).sin_cos();
            (cos * cos + complement * sin * sin).sqrt().recip()
        })
        .sum();
    sum * FRAC_PI_2 / f64::from(steps)
}

#[test]
fn the_functions_satisfy_their_differential_equations() {
    for complement in complements() {
        let parameter = 1.0 - complement;
        let rates = |_: f64, &[s, c, d]: &[f64; 3]| [c * d, -s * d, -parameter * s * c];
        for u in [0.1, 0.7, 1.5] {
            let end = Dop853::new(1e-14).unwrap().solve(rates, 0.0, [0.0, 1.0, 1.0], u).unwrap().state;
            for (found, judge) in jacobi(u, complement).into_iter().zip(end) {
                assert_relative_eq!(found, judge, epsilon = 2e-14);
            }
        }
    }
}

#[test]
fn squares_add_up_and_the_signs_are_right() {
    for complement in complements() {
        let quarter = quarter_period(complement);
        for n in -40..=40 {
            let u = quarter * f64::from(n) / 10.0;
            let [s, c, d] = jacobi(u, complement);
            assert_relative_eq!(s * s + c * c, 1.0, epsilon = 1e-15);
            // dn² = cn² + k'² sn²: nothing cancels.
            assert_relative_eq!(d * d, c * c + complement * s * s, max_relative = 2e-13 * (1.0 + u.abs()));
            let [minus_s, minus_c, minus_d] = jacobi(-u, complement);
            assert_eq!((minus_s, minus_c, minus_d), (-s, c, d));
        }
        let [s, c, d] = jacobi(quarter, complement);
        assert_relative_eq!(s, 1.0, max_relative = 1e-15);
        assert!(c.abs() < 1e-14);
        assert_relative_eq!(d, complement.sqrt(), max_relative = 1e-12);
    }
}

#[test]
fn the_quarter_period_is_its_integral_and_its_logarithm() {
    for complement in [1.0, 0.75, 0.5, 0.1, 0.01] {
        assert_relative_eq!(quarter_period(complement), quarter_by_sums(complement), max_relative = 1e-14);
    }
    for exponent in [8, 12, 100, 300] {
        // K → ln(4/k') + (ln(4/k') − 1) k'²/4.
        let complement = 10_f64.powi(-exponent);
        let log = (4.0 / complement.sqrt()).ln();
        let expected = log + (log - 1.0) * complement / 4.0;
        assert_relative_eq!(quarter_period(complement), expected, max_relative = 1e-15);
    }
    assert_eq!(quarter_period(0.0), f64::INFINITY);
    assert!(
        quarter_period(-0.1).is_nan() && quarter_period(1.1).is_nan() && quarter_period(f64::NAN).is_nan()
    );
    for outside in [1.5, 1.0_f64.next_up(), -1e-300] {
        assert!(jacobi(0.3, outside).iter().all(|x| x.is_nan()));
    }
}

#[test]
fn carlsons_integral_inverts_the_functions() {
    let mut random = fastrand::Rng::with_seed(1);
    for complement in complements() {
        for _ in 0..50 {
            let u = quarter_period(complement).min(20.0) * random.f64();
            let [s, c, d] = jacobi(u, complement);
            assert_relative_eq!(
                s * carlson_rf(c * c, d * d, 1.0),
                u,
                max_relative = 1e-12 + 1e-15 / (c * c + d * d)
            );
        }
    }
    assert_relative_eq!(carlson_rf(0.0, 1.0, 1.0), FRAC_PI_2, max_relative = 1e-15);
    assert_relative_eq!(carlson_rf(2.0, 2.0, 2.0), 0.5_f64.sqrt(), max_relative = 1e-15);
    assert_relative_eq!(carlson_rf(0.0, 0.5, 1.0), quarter_period(0.5), max_relative = 1e-15);
    assert_eq!(carlson_rf(0.0, 0.0, 1.0), f64::INFINITY);
    assert!(carlson_rf(-1.0, 1.0, 1.0).is_nan() && carlson_rf(f64::NAN, 1.0, 1.0).is_nan());
}

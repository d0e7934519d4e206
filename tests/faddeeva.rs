//! Faddeeva's function, against 32 digits, its differential equation and its symmetries.

use mechanics::faddeeva::faddeeva;
use nalgebra::Complex;
use serde_json::Value;
use std::f64::consts::PI;

/// A few units in the last place of |w|.
const ROUNDING: f64 = 1.5e-15;

#[test]
fn thirty_two_digits_are_met() {
    let file: Value = serde_json::from_str(include_str!("data/faddeeva.json")).unwrap();
    let rows = file["values"].as_array().unwrap();
    assert_eq!(rows.len(), 120);
    let mut worst = 0.0_f64;
    for row in rows {
        let number = |n: usize| row[n].as_f64().unwrap();
        let decimal = |n: usize| row[n].as_str().unwrap().parse::<f64>().unwrap();
        let z = Complex::new(number(0), number(1));
        let expected = Complex::new(decimal(2), decimal(3));
        let error = (faddeeva(z) - expected).norm() / expected.norm();
        worst = worst.max(error);
        assert!(error < ROUNDING, "{z}: {} for {expected}, {error:e}", faddeeva(z));
    }
    println!("largest error {worst:e}");
}

#[test]
fn it_is_an_integral_along_a_level_path_and_never_longer_than_one() {
    // eq:faddeeva-integral, by Simpson's rule from 0 to 7, where e^{−49} is left.
    let steps = 4000;
    let step = 7.0 / f64::from(steps);
    let mut random = fastrand::Rng::with_seed(15);
    for _ in 0..200 {
        let z = Complex::new(12.0 * random.f64() - 6.0, 6.0 * random.f64());
        let integrand = |l: f64| (Complex::<f64>::i() * z * (2.0 * l) - l * l).exp();
        let weight = |n: i32| if n == 0 || n == steps { 1.0 } else { 2.0 + 2.0 * f64::from(n % 2) };
        let sum: Complex<f64> = (0..=steps).map(|n| integrand(step * f64::from(n)) * weight(n)).sum();
        let expected = sum * (step / 3.0 * 2.0 / PI.sqrt());
        assert!((faddeeva(z) - expected).norm() < 1e-9, "{z}: {} for {expected}", faddeeva(z));
        assert!(faddeeva(z).norm() <= 1.0, "{z}");
    }
}

#[test]
fn no_size_and_no_place_gives_what_is_not_a_number() {
    let sizes = [0.0, 1e-300, 1e-12, 0.25, 0.5, 1.0, 20.0, 39.9, 40.1, 1e3, 1.005e6, 1e9, 1e30, 1e200];
    for x in sizes {
        for y in sizes {
            let (here, mirrored) = (faddeeva(Complex::new(x, y)), faddeeva(Complex::new(-x, y)));
            assert!(here.is_finite() && here.norm() <= 1.0 && here == mirrored.conj(), "{x} {y}: {here}");
        }
    }
}

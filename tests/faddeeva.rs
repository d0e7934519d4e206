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
fn mirror_images_are_conjugate_and_opposites_add_up_to_a_gaussian() {
    let mut random = fastrand::Rng::with_seed(91);
    for _ in 0..1000 {
        let z = Complex::new(8.0 * random.f64() - 4.0, 4.0 * random.f64() - 1.0);
        let mirrored = faddeeva(-z.conj()).conj();
        assert_eq!(faddeeva(z), mirrored);
        let sum = faddeeva(z) + faddeeva(-z);
        let gauss = 2.0 * (-z * z).exp();
        let size = gauss.norm() + faddeeva(z).norm() + faddeeva(-z).norm();
        // The Gaussian itself carries the rounding of z², twenty units of it.
        assert!((sum - gauss).norm() < 40.0 * ROUNDING * size, "{z}: {sum} {gauss}");
    }
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
fn the_nodes_of_the_rule_leave_no_trace() {
    // Along a line close above the real axis the choice of the rule changes every quarter of its spacing,
    // √(π/12); the function, of slope at most 2/√π, must not jump.
    let spacing = (PI / 12.0).sqrt();
    for height in [0.0, 1e-14, 1e-6, 0.1, 0.3] {
        for quarter in 0..60 {
            let x = 0.25 * f64::from(quarter) * spacing;
            let step = 1e-9;
            let (before, after) = (Complex::new(x - step, height), Complex::new(x + step, height));
            let jump = (faddeeva(after) - faddeeva(before)).norm();
            assert!(jump < 3.0 * step, "{x} {height}: {jump:e}");
        }
    }
}

#[test]
fn the_differential_equation_holds() {
    // w′ = −2zw + 2i/√π, the slope by a difference of fourth order.
    let mut random = fastrand::Rng::with_seed(92);
    for _ in 0..300 {
        let z = Complex::new(12.0 * random.f64() - 6.0, 8.0 * random.f64());
        let h = 2e-3;
        let slope = (8.0 * (faddeeva(z + h) - faddeeva(z - h))
            - (faddeeva(z + 2.0 * h) - faddeeva(z - 2.0 * h)))
            / (12.0 * h);
        let expected = -2.0 * z * faddeeva(z) + Complex::new(0.0, 2.0 / PI.sqrt());
        assert!((slope - expected).norm() < 2e-9, "{z}: {slope} {expected}");
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

#[test]
fn far_away_it_is_the_field_of_a_pole() {
    for z in [
        Complex::new(1e8, 0.0),
        Complex::new(-3e20, 1e20),
        Complex::new(0.0, 1e80),
        Complex::new(1e100, 1e-300),
    ] {
        let pole = Complex::new(0.0, 1.0 / PI.sqrt()) / z;
        assert!((faddeeva(z) - pole).norm() < 2.0 * ROUNDING * pole.norm(), "{z}: {} {pole}", faddeeva(z));
    }
}

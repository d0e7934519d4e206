//! Faddeeva's function.

use crate::long::{Long, PI, long};
use crate::search::{Case, Draw, keeps_its_promise};
use crate::taylor::System;
use mechanics::faddeeva::faddeeva;
use nalgebra::Complex;

/// The documented error.
const UNITS: f64 = 8.0 * f64::EPSILON;

type Point = [Long; 2];

fn times([a, b]: Point, [c, d]: Point) -> Point {
    [a * c - b * d, a * d + b * c]
}

fn over(a: Point, [c, d]: Point) -> Point {
    let size = c * c + d * d;
    times(a, [c / size, -d / size])
}

/// w by its asymptotic series, i/√π z (1 + 1/2z² + 3/4z⁴ + …), for |z| of 8 and more.
fn far(z: Point) -> Point {
    let square = times(z, z);
    let mut term = [long(1.0), long(0.0)];
    let mut sum = term;
    for n in 0..60 {
        term = over(term.map(|part| part * (f64::from(2 * n + 1) * 0.5)), square);
        if term[0].abs() + term[1].abs() < long(1e-33) {
            break;
        }
        sum = [sum[0] + term[0], sum[1] + term[1]];
    }
    over(times([long(0.0), long(1.0) / PI.sqrt()], sum), z)
}

/// w in the upper half-plane: near zero by w′ = −2zw + 2i/√π along the ray from there, on which the solution does not
/// grow; where it would, inward along the ray from far away; and far away by the asymptotic series.
fn truth(z: Complex<f64>) -> Complex<Long> {
    let z = [z.re, z.im].map(long);
    let size = (z[0] * z[0] + z[1] * z[1]).sqrt();
    if size > long(9.0) {
        let [re, im] = far(z);
        return Complex::new(re, im);
    }
    let [none, one] = [0.0, 1.0].map(long);
    let outward = z[1] * z[1] - z[0] * z[0] < long(8.0);
    // z = u s with s from 0 to 1, or from 9/|z| to 1.
    let (first, start) =
        if outward { (none, [one, none]) } else { (long(9.0) / size, far(z.map(|part| part * 9.0 / size))) };
    let (mut system, [re, im, s]) = System::new();
    let [square_re, square_im] = times(z, z);
    let (along_re, along_im) = (system.product(s, re), system.product(s, im));
    let unit = system.constant(one);
    let source = long(2.0) / PI.sqrt();
    system.rate(re, &[(square_re * -2.0, along_re), (square_im * 2.0, along_im), (-source * z[1], unit)]);
    system.rate(im, &[(square_re * -2.0, along_im), (square_im * -2.0, along_re), (source * z[0], unit)]);
    system.rate(s, &[(one, unit)]);
    let end = system.sample(&[start[0], start[1], first], &[one - first]).remove(0);
    Complex::new(end[0], end[1])
}

fn distance(ours: Complex<f64>, truth: Complex<Long>) -> f64 {
    (truth.re - ours.re).rounded().hypot((truth.im - ours.im).rounded())
}

fn anywhere(draw: &mut Draw<'_>) -> Complex<f64> {
    // The nodes of the two rules are whole multiples of half of this.
    let spacing = (std::f64::consts::PI / 12.0).sqrt();
    let x = match draw.below(3) {
        0 => {
            let quarters = draw.below(60) as f64;
            draw.beside(0.25 * spacing * quarters)
        }
        1 => draw.between(0.0, 9.0),
        _ => draw.decades(1e-20, 1e12),
    };
    let y = match draw.below(5) {
        0 => 0.0,
        1 => draw.beside(x),
        2 => draw.beside(std::f64::consts::PI / spacing),
        3 => draw.between(0.0, 9.0),
        _ => draw.decades(1e-20, 1e12),
    };
    Complex::new(x * draw.one_of(&[-1.0, 1.0]), y)
}

#[test]
fn w_has_its_digits_in_the_upper_half_plane() {
    let ways = ["beyond the nodes", "either rule", "no residue", "pole only", "the rule between"];
    keeps_its_promise("faddeeva", 4000, &ways, |draw| {
        let z = anywhere(draw);
        let truth = truth(z);
        let ours = faddeeva(z);
        let size = truth.re.rounded().hypot(truth.im.rounded());
        let whole = z.im < z.re.abs();
        let way = match (z.im >= 6.13996, z.norm() > 1e9, whole) {
            (_, true, _) => "pole only",
            (true, ..) => "no residue",
            (_, _, true) if z.re.abs() >= 40.0 => "beyond the nodes",
            (_, _, true) => "either rule",
            (_, _, false) => "the rule between",
        };
        let said = format!("{z:?}: {ours:?} for {truth:?}");
        Some(Case { ratio: distance(ours, truth) / size / UNITS, way, said })
    });
}

#[test]
fn in_the_lower_half_plane_it_is_the_gaussian_less_the_mirror_image() {
    keeps_its_promise("faddeeva below", 4000, &["grown", "small"], |draw| {
        let above = anywhere(draw);
        let square = times([above.re, above.im].map(long), [above.re, above.im].map(long));
        if above.im == 0.0 || square[0].rounded() < -700.0 || above.norm() > 1e7 {
            return None;
        }
        let (sin, cos) = (-square[1]).sin_cos();
        let gauss = (-square[0]).exp() * 2.0;
        let truth = truth(above);
        let below = Complex::new(gauss * cos - truth.re, gauss * sin - truth.im);
        let ours = faddeeva(-above);
        let grown = gauss.rounded() * (1.0 + above.norm_sqr());
        let size = grown + truth.re.rounded().hypot(truth.im.rounded());
        let way = if gauss.rounded() > 1.0 { "grown" } else { "small" };
        let said = format!("{:?}: {ours:?} for {below:?}", -above);
        Some(Case { ratio: distance(ours, below) / size / UNITS, way, said })
    });
    for (z, expected) in [
        (Complex::new(0.0, -27.0), Complex::new(f64::INFINITY, 0.0)),
        (Complex::new(0.0, -1e200), Complex::new(f64::INFINITY, 0.0)),
        (Complex::new(1.4e154, 1.0), Complex::new(2.878_518_283_406_9e-309, 4.029_925_9e-155)),
    ] {
        let ours = faddeeva(z);
        let close = |a: f64, b: f64| a == b || (a - b).abs() < 1e-7 * b.abs();
        assert!(close(ours.re, expected.re) && close(ours.im, expected.im), "{z}: {ours}");
    }
}

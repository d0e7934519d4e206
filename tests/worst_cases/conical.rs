//! The conical functions, by stepping Legendre's equation out from the middle.

use crate::long::{Long, long};
use crate::search::{Case, Draw, keeps_its_promise};
use crate::taylor::System;
use mechanics::conical::Conical;

/// Even, its slope, odd, its slope at X = tanh y, by series in y: there e″ = a(1 − X²)e, and nothing is singular.
pub(crate) fn judge(a: f64, y: Long, gap: Long) -> [Long; 4] {
    let (mut system, [x, h, e, de, o, d_o]) = System::new();
    let [one, a] = [long(1.0), long(a)];
    system.rate(x, &[(one, h)]);
    let xh = system.product(x, h);
    system.rate(h, &[(long(-2.0), xh)]); // of 1 − X²
    for (value, slope) in [(e, de), (o, d_o)] {
        let bend = system.product(h, value);
        system.rate(value, &[(one, slope)]);
        system.rate(slope, &[(a, bend)]);
    }
    let zero = long(0.0);
    let end = system.sample(&[zero, one, one, zero, zero, one], &[y]).remove(0);
    let square = gap * (long(2.0) - gap);
    [end[2], end[3] / square, end[4], end[5] / square]
}

/// The largest relative error of the four, at X of this sign.
fn error(a: f64, x: f64, gap: f64) -> (f64, [f64; 4]) {
    let far = if x.abs() <= 0.5 { long(1.0) - x.abs() } else { long(gap) };
    let y = if x == 0.0 { long(0.0) } else { ((long(2.0) - far) / far).ln() * 0.5 };
    // The logarithm of nearly one has no digits of its own to spare: artanh x by its series.
    let y = if x.abs() < 1e-3 { artanh(x.abs()) } else { y };
    let truth = judge(a, y, far);
    let v = Conical::new(a).at(x, gap);
    let sign = if x < 0.0 { -1.0 } else { 1.0 };
    let ours = [v.even, sign * v.even_slope, sign * v.odd, v.odd_slope];
    let relative = |n: usize| ((truth[n] - ours[n]).abs() / (truth[n].abs() + 1e-320)).rounded();
    ((0..4).map(relative).fold(0.0, f64::max), ours)
}

fn artanh(x: f64) -> Long {
    let square = long(x) * x;
    (0..8).rev().fold(long(0.0), |sum, n| sum * square + long(1.0) / f64::from(2 * n + 1)) * x
}

/// X and its gap: anywhere, at the border between the two series, or near an end.
fn place(draw: &mut Draw<'_>) -> (f64, f64) {
    let sign = draw.one_of(&[-1.0, 1.0]);
    match draw.below(4) {
        0 => {
            let x = draw.between(0.0, 1.0 - 1e-9);
            (sign * x, 1.0 - x)
        }
        1 => {
            let x = draw.beside(0.5).clamp(0.0, 1.0 - 1e-9);
            (sign * x, 1.0 - x)
        }
        2 => {
            let x = draw.decades(1e-300, 0.5);
            (sign * x, 1.0 - x)
        }
        _ => {
            let gap = draw.decades(1e-300, 0.499);
            (sign * (1.0 - gap), gap)
        }
    }
}

#[test]
fn conical_functions_have_all_their_digits() {
    keeps_its_promise("conical", 300, &["about the centre", "near an end"], |draw| {
        let a = if draw.below(2) == 0 { draw.between(1.0, 2.0) } else { draw.decades(1e-10, 2.0) };
        let (x, gap) = place(draw);
        let (error, ours) = error(a, x, gap);
        let (way, promise) = if x.abs() <= 0.5 { ("about the centre", 4.0) } else { ("near an end", 30.0) };
        let said = format!("a {a:?}, X {x:?}, gap {gap:?}: {ours:?}");
        Some(Case { ratio: error / (promise * f64::EPSILON), way, said })
    });
}

#[test]
fn the_worst_case_found_is_next_to_the_border_of_the_two_series() {
    // Of sixty thousand: 20.3 units.
    let (x, gap) = (0.500_000_000_239_697_3, 0.499_999_999_760_302_74);
    let (error, _) = error(1.963_229_380_495_534_3, x, gap);
    assert!(error < 21.0 * f64::EPSILON, "{error:e}");
}

//! The curves of the free tops, read back from the SVG, lie on formulas that are
//! written out here.

use crate::{curve, lies_on};
use std::f64::consts::{PI, TAU};

#[test]
fn the_height_of_the_normal_is_a_cosine() {
    for (ratio, name) in [(0.2, "0.2"), (0.49, "0.49"), (0.5, "0.5"), (0.51, "0.51")] {
        let tangent: f64 = 1.0 / (2.0 * ratio);
        let sine = tangent * tangent / (1.0 + tangent * tangent);
        let height = |turns: f64| 1.0 - sine + sine * (TAU * turns).cos();
        lies_on("threshold", &format!("whole-{name}"), height);
        if ratio > 0.4 {
            lies_on("threshold", &format!("part-{name}"), height);
        }
    }
}

#[test]
fn the_bias_is_an_inverse_sine() {
    lies_on("bias", "probability", |degrees| {
        let cotangent = 1.0 / degrees.to_radians().tan();
        if degrees <= 45.0 { 0.9999999 } else { 0.5 + (cotangent * cotangent).asin() / PI }
    });
}

#[test]
fn the_station_nods_faster_than_twice() {
    lies_on("nodding", "in-the-room", |turns| turns * (4.0 + 0.4_f64.powi(2)).sqrt());
    lies_on("nodding", "on-board", |turns| turns);
}

#[test]
fn the_tangent_falls_and_rises_exponentially_and_as_a_power_of_the_spin() {
    for (ratio, name) in [(2.0, "2"), (1.0, "1"), (0.5, "0.5")] {
        lies_on("tangent", &format!("ratio-{name}"), |t: f64| 0.3 * (-(1.0 - 1.0 / ratio) * t).exp());
    }
    for (ratio, name) in [(2.0, "2"), (1.5, "1.5"), (1.0, "1"), (0.5, "0.5")] {
        lies_on("spin-tangent", &format!("ratio-{name}"), |spin: f64| spin.powf(ratio - 1.0));
    }
}

#[test]
fn the_spiral_makes_three_turns() {
    let spiral = curve("wobble-turns", "spiral").values();
    let mut turned = 0.0;
    for pair in spiral.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        if a.0.hypot(a.1) > 0.003 && b.0.hypot(b.1) > 0.003 {
            turned += (a.0 * b.1 - a.1 * b.0).atan2(a.0 * b.0 + a.1 * b.1);
        }
    }
    // The size is e^{−Ct/I₁} and the phase 3(1 − e^{−Ct/I₃}) turns, with I₃ = 2I₁; the rest lies within half
    // a pixel of the centre.
    let turns = turned / TAU;
    let expected = 3.0 * (1.0 - (0.5_f64 / 160.0).sqrt());
    assert!((turns - expected).abs() < 0.15, "{turns} turns for {expected}");
}

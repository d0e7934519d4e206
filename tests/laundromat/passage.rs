//! A slow passage through the resonance without damping: Fresnel's integral, by Simpson's rule, against the closed
//! form of the ramp, which is Faddeeva's function.

use super::WASHER;
use crate::common::any;
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use nalgebra::Complex;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// The integral of e^{iu²/2} from long ago to `end`: half of the whole, √(2π) e^{iπ/4}, is on each side of zero.
fn fresnel(end: f64) -> Complex<f64> {
    let steps = 20_000;
    let h = end / f64::from(steps);
    let value = |n: u32| Complex::from_polar(1.0, 0.5 * (h * f64::from(n)).powi(2));
    let weight = |n: u32| match n {
        0 => 1.0,
        n if n == steps => 1.0,
        n => 2.0 + 2.0 * f64::from(n % 2),
    };
    let sum: Complex<f64> = (0..=steps).map(|n| value(n) * weight(n)).sum();
    Complex::from_polar((0.5 * PI).sqrt(), FRAC_PI_4) + sum * (h / 3.0)
}

/// Where that integral is longest, eq:ramp-farthest by halving, and how long it is over the whole.
fn farthest() -> (f64, f64) {
    let along = |u: f64| (fresnel(u) * Complex::from_polar(1.0, -0.5 * u * u)).re;
    let [mut low, mut high] = [1.5, 2.5];
    assert!(along(low) > 0.0 && along(high) < 0.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if along(middle) > 0.0 { low = middle } else { high = middle }
    }
    (low, fresnel(low).norm() / (2.0 * PI).sqrt())
}

/// The largest swing over b of the chapter's machine without a damper, and the spin over ω₀ where it comes.
fn largest(acceleration: f64) -> (f64, f64) {
    let machine = Machine::new(MachineParameters { damping: 0.0, spin: 0.0, ..WASHER }).expect("a machine");
    let ramp = machine.ramp(acceleration * 100.0, Shaft::AT_REST).expect("a ramp");
    let swing = |root: f64| {
        let time = (1.0 + root * acceleration.sqrt()) / (10.0 * acceleration);
        ramp.at(time).expect("a state").position.norm() / machine.offset()
    };
    let [mut low, mut high] = [1.6, 2.8]; // by golden section
    while high - low > 1e-7 {
        let [a, b] = [0.618_034, 0.381_966].map(|part| high - part * (high - low));
        if swing(a) > swing(b) { high = b } else { low = a }
    }
    (swing(low), 1.0 + low * acceleration.sqrt())
}

#[test]
fn a_slow_passage_overshoots_by_what_fresnels_integral_says() {
    let (place, factor) = farthest();
    assert!((place - 2.157_427_7).abs() < 1e-7 && (factor - 1.170_659_2).abs() < 1e-7, "{place} {factor}");
    let left = |acceleration: f64| (FRAC_PI_2 / acceleration).sqrt();
    // The overshoot tends to it in proportion to √α, and the place in proportion to α.
    for acceleration in [1e-4_f64, 1e-6, 1e-8] {
        let root = acceleration.sqrt();
        let (swing, spin) = largest(acceleration);
        assert!((swing / left(acceleration) - factor).abs() < 0.65 * root, "{swing} at {acceleration}");
        assert!(((spin - 1.0) / root - place).abs() < 2e-2 * root + 1e-4, "{spin} at {acceleration}");
    }
}

#[test]
fn the_largest_swing_has_three_quarters_of_b_besides() {
    let (_, factor) = farthest();
    let mut before = f64::INFINITY;
    for acceleration in [1e-2_f64, 1e-4, 1e-6] {
        let (swing, _) = largest(acceleration);
        let beside = swing - factor * (FRAC_PI_2 / acceleration).sqrt();
        // What is left is of the order √α.
        let off = (beside - 0.75).abs();
        assert!(off < 0.3 * acceleration.sqrt() + 1e-7 && off < before, "{beside} at {acceleration}");
        before = off;
    }
    // eq:ramp-largest against what the text states.
    let text = 1.4672 / 0.02_f64.sqrt() + 0.75;
    assert!((largest(0.02).0 - 11.14).abs() < 0.005 && (text - 11.12).abs() < 0.005, "{}", largest(0.02).0);
    assert!((factor * FRAC_PI_2.sqrt() - 1.4672).abs() < 1e-5);
}

#[test]
fn what_a_passage_leaves_is_lewiss_amplitude() {
    let acceleration = 1e-6_f64;
    let machine = Machine::new(MachineParameters { damping: 0.0, spin: 0.0, ..WASHER }).expect("a machine");
    let ramp = machine.ramp(acceleration * 100.0, Shaft::AT_REST).expect("a ramp");
    let left = machine.offset() * (FRAC_PI_2 / acceleration).sqrt();
    // Long after, the swing beats about it with an amplitude that falls as the inverse of the time.
    for root in [10.0_f64, 30.0, 100.0] {
        let swing = ramp.at((1.0 + root * 1e-3) / (10.0 * acceleration)).expect("a state").position.norm();
        assert!((swing / left - 1.0).abs() < 0.5 / root, "{}", swing / left);
    }
}

#[test]
fn the_chapters_machine_stays_below_four_centimetres_from_33_and_below_six_with_a_tenth_of_the_damper_from_26()
 {
    // The largest swing, m, by Newton's law, to three times ω₀ and half a second more.
    let largest = |damping: f64, acceleration: f64| {
        let rates = |t: f64, &[x, y, vx, vy]: &[f64; 4]| {
            let (sin, cos) = (0.5 * acceleration * t * t).sin_cos();
            let (spin, push) = (acceleration * t, 0.5); // m a, kg·m
            // m a (φ̇² e^{iφ} − iφ̈ e^{iφ})
            let (px, py) = (spin * spin * cos + acceleration * sin, spin * spin * sin - acceleration * cos);
            let rate = |pull: f64, x: f64, v: f64| (push * pull - 3000.0 * x - damping * v) / 30.0;
            [vx, vy, rate(px, x, vx), rate(py, y, vy)]
        };
        let end = 30.0 / acceleration + 0.5;
        let times: Vec<f64> = (0..=4000).map(|n| end * f64::from(n) / 4000.0).collect();
        let (states, _) = Dop853::new(1e-10)
            .expect("a solver")
            .sample(any(rates), 0.0, [0.0; 4], &times)
            .expect("a motion");
        states.iter().map(|[x, y, ..]| x.hypot(*y)).fold(0.0, f64::max)
    };
    assert!(largest(90.0, 33.0) > 0.04 && largest(90.0, 33.4) < 0.04); // "a little over 33"
    assert!(largest(9.0, 25.5) > 0.06 && largest(9.0, 26.0) < 0.06); // "nearly 26"
}

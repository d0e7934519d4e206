//! Equations (32) and (33), and the orbit that one mode makes.

use super::linear::{numerical_modes, separated};
use super::{letters, washer};
use crate::common::any;
use crate::printed::corrected_holds_and_printed_fails;
use approx::assert_relative_eq;
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{Machine, Shaft};
use nalgebra::Complex;

const I: Complex<f64> = Complex::new(0.0, 1.0);

/// The start that excites one mode only: the steady motion plus a centre at `displacement` that turns at `rate`.
fn one_mode(machine: &Machine, displacement: Complex<f64>, rate: f64) -> Shaft {
    let amplitude = machine.steady().unwrap().amplitude();
    let root = Complex::new(-machine.damping_rate() / 2.0, rate);
    Shaft {
        position: amplitude + displacement,
        velocity: I * machine.spin() * amplitude + root * displacement,
    }
}

fn w1(machine: &Machine) -> f64 {
    let (w0, _, gamma, _) = letters(machine);
    (w0 * w0 - gamma * gamma / 4.0).sqrt()
}

/// The states of a simulation of the lab equation at the given times.
fn simulated(machine: &Machine, start: Shaft, times: &[f64]) -> Vec<Shaft> {
    let (states, _) = Dop853::new(1e-14)
        .unwrap()
        .sample(any(|t, y| machine.cartesian_rates(t, y)), 0.0, start.to_array(), times)
        .unwrap();
    states.into_iter().map(Shaft::from_array).collect()
}

#[test]
fn eq32_the_amplitudes_are_in_the_ratio_i_at_any_spin_and_the_printed_correction_is_wrong() {
    // At any spin: the library's shape of each mode, and the one that follows from the linearised equations alone.
    let mut fast = Vec::new();
    for machine in separated(32, 1000) {
        let (_, _, gamma, spin) = letters(&machine);
        for mode in machine.modes() {
            assert_eq!((mode.shape - I).norm().min((mode.shape + I).norm()), 0.0);
        }
        for (w, e0, d0) in numerical_modes(&machine) {
            let shape = d0 / e0;
            assert!((shape - I).norm().min((shape + I).norm()) < 1e-6, "{shape} at ω = {w}");
            // The source's high spin, in units of Γ/Ω, the size of its correction.
            if spin > 3.0 * machine.natural_frequency() && w.re > 0.0 {
                let correction = 1.0 - I * gamma / (2.0 * spin) - gamma * gamma / (8.0 * spin * w.re);
                let (corrected, printed) = (I, I / correction);
                fast.push((
                    (shape - corrected).norm() * spin / gamma,
                    (shape - printed).norm() * spin / gamma,
                ));
            }
        }
    }
    corrected_holds_and_printed_fails(fast, 1e-3, 0.4);
}

#[test]
fn eq33_angular_velocity_corrected_holds_and_printed_fails() {
    let machine = washer().with_damping(3.0).unwrap();
    let (_, _, gamma, spin) = letters(&machine);
    for branch in [1.0, -1.0] {
        let (small, rate) = (1e-6, spin + branch * w1(&machine));
        let steady = machine.steady().unwrap();
        let start = one_mode(&machine, steady.amplitude() * small, -branch * w1(&machine));
        let times: Vec<f64> = (1..40).map(|n| f64::from(n) * 0.05).collect();
        let simulated = simulated(&machine, start, &times);
        let cases = times.iter().zip(simulated).map(|(t, shaft)| {
            let theta_dot = shaft.to_polar().azimuth_rate;
            let (sin, cos) = (rate * t).sin_cos();
            let corrected = spin - small * (-gamma * t / 2.0).exp() * (rate * cos - gamma / 2.0 * sin);
            let printed = spin + small * rate.sin();
            ((theta_dot - corrected).abs() / (small * rate), (theta_dot - printed).abs() / (small * rate))
        });
        // Second order in the disturbance, 1e-6 of it, plus the simulation's error.
        corrected_holds_and_printed_fails(cases, 1e-4, 0.05);
    }
}

#[test]
fn the_centre_of_the_orbit_turns_backwards_or_forwards_at_w1() {
    let machine = washer();
    let (w0, _, gamma, spin) = letters(&machine);
    let w1 = w1(&machine);
    let steady = machine.steady().unwrap();
    for sense in [-1.0, 1.0] {
        let c = 0.3 * steady.radius(); // not small: the statement is exact
        let start = one_mode(&machine, c.into(), sense * w1);
        let times: Vec<f64> = (1..=40).map(|n| f64::from(n) * 0.02).collect();
        let mut turned = 0.0;
        let mut before = Complex::new(c, 0.0);
        for (t, shaft) in times.iter().zip(simulated(&machine, start, &times)) {
            let centre = shaft.position - steady.amplitude() * Complex::from_polar(1.0, spin * t);
            assert_relative_eq!(centre.norm(), c * (-gamma * t / 2.0).exp(), max_relative = 1e-9);
            turned += (centre / before).arg();
            before = centre;
        }
        let rate = turned / times[times.len() - 1];
        assert_relative_eq!(rate, sense * w1, max_relative = 1e-9);
        assert!((rate.abs() - w0).abs() > 0.1); // the source says ω₀
    }
}

#[test]
fn an_undamped_mode_fills_the_annulus_and_no_more() {
    let machine = washer().with_damping(0.0).unwrap();
    let steady = machine.steady().unwrap();
    let (r0, e0) = (steady.radius(), 0.2);
    for sense in [-1.0, 1.0] {
        let start = one_mode(&machine, steady.amplitude() * e0, sense * 10.0);
        let times: Vec<f64> = (0..4000).map(|n| f64::from(n) * 0.005).collect();
        let radii: Vec<f64> =
            simulated(&machine, start, &times).iter().map(|shaft| shaft.position.norm()).collect();
        let (least, most) = radii.iter().fold((f64::MAX, 0.0_f64), |(a, b), &r| (a.min(r), b.max(r)));
        assert!(least >= r0 * (1.0 - e0) * (1.0 - 1e-9) && most <= r0 * (1.0 + e0) * (1.0 + 1e-9));
        assert!(least < r0 * (1.0 - 0.99 * e0) && most > r0 * (1.0 + 0.99 * e0));
    }
}

#[test]
fn at_high_spin_the_disturbed_orbit_is_a_displaced_circle_for_a_while() {
    let machine = washer().with_spin(2000.0).unwrap(); // Ω = 200 ω₀
    let steady = machine.steady().unwrap();
    let displacement = 0.3 * steady.radius();
    let start = one_mode(&machine, displacement.into(), w1(&machine));
    let turn = std::f64::consts::TAU / machine.spin();
    let times: Vec<f64> = (0..=64).map(|n| f64::from(n) / 64.0 * turn).collect();
    for shaft in simulated(&machine, start, &times) {
        let around = (shaft.position - displacement).norm();
        // The centre moves ω₁ · 2π/Ω of its own radius.
        assert_relative_eq!(around, steady.radius(), max_relative = 0.02);
    }
}

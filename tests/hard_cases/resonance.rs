//! At resonance and one rounding beside it.

use super::{FEW_ULPS, machine};
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use nalgebra::Complex;

#[test]
fn undamped_resonance_grows_in_proportion_to_the_time() {
    let machine = machine(0.0, 1.0);
    assert!(machine.steady().is_err());
    let motion = machine.transient(Shaft::AT_REST).unwrap();
    for t in [1e-3_f64, 0.1, 1.0, 30.0, 1e4, 1e9] {
        // z = (i/2)(sin t − t e^{it})
        let exact = Complex::new(0.0, 0.5) * (t.sin() - t * Complex::from_polar(1.0, t));
        let shaft = motion.at(t).unwrap();
        assert!((shaft.position - exact).norm() < FEW_ULPS * t.max(1.0), "t = {t}: {}", shaft.position);
        let rate = Complex::new(0.0, 0.5) * (t.cos() - Complex::new(1.0, t) * Complex::from_polar(1.0, t));
        assert!((shaft.velocity - rate).norm() < FEW_ULPS * t.max(1.0), "t = {t}: {}", shaft.velocity);
    }
}

#[test]
fn transient_keeps_its_digits_as_the_spin_nears_resonance() {
    // Without damping, from rest: z = Z(e^{iΩt} − cos t − iΩ sin t), whose parts for Ω = 1 + η nearly cancel. With
    // Taylor's series in η, z = z₀ + η z₁ + η² z₂ …; z₁ by the same series in closed form.
    let t = 20.0_f64;
    let [sin, cos] = [t.sin(), t.cos()];
    let turn = Complex::new(cos, sin);
    let i = Complex::<f64>::i();
    // e^{iΩt} − cos t − iΩ sin t = η f₁ + η² f₂ + η³ f₃ + …, and Z = −(1 + η)²/(η(2 + η)).
    let f = |n: i32| {
        let mut term = turn;
        for k in 1..=n {
            term = term * i * t / f64::from(k);
        }
        if n == 1 { term - i * sin } else { term }
    };
    for exponent in [6, 8, 10, 12, 14, 15] {
        let eta = (1.0 + 10.0_f64.powi(-exponent)) - 1.0;
        let series = f(1) + f(2) * eta + f(3) * eta.powi(2) + f(4) * eta.powi(3);
        let exact = series * (-(1.0 + eta).powi(2) / (2.0 + eta));
        let machine = machine(0.0, 1.0 + eta);
        let ours = machine.transient(Shaft::AT_REST).unwrap().at(t).unwrap().position;
        assert!((ours - exact).norm() < 1e-14 * exact.norm(), "η = {eta:e}: {ours} for {exact}");
        let amplitude = machine.steady().unwrap().amplitude();
        let turned = Complex::from_polar(1.0, (1.0 + eta) * t);
        let naive = amplitude * (turned - cos - i * (1.0 + eta) * sin);
        if exponent >= 12 {
            assert!(
                (naive - exact).norm() > 1e-6 * exact.norm(),
                "the textbook form should fail at η = {eta:e}"
            );
        }
    }
}

/// A machine whose natural frequency √(3/7) is not a double, without damping, at the double next to it, and its κ =
/// 3/7 − Ω² from exact integers.
fn next_to_resonance(steps: u32) -> (Machine, f64) {
    let mut spin = (3.0_f64 / 7.0).sqrt();
    for _ in 0..steps {
        spin = spin.next_up();
    }
    let machine = Machine::new(MachineParameters {
        drum_mass: 3.0,
        load_mass: 4.0,
        load_radius: 1.75,
        stiffness: 3.0,
        damping: 0.0,
        spin,
    });
    let n = (spin * 2.0_f64.powi(54)) as i128; // the double itself, as an integer
    assert_eq!(n as f64 / 2.0_f64.powi(54), spin);
    let exact = 3 * (1_i128 << 108) - 7 * n * n; // 7 κ in units of 2⁻¹⁰⁸
    (machine.expect("a valid machine"), exact as f64 / 2.0_f64.powi(108) / 7.0)
}

#[test]
fn beat_of_a_hundred_million_years_is_found() {
    // Beside resonance, z = Z(e^{iΩt} − e^{iω₀t}) up to terms of size b, so |z| = 2|Z sin((Ω − ω₀)t/2)|, with Ω − ω₀
    // = −κ/2Ω.
    for steps in 0..3 {
        let (machine, detuning) = next_to_resonance(steps);
        let difference = -detuning / (2.0 * machine.spin());
        let motion = machine.transient(Shaft::AT_REST).unwrap();
        let amplitude = machine.spin().powi(2) / detuning;
        for t in [1e12_f64, 1e15, 3e15, 1e16] {
            let exact = (2.0 * amplitude * (0.5 * difference * t).sin()).abs();
            let ours = motion.at(t).unwrap().position.norm();
            assert!((ours - exact).abs() < 1e-11 * exact + 2.0, "{steps}, t = {t:e}: {ours} for {exact}");
        }
    }
}

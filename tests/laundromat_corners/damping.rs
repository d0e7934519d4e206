//! Damping from none through critical to very heavy, before the start as well as after it.

use crate::{FEW_ULPS, JUDGE, machine, start};
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{Machine, Parameters, Shaft};

/// The largest difference between the closed form and DOP853 at ten times up to `end`, relative to the largest excursion.
fn departure_from_dop853(machine: &Machine, end: f64) -> f64 {
    let times: Vec<f64> = (1..=10).map(|n| f64::from(n) * 0.1 * end).collect();
    let rates = |t: f64, y: &[f64; 4]| machine.cartesian_rates(t, y);
    // With heavy damping the steps would grow to the edge of stability, where the dense output between them, which no error
    // estimate watches, is four digits worse than their ends.
    let solver = Dop853::new(1e-13).unwrap().with_max_step(1.0 / machine.damping_rate().max(1.0));
    let (judge, _) = solver.sample(rates, 0.0, start().to_array(), &times).unwrap();
    let motion = machine.transient(start()).unwrap();
    let (mut worst, mut size) = (0.0_f64, 0.0_f64);
    for (&t, judged) in times.iter().zip(&judge) {
        for (a, b) in motion.at(t).unwrap().to_array().iter().zip(judged) {
            worst = worst.max((a - b).abs());
            size = size.max(b.abs());
        }
    }
    worst / size
}

#[test]
fn transient_agrees_with_dop853_from_no_damping_to_heavy_damping() {
    for damping in [0.0, 1e-8, 1e-3, 0.1, 0.7, 1.0, 1.9, 2.0, 2.1, 3.0, 10.0, 50.0] {
        for spin in [-3.0, -1.0, -0.2, 0.0, 0.01, 0.5, 0.9, 1.0, 1.1, 2.0, 5.0] {
            let error = departure_from_dop853(&machine(damping, spin), 12.0);
            assert!(error < JUDGE, "Γ = {damping}, Ω = {spin}: {error:e}");
        }
    }
}

#[test]
fn transient_agrees_with_dop853_before_the_start() {
    for (damping, spin) in [(0.0, 1.0), (0.1, 1.0), (0.3, -2.0), (2.0, 0.5), (3.0, 3.0)] {
        let error = departure_from_dop853(&machine(damping, spin), -4.0);
        assert!(error < JUDGE, "Γ = {damping}, Ω = {spin}: {error:e}");
    }
}

#[test]
fn motion_long_before_a_heavily_damped_start_is_found_if_it_can_be_written_down() {
    // Released at rest at 1e-40 m: fifteen seconds before, e^{−λt} alone is beyond the largest number, the motion is not.
    let balanced = Parameters {
        drum_mass: 1.0,
        load_mass: 0.0,
        load_radius: 1.0,
        stiffness: 1.0,
        damping: 50.0,
        spin: 0.0,
    };
    let machine = Machine::new(balanced).unwrap();
    let motion = machine.transient(Shaft { position: 1e-40.into(), ..Shaft::AT_REST }).unwrap();
    let half_gap = 624.0_f64.sqrt();
    let (fast, slow) = (25.0 + half_gap, 1.0 / (25.0 + half_gap));
    let logarithm = (1e-40 * slow / (2.0 * half_gap)).ln() + 15.0 * fast;
    let ours = motion.at(-15.0).unwrap().position.re;
    assert!(ours < 0.0 && (ours.abs().ln() / logarithm - 1.0).abs() < 1e-14, "{ours:e}, ln {logarithm}");
}

#[test]
fn transient_is_smooth_through_critical_damping() {
    for exponent in [16, 15, 14, 12, 10, 8, 6, 4, 3] {
        for side in [-1.0, 1.0] {
            let damping = 2.0 * (1.0 + side * 10.0_f64.powi(-exponent));
            let error = departure_from_dop853(&machine(damping, 1.3), 8.0);
            assert!(error < JUDGE, "Γ/2ω₀ = 1 {side:+}e-{exponent}: {error:e}");
        }
    }
}

#[test]
fn difference_of_exponentials_loses_eight_digits_near_critical_damping() {
    // The textbook form with its two real roots, 1e-15 beyond critical damping, against the library.
    let damping = 2.0 * (1.0 + 1e-15_f64);
    let half_gap = (damping * damping / 4.0 - 1.0).sqrt();
    let (slow, fast) = (damping / 2.0 - half_gap, damping / 2.0 + half_gap);
    let t = 1.7_f64;
    // Free motion of a balanced machine from a push of 1 m/s: (e^{−st} − e^{−ft})/(f − s), at critical damping t e^{−t}.
    let naive = ((-slow * t).exp() - (-fast * t).exp()) / (fast - slow);
    let balanced =
        Parameters { drum_mass: 1.0, load_mass: 0.0, load_radius: 1.0, stiffness: 1.0, damping, spin: 0.0 };
    let push = Shaft { velocity: 1.0.into(), ..Shaft::AT_REST };
    let ours = Machine::new(balanced).unwrap().transient(push).unwrap().at(t).unwrap().position.re;
    let exact = t * (-t).exp(); // to 1e-15: the difference from critical damping is second order in 1e-15 and first in Γ
    assert!((ours / exact - 1.0).abs() < 1e-14, "{ours} for {exact}");
    assert!((naive / exact - 1.0).abs() > 1e-10, "the naive form should fail and gives {naive} for {exact}");
}

#[test]
fn slow_decay_keeps_its_digits_at_a_damping_of_1e8() {
    // λ_slow = ω₀²/Γ (1 + ω₀²/Γ² + …) is 1e-8 to sixteen digits, and a released drum follows e^{−λt} after the first 1e-7 s.
    let balanced = Parameters {
        drum_mass: 1.0,
        load_mass: 0.0,
        load_radius: 1.0,
        stiffness: 1.0,
        damping: 1e8,
        spin: 0.0,
    };
    let machine = Machine::new(balanced).unwrap();
    let motion = machine.transient(Shaft { position: 1.0.into(), ..Shaft::AT_REST }).unwrap();
    for t in [1.0_f64, 1e6, 1e8, 5e8] {
        let exact = (-1e-8 * t).exp();
        let shaft = motion.at(t).unwrap();
        assert!((shaft.position.re / exact - 1.0).abs() < FEW_ULPS, "t = {t}: {}", shaft.position.re);
        assert!(
            (shaft.velocity.re / (-1e-8 * exact) - 1.0).abs() < FEW_ULPS,
            "t = {t}: {}",
            shaft.velocity.re
        );
    }
    let naive = 0.5e8 - (0.25e16_f64 - 1.0).sqrt();
    assert!(
        (naive / 1e-8 - 1.0).abs() > 0.2,
        "the naive slow root should be wrong by a quarter, and is {naive}"
    );
}

#[test]
fn heavy_damping_after_a_hard_push_keeps_the_digits_of_the_small_velocity() {
    // A push of 1 m/s at Γ = 1e6 moves the drum by 1e-6 m; it creeps back at λ_slow times that.
    let balanced = Parameters {
        drum_mass: 1.0,
        load_mass: 0.0,
        load_radius: 1.0,
        stiffness: 1.0,
        damping: 1e6,
        spin: 0.0,
    };
    let machine = Machine::new(balanced).unwrap();
    let late = machine.transient(Shaft { velocity: 1.0.into(), ..Shaft::AT_REST }).unwrap().at(1.0).unwrap();
    // With q = ω₀²/Γ² = 1e-12: λ_slow = (1 + q) ω₀²/Γ and 1/(λ_fast − λ_slow) = (1 + 2q)/Γ, both to 24 digits.
    let q = 1e-12_f64;
    let slow = 1e-6 * (1.0 + q);
    let position = 1e-6 * (1.0 + 2.0 * q) * (-slow).exp();
    assert!((late.position.re / position - 1.0).abs() < FEW_ULPS);
    assert!((late.velocity.re / (-slow * position) - 1.0).abs() < FEW_ULPS);
}

#[test]
fn locked_motion_agrees_with_dop853_and_runs_away_above_the_natural_frequency() {
    for (damping, spin) in
        [(0.0, 0.5), (0.2, 0.5), (0.2, 1.0), (3.0, 0.9), (0.2, 1.5), (0.0, 3.0), (4.0, 2.0)]
    {
        let machine = machine(damping, spin);
        let equilibrium = machine.steady().unwrap().radius();
        let start = [equilibrium + 0.01, 0.0];
        let motion = machine.locked(start[0], start[1]).unwrap();
        let rates = |_t: f64, y: &[f64; 2]| machine.locked_rates(y).unwrap();
        let judge = Dop853::new(1e-13).unwrap().solve(rates, 0.0, start, 5.0).unwrap().state;
        let ours = motion.at(5.0).unwrap();
        for (a, b) in ours.iter().zip(&judge) {
            assert!(
                (a - b).abs() < JUDGE * (1.0 + b.abs()),
                "Γ = {damping}, Ω = {spin}: {ours:?} for {judge:?}"
            );
        }
        let away = (motion.at(20.0).unwrap()[0] - equilibrium).abs();
        assert_eq!(away > 0.011, spin > 1.0, "Γ = {damping}, Ω = {spin}: {away}");
    }
}

//! Damping from none through critical to very heavy, before the start as well as after it.

use crate::FEW_ULPS;
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};

#[test]
fn motion_long_before_a_heavily_damped_start_is_found_if_it_can_be_written_down() {
    // Released at rest at 1e-40 m: fifteen seconds before, e^{−λt} alone is beyond the largest number, the motion is
    // not.
    let balanced = MachineParameters {
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
fn difference_of_exponentials_loses_eight_digits_near_critical_damping() {
    // The textbook form with its two real roots, 1e-15 beyond critical damping, against the library.
    let damping = 2.0 * (1.0 + 1e-15_f64);
    let half_gap = (damping * damping / 4.0 - 1.0).sqrt();
    let (slow, fast) = (damping / 2.0 - half_gap, damping / 2.0 + half_gap);
    let t = 1.7_f64;
    // Free motion of a balanced machine from a push of 1 m/s: (e^{−st} − e^{−ft})/(f − s), at critical damping t
    // e^{−t}.
    let naive = ((-slow * t).exp() - (-fast * t).exp()) / (fast - slow);
    let balanced = MachineParameters {
        drum_mass: 1.0,
        load_mass: 0.0,
        load_radius: 1.0,
        stiffness: 1.0,
        damping,
        spin: 0.0,
    };
    let push = Shaft { velocity: 1.0.into(), ..Shaft::AT_REST };
    let ours = Machine::new(balanced).unwrap().transient(push).unwrap().at(t).unwrap().position.re;
    // To 1e-15: the difference from critical damping is second order in 1e-15 and first in Γ.
    let exact = t * (-t).exp();
    assert!((ours / exact - 1.0).abs() < 1e-14, "{ours} for {exact}");
    assert!((naive / exact - 1.0).abs() > 1e-10, "the naive form should fail and gives {naive} for {exact}");
}

#[test]
fn slow_decay_keeps_its_digits_at_a_damping_of_1e8() {
    // λ_slow = ω₀²/Γ (1 + ω₀²/Γ² + …) is 1e-8 to sixteen digits, and a released drum follows e^{−λt} after the first
    // 1e-7 s.
    let balanced = MachineParameters {
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
    let balanced = MachineParameters {
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

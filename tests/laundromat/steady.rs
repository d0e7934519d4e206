//! Equations (16) to (20): steady motion, self-centring, and what the motor pays.

use super::{ROUNDING, WASHER, letters, machines, washer};
use crate::common::any;
use crate::printed::corrected_holds_and_printed_fails;
use approx::assert_relative_eq;
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use nalgebra::Complex;
use num_dual::{Dual64, DualNum, first_derivative};
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

/// D of eq:steady-phase, in the plainest way.
fn d((w0, _, gamma, spin): (f64, f64, f64, f64)) -> f64 {
    ((w0 * w0 - spin * spin).powi(2) + (gamma * spin).powi(2)).sqrt()
}

/// Where a simulation of forty decay times from rest ends up, in the frame of the load: z e^{−iΩt}.
fn settled(machine: &Machine) -> Complex<f64> {
    let t = 80.0 / machine.damping_rate();
    let end = Dop853::new(1e-13)
        .unwrap()
        .solve(any(|t, y| machine.cartesian_rates(t, y)), 0.0, [0.0; 4], t)
        .unwrap();
    Shaft::from_array(end.state).position * Complex::from_polar(1.0, -machine.spin() * t)
}

#[test]
fn eq16_radial_balance_holds_in_steady_motion() {
    for machine in machines(16, 500) {
        let (w0, b, _, spin) = letters(&machine);
        let steady = machine.steady().unwrap();
        // r̈ = 0 with ṙ = 0, θ̇ = Ω in (10); multiplied out, because the quotient is 0/0 at resonance.
        let left = steady.radius() * (w0 * w0 - spin * spin);
        let right = b * spin * spin * steady.phase().cos();
        assert!((left - right).abs() < ROUNDING * (steady.radius() * (w0 * w0 + spin * spin) + right.abs()));
    }
}

#[test]
fn eq17_azimuthal_balance_holds_in_steady_motion() {
    for machine in machines(17, 500) {
        let (_, b, gamma, spin) = letters(&machine);
        let steady = machine.steady().unwrap();
        // The sine has lost digits near π.
        assert_relative_eq!(steady.radius() * gamma, b * spin * steady.phase().sin(), max_relative = 1e-11);
    }
}

#[test]
fn eq18_phase_is_where_a_simulated_load_settles() {
    for (damping, spin) in [(30.0, 3.0), (90.0, 10.0), (90.0, 30.0), (600.0, 12.0)] {
        let machine = Machine::new(MachineParameters { damping, spin, ..WASHER }).unwrap();
        let lead = -settled(&machine).arg(); // the load is at azimuth zero in its own frame
        assert!((lead - machine.steady().unwrap().phase()).abs() < 1e-10, "lead {lead} rad");
    }
}

#[test]
fn eq18_phase_runs_from_0_through_a_right_angle_to_pi() {
    let machine = washer();
    let phase = |spin: f64| machine.with_spin(spin).unwrap().steady().unwrap().phase();
    assert!(phase(1e-6) < 1e-7 && PI - phase(1e8) < 1e-7);
    assert_relative_eq!(phase(10.0), FRAC_PI_2, max_relative = 1e-15);
    assert!((1..2000).all(|n| phase(f64::from(n) * 0.01) < phase(f64::from(n + 1) * 0.01)));
}

#[test]
fn eq19_radius_is_that_of_the_simulated_circle() {
    for (damping, spin) in [(30.0, 3.0), (90.0, 10.0), (90.0, 30.0), (600.0, 12.0)] {
        let machine = Machine::new(MachineParameters { damping, spin, ..WASHER }).unwrap();
        assert_relative_eq!(
            settled(&machine).norm(),
            machine.steady().unwrap().radius(),
            max_relative = 1e-10
        );
    }
    for machine in machines(19, 500) {
        let all = letters(&machine);
        assert_relative_eq!(
            machine.steady().unwrap().radius(),
            all.1 * all.3 * all.3 / d(all),
            max_relative = 1e-11
        );
    }
}

/// r₀ as a function of the spin, for differentiation.
fn radius<D: DualNum<Primitive = f64>>(spin: D, (w0, b, gamma, _): (f64, f64, f64, f64)) -> D {
    let square = spin.clone() * spin;
    let detuning = -square.clone() + w0 * w0;
    square.clone() * b / (detuning.clone() * detuning + square * (gamma * gamma)).sqrt()
}

#[test]
fn peak_of_the_radius_is_a_zero_of_its_derivative() {
    let mut peaks = 0;
    for machine in machines(20, 500) {
        let all = letters(&machine);
        match machine.peak() {
            Some(peak) => {
                let (value, slope) = first_derivative(|spin: Dual64| radius(spin, all), peak.spin);
                assert_relative_eq!(value, peak.radius, max_relative = 1e-11);
                assert!(
                    slope.abs() * peak.spin < 1e-9 * value * (all.0 / all.2).powi(2).max(1.0),
                    "slope {slope}"
                );
                peaks += 1;
            }
            None => assert!(all.2 > 1.414 * all.0),
        }
    }
    assert!(peaks > 100);
}

#[test]
fn eq20_centre_of_mass_circle_corrected_holds_and_printed_fails() {
    // Fast enough, or damped enough, for the damper to count: that is where the two forms differ.
    let damped = |machine: &Machine| {
        machine.damping_rate() * machine.spin().abs() > 0.5 * machine.natural_frequency().powi(2)
    };
    let cases = machines(21, 1000).filter(damped).map(|machine| {
        let (w0, b, gamma, spin) = letters(&machine);
        let found = machine.steady().unwrap().centre_of_mass_radius();
        // Force: the suspension alone holds the centre of mass on its circle.
        let p = machine.parameters();
        let force = machine.steady().unwrap().radius() * p.stiffness.hypot(p.damping * spin);
        assert_relative_eq!(force, machine.total_mass() * spin * spin * found, max_relative = 1e-11);
        let d = d((w0, b, gamma, spin));
        let corrected = b * (w0.powi(4) + (gamma * spin).powi(2)).sqrt() / d;
        let printed = b * w0 * w0 / d;
        ((corrected / found - 1.0).abs(), (printed / found - 1.0).abs())
    });
    corrected_holds_and_printed_fails(cases, 1e-11, 0.1);
    // And a simulation: the shaft where it has settled, and the centre of mass b further along the load.
    for (damping, spin) in [(30.0, 3.0), (90.0, 10.0), (90.0, 30.0), (600.0, 12.0)] {
        let machine = Machine::new(MachineParameters { damping, spin, ..WASHER }).unwrap();
        let radius = (settled(&machine) + machine.offset()).norm();
        assert_relative_eq!(machine.steady().unwrap().centre_of_mass_radius(), radius, max_relative = 1e-9);
    }
}

#[test]
fn eq20_all_curves_cross_at_sqrt_2() {
    for damping in [0.0, 1.0, 90.0, 3000.0, 1e6] {
        let machine = Machine::new(MachineParameters { damping, spin: 10.0 * SQRT_2, ..WASHER }).unwrap();
        assert_relative_eq!(
            machine.steady().unwrap().centre_of_mass_radius(),
            machine.offset(),
            max_relative = 1e-14
        );
    }
}

#[test]
fn eq20_self_centring_goes_as_one_over_the_spin_and_not_as_its_square() {
    let machine = washer();
    let radius = |spin: f64| machine.with_spin(spin).unwrap().steady().unwrap().centre_of_mass_radius();
    for spin in [1e4, 1e6, 1e9] {
        assert_relative_eq!(
            radius(spin) * spin,
            machine.offset() * machine.damping_rate(),
            max_relative = 1e4 / spin.powi(2) + 1e-14
        );
        // The printed form gives 100.
        assert_relative_eq!(radius(spin) / radius(10.0 * spin), 10.0, max_relative = 1e-4);
    }
}

#[test]
fn motor_torque_feeds_the_dampers() {
    for machine in machines(22, 500) {
        let steady = machine.steady().unwrap();
        let p = machine.parameters();
        let heat = p.damping * (steady.radius() * p.spin).powi(2);
        assert_relative_eq!(steady.motor_power(), heat, max_relative = 1e-11);
        assert_relative_eq!(steady.motor_torque() * p.spin, heat, max_relative = 1e-11);
        // m a r₀ Ω² sin φ₀, from eq:motor-torque.
        let pull = p.load_mass * p.load_radius * steady.radius() * p.spin.powi(2) * steady.phase().sin();
        assert_relative_eq!(steady.motor_torque(), pull, max_relative = 1e-11);
    }
}

#[test]
fn a_steady_circle_at_the_ends_of_the_range_is_no_less_exact() {
    // At rest: nothing moves, and the motor has nothing to do.
    let resting = Machine::new(MachineParameters { spin: 0.0, ..WASHER }).unwrap().steady().unwrap();
    assert_eq!([resting.radius(), resting.motor_torque(), resting.motor_power()], [0.0; 3]);
    assert_eq!(resting.motor_torque_slope(), 0.0);
    assert_eq!(resting.centre_of_mass_radius(), washer().offset());
    // So far below resonance that squares of the ratio are beyond all numbers: bΩ²/ω₀².
    let stiff = MachineParameters {
        drum_mass: 0.0,
        load_mass: 1.0,
        load_radius: 1.0,
        stiffness: 1e80,
        damping: 0.0,
        spin: 1e-40,
    };
    let radius = Machine::new(stiff).unwrap().steady().unwrap().radius();
    assert!((radius / 1e-160 - 1.0).abs() < 1e-15, "{radius:e}");
    // Γ² = 2ω₀² to the last bit: the peak has just gone.
    let flat = MachineParameters { stiffness: 2.0, damping: 2.0, ..stiff };
    assert_eq!(Machine::new(flat).unwrap().peak(), None);
    assert!(
        Machine::new(MachineParameters { damping: 2.0_f64.next_down(), ..flat }).unwrap().peak().is_some()
    );
}

//! Equations (21) and (31): what is stable, and why.

use super::linear::{eigenvalues, scale};
use super::{ROUNDING, letters, machines, newton, washer};
use crate::common::any;
use approx::assert_relative_eq;
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{LockedState, Machine, MachineParameters, Polar, Shaft};
use nalgebra::{Complex, Matrix4};

const I: Complex<f64> = Complex::new(0.0, 1.0);

/// r̈ of a shaft on a rail that turns with Ω at the angle −φ₀ behind the load: Newton's law with the raw parameters,
/// along the rail. The rail pushes across it only, and r̂ turns, which adds rΩ².
fn on_a_rail(p: &MachineParameters, phi0: f64, t: f64, &[r, r_dot]: &[f64; 2]) -> [f64; 2] {
    let along = Complex::from_polar(1.0, p.spin * t - phi0);
    let (z, v) = (along * r, along * Complex::new(r_dot, r * p.spin));
    let [_, _, ax, ay] = newton(p, t, &[z.re, z.im, v.re, v.im]);
    [r_dot, (Complex::new(ax, ay) * along.conj()).re + r * p.spin * p.spin]
}

#[test]
fn eq21_a_locked_angle_is_stable_only_below_the_natural_frequency() {
    let (mut held, mut lost) = (0, 0);
    for machine in machines(21, 300) {
        let (w0, b, gamma, spin) = letters(&machine);
        let steady = machine.steady().unwrap();
        let phi0 = steady.phase();
        // (21), the radial row of the polar equations with the angle locked, and the rail are one law.
        let (t, r, r_dot) = (0.7, 0.8 * b, 0.3 * b * w0);
        let [_, rail] = on_a_rail(&machine.parameters(), phi0, t, &[r, r_dot]);
        let [_, _, row, _] = machine.polar_rates(t, &[r, spin * t - phi0, r_dot, spin]);
        let eq21 = (spin * spin - w0 * w0) * r + b * spin * spin * phi0.cos() - gamma * r_dot;
        let size = (spin * spin + w0 * w0) * b + gamma * r_dot;
        let motion = machine.locked(LockedState::from_array([r, r_dot])).unwrap();
        let [_, locked] = motion.rates(t, &[r, r_dot]);
        for form in [row, locked, eq21] {
            assert!((rail - form).abs() < ROUNDING * size, "{form} for {rail} m/s²");
        }
        if (spin.abs() / w0 - 1.0).abs() < 0.05 {
            continue;
        }
        // The library's closed form, a while after a nudge, against a simulation on the rail.
        let nudge = 1e-3 * steady.radius();
        let start = [steady.radius() + nudge, 0.0];
        let time = 10.0 / (w0 + spin.abs());
        let rates = |t: f64, y: &[f64; 2]| on_a_rail(&machine.parameters(), phi0, t, y);
        let solver = Dop853::with_tolerances(1e-13, 1e-13 * start[0]).unwrap();
        let end = solver.solve(any(rates), 0.0, start, time).unwrap().state;
        let locked = machine.locked(LockedState::from_array(start)).unwrap();
        let [r, r_dot] = locked.at(time).unwrap().to_array();
        assert!((r - end[0]).abs() < 1e-9 * (end[0].abs() + start[0]), "{r} m, simulated {} m", end[0]);
        assert!((r_dot - end[1]).abs() < 1e-9 * (w0 + spin.abs()) * (end[0].abs() + start[0]));
        // And long after it: a few of the slowest times of growth or of return.
        let late = 10.0 * (gamma + w0 + spin.abs()) / (spin * spin - w0 * w0).abs();
        let away = (locked.at(late).unwrap().radius - steady.radius()).abs();
        let stable = spin.abs() < w0;
        assert_eq!(away < 1.01 * nudge, stable, "at {spin} rad/s, ω₀ = {w0} rad/s: {away} m from {nudge} m");
        if stable { held += 1 } else { lost += 1 }
    }
    assert!(held > 50 && lost > 50, "{held} and {lost}");
}
#[test]
fn eq31_mode_frequencies_are_the_eigenvalues_of_thousands_of_machines() {
    let (mut over, mut under) = (0, 0);
    for machine in machines(31, 6000) {
        let (w0, _, gamma, spin) = letters(&machine);
        let gap = (gamma / (2.0 * w0) - 1.0).abs();
        if gap < 1e-3 {
            continue; // eigenvalues meet: see the test at critical damping
        }
        let fastest = w0 + gamma + spin.abs();
        let mut eigenvalues = eigenvalues(&machine);
        for mode in machine.modes() {
            let s: Complex<f64> = I * mode.frequency;
            let (place, distance) = eigenvalues
                .iter()
                .map(|e: &Complex<f64>| (e - s).norm())
                .enumerate()
                .min_by(|a, b| a.1.total_cmp(&b.1))
                .unwrap();
            // Backward error of the eigenvalue solver, magnified where eigenvalues are close to each other.
            let bound = 1e-13 * fastest * fastest / (w0 * gap.sqrt().min(1.0));
            assert!(distance < bound, "{s} is off by {distance}, bound {bound}");
            eigenvalues.swap_remove(place);
            assert!(mode.frequency.im > 0.0, "every mode decays");
        }
        if gamma > 2.0 * w0 { over += 1 } else { under += 1 }
    }
    assert!(over > 500 && under > 500);
}

#[test]
fn the_coriolis_coupling_is_needed_in_turning_axes_and_absent_in_the_room() {
    let (mut needed, mut spared) = (0, 0);
    for machine in machines(330, 2000) {
        let (w0, _, gamma, spin) = letters(&machine);
        // In polar axes: without its two terms in Ω ε̇ and Ω δ̇ the motion is stable only below ω₀/√2.
        let mut without = machine.stability_matrix();
        let coriolis = [without[(1, 3)], without[(3, 1)]];
        assert_relative_eq!(coriolis[0], 2.0 * spin, max_relative = ROUNDING);
        assert_relative_eq!(coriolis[1], -2.0 * spin, max_relative = ROUNDING);
        (without[(1, 3)], without[(3, 1)]) = (0.0, 0.0);
        let margin = 2.0 * spin * spin / (w0 * w0) - 1.0;
        let mut growth = f64::MIN;
        for (sense, branch) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            // What is left acts on ε ± iδ as one oscillator, pushed across its displacement: four exact eigenvectors.
            let push = Complex::new(gamma * gamma / 4.0 - w0 * w0 + spin * spin, -sense * gamma * spin);
            let (s, shape) = (push.sqrt() * branch - gamma / 2.0, I * -sense);
            let mode = nalgebra::Vector4::new(Complex::from(1.0), s, shape, s * shape);
            let miss: nalgebra::Vector4<Complex<f64>> = without.map(Complex::from) * mode - mode * s;
            assert!(miss.norm() < 1e-12 * scale(&machine) * (1.0 + s.norm()), "{s}: {miss}");
            growth = growth.max(s.re);
        }
        if margin.abs() > 1e-3 && gamma > 0.01 * w0 {
            assert_eq!(growth > 0.0, margin > 0.0, "growth {growth} at {margin}");
            if margin > 0.0 { needed += 1 } else { spared += 1 }
        }
        // In the room: what x does is no business of y, and what a disturbance does is no business of the spin.
        let rates = |machine: &Machine, y: [f64; 4]| machine.cartesian_rates(0.4, &y);
        let [here, there] = [[0.02, 0.0, 0.3, 0.0], [0.02, 0.07, 0.3, -0.9]].map(|y| rates(&machine, y));
        assert_eq!(here[2], there[2]);
        let other = machine.with_spin(2.0 * spin + 1.0).unwrap();
        let change =
            |machine: &Machine| rates(machine, [0.02, 0.0, 0.3, 0.0])[2] - rates(machine, [0.0; 4])[2];
        let size = w0 * w0 + gamma + machine.offset() * other.spin().powi(2);
        assert!((change(&machine) - change(&other)).abs() < ROUNDING * size);
    }
    assert!(needed > 200 && spared > 200, "{needed} and {spared}");
}

#[test]
fn every_disturbance_decays_with_the_time_two_over_gamma() {
    // A simulation of the lab equation, large disturbance and all: its distance from the steady motion shrinks as
    // e^{−Γt/2}.
    let machine = washer();
    let (_, _, gamma, spin) = letters(&machine);
    let steady = machine.steady().unwrap().amplitude();
    let w1 = (100.0_f64 - gamma * gamma / 4.0).sqrt();
    let whole = std::f64::consts::TAU / w1; // after each of these the oscillation is in the same phase
    let start = Shaft { position: Complex::new(0.4, -0.3), velocity: Complex::new(1.0, 2.0) };
    let away = |shaft: Shaft, t: f64| (shaft.position - steady * Complex::from_polar(1.0, spin * t)).norm();
    let first = away(start, 0.0);
    let solver = Dop853::new(1e-13).unwrap();
    for n in 1..=5 {
        let t = f64::from(n) * whole;
        let end = solver.solve(any(|t, y| machine.cartesian_rates(t, y)), 0.0, start.to_array(), t).unwrap();
        assert_relative_eq!(
            away(Shaft::from_array(end.state), t),
            first * (-gamma * t / 2.0).exp(),
            max_relative = 1e-8
        );
    }
    assert!(2.0 / gamma > 1.0 / machine.natural_frequency()); // what Γ < 2ω₀ says
}

#[test]
fn both_circles_of_a_swing_come_to_the_top_of_the_hill_one_from_below_and_one_from_above() {
    // Without a load the steady place is O, the top of the hill of eq:jacobi.
    let (w0, gamma) = (10.0_f64, 0.01);
    for spin in [11.0, 22.0, 60.0] {
        let parameters = MachineParameters {
            drum_mass: 30.0,
            load_mass: 0.0,
            load_radius: 0.25,
            stiffness: 3000.0,
            damping: 30.0 * gamma,
            spin,
        };
        let machine = Machine::new(parameters).unwrap();
        let solver = Dop853::new(1e-12).unwrap();
        let rates = |t: f64, state: &[f64; 4]| newton(&parameters, t, state);
        // Circles with the drum and against it, and both together: at x = 2 cm and at y = 3 cm.
        let [with, against, both] = [[0.02, 0.0, 0.0, 0.2], [0.0, 0.03, 0.3, 0.0], [0.02, 0.03, 0.3, 0.2]]
            .map(|start| {
                [0.0, 50.0, 100.0].map(|time| {
                    let state = solver.solve(any(rates), 0.0, start, time).unwrap().state;
                    machine.jacobi_integral(time, &Shaft::from_array(state))
                })
            });
        for (k, fallen) in [0.0_f64, 0.5, 1.0].map(|lives| (-lives).exp()).into_iter().enumerate() {
            let of = [-w0 * (spin - w0) * 4e-4, w0 * (spin + w0) * 9e-4].map(|start| start * fallen);
            // A circle that dies out is one but for a part Γ/ω₀ of its speed.
            let slack = gamma / w0 * (w0 + spin).powi(2) * 1e-3;
            for (found, expected) in [(with[k], of[0]), (against[k], of[1]), (both[k], of[0] + of[1])] {
                assert!((found - expected).abs() < slack, "{found} for {expected} at {spin} rad/s");
            }
        }
    }
}

#[test]
fn a_damper_on_the_radius_alone_turns_stability_round() {
    // The quartic is the characteristic polynomial of the dual-number linearisation without the drag across the
    // radius; at the steady motion of that machine, sin φ₀ = 0 and r₀ = b Ω²/|ω₀² − Ω²|.
    for machine in machines(33, 2000) {
        let (w0, _, gamma, spin) = letters(&machine);
        let kappa = w0 * w0 - spin * spin;
        let a = machine.radial_damping_matrix();
        let quartic = |s: Complex<f64>| {
            s.powi(4)
                + s.powi(3) * gamma
                + s * s * (2.0 * kappa + 4.0 * spin * spin)
                + s * (gamma * kappa)
                + kappa * kappa
        };
        let probe = Complex::new(0.3 * w0, 1.7 * spin);
        let determinant =
            (Matrix4::<Complex<f64>>::identity() * probe - a.map(|v| Complex::new(v, 0.0))).determinant();
        assert_relative_eq!(
            (determinant - quartic(probe)).norm() / quartic(probe).norm(),
            0.0,
            epsilon = 1e-10
        );
        let growth = a.complex_eigenvalues().iter().map(|s| s.re).fold(f64::MIN, f64::max);
        let slack = 1e-6 * (w0 + gamma + spin.abs());
        assert!((machine.radial_damping_growth() - growth).abs() < slack, "{machine:?}: {growth}");
        if (kappa / (w0 * w0)).abs() > 0.01 {
            // The slowest rate can be tiny; what matters is its sign beyond the solver's error.
            let noise = 1e-12 * (w0 + gamma + spin.abs());
            assert!(
                if kappa > 0.0 { growth < noise } else { growth > -noise },
                "κ = {kappa}, growth {growth}"
            );
        }
    }
}

#[test]
fn a_damper_on_the_radius_alone_makes_a_simulated_machine_run_away() {
    let growth = |spin: f64, time: f64| {
        let machine = washer().with_spin(spin).unwrap();
        let (w0, b, _, _) = letters(&machine);
        let r0 = b * spin * spin / (w0 * w0 - spin * spin).abs();
        let phi0 = if spin > w0 { std::f64::consts::PI } else { 0.0 };
        let start = Shaft::from_polar(Polar::from_array([r0 * 1.001, -phi0, 0.0, spin])).to_array();
        let end = Dop853::new(1e-12)
            .unwrap()
            .solve(any(|t, y| machine.radial_damping_rates(t, y)), 0.0, start, time)
            .unwrap();
        (end.state[0].hypot(end.state[1]) / r0 - 1.0).abs() / 1e-3
    };
    assert!(growth(5.0, 100.0) < 0.01);
    assert!(growth(15.0, 20.0) > 10.0);
}

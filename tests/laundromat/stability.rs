//! Equations (21) to (31): small disturbances.

use crate::{ROUNDING, letters, machines, washer};
use approx::assert_relative_eq;
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{Machine, Shaft};
use nalgebra::{Complex, Matrix4, SVector};
use num_dual::{DualNum, DualSVec64, jacobian};

type Vector<D> = SVector<D, 4>;

/// (ε̇, ε̈, δ̇, δ̈) as functions of (ε, ε̇, δ, δ̇): (10) and (11) with r = r₀(1 + ε), θ = Ωt − φ₀ + δ and nothing neglected.
fn disturbed<D: DualNum<Primitive = f64>>(machine: &Machine, x: &Vector<D>, drag_across: f64) -> Vector<D> {
    let (w0, b, gamma, spin) = letters(machine);
    let steady = machine.steady().unwrap();
    let (r0, phi0) = (steady.radius(), steady.phase());
    let [e, e_dot, delta, delta_dot] = std::array::from_fn(|i| x[i].clone());
    let (stretch, turning) = (e + 1.0, delta_dot.clone() + spin);
    let lead = -delta + phi0;
    let push = b * spin * spin / r0;
    let radial = stretch.clone() * turning.clone() * turning.clone() + lead.cos() * push
        - stretch.clone() * (w0 * w0)
        - e_dot.clone() * gamma;
    let azimuthal = (lead.sin() * push - e_dot.clone() * turning.clone() * 2.0) / stretch
        - turning * (gamma * drag_across);
    SVector::from([e_dot, radial, delta_dot, azimuthal])
}

/// The linearisation of the full equations by dual numbers.
fn linearised(machine: &Machine) -> Matrix4<f64> {
    let (_, matrix) = jacobian(|x: Vector<DualSVec64<4>>| disturbed(machine, &x, 1.0), &SVector::zeros());
    matrix
}

/// The typical size of an entry of that matrix.
fn scale(machine: &Machine) -> f64 {
    let (w0, _, gamma, spin) = letters(machine);
    1.0 + w0 * w0 + spin * spin + gamma * (1.0 + spin.abs())
}

/// The complex amplitudes (ω, ε₀, δ₀) of the modes, found from the linearised equations alone: for each eigenvalue s = iω of the
/// dual-number matrix the null vector gives δ₀/ε₀ from the radial row.
fn numerical_modes(machine: &Machine) -> Vec<(Complex<f64>, Complex<f64>, Complex<f64>)> {
    let a = linearised(machine);
    let s_values = a.complex_eigenvalues();
    s_values
        .iter()
        .map(|&s| {
            let e0 = Complex::new(1.0, 0.0);
            // s² ε₀ = (a₁₀ + a₁₁ s) ε₀ + (a₁₂ + a₁₃ s) δ₀
            let delta0 = (s * s - s * a[(1, 1)] - a[(1, 0)]) / (s * a[(1, 3)] + a[(1, 2)]);
            (s / Complex::i(), e0, delta0)
        })
        .collect()
}

/// Machines well away from critical damping, where eigenvalues coincide and no numerical eigenvector is trustworthy.
fn separated(seed: u64, count: usize) -> impl Iterator<Item = Machine> {
    machines(seed, count).filter(|machine| {
        let (w0, _, gamma, spin) = letters(machine);
        let w1 = (w0 * w0 - gamma * gamma / 4.0).abs().sqrt();
        gamma < 1.8 * w0 && spin.abs() < 10.0 * w0 && (spin.abs() - w1).abs() > 0.05 * w0
    })
}

#[test]
fn eq21_a_locked_angle_is_stable_only_below_the_natural_frequency() {
    let machine = washer();
    for (spin, stable) in [(5.0, true), (9.9, true), (10.1, false), (15.0, false), (300.0, false)] {
        let machine = machine.with_spin(spin).unwrap();
        let steady = machine.steady().unwrap();
        let (w0, b, gamma, _) = letters(&machine);
        // Integrate r̈ = (Ω² − ω₀²) r + bΩ² cos φ₀ − Γṙ from a nudge, and compare with the library's closed form.
        let rates = |_t: f64, &[r, r_dot]: &[f64; 2]| {
            [r_dot, (spin * spin - w0 * w0) * r + b * spin * spin * steady.phase().cos() - gamma * r_dot]
        };
        let nudge = 1e-3 * steady.radius();
        let start = [steady.radius() + nudge, 0.0];
        let time = 20.0 / (w0 + spin);
        let end = Dop853::new(1e-13).unwrap().solve(rates, 0.0, start, time).unwrap().state;
        let [r, r_dot] = machine.locked(start[0], start[1]).unwrap().at(time).unwrap();
        assert!((r - end[0]).abs() < 1e-9 * (end[0].abs() + start[0]), "{r} m, simulated {} m", end[0]);
        assert!((r_dot - end[1]).abs() < 1e-9 * (w0 + spin) * (end[0].abs() + start[0]));
        let late = (60.0 / gamma).min(600.0 / spin); // before the runaway overflows
        let late = machine.locked(start[0], start[1]).unwrap().at(late).unwrap()[0];
        assert_eq!((late - steady.radius()).abs() < nudge, stable, "at {spin} rad/s");
    }
}

#[test]
fn eq22_the_disturbance_in_polar_form_is_the_disturbance_in_the_plane() {
    // r₀(1 + ε) e^{i(Ωt − φ₀ + δ)} is Z e^{iΩt}(1 + ε + iδ) up to second order.
    let steady = washer().steady().unwrap();
    for size in [1e-2, 1e-3, 1e-4] {
        let (e, delta) = (0.6 * size, -0.8 * size);
        let polar = Complex::from_polar(steady.radius() * (1.0 + e), -steady.phase() + delta);
        let plane = steady.amplitude() * Complex::new(1.0 + e, delta);
        assert!((polar - plane).norm() < size * size * steady.radius());
    }
}

#[test]
fn eq23_the_modes_solve_the_linearised_equations() {
    let mut tried = 0;
    for machine in separated(23, 3000) {
        let a = linearised(&machine);
        for mode in machine.modes() {
            let s: Complex<f64> = I * mode.frequency;
            let (e0, delta0) = (Complex::new(1.0, 0.0), mode.shape);
            let x = nalgebra::Vector4::new(e0, s * e0, delta0, s * delta0);
            let difference: nalgebra::Vector4<Complex<f64>> = a.map(|v| Complex::new(v, 0.0)) * x - x * s;
            let residual = difference.norm();
            assert!(residual < 1e-12 * scale(&machine) * (1.0 + s.norm()), "residual {residual}");
            tried += 1;
        }
    }
    assert!(tried > 1000);
}

#[test]
fn eq24_sines_and_cosines_to_first_order() {
    let phi0 = 1.1_f64;
    for delta in [1e-3, 1e-5] {
        assert!(((phi0 - delta).cos() - (phi0.cos() + delta * phi0.sin())).abs() < delta * delta);
        assert!(((phi0 - delta).sin() - (phi0.sin() - delta * phi0.cos())).abs() < delta * delta);
    }
}

/// The left side less the right side of a linearised equation, for each numerical mode of each machine, relative to its terms.
fn worst_and_best(
    seed: u64,
    residual: impl Fn(Complex<f64>, Complex<f64>, Complex<f64>, &Machine) -> Complex<f64>,
) -> (f64, f64) {
    let (mut worst, mut best, mut tried) = (0.0_f64, f64::MAX, 0);
    for machine in separated(seed, 1000) {
        for (w, e0, d0) in numerical_modes(&machine) {
            let size = residual(w, e0, d0, &machine).norm() / (scale(&machine) * (1.0 + d0.norm()));
            worst = worst.max(size);
            best = best.min(size);
            tried += 1;
        }
    }
    assert!(tried > 400);
    (worst, best)
}

const I: Complex<f64> = Complex::new(0.0, 1.0);
/// Eigenvalues of a 4 × 4 matrix and what follows from them.
const EIGEN: f64 = 1e-9;

#[test]
fn eq25_radial_linearisation_corrected_holds_and_printed_fails() {
    let terms = |w: Complex<f64>, e0: Complex<f64>, d0: Complex<f64>, machine: &Machine| {
        let (w0, b, gamma, spin) = letters(machine);
        let steady = machine.steady().unwrap();
        let bend = b * spin * spin * steady.phase().sin() / steady.radius();
        let rest = d0 * bend - e0 * w0 * w0 - I * w * gamma * e0 + w * w * e0;
        (rest, e0 * spin * spin + I * w * d0 * (2.0 * spin), I * d0 * (2.0 * spin) + spin * spin)
    };
    let (worst, _) = worst_and_best(25, |w, e0, d0, m| terms(w, e0, d0, m).0 + terms(w, e0, d0, m).1);
    assert!(worst < EIGEN, "corrected: {worst}");
    let (worst, _) = worst_and_best(25, |w, e0, d0, m| terms(w, e0, d0, m).0 + terms(w, e0, d0, m).2);
    assert!(worst > 0.1, "printed: {worst}");
}

/// The denominator of (26) and (28).
fn denominator(w: Complex<f64>, machine: &Machine) -> Complex<f64> {
    let (w0, _, gamma, spin) = letters(machine);
    w * w - w0 * w0 + spin * spin - I * w * gamma
}

#[test]
fn eq26_radial_ratio_corrected_holds_and_printed_fails() {
    let residual = |printed: bool| {
        move |w: Complex<f64>, e0: Complex<f64>, d0: Complex<f64>, machine: &Machine| {
            let (_, _, gamma, spin) = letters(machine);
            let first = if printed { w * gamma } else { Complex::from(gamma * spin) };
            e0 * denominator(w, machine) + (first + I * w * (2.0 * spin)) * d0
        }
    };
    assert!(worst_and_best(26, residual(false)).0 < EIGEN);
    assert!(worst_and_best(26, residual(true)).0 > 0.1);
}

#[test]
fn eq27_azimuthal_linearisation_holds_with_the_spin_for_the_stray_symbol() {
    let residual = |drag_spin: fn(&Machine) -> f64| {
        move |w: Complex<f64>, e0: Complex<f64>, d0: Complex<f64>, machine: &Machine| {
            let (_, b, gamma, spin) = letters(machine);
            let steady = machine.steady().unwrap();
            let bend = b * spin * spin * steady.phase().cos() / steady.radius();
            -w * w * d0
                + I * w * e0 * (2.0 * spin)
                + d0 * bend
                + e0 * (gamma * drag_spin(machine))
                + I * w * gamma * d0
        }
    };
    assert!(worst_and_best(27, residual(Machine::spin)).0 < EIGEN);
    // "Ω₀" is not defined in the source; the natural frequency, its likeliest reading, fails.
    assert!(worst_and_best(27, residual(Machine::natural_frequency)).0 > 0.1);
}

#[test]
fn eq28_azimuthal_ratio_holds() {
    let (worst, _) = worst_and_best(28, |w, e0, d0, machine| {
        let (_, _, gamma, spin) = letters(machine);
        d0 * denominator(w, machine) - (I * w * (2.0 * spin) + gamma * spin) * e0
    });
    assert!(worst < EIGEN, "{worst}");
}

#[test]
fn eq25_and_eq27_are_the_rows_of_the_librarys_matrix() {
    for machine in machines(251, 500) {
        let difference = linearised(&machine) - machine.stability_matrix();
        assert!(difference.amax() < ROUNDING * scale(&machine), "off by {}", difference.amax());
    }
}

#[test]
fn eq29_the_ratio_is_plus_or_minus_i() {
    for machine in separated(29, 1000) {
        let (_, _, gamma, spin) = letters(&machine);
        for (w, _, _) in numerical_modes(&machine) {
            let q = (I * w * (2.0 * spin) + gamma * spin) / denominator(w, &machine);
            assert!((q - I).norm().min((q + I).norm()) < 1e-6, "{q}"); // a quotient of differences of eigenvalues
        }
    }
}

#[test]
fn eq30_quadratic_corrected_holds_and_printed_fails() {
    for machine in separated(30, 1000) {
        let (w0, _, gamma, spin) = letters(&machine);
        let quadratic = |w: Complex<f64>, sign: f64, half: f64| {
            w * w - w * (Complex::new(sign * spin, half) * 2.0) - w0 * w0
                + spin * spin
                + I * (sign * gamma * spin)
        };
        for (w, _, _) in numerical_modes(&machine) {
            let best = |half: f64| {
                quadratic(w, 1.0, half).norm().min(quadratic(w, -1.0, half).norm()) / scale(&machine)
            };
            assert!(best(gamma / 2.0) < EIGEN);
            // With the printed sign the residual is 2Γ|ω| away from zero.
            assert!(best(-gamma / 2.0) > 1e-3 * gamma * w.norm() / scale(&machine));
        }
    }
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
        // In units of the fastest rate all entries are of one size, which the eigenvalue solver needs for its accuracy.
        let fastest = w0 + gamma + spin.abs();
        let units = Matrix4::from_diagonal(&nalgebra::Vector4::new(fastest, 1.0, fastest, 1.0));
        let balanced = units * linearised(&machine) * units.try_inverse().unwrap();
        let mut eigenvalues: Vec<Complex<f64>> = balanced.complex_eigenvalues().iter().copied().collect();
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
fn eq31_at_critical_damping_the_four_frequencies_meet_in_two() {
    let machine = washer().with_damping(600.0).unwrap(); // Γ = 20 = 2 ω₀
    for mode in machine.modes() {
        assert_eq!(mode.frequency.re.abs(), 30.0);
        assert_eq!(mode.frequency.im, 10.0);
    }
}

#[test]
fn eq31_slow_rate_keeps_its_digits_with_heavy_damping() {
    for ratio in [1e4, 1e6, 1e8] {
        let machine = washer().with_damping(300.0 * ratio).unwrap();
        let (w0, _, gamma, _) = letters(&machine);
        let slow = machine.modes().iter().map(|mode| mode.frequency.im).fold(f64::MAX, f64::min);
        let x = (w0 / gamma).powi(2);
        let series = w0 * w0 / gamma * (1.0 + x + 2.0 * x * x); // the small root of λ² − Γλ + ω₀²
        assert_relative_eq!(slow, series, max_relative = 1e-15);
    }
}

#[test]
fn every_disturbance_decays_with_the_time_two_over_gamma() {
    // A simulation of the lab equation, large disturbance and all: its distance from the steady motion shrinks as e^{−Γt/2}.
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
        let end = solver.solve(|t, y| machine.cartesian_rates(t, y), 0.0, start.to_array(), t).unwrap();
        assert_relative_eq!(
            away(Shaft::from_array(end.state), t),
            first * (-gamma * t / 2.0).exp(),
            max_relative = 1e-8
        );
    }
    assert!(2.0 / gamma > 1.0 / machine.natural_frequency()); // what Γ < 2ω₀ says
}

#[test]
fn the_slowest_mode_stands_still_when_the_spin_passes_w1() {
    let machine = washer();
    let w1 = (100.0_f64 - 2.25).sqrt();
    let slowest = |spin: f64| {
        machine
            .with_spin(spin)
            .unwrap()
            .modes()
            .iter()
            .map(|mode| mode.frequency.re.abs())
            .fold(f64::MAX, f64::min)
    };
    assert!(slowest(w1) < 1e-13);
    assert_relative_eq!(slowest(w1 + 0.5), 0.5, max_relative = ROUNDING * 1e2);
}

#[test]
fn a_damper_on_the_radius_alone_turns_stability_round() {
    // The quartic is the characteristic polynomial of the dual-number linearisation without the drag across the radius; at the
    // steady motion of that machine, sin φ₀ = 0 and r₀ = b Ω²/|ω₀² − Ω²|.
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
        let start = Shaft::from_polar([r0 * 1.001, -phi0, 0.0, spin]).to_array();
        let end = Dop853::new(1e-12)
            .unwrap()
            .solve(|t, y| machine.radial_damping_rates(t, y), 0.0, start, time)
            .unwrap();
        (end.state[0].hypot(end.state[1]) / r0 - 1.0).abs() / 1e-3
    };
    assert!(growth(5.0, 100.0) < 0.01);
    assert!(growth(15.0, 20.0) > 10.0);
}

//! Equations (22) to (30): small disturbances in polar coordinates.

use super::{ROUNDING, letters, machines, washer};
use crate::printed::corrected_holds_and_printed_fails;
use mechanics::scenes::laundromat::Machine;
use nalgebra::{Complex, Matrix4, SVector};
use num_dual::{DualNum, DualSVec64, jacobian};

const I: Complex<f64> = Complex::new(0.0, 1.0);

type Vector<D> = SVector<D, 4>;

/// (ε̇, ε̈, δ̇, δ̈) as functions of (ε, ε̇, δ, δ̇): (10) and (11) with r = r₀(1 + ε), θ = Ωt − φ₀ + δ and nothing
/// neglected.
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
pub(crate) fn scale(machine: &Machine) -> f64 {
    let (w0, _, gamma, spin) = letters(machine);
    1.0 + w0 * w0 + spin * spin + gamma * (1.0 + spin.abs())
}

/// The eigenvalues of the linearisation. In units of the fastest rate all entries are of one size, which the
/// eigenvalue solver needs for its accuracy.
pub(crate) fn eigenvalues(machine: &Machine) -> Vec<Complex<f64>> {
    let (w0, _, gamma, spin) = letters(machine);
    let fastest = w0 + gamma + spin.abs();
    let units = Matrix4::from_diagonal(&nalgebra::Vector4::new(fastest, 1.0, fastest, 1.0));
    let balanced = units * linearised(machine) * units.try_inverse().unwrap();
    balanced.complex_eigenvalues().iter().copied().collect()
}

/// The complex amplitudes (ω, ε₀, δ₀) of the modes, found from the linearised equations alone: for each eigenvalue s
/// = iω of the dual-number matrix the null vector gives δ₀/ε₀ from the radial row. The amplitude ε₀ is free: no
/// equation may take it for one.
pub(crate) fn numerical_modes(machine: &Machine) -> Vec<(Complex<f64>, Complex<f64>, Complex<f64>)> {
    let a = linearised(machine);
    let e0 = Complex::new(0.6, -1.9);
    let ratio = |s: Complex<f64>| {
        // s² ε₀ = (a₁₀ + a₁₁ s) ε₀ + (a₁₂ + a₁₃ s) δ₀
        (s * s - s * a[(1, 1)] - a[(1, 0)]) / (s * a[(1, 3)] + a[(1, 2)])
    };
    eigenvalues(machine).into_iter().map(|s| (s / I, e0, e0 * ratio(s))).collect()
}

/// Machines well away from critical damping, where eigenvalues coincide and no numerical eigenvector is trustworthy.
pub(crate) fn separated(seed: u64, count: usize) -> impl Iterator<Item = Machine> {
    machines(seed, count).filter(|machine| {
        let (w0, _, gamma, spin) = letters(machine);
        let w1 = (w0 * w0 - gamma * gamma / 4.0).abs().sqrt();
        gamma < 1.8 * w0 && spin.abs() < 10.0 * w0 && (spin.abs() - w1).abs() > 0.05 * w0
    })
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
    for machine in machines(24, 200) {
        let (phi0, push) = (machine.steady().unwrap().phase(), bend(&machine).norm());
        let slopes = [phi0.sin(), -phi0.cos()];
        for delta in [1e-3, 1e-5] {
            assert!(((phi0 - delta).cos() - (phi0.cos() + delta * slopes[0])).abs() < delta * delta);
            assert!(((phi0 - delta).sin() - (phi0.sin() + delta * slopes[1])).abs() < delta * delta);
        }
        // They are all that the angle does in the two rows of the library's matrix.
        let matrix = machine.stability_matrix();
        for (row, slope) in [1, 3].into_iter().zip(slopes) {
            assert!((matrix[(row, 2)] - push * slope).abs() < 1e-11 * push, "row {row}");
        }
    }
}

/// Left side less right side, in units of the term that the slip concerns.
type Residual = fn(Complex<f64>, Complex<f64>, Complex<f64>, &Machine) -> Complex<f64>;

/// The corrected and the printed form of a linearised equation on all modes of many machines: those of the dual-number
/// linearisation, and those that the library gives.
fn on_modes(seed: u64, corrected: Residual, printed: Residual) -> Vec<(f64, f64)> {
    let mut cases = Vec::new();
    for machine in separated(seed, 1000) {
        let e0 = Complex::new(-0.3, 1.4);
        let library = machine.modes().map(|mode| (mode.frequency, e0, mode.shape * e0));
        for (w, e0, d0) in numerical_modes(&machine).into_iter().chain(library) {
            cases.push((corrected(w, e0, d0, &machine).norm(), printed(w, e0, d0, &machine).norm()));
        }
    }
    assert!(cases.len() > 800, "{}", cases.len());
    cases
}

/// Eigenvalues of a 4 × 4 matrix and what follows from them, relative to terms that may be a ten thousandth of the
/// largest.
const EIGEN: f64 = 1e-6;

/// The terms of (25) and (27) that hold b/r₀, from the radius and the phase of the library.
fn bend(machine: &Machine) -> Complex<f64> {
    let steady = machine.steady().unwrap();
    let push = machine.offset() * machine.spin().powi(2) / steady.radius();
    Complex::from_polar(push, steady.phase())
}

#[test]
fn eq25_radial_linearisation_corrected_holds_and_printed_fails() {
    let corrected: Residual = |w, e0, d0, machine| {
        let (w0, _, gamma, spin) = letters(machine);
        let right = e0 * spin * spin + I * w * d0 * (2.0 * spin) + d0 * bend(machine).im
            - e0 * w0 * w0
            - I * w * gamma * e0;
        (-w * w * e0 - right) / (spin * spin)
    };
    let printed: Residual = |w, e0, d0, machine| {
        let (w0, _, gamma, spin) = letters(machine);
        let right =
            spin * spin + I * d0 * (2.0 * spin) + d0 * bend(machine).im - e0 * w0 * w0 - I * w * gamma * e0;
        (-w * w * e0 - right) / (spin * spin)
    };
    corrected_holds_and_printed_fails(on_modes(25, corrected, printed), EIGEN, 0.1);
}

/// The denominator of (26) and (28).
fn denominator(w: Complex<f64>, machine: &Machine) -> Complex<f64> {
    let (w0, _, gamma, spin) = letters(machine);
    w * w - w0 * w0 + spin * spin - I * w * gamma
}

#[test]
fn eq26_radial_ratio_corrected_holds_and_printed_fails() {
    let corrected: Residual = |w, e0, d0, machine| {
        let (_, _, gamma, spin) = letters(machine);
        let numerator = I * w * (2.0 * spin) + gamma * spin;
        (e0 * denominator(w, machine) + numerator * d0) / (gamma * spin)
    };
    let printed: Residual = |w, e0, d0, machine| {
        let (_, _, gamma, spin) = letters(machine);
        let numerator = I * w * (2.0 * spin) + w * gamma;
        (e0 * denominator(w, machine) + numerator * d0) / (gamma * spin)
    };
    corrected_holds_and_printed_fails(on_modes(26, corrected, printed), EIGEN, 0.1);
}

#[test]
fn eq27_azimuthal_linearisation_holds_with_the_spin_for_the_stray_symbol() {
    let corrected: Residual = |w, e0, d0, machine| {
        let (_, _, gamma, spin) = letters(machine);
        let right = -w * w * d0
            + I * w * e0 * (2.0 * spin)
            + d0 * bend(machine).re
            + e0 * (gamma * spin)
            + I * w * gamma * d0;
        right / (gamma * spin)
    };
    // "Ω₀" is not defined in the source; the natural frequency is its likeliest reading.
    let printed: Residual = |w, e0, d0, machine| {
        let (w0, _, gamma, spin) = letters(machine);
        let right = -w * w * d0
            + I * w * e0 * (2.0 * spin)
            + d0 * bend(machine).re
            + e0 * (gamma * w0)
            + I * w * gamma * d0;
        right / (gamma * spin)
    };
    corrected_holds_and_printed_fails(on_modes(27, corrected, printed), EIGEN, 0.1);
}

#[test]
fn eq28_azimuthal_ratio_holds() {
    let printed: Residual = |w, e0, d0, machine| {
        let (_, _, gamma, spin) = letters(machine);
        (d0 * denominator(w, machine) - (I * w * (2.0 * spin) + gamma * spin) * e0) / (gamma * spin)
    };
    let worst = on_modes(28, printed, printed).iter().map(|(miss, _)| *miss).fold(0.0, f64::max);
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
    // Each frequency solves the equation of one of the two signs; in units of the term with Γ.
    fn quadratic(w: Complex<f64>, machine: &Machine, half: f64) -> Complex<f64> {
        let (w0, _, gamma, spin) = letters(machine);
        [1.0, -1.0]
            .map(|sign| {
                let middle = w * 2.0 * Complex::new(sign * spin, half * gamma);
                (w * w - middle - w0 * w0 + spin * spin + I * (sign * gamma * spin)) / (w * gamma)
            })
            .into_iter()
            .min_by(|a, b| a.norm().total_cmp(&b.norm()))
            .unwrap()
    }
    let corrected: Residual = |w, _, _, machine| quadratic(w, machine, 0.5);
    let printed: Residual = |w, _, _, machine| quadratic(w, machine, -0.5);
    corrected_holds_and_printed_fails(on_modes(30, corrected, printed), EIGEN, 0.1);
}

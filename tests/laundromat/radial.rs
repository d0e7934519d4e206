//! The damper on the radius alone: its force, and its matrix, which is the derivative of the motion.

use super::machines;
use mechanics::scenes::laundromat::{Machine, MachineParameters, Polar, Shaft};
use nalgebra::{Complex, Matrix4, Vector4};

/// What central differences of step 1e-5 leave: 1e-10 of truncation and 1e-11 of rounding, relative to the largest
/// entry.
const DIFFERENCES: f64 = 1e-8;

/// (ε̇, ε̈, δ̇, δ̈) at (ε, ε̇, δ, δ̇) beside the steady motion of radius `r0` and lead `phi0`, from accelerations in
/// the laboratory.
fn disturbed(
    machine: &Machine,
    r0: f64,
    phi0: f64,
    rates: impl Fn(f64, &[f64; 4]) -> [f64; 4],
    x: &Vector4<f64>,
) -> Vector4<f64> {
    let spin = machine.spin();
    let [r, theta] = [r0 * (1.0 + x[0]), -phi0 + x[2]]; // at t = 0, when the load is at azimuth 0
    let [r_dot, theta_dot] = [r0 * x[1], spin + x[3]];
    let shaft = Shaft::from_polar(Polar::from_array([r, theta, r_dot, theta_dot]));
    let [_, _, ax, ay] = rates(0.0, &shaft.to_array());
    let turned = Complex::new(ax, ay) * Complex::from_polar(1.0, -theta);
    let r_ddot = turned.re + r * theta_dot.powi(2);
    let theta_ddot = (turned.im - 2.0 * r_dot * theta_dot) / r;
    Vector4::new(x[1], r_ddot / r0, x[3], theta_ddot)
}

fn differentiated(f: impl Fn(&Vector4<f64>) -> Vector4<f64>, rate: f64) -> Matrix4<f64> {
    let mut matrix = Matrix4::zeros();
    for column in 0..4 {
        // ε and δ are pure numbers, their rates are so many per second.
        let h = if column % 2 == 0 { 1e-5 } else { 1e-5 * rate };
        let mut step = Vector4::zeros();
        step[column] = h;
        matrix.set_column(column, &((f(&step) - f(&-step)) / (2.0 * h)));
    }
    matrix
}

fn assert_close(found: &Matrix4<f64>, expected: &Matrix4<f64>, what: &str) {
    let scale = expected.amax().max(1.0);
    assert!((found - expected).amax() < DIFFERENCES * scale, "{what}: {found} for {expected}");
}

#[test]
fn radial_damping_matrix_is_the_derivative_of_that_motion() {
    for machine in machines(2, 500) {
        // The damper does nothing in steady motion, so the radius and the lead are those of the undamped machine.
        let steady = machine.with_damping(0.0).unwrap().steady().unwrap();
        let rates = |t: f64, y: &[f64; 4]| machine.radial_damping_rates(t, y);
        let f = |x: &Vector4<f64>| disturbed(&machine, steady.radius(), steady.phase(), rates, x);
        let rate = machine.natural_frequency().max(machine.spin().abs());
        assert_close(&machine.radial_damping_matrix(), &differentiated(f, rate), "damping on the radius");
    }
}

#[test]
fn radial_damping_is_the_same_on_either_side_of_the_origin() {
    let machine = machines(3, 1).next().unwrap();
    let balanced = Machine::new(MachineParameters { load_radius: 0.0, ..machine.parameters() }).unwrap();
    let rates = |x: f64| balanced.radial_damping_rates(0.0, &[x, 0.0, 0.7, 0.0]);
    let drag = balanced.damping_rate() * 0.7;
    for x in [-1e-9, 0.0, 1e-9] {
        let [vx, vy, ax, ay] = rates(x);
        assert_eq!((vx, vy, ay), (0.7, 0.0, 0.0));
        assert!((ax + drag).abs() < 1e-6 * drag, "at x = {x}: {ax}");
    }
    // Across the radius it does not brake at all.
    let [_, _, ax, ay] = balanced.radial_damping_rates(0.0, &[0.3, 0.0, 0.0, 0.7]);
    let pull = balanced.natural_frequency().powi(2) * 0.3;
    assert!((ax + pull).abs() < 1e-14 * pull && ay == 0.0);
}

#[test]
fn a_radial_damper_resists_what_leads_away_from_the_centre() {
    // At (3, 4) m: all of a velocity along (3, 4), and nothing of one across.
    let parameters = MachineParameters {
        drum_mass: 1.0,
        load_mass: 1.0,
        load_radius: 1.0,
        stiffness: 3.0,
        damping: 0.7,
        spin: 0.0,
    };
    let machine = Machine::new(parameters).unwrap();
    for [along, across] in [[1.0, 0.0], [0.0, 1.0], [2.0, -0.5]] {
        let (vx, vy) = (0.6 * along - 0.8 * across, 0.8 * along + 0.6 * across);
        let [_, _, ax, ay] = machine.radial_damping_rates(0.0, &[3.0, 4.0, vx, vy]);
        let [spring_x, spring_y] = [-3.0, -4.0].map(|x| x * machine.natural_frequency().powi(2));
        let damping = machine.damping_rate() * along;
        assert!((ax - spring_x + 0.6 * damping).abs() < 1e-14, "{ax}");
        assert!((ay - spring_y + 0.8 * damping).abs() < 1e-14, "{ay}");
    }
}

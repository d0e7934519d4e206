//! Equations (6) to (15): the motion and how it is written down.

use crate::{ROUNDING, WASHER, letters, machines, washer};
use approx::assert_relative_eq;
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{Machine, Shaft};
use nalgebra::{Complex, SVector};
use num_dual::{DualNum, hessian, second_derivative};

/// An arbitrary smooth motion of the shaft in polar coordinates.
fn r<D: DualNum<Primitive = f64>>(t: D) -> D {
    (t * 1.7).sin() * 0.02 + 0.05
}
fn theta<D: DualNum<Primitive = f64>>(t: D) -> D {
    (t.clone() * 0.8).cos() * 0.6 + t * 2.1
}

/// The Cartesian position of the load on that motion.
fn load<D: DualNum<Primitive = f64>>(t: D) -> (D, D) {
    let (r, theta, phi) = (r(t.clone()), theta(t.clone()), t * WASHER.spin);
    (
        r.clone() * theta.cos() + phi.cos() * WASHER.load_radius,
        r * theta.sin() + phi.sin() * WASHER.load_radius,
    )
}

const TIMES: [f64; 4] = [0.0, 0.3, 1.9, 7.7];

/// Compares Cartesian components with components along r̂ and θ̂.
fn assert_same(cartesian: Complex<f64>, radial: f64, azimuthal: f64, theta: f64) {
    let turned = cartesian * Complex::from_polar(1.0, -theta);
    let scale = cartesian.norm();
    assert!(
        (turned - Complex::new(radial, azimuthal)).norm() < ROUNDING * scale,
        "{turned} is not {radial} + {azimuthal}i"
    );
}

#[test]
fn eq06_newtons_law_holds_along_a_simulated_motion() {
    // The centre of mass of the simulated motion is accelerated by the suspension's force alone: M r̈ + m r̈ₘ = −k r − γ ṙ.
    let machine = washer();
    let (h, mid) = (1e-3, 0.8);
    let times: Vec<f64> = (-3..=3).map(|n| mid + f64::from(n) * h).collect();
    let (states, _) = Dop853::new(1e-14)
        .unwrap()
        .sample(|t, y| machine.cartesian_rates(t, y), 0.0, [0.01, 0.02, 0.3, -0.1], &times)
        .unwrap();
    let momentum_sum = |n: usize| {
        let z = Complex::new(states[n][0], states[n][1]);
        let load = z + Complex::from_polar(WASHER.load_radius, WASHER.spin * times[n]);
        z * WASHER.drum_mass + load * WASHER.load_mass
    };
    // Second difference of order six.
    let weights = [2.0, -27.0, 270.0, -490.0, 270.0, -27.0, 2.0];
    let acceleration = (0..7).map(|n| momentum_sum(n) * weights[n]).sum::<Complex<f64>>() / (180.0 * h * h);
    let [x, y, vx, vy] = states[3];
    let force = -(Complex::new(x, y) * WASHER.stiffness + Complex::new(vx, vy) * WASHER.damping);
    assert!((acceleration - force).norm() < 1e-6 * force.norm(), "{acceleration} is not {force}"); // differences: ε/h²
}

#[test]
fn eq07_position_of_the_load_in_polar_components() {
    for t in TIMES {
        let (x, y) = load(t);
        let lead = WASHER.spin * t - theta(t);
        let a = WASHER.load_radius;
        assert_same(Complex::new(x, y), r(t) + a * lead.cos(), a * lead.sin(), theta(t));
    }
}

/// Value, first and second derivative of r and θ, by dual numbers.
fn polar(t: f64) -> ([f64; 3], [f64; 3]) {
    let (r0, r1, r2) = second_derivative(r, t);
    let (t0, t1, t2) = second_derivative(theta, t);
    ([r0, r1, r2], [t0, t1, t2])
}

#[test]
fn eq08_velocity_of_the_load_by_dual_numbers() {
    for t in TIMES {
        let (_, vx, _) = second_derivative(|t| load(t).0, t);
        let (_, vy, _) = second_derivative(|t| load(t).1, t);
        let ([r, r_dot, _], [theta, theta_dot, _]) = polar(t);
        let (sin, cos) = (WASHER.spin * t - theta).sin_cos();
        let speed = WASHER.load_radius * WASHER.spin;
        assert_same(Complex::new(vx, vy), r_dot - speed * sin, r * theta_dot + speed * cos, theta);
    }
}

#[test]
fn eq09_acceleration_of_the_load_by_dual_numbers() {
    for t in TIMES {
        let (_, _, ax) = second_derivative(|t| load(t).0, t);
        let (_, _, ay) = second_derivative(|t| load(t).1, t);
        let ([r, r_dot, r_ddot], [theta, theta_dot, theta_ddot]) = polar(t);
        let (sin, cos) = (WASHER.spin * t - theta).sin_cos();
        let pull = WASHER.load_radius * WASHER.spin.powi(2);
        let radial = r_ddot - r * theta_dot.powi(2) - pull * cos;
        let azimuthal = r * theta_ddot + 2.0 * r_dot * theta_dot - pull * sin;
        assert_same(Complex::new(ax, ay), radial, azimuthal, theta);
    }
}

/// The polar accelerations (r̈, θ̈) that the library computes, against those of the Cartesian law, turned.
fn polar_from_lab(machine: &Machine, t: f64, state: [f64; 4]) -> (f64, f64) {
    let [r, theta, r_dot, theta_dot] = state;
    let (w0, b, gamma, spin) = letters(machine);
    let outwards = Complex::from_polar(1.0, theta);
    let (z, v) = (outwards * r, outwards * Complex::new(r_dot, r * theta_dot));
    let acceleration = Complex::from_polar(b * spin * spin, spin * t) - v * gamma - z * (w0 * w0);
    let turned = acceleration * outwards.conj();
    (turned.re + r * theta_dot.powi(2), (turned.im - 2.0 * r_dot * theta_dot) / r)
}

#[test]
fn eq10_radial_motion_is_newtons_law_along_the_radius() {
    for machine in machines(10, 200) {
        let state = [0.03, 0.7, -0.4, 5.0];
        let [_, _, r_ddot, _] = machine.polar_rates(0.9, &state);
        let scale =
            machine.offset() * machine.spin().powi(2) + 0.03 * machine.natural_frequency().powi(2) + 1.0;
        assert!(
            (r_ddot - polar_from_lab(&machine, 0.9, state).0).abs()
                < ROUNDING * scale * (1.0 + machine.damping_rate())
        );
    }
}

#[test]
fn eq11_azimuthal_motion_is_newtons_law_across_the_radius() {
    for machine in machines(11, 200) {
        let state = [0.03, 0.7, -0.4, 5.0];
        let [_, _, _, theta_ddot] = machine.polar_rates(0.9, &state);
        let scale =
            (machine.offset() * machine.spin().powi(2) + 1.0) / 0.03 + machine.natural_frequency().powi(2);
        let expected = polar_from_lab(&machine, 0.9, state).1;
        assert!((theta_ddot - expected).abs() < ROUNDING * scale * (1.0 + machine.damping_rate()));
    }
}

#[test]
fn eq10_and_eq11_give_the_same_motion_as_the_lab() {
    // Away from O the two programs must agree as far as the integrator's tolerance lets them.
    let machine = washer();
    let start = [0.05, 0.3, 0.1, 25.0];
    let solver = Dop853::new(1e-13).unwrap();
    let polar = solver.solve(|t, y| machine.polar_rates(t, y), 0.0, start, 2.0).unwrap();
    let lab = solver
        .solve(|t, y| machine.cartesian_rates(t, y), 0.0, Shaft::from_polar(start).to_array(), 2.0)
        .unwrap();
    let difference = Shaft::from_polar(polar.state).position - Shaft::from_array(lab.state).position;
    assert!(difference.norm() < 1e-11 * machine.offset(), "they part by {} m", difference.norm());
}

#[test]
fn eq12_natural_frequency_is_that_of_the_free_swing() {
    // A balanced, undamped drum that is pushed aside comes back after 2π/ω₀.
    let machine =
        Machine::new(mechanics::scenes::laundromat::Parameters { load_mass: 0.0, damping: 0.0, ..WASHER })
            .unwrap();
    let period = std::f64::consts::TAU / machine.natural_frequency();
    let end = Dop853::new(1e-14)
        .unwrap()
        .solve(|t, y| machine.cartesian_rates(t, y), 0.0, [0.01, 0.0, 0.0, 0.0], period)
        .unwrap();
    assert!((end.state[0] - 0.01).abs() < 1e-13 && end.state[2].abs() < 1e-12);
    assert_relative_eq!(
        machine.natural_frequency().powi(2),
        WASHER.stiffness / WASHER.drum_mass,
        max_relative = ROUNDING
    );
}

#[test]
fn eq13_offset_is_where_the_masses_balance() {
    for machine in machines(13, 200) {
        let p = machine.parameters();
        let b = machine.offset();
        assert_relative_eq!(p.drum_mass * b, p.load_mass * (p.load_radius - b), max_relative = ROUNDING);
    }
}

#[test]
fn eq14_damping_rate_is_how_fast_energy_leaks() {
    // Without a load the power lost is Γ times twice the kinetic energy, so of one swing e^{−Γt} remains.
    let p = mechanics::scenes::laundromat::Parameters { load_mass: 0.0, damping: 2.8, ..WASHER };
    let machine = Machine::new(p).unwrap();
    let w1 = (machine.natural_frequency().powi(2) - machine.damping_rate().powi(2) / 4.0).sqrt();
    let turns = 20.0 * std::f64::consts::TAU / w1;
    let start = Shaft { position: 0.01.into(), velocity: 0.0.into() };
    let end = Dop853::new(1e-14)
        .unwrap()
        .solve(|t, y| machine.cartesian_rates(t, y), 0.0, start.to_array(), turns)
        .unwrap();
    let ratio = (end.state[0].powi(2) + end.state[1].powi(2)) / 1e-4;
    assert_relative_eq!(ratio.ln(), -machine.damping_rate() * turns, max_relative = 1e-10); // DOP853 at 1e-14 over 20 swings
}

/// The Lagrangian at (r, θ, ṙ, θ̇, t), without the constant term, with its first cross term made from `first`.
fn lagrangian<D: DualNum<Primitive = f64>>(x: &SVector<D, 5>, first: impl Fn(D, D, D) -> D) -> D {
    let [r, theta, r_dot, theta_dot, t] = std::array::from_fn(|i| x[i].clone());
    let lead = t * WASHER.spin - theta.clone();
    let mass = WASHER.drum_mass + WASHER.load_mass;
    let unbalance = WASHER.load_mass * WASHER.load_radius * WASHER.spin;
    let speed = r_dot.clone() * r_dot.clone() + r.clone() * r.clone() * theta_dot.clone() * theta_dot.clone();
    let cross =
        -(first(r.clone(), r_dot, theta_dot.clone()) * lead.sin()) + r.clone() * theta_dot * lead.cos();
    speed * (0.5 * mass) + cross * unbalance - r.clone() * r * (0.5 * WASHER.stiffness)
}

/// (r̈, θ̈) from the equations of Euler and Lagrange, d/dt ∂L/∂q̇ = ∂L/∂q, by second derivatives of L.
fn euler_lagrange(
    gradient: &SVector<f64, 5>,
    h: &nalgebra::SMatrix<f64, 5, 5>,
    r_dot: f64,
    theta_dot: f64,
) -> (f64, f64) {
    let right = |i: usize| gradient[i] - h[(i + 2, 0)] * r_dot - h[(i + 2, 1)] * theta_dot - h[(i + 2, 4)];
    let mass = h.fixed_view::<2, 2>(2, 2).into_owned();
    let solved = mass.lu().solve(&nalgebra::Vector2::new(right(0), right(1))).unwrap();
    (solved[0], solved[1])
}

#[test]
fn eq15_the_corrected_lagrangian_gives_the_motion_and_the_printed_one_does_not() {
    let machine = washer().with_damping(0.0).unwrap();
    for (t, state) in
        [(0.4, [0.03, 0.7, -0.4, 5.0]), (2.2, [0.08, -1.2, 0.9, 31.0]), (9.1, [0.01, 2.9, 0.0, -3.0])]
    {
        let [r, theta, r_dot, theta_dot] = state;
        let x = SVector::from([r, theta, r_dot, theta_dot, t]);
        let [_, _, r_ddot, theta_ddot] = machine.polar_rates(t, &state);

        let (_, gradient, h) = hessian(|x| lagrangian(&x, |_r, r_dot, _theta_dot| r_dot), &x);
        let corrected = euler_lagrange(&gradient, &h, r_dot, theta_dot);
        assert_relative_eq!(corrected.0, r_ddot, max_relative = 1e-12); // cancellation of a few terms
        assert_relative_eq!(corrected.1, theta_ddot, max_relative = 1e-12);

        let (_, gradient, h) = hessian(|x| lagrangian(&x, |r, _r_dot, theta_dot| r * theta_dot), &x);
        let printed = euler_lagrange(&gradient, &h, r_dot, theta_dot);
        assert!(
            (printed.0 - r_ddot).abs() + r * (printed.1 - theta_ddot).abs()
                > 0.1 * (r_ddot.abs() + r * theta_ddot.abs())
        );
    }
}

#[test]
fn the_source_places_the_centre_of_mass_at_the_load() {
    // "distance a away" in the introduction of the solution is the load's distance; the centre of mass is at b = ma/(m+M).
    let machine = washer();
    let centre = (WASHER.load_mass * WASHER.load_radius) / (WASHER.load_mass + WASHER.drum_mass);
    assert_relative_eq!(machine.offset(), centre, max_relative = ROUNDING);
    assert!(machine.offset() < 0.1 * WASHER.load_radius);
}

//! Equations (6) to (15): the motion and how it is written down.

use super::{ROUNDING, WASHER, letters, machines, newton, washer};
use crate::common::any;
use crate::printed::corrected_holds_and_printed_fails;
use approx::assert_relative_eq;
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{Machine, MachineParameters, Polar, Shaft};
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
    // The centre of mass of the simulated motion is accelerated by the suspension's force alone: M r̈ + m r̈ₘ = −k r
    // − γ ṙ.
    let machine = washer();
    let (h, mid) = (1e-3, 0.8);
    let times: Vec<f64> = (-3..=3).map(|n| mid + f64::from(n) * h).collect();
    let (states, _) = Dop853::new(1e-14)
        .unwrap()
        .sample(any(|t, y| machine.cartesian_rates(t, y)), 0.0, [0.01, 0.02, 0.3, -0.1], &times)
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
        // The library's centre of mass lies between drum and this load.
        let shaft = Complex::from_polar(r(t), theta(t));
        let centre = washer().centre_of_mass(t, &Shaft { position: shaft, velocity: 0.0.into() });
        let between = shaft * WASHER.drum_mass + Complex::new(x, y) * WASHER.load_mass;
        assert!((centre * washer().total_mass() - between).norm() < ROUNDING * between.norm());
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
        // The library's energy is that of drum, of a load with this velocity, and of the spring.
        let energy = 0.5 * WASHER.drum_mass * (r_dot.powi(2) + (r * theta_dot).powi(2))
            + 0.5 * WASHER.load_mass * (vx * vx + vy * vy)
            + 0.5 * WASHER.stiffness * r * r;
        let shaft = Shaft::from_polar(Polar::from_array([r, theta, r_dot, theta_dot]));
        assert_relative_eq!(washer().energy(t, &shaft), energy, max_relative = ROUNDING);
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
        // With the library's r̈ and θ̈ at this place and speed, the same components make Newton's law (6) hold.
        let [_, _, r_ddot, theta_ddot] = washer().polar_rates(t, &[r, theta, r_dot, theta_dot]);
        let drum = Complex::new(r_ddot - r * theta_dot.powi(2), r * theta_ddot + 2.0 * r_dot * theta_dot);
        let load = drum - Complex::new(pull * cos, pull * sin);
        let suspension =
            Complex::from(r) * WASHER.stiffness + Complex::new(r_dot, r * theta_dot) * WASHER.damping;
        let sum = drum * WASHER.drum_mass + load * WASHER.load_mass + suspension;
        assert!(sum.norm() < ROUNDING * (suspension.norm() + WASHER.load_mass * pull), "{sum} N are left");
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
fn eq10_and_eq11_are_newtons_law_along_and_across_the_radius() {
    for machine in machines(10, 200) {
        let (w0, b, gamma, spin) = letters(&machine);
        let state = [0.03, 0.7, -0.4, 5.0];
        let [_, _, r_ddot, theta_ddot] = machine.polar_rates(0.9, &state);
        let (radial, azimuthal) = polar_from_lab(&machine, 0.9, state);
        let scale = (b * spin * spin + 0.03 * w0 * w0 + 1.0) * (1.0 + gamma);
        assert!((r_ddot - radial).abs() < ROUNDING * scale);
        assert!((theta_ddot - azimuthal).abs() < ROUNDING * scale / 0.03);
    }
}

#[test]
fn eq10_and_eq11_give_the_same_motion_as_the_lab() {
    // Away from O the two programs must agree as far as the integrator's tolerance lets them.
    let machine = washer();
    let start = [0.05, 0.3, 0.1, 25.0];
    let solver = Dop853::new(1e-13).unwrap();
    let polar = solver.solve(any(|t, y| machine.polar_rates(t, y)), 0.0, start, 2.0).unwrap();
    let in_lab = |state: [f64; 4]| Shaft::from_polar(Polar::from_array(state));
    let lab = |t: f64, y: &[f64; 4]| machine.cartesian_rates(t, y);
    let lab = solver.solve(any(lab), 0.0, in_lab(start).to_array(), 2.0).unwrap();
    let difference = in_lab(polar.state).position - Shaft::from_array(lab.state).position;
    assert!(difference.norm() < 1e-11 * machine.offset(), "they part by {} m", difference.norm());
}

/// State at time `t` of the motion from `start`, less that of the motion from rest at O, both by Newton's law with
/// the raw parameters. The pull of the load drops out of the difference; its mass does not.
fn difference(p: &MachineParameters, start: [f64; 4], t: f64) -> [f64; 4] {
    let solver = Dop853::new(1e-14).unwrap();
    let [moved, rest] = [start, [0.0; 4]]
        .map(|start| solver.solve(any(|t, y: &[f64; 4]| newton(p, t, y)), 0.0, start, t).unwrap().state);
    std::array::from_fn(|i| moved[i] - rest[i])
}

#[test]
fn eq12_natural_frequency_is_that_of_the_free_swing() {
    // Without damping two motions of one machine, loaded as it is, swing about each other with the period 2π/ω₀.
    for machine in machines(12, 40) {
        let p = MachineParameters {
            load_mass: 0.5 * machine.parameters().drum_mass,
            damping: 0.0,
            ..machine.parameters()
        };
        let w0 = Machine::new(p).unwrap().natural_frequency();
        let period = std::f64::consts::TAU / w0;
        let start = [p.load_radius, 0.0, 0.0, 0.0];
        let [x, y, vx, _] = difference(&p, start, 0.125 * period);
        assert_relative_eq!(x, p.load_radius * 0.5_f64.sqrt(), max_relative = 1e-10);
        assert_relative_eq!(vx, -w0 * x, max_relative = 1e-10);
        assert!(y.abs() < 1e-10 * p.load_radius);
        let [x, _, vx, _] = difference(&p, start, 5.0 * period);
        assert!((x - p.load_radius).abs() < 1e-9 * p.load_radius && vx.abs() < 1e-8 * w0 * p.load_radius);
        // The drum alone would swing faster by √1.5.
        let without_load = (p.stiffness / p.drum_mass).sqrt();
        assert_relative_eq!(without_load / w0, 1.5_f64.sqrt(), max_relative = ROUNDING);
    }
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
fn eq14_damping_rate_is_how_fast_two_motions_close_up() {
    // The area x₁ẋ₂ − x₂ẋ₁ between two motions shrinks as e^{−Γt} and as nothing else: no spring, no load has a part
    // in it.
    for machine in machines(14, 40) {
        let p = MachineParameters { load_mass: 0.5 * machine.parameters().drum_mass, ..machine.parameters() };
        let machine = Machine::new(p).unwrap();
        let speed = p.load_radius * machine.natural_frequency();
        let time = 1.0 / machine.damping_rate().max(0.1 * machine.natural_frequency());
        let [x1, _, v1, _] = difference(&p, [p.load_radius, 0.0, 0.0, 0.0], time);
        let [x2, _, v2, _] = difference(&p, [0.0, 0.0, speed, 0.0], time);
        let rate = -((x1 * v2 - x2 * v1) / (p.load_radius * speed)).ln() / time;
        let error = (rate - machine.damping_rate()).abs() * time;
        assert!(error < 1e-9, "{rate} for {}", machine.damping_rate());
    }
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
    let mut random = fastrand::Rng::with_seed(15);
    let mut between = |low: f64, high: f64| low + (high - low) * random.f64();
    let cases = (0..100).map(|_| {
        let state = [between(0.01, 0.1), between(-3.0, 3.0), between(-1.0, 1.0), between(-30.0, 30.0)];
        let ([r, theta, r_dot, theta_dot], t) = (state, between(0.0, 10.0));
        let x = SVector::from([r, theta, r_dot, theta_dot, t]);
        let [_, _, r_ddot, theta_ddot] = machine.polar_rates(t, &state);
        let miss = |(radial, turning): (f64, f64)| {
            ((radial - r_ddot).abs() + r * (turning - theta_ddot).abs())
                / (r_ddot.abs() + r * theta_ddot.abs())
        };
        let (_, gradient, h) = hessian(|x| lagrangian(&x, |_r, r_dot, _theta_dot| r_dot), &x);
        let corrected = euler_lagrange(&gradient, &h, r_dot, theta_dot);
        let (_, gradient, h) = hessian(|x| lagrangian(&x, |r, _r_dot, theta_dot| r * theta_dot), &x);
        let printed = euler_lagrange(&gradient, &h, r_dot, theta_dot);
        (miss(corrected), miss(printed))
    });
    corrected_holds_and_printed_fails(cases, 1e-11, 0.1); // cancellation of a few terms
}

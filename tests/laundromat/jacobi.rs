//! The Jacobi integral: what it is, what dampers do to it, and that it stays.

use super::unit_machine;
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use nalgebra::Complex;

#[test]
fn jacobi_integral_is_energy_less_spin_times_angular_momentum() {
    // Of drum and load, in the laboratory; over the mass, and less what the load at rest about O has of it.
    let mut random = fastrand::Rng::with_seed(31);
    for _ in 0..1000 {
        let mut number = || 3.0 * random.f64() - 1.5;
        let (time, shaft) = (5.0 * number(), Shaft::from_array(std::array::from_fn(|_| number())));
        let parameters = MachineParameters {
            drum_mass: 2.0 + number(),
            load_mass: 2.0 + number(),
            load_radius: 2.0 + number(),
            stiffness: 2.0 + number(),
            damping: 0.0,
            spin: number(),
        };
        let MachineParameters { drum_mass, load_mass, load_radius, stiffness, spin, .. } = parameters;
        let arm = Complex::from_polar(load_radius, spin * time);
        let load = [shaft.position + arm, shaft.velocity + Complex::i() * spin * arm];
        let momentum = |[place, rate]: [Complex<f64>; 2]| (place.conj() * rate).im;
        let momentum = drum_mass * momentum([shaft.position, shaft.velocity]) + load_mass * momentum(load);
        let energy = drum_mass * shaft.velocity.norm_sqr()
            + load_mass * load[1].norm_sqr()
            + stiffness * shaft.position.norm_sqr();
        let at_centre = load_mass * (load_radius * spin).powi(2);
        let expected = (0.5 * energy - spin * momentum + 0.5 * at_centre) / (drum_mass + load_mass);
        let ours = Machine::new(parameters).unwrap().jacobi_integral(time, &shaft);
        assert!((ours - expected).abs() < 1e-13, "{parameters:?}: {ours} for {expected}");
    }
}

#[test]
fn a_damper_on_the_radius_takes_the_jacobi_integral_and_dampers_on_the_floor_also_lend() {
    // A moment earlier and later, with velocity and acceleration for the change of the shaft's state.
    let mut random = fastrand::Rng::with_seed(8);
    let mut lent = 0;
    for _ in 0..300 {
        let mut number = || 3.0 * random.f64() - 1.5;
        let (time, spin) = (5.0 * number(), 2.0 * number());
        let state: [f64; 4] = std::array::from_fn(|_| number());
        let damping = 2.0 + number();
        let machine = unit_machine(damping, spin);
        let gain = |rates: [f64; 4]| {
            let moment = 1e-5;
            let after = |t: f64| {
                let shaft = Shaft::from_array(std::array::from_fn(|n| state[n] + t * rates[n]));
                machine.jacobi_integral(time + t, &shaft)
            };
            (after(moment) - after(-moment)) / (2.0 * moment)
        };
        let [x, y, vx, vy] = state;
        let square = x * x + y * y;
        let (out, round) = ((x * vx + y * vy) / square.sqrt(), (x * vy - y * vx) / square); // ṙ and θ̇
        let taken = damping * (out * out + square * (round - spin).powi(2));
        let given = damping * spin * square * (spin - round);
        let found = gain(machine.cartesian_rates(time, &state));
        assert!((found - (given - taken)).abs() < 1e-7, "{found} for {}", given - taken); // eq:jacobi-floor
        let found = gain(machine.radial_damping_rates(time, &state));
        assert!((found + damping * out * out).abs() < 1e-7, "{found} for {}", -damping * out * out);
        lent += usize::from(given > taken);
    }
    assert!((30..270).contains(&lent), "{lent} of 300 gain");
}

#[test]
fn jacobi_integral_is_constant_for_a_billion_seconds() {
    for spin in [0.3, 0.999, 1.0, 1.001, 3.0, -3.0] {
        let machine = unit_machine(0.0, spin);
        let motion = machine.transient(Shaft::from_array([0.7, -0.4, -0.3, 0.9])).unwrap();
        let j = |t: f64| machine.jacobi_integral(t, &motion.at(t).unwrap());
        for t in [1.0, 1e3, 1e6, 1e9] {
            let shaft = motion.at(t).unwrap();
            // Rounding of the largest terms that J is the difference of.
            let scale = shaft.velocity.norm_sqr() + (1.0 + spin * spin) * shaft.position.norm_sqr() + 1.0;
            assert!((j(t) - j(0.0)).abs() < 1e-14 * scale, "Ω = {spin}, t = {t}: {} for {}", j(t), j(0.0));
        }
    }
}

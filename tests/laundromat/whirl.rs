//! Friction that turns with the drum: what it does to the roots, when it makes the shaft whirl, and the whole motion.

use super::{ROUNDING, letters, machines, newton, washer};
use approx::assert_relative_eq;
use mechanics::scenes::laundromat::{Machine, Rotor, Shaft};
use nalgebra::Complex;

const I: Complex<f64> = Complex::new(0.0, 1.0);

/// Newton's law with a dashpot on the drum: the place of the shaft on board, differentiated there, gives the
/// force, and this is turned back into the room.
fn with_friction_on_board(machine: &Machine, inner: f64, t: f64, state: &[f64; 4]) -> [f64; 4] {
    let p = machine.parameters();
    let (sin, cos) = (p.spin * t).sin_cos();
    let &[x, y, vx, vy] = state;
    // ξ = x cos + y sin, η = −x sin + y cos, and their rates.
    let on_board = [
        vx * cos + vy * sin + p.spin * (y * cos - x * sin),
        vy * cos - vx * sin - p.spin * (x * cos + y * sin),
    ];
    let [fx, fy] = on_board.map(|rate| -inner * rate);
    let [vx, vy, ax, ay] = newton(&p, t, state);
    let mass = p.drum_mass + p.load_mass;
    [vx, vy, ax + (fx * cos - fy * sin) / mass, ay + (fx * sin + fy * cos) / mass]
}

/// Machines with friction on board, γᵢ from a hundredth to a hundred times γ and so that both sides of the
/// threshold come.
fn rotors(seed: u64, count: usize) -> impl Iterator<Item = (Machine, f64, Rotor)> {
    let mut random = fastrand::Rng::with_seed(seed);
    machines(seed, count).map(move |machine| {
        let inner = machine.parameters().damping * 1e4_f64.powf(random.f64() - 0.5);
        (machine, inner, machine.rotor(inner).expect("a rotor"))
    })
}

/// The rates of a disturbance, by the law above at time zero: less what the load does.
fn free(machine: &Machine, inner: f64, state: [f64; 4]) -> [f64; 4] {
    let [with, without] = [state, [0.0; 4]].map(|state| with_friction_on_board(machine, inner, 0.0, &state));
    std::array::from_fn(|i| with[i] - without[i])
}

#[test]
fn the_rates_are_newtons_with_a_dashpot_that_turns() {
    let mut random = fastrand::Rng::with_seed(3);
    for (machine, inner, rotor) in rotors(1, 300) {
        let (w0, _, _, spin) = letters(&machine);
        let t = 3.0 / w0 * random.f64();
        let state: [f64; 4] = std::array::from_fn(|i| random.f64() * if i < 2 { 1.0 } else { w0 });
        let [a, b] = [with_friction_on_board(&machine, inner, t, &state), rotor.cartesian_rates(t, &state)];
        let rates = machine.damping_rate() + rotor.damping_rate_on_board();
        let size = (w0 + spin.abs()) * (w0 + rates + spin.abs()) * (1.0 + machine.offset());
        for (a, b) in a.iter().zip(b) {
            assert!((a - b).abs() < ROUNDING * size, "{a} {b}");
        }
    }
}

#[test]
fn the_roots_are_free_motions_and_growth_begins_at_the_threshold() {
    let (mut grow, mut die) = (0, 0);
    for (machine, inner, rotor) in rotors(2, 1000) {
        let (w0, _, rate, spin) = letters(&machine);
        let on_board = rotor.damping_rate_on_board();
        // A free motion e^{λt} has z = 1, ż = λ and z̈ = λ² at time zero; and the two roots are not one.
        let fastest = w0 + rate + on_board + spin.abs();
        let roots = rotor.roots();
        for root in roots {
            let [_, _, x, y] = free(&machine, inner, [1.0, 0.0, root.re, root.im]);
            let off = (Complex::new(x, y) - root * root).norm();
            assert!(off < 1e-13 * fastest * fastest, "{root}: {off}");
        }
        assert!((roots[0] + roots[1] + rate + on_board).norm() < 1e-14 * fastest);
        assert!(roots[0].re >= roots[1].re);
        assert_eq!(rotor.growth(), rotor.roots()[0].re);

        let threshold = rotor.whirl_spin().expect("friction on board");
        assert_relative_eq!(
            threshold,
            w0 * (1.0 + rate / rotor.damping_rate_on_board()),
            max_relative = 1e-14
        );
        match spin.abs() > threshold {
            true => grow += 1,
            false => die += 1,
        }
        assert_eq!(rotor.growth() > 0.0, spin.abs() > threshold, "{machine:?}");
    }
    assert!(grow > 200 && die > 200, "{grow} {die}");
}

#[test]
fn at_the_threshold_the_whirl_goes_round_at_the_natural_frequency_whatever_the_dampers() {
    for (machine, inner, rotor) in rotors(3, 300) {
        let threshold = rotor.whirl_spin().expect("friction on board");
        let at = machine.with_spin(threshold).and_then(|machine| machine.rotor(inner)).expect("a rotor");
        let (w0, _, rate, _) = letters(&machine);
        let rates = w0 + rate + rotor.damping_rate_on_board();
        assert!((at.roots()[0] - I * w0).norm() < 1e-13 * rates, "{}", at.roots()[0]);
        // The two frictions push with the same force on a circle at ω₀: the drum forwards, the floor backwards.
        let circle = Shaft { position: 1.0.into(), velocity: I * w0 };
        let forwards = inner * (threshold - w0);
        let backwards = machine.parameters().damping * w0;
        assert_relative_eq!(forwards, backwards, max_relative = 1e-12);
        let still = at.cartesian_rates(0.0, &circle.to_array());
        let push = machine.offset() * threshold * threshold; // of the load, at azimuth 0
        let size = w0 * w0 + push + rates * (w0 + threshold);
        assert!((still[2] - push + w0 * w0).abs() < 1e-13 * size && still[3].abs() < 1e-13 * size);
    }
}

#[test]
fn friction_on_board_has_a_threshold_however_weak_it_is() {
    let mut random = fastrand::Rng::with_seed(5);
    for machine in machines(6, 300) {
        let (w0, _, rate, _) = letters(&machine);
        let on_board = 10_f64.powf(-45.0 * random.f64());
        let rotor = machine.rotor(on_board * machine.total_mass()).expect("a rotor");
        let threshold = rotor.whirl_spin().expect("friction on board");
        assert_relative_eq!(threshold, w0 + w0 * rate / on_board, max_relative = 1e-14);
    }
}

#[test]
fn weak_friction_on_board_is_twice_a_weak_damper_on_the_radius() {
    for ratio in [0.3, 0.7, 1.2, 2.0, 5.0] {
        let (machine, weak) = (washer().with_spin(10.0 * ratio).unwrap(), 0.03); // Γ = 0.001
        let [floor, board] = [machine.with_damping(weak).unwrap(), machine.with_damping(0.0).unwrap()];
        let (radial, turning) = (floor.radial_damping_growth(), board.rotor(weak).unwrap().growth());
        assert_relative_eq!(turning, 0.001 * (ratio - 1.0) / 2.0, max_relative = 2e-3);
        assert_relative_eq!(radial, 0.5 * turning, max_relative = 2e-3);
    }
    // And together with a damper on the floor: (Γᵢ(Ω − ω₀) − Γω₀)/2ω₀.
    let machine = washer().with_damping(0.03).unwrap().with_spin(50.0).unwrap();
    assert_relative_eq!(
        machine.rotor(0.06).unwrap().growth(),
        (0.002 * 40.0 - 0.001 * 10.0) / 20.0,
        max_relative = 1e-3
    );
}

#[test]
fn what_cannot_be_is_refused() {
    assert!(washer().rotor(1.0).unwrap().transient(Shaft::AT_REST).unwrap().at(-1.0).is_err());
    assert!(washer().rotor(-1.0).is_err() && washer().rotor(f64::NAN).is_err());
    assert_eq!(washer().rotor(0.0).unwrap().whirl_spin(), None);
}

#[test]
fn the_shortest_time_after_the_start_the_shaft_is_where_it_was() {
    for (machine, _, rotor) in rotors(7, 200) {
        let start = Shaft::from_array([0.1, -0.2, 0.3, 0.4].map(|number| number * machine.offset()));
        let motion = rotor.transient(start).unwrap();
        let near = |found: Shaft| (found.position - start.position).norm() < 1e-12 * motion_size(&machine);
        for time in [0.0, 5e-324, 1e-309, 1e-160, 1e-120] {
            assert!(motion.at(time).is_ok_and(near), "{time:e}: {:?}", motion.at(time));
        }
    }
}

/// The largest distance that takes part: of the circle or of the load.
fn motion_size(machine: &Machine) -> f64 {
    machine.offset() + machine.steady().map_or(0.0, |steady| steady.radius())
}

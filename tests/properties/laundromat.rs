//! The washing machine.

use super::{any, between};
use mechanics::scenes::laundromat::{LockedState, Machine, MachineParameters, Polar, Shaft};
use nalgebra::Complex;

/// A few dozen roundings, relative to the largest number that took part.
const ROUNDING: f64 = 1e-13;

/// A machine with every frequency and rate within `decades` of one another, in either sense of spin, one in ten
/// without damping.
fn machine(random: &mut fastrand::Rng, decades: f64) -> Machine {
    let [low, high] = [10.0_f64.powf(-decades), 10.0_f64.powf(decades)];
    let (drum_mass, load_mass) = (between(random, 1e-2, 1e2), between(random, 1e-2, 1e2));
    let natural = between(random, low, high);
    let damping = if random.u8(0..10) == 0 { 0.0 } else { between(random, low, high) * natural };
    let spin = between(random, low, high) * natural * if random.bool() { 1.0 } else { -1.0 };
    Machine::new(MachineParameters {
        drum_mass,
        load_mass,
        load_radius: between(random, 1e-2, 1e2),
        stiffness: natural * natural * (drum_mass + load_mass),
        damping: damping * (drum_mass + load_mass),
        spin,
    })
    .expect("a valid machine")
}

fn start(random: &mut fastrand::Rng) -> Shaft {
    let mut number = || between(random, 1e-3, 1e3);
    let state = [number(), number(), number(), number()];
    Shaft::from_array(state.map(|value| if random.bool() { value } else { -value }))
}

#[test]
fn no_finite_parameters_panic_or_give_what_is_not_a_number() {
    let mut random = fastrand::Rng::with_seed(1988);
    let (mut accepted, mut refused) = (0, 0);
    for _ in 0..200_000 {
        let mut positive = || any(&mut random).abs();
        let [drum_mass, load_mass, load_radius, stiffness, damping] = std::array::from_fn(|_| positive());
        let parameters = MachineParameters {
            drum_mass,
            load_mass,
            load_radius,
            stiffness,
            damping,
            spin: any(&mut random),
        };
        let Ok(machine) = Machine::new(parameters) else {
            refused += 1;
            continue;
        };
        accepted += 1;
        let mut numbers = vec![
            machine.total_mass(),
            machine.natural_frequency(),
            machine.offset(),
            machine.damping_rate(),
            machine.spin(),
        ];
        if let Ok(steady) = machine.steady() {
            numbers.extend([steady.radius(), steady.phase(), steady.centre_of_mass_radius()]);
            numbers.extend([steady.amplitude().re, steady.amplitude().im]);
            numbers.extend([steady.centre_of_mass_amplitude().re, steady.centre_of_mass_amplitude().im]);
            // Torque and power are powers of these and may overflow; that is infinite, and still a number.
            assert!(!steady.motor_torque().is_nan() && !steady.motor_power().is_nan(), "{parameters:?}");
        }
        if let Some(peak) = machine.peak() {
            numbers.extend([peak.spin, peak.radius]);
        }
        numbers.extend(
            machine.modes().iter().flat_map(|m| [m.frequency.re, m.frequency.im, m.shape.re, m.shape.im]),
        );
        numbers.extend(machine.stability_matrix().iter());
        numbers.extend(machine.radial_damping_matrix().iter());
        assert!(numbers.iter().all(|number| number.is_finite()), "{parameters:?}: {numbers:?}");
    }
    assert!(accepted > 1000 && refused > 1000, "{accepted} accepted, {refused} refused");
}

#[test]
fn no_finite_start_or_time_panics_or_gives_what_is_not_a_number() {
    let mut random = fastrand::Rng::with_seed(2);
    let (mut answered, mut refused) = (0, 0);
    for round in 0..100_000 {
        let machine = machine(&mut random, if round % 2 == 0 { 2.0 } else { 20.0 });
        let start = Shaft::from_array(std::array::from_fn(|_| any(&mut random)));
        let Ok(motion) = machine.transient(start) else {
            refused += 1;
            continue;
        };
        let t = any(&mut random);
        match motion.at(t) {
            Ok(shaft) => {
                answered += 1;
                assert!(
                    shaft.to_array().iter().all(|value| value.is_finite()),
                    "{machine:?} {start:?} t = {t:e}: {shaft:?}"
                );
                assert!(
                    motion.centre_of_mass(t).is_ok_and(Complex::is_finite),
                    "{machine:?} {start:?} t = {t:e}"
                );
            }
            // Refused only for the two documented reasons: out of reach, or long before the start of a damped machine.
            Err(_) => {
                refused += 1;
                assert!(
                    t.abs() > 1e50 || (t < 0.0 && machine.damping_rate() > 0.0),
                    "{machine:?} {start:?} t = {t:e}"
                );
            }
        }
        let locked = LockedState { radius: start.position.re, radius_rate: start.velocity.re };
        if let Ok(Ok(state)) = machine.locked(locked).map(|motion| motion.at(t)) {
            assert!(state.radius.is_finite() && state.radius_rate.is_finite(), "{state:?}");
        }
    }
    assert!(answered > 10_000 && refused > 1000, "{answered} answered, {refused} refused");
}

#[test]
fn polar_and_cartesian_states_are_the_same_state() {
    let mut random = fastrand::Rng::with_seed(3);
    for _ in 0..10_000 {
        let shaft = start(&mut random);
        let back = Shaft::from_polar(shaft.to_polar());
        assert!((back.position - shaft.position).norm() <= ROUNDING * shaft.position.norm());
        assert!((back.velocity - shaft.velocity).norm() <= ROUNDING * shaft.velocity.norm());
    }
    // At O itself the direction is that of the velocity.
    let shaft = Shaft { position: Complex::new(0.0, 0.0), velocity: Complex::new(0.0, -2.0) };
    assert_eq!(shaft.to_polar(), Polar::from_array([0.0, -std::f64::consts::FRAC_PI_2, 2.0, 0.0]));
    assert_eq!(Shaft::AT_REST.to_polar(), Polar::from_array([0.0; 4]));
}

#[test]
fn energy_supplied_is_energy_kept_or_turned_into_heat() {
    // The power balance at an instant, from the exact motion by a central difference of the fourth order.
    let mut random = fastrand::Rng::with_seed(7);
    for _ in 0..1_000 {
        let (machine, start) = (machine(&mut random, 0.5), start(&mut random));
        let motion = machine.transient(start).unwrap();
        let t = between(&mut random, 0.1, 10.0) / machine.natural_frequency();
        let rate = machine.natural_frequency() + machine.spin().abs() + machine.damping_rate();
        let h = 1e-3 / rate;
        let energy = |t: f64| machine.energy(t, &motion.at(t).unwrap());
        let growth = (8.0 * (energy(t + h) - energy(t - h)) - (energy(t + 2.0 * h) - energy(t - 2.0 * h)))
            / (12.0 * h);
        let now = motion.at(t).unwrap();
        let balance = machine.motor_torque(t, &now) * machine.spin() - machine.dissipation(&now);
        let scale = rate * (energy(t) + machine.total_mass() * (machine.offset() * rate).powi(2));
        assert!((growth - balance).abs() < 1e-9 * scale, "{machine:?} t = {t}: {growth} for {balance}");
    }
}

#[test]
fn steady_motion_is_a_motion_and_all_others_end_in_it() {
    let mut random = fastrand::Rng::with_seed(8);
    for _ in 0..5_000 {
        let machine = machine(&mut random, 1.0);
        let Ok(steady) = machine.steady() else {
            continue;
        };
        if machine.damping_rate() == 0.0 {
            continue;
        }
        // Slowest decay: Γ/2 or, with heavy damping, about ω₀²/Γ. Wait for eighty times that.
        let slowest = machine.modes().map(|mode| mode.frequency.im).into_iter().fold(f64::MAX, f64::min);
        let t = 80.0 / slowest;
        let late = machine.transient(start(&mut random)).unwrap().at(t).unwrap();
        let circle = steady.amplitude() * machine.load_direction(t);
        assert!((late.position - circle).norm() <= ROUNDING * steady.radius(), "{machine:?}");
        let turning = Complex::i() * machine.spin() * circle;
        assert!((late.velocity - turning).norm() <= ROUNDING * turning.norm(), "{machine:?}");
        let torque = machine.motor_torque(t, &late);
        // From the acceleration across the load, which may be the small part of it.
        let scale = machine.total_mass() * machine.offset() * steady.radius() * machine.spin().powi(2)
            + machine.total_mass() * machine.offset().powi(2) * machine.spin().powi(2);
        assert!((torque - steady.motor_torque()).abs() <= ROUNDING * scale, "{machine:?}");
    }
}

#[test]
fn polar_coordinates_of_small_numbers_are_as_good() {
    let at_centre = Shaft::from_array([0.0, 0.0, 3.0, 4.0]).to_polar();
    assert_eq!(at_centre.to_array(), [0.0, 4.0_f64.atan2(3.0), 5.0, 0.0]);
    for size in [1e-170, 1e-300, 1e200] {
        let [r, theta, r_dot, theta_dot] =
            Shaft::from_array([3.0, 4.0, 4.0, -3.0].map(|x| x * size)).to_polar().to_array();
        assert!((r / size - 5.0).abs() < 1e-14 && (theta - 4.0_f64.atan2(3.0)).abs() < 1e-15, "{r} {theta}");
        assert!(r_dot.abs() < 1e-14 * size && (theta_dot + 1.0).abs() < 1e-15, "{r_dot} {theta_dot}");
        let speed = Shaft::from_array([0.0, 0.0, 3.0 * size, 4.0 * size]).to_polar().radius_rate;
        assert!((speed / size - 5.0).abs() < 1e-14, "{speed}");
    }
}

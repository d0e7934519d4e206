//! High spin, spin the other way round, and late times.

use crate::{FEW_ULPS, machine, start};
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{LockedState, Machine, MachineParameters, Shaft};
use nalgebra::Complex;
use std::f64::consts::PI;

#[test]
fn centre_of_mass_keeps_its_digits_at_a_spin_of_1e8() {
    let machine = machine(0.3, 1e8);
    let steady = machine.steady().unwrap();
    // r_cm/b = √(1 + Γ²Ω²)/√((1 − Ω²)² + Γ²Ω²): with ε = 1/Ω², to 24 digits it is √(Γ² + ε) √ε (1 + ε(1 − Γ²/2)).
    let exact = (0.09_f64 + 1e-16).sqrt() * 1e-8;
    assert!((steady.centre_of_mass_radius() / exact - 1.0).abs() < FEW_ULPS);
    assert!((steady.centre_of_mass_amplitude().norm() / exact - 1.0).abs() < FEW_ULPS);
    assert!((steady.radius() - machine.offset()).abs() < 1e-15, "r₀ − b is lost to rounding");

    // Started with the centre of mass at rest at O, it moves out to that circle and nothing else.
    let (b, spin) = (machine.offset(), machine.spin());
    let centred = Shaft { position: (-b).into(), velocity: Complex::new(0.0, -spin * b) };
    let motion = machine.transient(centred).unwrap();
    let late = 400.0;
    let ours = motion.centre_of_mass(late).unwrap();
    assert!((ours.norm() / exact - 1.0).abs() < FEW_ULPS, "{} for {exact}", ours.norm());
    let naive = machine.centre_of_mass(late, &motion.at(late).unwrap());
    assert!((naive.norm() / exact - 1.0).abs() > 1e-10, "the sum z + b e^(iφ) should have lost digits");
    let early = motion.centre_of_mass(0.0).unwrap();
    assert!(early.norm() < 1e-22, "the centre of mass starts at O, not at {early}");
}

#[test]
fn self_centring_start_agrees_with_its_own_differential_equation() {
    // ẅ + Γẇ + ω₀²w = b(ω₀² + iΓΩ)e^{iΩt} for the centre of mass itself, integrated with that small force.
    let machine = machine(0.3, 50.0);
    let (b, spin) = (machine.offset(), machine.spin());
    let rates = |t: f64, &[x, y, vx, vy]: &[f64; 4]| {
        let force = Complex::new(b, b * 0.3 * spin) * Complex::from_polar(1.0, spin * t);
        [vx, vy, force.re - x - 0.3 * vx, force.im - y - 0.3 * vy]
    };
    let end = Dop853::new(1e-13).unwrap().solve(rates, 0.0, [0.0; 4], 9.0).unwrap().state;
    let centred = Shaft { position: (-b).into(), velocity: Complex::new(0.0, -spin * b) };
    let ours = machine.transient(centred).unwrap().centre_of_mass(9.0).unwrap();
    assert!((ours - Complex::new(end[0], end[1])).norm() < 1e-12);
}

#[test]
fn spinning_the_other_way_is_the_mirror_image() {
    for (damping, spin) in [(0.0, 1.0), (0.05, 1.02), (0.3, 0.4), (0.3, 7.0), (2.0, 1.5), (5.0, 0.1)] {
        let (one, other) = (machine(damping, spin), machine(damping, -spin));
        let mirrored = Shaft { position: start().position.conj(), velocity: start().velocity.conj() };
        let (a, b) = (one.transient(start()).unwrap(), other.transient(mirrored).unwrap());
        for t in [0.3, 2.0, 40.0] {
            let (a, b) = (a.at(t).unwrap(), b.at(t).unwrap());
            assert!((a.position - b.position.conj()).norm() <= FEW_ULPS * a.position.norm().max(1.0));
            assert!((a.velocity - b.velocity.conj()).norm() <= FEW_ULPS * a.velocity.norm().max(1.0));
        }
        if let (Ok(a), Ok(b)) = (one.steady(), other.steady()) {
            assert!(damping == 0.0 || (0.0..=PI).contains(&a.phase()));
            assert_eq!(
                (a.radius(), a.phase(), a.motor_torque(), a.motor_power()),
                (b.radius(), -b.phase(), -b.motor_torque(), b.motor_power())
            );
        }
    }
}

/// The angle m·2⁻⁶⁰ · t modulo 2π for integers m and t, in integer arithmetic with 2π to 88 binary places.
fn exact_phase(m: u128, t: u128) -> f64 {
    // 2π · 2^88, from 2π = 6.283185307179586476925286766559005768394338798750211641949889…
    const TWO_PI: u128 = 1_944_551_666_501_805_353_363_452_692;
    let product = (m * t) << 28;
    (product % TWO_PI) as f64 / 2.0_f64.powi(88)
}

#[test]
fn integer_value_of_two_pi_is_right() {
    // Checked by Machin's formula, π/4 = 4 arctan(1/5) − arctan(1/239), in integers of 120 bits.
    let arctan = |n: i128| {
        let (mut power, mut sum, mut k) = ((1_i128 << 118) / n, 0_i128, 0_i128);
        while power != 0 {
            sum += if k % 2 == 0 { power / (2 * k + 1) } else { -power / (2 * k + 1) };
            power /= n * n;
            k += 1;
        }
        sum
    };
    // 2π · 2^88 = 8 (4 arctan(1/5) − arctan(1/239)) · 2^118 / 2^30
    let two_pi = (4 * arctan(5) - arctan(239)) >> 27;
    assert!((exact_phase(1 << 60, 44) - (44.0 - 14.0 * PI)).abs() < 1e-14); // 44/7 is nearly 2π
    let in_use = 1_944_551_666_501_805_353_363_452_692_i128;
    assert!((two_pi - in_use).abs() <= 1, "2π · 2^88 = {two_pi}, in use {in_use}");
}

#[test]
fn phase_is_exact_after_a_billion_seconds() {
    for (spin, seed) in [(11.503_217_f64, 1), (0.314_159, 2), (28.25 + 1e-9, 3)] {
        let machine = machine(0.3, spin);
        let m = (spin * 2.0_f64.powi(60)) as u128; // the double itself, as an integer
        assert_eq!(m as f64 / 2.0_f64.powi(60), spin);
        let mut random = fastrand::Rng::with_seed(seed);
        let mut naive_worst = 0.0_f64;
        for _ in 0..1000 {
            let t = random.u32(900_000_000..1_000_000_000);
            let exact = Complex::from_polar(1.0, exact_phase(m, u128::from(t)));
            let ours = machine.load_direction(f64::from(t));
            assert!((ours - exact).norm() < FEW_ULPS, "Ω = {spin}, t = {t}");
            naive_worst = naive_worst.max((Complex::from_polar(1.0, spin * f64::from(t)) - exact).norm());
        }
        assert!(naive_worst > 1e-9, "the naive phase should be wrong, and is off by {naive_worst:e}");
        // The transient has died out, so the shaft shows the phase too.
        let t = 999_999_937;
        let steady = machine.steady().unwrap().amplitude() * Complex::from_polar(1.0, exact_phase(m, t));
        let late = machine.transient(start()).unwrap().at(t as f64).unwrap().position;
        assert!((late - steady).norm() < FEW_ULPS * steady.norm().max(1e-3));
    }
}

#[test]
fn free_swing_is_exact_after_a_billion_seconds_too() {
    // ω₀ = √2 is not a double; its phase is right all the same, since it is kept in two parts. √2 to 120 binary
    // places: an integer square root to 60, and one step of Newton for the next 60.
    let machine = Machine::new(MachineParameters {
        drum_mass: 1.0,
        load_mass: 0.0,
        load_radius: 1.0,
        stiffness: 2.0,
        damping: 0.0,
        spin: 0.25,
    })
    .unwrap();
    let motion = machine.transient(Shaft { position: 1.0.into(), ..Shaft::AT_REST }).unwrap();
    let high: u128 = (2_u128 << 120).isqrt();
    let rest = (2_u128 << 120) - high * high;
    let low = (rest << 60) / (2 * high); // √2 = high · 2^-60 + low · 2^-120
    for t in [1_000_000_000_u128, 999_999_937, 123_456_789] {
        let phase = exact_phase(high, t) + (low * t) as f64 / 2.0_f64.powi(120);
        let ours = motion.at(t as f64).unwrap();
        assert!(
            (ours.position.re - phase.cos()).abs() < FEW_ULPS,
            "{} for {}",
            ours.position.re,
            phase.cos()
        );
        let naive = (2.0_f64.sqrt() * t as f64).cos();
        assert!((naive - phase.cos()).abs() > 1e-10, "the rounded root should be out of phase");
    }
}

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
        let machine = machine(damping, spin);
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
fn times_that_are_none_are_refused_by_every_motion_of_the_drum() {
    let machine = machine(0.5, 3.0);
    let transient = machine.transient(start()).unwrap();
    let pulled_out = LockedState { radius: 1.0, radius_rate: 0.0 };
    let (ramp, locked) = (machine.ramp(0.1, start()).unwrap(), machine.locked(pulled_out).unwrap());
    // The last of them is so long before the start that the motion there is beyond the largest number.
    for t in [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e51, -1e51, -1e4] {
        assert!(transient.at(t).is_err() && transient.centre_of_mass(t).is_err(), "{t}");
        assert!(ramp.at(t).is_err() && locked.at(t).is_err() && locked.sample(&[0.0, t]).is_err(), "{t}");
    }
    assert!(transient.at(1e50).is_ok() && transient.centre_of_mass(1e50).is_ok() && ramp.at(1e50).is_ok());
    let resting = Machine::new(MachineParameters { spin: 0.5, ..machine.parameters() }).unwrap();
    assert!(resting.locked(pulled_out).unwrap().at(1e50).is_ok());
}

#[test]
fn a_tiny_motion_is_followed_back_until_it_is_huge() {
    // |v + ½Γz|² + ω₁²|z|² of the free motion that this is, long before the start, grows by e^Γ in a second.
    let size = |damping: f64, shaft: Shaft| {
        let [z, v] = [shaft.position, shaft.velocity].map(|part| part * 1e-200);
        ((v + z * (0.5 * damping)).norm_sqr() + (1.0 - 0.25 * damping * damping) * z.norm_sqr()).ln()
    };
    let tiny = Shaft::from_array([3e-45, -1e-45, 2e-45, 1e-45]);
    for (damping, spin, last) in [(1.0, 0.0, -1575.0), (1.0, 3.0, -1575.0), (0.2, 1.0, -7800.0)] {
        let parameters = MachineParameters { load_radius: 1e-45, ..machine(damping, spin).parameters() };
        let motion = Machine::new(parameters).unwrap().transient(tiny).unwrap();
        let at = |t: f64| size(damping, motion.at(t).unwrap());
        for back in [0.6, 0.8, 0.9, 0.95, 1.0] {
            let t = back * last;
            let grown = at(t - 2.0) - at(t);
            assert!((grown - 2.0 * damping).abs() < 1e-9, "Γ {damping}, Ω {spin}, t {t}: {grown}");
        }
        assert!(motion.at(1.1 * last).is_err());
    }
}

#[test]
fn jacobi_integral_is_constant_for_a_billion_seconds() {
    for spin in [0.3, 0.999, 1.0, 1.001, 3.0, -3.0] {
        let machine = machine(0.0, spin);
        let motion = machine.transient(start()).unwrap();
        let j = |t: f64| machine.jacobi_integral(t, &motion.at(t).unwrap());
        for t in [1.0, 1e3, 1e6, 1e9] {
            let shaft = motion.at(t).unwrap();
            // Rounding of the largest terms that J is the difference of.
            let scale = shaft.velocity.norm_sqr() + (1.0 + spin * spin) * shaft.position.norm_sqr() + 1.0;
            assert!((j(t) - j(0.0)).abs() < 1e-14 * scale, "Ω = {spin}, t = {t}: {} for {}", j(t), j(0.0));
        }
    }
}

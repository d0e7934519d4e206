//! The washing machine with a motor of limited torque, against its equations of motion written out in the room, against
//! reference values, and against long simulations.

use crate::common::any;
use mechanics::integrate::Dop853;
use mechanics::nalgebra::{Complex, Matrix3, Vector3};
use mechanics::scenes::laundromat::{DrivenMachine, DrivenState, Machine, MachineParameters, Motor};
use serde_json::Value;

/// The chapter's machine; its own spin plays no part.
const WASHER: MachineParameters = MachineParameters {
    drum_mass: 28.0,
    load_mass: 2.0,
    load_radius: 0.25,
    stiffness: 3000.0,
    damping: 90.0,
    spin: 0.0,
};

/// m + M = ω₀ = 1, b = Γ = 0.1: the machine of the reference values.
const UNITS: MachineParameters = MachineParameters {
    drum_mass: 0.5,
    load_mass: 0.5,
    load_radius: 0.2,
    stiffness: 1.0,
    damping: 0.1,
    spin: 0.0,
};

fn driven(parameters: MachineParameters, motor: Motor) -> DrivenMachine {
    Machine::new(parameters).expect("a machine").driven(motor).expect("a motor")
}

/// ẍ, ÿ and φ̈ in the room from T − V with the coordinates x, y, φ, the generalised forces −γẋ, −γẏ and the motor's
/// torque: three linear equations, solved as they stand.
fn accelerations(
    parameters: &MachineParameters,
    motor: &Motor,
    [x, y, phi, vx, vy, spin]: [f64; 6],
) -> Vector3<f64> {
    let &MachineParameters { drum_mass, load_mass, load_radius, stiffness, damping, .. } = parameters;
    let (mass, unbalance) = (drum_mass + load_mass, load_mass * load_radius);
    let (sin, cos) = phi.sin_cos();
    let turning = motor.drum_inertia + load_mass * load_radius * load_radius;
    let masses = Matrix3::new(
        mass,
        0.0,
        -unbalance * sin,
        0.0,
        mass,
        unbalance * cos,
        -unbalance * sin,
        unbalance * cos,
        turning,
    );
    let torque = motor.stall_torque * (1.0 - spin / motor.idle_spin);
    let forces = Vector3::new(
        unbalance * spin * spin * cos - stiffness * x - damping * vx,
        unbalance * spin * spin * sin - stiffness * y - damping * vy,
        torque,
    );
    masses.lu().solve(&forces).expect("masses")
}

/// Where the motion in the room is after a time, from a state on board with the load at azimuth 0, and back on board.
fn simulated(parameters: MachineParameters, motor: Motor, start: DrivenState, time: f64) -> DrivenState {
    let rates = |_: f64, state: &[f64; 6]| {
        let [.., vx, vy, spin] = *state;
        let [ax, ay, acceleration] = accelerations(&parameters, &motor, *state).into();
        [vx, vy, spin, ax, ay, acceleration]
    };
    let DrivenState { position, velocity, spin } = start;
    let start = [position.re, position.im, 0.0, velocity.re, velocity.im, spin];
    let [x, y, phi, vx, vy, spin] =
        Dop853::new(1e-10).expect("a tolerance").solve(any(rates), 0.0, start, time).expect("a motion").state;
    let back = Complex::from_polar(1.0, -phi);
    DrivenState { position: Complex::new(x, y) * back, velocity: Complex::new(vx, vy) * back, spin }
}

/// The same by the library's rates.
fn settled(drive: &DrivenMachine, start: DrivenState, time: f64) -> DrivenState {
    let solver = Dop853::new(1e-9).expect("a tolerance");
    let end = solver
        .solve(any(|time, state| drive.rates(time, state)), 0.0, start.to_array(), time)
        .expect("a motion");
    DrivenState::from_array(end.state)
}

/// A seeded stream of machines with motors, from light to heavy in every respect.
fn drives(seed: u64, count: usize) -> impl Iterator<Item = (MachineParameters, Motor)> {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut between = move |low: f64, high: f64| low * (high / low).powf(random.f64());
    (0..count).map(move |_| {
        let (drum_mass, load_mass, stiffness) = (between(1.0, 100.0), between(0.1, 10.0), between(10.0, 1e5));
        let mass = drum_mass + load_mass;
        let natural = (stiffness / mass).sqrt();
        let load_radius = between(0.05, 0.5);
        let damping = mass * natural * between(1e-2, 3.0);
        let offset = load_mass * load_radius / mass;
        let torque = mass * (offset * natural).powi(2);
        let parameters =
            MachineParameters { drum_mass, load_mass, load_radius, stiffness, damping, spin: 0.0 };
        let motor = Motor {
            stall_torque: torque * between(1e-2, 1e3),
            idle_spin: natural * between(0.5, 20.0),
            drum_inertia: load_mass * load_radius * load_radius * between(0.1, 100.0),
        };
        (parameters, motor)
    })
}

/// The stall torque that a spin takes, with nothing but the formula: `γ b² Ω⁵ / D²` over `1 − Ω/Ω_idle`.
fn required(parameters: &MachineParameters, motor: &Motor, spin: f64) -> f64 {
    let mass = parameters.drum_mass + parameters.load_mass;
    let offset = parameters.load_mass * parameters.load_radius / mass;
    let d = (parameters.stiffness / mass - spin * spin).hypot(parameters.damping / mass * spin);
    parameters.damping * offset.powi(2) * spin.powi(5) / (d * d) / (1.0 - spin / motor.idle_spin)
}

#[test]
fn the_folds_have_the_digits_of_the_reference() {
    let file: Value = serde_json::from_str(include_str!("data/sommerfeld-folds.json")).expect("a file");
    assert_eq!(file["inputs"]["motor"], "T0 (1-Omega/3)");
    let digits =
        |name: &str| file["values"][name].as_str().expect("digits").parse::<f64>().expect("a number");
    let folds =
        driven(UNITS, Motor { stall_torque: 0.1, idle_spin: 3.0, drum_inertia: 1.0 }).folds().expect("two");
    for (found, name) in [
        (folds.up.spin, "Omega_up"),
        (folds.up.stall_torque, "T0_up"),
        (folds.down.spin, "Omega_down"),
        (folds.down.stall_torque, "T0_down"),
    ] {
        assert!((found / digits(name) - 1.0).abs() < 2e-15, "{name}: {found}");
    }
}

#[test]
fn the_rates_are_those_of_the_lagrangian_in_the_room() {
    let mut random = fastrand::Rng::with_seed(5);
    for (parameters, motor) in drives(1, 500) {
        let mut number = || 2.0 * random.f64() - 1.0;
        let [position, velocity] = [0.1, 3.0].map(|size| Complex::new(size * number(), size * number()));
        let (spin, phi) = (30.0 * number(), 3.0 * number());
        let on_board = DrivenState { position, velocity, spin };
        let rates = DrivenState::from_array(driven(parameters, motor).rates(0.0, &on_board.to_array()));

        let turned = Complex::from_polar(1.0, phi);
        let [place, speed] = [position * turned, velocity * turned];
        let [ax, ay, acceleration] =
            accelerations(&parameters, &motor, [place.re, place.im, phi, speed.re, speed.im, spin]).into();
        let scale = 1.0 + acceleration.abs();
        assert!((rates.spin - acceleration).abs() < 1e-11 * scale.max(spin * spin));
        // d/dt of ż e^{−iφ} is z̈ e^{−iφ} − iφ̇ ż e^{−iφ}, and of z e^{−iφ} alike.
        let swing = Complex::i() * spin;
        let size = Complex::new(ax, ay).norm() + (swing * velocity).norm() + 1.0;
        assert!((rates.velocity - (Complex::new(ax, ay) / turned - swing * velocity)).norm() < 1e-11 * size);
        assert!((rates.position - (velocity - swing * position)).norm() < 1e-12 * size);
    }
}

#[test]
fn no_steady_spin_is_missed() {
    let [mut ones, mut threes] = [0, 0];
    for (parameters, motor) in drives(2, 2000) {
        let found = driven(parameters, motor).steady_spins();
        // Every change of sign on a fine grid, closer near the idle spin.
        let grid: Vec<f64> = (1..20_000).map(|n| motor.idle_spin * f64::from(n) / 20_000.0).collect();
        let enough = |spin: f64| required(&parameters, &motor, spin) < motor.stall_torque;
        let seen: Vec<f64> =
            grid.windows(2).filter(|pair| enough(pair[0]) != enough(pair[1])).map(|pair| pair[0]).collect();
        let last = grid[grid.len() - 1];
        let inside: Vec<f64> = found.iter().copied().filter(|&spin| grid[0] < spin && spin < last).collect();
        assert_eq!(seen.len(), inside.len(), "{parameters:?} {motor:?}: {seen:?} {found:?}");
        for (seen, spin) in seen.iter().zip(&inside) {
            assert!((seen..=&(seen + 1.001 * grid[0])).contains(&spin));
            let needed = required(&parameters, &motor, *spin) / motor.stall_torque;
            let room = 1e-10 / (1.0 - spin / motor.idle_spin);
            assert!((needed - 1.0).abs() < room, "{needed} at {spin}, {parameters:?} {motor:?}");
        }
        ones += usize::from(found.len() == 1);
        threes += usize::from(found.len() == 3);
        assert!(found.len() == 1 || found.len() == 3);
    }
    assert!(ones > 300 && threes > 100, "{ones} {threes}");
}

/// The page's machine: the chapter's with half its damper.
fn light(stall_torque: f64, drum_inertia: f64) -> (MachineParameters, Motor) {
    (MachineParameters { damping: 45.0, ..WASHER }, Motor { stall_torque, idle_spin: 40.0, drum_inertia })
}

#[test]
fn a_long_simulation_in_the_room_ends_at_the_outer_speeds_and_leaves_the_middle_one() {
    let (parameters, motor) = light(6.0, 0.5);
    let drive = driven(parameters, motor);
    let [stuck, middle, fast] = drive.steady_spins()[..] else { panic!("three speeds") };
    let nudged = |spin: f64, by: f64| {
        let state = drive.steady_state(spin).expect("a state");
        simulated(parameters, motor, DrivenState { spin: state.spin + by, ..state }, 60.0)
    };
    for (spin, by) in [(stuck, 0.3), (stuck, -0.3), (fast, 0.5), (fast, -0.5)] {
        let end = nudged(spin, by);
        let steady = drive.steady_state(spin).expect("a state");
        assert!((end.spin - spin).abs() < 2e-6, "{spin}: {}", end.spin);
        assert!((end.position - steady.position).norm() < 1e-6);
    }
    assert!((nudged(middle, 0.01).spin - fast).abs() < 1e-4);
    assert!((nudged(middle, -0.01).spin - stuck).abs() < 1e-4);
}

#[test]
fn the_stability_matrix_is_the_derivative_of_the_motion_in_the_room() {
    for (parameters, motor) in drives(3, 100) {
        let drive = driven(parameters, motor);
        for spin in drive.steady_spins() {
            let Ok(matrix) = drive.stability_matrix(spin) else { continue };
            let steady = drive.steady_state(spin).expect("a state").to_array();
            // The rates on board, from the accelerations in the room with the load at azimuth 0.
            let rates = |state: [f64; 5]| {
                let [x, y, vx, vy, spin] = state;
                let [ax, ay, acceleration] =
                    accelerations(&parameters, &motor, [x, y, 0.0, vx, vy, spin]).into();
                [vx + spin * y, vy - spin * x, ax + spin * vy, ay - spin * vx, acceleration]
            };
            for column in 0..5 {
                // The rates are of the second degree, so that the difference of two is the derivative.
                let step = 0.1 * if column < 2 { steady[0].hypot(steady[1]) } else { spin };
                let [mut before, mut after] = [steady; 2];
                before[column] -= step;
                after[column] += step;
                let [before, after] = [rates(before), rates(after)];
                for row in 0..5 {
                    let slope = (after[row] - before[row]) / (2.0 * step);
                    let size = (after[row].abs() + before[row].abs()) / step + slope.abs();
                    let off = (matrix[(row, column)] - slope).abs();
                    assert!(off < 1e-9 * size + 1e-12, "{row} {column}: {slope} {off}");
                }
            }
        }
    }
}

#[test]
fn where_the_stall_torque_falls_with_the_spin_one_real_root_is_positive() {
    let mut convicted = 0;
    for (parameters, motor) in drives(4, 1000) {
        let drive = driven(parameters, motor);
        for part in [0.2, 0.35, 0.5, 0.65, 0.8] {
            let spin = part * motor.idle_spin;
            let needed = required(&parameters, &motor, spin);
            let slope = (required(&parameters, &motor, spin * (1.0 + 1e-6))
                - required(&parameters, &motor, spin * (1.0 - 1e-6)))
                / (2e-6 * spin);
            // dτ_shaking/dΩ − dτ_motor/dΩ is (1 − Ω/Ω_idle) times the slope of the stall torque.
            let difference = (1.0 - part) * slope;
            let mass = parameters.drum_mass + parameters.load_mass;
            let d = (parameters.stiffness / mass - spin * spin).hypot(parameters.damping / mass * spin);
            let expected = d * d * difference / drive.inertia(); // eq:driven-determinant
            let matrix = drive.stability_matrix(spin).expect("a matrix");
            let room = d * d * needed / spin / drive.inertia();
            assert!((-matrix.determinant() - expected).abs() < 1e-5 * (expected.abs() + room));
            if slope * spin < -1e-3 * needed {
                assert!(drive.growth_rate(spin).expect("a rate") > 0.0);
                convicted += 1;
            }
        }
    }
    assert!(convicted > 500, "{convicted}");
}

#[test]
fn every_speed_of_the_outer_branches_of_the_washer_is_stable() {
    let mut stable = 0;
    for inertia in [0.0, 0.1, 0.5, 5.0] {
        let (parameters, motor) = light(1.0, inertia);
        let drive = driven(parameters, motor);
        let folds = drive.folds().expect("two");
        for spin in (10..400).map(|n| 0.1 * f64::from(n)) {
            if spin < folds.up.spin || spin > folds.down.spin {
                assert!(drive.growth_rate(spin).expect("a rate") < 0.0, "{spin}");
                stable += 1;
            }
        }
    }
    assert!(stable > 1000);
}

#[test]
fn the_slope_alone_acquits_nobody() {
    // Half of all mass is the load, and the drum itself has no moment of inertia.
    let parameters = MachineParameters { damping: 0.05, ..UNITS };
    let motor = Motor { stall_torque: 1.0, idle_spin: 2.0, drum_inertia: 0.0 };
    let spin = 1.7;
    let stall_torque = required(&parameters, &motor, spin);
    assert!(required(&parameters, &motor, 1.001 * spin) > stall_torque);
    let drive = driven(parameters, Motor { stall_torque, ..motor });
    let growth = drive.growth_rate(spin).expect("a rate");
    assert!(growth > 0.1, "{growth}");
    // The motion in the room does leave it.
    let steady = drive.steady_state(spin).expect("a state");
    let start = DrivenState { spin: spin + 1e-6, ..steady };
    let left = simulated(parameters, drive.motor(), start, 100.0);
    assert!((left.spin - spin).abs() > 0.05, "{}", left.spin);
}

#[test]
fn a_slow_knob_jumps_at_the_folds() {
    let (parameters, motor) = light(1.0, 0.5);
    let drive = driven(parameters, motor);
    let folds = drive.folds().expect("two");
    // Up past the upper fold and down past the lower one, a notch a minute, each a hundredth of the fold.
    let jump = |fold: f64, from: i32, step: i32, mut state: DrivenState| {
        let mut notch = from;
        loop {
            let torque = 0.01 * f64::from(notch) * fold;
            let next = settled(&drive.with_stall_torque(torque).expect("a torque"), state, 60.0);
            if (next.spin - state.spin).abs() > 3.0 {
                return (torque / fold, next);
            }
            state = next;
            notch += step;
            assert!((30..200).contains(&notch));
        }
    };
    let start = settled(
        &drive.with_stall_torque(0.3 * folds.up.stall_torque).expect("a torque"),
        DrivenState::AT_REST,
        60.0,
    );
    let (up, fast) = jump(folds.up.stall_torque, 31, 1, start);
    let start =
        settled(&drive.with_stall_torque(2.0 * folds.down.stall_torque).expect("a torque"), fast, 60.0);
    let (down, _) = jump(folds.down.stall_torque, 199, -1, start);
    assert!((1.0..1.03).contains(&up), "{up}");
    assert!((0.96..1.0).contains(&down), "{down}");
}

/// The least stall torque, over that of the upper fold, from which a start gets through; by halving.
fn threshold(parameters: MachineParameters, motor: Motor, start: DrivenState, patience: f64) -> f64 {
    let folds = driven(parameters, motor).folds().expect("two");
    let escapes = |part: f64| {
        let stall_torque = part * folds.up.stall_torque;
        let drive = driven(parameters, Motor { stall_torque, ..motor });
        settled(&drive, start, patience).spin > 0.5 * (folds.up.spin + folds.down.spin)
    };
    let (mut caught, mut free) = (0.05, 1.05);
    assert!(!escapes(caught) && escapes(free));
    while free - caught > 0.002 {
        let part = 0.5 * (caught + free);
        if escapes(part) { free = part } else { caught = part }
    }
    free
}

#[test]
fn a_start_from_rest_escapes_below_the_fold_the_more_so_the_lighter_the_rotor() {
    // J = I + ma², with ma² = 0.02; from another program, to two digits.
    for (inertia, known) in [(0.1, 0.28), (0.3, 0.39), (1.0, 0.53), (3.0, 0.68)] {
        let motor = Motor { stall_torque: 0.1, idle_spin: 3.0, drum_inertia: inertia - 0.02 };
        let part = threshold(UNITS, motor, DrivenState::AT_REST, 600.0 * (1.0 + inertia));
        assert!((part - known).abs() < 0.0075, "{inertia}: {part}");
    }
    // The table of the page, in newton metres.
    for (inertia, torque) in [(0.0, 3.4), (0.1, 4.0), (0.5, 5.0), (2.0, 6.4), (20.0, 7.5)] {
        let (parameters, motor) = light(1.0, inertia);
        let fold = driven(parameters, motor).folds().expect("two").up.stall_torque;
        let found = fold * threshold(parameters, motor, DrivenState::AT_REST, 60.0 + 60.0 * inertia);
        assert!((found - torque).abs() < 0.06, "{inertia}: {found}, {} of the fold", found / fold);
    }
    // Not universal: where the shaft starts matters too.
    let from = |angle: f64| {
        let position = Complex::from_polar(0.05, angle);
        let (parameters, motor) = light(1.0, 0.5);
        threshold(parameters, motor, DrivenState { position, ..DrivenState::AT_REST }, 100.0)
    };
    let parts = [0.0, 90.0, 180.0, 270.0].map(|angle: f64| from(angle.to_radians()));
    // A quarter turn ahead of the load the shaft helps most; the opposite place hinders most.
    for (part, expected) in parts.iter().zip([0.636, 0.634, 0.679, 0.712]) {
        assert!((part - expected).abs() < 0.003, "{parts:?}");
    }
}

#[test]
fn the_upper_fold_keeps_its_torque_down_to_a_damping_of_which_the_documentation_speaks() {
    // At the peak of a narrow resonance the torque is γb²ω₀³/Γ² over 1 − ω₀/Ω_idle.
    let motor = Motor { stall_torque: 1.0, idle_spin: 3.0, drum_inertia: 1.0 };
    let off = |damping: f64| {
        let found = driven(MachineParameters { damping, ..UNITS }, motor).folds().expect("two").up;
        let peak = 0.1_f64.powi(2) / damping / (1.0 - 1.0 / 3.0);
        (found.stall_torque / peak - 1.0).abs()
    };
    for damping in [1e-6, 1e-9, 1e-12, 3e-14] {
        assert!(off(damping) < 1e-3, "{damping}: {}", off(damping));
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let machine = Machine::new(WASHER).expect("a machine");
    let motor = Motor { stall_torque: 3.0, idle_spin: 40.0, drum_inertia: 0.5 };
    let refusal = |machine: Machine, motor: Motor| machine.driven(motor).expect_err("refused").to_string();
    assert!(refusal(machine, Motor { stall_torque: 0.0, ..motor }).contains("stall torque"));
    assert!(refusal(machine, Motor { idle_spin: f64::NAN, ..motor }).contains("idle spin"));
    assert!(refusal(machine, Motor { drum_inertia: -1.0, ..motor }).contains("moment of inertia"));
    let undamped = machine.with_damping(0.0).expect("a machine");
    assert!(refusal(undamped, motor).contains("damping"));
    let empty = Machine::new(MachineParameters { load_mass: 0.0, ..WASHER }).expect("a machine");
    assert!(refusal(empty, Motor { drum_inertia: 0.0, ..motor }).contains("moment of inertia"));
    let drive = machine.driven(motor).expect("a motor");
    for spin in [0.0, 40.0, 50.0, -1.0, f64::NAN] {
        assert!(drive.required_stall_torque(spin).is_err() && drive.growth_rate(spin).is_err());
    }
    let message = drive.growth_rate(f64::NAN).expect_err("refused").to_string();
    assert_eq!(message, "spin NaN rad/s is not a finite number");
    // With a strong damper there is one speed for each torque.
    let calm = machine.with_damping(300.0).expect("a machine").driven(motor).expect("a motor");
    assert!(calm.folds().is_none() && calm.steady_spins().len() == 1);
}

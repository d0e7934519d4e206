//! The washing machine, its motion, and the integrators.

use super::Sign::{Any, NotNegative, Positive};
use super::{Setter, every_number_is_checked};
use crate::common::any;
use mechanics::integrate::{Direction, Dop853, Failure, Taylor, rk4};
use mechanics::scenes::laundromat::{LockedState, Machine, MachineParameters, Shaft};
use mechanics::{InvalidQuantity, Rule};

const WASHER: MachineParameters = MachineParameters {
    drum_mass: 28.0,
    load_mass: 2.0,
    load_radius: 0.25,
    stiffness: 3000.0,
    damping: 90.0,
    spin: 30.0,
};

fn washer() -> Machine {
    Machine::new(WASHER).expect("the chapter's machine is valid")
}

fn resonant() -> Machine {
    Machine::new(MachineParameters { damping: 0.0, spin: 10.0, ..WASHER }).expect("a valid machine")
}

fn refusal(parameters: MachineParameters) -> (InvalidQuantity, String) {
    let error = Machine::new(parameters).expect_err("the machine should be refused");
    (error, error.to_string())
}

#[test]
fn parameters_are_finite_and_but_for_the_spin_not_negative() {
    let numbers: [Setter<MachineParameters>; 6] = [
        (|p| &mut p.drum_mass, "drum mass", "kg", NotNegative),
        (|p| &mut p.load_mass, "load mass", "kg", NotNegative),
        (|p| &mut p.load_radius, "load radius", "m", NotNegative),
        (|p| &mut p.stiffness, "stiffness", "N/m", Positive),
        (|p| &mut p.damping, "damping", "kg/s", NotNegative),
        (|p| &mut p.spin, "spin", "rad/s", Any),
    ];
    every_number_is_checked(WASHER, &numbers, |parameters| {
        let machine = Machine::new(parameters)?;
        assert!(machine.transient(Shaft::AT_REST)?.at(1.0).is_ok() && machine.steady().is_ok());
        Ok::<_, InvalidQuantity>(machine)
    });
    assert!(Machine::new(MachineParameters { spin: -2.5, ..WASHER }).is_ok());
}

#[test]
fn a_machine_has_mass_and_a_spring() {
    let (_, message) = refusal(MachineParameters { drum_mass: 0.0, load_mass: 0.0, ..WASHER });
    assert_eq!(message, "mass of drum and load 0 kg is not positive; it must be more than zero");
}

#[test]
fn derived_quantities_must_stay_in_range() {
    let four = MachineParameters { drum_mass: 3.0, load_mass: 1.0, ..WASHER };
    assert!(Machine::new(MachineParameters { stiffness: 4e80, damping: 3e50, ..four }).is_ok());
    let cases = [
        (MachineParameters { load_mass: 1e-310, ..WASHER }, "load mass 1e-310 kg"),
        (MachineParameters { spin: -1e-60, ..WASHER }, "spin -1e-60 rad/s"),
    ];
    for (parameters, start) in cases {
        let (error, message) = refusal(parameters);
        assert_eq!(error.rule, Rule::InRange, "{message}");
        assert!(message.starts_with(start), "{message}");
        assert!(message.contains("is outside the range from 1e-50 to 1e50"), "{message}");
    }
    // Of some it is the ratio to others that must stay in range: the message names what was given.
    let light = MachineParameters { drum_mass: 1e-40, load_mass: 0.0, ..WASHER };
    let heavy = MachineParameters { drum_mass: 1e50, load_mass: 0.0, stiffness: 1e50, ..WASHER };
    for (parameters, start, what) in [
        (MachineParameters { stiffness: 1e300, ..WASHER }, "stiffness 1e300 N/m: ", "natural frequency ω₀"),
        (MachineParameters { stiffness: 1e-300, ..WASHER }, "stiffness 1e-300 N/m: ", "natural frequency ω₀"),
        (MachineParameters { stiffness: 1e308, ..light }, "stiffness 1e308 N/m: ", "natural frequency ω₀"),
        (MachineParameters { stiffness: 5e-324, ..heavy }, "stiffness 5e-324 N/m: ", "natural frequency ω₀"),
        (
            MachineParameters { load_radius: 1e-45, load_mass: 1e-10, ..WASHER },
            "load radius 1e-45 m: ",
            "offset b",
        ),
        (MachineParameters { load_radius: 2e-50, ..four }, "load radius 2e-50 m: ", "offset b"),
        (MachineParameters { damping: 1e200, ..WASHER }, "damping 1e200 kg/s: ", "damping rate"),
        (MachineParameters { damping: 1e-200, ..WASHER }, "damping 1e-200 kg/s: ", "damping rate"),
        (MachineParameters { damping: 5e-324, ..heavy }, "damping 5e-324 kg/s: ", "damping rate"),
        (MachineParameters { damping: 1e300, ..light }, "damping 1e300 kg/s: ", "damping rate"),
    ] {
        let message = refusal(parameters).1;
        assert!(message.starts_with(start) && message.contains(what), "{message}");
        assert!(message.contains("outside 1e-50 to 1e50"), "{message}");
    }
    let on_board = Machine::new(light).and_then(|machine| machine.rotor(1e49)).unwrap_err().to_string();
    assert!(on_board.starts_with("damping on board 1e49 kg/s: "), "{on_board}");
}

#[test]
fn changed_copies_are_checked_too() {
    assert_eq!(washer().with_spin(-12.0).unwrap().spin(), -12.0);
    let refused = [washer().with_spin(f64::NAN), washer().with_damping(-1.0)].map(Result::unwrap_err);
    assert_eq!(refused.map(|error| (error.quantity, error.rule))[0], ("spin", Rule::Finite));
    assert_eq!(refused.map(|error| (error.quantity, error.rule))[1], ("damping", Rule::NotNegative));
}

#[test]
fn undamped_resonance_has_no_steady_motion() {
    let error = resonant().steady().unwrap_err();
    assert_eq!((error.quantity, error.value, error.unit), ("spin", 10.0, "rad/s"));
    assert_eq!(
        error.to_string(),
        "spin 10 rad/s: the damping is 0 and this is the natural frequency, so the motion grows without end"
    );
    let pulled_out = LockedState { radius: 0.1, radius_rate: 0.0 };
    assert_eq!(resonant().locked(pulled_out).unwrap_err(), error);
    assert!(resonant().with_spin(-10.0).unwrap().steady().is_err());
    // One unit in the last place away there is one, a huge one.
    assert!(resonant().with_spin(10.0_f64.next_up()).unwrap().steady().unwrap().radius() > 1e13);
}

#[test]
fn a_start_must_be_finite_and_within_reach() {
    let names = [
        ("x of the start", "m"),
        ("y of the start", "m"),
        ("velocity along x of the start", "m/s"),
        ("velocity along y of the start", "m/s"),
    ];
    for (component, (name, unit)) in names.into_iter().enumerate() {
        for (bad, rule) in
            [(f64::NAN, Rule::Finite), (f64::NEG_INFINITY, Rule::Finite), (-2e50, Rule::InRange)]
        {
            let mut state = [0.0; 4];
            state[component] = bad;
            let start = Shaft::from_array(state);
            let errors = [washer().transient(start).unwrap_err(), washer().ramp(1.0, start).unwrap_err()];
            for error in errors {
                assert_eq!((error.quantity, error.unit, error.rule), (name, unit, rule));
            }
        }
    }
    for (radius, radius_rate, name) in
        [(f64::NAN, 0.0, "radius of the start"), (0.0, 2e50, "radial velocity of the start")]
    {
        let error = washer().locked(LockedState { radius, radius_rate }).unwrap_err();
        assert_eq!(error.quantity, name);
    }
    // A start may be as small as it likes.
    assert!(washer().transient(Shaft::from_array([1e-300, 5e-324, 0.0, -1e-60])).is_ok());
}

#[test]
fn a_ramp_is_neither_too_slow_nor_too_quick() {
    let machine = Machine::new(MachineParameters { stiffness: 30.0, ..WASHER }).unwrap(); // ω₀ = 1 rad/s
    let name = "angular acceleration over the square of the natural frequency";
    for (ratio, rule) in [
        (0.0, "0 is too small; it must be at least 1e-12"),
        (1e-13, "1e-13 is too small; it must be at least 1e-12"),
        (-1e13, "1e13 is too large; it must be at most 1e12"),
    ] {
        let error = machine.ramp(ratio, Shaft::AT_REST).unwrap_err();
        assert_eq!(error.to_string(), format!("{name} {rule}"));
    }
    let error = machine.ramp(f64::NAN, Shaft::AT_REST).unwrap_err();
    assert_eq!(error.to_string(), "angular acceleration NaN rad/s² is not a finite number");
}

#[test]
fn a_time_must_be_finite_and_within_reach() {
    let motion = washer().transient(Shaft::AT_REST).unwrap();
    for (bad, said) in [
        (f64::NAN, "time NaN s is not a finite number"),
        (f64::INFINITY, "time inf s is not a finite number"),
        (-1e51, "time -1e51 s is outside the range from 1e-50 to 1e50 s in size that is computed with"),
        // Nine minutes before the start, the motion that leads to it was beyond the largest number.
        (-530.0, "time -530 s: the motion there is beyond the largest number"),
    ] {
        assert_eq!(motion.at(bad).unwrap_err().to_string(), said);
        assert_eq!(motion.sample(&[1.0, bad, 2.0]).unwrap_err().to_string(), said);
        assert!(motion.centre_of_mass(bad).is_err());
    }
    let ramp = washer().ramp(1.0, Shaft::AT_REST).unwrap();
    assert!(ramp.at(f64::NAN).is_err() && ramp.at(1e51).is_err() && ramp.at(-1e6).is_err());
    assert!(ramp.sample(&[]).unwrap().is_empty() && ramp.sample(&[1.0, f64::NAN]).is_err());
    assert!(motion.at(1e50).is_ok() && ramp.at(1e50).is_ok() && motion.at(-400.0).is_ok());
    let running_away = washer().locked(LockedState { radius: 0.1, radius_rate: 0.0 }).unwrap();
    assert!(running_away.at(10.0).is_ok() && running_away.at(f64::NAN).is_err());
    assert_eq!(
        running_away.sample(&[1.0, 100.0]).unwrap_err().to_string(),
        "time 100 s: the motion there is beyond the largest number"
    );
}

#[test]
fn tolerances_below_rounding_are_refused() {
    for (bad, rule) in [
        (1e-16, Rule::AtLeast(1e-15)),
        (0.0, Rule::Positive),
        (-1e-6, Rule::Positive),
        (f64::NAN, Rule::Finite),
        (f64::INFINITY, Rule::Finite),
    ] {
        let error = Dop853::new(bad).unwrap_err();
        assert_eq!(error.rule, rule, "{bad}");
    }
    assert!(Dop853::new(1e-15).is_ok());
    assert!(Dop853::with_tolerances(1e-9, 0.0).is_ok());
    assert!(Dop853::with_tolerances(1e-9, -1.0).is_err() && Dop853::with_tolerances(1e-9, f64::NAN).is_err());
}

fn still(_: f64, _: &[f64; 1]) -> [f64; 1] {
    [0.0]
}

#[test]
fn integrations_refuse_intervals_and_states_that_are_not_finite() {
    let solver = Dop853::new(1e-9).unwrap();
    for (start, end) in [(0.0, f64::NAN), (f64::NEG_INFINITY, 0.0), (0.0, f64::INFINITY)] {
        let failures = [
            solver.solve(any(still), start, [1.0], end).unwrap_err(),
            rk4(still, start, [1.0], end, 5).unwrap_err(),
        ];
        for failure in failures {
            assert!(matches!(failure, Failure::Interval { .. }));
            assert_eq!(
                failure.to_string(),
                format!("the interval from {start} to {end} must have finite ends")
            );
        }
    }
    let failures = [
        solver.solve(any(still), 0.0, [f64::NAN], 1.0).unwrap_err(),
        rk4(still, 0.0, [f64::NAN], 1.0, 5).unwrap_err(),
    ];
    for failure in failures {
        assert!(matches!(failure, Failure::InitialState { .. }));
        assert_eq!(failure.to_string(), "the initial state [NaN] must be finite");
    }
    let failure = rk4(still, 0.0, [1.0], 1.0, 0).unwrap_err();
    assert_eq!(failure.to_string(), "0 steps: a fixed-step method needs at least one");
    assert_eq!(failure, Failure::NoSteps);
}

#[test]
fn an_interval_of_no_length_is_no_work() {
    let end = Dop853::new(1e-9).unwrap().solve(any(still), 2.0, [7.0], 2.0).unwrap();
    assert_eq!((end.time, end.state, end.work.evaluations), (2.0, [7.0], 0));
}

#[test]
fn sample_times_must_be_in_order() {
    let solver = Dop853::new(1e-9).unwrap();
    for (times, culprit) in [
        (vec![0.5, 0.4, 1.0], 1),
        (vec![-0.5, 1.0], 0),
        (vec![0.5, f64::NAN, 1.0], 1),
        (vec![0.5, f64::INFINITY], 0),
        (vec![0.5, 0.0], 0),
        (vec![-0.5, 0.0], 0),
        (vec![2e-200, 1e-200, 3e-200], 1),
    ] {
        let failure = solver.sample(any(still), 0.0, [1.0], &times).unwrap_err();
        let Failure::SampleTime { index, time } = failure else { panic!("{times:?}: {failure}") };
        assert!(index >= culprit && (time.is_nan() || time == times[index]), "{times:?}: {failure}");
        assert!(failure.to_string().contains("must lie in the interval and not before its predecessor"));
    }
}

#[test]
fn an_event_that_is_not_a_number_is_a_failure() {
    let solver = Dop853::new(1e-9).unwrap();
    let at_once =
        solver.solve_until(any(still), 0.0, [1.0], 1.0, |_, _| f64::NAN, Direction::Either).unwrap_err();
    assert!(matches!(at_once, Failure::EventNotANumber { .. }));
    let later = |t: f64, _: &[f64; 1]| (0.5 - t).sqrt();
    let failure = solver.solve_until(any(still), 0.0, [1.0], 1.0, later, Direction::Either).unwrap_err();
    assert!(matches!(failure, Failure::EventNotANumber { time, .. } if time < 0.5));
    // Finite at both ends of a step, and not in between.
    let within = |t: f64, _: &[f64; 1]| {
        if t == 0.0 || t == 1.0 { t - 0.5 } else { f64::NAN }
    };
    let one_step = solver.with_first_step(1.0).unwrap();
    let failure = one_step.solve_until(any(still), 0.0, [1.0], 1.0, within, Direction::Rising).unwrap_err();
    assert!(matches!(failure, Failure::EventNotANumber { time: 0.0, .. }));
}

#[test]
fn lengths_of_steps_that_mean_nothing_are_refused() {
    let (plain, taylor) = (Dop853::new(1e-9).unwrap(), Taylor::new(1e-9).unwrap());
    for (odd, said) in [(0.0, "0 must not be zero"), (f64::NAN, "NaN is not a finite number")] {
        let first = plain.with_first_step(odd).unwrap_err();
        assert_eq!(first.to_string(), format!("first step {said}"));
        for longest in [plain.with_max_step(odd).unwrap_err(), taylor.with_max_step(odd).unwrap_err()] {
            assert_eq!(longest.to_string(), format!("longest step {said}"));
        }
    }
    assert!(plain.with_first_step(f64::INFINITY).is_err());
    assert_eq!(plain.with_max_step(f64::INFINITY), Ok(plain));
    let swing = |_t: f64, &[x, v]: &[f64; 2]| [v, -x];
    let failure = plain.with_max_evaluations(0).solve(any(swing), 0.0, [1.0, 0.0], 5.0).unwrap_err();
    assert!(matches!(failure, Failure::TooMuchWork { time: 0.0, .. }));
}

//! What `mechanics` can do for each problem.

use crate::contest::{Cause, Entry};
use crate::problems::{self, Problem};
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{Dop853, Taylor, rk4};
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::spinning_coin::EulersDisk;
use mechanics::scenes::top::{Top, TopParameters};
use nalgebra::{Complex, Quaternion, UnitQuaternion, Vector3};
use std::f64::consts::PI;
use std::hint::black_box;
use std::rc::Rc;

/// The name under which the library competes.
const NAME: &str = "mechanics";
/// The moments of the free bodies: of the hoop about its pin, of the coin and of the ring.
const HOOP: [f64; 3] = [1.5, 0.5, 2.0];
const COIN: [f64; 3] = [0.25, 0.25, 0.5];
const RING: [f64; 3] = [0.5, 0.5, 1.0];
/// The names of the two kinds of method that need no stepping, or almost none.
const CLOSED: [&str; 2] = [NAME, "closed form"];
const REDUCED: [&str; 2] = [NAME, "half a wobble"];

/// Every entry of the library, problem by problem, the quickest way first.
///
/// # Errors
/// If the library refuses a problem, or a problem is missing.
pub(crate) fn entries() -> Result<Vec<Entry>, Cause> {
    let mut entries = Vec::new();
    washer(&mut entries);
    ramp(&mut entries);
    for (problem, steps) in [(problems::hoop(), RK4_HARD), (problems::separatrix(), RK4_HARD)] {
        body(&mut entries, problem, HOOP, problems::hoop_rates, steps);
    }
    disk(&mut entries);
    rest(&mut entries);
    body(&mut entries, problems::toss(), COIN, problems::flat_rates, RK4_FREE);
    body(&mut entries, problems::station(), RING, problems::flat_rates, RK4_FREE);
    drag(&mut entries);
    top(&mut entries);
    match problems::NAMES.iter().find(|name| entries.iter().all(|entry| entry.problem != **name)) {
        Some(missing) => Err(format!("nothing solves the problem `{missing}`").into()),
        None => Ok(entries),
    }
}

/// The free bodies by their closed form alone, for the race with another: their samples in a list, and one by one.
///
/// # Errors
/// If the library refuses a body.
pub(crate) fn closed_forms() -> Result<Vec<Entry>, Cause> {
    let mut entries = Vec::new();
    for (problem, moments) in [
        (problems::hoop(), HOOP),
        (problems::separatrix(), HOOP),
        (problems::toss(), COIN),
        (problems::station(), RING),
    ] {
        let problem = Rc::new(problem);
        entries.push(free_top(&problem, moments, "", |top, times, samples| {
            *samples = top.sample(times)?;
            Ok(())
        }));
        entries.push(free_top(&problem, moments, "one by one", |top, times, samples| {
            samples.clear();
            for &time in times {
                samples.push(top.at(time)?);
            }
            Ok(())
        }));
    }
    Ok(entries)
}

/// Steps of RK4 between two samples.
const RK4_WASHER: &[usize] = &[25, 50, 100, 200, 400, 800];
const RK4_HARD: &[usize] = &[50, 100, 200, 400, 800];
const RK4_DISK: &[usize] = &[50, 100, 200, 400, 800, 1600];
const RK4_FREE: &[usize] = &[12, 25, 50, 100, 200, 400];

/// The stepping methods, the same for every problem: DOP853 with its dense output, RK4 from sample to sample.
fn steppers<const N: usize>(
    entries: &mut Vec<Entry>,
    problem: &Rc<Problem<N>>,
    rates: impl Fn(f64, &[f64; N]) -> [f64; N] + Copy + 'static,
    steps: &[usize],
) {
    for digits in 3..=14 {
        let tolerance = 10.0_f64.powi(-digits);
        let solve = move |problem: &Problem<N>, samples: &mut Vec<[f64; N]>| {
            let (states, work) = Dop853::new(tolerance)?.sample(rates, 0.0, problem.start, &problem.times)?;
            *samples = states;
            Ok(Some(work.evaluations))
        };
        entries.push(Entry::new(problem, [NAME, "DOP853"], format!("tolerance 1e-{digits}"), solve, |y| *y));
    }
    for &steps in steps {
        let solve = move |problem: &Problem<N>, samples: &mut Vec<[f64; N]>| {
            samples.clear();
            samples.push(problem.start);
            let mut state = problem.start;
            for pair in problem.times.windows(2) {
                state = rk4(rates, pair[0], state, pair[1], steps)?;
                samples.push(state);
            }
            Ok(Some(4 * steps * (problem.times.len() - 1)))
        };
        entries.push(Entry::new(problem, [NAME, "RK4"], format!("{steps} steps a sample"), solve, |y| *y));
    }
}

/// One kilogram, all of it the load, one metre out: ω₀ = b = 1 and Γ = 0.01.
fn washing_machine(spin: f64) -> Result<Machine, Cause> {
    Ok(Machine::new(black_box(MachineParameters {
        drum_mass: 0.0,
        load_mass: 1.0,
        load_radius: 1.0,
        stiffness: 1.0,
        damping: 0.01,
        spin,
    }))?)
}

fn washer(entries: &mut Vec<Entry>) {
    let problem = Rc::new(problems::washer());
    let solve = |problem: &Problem<4>, samples: &mut Vec<Shaft>| {
        *samples = washing_machine(3.0)?.transient(Shaft::AT_REST)?.sample(&problem.times)?;
        Ok(None)
    };
    entries.push(Entry::new(&problem, CLOSED, String::new(), solve, Shaft::to_array));
    steppers(entries, &problem, problems::washer_rates, RK4_WASHER);
}

fn ramp(entries: &mut Vec<Entry>) {
    let problem = Rc::new(problems::ramp());
    let solve = |problem: &Problem<4>, samples: &mut Vec<Shaft>| {
        *samples = washing_machine(0.0)?.ramp(0.01, Shaft::AT_REST)?.sample(&problem.times)?;
        Ok(None)
    };
    entries.push(Entry::new(&problem, CLOSED, String::new(), solve, Shaft::to_array));
    steppers(entries, &problem, problems::ramp_rates, RK4_WASHER);
}

/// How the body of a problem starts.
pub(crate) fn turning(problem: &Problem<7>) -> Turning {
    let [w1, w2, w3, w, i, j, k] = problem.start;
    Turning {
        world_from_body: UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, k)),
        omega_body: Vector3::new(w1, w2, w3),
    }
}

/// A free body by its closed form; `fill` takes the samples.
fn free_top(
    problem: &Rc<Problem<7>>,
    [i1, i2, i3]: [f64; 3],
    setting: &str,
    fill: impl Fn(&FreeTop, &[f64], &mut Vec<Turning>) -> Result<(), Cause> + 'static,
) -> Entry {
    let solve = move |problem: &Problem<7>, samples: &mut Vec<Turning>| {
        let top = FreeTop::new(PrincipalMoments::new(i1, i2, i3)?, turning(problem))?;
        fill(&top, &problem.times, samples)?;
        Ok(None)
    };
    Entry::new(problem, CLOSED, setting.to_owned(), solve, turning_state)
}

/// The state of a problem from the library's.
fn turning_state(turning: &Turning) -> [f64; 7] {
    let [w, i, j, k, w1, w2, w3] = turning.to_array();
    [w1, w2, w3, w, i, j, k]
}

/// A free body, by its closed form, and stepped.
fn body(
    entries: &mut Vec<Entry>,
    problem: Problem<7>,
    moments: [f64; 3],
    rates: impl Fn(f64, &[f64; 7]) -> [f64; 7] + Copy + 'static,
    steps: &[usize],
) {
    let problem = Rc::new(problem);
    entries.push(free_top(&problem, moments, "", |top, times, samples| {
        *samples = top.sample(times)?;
        Ok(())
    }));
    steppers(entries, &problem, rates, steps);
}

fn disk(entries: &mut Vec<Entry>) {
    let problem = Rc::new(problems::disk());
    for digits in 4..=16 {
        let tolerance = 10.0_f64.powi(-digits);
        let solve = move |problem: &Problem<8>, states: &mut Vec<Rolling>| {
            let wheel = Wheel::new(black_box(UNIT_DISC))?;
            let wobble = wheel.wobble(rolling(&problem.start), &Taylor::new(tolerance)?)?;
            *states = wobble.sample(&problem.times)?;
            Ok(None)
        };
        entries.push(Entry::new(&problem, REDUCED, format!("tolerance 1e-{digits}"), solve, contact_state));
    }
    steppers(entries, &problem, problems::disk_rates, RK4_DISK);
}

fn rest(entries: &mut Vec<Entry>) {
    let problem = Rc::new(problems::rest());
    for digits in 4..=16 {
        let tolerance = 10.0_f64.powi(-digits);
        let solve = move |problem: &Problem<8>, states: &mut Vec<Rolling>| {
            let disk = EulersDisk::new(black_box(UNIT_DISC), 1e-5)?;
            let sinking = disk.sinking(rolling(&problem.start), &Taylor::new(tolerance)?)?;
            *states = sinking.sample(&problem.times)?;
            Ok(None)
        };
        entries.push(Entry::new(
            &problem,
            [NAME, "Taylor"],
            format!("tolerance 1e-{digits}"),
            solve,
            contact_state,
        ));
    }
    steppers(entries, &problem, problems::rest_rates, RK4_DISK);
}

fn drag(entries: &mut Vec<Entry>) {
    let problem = Rc::new(problems::drag());
    let solve = |problem: &Problem<3>, samples: &mut Vec<Vector3<f64>>| {
        let [w1, w2, w3] = problem.start;
        let moments = PrincipalMoments::new(0.25, 0.25, 0.5)?;
        let (drag, omega_body) = (Drag::isotropic(1e-4), Vector3::new(w1, w2, w3));
        let top = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?;
        *samples = top.sample(&problem.times)?;
        Ok(None)
    };
    entries.push(Entry::new(&problem, CLOSED, String::new(), solve, |omega| (*omega).into()));
    steppers(entries, &problem, problems::drag_rates, RK4_FREE);
}

fn top(entries: &mut Vec<Entry>) {
    let problem = Rc::new(problems::top());
    // Half a metre of arm under twice a unit of gravity.
    let parameters = TopParameters { mass: 1.0, arm: 0.5, transverse: 1.0, axial: 0.5, gravity: 2.0 };
    let solve = move |problem: &Problem<7>, samples: &mut Vec<Turning>| {
        *samples = Top::new(black_box(parameters))?.motion(&turning(problem))?.sample(&problem.times)?;
        Ok(None)
    };
    entries.push(Entry::new(&problem, CLOSED, String::new(), solve, turning_state));
    steppers(entries, &problem, problems::top_rates, RK4_HARD);
}

/// A disc in units of its mass, its radius and gravity.
pub(crate) const UNIT_DISC: DiskParameters =
    DiskParameters { mass: 1.0, radius: 1.0, moments: MomentFactors::DISK, gravity: 1.0 };

/// The library's disk from the state of the problem, whose normal is the opposite one, e₃ = −3̂, e₂ = 2̂, e₁ = −1̂, and
/// whose place is that of the contact.
fn rolling(&[tilt, w1, w2, w3, psi, x, y, phi]: &[f64; 8]) -> Rolling {
    let turned = Rolling { tilt, heading: psi + PI, ..Rolling::UPRIGHT };
    Rolling {
        omega_1: -w1,
        omega_2: w2,
        omega_3: -w3,
        roll_angle: -phi,
        centre: Complex::new(x, y) - turned.contact(1.0),
        ..turned
    }
}

/// The state of the problem from the library's disk.
fn contact_state(rolling: &Rolling) -> [f64; 8] {
    let Rolling { tilt, omega_1, omega_2, omega_3, heading, roll_angle, .. } = *rolling;
    let contact = rolling.contact(1.0);
    [tilt, -omega_1, omega_2, -omega_3, heading - PI, contact.re, contact.im, -roll_angle]
}

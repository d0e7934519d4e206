//! Every stepping method has the order that [`METHODS`] promises, costs what it says and keeps what it says.

mod keeps;
mod runge_kutta;
mod table;

use crate::common::any;
use mechanics::euler::{self, FreeSeries, Turning};
use mechanics::geometric::{Splitting, commutator_free};
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::methods::Method;
use mechanics::integrate::{Dop853, METHODS, Taylor, rk4};
use mechanics::measure::{ObservedOrder, observed_order};
use nalgebra::{UnitQuaternion, Vector3};

/// An observed slope may miss the order by this much: the error is a power of the step only in the limit of
/// short steps.
const SLACK: f64 = 0.35;

/// Errors at or below this are rounding over some hundred steps on states of size one.
const PLATEAU: f64 = 2e-14;

/// Slopes from fewer points above rounding are no evidence.
const ENOUGH: usize = 5;

/// A tolerance that every step meets, so that the length limit alone sets the steps.
const LOOSE: f64 = 1e12;

fn observed(steps: &[usize], error: impl Fn(usize) -> f64) -> ObservedOrder {
    let pairs: Vec<(f64, f64)> = steps.iter().map(|&n| (1.0 / n as f64, error(n))).collect();
    println!("{pairs:?}");
    observed_order(&pairs, PLATEAU).expect("enough points above rounding")
}

fn assert_order(name: &str, found: ObservedOrder, promised: u32) {
    println!("{name}: order {:.2} from {} points", found.slope, found.points);
    assert!(found.points >= ENOUGH, "{name}: only {} points above rounding", found.points);
    assert!(
        (found.slope - f64::from(promised)).abs() < SLACK,
        "{name}: order {} for {promised}",
        found.slope
    );
}

fn method(name: &str) -> Method {
    *METHODS.iter().find(|method| method.name == name).expect("the method is in the table")
}

/// The body on which all methods are compared, that of the chapter.
fn brick() -> (PrincipalMoments, Turning) {
    let moments = PrincipalMoments::new(1.0, 1.6, 2.1).expect("a body");
    let world_from_body = UnitQuaternion::from_euler_angles(0.3, 0.2, 0.1);
    (moments, Turning { world_from_body, omega_body: Vector3::new(0.7, 0.9, 0.5) })
}

/// That body after `duration` in so many steps of fixed length, as seven numbers that nobody has normed.
type Run = fn(start: Turning, duration: f64, steps: usize) -> [f64; 7];

/// How a method of the table is run, and numbers of steps for a duration of [`DURATION`] in which its error
/// is a power of the step.
fn run(name: &str) -> (Run, [usize; 8]) {
    fn free() -> impl FnMut(f64, &[f64; 7]) -> [f64; 7] {
        euler::turning_rates(brick().0, |_, _| Vector3::zeros())
    }
    match name {
        "RK4" => (
            |start, duration, steps| rk4(free(), 0.0, start.to_array(), duration, steps).unwrap(),
            [240, 340, 480, 680, 960, 1360, 1920, 2720],
        ),
        "DOP853" => (
            |start, duration, steps| {
                let h = (duration / steps as f64).abs();
                let solver =
                    Dop853::new(LOOSE).unwrap().with_first_step(h).unwrap().with_max_step(h).unwrap();
                solver.solve(any(free()), 0.0, start.to_array(), duration).unwrap().state
            },
            [40, 48, 58, 70, 84, 100, 120, 144],
        ),
        "Taylor" => (
            |start, duration, steps| {
                let solver = Taylor::new(LOOSE).unwrap().with_max_step(duration / steps as f64).unwrap();
                let body = FreeSeries::new(&brick().0);
                solver.solve(&body, 0.0, start.to_array(), duration).unwrap().state
            },
            [24, 27, 30, 33, 37, 41, 46, 51],
        ),
        "CF4" => (
            |start, duration, steps| {
                let free = |_: f64, _: &Turning| Vector3::zeros();
                commutator_free(&brick().0, free, 0.0, start, duration, steps).unwrap().to_array()
            },
            [240, 340, 480, 680, 960, 1360, 1920, 2720],
        ),
        "Strang" => (
            |start, duration, steps| {
                Splitting::Strang.solve(&brick().0, start, duration, steps).unwrap().to_array()
            },
            [120, 170, 240, 340, 480, 680, 960, 1360],
        ),
        "Blanes–Moan" => (
            |start, duration, steps| {
                Splitting::BlanesMoan.solve(&brick().0, start, duration, steps).unwrap().to_array()
            },
            [30, 42, 60, 85, 120, 170, 240, 340],
        ),
        other => panic!("the table has a method that is not tested: {other}"),
    }
}

/// How long the body turns, s: a little more than one round of its polhode.
const DURATION: f64 = 30.0;

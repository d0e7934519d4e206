//! Polar coordinates near their origin.

use crate::machine;
use mechanics::integrate::{Dop853, rk4};
use mechanics::scenes::laundromat::{Polar, Shaft};
use nalgebra::Complex;

/// Error in place after one second of the polar equations and of the Cartesian ones, both by RK4 with steps of 1 ms,
/// for a shaft that passes O at distance `miss`, m, halfway through; `None` where the program broke down.
fn errors_of_passing(miss: f64) -> (Option<f64>, f64) {
    let machine = machine(0.01, 1e-3);
    // Straight through at 1 m/s, near enough: from half a second before the closest approach.
    let start = Shaft { position: Complex::new(-0.5, miss), velocity: Complex::new(1.0, 0.0) };
    let exact = machine.transient(start).unwrap().at(1.0).unwrap().position;
    let polar = rk4(|t, y: &[f64; 4]| machine.polar_rates(t, y), 0.0, start.to_polar().to_array(), 1.0, 1000)
        .ok()
        .map(|end| (Shaft::from_polar(Polar::from_array(end)).position - exact).norm());
    let lab = rk4(|t, y: &[f64; 4]| machine.cartesian_rates(t, y), 0.0, start.to_array(), 1.0, 1000).unwrap();
    (polar, (Shaft::from_array(lab).position - exact).norm())
}

#[test]
fn polar_program_fails_near_the_origin_and_the_cartesian_one_does_not() {
    let mut worst_polar = 0.0_f64;
    for miss in [0.1, 1e-2, 1e-3, 1e-4, 1e-5] {
        let (polar, lab) = errors_of_passing(miss);
        println!("miss {miss:e} m: polar {polar:?}, lab {lab:e}");
        assert!(lab < 1e-12, "miss {miss}: {lab:e} in the laboratory");
        worst_polar = worst_polar.max(polar.unwrap_or(f64::INFINITY));
        if miss == 0.1 {
            assert!(polar.unwrap() < 1e-6, "a wide miss is no trouble");
        }
    }
    assert!(
        worst_polar > 0.1,
        "a near miss should ruin the polar program; the worst error was {worst_polar:e}"
    );
    // From O itself, where every start is, it does not get away at all.
    let machine = machine(0.01, 3.0);
    assert!(rk4(|t, y: &[f64; 4]| machine.polar_rates(t, y), 0.0, [0.0; 4], 1.0, 1000).is_err());
}

#[test]
fn step_control_saves_the_polar_program_at_several_times_the_work() {
    let machine = machine(0.01, 3.0);
    let start = Shaft { position: Complex::new(-0.5, 0.01), velocity: Complex::new(1.0, 0.05) };
    let solver = Dop853::new(1e-10).unwrap();
    let polar = solver
        .solve(|t, y: &[f64; 4]| machine.polar_rates(t, y), 0.0, start.to_polar().to_array(), 30.0)
        .unwrap();
    let lab =
        solver.solve(|t, y: &[f64; 4]| machine.cartesian_rates(t, y), 0.0, start.to_array(), 30.0).unwrap();
    let ratio = polar.work.evaluations as f64 / lab.work.evaluations as f64;
    println!("polar takes {ratio} times the evaluations");
    assert!(ratio > 1.5, "{ratio}");
}

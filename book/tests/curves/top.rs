//! The top under gravity: its curves against Newton's law, stepped, and the formulas by hand.

use crate::{lies_on, passes};
use mechanics::integrate::Dop853;

/// The toy of the chapter, as numbers: I₁, I₃, mgl, and its spin.
const ACROSS: f64 = 2e-4;
const ALONG: f64 = 5e-5;
const WEIGHT: f64 = 0.1 * 0.04 * 9.81;
const SPIN: f64 = 150.0;

#[test]
fn the_well_is_what_going_round_and_the_weight_cost() {
    let upright = ALONG * SPIN * 30_f64.to_radians().cos(); // L_z of a release at rest
    lies_on("top-well", "well", |degrees| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let rate = (upright - ALONG * SPIN * cos) / (ACROSS * sin * sin);
        1e3 * (0.5 * ACROSS * (rate * sin).powi(2) + WEIGHT * cos)
    });
}

#[test]
fn the_tip_goes_as_the_angles_stepped_have_it() {
    for (name, push) in [("waves", 3.0), ("cusps", 0.0), ("loops", -3.0)] {
        let (sin, cos) = 30_f64.to_radians().sin_cos();
        let upright = ALONG * SPIN * cos + ACROSS * push * sin * sin;
        let rates = move |_: f64, [tilt, rate, _]: &[f64; 3]| {
            let (sin, cos) = tilt.sin_cos();
            let round = (upright - ALONG * SPIN * cos) / (ACROSS * sin * sin);
            let pull = ACROSS * round * round * sin * cos - ALONG * SPIN * round * sin + WEIGHT * sin;
            [*rate, pull / ACROSS, round]
        };
        let solver = Dop853::new(1e-12).expect("a solver");
        let tip = |n: i32| {
            let time = 1.0 * f64::from(n) / 400.0; // a little less than the figure shows
            let [tilt, _, round] = if n == 0 {
                [30_f64.to_radians(), 0.0, 0.0]
            } else {
                solver.solve(rates, 0.0, [30_f64.to_radians(), 0.0, 0.0], time).expect("a motion").state
            };
            // The axis leans a quarter turn behind the line of nodes.
            (tilt.sin() * round.sin(), -tilt.sin() * round.cos())
        };
        passes("top-tracks", name, (0..=400).map(tip));
    }
}

#[test]
fn the_rates_of_steady_precession_are_roots() {
    let middle = |spin: f64| ALONG * spin / (2.0 * ACROSS * 30_f64.to_radians().cos());
    let half = |spin: f64| (middle(spin).powi(2) - WEIGHT / (ACROSS * 30_f64.to_radians().cos())).sqrt();
    lies_on("top-steady", "slow", |spin| middle(spin) - half(spin));
    lies_on("top-steady", "fast", |spin| middle(spin) + half(spin));
    lies_on("top-steady", "estimate", |spin| WEIGHT / (ALONG * spin));
}

#[test]
fn a_sleeper_wakes_like_a_root() {
    lies_on("top-waking", "resting", |part: f64| 2.0 * part.min(1.0).sqrt().acos().to_degrees());
    lies_on("top-waking", "furthest", |part: f64| 2.0 * part.min(1.0).acos().to_degrees());
}

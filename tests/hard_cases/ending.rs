//! A motion that ends: the tilt of a spinning coin, with a loss that grows without bound.

use super::{FEW_ULPS, ROUNDOFF, TOY, assert_level, assert_slope, number, relative, rows};
use crate::common::any;
use mechanics::integrate::{Dop853, Failure, rk4};
use mechanics::rolling::{DiskParameters, MomentFactors};
use mechanics::scenes::spinning_coin::{Loss, SpinDown, SpinningCoin};
use std::f64::consts::TAU;

fn start() -> SpinningCoin {
    SpinningCoin::new(TOY, 0.1).expect("a coin")
}

/// α̇ = −1/(3α²), the film's law in units of α₀ and t₀: α³ = 1 − t.
fn film(_t: f64, &[tilt]: &[f64; 1]) -> [f64; 1] {
    [-1.0 / (3.0 * tilt * tilt)]
}

#[test]
fn equal_steps_go_through_the_end_without_a_word() {
    for steps in [150, 1500, 15_000] {
        let [beyond] = rk4(film, 0.0, [1.0], 1.5, steps).unwrap();
        // Half a life after the end: the third root of −1/2, and a little more.
        assert!((-0.9..-0.793).contains(&beyond), "{steps} steps: {beyond}");
    }
    let careless = Dop853::new(1e-6).unwrap().solve(any(film), 0.0, [1.0], 1.5).unwrap();
    assert!(relative(careless.state[0], -0.5_f64.cbrt()) < 1e-6);
    // A finer tolerance stops there, with a word about its step and none about the coin.
    let careful = Dop853::new(1e-9).unwrap().solve(any(film), 0.0, [1.0], 1.5).unwrap_err();
    assert!(matches!(careful, Failure::StepUnderflow { time, .. } if (time - 1.0).abs() < 1e-9), "{careful}");
}

#[test]
fn equal_steps_lose_four_digits_a_decade_of_the_time_left() {
    let errors = [1e-1, 3e-2, 1e-2, 3e-3, 1e-3_f64].map(|left| {
        let [tilt] = rk4(film, 0.0, [1.0], 1.0 - left, 10_000).unwrap();
        (left, relative(tilt, left.cbrt()))
    });
    assert_slope("equal steps towards the end", &errors[1..], -4.0, 0.2);
    assert_level("equal steps towards the end", &errors[1..], |left| (1e-4 / left).powi(4), 1e-4..4e-4);
}

#[test]
fn step_control_loses_a_digit_a_decade_because_it_has_moved_the_end() {
    for (tolerance, moved) in [(1e-6, 1.6e-8), (1e-9, 9.6e-11), (1e-12, 1.4e-13)] {
        let solver = Dop853::new(tolerance).unwrap();
        let mut errors = Vec::new();
        for exponent in 1..=6 {
            let end = 1.0 - 10_f64.powi(-exponent);
            let left = 1.0 - end; // exact
            let tilt = solver.solve(any(film), 0.0, [1.0], end).unwrap().state[0];
            errors.push((left, relative(tilt, left.cbrt())));
        }
        assert_slope("step control towards the end", &errors, -1.0, 0.04);
        // δα/α = δt₀/3τ with one and the same δt₀.
        let shift = 3.0 * errors[5].0 * errors[5].1;
        assert!(
            (0.7..1.5).contains(&(shift / moved)),
            "tolerance {tolerance:e}: the end has moved by {shift:e}"
        );
    }
    // A hundredth of a millionth of a per cent before the end, at 1e-9: three per cent off; then it cannot go on.
    let solver = Dop853::new(1e-9).unwrap();
    let end = 1.0 - 1e-9;
    let tilt = solver.solve(any(film), 0.0, [1.0], end).unwrap().state[0];
    assert!((0.02..0.05).contains(&relative(tilt, (1.0 - end).cbrt())));
    assert!(solver.solve(any(film), 0.0, [1.0], 1.0 - 1e-12).is_err());
}

#[test]
fn cube_of_the_tilt_makes_the_law_a_straight_line() {
    // d(α³)/dt = −1: every method is exact, in one step.
    for left in [1e-1, 1e-5, 1e-9_f64] {
        let end = 1.0 - left;
        let [cube] = rk4(|_, _: &[f64; 1]| [-1.0], 0.0, [1.0], end, 1).unwrap();
        assert!((cube - (1.0 - end)).abs() < f64::EPSILON, "{cube:e}");
    }
}

#[test]
fn spin_down_is_exact_however_little_time_is_left() {
    for row in rows("spin_down") {
        let exponent = number(&row["exponent"]);
        let loss = match row["coefficient"].as_str() {
            Some("film") => Loss::air_film(&start(), 1.78e-5),
            _ => Loss::new(number(&row["coefficient"]), exponent),
        };
        let spin_down = SpinDown::new(start(), loss.unwrap()).unwrap();
        let (life, left, tilt) = (number(&row["life"]), number(&row["left"]), number(&row["tilt"]));
        assert!(relative(spin_down.life(), life) < FEW_ULPS);
        let coin = spin_down.with_time_left(left).unwrap();
        assert!(relative(coin.tilt(), tilt) < FEW_ULPS, "p = {exponent}, {left:e} s left");
        assert!(
            relative(coin.turn_rate(), number(&row["turn"])) < FEW_ULPS,
            "p = {exponent}, {left:e} s left"
        );
        assert!(
            relative(spin_down.time_left(tilt).unwrap(), left) < FEW_ULPS,
            "p = {exponent}, {left:e} s left"
        );
        // By the time since the start the same, as far as that time can say it: τ is a difference of rounded numbers.
        if left > 1e-10 {
            let error = relative(spin_down.at(life - left).unwrap().tilt(), tilt);
            assert!(error < FEW_ULPS + 3.0 * ROUNDOFF * life / left, "p = {exponent}, {left:e} s: {error:e}");
        }
    }
}

#[test]
fn law_of_the_film_asks_the_centre_to_fall_faster_than_gravity_before_the_end() {
    // Of the height a sin α by second differences, which know nothing of the law's powers.
    let spin_down = SpinDown::new(start(), Loss::air_film(&start(), 1.78e-5).unwrap()).unwrap();
    let fall = |left: f64| {
        let height = |left: f64| 0.0375 * spin_down.with_time_left(left).unwrap().tilt().sin();
        let h = 1e-3 * left;
        (height(left + h) - 2.0 * height(left) + height(left - h)) / (h * h) / -9.81
    };
    // Moffatt's criterion: τ = (2a/9g)^{3/5} κ^{1/5} with κ = 2πμa/m.
    let kappa = TAU * 1.78e-5 * 0.0375 / TOY.mass;
    let free = (2.0 * 0.0375 / (9.0 * 9.81_f64)).powf(0.6) * f64::powf(kappa, 0.2);
    assert!(relative(free, 1.451e-3) < 1e-3 && relative(fall(free), 1.0) < 1e-4, "{free:e}, {}", fall(free));
    // Where the coin would sink by its height within a radian of its round, with eight times gravity.
    let round = free / 8_f64.powf(0.6);
    let coin = spin_down.with_time_left(round).unwrap();
    assert!(relative(3.0 * coin.turn_rate() * round, 1.0) < 1e-5 && relative(fall(round), 8.0) < 1e-4);
}

#[test]
fn spin_down_spends_its_energy_at_the_stated_rate() {
    // By Simpson's rule: the time between two tilts is the integral of dE over the power.
    let (coefficient, exponent) = (2e-4, 1.25);
    for tilt in [0.1, 0.7, 1.5] {
        let hoop = DiskParameters { radius: 0.05, moments: MomentFactors::HOOP, ..TOY };
        let start = SpinningCoin::new(hoop, tilt).unwrap();
        let spin_down = SpinDown::new(start, Loss::new(coefficient, exponent).unwrap()).unwrap();
        let energy = |tilt: f64| SpinningCoin::new(hoop, tilt).unwrap().energy();
        let lower = 0.3 * tilt;
        let n = 2000;
        let (from, to) = (energy(lower), energy(tilt));
        let slowness = |part: f64| {
            let sin = (from + (to - from) * part) / (1.5 * TOY.mass * 9.81 * 0.05);
            sin.powf(exponent) / coefficient
        };
        let sum: f64 = (0..n)
            .map(|k| {
                let at = |part: f64| slowness((f64::from(k) + part) / f64::from(n));
                (at(0.0) + 4.0 * at(0.5) + at(1.0)) / 6.0
            })
            .sum();
        let time = sum / f64::from(n) * (to - from);
        assert!(relative(spin_down.time_to(lower).unwrap(), time) < 1e-11);
        assert!(relative(spin_down.at(time).unwrap().tilt(), lower) < 1e-10);
        let left = spin_down.time_left(lower).unwrap();
        assert!(relative(left + time, spin_down.life()) < 1e-11);
    }
}

//! The pinned hoop, the rolling wheel and the spinning coin: formulas and equations of motion written out here.

use crate::Range::{Linear, Log};
use crate::{Frame, lies_on};

/// One Runge-Kutta step.
pub(crate) fn step<const N: usize>(
    rates: impl Fn(f64, [f64; N]) -> [f64; N],
    t: f64,
    y: [f64; N],
    h: f64,
) -> [f64; N] {
    let along = |k: [f64; N], h: f64| std::array::from_fn(|n| y[n] + h * k[n]);
    let k1 = rates(t, y);
    let k2 = rates(t + 0.5 * h, along(k1, 0.5 * h));
    let k3 = rates(t + 0.5 * h, along(k2, 0.5 * h));
    let k4 = rates(t + h, along(k3, h));
    std::array::from_fn(|n| y[n] + h / 6.0 * (k1[n] + 2.0 * k2[n] + 2.0 * k3[n] + k4[n]))
}

#[test]
fn the_speeds_of_b_are_a_difference_a_sum_and_a_root() {
    let frame = Frame { place: [52.0, 34.0, 470.0, 262.0], x: Linear(0.0, 90.0), y: Linear(0.0, 1.2) };
    let parts = |degrees: f64| (degrees.to_radians().sin() / 3.0, degrees.to_radians().cos());
    lies_on("speed-of-b", "plus", &frame, |degrees| (parts(degrees).0 - parts(degrees).1).abs());
    lies_on("speed-of-b", "minus", &frame, |degrees| parts(degrees).0 + parts(degrees).1);
    lies_on("speed-of-b", "stated", &frame, |degrees| parts(degrees).0.hypot(parts(degrees).1));
}

#[test]
fn the_hoop_flips_as_eulers_equations_say() {
    let frame = Frame { place: [58.0, 34.0, 500.0, 250.0], x: Linear(0.0, 150.0), y: Linear(-0.4, 0.4) };
    // Moments 3/2, 1/2 and 2 about the pin.
    let rates = |_: f64, [a, b, c]: [f64; 3]| [-b * c, c * a, 0.5 * a * b];
    let angle = 89.9_f64.to_radians();
    let h = 0.005;
    let mut motion = vec![[angle.sin() / 3.0, -angle.cos(), 0.0]];
    for n in 0..30_000 {
        motion.push(step(rates, 0.0, motion[n], h));
    }
    for (axis, name) in [(0, "tangent"), (1, "diameter")] {
        lies_on("flip", name, &frame, |time| {
            let n = (time / h) as usize;
            step(rates, 0.0, motion[n], time - h * n as f64)[axis]
        });
    }
}

#[test]
fn the_turn_rate_and_the_friction_of_a_disc_follow_their_formulas() {
    let square = |lean: f64, b: f64| 2.0 * lean.tan() / (3.0 * b + 0.5 * lean.sin());
    let frame = Frame { place: [48.0, 34.0, 540.0, 262.0], x: Linear(-0.2, 1.0), y: Linear(0.0, 20.0) };
    for degrees in [20.0_f64, 45.0, 70.0] {
        lies_on("turn-rate", &format!("lean-{degrees}"), &frame, |b| square(degrees.to_radians(), b));
    }
    let frame = Frame { place: [52.0, 34.0, 540.0, 262.0], x: Linear(0.0, 3.0), y: Linear(0.0, 1.25) };
    for degrees in [20.0_f64, 45.0, 60.0] {
        lies_on("friction", &format!("lean-{degrees}"), &frame, |b| b * square(degrees.to_radians(), b));
    }
}

#[test]
fn the_potential_is_the_energy_of_spin_and_height() {
    let frame = Frame { place: [58.0, 34.0, 540.0, 262.0], x: Linear(-30.0, 40.0), y: Linear(1.54, 1.66) };
    // Across and along spin as functions of the lean, from the motion of the text: 0.45 and 0.9 at 0.3.
    let rates = |lean: f64, [across, along]: [f64; 2]| [across * lean.tan() + 2.0 * along, across / 1.5];
    lies_on("potential", "potential", &frame, |degrees| {
        let (start, lean) = (0.3, degrees.to_radians());
        let h = (lean - start) / 200.0;
        let end = (0..200).fold([0.45, 0.9], |spins, n| step(rates, start + h * f64::from(n), spins, h));
        0.5 * (0.25 * end[0] * end[0] + 1.5 * end[1] * end[1]) + lean.cos()
    });
}

#[test]
fn the_rates_of_the_coin_are_straight_until_it_stands_up() {
    let (radius, gravity) = (0.0375, 9.81);
    let contact = |tilt: f64| (4.0 * gravity / (radius * tilt.sin())).sqrt();
    let frame = Frame { place: [60.0, 34.0, 470.0, 286.0], x: Log(1e-4, 1.0), y: Log(1e-5, 1e4) };
    lies_on("coin-rates", "contact", &frame, contact);
    lies_on("coin-rates", "figure", &frame, |tilt| contact(tilt) * 2.0 * (0.5 * tilt).sin().powi(2));
    lies_on("coin-rates", "vertical", &frame, |tilt| contact(tilt) * tilt.sin().powi(2));
    let frame = Frame { place: [60.0, 34.0, 560.0, 262.0], x: Log(1e-6, 1.0), y: Log(1e-3, 10.0) };
    lies_on("mach", "mach", &frame, |tilt| contact(tilt) * radius * tilt.cos() / 343.0);
}

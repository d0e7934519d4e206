//! The small scene of "A motor of limited torque" against Lagrange's equations for shaft and drum in the room.

use crate::hand::Hand;
use mechanics::integrate::Dop853;

/// The spin at some times of a drum from rest whose motor stands at a torque, and from 25 s on at another.
fn spins(knob: [f64; 2], times: &[f64]) -> Vec<f64> {
    let (total, unbalance, inertia) = (30.0, 2.0 * 0.25, 0.5 + 2.0 * 0.25 * 0.25);
    let rates = |time: f64, &[x, y, angle, vx, vy, spin]: &[f64; 6]| {
        let (sin, cos) = f64::sin_cos(angle);
        let torque = knob[usize::from(time >= 25.0)] * (1.0 - spin / 40.0);
        let (fx, fy) = (-3000.0 * x - 45.0 * vx, -3000.0 * y - 45.0 * vy);
        let faster =
            (torque + unbalance / total * (sin * fx - cos * fy)) / (inertia - unbalance * unbalance / total);
        let ax = (fx + unbalance * (faster * sin + spin * spin * cos)) / total;
        let ay = (fy - unbalance * (faster * cos - spin * spin * sin)) / total;
        [vx, vy, spin, ax, ay, faster]
    };
    let solver = Dop853::new(1e-10).unwrap().with_max_step(0.05).unwrap();
    let times: Vec<f64> = [0.0].iter().chain(times).copied().collect();
    let (states, _) = solver.sample(rates, 0.0, [0.0; 6], &times).unwrap();
    states[1..].iter().map(|state| state[5]).collect()
}

#[test]
fn the_drum_turns_as_by_lagrange() {
    for (first, then) in [(3.0, 6.0), (6.0, 6.0), (9.0, 6.0), (6.0, 0.5)] {
        let hand = Hand::with("knob", &[("first", first), ("torque", then)]);
        let times = [3.0, 10.0, 24.0, 30.0, 99.0];
        for (time, spin) in times.iter().zip(spins([first, then], &times)) {
            let found = hand.reading(*time, "spin");
            assert!((found - spin).abs() < 0.03, "{first}, then {then}, at {time} s: {found}, not {spin}");
        }
    }
}

#[test]
fn where_it_ends_depends_on_the_way() {
    let end = |settings: &[(&str, f64)]| Hand::with("knob", settings).reading(100.0, "spin");
    // The speeds of the page.
    assert!((end(&[]) - 9.734).abs() < 5e-3 && (end(&[("first", 9.0)]) - 36.45).abs() < 5e-3);
    assert!((end(&[("first", 6.0), ("turn", -1.0)]) - 36.45).abs() < 5e-3);
    // Beyond the fold at 7.525 N·m it leaps, whatever was before; and with an earlier press it remembers that.
    assert!(end(&[("torque", 8.0)]) > 37.0 && end(&[("torque", 6.2)]) < 10.0);
    let up_and_back = Hand::with("knob", &[("turn", 50.0)]).pressed("turn", &[[10.0, 8.0, 0.0]]);
    assert!((up_and_back.reading(100.0, "spin") - 36.45).abs() < 0.05);
}

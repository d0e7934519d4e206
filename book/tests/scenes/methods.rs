//! The scene of "Methods" against the ten lines that everybody writes first, and what the chapter says of RK4.

use crate::hand::{Hand, number_behind};

/// The energy by Euler's method, of that of the throw, after so many steps.
fn euler(h: f64, steps: u32) -> f64 {
    let [i1, i2, i3] = [1.0, 1.6, 2.1];
    let energy = |[w1, w2, w3]: [f64; 3]| i1 * w1 * w1 + i2 * w2 * w2 + i3 * w3 * w3;
    let throw = [1.0, 0.12, 0.0];
    let mut w = throw;
    for _ in 0..steps {
        let [w1, w2, w3] = w;
        w = [
            w1 + h * (i2 - i3) / i1 * w2 * w3,
            w2 + h * (i3 - i1) / i2 * w3 * w1,
            w3 + h * (i1 - i2) / i3 * w1 * w2,
        ];
    }
    energy(w) / energy(throw)
}

#[test]
fn eulers_method_gains_what_ten_lines_gain() {
    for (step, time) in [(0.1, 240.0), (0.05, 120.0), (0.25, 60.0)] {
        let found = Hand::with("methods", &[("step", step)]).reading(time, "by Euler");
        let expected = euler(step, (time / step).round() as u32);
        assert!((found - expected).abs() < 1e-9, "{step}: {found}, not {expected}");
    }
    assert!((euler(0.1, 2400) - 3.2).abs() < 0.05); // the number of the page
    let words = Hand::with("methods", &[]).words();
    let tripled = number_behind(&words, "tripled after");
    assert!(
        euler(0.1, (10.0 * tripled - 10.0) as u32) < 3.0 && euler(0.1, (10.0 * tripled + 10.0) as u32) > 3.0
    );
}

#[test]
fn rk4_calms_the_swing_as_its_factor_says() {
    for step in [1.5, 2.0, 2.5_f64] {
        let words = Hand::with("methods", &[("step", step)]).words();
        // eq:rk4-amplitude, with the rate of the wobble; the largest swing of the last half minute is at its beginning.
        let z = step * (1.1 * 0.6 / (1.6 * 2.1_f64)).sqrt();
        let factor = (1.0 - z.powi(6) / 72.0 + z.powi(8) / 576.0).powf(0.5 * 210.0 / step);
        let [truth, rk4] = ["out to", "truth, to"].map(|before| number_behind(&words, before));
        assert!((rk4 / (truth * factor) - 1.0).abs() < 0.06, "{step}: {words}, and {factor}");
    }
}

#[test]
fn what_turns_keeps_the_energy_at_any_step_and_the_closed_form_keeps_it_to_rounding() {
    for step in [0.05, 0.5, 2.0, 3.0] {
        let hand = Hand::with("methods", &[("step", step)]);
        for time in [0.0, 50.0, 133.3, 240.0] {
            assert!((hand.reading(time, "by Strang") - 1.0).abs() < 2e-3, "{step}");
            assert!((hand.reading(time, "energy") - 1.0).abs() < 1e-13, "{step}");
        }
    }
}

//! The phase Ωt after a long time: one rounding, and many.

use super::{ROUNDOFF, assert_level, assert_slope, machine, number, rows};
use mechanics::scenes::laundromat::Machine;
use nalgebra::Complex;

/// A time of 1 s is this many steps; a power of two, so that the step and `ΩΔt` are exact and only the additions round.
const STEPS_PER_SECOND: f64 = 128.0;

/// One row of the reference: machine, time, and the exact direction of the load.
fn phases() -> impl Iterator<Item = (Machine, f64, Complex<f64>)> {
    rows("phases").iter().map(|row| {
        let exact = Complex::new(number(&row["cos"]), number(&row["sin"]));
        (machine(0.3, number(&row["spin"])), number(&row["t"]), exact)
    })
}

#[test]
fn direction_of_the_load_is_exact_for_a_billion_seconds_and_one_rounding_of_the_phase_costs_a_digit_a_decade()
{
    let (mut errors, mut of_phase) = (Vec::new(), Vec::new());
    for (machine, t, exact) in phases() {
        assert!((machine.load_direction(t) - exact).norm() < 2.0 * ROUNDOFF, "t = {t:e}");
        let phase = machine.spin() * t;
        let error = (Complex::from_polar(1.0, phase) - exact).norm();
        assert!(error < ROUNDOFF * phase + 2.0 * ROUNDOFF, "t = {t:e}: {error:e}");
        if t > 50.0 {
            errors.push((t, error));
            of_phase.push((phase, error));
        }
    }
    assert_slope("one rounding", &errors, 1.0, 0.15);
    assert_level("one rounding", &of_phase, |phase| ROUNDOFF * phase, 0.15..0.8);
    let last = errors.iter().filter(|(t, _)| *t > 9e8).map(|(_, error)| *error).fold(0.0, f64::max);
    assert!(last > 1e-7, "after 1e9 s the naive phase should be off by 1e-7 and more, and is by {last:e}");
}

#[test]
fn phase_that_is_added_up_loses_two_digits_a_decade_and_a_compensated_sum_only_one() {
    let (mut errors, mut compensated_errors) = (Vec::new(), Vec::new());
    for (machine, t, exact) in phases().filter(|(_, t, _)| *t < 2e5) {
        let (step, count) = (machine.spin() / STEPS_PER_SECOND, (t * STEPS_PER_SECOND) as u64);
        let (mut plain, mut sum, mut lost) = (0.0, 0.0, 0.0);
        for _ in 0..count {
            plain += step;
            // Kahan's: what an addition has rounded away goes into the next one.
            let increment = step - lost;
            let next = sum + increment;
            lost = (next - sum) - increment;
            sum = next;
        }
        let error_of = |phase: f64| (Complex::from_polar(1.0, phase) - exact).norm();
        let phase = machine.spin() * t;
        let bound = 0.5 * ROUNDOFF * phase * count as f64; // Σ u φ_k
        let (error, compensated) = (error_of(plain), error_of(sum));
        assert!(error < bound, "t = {t:e}: {error:e}, bound {bound:e}");
        assert!(error > bound / 300.0, "t = {t:e}: {error:e}, bound {bound:e}");
        assert!(compensated < 2.0 * ROUNDOFF * phase + 2.0 * ROUNDOFF, "t = {t:e}: {compensated:e}");
        errors.push((t, error));
        if t > 50.0 {
            compensated_errors.push((t, compensated));
        }
    }
    assert_slope("added up", &errors, 2.0, 0.15);
    assert_slope("compensated", &compensated_errors, 1.0, 0.25);
}

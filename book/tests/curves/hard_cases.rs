//! The hard cases: every point that is drawn lies where the error analysis, written out here, or a
//! computation of its own says.

use crate::{curve, lies_on};
use mechanics::euler::{Turning, turning_rates};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::rk4;
use nalgebra::{UnitQuaternion, Vector3, Vector4};
use std::f64::consts::TAU;

const ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// A curve's corners as values.
fn values(figure: &str, name: &str) -> Vec<(f64, f64)> {
    let values = curve(figure, name).values();
    assert!(values.len() > 3, "{figure} {name} has {} points", values.len());
    values
}

/// Each point between two bounds, of which the lower may be nothing.
fn between(what: &str, values: &[(f64, f64)], bounds: impl Fn(f64) -> (f64, f64)) {
    for &(x, y) in values {
        let (low, high) = bounds(x);
        assert!(y > 0.99 * low && y < 1.01 * high, "{what}: {y:e} at {x:e}, from {low:e} to {high:e}");
    }
}

/// The middle one of all ratios of a curve to a law, within a range of x.
fn middle_ratio(values: &[(f64, f64)], from: f64, to: f64, law: impl Fn(f64) -> f64) -> f64 {
    let inside = values.iter().filter(|(x, _)| (from..to).contains(x));
    let mut ratios: Vec<f64> = inside.map(|&(x, y)| y / law(x)).collect();
    assert!(ratios.len() > 5);
    ratios.sort_by(f64::total_cmp);
    ratios[ratios.len() / 2]
}

#[test]
fn differences_lose_two_digits_a_decade_and_the_library_none() {
    // The largest error over u/ε²: of the sine; of a few numbers over (Γ/ω₀)² = 0.09; of the root; of the
    // parameter in a logarithm.
    for (name, most) in [("coin", 1.0), ("spin", 45.0), ("root", 1.0), ("period", 1.0)] {
        let naive = values("hard-cancellation", &format!("{name}-naive"));
        let law = |small: f64| ROUNDOFF / (small * small);
        between(name, &naive, |small| {
            (
                0.0,
                (most * law(small) + 4.0 * ROUNDOFF / small + 1e-15).min(1.0).max(most * law(small).min(1.0)),
            )
        });
        let middle = middle_ratio(&naive, 1e-7, 1e-2, law);
        assert!(middle > 0.01 * most && middle < 0.7 * most, "{name}: {middle}");
        let cured = values("hard-cancellation", &format!("{name}-cured"));
        between(name, &cured, |_| (0.0, 2e-15));
    }
}

#[test]
fn the_difference_of_exponentials_loses_half_a_digit_a_decade() {
    let law = |beyond: f64| ROUNDOFF / (8.0 * beyond).sqrt();
    let naive = values("hard-critical", "naive");
    between("critical", &naive, |beyond| (0.0, 4.0 * law(beyond) + 1e-15));
    assert!((0.05..1.5).contains(&middle_ratio(&naive, 1e-15, 1e-4, law)));
    between("critical, cured", &values("hard-critical", "cured"), |_| (0.0, 2e-15));
}

#[test]
fn the_phase_loses_one_digit_a_decade_by_a_product_and_two_by_a_sum() {
    let phase = |time: f64| 11.503_217 * time;
    let of = |name: &str| values("hard-phase", name);
    between("product", &of("product"), |time| (0.0, ROUNDOFF * phase(time) + 3e-16));
    assert!((0.1..0.8).contains(&middle_ratio(&of("product"), 1e3, 1e9, |time| ROUNDOFF * phase(time))));
    let sum = |time: f64| 64.0 * time * ROUNDOFF * phase(time);
    between("added", &of("added"), |time| (0.0, sum(time) + 3e-16));
    assert!((0.02..0.8).contains(&middle_ratio(&of("added"), 10.0, 1e6, sum)));
    between("parts", &of("parts"), |_| (0.0, 8e-16));
}

#[test]
fn the_wheel_costs_a_thousand_evaluations_a_decade_by_its_tilt() {
    let tilt = values("hard-almost-flat", "tilt");
    between("tilt", &tilt, |across| {
        let expected = 250.0 - 1020.0 * across.log10();
        (0.9 * expected, 1.1 * expected)
    });
    let lean = values("hard-almost-flat", "lean");
    let least = lean.iter().map(|point| point.0).fold(1.0, f64::min);
    assert!((1e-7..1e-5).contains(&least), "the lean gets lost at {least:e}");
    assert!(lean.iter().any(|point| point.1 > 2e4));
}

#[test]
fn length_energy_and_attitude_of_the_hoop_drift_period_by_period() {
    let of = |name: &str| values("hard-drift", name);
    let moments = PrincipalMoments::new(1.5, 0.5, 2.0).expect("moments");
    let omega_body = Vector3::new(3_f64.sqrt() / 6.0, -0.5, 0.0);
    let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
    let top = FreeTop::new(moments, start).expect("a top");
    let period = top.period().expect("a period");
    let energy = |omega: &Vector3<f64>| moments.kinetic_energy(omega) / moments.kinetic_energy(&omega_body);
    for periods in [1, 10, 100] {
        let time = f64::from(periods) * period;
        let free = turning_rates(moments, |_, _| Vector3::zeros());
        let found = rk4(free, 0.0, start.to_array(), time, 80 * periods as usize).expect("steps");
        let length = Vector4::from_row_slice(&found[..4]).norm();
        let body = Turning::from_array(found);
        let [a, b] = [body, top.at(time).expect("a state")].map(|state| state.world_from_body.into_inner());
        let errors = [
            ("length", 1.0 - length),
            ("energy", 1.0 - energy(&body.omega_body)),
            ("attitude", (a - b).norm().min((a + b).norm())),
        ];
        for (name, error) in errors {
            let pixels = curve("hard-drift", name).distance((f64::from(periods), error));
            assert!(pixels < 0.3, "{name} after {periods}: {pixels} px off {error:e}");
        }
    }
    let attitude = of("attitude");
    assert!(attitude.iter().any(|point| point.1 > 1.0) && attitude[0].1 < 1e-5);
    between("closed", &of("closed"), |_| (0.0, 2e-15));
}

#[test]
fn stepping_past_the_separatrix_loses_two_digits_a_decade() {
    let of = |name: &str| values("hard-separatrix", name);
    let law = |modulus: f64| ROUNDOFF / (modulus * modulus);
    for (name, floor) in [("dop853", 3e-11), ("rk4", 3e-10)] {
        between(name, &of(name), |modulus| (0.0, (100.0 * law(modulus) + floor).min(1.0)));
        let middle = middle_ratio(&of(name), 5e-8, 3e-4, law);
        assert!((0.3..100.0).contains(&middle), "{name}: {middle}");
    }
    between("closed", &of("closed"), |_| (0.0, 1.5e-14));
}

#[test]
fn steps_and_tolerances_help_down_to_rounding() {
    let rk4 = values("hard-rounding", "rk4");
    // One step multiplies x − iv by a polynomial of ih; in a turn its logarithm grows by n of its steps' errors.
    lies_on("hard-rounding", "rk4", |work| {
        if !(100.0..8e3).contains(&work) {
            return f64::NAN;
        }
        let n = work / 4.0;
        let h = TAU / n;
        let (re, im) = (1.0 - h * h / 2.0 + h.powi(4) / 24.0, h - h.powi(3) / 6.0);
        let (growth, turn) = (n * re.hypot(im).ln(), n * (im.atan2(re) - h));
        (growth.exp() * turn.cos() - 1.0).hypot(growth.exp() * turn.sin())
    });
    let fine: Vec<_> = rk4.iter().copied().filter(|(work, _)| *work > 1e5).collect();
    between("RK4, fine", &fine, |work| (1e-16, ROUNDOFF * work.sqrt() * 3.0));
    assert!(fine.iter().any(|point| point.1 > 5e-14));
    between("tolerance", &values("hard-rounding", "tolerance"), |tolerance| {
        let expected = 3.5 * tolerance;
        (0.25 * expected.min(1e-12), 2.0 * expected + 2e-11)
    });
}

#[test]
fn work_grows_with_the_damping() {
    for name in ["coarse", "fine"] {
        let curve = values("hard-stiff", name);
        let heavy: Vec<_> = curve.into_iter().filter(|(damping, _)| *damping > 20.0).collect();
        // Twelve evaluations a step of 6.4/Γ, for 100 s.
        between(name, &heavy, |damping| (0.88 * 187.5 * damping, 1.12 * 187.5 * damping));
    }
}

#[test]
fn towards_the_end_the_tilt_is_the_third_root_of_what_is_left() {
    let of = |name: &str| values("hard-end", name);
    // DOP853 has moved the end once and for all: 3.2e-11 over what is left, until that is all there is.
    let late: Vec<_> = of("dop853").into_iter().filter(|(left, _)| *left > 1e-9).collect();
    between("dop853", &late, |left| (0.75 * 3.2e-11 / left, 1.1 * 3.2e-11 / left));
    let rates = |_: f64, [tilt]: &[f64; 1]| [-1.0 / (3.0 * tilt * tilt)];
    for (left, drawn) in of("rk4").into_iter().filter(|(left, _)| (2e-4..3e-3).contains(left)) {
        let end = rk4(rates, 0.0, [1.0], 1.0 - left, 10_000).expect("steps");
        let exact = (end[0] / left.cbrt() - 1.0).abs();
        assert!((drawn / exact - 1.0).abs() < 0.1, "{left:e}: {drawn:e}, {exact:e}");
    }
    between("law", &of("law"), |_| (0.0, 2e-15));
}

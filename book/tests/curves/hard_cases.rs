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
fn the_cures_lose_no_digits() {
    for (figure, name, most) in [
        ("hard-cancellation", "coin-cured", 2e-15),
        ("hard-cancellation", "spin-cured", 2e-15),
        ("hard-cancellation", "root-cured", 2e-15),
        ("hard-cancellation", "period-cured", 2e-15),
        ("hard-critical", "cured", 2e-15),
        ("hard-phase", "parts", 8e-16),
        ("hard-drift", "closed", 2e-15),
        ("hard-separatrix", "closed", 1.5e-14),
        ("hard-end", "law", 2e-15),
    ] {
        between(name, &values(figure, name), |_| (0.0, most));
    }
}

/// A curve, what its points are below, a law, the range in which the middle ratio to that law is taken, and its bounds.
type Naive<'a> = (&'a str, &'a str, fn(f64) -> f64, fn(f64) -> f64, [f64; 2], [f64; 2]);

#[test]
fn the_naive_ways_lose_digits_by_their_laws() {
    fn square(small: f64) -> f64 {
        ROUNDOFF / (small * small)
    }
    fn lost(most: f64, small: f64) -> f64 {
        let law = most * square(small);
        (law + 4.0 * ROUNDOFF / small + 1e-15).min(1.0).max(most * square(small).min(1.0))
    }
    let root = |beyond: f64| ROUNDOFF / (8.0 * beyond).sqrt();
    let product = |time: f64| ROUNDOFF * 11.503_217 * time;
    let sum = |time: f64| 64.0 * time * ROUNDOFF * 11.503_217 * time;
    // Of the differences, the largest error over u/ε²: of the sine; of a few numbers over (Γ/ω₀)² = 0.09; of the root;
    // of the parameter in a logarithm. Of the phase, a product loses one digit a decade and a sum two.
    let cases: [Naive<'_>; 9] = [
        ("hard-cancellation", "coin-naive", |x| lost(1.0, x), square, [1e-7, 1e-2], [0.01, 0.7]),
        ("hard-cancellation", "spin-naive", |x| lost(45.0, x), square, [1e-7, 1e-2], [0.45, 31.5]),
        ("hard-cancellation", "root-naive", |x| lost(1.0, x), square, [1e-7, 1e-2], [0.01, 0.7]),
        ("hard-cancellation", "period-naive", |x| lost(1.0, x), square, [1e-7, 1e-2], [0.01, 0.7]),
        (
            "hard-critical",
            "naive",
            |x| 4.0 * ROUNDOFF / (8.0 * x).sqrt() + 1e-15,
            root,
            [1e-15, 1e-4],
            [0.05, 1.5],
        ),
        ("hard-phase", "product", |t| ROUNDOFF * 11.503_217 * t + 3e-16, product, [1e3, 1e9], [0.1, 0.8]),
        (
            "hard-phase",
            "added",
            |t| 64.0 * t * ROUNDOFF * 11.503_217 * t + 3e-16,
            sum,
            [10.0, 1e6],
            [0.02, 0.8],
        ),
        (
            "hard-separatrix",
            "dop853",
            |x| (100.0 * square(x) + 3e-11).min(1.0),
            square,
            [5e-8, 3e-4],
            [0.3, 100.0],
        ),
        (
            "hard-separatrix",
            "rk4",
            |x| (100.0 * square(x) + 3e-10).min(1.0),
            square,
            [5e-8, 3e-4],
            [0.3, 100.0],
        ),
    ];
    for (figure, name, most, law, [from, to], [low, high]) in cases {
        let found = values(figure, name);
        between(name, &found, |x| (0.0, most(x)));
        let middle = middle_ratio(&found, from, to, law);
        assert!(middle > low && middle < high, "{figure}, {name}: {middle}");
    }
}

#[test]
fn work_grows_with_what_is_small_or_stiff() {
    // A thousand evaluations a decade, by the tilt of the wheel.
    between("tilt", &values("hard-almost-flat", "tilt"), |across| {
        let expected = 250.0 - 1020.0 * across.log10();
        (0.9 * expected, 1.1 * expected)
    });
    let lean = values("hard-almost-flat", "lean");
    let least = lean.iter().map(|point| point.0).fold(1.0, f64::min);
    assert!((1e-7..1e-5).contains(&least), "the lean gets lost at {least:e}");
    assert!(lean.iter().any(|point| point.1 > 2e4));
    for name in ["coarse", "fine"] {
        let curve = values("hard-stiff", name);
        let heavy: Vec<_> = curve.into_iter().filter(|(damping, _)| *damping > 20.0).collect();
        // Twelve evaluations a step of 6.4/Γ, for 100 s.
        between(name, &heavy, |damping| (0.88 * 187.5 * damping, 1.12 * 187.5 * damping));
    }
}

#[test]
fn length_energy_and_attitude_of_the_hoop_drift_period_by_period() {
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
        for (name, error) in [
            ("length", 1.0 - length),
            ("energy", 1.0 - energy(&body.omega_body)),
            ("attitude", (a - b).norm().min((a + b).norm())),
        ] {
            let pixels = curve("hard-drift", name).distance((f64::from(periods), error));
            assert!(pixels < 0.3, "{name} after {periods}: {pixels} px off {error:e}");
        }
    }
    let attitude = values("hard-drift", "attitude");
    assert!(attitude.iter().any(|point| point.1 > 1.0) && attitude[0].1 < 1e-5);
}

#[test]
fn steps_and_tolerances_help_down_to_rounding() {
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
    let fine: Vec<_> = values("hard-rounding", "rk4").into_iter().filter(|(work, _)| *work > 1e5).collect();
    between("RK4, fine", &fine, |work| (1e-16, ROUNDOFF * work.sqrt() * 3.0));
    assert!(fine.iter().any(|point| point.1 > 5e-14));
    between("tolerance", &values("hard-rounding", "tolerance"), |tolerance| {
        let expected = 3.5 * tolerance;
        (0.25 * expected.min(1e-12), 2.0 * expected + 2e-11)
    });
}

#[test]
fn towards_the_end_the_tilt_is_the_third_root_of_what_is_left() {
    // DOP853 has moved the end once and for all: 3.2e-11 over what is left, until that is all there is.
    let late: Vec<_> = values("hard-end", "dop853").into_iter().filter(|(left, _)| *left > 1e-9).collect();
    between("dop853", &late, |left| (0.75 * 3.2e-11 / left, 1.1 * 3.2e-11 / left));
    let rates = |_: f64, [tilt]: &[f64; 1]| [-1.0 / (3.0 * tilt * tilt)];
    for (left, drawn) in values("hard-end", "rk4").into_iter().filter(|(left, _)| (2e-4..3e-3).contains(left))
    {
        let end = rk4(rates, 0.0, [1.0], 1.0 - left, 10_000).expect("steps");
        let exact = (end[0] / left.cbrt() - 1.0).abs();
        assert!((drawn / exact - 1.0).abs() < 0.1, "{left:e}: {drawn:e}, {exact:e}");
    }
}

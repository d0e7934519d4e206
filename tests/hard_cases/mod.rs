//! Hard cases: the naive program fails by as much as its cause predicts, and the library does not, over decades of the
//! hard parameter and against 35 digits that no code of this library took part in.
//!
//! Failures are bounded from below and from above: should one become smaller the lesson is no longer true, should one
//! become larger the cause is another.

mod cancellation;
mod drift;
mod ending;
mod phase;
mod resonance;
mod separatrix;
mod tolerance;
mod vanishing;

use mechanics::measure::observed_order;
use mechanics::rolling::{DiskParameters, MomentFactors};
use mechanics::scenes::laundromat::{Machine, MachineParameters};
use serde_json::Value;
use std::ops::Range;
use std::sync::OnceLock;

/// A few units in the last place, after a dozen operations.
const FEW_ULPS: f64 = 4e-15;

/// The unit roundoff: the largest relative error of one rounding.
const ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// A steel disc of 0.4 kg and 37.5 mm.
const TOY: DiskParameters =
    DiskParameters { mass: 0.4, radius: 0.0375, moments: MomentFactors::DISK, gravity: 9.81 };

/// The rows of one list of `data/hard-cases.json`.
fn rows(list: &str) -> &'static [Value] {
    let rows = data()[list].as_array().expect("a list");
    assert!(rows.len() >= 8, "{list} has {} rows", rows.len());
    rows
}

fn data() -> &'static Value {
    static DATA: OnceLock<Value> = OnceLock::new();
    DATA.get_or_init(|| serde_json::from_str(include_str!("../data/hard-cases.json")).expect("valid JSON"))
}

/// The double nearest to a number that is written out as a text.
fn number(value: &Value) -> f64 {
    value.as_str().expect("a text").parse().expect("a number")
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let list = value.as_array().expect("a list");
    assert_eq!(list.len(), N);
    std::array::from_fn(|n| number(&list[n]))
}

/// ω₀ = 1 rad/s, b = 1 m: one kilogram, all of it the load.
fn machine(damping: f64, spin: f64) -> Machine {
    Machine::new(MachineParameters {
        drum_mass: 0.0,
        load_mass: 1.0,
        load_radius: 1.0,
        stiffness: 1.0,
        damping,
        spin,
    })
    .expect("a valid machine")
}

fn relative(found: f64, exact: f64) -> f64 {
    (found / exact - 1.0).abs()
}

/// The exponent of the power law that pairs of parameter and error follow, and that it is as predicted.
fn assert_slope(name: &str, pairs: &[(f64, f64)], predicted: f64, within: f64) {
    let fit = observed_order(pairs, 0.0).unwrap_or_else(|| panic!("{name}: too few points in {pairs:?}"));
    println!("{name}: slope {:.3} from {} points, predicted {predicted}", fit.slope, fit.points);
    assert!((fit.slope - predicted).abs() < within, "{name}: slope {} in {pairs:?}", fit.slope);
}

/// That the errors are, in their geometric mean, such a part of what the law predicts: one lucky rounding says nothing.
fn assert_level(name: &str, pairs: &[(f64, f64)], law: impl Fn(f64) -> f64, part: Range<f64>) {
    assert!(pairs.len() >= 3, "{name}: too few points in {pairs:?}");
    let sum: f64 = pairs.iter().map(|(parameter, error)| (error / law(*parameter)).ln()).sum();
    let mean = (sum / pairs.len() as f64).exp();
    println!("{name}: {mean:.2e} of what is predicted");
    assert!(part.contains(&mean), "{name}: {mean:e} of what is predicted, in {pairs:?}");
}

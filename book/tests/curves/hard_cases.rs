//! The hard cases and the chapter on methods: curves go with the powers that the text claims. The numbers themselves are
//! judged in `tests/hard_cases`; what the library does instead is a band, which is not drawn if a value leaves it.

use crate::curve;
use figures::log_steps;

/// The power of x with which a curve goes from one x to another: the straight line through logarithms.
fn power(figure: &str, name: &str, from: f64, to: f64) -> f64 {
    let curve = curve(figure, name);
    let logs: Vec<(f64, f64)> = log_steps(from, to, 60).map(|x| (x.ln(), curve.value(x).ln())).collect();
    let sum = |of: &dyn Fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>();
    let count = logs.len() as f64;
    let (x, y) = (sum(&|log| log.0) / count, sum(&|log| log.1) / count);
    sum(&|log| (log.0 - x) * (log.1 - y)) / sum(&|log| (log.0 - x).powi(2))
}

#[test]
fn errors_and_work_go_with_the_powers_of_the_text() {
    let mut faults = Vec::new();
    for (figure, name, from, to, expected, slack) in [
        ("hard-separatrix", "dop853", 5e-8, 3e-4, -2.0, 0.3),
        ("hard-separatrix", "rk4", 5e-8, 3e-4, -2.0, 0.3),
        ("hard-drift", "length", 1.1, 9e3, 1.0, 0.1),
        ("hard-drift", "energy", 1.1, 9e3, 1.0, 0.1),
        ("hard-drift", "attitude", 100.0, 600.0, 2.0, 0.3),
        ("hard-stiff", "coarse", 20.0, 9e3, 1.0, 0.05),
        ("hard-stiff", "fine", 20.0, 9e3, 1.0, 0.05),
        ("hard-rounding", "rk4", 100.0, 8e3, -4.0, 0.1),
        ("hard-rounding", "tolerance", 1e-10, 9e-4, 1.0, 0.15),
        ("hard-end", "dop853", 1e-9, 1e-2, -1.0, 0.1),
        ("method-order", "rk4", 0.02, 0.3, 4.0, 0.2),
        ("method-order", "strang", 0.02, 0.3, 2.0, 0.1),
        ("method-long-run", "rk4-energy", 50.0, 9000.0, 1.0, 0.03),
        ("method-long-run", "dop853-energy", 50.0, 9000.0, 1.0, 0.03),
        ("method-long-run", "strang-energy", 50.0, 9000.0, 0.0, 0.03),
        ("method-long-run", "blanes-moan-energy", 50.0, 9000.0, 0.0, 0.03),
        ("method-long-run", "rk4-attitude", 60.0, 300.0, 2.0, 0.15),
        ("method-long-run", "dop853-attitude", 1800.0, 9000.0, 2.0, 0.15),
        ("method-long-run", "strang-attitude", 18.0, 90.0, 1.0, 0.15),
        ("method-long-run", "blanes-moan-attitude", 1800.0, 9000.0, 1.0, 0.15),
    ] {
        let found = power(figure, name, from, to);
        if (found - expected).abs() >= slack {
            faults.push(format!("{figure}, {name}: {found}, not {expected}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

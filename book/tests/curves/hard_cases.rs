//! The hard cases, and the chapters on methods and on other people's programs: curves go with the powers that the text
//! claims, and what the library does instead loses no digits. The numbers themselves are judged in `tests/hard_cases`.

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
        ("hard-cancellation", "coin-naive", 1e-7, 1e-2, -2.0, 0.15),
        ("hard-cancellation", "spin-naive", 1e-7, 1e-2, -2.0, 0.15),
        ("hard-cancellation", "root-naive", 1e-7, 1e-2, -2.0, 0.15),
        ("hard-cancellation", "period-naive", 1e-7, 1e-2, -2.0, 0.3),
        ("hard-critical", "naive", 2e-15, 1e-4, -0.5, 0.1),
        ("hard-phase", "product", 1e3, 9e8, 1.0, 0.15),
        ("hard-phase", "added", 10.0, 1e6, 2.0, 0.2),
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
        ("method-energy", "rk4", 50.0, 9000.0, 1.0, 0.03),
        ("method-energy", "dop853", 50.0, 9000.0, 1.0, 0.03),
        ("method-energy", "strang", 50.0, 9000.0, 0.0, 0.03),
        ("method-energy", "blanes-moan", 50.0, 9000.0, 0.0, 0.03),
        ("method-attitude", "rk4", 60.0, 300.0, 2.0, 0.15),
        ("method-attitude", "dop853", 1800.0, 9000.0, 2.0, 0.15),
        ("method-attitude", "strang", 18.0, 90.0, 1.0, 0.15),
        ("method-attitude", "blanes-moan", 1800.0, 9000.0, 1.0, 0.15),
        ("judged-coin", "exudyn", 2.6e-5, 9e-4, 2.0, 0.05),
    ] {
        let found = power(figure, name, from, to);
        if (found - expected).abs() >= slack {
            faults.push(format!("{figure}, {name}: {found}, not {expected}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
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
        ("judged-brick", "two-explained", 5e-8),
        ("judged-brick", "five-explained", 2e-13),
        ("judged-brick", "six-explained", 3e-7),
        ("judged-brick", "four-explained", 1e-10),
        ("judged-brick", "one-explained", 1.2e-10),
    ] {
        let values = curve(figure, name).values();
        let worst = values.iter().map(|value| value.1).fold(0.0, f64::max);
        assert!(values.len() > 3 && worst < 1.01 * most, "{figure}, {name}: {worst:e}");
    }
}

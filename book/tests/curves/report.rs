//! The figures of the report, held to the committed measurements, read here anew.

use crate::{curve, passes};

/// A run: problem, contestant, method; error and milliseconds.
type Run = ([&'static str; 3], (f64, f64));

/// What cannot be beaten of a contestant's method: its errors and costs.
type Unbeaten = ([&'static str; 3], Vec<(f64, f64)>);

/// All problems, in the order of the report.
const PROBLEMS: [&str; 10] =
    ["washer", "ramp", "hoop", "separatrix", "disk", "rest", "toss", "station", "drag", "top"];

fn runs() -> Vec<Run> {
    let lines = include_str!("../../speed-and-accuracy/measured.csv").lines();
    let rows = lines.filter(|line| !line.starts_with('#')).skip(1).map(|line| line.split(','));
    let number = |text: &str| text.parse::<f64>().unwrap_or(f64::NAN);
    rows.map(Iterator::collect::<Vec<_>>)
        .map(|row| ([row[0], row[1], row[2]], (number(row[4]), 1e3 * number(row[6]))))
        .filter(|(name, _)| name[1] != "mechanics native")
        .collect()
}

/// For each method in a problem, the runs that no other one of its own beats in error and in cost.
fn unbeaten(problem: &str) -> Vec<Unbeaten> {
    let runs: Vec<Run> = runs().into_iter().filter(|(name, _)| name[0] == problem).collect();
    let mut names: Vec<_> = runs.iter().map(|(name, _)| *name).collect();
    names.dedup();
    let of = |name: [&'static str; 3]| {
        let mine = runs.iter().filter(|(own, _)| *own == name);
        let pairs: Vec<(f64, f64)> = mine.map(|(_, values)| *values).collect();
        let beaten = |a: &(f64, f64)| pairs.iter().any(|b| b != a && b.0 <= a.0 && b.1 <= a.1);
        (name, pairs.iter().filter(|pair| !beaten(pair)).copied().collect())
    };
    names.into_iter().map(of).collect()
}

#[test]
fn every_measurement_that_is_not_beaten_lies_on_its_curve() {
    let mut checked = 0;
    for problem in PROBLEMS {
        let inside =
            |pairs: Vec<(f64, f64)>| pairs.into_iter().filter(|pair| pair.0 < 1.0).collect::<Vec<_>>();
        for (name, pairs) in unbeaten(problem) {
            let pairs = inside(pairs);
            if pairs.len() > 1 {
                let name = name.join(" ").replace([' ', '(', ')'], "-");
                checked += passes("speed-problems", &name, pairs);
            }
        }
    }
    assert!(checked > 250, "only {checked} measurements");
}

#[test]
fn the_dots_begin_at_the_best_of_the_library() {
    // Past the separatrix the library has one dot, and no line.
    let lines = PROBLEMS.into_iter().enumerate().filter(|(_, problem)| *problem != "separatrix");
    for (place, problem) in lines {
        let values = curve("speed-dots", &format!("{problem}-library")).values();
        let best = values.iter().map(|value| value.0).fold(f64::INFINITY, f64::min);
        assert!(best.ln().abs() < 0.01, "{problem}: {best}");
        let row = (PROBLEMS.len() - place) as f64 + 0.15;
        assert!(values.iter().all(|value| (value.1 - row).abs() < 0.02), "{problem}: {values:?}");
    }
}

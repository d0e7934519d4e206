//! The figures of the report, held to the committed measurements, read here anew.

use crate::{PIXELS, curve};

/// A run: problem, contestant, method, error, evaluations (NaN where they are not counted), seconds.
struct Run<'a> {
    name: [&'a str; 3],
    error: f64,
    evaluations: f64,
    milliseconds: f64,
}

/// All problems, in the order of the report.
const PROBLEMS: [&str; 9] =
    ["washer", "ramp", "hoop", "separatrix", "disk", "rest", "toss", "station", "drag"];

/// A name, and the errors and costs that its curve must pass.
type Curve<'a> = ([&'a str; 3], Vec<(f64, f64)>);

fn runs() -> Vec<Run<'static>> {
    let lines = include_str!("../../speed-and-accuracy/measured.csv").lines();
    let rows =
        lines.filter(|line| !line.starts_with('#')).skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    let number = |text: &str| text.parse::<f64>().unwrap_or(f64::NAN);
    rows.map(|row| Run {
        name: [row[0], row[1], row[2]],
        error: number(row[4]),
        evaluations: number(row[5]),
        milliseconds: 1e3 * number(row[6]),
    })
    .collect()
}

/// Those that no other one beats in both, found by comparing each with each.
fn unbeaten(pairs: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let beaten = |a: &(f64, f64)| pairs.iter().any(|b| b != a && b.0 <= a.0 && b.1 <= a.1);
    pairs.iter().filter(|pair| !beaten(pair)).copied().collect()
}

#[test]
fn every_measurement_that_is_not_beaten_lies_on_its_curve() {
    let runs = runs();
    let mut checked = 0;
    for problem in PROBLEMS {
        let here = || runs.iter().filter(|run| run.name[0] == problem && run.name[1] != "mechanics native");
        let mut names: Vec<[&str; 3]> = here().map(|run| run.name).collect();
        names.dedup();
        let curves: Vec<Curve<'_>> = names
            .into_iter()
            .map(|name| {
                let mine = here().filter(|run| run.name == name).map(|run| (run.error, run.milliseconds));
                let pairs = unbeaten(&mine.collect::<Vec<_>>());
                (name, pairs.into_iter().filter(|pair| pair.0 < 1.0).collect())
            })
            .collect();
        for ([_, contestant, method], pairs) in &curves {
            if pairs.len() < 2 {
                continue;
            }
            let name = format!("{problem} {contestant} {method}").replace([' ', '(', ')'], "-");
            let curve = curve("speed-problems", &name);
            for &pair in pairs {
                let off = curve.distance(pair);
                assert!(off < PIXELS, "{problem}, {name}: {off} px off at {pair:?}");
                checked += 1;
            }
        }
    }
    assert!(checked > 250, "only {checked} measurements");
}

#[test]
fn the_evaluations_lie_on_their_curves_with_the_slopes_of_their_orders() {
    let runs = runs();
    let mut checked = 0;
    for problem in PROBLEMS {
        for method in ["RK4", "DOP853"] {
            let mine = runs.iter().filter(|run| run.name == [problem, "mechanics", method]);
            let pairs = unbeaten(&mine.map(|run| (run.error, run.evaluations)).collect::<Vec<_>>());
            let inside: Vec<_> = pairs.into_iter().filter(|pair| pair.0 < 1.0).collect();
            if inside.len() < 2 {
                continue;
            }
            let curve = curve("speed-work", &format!("{problem}-{method}"));
            for &pair in &inside {
                assert!(curve.distance(pair) < PIXELS, "{problem}, {method}, {pair:?}");
                checked += 1;
            }
        }
    }
    assert!(checked > 110, "only {checked}");
}

/// The time to reach an error of a millionth, by a line through the logarithms of two settings that lie on both sides.
fn to_a_millionth(mut pairs: Vec<(f64, f64)>) -> Option<f64> {
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
    let fine = pairs.iter().position(|pair| pair.0 <= 1e-6)?;
    let (error, time) = pairs[fine];
    if fine == 0 {
        return Some(time);
    }
    let (coarse, before) = pairs[fine - 1];
    let slope = (time / before).ln() / (error / coarse).ln();
    Some((before.ln() + slope * (1e-6_f64 / coarse).ln()).exp())
}

#[test]
fn the_dots_reach_from_the_best_to_the_slowest() {
    let runs = runs();
    for (place, problem) in PROBLEMS.into_iter().enumerate() {
        let here = || runs.iter().filter(|run| run.name[0] == problem && run.name[1] != "mechanics native");
        let mut names: Vec<[&str; 3]> = here().map(|run| run.name).collect();
        names.dedup();
        let times = |ours: bool| -> Vec<f64> {
            let mine = names.iter().filter(|name| (name[1] == "mechanics") == ours);
            mine.filter_map(|name| {
                let pairs = here().filter(|run| run.name == *name).map(|run| (run.error, run.milliseconds));
                to_a_millionth(unbeaten(&pairs.collect::<Vec<_>>()))
            })
            .collect()
        };
        let best = times(true).into_iter().fold(f64::INFINITY, f64::min);
        for (whose, ours, rise) in [("library", true, 0.15), ("others", false, -0.15)] {
            let times = times(ours);
            if times.len() < 2 {
                assert_eq!(problem, "separatrix");
                continue;
            }
            let curve = curve("speed-dots", &format!("{problem}-{whose}"));
            let row = (PROBLEMS.len() - place) as f64 + rise;
            for time in &times {
                let off = curve.distance((time / best, row));
                assert!(off < PIXELS, "{problem}, {whose}: {off} px off at {}", time / best);
            }
            // And no further.
            let longest = curve.values().iter().map(|value| value.0).fold(0.0, f64::max);
            let slowest = times.iter().fold(0.0_f64, |most, &time| most.max(time)) / best;
            assert!((longest / slowest).ln().abs() < 0.01, "{problem}, {whose}: to {longest}, not {slowest}");
        }
    }
}

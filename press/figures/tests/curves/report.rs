//! The figures of the report, held to the committed measurements, read here anew.

use crate::{Frame, PIXELS, Range, distance, path};

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
    let lines = include_str!("../../../../book/speed-and-accuracy/measured.csv").lines();
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
        let all = || curves.iter().flat_map(|(_, pairs)| pairs);
        let least = all().map(|pair| pair.1).fold(f64::INFINITY, f64::min);
        let most = all().map(|pair| pair.1).fold(0.0, f64::max);
        let coarsest = all().map(|pair| pair.0).fold(0.0, f64::max);
        let power = |exponent: f64| 10.0_f64.powf(exponent);
        let sample = Frame {
            place: [62.0, 34.0, 440.0, 312.0],
            x: Range::Log(1e-16, power(coarsest.log10().ceil().clamp(-2.0, 0.0))),
            y: Range::Log(power((least.log10() - 0.2).floor()), power(most.log10().ceil())),
        };
        for ([_, contestant, method], pairs) in &curves {
            if pairs.len() < 2 {
                continue;
            }
            let name = format!("{contestant} {method}").replace([' ', '(', ')'], "-");
            let curve = path(&format!("speed-{problem}"), &name);
            for &pair in pairs {
                let off = distance(&curve, sample.at(pair));
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
    for (place, problem) in PROBLEMS.into_iter().enumerate() {
        let corner = [50.0 + 218.0 * (place % 3) as f64, 40.0 + 216.0 * (place / 3) as f64];
        let sample = Frame {
            place: [corner[0], corner[1], 176.0, 150.0],
            x: Range::Log(1e-12, 1.0),
            y: Range::Log(1e3, 1e8),
        };
        for method in ["RK4", "DOP853"] {
            let mine = runs.iter().filter(|run| run.name == [problem, "mechanics", method]);
            let pairs = unbeaten(&mine.map(|run| (run.error, run.evaluations)).collect::<Vec<_>>());
            let inside: Vec<_> = pairs.into_iter().filter(|pair| pair.0 < 1.0).collect();
            if inside.len() < 2 {
                continue;
            }
            let curve = path("speed-work", &format!("{problem}-{method}"));
            for &pair in &inside {
                assert!(distance(&curve, sample.at(pair)) < PIXELS, "{problem}, {method}, {pair:?}");
                checked += 1;
            }
        }
    }
    assert!(checked > 110, "only {checked}");
}

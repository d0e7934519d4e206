//! The data of the report "Speed and accuracy": what does not depend on the machine is computed again, and
//! the tables of the page are those of the measurements. Nothing here asserts on a time.

#[allow(dead_code, reason = "the tests measure without a runner")]
#[path = "../benches/speed/contest.rs"]
mod contest;
#[allow(dead_code, reason = "the writing is the bench's")]
#[path = "../benches/speed/long_run.rs"]
mod long_run;
#[allow(dead_code, reason = "the writing is the runner's")]
#[path = "../benches/speed/measured.rs"]
mod measured;
#[path = "../benches/speed/ours.rs"]
mod ours;
#[allow(dead_code, reason = "some of it is for the peers")]
#[path = "../benches/speed/problems.rs"]
mod problems;
#[path = "../benches/speed/tables.rs"]
mod tables;
#[path = "../benches/speed/work.rs"]
mod work;

use std::collections::BTreeMap;

const WORK: &str = include_str!("../book/speed-and-accuracy/work.csv");
const MEASURED: &str = include_str!("../book/speed-and-accuracy/measured.csv");
const LONG_RUN: &str = include_str!("../book/speed-and-accuracy/long-run.csv");
const LIMITS: &str = include_str!("../book/speed-and-accuracy/limits.csv");
const PAGE: &str = include_str!("../book/speed-and-accuracy/report.md");
const CHAPTER: &str = include_str!("../book/speed-and-accuracy/index.md");

/// Errors are repeated to this factor. On the kind of machine that wrote the data they are repeated exactly;
/// another library of sines, whose last bit differs here and there, changes an error far above rounding by
/// less than a tenth. (Tried by changing the last bit of all rates at random.)
const FACTOR: f64 = 1.1;

/// Whether this is the kind of machine that wrote the data: the same steps, to the last bit.
const SAME: bool = cfg!(all(target_arch = "x86_64", target_os = "linux", target_env = "gnu"));

/// By how much the evaluations of an adaptive method may differ on another kind of machine. Random last bits
/// change most counts not at all, some on the hoop by up to 2 in 100 and next to the separatrix, at
/// tolerances that are no use there, by 20 in 100.
fn slack(problem: &str, method: &str) -> f64 {
    match (SAME, method, problem) {
        (true, ..) | (false, "RK4", _) => 0.0,
        (false, _, "separatrix") => 0.3,
        (false, ..) => 0.03,
    }
}

/// Where an error is made of rounding, its size is chance: by [`FACTOR`], it may differ by this in addition.
/// The floors of the problems lie between 1e-16 and 1e-10; they grow with the number of steps, and near the
/// separatrix with the sensitivity of the motion.
fn floor(problem: &str) -> f64 {
    match problem {
        "separatrix" => 1e-1,
        "disk" => 1e-9,
        _ => 1e-10,
    }
}

#[test]
fn work_and_errors_are_those_of_the_committed_data() {
    let rows =
        work::rows(&ours::entries().expect("the library takes every problem")).expect("every method solves");
    let comments = |text: &str| text.lines().take_while(|line| line.starts_with('#')).count();
    let again = work::csv(&rows);
    assert_eq!(
        again.lines().take(comments(&again) + 1).collect::<Vec<_>>(),
        WORK.lines().take(comments(WORK) + 1).collect::<Vec<_>>(),
        "the head of work.csv"
    );
    let committed: Vec<&str> = WORK.lines().skip(comments(WORK) + 1).collect();
    assert_eq!(rows.len(), committed.len(), "write work.csv again: cargo bench --bench speed -- work FILE");
    for (row, line) in rows.iter().zip(committed) {
        let [problem, method, setting, error, evaluations] = line.split(',').collect::<Vec<_>>()[..] else {
            panic!("five columns expected in `{line}`");
        };
        assert_eq!((problem, method, setting), (&*row.problem, &*row.method, &*row.setting));
        let error: f64 = error.parse().expect("a number");
        assert!(row.error.is_finite() && error.is_finite(), "{row}");
        let (low, high) = (error / FACTOR - floor(problem), error * FACTOR + floor(problem));
        assert!(low <= row.error && row.error <= high, "{row} and not {error:e}");
        let count: Option<f64> = (!evaluations.is_empty()).then(|| evaluations.parse().expect("a count"));
        assert_eq!(row.evaluations.is_some(), count.is_some(), "{row}");
        if let (Some(found), Some(count)) = (row.evaluations, count) {
            assert!((found as f64 - count).abs() <= count * slack(problem, method), "{row} and not {count}");
        }
    }
}

#[test]
fn the_closed_forms_are_exact_and_the_steppers_converge() {
    let rows = work::rows(&ours::entries().unwrap()).unwrap();
    for row in rows.iter().filter(|row| row.method == "closed form") {
        assert!(row.error < 1e-13, "{row}");
    }
    // The rates, and with them the steppers, share no code with the references: the best of each is near rounding.
    for problem in problems::NAMES {
        let best = rows
            .iter()
            .filter(|row| row.problem == problem)
            .map(|row| row.error)
            .fold(f64::INFINITY, f64::min);
        assert!(best < 1e-9, "{problem}: {best:e}");
        let stepped = rows.iter().filter(|row| row.problem == problem && row.method == "DOP853");
        let least = stepped.map(|row| row.error).fold(f64::INFINITY, f64::min);
        assert!(least < if problem == "separatrix" { 1e-1 } else { 1e-7 }, "{problem}: {least:e}");
    }
}

#[test]
fn the_free_bodies_are_the_same_in_a_list_and_one_by_one() {
    let rows = work::rows(&ours::closed_forms().unwrap()).unwrap();
    assert_eq!(rows.len(), 8);
    for row in &rows {
        assert!(row.error < 4e-15, "{row}");
    }
}

#[test]
fn an_error_that_is_put_in_is_found() {
    let washer = problems::washer();
    let solver = mechanics::integrate::Dop853::new(1e-13).unwrap();
    let (mut samples, _) = solver.sample(problems::washer_rates, 0.0, washer.start, &washer.times).unwrap();
    assert!(washer.error(&samples) < 1e-9);
    samples[200][3] += 1e-3;
    assert!((washer.error(&samples) - 1e-3).abs() < 1e-9);
    assert!(washer.error(&samples[1..]).is_nan());
    samples[200][3] = f64::NAN;
    assert!(washer.error(&samples).is_nan());

    let toss = problems::toss();
    let (mut samples, _) = solver.sample(problems::flat_rates, 0.0, toss.start, &toss.times).unwrap();
    let before = toss.error(&samples);
    // A rotation by 0.02 rad about an axis of the body, a quaternion of another length and sign, and nothing else.
    for sample in &mut samples {
        let [w1, w2, w3, q0, q1, q2, q3] = *sample;
        let (sin, cos) = 0.01_f64.sin_cos();
        let turned = [q0 * cos - q2 * sin, q1 * cos - q3 * sin, q2 * cos + q0 * sin, q3 * cos + q1 * sin];
        let [a, b, c, d] = turned.map(|part| -1.7 * part);
        *sample = [w1, w2, w3, a, b, c, d];
    }
    assert!(before < 1e-8 && (toss.error(&samples) - 0.02).abs() < 1e-8, "{}", toss.error(&samples));
    samples[1000][1] += 0.5;
    assert!((toss.error(&samples) - 0.5).abs() < 1e-8);
}

#[test]
fn every_problem_has_every_kind_of_contestant() {
    let rows = measured::parse(MEASURED).unwrap();
    let mut methods: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for row in &rows {
        assert!(
            row.seconds > 0.0 && row.quartiles[0] <= row.seconds && row.seconds <= row.quartiles[1],
            "{row:?}"
        );
        methods.entry(&row.problem).or_default().push(&row.contestant);
    }
    assert_eq!(methods.len(), problems::NAMES.len());
    let everywhere = [
        "mechanics",
        measured::NATIVE,
        "ivp",
        "differential-equations",
        "ode_solvers",
        "diffsol",
        "heyoka",
        "scipy",
    ];
    for (problem, found) in &methods {
        for name in everywhere {
            assert!(found.contains(&name), "{name} is missing on {problem}");
        }
    }
    assert!(["rapier3d-f64", "mujoco"].iter().all(|engine| methods["hoop"].contains(engine)));
    // What is measured is what is computed: the same methods and settings, the same work.
    let work: Vec<&str> = WORK.lines().filter(|line| !line.starts_with('#')).skip(1).collect();
    for contestant in ["mechanics", measured::NATIVE] {
        let mine: Vec<_> = rows.iter().filter(|row| row.contestant == contestant).collect();
        assert_eq!(mine.len(), work.len(), "measure again: cargo book measure");
        for (row, line) in mine.iter().zip(&work) {
            let evaluations = row.evaluations.map_or_else(String::new, |count| count.to_string());
            let head = format!("{},{},{},", row.problem, row.method, row.setting);
            assert!(
                line.starts_with(&head) && line.ends_with(&format!(",{evaluations}")),
                "{line} and {row:?}"
            );
        }
    }
}

#[test]
fn the_tables_of_the_page_are_those_of_the_data() {
    let rows = measured::parse(MEASURED).unwrap();
    for problem in problems::NAMES {
        let table = measured::table(&rows, problem);
        assert!(table.lines().count() > 8);
        assert!(PAGE.contains(&table), "the page has another table than:\n{table}");
    }
    for table in
        [measured::ahead(&rows, &problems::NAMES), tables::long_run(LONG_RUN), tables::limits(LIMITS)]
    {
        assert!(table.lines().count() > 8);
        assert!(PAGE.contains(&table), "the page has another table than:\n{table}");
    }
    // The chapter has some rows of the long run.
    let long_run = tables::long_run(LONG_RUN);
    let mut shown = CHAPTER.lines().skip_while(|line| !line.starts_with("| after a million periods"));
    assert_eq!(shown.next(), long_run.lines().next());
    let shown: Vec<&str> = shown.skip(1).take_while(|line| line.starts_with('|')).collect();
    assert_eq!(shown.len(), 6);
    for row in shown {
        assert!(long_run.lines().any(|line| line == row), "the data has no row {row}");
    }
    let sentence = measured::factors(&rows, &problems::NAMES);
    assert!(PAGE.contains(&sentence), "the page should say: {sentence}");
}

#[test]
fn the_beginning_of_the_long_run_is_that_of_the_committed_data() {
    let rows = long_run::rows(&long_run::PERIODS[..2]).unwrap();
    assert_eq!(rows.len(), 9 * 2);
    for row in &rows {
        let head = format!("{},{},{},", row.method, row.setting, row.periods);
        let line = LONG_RUN.lines().find(|line| line.starts_with(&head)).expect("the data has a line for it");
        let [work, length, energy, attitude]: [f64; 4] =
            std::array::from_fn(|n| line[head.len()..].split(',').nth(n).unwrap().parse().unwrap());
        if SAME {
            assert_eq!(row.work as f64, work, "{row}");
        }
        // To the digits that are written, and to what rounding leaves after ten thousand periods.
        for (found, committed) in [(row.length, length), (row.energy, energy), (row.attitude, attitude)] {
            let near = 0.01 * committed.abs() + 1e-11;
            assert!((found - committed).abs() < near, "{row}: {found:e} and not {committed:e}");
        }
    }
    // Each method loses what the page says: in proportion to the time, the attitude as its square, the
    // splitting's in proportion.
    let grows = |method: &str, setting: &str, quantity: fn(&long_run::Row) -> f64| {
        let mine: Vec<_> = rows.iter().filter(|row| row.method == method && row.setting == setting).collect();
        (quantity(mine[1]) / quantity(mine[0])).abs().log10()
    };
    let fine = ("DOP853", "tolerance 1e-12");
    assert!((grows(fine.0, fine.1, |row| row.length) - 1.0).abs() < 0.05);
    assert!((grows(fine.0, fine.1, |row| row.energy) - 1.0).abs() < 0.05);
    assert!((grows(fine.0, fine.1, |row| row.attitude) - 2.0).abs() < 0.05);
    assert!((grows("Blanes–Moan", "40 steps a period", |row| row.attitude) - 1.0).abs() < 0.05);
}

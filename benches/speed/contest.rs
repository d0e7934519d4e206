//! What a contestant is, how it is timed, and the lines in which it speaks with the runner.
//!
//! A contestant is a program. To the line `list` it answers with a line for each `version`, each `note` (what
//! it cannot do) and each `entry` (problem, contestant, method, setting), with tabs between the fields, then
//! `end`. To `run I` it solves entry `I` again and again for the time of a slice and answers
//! `error evaluations seconds`, the evaluations being `-` where they are not counted, or `failed` and why.

use crate::problems::Problem;
use std::error::Error;
use std::hint::black_box;
use std::io::{self, BufRead, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;
use std::time::{Duration, Instant};

/// Why a problem could not be solved.
pub(crate) type Cause = Box<dyn Error>;

/// How long an entry is repeated in one round.
pub(crate) const SLICE: Duration = Duration::from_millis(4);

/// What one round gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Measured {
    /// The error, as the problem defines it.
    pub error: f64,
    /// Evaluations of the rates in one run, if they are counted.
    pub evaluations: Option<usize>,
    /// The time of one run, s, wall clock.
    pub seconds: f64,
}

/// One way to solve one problem.
pub(crate) struct Entry {
    /// The name of the problem.
    pub problem: &'static str,
    /// Whose code it is.
    pub contestant: &'static str,
    /// The method.
    pub method: &'static str,
    /// Its tolerance, step or the like.
    pub setting: String,
    measure: Box<dyn Fn(Duration) -> Result<Measured, Cause>>,
}

impl Entry {
    /// An entry that fills a list of samples of any kind `F` and returns its evaluations. What brings a
    /// sample into the problem's form is not timed.
    pub(crate) fn new<const N: usize, F: 'static>(
        problem: &Rc<Problem<N>>,
        [contestant, method]: [&'static str; 2],
        setting: String,
        solve: impl Fn(&Problem<N>, &mut Vec<F>) -> Result<Option<usize>, Cause> + 'static,
        state: impl Fn(&F) -> [f64; N] + 'static,
    ) -> Self {
        let name = problem.name;
        let problem = Rc::clone(problem);
        let measure = move |slice: Duration| -> Result<Measured, Cause> {
            let mut samples = Vec::new();
            let (mut runs, mut evaluations) = (0_u32, None);
            let began = Instant::now();
            while runs == 0 || began.elapsed() < slice {
                evaluations = solve(black_box(&problem), &mut samples)?;
                black_box(&samples);
                runs += 1;
            }
            let seconds = began.elapsed().as_secs_f64() / f64::from(runs);
            let states: Vec<[f64; N]> = samples.iter().map(&state).collect();
            Ok(Measured { error: problem.error(&states), evaluations, seconds })
        };
        Self { problem: name, contestant, method, setting, measure: Box::new(measure) }
    }

    /// Solves the problem for as long as `slice`, at least once.
    ///
    /// # Errors
    /// Whatever the solver says.
    pub(crate) fn measure(&self, slice: Duration) -> Result<Measured, Cause> {
        (self.measure)(slice)
    }
}

/// Something that a contestant cannot do.
#[derive(Debug, Clone)]
pub(crate) struct Note {
    /// The problem.
    pub problem: &'static str,
    /// Whose code it is.
    pub contestant: &'static str,
    /// What it cannot do, and why.
    pub text: &'static str,
}

/// Speaks with the runner until it closes standard input.
///
/// # Errors
/// If the runner cannot be heard or answered.
pub(crate) fn serve(entries: &[Entry], notes: &[Note], versions: &[(&str, &str)]) -> io::Result<()> {
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let line = line?;
        if line == "list" {
            for (name, version) in versions {
                writeln!(out, "version\t{name}\t{version}")?;
            }
            for note in notes {
                writeln!(out, "note\t{}\t{}\t{}", note.problem, note.contestant, note.text)?;
            }
            for Entry { problem, contestant, method, setting, .. } in entries {
                writeln!(out, "entry\t{problem}\t{contestant}\t{method}\t{setting}")?;
            }
            writeln!(out, "end")?;
        } else {
            let entry = line
                .strip_prefix("run ")
                .and_then(|text| text.parse().ok())
                .and_then(|i: usize| entries.get(i));
            let answer = match entry {
                Some(entry) => answer(entry),
                None => format!("failed\tno such line: {line}"),
            };
            writeln!(out, "{answer}")?;
        }
        out.flush()?;
    }
    Ok(())
}

fn answer(entry: &Entry) -> String {
    // A peer may panic; the contest goes on.
    match catch_unwind(AssertUnwindSafe(|| entry.measure(SLICE))) {
        Ok(Ok(Measured { error, evaluations, seconds })) => {
            let evaluations = evaluations.map_or_else(|| "-".to_owned(), |count| count.to_string());
            format!("{error:e}\t{evaluations}\t{seconds:e}")
        }
        Ok(Err(cause)) => format!("failed\t{}", cause.to_string().replace(['\n', '\t'], " ")),
        Err(_) => "failed\tit panicked".to_owned(),
    }
}

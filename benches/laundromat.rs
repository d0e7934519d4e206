//! Error against time for the laundromat: the closed form, DOP853 and RK4 on two hundred turns of a lightly damped machine.
//!
//! The problem: ω₀ = b = 1, Γ = 0.01, Ω = 3, from rest, a frame at the end of each turn. The error is the largest over all frames and
//! components against the reference of `tests/data`; the time is for the whole run with all its frames written. Every method is run in
//! every round, in turn, so that what disturbs the machine disturbs all of them; the median over the rounds is reported.
//!
//! `cargo bench --bench laundromat` prints a table; `-- --write FILE` also writes it as CSV with a description of the machine.

use mechanics::integrate::{Dop853, rk4};
use mechanics::measure::{Counter, max_error};
use mechanics::scenes::laundromat::{Machine, Parameters, Shaft, Transient};
use serde_json::Value;
use std::error::Error;
use std::fmt::Write as _;
use std::hint::black_box;
use std::process::Command;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// How many rounds the median is taken over.
const ROUNDS: usize = 31;

/// A method is repeated within a round until this much time has passed.
const SLICE: Duration = Duration::from_millis(4);

/// Frames and, for one run, evaluations of the rates.
type Run = Result<(Vec<[f64; 4]>, usize), Box<dyn Error>>;

/// A way to compute the frames.
#[derive(Clone, Copy)]
enum Method {
    Closed,
    Dop853 { tolerance: f64 },
    Rk4 { steps_per_turn: usize },
}

struct Problem {
    machine: Machine,
    times: Vec<f64>,
    reference: Vec<[f64; 4]>,
}

/// What was measured of one method.
struct Row {
    method: Method,
    error: f64,
    evaluations: usize,
    seconds: Vec<f64>,
}

impl Problem {
    fn new() -> Result<Self, Box<dyn Error>> {
        let machine = Machine::new(Parameters {
            drum_mass: 0.0,
            load_mass: 1.0,
            load_radius: 1.0,
            stiffness: 1.0,
            damping: 0.01,
            spin: 3.0,
        })?;
        let file: Value = serde_json::from_str(include_str!("../tests/data/two-hundred-turns.json"))?;
        let dt = file["dt"].as_f64().ok_or("no dt")?;
        let rows = file["grid_hi"].as_array().ok_or("no states")?;
        let reference =
            rows.iter().map(|row| std::array::from_fn(|i| row[i].as_f64().unwrap_or(f64::NAN))).collect();
        Ok(Self { machine, times: (0..rows.len()).map(|i| i as f64 * dt).collect(), reference })
    }

    fn run(&self, method: Method) -> Run {
        let machine = self.machine;
        let rates = |t: f64, y: &[f64; 4]| machine.cartesian_rates(t, y);
        match method {
            Method::Closed => {
                let motion = machine.transient(Shaft::AT_REST)?;
                let frames: Result<Vec<_>, _> =
                    self.times.iter().map(|&t| motion.at(t).map(|s| s.to_array())).collect();
                Ok((frames?, 0))
            }
            Method::Dop853 { tolerance } => {
                let (frames, work) = Dop853::new(tolerance)?.sample(rates, 0.0, [0.0; 4], &self.times)?;
                Ok((frames, work.evaluations))
            }
            Method::Rk4 { steps_per_turn } => {
                let counter = Counter::new();
                let mut state = [0.0; 4];
                let mut frames = vec![state];
                for turn in self.times.windows(2) {
                    state = rk4(counter.count(rates), turn[0], state, turn[1], steps_per_turn)?;
                    frames.push(state);
                }
                Ok((frames, counter.evaluations()))
            }
        }
    }

    /// Seconds for one run, from as many runs as fit the slice. What is timed writes frames and counts nothing.
    fn time(&self, method: Method, frames: &mut [Shaft]) -> Result<f64, Box<dyn Error>> {
        let machine = black_box(self.machine);
        let rates = |t: f64, y: &[f64; 4]| machine.cartesian_rates(t, y);
        let began = Instant::now();
        let mut runs = 0_u32;
        while runs == 0 || began.elapsed() < SLICE {
            match method {
                Method::Closed => {
                    let motion: Transient = machine.transient(black_box(Shaft::AT_REST))?;
                    motion.fill(black_box(&self.times), frames)?;
                    black_box(&frames);
                }
                Method::Dop853 { tolerance } => {
                    black_box(Dop853::new(tolerance)?.sample(
                        rates,
                        0.0,
                        black_box([0.0; 4]),
                        &self.times,
                    )?);
                }
                Method::Rk4 { steps_per_turn } => {
                    let mut state = black_box([0.0; 4]);
                    for (turn, frame) in self.times.windows(2).zip(frames.iter_mut().skip(1)) {
                        state = rk4(rates, turn[0], state, turn[1], steps_per_turn)?;
                        *frame = Shaft::from_array(state);
                    }
                    black_box(&frames);
                }
            }
            runs += 1;
        }
        Ok(began.elapsed().as_secs_f64() / f64::from(runs))
    }
}

impl Method {
    fn name(self) -> &'static str {
        match self {
            Self::Closed => "closed form",
            Self::Dop853 { .. } => "DOP853",
            Self::Rk4 { .. } => "RK4",
        }
    }

    fn setting(self) -> String {
        match self {
            Self::Closed => String::new(),
            Self::Dop853 { tolerance } => format!("tolerance {tolerance:e}"),
            Self::Rk4 { steps_per_turn } => format!("{steps_per_turn} steps a turn"),
        }
    }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// What a program says when asked for its version, or that it says nothing.
fn version(program: &str, argument: &str) -> String {
    Command::new(program)
        .arg(argument)
        .output()
        .ok()
        .and_then(|out| String::from_utf8(out.stdout).ok())
        .map_or_else(|| "unknown".into(), |text| text.trim().to_owned())
}

fn processor() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    info.lines()
        .find(|line| line.starts_with("model name"))
        .and_then(|line| line.split_once(':'))
        .map_or_else(|| std::env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned())
}

/// Today's date in the calendar of ISO 8601, universal time, by counting years and months.
fn today() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let mut days = seconds / 86_400;
    let leap = |year: u64| (year.is_multiple_of(4) && !year.is_multiple_of(100)) || year.is_multiple_of(400);
    let mut year = 1970;
    while days >= 365 + u64::from(leap(year)) {
        days -= 365 + u64::from(leap(year));
        year += 1;
    }
    let lengths = [31, 28 + u64::from(leap(year)), 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let mut month = 1;
    for length in lengths {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    format!("{year}-{month:02}-{:02}", days + 1)
}

fn csv(rows: &mut [Row]) -> String {
    let flags = std::env::var("RUSTFLAGS").unwrap_or_else(|_| "none".into());
    let cores = std::thread::available_parallelism().map_or(0, std::num::NonZero::get);
    let mut text = String::new();
    let mut line = |text_line: String| {
        text.push_str(&text_line);
        text.push('\n');
    };
    line("# Two hundred turns of a lightly damped washing machine, a frame each: error against time.".into());
    line("# omega_0 = b = 1, Gamma = 0.01, Omega = 3, from rest; error: largest over frames and components, absolute.".into());
    line(format!(
        "# seconds: wall clock for one run, median of {ROUNDS} interleaved rounds; evaluations of the rates are exact."
    ));
    line(format!("# processor: {}, {cores} cores seen, {}", processor(), std::env::consts::OS));
    line(format!("# compiler: {}; profile bench, RUSTFLAGS {flags}", version("rustc", "--version")));
    line(format!("# mechanics {}; {}", env!("CARGO_PKG_VERSION"), today()));
    line("# written by: cargo bench --bench laundromat -- --write book/laundromat/speed.csv".into());
    line("method,setting,error,seconds,evaluations".into());
    for row in rows {
        let seconds = median(&mut row.seconds);
        let (name, setting) = (row.method.name(), row.method.setting());
        line(format!("{name},{setting},{:.3e},{seconds:.3e},{}", row.error, row.evaluations));
    }
    text
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut file = None;
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--write" => file = Some(arguments.next().ok_or("--write needs the name of a file")?),
            "--bench" => {}
            other => {
                return Err(format!("unknown argument {other}; there is only --write FILE").into());
            }
        }
    }

    let problem = Problem::new()?;
    let mut methods = vec![Method::Closed];
    methods.extend((3..=14).map(|n| Method::Dop853 { tolerance: 10.0_f64.powi(-n) }));
    methods.extend(
        [25, 50, 100, 200, 400, 800, 1600, 3200].map(|steps_per_turn| Method::Rk4 { steps_per_turn }),
    );
    let mut rows = Vec::new();
    for method in methods {
        let (frames, evaluations) = problem.run(method)?;
        rows.push(Row {
            method,
            error: max_error(&frames, &problem.reference),
            evaluations,
            seconds: Vec::new(),
        });
    }
    let mut frames = vec![Shaft::AT_REST; problem.times.len()];
    for _ in 0..ROUNDS {
        for row in &mut rows {
            row.seconds.push(problem.time(row.method, &mut frames)?);
        }
    }

    let mut table = String::new();
    for row in &mut rows {
        let milliseconds = 1e3 * median(&mut row.seconds);
        let (name, setting) = (row.method.name(), row.method.setting());
        writeln!(
            table,
            "{name:<12} {setting:<22} {:>10.2e} {milliseconds:>12.5} ms {:>9}",
            row.error, row.evaluations
        )?;
    }
    println!("{:<12} {:<22} {:>10} {:>15} {:>9}", "method", "setting", "error", "time", "rates");
    print!("{table}");
    if let Some(file) = file {
        std::fs::write(&file, csv(&mut rows))?;
        println!("written to {file}");
    }
    Ok(())
}

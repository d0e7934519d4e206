//! The machine, the compiler and the versions: the head of the data.

use crate::measured::COLUMNS;
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

/// What the library is compiled with as the second contestant.
pub const NATIVE_FLAGS: &str = "-C target-cpu=native";

/// The lock file, for the versions of the Rust peers.
const LOCK: &str = include_str!("../Cargo.lock");
const PEERS: [&str; 5] = ["diffsol", "differential-equations", "ivp", "ode_solvers", "rapier3d-f64"];

/// The lines before the data, with the names of the columns.
pub fn describe(rounds: usize, versions: &[String], notes: &[String]) -> String {
    let peers: Vec<String> = PEERS.iter().map(|name| format!("{name} {}", locked(name))).collect();
    let mut lines = vec![
        "Error against time of the library and its peers on the problems of the report.".to_owned(),
        format!(
            "seconds: wall clock of one run with all its samples, median and quartiles of {rounds} interleaved rounds; 3 for what takes over 0.2 s"
        ),
        machine(),
        format!(
            "compiler: {}; profile bench; default flags, and {NATIVE_FLAGS} for `mechanics native`",
            version("rustc")
        ),
        format!("{}; {}; {}", versions.join(", "), peers.join(", "), today()),
        "written by: cargo book measure".to_owned(),
    ];
    lines.extend(notes.iter().map(|note| format!("note: {note}")));
    let mut text: String = lines.iter().map(|line| format!("# {line}\n")).collect();
    text.push_str(COLUMNS);
    text.push('\n');
    text
}

/// The lines before the data of the race of closed forms.
pub fn closed_forms(rounds: usize, versions: &[String], notes: &[String]) -> String {
    let mut lines = vec![
        "Two closed forms of a free body, the library's and Principia's, on the free bodies of the report: 1001 samples of angular velocity and attitude.".to_owned(),
        format!("seconds: wall clock of one run with all its samples, median and quartiles of {rounds} interleaved rounds"),
        machine(),
        format!(
            "compilers: {}, profile bench, default flags, and {NATIVE_FLAGS} for `mechanics native`; clang -O3 with the flags of Principia's platforms x64 and, for `principia native`, x64_AVX_FMA",
            version("rustc")
        ),
        format!("{}; {}", versions.join(", "), today()),
        "written by: cargo book measure --principia FOLDER".to_owned(),
    ];
    lines.extend(notes.iter().map(|note| format!("note: {note}")));
    let mut text: String = lines.iter().map(|line| format!("# {line}\n")).collect();
    text.push_str(COLUMNS);
    text.push('\n');
    text
}

fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(0, std::num::NonZero::get);
    format!("processor: {}, {cores} cores seen, {}", processor(), std::env::consts::OS)
}

/// The lines before the data of the limits.
pub fn head_of_limits() -> String {
    let lines = [
        "What a sample costs in long lists, what the functions in it cost one by one, and a sweep. Nanoseconds, wall clock, median.".to_owned(),
        machine(),
        format!("compiler: {}; profile bench, default flags; {}", version("rustc"), today()),
        "written by: cargo book measure".to_owned(),
    ];
    lines.iter().map(|line| format!("# {line}\n")).collect()
}

/// The version of a crate in the lock file.
fn locked(name: &str) -> &'static str {
    let head = format!("name = \"{name}\"\nversion = \"");
    LOCK.find(&head).and_then(|at| LOCK[at + head.len()..].split('"').next()).unwrap_or("of unknown version")
}

/// What a program says when asked for its version, or that it says nothing.
fn version(program: &str) -> String {
    Command::new(program)
        .arg("--version")
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

//! What is wrong with a page, and where.

use anyhow::Error;
use std::fmt;

/// One fault, at a line of a file.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fault {
    /// The file, relative to the project's root, with forward slashes.
    pub file: String,
    /// The line, counted from one; zero for a fault of the whole file.
    pub line: usize,
    /// What is wrong, and where possible what would be right.
    pub message: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            0 => write!(out, "error: {}: {}", self.file, self.message),
            line => write!(out, "error: {}:{line}: {}", self.file, self.message),
        }
    }
}

/// The faults of a run, in the order of files and lines.
#[derive(Debug, Clone, Default)]
pub struct Faults {
    list: Vec<Fault>,
}

impl Faults {
    /// Adds a fault.
    pub fn add(&mut self, file: &str, line: usize, message: impl Into<String>) {
        self.list.push(Fault { file: file.to_owned(), line, message: message.into() });
    }

    /// Adds the faults of another list.
    pub fn append(&mut self, mut other: Self) {
        self.list.append(&mut other.list);
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The faults, sorted, each once.
    pub fn sorted(mut self) -> Vec<Fault> {
        self.list.sort();
        self.list.dedup();
        self.list
    }
}

impl fmt::Display for Faults {
    /// All faults, a line each, and their number.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let faults = self.clone().sorted();
        for fault in &faults {
            writeln!(out, "{fault}")?;
        }
        write!(out, "{} fault{}", faults.len(), if faults.len() == 1 { "" } else { "s" })
    }
}

impl std::error::Error for Faults {}

/// What is printed of an error, with its causes.
pub(crate) fn said(error: &Error) -> String {
    format!("error: {}", format!("{error:#}").trim_start_matches("error: "))
}

/// Where the lines of a text begin, so that the line of a place is found without counting through the text again.
#[derive(Debug, Clone)]
pub(crate) struct Lines {
    starts: Vec<usize>,
}

impl Lines {
    pub(crate) fn of(text: &str) -> Self {
        Self { starts: std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect() }
    }

    /// The number of the line that holds byte `offset`, counted from one.
    pub(crate) fn at(&self, offset: usize) -> usize {
        self.starts.partition_point(|&start| start <= offset)
    }
}

/// Reports the faults of one file by their places in its text.
#[derive(Debug)]
pub(crate) struct Reporter<'a> {
    pub(crate) file: &'a str,
    pub(crate) lines: &'a Lines,
    pub(crate) faults: &'a mut Faults,
}

impl Reporter<'_> {
    pub(crate) fn fault(&mut self, offset: usize, message: impl Into<String>) {
        self.faults.add(self.file, self.lines.at(offset), message);
    }
}

/// The candidate most like `name`, if any is like it: a hint for a misspelt label.
pub(crate) fn nearest<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    candidates
        .map(|candidate| (strsim::levenshtein(name, candidate), candidate))
        .filter(|(distance, candidate)| *distance <= candidate.len().max(name.len()) / 3)
        .min()
        .map(|(_, candidate)| candidate)
}

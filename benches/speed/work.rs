//! What does not depend on the machine: errors and evaluations.

use crate::contest::{Cause, Entry};
use std::fmt;
use std::time::Duration;

/// One line of `work.csv`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Row {
    /// The name of the problem.
    pub problem: String,
    /// The method.
    pub method: String,
    /// Its tolerance or step.
    pub setting: String,
    /// The error.
    pub error: f64,
    /// Evaluations of the rates, where they are counted.
    pub evaluations: Option<usize>,
}

/// Solves every entry once.
///
/// # Errors
/// Whatever a solver says.
pub(crate) fn rows(entries: &[Entry]) -> Result<Vec<Row>, Cause> {
    let row = |entry: &Entry| {
        let measured = entry.measure(Duration::ZERO)?;
        Ok(Row {
            problem: entry.problem.into(),
            method: entry.method.into(),
            setting: entry.setting.clone(),
            error: measured.error,
            evaluations: measured.evaluations,
        })
    };
    entries.iter().map(row).collect()
}

/// The rows as a table with a comma between the columns.
pub(crate) fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "# Errors and evaluations of the rates of every method of the library on every problem of the report: the same on every run.\n\
         # error: see the page; evaluations: empty for what steps nothing, and for what does not count its steps.\n\
         # written by: cargo bench --bench speed -- work FILE\n\
         problem,method,setting,error,evaluations\n",
    );
    for Row { problem, method, setting, error, evaluations } in rows {
        let evaluations = evaluations.map_or_else(String::new, |count| count.to_string());
        text.push_str(&format!("{problem},{method},{setting},{error:.3e},{evaluations}\n"));
    }
    text
}

impl fmt::Display for Row {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let evaluations = self.evaluations.map_or_else(|| "–".to_owned(), |count| count.to_string());
        write!(
            out,
            "{:<11} {:<12} {:<20} {:>9.2e} {evaluations:>9}",
            self.problem, self.method, self.setting, self.error
        )
    }
}

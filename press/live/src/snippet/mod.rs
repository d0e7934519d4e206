//! Snippets of pages: as tests, where each number that the page prints is held to its last digit, and as functions of
//! the numbers that a reader may change.

mod printable;
pub mod record;
mod tested;

pub use printable::{Number, Printable};
pub use tested::{begin, printed};

/// A snippet with live numbers: a function of them that answers with what it prints and finds. What an assertion in it
/// finds is recorded and stops nothing. The build script of the crate of the pages makes them.
#[derive(Debug)]
pub struct Snippet {
    /// Which snippet with live numbers it is, from 0 on in the book.
    pub number: usize,
    /// Where it stands: `book/turning/index.md:292`.
    pub place: &'static str,
    /// Its live numbers.
    pub live: &'static [Live],
    /// The numbers that the page prints.
    pub printed: &'static [&'static str],
    /// How many assertions it has.
    pub checks: usize,
    /// The text of the page, as a function.
    pub body: fn(&[f64]) -> Result<(), String>,
}

/// A number that a reader may change.
#[derive(Debug)]
pub struct Live {
    /// What the snippet calls it.
    pub name: &'static str,
    /// What the page has.
    pub value: f64,
    /// How far it goes.
    pub least: f64,
    /// How far it goes.
    pub most: f64,
    /// Whether it counts.
    pub whole: bool,
}

impl Snippet {
    /// Runs it with these numbers. A line for each number that it prints, in its order: `=` and the number, or nothing
    /// if it was not reached; for each assertion: `+` if it holds, `?` if it was not reached, or `-` if it fails, and
    /// the two numbers that it compares, `0.092 is not below 0.087`, if they are two; then `!` and the words of an error if
    /// it gave up.
    pub fn run(&self, live: &[f64]) -> Vec<String> {
        record::begin(self.printed.len(), self.checks);
        let outcome = if live.len() == self.live.len() {
            (self.body)(live)
        } else {
            Err(format!("{} live numbers were given, and the snippet has {}", live.len(), self.live.len()))
        };
        let mut lines = record::lines();
        lines.extend(outcome.err().map(|said| format!("!{said}")));
        lines
    }
}

//! The snippets whose numbers a reader may change, each a function of them that answers with what it prints and finds.
//!
//! The build script takes their text from the pages. What an assertion there finds is recorded and stops nothing.

#[path = "../../../snippets/src/printable.rs"]
#[allow(unreachable_pub, reason = "the crate `snippets` gives it to its tests")]
mod printable;
#[macro_use]
#[allow(dead_code, unused_macros, reason = "a snippet may use any of them")]
mod record;

/// A snippet of a page.
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
    body: fn(&[f64]) -> Result<(), String>,
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
    /// Runs it with these numbers; the lines of the answer, as [`crate::run`] describes them.
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

/// The text of the pages.
#[allow(unused, clippy::all, reason = "it is written for a reader, who may leave a value unused")]
mod pages {
    use super::{Live, Snippet, record};

    /// What snippets import by this name: assertions that record.
    mod approx {
        pub(crate) use crate::snippets::record::{assert_abs_diff_eq, assert_relative_eq, assert_ulps_eq};
    }

    include!(concat!(env!("OUT_DIR"), "/snippets.rs"));
}

pub use pages::{SNIPPETS, scenes};

//! Snippets as documentation tests: what the build script of the crate of the pages writes into them.

use super::Printable;
use super::printable::is_zero;
use crate::limit;
use std::panic::{self, Location};

/// Begins the snippet at this line of a page: whatever fails in it is named by page and line, and it has to come to an
/// end.
#[track_caller]
pub fn begin(page: &'static str, line: u32) {
    let first = Location::caller();
    let said = panic::take_hook();
    panic::set_hook(Box::new(move |panic| {
        let here = panic.location().filter(|here| here.file() == first.file() && here.line() >= first.line());
        eprintln!(
            "error: {page}:{}: the snippet fails:",
            line + here.map_or(0, |here| here.line() - first.line())
        );
        said(panic);
    }));
    std::mem::forget(limit::watch(format!("{page}:{line}: the snippet")));
}

/// Holds a value to the numbers that the page prints of it, to the last digit shown.
///
/// ```
/// live::snippet::printed(&(0.0123456, 12), "1.23e-2, 12", "book/page.md:3");
/// ```
///
/// # Panics
/// If a number of the value, rounded to as many digits, is another; the message names page and line.
#[track_caller]
pub fn printed(value: &impl Printable, shown: &str, place: &str) {
    let numbers = value.numbers();
    let count = shown.split(", ").count();
    assert!(
        count == numbers.len(),
        "{place}: the page prints {count} numbers, and the value has {numbers:?}"
    );
    for (number, shown) in numbers.into_iter().zip(shown.split(", ")) {
        let written = number.written_like(shown);
        assert!(
            written == shown || (is_zero(shown) && written.trim_start_matches('-') == shown),
            "{place}: the page prints {shown}, and the value is {written}, that is {number:?}"
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::process::Command;
    use std::{env, thread};

    /// Runs itself once more, as a snippet that fails, or that does not come to an end.
    #[test]
    fn a_snippet_is_named_by_page_and_line_when_it_fails_and_ends_when_it_runs_for_ever() {
        const AS: &str = "PLAYS_A_SNIPPET";
        match env::var(AS).as_deref() {
            Ok("fails") => {
                begin("book/a.md", 7);

                panic!("so it is");
            }
            Ok(_) => {
                begin("book/a.md", 7);
                loop {
                    thread::park();
                }
            }
            Err(_) => {}
        }
        let name = thread::current().name().expect("that of the test").to_owned();
        for (part, words) in [
            ("fails", "error: book/a.md:9: the snippet fails:\n"),
            ("runs", "error: book/a.md:7: the snippet still runs after 1 s: "),
        ] {
            let mut test = Command::new(env::current_exe().expect("this program"));
            test.args([&*name, "--exact", "--nocapture"]).env(AS, part).env("BOOK_LIMIT", "1");
            let run = test.output().expect("it runs");
            let said = String::from_utf8_lossy(&run.stderr);
            assert!(!run.status.success() && said.contains(words), "{part}: {said}");
        }
    }

    #[test]
    fn a_value_is_held_to_every_digit_that_the_page_shows() {
        printed(&4.316_6, "4.317", "");
        printed(&-0.000_04, "0.000", "");
        printed(&[1.0, 2.55], "1, 2.5", ""); // 2.55 lies below the tie
        printed(&6.02e23, "6.0e23", "");
        printed(&&7_usize, "7", "");
        for (value, shown) in [(4.316_4, "4.317"), (4.316_6, "4.318"), (-4.317, "4.317"), (6.06e23, "6.0e23")]
        {
            let wrong = std::panic::catch_unwind(|| printed(&value, shown, "book/page.md:3"));
            let said = *wrong.expect_err(shown).downcast::<String>().expect("a message");
            let begins = format!("book/page.md:3: the page prints {shown}, and the value is ");
            assert!(said.starts_with(&begins) && said.ends_with(&format!(", that is {value:?}")), "{said}");
        }
        assert!(std::panic::catch_unwind(|| printed(&[1.0, 2.0], "1.0", "")).is_err());
    }
}

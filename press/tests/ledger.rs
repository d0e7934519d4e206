//! The ledger is complete and true: every equation of the source has its row, its anchor on a page and its test.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the press lies in the workspace")
}

/// The text of all files of this ending below a folder.
fn texts(folder: &Path, ending: &str) -> String {
    let mut all = String::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            all += &texts(&path, ending);
        } else if path.to_string_lossy().ends_with(ending) {
            all += &fs::read_to_string(&path).expect("a text");
            all.push('\n');
        }
    }
    all
}

/// The names of the tests of the library that run: an ignored one does not count.
fn tests() -> BTreeSet<String> {
    let text = texts(&root().join("tests"), ".rs");
    let names = text.split("#[test]\nfn ").skip(1).filter_map(|rest| rest.split('(').next());
    let names: BTreeSet<String> = names.map(str::to_owned).collect();
    assert!(names.len() > 200, "only {} tests were found", names.len());
    names
}

/// The rows of the tables, as cells.
fn rows(ledger: &str, section: &str) -> Vec<Vec<String>> {
    let part = ledger.split(section).nth(1).expect("the section");
    let part = part.split("\n## ").next().expect("its end");
    part.lines()
        .filter(|line| {
            line.starts_with("| ") && !line.starts_with("| equation") && !line.starts_with("| where")
        })
        .map(|line| line.trim_matches('|').split(" | ").map(|cell| cell.trim().to_owned()).collect())
        .collect()
}

fn ledger() -> String {
    fs::read_to_string(root().join("book/ledger.md")).expect("the ledger")
}

fn named_test(cell: &str) -> &str {
    cell.trim_matches('`')
}

#[test]
fn every_equation_of_the_source_has_its_row_its_anchor_and_its_test() {
    let ledger = ledger();
    let rows = rows(&ledger, "{#sec:ledger-equations}");
    let (tests, pages) = (tests(), texts(&root().join("book"), ".md"));
    assert_eq!(rows.len(), 98);
    for (row, number) in rows.iter().zip(1..) {
        let [equation, says, verdict, test] = &row[..] else {
            panic!("({number}) has {} cells: {row:?}", row.len())
        };
        assert_eq!(equation, &format!("@source:{number}"), "the row of ({number})");
        assert!(says.len() > 3, "({number}) says nothing");
        let judged = ["right", "slip", "**wrong**"].iter().any(|word| verdict.starts_with(word));
        assert!(judged, "({number}) has no verdict: {verdict}");
        let test = named_test(test);
        assert!(tests.contains(test), "the test `{test}` of ({number}) does not exist");
        assert!(test.contains(&format!("eq{number:02}_")), "`{test}` is not named for ({number})");
        // The equation's label carries the number: source=19, or one of several in quotation marks.
        let labelled = pages.split("{#eq:").skip(1).filter_map(|rest| rest.split('}').next()).any(|label| {
            label.split("source=").nth(1).is_some_and(|numbers| {
                let numbers = numbers.strip_prefix('"').map_or_else(
                    || numbers.split(' ').next().unwrap_or_default(),
                    |quoted| quoted.split('"').next().unwrap_or_default(),
                );
                numbers.split(' ').any(|n| n.parse() == Ok(number))
            })
        });
        assert!(labelled, "no page derives ({number})");
    }
}

#[test]
fn an_equation_that_a_page_corrects_is_not_called_right_in_the_ledger() {
    let (ledger, pages) = (ledger(), texts(&root().join("book"), ".md"));
    let rows = rows(&ledger, "{#sec:ledger-equations}");
    let mut corrected = 0;
    for label in pages.split("{#eq:").skip(1).filter_map(|rest| rest.split('}').next()) {
        if !label.ends_with("corrected") {
            continue;
        }
        let numbers = label.split("source=").nth(1).expect("a corrected equation has a number");
        let numbers = numbers.trim_end_matches("corrected").trim().trim_matches('"');
        let verdicts: Vec<&str> =
            numbers.split(' ').map(|n| rows[n.parse::<usize>().expect("a number") - 1][2].as_str()).collect();
        assert!(
            verdicts.iter().all(|verdict| !verdict.starts_with("right")),
            "eq:{label} corrects what the ledger calls right"
        );
        corrected += 1;
    }
    assert!(corrected > 15, "{corrected}");
}

#[test]
fn every_claim_without_a_number_names_an_equation_and_a_test() {
    let ledger = ledger();
    let rows = rows(&ledger, "{#sec:ledger-claims}");
    let tests = tests();
    assert!(rows.len() >= 18, "{}", rows.len());
    for row in rows {
        let [what, _, equation, test] = &row[..] else { panic!("{row:?}") };
        assert!(equation.starts_with("@eq:"), "{what}: {equation}");
        let test = named_test(test);
        assert!(tests.contains(test), "{what}: the test `{test}` does not exist");
    }
}

#[test]
fn the_errata_page_counts_the_verdicts_and_names_every_equation_that_is_wrong() {
    let ledger = ledger();
    let rows = rows(&ledger, "{#sec:ledger-equations}");
    let count = |verdict: &str| rows.iter().filter(|row| row[2].starts_with(verdict)).count();
    let page = fs::read_to_string(root().join("book/errata.md")).expect("the page");
    let said = format!(
        "98 equations and finds {} of them right as they stand, {} with a slip of the pen and {} wrong",
        count("right"),
        count("slip"),
        count("**wrong**")
    );
    assert!(page.contains(&said), "the page should say: {said}");
    let striking = page.split("{#sec:errata-limits}").next().expect("the first section");
    for row in rows.iter().filter(|row| row[2].starts_with("**wrong**")) {
        let named =
            striking.split(|c: char| c != ':' && c != '@' && !c.is_alphanumeric()).any(|word| word == row[0]);
        assert!(named, "{} is wrong, and the page does not name it", row[0]);
    }
}

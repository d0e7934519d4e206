//! The ledger is complete and true: every equation of the source has its row, its anchor on a page and its
//! test, and where the source is wrong the test holds what is printed and sees it fail.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The workspace, where it lies now.
fn root() -> PathBuf {
    PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it")).join("../..")
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

/// The body of the test that a cell names, in the `tests` of the library.
fn test<'a>(tests: &'a str, cell: &str) -> Result<&'a str, String> {
    let head = format!("fn {}()", cell.trim_matches('`'));
    let found = tests.split("#[test]\n").skip(1).filter_map(|test| test.trim_start().strip_prefix(&head));
    match found.collect::<Vec<_>>()[..] {
        [body] => Ok(body.split("\n}\n").next().unwrap_or(body)),
        [] => Err(format!("there is no test {cell} that runs")),
        _ => Err(format!("there is more than one test {cell}")),
    }
}

/// The numbers of the rows that the ledger calls a slip or wrong.
fn corrected(rows: &[Vec<String>]) -> BTreeSet<usize> {
    (1..).zip(rows).filter(|(_, row)| !row[2].starts_with("right")).map(|(number, _)| number).collect()
}

/// The labels of all pages: their numbers of the source, and whether they correct them.
fn labels(pages: &str) -> Vec<(Vec<usize>, bool)> {
    let labels = pages.split("{#eq:").skip(1).filter_map(|rest| rest.split('}').next());
    labels
        .filter_map(|label| label.split_once("source="))
        .map(|(_, numbers)| {
            let (numbers, corrected) =
                numbers.strip_suffix(" corrected").map_or((numbers, false), |n| (n, true));
            (numbers.trim_matches('"').split(' ').filter_map(|n| n.parse().ok()).collect(), corrected)
        })
        .collect()
}

#[test]
fn every_equation_of_the_source_has_its_row_its_label_and_its_test() {
    let rows = rows(&ledger(), "{#sec:ledger-equations}");
    let (tests, labels) = (texts(&root().join("tests"), ".rs"), labels(&texts(&root().join("book"), ".md")));
    let corrected = corrected(&rows);
    assert!(corrected.len() > 15, "{corrected:?}");
    // That no page has a number which the ledger lacks is for the press to say.
    let mut faults = Vec::new();
    for (row, number) in rows.iter().zip(1..) {
        let [equation, says, verdict, name] = &row[..] else {
            panic!("({number}) has {} cells: {row:?}", row.len())
        };
        assert_eq!(equation, &format!("@source:{number}"), "the row of ({number})");
        let mut fault = |message: String| faults.push(format!("({number}): {message}"));
        if says.len() < 4 {
            fault("the row says nothing".to_owned());
        }
        if !["right", "slip", "**wrong**"].iter().any(|word| verdict.starts_with(word)) {
            fault(format!("`{verdict}` is no verdict"));
        }
        if !name.contains(&format!("eq{number:02}_")) {
            fault(format!("{name} is not named for it"));
        }
        match test(&tests, name) {
            Err(message) => fault(message),
            // That the form which is printed is the source's is the business of whoever reads the test.
            Ok(body)
                if corrected.contains(&number) && !body.contains("corrected_holds_and_printed_fails(") =>
            {
                fault(format!("the source is wrong, and {name} does not see the printed form fail"));
            }
            Ok(_) => {}
        }
        match labels.iter().find(|(numbers, _)| numbers.contains(&number)) {
            None => fault("no page derives it".to_owned()),
            Some((_, says_so)) if *says_so != corrected.contains(&number) => {
                fault(format!("it is \"{verdict}\" in the ledger, and its label says otherwise"));
            }
            Some(_) => {}
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn the_tables_of_errata_and_the_changelog_list_what_the_ledger_corrects() {
    let corrected = corrected(&rows(&ledger(), "{#sec:ledger-equations}"));
    // A row that stands for an equation begins with its number and nothing else.
    let page = fs::read_to_string(root().join("book/errata.md")).expect("the page");
    let listed: BTreeSet<usize> = page
        .split("| where | printed | true | see |")
        .skip(1)
        .flat_map(|table| table.lines().skip(1).take_while(|line| line.starts_with('|')))
        .filter_map(|line| line.strip_prefix("| @source:")?.split(' ').next()?.parse().ok())
        .collect();
    assert_eq!(listed, corrected, "the tables of errata and the ledger");
    // An entry of the changelog begins with the numbers of its equations: "- (25), (26) …".
    let log = fs::read_to_string(root().join("CHANGELOG.md")).expect("the changelog");
    let entries = log.split("### Corrected in the source").nth(1).expect("the section");
    let logged: BTreeSet<usize> = entries
        .lines()
        .take_while(|line| !line.starts_with('#'))
        .filter_map(|line| line.strip_prefix("- "))
        .flat_map(|entry| entry.split([' ', ',']).take_while(|word| word.is_empty() || word.starts_with('(')))
        .filter_map(|word| word.strip_prefix('(')?.strip_suffix(')')?.parse().ok())
        .collect();
    assert_eq!(logged, corrected, "the changelog and the ledger");
}

/// The chapters in their order: name and folder.
fn chapters() -> Vec<(String, String)> {
    let summary = fs::read_to_string(root().join("book/SUMMARY.md")).expect("the summary");
    let chapters: Vec<(String, String)> = summary
        .lines()
        .filter_map(|line| line.strip_prefix("- [")?.strip_suffix("/index.md)")?.split_once("]("))
        .map(|(title, folder)| (title.split(':').next().expect("a name").to_owned(), folder.to_owned()))
        .collect();
    assert!(chapters.len() >= 12, "{chapters:?}");
    chapters
}

#[test]
fn the_readme_lists_the_chapters_and_the_equations_that_they_derive() {
    let readme = fs::read_to_string(root().join("README.md")).expect("the readme");
    let chapters = chapters();
    let table = readme.split("| chapter | problem |").nth(1).expect("the table").trim_start();
    let rows: Vec<&str> = table.lines().skip(1).map_while(|line| line.strip_prefix("| ")).collect();
    let names: Vec<&str> = rows.iter().filter_map(|row| Some(row.split_once(" | ")?.0)).collect();
    let wanted: Vec<&str> = chapters.iter().map(|(name, _)| &name[..]).collect();
    // One row is of a page that is no chapter.
    let listed: Vec<&str> = names.into_iter().filter(|name| *name != "Ledger").collect();
    assert_eq!(listed, wanted, "the chapters of the table in README.md and of book/SUMMARY.md");
    for (name, folder) in chapters {
        let row = rows.iter().find_map(|line| line.strip_prefix(&format!("{name} |"))).expect("its row");
        // "(1), (2), (34) to (45)"
        let mut listed = BTreeSet::new();
        let mut last = 0;
        for (at, _) in row.match_indices('(') {
            if let Some(Ok(number)) = row[at + 1..].split(')').next().map(str::parse::<usize>) {
                let first = if row[..at].ends_with(" to ") { last + 1 } else { number };
                listed.extend(first..=number);
                last = number;
            }
        }
        let labels = labels(&texts(&root().join("book").join(&folder), ".md"));
        let derived: BTreeSet<usize> = labels.into_iter().flat_map(|(numbers, _)| numbers).collect();
        assert_eq!(listed, derived, "the row of {name} in README.md and the pages of book/{folder}");
    }
}

#[test]
fn teachers_have_a_section_of_notes_for_each_chapter_in_their_order() {
    let notes = fs::read_to_string(root().join("book/teaching-notes.md")).expect("the notes");
    let headings: Vec<&str> = notes
        .lines()
        .filter_map(|line| Some(line.strip_prefix("## ")?.split(" {#sec:notes-").next().expect("words")))
        .collect();
    let names: Vec<String> = chapters().into_iter().map(|(name, _)| name).collect();
    assert_eq!(headings, names, "the sections of book/teaching-notes.md and the chapters of book/SUMMARY.md");
}

#[test]
fn every_claim_without_a_number_names_an_equation_and_a_test() {
    let ledger = ledger();
    let rows = rows(&ledger, "{#sec:ledger-claims}");
    let tests = texts(&root().join("tests"), ".rs");
    assert!(rows.len() >= 22, "{}", rows.len());
    for row in rows {
        let [what, _, equation, name] = &row[..] else { panic!("{row:?}") };
        assert!(equation.starts_with("@eq:"), "{what}: {equation}");
        test(&tests, name).unwrap_or_else(|fault| panic!("{what}: {fault}"));
    }
}

#[test]
fn the_errata_page_counts_the_verdicts_and_names_every_equation_that_is_wrong() {
    let ledger = ledger();
    let rows = rows(&ledger, "{#sec:ledger-equations}");
    let count = |verdict: &str| rows.iter().filter(|row| row[2].starts_with(verdict)).count();
    let page = fs::read_to_string(root().join("book/errata.md")).expect("the page");
    let said = format!(
        "{} equations and finds {} of them right as they stand, {} with a slip of the pen and {} wrong",
        rows.len(),
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

//! The ledger is complete and true: every equation of the source has its row, its anchor on a page and its
//! test, and where the source is wrong the test holds what is printed and sees it fail.

mod suite;

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

fn named_test(cell: &str) -> &str {
    cell.trim_matches('`')
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
fn every_equation_of_the_source_has_its_row_its_anchor_and_its_test() {
    let ledger = ledger();
    let rows = rows(&ledger, "{#sec:ledger-equations}");
    let (suite, labels) = (suite::read(&root().join("tests")), labels(&texts(&root().join("book"), ".md")));
    // That no page has a number which the ledger lacks is for the press to say.
    let mut faults = Vec::new();
    for (row, number) in rows.iter().zip(1..) {
        let [equation, says, verdict, test] = &row[..] else {
            panic!("({number}) has {} cells: {row:?}", row.len())
        };
        assert_eq!(equation, &format!("@source:{number}"), "the row of ({number})");
        assert!(says.len() > 3, "({number}) says nothing");
        let judged = ["right", "slip", "**wrong**"].iter().any(|word| verdict.starts_with(word));
        assert!(judged, "({number}) has no verdict: {verdict}");
        let test = named_test(test);
        assert!(test.contains(&format!("eq{number:02}_")), "`{test}` is not named for ({number})");
        faults.extend(suite.proves(test).err().map(|fault| format!("({number}): {fault}")));
        assert!(labels.iter().any(|(numbers, _)| numbers.contains(&number)), "no page derives ({number})");
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn the_test_of_a_corrected_equation_holds_the_printed_form_and_sees_it_fail() {
    // What can be seen from here: the very test that the row names binds the two forms to `corrected` and to
    // `printed` and gives them to `corrected_holds_and_printed_fails`, which at run time wants every case of
    // the one right and nine in ten of the other wrong. A comment does not count, nor does another test. That
    // the form bound to `printed` is the source's is the business of whoever reads it.
    let rows = rows(&ledger(), "{#sec:ledger-equations}");
    let suite = suite::read(&root().join("tests"));
    let corrected = corrected(&rows);
    assert!(corrected.len() > 15, "{corrected:?}");
    let faults: Vec<String> = corrected
        .into_iter()
        .filter_map(|number| {
            let fault = suite.sees_the_printed_form_fail(named_test(&rows[number - 1][3])).err()?;
            Some(format!("({number}): {fault}"))
        })
        .collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn a_comment_a_name_or_another_test_is_no_proof() {
    let judged = |body: &str| {
        let text = format!("use mechanics::Thing;\n{body}");
        let suite = suite::Suite::of([("case", text.as_str())]);
        (suite.proves("eq01_a").is_ok(), suite.sees_the_printed_form_fail("eq01_a").is_ok())
    };
    let whole = "#[test] fn eq01_a() { let corrected = Thing::new(); let printed = 2.0;
        corrected_holds_and_printed_fails([(corrected, printed)], 1e-9, 0.1); }";
    assert_eq!(judged(whole), (true, true));
    // The two forms bound together, and the library reached through a helper.
    let helped =
        "fn two() -> f64 { Thing::new() } #[test] fn eq01_a() { let (corrected, printed) = (two(), 2.0);
        corrected_holds_and_printed_fails([(corrected, printed)], 1e-9, 0.1); }";
    assert_eq!(judged(helped), (true, true));
    for weaker in [
        whole.replace("let printed = 2.0;", "// let printed = 2.0;\n"),
        whole.replace("let printed = 2.0;", "let text = \"let printed = 2.0\";"),
        whole.replace("(corrected, printed)", "(corrected, 2.0)"),
        whole
            .replace("corrected_holds_and_printed_fails(", "// corrected_holds_and_printed_fails(\nassert!("),
        whole.replace("eq01_a() {", "eq01_a() { assert!(Thing::new()); } #[test] fn eq01_b() {"),
    ] {
        assert!(!judged(&weaker).1, "{weaker}");
    }
    assert_eq!(judged(&whole.replace("#[test]", "#[test] #[ignore]")), (false, false));
    assert_eq!(judged(&whole.replace("#[test]", "")), (false, false));
    assert!(!judged(&whole.replace("Thing::new()", "1.0")).0, "it reaches no library");
    assert!(!judged("#[test] fn eq01_a() { Thing::new(); }").0, "it asserts nothing");
}

#[test]
fn a_label_says_corrected_exactly_where_the_ledger_says_slip_or_wrong() {
    let rows = rows(&ledger(), "{#sec:ledger-equations}");
    let corrected = corrected(&rows);
    let labels = labels(&texts(&root().join("book"), ".md"));
    assert!(labels.iter().filter(|(_, corrected)| *corrected).count() > 15, "the labels are not read");
    for (numbers, says_so) in labels {
        for number in numbers {
            assert_eq!(
                says_so,
                corrected.contains(&number),
                "({number}) is \"{}\" in the ledger, and its label says otherwise",
                rows[number - 1][2]
            );
        }
    }
}

#[test]
fn the_tables_of_the_chapters_and_the_changelog_list_what_the_ledger_corrects() {
    let corrected = corrected(&rows(&ledger(), "{#sec:ledger-equations}"));
    // A row of a chapter's table that stands for an equation begins with its number and nothing else.
    let pages = texts(&root().join("book"), "index.md");
    let listed: BTreeSet<usize> = pages
        .split("| source | printed | should be | proof |")
        .skip(1)
        .flat_map(|table| table.lines().skip(1).take_while(|line| line.starts_with('|')))
        .filter_map(|line| line.strip_prefix("| @source:")?.split(' ').next()?.parse().ok())
        .collect();
    assert_eq!(listed, corrected, "the tables of the chapters and the ledger");
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
    let suite = suite::read(&root().join("tests"));
    assert!(rows.len() >= 22, "{}", rows.len());
    for row in rows {
        let [what, _, equation, test] = &row[..] else { panic!("{row:?}") };
        assert!(equation.starts_with("@eq:"), "{what}: {equation}");
        if let Err(fault) = suite.proves(named_test(test)) {
            panic!("{what}: {fault}");
        }
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

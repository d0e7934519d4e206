//! The tables of symbols are complete and true: each letter of a formula has its row, for the whole book or for the
//! chapter that means it otherwise; each row is used, first where it says; and what it names in the library is there.

use press::print::symbols::letters;
use press::read::disk::from_disk;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The table of letters that mean the same everywhere.
const BOOK: &str = "book";

/// The workspace, where it lies now.
fn root() -> PathBuf {
    PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it")).join("../..")
}

/// The chapters in reading order, each with the letters of its pages and one of the pages that use each.
fn chapters() -> Vec<(String, BTreeMap<String, String>)> {
    let mut chapters: Vec<(String, BTreeMap<String, String>)> = Vec::new();
    for page in from_disk(&root()).expect("a book without faults").1 {
        let Some((chapter, _)) = page.path.split_once('/') else { continue };
        if chapters.last().is_none_or(|(last, _)| last != chapter) {
            chapters.push((chapter.to_owned(), BTreeMap::new()));
        }
        let used = letters(&page.text).unwrap_or_else(|fault| panic!("{}: {fault}", page.file));
        let all = chapters.last_mut().map(|(_, letters)| letters).expect("a chapter");
        used.into_iter().for_each(|letter| drop(all.insert(letter, page.file.clone())));
    }
    chapters
}

/// A row of a table of symbols.
struct Row {
    symbols: BTreeSet<String>,
    cells: Vec<String>,
}

/// The rows of the tables below the headings `{#sec:symbols-…}`.
fn tables() -> BTreeMap<String, Vec<Row>> {
    let pages = ["conventions.md", "symbols.md"].map(|page| root().join("book").join(page));
    let text: String = pages.map(|page| fs::read_to_string(page).expect("a page of symbols")).join("\n");
    let mut tables = BTreeMap::new();
    for section in text.split("\n#").filter(|section| section.contains("{#sec:symbols-")) {
        let label = section.split("{#sec:symbols-").nth(1).and_then(|rest| rest.split('}').next());
        let rows = section.lines().filter(|line| line.starts_with("| $")).map(|line| {
            let cells = line.trim_matches('|').split(" | ").map(|cell| cell.trim().to_owned());
            let cells: Vec<String> = cells.collect();
            Row { symbols: letters(&cells[0]).expect("formulas that are understood"), cells }
        });
        tables.insert(label.expect("a label").to_owned(), rows.collect());
    }
    tables
}

/// Whether a row for `symbol` is one for this letter: with its subscript, or without.
fn is_for(symbol: &str, letter: &str) -> bool {
    letter == symbol || letter.split('_').next() == Some(symbol)
}

fn assert_none(faults: &BTreeSet<String>) {
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), Vec::from_iter(faults.clone()).join("\n"));
}

#[test]
fn every_letter_of_a_formula_has_one_row() {
    let tables = tables();
    let mut faults = BTreeSet::new();
    for (section, rows) in &tables {
        let mut seen = BTreeSet::new();
        let doubled = rows.iter().flat_map(|row| &row.symbols).filter(|symbol| !seen.insert(*symbol));
        faults.extend(doubled.map(|symbol| format!("{{#sec:symbols-{section}}}: {symbol} has two rows")));
    }
    let mut count = 0;
    for (chapter, letters) in &chapters() {
        let rows = [BOOK, chapter].into_iter().filter_map(|section| tables.get(section)).flatten();
        let known: Vec<&String> = rows.flat_map(|row| &row.symbols).collect();
        count += letters.len();
        for (letter, page) in letters.iter().filter(|(letter, _)| !known.iter().any(|s| is_for(s, letter))) {
            faults.insert(format!("{{#sec:symbols-{chapter}}}: {letter} has no row, and {page} uses it"));
        }
    }
    assert!(count > 400, "only {count} letters");
    assert_none(&faults);
}

#[test]
fn every_row_is_used_and_first_where_it_says() {
    let (chapters, tables) = (chapters(), tables());
    let uses = |letters: &BTreeMap<String, String>, symbol: &str| letters.keys().any(|l| is_for(symbol, l));
    let means_otherwise = |chapter: &str, symbol: &String| {
        tables.get(chapter).is_some_and(|rows| rows.iter().any(|row| row.symbols.contains(symbol)))
    };
    let mut faults = BTreeSet::new();
    for (section, row) in tables.iter().flat_map(|(section, rows)| rows.iter().map(move |row| (section, row)))
    {
        for symbol in &row.symbols {
            let mut users =
                chapters.iter().filter(|(_, letters)| uses(letters, symbol)).map(|(name, _)| name);
            if section != BOOK {
                if !users.any(|name| name == section) {
                    faults.insert(format!("{{#sec:symbols-{section}}}: no page uses {symbol}"));
                }
                continue;
            }
            let says = row.cells.last().expect("cells");
            match users.find(|name| !means_otherwise(name, symbol)) {
                None => drop(faults.insert(format!("no chapter uses {symbol} as the book does"))),
                Some(first) if says.contains(&format!("({first}/index.md)")) => {}
                Some(first) => drop(faults.insert(format!("{symbol} is first in {first}, not in {says}"))),
            }
        }
    }
    assert!(tables.len() > 9, "a table for the book and one for each chapter");
    assert_none(&faults);
}

/// The words of the public items of the library.
fn public(folder: &Path) -> BTreeSet<String> {
    let mut words = BTreeSet::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            words.append(&mut public(&path));
            continue;
        }
        let text = fs::read_to_string(&path).expect("a text");
        let lines = text.lines().filter(|line| line.trim_start().starts_with("pub"));
        let all = lines.flat_map(|line| line.split(|c: char| !c.is_alphanumeric() && c != '_'));
        words.extend(all.map(str::to_owned));
    }
    words
}

#[test]
fn what_rows_name_in_the_library_is_there() {
    let public = public(&root().join("src"));
    let (mut faults, mut names) = (BTreeSet::new(), 0);
    for (section, rows) in &tables() {
        for Row { symbols, cells } in rows {
            if cells.len() != if section == BOOK { 5 } else { 4 } || cells[1].len() < 3 {
                faults.insert(format!("{{#sec:symbols-{section}}}: {symbols:?} has {} cells", cells.len()));
                continue;
            }
            for part in cells[3].split('`').skip(1).step_by(2).flat_map(|name| name.split("::")) {
                names += 1;
                if !public.contains(part.trim_end_matches("()")) {
                    faults.insert(format!("{{#sec:symbols-{section}}}: the library has no {part}"));
                }
            }
        }
    }
    assert!(names > 50, "only {names} names");
    assert_none(&faults);
}

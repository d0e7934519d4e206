//! The tables of symbols are complete and true: each letter of a formula has its row, for the whole book or for the
//! chapter that means it otherwise; each row is used, first where it says; and what it names in the library is there.

use press::book::Page;
use press::disk::from_disk;
use pulldown_cmark::{Event, Options, Parser};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The workspace, where it lies now.
fn root() -> PathBuf {
    PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it")).join("..")
}

fn pages() -> Vec<Page> {
    from_disk(&root()).expect("a book without faults").1
}

/// The chapter of a page: its folder.
fn folder(page: &Page) -> Option<&str> {
    page.path.split_once('/').map(|(folder, _)| folder)
}

// Formulas

const GREEK: [&str; 38] = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "zeta",
    "eta",
    "theta",
    "vartheta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "pi",
    "rho",
    "varrho",
    "sigma",
    "tau",
    "upsilon",
    "phi",
    "varphi",
    "chi",
    "psi",
    "omega",
    "Gamma",
    "Delta",
    "Theta",
    "Lambda",
    "Xi",
    "Pi",
    "Sigma",
    "Phi",
    "Psi",
    "Omega",
    "ell",
];
/// A letter in one of these is another letter; in any other command, as an accent, it stays itself.
const FONTS: [&str; 5] = ["mathcal", "mathsf", "mathbb", "mathfrak", "mathscr"];
/// What these hold are words.
const WORDS: [&str; 6] = ["text", "operatorname", "mathrm", "begin", "end", "textcolor"];

/// Reads a formula from left to right.
struct Formula<'a> {
    rest: &'a str,
}

impl<'a> Formula<'a> {
    fn eat(&mut self, length: usize) -> &'a str {
        let (eaten, rest) = self.rest.split_at(length);
        self.rest = rest;
        eaten
    }

    /// What stands next: a group in braces, a command, or one character.
    fn argument(&mut self) -> &'a str {
        self.rest = self.rest.trim_start();
        if self.rest.starts_with('{') {
            let mut depth = 0;
            let end = self.rest.find(|c| {
                depth += i32::from(c == '{') - i32::from(c == '}');
                depth == 0
            });
            let group = self.eat(end.expect("braces that close") + 1);
            return &group[1..group.len() - 1];
        }
        if self.rest.starts_with('\\') {
            let name = self.rest[1..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(self.rest.len() - 1);
            let command = self.eat(1 + name.max(1));
            // `\text{rel}` is one thing.
            return if WORDS.contains(&&command[1..]) { self.argument() } else { command };
        }
        let length = self.rest.chars().next().map_or(0, char::len_utf8);
        self.eat(length)
    }

    /// The subscript that follows, if one does: in one spelling.
    fn subscript(&mut self) -> String {
        // Primes and exponents may stand before it.
        let marks = self.rest.trim_start().trim_start_matches(['\'', ' ']);
        if !marks.starts_with('_') {
            return String::new();
        }
        self.rest = &marks[1..];
        let inside = self.argument().replace(['{', '}', ' ', ','], "");
        format!("_{}", inside.replace("\\text", "").replace("\\mathrm", ""))
    }
}

/// The letters of a formula, each with its subscript.
fn letters(tex: &str, found: &mut Vec<String>) {
    let mut formula = Formula { rest: tex };
    while !formula.rest.is_empty() {
        if formula.rest.starts_with('\\') {
            let end = formula.rest[1..].find(|c: char| !c.is_ascii_alphabetic());
            let command = formula.eat(1 + end.unwrap_or(formula.rest.len() - 1).max(1));
            let name = &command[1..];
            if WORDS.contains(&name) {
                formula.argument();
            } else if GREEK.contains(&name) {
                found.push(format!("{command}{}", formula.subscript()));
            } else if FONTS.contains(&name) {
                let letter = formula.argument().trim();
                found.push(format!("{command} {letter}{}", formula.subscript()));
            } else if formula.rest.trim_start().starts_with('{') || is_accent(name) {
                // The subscript of an accented letter is the letter's.
                let mut inner = Vec::new();
                letters(formula.argument(), &mut inner);
                let subscript = formula.subscript();
                if let [only] = &mut inner[..] {
                    only.push_str(&subscript);
                }
                found.append(&mut inner);
            }
        } else if formula.rest.starts_with(|c: char| c.is_ascii_alphabetic()) {
            let letter = formula.eat(1);
            found.push(format!("{letter}{}", formula.subscript()));
        } else if formula.rest.starts_with('_') {
            formula.eat(1);
            formula.argument(); // of something else than a letter
        } else {
            let length = formula.rest.chars().next().map_or(0, char::len_utf8);
            formula.eat(length);
        }
    }
}

fn is_accent(name: &str) -> bool {
    ["boldsymbol", "mathbf", "hat", "dot", "ddot", "bar", "tilde", "vec"].contains(&name)
}

/// The formulas of a text.
fn formulas(text: &str) -> Vec<String> {
    Parser::new_ext(text, Options::ENABLE_MATH | Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES)
        .filter_map(|event| match event {
            Event::InlineMath(tex) | Event::DisplayMath(tex) => Some(tex.into_string()),
            _ => None,
        })
        .collect()
}

fn letters_of(text: &str) -> BTreeSet<String> {
    let mut found = Vec::new();
    formulas(text).iter().for_each(|tex| letters(tex, &mut found));
    found.into_iter().collect()
}

/// The same without its subscript.
fn plain(letter: &str) -> &str {
    letter.split('_').next().unwrap_or(letter)
}

// Tables

/// A row of a table of symbols.
struct Row {
    line: String,
    symbols: Vec<String>,
    cells: Vec<String>,
}

/// The rows of the tables below a heading, by the heading's address.
fn tables() -> BTreeMap<String, Vec<Row>> {
    let text = fs::read_to_string(root().join("book/conventions.md")).expect("the conventions");
    let mut tables: BTreeMap<String, Vec<Row>> = BTreeMap::new();
    let mut section = None;
    for line in text.lines() {
        if line.starts_with('#') {
            let label = line.split("{#sec:symbols-").nth(1).and_then(|rest| rest.split('}').next());
            section = label.map(str::to_owned);
        }
        let Some(section) = section.as_ref().filter(|_| line.starts_with("| $")) else { continue };
        let cells: Vec<String> =
            line.trim_matches('|').split(" | ").map(|cell| cell.trim().to_owned()).collect();
        let mut symbols = Vec::new();
        formulas(&cells[0]).iter().for_each(|tex| letters(tex, &mut symbols));
        symbols.sort();
        symbols.dedup(); // a vector and its length
        let row = Row { line: line.to_owned(), symbols, cells };
        tables.entry(section.clone()).or_default().push(row);
    }
    tables
}

const BOOK: &str = "book";

/// Where the rows of a chapter stand.
fn place(section: &str) -> String {
    format!("book/conventions.md, {{#sec:symbols-{section}}}:")
}

#[test]
fn every_letter_of_a_formula_has_one_row() {
    let tables = tables();
    let known: HashMap<&str, BTreeSet<&String>> = tables
        .iter()
        .map(|(section, rows)| (&section[..], rows.iter().flat_map(|row| &row.symbols).collect()))
        .collect();
    let mut faults = BTreeSet::new();
    for (section, rows) in &tables {
        let mut seen = BTreeSet::new();
        for symbol in rows.iter().flat_map(|row| &row.symbols) {
            if !seen.insert(symbol) {
                faults.insert(format!("{} {symbol} has two rows", place(section)));
            }
        }
    }
    let mut letters = 0;
    for page in pages() {
        let Some(chapter) = folder(&page) else { continue };
        let here = [known.get(chapter), known.get(BOOK)];
        for letter in letters_of(&page.text) {
            letters += 1;
            let has = |letter: &str| here.iter().flatten().any(|rows| rows.contains(&letter.to_owned()));
            if !has(&letter) && !has(plain(&letter)) {
                let wanted = place(chapter);
                faults.insert(format!("{wanted} {letter} has no row, and {} uses it", page.file));
            }
        }
    }
    assert!(letters > 1000, "only {letters} letters");
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), Vec::from_iter(faults).join("\n"));
}

#[test]
fn every_row_is_used_and_first_where_it_says() {
    let pages = pages();
    let mut faults = Vec::new();
    let mut chapters: Vec<&str> = Vec::new();
    for chapter in pages.iter().filter_map(folder) {
        if !chapters.contains(&chapter) {
            chapters.push(chapter);
        }
    }
    let used: Vec<BTreeSet<String>> = chapters
        .iter()
        .map(|chapter| {
            let own = pages.iter().filter(|page| folder(page) == Some(chapter));
            own.flat_map(|page| letters_of(&page.text)).collect()
        })
        .collect();
    let tables = tables();
    let otherwise = |chapter: &str, symbol: &str| {
        tables
            .get(chapter)
            .is_some_and(|rows| rows.iter().any(|row| row.symbols.iter().any(|own| own == symbol)))
    };
    let uses = |index: usize, symbol: &str| {
        let is_used = |letter: &String| letter == symbol || plain(letter) == symbol;
        used[index].iter().any(is_used)
    };
    for (section, rows) in &tables {
        for row in rows {
            for symbol in &row.symbols {
                if section != BOOK {
                    let index = chapters.iter().position(|chapter| chapter == section);
                    let Some(index) = index else {
                        faults.push(format!("{} there is no such chapter", place(section)));
                        continue;
                    };
                    if !uses(index, symbol) {
                        faults.push(format!("{} no page uses {symbol}", place(section)));
                    }
                    continue;
                }
                let first = (0..chapters.len()).find(|&k| uses(k, symbol) && !otherwise(chapters[k], symbol));
                let says = row.cells.last().expect("cells");
                match first {
                    None => faults.push(format!("no chapter uses {symbol} as the book does")),
                    Some(first) if says.contains(&format!("({}/index.md)", chapters[first])) => {}
                    Some(first) => {
                        faults.push(format!("{symbol} is first in {}, not in {says}", chapters[first]));
                    }
                }
            }
        }
    }
    assert!(tables.len() > 9, "a table for the book and one for each chapter");
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn what_rows_name_in_the_library_is_there() {
    let mut words = BTreeSet::new();
    fn read(folder: &Path, words: &mut BTreeSet<String>) {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                read(&path, words);
                continue;
            }
            let text = fs::read_to_string(&path).expect("a text");
            let code = text
                .lines()
                .filter(|line| line.trim_start().starts_with("pub"))
                .collect::<Vec<_>>()
                .join(" ");
            words.extend(code.split(|c: char| !c.is_alphanumeric() && c != '_').map(str::to_owned));
        }
    }
    read(&root().join("src"), &mut words);
    let (mut faults, mut names) = (Vec::new(), 0);
    for (section, rows) in &tables() {
        for row in rows {
            let meaning = row.cells.get(1).map_or("", String::as_str);
            if row.cells.len() != if section == BOOK { 5 } else { 4 } || meaning.len() < 3 {
                faults.push(format!("{} {} has {} cells", place(section), row.line, row.cells.len()));
                continue;
            }
            for name in row.cells[3].split('`').skip(1).step_by(2) {
                names += 1;
                let parts = name.split("::").map(|part| part.trim_end_matches("()"));
                if let Some(part) = parts.into_iter().find(|part| !words.contains(*part)) {
                    faults.push(format!("{} the library has no {part}", place(section)));
                }
            }
        }
    }
    assert!(names > 50, "only {names} names");
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn letters_are_found_in_formulas() {
    for (tex, expected) in [
        (r"\boldsymbol\omega = \dot{\theta}_1\,\hat{\mathbf 3} + x", r"\omega \theta_1 x"),
        (r"\omega_\text{rel}^2 + \theta_L + \hat{\boldsymbol r}_m", r"\omega_rel \theta_L r_m"),
        (r"\mathcal L = \tfrac12 m v'_{1,2}", r"\mathcal L m v_12"),
        (r"\frac{a}{b} \operatorname{Re}(\bar u v) \text{if } \left( c \right)", "a b u v c"),
        (r"e^{i\Omega t}, \dot\omega_\perp", r"e i \Omega t \omega_\perp"),
    ] {
        let mut found = Vec::new();
        letters(tex, &mut found);
        assert_eq!(found.join(" "), expected, "{tex}");
    }
}

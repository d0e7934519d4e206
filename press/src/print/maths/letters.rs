//! Letters in the colours of what they stand for.
//!
//! Two tables of the page of conventions say which: readers have them as a key, and the press reads the same. One
//! begins with the column `quantity`, one with `chapter`; a column `letters` holds formulas, and a column
//! `colour` the name of a colour or `none`. A table below a heading `{#sec:symbols-chapter}`, on whatever page, shows
//! letters as that chapter means them.

use super::tree::Element;
use crate::book::Page;
use crate::colours::{QUANTITIES, Quantity};
use crate::fault::Faults;
use crate::read::items::{Cell, Item, LabelKind, PlacedItem};
use pulldown_cmark::{Event, Tag};
use std::collections::{BTreeSet, HashMap};
use unicode_normalization::UnicodeNormalization as _;

/// The page that has the tables.
pub(super) const CONVENTIONS: &str = "conventions.md";

/// What letters stand for, in the whole book and in its chapters.
#[derive(Debug, Default)]
pub(super) struct Letters {
    /// A chapter's folder, or nothing for all of them; a letter, perhaps with its subscript → its quantity, or none.
    meanings: HashMap<(String, String), Option<Quantity>>,
    /// Where formulas show what a chapter means, the path of the page and the place on it, and its folder.
    shown: HashMap<(String, usize), String>,
}

impl Letters {
    /// Reads the tables of the page of conventions; `convert` makes MathML of LaTeX, and nothing of what it does not
    /// understand.
    pub(super) fn read(
        page: &Page,
        items: &[PlacedItem<'_>],
        convert: impl Fn(&str) -> Option<Element>,
        faults: &mut Faults,
    ) -> Self {
        let mut letters = Self::default();
        let mut report = page.reporter(faults);
        for placed in items {
            let Item::Table { table, .. } = &placed.item else { continue };
            let Some((head, rows)) = table.rows.split_first() else { continue };
            let column = |name: &str| head.iter().position(|cell| words(cell) == name);
            let (Some(colours), Some(signs)) = (column("colour"), column("letters")) else {
                continue;
            };
            for row in rows {
                let (colour, chapter) = (&row[colours], &row[0]);
                let name = words(colour);
                let quantity = QUANTITIES.into_iter().find(|quantity| quantity.hue == name);
                if quantity.is_none() && name != "none" {
                    let known = QUANTITIES.map(|quantity| quantity.hue).join(", ");
                    report.fault(
                        colour.offset,
                        format!("`{name}` is no colour of a quantity: {known}, or none"),
                    );
                }
                let folders: Vec<String> = match column("chapter") {
                    None => vec![String::new()],
                    Some(_) => folders(chapter).collect(),
                };
                if folders.is_empty() {
                    report.fault(chapter.offset, "the row links to no chapter");
                }
                for (offset, tex) in formulas(&row[signs]) {
                    // What LaTeX is not understood is reported where the formula is printed.
                    let Some(formula) = convert(tex) else { continue };
                    let only = formula.elements().next().filter(|_| formula.elements().count() == 1);
                    let Some(key) = only.and_then(key) else {
                        report.fault(offset, format!("`{tex}` is not one letter, perhaps with a subscript"));
                        continue;
                    };
                    if let Some(folder) = folders.first().filter(|folder| !folder.is_empty()) {
                        letters.shown.insert((page.path.clone(), offset), folder.clone());
                    }
                    for folder in &folders {
                        letters.meanings.insert((folder.clone(), key.clone()), quantity);
                    }
                }
            }
        }
        letters
    }

    /// Notes the tables of symbols of a page, each of which means what its chapter does.
    pub(super) fn note_symbols(&mut self, page: &Page, items: &[PlacedItem<'_>]) {
        let mut chapter = None;
        for placed in items {
            match (&placed.item, &chapter) {
                (Item::Heading { label, .. }, _) => {
                    let section = label.as_ref().filter(|label| label.kind == LabelKind::Section);
                    let name = section.and_then(|label| label.name.strip_prefix("symbols-"));
                    chapter = name.map(str::to_owned);
                }
                (Item::Table { table, .. }, Some(folder)) => {
                    let formulas = table.rows.iter().flatten().flat_map(formulas);
                    let places = formulas.map(|(offset, _)| (page.path.clone(), offset));
                    self.shown.extend(places.map(|place| (place, folder.clone())));
                }
                _ => {}
            }
        }
    }

    /// The folder of the chapter whose letters a page uses at a place.
    pub(super) fn folder<'a>(&'a self, path: &'a str, offset: usize) -> &'a str {
        let shown = self.shown.get(&(path.to_owned(), offset));
        shown.map_or_else(|| path.split('/').next().unwrap_or(path), String::as_str)
    }

    /// Gives each letter of a formula its colour. A letter has it together with its hat, dot, prime and subscript,
    /// but without its exponent; what stands in a subscript is a name and has none of its own.
    pub(super) fn colour(&self, formula: &mut Element, folder: &str) {
        match (self.meaning(formula, folder), &*formula.name) {
            (Some(meaning), "msubsup") => {
                for place in 0..2 {
                    if let (Some(quantity), Some(part)) = (meaning, formula.element_mut(place)) {
                        part.set("class", &quantity.class());
                    }
                }
                self.colour_at(2, formula, folder);
            }
            (Some(Some(quantity)), _) => formula.set("class", &quantity.class()),
            (Some(None), _) => {}
            (None, "msub" | "msubsup") if !formula.elements().next().is_some_and(|base| base.is("mo")) => {
                self.colour_at(0, formula, folder);
                self.colour_at(2, formula, folder);
            }
            (None, _) => (0..formula.children.len()).for_each(|place| self.colour_at(place, formula, folder)),
        }
    }

    fn colour_at(&self, place: usize, formula: &mut Element, folder: &str) {
        if let Some(part) = formula.element_mut(place) {
            self.colour(part, folder);
        }
    }

    /// What a sign stands for; `None` if the tables do not say.
    fn meaning(&self, sign: &Element, folder: &str) -> Option<Option<Quantity>> {
        let parts: Vec<&Element> = sign.elements().collect();
        let wrapped = match &*sign.name {
            "mover" => sign.attribute("accent").is_some(),
            "msup" => parts.get(1).is_some_and(|exponent| exponent.text().chars().all(|c| c == '′')),
            _ => false,
        };
        if wrapped {
            return self.meaning(parts.first()?, folder);
        }
        let full = key(sign)?;
        let letter = full.split('_').next().unwrap_or(&full).to_owned();
        let mut keys = [&full, &letter].into_iter().flat_map(|key| [(folder, key), ("", key)]);
        keys.find_map(|(folder, key)| self.meanings.get(&(folder.to_owned(), key.clone()))).copied()
    }
}

/// A letter as it is found in the tables: `ω`, `ω_0`; not its hat.
fn key(sign: &Element) -> Option<String> {
    let parts: Vec<&Element> = sign.elements().collect();
    match (&*sign.name, &*parts) {
        ("mi", _) => Some(sign.text()).filter(|text| text.chars().count() == 1),
        // An upright letter.
        ("mrow", [space, letter]) if space.is("mspace") && letter.is("mi") => key(letter),
        ("mover", [letter, _]) if sign.attribute("accent").is_some() => key(letter),
        ("msub" | "msubsup", [letter, subscript, ..]) => {
            let letter = key(letter).filter(|letter| !letter.contains('_'))?;
            Some(format!("{letter}_{}", subscript.text()))
        }
        _ => None,
    }
}

/// The letters of a formula, each with its subscript and none with its hat: `ω`, `ω_0`. A vector has the letter of its
/// length.
pub(super) fn all(formula: &Element, found: &mut BTreeSet<String>) {
    let parts: Vec<&Element> = formula.elements().collect();
    let (key, is_indexed) = (key(formula), matches!(&*formula.name, "msub" | "msubsup"));
    if let Some(key) = key.as_ref().filter(|key| key.starts_with(char::is_alphabetic)) {
        found.insert(key.chars().map(not_bold).collect());
    }
    match (key, is_indexed) {
        (Some(_), true) => parts.iter().skip(2).for_each(|part| all(part, found)),
        (Some(_), false) => {}
        // What is lowered is a name.
        (None, true) => [0, 2].iter().filter_map(|&at| parts.get(at)).for_each(|part| all(part, found)),
        (None, false) => parts.iter().for_each(|part| all(part, found)),
    }
}

/// The letter that a bold one is in plain type.
fn not_bold(c: char) -> char {
    let is_bold =
        matches!(u32::from(c), 0x1d400..=0x1d433 | 0x1d468..=0x1d49b | 0x1d6a8..=0x1d6e1 | 0x1d71c..=0x1d755);
    if is_bold { c.nfkc().next().unwrap_or(c) } else { c }
}

/// The text of a cell.
fn words(cell: &Cell<'_>) -> String {
    let text = cell.words.iter().filter_map(|(event, _)| match event {
        Event::Text(text) => Some(text.as_ref()),
        _ => None,
    });
    text.collect::<String>().trim().to_owned()
}

/// The formulas of a cell, with their places.
fn formulas<'a>(cell: &'a Cell<'_>) -> impl Iterator<Item = (usize, &'a str)> {
    cell.words.iter().filter_map(|(event, offset)| match event {
        Event::InlineMath(tex) => Some((*offset, tex.as_ref())),
        _ => None,
    })
}

/// The folders of the chapters to which a cell has links.
fn folders(cell: &Cell<'_>) -> impl Iterator<Item = String> {
    cell.words.iter().filter_map(|(event, _)| match event {
        Event::Start(Tag::Link { dest_url, .. }) => dest_url.split('/').next().map(str::to_owned),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use crate::book::Page;
    use crate::fault::Faults;
    use crate::print::maths::Maths;
    use crate::read::scan::scan;

    const TABLES: &str = "# C\n\n| quantity | colour | letters |\n|---|---|---|\n\
        | angular velocity | orange | $\\boldsymbol\\omega$, $\\omega$, $\\Omega$ |\n| momentum | green | $L$ |\n\n\
        | chapter | letters | meaning | colour |\n|---|---|---|---|\n\
        | [One](one/index.md) | $\\omega_0$, $L$ | other things | none |\n| [Two](two/index.md) | $n$ | a spin | orange |\n";

    fn maths(tables: &str) -> (Maths, Vec<String>) {
        let page = Page::new("book", "conventions.md".to_owned(), None, None, tables.to_owned());
        let mut faults = Faults::default();
        let items = scan(&page, &mut Faults::default());
        let maths = Maths::new(std::slice::from_ref(&page), &[items], &mut faults);
        (maths, faults.sorted().iter().map(ToString::to_string).collect())
    }

    #[test]
    fn a_letter_has_its_colour_with_all_that_hangs_on_it_but_its_exponent() {
        for (folder, tex, expected) in [
            ("three", r"\boldsymbol\omega + x", "s:𝝎+x"),
            ("three", r"\dot\omega_3", "s:ω˙3"),
            ("three", r"\omega_3^2L", "s:ωs:32m:L"),
            ("three", r"\Omega'", "s:Ω′"),
            ("three", r"L^2", "m:L2"),
            ("three", r"e^{i\Omega t}", "eis:Ωt"),
            ("three", r"\theta_L", "θL"),
            ("three", r"\frac{L}{\sqrt{\omega_1}}", "m:Ls:ω1"),
            ("three", r"\int_0^{\Omega}", "∫0s:Ω"),
            // A chapter may mean something else.
            ("one", r"\omega_0\omega_1nL\hat L", "ω0s:ω1nLLˆ"),
            ("two", r"\omega_0nL", "s:ω0s:nm:L"),
        ] {
            // The class of each coloured part, shortened, stands before the part: `s:ω`.
            let mathml = maths(TABLES).0.inline_html(tex, folder).unwrap();
            let marked = mathml.replace(" class=\"q-spin\">", ">s:").replace(" class=\"q-momentum\">", ">m:");
            let text: String =
                marked.split('<').filter_map(|part| part.split_once('>')).map(|(_, text)| text).collect();
            assert_eq!(text, expected, "{tex}");
        }
    }

    #[test]
    fn a_table_of_symbols_shows_them_as_its_chapter_means_them() {
        let text = format!(
            "{TABLES}\n### One {{#sec:symbols-one}}\n\n| symbol | meaning |\n|---|---|\n| $L$ | a length |\n"
        );
        let place = text.rfind("$L$").unwrap();
        let conventions = Page::new("book", "conventions.md".to_owned(), None, None, TABLES.to_owned());
        let symbols = Page::new("book", "symbols.md".to_owned(), None, None, text);
        let pages = [conventions, symbols];
        let mut faults = Faults::default();
        let scans: Vec<_> = pages.iter().map(|page| scan(page, &mut Faults::default())).collect();
        let maths = Maths::new(&pages, &scans, &mut faults);
        assert_eq!((maths.folder("symbols.md", place), faults.sorted().len()), ("one", 0));
        assert_eq!(maths.folder("symbols.md", place + 1), "symbols.md");
        assert_eq!(maths.folder("conventions.md", place), "conventions.md");
    }

    #[test]
    fn faults_of_the_tables_have_their_lines() {
        let table = TABLES
            .replace("| green |", "| greenish |")
            .replace("$n$", "$n + 1$")
            .replace("[Two](two/index.md)", "Two");
        assert_eq!(
            maths(&table).1,
            [
                "error: book/conventions.md:6: `greenish` is no colour of a quantity: blue, orange, green, pink, purple, or none",
                "error: book/conventions.md:11: `n + 1` is not one letter, perhaps with a subscript",
                "error: book/conventions.md:11: the row links to no chapter",
            ]
        );
    }
}

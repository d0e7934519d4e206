//! Letters in the colours of what they stand for.
//!
//! Two tables of the page of conventions say which: readers have them as a key, and the press reads the same. One
//! begins with the column `quantity`, one with `chapter`; a column `letters` holds formulas, and a column
//! `colour` the name of a colour or `none`. A table below a heading `{#sec:symbols-chapter}` shows letters as that
//! chapter means them.

use super::MathsFault;
use super::tree::Element;
use crate::book::Page;
use crate::fault::Faults;
use crate::scan::options;
use pulldown_cmark::{Event, Parser, Tag, TagEnd};
use std::collections::HashMap;
use std::ops::Range;

/// The page that has the tables.
const CONVENTIONS: &str = "conventions.md";

/// A quantity that has a colour: what authors call it, and the hue of figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Quantity {
    pub(crate) role: &'static str,
    pub(crate) hue: &'static str,
}

/// All of them, as figures colour them.
pub(crate) const QUANTITIES: [Quantity; 5] = [
    Quantity { role: "body", hue: "blue" },
    Quantity { role: "spin", hue: "orange" },
    Quantity { role: "momentum", hue: "green" },
    Quantity { role: "contact", hue: "pink" },
    Quantity { role: "force", hue: "purple" },
];

impl Quantity {
    /// The quantity that authors call so in `[words]{.role}`; if there is none, what there is.
    pub(crate) fn of_role(role: &str) -> Result<Self, String> {
        let known = || QUANTITIES.map(|quantity| quantity.role).join(", ");
        let found = QUANTITIES.into_iter().find(|quantity| quantity.role == role);
        found.ok_or_else(|| format!("no words are coloured as `{role}`, but as {}", known()))
    }

    /// The class of a page's elements that are to have its colour.
    pub(crate) fn class(self) -> String {
        format!("q-{}", self.role)
    }
}

/// What letters stand for, in the whole book and in its chapters.
#[derive(Debug, Default)]
pub(super) struct Letters {
    /// A chapter's folder, or nothing for all of them; a letter, perhaps with its subscript → its quantity, or none.
    meanings: HashMap<(String, String), Option<Quantity>>,
    /// Where on the page of conventions formulas show what a chapter means, and its folder.
    shown: HashMap<usize, String>,
}

/// A row of a table: for each cell its place, its words, its formulas with their places, the targets of its links.
#[derive(Debug, Default)]
struct Cell {
    place: usize,
    words: String,
    formulas: Vec<(Range<usize>, String)>,
    targets: Vec<String>,
}

impl Letters {
    /// Reads the tables; `convert` makes MathML of LaTeX.
    pub(super) fn read(
        pages: &[Page],
        convert: impl Fn(&str) -> Result<Element, MathsFault>,
        faults: &mut Faults,
    ) -> Self {
        let mut letters = Self::default();
        let Some(page) = pages.iter().find(|page| page.path == CONVENTIONS) else {
            return letters;
        };
        let mut report = page.reporter(faults);
        for (section, table) in tables(&page.text) {
            if let Some(folder) = section.strip_prefix("sec:symbols-") {
                let formulas = table.iter().flatten().flat_map(|cell| &cell.formulas);
                letters.shown.extend(formulas.map(|(range, _)| (range.start, folder.to_owned())));
            }
            let Some((head, rows)) = table.split_first() else {
                continue;
            };
            let column = |name: &str| head.iter().position(|cell| cell.words.trim() == name);
            let (Some(colours), Some(signs)) = (column("colour"), column("letters")) else {
                continue;
            };
            for row in rows {
                let (colour, chapter) = (&row[colours], &row[0]);
                let name = colour.words.trim();
                let quantity = QUANTITIES.into_iter().find(|quantity| quantity.hue == name);
                if quantity.is_none() && name != "none" {
                    let known = QUANTITIES.map(|quantity| quantity.hue).join(", ");
                    report.fault(
                        colour.place,
                        format!("`{name}` is no colour of a quantity: {known}, or none"),
                    );
                }
                let folders: Vec<String> = match column("chapter") {
                    None => vec![String::new()],
                    Some(_) => {
                        let folder = |target: &String| target.split('/').next().unwrap_or("").to_owned();
                        chapter.targets.iter().map(folder).collect()
                    }
                };
                if folders.is_empty() {
                    report.fault(chapter.place, "the row links to no chapter");
                }
                for (range, tex) in &row[signs].formulas {
                    // What LaTeX is not understood is reported where the formula is printed.
                    let Ok(formula) = convert(tex) else {
                        continue;
                    };
                    let only = formula.elements().next().filter(|_| formula.elements().count() == 1);
                    let Some(key) = only.and_then(key) else {
                        report.fault(
                            range.start,
                            format!("`{tex}` is not one letter, perhaps with a subscript"),
                        );
                        continue;
                    };
                    if let Some(folder) = folders.first().filter(|folder| !folder.is_empty()) {
                        letters.shown.insert(range.start, folder.clone());
                    }
                    for folder in &folders {
                        letters.meanings.insert((folder.clone(), key.clone()), quantity);
                    }
                }
            }
        }
        letters
    }

    /// The folder of the chapter whose letters a page uses at a place.
    pub(super) fn folder<'a>(&'a self, path: &'a str, offset: usize) -> &'a str {
        let shown = self.shown.get(&offset).filter(|_| path == CONVENTIONS);
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

/// The tables of a page: the label of the heading above, and rows of cells, the head first.
fn tables(text: &str) -> Vec<(String, Vec<Vec<Cell>>)> {
    let mut tables: Vec<(String, Vec<Vec<Cell>>)> = Vec::new();
    let (mut in_cell, mut section) = (false, String::new());
    for (event, range) in Parser::new_ext(text, options()).into_offset_iter() {
        match &event {
            Event::Start(Tag::Heading { id, .. }) => section = id.as_deref().unwrap_or("").to_owned(),
            Event::Start(Tag::Table(_)) => tables.push((section.clone(), Vec::new())),
            Event::Start(Tag::TableHead | Tag::TableRow) => {
                if let Some((_, table)) = tables.last_mut() {
                    table.push(Vec::new());
                }
            }
            Event::End(TagEnd::TableCell) => in_cell = false,
            Event::Start(Tag::TableCell) => {
                in_cell = true;
                if let Some(row) = tables.last_mut().and_then(|(_, table)| table.last_mut()) {
                    row.push(Cell { place: range.start, ..Cell::default() });
                }
            }
            _ => {}
        }
        let row = tables.last_mut().and_then(|(_, table)| table.last_mut());
        let Some(cell) = row.and_then(|row| row.last_mut()).filter(|_| in_cell) else {
            continue;
        };
        match event {
            Event::Text(words) => cell.words.push_str(&words),
            Event::InlineMath(tex) => cell.formulas.push((range, tex.into_string())),
            Event::Start(Tag::Link { dest_url, .. }) => cell.targets.push(dest_url.into_string()),
            _ => {}
        }
    }
    tables
}

#[cfg(test)]
mod tests {
    use crate::book::Page;
    use crate::fault::Faults;
    use crate::maths::Maths;

    const TABLES: &str = "# C\n\n| quantity | colour | letters |\n|---|---|---|\n\
        | angular velocity | orange | $\\boldsymbol\\omega$, $\\omega$, $\\Omega$ |\n| momentum | green | $L$ |\n\n\
        | chapter | letters | meaning | colour |\n|---|---|---|---|\n\
        | [One](one/index.md) | $\\omega_0$, $L$ | other things | none |\n| [Two](two/index.md) | $n$ | a spin | orange |\n";

    fn maths(tables: &str) -> (Maths, Vec<String>) {
        let page = Page::new("book", "conventions.md".to_owned(), None, None, tables.to_owned());
        let mut faults = Faults::default();
        let maths = Maths::new(&[page], &mut faults);
        (maths, faults.sorted().iter().map(ToString::to_string).collect())
    }

    /// A formula with the class of each coloured part, shortened, before the part: `s:ω`.
    fn coloured(tex: &str, folder: &str) -> String {
        let mathml = maths(TABLES).0.inline_html(tex, folder).unwrap();
        let marked = mathml.replace(" class=\"q-spin\">", ">s:").replace(" class=\"q-momentum\">", ">m:");
        let mut text = String::new();
        let mut in_tag = false;
        for c in marked.chars() {
            match c {
                '<' => in_tag = true,
                '>' => in_tag = false,
                c if !in_tag => text.push(c),
                _ => {}
            }
        }
        text
    }

    #[test]
    fn a_letter_has_its_colour_with_all_that_hangs_on_it_but_its_exponent() {
        for (tex, expected) in [
            (r"\boldsymbol\omega + x", "s:𝝎+x"),
            (r"\dot\omega_3", "s:ω˙3"),
            (r"\omega_3^2L", "s:ωs:32m:L"),
            (r"\Omega'", "s:Ω′"),
            (r"L^2", "m:L2"),
            (r"e^{i\Omega t}", "eis:Ωt"),
            (r"\theta_L", "θL"),
            (r"\frac{L}{\sqrt{\omega_1}}", "m:Ls:ω1"),
            (r"\int_0^{\Omega}", "∫0s:Ω"),
        ] {
            assert_eq!(coloured(tex, "three"), expected, "{tex}");
        }
    }

    #[test]
    fn a_chapter_may_mean_something_else() {
        assert_eq!(coloured(r"\omega_0\omega_1nL\hat L", "one"), "ω0s:ω1nLLˆ");
        assert_eq!(coloured(r"\omega_0nL", "two"), "s:ω0s:nm:L");
    }

    #[test]
    fn a_table_of_symbols_shows_them_as_its_chapter_means_them() {
        let text = format!(
            "{TABLES}\n### One {{#sec:symbols-one}}\n\n| symbol | meaning |\n|---|---|\n| $L$ | a length |\n"
        );
        let place = text.rfind("$L$").unwrap();
        let (maths, faults) = maths(&text);
        assert_eq!((maths.folder("conventions.md", place), faults.len()), ("one", 0));
        assert_eq!(maths.folder("conventions.md", place + 1), "conventions.md");
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

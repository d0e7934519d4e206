//! A page in our dialect becomes a page that mdBook understands.

mod bibliography;
#[cfg(test)]
mod cases;
mod equations;
mod figures;
mod headings;
mod notes;
mod references;
mod snippets;
mod tables;
mod words;

use crate::assets::Rendered;
use crate::book::{Page, resolve};
use crate::fault::Faults;
use crate::print::code_links::{self, CodePlace};
use crate::print::maths::Maths;
use crate::print::{nonbreaking, scenes};
use crate::read::items::{Item, Label, PlacedItem};
use crate::read::label_syntax;
use crate::read::labels::Registry;
use crate::read::scan::scan;
use bibliography::Cited;
use html::escaped;
use live::numbers::BLANK;
use references::Reference;
use std::collections::BTreeMap;

/// Renders all pages with what is `drawn`; the faults if there are any. `code` holds the files whose comments
/// cite labels, with their text.
///
/// # Errors
/// Every fault of every page, and every label that code cites and no page defines.
pub(crate) fn render(
    pages: &[Page],
    drawn: &Rendered,
    library: &str,
    code: &[(String, String)],
) -> Result<Vec<String>, Faults> {
    let mut faults = Faults::default();
    let scans: Vec<Vec<PlacedItem<'_>>> = pages.iter().map(|page| scan(page, &mut faults)).collect();
    scenes::check(&drawn.scenes, &mut faults);
    let registry = Registry::build(pages, &scans, drawn, &mut faults);
    check_citations_in_code(&registry, code, &mut faults);
    let maths = Maths::new(pages, &scans, &mut faults);
    let places = code_links::places(library, drawn.book.code.first().copied().unwrap_or_default(), code);
    let mut cited = Cited::new();
    let chapters = chapters(pages, &scans);
    let mut live = 0;
    let mut printed = Vec::with_capacity(pages.len());
    for (index, (page, found)) in pages.iter().zip(&scans).enumerate() {
        let mut printer = Printer {
            page,
            index,
            registry: &registry,
            maths: &maths,
            drawn,
            library,
            places: &places,
            chapters: &chapters,
            cited: &mut cited,
            notes: Vec::new(),
            live: &mut live,
            faults: &mut faults,
        };
        printed.push(printer.page(found));
    }
    registry.check_citations(&cited, &mut faults);
    if !faults.is_empty() {
        return Err(faults);
    }
    let titles = bibliography::titles(pages, &scans);
    let whole = |(page, parts): (&Page, Vec<Part>)| -> String {
        let text = |part| match part {
            Part::Text(text) => text,
            Part::CitedIn(entry) => bibliography::cited_in(&entry, page, pages, &titles, &cited),
        };
        parts.into_iter().map(text).collect()
    };
    Ok(pages.iter().zip(printed).map(whole).collect())
}

/// The number of each chapter → the path and the title of its first page.
type Chapters = BTreeMap<u32, (String, String)>;

fn chapters(pages: &[Page], scans: &[Vec<PlacedItem<'_>>]) -> Chapters {
    let first = pages.iter().zip(scans).filter(|(page, _)| page.part.is_none());
    let entry = |(page, items): (&Page, &Vec<PlacedItem<'_>>)| {
        let title = items.iter().find_map(|placed| match &placed.item {
            Item::Heading { level: 1, plain, .. } => Some(plain.clone()),
            _ => None,
        });
        Some((page.chapter?, (page.path.clone(), title?)))
    };
    first.filter_map(entry).collect()
}

/// Adds a fault for each label that a comment cites and no page defines.
fn check_citations_in_code(registry: &Registry, code: &[(String, String)], faults: &mut Faults) {
    for (file, text) in code {
        for (n, line) in text.lines().enumerate() {
            for (_, label) in label_syntax::cited(line) {
                if let Err(message) = registry.find(&label) {
                    faults.add(file, n + 1, message);
                }
            }
        }
    }
}

/// A part of a printed page.
enum Part {
    Text(String),
    /// Where the pages stand that cite this entry of the bibliography. They are known when all are printed.
    CitedIn(Label),
}

struct Printer<'a, 'f> {
    page: &'a Page,
    /// Its order among the pages.
    index: usize,
    registry: &'a Registry,
    maths: &'a Maths,
    drawn: &'a Rendered,
    library: &'a str,
    /// Where the library's comments name equations.
    places: &'a BTreeMap<String, Vec<CodePlace>>,
    chapters: &'a Chapters,
    /// Every label that some page mentions.
    cited: &'f mut Cited,
    /// The notes of the page whose marks are printed, in their order.
    notes: Vec<String>,
    /// How many snippets with live numbers are printed.
    live: &'f mut usize,
    faults: &'f mut Faults,
}

impl Printer<'_, '_> {
    fn fault(&mut self, offset: usize, message: impl Into<String>) {
        self.page.reporter(self.faults).fault(offset, message);
    }

    /// The page with every item replaced; everything else stands as it was written.
    fn page(&mut self, items: &[PlacedItem<'_>]) -> Vec<Part> {
        let text = &self.page.text;
        let mut parts = Vec::new();
        let mut out = String::with_capacity(text.len() * 4);
        let mut done = 0;
        for placed in items {
            let range = placed.range.clone();
            if range.start < done {
                // Inside something already replaced: a caption, which is printed by other means.
                if let Item::Link { target } = &placed.item {
                    self.check_link(target, range.start);
                }
                continue;
            }
            if let Item::CitationEnd(label) = &placed.item {
                out.push_str(&text[done..range.start]);
                done = range.start;
                parts.extend([Part::Text(std::mem::take(&mut out)), Part::CitedIn(label.clone())]);
                continue;
            }
            let replacement = match &placed.item {
                item @ Item::Heading { level: 1, .. } => {
                    let heading = self.item(item, range.start);
                    self.title(heading.as_deref().unwrap_or(&text[range.clone()])).or(heading)
                }
                item => self.item(item, range.start),
            };
            let Some(replacement) = replacement else { continue };
            let (head, tail) = match &placed.item {
                Item::InlineMaths { .. } => nonbreaking::around(&text[done..range.start], &text[range.end..]),
                _ => (0, 0),
            };
            let (start, end) = (range.start - head, range.end + tail);
            out.push_str(&text[done..start]);
            out.push_str(&nonbreaking::tied(&text[start..range.start], &replacement, &text[range.end..end]));
            done = end;
        }
        out.push_str(&text[done..]);
        parts.push(Part::Text(out));
        parts
    }

    fn item(&mut self, item: &Item<'_>, offset: usize) -> Option<String> {
        match item {
            Item::InlineMaths { tex } => self.inline(tex, offset + 1),
            Item::DisplayMaths { tex, label } => self.display(tex, label.as_ref(), offset),
            Item::Figure { label, caption } => self.figure(label, caption),
            Item::Scene { label, caption } => self.scene(label, caption, offset),
            Item::SettingStart(setting) => Some(self.setting(setting, offset)),
            Item::SettingEnd => Some("</a>".to_owned()),
            Item::Table { table, caption } => Some(self.table(table, caption)),
            Item::LibraryTable { name, caption } => self.library_table(name, caption, offset),
            Item::Heading { level, label: Some(label), title, .. } => self.heading(*level, label, title),
            Item::Mention(mention) => {
                let before = &self.page.text[..offset];
                let Reference { words, target, title } = self.mention(mention, before, offset)?;
                let title = if title.is_empty() { title } else { format!(" \"{}\"", escaped(&title)) };
                Some(format!("{}[{words}]({target}{title})", self.way_back(mention)))
            }
            Item::MarkedStart(class) => Some(format!("<span class=\"{class}\">")),
            Item::MarkedEnd => Some("</span>".to_owned()),
            Item::Blank => Some(BLANK.to_owned()),
            Item::Dash => Some("–\u{2060}".to_owned()),
            Item::NoteMark(name) => Some(self.note_mark(name)),
            Item::Note(note) => Some(self.note(note)),
            Item::NoteDefinition => Some(String::new()),
            Item::Snippet { code } => Some(self.snippet(code, offset)),
            Item::Citation { label, short } => Some(bibliography::name(label, short)),
            Item::Link { target } => {
                self.check_link(target, offset);
                None
            }
            Item::Picture { file } => {
                let path = resolve(&self.page.path, file);
                if !path.is_some_and(|path| self.drawn.beside.contains(&path)) {
                    self.fault(
                        offset,
                        format!(
                            "there is no picture {file}: its path is counted from the folder of the page"
                        ),
                    );
                }
                None
            }
            Item::Heading { label: None, .. } | Item::Hint | Item::Id(_) | Item::CitationEnd(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assets::{Figure, Scene};
    use live::{Control, Form, Preset, Reading};

    const SCENE: live::Scene = live::Scene {
        file: "book/a/scene.rs",
        name: "plate",
        title: "",
        description: "",
        question: "Why $x$?",
        size: [[1.0; 2]; 2],
        view: Some([-0.5, 0.25]),
        still: 0.5,
        controls: &[
            Control::slider("spin", "spin, $x$", [-1.0, 4.0, 0.1], "rad/s", 2.0),
            Control::log_slider("drag", "drag", [1e-3, 1.0], "", 0.01),
            Control::choice("camera", "camera", &["room", "body"]),
            Control::switch("cones", "cones", true),
            Control::button("kick", "Kick"),
        ],
        presets: &[Preset { words: "a ball", settings: &[("spin", 1.0), ("drag", 0.1)] }],
        readings: &[Reading { words: "wobbles", form: Form::Fixed(0), unit: "" }],
        symbols: &[],
        start: |_| Err("it never starts".into()),
    };

    /// What becomes of one page, which is chapter 1. It may show a scene and a figure.
    pub(super) fn printed(text: &str, is_still: bool) -> String {
        let [source, svg, standalone] = ["", "<svg></svg>", ""].map(str::to_owned);
        let scene = Scene {
            page: "a.md",
            live: SCENE,
            svg: svg.clone(),
            longest: String::new(),
            sounds: false,
            lowest_eye: -std::f64::consts::FRAC_PI_2,
        };
        let figure = Figure { id: "fig:x".to_owned(), source, svg, standalone, place: "column".to_owned() };
        let mut drawn = Rendered { is_still, ..Rendered::default() };
        if text.contains("scene:") {
            drawn.scenes.push(scene);
        }
        if text.contains("fig:") {
            drawn.figures.push(figure);
        }
        let page = Page::new("book", "a.md".to_owned(), Some(1), None, text.to_owned());
        let printed = render(&[page], &drawn, "", &[]);
        printed.unwrap_or_else(|faults| panic!("{:?}", faults.sorted())).remove(0)
    }

    #[test]
    fn what_stands_on_a_page_is_printed() {
        for (name, page, parts) in cases::CASES {
            let whole = printed(page, false);
            let mut rest = whole.as_str();
            for part in *parts {
                let part =
                    part.replace('\'', "\"").replace('~', BLANK).replace("⟨x⟩", "<math><mi>x</mi></math>");
                let (_, behind) =
                    rest.split_once(&part).unwrap_or_else(|| panic!("{name}: no {part} in {whole}"));
                rest = behind;
            }
            for figure in whole.split("<figure").skip(1).filter_map(|rest| rest.split("</figure>").next()) {
                assert!(!figure.contains("\n\n"), "{name}: Markdown would read on in {figure}");
            }
        }
        let (_, scene, _) = cases::CASES.last().unwrap();
        let still = printed(scene, true);
        assert!(!still.contains("panel") && !still.contains("data-module") && still.contains("<svg></svg>"));
    }

    #[test]
    fn a_page_comes_out_as_expected() {
        let page = "# A\n\n## Motion {#sec:motion}\n\n$$\na\n$$ {#eq:x source=19}\n\n$$\nb\n$$\n\n\
                    $$\nc\n$$ {#eq:y source=\"20 21\" corrected}\n\nSee @eq:y, @source:19, @sec:motion and `@eq:z`.\n";
        let expected = "<p class=\"kicker\" style=\"--chapter: 1; --sections: 0\">Chapter 1</p>\n\n# A\n\n## Motion {#sec-motion}\n\n\
            <div class=\"equation numbered\" id=\"eq-x\"><span id=\"source-19\"></span><div class=\"formula\"><math display=\"block\"><mi>a</mi></math></div>\
            <div class=\"marks\"><details class=\"origin\"><summary aria-label=\"Where (1.1) is from\"></summary>\
            <p><span class=\"source\">is (19) of the source</span></p></details><a class=\"number\" href=\"#eq-x\">(1.1)</a></div></div>\n\n\
            <div class=\"equation\"><div class=\"formula\"><math display=\"block\"><mi>b</mi></math></div></div>\n\n\
            <div class=\"equation numbered\" id=\"eq-y\"><span id=\"source-20\"></span><span id=\"source-21\"></span><div class=\"formula\"><math display=\"block\"><mi>c</mi></math></div>\
            <div class=\"marks\"><details class=\"origin\"><summary aria-label=\"Where (1.2) is from\"></summary>\
            <p><span class=\"source\">corrects (20), (21) of the source</span></p></details><a class=\"number\" href=\"#eq-y\">(1.2)</a></div></div>\n\n\
            See [(1.2)](a.md#eq-y), [source\u{a0}19](a.md#source-19), [§1.1](a.md#sec-motion \"Motion\") and `@eq:z`.\n";
        assert_eq!(printed(page, false), expected);
    }
}

//! All labels of the book: who defines them, and which number each one has.

mod partners;

use crate::assets::Rendered;
use crate::book::Page;
use crate::fault::{Faults, nearest};
use crate::read::items::{Item, Label, LabelKind, PlacedItem};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// How ids begin that mdBook puts on each page.
const MDBOOKS_IDS: [&str; 5] = ["mdbook-", "fa-", "footnote-", "fr-", "print-button"];

/// A label with all that a reference to it needs.
#[derive(Debug, Clone)]
pub(crate) struct LabelEntry {
    /// Path of the page that defines it.
    pub(crate) page: String,
    /// Where it is defined, for messages: `book/page.md`, 80.
    file: String,
    line: usize,
    /// `1.9`; that of a section is the number of the section of level two that it is or stands in, that of a chapter's
    /// title the chapter's. Empty for citations, and outside of chapters.
    pub(crate) number: String,
    /// The title of a section or an exercise, the short name of a citation.
    pub(crate) title: String,
}

/// The labels of a book.
#[derive(Debug, Default)]
pub(crate) struct Registry {
    entries: HashMap<Label, LabelEntry>,
    /// Number in the source → the label of our equation.
    sources: BTreeMap<u32, Label>,
    /// Path of a page → the ids on it that a link may lead to.
    anchors: HashMap<String, BTreeSet<String>>,
    /// Path of a page of a chapter → how many sections the chapter has before it.
    sections: HashMap<String, u32>,
}

impl Registry {
    /// Collects and numbers the labels of all pages.
    pub(crate) fn build(
        pages: &[Page],
        scans: &[Vec<PlacedItem<'_>>],
        drawn: &Rendered,
        faults: &mut Faults,
    ) -> Self {
        let mut registry = Self::default();
        let mut counters: HashMap<(u32, LabelKind), u32> = HashMap::new();
        for (page, items) in pages.iter().zip(scans) {
            let mut slugs = Slugs::default();
            let mut claimed: Vec<(String, usize)> = Vec::new();
            let chapter = page.chapter.unwrap_or_default();
            let before = counters.entry((chapter, LabelKind::Section)).or_default();
            registry.sections.insert(page.path.clone(), *before);
            for placed in items {
                let line = page.lines.at(placed.range.start);
                if let Item::Heading { level: 2, label, .. } = &placed.item
                    && label.as_ref().is_none_or(|label| label.kind == LabelKind::Section)
                {
                    *counters.entry((chapter, LabelKind::Section)).or_default() += 1;
                }
                let (label, title) = match &placed.item {
                    Item::DisplayMaths { label: Some(equation), .. } => (&equation.label, String::new()),
                    Item::Figure { label, .. } | Item::Scene { label, .. } => (label, String::new()),
                    Item::Citation { label, short } => (label, (*short).to_owned()),
                    Item::Heading { label: Some(label), title, .. } => (label, (*title).to_owned()),
                    Item::Heading { label: None, id: Some(id), .. } => {
                        claimed.push(((*id).to_owned(), line));
                        continue;
                    }
                    Item::Heading { plain, .. } => {
                        slugs.heading(plain);
                        continue;
                    }
                    Item::Id(id) => {
                        claimed.push((id.clone(), line));
                        continue;
                    }
                    Item::NoteMark(name) => {
                        claimed.push((format!("noteref-{name}"), line));
                        claimed.push((format!("note-{name}"), line));
                        continue;
                    }
                    _ => continue,
                };
                let number = match &placed.item {
                    Item::Heading { level, .. } if label.kind == LabelKind::Section => {
                        section(page, *level, counters[&(chapter, LabelKind::Section)])
                    }
                    _ => registry.number(label, page, line, &mut counters, faults),
                };
                let entry =
                    LabelEntry { page: page.path.clone(), file: page.file.clone(), line, number, title };
                if let Some(first) = registry.entries.get(label) {
                    let place = format!("{}:{}", first.file, first.line);
                    let message = format!("the label {} is already defined at {place}", label.written());
                    faults.add(&page.file, line, message);
                    continue;
                }
                claimed.push((label.id(), line));
                registry.entries.insert(label.clone(), entry);
                if let Item::DisplayMaths { label: Some(equation), .. } = &placed.item {
                    for &number in &equation.source {
                        if let Some(other) = registry.sources.insert(number, label.clone()) {
                            let message = format!(
                                "equation ({number}) of the source already belongs to {}",
                                other.written()
                            );
                            faults.add(&page.file, line, message);
                        } else {
                            claimed.push((format!("source-{number}"), line));
                        }
                    }
                }
                if let Item::Figure { .. } = &placed.item {
                    let figure = drawn.figures.iter().find(|figure| figure.id == label.written());
                    let ids: BTreeSet<String> = figure.iter().flat_map(|figure| figure.ids()).collect();
                    claimed.extend(ids.into_iter().map(|id| (id, line)));
                }
            }
            for (id, line) in claimed {
                if MDBOOKS_IDS.iter().any(|prefix| id.starts_with(prefix)) {
                    faults.add(&page.file, line, format!("the id `{id}` is one of mdBook's own"));
                }
                if !slugs.ids.insert(id.clone()) {
                    faults.add(&page.file, line, format!("the id `{id}` stands on the page already"));
                }
            }
            registry.anchors.insert(page.path.clone(), slugs.ids);
        }
        registry.check_partners(pages, scans, drawn, faults);
        registry
    }

    /// The number of a newly met label. Solutions take that of their exercise when they are printed.
    fn number(
        &self,
        label: &Label,
        page: &Page,
        line: usize,
        counters: &mut HashMap<(u32, LabelKind), u32>,
        faults: &mut Faults,
    ) -> String {
        if !matches!(
            label.kind,
            LabelKind::Equation | LabelKind::Figure | LabelKind::Scene | LabelKind::Exercise
        ) {
            return String::new();
        }
        let Some(chapter) = page.chapter else {
            if label.kind == LabelKind::Figure {
                return String::new(); // it stands there without a number
            }
            faults.add(
                &page.file,
                line,
                format!("{} needs a number, but this page belongs to no numbered chapter", label.written()),
            );
            return String::new();
        };
        let counter = counters.entry((chapter, label.kind)).or_insert(0);
        *counter += 1;
        format!("{chapter}.{counter}")
    }

    /// How many sections the chapter of a page has before it.
    pub(crate) fn sections_before(&self, page: &Page) -> u32 {
        self.sections.get(&page.path).copied().unwrap_or_default()
    }

    /// The entry of a label, or what to say about its absence.
    pub(crate) fn find(&self, label: &Label) -> Result<&LabelEntry, String> {
        self.entries.get(label).ok_or_else(|| {
            let names =
                self.entries.keys().filter(|known| known.kind == label.kind).map(|known| known.name.as_str());
            let near = hint(label.kind.prefix(), nearest(&label.name, names));
            format!("no page defines the label {}{near}", label.written())
        })
    }

    /// The label and the entry of our equation that has this number in the source.
    pub(crate) fn find_source(&self, number: u32) -> Result<&LabelEntry, String> {
        let label = self
            .sources
            .get(&number)
            .ok_or_else(|| format!("no equation carries the source's number ({number})"))?;
        self.find(label)
    }

    /// Adds a fault for each entry of the bibliography that no page cites.
    pub(crate) fn check_citations<T>(&self, cited: &BTreeMap<Label, T>, faults: &mut Faults) {
        for (label, entry) in &self.entries {
            if label.kind == LabelKind::Citation && !cited.contains_key(label) {
                let message = format!("nothing cites {}: cite it as @{0}, or take it out", label.written());
                faults.add(&entry.file, entry.line, message);
            }
        }
    }

    /// Whether `path` is a page of the book.
    pub(crate) fn has_page(&self, path: &str) -> bool {
        self.anchors.contains_key(path)
    }

    /// Whether the page at `path` has an element with this id.
    pub(crate) fn has_anchor(&self, path: &str, id: &str) -> bool {
        self.anchors.get(path).is_some_and(|ids| ids.contains(id))
    }
}

/// The number of a section on a page of a chapter that has come to its section `count`.
fn section(page: &Page, level: u8, count: u32) -> String {
    match (page.chapter, &page.part) {
        (Some(chapter), None) if level == 1 => chapter.to_string(),
        (Some(chapter), _) if level > 1 => format!("{chapter}.{count}"),
        _ => String::new(),
    }
}

fn hint(prefix: &str, near: Option<&str>) -> String {
    near.map_or_else(String::new, |near| format!("; is {prefix}:{near} meant?"))
}

/// The ids of a page, formed as mdBook forms them.
#[derive(Debug, Default)]
struct Slugs {
    ids: BTreeSet<String>,
    /// The last number behind each heading that stands on the page more than once.
    counts: HashMap<String, u32>,
}

impl Slugs {
    /// The id that mdBook gives to a heading: letters, digits, `_` and `-` in lower case, blanks as hyphens.
    fn heading(&mut self, title: &str) {
        let kept = title.trim().chars().filter_map(|c| match c {
            c if c.is_alphanumeric() || c == '_' || c == '-' => Some(c.to_lowercase().to_string()),
            c if c.is_whitespace() => Some("-".to_owned()),
            _ => None,
        });
        let base: String = kept.collect();
        let mut id = base.clone();
        let count = self.counts.entry(base.clone()).or_default();
        while !self.ids.insert(id) {
            *count += 1;
            id = format!("{base}-{count}");
        }
    }
}

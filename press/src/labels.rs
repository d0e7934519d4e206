//! All labels of the book: who defines them, and which number each one has.

use crate::book::Page;
use crate::fault::{Faults, nearest};
use crate::page::{Item, Kind, Label, Mention, Placed};
use crate::rendered::{Figure, Rendered};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// How ids begin that mdBook puts on each page.
const MDBOOKS_IDS: [&str; 5] = ["mdbook-", "fa-", "footnote-", "fr-", "print-button"];

/// A label with all that a reference to it needs.
#[derive(Debug, Clone)]
pub(crate) struct Entry {
    /// Path of the page that defines it.
    pub(crate) page: String,
    /// Where it is defined, for messages: `book/page.md`, 80.
    file: String,
    line: usize,
    /// `1.9`; empty for sections and citations.
    pub(crate) number: String,
    /// The title of a section or an exercise, the short name of a citation.
    pub(crate) title: String,
}

/// The labels of a book.
#[derive(Debug, Default)]
pub(crate) struct Registry {
    entries: HashMap<Label, Entry>,
    /// Number in the source → the label of our equation.
    sources: BTreeMap<u32, Label>,
    /// Path of a page → the ids on it that a link may lead to.
    anchors: HashMap<String, BTreeSet<String>>,
}

/// Where every equation of the source has a row, if the book has such a page.
const LEDGER: &str = "ledger.md";

/// Adds a fault for each number of the source that a page gives to an equation and the ledger does not list.
fn check_ledger(pages: &[Page], scans: &[Vec<Placed<'_>>], faults: &mut Faults) {
    let Some(at) = pages.iter().position(|page| page.path == LEDGER) else {
        return;
    };
    let listed = scans[at].iter().filter_map(|placed| match placed.item {
        Item::Mention(Mention::Source(number)) => Some(number),
        _ => None,
    });
    let listed: BTreeSet<u32> = listed.collect();
    for (page, items) in pages.iter().zip(scans) {
        for placed in items {
            let Item::DisplayMaths { label: Some(equation), .. } = &placed.item else {
                continue;
            };
            for &number in equation.source.iter().filter(|number| !listed.contains(number)) {
                let line = page.lines.at(placed.range.start);
                faults.add(
                    &page.file,
                    line,
                    format!("the ledger has no row for equation ({number}) of the source"),
                );
            }
        }
    }
}

impl Registry {
    /// Collects and numbers the labels of all pages.
    pub(crate) fn build(
        pages: &[Page],
        scans: &[Vec<Placed<'_>>],
        drawn: &Rendered,
        faults: &mut Faults,
    ) -> Self {
        let figures = &drawn.figures;
        let mut registry = Self::default();
        let mut counters: HashMap<(u32, Kind), u32> = HashMap::new();
        for (page, items) in pages.iter().zip(scans) {
            let mut slugs = Slugs::default();
            let mut claimed: Vec<(String, usize)> = Vec::new();
            for placed in items {
                let line = page.lines.at(placed.range.start);
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
                let number = registry.number(label, page, line, &mut counters, faults);
                let entry = Entry { page: page.path.clone(), file: page.file.clone(), line, number, title };
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
                    let figure = figures.iter().find(|figure| figure.id == label.written());
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
        registry.check_figures(pages, scans, figures, faults);
        registry.check_scenes(pages, scans, drawn, faults);
        registry.check_exercises(pages, scans, faults);
        check_ledger(pages, scans, faults);
        registry
    }

    /// The number of a newly met label. Solutions take that of their exercise when they are printed.
    fn number(
        &self,
        label: &Label,
        page: &Page,
        line: usize,
        counters: &mut HashMap<(u32, Kind), u32>,
        faults: &mut Faults,
    ) -> String {
        if !matches!(label.kind, Kind::Equation | Kind::Figure | Kind::Scene | Kind::Exercise) {
            return String::new();
        }
        let Some(chapter) = page.chapter else {
            if label.kind == Kind::Figure {
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

    fn check_figures(
        &self,
        pages: &[Page],
        scans: &[Vec<Placed<'_>>],
        figures: &[Figure],
        faults: &mut Faults,
    ) {
        for (page, items) in pages.iter().zip(scans) {
            for placed in items {
                let Item::Figure { label, .. } = &placed.item else {
                    continue;
                };
                if !figures.iter().any(|figure| figure.id == label.written()) {
                    let ids = figures.iter().map(|figure| figure.id.trim_start_matches("fig:"));
                    let message = format!(
                        "there is no figure {}{}",
                        label.written(),
                        hint("fig", nearest(&label.name, ids))
                    );
                    faults.add(&page.file, page.lines.at(placed.range.start), message);
                }
            }
        }
        for figure in figures {
            let mut ids = BTreeSet::new();
            for id in figure.ids() {
                if !ids.insert(id.clone()) {
                    let message = format!(
                        "the id `{id}` stands twice in the figure {}: has it two curves of one name?",
                        figure.id
                    );
                    faults.add(&figure.source(), 0, message);
                }
            }
            let name = figure.id.trim_start_matches("fig:").to_owned();
            if !self.entries.contains_key(&Label { kind: Kind::Figure, name }) {
                faults.add(
                    &figure.source(),
                    0,
                    format!("the figure {} is drawn, but no page shows it", figure.id),
                );
            }
        }
    }

    fn check_scenes(&self, pages: &[Page], scans: &[Vec<Placed<'_>>], drawn: &Rendered, faults: &mut Faults) {
        for (page, items) in pages.iter().zip(scans) {
            for (n, placed) in items.iter().enumerate() {
                let Item::Scene { label, .. } = &placed.item else {
                    continue;
                };
                let mut fault = |message| faults.add(&page.file, page.lines.at(placed.range.start), message);
                let Some(scene) = drawn.scenes.iter().find(|scene| scene.name == label.name) else {
                    let names = drawn.scenes.iter().map(|scene| scene.name.as_str());
                    let near = hint("scene", nearest(&label.name, names));
                    fault(format!("there is no scene {}{near}", label.written()));
                    continue;
                };
                if page.path.split('/').next() != Some(&scene.chapter) || page.part.is_some() {
                    fault(format!("the scene {} opens the chapter in {}", label.written(), scene.chapter));
                } else if items[..n].iter().any(|above| matches!(above.item, Item::DisplayMaths { .. })) {
                    fault(format!("the scene {} belongs above the first equation", label.written()));
                }
            }
        }
        for scene in &drawn.scenes {
            if !self.entries.contains_key(&Label { kind: Kind::Scene, name: scene.name.clone() }) {
                let message = format!("no page shows this scene: ![Caption.](scene:{})", scene.name);
                faults.add(&scene.source(), 0, message);
            }
        }
    }

    fn check_exercises(&self, pages: &[Page], scans: &[Vec<Placed<'_>>], faults: &mut Faults) {
        for (page, items) in pages.iter().zip(scans) {
            for (n, placed) in items.iter().enumerate() {
                let Item::Heading { label: Some(label), level, .. } = &placed.item else {
                    continue;
                };
                let line = page.lines.at(placed.range.start);
                let (partner, what) = match label.kind {
                    Kind::Exercise => (Kind::Solution, "solution"),
                    Kind::Solution => (Kind::Exercise, "exercise"),
                    _ => continue,
                };
                let partner = Label { kind: partner, name: label.name.clone() };
                if !self.entries.contains_key(&partner) {
                    faults.add(
                        &page.file,
                        line,
                        format!("{} has no {what} {}", label.written(), partner.written()),
                    );
                }
                let until_next = items[n + 1..]
                    .iter()
                    .take_while(|next| !matches!(&next.item, Item::Heading { level: l, .. } if l <= level));
                if label.kind == Kind::Exercise
                    && !until_next.into_iter().any(|p| matches!(p.item, Item::Hint))
                {
                    let message =
                        format!("{} has no hint: <details> with <summary>Hint</summary>", label.written());
                    faults.add(&page.file, line, message);
                }
            }
        }
    }

    /// The entry of a label, or what to say about its absence.
    pub(crate) fn find(&self, label: &Label) -> Result<&Entry, String> {
        self.entries.get(label).ok_or_else(|| {
            let names =
                self.entries.keys().filter(|known| known.kind == label.kind).map(|known| known.name.as_str());
            let near = hint(label.kind.prefix(), nearest(&label.name, names));
            format!("no page defines the label {}{near}", label.written())
        })
    }

    /// The label and the entry of our equation that has this number in the source.
    pub(crate) fn find_source(&self, number: u32) -> Result<&Entry, String> {
        let label = self
            .sources
            .get(&number)
            .ok_or_else(|| format!("no equation carries the source's number ({number})"))?;
        self.find(label)
    }

    /// Adds a fault for each entry of the bibliography that no page cites.
    pub(crate) fn check_citations<T>(&self, cited: &BTreeMap<Label, T>, faults: &mut Faults) {
        for (label, entry) in &self.entries {
            if label.kind == Kind::Citation && !cited.contains_key(label) {
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

//! The bibliography: the names of its entries, and links from each to where it is cited.

use super::Printer;
use crate::book::{Page, relative};
use crate::read::items::{Item, Label, LabelKind, Mention, PlacedItem};
use html::escaped;
use std::collections::BTreeMap;

/// Label → the pages that mention it, each once, by their order, and whether an id stands where the page does.
pub(super) type Cited = BTreeMap<Label, Vec<(usize, bool)>>;

/// What links to the pages are called where there is little room: `Chapter 4`, `Chapter 4 · Exercises`, `Preface`.
pub(super) fn titles(pages: &[Page], scans: &[Vec<PlacedItem<'_>>]) -> Vec<String> {
    let title = |items: &[PlacedItem<'_>]| {
        items.iter().find_map(|placed| match &placed.item {
            Item::Heading { level: 1, plain, .. } => Some(plain.clone()),
            _ => None,
        })
    };
    let short = |(page, items): (&Page, &Vec<PlacedItem<'_>>)| match (page.chapter, &page.part) {
        (Some(chapter), None) => format!("Chapter {chapter}"),
        (Some(chapter), Some(part)) => format!("Chapter {chapter} · {part}"),
        (None, _) => title(items).unwrap_or_else(|| page.path.clone()),
    };
    pages.iter().zip(scans).map(short).collect()
}

/// The name of an entry, in front of it.
pub(super) fn name(label: &Label, short: &str) -> String {
    format!("<span class=\"cite\" id=\"{}\">&#91;{}&#93;</span>", label.id(), escaped(short))
}

/// Links to where an entry on this page is cited.
pub(super) fn cited_in(
    entry: &Label,
    page: &Page,
    pages: &[Page],
    titles: &[String],
    cited: &Cited,
) -> String {
    let link = |(order, &(index, has_id)): (usize, &(usize, bool))| {
        let target = relative(&page.path, &pages[index].path);
        let id = if has_id { format!("#from-{}-{order}", entry.name) } else { String::new() };
        format!("[{}]({target}{id})", titles[index])
    };
    let links: Vec<String> = cited.get(entry).into_iter().flatten().enumerate().map(link).collect();
    format!(" <span class=\"citing\">Cited in {}.</span>", links.join(", "))
}

impl Printer<'_, '_> {
    /// An id for the way back from the bibliography, where a page first cites an entry.
    pub(super) fn way_back(&mut self, mention: &Mention) -> String {
        let Mention::Label(label) = mention else { return String::new() };
        let order = self.cited.get(label).map_or(0, Vec::len);
        match self.cited.get_mut(label).and_then(|pages| pages.last_mut()) {
            Some((_, has_id @ false)) if label.kind == LabelKind::Citation => {
                *has_id = true;
                format!("<span id=\"from-{}-{}\"></span>", label.name, order - 1)
            }
            _ => String::new(),
        }
    }
}

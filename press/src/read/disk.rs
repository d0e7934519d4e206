//! The pages as they stand on disk, read without mdBook.

use crate::book::{Page, part, slashed, text};
use crate::fault::{Faults, Lines};
use crate::read::summary;
use mdbook_summary::SummaryItem;
use std::path::Path;

/// The pages under `root`, and the folder that they stand in.
///
/// # Errors
/// Faults of book.toml and SUMMARY.md, and of files that cannot be read.
pub fn from_disk(root: &Path) -> Result<(String, Vec<Page>), Faults> {
    let mut faults = Faults::default();
    let pages = source(root, &mut faults).and_then(|source| {
        let summary = summary::read(root, &source, &mut faults)?;
        let mut pages = Vec::new();
        let mut part = None;
        for item in
            summary.prefix_chapters.iter().chain(&summary.numbered_chapters).chain(&summary.suffix_chapters)
        {
            match item {
                SummaryItem::PartTitle(title) => part = Some(title),
                item => read(item, part, root, &source, &mut pages, &mut faults),
            }
        }
        Some((source, pages))
    });
    pages.filter(|_| faults.is_empty()).ok_or(faults)
}

/// The folder of the pages, as book.toml names it.
pub(crate) fn source(root: &Path, faults: &mut Faults) -> Option<String> {
    const CONFIGURATION: &str = "book.toml";
    let text = text(root, CONFIGURATION, faults)?;
    match text.parse::<toml::Table>() {
        Ok(config) => {
            let source = config.get("book").and_then(|book| book.get("src")).and_then(toml::Value::as_str);
            Some(source.unwrap_or("src").to_owned())
        }
        Err(error) => {
            let line = error.span().map_or(0, |span| Lines::of(&text).at(span.start));
            faults.add(CONFIGURATION, line, error.message().to_owned());
            None
        }
    }
}

/// Adds the pages of an item, of which the first may open a chapter in a `title`d part of the book.
fn read(
    item: &SummaryItem,
    title: Option<&String>,
    root: &Path,
    source: &str,
    pages: &mut Vec<Page>,
    faults: &mut Faults,
) {
    let SummaryItem::Link(link) = item else { return };
    if let Some(location) = &link.location {
        let path = slashed(location);
        let chapter = link.number.as_ref().and_then(|number| number.first().copied());
        let part = link.number.as_ref().and_then(|number| part(number, &link.name));
        if let Some(text) = text(root, &format!("{source}/{path}"), faults) {
            let part_of_book = title.filter(|_| chapter.is_some()).cloned();
            pages.push(Page { part_of_book, ..Page::new(source, path, chapter, part, text) });
        }
    }
    for nested in &link.nested_items {
        read(nested, None, root, source, pages, faults);
    }
}

//! The pages of the book as the press sees them, whoever loaded them.

use crate::fault::Faults;
use mdbook_preprocessor::book::{Book, BookItem};
use std::fs;
use std::path::Path;

/// One page.
#[derive(Debug, Clone)]
pub struct Page {
    /// Its path in the book's source folder, with forward slashes: `laundromat/index.md`.
    pub path: String,
    /// The file as faults name it: `book/laundromat/index.md`.
    pub file: String,
    /// The number of the chapter that it belongs to; `None` for unnumbered pages.
    pub chapter: Option<u32>,
    /// Its Markdown.
    pub text: String,
}

/// The pages that mdBook handed over, in reading order.
pub fn from_mdbook(book: &Book, source: &str) -> Vec<Page> {
    let mut pages = Vec::new();
    collect(&book.items, source, &mut pages);
    pages
}

fn collect(items: &[BookItem], source: &str, pages: &mut Vec<Page>) {
    for item in items {
        let BookItem::Chapter(chapter) = item else {
            continue;
        };
        if let Some(path) = &chapter.source_path {
            let path = slashed(path);
            pages.push(Page {
                file: format!("{source}/{path}"),
                path,
                chapter: chapter.number.as_ref().and_then(|number| number.first().copied()),
                text: chapter.content.clone(),
            });
        }
        collect(&chapter.sub_items, source, pages);
    }
}

/// The pages as they stand on disk under `root`, read without mdBook.
///
/// # Errors
/// Faults of book.toml and SUMMARY.md, and of files that cannot be read.
pub fn from_disk(root: &Path) -> Result<Vec<Page>, Faults> {
    let mut faults = Faults::default();
    let source = match fs::read_to_string(root.join("book.toml")).map(|text| text.parse::<toml::Table>()) {
        Ok(Ok(config)) => config
            .get("book")
            .and_then(|book| book.get("src"))
            .and_then(toml::Value::as_str)
            .unwrap_or("src")
            .to_owned(),
        Ok(Err(error)) => {
            faults.add("book.toml", 0, error.message().to_owned());
            return Err(faults);
        }
        Err(error) => {
            faults.add("book.toml", 0, format!("cannot be read: {error}"));
            return Err(faults);
        }
    };
    let summary_file = format!("{source}/SUMMARY.md");
    let summary = fs::read_to_string(root.join(&summary_file))
        .map_err(|error| error.to_string())
        .and_then(|text| mdbook_summary::parse_summary(&text).map_err(|error| format!("{error:#}")));
    let summary = match summary {
        Ok(summary) => summary,
        Err(error) => {
            faults.add(&summary_file, 0, error);
            return Err(faults);
        }
    };
    let mut pages = Vec::new();
    let items =
        summary.prefix_chapters.iter().chain(&summary.numbered_chapters).chain(&summary.suffix_chapters);
    for item in items {
        read(item, root, &source, &mut pages, &mut faults);
    }
    if faults.is_empty() { Ok(pages) } else { Err(faults) }
}

fn read(
    item: &mdbook_summary::SummaryItem,
    root: &Path,
    source: &str,
    pages: &mut Vec<Page>,
    faults: &mut Faults,
) {
    let mdbook_summary::SummaryItem::Link(link) = item else {
        return;
    };
    if let Some(location) = &link.location {
        let path = slashed(location);
        let file = format!("{source}/{path}");
        match fs::read_to_string(root.join(&file)) {
            Ok(text) => {
                let chapter = link.number.as_ref().and_then(|number| number.first().copied());
                pages.push(Page { path, file, chapter, text });
            }
            Err(error) => {
                faults.add(&file, 0, format!("SUMMARY.md names it, but it cannot be read: {error}"));
            }
        }
    }
    for nested in &link.nested_items {
        read(nested, root, source, pages, faults);
    }
}

fn slashed(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}

/// The path that leads from the page at `from` to the page at `to`, both in the source folder.
pub(crate) fn relative(from: &str, to: &str) -> String {
    let from: Vec<&str> = from.split('/').collect();
    let to: Vec<&str> = to.split('/').collect();
    let folders = from.len() - 1;
    let common = from[..folders].iter().zip(&to[..to.len() - 1]).take_while(|(a, b)| a == b).count();
    let mut path = "../".repeat(folders - common);
    path.push_str(&to[common..].join("/"));
    path
}

/// The path of a link `target` as seen from the page at `from`; `None` if it leaves the source folder.
pub(crate) fn resolve(from: &str, target: &str) -> Option<String> {
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in target.split('/') {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop()?;
            }
            name => parts.push(name),
        }
    }
    Some(parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_lead_from_page_to_page() {
        assert_eq!(relative("a/index.md", "a/solutions.md"), "solutions.md");
        assert_eq!(relative("a/index.md", "bibliography.md"), "../bibliography.md");
        assert_eq!(relative("preface.md", "a/index.md"), "a/index.md");
        assert_eq!(resolve("a/index.md", "../b/x.md").as_deref(), Some("b/x.md"));
        assert_eq!(resolve("a.md", "../b.md"), None);
    }
}

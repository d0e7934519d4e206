//! A book without its solutions, for a class: `solutions = false` below `[preprocessor.press]` in book.toml, or
//! `MDBOOK_PREPROCESSOR__PRESS__SOLUTIONS=false` around a command.
//!
//! What is left out are whole pages: those on which a solution stands. They are checked and tested all the same.

use crate::book::{resolve, slashed};
use anyhow::{Context as _, Result};
use mdbook_preprocessor::book::{Book, BookItem};
use mdbook_preprocessor::config::Config;

/// The key in book.toml.
const KEY: &str = "preprocessor.press.solutions";

/// Whether the book is to be printed without its solutions.
///
/// # Errors
/// If the value is neither `true` nor `false`.
pub(crate) fn are_hidden(config: &Config) -> Result<bool> {
    let shown = config.get::<bool>(KEY).with_context(|| format!("{KEY} of book.toml is true or false"))?;
    Ok(shown == Some(false))
}

/// Whether a solution stands on a page: `## {#sol:peak}`, as it is written or as it is printed.
pub(crate) fn stand_on(text: &str) -> bool {
    text.lines().any(|line| line.starts_with('#') && (line.contains("{#sol:") || line.contains("{#sol-")))
}

/// Takes the pages with solutions out of a book; their paths in the site.
pub(crate) fn leave_out(book: &mut Book) -> Vec<String> {
    let mut hidden = Vec::new();
    retain(&mut book.items, &mut hidden);
    hidden
}

fn retain(items: &mut Vec<BookItem>, hidden: &mut Vec<String>) {
    items.retain_mut(|item| {
        let BookItem::Chapter(chapter) = item else { return true };
        retain(&mut chapter.sub_items, hidden);
        let Some(path) = chapter.path.as_ref().filter(|_| stand_on(&chapter.content)) else {
            return true;
        };
        hidden.push(slashed(&path.with_extension("html")));
        false
    });
}

/// The page at `path` of the site without links to pages that are `hidden`.
pub(crate) fn unlinked(html: &str, path: &str, hidden: &[String]) -> String {
    html::unlinked(html, |target| {
        let page = target.split(['#', '?']).next().unwrap_or_default();
        resolve(path, page).is_some_and(|page| hidden.contains(&page))
    })
}

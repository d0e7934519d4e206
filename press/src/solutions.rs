//! A book without its solutions, for a class: `solutions = false` below `[preprocessor.press]` in book.toml, or
//! `MDBOOK_PREPROCESSOR__PRESS__SOLUTIONS=false` around a command.
//!
//! What is left out are whole pages: those on which a solution stands. They are checked and tested all the same.

use crate::book::{relative, slashed};
use mdbook_preprocessor::book::{Book, BookItem};
use mdbook_preprocessor::config::Config;
use std::path::Path;

/// The key in book.toml.
const KEY: &str = "preprocessor.press.solutions";

/// Whether the book is to be printed without its solutions.
///
/// # Errors
/// If the value is neither `true` nor `false`.
pub(crate) fn are_hidden(config: &Config) -> Result<bool, String> {
    match config.get::<bool>(KEY) {
        Ok(shown) => Ok(shown == Some(false)),
        Err(error) => Err(format!("{KEY} of book.toml is true or false ({error:#})")),
    }
}

/// Whether the book in this folder is printed without its solutions, as book.toml and the environment say.
///
/// # Errors
/// As for [`are_hidden`], and if book.toml cannot be read.
pub(crate) fn are_hidden_in(root: &Path) -> Result<bool, String> {
    let mut config = Config::from_disk(root.join("book.toml")).map_err(|error| format!("{error:#}"))?;
    config.update_from_env().map_err(|error| format!("{error:#}"))?;
    are_hidden(&config)
}

/// Whether a solution stands on a page: `## {#sol:peak}`, as it is written or as it is printed.
pub(crate) fn stand_on(text: &str) -> bool {
    text.lines().any(|line| line.starts_with('#') && (line.contains("{#sol:") || line.contains("{#sol-")))
}

/// Takes the pages with solutions out of a book, and what leads to them out of its other pages.
pub(crate) fn leave_out(book: &mut Book) {
    let mut hidden = Vec::new();
    retain(&mut book.items, &mut hidden);
    unlink(&mut book.items, &hidden);
}

fn retain(items: &mut Vec<BookItem>, hidden: &mut Vec<String>) {
    items.retain_mut(|item| {
        let BookItem::Chapter(chapter) = item else { return true };
        retain(&mut chapter.sub_items, hidden);
        let Some(path) = chapter.source_path.as_ref().filter(|_| stand_on(&chapter.content)) else {
            return true;
        };
        hidden.push(slashed(path));
        false
    });
}

fn unlink(items: &mut [BookItem], hidden: &[String]) {
    for item in items {
        let BookItem::Chapter(chapter) = item else { continue };
        if let Some(path) = &chapter.source_path {
            let path = slashed(path);
            for page in hidden {
                chapter.content = unlinked(&chapter.content, &relative(&path, page));
            }
        }
        unlink(&mut chapter.sub_items, hidden);
    }
}

/// A printed page without the lines that do nothing but lead to `page`; other links to it are their words.
fn unlinked(text: &str, page: &str) -> String {
    let way = format!("<p class=\"turn\"><a href=\"{page}#");
    let lines = text.split_inclusive('\n').filter(|line| !line.starts_with(&way));
    let mut text: String = lines.collect();
    for end in ["#", ")"] {
        let middle = format!("]({page}{end}");
        while let Some(at) = text.find(&middle) {
            let (Some(start), Some(length)) = (text[..at].rfind('['), text[at..].find(')')) else { break };
            text.replace_range(at..=at + length, "");
            text.remove(start);
        }
    }
    // In tables and captions links are HTML already.
    for end in ["#", "\""] {
        let start = format!("<a href=\"{page}{end}");
        while let Some(at) = text.find(&start) {
            let (Some(open), Some(close)) = (text[at..].find('>'), text[at..].find("</a>")) else { break };
            text.replace_range(at + close..at + close + "</a>".len(), "");
            text.replace_range(at..=at + open, "");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_leads_to_a_page_that_is_left_out_goes() {
        let page = "# Exercises\n\n## Exercise 1. A {#ex-a}\n\n<p class=\"turn\"><a href=\"solutions.md#sol-a\">Solution 1</a></p>\n\n\
                    See [Solution 1](solutions.md#sol-a), [all](solutions.md) and [b](b.md).\n\n\
                    <td><a href=\"solutions.md#source-7\">(1.7)</a></td><td><a href=\"b.md\">b</a></td>\n";
        assert_eq!(
            unlinked(page, "solutions.md"),
            "# Exercises\n\n## Exercise 1. A {#ex-a}\n\n\nSee Solution 1, all and [b](b.md).\n\n\
             <td>(1.7)</td><td><a href=\"b.md\">b</a></td>\n"
        );
        assert!(stand_on("# S\n\n## {#sol:a}\n") && !stand_on("See @sol:a, `{#sol:a}`.\n"));
    }
}

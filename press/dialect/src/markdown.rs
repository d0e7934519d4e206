//! Markdown as the press reads it, and the snippets of Rust in it.
//!
//! The press and the build script of the pages' crate read by it, so that a page prints the snippets that are tested,
//! and runs them.

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag};
use std::ops::Range;

/// Markdown as mdBook reads it, and mathematics, which it does not.
pub fn options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_SMART_PUNCTUATION
        | Options::ENABLE_MATH
}

/// A fenced block of Rust.
#[derive(Debug, PartialEq, Eq)]
pub struct Snippet<'a> {
    /// The bytes of the page that it takes up, fences included.
    pub range: Range<usize>,
    /// The line of the page on which it opens, counted from one.
    pub line: usize,
    /// Its lines between the fences, without the margin of a list or quotation around it.
    pub code: Vec<&'a str>,
}

/// The snippets of a page, wherever they stand.
pub fn snippets(page: &str) -> Vec<Snippet<'_>> {
    let events = Parser::new_ext(page, options()).into_offset_iter();
    let found = events.filter_map(|(event, range)| match event {
        Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) if is_rust(&info) => {
            let above = &page[..range.start];
            let lines: Vec<&str> = page[range.clone()].lines().collect();
            let margin = column(page, range.start);
            let code = lines[code_lines(&lines)].iter().map(|line| line.get(margin..).unwrap_or_default());
            Some(Snippet { line: above.matches('\n').count() + 1, code: code.collect(), range })
        }
        _ => None,
    });
    found.collect()
}

/// Whether a block whose opening fence says this is Rust: `rust`, `rust,should_panic`.
pub fn is_rust(info: &str) -> bool {
    info.split([',', ' ', '\t']).next() == Some("rust")
}

/// Which lines of a fenced block are its code.
pub fn code_lines(block: &[&str]) -> Range<usize> {
    let fenced = block.last().is_some_and(|line| line.trim_start_matches([' ', '>']).starts_with(['`', '~']));
    1..block.len() - usize::from(fenced && block.len() > 1)
}

/// How many bytes a place stands from the beginning of its line.
pub fn column(page: &str, place: usize) -> usize {
    place - page[..place].rfind('\n').map_or(0, |at| at + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snippets_are_found_wherever_they_stand() {
        let page = "```rust,should_panic\na();\n```\n\n- item\n\n  ```rust\n  b();\n  ```\n\n> ~~~rust\n> c();\n> ~~~\n\n\
                    ````text\n```rust\nno();\n```\n````\n\n```rusty\nno();\n```\n\n~~~rust\n```\n";
        let found: Vec<_> = snippets(page).into_iter().map(|s| (s.line, s.code)).collect();
        assert_eq!(found, [(1, vec!["a();"]), (7, vec!["b();"]), (11, vec!["c();"]), (25, vec![])]);
    }
}

//! Links by reference: what is referred to is defined.

use crate::fault::Reporter;
use dialect::markdown::options;
use pulldown_cmark::{BrokenLink, Event, LinkType, Parser};
use std::ops::Range;

/// What is said of a target with a blank, which Markdown reads as none.
pub(crate) const BLANK: &str = "a target with a blank stands in angle brackets: `[words](<a page.md>)`";

/// Whether the target that a text begins with, up to its bracket, has a blank that ends it too early.
pub(crate) fn has_blank(text: &str) -> bool {
    let target = text.split([')', '\n']).next().unwrap_or_default().trim();
    target.contains(' ') && !target.starts_with('<') && !target.contains('"')
}

/// The events of a page; what Markdown would print as it is written, because it is defined nowhere, is a fault.
pub(crate) fn parsed<'a>(text: &'a str, report: &mut Reporter<'_>) -> Vec<(Event<'a>, Range<usize>)> {
    let mut undefined = Vec::new();
    let callback = |link: BrokenLink<'a>| {
        undefined.push((link.span.start, link.link_type, link.reference));
        None
    };
    let parser = Parser::new_with_broken_link_callback(text, options(), Some(callback));
    let events: Vec<_> = parser.into_offset_iter().collect();
    for (offset, kind, name) in undefined {
        if kind != LinkType::Shortcut {
            report.fault(
                offset,
                format!("`[{name}]` is defined nowhere: write the target, [words](page.md), or `\\[` for a bracket"),
            );
        }
    }
    for (event, range) in &events {
        // A bracket that ends a run of text has its parenthesis in the next.
        let end = range.end + usize::from(text[range.end..].starts_with('('));
        if matches!(event, Event::Text(_))
            && let Some(at) = text[range.start..end].find("](").map(|at| range.start + at)
            && !text[..at].ends_with('\\')
        {
            let message = if has_blank(&text[at + 2..]) {
                BLANK
            } else {
                "`](` was left as it is: no link and no figure begins before it, perhaps since a footnote stands in its \
                 words; that of a figure stands behind it, `![Caption.](fig:name)[^note]`"
            };
            report.fault(at, message);
        }
    }
    events
}

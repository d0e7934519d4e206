//! Links by reference and footnotes: what is referred to is defined, once, and what is defined is referred to.

use crate::fault::Reporter;
use crate::scan::options;
use pulldown_cmark::{BrokenLink, CowStr, Event, LinkType, Parser, Tag};
use std::collections::HashMap;
use std::ops::Range;

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
    footnotes(text, &events, report);
    events
}

fn footnotes(text: &str, events: &[(Event<'_>, Range<usize>)], report: &mut Reporter<'_>) {
    let mut defined: HashMap<&CowStr<'_>, usize> = HashMap::new();
    for (event, range) in events {
        if let Event::Start(Tag::FootnoteDefinition(name)) = event
            && defined.insert(name, range.start).is_some()
        {
            report.fault(range.start, format!("the footnote `[^{name}]` is defined already"));
        }
    }
    for (event, range) in events {
        match event {
            Event::FootnoteReference(name) => _ = defined.remove(name),
            // A reference that is still text.
            Event::Text(_) => {
                for (at, _) in text[range.clone()].match_indices('[') {
                    let at = range.start + at;
                    let escaped = text[..at].ends_with('\\');
                    let name = text[at..].strip_prefix("[^").filter(|_| !escaped);
                    let end = name.and_then(|name| name.find([']', '[', '\n']));
                    if let (Some(name), Some(end)) = (name, end)
                        && name[end..].starts_with(']')
                    {
                        report.fault(
                            at,
                            format!("the footnote `[^{}]` is defined nowhere on this page", &name[..end]),
                        );
                    }
                }
            }
            _ => {}
        }
    }
    for (name, offset) in defined {
        report.fault(offset, format!("nothing refers to the footnote `[^{name}]`"));
    }
}

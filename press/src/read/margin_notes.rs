//! Notes in the margin, written as footnotes: each is referred to once and defined once.

use crate::fault::Reporter;
use crate::read::items::{Note, Words};
use crate::read::label_syntax;
use pulldown_cmark::{CowStr, Event, Tag, TagEnd};
use std::collections::{BTreeMap, HashSet};
use std::ops::Range;

type Events<'a> = [(Event<'a>, Range<usize>)];

/// The notes that a page defines, by their names; reports those that are no notes.
pub(crate) fn defined<'a>(
    text: &str,
    events: &Events<'a>,
    report: &mut Reporter<'_>,
) -> BTreeMap<String, Note<'a>> {
    let mut notes: BTreeMap<String, Note<'a>> = BTreeMap::new();
    for (n, (event, range)) in events.iter().enumerate() {
        let Event::Start(Tag::FootnoteDefinition(name)) = event else { continue };
        if !label_syntax::is_name(name) {
            report.fault(
                range.start,
                format!("the name of the footnote `[^{name}]` may hold only lower-case letters, digits and hyphens"),
            );
        }
        let body = events[n + 1..].iter();
        let body = body.take_while(|(event, _)| !matches!(event, Event::End(TagEnd::FootnoteDefinition)));
        let note =
            Note { name: name.to_string(), words: words(body, name, range, report), offset: range.start };
        if notes.insert(note.name.clone(), note).is_some() {
            report.fault(range.start, format!("the footnote `[^{name}]` is defined already"));
        }
    }
    references(text, events, &notes, report);
    notes
}

/// Whether a text is nothing but marks of notes, `[^one][^two]`, or empty.
pub(crate) fn only_marks(text: &str) -> bool {
    text.is_empty()
        || (text.starts_with("[^")
            && text.ends_with(']')
            && !text.contains(char::is_whitespace)
            && text.matches('[').count() == text.matches("[^").count()
            && text.matches(']').count() == text.matches("][^").count() + 1)
}

/// The words of a note, which are one paragraph.
fn words<'a, 'e>(
    body: impl Iterator<Item = &'e (Event<'a>, Range<usize>)>,
    name: &CowStr<'_>,
    range: &Range<usize>,
    report: &mut Reporter<'_>,
) -> Words<'a>
where
    'a: 'e,
{
    let mut words = Vec::new();
    let (mut paragraphs, mut foreign) = (0, false);
    for (event, place) in body {
        match event {
            Event::Start(Tag::Paragraph) => paragraphs += 1,
            Event::End(TagEnd::Paragraph) => {}
            Event::Start(Tag::Emphasis | Tag::Strong | Tag::Strikethrough | Tag::Link { .. })
            | Event::End(TagEnd::Emphasis | TagEnd::Strong | TagEnd::Strikethrough | TagEnd::Link)
            | Event::Text(_)
            | Event::Code(_)
            | Event::InlineMath(_)
            | Event::SoftBreak => words.push((event.clone(), place.start)),
            _ => foreign = true,
        }
    }
    if foreign || paragraphs > 1 {
        report.fault(
            range.start,
            format!(
                "the footnote `[^{name}]` becomes a note in the margin: one paragraph of words, with $…$, \
                 references and links"
            ),
        );
    } else if words.is_empty() {
        report.fault(range.start, format!("the footnote `[^{name}]` has no words"));
    }
    words
}

/// Reports each footnote that is referred to and not defined, twice, or never.
fn references(
    text: &str,
    events: &Events<'_>,
    notes: &BTreeMap<String, Note<'_>>,
    report: &mut Reporter<'_>,
) {
    let mut seen: HashSet<&str> = HashSet::new();
    for (event, range) in events {
        match event {
            Event::FootnoteReference(name) if seen.insert(name) => {}
            Event::FootnoteReference(name) => report.fault(
                range.start,
                format!("a second reference to the footnote `[^{name}]`: a note stands beside one place"),
            ),
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
    for note in notes.values().filter(|note| !seen.contains(note.name.as_str())) {
        report.fault(note.offset, format!("nothing refers to the footnote `[^{}]`", note.name));
    }
}

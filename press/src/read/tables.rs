//! Tables: their cells, and how a column of numbers is set.

use crate::read::items::{Cell, Table, Words};
use pulldown_cmark::{Event, Tag, TagEnd};
use std::ops::Range;

/// How the paragraph below a table begins that is its caption.
pub(crate) const CAPTION: &str = "Table: ";

/// The table whose events these are, up to its end.
pub(crate) fn read<'a>(events: &[(Event<'a>, Range<usize>)]) -> Table<'a> {
    let mut table = Table::default();
    let mut cell = None;
    for (event, range) in events {
        match event {
            Event::End(TagEnd::Table) => break,
            Event::Start(Tag::TableHead | Tag::TableRow) => table.rows.push(Vec::new()),
            Event::Start(Tag::TableCell) => cell = Some(Cell { offset: range.start, words: Vec::new() }),
            Event::End(TagEnd::TableCell) => {
                if let (Some(row), Some(cell)) = (table.rows.last_mut(), cell.take()) {
                    row.push(cell);
                }
            }
            event => {
                if let Some(cell) = &mut cell {
                    cell.words.push((event.clone(), range.start));
                }
            }
        }
    }
    table
}

/// The caption in the paragraph that these events begin with, if it is one: its words and its place.
pub(crate) fn caption<'a>(
    text: &str,
    events: &[(Event<'a>, Range<usize>)],
) -> Option<(Words<'a>, Range<usize>)> {
    let Some((Event::Start(Tag::Paragraph), range)) = events.first() else { return None };
    let first = text[range.clone()].strip_prefix(CAPTION)?;
    let words = events[1..].iter().map(|(event, range)| (event.clone(), range.start));
    let mut words: Words<'a> =
        words.take_while(|(event, _)| !matches!(event, Event::End(TagEnd::Paragraph))).collect();
    if let Some((Event::Text(text), _)) = words.first_mut()
        && !first.trim().is_empty()
    {
        *text = text[CAPTION.len().min(text.len())..].to_owned().into();
    }
    Some((words, range.clone()))
}

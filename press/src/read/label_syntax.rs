//! Labels as authors write them: `eq:name`, behind an equation with its number in the source, before an entry of the
//! bibliography.

use crate::fault::Reporter;
use crate::read::items::{EquationLabel, Item, Label, LabelKind, Mention, PlacedItem};
use std::ops::Range;

/// Whether a text can be the name of a label, a note or a control.
pub(crate) fn is_name(text: &str) -> bool {
    !text.is_empty() && text.chars().all(is_of_name)
}

fn is_of_name(c: char) -> bool {
    c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'
}

/// The labels that a text names as words of their own, `eq:…`, `fig:…`, `sec:…` and `ex:…`, and where they begin.
pub(crate) fn named(text: &str) -> Vec<(usize, Label)> {
    let mut found = Vec::new();
    for kind in [LabelKind::Equation, LabelKind::Figure, LabelKind::Section, LabelKind::Exercise] {
        let prefix = format!("{}:", kind.prefix());
        for (at, _) in text.match_indices(&prefix) {
            let before = text[..at].chars().next_back();
            let name = word(&text[at + prefix.len()..], is_of_name).trim_end_matches('-');
            if !before.is_some_and(|c| c.is_alphanumeric() || c == ':') && !name.is_empty() {
                found.push((at, Label { kind, name: name.to_owned() }));
            }
        }
    }
    found
}

/// The labels that the comment at the end of a line of Rust names, and where they begin.
pub(crate) fn cited(line: &str) -> impl Iterator<Item = (usize, Label)> {
    let comment = line.find("//").unwrap_or(line.len());
    named(&line[comment..]).into_iter().map(move |(at, label)| (comment + at, label))
}

/// A label such as `eq:steady-radius`; a fault and `None` if its form is wrong.
pub(crate) fn label(written: &str, offset: usize, report: &mut Reporter<'_>) -> Option<Label> {
    let (prefix, name) = written.split_once(':')?;
    let kind = LabelKind::from_prefix(prefix)?;
    if !is_name(name) {
        report.fault(
            offset,
            format!("the label `{written}` may hold only lower-case letters, digits and hyphens"),
        );
        return None;
    }
    Some(Label { kind, name: name.to_owned() })
}

/// `{#eq:name source="12 13" corrected}`.
pub(crate) fn equation_label(
    written: &str,
    offset: usize,
    report: &mut Reporter<'_>,
) -> Option<EquationLabel> {
    let Some(inner) = written.strip_prefix("{#").and_then(|rest| rest.strip_suffix('}')) else {
        report.fault(
            offset,
            format!(
                "`{written}` is not a label: write {{#eq:name}}, perhaps with source=19 corrected, and nothing behind it"
            ),
        );
        return None;
    };
    let (name, mut rest) = inner.split_once(char::is_whitespace).unwrap_or((inner, ""));
    let label = label(name, offset, report)?;
    if label.kind != LabelKind::Equation {
        report.fault(offset, format!("an equation cannot carry the label {name}"));
        return None;
    }
    let mut found = EquationLabel { label, source: Vec::new(), corrected: false };
    rest = rest.trim();
    while !rest.is_empty() {
        if let Some(after) = rest.strip_prefix("corrected") {
            found.corrected = true;
            rest = after.trim_start();
            continue;
        }
        let value = rest.strip_prefix("source=").map(|value| match value.strip_prefix('"') {
            Some(quoted) => quoted.split_once('"').unwrap_or((quoted, "")),
            None => value.split_once(char::is_whitespace).unwrap_or((value, "")),
        });
        let Some((numbers, after)) = value else {
            report.fault(offset, format!("`{rest}` behind {name} is neither source=… nor corrected"));
            return Some(found);
        };
        if numbers.trim().is_empty() {
            report.fault(offset, format!("source= behind {name} lacks a number"));
        }
        for number in numbers.split_whitespace() {
            match number.parse() {
                Ok(number) => found.source.push(number),
                Err(_) => report.fault(
                    offset,
                    format!("`{number}` is not an equation number; several are written source=\"12 13\""),
                ),
            }
        }
        rest = after.trim_start();
    }
    if found.corrected && found.source.is_empty() {
        report
            .fault(offset, format!("{name} is marked corrected, but says not which equation of the source"));
    }
    Some(found)
}

/// `@eq:name` and its kin in a run of text.
pub(crate) fn mentions<'a>(
    text: &str,
    range: &Range<usize>,
    in_link: bool,
    mut fault: impl FnMut(usize, String),
) -> Vec<PlacedItem<'a>> {
    let mut found = Vec::new();
    for (at, _) in text[range.clone()].match_indices('@') {
        let at = range.start + at;
        let before = text[..at].chars().next_back();
        if before.is_some_and(|c| c == '\\' || c.is_alphanumeric()) {
            continue;
        }
        // Beyond the run, since the parser may have cut the text in two.
        let rest = &text[at + 1..];
        let prefix = word(rest, |c| c.is_ascii_alphabetic());
        let Some(rest) = rest[prefix.len()..].strip_prefix(':').filter(|_| !prefix.is_empty()) else {
            continue;
        };
        let name = word(rest, |c| c.is_ascii_alphanumeric() || c == '-').trim_end_matches('-');
        let lower = prefix.to_ascii_lowercase();
        let kind = LabelKind::from_prefix(&lower);
        let known = kind.is_some() || lower == "source";
        let mention = match kind {
            _ if known && lower != prefix => {
                fault(at, format!("`@{prefix}:` is written `@{lower}:`"));
                continue;
            }
            _ if known && in_link => {
                fault(at, "a reference is a link and cannot stand inside a link".to_owned());
                continue;
            }
            Some(_) if name.is_empty() => {
                fault(at, format!("`@{prefix}:` lacks a name"));
                continue;
            }
            Some(kind) => Mention::Label(Label { kind, name: name.to_owned() }),
            None if known => match name.parse() {
                Ok(number) => Mention::Source(number),
                Err(_) => {
                    fault(at, format!("`@source:{name}` needs an equation number of the source"));
                    continue;
                }
            },
            None => {
                if lower == prefix && !name.is_empty() {
                    fault(at, format!("`@{prefix}:{name}`: there are no labels of the kind `{prefix}`"));
                }
                continue;
            }
        };
        let range = at..at + 1 + prefix.len() + 1 + name.len();
        found.push(PlacedItem { range, item: Item::Mention(mention) });
    }
    found
}

/// The longest beginning of a text that holds nothing else.
fn word(text: &str, belongs: impl Fn(char) -> bool) -> &str {
    &text[..text.find(|c| !belongs(c)).unwrap_or(text.len())]
}

/// Entries of the bibliography: `- {#cite:key "Name 1999"} …`.
pub(crate) fn citations<'a>(text: &'a str, report: &mut Reporter<'_>) -> Vec<PlacedItem<'a>> {
    let mut found = Vec::new();
    for (at, _) in text.match_indices("{#cite:") {
        let start_of_line = text[..at].rfind('\n').map_or(0, |newline| newline + 1);
        if !matches!(text[start_of_line..at].trim(), "-" | "*") {
            report.fault(
                at,
                "an entry of the bibliography is a list item that begins with {#cite:key \"Name 1999\"}",
            );
            continue;
        }
        let rest = &text[at + 2..];
        let end = rest.find('}');
        let parts =
            end.and_then(|end| rest[..end].split_once(' ').map(|(key, short)| (key, short.trim(), end)));
        match parts {
            Some((key, short, end)) if short.len() > 2 && short.starts_with('"') && short.ends_with('"') => {
                if let Some(label) = label(key, at, report) {
                    let short = &short[1..short.len() - 1];
                    let range = at..at + 2 + end + 1;
                    let behind = &text[range.end..];
                    let next = ["\n- ", "\n* ", "\n\n"].iter().filter_map(|next| behind.find(next)).min();
                    let end = range.end + behind[..next.unwrap_or(behind.len())].trim_end().len();
                    found.push(PlacedItem { range: end..end, item: Item::CitationEnd(label.clone()) });
                    found.push(PlacedItem { range, item: Item::Citation { label, short } });
                }
            }
            _ => report.fault(at, "write the entry as {#cite:key \"Name 1999\"}"),
        }
    }
    found
}

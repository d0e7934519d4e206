//! One pass over the Markdown of a page, which finds everything that the press has to replace or check.

use crate::book::Page;
use crate::fault::{Faults, line_of};
use crate::page::{EquationLabel, Item, Kind, Label, Mention, Placed};
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd};
use std::borrow::Cow;
use std::ops::Range;

/// Markdown as mdBook reads it, and mathematics, which it does not.
pub(crate) fn options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH
}

/// How many equations the source numbers.
const EQUATIONS_OF_THE_SOURCE: u32 = 98;

/// Finds the items of a page, in the order in which they stand.
pub(crate) fn scan<'a>(page: &'a Page, faults: &mut Faults) -> Vec<Placed<'a>> {
    let mut scan =
        Scan { page, text: &page.text, items: Vec::new(), faults, surroundings: Surroundings::default() };
    scan.run();
    scan.items.sort_by_key(|placed| placed.range.start);
    scan.items
}

struct Scan<'a, 'f> {
    page: &'a Page,
    text: &'a str,
    items: Vec<Placed<'a>>,
    faults: &'f mut Faults,
    surroundings: Surroundings,
}

/// What the place that is being read stands in.
#[derive(Debug, Default)]
struct Surroundings {
    /// How many quotations deep.
    quotes: usize,
    in_table: bool,
    in_link: bool,
}

impl<'a> Scan<'a, '_> {
    fn fault(&mut self, offset: usize, message: impl Into<String>) {
        let line = line_of(self.text, offset);
        self.faults.add(&self.page.file, line, message);
    }

    fn place(&mut self, range: Range<usize>, item: Item<'a>) {
        self.items.push(Placed { range, item });
    }

    fn run(&mut self) {
        let events: Vec<(Event<'a>, Range<usize>)> =
            Parser::new_ext(self.text, options()).into_offset_iter().collect();
        let mut paragraph: Option<Range<usize>> = None;
        let mut heading: Option<(u8, Range<usize>)> = None;
        let mut n = 0;
        while let Some((event, range)) = events.get(n) {
            n += 1;
            match event {
                Event::Start(Tag::BlockQuote(_)) => self.surroundings.quotes += 1,
                Event::End(TagEnd::BlockQuote(_)) => self.surroundings.quotes -= 1,
                Event::Start(Tag::Table(_)) => self.surroundings.in_table = true,
                Event::End(TagEnd::Table) => self.surroundings.in_table = false,
                Event::End(TagEnd::Link) => self.surroundings.in_link = false,
                Event::Start(Tag::Paragraph) => {
                    if self.text[range.clone()].starts_with('|') {
                        self.fault(
                            range.start,
                            "a row of no table: no blank line may stand above it, and a table begins with a line of names and one of dashes",
                        );
                    }
                    paragraph = Some(range.clone());
                }
                Event::End(TagEnd::Paragraph) => paragraph = None,
                Event::Start(Tag::Heading { level, .. }) => {
                    heading = Some((number(*level), range.clone()));
                }
                Event::End(TagEnd::Heading(_)) => {
                    if let Some((level, range)) = heading.take() {
                        self.heading(level, range);
                    }
                }
                Event::Start(Tag::CodeBlock(kind)) => {
                    crate::snippets::check(self.text, kind, range, |offset, message| {
                        let line = line_of(self.text, offset);
                        self.faults.add(&self.page.file, line, message);
                    });
                    if matches!(kind, CodeBlockKind::Indented) {
                        self.fault(
                            range.start,
                            "text indented by four spaces becomes code: unindent it, or fence it",
                        );
                    }
                    if matches!(kind, CodeBlockKind::Fenced(info) if info.starts_with("rust")) {
                        self.place(range.end..range.end, Item::Snippet { code: &self.text[range.clone()] });
                    }
                    for (place, written) in crate::snippets::cited_labels(self.text, range) {
                        if let Some(label) = self.label(written, place.start) {
                            self.place(place, Item::CodeLabel(label));
                        }
                    }
                    n = after(&events, n, |tag| matches!(tag, TagEnd::CodeBlock));
                }
                Event::Start(Tag::Image { dest_url, .. }) => {
                    let end = after(&events, n, |tag| matches!(tag, TagEnd::Image));
                    if let Some(label) =
                        self.label(dest_url, range.start).filter(|label| label.kind == Kind::Figure)
                    {
                        let alone = paragraph
                            .as_ref()
                            .is_some_and(|p| self.text[p.clone()].trim() == &self.text[range.clone()]);
                        if !alone {
                            self.fault(
                                range.start,
                                format!("the figure {dest_url} must stand in a paragraph of its own"),
                            );
                        }
                        for (event, range) in &events[n..end - 1] {
                            if let Event::Text(_) = event {
                                self.stray_dollars(range.clone());
                            }
                        }
                        if n + 1 >= end {
                            self.fault(
                                range.start,
                                format!("the figure {dest_url} has no caption that says what it shows"),
                            );
                        }
                        let caption = events[n..end - 1].iter().map(|(event, _)| event.clone()).collect();
                        self.place(range.clone(), Item::Figure { label, caption });
                    } else {
                        self.fault(
                            range.start,
                            format!("the image `{dest_url}` is not a figure of the book (`fig:name`)"),
                        );
                    }
                    n = end;
                }
                Event::Start(Tag::Link { dest_url, .. }) => {
                    self.surroundings.in_link = true;
                    let written = &self.text[range.clone()];
                    // The target as it is written, which outlives the parser's copy.
                    let target = written.rfind(dest_url.as_ref()).map(|at| &written[at..at + dest_url.len()]);
                    match target {
                        Some(target) => self.place(range.clone(), Item::Link { target }),
                        None => self.fault(
                            range.start,
                            format!("the link to `{dest_url}` should spell out its target"),
                        ),
                    }
                }
                Event::InlineMath(_) => {
                    if heading.is_some() {
                        self.fault(
                            range.start,
                            "mathematics in a heading is lost in the sidebar: say it in words",
                        );
                    }
                    let tex = &self.text[range.start + 1..range.end - 1];
                    if self.surroundings.in_table && tex.contains('|') {
                        self.fault(
                            range.start,
                            "`|` in the mathematics of a table ends the cell: write \\lvert … \\rvert, \\lVert … \\rVert or \\mid",
                        );
                    }
                    let tex = self.unquoted(tex);
                    self.place(range.clone(), Item::InlineMaths { tex });
                }
                Event::DisplayMath(_) => self.display(range, paragraph.as_ref()),
                Event::Text(_) => {
                    self.mentions(range.clone());
                    self.stray_dollars(range.clone());
                    self.foreign_maths(range);
                    if heading.is_none() && !self.behind_maths(range.start) {
                        self.lost_labels(range);
                    }
                }
                Event::Html(html) | Event::InlineHtml(html) => {
                    if html.contains("<summary>Hint") {
                        self.place(range.clone(), Item::Hint);
                    } else if html.contains("<summary>") && html.to_lowercase().contains("<summary>hint") {
                        self.fault(range.start, "the summary of a hint is the word `Hint`");
                    }
                    if ["<img", "<script", "<iframe", "<link", "src="].iter().any(|tag| html.contains(tag)) {
                        self.fault(range.start, "raw HTML must not load anything: use a figure");
                    }
                    if html.contains('$') && !html.trim_start().starts_with("<!--") {
                        self.fault(
                            range.start,
                            "raw HTML is not read for mathematics: put the text into a paragraph of its own, with blank lines around it",
                        );
                    }
                }
                _ => {}
            }
        }
        self.citations();
    }

    /// `\(x\)` and `\[y\]`, which other tools read as mathematics and Markdown as brackets.
    fn foreign_maths(&mut self, range: &Range<usize>) {
        let before = self.text[..range.start].chars().next_back();
        if before == Some('\\') && self.text[range.clone()].starts_with(['(', '[']) {
            self.fault(range.start - 1, "`\\(` and `\\[` are not mathematics here: write $…$ or $$…$$");
        }
    }

    /// Whether this place follows display mathematics in its paragraph: its label is read with it.
    fn behind_maths(&self, offset: usize) -> bool {
        self.text[..offset].trim_end().ends_with("$$")
    }

    /// A label that nothing has read, in a run of text.
    fn lost_labels(&mut self, range: &Range<usize>) {
        for (at, _) in self.text[range.clone()].match_indices("{#") {
            let written = &self.text[range.start + at + 2..];
            let kind = written.split_once(':').and_then(|(prefix, _)| Kind::from_prefix(prefix));
            if kind.is_some_and(|kind| kind != Kind::Citation) {
                self.fault(
                    range.start + at,
                    "a label stands behind the closing `$$` of an equation, or at the end of a heading `## …`",
                );
            }
        }
    }

    /// A heading, with the label in its braces.
    fn heading(&mut self, level: u8, range: Range<usize>) {
        let line = self.text[range.clone()].trim_end();
        if line.contains('\n') {
            self.fault(
                range.start,
                "write a heading with `#` on one line: an underlined one cannot carry a label",
            );
        }
        let body = line.trim_start_matches('#').trim();
        let (title, attributes) = match body.rfind("{#") {
            Some(at) if body.ends_with('}') => (body[..at].trim_end(), Some(&body[at + 2..body.len() - 1])),
            _ => (body, None),
        };
        let id = attributes.filter(|a| !a.contains(':')).and_then(|a| a.split_whitespace().next());
        let label = attributes.filter(|a| a.contains(':')).and_then(|a| self.label(a, range.start));
        if let Some(label) = &label {
            if !matches!(label.kind, Kind::Section | Kind::Exercise | Kind::Solution) {
                self.fault(range.start, format!("a heading cannot carry the label {}", label.written()));
            } else if title.is_empty() != (label.kind == Kind::Solution) {
                let rule =
                    if title.is_empty() { "needs a title" } else { "takes its title from the exercise" };
                self.fault(range.start, format!("the heading of {} {rule}", label.written()));
            }
        }
        let plain = title.replace(['`', '*', '_'], "");
        self.place(range.start..range.start + line.len(), Item::Heading { level, label, id, title, plain });
    }

    /// Display mathematics: alone in its paragraph, but for a label behind it.
    fn display(&mut self, range: &Range<usize>, paragraph: Option<&Range<usize>>) {
        let tex = self.unquoted(&self.text[range.start + 2..range.end - 2]);
        let rest = &self.text[range.end..];
        let line = &rest[..rest.find('\n').unwrap_or(rest.len())];
        let mut end = range.end;
        let mut label = None;
        if line.trim_start().starts_with('{') {
            end += line.trim_end().len();
            label = self.equation_label(line.trim(), range.end);
        }
        let alone = paragraph.is_some_and(|p| {
            self.text[p.start..range.start].trim().is_empty()
                && self.text[end.min(p.end)..p.end].trim().is_empty()
        });
        let behind = paragraph.map_or("", |p| self.text[end.min(p.end)..p.end].trim());
        if label.is_none() && behind.starts_with("{#") {
            let place = end + self.text[end..].find('{').unwrap_or(0);
            self.fault(
                place,
                "the label of an equation stands right behind the closing dollars, on their line",
            );
        } else if !alone {
            self.fault(
                range.start,
                "display mathematics must stand in a paragraph of its own, with blank lines around it",
            );
        }
        self.place(range.start..end, Item::DisplayMaths { tex, label });
    }

    /// A formula without the `>` of the quotation that it stands in: blanks in their place, so that a fault keeps its line.
    fn unquoted(&self, tex: &'a str) -> Cow<'a, str> {
        if self.surroundings.quotes == 0 || !tex.contains('\n') {
            return Cow::Borrowed(tex);
        }
        let mut lines = tex.split('\n');
        let mut out = lines.next().unwrap_or_default().to_owned();
        for line in lines {
            out.push('\n');
            let mut left = self.surroundings.quotes;
            let mut margin = true;
            for c in line.chars() {
                margin &= c == ' ' || (c == '>' && left > 0);
                if margin && c == '>' {
                    left -= 1;
                    out.push(' ');
                } else {
                    out.push(c);
                }
            }
        }
        Cow::Owned(out)
    }

    /// `{#eq:name source="12 13" corrected}`.
    fn equation_label(&mut self, written: &str, offset: usize) -> Option<EquationLabel> {
        let Some(inner) = written.strip_prefix("{#").and_then(|rest| rest.strip_suffix('}')) else {
            self.fault(
                offset,
                format!(
                    "`{written}` is not a label: write {{#eq:name}}, perhaps with source=19 corrected, and nothing behind it"
                ),
            );
            return None;
        };
        let (name, mut rest) = inner.split_once(char::is_whitespace).unwrap_or((inner, ""));
        let label = self.label(name, offset)?;
        if label.kind != Kind::Equation {
            self.fault(offset, format!("an equation cannot carry the label {name}"));
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
                self.fault(offset, format!("`{rest}` behind {name} is neither source=… nor corrected"));
                return Some(found);
            };
            if numbers.trim().is_empty() {
                self.fault(offset, format!("source= behind {name} lacks a number"));
            }
            for number in numbers.split_whitespace() {
                match number.parse() {
                    Ok(number) if (1..=EQUATIONS_OF_THE_SOURCE).contains(&number) => {
                        found.source.push(number);
                    }
                    _ => self.fault(
                        offset,
                        format!(
                            "`{number}` is not an equation number of the source, from 1 to {EQUATIONS_OF_THE_SOURCE}; \
                             several are written source=\"12 13\""
                        ),
                    ),
                }
            }
            rest = after.trim_start();
        }
        if found.corrected && found.source.is_empty() {
            self.fault(
                offset,
                format!("{name} is marked corrected, but says not which equation of the source"),
            );
        }
        Some(found)
    }

    /// A label such as `eq:steady-radius`; a fault and `None` if its form is wrong.
    fn label(&mut self, written: &str, offset: usize) -> Option<Label> {
        let (prefix, name) = written.split_once(':')?;
        let kind = Kind::from_prefix(prefix)?;
        if name.is_empty() || !name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-')
        {
            self.fault(
                offset,
                format!("the label `{written}` may hold only lower-case letters, digits and hyphens"),
            );
            return None;
        }
        Some(Label { kind, name: name.to_owned() })
    }

    /// `@eq:name` and its kin in a run of text.
    fn mentions(&mut self, range: Range<usize>) {
        let text = &self.text[range.clone()];
        for (at, _) in text.match_indices('@') {
            let escaped = self.text[..range.start + at].ends_with('\\');
            let before = self.text[..range.start + at].chars().next_back();
            if escaped || before.is_some_and(char::is_alphanumeric) {
                continue;
            }
            let looks_like_one = self.text[range.start + at + 1..]
                .split_once(':')
                .is_some_and(|(prefix, _)| prefix == "source" || Kind::from_prefix(prefix).is_some());
            if self.surroundings.in_link && looks_like_one {
                self.fault(range.start + at, "a reference is a link and cannot stand inside a link");
                continue;
            }
            // Up to the end of the page, since the parser may have cut the text in two.
            let rest = &self.text[range.start + at + 1..];
            let Some(colon) = rest.find(':') else {
                continue;
            };
            let prefix = &rest[..colon];
            let lower = prefix.to_ascii_lowercase();
            if lower != prefix && (lower == "source" || Kind::from_prefix(&lower).is_some()) {
                self.fault(range.start + at, format!("`@{prefix}:` is written `@{lower}:`"));
                continue;
            }
            let name = &rest[colon + 1..];
            let name =
                &name[..name.find(|c: char| !(c.is_ascii_alphanumeric() || c == '-')).unwrap_or(name.len())];
            let name = name.trim_end_matches('-');
            let here = range.start + at..range.start + at + 1 + colon + 1 + name.len();
            if prefix == "source" {
                match name.parse() {
                    Ok(number) => self.place(here, Item::Mention(Mention::Source(number))),
                    Err(_) => self.fault(
                        here.start,
                        format!("`@source:{name}` needs an equation number of the source"),
                    ),
                }
            } else if let Some(kind) = Kind::from_prefix(prefix) {
                if name.is_empty() {
                    self.fault(here.start, format!("`@{prefix}:` lacks a name"));
                } else {
                    self.place(here, Item::Mention(Mention::Label(Label { kind, name: name.to_owned() })));
                }
            } else if !prefix.is_empty() && prefix.bytes().all(|b| b.is_ascii_lowercase()) && !name.is_empty()
            {
                self.fault(
                    here.start,
                    format!("`@{prefix}:{name}`: there are no labels of the kind `{prefix}`"),
                );
            }
        }
    }

    /// A dollar in plain text is mathematics that did not close.
    fn stray_dollars(&mut self, range: Range<usize>) {
        if let Some(at) = self.text[range.clone()].find('$') {
            let offset = range.start + at;
            if !self.text[..offset].ends_with(['\\', '$']) {
                let message = if self.text[offset..].starts_with("$$") {
                    "a stray `$$`: does the formula lack its end, hold a blank line, braces that do not balance, or a line \
                     that begins with `+`, `-` or `#` and so starts a list or a heading?"
                } else if self.surroundings.in_table {
                    "a stray `$`: in a table `|` ends the cell, so write \\lvert … \\rvert or \\mid; or `\\$` for a dollar"
                } else {
                    "a stray `$`: close the formula, balance its braces, or write `\\$` for a dollar"
                };
                self.fault(offset, message);
            }
        }
    }

    /// Entries of the bibliography: `- {#cite:key "Name 1999"} …`.
    fn citations(&mut self) {
        for (at, _) in self.text.match_indices("{#cite:") {
            let start_of_line = self.text[..at].rfind('\n').map_or(0, |newline| newline + 1);
            if !matches!(self.text[start_of_line..at].trim(), "-" | "*") {
                self.fault(
                    at,
                    "an entry of the bibliography is a list item that begins with {#cite:key \"Name 1999\"}",
                );
                continue;
            }
            let rest = &self.text[at + 2..];
            let end = rest.find('}');
            let parts =
                end.and_then(|end| rest[..end].split_once(' ').map(|(key, short)| (key, short.trim(), end)));
            match parts {
                Some((key, short, end))
                    if short.len() > 2 && short.starts_with('"') && short.ends_with('"') =>
                {
                    if let Some(label) = self.label(key, at) {
                        let short = &short[1..short.len() - 1];
                        self.place(at..at + 2 + end + 1, Item::Citation { label, short });
                    }
                }
                _ => self.fault(at, "write the entry as {#cite:key \"Name 1999\"}"),
            }
        }
    }
}

/// The place behind the end of the element that was just opened.
fn after(events: &[(Event<'_>, Range<usize>)], from: usize, is_end: impl Fn(&TagEnd) -> bool) -> usize {
    let end = events[from..].iter().position(|(event, _)| matches!(event, Event::End(tag) if is_end(tag)));
    end.map_or(events.len(), |end| from + end + 1)
}

fn number(level: HeadingLevel) -> u8 {
    level as u8
}

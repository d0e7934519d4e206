//! Raw HTML on a page: a few elements that load and run nothing, each closed where it was opened.

use crate::fault::Reporter;
use crate::read::control_characters;
use crate::read::font_coverage::Face;
use crate::read::items::{Item, LabelKind, PlacedItem};
use html::{StartTag, Token, VOID};

/// The elements that a page may write itself; for everything else there is Markdown, or there should not be any.
const ELEMENTS: [&str; 14] =
    ["a", "abbr", "b", "br", "details", "div", "em", "kbd", "p", "small", "span", "sub", "summary", "sup"];
const ATTRIBUTES: [&str; 7] = ["class", "dir", "href", "id", "lang", "open", "title"];
/// How many elements may stand open: what reads them later does not bear any number.
const DEEPEST: usize = 30;

/// The raw HTML of a page, read piece by piece between its Markdown.
#[derive(Debug, Default)]
pub(crate) struct RawHtml {
    open: Vec<OpenElement>,
    /// How many elements of Markdown stand open.
    depth: usize,
}

/// An element that was opened at `offset`, inside `depth` elements of Markdown.
#[derive(Debug)]
struct OpenElement {
    name: String,
    offset: usize,
    depth: usize,
}

impl RawHtml {
    /// An element of Markdown begins.
    pub(crate) fn enter(&mut self) {
        self.depth += 1;
    }

    /// An element of Markdown ends, and with it must what was opened inside.
    pub(crate) fn leave(&mut self, report: &mut Reporter<'_>) {
        while self.open.last().is_some_and(|open| open.depth >= self.depth) {
            self.unclosed(report);
        }
        self.depth = self.depth.saturating_sub(1);
    }

    /// The page ends.
    pub(crate) fn end(&mut self, report: &mut Reporter<'_>) {
        while !self.open.is_empty() {
            self.unclosed(report);
        }
    }

    fn unclosed(&mut self, report: &mut Reporter<'_>) {
        if let Some(OpenElement { name, offset, .. }) = self.open.pop() {
            report.fault(
                offset,
                format!("`<{name}>` is not closed: `</{name}>` must stand in the same paragraph, list item or page"),
            );
        }
    }

    /// Reads a piece of HTML whose byte `n` is byte `place(n)` of the page; what it holds for the press to look up.
    pub(crate) fn read(
        &mut self,
        html: &str,
        place: impl Fn(usize) -> usize,
        report: &mut Reporter<'_>,
    ) -> Vec<PlacedItem<'static>> {
        let mut found = Vec::new();
        let mut in_summary = false;
        for token in html::tokens(html) {
            match token {
                Token::StartTag(tag) => {
                    let name = html::text(&tag.name);
                    let offset = place(tag.span.start);
                    in_summary = name == "summary";
                    if ELEMENTS.contains(&name.as_str()) {
                        attributes(&name, &tag, html, &place, report, &mut found);
                    } else {
                        report.fault(
                            offset,
                            format!(
                                "`<{name}>`: raw HTML must not load, run or order anything; a page may write {}",
                                ELEMENTS.join(", ")
                            ),
                        );
                    }
                    if !VOID.contains(&name.as_str()) {
                        self.open.push(OpenElement { name, offset, depth: self.depth });
                        if self.open.len() == DEEPEST + 1 {
                            report.fault(
                                offset,
                                format!("more than {DEEPEST} elements of raw HTML stand open"),
                            );
                        }
                    }
                }
                Token::EndTag(tag) => {
                    in_summary = false;
                    self.close(&html::text(&tag.name), place(tag.span.start), report);
                }
                Token::String(text) => {
                    let (text_span, offset) = (text.span.start..text.span.end, place(text.span.start));
                    let text = html::text(&text);
                    prose(&text, &html[text_span], offset, report);
                    if in_summary && text.trim() == "Hint" {
                        found.push(PlacedItem { range: offset..offset, item: Item::Hint });
                    } else if in_summary && text.trim().to_lowercase().starts_with("hint") {
                        report.fault(offset, "the summary of a hint is the word `Hint`");
                    }
                }
                Token::Error(error) => {
                    // What breaks at the end of the HTML began at its last bracket.
                    let at = error.span.start;
                    let at = if at < html.len() { at } else { html.rfind('<').unwrap_or(0) };
                    report.fault(place(at), format!("the HTML is broken: {}", error.value));
                }
                Token::Comment(_) | Token::Doctype(_) => {}
            }
        }
        found
    }

    /// An end tag closes the last element of its name, if that was opened in the same element of Markdown.
    fn close(&mut self, name: &str, offset: usize, report: &mut Reporter<'_>) {
        let partner = self.open.iter().rposition(|open| open.name == name && open.depth == self.depth);
        match partner {
            Some(at) => {
                while self.open.len() > at + 1 {
                    self.unclosed(report);
                }
                self.open.pop();
            }
            None => report.fault(
                offset,
                format!(
                    "`</{name}>` closes nothing that was opened in the same paragraph, list item or page"
                ),
            ),
        }
    }
}

fn attributes(
    name: &str,
    tag: &StartTag<usize>,
    html: &str,
    place: impl Fn(usize) -> usize,
    report: &mut Reporter<'_>,
    found: &mut Vec<PlacedItem<'static>>,
) {
    for (key, value) in &tag.attributes {
        let (span, offset) = (value.span.start..value.span.end, place(value.span.start));
        let (key, value) = (html::text(key), html::text(value));
        prose(&value, &html[span], offset, report);
        match &*key {
            "id" => found.push(PlacedItem { range: offset..offset, item: Item::Id(value) }),
            "href" if name == "a" => {
                found.push(PlacedItem { range: offset..offset, item: Item::Link { target: value.into() } });
            }
            key if ATTRIBUTES.contains(&key) => {}
            key => report.fault(
                offset,
                format!(
                    "the attribute `{key}` of `<{name}>`: raw HTML must not load, run or style anything; \
                     a page may write {}",
                    ATTRIBUTES.join(", ")
                ),
            ),
        }
    }
}

/// Text inside HTML is not read as our dialect; `source` is what the page has for it.
fn prose(text: &str, source: &str, offset: usize, report: &mut Reporter<'_>) {
    if source.contains('&') {
        control_characters::characters(text, |_, message| report.fault(offset, message));
    }
    if let Err((at, message)) = Face::Text.check(text) {
        let above = text[..at].matches('\n').count();
        let line: usize = source.split_inclusive('\n').take(above).map(str::len).sum();
        report.fault(offset + line, message);
    }
    const CURE: &str = "put the text into a paragraph of its own, with blank lines around it";
    if text.contains('$') {
        report.fault(offset, format!("raw HTML is not read for mathematics: {CURE}"));
    }
    let mentions = |prefix: &str| text.contains(&format!("@{prefix}:"));
    if mentions("source") || LabelKind::ALL.iter().any(|kind| mentions(kind.prefix())) {
        report.fault(offset, format!("raw HTML is not read for references: {CURE}"));
    }
}

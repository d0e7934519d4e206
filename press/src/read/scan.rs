//! One pass over the Markdown of a page, which finds everything that the press has to replace or check.

mod captioned;
mod mathematics;
mod text;

use crate::book::Page;
use crate::fault::{Faults, Reporter};
use crate::read::font_coverage::Face;
use crate::read::items::{Item, LabelKind, Note, PlacedItem};
use crate::read::raw_html::RawHtml;
use crate::read::{control_characters, label_syntax, margin_notes, outline, references, snippets, tables};
use dialect::markdown::is_rust;
use pulldown_cmark::{CodeBlockKind, CowStr, Event, Tag, TagEnd};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;

/// Finds the items of a page, in the order in which they stand.
pub(crate) fn scan<'a>(page: &'a Page, faults: &mut Faults) -> Vec<PlacedItem<'a>> {
    let mut report = page.reporter(faults);
    control_characters::check(&page.text, &mut report);
    let events = references::parsed(&page.text, &mut report);
    let notes = margin_notes::defined(&page.text, &events, &mut report);
    let mut items = label_syntax::citations(&page.text, &mut report);
    let mut scan = Scan {
        text: &page.text,
        events: &events,
        notes,
        items: Vec::new(),
        report,
        surroundings: Surroundings::default(),
        raw: RawHtml::default(),
    };
    scan.run();
    items.append(&mut scan.items);
    items.sort_by_key(|placed| placed.range.start);
    outline::check(&items, &mut page.reporter(faults));
    items
}

type Events<'a> = [(Event<'a>, Range<usize>)];

struct Scan<'a, 'f> {
    text: &'a str,
    events: &'f Events<'a>,
    /// The notes whose marks have not been met.
    notes: BTreeMap<String, Note<'a>>,
    items: Vec<PlacedItem<'a>>,
    report: Reporter<'f>,
    surroundings: Surroundings,
    raw: RawHtml,
}

/// What the place that is being read stands in.
#[derive(Debug, Default)]
struct Surroundings {
    /// How many quotations deep.
    quotes: usize,
    in_table: bool,
    in_table_head: bool,
    /// Where the last table ends, with its caption.
    end_of_table: usize,
    in_link: bool,
    in_caption: bool,
    in_note: bool,
    /// How many elements deep, and the notes that the outermost one refers to.
    depth: usize,
    notes: Vec<String>,
    paragraph: Option<Range<usize>>,
    heading: Option<Range<usize>>,
}

impl<'a> Scan<'a, '_> {
    fn fault(&mut self, offset: usize, message: impl Into<String>) {
        self.report.fault(offset, message);
    }

    fn place(&mut self, range: Range<usize>, item: Item<'a>) {
        self.items.push(PlacedItem { range, item });
    }

    fn run(&mut self) {
        let events = self.events;
        let mut n = 0;
        while let Some((event, range)) = events.get(n) {
            n += 1;
            match event {
                Event::Start(Tag::CodeBlock(kind)) => {
                    self.code(kind, range);
                    n = after(events, n, |tag| matches!(tag, TagEnd::CodeBlock));
                }
                Event::Start(Tag::HtmlBlock) => {
                    let end = after(events, n, |tag| matches!(tag, TagEnd::HtmlBlock));
                    self.html(&events[n..end]);
                    n = end;
                }
                Event::InlineHtml(_) => self.html(&events[n - 1..n]),
                Event::Start(tag) => {
                    self.raw.enter();
                    self.surroundings.depth += 1;
                    self.start(tag, range, n);
                }
                Event::End(tag) => {
                    self.end(*tag);
                    self.raw.leave(&mut self.report);
                    self.surroundings.depth -= 1;
                    if self.surroundings.depth == 0 {
                        self.notes(range.end.max(self.surroundings.end_of_table));
                    }
                }
                Event::FootnoteReference(name) => self.note_mark(name, range),
                Event::InlineMath(_) => self.inline(range),
                Event::DisplayMath(_) => self.display(range),
                Event::Code(_) => self.shown(Face::Code, range),
                Event::Text(text) => self.words(text, range),
                _ => {}
            }
        }
        self.raw.end(&mut self.report);
    }

    /// An element of Markdown begins; `next` is its first event.
    fn start(&mut self, tag: &Tag<'a>, range: &Range<usize>, next: usize) {
        match tag {
            Tag::BlockQuote(_) => self.surroundings.quotes += 1,
            Tag::Table(_) => {
                self.surroundings.in_table = true;
                self.table(range, next);
            }
            Tag::TableHead => self.surroundings.in_table_head = true,
            Tag::TableCell => {
                let empty = self.text[range.clone()].trim_matches(['|', ' ', '\t']).is_empty();
                if self.surroundings.in_table_head && empty {
                    self.fault(range.start, "a column of the table has no name");
                }
            }
            Tag::Paragraph => {
                if self.text[range.clone()].starts_with('|') {
                    self.fault(
                        range.start,
                        "a row of no table: no blank line may stand above it, and a table begins with a line of names and one of dashes",
                    );
                }
                let caption = self.text[range.clone()].starts_with(tables::CAPTION);
                if caption && range.end > self.surroundings.end_of_table {
                    self.fault(range.start, "a caption of no table: it stands right below its table");
                }
                self.surroundings.paragraph = Some(range.clone());
            }
            Tag::Heading { level, classes, attrs, .. } => {
                if !classes.is_empty() || !attrs.is_empty() {
                    self.fault(
                        range.start,
                        "the braces behind a heading hold an id or a label, {#…}, and nothing else",
                    );
                }
                self.heading(*level as u8, range.clone());
                self.surroundings.heading = Some(range.clone());
            }
            Tag::FootnoteDefinition(_) => {
                self.surroundings.in_note = true;
                self.place(range.clone(), Item::NoteDefinition);
            }
            Tag::Image { .. } if self.surroundings.in_caption => {
                self.fault(range.start, "a figure cannot stand in the caption of another");
            }
            Tag::Image { dest_url, .. } => {
                self.surroundings.in_caption = true;
                self.image(dest_url, range, next);
            }
            Tag::Link { dest_url, .. } => {
                self.surroundings.in_link = true;
                self.link(dest_url, range, next);
            }
            _ => {}
        }
    }

    fn end(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::BlockQuote(_) => self.surroundings.quotes -= 1,
            TagEnd::Table => self.surroundings.in_table = false,
            TagEnd::TableHead => self.surroundings.in_table_head = false,
            TagEnd::Link => self.surroundings.in_link = false,
            TagEnd::FootnoteDefinition => self.surroundings.in_note = false,
            TagEnd::Image => self.surroundings.in_caption = false,
            TagEnd::Paragraph => self.surroundings.paragraph = None,
            TagEnd::Heading(_) => self.surroundings.heading = None,
            _ => {}
        }
    }

    /// The mark of a note, which is printed behind the outermost block around it.
    fn note_mark(&mut self, name: &str, range: &Range<usize>) {
        if self.surroundings.heading.is_some() {
            self.fault(range.start, "a note cannot hang on a heading: it would be lost in the sidebar");
        } else if self.surroundings.in_note {
            self.fault(range.start, "a note cannot hang on another note");
        } else if self.notes.contains_key(name) && !self.surroundings.notes.iter().any(|note| note == name) {
            self.surroundings.notes.push(name.to_owned());
            self.place(range.clone(), Item::NoteMark(name.to_owned()));
        }
    }

    /// The notes of the block that ends here.
    fn notes(&mut self, end: usize) {
        for name in std::mem::take(&mut self.surroundings.notes) {
            if let Some(note) = self.notes.remove(&name) {
                self.place(end..end, Item::Note(note));
            }
        }
    }

    fn code(&mut self, kind: &CodeBlockKind<'a>, range: &Range<usize>) {
        self.shown(Face::Code, range);
        snippets::check(self.text, kind, range, |offset, message| self.report.fault(offset, message));
        if matches!(kind, CodeBlockKind::Indented) {
            self.fault(range.start, "text indented by four spaces becomes code: unindent it, or fence it");
        }
        if matches!(kind, CodeBlockKind::Fenced(info) if is_rust(info)) {
            self.place(range.clone(), Item::Snippet { code: &self.text[range.clone()] });
        }
    }

    fn link(&mut self, dest_url: &CowStr<'a>, range: &Range<usize>, next: usize) {
        let written = &self.text[range.clone()];
        if dest_url.is_empty() {
            self.fault(range.start, "the link leads nowhere: write its target into the parentheses");
        } else if matches!(self.events.get(next), Some((Event::End(TagEnd::Link), _))) {
            self.fault(range.start, format!("the link to `{dest_url}` has no words"));
        } else if let Some(at) = written.rfind(dest_url.as_ref()) {
            // The target as it is written, which outlives the parser's copy.
            let target = Cow::Borrowed(&written[at..at + dest_url.len()]);
            match dest_url.strip_prefix("scene:") {
                Some(setting) if written.starts_with('[') && written[..at].ends_with("](") => {
                    let setting = Cow::Owned(setting.to_owned());
                    self.place(range.start..range.start + 1, Item::SettingStart(setting));
                    self.place(range.start + at - 2..range.end, Item::SettingEnd);
                }
                _ => self.place(range.clone(), Item::Link { target }),
            }
        } else {
            self.fault(range.start, format!("the link to `{dest_url}` should spell out its target"));
        }
    }

    /// Raw HTML: the lines of a block, or one tag in a line of text.
    fn html(&mut self, events: &Events<'a>) {
        let mut html = String::new();
        let mut places = Vec::new();
        for (event, range) in events {
            if let Event::Html(piece) | Event::InlineHtml(piece) = event {
                places.push((html.len(), range.start));
                html.push_str(piece);
            }
        }
        let place = |at: usize| {
            let piece = places.partition_point(|&(start, _)| start <= at).saturating_sub(1);
            places.get(piece).map_or(0, |&(start, offset)| offset + at - start)
        };
        self.items.extend(self.raw.read(&html, place, &mut self.report));
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
        let label = attributes
            .filter(|a| a.contains(':'))
            .and_then(|a| label_syntax::label(a, range.start, &mut self.report));
        if let Some(label) = &label {
            if !matches!(label.kind, LabelKind::Section | LabelKind::Exercise | LabelKind::Solution) {
                self.fault(range.start, format!("a heading cannot carry the label {}", label.written()));
            } else if title.is_empty() != (label.kind == LabelKind::Solution) {
                let rule =
                    if title.is_empty() { "needs a title" } else { "takes its title from the exercise" };
                self.fault(range.start, format!("the heading of {} {rule}", label.written()));
            }
        }
        let plain = title.replace(['`', '*', '_'], "");
        self.place(range.start..range.start + line.len(), Item::Heading { level, label, id, title, plain });
    }
}

/// The place behind the end of the element that was just opened.
fn after(events: &[(Event<'_>, Range<usize>)], from: usize, is_end: impl Fn(&TagEnd) -> bool) -> usize {
    let end = events[from..].iter().position(|(event, _)| matches!(event, Event::End(tag) if is_end(tag)));
    end.map_or(events.len(), |end| from + end + 1)
}

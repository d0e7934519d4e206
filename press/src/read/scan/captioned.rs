//! Figures, scenes and tables, with their captions.

use super::{Scan, after};
use crate::read::items::{Item, LabelKind, Words};
use crate::read::{label_syntax, margin_notes, tables};
use pulldown_cmark::{CowStr, Event, TagEnd};
use std::ops::Range;

impl<'a> Scan<'a, '_> {
    /// A figure, whose caption is read like any text, a table of the library, or a picture.
    pub(super) fn image(&mut self, dest_url: &CowStr<'a>, range: &Range<usize>, next: usize) {
        let (mut alone, mut marks) = (false, "");
        if let Some(paragraph) = &self.surroundings.paragraph {
            marks = self.text[range.end..paragraph.end].trim_end();
            alone =
                self.text[paragraph.start..range.start].trim().is_empty() && margin_notes::only_marks(marks);
        }
        if let Some(name) = dest_url.strip_prefix("table:") {
            if !alone {
                self.fault(range.start, format!("the table {name} must stand in a paragraph of its own"));
            }
            let caption = self.caption(next, marks);
            if caption.is_empty() {
                self.fault(range.start, format!("the table {name} has no caption that says what it holds"));
            }
            let name = name.to_owned();
            self.place(range.start..range.end + marks.len(), Item::LibraryTable { name, caption });
            return;
        }
        if is_picture(dest_url) {
            self.picture(dest_url, range, next);
            return;
        }
        let label = label_syntax::label(dest_url, range.start, &mut self.report);
        let Some(label) = label.filter(|label| matches!(label.kind, LabelKind::Figure | LabelKind::Scene))
        else {
            self.fault(
                range.start,
                format!("the image `{dest_url}` is not a figure of the book (`fig:name`), nor a scene, nor a picture beside the page (`photo.png`)"),
            );
            return;
        };
        let what = if label.kind == LabelKind::Scene { "scene" } else { "figure" };
        if !alone {
            self.fault(range.start, format!("the {what} {dest_url} must stand in a paragraph of its own"));
        }
        let caption = self.caption(next, if alone { marks } else { "" });
        if caption.is_empty() {
            self.fault(range.start, format!("the {what} {dest_url} has no caption that says what it shows"));
        }
        let item = match label.kind {
            LabelKind::Scene => Item::Scene { label, caption },
            _ => Item::Figure { label, caption },
        };
        self.place(range.start..range.end + marks.len(), item);
    }

    /// A picture, a file among the pages, which mdBook prints as it is.
    fn picture(&mut self, file: &str, range: &Range<usize>, next: usize) {
        let words = self.caption(next, "");
        self.place(range.clone(), Item::Picture { file: file.to_owned() });
        if self.text[range.end..].starts_with('{') {
            let message = "a picture has no attributes: it is as wide as its file, at most as the text";
            self.fault(range.end, message.to_owned());
        }
        if words.is_empty() {
            let message =
                format!("the picture {file} has no words for those who cannot see it: `![words]({file})`");
            self.fault(range.start, message);
        } else if !words.iter().all(|(event, _)| matches!(event, Event::Text(_) | Event::SoftBreak)) {
            self.fault(
                range.start,
                format!("the words of the picture {file} are read aloud: no formulas, no marks"),
            );
        }
    }

    /// The words of a figure, or of a table of the library, and the `marks` of notes behind it.
    fn caption(&self, next: usize, marks: &str) -> Words<'a> {
        let end = after(self.events, next, |tag| matches!(tag, TagEnd::Image));
        let behind = self.events[end..]
            .iter()
            .take_while(|(event, _)| !marks.is_empty() && !matches!(event, Event::End(_)));
        self.events[next..end - 1]
            .iter()
            .chain(behind)
            .map(|(event, range)| (event.clone(), range.start))
            .collect()
    }

    /// A table, with the caption below it.
    pub(super) fn table(&mut self, range: &Range<usize>, next: usize) {
        if self.surroundings.depth > 1 {
            self.fault(range.start, "a table cannot stand in a list or a quotation");
        }
        let table = tables::read(&self.events[next..]);
        let end = after(self.events, next, |tag| matches!(tag, TagEnd::Table));
        let (caption, place) =
            tables::caption(self.text, &self.events[end..]).unwrap_or((Vec::new(), range.clone()));
        if caption.is_empty() {
            self.fault(
                range.start,
                "the table has no caption: a paragraph right below it, `Table: what it holds.`",
            );
        }
        self.surroundings.end_of_table = place.end;
        self.place(range.start..place.end, Item::Table { table, caption });
    }
}

/// Whether an image is a picture in a file of the book.
fn is_picture(target: &str) -> bool {
    let kinds = [".png", ".jpg", ".jpeg", ".webp", ".gif", ".svg"];
    let target = target.to_ascii_lowercase();
    !target.contains(':') && kinds.iter().any(|kind| target.ends_with(kind))
}

//! Notes in the margin, and the marks in the text that lead to them.

use super::Printer;
use crate::read::items::Note;

impl Printer<'_, '_> {
    /// The mark of a note; the note itself stands behind the block.
    pub(super) fn note_mark(&mut self, name: &str) -> String {
        self.notes.push(name.to_owned());
        let number = self.notes.len();
        format!(
            "<a class=\"note-mark\" id=\"noteref-{name}\" href=\"#note-{name}\" role=\"doc-noteref\">{number}</a>"
        )
    }

    pub(super) fn note(&mut self, Note { name, words, .. }: &Note<'_>) -> String {
        let number = self.notes.iter().position(|mark| mark == name).map_or(0, |at| at + 1);
        let words = self.words_of(words, "note");
        format!(
            "\n\n<aside class=\"note\" id=\"note-{name}\" role=\"doc-footnote\" aria-label=\"Note {number}\"><a class=\"note-number\" \
             href=\"#noteref-{name}\" aria-label=\"{number}, back to the text\">{number}</a> {words}</aside>\n\n"
        )
    }
}

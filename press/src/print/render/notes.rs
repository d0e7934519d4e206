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

#[cfg(test)]
mod tests {
    use crate::print::render::tests::{maths, printed};

    #[test]
    fn a_note_stands_behind_the_block_that_refers_to_it() {
        let mark = |n: u8, name: &str| {
            format!(
                "<a class=\"note-mark\" id=\"noteref-{name}\" href=\"#note-{name}\" role=\"doc-noteref\">{n}</a>"
            )
        };
        let note = |n: u8, name: &str, words: &str| {
            format!(
                "<aside class=\"note\" id=\"note-{name}\" role=\"doc-footnote\" aria-label=\"Note {n}\"><a class=\"note-number\" \
                 href=\"#noteref-{name}\" aria-label=\"{n}, back to the text\">{n}</a> {words}</aside>"
            )
        };
        let page = "# A\n\n$$\na\n$$ {#eq:x}\n\nSo.[^b] More[^a]\nhere.\n\n[^a]: It's $x$.\n\n[^b]: From *b*\n    by @eq:x.\n\n\
                    - one[^c]\n- two\n\n> quoted[^d]\n\nEnd.\n\n[^c]: C.\n[^d]: D.\n";
        let printed = printed(page);
        let blocks: Vec<&str> =
            printed.split("\n\n").map(str::trim).filter(|block| !block.is_empty()).collect();
        let x = maths("$x$");
        assert_eq!(
            blocks[3..],
            [
                format!("So.{} More{}\nhere.", mark(1, "b"), mark(2, "a")),
                note(1, "b", "From <em>b</em> by <a href=\"a.md#eq-x\">(1.1)</a>."),
                note(2, "a", &format!("It’s <span class=\"tied\">{x}.</span>")),
                format!("- one{}\n- two", mark(3, "c")),
                note(3, "c", "C."),
                format!("> quoted{}", mark(4, "d")),
                note(4, "d", "D."),
                "End.".to_owned(),
            ]
        );
    }
}

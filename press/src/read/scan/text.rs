//! Runs of text, and what they hold that is no text.

use super::Scan;
use crate::colours;
use crate::read::font_coverage::Face;
use crate::read::items::Item;
use crate::read::{control_characters, label_syntax};
use live::numbers;
use std::ops::Range;

impl Scan<'_, '_> {
    /// A run of text that is neither code nor mathematics.
    pub(super) fn words(&mut self, text: &str, range: &Range<usize>) {
        self.shown(Face::Text, range);
        self.entities(text, range);
        let in_link = self.surroundings.in_link;
        let fault = |at, message| self.report.fault(at, message);
        self.items.extend(label_syntax::mentions(self.text, range, in_link, fault));
        self.stray_dollars(range.clone());
        self.foreign_maths(range);
        if self.surroundings.heading.is_none() && !self.behind_maths(range.start) {
            self.lost_labels(range);
            self.blanks(range);
            self.marked(range);
        }
    }

    /// Text that the page shows in this face.
    pub(super) fn shown(&mut self, face: Face, range: &Range<usize>) {
        if let Err((at, message)) = face.check(&self.text[range.clone()]) {
            self.fault(range.start + at, message);
        }
    }

    /// Characters that the page writes by their numbers or names, `&#x202e;` or `&omega;`.
    fn entities(&mut self, text: &str, range: &Range<usize>) {
        if self.text[range.clone()].starts_with('&') && text != &self.text[range.clone()] {
            control_characters::characters(text, |_, message| self.report.fault(range.start, message));
            if let Err((_, message)) = Face::Text.check(text) {
                self.fault(range.start, message);
            }
        }
    }

    /// `[words]{.role}`: words in the colour of a quantity, or for a screen alone. They may hold links.
    fn marked(&mut self, range: &Range<usize>) {
        for (at, _) in self.text[range.clone()].match_indices("{.") {
            let at = range.start + at;
            let Some(words) = self.text[..at].strip_suffix(']') else { continue };
            let paragraph = self.text[..at].rfind("\n\n").map_or(0, |blank| blank + 2);
            let role = &self.text[at + 2..];
            let mut closed = 0;
            let open = words[paragraph.min(words.len())..].rfind(|c| {
                closed += i32::from(c == ']') - i32::from(c == '[');
                closed < 0
            });
            let (Some(open), Some(end)) = (open, role.find('}')) else { continue };
            let open = paragraph + open;
            match colours::class_of(&role[..end]) {
                Ok(class) => {
                    self.place(open..open + 1, Item::MarkedStart(class));
                    self.place(at - 1..at + 2 + end + 1, Item::MarkedEnd);
                }
                Err(message) => self.fault(at, message),
            }
        }
    }

    /// Numbers in a run of text are not parted from their units, nor the ends of a range, `67–85`.
    fn blanks(&mut self, range: &Range<usize>) {
        for (at, dash) in self.text[range.clone()].match_indices('–') {
            let (at, end) = (range.start + at, range.start + at + dash.len());
            let [before, after] = [&self.text[range.start..at], &self.text[end..range.end]];
            if before.ends_with(|c: char| c.is_ascii_digit())
                && after.starts_with(|c: char| c.is_ascii_digit())
            {
                self.place(at..end, Item::Dash);
            }
        }
        for at in numbers::blanks(&self.text[range.clone()]).map(|at| range.start + at) {
            self.place(at..at + 1, Item::Blank);
        }
    }
}

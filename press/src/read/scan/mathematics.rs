//! Mathematics in the text of a page, and what looks like it.

use super::Scan;
use crate::read::items::{Item, LabelKind};
use crate::read::label_syntax;
use std::borrow::Cow;
use std::ops::Range;

impl<'a> Scan<'a, '_> {
    pub(super) fn inline(&mut self, range: &Range<usize>) {
        if self.surroundings.heading.is_some() {
            self.fault(range.start, "mathematics in a heading is lost in the sidebar: say it in words");
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

    /// Display mathematics: alone in its paragraph, but for a label behind it.
    pub(super) fn display(&mut self, range: &Range<usize>) {
        let paragraph = self.surroundings.paragraph.clone();
        let tex = self.unquoted(&self.text[range.start + 2..range.end - 2]);
        let rest = &self.text[range.end..];
        let mut end = range.end;
        let mut label = None;
        if rest.trim_start_matches([' ', '\t']).starts_with('{') {
            let line = &rest[..rest.find('\n').unwrap_or(rest.len())];
            end += line.trim_end().len();
            label = label_syntax::equation_label(line.trim(), range.end, &mut self.report);
        }
        let alone = paragraph.as_ref().is_some_and(|p| {
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

    /// A formula without the `>` of the quotation that it stands in: blanks in their place, so that a fault
    /// keeps its line.
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

    /// `\(x\)` and `\[y\]`, which other tools read as mathematics and Markdown as brackets.
    pub(super) fn foreign_maths(&mut self, range: &Range<usize>) {
        let before = self.text[..range.start].chars().next_back();
        if before == Some('\\') && self.text[range.clone()].starts_with(['(', '[']) {
            self.fault(range.start - 1, "`\\(` and `\\[` are not mathematics here: write $…$ or $$…$$");
        }
    }

    /// A dollar in plain text is mathematics that did not close.
    pub(super) fn stray_dollars(&mut self, range: Range<usize>) {
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

    /// Whether this place follows display mathematics in its paragraph: its label is read with it.
    pub(super) fn behind_maths(&self, offset: usize) -> bool {
        let before = &self.text[..offset];
        let formula = before.trim_end();
        formula.ends_with("$$") && before[formula.len()..].matches('\n').count() < 2
    }

    /// A label that nothing has read, in a run of text.
    pub(super) fn lost_labels(&mut self, range: &Range<usize>) {
        for (at, _) in self.text[range.clone()].match_indices("{#") {
            let written = &self.text[range.start + at + 2..];
            let kind = written.split_once(':').and_then(|(prefix, _)| LabelKind::from_prefix(prefix));
            if kind.is_some_and(|kind| kind != LabelKind::Citation) {
                self.fault(
                    range.start + at,
                    "a label stands behind the closing `$$` of an equation, or at the end of a heading `## …`",
                );
            }
        }
    }
}

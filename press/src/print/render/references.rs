//! References, `@eq:name`, and links: their words, and whether they lead somewhere.

use super::Printer;
use crate::book::{relative, resolve};
use crate::print::nonbreaking;
use crate::read::items::{Label, LabelKind, Mention};
use live::numbers::BLANK;

/// A reference as it is printed.
pub(super) struct Reference {
    pub(super) words: String,
    pub(super) target: String,
    /// What it refers to, for those who point at it; empty if its words say so.
    pub(super) title: String,
}

impl Printer<'_, '_> {
    /// A reference behind the text `before`.
    pub(super) fn mention(&mut self, mention: &Mention, before: &str, offset: usize) -> Option<Reference> {
        let found = match mention {
            Mention::Source(number) => self.registry.find_source(*number).map(|entry| {
                let words = format!("source{BLANK}{number}");
                Reference { words, target: format!("{}#source-{number}", entry.page), title: String::new() }
            }),
            Mention::Label(label) => {
                let pages = self.cited.entry(label.clone()).or_default();
                if pages.last().is_none_or(|&(last, _)| last != self.index) {
                    pages.push((self.index, false));
                }
                self.reference(label)
            }
        };
        match found {
            Ok(found) => Some(Reference {
                words: nonbreaking::in_place(found.words, before),
                target: relative(&self.page.path, &found.target),
                title: found.title,
            }),
            Err(message) => {
                self.fault(offset, message);
                None
            }
        }
    }

    /// A reference to `label`, from the root of the book.
    fn reference(&self, label: &Label) -> Result<Reference, String> {
        let entry = self.registry.find(label)?;
        let (number, mut title) = (&entry.number, String::new());
        let words = match label.kind {
            LabelKind::Equation => format!("({number})"),
            LabelKind::Figure if number.is_empty() => {
                return Err(format!("{} has no number by which to refer to it", label.written()));
            }
            LabelKind::Figure => format!("Figure{BLANK}{number}"),
            LabelKind::Scene => format!("Scene{BLANK}{number}"),
            LabelKind::Exercise => format!("Exercise{BLANK}{number}"),
            LabelKind::Solution => {
                let exercise =
                    self.registry.find(&Label { kind: LabelKind::Exercise, name: label.name.clone() })?;
                format!("Solution{BLANK}{}", exercise.number)
            }
            LabelKind::Section if number.is_empty() => format!("“{}”", entry.title),
            LabelKind::Section => {
                title.clone_from(&entry.title);
                if number.contains('.') { format!("§{number}") } else { format!("Chapter{BLANK}{number}") }
            }
            LabelKind::Citation => entry.title.replace(' ', BLANK),
        };
        Ok(Reference { words, target: format!("{}#{}", entry.page, label.id()), title })
    }

    /// A link to another page or to an anchor must lead somewhere.
    pub(super) fn check_link(&mut self, target: &str, offset: usize) {
        if target.starts_with("http://") || target.starts_with("https://") || target.starts_with("mailto:") {
            return;
        }
        let (path, anchor) = target.split_once('#').unwrap_or((target, ""));
        let page = match path.strip_suffix(".html") {
            _ if path.is_empty() => Some(self.page.path.clone()),
            Some(stem) => resolve(&self.page.path, &format!("{stem}.md")), // as raw HTML may write it
            None => resolve(&self.page.path, path),
        };
        let Some(page) = page.filter(|page| self.registry.has_page(page)) else {
            self.fault(offset, format!("the link to `{target}` leads to no page of the book"));
            return;
        };
        if !anchor.is_empty() && !self.registry.has_anchor(&page, anchor) {
            self.fault(
                offset,
                format!("the link to `{target}` leads to a page without the anchor `#{anchor}`"),
            );
        }
    }
}

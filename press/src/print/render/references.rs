//! References, `@eq:name`, and links: their words, and whether they lead somewhere.

use super::Printer;
use crate::book::{relative, resolve};
use crate::print::nonbreaking;
use crate::read::items::{Label, LabelKind, Mention};
use live::numbers::BLANK;

impl Printer<'_, '_> {
    /// The words of a reference behind the text `before`, and where it leads.
    pub(super) fn mention(
        &mut self,
        mention: &Mention,
        before: &str,
        offset: usize,
    ) -> Option<(String, String)> {
        let found = match mention {
            Mention::Source(number) => self.registry.find_source(*number).map(|entry| {
                (format!("source{BLANK}{number}"), entry.page.clone(), format!("source-{number}"))
            }),
            Mention::Label(label) => {
                let pages = self.cited.entry(label.clone()).or_default();
                if pages.last().is_none_or(|&(last, _)| last != self.index) {
                    pages.push((self.index, false));
                }
                self.words(label).map(|(words, page)| (words, page, label.id()))
            }
        };
        match found {
            Ok((words, page, id)) => {
                let words = nonbreaking::in_place(words, before);
                Some((words, format!("{}#{id}", relative(&self.page.path, &page))))
            }
            Err(message) => {
                self.fault(offset, message);
                None
            }
        }
    }

    /// What a reference to `label` says, and on which page it is.
    pub(super) fn words(&self, label: &Label) -> Result<(String, String), String> {
        let entry = self.registry.find(label)?;
        let words = match label.kind {
            LabelKind::Equation => format!("({})", entry.number),
            LabelKind::Figure if entry.number.is_empty() => {
                return Err(format!("{} has no number by which to refer to it", label.written()));
            }
            LabelKind::Figure => format!("Figure{BLANK}{}", entry.number),
            LabelKind::Scene => format!("Scene{BLANK}{}", entry.number),
            LabelKind::Exercise => format!("Exercise{BLANK}{}", entry.number),
            LabelKind::Solution => {
                let exercise =
                    self.registry.find(&Label { kind: LabelKind::Exercise, name: label.name.clone() })?;
                format!("Solution{BLANK}{}", exercise.number)
            }
            LabelKind::Section => format!("“{}”", entry.title),
            LabelKind::Citation => entry.title.replace(' ', BLANK),
        };
        Ok((words, entry.page.clone()))
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

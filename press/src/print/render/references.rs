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

#[cfg(test)]
mod tests {
    use crate::print::render::tests::printed;

    #[test]
    fn a_section_is_named_by_its_number_and_its_title_is_there_for_those_who_point() {
        let page = printed(
            "# A {#sec:a}\n\n## One\n\n## The \"two\" {#sec:two}\n\n### In it {#sec:in}\n\n@sec:two.[^n] @sec:in, @sec:a\n\n[^n]: @sec:two.\n",
        );
        for link in [
            "[§1.2](a.md#sec-two \"The &quot;two&quot;\").",
            "[§1.2](a.md#sec-in \"In it\"), [Chapter\u{a0}1](a.md#sec-a \"A\")",
            "<a href=\"a.md#sec-two\" title=\"The &quot;two&quot;\">§1.2</a>.",
        ] {
            assert!(page.contains(link), "{link} in {page}");
        }
    }

    #[test]
    fn brackets_around_the_number_of_an_equation_are_its_own() {
        let page = printed(
            "# A\n\n$$\na\n$$ {#eq:x}\n\nBy @eq:x (@eq:x, as in @eq:x) and (so)\n@eq:x.[^a]\n\n[^a]: By (@eq:x) @eq:x.\n",
        );
        let [x, bare, word] = ["(1.1)", "1.1", "Eq.\u{a0}1.1"].map(|words| format!("[{words}](a.md#eq-x)"));
        assert!(page.contains(&format!("By {x} ({bare}, as in {word}) and (so)\n{x}.")), "{page}");
        let [x, bare] = ["(1.1)", "1.1"].map(|words| format!("<a href=\"a.md#eq-x\">{words}</a>"));
        assert!(page.contains(&format!("By ({bare}) {x}.")), "{page}");
    }
}

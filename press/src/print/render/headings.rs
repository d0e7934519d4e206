//! Headings: the number of the chapter above its title, exercises and solutions that lead to each other.

use super::Printer;
use crate::book::relative;
use crate::read::items::{Label, LabelKind};
use html::escaped;
use live::numbers::BLANK;

impl Printer<'_, '_> {
    /// The title of a page of a numbered chapter, below the number of the chapter or, on a further page, a link to its
    /// first.
    pub(super) fn title(&self, heading: &str) -> Option<String> {
        let chapter = self.page.chapter?;
        let (class, words) = match self.chapters.get(&chapter) {
            Some((path, title)) if self.page.part.is_some() => {
                let up = relative(&self.page.path, path);
                ("kicker leaf", format!("<a href=\"{up}\">{chapter}{BLANK}{BLANK}{}</a>", escaped(title)))
            }
            _ => ("kicker", format!("Chapter {chapter}")),
        };
        let sections = self.registry.sections_before(self.page);
        let counts = format!("--chapter: {chapter}; --sections: {sections}");
        Some(format!("<p class=\"{class}\" style=\"{counts}\">{words}</p>\n\n{heading}"))
    }

    /// A heading with a label.
    pub(super) fn heading(&self, level: u8, label: &Label, title: &str) -> Option<String> {
        let marks = "#".repeat(usize::from(level));
        let id = label.id();
        let partner = match label.kind {
            LabelKind::Exercise => Label { kind: LabelKind::Solution, name: label.name.clone() },
            LabelKind::Solution => Label { kind: LabelKind::Exercise, name: label.name.clone() },
            _ => return Some(format!("{marks} {title} {{#{id}}}")),
        };
        let exercise = if label.kind == LabelKind::Exercise { label } else { &partner };
        let entry = self.registry.find(exercise).ok()?.clone();
        let place = self.registry.find(&partner).ok()?; // its absence is reported with the labels
        let target = format!("{}#{}", relative(&self.page.path, &place.page), partner.id());
        let (kind, there) = if label.kind == LabelKind::Exercise {
            ("Exercise", "Solution")
        } else {
            ("Solution", "Exercise")
        };
        Some(format!(
            "{marks} {kind} {}. {} {{#{id}}}\n\n<p class=\"turn\"><a href=\"{target}\">{there} {}</a></p>\n",
            entry.number, entry.title, entry.number
        ))
    }
}

#[cfg(test)]
mod tests {
    use crate::assets::Rendered;
    use crate::book::Page;
    use crate::print::render::render;

    #[test]
    fn the_number_of_the_chapter_stands_above_the_title() {
        let page = |path: &str, chapter, part: Option<&str>, text: &str| {
            Page::new("book", path.to_owned(), chapter, part.map(str::to_owned), text.to_owned())
        };
        let pages = [
            page("a/index.md", Some(4), None, "# A *top* {#sec:a}\n\n## One\n"),
            page("a/more.md", Some(4), Some("More"), "# B\n\n## Two {#sec:two}\n"),
            page("c.md", None, None, "# C\n"),
        ];
        let printed = render(&pages, &Rendered::default(), "", &[]).unwrap_or_default();
        let kicker = |class: &str, sections: u8, words: &str| {
            format!("<p class=\"{class}\" style=\"--chapter: 4; --sections: {sections}\">{words}</p>\n\n# ")
        };
        assert!(printed[0].starts_with(&kicker("kicker", 0, "Chapter 4")), "{}", printed[0]);
        let up = "<a href=\"index.md\">4\u{a0}\u{a0}A top</a>";
        assert!(printed[1].starts_with(&kicker("kicker leaf", 1, up)), "{}", printed[1]);
        assert_eq!(printed[2], "# C\n");
    }
}

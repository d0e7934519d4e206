//! Headings: the number of the chapter above its title, exercises and solutions that lead to each other.

use super::Printer;
use crate::book::relative;
use crate::html::escaped;
use crate::read::items::{Label, LabelKind};

impl Printer<'_, '_> {
    /// The title of a page of a numbered chapter, below the number of the chapter.
    pub(super) fn title(&self, heading: &str) -> Option<String> {
        let chapter = self.page.chapter?;
        // Only the sections of a chapter's first page have numbers.
        let (class, part) = match &self.page.part {
            None => ("kicker", String::new()),
            Some(part) => ("kicker leaf", format!(" · {}", escaped(part))),
        };
        Some(format!(
            "<p class=\"{class}\" style=\"--chapter: {chapter}\">Chapter {chapter}{part}</p>\n\n{heading}"
        ))
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
        let print = |chapter, part: Option<&str>| {
            let text = "# A {#sec:a}\n".to_owned();
            let page = Page::new("book", "a.md".to_owned(), chapter, part.map(str::to_owned), text);
            render(&[page], &Rendered::default(), "", &[]).unwrap_or_default().remove(0)
        };
        let kicker = |class: &str, words: &str| {
            format!("<p class=\"{class}\" style=\"--chapter: 4\">{words}</p>\n\n# A {{#sec-a}}\n")
        };
        assert_eq!(print(Some(4), None), kicker("kicker", "Chapter 4"));
        assert_eq!(print(Some(4), Some("Exercises")), kicker("kicker leaf", "Chapter 4 · Exercises"));
        assert_eq!(print(None, None), "# A {#sec-a}\n");
    }
}

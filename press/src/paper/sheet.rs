//! One page of the book, as it goes onto paper.

use super::page_number;
use crate::book::Page;
use crate::site::exercises::ANSWER;
use html::{Edits, Element};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

/// Of three lines at most, in letters: Chromium forgets about `widows` where such a paragraph follows its heading.
const SHORT: usize = 290;

/// What a page is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Text,
    Exercises,
    Solutions,
}

/// A heading that the contents may show.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Heading {
    pub(super) id: String,
    /// With its markup.
    pub(super) words: String,
}

#[derive(Debug)]
pub(super) struct Sheet {
    /// Of its chapter: the folder.
    pub(super) name: String,
    pub(super) number: Option<u32>,
    /// The part of the book that it opens a chapter of.
    pub(super) part: Option<String>,
    pub(super) kind: Kind,
    /// Whether it stands below the first page of a chapter.
    pub(super) is_leaf: bool,
    /// Its title and its sections.
    pub(super) headings: Vec<Heading>,
    pub(super) html: String,
}

impl Sheet {
    /// A page, as print.html holds it.
    pub(super) fn new(page: &Page, html: &str) -> Self {
        let kind = match page.path.rsplit('/').next() {
            Some("exercises.md") => Kind::Exercises,
            Some("solutions.md") => Kind::Solutions,
            _ => Kind::Text,
        };
        let found = html::named(html, &["h1", "h2", "a"]);
        let headings = ["h1", "h2"].iter().flat_map(|level| headings(html, &found, level)).collect();
        let html = if kind == Kind::Exercises { hints_last(html) } else { html.to_owned() };
        let html = if page.part.is_some() { lowered(&html) } else { html };
        Self {
            name: super::name(page).to_owned(),
            number: page.chapter,
            part: page.part_of_book.clone(),
            kind,
            is_leaf: page.part.is_some(),
            headings,
            html,
        }
    }

    /// Leaves of each solution its number, its title and its answer.
    pub(super) fn keep_answers(&mut self) {
        let found = html::named(&self.html, &["h2", "h3", "p"]);
        let mut kept = String::new();
        let mut title = String::new();
        for element in found {
            let inside = &self.html[element.inside.clone()];
            match element.name.as_str() {
                "p" => {
                    if let Some(answer) = inside.strip_prefix(ANSWER) {
                        let _ = writeln!(kept, "<p><strong>{title}</strong>\u{2002}{}</p>", answer.trim());
                    }
                }
                "h3" if element.get("id").is_some_and(|id| id.starts_with("sol-")) => {
                    let words = html::words(inside); // “Solution 4.1. Twice as hard”
                    title = html::escaped(words.split_once(' ').map_or(&*words, |(_, rest)| rest));
                }
                "h2" => kept += &self.html[element.whole].replace("Solutions", "Answers"),
                _ => {}
            }
        }
        self.html = kept;
        for heading in &mut self.headings {
            heading.words = heading.words.replace("Solutions", "Answers");
        }
    }

    pub(super) fn class(&self) -> &'static str {
        match (self.kind, self.is_leaf) {
            (Kind::Exercises, _) => "leaf exercises",
            (Kind::Solutions, _) => "leaf solutions",
            (Kind::Text, true) => "leaf",
            (Kind::Text, false) => "first",
        }
    }

    /// Its title without markup.
    pub(super) fn plain_title(&self) -> String {
        html::words(self.headings.first().map_or("", |heading| &heading.words))
    }

    /// Takes away the addresses of links that lead to nothing on this paper and into no network.
    pub(super) fn keep_links(&mut self, ids: &BTreeSet<String>) {
        self.html = html::unlinked(&self.html, |target| match target.strip_prefix('#') {
            Some(id) => !ids.contains(id),
            None => !["https://", "http://", "mailto:"].iter().any(|start| target.starts_with(start)),
        });
    }

    /// The id of its title, if it stands below a chapter's first page: references to it are by its title.
    pub(super) fn title_below(&self) -> Option<&str> {
        let title = self.headings.first().filter(|_| self.is_leaf && self.kind == Kind::Text);
        title.map(|heading| heading.id.as_str())
    }

    /// Its HTML for a PDF: the lines that lead from exercises to hints and solutions, and back, and references to sections
    /// and to pages by their `titles` have the numbers of pages.
    pub(super) fn for_pdf(&self, numbers: &BTreeMap<String, usize>, titles: &BTreeSet<&str>) -> String {
        let html = self.unfolded();
        let found = html::named(&html, &["p", "a", "span"]);
        let cited: Vec<&Element> = found.iter().filter(|element| element.is("span", "citing")).collect();
        let mut edits = Edits::default();
        let lines: Vec<&Element> = found.iter().filter(|element| element.is("p", "turn")).collect();
        for paragraph in found.iter().filter(|element| element.name == "p" && element.get("class").is_none())
        {
            if html::words(&html[paragraph.inside.clone()]).chars().count() < SHORT {
                edits.insert(paragraph.start_tag.start + "<p".len(), " class=\"short\"".to_owned());
            }
        }
        for link in found.iter().filter(|element| element.name == "a") {
            let Some(id) = link.get("href").and_then(|target| target.strip_prefix('#')) else { continue };
            if lines.iter().any(|line| line.holds(link)) {
                edits.insert(link.inside.end, format!(", page {}", page_number(id, numbers)));
            } else if html[link.inside.clone()].starts_with(['§', '“'])
                || titles.contains(id)
                    && !link.is("a", "header")
                    && !cited.iter().any(|list| list.holds(link))
            {
                edits.insert(link.inside.end, format!(", p.\u{a0}{}", page_number(id, numbers)));
            }
        }
        edits.applied(&html)
    }

    /// Its HTML with what answers its guesses moved to the end: on paper nothing folds, and no answer stands below its question.
    pub(super) fn unfolded(&self) -> String {
        let html = &self.html;
        let found = html::named(html, &["ol", "details", "summary"]);
        let is_below = |details: &Element, choices: &Element| {
            choices.whole.end <= details.whole.start
                && html[choices.whole.end..details.whole.start].trim().is_empty()
        };
        let choices = found.iter().filter(|found| found.name == "ol");
        let guess = |choices: &Element| {
            let details = found.iter().find(|found| found.name == "details" && is_below(found, choices))?;
            let summary = found.iter().find(|found| found.name == "summary" && details.holds(found))?;
            Some((choices.whole.end, details, summary.whole.end))
        };
        let guesses: Vec<_> = choices.filter_map(guess).collect();
        let name = self.headings.first().map_or(self.name.as_str(), |title| &title.id);
        let (mut edits, mut answers) = (Edits::default(), String::new());
        for (n, &(asked, details, answer)) in (1..).zip(&guesses) {
            let id = format!("guess-{n}-{name}");
            edits.insert(asked, format!("\n<p class=\"turn\"><a href=\"#{id}\">Answer</a></p>"));
            edits.remove(details.whole.clone());
            let answer = html[answer..details.inside.end].trim();
            let which = if guesses.len() > 1 {
                format!("<p><strong>Guess {n}</strong></p>\n")
            } else {
                String::new()
            };
            let _ = writeln!(answers, "<div id=\"{id}\">\n{which}{answer}\n</div>");
        }
        if !answers.is_empty() {
            let (level, end) = (if self.is_leaf { 3 } else { 2 }, html.len());
            edits.insert(end, format!("\n<h{level} class=\"hints\">The guess</h{level}>\n{answers}"));
        }
        edits.applied(html)
    }
}

/// The headings of a level, among the elements that were `found`.
fn headings<'a>(html: &'a str, found: &'a [Element], level: &'a str) -> impl Iterator<Item = Heading> + 'a {
    found.iter().filter(move |element| element.name == level).filter_map(|heading| {
        let link = found.iter().find(|link| link.is("a", "header") && heading.holds(link))?;
        Some(Heading { id: heading.get("id")?.to_owned(), words: html[link.inside.clone()].to_owned() })
    })
}

/// All headings a level lower, as those of a page below a chapter's; its title keeps its look.
fn lowered(html: &str) -> String {
    let mut edits = Edits::default();
    for (level, name) in ["h1", "h2", "h3", "h4", "h5"].into_iter().enumerate() {
        for heading in html::named(html, &[name]) {
            let class = if level == 0 { " class=\"page-title\"" } else { "" };
            let start = heading.start_tag.start;
            edits.replace(start..start + "<h1".len(), format!("<h{}{class}", level + 2));
            edits.replace(heading.inside.end..heading.whole.end, format!("</h{}>", level + 2));
        }
    }
    edits.applied(html)
}

/// Moves the hints of all exercises behind the last one, each with its number; on paper nothing folds.
fn hints_last(html: &str) -> String {
    let found = html::named(html, &["h2", "details", "summary", "p"]);
    let (mut edits, mut hints) = (Edits::default(), String::new());
    let exercises =
        found.iter().filter_map(|heading| Some((heading, heading.get("id")?.strip_prefix("ex-")?)));
    for (heading, name) in exercises {
        let rest = found.iter().skip_while(|element| element.whole.start < heading.whole.end);
        let own: Vec<&Element> = rest.take_while(|element| element.name != "h2").collect();
        let mut words = String::new();
        for details in own.iter().filter(|element| element.name == "details") {
            let summary = own.iter().find(|element| element.name == "summary" && details.holds(element));
            if let Some(summary) = summary.filter(|summary| &html[summary.inside.clone()] == "Hint") {
                words += &html[summary.whole.end..details.inside.end];
                edits.remove(details.whole.clone());
            }
        }
        if words.is_empty() {
            continue;
        }
        // “Exercise 4.1. Twice as hard”
        let title = html::words(&html[heading.inside.clone()]);
        let number = title.split(' ').find(|word| word.starts_with(|c: char| c.is_ascii_digit()));
        let number = number.unwrap_or_default().trim_end_matches('.');
        let _ = writeln!(
            hints,
            "<div class=\"hint\" id=\"hint-{name}\"><a class=\"number\" href=\"#ex-{name}\">{number}</a>{words}</div>"
        );
        if let Some(turn) = own.iter().find(|element| element.is("p", "turn")) {
            edits.insert(turn.inside.start, format!("<a href=\"#hint-{name}\">Hint</a> "));
        }
    }
    if !hints.is_empty() {
        edits.insert(html.len(), format!("\n<h2 class=\"hints\">Hints</h2>\n{hints}"));
    }
    edits.applied(html)
}

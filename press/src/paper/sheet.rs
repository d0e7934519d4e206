//! One page of the book, as it goes onto paper.

use crate::book::Page;
use crate::head::plain;
use std::collections::BTreeSet;
use std::fmt::Write as _;

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
    pub(super) number: Option<u32>,
    /// The part of the book that it opens a chapter of.
    pub(super) part: Option<String>,
    pub(super) kind: Kind,
    /// Whether it stands below the first page of a chapter.
    is_leaf: bool,
    /// Its title and its sections.
    pub(super) headings: Vec<Heading>,
    pub(super) html: String,
}

impl Sheet {
    /// A page, as print.html holds it.
    pub(super) fn new(page: &Page, part: Option<String>, html: &str) -> Self {
        let kind = match page.path.rsplit('/').next() {
            Some("exercises.md") => Kind::Exercises,
            Some("solutions.md") => Kind::Solutions,
            _ => Kind::Text,
        };
        let headings = ["<h1 id=\"", "<h2 id=\""].iter().flat_map(|tag| headings(html, tag)).collect();
        let html = if kind == Kind::Exercises { hints_last(html) } else { html.to_owned() };
        let html = if page.part.is_some() { lowered(&html) } else { html };
        Self { number: page.chapter, part, kind, is_leaf: page.part.is_some(), headings, html }
    }

    pub(super) fn is_leaf(&self) -> bool {
        self.is_leaf
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
        plain(self.headings.first().map_or("", |heading| &heading.words))
    }

    pub(super) fn ids(&self) -> impl Iterator<Item = String> {
        let ids = self.html.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next());
        ids.map(str::to_owned)
    }

    /// Takes away the addresses of links that lead to nothing on this paper and into no network.
    pub(super) fn keep_links(&mut self, ids: &BTreeSet<String>) {
        let mut parts = self.html.split("<a ");
        let mut html = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let (tag, rest) = part.split_once('>').unwrap_or((part, ""));
            let target =
                tag.split_once("href=\"").and_then(|(_, rest)| rest.split('"').next()).unwrap_or_default();
            let is_alive = match target.strip_prefix('#') {
                Some(id) => ids.contains(id),
                None => ["https://", "http://", "mailto:"].iter().any(|start| target.starts_with(start)),
            };
            let tag = if is_alive { tag.to_owned() } else { tag.replace(&format!("href=\"{target}\""), "") };
            let _ = write!(html, "<a {tag}>{rest}");
        }
        self.html = html;
        // A line that leads to a solution is nothing where there is none.
        self.html = without(&self.html, "<p class=\"turn\">", "</p>", |line| !line.contains("href="));
    }
}

/// All headings whose tag begins so.
fn headings<'a>(html: &'a str, tag: &'a str) -> impl Iterator<Item = Heading> + 'a {
    html.split(tag).skip(1).filter_map(|rest| {
        let (id, rest) = rest.split_once('"')?;
        let (inside, _) = rest.split_once("</h")?;
        let words = inside.split_once("<a class=\"header\"")?.1.split_once('>')?.1.strip_suffix("</a>")?;
        Some(Heading { id: id.to_owned(), words: words.to_owned() })
    })
}

/// All headings a level lower, as those of a page below a chapter's; its title keeps its look.
fn lowered(html: &str) -> String {
    let mut html = html.to_owned();
    for level in (1..6).rev() {
        let class = if level == 1 { " class=\"page-title\"" } else { "" };
        html = html.replace(&format!("<h{level} "), &format!("<h{}{class} ", level + 1));
        html = html.replace(&format!("</h{level}>"), &format!("</h{}>", level + 1));
    }
    html
}

/// Moves the hints of all exercises behind the last one, each with its number; on paper nothing folds.
fn hints_last(html: &str) -> String {
    const HINT: &str = "<details>\n<summary>Hint</summary>";
    let mut exercises = html.split("<h2 id=\"ex-");
    let mut text = exercises.next().unwrap_or_default().to_owned();
    let mut hints = String::new();
    for exercise in exercises {
        let (name, rest) = exercise.split_once('"').unwrap_or((exercise, ""));
        // “Exercise 4.1. Twice as hard”
        let heading = plain(
            rest.split_once('>').map_or("", |(_, rest)| rest.split("</h2>").next().unwrap_or_default()),
        );
        let number =
            heading.trim_start_matches(|c: char| !c.is_ascii_digit()).split(' ').next().unwrap_or_default();
        let mut rest = rest.to_owned();
        let mut words = String::new();
        while let Some((before, hint, after)) = rest.split_once(HINT).and_then(|(before, tail)| {
            let (hint, after) = tail.split_once("</details>")?;
            Some((before.to_owned(), hint.to_owned(), after.to_owned()))
        }) {
            words += &hint;
            rest = before + after.trim_start_matches('\n');
        }
        if !words.is_empty() {
            let _ = writeln!(
                hints,
                "<div class=\"hint\" id=\"hint-{name}\"><a class=\"number\" href=\"#ex-{name}\">{}</a>{words}</div>",
                number.trim_end_matches('.')
            );
            let turn = "<p class=\"turn\">";
            rest = rest.replacen(turn, &format!("{turn}<a href=\"#hint-{name}\">Hint</a> "), 1);
        }
        let _ = write!(text, "<h2 id=\"ex-{name}\"{rest}");
    }
    if hints.is_empty() {
        return text;
    }
    format!("{text}\n<h2 class=\"hints\">Hints</h2>\n{hints}")
}

/// The lines that lead from exercises to hints and solutions, and back, with the numbers of pages.
pub(super) fn numbered(html: &str) -> String {
    let mut parts = html.split("<p class=\"turn\">");
    let mut numbered = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (line, rest) = part.split_once("</p>").unwrap_or((part, ""));
        numbered += "<p class=\"turn\">";
        for link in line.split("<a href=\"#").skip(1) {
            let (id, words) = link.split_once("\">").unwrap_or_default();
            let words = words.split("</a>").next().unwrap_or_default();
            let page = format!("page <span class=\"on\" data-of=\"{id}\"></span>");
            let _ = write!(numbered, "<a href=\"#{id}\">{words}, {page}</a> ");
        }
        let _ = write!(numbered, "</p>{rest}");
    }
    numbered
}

/// A text without those of its pieces from a mark to the next end of which something is true.
fn without(html: &str, from: &str, to: &str, is_out: impl Fn(&str) -> bool) -> String {
    let mut parts = html.split(from);
    let mut left = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(to) {
            Some((inside, rest)) if is_out(inside) => left += rest,
            _ => left += &format!("{from}{part}"),
        }
    }
    left
}

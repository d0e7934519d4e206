//! A chapter as slides, made of the parts of its pages: the guess, the still of its scene, its figures and equations, its
//! common mistakes, and what its teaching notes put to the vote. Nothing on them is written for them.

use super::{Paper, Sheet};
use anyhow::{Context as _, Result, ensure};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use html::Element;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// So many figures and equations stand on slides: those to which the book refers most.
const MOST: usize = 4;

/// The files of the theme that say how slides look, and the script that fits and turns them.
const STYLES: [&str; 4] = ["fonts/fonts.css", "maths.css", "figures.css", "slides.css"];
const SCRIPT: &str = "slides.js";

/// A page of the book, taken apart.
struct Parts<'a> {
    html: &'a str,
    found: Vec<Element>,
}

impl<'a> Parts<'a> {
    fn of(html: &'a str) -> Self {
        let names = ["h1", "h2", "p", "ol", "details", "summary", "figure", "figcaption", "div", "a"];
        Self { html, found: html::named(html, &names) }
    }

    fn inside(&self, element: &Element) -> &'a str {
        &self.html[element.inside.clone()]
    }

    fn all<'b>(&'b self, name: &'b str, class: &'b str) -> impl Iterator<Item = &'b Element> {
        self.found.iter().filter(move |element| element.is(name, class))
    }

    /// The element of this name that ends where another begins.
    fn before(&self, next: &Element, name: &str) -> Option<&Element> {
        let ends = |one: &&Element| {
            let between = self.html.get(one.whole.end..next.whole.start);
            one.name == name && between.is_some_and(|between| between.trim().is_empty())
        };
        self.found.iter().find(ends)
    }

    /// What stands within an element.
    fn within(&self, outer: &Element, name: &str, class: &str) -> &'a str {
        self.all(name, class).find(|inner| outer.holds(inner)).map_or("", |inner| self.inside(inner))
    }

    /// The drawing of a figure or the still of a scene, with what is said of it.
    fn picture(&self, figure: &Element) -> String {
        let drawing = self.all("div", "drawing").find(|drawing| figure.holds(drawing));
        let drawing = drawing.map_or("", |drawing| &self.html[drawing.whole.clone()]);
        let caption = self.found.iter().find(|inner| inner.name == "figcaption" && figure.holds(inner));
        let caption = caption.map_or("", |caption| self.inside(caption));
        let caption = caption.split("<a class=\"save\"").next().unwrap_or_default();
        format!("{}<p class=\"caption\">{caption}</p>", drawing.replace("max-width:", "--most:"))
    }

    /// The question above a guess, its choices and what answers it.
    fn guess(&self) -> Option<(&'a str, &'a str, &'a str)> {
        let mut folds = self.found.iter().filter(|fold| fold.name == "details");
        let (fold, choices) = folds.find_map(|fold| Some((fold, self.before(fold, "ol")?)))?;
        let summary = self.found.iter().find(|inner| inner.name == "summary" && fold.holds(inner))?;
        let answer = &self.html[summary.whole.end..fold.inside.end];
        Some((self.inside(self.before(choices, "p")?), &self.html[choices.whole.clone()], answer))
    }

    /// The first heading, and above it which chapter it is.
    fn title(&self) -> &'a str {
        let h1 = self.found.iter().find(|element| element.name == "h1");
        let link = h1.and_then(|h1| self.all("a", "header").find(|link| h1.holds(link)));
        link.map_or("", |link| self.inside(link))
    }

    fn opening(&self, book: &str) -> String {
        let h1 = self.found.iter().position(|element| element.name == "h1").unwrap_or_default();
        let first = self.found[h1..].iter().find(|element| element.name == "p");
        let kicker = self.all("p", "kicker").next().map_or("", |kicker| self.inside(kicker));
        let first = first.map_or("", |first| self.inside(first));
        format!("<p class=\"kicker\">{book} · {kicker}</p><h1>{}</h1><p>{first}</p>", self.title())
    }

    /// Equations with their numbers, below the titles of their sections.
    fn equations(&self, equations: &[&Element]) -> String {
        let (mut out, mut last) = (String::new(), "");
        for equation in equations {
            let is_above = |link: &&Element| link.whole.end <= equation.whole.start;
            let above = self.all("a", "header").filter(is_above).last().map_or("", |link| self.inside(link));
            if above != last {
                let _ = write!(out, "<p class=\"section\">{above}</p>");
                last = above;
            }
            let [formula, number] =
                [("div", "formula"), ("a", "number")].map(|(name, class)| self.within(equation, name, class));
            let _ =
                write!(out, "<div class=\"equation\"><div class=\"formula\">{formula}</div>{number}</div>");
        }
        out
    }

    /// What a page says behind a bold beginning, in each paragraph that is whole without what follows it.
    fn says(&self, bold: &str) -> impl Iterator<Item = &'a str> {
        let bold = format!("<strong>{bold}</strong>");
        let paragraphs = self.found.iter().filter(|element| element.name == "p");
        let whole = paragraphs
            .map(|p| self.inside(p))
            .filter(|words| html::words(words).ends_with(['.', '?', ')', '”']));
        whole.filter_map(move |words| Some(&words[words.find(&bold)?..]))
    }
}

/// A paragraph whose bold beginning becomes a title.
fn titled(paragraph: &str) -> String {
    let parts = paragraph.strip_prefix("<strong>").and_then(|rest| rest.split_once("</strong>"));
    parts.map_or_else(
        || format!("<p>{paragraph}</p>"),
        |(title, rest)| format!("<h2>{}</h2><p>{rest}</p>", title.trim_end_matches('.')),
    )
}

/// What stands on a page between the heading of this id and the next of its level.
fn section<'a>(sheet: &'a Sheet, id: &str) -> Option<&'a str> {
    let headings = html::named(&sheet.html, &["h2", "h3"]);
    let at = headings.iter().position(|heading| heading.get("id") == Some(id))?;
    let next = headings[at + 1..].iter().find(|heading| heading.name == headings[at].name);
    Some(&sheet.html[headings[at].whole.end..next.map_or(sheet.html.len(), |next| next.whole.start)])
}

/// A question to vote on.
#[derive(Debug, PartialEq, Eq)]
struct Vote<'a> {
    question: &'a str,
    choices: Vec<String>,
    /// The letter of the right one and what is said of it.
    answer: &'a str,
}

/// A choice without what parts it from the next.
fn bare(choice: &str) -> String {
    let (words, tie) = choice.strip_suffix("</span>").map_or((choice, ""), |words| (words, "</span>"));
    words.trim_end_matches([',', '.']).to_owned() + tie
}

/// The questions of `**Vote.** *Question* (A) one, (B) another. **B**: why. *Next question* (A) …`; `None` if they are not so.
fn votes(paragraph: &str) -> Option<Vec<Vote<'_>>> {
    const FIRST: &str = "</em> (A) ";
    let ends: Vec<usize> = paragraph.match_indices(FIRST).map(|(end, _)| end).collect();
    let starts: Vec<usize> = ends.iter().map(|end| paragraph[..*end].rfind("<em>")).collect::<Option<_>>()?;
    let vote = |n: usize| {
        let rest = &paragraph[ends[n] + FIRST.len()..*starts.get(n + 1).unwrap_or(&paragraph.len())];
        let at = rest.find("<strong>")?;
        let (mut choices, mut left) = (Vec::new(), rest[..at].trim_end());
        for mark in [" (B) ", " (C) ", " (D) "] {
            if let Some((one, more)) = left.split_once(mark) {
                choices.push(bare(one));
                left = more;
            }
        }
        choices.push(bare(left));
        (choices.len() > 1).then_some(())?;
        Some(Vote { question: &paragraph[starts[n] + 4..ends[n]], choices, answer: rest[at..].trim() })
    };
    (0..ends.len()).map(vote).collect::<Option<Vec<_>>>().filter(|votes| !votes.is_empty())
}

impl Paper {
    /// The slides of a chapter of the whole book, a page that loads nothing; `theme` is the folder with its look.
    ///
    /// # Errors
    /// If a file of the look cannot be read, the page has nothing to show, or its notes ask for a vote in another form.
    pub fn slides(&self, theme: &Path, chapter: &str) -> Result<String> {
        let sheet = self.sheets.iter().find(|sheet| sheet.name == chapter && !sheet.is_leaf);
        let page = Parts::of(&sheet.context("the chapter is not in the book")?.html);
        let mut slides = vec![("title", page.opening(&self.settings.title))];
        if let Some((question, choices, _)) = page.guess() {
            slides.push(("text", titled(question) + choices));
        }
        if let Some(scene) = page.all("figure", "scene").next() {
            slides.push(("picture", page.picture(scene)));
        }
        if let Some((.., answer)) = page.guess() {
            slides.push(("text", format!("<h2>The answer</h2>{answer}")));
        }
        let figures = self.most_cited(page.all("figure", "figure"));
        slides.extend(figures.iter().map(|figure| ("picture", page.picture(figure))));
        let equations = self.most_cited(page.all("div", "numbered"));
        if !equations.is_empty() {
            slides.push(("equations", page.equations(&equations)));
        }
        let mistakes: Vec<String> =
            page.says("A common mistake").take(2).map(|words| format!("<p>{words}</p>")).collect();
        if !mistakes.is_empty() {
            slides.push(("text", format!("<h2>What goes wrong</h2>{}", mistakes.concat())));
        }
        let notes = self.sheets.iter().find_map(|sheet| section(sheet, &format!("sec-notes-{chapter}")));
        for paragraph in Parts::of(notes.unwrap_or_default()).says("Vote.") {
            let votes = votes(paragraph)
                .context("a vote is written `**Vote.** *Question* (A) one, (B) another. **B**: why.`")?;
            for Vote { question, choices, answer } in votes {
                let choices: String = choices.iter().map(|choice| format!("<li>{choice}</li>")).collect();
                let vote = format!(
                    "<h2>Vote</h2><p>{question}</p><ol type=\"A\">{choices}</ol><p class=\"answer\">{answer}</p>"
                );
                slides.extend([("text asked", vote.clone()), ("text", vote)]);
            }
        }
        ensure!(slides.len() > 1, "there is nothing on the page `{chapter}` that slides show");
        self.bound(theme, page.title(), &slides)
    }

    /// The slides as one page, with all that it needs.
    fn bound(&self, theme: &Path, title: &str, slides: &[(&str, String)]) -> Result<String> {
        let read =
            |name: &str| fs::read(theme.join(name)).with_context(|| theme.join(name).display().to_string());
        let text = |name: &str| read(name).map(|bytes| html::text(&bytes));
        let mut style = STYLES.into_iter().map(text).collect::<Result<String>>()?;
        const LOADS: [&str; 2] = ["{{ resource \"", "\" }}"];
        while let Some((before, (name, after))) =
            style.split_once(LOADS[0]).and_then(|(before, rest)| Some((before, rest.split_once(LOADS[1])?)))
        {
            let font = BASE64_STANDARD.encode(read(name)?);
            style = format!("{before}data:font/woff2;base64,{font}{after}");
        }
        let settings = &self.settings;
        let about = [settings.title.clone(), self.edition_in_words(), settings.licence.clone()].join(". ");
        let mut body = String::new();
        for (n, (class, slide)) in slides.iter().enumerate() {
            let foot: &str = if n == 0 { &about } else { title };
            let slide = html::unlinked(slide, |_| true);
            let _ = writeln!(
                body,
                "<section class=\"slide {class}\"><div>{slide}</div><footer><span>{foot}</span><span>{}</span></footer></section>",
                n + 1
            );
        }
        Ok(format!(
            "<!DOCTYPE html>\n<html lang=\"{}\" class=\"light\">\n<head>\n<meta charset=\"UTF-8\">\n<title>{title} – {}</title>\n\
             <meta name=\"description\" content=\"{}\">\n<style>\n{style}</style>\n</head>\n<body>\n<main>\n{body}</main>\n<script>\n{}</script>\n</body>\n</html>\n",
            settings.language,
            settings.title,
            about,
            text(SCRIPT)?
        ))
    }

    /// Those of some elements to which the book refers most, in their own order.
    fn most_cited<'a>(&self, elements: impl Iterator<Item = &'a Element>) -> Vec<&'a Element> {
        let links = |element: &Element| {
            let link = format!("href=\"#{}\"", element.get("id").unwrap_or_default());
            self.sheets.iter().map(|sheet| sheet.html.matches(&link).count()).sum::<usize>()
        };
        let mut found: Vec<&Element> = elements.collect();
        found.sort_by_cached_key(|element| std::cmp::Reverse(links(element)));
        found.truncate(MOST);
        found.sort_by_key(|element| element.whole.start);
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn votes_are_read_and_others_refused() {
        let two = "<strong>Vote.</strong> <em>It is</em> (A) 0.5 (or so), (B) two, (C) three. <strong>B</strong>: why. A adds <em>two</em>. \
                   <em>And?</em> (A) <span>x,</span> (B) <span>y.</span> <strong>A</strong>, by all.";
        let vote = |question, choices: &[&str], answer| Vote {
            question,
            choices: choices.iter().map(|one| (*one).to_owned()).collect(),
            answer,
        };
        let expected = [
            vote("It is", &["0.5 (or so)", "two", "three"], "<strong>B</strong>: why. A adds <em>two</em>."),
            vote("And?", &["<span>x</span>", "<span>y</span>"], "<strong>A</strong>, by all."),
        ];
        assert_eq!(votes(two).as_deref(), Some(&expected[..]));
        for wrong in [
            "<em>It is</em> one or two.",
            "<em>It is</em> (A) one, (B) two, and why.",
            "<em>It is</em> (A) one, (B) two. B: why.",
            "<em>It is</em> (A) one. <strong>A</strong>: why.",
            "(A) one, (B) two. <strong>B</strong>: why.",
        ] {
            assert_eq!(votes(wrong), None, "{wrong}");
        }
    }
}

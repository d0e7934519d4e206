//! The book on paper: what Chromium prints as one PDF, or a chapter of it as a handout; as an EPUB; and a chapter as slides.
//!
//! mdBook puts all pages into one, `print.html`, with ids that are unique in the book. Its parts are arranged anew
//! here: a title page with version and commit, contents with the numbers of pages, every chapter with its further
//! pages and its exercises below it, their hints behind the last of them, and the solutions in an appendix. What needs
//! a number of a page is written twice: the first print says where everything has come to stand.

mod epub;
mod packed;
mod pdf;
mod sheet;
mod slides;

pub use pdf::{browser, numbers, print};

use crate::book::Page;
use crate::mdbook;
use crate::read::disk;
use crate::site::licence::Licence;
use crate::site::package::Package;
use crate::site::{solutions, version_stamp};
use anyhow::{Context as _, Result, ensure};
use html::{Edits, Element, escaped};
use mdbook_driver::config::Config;
use sheet::{Kind, Sheet};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// What of the solutions goes onto paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Solutions {
    /// Nothing of them.
    None,
    /// All of them.
    Whole,
    /// Their answers, and nothing but these.
    Answers,
}

/// What stands for the number of a page that is not known yet; as long as such a number.
const UNKNOWN: &str = "000";

/// A book or a handout, taken from a built site and ready to be printed.
#[derive(Debug)]
pub struct Paper {
    settings: Settings,
    /// What the pages load.
    head: String,
    edition: String,
    /// The day of its commit.
    day: Option<String>,
    /// Whether it is the whole book.
    is_whole: bool,
    sheets: Vec<Sheet>,
}

/// `laundromat` for `laundromat/index.md`, `preface` for `preface.md`.
fn name(page: &Page) -> &str {
    let path = page.path.as_str();
    path.split_once('/').map_or(path.trim_end_matches(".md"), |(folder, _)| folder)
}

/// The title of a page, from its Markdown.
fn title(text: &str) -> String {
    let line = text.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or_default();
    line.split(" {#").next().unwrap_or_default().trim().to_owned()
}

/// The name of what somebody asks to have printed alone: a chapter, by its folder or its number, or a page without one.
///
/// # Errors
/// If there is none: a message that lists those that there are.
pub fn chapter(pages: &[Page], asked: &str) -> Result<String> {
    let all = || pages.iter().filter(|page| page.part.is_none());
    let number = |page: &Page| page.chapter.map_or(String::new(), |number| number.to_string());
    let is_it = |page: &&Page| {
        name(page) == asked.trim_end_matches('/') || !asked.is_empty() && number(page) == asked
    };
    all().find(is_it).map(|page| name(page).to_owned()).with_context(|| {
        let line = |page| format!("\n  {:>2}  {:<20} {}", number(page), name(page), title(&page.text));
        format!("there is no chapter `{asked}`; there are{}", all().map(line).collect::<String>())
    })
}

impl Paper {
    /// The whole book, or one chapter of it with what is asked for of its solutions, from the site that was built from `root`.
    ///
    /// # Errors
    /// If a file cannot be read, or the site is not one of this book.
    pub fn read(root: &Path, site: &Path, chapter: Option<&str>, solutions: Solutions) -> Result<Self> {
        let (_, mut pages) = disk::from_disk(root)?;
        let config = mdbook::settings(root)?;
        if solutions::are_hidden(&config)? {
            pages.retain(|page| !solutions::stand_on(&page.text));
        }
        let printed = site.join("print.html");
        let printed = fs::read_to_string(&printed).with_context(|| printed.display().to_string())?;
        let elements = html::named(&printed, &["link", "script", "main", "ul", "div"]);
        let pieces = pieces(&printed, &elements);
        let (found, named) = (pieces.len(), pages.len());
        ensure!(found == named, "print.html holds {found} pages, SUMMARY.md {named}");
        let asked =
            pages.iter().zip(pieces).filter(|(page, _)| chapter.is_none_or(|chapter| name(page) == chapter));
        let mut sheets: Vec<Sheet> = asked
            .map(|(page, html)| Sheet::new(page, html))
            .filter(|sheet| match solutions {
                Solutions::None => sheet.kind != Kind::Solutions,
                Solutions::Whole => true,
                Solutions::Answers => sheet.kind == Kind::Solutions,
            })
            .collect();
        if solutions == Solutions::Answers {
            sheets.iter_mut().for_each(Sheet::keep_answers);
        }
        if chapter.is_none() {
            // Below the pages that belong to no chapter at the end: what one looks up comes last.
            sheets.sort_by_key(|sheet| sheet.kind == Kind::Solutions);
        }
        let ids: BTreeSet<String> = sheets.iter().flat_map(|sheet| html::ids(&sheet.html)).collect();
        for sheet in &mut sheets {
            sheet.keep_links(&ids);
        }
        Ok(Self {
            settings: Settings::read(config)?,
            head: head(&printed, &elements),
            edition: version_stamp::edition(root, Package::read(root).as_ref()),
            day: version_stamp::day(root),
            is_whole: chapter.is_none(),
            sheets,
        })
    }

    /// The page that Chromium prints, with the numbers of its pages as far as they are known. It loads its style sheets
    /// from the site, whose address is `site` and ends with a slash.
    #[must_use]
    pub fn html(&self, site: &str, numbers: &BTreeMap<String, usize>) -> String {
        let title = match self.sheets.first() {
            Some(first) if !self.is_whole => format!("{} – {}", first.plain_title(), self.settings.title),
            _ => self.settings.title.clone(),
        };
        let head = moved(&self.head, site, &["link", "script"]);
        let mut body =
            if self.is_whole { self.title_page() + &self.contents(numbers) } else { String::new() };
        let mut running = String::new();
        let titles: BTreeSet<&str> = self.sheets.iter().filter_map(Sheet::title_below).collect();
        for (n, sheets) in self.chapters().iter().enumerate() {
            let _ = write!(running, "{}", self.running_head(n, sheets[0]));
            let _ = writeln!(body, "<section class=\"folio\" style=\"page: chapter-{n}\">");
            if self.is_whole && sheets[0].kind == Kind::Solutions && n == self.first_of_appendix() {
                let _ = writeln!(body, "<h1 id=\"{APPENDIX}\">Solutions</h1>");
            }
            if n == 0 && !self.is_whole {
                body += &self.letterhead();
            }
            for sheet in sheets {
                let _ = writeln!(
                    body,
                    "<section class=\"{}\">\n{}\n</section>",
                    sheet.class(),
                    moved(&sheet.for_pdf(numbers, &titles), site, &["img"])
                );
            }
            body += "</section>\n";
        }
        format!(
            "<!DOCTYPE html>\n<html lang=\"{}\" class=\"light\">\n<head>\n<meta charset=\"UTF-8\">\n<title>{title}</title>\n\
             {head}<style>\n{running}</style>\n</head>\n<body>\n<div class=\"content paper\">\n<main>\n{body}</main>\n</div>\n\
             {HIGHLIGHT}</body>\n</html>\n",
            self.settings.language
        )
    }

    /// How many pages of the book it holds.
    #[must_use]
    pub fn length(&self) -> usize {
        self.sheets.len()
    }

    /// The title of the book as the name of a file: `things-that-spin`.
    #[must_use]
    pub fn file_name(&self) -> String {
        let words = html::words(&self.settings.title).to_lowercase();
        let words: Vec<&str> =
            words.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
        words.join("-")
    }

    /// The sheets that stand below one running head: a chapter, or its solutions.
    fn chapters(&self) -> Vec<Vec<&Sheet>> {
        let mut chapters: Vec<Vec<&Sheet>> = Vec::new();
        for sheet in &self.sheets {
            let goes_on = |last: &&mut Vec<&Sheet>| {
                sheet.is_leaf
                    && (sheet.kind != Kind::Solutions || !self.is_whole)
                    && last[0].number == sheet.number
            };
            match chapters.last_mut().filter(goes_on) {
                Some(last) => last.push(sheet),
                None => chapters.push(vec![sheet]),
            }
        }
        chapters
    }

    /// The place of the first chapter whose solutions follow; past the last if none do.
    fn first_of_appendix(&self) -> usize {
        let chapters = self.chapters();
        chapters.iter().position(|sheets| sheets[0].kind == Kind::Solutions).unwrap_or(chapters.len())
    }

    /// What stands above the pages of a chapter.
    fn running_head(&self, n: usize, first: &Sheet) -> String {
        let number = first.number.map_or(String::new(), |number| format!("{number}\u{2002}"));
        let number = if first.kind == Kind::Solutions { String::new() } else { number };
        let (book, mut chapter) = (html::words(&self.settings.title), number + &first.plain_title());
        if chapter == book {
            chapter.clear(); // the cover, which has the title of the book
        }
        let [book, chapter] = [book, chapter].map(|words| quoted(&words));
        format!(
            "@page chapter-{n} {{ @top-left {{ content: {book}; }} @top-right {{ content: {chapter}; }} }}\n"
        )
    }

    fn edition_in_words(&self) -> String {
        if self.edition.is_empty() { String::new() } else { format!("version {}", self.edition) }
    }

    fn title_page(&self) -> String {
        format!(
            "<section class=\"title-page\">\n<p class=\"title\">{}</p>\n<p>{}</p>\n<p>{}</p>\n<p class=\"licence\">{}<br>\n{}</p>\n\
             </section>\n",
            self.settings.title,
            self.settings.description,
            self.settings.authors,
            self.edition_in_words(),
            self.settings.licence,
        )
    }

    /// What stands at the head of a handout.
    fn letterhead(&self) -> String {
        format!(
            "<p class=\"letterhead\">From <em>{}</em>, {}. {}</p>\n",
            self.settings.title,
            self.edition_in_words(),
            self.settings.licence,
        )
    }

    /// The chapters, their sections and further pages, and where they begin.
    fn contents(&self, numbers: &BTreeMap<String, usize>) -> String {
        let line = |class: &str, id: &str, count: &str, words: &str| {
            format!(
                "<li class=\"{class}\"><a href=\"#{id}\"><span class=\"count\">{count}</span><span>{words}</span>\
                 <span class=\"dots\"></span>{}</a></li>\n",
                page_number(id, numbers)
            )
        };
        let mut lines = String::new();
        let mut part = &None;
        let mut has_appendix = false;
        for sheet in &self.sheets {
            if sheet.kind == Kind::Solutions && !has_appendix {
                has_appendix = true;
                lines += &line("of-chapter", APPENDIX, "", "Solutions");
            }
            let Some((first, sections)) = sheet.headings.split_first() else { continue };
            if sheet.is_leaf {
                let words = if sheet.kind == Kind::Exercises { "Exercises" } else { &first.words };
                lines += &line("of-leaf", &first.id, "", words);
                continue;
            }
            let number = sheet.number.map_or(String::new(), |number| number.to_string());
            if sheet.part != *part {
                part = &sheet.part;
                let _ = writeln!(lines, "<li class=\"of-part\">{}</li>", part.as_deref().unwrap_or_default());
            }
            lines += &line("of-chapter", &first.id, &number, &first.words);
            for (n, section) in sections.iter().filter(|_| sheet.number.is_some()).enumerate() {
                lines += &line("of-section", &section.id, &format!("{number}.{}", n + 1), &section.words);
            }
        }
        format!("<section class=\"list\">\n<p class=\"title\">Contents</p>\n<ul>\n{lines}</ul>\n</section>\n")
    }
}

/// The number of the page on which an id stands.
fn page_number(id: &str, numbers: &BTreeMap<String, usize>) -> String {
    let number = numbers.get(id).map_or_else(|| UNKNOWN.to_owned(), usize::to_string);
    format!("<span class=\"on\" data-of=\"{id}\">{number}</span>")
}

/// The id of the title above all solutions.
const APPENDIX: &str = "appendix-solutions";

/// mdBook's script colours the code; on the pages of the site another one asks it to.
const HIGHLIGHT: &str = "<script>for (const code of document.querySelectorAll('pre > code')) hljs.highlightBlock(code);</script>\n";

/// What book.toml says of the book.
#[derive(Debug, Default)]
struct Settings {
    title: String,
    description: String,
    authors: String,
    language: String,
    /// May be empty.
    licence: String,
}

impl Settings {
    fn read(config: Config) -> Result<Self> {
        let licence = Licence::read(&config)?;
        let word = |value: Option<String>| escaped(&value.unwrap_or_default());
        Ok(Self {
            title: word(config.book.title),
            description: word(config.book.description),
            authors: escaped(&config.book.authors.join(", ")),
            language: escaped(config.book.language.as_deref().unwrap_or("en")),
            licence: word(licence.map(|licence| licence.words)),
        })
    }
}

/// The pages in print.html, behind its list of chapters; mdBook puts an element between two of them.
fn pieces<'a>(printed: &'a str, found: &[Element]) -> Vec<&'a str> {
    let (Some(main), Some(list)) = (
        found.iter().find(|element| element.name == "main"),
        found.iter().find(|element| element.is("ul", "contents")),
    ) else {
        return Vec::new();
    };
    let is_between = |element: &&Element| {
        element.get("style").is_some_and(|style| style.starts_with("break-before: page"))
            && main.holds(element)
    };
    let between = found.iter().filter(is_between).map(|element| element.whole.clone());
    let (starts, ends): (Vec<_>, Vec<_>) = between.map(|place| (place.end, place.start)).unzip();
    let starts = [list.whole.end].into_iter().chain(starts);
    starts.zip(ends.into_iter().chain([main.inside.end])).map(|(start, end)| &printed[start..end]).collect()
}

/// What of the head of print.html paper needs: style sheets, the face of the text, and the script that colours code.
fn head(printed: &str, found: &[Element]) -> String {
    let is_needed = |element: &&Element| match element.name.as_str() {
        "link" => matches!(element.get("rel"), Some("stylesheet" | "preload")),
        "script" => element.get("src").is_some_and(|source| source.starts_with("highlight")),
        _ => false,
    };
    found.iter().filter(is_needed).map(|element| format!("{}\n", &printed[element.whole.clone()])).collect()
}

/// A part of a page of the site, for a page elsewhere: where elements of these names load from.
fn moved(html: &str, site: &str, names: &[&str]) -> String {
    let mut edits = Edits::default();
    for element in html::named(html, names) {
        for key in ["href", "src"] {
            if let (Some(place), Some(target)) = (element.place(key), element.get(key)) {
                edits.replace(place, format!("{key}=\"{site}{target}\""));
            }
        }
    }
    edits.applied(html)
}

/// Words as CSS writes them.
fn quoted(words: &str) -> String {
    format!("\"{}\"", words.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_that_is_not_known_keeps_the_room_of_its_number() {
        let numbers = BTreeMap::from([("a".to_owned(), 17)]);
        assert_eq!(page_number("a", &numbers), "<span class=\"on\" data-of=\"a\">17</span>");
        assert_eq!(page_number("b", &numbers), "<span class=\"on\" data-of=\"b\">000</span>");
    }
}

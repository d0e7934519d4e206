//! The pages of the book as the press sees them, whoever loaded them.

use crate::fault::{Faults, Lines, Reporter};
use dialect::pages;
use mdbook_preprocessor::book::{Book, BookItem};
use std::path::Path;
use std::{fs, io};

/// One page.
#[derive(Debug, Clone)]
pub struct Page {
    /// Its path in the book's source folder, with forward slashes: `laundromat/index.md`.
    pub path: String,
    /// The file as faults name it: `book/laundromat/index.md`.
    pub file: String,
    /// The number of the chapter that it belongs to; `None` for unnumbered pages.
    pub chapter: Option<u32>,
    /// Its name in SUMMARY.md if it stands below the first page of its chapter: `Exercises`.
    pub part: Option<String>,
    /// The part of the book that its chapter belongs to, if it is the first page of one and SUMMARY.md has parts.
    pub(crate) part_of_book: Option<String>,
    /// Its Markdown.
    pub text: String,
    /// Where its lines begin.
    pub(crate) lines: Lines,
}

impl Page {
    /// A page of the book whose source folder is `source`.
    pub(crate) fn new(
        source: &str,
        path: String,
        chapter: Option<u32>,
        part: Option<String>,
        text: String,
    ) -> Self {
        let text = text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text); // as mdBook does
        Self {
            file: format!("{source}/{path}"),
            path,
            chapter,
            part,
            part_of_book: None,
            lines: Lines::of(&text),
            text,
        }
    }

    /// What reports the faults of this page.
    pub(crate) fn reporter<'a>(&'a self, faults: &'a mut Faults) -> Reporter<'a> {
        Reporter { file: &self.file, lines: &self.lines, faults }
    }
}

/// The pages that mdBook handed over, in reading order.
pub fn from_mdbook(book: &Book, source: &str) -> Vec<Page> {
    let mut pages = Vec::new();
    collect(&book.items, source, &mut pages);
    pages
}

fn collect(items: &[BookItem], source: &str, pages: &mut Vec<Page>) {
    for item in items {
        let BookItem::Chapter(chapter) = item else { continue };
        if let Some(path) = &chapter.source_path {
            let number = chapter.number.as_ref().and_then(|number| number.first().copied());
            let part = chapter.number.as_ref().and_then(|number| part(number, &chapter.name));
            pages.push(Page::new(source, slashed(path), number, part, chapter.content.clone()));
        }
        collect(&chapter.sub_items, source, pages);
    }
}

/// What a page that has this number and this name is of its chapter, if it is not its first page.
pub(crate) fn part(number: &[u32], name: &str) -> Option<String> {
    (number.len() > 1).then(|| name.to_owned())
}

/// The text of a file of the project; a fault if there is none.
pub(crate) fn text(root: &Path, file: &str, faults: &mut Faults) -> Option<String> {
    match fs::read(root.join(file)).map(String::from_utf8) {
        Ok(Ok(text)) => Some(text),
        Ok(Err(error)) => {
            let sound = &error.as_bytes()[..error.utf8_error().valid_up_to()];
            let line = 1 + sound.iter().filter(|&&byte| byte == b'\n').count();
            faults.add(file, line, "this line is not UTF-8: save the file in that encoding");
            None
        }
        Err(error) => {
            faults.add(file, 0, format!("cannot be read: {error}"));
            None
        }
    }
}

/// The files below a folder, in order, by their paths from there with forward slashes.
pub(crate) fn files(folder: &Path) -> io::Result<Vec<String>> {
    let (mut found, mut open) = (Vec::new(), vec![String::new()]);
    while let Some(below) = open.pop() {
        for entry in fs::read_dir(folder.join(&below))? {
            let entry = entry?;
            let name = format!("{below}{}", entry.file_name().to_string_lossy());
            if entry.file_type()?.is_dir() {
                open.push(name + "/");
            } else {
                found.push(name);
            }
        }
    }
    found.sort();
    Ok(found)
}

pub(crate) fn slashed(path: &Path) -> String {
    pages::slashed(&path.to_string_lossy())
}

/// The script with the scene and the live numbers of the chapter in a folder, in the site's root.
pub(crate) fn script(chapter: &str) -> String {
    format!("live-{chapter}.js")
}

/// The path that leads from the page at `from` to the page at `to`, both in the source folder.
pub(crate) fn relative(from: &str, to: &str) -> String {
    let from: Vec<&str> = from.split('/').collect();
    let to: Vec<&str> = to.split('/').collect();
    let folders = from.len() - 1;
    let common = from[..folders].iter().zip(&to[..to.len() - 1]).take_while(|(a, b)| a == b).count();
    let mut path = "../".repeat(folders - common);
    path.push_str(&to[common..].join("/"));
    path
}

/// The path of a link `target` as seen from the page at `from`; `None` if it leaves the source folder.
pub(crate) fn resolve(from: &str, target: &str) -> Option<String> {
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in target.split('/') {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop()?;
            }
            name => parts.push(name),
        }
    }
    Some(parts.join("/"))
}

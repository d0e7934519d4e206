//! SUMMARY.md: the pages that it names exist, each once, and every page is named.

use crate::book::{self, Page, slashed};
use crate::fault::{Faults, Lines, Reporter};
use crate::read::control_characters;
use crate::read::references::{BLANK, has_blank};
use crate::site::rustdoc;
use dialect::pages;
use mdbook_summary::{Summary, SummaryItem};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const SUMMARY: &str = "SUMMARY.md";
/// What the site has of its own below these names.
const TAKEN: [&str; 3] = ["404.md", "print.md", "toc.md"];

/// Reads SUMMARY.md; faults if it is not understood, or names a page twice or one that does not exist.
pub(crate) fn read(root: &Path, source: &str, faults: &mut Faults) -> Option<Summary> {
    let file = format!("{source}/{SUMMARY}");
    let text = book::text(root, &file, faults)?;
    let lines = Lines::of(&text);
    let mut report = Reporter { file: &file, lines: &lines, faults };
    control_characters::characters(&text, |at, message| report.fault(at, message));
    let mut named = BTreeSet::new();
    let mut sound = true;
    let links = pages::links(&text);
    for (path, offset) in &links {
        let mut fault = |message: String| {
            report.fault(*offset, message);
            sound = false;
        };
        let first = path.split('/').next().unwrap_or_default();
        if first.is_empty() || path.split('/').any(|part| part == "..") {
            fault(format!("{path} is no page in {source}/: the way there goes down from it, without `..`"));
        } else if TAKEN.contains(&path.as_str()) || (first == rustdoc::FOLDER && path != first) {
            fault(format!("{source}/{path} cannot have this name: the site has a page of its own there"));
        } else if !root.join(source).join(path).is_file() {
            fault(format!("there is no page {source}/{path}"));
        } else if !named.insert(path) {
            fault(format!("{source}/{path} is named a second time"));
        }
    }
    match mdbook_summary::parse_summary(&text) {
        _ if !sound => None, // said already
        Ok(summary) => {
            let parts = [&summary.prefix_chapters, &summary.numbered_chapters, &summary.suffix_chapters];
            let read = parts.into_iter().flat_map(|items| paths(items));
            let of_both = links.iter().zip(read).take_while(|((path, _), read)| path == read).count();
            if let Some((path, offset)) = links.get(of_both) {
                report.fault(*offset, format!("mdBook does not read {path} as a page where it stands here"));
                return None;
            }
            Some(summary)
        }
        Err(error) => {
            let said = format!("{error:#}"); // `… SUMMARY.md line 4, column 1: …`
            let cause = said.split_once(&format!("{SUMMARY} line "));
            let cause = cause.and_then(|(_, rest)| Some((rest.split_once(',')?.0, rest.split_once(": ")?.1)));
            let (line, message) = cause.unwrap_or(("0", &said));
            let line = line.parse().unwrap_or(0);
            let target = text.lines().nth(line.max(1) - 1).and_then(|text| Some(text.split_once("](")?.1));
            faults.add(&file, line, if target.is_some_and(has_blank) { BLANK } else { message });
            None
        }
    }
}

/// The paths of the pages, as mdBook reads them.
fn paths(items: &[SummaryItem]) -> Vec<String> {
    let of = |item: &SummaryItem| match item {
        SummaryItem::Link(link) => {
            let own = link.location.iter().map(|path| slashed(path));
            own.chain(paths(&link.nested_items)).collect()
        }
        _ => Vec::new(),
    };
    items.iter().flat_map(of).collect()
}

/// Adds a fault for each page in the source folder that SUMMARY.md does not name, and so nobody would print or test.
pub(crate) fn strays(pages: &[Page], root: &Path, source: &str, faults: &mut Faults) {
    let named: BTreeSet<&str> = pages.iter().map(|page| page.path.as_str()).collect();
    let mut folders = vec![String::new()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root.join(source).join(&folder)).into_iter().flatten().flatten() {
            let path = format!("{folder}{}", entry.file_name().to_string_lossy());
            let is_folder = entry.path().is_dir();
            if is_folder && entry.path().is_symlink() {
                let message = "a link to a folder could lead round in a circle: put the folder itself here";
                faults.add(&format!("{source}/{path}"), 0, message);
            } else if is_folder {
                folders.push(path + "/");
            } else if path.to_lowercase().ends_with(".md")
                && path != SUMMARY
                && !named.contains(path.as_str())
            {
                faults.add(
                    &format!("{source}/{path}"),
                    0,
                    format!("{SUMMARY} does not name this page: add it there, or move it out of {source}/"),
                );
            }
        }
    }
}

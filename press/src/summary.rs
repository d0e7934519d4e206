//! SUMMARY.md: the pages that it names exist, each once, and every page is named.

use crate::book::{self, Page};
use crate::fault::{Faults, Lines, Reporter};
use crate::signs;
use mdbook_summary::Summary;
use pulldown_cmark::{Event, Parser, Tag};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const SUMMARY: &str = "SUMMARY.md";

/// Reads SUMMARY.md; faults if it is not understood, or names a page twice or one that does not exist.
pub(crate) fn read(root: &Path, source: &str, faults: &mut Faults) -> Option<Summary> {
    let file = format!("{source}/{SUMMARY}");
    let text = book::text(root, &file, faults)?;
    let lines = Lines::of(&text);
    let mut report = Reporter { file: &file, lines: &lines, faults };
    signs::characters(&text, &mut report);
    let mut named = BTreeSet::new();
    let mut sound = true;
    for (path, offset) in links(&text) {
        if !root.join(source).join(&path).is_file() {
            report.fault(offset, format!("there is no page {source}/{path}"));
            sound = false;
        }
        if !named.insert(path.clone()) {
            report.fault(offset, format!("{source}/{path} is named a second time"));
            sound = false;
        }
    }
    match mdbook_summary::parse_summary(&text) {
        Ok(summary) => Some(summary).filter(|_| sound),
        Err(_) if !sound => None, // said already
        Err(error) => {
            let message = format!("{error:#}");
            let line =
                message.split(&format!("{SUMMARY} line ")).nth(1).and_then(|rest| rest.split(',').next());
            faults.add(&file, line.and_then(|line| line.parse().ok()).unwrap_or(0), message);
            None
        }
    }
}

/// The pages that a summary names, and where.
fn links(text: &str) -> Vec<(String, usize)> {
    let events = Parser::new(text).into_offset_iter();
    let links = events.filter_map(|(event, range)| match event {
        Event::Start(Tag::Link { dest_url, .. }) if !dest_url.is_empty() => {
            Some((dest_url.trim_start_matches("./").replace("%20", " "), range.start))
        }
        _ => None,
    });
    links.collect()
}

/// Adds a fault for each page in the source folder that SUMMARY.md does not name, and so nobody would print or test.
pub(crate) fn strays(pages: &[Page], root: &Path, source: &str, faults: &mut Faults) {
    let named: BTreeSet<&str> = pages.iter().map(|page| page.path.as_str()).collect();
    let mut folders = vec![String::new()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root.join(source).join(&folder)).into_iter().flatten().flatten() {
            let path = format!("{folder}{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
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

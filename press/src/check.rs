//! What is wrong with the pages, found without building the book.

use crate::api::Items;
use crate::book::{Page, from_disk};
use crate::fault::Faults;
use crate::{figures, render};
use std::fs;
use std::path::Path;

/// Checks the pages under `root`; returns how many there are.
///
/// # Errors
/// Every fault of every page.
pub fn check(root: &Path) -> Result<usize, Faults> {
    let pages = from_disk(root)?;
    let mut faults = Faults::default();
    code_labels(&pages, root, &mut faults);
    if let Err(found) = render::render(&pages, figures::ALL, &Items::read(root)) {
        faults.append(found);
    }
    if faults.is_empty() { Ok(pages.len()) } else { Err(faults) }
}

/// Adds a fault for each label that a comment of the library, its tests or the figures cites and no page defines.
pub(crate) fn code_labels(pages: &[Page], root: &Path, faults: &mut Faults) {
    let mut files = Vec::new();
    for folder in ["src", "tests", "benches", "book", "press/figures"] {
        collect(root, folder, &mut files);
    }
    files.sort();
    render::check_citations_in_code(pages, figures::ALL, &files, faults);
}

/// The Rust files under `root/folder`, with their names relative to the root.
fn collect(root: &Path, folder: &str, files: &mut Vec<(String, String)>) {
    let Ok(entries) = fs::read_dir(root.join(folder)) else {
        return;
    };
    for entry in entries.flatten() {
        let name = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            collect(root, &name, files);
        } else if name.ends_with(".rs")
            && let Ok(text) = fs::read_to_string(entry.path())
        {
            files.push((name, text));
        }
    }
}

//! What is wrong with the pages, found without building the book.

use crate::assets::Rendered;
use crate::book::{Page, files};
use crate::fault::Faults;
use crate::print::render;
use crate::read::disk::from_disk;
use crate::read::{exercise_times, summary};
use crate::site::links;
use std::fs;
use std::path::Path;

/// Checks the pages under `root`, which show what is `drawn`; returns how many there are.
pub fn check(root: &Path, drawn: &Rendered) -> Result<usize, Faults> {
    let (source, pages) = from_disk(root)?;
    rendered(&pages, root, &source, drawn)?;
    Ok(pages.len())
}

/// The pages as they go to mdBook. This is the one way there, so that building, testing and checking find the
/// same faults.
///
/// # Errors
/// Every fault of every page, of the labels that code cites, and of SUMMARY.md.
pub(crate) fn rendered(
    pages: &[Page],
    root: &Path,
    source: &str,
    drawn: &Rendered,
) -> Result<Vec<String>, Faults> {
    let mut faults = Faults::default();
    summary::strays(pages, root, source, &mut faults);
    links::check_style_sheets(root, source, &mut faults);
    pages.iter().for_each(|page| exercise_times::check(page, &mut faults));
    let mut drawn = drawn.clone();
    drawn.beside = files(&root.join(source)).unwrap_or_default().into_iter().collect();
    drawn.tables.push((exercise_times::TABLE.to_owned(), exercise_times::table(pages)));
    match render::render(pages, &drawn, &drawn.book.library.replace('-', "_"), &code(root, drawn.book.code)) {
        Ok(texts) if faults.is_empty() => Ok(texts),
        Ok(_) => Err(faults),
        Err(found) => {
            faults.append(found);
            Err(faults)
        }
    }
}

/// The Rust files whose comments may cite labels.
fn code(root: &Path, folders: &[&str]) -> Vec<(String, String)> {
    let mut files = Vec::new();
    for folder in folders {
        collect(root, folder, &mut files);
    }
    files.sort();
    files
}

/// The Rust files under `root/folder`, with their names relative to the root; those of a package further down are asked
/// for by its own name.
fn collect(root: &Path, folder: &str, files: &mut Vec<(String, String)>) {
    let Ok(entries) = fs::read_dir(root.join(folder)) else { return };
    for entry in entries.flatten() {
        let name = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            if !entry.path().join("Cargo.toml").is_file() {
                collect(root, &name, files);
            }
        } else if name.ends_with(".rs")
            && let Ok(text) = fs::read_to_string(entry.path())
        {
            files.push((name, text));
        }
    }
}

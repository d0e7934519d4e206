//! A new book: the example, with the press, its theme and their licences beside it.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

/// What of the press stays where it is: its tests speak of this book.
const TESTS: &str = "tests";
/// What of the theme does: the picture of this book.
const PICTURE: &str = "preview.png";

/// Writes a new book into `folder`, with the press of the one in `root`.
///
/// # Errors
/// If the folder holds something or lies among what is copied, or something cannot be copied.
pub(crate) fn book(root: &Path, folder: &Path) -> io::Result<()> {
    if folder.exists() && fs::read_dir(folder)?.next().is_some() {
        return Err(io::Error::new(ErrorKind::AlreadyExists, "the folder is not empty"));
    }
    fs::create_dir_all(folder)?;
    for part in ["press", "book"] {
        if folder.canonicalize()?.starts_with(root.join(part).canonicalize()?) {
            fs::remove_dir(folder)?;
            let why = format!("the folder lies in `{part}`, which is copied: take one beside this book");
            return Err(io::Error::new(ErrorKind::InvalidInput, why));
        }
    }
    copy(&root.join("press/example"), folder)?;
    copy(&root.join("press"), &folder.join("press"))?;
    copy(&root.join("book/theme"), &folder.join("book/theme"))?;
    for entry in fs::read_dir(root)? {
        let entry = entry?;
        let name = entry.file_name();
        // The press is tried with these versions of what it uses.
        if name == "Cargo.lock" || name.to_string_lossy().starts_with("LICENSE-") {
            fs::copy(entry.path(), folder.join(name))?;
        }
    }
    Ok(())
}

fn copy(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let name = entry.file_name();
        if entry.file_type()?.is_dir() {
            if name != TESTS && name != "target" {
                copy(&entry.path(), &to.join(name))?;
            }
        } else if name != PICTURE {
            fs::copy(entry.path(), to.join(name))?;
        }
    }
    Ok(())
}

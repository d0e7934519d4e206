//! Which files have changed: looked at ten times a second, which takes a millisecond and works everywhere.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};
use std::{fs, thread};

/// Between two looks.
pub(super) const PAUSE: Duration = Duration::from_millis(100);

/// When a file was written, and how long it is.
type Stamp = (SystemTime, u64);

/// Watches what the book is made of.
pub(super) struct Watcher {
    /// Files, and folders with all that is in them.
    watched: Vec<PathBuf>,
    known: BTreeMap<PathBuf, Stamp>,
}

impl Watcher {
    pub(super) fn new(watched: Vec<PathBuf>) -> Self {
        let known = look(&watched);
        Self { watched, known }
    }

    /// Whether something has changed since it was last waited for.
    pub(super) fn has_changed(&self) -> bool {
        look(&self.watched) != self.known
    }

    /// Waits until something has changed, and for a moment nothing more; which files.
    pub(super) fn wait(&mut self) -> Vec<PathBuf> {
        let mut now = look(&self.watched);
        while now == self.known {
            thread::sleep(PAUSE);
            now = look(&self.watched);
        }
        // An editor may write several files, or one in two steps.
        loop {
            thread::sleep(PAUSE / 2);
            let next = look(&self.watched);
            if next == now {
                break;
            }
            now = next;
        }
        let fresh = now.iter().filter(|(file, stamp)| self.known.get(*file) != Some(stamp));
        let gone = self.known.keys().filter(|file| !now.contains_key(*file));
        let changed = fresh.map(|(file, _)| file).chain(gone).cloned().collect();
        self.known = now;
        changed
    }
}

/// All files among these and below, but what is hidden or built.
fn look(watched: &[PathBuf]) -> BTreeMap<PathBuf, Stamp> {
    let mut files = BTreeMap::new();
    watched.iter().for_each(|path| walk(path, &mut files));
    files
}

fn walk(path: &Path, files: &mut BTreeMap<PathBuf, Stamp>) {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    // Of editors: swap files and safety copies.
    if name.starts_with('.') || name.ends_with('~') || name == "target" {
        return;
    }
    let Ok(data) = fs::metadata(path) else { return };
    if data.is_dir() {
        for entry in fs::read_dir(path).into_iter().flatten().flatten() {
            walk(&entry.path(), files);
        }
    } else if let Ok(written) = data.modified() {
        files.insert(path.to_owned(), (written, data.len()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_is_seen_and_what_an_editor_keeps_for_itself_is_not() {
        let root = std::env::temp_dir().join(format!("press-watch-{}", std::process::id()));
        fs::create_dir_all(root.join("book/a")).unwrap();
        fs::write(root.join("book/a/index.md"), "one").unwrap();
        let page = root.join("book/a/index.md");
        let mut watcher = Watcher::new(vec![root.join("book"), root.join("book.toml")]);
        fs::write(root.join("book/a/.index.md.swp"), "two").unwrap();
        fs::create_dir_all(root.join("book/target")).unwrap();
        fs::write(root.join("book/target/x.md"), "two").unwrap();
        assert!(!watcher.has_changed());
        fs::write(&page, "three").unwrap();
        assert!(watcher.has_changed());
        assert_eq!(watcher.wait(), std::slice::from_ref(&page));
        assert!(!watcher.has_changed());
        fs::remove_file(&page).unwrap();
        fs::write(root.join("book.toml"), "[book]").unwrap();
        assert_eq!(watcher.wait().len(), 2);
        fs::remove_dir_all(root).unwrap();
    }
}

//! What the figures of a chapter are drawn from, as one number that changes when any of it does.
//!
//! A *name* stands for a scene and for a chapter: `pinned_hoop` for `src/scenes/pinned_hoop.rs` (or the
//! folder) and for `book/pinned-hoop/` without its Markdown and its live scene. All other code that draws is
//! *shared*. The figures of a chapter are drawn from what is shared, from what its own name stands for, and
//! from every name that a word of these mentions, and so on. Shared code can reach a scene only through the
//! module `scenes`, so a shared file without that word mentions none.

use figures::house;
use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;
use std::{fs, io};

/// Everything that figures are drawn from.
#[derive(Debug, Default)]
pub(crate) struct Stamps {
    shared: Part,
    named: BTreeMap<String, Part>,
}

/// Files that are always hashed together.
#[derive(Debug, Default)]
struct Part {
    hasher: DefaultHasher,
    /// The words in which another name may be mentioned.
    words: BTreeSet<String>,
}

impl Stamps {
    /// Reads the code under `root`, the folder of the workspace.
    ///
    /// # Errors
    /// If a file cannot be read.
    pub(crate) fn read(root: &Path) -> io::Result<Self> {
        let mut stamps = Self::default();
        for path in [
            "Cargo.lock",
            "Cargo.toml",
            "press/book/build.rs",
            "press/drawing",
            "press/figures",
            "src",
            "book",
        ] {
            stamps.add(&root.join(path), &root.join("src/scenes"), &root.join("book"))?;
        }
        // The picture of the house is drawn from them.
        for manifest in house::manifests(root)? {
            stamps.shared.add(&manifest, true)?;
        }
        Ok(stamps)
    }

    /// Adds a file, or a folder with all that is in it but pages, live scenes, tests and examples.
    fn add(&mut self, path: &Path, scenes: &Path, book: &Path) -> io::Result<()> {
        if path.is_dir() {
            let mut below =
                fs::read_dir(path)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
            below.sort();
            let drawn_from = |path: &&std::path::PathBuf| {
                let name = path.file_name().unwrap_or_default();
                let is_page = path.extension().is_some_and(|ending| ending == "md");
                !is_page
                    && !["tests", "examples", "scene.rs", "scene"]
                        .iter()
                        .any(|draws_none| name == *draws_none)
            };
            return below.iter().filter(drawn_from).try_for_each(|path| self.add(path, scenes, book));
        }
        let below = path.strip_prefix(scenes).or_else(|_| path.strip_prefix(book));
        let name = below.ok().and_then(|below| below.iter().next()).map(Path::new).and_then(Path::file_stem);
        let name = name.map(|name| name.to_string_lossy().replace('-', "_")).filter(|name| name != "mod");
        let is_shared = name.is_none();
        let part = name.map_or(&mut self.shared, |name| self.named.entry(name).or_default());
        part.add(path, is_shared)
    }

    /// The stamp of the figures of `chapter`, the name of its folder.
    pub(crate) fn of(&self, chapter: &str) -> String {
        let mut names = BTreeSet::new();
        let mut open: Vec<String> = self.shared.words.iter().cloned().collect();
        open.push(chapter.replace('-', "_"));
        while let Some(name) = open.pop() {
            if let Some(part) = self.named.get(&name)
                && names.insert(name)
            {
                open.extend(part.words.iter().cloned());
            }
        }
        let mut hasher = self.shared.hasher.clone();
        for name in names {
            self.named[&name].hasher.finish().hash(&mut hasher);
            name.hash(&mut hasher);
        }
        format!("{:016x}", hasher.finish())
    }
}

impl Part {
    fn add(&mut self, path: &Path, is_shared: bool) -> io::Result<()> {
        let content = fs::read(path)?;
        (path, &content).hash(&mut self.hasher);
        if path.extension().is_none_or(|ending| ending != "rs") {
            return Ok(());
        }
        let text = String::from_utf8_lossy(&content);
        for (at, _) in text.match_indices("include_") {
            // Its own folder is part of a chapter anyway.
            let included = text[at..].split('"').nth(1).filter(|included| included.starts_with(".."));
            if let (Some(included), Some(folder)) = (included, path.parent()) {
                fs::read(folder.join(included)).unwrap_or_default().hash(&mut self.hasher);
            }
        }
        let is_code = |line: &&str| {
            let line = line.trim_start().trim_start_matches("pub ");
            !line.starts_with("//") && !line.starts_with("mod ")
        };
        let words: BTreeSet<&str> = text
            .lines()
            .filter(is_code)
            .flat_map(|line| line.split(|c: char| !(c.is_alphanumeric() || c == '_')))
            .collect();
        if !is_shared || words.contains("scenes") {
            self.words.extend(words.into_iter().map(str::to_owned));
        }
        Ok(())
    }
}

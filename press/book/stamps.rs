//! What the figures of a chapter are drawn from, as one number that changes when any of it does.
//!
//! The code that draws lies in *parts*: each scene (`src/scenes/wheel.rs`, or the folder), each kernel
//! (`src/wide/wheel.rs`), each chapter (`book/pinned-hoop/` without its Markdown and its live scene), and all that is
//! left, which is *shared*. The figures of a chapter are drawn from what is shared, from the chapter, and from every
//! part that these name, and so on. A file names the scene `wheel` by that word, if it has the word `scenes` too or is
//! a scene itself; likewise for kernels and `wide`; a chapter by `chapter_pinned_hoop`. A string that is but one word
//! names nothing.

use figures::house;
use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;
use std::{fs, io};

/// Everything that figures are drawn from.
#[derive(Debug, Default)]
pub(crate) struct Stamps {
    shared: Part,
    /// By their names: `scenes wheel`, `wide wheel`, `chapter_pinned_hoop`.
    named: BTreeMap<String, Part>,
}

/// Files that are always hashed together.
#[derive(Debug, Default)]
struct Part {
    hasher: DefaultHasher,
    /// The names of all parts that these files may mean.
    named: BTreeSet<String>,
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
            stamps.add(&root.join(path), root)?;
        }
        // The picture of the house is drawn from them.
        for manifest in house::manifests(root)? {
            stamps.shared.add(&manifest, "")?;
        }
        Ok(stamps)
    }

    /// Adds a file, or a folder with all that is in it but pages, live scenes, tests and examples.
    fn add(&mut self, path: &Path, root: &Path) -> io::Result<()> {
        if path.is_dir() {
            let mut below =
                fs::read_dir(path)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
            below.sort();
            let drawn_from = |path: &&std::path::PathBuf| {
                let name = path.file_name().unwrap_or_default();
                let is_page = path.extension().is_some_and(|ending| ending == "md");
                let is_link = path.is_symlink() && path.is_dir(); // perhaps back to where it stands
                !is_page
                    && !is_link
                    && !["tests", "examples", "scene.rs", "scene"]
                        .iter()
                        .any(|draws_none| name == *draws_none)
            };
            return below.iter().filter(drawn_from).try_for_each(|path| self.add(path, root));
        }
        let kinds = [("src/scenes", "scenes "), ("src/wide", "wide "), ("book", "chapter_")];
        let below = |(folder, kind)| Some((path.strip_prefix(root.join(folder)).ok()?, kind));
        let (below, kind) = kinds.into_iter().find_map(below).unwrap_or((Path::new(""), ""));
        let name = below.iter().next().map(|name| name.to_string_lossy());
        let name = name.map(|name| name.trim_end_matches(".rs").to_owned()).filter(|name| name != "mod");
        let part = name.map(|name| format!("{kind}{}", in_rust(&name)));
        part.map_or(&mut self.shared, |name| self.named.entry(name).or_default()).add(path, kind)
    }

    /// The stamp of the figures of `chapter`, the name of its folder.
    pub(crate) fn of(&self, chapter: &str) -> String {
        let mut names = BTreeSet::new();
        let mut open: Vec<String> = self.shared.named.iter().cloned().collect();
        open.push(format!("chapter_{}", in_rust(chapter)));
        while let Some(name) = open.pop() {
            if let Some(part) = self.named.get(&name)
                && names.insert(name)
            {
                open.extend(part.named.iter().cloned());
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
    /// Adds a file, whose names of parts of its own `kind` need no other word.
    fn add(&mut self, path: &Path, kind: &str) -> io::Result<()> {
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
            let line = line.trim_start();
            let line =
                ["pub ", "pub(crate) "].iter().find_map(|start| line.strip_prefix(start)).unwrap_or(line);
            !line.starts_with("//") && !line.starts_with("mod ")
        };
        let words: BTreeSet<&str> = text.lines().filter(is_code).flat_map(words).collect();
        for module in ["scenes ", "wide "] {
            if module == kind || words.contains(module.trim_end()) {
                self.named.extend(words.iter().map(|word| format!("{module}{word}")));
            }
        }
        let chapters = words.iter().filter(|word| word.starts_with("chapter_"));
        self.named.extend(chapters.map(|word| (*word).to_owned()));
        Ok(())
    }
}

/// A name as figures are known by it in Rust, as the press has it.
fn in_rust(name: &str) -> String {
    name.replace(|c: char| !c.is_ascii_alphanumeric(), "_").to_lowercase()
}

/// The words of a line of code, but for strings that are one.
fn words(line: &str) -> impl Iterator<Item = &str> {
    let in_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut parts = line.split_inclusive(move |c| !in_word(c));
    let mut before = None;
    std::iter::from_fn(move || {
        let part = parts.next()?;
        let word = part.trim_end_matches(move |c| !in_word(c));
        let after = part[word.len()..].chars().next();
        let is_string = before == Some('"') && after == Some('"');
        before = after;
        Some(if is_string { "" } else { word })
    })
}

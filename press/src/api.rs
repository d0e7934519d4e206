//! The library items that a snippet uses, and where rustdoc documents them.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::SystemTime;
use std::{env, fs, io};

/// The folder of the site that holds rustdoc's pages.
pub(crate) const FOLDER: &str = "api";

/// The page to which rustdoc's help leads back. For a single crate rustdoc writes none.
const ENTRANCE: &str = "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<meta charset=\"utf-8\">\n\
    <meta http-equiv=\"refresh\" content=\"0; url=LIBRARY/index.html\">\n<title>The library</title>\n\
    <p><a href=\"LIBRARY/index.html\">The library</a></p>\n</html>\n";

/// The kinds of items that have a page of their own, as the language and as rustdoc name them.
const KINDS: [(&str, &str); 5] =
    [("struct", "struct"), ("enum", "enum"), ("fn", "fn"), ("trait", "trait"), ("const", "constant")];

/// The library of the book: the package in the project's root, if it is one.
#[derive(Debug, Default)]
pub(crate) struct Library {
    /// Its name, as Rust and rustdoc write it.
    pub(crate) name: String,
    /// Which items it makes public: name → rustdoc's word for its kind.
    kinds: BTreeMap<String, &'static str>,
}

impl Library {
    /// Reads the library, a package whose sources lie in `root/src`.
    pub(crate) fn read(root: &Path, package: &str) -> Self {
        let mut library = Self { name: in_rust(package), kinds: BTreeMap::new() };
        library.collect(&root.join("src"));
        library
    }

    fn collect(&mut self, folder: &Path) {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                self.collect(&path);
            } else if let Ok(text) = fs::read_to_string(&path) {
                for line in text.lines().filter_map(|line| line.strip_prefix("pub ")) {
                    for (keyword, kind) in KINDS {
                        if let Some(rest) = line.strip_prefix(keyword).and_then(|rest| rest.strip_prefix(' '))
                        {
                            let end =
                                rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
                            self.kinds.insert(rest[..end].to_owned(), kind);
                        }
                    }
                }
            }
        }
    }

    /// The items that `code` imports from the library, in the order of the imports: (name, page below [`FOLDER`]).
    pub(crate) fn used(&self, code: &str) -> Vec<(String, String)> {
        let plain: String = code
            .lines()
            .map(|line| line.strip_prefix("# ").unwrap_or(line).trim())
            .collect::<Vec<_>>()
            .join(" ");
        let mut used = Vec::new();
        for (at, _) in plain.match_indices(&format!("use {}::", self.name)) {
            let tree = plain[at + 4..].split(';').next().unwrap_or_default();
            for path in expanded(tree) {
                let Some((module, name)) = path.rsplit_once("::") else {
                    continue;
                };
                if let Some(kind) = self.kinds.get(name) {
                    let page = format!("{}/{kind}.{name}.html", module.replace("::", "/"));
                    if !used.iter().any(|(_, known)| *known == page) {
                        used.push((name.to_owned(), page));
                    }
                }
            }
        }
        used
    }
}

/// All paths of an import: `a::{b, c::{d, e}}` → `a::b`, `a::c::d`, `a::c::e`.
fn expanded(tree: &str) -> Vec<String> {
    let tree = tree.trim();
    let Some((prefix, rest)) = tree.split_once('{') else {
        return if tree.is_empty() { Vec::new() } else { vec![tree.to_owned()] };
    };
    let inner = rest.trim_end().strip_suffix('}').unwrap_or(rest);
    let mut parts = Vec::new();
    let (mut depth, mut start) = (0, 0);
    for (at, c) in inner.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&inner[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&inner[start..]);
    parts.into_iter().flat_map(expanded).map(|path| format!("{prefix}{path}")).collect()
}

/// The name of a package as Rust and rustdoc write it.
fn in_rust(package: &str) -> String {
    package.replace('-', "_")
}

/// Where rustdoc leaves its pages.
fn written(root: &Path) -> io::Result<PathBuf> {
    let metadata = Command::new(cargo())
        .args(["metadata", "--no-deps", "--format-version", "1"])
        .current_dir(root)
        .stdin(Stdio::null())
        .stderr(Stdio::inherit())
        .output()?;
    let metadata: serde_json::Value = serde_json::from_slice(&metadata.stdout)?;
    let target = metadata["target_directory"].as_str();
    Ok(Path::new(target.ok_or_else(|| io::Error::other("cargo names no target folder"))?).join("doc"))
}

fn cargo() -> OsString {
    env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// Whether the documentation of the library in `root` was written after its sources, if there is one.
pub(crate) fn is_current(root: &Path, package: &str) -> bool {
    if !root.join("src").is_dir() {
        return true; // a book without a library
    }
    written(root).and_then(|doc| is_newer(&doc.join(in_rust(package)), &root.join("src"))).unwrap_or(false)
}

/// Runs rustdoc on the library in `root`, if there is one, and copies its pages into the site.
pub(crate) fn add(site: &Path, root: &Path, package: &str) -> io::Result<()> {
    if !root.join("src").is_dir() {
        return Ok(());
    }
    let library = in_rust(package);
    let doc = written(root)?;
    let sources = format!("src/{library}"); // where rustdoc puts them
    remove_outdated(&doc, [&library, &sources], &root.join("src"))?;
    let documented = Command::new(cargo())
        // Of this package alone: for all that is built here rustdoc would read the mdBook of the press, too.
        .args(["doc", "--quiet", "--no-deps", "--lib", "--package", package])
        .current_dir(root)
        .stdin(Stdio::null())
        .stderr(Stdio::inherit())
        .output()?;
    if !documented.status.success() {
        return Err(io::Error::other(format!("`cargo doc` failed for the library {library}")));
    }
    // The library's pages and what they share; other crates may have left theirs beside them.
    for part in [&library, &sources, "static.files", "search.index", "trait.impl", "type.impl"] {
        copy(&doc.join(part), &site.join(FOLDER).join(part))?;
    }
    fs::write(site.join(FOLDER).join("index.html"), ENTRANCE.replace("LIBRARY", &library))?;
    for entry in fs::read_dir(&doc)? {
        let entry = entry?;
        let name = entry.file_name();
        let is_shared = [".js", ".css"].iter().any(|ending| name.to_string_lossy().ends_with(ending))
            || name == "help.html"
            || name == "settings.html";
        if is_shared && entry.path().is_file() {
            fs::copy(entry.path(), site.join(FOLDER).join(name))?;
        }
    }
    Ok(())
}

/// Removes rustdoc's pages if the library is newer, since rustdoc writes them all again and never removes
/// that of an item which is gone.
fn remove_outdated(doc: &Path, parts: [&str; 2], sources: &Path) -> io::Result<()> {
    if is_newer(&doc.join(parts[0]), sources)? {
        return Ok(());
    }
    for part in parts {
        if doc.join(part).is_dir() {
            fs::remove_dir_all(doc.join(part))?;
        }
    }
    Ok(())
}

/// Whether rustdoc's pages in a folder are there, and newer than the sources.
fn is_newer(pages: &Path, sources: &Path) -> io::Result<bool> {
    let written = fs::metadata(pages.join("index.html")).and_then(|page| page.modified());
    Ok(matches!(written, Ok(written) if newest(sources)? < written))
}

/// When something in a folder was last changed; a folder changes when a file in it goes.
fn newest(folder: &Path) -> io::Result<SystemTime> {
    let mut newest = fs::metadata(folder)?.modified()?;
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let changed = if entry.file_type()?.is_dir() {
            self::newest(&entry.path())?
        } else {
            entry.metadata()?.modified()?
        };
        newest = newest.max(changed);
    }
    Ok(newest)
}

/// Copies a folder with all that is in it; one that does not exist is nothing to copy.
fn copy(from: &Path, to: &Path) -> io::Result<()> {
    if !from.is_dir() {
        return Ok(());
    }
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let target = to.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            copy(&entry.path(), &target)?;
        } else {
            fs::copy(entry.path(), target)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn imports_are_expanded() {
        assert_eq!(expanded("m::a::{B, c::{D, E}}"), ["m::a::B", "m::a::c::D", "m::a::c::E"]);
        assert_eq!(expanded("m::a"), ["m::a"]);
    }

    #[test]
    fn a_snippet_links_to_the_items_it_imports() {
        let mut items = Library { name: "mechanics".to_owned(), ..Library::default() };
        items.kinds.insert("Machine".to_owned(), "struct");
        items.kinds.insert("rk4".to_owned(), "fn");
        let code = "# use mechanics::integrate::rk4;\n# use mechanics::scenes::laundromat::{Machine,\n#     Unknown};\nrk4();";
        let pages: Vec<String> = items.used(code).into_iter().map(|(_, page)| page).collect();
        assert_eq!(
            pages,
            ["mechanics/integrate/fn.rk4.html", "mechanics/scenes/laundromat/struct.Machine.html"]
        );
    }
}

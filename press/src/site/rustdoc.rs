//! The documentation of the library, and the pages of it to which a snippet leads.

use crate::book::files;
use crate::site::package::{Library, Package, cargo};
use anyhow::{Result, ensure};
use html::Edits;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::SystemTime;
use std::{fs, io};

/// The folder of the site that holds rustdoc's pages.
pub(crate) const FOLDER: &str = "api";

/// The page to which rustdoc's help leads back. For a single crate rustdoc writes none.
const ENTRANCE: &str = "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<meta charset=\"utf-8\">\n\
    <meta http-equiv=\"refresh\" content=\"0; url=LIBRARY/index.html\">\n<title>The library</title>\n\
    <p><a href=\"LIBRARY/index.html\">The library</a></p>\n</html>\n";

/// What stands below a snippet that imports something of `library`: a line that [`with_links`] fills once rustdoc has
/// said which pages there are.
pub(crate) fn uses(library: &str, code: &str) -> Option<String> {
    let items = imported(library, code);
    (!items.is_empty()).then(|| format!("<p class=\"uses\" data-items=\"{}\"></p>", items.join(" ")))
}

/// The page at `path` of the site with links, below each snippet, to the pages of `doc` for what it imports.
pub(crate) fn with_links(html: &str, path: &str, doc: &Path) -> String {
    if !html.contains("data-items") {
        return html.to_owned(); // most pages have no snippet
    }
    let up = "../".repeat(path.matches('/').count());
    let mut edits = Edits::default();
    for line in html::named(html, &["p"]) {
        let Some(items) = line.get("data-items") else { continue };
        let links = items.split(' ').filter_map(|item| {
            let (name, page) = page(doc, item)?;
            Some(format!("<a href=\"{up}{FOLDER}/{page}\"><code>{name}</code></a>"))
        });
        let links = links.collect::<Vec<_>>().join(", ");
        let filled = format!("<p class=\"uses\">In the library: {links}</p>");
        edits.replace(line.whole.clone(), if links.is_empty() { String::new() } else { filled });
    }
    edits.applied(html)
}

/// The name of an item, and its page among those in `doc`: `a/struct.B.html` for `a::B`. There is none for a module,
/// and none for what another crate documents.
fn page<'a>(doc: &Path, item: &'a str) -> Option<(&'a str, String)> {
    let (module, name) = item.rsplit_once("::")?;
    let folder = module.replace("::", "/");
    let files = fs::read_dir(doc.join(&folder)).ok()?.flatten();
    let mut files = files.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let end = format!("{name}.html");
    let file = files.find(|file| file.split_once('.').is_some_and(|(_, rest)| rest == end))?;
    Some((name, format!("{folder}/{file}")))
}

/// The items that `code` imports from a library, each once, in their order.
fn imported(library: &str, code: &str) -> Vec<String> {
    let lines = code.lines().map(|line| line.strip_prefix("# ").unwrap_or(line).trim());
    let plain = lines.collect::<Vec<_>>().join(" ");
    let mut items = Vec::new();
    for (at, _) in plain.match_indices(&format!("use {library}::")) {
        for item in expanded(plain[at + 4..].split(';').next().unwrap_or_default()) {
            if !items.contains(&item) {
                items.push(item);
            }
        }
    }
    items
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

/// Where rustdoc leaves its pages.
pub(crate) fn folder(package: &Package) -> PathBuf {
    package.target.join("doc")
}

/// Whether the documentation of the library in `root` was written after its sources, if there is one.
pub(crate) fn is_current(root: &Path) -> bool {
    let Some(package) = Package::read(root) else { return true };
    package.library.as_ref().is_none_or(|library| {
        is_newer(&folder(&package).join(&library.name), &library.sources).unwrap_or(false)
    })
}

/// Runs rustdoc on the library of a package, if it has one, and copies its pages into the site.
pub(crate) fn add(site: &Path, root: &Path, package: &Package) -> Result<()> {
    let Some(Library { name: library, sources }) = &package.library else { return Ok(()) };
    let doc = folder(package);
    let code = format!("src/{library}"); // where rustdoc puts it
    remove_outdated(&doc, [library, &code], sources)?;
    let documented = cargo(root)
        // Of this package alone: for all that is built here rustdoc would read the mdBook of the press, too.
        .args(["doc", "--quiet", "--no-deps", "--lib", "--package", &package.name])
        .stderr(Stdio::inherit())
        .output()?;
    ensure!(documented.status.success(), "`cargo doc` failed for the library {library}");
    // The library's pages and what they share; other crates may have left theirs beside them.
    for part in [library, &*code, "static.files", "search.index", "trait.impl", "type.impl"] {
        copy(&doc.join(part), &site.join(FOLDER).join(part))?;
    }
    fs::write(site.join(FOLDER).join("index.html"), ENTRANCE.replace("LIBRARY", library))?;
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
    let names = if from.is_dir() { files(from)? } else { Vec::new() };
    for name in names {
        let target = to.join(&name);
        fs::create_dir_all(target.parent().unwrap_or(to))?;
        fs::copy(from.join(name), target)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_snippet_links_to_the_items_it_imports_by_what_rustdoc_calls_them() {
        let code = "# use spin::{tops::{rk4, Rule, tops}, plates::Rule};\n# use spin::plates::{Rule,\n#     Unknown};\n# use other::A;\nrk4();";
        let line = uses("spin", code).unwrap();
        assert_eq!(
            line,
            "<p class=\"uses\" data-items=\"spin::tops::rk4 spin::tops::Rule spin::tops::tops spin::plates::Rule \
             spin::plates::Unknown\"></p>"
        );
        assert_eq!(uses("spin", "use other::A;"), None);
        let doc = std::env::temp_dir().join(format!("press-api-{}", std::process::id()));
        let pages =
            ["tops/fn.rk4.html", "tops/enum.Rule.html", "tops/tops/index.html", "plates/struct.Rule.html"];
        for page in pages.map(|page| doc.join("spin").join(page)) {
            fs::create_dir_all(page.parent().unwrap()).unwrap();
            fs::write(page, "").unwrap();
        }
        let linked = with_links(&line, "a/b.html", &doc);
        let targets: Vec<String> =
            html::named(&linked, &["a"]).iter().map(|link| link.get("href").unwrap().to_owned()).collect();
        let expected = [pages[0], pages[1], pages[3]].map(|page| format!("../api/spin/{page}"));
        assert_eq!(targets, expected, "{linked}");
        assert!(
            linked.starts_with("<p class=\"uses\">In the library: <a")
                && linked.contains("<code>rk4</code></a>, <a")
        );
        assert_eq!(with_links(&line, "a/b.html", &doc.join("none")), "");
        fs::remove_dir_all(doc).unwrap();
    }
}

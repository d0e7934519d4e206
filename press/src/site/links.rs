//! Checks of the finished site: what only the built HTML can show.

mod page;

use self::page::{Built, examine, is_remote, remote_in_css};
use crate::book::{files, slashed, text};
use crate::fault::{Faults, Lines};
use mdbook_renderer::book::BookItem;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZero;
use std::path::Path;
use std::sync::Mutex;
use std::{fs, io, thread};

/// A fault of the site: the built page, a word that may stand in its Markdown, and what is wrong.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct SiteFault {
    /// Path of the page in the site: `laundromat/index.html`.
    pub(crate) page: String,
    /// The target or text at fault, by which its line can be found.
    pub(crate) clue: String,
    pub(crate) message: String,
}

/// What pages of the site hold, by their paths in it: `laundromat/index.html`.
#[derive(Debug, Default)]
pub(crate) struct Examined(BTreeMap<String, Built>);

impl Examined {
    /// Where each id is found. What mdBook prints again is named by its first place.
    pub(crate) fn homes(&self) -> BTreeMap<&str, &str> {
        let own = self.0.iter().filter(|(page, _)| !is_copy(page));
        own.flat_map(|(page, built)| built.ids.iter().map(|id| (id.as_str(), page.as_str()))).collect()
    }
}

/// Reads pages of the site in `folder`, as many at a time as the machine can.
pub(crate) fn examined(folder: &Path, pages: impl Iterator<Item = String>) -> io::Result<Examined> {
    let mut open = Vec::new();
    for page in pages {
        open.push((fs::metadata(folder.join(&page))?.len(), page));
    }
    open.sort_by_key(|(size, _)| Reverse(*size)); // nobody should begin with print.html last
    let open = Mutex::new(open.into_iter());
    let some = || {
        let mut built = Vec::new();
        loop {
            let next = open.lock().map_or(None, |mut open| open.next());
            let Some((_, page)) = next else { return Ok::<_, io::Error>(built) };
            let examined = examine(&fs::read_to_string(folder.join(&page))?);
            built.push((page, examined));
        }
    };
    let parts = thread::scope(|scope| {
        let threads = thread::available_parallelism().map_or(1, NonZero::get);
        let all: Vec<_> = (0..threads).map(|_| scope.spawn(some)).collect();
        let join = |thread: thread::ScopedJoinHandle<'_, _>| {
            thread.join().unwrap_or_else(|_| Err(io::Error::other("a page cannot be examined")))
        };
        all.into_iter().map(join).collect::<io::Result<Vec<_>>>()
    })?;
    Ok(Examined(parts.into_iter().flatten().collect()))
}

/// Checks every page of the site in `folder`, of which some may have been examined before.
pub(crate) fn check(folder: &Path, before: Examined) -> io::Result<Vec<SiteFault>> {
    let files = files(folder)?;
    let rest = files.iter().filter(|name| name.ends_with(".html") && !before.0.contains_key(*name));
    let rest = examined(folder, rest.cloned())?;
    let mut pages = before.0;
    pages.extend(rest.0);
    let mut faults = Vec::new();
    for file in files.iter().filter(|file| file.ends_with(".css")) {
        if let Some(at) = remote_in_css(&fs::read_to_string(folder.join(file))?) {
            faults.push(SiteFault {
                page: file.clone(),
                clue: at.clone(),
                message: format!("the style sheet loads {at} from a network"),
            });
        }
    }
    let known: BTreeSet<String> = files.into_iter().collect();
    for (name, page) in &pages {
        let mut add = |clue: &str, message: String| {
            faults.push(SiteFault { page: name.clone(), clue: clue.to_owned(), message });
        };
        for id in &page.doubled_ids {
            add(id, format!("the id `{id}` stands on the page twice"));
        }
        for text in &page.unresolved {
            add(text, format!("`{text}` was left as it is"));
        }
        if page.mute_figures > 0 {
            add("", format!("{} figures lack a title or a description", page.mute_figures));
        }
        for (target, attribute) in &page.targets {
            if let Some(message) = dead(name, target, attribute, &pages, &known) {
                add(target, message);
            }
        }
    }
    // mdBook prints the first page again as index.html and all of them as print.html, where a target may be
    // written otherwise.
    if faults.iter().any(|fault| !is_copy(&fault.page)) {
        faults.retain(|fault| !is_copy(&fault.page));
    }
    faults.sort();
    Ok(faults)
}

/// The pages of the book, below the root of the site.
pub(crate) fn pages<'a>(items: impl Iterator<Item = &'a BookItem>) -> Vec<String> {
    let path = |item: &BookItem| match item {
        BookItem::Chapter(chapter) => chapter.path.as_ref().map(|path| slashed(&path.with_extension("html"))),
        _ => None,
    };
    items.filter_map(path).collect()
}

/// Adds a fault for each style sheet of the book that loads something from a network.
pub(crate) fn check_style_sheets(root: &Path, source: &str, faults: &mut Faults) {
    let files = files(&root.join(source)).unwrap_or_default(); // what cannot be read is said of the pages
    for file in files.iter().filter(|file| file.ends_with(".css")) {
        let name = format!("{source}/{file}");
        if let Some(css) = text(root, &name, faults)
            && let Some(target) = remote_in_css(&css)
        {
            let line = css.find(&target).map_or(0, |at| Lines::of(&css).at(at));
            faults.add(&name, line, format!("the style sheet loads {target} from a network"));
        }
    }
}

/// Whether mdBook makes this page of others.
fn is_copy(page: &str) -> bool {
    matches!(page, "index.html" | "print.html")
}

/// Why a link or resource is at fault; `None` if it is alive.
fn dead(
    from: &str,
    target: &str,
    attribute: &str,
    pages: &BTreeMap<String, Built>,
    known: &BTreeSet<String>,
) -> Option<String> {
    if is_remote(target) {
        return (attribute != "a").then(|| format!("<{attribute}> loads {target} from a network"));
    }
    if target.starts_with("data:")
        || target.starts_with("mailto:")
        || target.starts_with("javascript:")
        || target.is_empty()
    {
        return None;
    }
    let (path, anchor) = target.split_once('#').unwrap_or((target, ""));
    let path = path.split('?').next().unwrap_or("");
    let file = if path.is_empty() {
        from.to_owned()
    } else if from == "404.html" && path.starts_with('/') {
        path.trim_start_matches('/').to_owned()
    } else {
        match crate::book::resolve(from, path) {
            Some(file) if path.ends_with('/') || file.is_empty() => {
                if file.is_empty() {
                    "index.html".to_owned()
                } else {
                    format!("{file}/index.html")
                }
            }
            Some(file) => file,
            None => return Some(format!("the link to `{target}` leaves the site")),
        }
    };
    if !known.contains(&file) {
        return Some(format!("the link to `{target}` leads nowhere"));
    }
    let page = pages.get(&file)?;
    // On rustdoc's pages of sources a script marks the lines from one number to another.
    let lines = anchor.split_once('-').filter(|_| anchor.bytes().all(|b| b.is_ascii_digit() || b == b'-'));
    let alive = match lines {
        Some((from, to)) => page.ids.contains(from) && page.ids.contains(to),
        None => anchor.is_empty() || page.ids.contains(anchor),
    };
    (!alive).then(|| format!("the link to `{target}` leads to a page without `#{anchor}`"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of the site, what it holds, and what is said of it, or nothing.
    const CASES: [(&str, &str, &str); 18] = [
        (
            "a.html",
            "<a href=\"b.html#there\">b</a> <a href=\"https://example.org\">out</a> <code>@eq:x</code>\
             <figure><svg role=\"img\"><title>T</title><desc>D</desc><style>a{}</style></svg></figure>",
            "",
        ),
        (
            "a.html",
            "<script>let a = `<a href=\"${b}\">`;</script><a href=\"#4-12\">4</a><p id=4></p><p id=12></p>",
            "",
        ),
        (
            "a.html",
            "<a href=\"#4-13\">4</a><p id=4></p>",
            "the link to `#4-13` leads to a page without `#4-13`",
        ),
        ("a.html", "<a href=\"c.html\">c</a>", "the link to `c.html` leads nowhere"),
        (
            "a.html",
            "<a href=\"b.html#here\">b</a>",
            "the link to `b.html#here` leads to a page without `#here`",
        ),
        ("a.html", "<p id=\"x\"><b id=\"x\">", "the id `x` stands on the page twice"),
        ("a.html", "<style>a{}</style><p>See</p>@eq:x now", "`@eq:x` was left as it is"),
        (
            "a.html",
            "<script src=\"https://example.org/x.js\"></script>",
            "<script> loads https://example.org/x.js from a network",
        ),
        (
            "a.html",
            "<p style=\"background:url(//example.org/x.png)\">",
            "<style> loads //example.org/x.png from a network",
        ),
        (
            "a.html",
            "<svg role=\"img\"><title>T</title><desc>D</desc><style>@import 'https://example.org/x.css';</style></svg>",
            "<style> loads https://example.org/x.css from a network",
        ),
        (
            "a.html",
            "<IMG SRC=\"HTTPS://example.org/x.png\">",
            "<img> loads HTTPS://example.org/x.png from a network",
        ),
        (
            "a.html",
            "<figure><svg role=\"img\"><title> </title><desc>D</desc></svg></figure>",
            "1 figures lack a title or a description",
        ),
        (
            "a.html",
            "<figure><svg><title>T</title><desc>D</desc></svg></figure>",
            "1 figures lack a title or a description",
        ),
        ("page.css", "a { background: url(\"x.png\") }", ""),
        (
            "page.css",
            "a { background: url(https://example.org/x.png) }",
            "the style sheet loads https://example.org/x.png from a network",
        ),
        // The documentation of the library is checked like the rest.
        ("api/c.html", "<a href=\"../b.html#there\">b</a> <a href=\"src/a.rs.html#1\">Source</a>", ""),
        ("api/c.html", "<a href=\"src/b.rs.html\">Source</a>", "the link to `src/b.rs.html` leads nowhere"),
        ("api/src/a.rs.html", "<a href=#1 id=1>1</a>", ""),
    ];

    #[test]
    fn each_fault_of_the_site_is_reported_once() {
        let folder = std::env::temp_dir().join(format!("press-site-{}", std::process::id()));
        for (file, text, expected) in CASES {
            fs::create_dir_all(folder.join("api/src")).unwrap();
            let write = |name: &str, text: &str| fs::write(folder.join(name), text).unwrap();
            write("b.html", "<p id=\"there\">b</p>");
            write("api/src/a.rs.html", "<a href=#1 id=1>1</a>");
            write("print.html", if file == "a.html" { text } else { "" });
            write(file, text);
            let faults = check(&folder, Examined::default()).unwrap();
            fs::remove_dir_all(&folder).unwrap();
            let said: Vec<_> =
                faults.iter().map(|fault| (fault.page.as_str(), fault.message.as_str())).collect();
            assert_eq!(said, Vec::from_iter((!expected.is_empty()).then_some((file, expected))), "{text}");
        }
    }
}

//! Checks of the finished site: what only the built HTML can show.

use crate::book::{slashed, text};
use crate::fault::{Faults, Lines};
use html5gum::{DefaultEmitter, StartTag, Token, Tokenizer};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{fs, io};

/// What one built page holds.
#[derive(Debug, Default)]
struct Built {
    ids: BTreeSet<String>,
    doubled_ids: BTreeSet<String>,
    /// Targets of links and of resources, with the attribute that holds them.
    targets: BTreeSet<(String, &'static str)>,
    /// Text that should have been replaced.
    unresolved: Vec<String>,
    /// Figures without title or description.
    mute_figures: usize,
    /// Characters in formulas.
    characters: BTreeSet<char>,
}

/// A fault of the site: the built page, a word that may stand in its Markdown, and what is wrong.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct SiteFault {
    /// Path of the page in the site: `laundromat/index.html`.
    pub(crate) page: String,
    /// The target or text at fault, by which its line can be found.
    pub(crate) clue: String,
    pub(crate) message: String,
}

/// What a look at the whole site brings.
#[derive(Debug, Default)]
pub(crate) struct Report {
    /// What is wrong with it.
    pub(crate) faults: Vec<SiteFault>,
    /// Every character that stands in a formula.
    pub(crate) characters: BTreeSet<char>,
}

/// Checks every page of the site in `folder`.
pub(crate) fn check(folder: &Path) -> io::Result<Report> {
    let mut files = Vec::new();
    walk(folder, Path::new(""), &mut files)?;
    let mut pages: BTreeMap<String, Built> = BTreeMap::new();
    let mut faults = Vec::new();
    for file in &files {
        let name = slashed(file);
        if name.ends_with(".html") {
            pages.insert(name, examine(&fs::read_to_string(folder.join(file))?));
        } else if name.ends_with(".css") {
            let css = fs::read_to_string(folder.join(file))?;
            if let Some(at) = remote_in_css(&css) {
                faults.push(SiteFault {
                    page: name,
                    clue: at.clone(),
                    message: format!("the style sheet loads {at} from a network"),
                });
            }
        }
    }
    let known: BTreeSet<String> = files.iter().map(|file| slashed(file)).collect();
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
    // mdBook prints the first page again as index.html and all of them as print.html, where a target may be written otherwise.
    if faults.iter().any(|fault| !is_copy(&fault.page)) {
        faults.retain(|fault| !is_copy(&fault.page));
    }
    faults.sort();
    let characters = pages.values().flat_map(|page| page.characters.iter().copied()).collect();
    Ok(Report { faults, characters })
}

/// Adds a fault for each style sheet of the book that loads something from a network.
pub(crate) fn check_style_sheets(root: &Path, source: &str, faults: &mut Faults) {
    let mut files = Vec::new();
    let _ = walk(&root.join(source), Path::new(""), &mut files); // what cannot be read is said of the pages
    for file in files.iter().filter(|file| file.extension().is_some_and(|ending| ending == "css")) {
        let name = format!("{source}/{}", slashed(file));
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

fn walk(root: &Path, below: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(root.join(below))? {
        let entry = entry?;
        let name = below.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            walk(root, &name, files)?;
        } else {
            files.push(name);
        }
    }
    Ok(())
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

/// Reads one page.
fn examine(html: &str) -> Built {
    let mut built = Built::default();
    // Depth inside elements whose text is not prose.
    let mut verbatim = 0_u32;
    let mut in_formula = false;
    let mut in_figure = false;
    // Whether the drawing that is being read has said its title and its description, and the element that the text is in.
    let mut svg: Option<(bool, bool)> = None;
    let mut element = String::new();
    let mut emitter = DefaultEmitter::new_with_span();
    emitter.naively_switch_states(true); // a script is no HTML
    for token in Tokenizer::new_with_emitter(html, emitter) {
        let Ok(token) = token;
        match token {
            Token::StartTag(tag) => {
                let name = String::from_utf8_lossy(&tag.name).into_owned();
                start(&mut built, &name, &tag);
                element.clone_from(&name);
                match name.as_str() {
                    "code" | "pre" | "script" | "style" | "title" if svg.is_none() && !tag.self_closing => {
                        verbatim += 1;
                    }
                    "figure" => in_figure = true,
                    "svg" if in_figure || attribute(&tag, "role").as_deref() == Some("img") => {
                        if attribute(&tag, "role").as_deref() != Some("img") {
                            built.mute_figures += 1;
                        }
                        svg = Some((false, false));
                    }
                    "math" => in_formula = true,
                    _ => {}
                }
            }
            Token::String(text) if element == "style" => {
                let css = String::from_utf8_lossy(&text).into_owned();
                built.targets.extend(remote_in_css(&css).map(|target| (target, "style")));
            }
            Token::String(text)
                if svg.is_some()
                    && matches!(element.as_str(), "title" | "desc")
                    && !text.trim_ascii().is_empty() =>
            {
                let (title, description) = svg.unwrap_or_default();
                svg = Some((title || element == "title", description || element == "desc"));
            }
            Token::EndTag(tag) => {
                element.clear();
                match tag.name.as_slice() {
                    b"figure" => in_figure = false,
                    b"code" | b"pre" | b"script" | b"style" | b"title" if svg.is_none() => {
                        verbatim = verbatim.saturating_sub(1);
                    }
                    b"math" => in_formula = false,
                    b"svg" if svg.take().is_some_and(|seen| seen != (true, true)) => {
                        built.mute_figures += 1;
                    }
                    _ => {}
                }
            }
            Token::String(text) if verbatim == 0 => {
                let text = String::from_utf8_lossy(&text).into_owned();
                if in_formula {
                    built.characters.extend(text.chars());
                }
                built.unresolved.extend(unresolved(&text));
            }
            _ => {}
        }
    }
    built
}

fn attribute(tag: &StartTag<()>, name: &str) -> Option<String> {
    tag.attributes.get(name.as_bytes()).map(|value| String::from_utf8_lossy(value).into_owned())
}

fn start(built: &mut Built, name: &str, tag: &StartTag<()>) {
    if let Some(id) = attribute(tag, "id")
        && !built.ids.insert(id.clone())
    {
        built.doubled_ids.insert(id);
    }
    if let Some(target) = attribute(tag, "style").and_then(|css| remote_in_css(&css)) {
        built.targets.insert((target, "style"));
    }
    let loads: &[(&str, &'static str)] = match name {
        "a" => &[("href", "a")],
        "link" => &[("href", "link")],
        "script" => &[("src", "script")],
        "img" => &[("src", "img")],
        "iframe" => &[("src", "iframe")],
        "use" => &[("href", "use"), ("xlink:href", "use")],
        "image" => &[("href", "image"), ("xlink:href", "image")],
        "source" | "video" | "audio" | "embed" => &[("src", "media")],
        "object" => &[("data", "object")],
        _ => &[],
    };
    for (key, kind) in loads {
        if let Some(target) = attribute(tag, key) {
            built.targets.insert((target, kind));
        }
    }
}

/// What looks like our dialect and is still there.
fn unresolved(text: &str) -> Option<String> {
    let suspicious = [
        "{#eq", "{#fig", "{#sec", "{#ex", "{#sol", "{#cite", "@eq:", "@fig:", "@ex:", "@sol:", "@sec:",
        "@source:", "@cite:", "$$",
    ];
    suspicious.iter().find_map(|mark| {
        let at = text.find(mark)?;
        Some(text[at..].chars().take_while(|c| !c.is_whitespace()).take(40).collect())
    })
}

/// Whether an address needs a network.
fn is_remote(target: &str) -> bool {
    let start = target.get(..6).unwrap_or(target).to_ascii_lowercase();
    start.starts_with("http:") || start == "https:" || start.starts_with("//")
}

/// The first address in a style sheet that needs a network.
fn remote_in_css(css: &str) -> Option<String> {
    let lower = css.to_ascii_lowercase();
    for mark in ["url(", "@import"] {
        for (at, _) in lower.match_indices(mark) {
            let rest = css[at + mark.len()..].trim_start_matches([' ', '"', '\'']);
            if is_remote(rest) {
                return Some(rest.chars().take_while(|c| !matches!(c, ')' | '"' | '\'' | ';')).collect());
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is said of a site of two pages, of which `b.html` has the anchor `there`.
    fn said(name: &str, html: &str, css: &str) -> Vec<String> {
        let folder = std::env::temp_dir().join(format!("press-site-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("a.html"), html).unwrap();
        fs::write(folder.join("b.html"), "<p id=\"there\">b</p>").unwrap();
        fs::write(folder.join("print.html"), html).unwrap();
        fs::write(folder.join("page.css"), css).unwrap();
        let report = check(&folder);
        fs::remove_dir_all(&folder).unwrap();
        report.unwrap().faults.into_iter().map(|fault| format!("{}: {}", fault.page, fault.message)).collect()
    }

    #[test]
    fn a_sound_site_has_no_faults() {
        let html = "<a href=\"b.html#there\">b</a> <a href=\"https://example.org\">out</a> <code>@eq:x</code>\
                    <figure><svg role=\"img\"><title>T</title><desc>D</desc><style>a{}</style></svg></figure>";
        assert_eq!(said("sound", html, "a { background: url(\"x.png\") }"), Vec::<String>::new());
    }

    #[test]
    fn each_fault_of_the_site_is_reported_once() {
        let titled = "<title>T</title><desc>D</desc>";
        for (name, html, css, expected) in [
            ("page", "<a href=\"c.html\">c</a>".to_owned(), "", "a.html: the link to `c.html` leads nowhere"),
            (
                "anchor",
                "<a href=\"b.html#here\">b</a>".to_owned(),
                "",
                "a.html: the link to `b.html#here` leads to a page without `#here`",
            ),
            ("id", "<p id=\"x\"><b id=\"x\">".to_owned(), "", "a.html: the id `x` stands on the page twice"),
            (
                "label",
                "<style>a{}</style><p>See</p>@eq:x now".to_owned(),
                "",
                "a.html: `@eq:x` was left as it is",
            ),
            (
                "script",
                "<script src=\"https://example.org/x.js\"></script>".to_owned(),
                "",
                "a.html: <script> loads https://example.org/x.js from a network",
            ),
            (
                "style",
                "<p style=\"background:url(//example.org/x.png)\">".to_owned(),
                "",
                "a.html: <style> loads //example.org/x.png from a network",
            ),
            (
                "sheet",
                "<svg role=\"img\">".to_owned()
                    + titled
                    + "<style>@import 'https://example.org/x.css';</style></svg>",
                "",
                "a.html: <style> loads https://example.org/x.css from a network",
            ),
            (
                "shouted",
                "<IMG SRC=\"HTTPS://example.org/x.png\">".to_owned(),
                "",
                "a.html: <img> loads HTTPS://example.org/x.png from a network",
            ),
            (
                "css",
                String::new(),
                "a { background: url(https://example.org/x.png) }",
                "page.css: the style sheet loads https://example.org/x.png from a network",
            ),
            (
                "untitled",
                "<figure><svg role=\"img\"><title> </title><desc>D</desc></svg></figure>".to_owned(),
                "",
                "a.html: 1 figures lack a title or a description",
            ),
            (
                "no-role",
                "<figure><svg>".to_owned() + titled + "</svg></figure>",
                "",
                "a.html: 1 figures lack a title or a description",
            ),
        ] {
            assert_eq!(said(name, &html, css), [expected], "{name}");
        }
    }

    #[test]
    fn a_range_of_lines_and_a_script_are_no_faults() {
        let html =
            "<script>let a = `<a href=\"${b}\">`;</script><a href=\"#4-12\">4</a><p id=4></p><p id=12></p>";
        assert_eq!(said("lines", html, ""), Vec::<String>::new());
        assert_eq!(said("no-line", "<a href=\"#4-13\">4</a><p id=4></p>", "").len(), 1);
    }

    #[test]
    fn only_formulas_ask_for_glyphs() {
        let built = examine("<p>a <math><mi>x</mi></math> b &#937; <math><mo>+</mo></math> c</p>");
        assert_eq!(built.characters.into_iter().collect::<String>(), "+x");
    }
}

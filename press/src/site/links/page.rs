//! One built page of the site, read.

use html::{StartTag, Token, attribute, text, tokens};
use std::collections::BTreeSet;

/// What one built page holds.
#[derive(Debug, Default)]
pub(super) struct Built {
    pub(super) ids: BTreeSet<String>,
    pub(super) doubled_ids: BTreeSet<String>,
    /// Targets of links and of resources, with the attribute that holds them.
    pub(super) targets: BTreeSet<(String, &'static str)>,
    /// Text that should have been replaced.
    pub(super) unresolved: Vec<String>,
    /// Figures without title or description.
    pub(super) mute_figures: usize,
}

/// Reads one page.
pub(super) fn examine(html: &str) -> Built {
    let mut built = Built::default();
    // Depth inside elements whose text is not prose.
    let mut verbatim = 0_u32;
    let mut in_figure = false;
    // Whether the drawing that is being read has said its title and its description, and the element that the
    // text is in.
    let mut svg: Option<(bool, bool)> = None;
    let mut element = String::new();
    for token in tokens(html) {
        match token {
            Token::StartTag(tag) => {
                let name = text(&tag.name);
                start(&mut built, &name, &tag);
                element.clone_from(&name);
                match name.as_str() {
                    "code" | "pre" | "script" | "style" | "title" if svg.is_none() && !tag.self_closing => {
                        verbatim += 1;
                    }
                    "figure" => in_figure = true,
                    "svg" if in_figure || attribute(&tag, "role").as_deref() == Some("img") => {
                        if attribute(&tag, "aria-hidden").as_deref() == Some("true") {
                            continue; // a panel for which another speaks
                        }
                        if attribute(&tag, "role").as_deref() != Some("img") {
                            built.mute_figures += 1;
                        }
                        svg = Some((false, false));
                    }
                    _ => {}
                }
            }
            Token::String(css) if element == "style" => {
                built.targets.extend(remote_in_css(&text(&css)).map(|target| (target, "style")));
            }
            Token::String(words)
                if svg.is_some()
                    && matches!(element.as_str(), "title" | "desc")
                    && !words.trim_ascii().is_empty() =>
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
                    b"svg" if svg.take().is_some_and(|seen| seen != (true, true)) => {
                        built.mute_figures += 1;
                    }
                    _ => {}
                }
            }
            Token::String(words) if verbatim == 0 => built.unresolved.extend(unresolved(&text(&words))),
            _ => {}
        }
    }
    built
}

fn start(built: &mut Built, name: &str, tag: &StartTag<usize>) {
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
        "link" if attribute(tag, "rel").as_deref() != Some("canonical") => &[("href", "link")], // which loads nothing
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
    if !text.contains(['{', '@', '$']) {
        return None;
    }
    let suspicious = [
        "{#eq", "{#fig", "{#scene", "{#sec", "{#ex", "{#sol", "{#cite", "@eq:", "@fig:", "@scene:", "@ex:",
        "@sol:", "@sec:", "@source:", "@cite:", "$$",
    ];
    suspicious.iter().find_map(|mark| {
        let at = text.find(mark)?;
        Some(text[at..].chars().take_while(|c| !c.is_whitespace()).take(40).collect())
    })
}

/// Whether an address needs a network.
pub(super) fn is_remote(target: &str) -> bool {
    let start = target.get(..6).unwrap_or(target).to_ascii_lowercase();
    start.starts_with("http:") || start == "https:" || start.starts_with("//")
}

/// The first address in a style sheet that needs a network.
pub(super) fn remote_in_css(css: &str) -> Option<String> {
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

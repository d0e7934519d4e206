//! The pages that SUMMARY.md names, and what Rust calls them.

use pulldown_cmark::{Event, Parser, Tag};

/// The paths of the pages below the folder of SUMMARY.md, in reading order, and where each is named. A chapter that is
/// no more than a title, `[Draft]()`, has no page.
pub fn links(summary: &str) -> Vec<(String, usize)> {
    let events = Parser::new(summary).into_offset_iter();
    let links = events.filter_map(|(event, range)| match event {
        Event::Start(Tag::Link { dest_url, .. }) if !dest_url.is_empty() => {
            Some((slashed(&dest_url.replace("%20", " ")), range.start)) // as mdBook does
        }
        _ => None,
    });
    links.collect()
}

/// The folders of the chapters: those with a page `index.md`.
pub fn chapters(summary: &str) -> Vec<String> {
    let paths = links(summary).into_iter();
    paths.filter_map(|(path, _)| path.strip_suffix("/index.md").map(str::to_owned)).collect()
}

/// A path with forward slashes and without steps that lead nowhere: `b.md` for `./b.md`.
pub fn slashed(path: &str) -> String {
    let path = path.replace('\\', "/");
    let parts = path.split('/').enumerate().filter(|(n, part)| *part != "." && (*n == 0 || !part.is_empty()));
    parts.map(|(_, part)| part).collect::<Vec<_>>().join("/")
}

/// A name as a part of one in Rust: `pinned_hoop` for `pinned-hoop`.
pub fn in_rust(name: &str) -> String {
    name.replace(|c: char| !c.is_ascii_alphanumeric(), "_").to_lowercase()
}

/// The same in capitals: `PINNED_HOOP`, and `_01_INTRO` where a digit would be first.
pub fn constant(name: &str) -> String {
    let digit = name.starts_with(|c: char| c.is_ascii_digit());
    format!("{}{}", if digit { "_" } else { "" }, in_rust(name).to_uppercase())
}

/// The module of the documentation tests of page number `n`. The number makes it a name of its own, and a name at all:
/// a folder may be called `loop` or `01-intro`.
pub fn module(n: usize, path: &str) -> String {
    let name = path.strip_suffix(".md").unwrap_or(path);
    format!("page_{n}_{}", in_rust(name.strip_suffix("/index").unwrap_or(name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_are_read_as_mdbook_reads_them() {
        let summary = "# Summary\n\n[Preface](preface.md)\n\n- [A](./01-intro/index.md)\n  - [B](loop/index.md \"tip\")\n  \
                       - [C](<b c.md>)\n  - [D](d%20e.md)\n- [Draft]()\n- [E](v1.0.md)\n- [F](a-b.md)\n- [G](a//b.md)\n";
        let ours: Vec<String> = links(summary).into_iter().map(|(path, _)| path).collect();
        let expected = [
            "preface.md",
            "01-intro/index.md",
            "loop/index.md",
            "b c.md",
            "d e.md",
            "v1.0.md",
            "a-b.md",
            "a/b.md",
        ];
        assert_eq!(ours, expected);
        assert_eq!(chapters(summary), ["01-intro", "loop"]);
        assert_eq!(
            chapters(summary).iter().map(|name| constant(name)).collect::<Vec<_>>(),
            ["_01_INTRO", "LOOP"]
        );
        let modules: Vec<String> = ours.iter().enumerate().map(|(n, path)| module(n, path)).collect();
        let expected = [
            "page_0_preface",
            "page_1_01_intro",
            "page_2_loop",
            "page_3_b_c",
            "page_4_d_e",
            "page_5_v1_0",
            "page_6_a_b",
            "page_7_a_b",
        ];
        assert_eq!(modules, expected);
    }
}

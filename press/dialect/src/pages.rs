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

/// A path with forward slashes and without steps that lead nowhere: `b.md` for `./b.md`.
pub fn slashed(path: &str) -> String {
    let path = path.replace('\\', "/");
    let parts = path.split('/').enumerate().filter(|(n, part)| *part != "." && (*n == 0 || !part.is_empty()));
    parts.map(|(_, part)| part).collect::<Vec<_>>().join("/")
}

/// The module of the documentation tests of page number `n`. The number makes it a name of its own, and a name at all:
/// a folder may be called `loop` or `01-intro`.
pub fn module(n: usize, path: &str) -> String {
    let name = path.strip_suffix(".md").unwrap_or(path);
    let name = name.strip_suffix("/index").unwrap_or(name);
    format!("page_{n}_{}", name.replace(|c: char| !c.is_ascii_alphanumeric(), "_").to_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_are_read_as_mdbook_reads_them() {
        let summary = "# Summary\n\n[Preface](preface.md)\n\n- [A](./01-intro/index.md)\n  - [B](loop/index.md \"tip\")\n  \
                       - [C](<b c.md>)\n  - [D](d%20e.md)\n- [Draft]()\n- [E](v1.0.md)\n- [F](a-b.md)\n- [G](a//b.md)\n";
        let ours: Vec<String> = links(summary).into_iter().map(|(path, _)| path).collect();
        let expected = "preface.md|01-intro/index.md|loop/index.md|b c.md|d e.md|v1.0.md|a-b.md|a/b.md";
        assert_eq!(ours.join("|"), expected);
        let modules: Vec<String> = ours.iter().enumerate().map(|(n, path)| module(n, path)).collect();
        let expected = "page_0_preface page_1_01_intro page_2_loop page_3_b_c page_4_d_e page_5_v1_0 page_6_a_b page_7_a_b";
        assert_eq!(modules.join(" "), expected);
    }
}

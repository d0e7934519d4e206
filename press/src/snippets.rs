//! The rules for code on pages.

use crate::checks::{self, Folded};
use crate::markdown::{self, code_lines, column};
use crate::{answers, printed};
use pulldown_cmark::CodeBlockKind;
use std::ops::Range;

/// The languages that a fence may name. Anything else, `rs` for instance, would look like Rust and never run.
const LANGUAGES: [&str; 8] = ["rust", "text", "console", "sh", "toml", "markdown", "python", "csv"];
/// How many lines of a snippet a reader may be asked to take in.
const MAX_VISIBLE_LINES: usize = 25;
/// How many characters of a line fit on the page before it has to be scrolled.
const MAX_WIDTH: usize = 86;

/// Reports what is wrong with a code block of `text` as (offset, message).
pub(crate) fn check(
    text: &str,
    kind: &CodeBlockKind<'_>,
    range: &Range<usize>,
    mut fault: impl FnMut(usize, String),
) {
    let CodeBlockKind::Fenced(info) = kind else {
        return;
    };
    if !is_closed(&text[range.clone()]) {
        fault(
            range.start,
            "the fence is not closed: as many of the same marks stand below the code".to_owned(),
        );
    }
    let mut words = info.split([',', ' ', '\t']).map(str::trim).filter(|word| !word.is_empty());
    let Some(language) = words.next() else {
        fault(
            range.start,
            "a fence needs a language (`rust`, `text`, `console`, …): untagged it would run as Rust"
                .to_owned(),
        );
        return;
    };
    if !LANGUAGES.contains(&language) {
        fault(
            range.start,
            format!("`{language}` is no language of this book: write one of {}", LANGUAGES.join(", ")),
        );
    }
    if language != "rust" {
        return;
    }
    for word in words {
        let shows_a_failure = matches!(word, "should_panic" | "compile_fail") || word.starts_with('E');
        if !shows_a_failure {
            fault(
                range.start,
                format!("`{word}`: every snippet runs; show what fails with should_panic or compile_fail"),
            );
        }
    }
    let lines: Vec<&str> = text[range.clone()].lines().collect();
    let code = code_lines(&lines);
    let shown = checks::folded(&lines[code.clone()]).map_or(code.end, |folded| code.start + folded.from);
    let is_told = info.contains(',') || column(text, range.start) > 0;
    let (_, broken) = answers::answers(&lines);
    let marked = lines.iter().any(|line| answers::is_marked(line));
    if marked && is_told {
        fault(
            range.start,
            "a snippet with live numbers stands on its own, in a list or quotation no more than in a fence with \
             `should_panic` or `compile_fail`: the page runs it"
                .to_owned(),
        );
    }
    let mut count = 0;
    let mut offset = range.start;
    for (n, line) in text[range.clone()].split_inclusive('\n').enumerate() {
        let here = line.trim_end();
        if code.contains(&n) && !checks::is_hidden(line) {
            count += usize::from(n < shown);
            let width = width(here);
            if width > MAX_WIDTH {
                fault(
                    offset,
                    format!(
                        "this line of code has {width} characters; more than {MAX_WIDTH} do not fit on the page"
                    ),
                );
            }
        }
        if let Some(Err(message)) = printed::read(&lines, n) {
            fault(offset, message.to_owned());
        }
        broken
            .iter()
            .filter(|(at, _)| marked && *at == n)
            .for_each(|(_, message)| fault(offset, message.clone()));
        offset += line.len();
    }
    if count > MAX_VISIBLE_LINES {
        fault(
            range.start,
            format!(
                "the snippet shows {count} lines; {MAX_VISIBLE_LINES} are the most that a reader can be asked to take in"
            ),
        );
    }
}

/// A fenced block with the units of its live numbers, whose ranges only the panel beside it knows.
pub(crate) fn without_ranges(block: &str) -> String {
    let shown = |line: &str| match answers::live(line) {
        Some(Ok(live)) => {
            let unit = if live.unit.is_empty() { String::new() } else { format!(" // {}", live.unit) };
            format!("{}{}{}{unit}\n", live.before, live.literal, live.after)
        }
        _ => format!("{line}\n"),
    };
    block.lines().map(shown).collect()
}

/// A fenced block with the panel of its live numbers beside it, and with its last assertions in a block of
/// their own that opens on demand if they are many.
pub(crate) fn with_folded_checks(block: &str, panel: Option<&str>) -> String {
    let beside = |block: &str| match panel {
        Some(panel) => format!("<div class=\"answering\">\n\n{block}\n\n{panel}\n</div>\n"),
        None => block.to_owned(),
    };
    let lines: Vec<&str> = block.lines().collect();
    let code = code_lines(&lines);
    let Some(Folded { from, count }) = checks::folded(&lines[code.clone()]) else {
        return beside(block);
    };
    let cut = code.start + from;
    let words = lines[0].trim_start_matches(['`', '~']).len();
    let fence = &lines[0][..lines[0].len() - words];
    if lines[code.end..] != [fence] {
        return beside(block); // in a list or a quotation, where a block cannot be cut in two
    }
    let (shown, hidden) = (lines[..cut].join("\n"), lines[cut..code.end].join("\n"));
    let noun = if count == 1 { "check" } else { "checks" };
    let shown = beside(&format!("{}\n{fence}", shown.trim_end()));
    format!(
        "{shown}\n\n<details class=\"checks\">\n<summary>{count} {noun}</summary>\n\n{}\n{hidden}\n{fence}\n\n</details>\n",
        lines[0],
    )
}

/// Whether a fenced block ends with its fence, whatever quotation or list it stands in.
fn is_closed(block: &str) -> bool {
    let Some(mark) = block.chars().next() else {
        return false;
    };
    let marks = block.chars().take_while(|&c| c == mark).count();
    let last = block.trim_end().lines().skip(1).last().unwrap_or_default();
    let last = last.trim_start_matches([' ', '\t', '>']);
    last.chars().count() >= marks && last.chars().all(|c| c == mark)
}

/// How wide a line is on the page: accents take no room, and a label becomes a number such as (1.28).
fn width(line: &str) -> usize {
    let characters = line.chars().filter(|c| !('\u{300}'..='\u{36f}').contains(c)).count();
    let labels = cited_labels(line, &(0..line.len()));
    characters - labels.iter().map(|(_, label)| label.len().saturating_sub("(1.28)".len())).sum::<usize>()
}

/// The labels that comments of a Rust snippet cite, as (place, label as written): `// eq:newton` → `eq:newton`.
pub(crate) fn cited_labels<'a>(text: &'a str, range: &Range<usize>) -> Vec<(Range<usize>, &'a str)> {
    let mut found = Vec::new();
    let mut offset = range.start;
    for line in text[range.clone()].split_inclusive('\n') {
        if let Some(comment) = line.find("//") {
            for (at, _) in line[comment..].match_indices("eq:") {
                let start = comment + at;
                let rest = &line[start + 3..];
                let end = rest
                    .find(|c: char| !(c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'))
                    .unwrap_or(rest.len());
                found.push((offset + start..offset + start + 3 + end, &line[start..start + 3 + end]));
            }
        }
        offset += line.len();
    }
    found
}

/// The page with every Rust fence relabelled, so that rustdoc has nothing left to test.
pub(crate) fn relabelled(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut done = 0;
    for snippet in markdown::snippets(text) {
        let fence = text[snippet.range.clone()].lines().next().unwrap_or_default();
        let marks = fence.len() - fence.trim_start_matches(['`', '~', ' ']).len();
        out.push_str(&text[done..snippet.range.start + marks]);
        out.push_str("text");
        done = snippet.range.start + fence.len();
    }
    out + &text[done..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_checks_are_folded_into_a_block_of_their_own() {
        let checks = "assert!(a);\nassert!(\n    a\n);\n# Ok(())";
        assert_eq!(
            with_folded_checks(&format!("```rust\n# use x;\nlet a = 1;\n\n{checks}\n```\n"), None),
            format!(
                "```rust\n# use x;\nlet a = 1;\n```\n\n<details class=\"checks\">\n<summary>2 checks</summary>\n\n\
                 ```rust\n{checks}\n```\n\n</details>\n"
            )
        );
        let few = "```rust\nlet a = 1;\nassert!(a);\n```\n";
        assert_eq!(with_folded_checks(few, None), few);
    }

    #[test]
    fn a_live_number_shows_its_unit_and_a_panel_beside_it() {
        let block = "```rust\nlet a = 1.0; // live: 0..2 m\nlet b = 2; // live: 0..2\nf(); // → 3\n```";
        let shown = without_ranges(block);
        assert_eq!(shown, "```rust\nlet a = 1.0; // m\nlet b = 2;\nf(); // → 3\n```\n");
        assert_eq!(
            with_folded_checks(&shown, Some("<div>P</div>")),
            format!("<div class=\"answering\">\n\n{shown}\n\n<div>P</div>\n</div>\n")
        );
    }

    #[test]
    fn no_rust_is_left_wherever_its_fence_stands() {
        let text = "```rust,should_panic\na();\n```\n\n- item\n\n  ```rust\n  b();\n  ```\n\n> ~~~rust\n> c();\n> ~~~\n\n```console\nrust\n```\n";
        let relabelled = relabelled(text);
        assert_eq!(
            relabelled,
            "```text\na();\n```\n\n- item\n\n  ```text\n  b();\n  ```\n\n> ~~~text\n> c();\n> ~~~\n\n```console\nrust\n```\n"
        );
    }
}

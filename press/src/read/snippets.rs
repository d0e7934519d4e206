//! The rules for code on pages.

use crate::read::items::{Label, LabelKind};
use crate::read::{folded_assertions, label_syntax};
use dialect::markdown::{self, code_lines, column};
use dialect::{expected_output, live_numbers};
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
    let CodeBlockKind::Fenced(info) = kind else { return };
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
    let shown =
        folded_assertions::folded(&lines[code.clone()]).map_or(code.end, |folded| code.start + folded.from);
    let is_told = info.contains(',') || column(text, range.start) > 0;
    let (_, broken) = live_numbers::answers(&lines);
    let marked = lines.iter().any(|line| live_numbers::is_marked(line));
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
        if code.contains(&n) && !folded_assertions::is_hidden(line) {
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
        if let Some(Err(message)) = expected_output::read(&lines, n) {
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

/// Whether a fenced block ends with its fence, whatever quotation or list it stands in.
fn is_closed(block: &str) -> bool {
    let Some(mark) = block.chars().next() else { return false };
    let marks = block.chars().take_while(|&c| c == mark).count();
    let last = block.trim_end().lines().skip(1).last().unwrap_or_default();
    let last = last.trim_start_matches([' ', '\t', '>']);
    last.chars().count() >= marks && last.chars().all(|c| c == mark)
}

/// How wide a line is on the page: accents take no room, and a label becomes a number such as (1.28).
fn width(line: &str) -> usize {
    let characters = line.chars().filter(|c| !('\u{300}'..='\u{36f}').contains(c)).count();
    let labels = cited_equations(line).into_iter();
    characters - labels.map(|(_, label)| label.written().len().saturating_sub("(1.28)".len())).sum::<usize>()
}

/// The equations that comments of a Rust snippet cite, and where they are named: `// eq:newton`.
pub(crate) fn cited_equations(text: &str) -> Vec<(Range<usize>, Label)> {
    let mut found = Vec::new();
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        for (at, label) in label_syntax::cited(line).filter(|(_, label)| label.kind == LabelKind::Equation) {
            found.push((offset + at..offset + at + label.written().len(), label));
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
    fn no_rust_is_left_wherever_its_fence_stands() {
        let text = "```rust,should_panic\na();\n```\n\n- item\n\n  ```rust\n  b();\n  ```\n\n> ~~~rust\n> c();\n> ~~~\n\n```console\nrust\n```\n";
        let relabelled = relabelled(text);
        assert_eq!(
            relabelled,
            "```text\na();\n```\n\n- item\n\n  ```text\n  b();\n  ```\n\n> ~~~text\n> c();\n> ~~~\n\n```console\nrust\n```\n"
        );
    }
}

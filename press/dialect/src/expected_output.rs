//! Numbers that a page prints behind its code, `let rate = wheel.turn_rate(); // → 4.317 rad/s`, and that its
//! test holds to the last digit shown.
//!
//! What the press accepts here the build script of the pages' crate tests.

use crate::markdown::{self, Snippet};
use std::borrow::Cow;

/// What opens the comment that holds the numbers.
const ARROW: char = '→';
const FORM: &str = "a printed number is written `// → 4.317 rad/s`, several `// → 1.2, 3.4`";

/// A line of a snippet that prints numbers.
#[derive(Debug, PartialEq, Eq)]
pub struct Printed<'a> {
    /// The line without its comment.
    pub code: &'a str,
    /// Of the code, the expression that has the value: all of it, or what its `let` binds.
    pub value: &'a str,
    /// The numbers, as they stand: `4.317`, or several with commas between.
    pub numbers: &'a str,
    /// Whether `code` is the expression itself.
    pub bare: bool,
}

/// What the line `lines[at]` prints, if it has the mark; `Err` says what is wrong with it.
pub fn read<'a>(lines: &[&'a str], at: usize) -> Option<Result<Printed<'a>, &'static str>> {
    let line = lines[at];
    let mark = line.split_once(ARROW);
    let Some((code, after)) =
        mark.and_then(|(code, after)| Some((code.trim_end().strip_suffix("//")?, after)))
    else {
        return is_near_miss(line).then_some(Err(FORM));
    };
    let code = code.trim_end();
    Some(numbers(after).and_then(|numbers| {
        let (value, bare) = value(lines, at, code)?;
        Ok(Printed { code, value, numbers, bare })
    }))
}

/// Whether a comment has an arrow before a number where nothing would test it: `// -> 7.0`, `// about → 7.0`.
fn is_near_miss(line: &str) -> bool {
    let behind = ["→", "->", "=>"].map(|arrow| comment(line).split(arrow).skip(1));
    behind.into_iter().flatten().any(|behind| number(behind.trim_start()).is_some())
}

/// The comment that a line of code ends with, or nothing.
pub fn comment(line: &str) -> &str {
    let start = ["//", "/*"].into_iter().filter_map(|mark| line.find(mark)).min();
    &line[start.unwrap_or(line.len())..]
}

/// The numbers at the beginning of a comment; any words may follow, as its unit.
fn numbers(comment: &str) -> Result<&str, &'static str> {
    let text = comment.strip_prefix(' ').ok_or(FORM)?;
    let mut end = number(text).ok_or(FORM)?;
    while let Some(next) = text[end..].strip_prefix(", ").and_then(number) {
        end += ", ".len() + next;
    }
    let rest = text[end..].strip_prefix(',').unwrap_or(&text[end..]);
    let goes_on = rest.starts_with(|c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '_'));
    if goes_on { Err(FORM) } else { Ok(&text[..end]) }
}

/// The length of the number that a text begins with: `-4.317`, `12`, `1.2e-5`.
pub fn number(text: &str) -> Option<usize> {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let mut end = usize::from(text.starts_with('-'));
    let whole = digits(&text[end..]);
    end += whole;
    if let Some(rest) = text[end..].strip_prefix('.').filter(|rest| digits(rest) > 0) {
        end += 1 + digits(rest);
    }
    if let Some(rest) = text[end..].strip_prefix('e') {
        let sign = usize::from(rest.starts_with('-'));
        let power = digits(&rest[sign..]);
        end += if power > 0 { 1 + sign + power } else { 0 };
    }
    (whole > 0).then_some(end)
}

/// The expression that a statement gives its value to, or is, and whether it is the statement itself.
fn value<'a>(lines: &[&'a str], at: usize, code: &'a str) -> Result<(&'a str, bool), &'static str> {
    let statement = code.trim_start().strip_suffix(';');
    let statement =
        statement.ok_or("a printed number stands behind the end of a statement, `…; // → 4.317`")?;
    if let Some(bound) = statement.strip_prefix("let ") {
        return Ok((pattern(bound), false));
    }
    if !statement.starts_with(|c: char| c.is_alphanumeric() || matches!(c, '_' | '(' | '[' | '"')) {
        // The last line of a longer statement.
        let above = lines[..at].iter().rev().take_while(|line| !line.trim_end().ends_with(';'));
        let bound = above.map(|line| line.trim_start()).find_map(|line| line.strip_prefix("let "));
        let bound = bound.ok_or("a printed number of a long statement needs a `let` at its beginning")?;
        return Ok((pattern(bound), false));
    }
    Ok((statement, true))
}

/// What a `let` binds: a name, or several in brackets.
fn pattern(bound: &str) -> &str {
    let bound = bound.strip_prefix("mut ").unwrap_or(bound);
    let end = match bound.chars().next() {
        Some('(') => bound.find(')').map(|at| at + 1),
        Some('[') => bound.find(']').map(|at| at + 1),
        _ => bound.find(|c: char| !c.is_alphanumeric() && c != '_'),
    };
    &bound[..end.unwrap_or(bound.len())]
}

/// The page with a check in the place of each printed number, and at the beginning of each snippet what names it if it
/// fails; every line keeps its number. `file` names the page.
pub fn tested(page: &str, file: &str) -> String {
    let mut lines: Vec<Cow<'_, str>> = page.lines().map(Cow::Borrowed).collect();
    for Snippet { line: above, code, .. } in markdown::snippets(page) {
        let is_whole = code.iter().any(|line| line.contains("fn main("));
        let named = format!("::live::snippet::begin({file:?}, {}); ", above + 1);
        let begin = if is_whole { String::new() } else { named };
        for (at, line) in code.iter().enumerate() {
            let mut tested = match read(&code, at) {
                Some(Ok(Printed { code, value, numbers, bare })) => {
                    let indent = &code[..code.len() - code.trim_start().len()];
                    let kept = if bare { indent.to_owned() } else { format!("{code} ") };
                    let place = format!("{file}:{}", above + at + 1);
                    format!("{kept}::live::snippet::printed(&({value}), {numbers:?}, {place:?});")
                }
                _ => (*line).to_owned(),
            };
            if at == 0 {
                tested = begin.clone() + tested.strip_prefix("# ").unwrap_or(&tested);
            }
            let whole = &lines[above + at];
            lines[above + at] = Cow::Owned(format!("{}{tested}", &whole[..whole.len() - line.len()]));
        }
    }
    lines.join("\n") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_printed_number_becomes_a_check_in_its_line() {
        let page = "```rust\nlet a = f(); // → 4.317 rad/s\n\
                    let b: f64 = g()\n    .h(2); // → -1.2e-5\n\
                    # let mut c = 1;\n  c + f(1); // → 12\n\
                    let [x, y] = z(); // → 1.0, 2 m, 3\n\
                    let d = 3; // a → b\n```\n\nNot `// → 5`.\n";
        let expected = "```rust\n::live::snippet::begin(\"p.md\", 2); let a = f(); ::live::snippet::printed(&(a), \"4.317\", \"p.md:2\");\n\
                        let b: f64 = g()\n    .h(2); ::live::snippet::printed(&(b), \"-1.2e-5\", \"p.md:4\");\n\
                        # let mut c = 1;\n  ::live::snippet::printed(&(c + f(1)), \"12\", \"p.md:6\");\n\
                        let [x, y] = z(); ::live::snippet::printed(&([x, y]), \"1.0, 2\", \"p.md:7\");\n\
                        let d = 3; // a → b\n```\n\nNot `// → 5`.\n";
        assert_eq!(tested(page, "p.md"), expected);
    }

    #[test]
    fn a_snippet_begins_with_what_names_it() {
        let page = "```rust\n# use a::b;\n# b();\n```\n\n```rust\nlet a = 1; // → 1\n```\n";
        let expected = "```rust\n::live::snippet::begin(\"p.md\", 2); use a::b;\n# b();\n```\n\n\
                        ```rust\n::live::snippet::begin(\"p.md\", 7); let a = 1; ::live::snippet::printed(&(a), \"1\", \"p.md:7\");\n```\n";
        assert_eq!(tested(page, "p.md"), expected);
    }
}

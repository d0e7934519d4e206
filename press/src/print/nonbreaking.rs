//! What belongs together at the end of a line: a formula and its punctuation, a number and its unit; and
//! which brackets there are already.

use live::numbers::{BLANK, unit};

/// The longest word that hangs on a formula: `$x$-axis`.
const LONGEST: usize = 16;

/// How many bytes before and behind a formula may not be parted from it.
pub(crate) fn around(before: &str, after: &str) -> (usize, usize) {
    let head = if before.ends_with('(') && !before.ends_with("](") { 1 } else { 0 };
    let unit = unit(after).unwrap_or(0);
    let rest = &after[unit..];
    let hangs = |c: char| c.is_alphanumeric() || ",.;:!?)-–’'\"”".contains(c);
    let tail = rest.find(|c| !hangs(c)).unwrap_or(rest.len());
    (head, unit + if tail > LONGEST { rest.find(char::is_alphanumeric).unwrap_or(tail) } else { tail })
}

/// A formula with the text around it that was found [`around`] it. Straight quotes close what was said, as nothing
/// tells Markdown so any more.
pub(crate) fn tied(head: &str, formula: &str, tail: &str) -> String {
    if head.is_empty() && tail.is_empty() {
        return formula.to_owned();
    }
    let tail = tail.replace('\'', "’").replace('"', "”").replace([' ', '\n'], BLANK);
    format!("<span class=\"tied\">{head}{formula}{tail}</span>")
}

/// What stands in the round bracket that is open at the end of a page's text, in its last paragraph and outside of
/// mathematics and code.
fn in_brackets(before: &str) -> Option<&str> {
    let paragraph = before.rsplit("\n\n").next().unwrap_or(before);
    let (mut open, mut within) = (Vec::new(), None);
    for (at, c) in paragraph.char_indices() {
        match (within, c) {
            (None, '$' | '`') => within = Some(c),
            (Some(mark), _) if mark == c => within = None,
            (None, '(') => open.push(at + 1),
            (None, ')') => drop(open.pop()),
            _ => {}
        }
    }
    open.last().map(|&at| &paragraph[at..])
}

/// How a reference behind the text `before` is printed, where alone it would be `(2.31)`. A bracket that begins with
/// references is theirs, `(2.31, 2.32)`; elsewhere in one a bare number would be read as a value.
pub(crate) fn in_place(reference: String, before: &str) -> String {
    let bare = reference.strip_prefix('(').and_then(|words| words.strip_suffix(')'));
    let (Some(bare), Some(inside)) = (bare, in_brackets(before)) else {
        return reference;
    };
    let is_reference = |word: &str| word.is_empty() || word.starts_with('@') || word == "and";
    if inside.split([' ', '\n', ',', ';']).all(is_reference) {
        bare.to_owned()
    } else {
        format!("Eq.{BLANK}{bare}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_keeps_its_punctuation_and_its_unit() {
        let parts = |before: &str, after: &str| {
            let (head, tail) = around(before, after);
            (before[before.len() - head..].to_owned(), after[..tail].to_owned())
        };
        for (before, after, head, tail) in [
            ("and ", ", where", "", ","),
            ("words (", "). More", "(", ")."),
            ("[a](", ") b", "", ")"),
            ("the ", "-axis, so", "", "-axis,"),
            ("of ", " rad/s, as", "", " rad/s,"),
            ("of ", " meals", "", ""),
            ("the ", "-dimensional-looking thing", "", "-"),
            ("so ", "?* Yes", "", "?"),
            ("so ", ".](fig:x)", "", "."),
            ("", "", "", ""),
        ] {
            assert_eq!(parts(before, after), (head.to_owned(), tail.to_owned()), "{before}…{after}");
        }
        assert_eq!(tied("", "X", ""), "X");
        assert_eq!(tied("(", "X", " s)\""), "<span class=\"tied\">(X\u{a0}s)”</span>");
    }

    #[test]
    fn a_reference_in_brackets_is_no_value() {
        let [alone, bare, word] = ["(2.31)", "2.31", "Eq.\u{a0}2.31"];
        for (before, printed) in [
            ("so (", bare),
            ("so (@eq:x, @eq:y and ", bare),
            ("(For any body it is ", word),
            ("(@sec:x, by ", word),
            ("(a) and ", alone),
            ("((a) and ", word),
            ("$f(x$ and `g(` ", alone),
            ("(lost\n\nnew ", alone),
            ("[a](b.md) and ", alone),
        ] {
            assert_eq!(in_place(alone.to_owned(), before), printed, "{before}");
        }
        assert_eq!(in_place("Figure 1.2".to_owned(), "(in "), "Figure 1.2");
    }
}

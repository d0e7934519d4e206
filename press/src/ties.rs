//! What belongs together at the end of a line: a formula and its punctuation, a number and its unit; and
//! which brackets there are already.

/// A blank at which no line ends.
pub(crate) const BLANK: &str = "\u{a0}";

/// Units that stand behind a number.
const UNITS: [&str; 22] = [
    "kg", "g", "m", "cm", "mm", "km", "s", "ms", "ns", "µs", "min", "h", "N", "J", "W", "Hz", "rad", "rad/s",
    "m/s", "kg/s", "N/m", "%",
];
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

/// Where in a run of text a blank stands between a number and its unit.
pub(crate) fn blanks(text: &str) -> Vec<usize> {
    let digit = |at: usize| text[..at].ends_with(|c: char| c.is_ascii_digit());
    let places = text.match_indices([' ', '\n']).map(|(at, _)| at);
    places.filter(|&at| digit(at) && unit(&text[at..]).is_some()).collect()
}

/// How long the blank and the unit are with which a text begins.
fn unit(text: &str) -> Option<usize> {
    let rest = text.strip_prefix([' ', '\n'])?;
    let end = rest.find(|c: char| !(c.is_alphabetic() || c == '/' || c == '%')).unwrap_or(rest.len());
    (UNITS.contains(&&rest[..end]) && !rest[end..].starts_with(['^', '·'])).then_some(1 + end)
}

/// Whether a round bracket stands open at the end of a page's text, in its last paragraph and outside of
/// mathematics and code.
pub(crate) fn in_brackets(before: &str) -> bool {
    let paragraph = before.rsplit("\n\n").next().unwrap_or(before);
    let (mut open, mut within) = (0_usize, None);
    for c in paragraph.chars() {
        match (within, c) {
            (None, '$' | '`') => within = Some(c),
            (Some(mark), _) if mark == c => within = None,
            (None, '(') => open += 1,
            (None, ')') => open = open.saturating_sub(1),
            _ => {}
        }
    }
    open > 0
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
    fn a_number_keeps_its_unit() {
        assert_eq!(blanks("It has 5 kg, 3 m and 20 meals; in 4\ns, 9 % at 1.5 rad/s"), [8, 14, 35, 40, 49]);
    }

    #[test]
    fn brackets_are_counted_outside_of_formulas_and_code() {
        for (text, inside) in [
            ("so (", true),
            ("(as in ", true),
            ("(a) and ", false),
            ("$f(x$ and `g(` ", false),
            ("(lost\n\nnew ", false),
            ("[a](b.md) and ", false),
        ] {
            assert_eq!(in_brackets(text), inside, "{text}");
        }
    }
}

//! The assertions at the end of a snippet, which the page folds away when there are many lines of them.

/// How many lines of checks a reader is shown; more are folded.
const MAX_SHOWN: usize = 3;

/// The checks of a snippet that are folded.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Folded {
    /// The first of their lines: those below it are checks, or hidden.
    pub(crate) from: usize,
    /// How many assertions they hold.
    pub(crate) count: usize,
}

/// Whether a line of a snippet is there for the test and not for the reader.
pub(crate) fn is_hidden(line: &str) -> bool {
    let line = line.trim_start();
    line.trim_end() == "#" || line.starts_with("# ")
}

/// The last statements of a snippet if they are assertions, on more than [`MAX_SHOWN`] lines with the
/// comments right above each, and stand below something else.
pub(crate) fn folded(lines: &[&str]) -> Option<Folded> {
    let mut found = Folded { from: lines.len(), count: 0 };
    let (mut shown, mut seen) = (0, 0);
    for (at, line) in lines.iter().enumerate().rev().filter(|(_, line)| !is_hidden(line)) {
        seen += 1;
        if line.starts_with("assert") && line.contains("!(") {
            found = Folded { from: at, count: found.count + 1 };
            shown = seen;
        } else if line.starts_with("//") && shown + 1 == seen {
            found.from = at;
            shown = seen;
        } else if !line.is_empty() && !line.starts_with([' ', ')', ']', '}']) {
            break;
        }
    }
    let above = lines[..found.from].iter().any(|line| !is_hidden(line) && !line.trim().is_empty());
    (found.count > 0 && shown > MAX_SHOWN && above).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(code: &str) -> Option<(usize, usize)> {
        folded(&code.lines().collect::<Vec<_>>()).map(|Folded { from, count }| (from, count))
    }

    #[test]
    fn a_tail_of_assertions_is_folded_with_its_comments() {
        let tail =
            "// why\n// indeed\nassert!(a);\n\nassert_relative_eq!(\n    b,\n    c\n);\n# Ok(())\n# }\n";
        assert_eq!(of(&format!("# use x;\nlet a = f(\n    1\n);\n{tail}")), Some((4, 2)));
        assert_eq!(of(&format!("# use x;\n{tail}")), None, "nothing else would be left");
        assert_eq!(of("let a = 1;\nassert!(a);\nassert!(a);\nassert!(a);\n"), None, "three lines are shown");
        assert_eq!(of("let a = 1;\nassert!(a);\nassert!(a);\nassert!(a);\nassert!(a);\n"), Some((1, 4)));
        assert_eq!(of("assert!(a);\nlet a = f(\n  1,\n  2,\n  3\n);\n"), None, "no assertion is last");
    }
}

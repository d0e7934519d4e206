//! What may stand nowhere on a page: characters that nobody sees, and directives of mdBook.

use crate::fault::Reporter;

pub(crate) fn check(text: &str, report: &mut Reporter<'_>) {
    characters(text, |at, message| report.fault(at, message));
    directives(text, report);
}

/// Control characters, and those that turn the direction of the text around them.
pub(crate) fn characters(text: &str, mut fault: impl FnMut(usize, String)) {
    for (at, c) in text.char_indices() {
        let code = u32::from(c);
        if matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}') {
            fault(
                at,
                format!("the invisible character U+{code:04X} turns the direction of the text: delete it"),
            );
        } else if c.is_control() && !matches!(c, '\n' | '\r' | '\t') {
            fault(at, format!("the control character U+{code:04X} has no place in a text: delete it"));
        }
    }
}

/// `{{#include …}}` and its kin, which mdBook would replace, wherever they stand, or leave if they fail.
fn directives(text: &str, report: &mut Reporter<'_>) {
    for (at, _) in text.match_indices("{{") {
        let name = text[at + 2..].trim_start().strip_prefix('#').map(str::trim_start);
        let name =
            name.map(|rest| &rest[..rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len())]);
        if let Some(name) = name.filter(|name| !name.is_empty() && !text[..at].ends_with('\\')) {
            report.fault(
                at,
                format!(
                    "`{{{{#{name}`: mdBook's directives have no place in this book; \
                     in code, `\\{{{{#{name}` shows the words themselves"
                ),
            );
        }
    }
}

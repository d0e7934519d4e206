//! The widths of words in the page's sans, and their letters for pictures that stand alone.
//!
//! The build script took them out of Open Sans Regular, which the pages load: 2048 units to the em. Words are set as
//! text and stretched to these widths, so that a figure keeps its layout on a machine that has another sans.

const UNITS_PER_EM: f64 = 2048.0;
/// Height of capitals and of lower-case letters, and depth of the letters that descend, in ems (`OS/2` and `glyf`).
pub(super) const CAPITAL_HEIGHT: f64 = 1462.0 / UNITS_PER_EM;
pub(super) const ASCENDER: f64 = 1556.0 / UNITS_PER_EM;
pub(super) const X_HEIGHT: f64 = 1096.0 / UNITS_PER_EM;
pub(super) const DESCENDER: f64 = 492.0 / UNITS_PER_EM;

include!(concat!(env!("OUT_DIR"), "/letters.rs")); // ADVANCES: characters and their advances; OUTLINES: those of each

/// The advance of a character in ems, or `None` if the table does not hold it.
pub(super) fn advance(character: char) -> Option<f64> {
    Some(f64::from(ADVANCES[index(character)?].1) / UNITS_PER_EM)
}

/// The outline of a character in font units, y upwards, and its advance and a font unit in ems.
pub(super) fn letter(character: char) -> Option<(&'static [i16], f64, f64)> {
    Some((OUTLINES[index(character)?], advance(character)?, 1.0 / UNITS_PER_EM))
}

fn index(character: char) -> Option<usize> {
    ADVANCES.binary_search_by_key(&character, |letter| letter.0).ok()
}

/// How far a character reaches above and below the baseline, in ems, to the nearest class of letters.
pub(super) fn extent(character: char) -> (f64, f64) {
    match character {
        ' ' | '\u{a0}' => (0.0, 0.0),
        'g' | 'p' | 'q' | 'y' => (X_HEIGHT, DESCENDER),
        'j' | '(' | ')' | '[' | ']' | '{' | '}' | '|' => (ASCENDER, DESCENDER),
        ',' | ';' => (X_HEIGHT, 264.0 / UNITS_PER_EM),
        'Q' => (CAPITAL_HEIGHT, 348.0 / UNITS_PER_EM),
        'a' | 'c' | 'e' | 'm' | 'n' | 'o' | 'r' | 's' | 'u' | 'v' | 'w' | 'x' | 'z' | '.' | ':' | '–'
        | '—' | '−' | '-' | '·' => (X_HEIGHT, 0.0),
        'b' | 'd' | 'f' | 'h' | 'k' | 'l' | 'i' | 't' => (ASCENDER, 0.0),
        _ => (CAPITAL_HEIGHT, 0.0),
    }
}

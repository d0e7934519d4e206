//! The widths of words in the page's sans, and their letters for pictures that stand alone.
//!
//! The numbers are the advance widths of Open Sans Regular, version 1.10, which the pages
//! load: 2048 units to the em, read from the font's `hmtx` table. Words are set as text and stretched to
//! these widths, so that a figure keeps its layout on a machine that has another sans.

const UNITS_PER_EM: f64 = 2048.0;
/// Height of capitals and of lower-case letters, and depth of the letters that descend, in ems (`OS/2` and `glyf`).
pub(super) const CAPITAL_HEIGHT: f64 = 1462.0 / UNITS_PER_EM;
pub(super) const ASCENDER: f64 = 1556.0 / UNITS_PER_EM;
pub(super) const X_HEIGHT: f64 = 1096.0 / UNITS_PER_EM;
pub(super) const DESCENDER: f64 = 492.0 / UNITS_PER_EM;

/// U+0020 to U+007E.
#[rustfmt::skip]
const ASCII: [u16; 95] = [
    532, 547, 821, 1323, 1171, 1686, 1495, 453, 606, 606, 1130, 1171, 502, 659, 545, 752,
    1171, 1171, 1171, 1171, 1171, 1171, 1171, 1171, 1171, 1171, 545, 545, 1171, 1171, 1171, 879,
    1841, 1296, 1327, 1292, 1493, 1139, 1057, 1491, 1511, 571, 547, 1257, 1063, 1849, 1544, 1595,
    1233, 1595, 1266, 1124, 1133, 1491, 1219, 1896, 1182, 1147, 1169, 674, 752, 674, 1110, 918,
    1182, 1139, 1255, 975, 1255, 1149, 694, 1122, 1257, 518, 518, 1075, 518, 1905, 1257, 1237,
    1255, 1255, 836, 977, 723, 1257, 1026, 1593, 1073, 1032, 958, 776, 1128, 776, 1171,
];

const OTHERS: [(char, u16); 17] = [
    ('\u{a0}', 532),
    ('°', 877),
    ('±', 1171),
    ('²', 711),
    ('³', 711),
    ('µ', 1268),
    ('·', 545),
    ('×', 1171),
    ('÷', 1171),
    ('é', 1149),
    ('–', 1024),
    ('—', 2048),
    ('‘', 348),
    ('’', 348),
    ('“', 717),
    ('”', 717),
    ('−', 1171),
];

/// The advance of a character in ems, or `None` if the table does not hold it.
pub(super) fn advance(character: char) -> Option<f64> {
    let units = match u32::from(character) {
        code @ 0x20..=0x7e => ASCII[(code - 0x20) as usize],
        _ => OTHERS.iter().find(|(other, _)| *other == character)?.1,
    };
    Some(f64::from(units) / UNITS_PER_EM)
}

include!(concat!(env!("OUT_DIR"), "/letters.rs")); // LETTERS: character, advance, outline as of the math font's glyphs

/// The outline of a character in font units, y upwards, and its advance and a font unit in ems.
pub(super) fn letter(character: char) -> Option<(&'static [i16], f64, f64)> {
    let index = LETTERS.binary_search_by_key(&character, |letter| letter.0).ok()?;
    let (_, advance, outline) = LETTERS[index];
    Some((outline, f64::from(advance) / UNITS_PER_EM, 1.0 / UNITS_PER_EM))
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

//! What the faces of the book can show: the characters to which `press/drawing/font/cut.py` cuts them down.

use std::collections::BTreeSet;
use std::sync::OnceLock;

/// The list that the script reads, too.
const LIST: &str = include_str!("../../drawing/font/characters.txt");

/// Faces that have the same characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Face {
    /// The serif, and the sans of captions, tables, margin, labels and headings.
    Text,
    /// Programs and what they print.
    Code,
    /// Formulas.
    Maths,
}

impl Face {
    /// What the list calls it, and what we do.
    fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Text => ("text", "the face of the text"),
            Self::Code => ("code", "the face of the code"),
            Self::Maths => ("maths", "the face of mathematics"),
        }
    }

    fn characters(self) -> &'static BTreeSet<char> {
        static READ: OnceLock<[BTreeSet<char>; 3]> = OnceLock::new();
        &READ.get_or_init(|| [Self::Text, Self::Code, Self::Maths].map(|face| listed(face.names().0)))
            [self as usize]
    }

    /// What is wrong with a text in this face, and at which byte: the characters that the face lacks, and the first of them.
    pub(crate) fn check(self, text: &str) -> Result<(), (usize, String)> {
        let lacks = |&(_, c): &(usize, char)| !is_unseen(c) && !self.characters().contains(&c);
        let Some((first, _)) = text.char_indices().find(lacks) else { return Ok(()) };
        let lacking: BTreeSet<char> = text.char_indices().filter(lacks).map(|(_, c)| c).collect();
        let named = lacking.iter().map(|&c| format!("`{c}` (U+{:04X})", u32::from(c)));
        let (_, name) = self.names();
        Err((
            first,
            format!(
                "{name} has no {}: write it otherwise, or add it to characters.txt in press/drawing/font and run cut.py there",
                named.collect::<Vec<_>>().join(", ")
            ),
        ))
    }
}

/// The characters of one section of the list.
fn listed(section: &str) -> BTreeSet<char> {
    let head = format!("[{section}]");
    let lines = LIST.lines().skip_while(|line| !line.starts_with(&head)).skip(1);
    let words = lines
        .take_while(|line| !line.starts_with('['))
        .flat_map(|line| line.split("   ").next().unwrap_or_default().split_whitespace());
    let number = |digits| u32::from_str_radix(digits, 16).unwrap_or_else(|_| unreachable!("{digits}"));
    words
        .flat_map(|word| {
            let (first, last) = word.split_once('-').unwrap_or((word, word));
            number(first)..=number(last)
        })
        .filter_map(char::from_u32)
        .collect()
}

/// Whether a character needs no shape: ends of lines, places where a word may or may not break, directions, a narrow
/// space.
fn is_unseen(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202f}' | '\u{2060}'..='\u{2069}')
}

/// The italic letter that a browser shows for a plain one.
pub(crate) fn italic(c: char) -> char {
    let from = |first: u32, base: char| char::from_u32(first + u32::from(c) - u32::from(base)).unwrap_or(c);
    match c {
        'h' => 'ℎ',
        'A'..='Z' => from(0x1d434, 'A'),
        'a'..='z' => from(0x1d44e, 'a'),
        'Α'..='Ω' => from(0x1d6e2, 'Α'),
        'α'..='ω' => from(0x1d6fc, 'α'),
        'ϵ' => '𝜖',
        'ϑ' => '𝜗',
        'ϕ' => '𝜙',
        'ϱ' => '𝜚',
        'ϖ' => '𝜛',
        'ı' => '𝚤',
        'ȷ' => '𝚥',
        _ => c,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use read_fonts::types::GlyphId;
    use read_fonts::{FontRef, TableProvider};
    use std::fs;

    /// The characters of a font.
    fn held(font: &[u8]) -> BTreeSet<char> {
        let cmap = FontRef::new(font).unwrap().cmap().unwrap();
        let (_, _, table) = cmap.best_subtable().expect("a table of Unicode");
        let shown = table.iter().filter(|(_, glyph)| *glyph != GlyphId::NOTDEF); // its end mark has no glyph
        shown.filter_map(|(code, _)| char::from_u32(code)).collect()
    }

    #[test]
    fn the_fonts_hold_what_the_list_says() {
        let folders = ["drawing/font", "theme/fonts"].map(|folder| fs::read_dir(folder).unwrap());
        let mut fonts = Vec::new();
        for path in folders.into_iter().flatten().map(|file| file.unwrap().path()) {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let bytes = fs::read(&path).unwrap();
            let font = match name.rsplit_once('.') {
                Some((_, "woff2")) => {
                    let font = wuff::decompress_woff2(&bytes).unwrap();
                    // Of other outlines Chromium makes no font of a PDF, but a drawing for each letter (Type 3).
                    assert!(
                        font[..400].windows(4).any(|tag| tag == b"glyf"),
                        "{name} has no quadratic outlines"
                    );
                    font
                }
                Some((_, "otf" | "ttf")) => bytes,
                _ => continue,
            };
            let face = match name.as_str() {
                "book-math.woff2" | "math.otf" => Face::Maths,
                "book-code.woff2" => Face::Code,
                _ => Face::Text,
            };
            fonts.push((name, face, held(&font)));
        }
        assert_eq!(fonts.len(), 10);
        for (name, face, held) in fonts {
            let missing: String = face.characters().difference(&held).collect();
            assert!(missing.is_empty(), "{name} lacks {missing}");
            // Brackets bring the pieces that they are put together from.
            let idle: String =
                held.difference(face.characters()).filter(|c| !matches!(c, '⌠'..='⎷')).collect();
            assert!(idle.is_empty(), "{name} has {idle}, which is not in the list");
        }
    }
}

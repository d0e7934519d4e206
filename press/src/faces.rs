//! What the faces of the book can show: the characters to which `press/drawing/font/cut.py` cuts them down.

use crate::maths::accents::italic;
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// The list that the script reads, too.
const LIST: &str = include_str!("../drawing/font/characters.txt");

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

    /// What is wrong with a text in this face, and at which byte: its first character that the face lacks.
    pub(crate) fn check(self, text: &str) -> Result<(), (usize, String)> {
        let lacks = |&(_, c): &(usize, char)| !is_unseen(c) && !self.characters().contains(&c);
        text.char_indices().find(lacks).map_or(Ok(()), |(at, c)| Err((at, self.fault(c))))
    }

    fn fault(self, c: char) -> String {
        let (_, name) = self.names();
        format!(
            "{name} has no `{c}` (U+{:04X}): write it otherwise, or add it to characters.txt in \
             press/drawing/font and run cut.py there",
            u32::from(c)
        )
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

/// What is wrong with MathML: the first character that its face lacks.
pub(crate) fn check_mathml(mathml: &str) -> Result<(), String> {
    for piece in mathml.split('<').skip(1) {
        let (tag, text) = piece.split_once('>').unwrap_or((piece, ""));
        let text = text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
        let face = if tag.starts_with("mtext") { Face::Text } else { Face::Maths };
        let mut characters = text.chars();
        let shown = match (characters.next(), characters.next()) {
            (Some(c), None) if tag.starts_with("mi") && !tag.contains("mathvariant=\"normal\"") => {
                italic(c).to_string()
            }
            _ => text,
        };
        face.check(&shown).map_err(|(_, message)| message)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use read_fonts::tables::cmap::Cmap;
    use read_fonts::types::GlyphId;
    use read_fonts::{FontData, FontRead, FontRef, TableProvider};
    use std::fs;

    /// The characters of the table `cmap` of a font.
    fn held(cmap: &Cmap<'_>) -> BTreeSet<char> {
        let (_, _, table) = cmap.best_subtable().expect("a table of Unicode");
        let shown = table.iter().filter(|(_, glyph)| *glyph != GlyphId::NOTDEF); // its end mark has no glyph
        shown.filter_map(|(code, _)| char::from_u32(code)).collect()
    }

    /// The table `cmap` out of a font of the pages. WOFF2 names its tables, with their lengths, and packs all in one.
    fn packed_cmap(woff2: &[u8]) -> Vec<u8> {
        fn number(bytes: &mut impl Iterator<Item = u8>) -> usize {
            let mut value = 0;
            loop {
                let byte = usize::from(bytes.next().unwrap());
                value = value << 7 | byte & 0x7f;
                if byte < 0x80 {
                    return value;
                }
            }
        }
        assert_eq!(&woff2[..4], b"wOF2");
        let mut bytes = woff2[48..].iter().copied();
        let (mut before, mut place) = (0, None);
        for _ in 0..u16::from_be_bytes([woff2[12], woff2[13]]) {
            let flags = bytes.next().unwrap();
            let (tag, version) = (flags & 0x3f, flags >> 6);
            if tag == 0x3f {
                bytes.by_ref().take(4).for_each(drop); // a tag in full
            }
            let mut length = number(&mut bytes);
            if matches!(tag, 10 | 11) != (version != 0) {
                length = number(&mut bytes); // of a table in another form, as `glyf` and `loca` are
            }
            if tag == 0 {
                place = Some(before..before + length);
            }
            before += length;
        }
        let mut tables = Vec::new();
        let packed: Vec<u8> = bytes.collect();
        brotli_decompressor::BrotliDecompress(&mut packed.as_slice(), &mut tables).unwrap();
        tables[place.unwrap()].to_vec()
    }

    #[test]
    fn the_fonts_hold_what_the_list_says() {
        let label_fonts: [(_, _, &[u8]); 2] = [
            ("math.otf", Face::Maths, include_bytes!("../drawing/font/math.otf")),
            ("open-sans.ttf", Face::Text, include_bytes!("../drawing/font/open-sans.ttf")),
        ];
        let mut fonts = Vec::new();
        for (name, face, font) in label_fonts {
            let font = FontRef::new(font).unwrap();
            fonts.push((name.to_owned(), face, held(&font.cmap().unwrap())));
        }
        for file in fs::read_dir("../book/theme/fonts").unwrap() {
            let path = file.unwrap().path();
            if path.extension().is_some_and(|ending| ending == "woff2") {
                let name = path.file_stem().unwrap().to_string_lossy().into_owned();
                let face = match name.as_str() {
                    "book-math" => Face::Maths,
                    "book-code" => Face::Code,
                    _ => Face::Text,
                };
                let cmap = packed_cmap(&fs::read(&path).unwrap());
                fonts.push((name, face, held(&Cmap::read(FontData::new(&cmap)).unwrap())));
            }
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

    #[test]
    fn a_character_that_a_face_lacks_is_named() {
        assert_eq!(Face::Text.check("Störmer’s – “curve”,\n"), Ok(()));
        assert_eq!(Face::Code.check("let ω₀ = 2e-3;"), Ok(()));
        let (at, message) = Face::Text.check("an ω").unwrap_err();
        assert!(at == 3 && message.starts_with("the face of the text has no `ω` (U+03C9)"), "{message}");
    }

    #[test]
    fn variables_are_asked_for_in_italics() {
        assert_eq!(
            check_mathml("<math><mi>ω</mi><mi>sin</mi><mi mathvariant=\"normal\">Ω</mi></math>"),
            Ok(())
        );
        assert_eq!(check_mathml("<mtext>if a</mtext><mo>&lt;</mo>"), Ok(()));
        // There is no upright ω, and no Γ in italics.
        for lacking in
            ["<mi mathvariant=\"normal\">ω</mi>", "<mi class=\"q-spin\">Γ</mi>", "<mtext>α</mtext>"]
        {
            assert!(check_mathml(lacking).is_err(), "{lacking}");
        }
    }
}

//! What the faces of the book can show: the characters to which `press/drawing/font/cut.py` cuts them down.

use roxmltree::{Document, Node};
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
    let document = Document::parse(mathml).map_err(|error| format!("this is no MathML: {error}"))?;
    for text in document.descendants().filter(Node::is_text) {
        let element = text.parent_element();
        let is = |name: &str| element.is_some_and(|element| element.has_tag_name(name));
        let is_upright = element.is_some_and(|element| element.attribute("mathvariant") == Some("normal"));
        let words = text.text().unwrap_or_default();
        let mut characters = words.chars();
        let shown = match (characters.next(), characters.next()) {
            (Some(c), None) if is("mi") && !is_upright => italic(c).to_string(),
            _ => words.to_owned(),
        };
        let face = if is("mtext") { Face::Text } else { Face::Maths };
        face.check(&shown).map_err(|(_, message)| message)?;
    }
    Ok(())
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
        let label_fonts: [(_, _, &[u8]); 2] = [
            ("math.otf", Face::Maths, include_bytes!("../../drawing/font/math.otf")),
            ("open-sans.ttf", Face::Text, include_bytes!("../../drawing/font/open-sans.ttf")),
        ];
        let mut fonts = Vec::new();
        for (name, face, font) in label_fonts {
            fonts.push((name.to_owned(), face, held(font)));
        }
        for file in fs::read_dir("theme/fonts").unwrap() {
            let path = file.unwrap().path();
            if path.extension().is_some_and(|ending| ending == "woff2") {
                let name = path.file_stem().unwrap().to_string_lossy().into_owned();
                let face = match name.as_str() {
                    "book-math" => Face::Maths,
                    "book-code" => Face::Code,
                    _ => Face::Text,
                };
                let font = wuff::decompress_woff2(&fs::read(&path).unwrap()).unwrap();
                fonts.push((name, face, held(&font)));
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
        assert_eq!(check_mathml("<math><mtext>if a</mtext><mo>&lt;</mo></math>"), Ok(()));
        // There is no upright ω, and no Γ in italics.
        for lacking in
            ["<mi mathvariant=\"normal\">ω</mi>", "<mi class=\"q-spin\">Γ</mi>", "<mtext>α</mtext>"]
        {
            assert!(check_mathml(lacking).is_err(), "{lacking}");
        }
    }
}

//! LaTeX to MathML: a converter's, mended where browsers print it badly.

mod accents;
mod brackets;
mod letters;
mod pieces;
mod roots;
mod tree;
mod words;

use crate::book::Page;
use crate::fault::Faults;
use crate::read::font_coverage::Face;
use crate::read::items::PlacedItem;
use letters::{CONVENTIONS, Letters};
use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};
use read_fonts::model::Font;
use std::collections::BTreeSet;
use tree::{Element, Node};

/// The mathematics font of labels, which has the measures of that of the pages.
const FONT: &[u8] = include_bytes!("../../../drawing/font/math.otf");

/// How deep a formula may be nested. The converter calls itself for each level, and so does what reads the
/// MathML later.
const DEEPEST: usize = 60;
/// How long a formula may be: the time that some passes take grows as its square.
const LONGEST: usize = 10_000;

/// A converter, built once a run.
pub(crate) struct Maths {
    converter: LatexToMathML,
    font: Font,
    letters: Letters,
}

/// LaTeX that is not understood: where in it, and why.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct MathsFault {
    /// Byte offset in the LaTeX.
    pub(crate) offset: usize,
    pub(crate) message: String,
}

impl Maths {
    /// A converter that colours letters as the conventions among `pages` say.
    pub(crate) fn new(pages: &[Page], scans: &[Vec<PlacedItem<'_>>], faults: &mut Faults) -> Self {
        let config = MathCoreConfig { annotation: false, ..MathCoreConfig::default() };
        // Only a macro can make the converter fail, and there is none.
        let mut maths = Self {
            converter: LatexToMathML::new(config).unwrap_or_else(|_| unreachable!("no macros to be wrong")),
            font: Font::new(FONT, 0).unwrap_or_else(|| unreachable!("the font is sound")),
            letters: Letters::default(),
        };
        if let Some((page, items)) = pages.iter().zip(scans).find(|(page, _)| page.path == CONVENTIONS) {
            let convert = |tex: &str| maths.formula(tex, MathDisplay::Inline).ok();
            maths.letters = Letters::read(page, items, convert, faults);
        }
        pages.iter().zip(scans).for_each(|(page, items)| maths.letters.note_symbols(page, items));
        maths
    }

    /// The folder of the chapter whose letters the page at `path` uses at this place.
    pub(crate) fn folder<'a>(&'a self, path: &'a str, offset: usize) -> &'a str {
        self.letters.folder(path, offset)
    }

    /// Display mathematics of the chapter in `folder`, as one line of MathML: a formula, or some in a row.
    pub(crate) fn display(&self, tex: &str, folder: &str) -> Result<String, MathsFault> {
        self.convert(tex, MathDisplay::Block, folder)
    }

    /// Inline mathematics, as MathML whose text no Markdown parser can misread.
    pub(crate) fn inline(&self, tex: &str, folder: &str) -> Result<String, MathsFault> {
        self.inline_html(tex, folder).map(|mathml| shielded(&mathml))
    }

    /// Inline mathematics for a place that is HTML already.
    pub(crate) fn inline_html(&self, tex: &str, folder: &str) -> Result<String, MathsFault> {
        self.convert(tex, MathDisplay::Inline, folder)
    }

    /// The letters of a formula, each with its subscript: `ω`, `ω_0`.
    pub(crate) fn letters_of(&self, tex: &str) -> Result<BTreeSet<String>, MathsFault> {
        let mut found = BTreeSet::new();
        letters::all(&self.formula(tex, MathDisplay::Inline)?, &mut found);
        Ok(found)
    }

    /// The converter's MathML as browsers print it well, coloured.
    fn convert(&self, tex: &str, display: MathDisplay, folder: &str) -> Result<String, MathsFault> {
        let mut formula = self.formula(tex, display)?;
        pieces::go_on(&mut formula);
        brackets::stand_close(&mut formula, &self.font);
        brackets::keep_their_height(&mut formula);
        accents::centre(&mut formula, &self.font);
        accents::make_room(&mut formula, &self.font);
        self.letters.colour(&mut formula, folder);
        accents::keep_exponents_low(&mut formula, &self.font);
        words::be_small(&mut formula);
        roots::have_struts(&mut formula);
        let pieces = if display == MathDisplay::Block { pieces::cut(formula) } else { vec![formula] };
        let mut out = String::with_capacity(tex.len() * 8);
        pieces.iter().for_each(|piece| piece.write(&mut out));
        Ok(out)
    }

    /// What the converter makes of a formula.
    fn formula(&self, tex: &str, display: MathDisplay) -> Result<Element, MathsFault> {
        if tex.trim().is_empty() {
            return Err(MathsFault { offset: 0, message: "the formula is empty".to_owned() });
        }
        if let Some(offset) = too_deep(tex) {
            let message = format!("the formula is nested more than {DEEPEST} deep: give its parts names");
            return Err(MathsFault { offset, message });
        }
        if tex.len() > LONGEST {
            let message =
                format!("the formula has {} bytes; more than {LONGEST} cannot be read: divide it", tex.len());
            return Err(MathsFault { offset: 0, message });
        }
        // The converter would print the length.
        if let Some(offset) = tex.find(r"\\[") {
            let message = r"in the formula: `\\[…]` is not understood: end the line by `\\` alone".to_owned();
            return Err(MathsFault { offset, message });
        }
        let mathml = match self.converter.convert_with_local_state(tex, display) {
            Ok(result) => result.mathml.replace('\n', " "),
            Err(error) => {
                let offset = error.0.start.min(tex.len());
                let context: String = tex[error.0.clone()].chars().take(40).collect();
                let message = error.error_message();
                let near = if context.trim().is_empty() {
                    String::new()
                } else {
                    format!(" (at `{}`)", context.trim())
                };
                return Err(MathsFault { offset, message: format!("in the formula: {message}{near}") });
            }
        };
        let formula =
            Element::read(&mathml).map_err(|error| format!("the formula becomes no sound XML: {error}"));
        let sound = formula.and_then(|formula| check_characters(&formula).map(|()| formula));
        sound.map_err(|message| MathsFault { offset: 0, message })
    }
}

/// What is wrong with the text of a formula: the characters of its first letter or word that the face lacks.
fn check_characters(element: &Element) -> Result<(), String> {
    let face = if element.is("mtext") { Face::Text } else { Face::Maths };
    element.children.iter().try_for_each(|child| match child {
        Node::Element(element) => check_characters(element),
        Node::Text(text) => {
            let shown = accents::shown(element).map_or_else(|| text.clone(), String::from);
            face.check(&shown).map_err(|(_, message)| message)
        }
    })
}

/// Where a formula goes deeper than [`DEEPEST`]: into braces, brackets, `\left`, environments, or commands
/// that each take the next.
fn too_deep(tex: &str) -> Option<usize> {
    // Open groups, and commands in a row.
    let (mut open, mut row) = (0_usize, 0_usize);
    let mut at = 0;
    while let Some(byte) = tex.as_bytes().get(at) {
        let mut length = 1;
        match byte {
            b'\\' => {
                let word = tex[at + 1..].bytes().take_while(u8::is_ascii_alphabetic).count();
                length += word.max(1);
                row += 1;
                match &tex[at + 1..at + 1 + word] {
                    "left" | "begin" => open += 1,
                    "right" | "end" => open = open.saturating_sub(1),
                    _ => {}
                }
            }
            b'{' | b'[' => open += 1,
            b'}' | b']' => {
                open = open.saturating_sub(1);
                row = 0;
            }
            b' ' | b'\n' | b'^' | b'_' => {}
            _ => row = 0,
        }
        if open + row > DEEPEST {
            return Some(at);
        }
        at += length;
    }
    None
}

/// MathML in which every character of text that Markdown could take for markup is a numeric entity.
fn shielded(mathml: &str) -> String {
    let mut out = String::with_capacity(mathml.len() * 2);
    let (mut in_tag, mut in_entity) = (false, false);
    for c in mathml.chars() {
        match c {
            '<' => in_tag = true,
            '&' if !in_tag => in_entity = true,
            _ => {}
        }
        if in_tag || in_entity || c.is_alphanumeric() || c == ' ' || !c.is_ascii() {
            out.push(c);
        } else {
            out.push_str(&format!("&#{};", u32::from(c)));
        }
        match c {
            '>' => in_tag = false,
            ';' => in_entity = false,
            _ => {}
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mathml(tex: &str) -> String {
        Maths::new(&[], &[], &mut Faults::default()).display(tex, "").unwrap()
    }

    /// The first number behind some words in the MathML of a formula, ems.
    fn number(tex: &str, words: &str) -> f32 {
        let mathml = mathml(tex);
        let (_, behind) = mathml.split_once(words).unwrap_or_else(|| panic!("{words} in {mathml}"));
        behind.split_once("em").unwrap().0.parse().unwrap()
    }

    #[test]
    fn mathml_survives_markdown() {
        let mathml = Maths::new(&[], &[], &mut Faults::default()).inline("a_1*b_2 - [c]'", "").unwrap();
        let text: String = mathml.split('<').map(|part| part.rsplit('>').next().unwrap_or("")).collect();
        assert!(!text.contains(['*', '_', '[', ']', '\'']), "{text}");
    }

    /// Formulas, and how often their MathML holds some words.
    type Case = (&'static str, &'static [(&'static str, usize)]);
    const CASES: &[Case] = &[
        // A row of formulas can be broken between them.
        (
            "<math display=\"block\">",
            &[
                (r"a = b , \qquad c = d , \qquad e", 3),
                (r"a \quad b", 1),
                (r"\begin{aligned} a &= b \qquad c \\ d &= e \end{aligned}", 1),
            ],
        ),
        // A sum goes on in the next line.
        (
            "<mo form=\"infix\">",
            &[
                (r"\begin{aligned} a &= b \\ &+ c \\ & - d \end{aligned}", 2),
                (r"\begin{aligned} a &= - b \\ -c &= d \\ & c \end{aligned}", 0),
            ],
        ),
        // Each root has a strut.
        (
            "<mspace height=\"0.8em\" depth=\"0.25em\"/></msqrt>",
            &[(r"\sqrt u", 1), (r"\sqrt{u + \sqrt v}", 2), ("u", 0)],
        ),
        ("<mspace height=\"0.8em\" depth=\"0.25em\"/></mrow><mn>3</mn></mroot>", &[(r"\sqrt[3] u", 1)]),
        // A letter that leans has room where nothing is lowered.
        ("margin-right", &[("T = P", 2), (r"\frac{P}{2}", 1), ("f(x)", 1), ("T^2", 1), ("a^T", 0)]),
        ("margin-right", &[("P_0", 0), ("P_0^2", 0), ("a = x", 0), (r"\sin x", 0)]),
        // A word as an index stands in a row.
        (
            "<mrow><mtext>cm</mtext></mrow>",
            &[(r"r_\text{cm}", 1), (r"r^\text{cm}", 1), (r"r_\text{cm}^2", 1)],
        ),
        (
            "<mrow><mtext>cm</mtext></mrow>",
            &[(r"\underset{\text{cm}}{r}", 1), (r"\frac{\text{cm}}{\text{cm}}", 2)],
        ),
        ("<mrow><mtext>cm</mtext></mrow>", &[(r"\text{cm}_2 + \text{cm}", 0)]),
        // A bracket has no air; with a power it stands in a row.
        ("lspace=\"0\" rspace=\"0\"", &[(r"f\bigl(x\bigr) + (x)", 2), (r"f\Bigl(x\Bigr)", 2)]),
        (
            "<msup><mrow>",
            &[(r"\Bigl(\tfrac{a}{b}\Bigr)^2", 1), (r"\left(\tfrac{a}{b}\right)^2", 1), ("(a)^2", 0)],
        ),
        ("<msub><mrow>", &[(r"\bigl(a\bigr)_0", 1), (r"\Bigl|a\Bigr|_{x=0}", 1)]),
        ("<msubsup><mrow>", &[(r"\biggl[a\biggr]_0^1", 1)]),
        // An exponent says how low it stands at a letter with an accent, and only there.
        ("<mpadded height=", &[(r"\dot x^2", 1), (r"\dot x", 0), (r"\dot x_1", 0), ("x^2", 0)]),
        // Upright letters with a hat have their tops in the middle.
        ("margin-left", &[(r"\hat{\mathbf x}", 0), (r"\hat{\mathbf k}", 0), (r"\dot\omega", 1)]),
    ];

    #[test]
    fn formulas_are_mended_where_they_need_it() {
        for (words, formulas) in CASES {
            for (tex, count) in *formulas {
                assert_eq!(mathml(tex).matches(words).count(), *count, "{words} in {tex}: {}", mathml(tex));
            }
        }
    }

    #[test]
    fn accents_exponents_and_brackets_stand_where_the_font_says() {
        let [d, theta, omega] =
            [r"\dot d", r"\dot\theta", r"\dot\omega"].map(|tex| number(tex, "margin-left:"));
        assert!(d > theta && theta > omega && omega > 0.0, "{d} {theta} {omega}");
        let [bare, indexed, tall] =
            [r"\dot x^2", r"\dot{x}_1^2", r"\dot\theta^2"].map(|tex| number(tex, "<mpadded height=\""));
        assert!(bare < 0.5 && indexed == bare && 0.6 < tall && tall < 0.8, "{bare} {indexed} {tall}");
        let [big, bigger] = [r"f\bigl(x\bigr)", r"f\Bigl(x\Bigr)"].map(|tex| number(tex, "width:"));
        assert!(0.4 < big && big < bigger && bigger < 0.7, "{big} {bigger}");
    }
}

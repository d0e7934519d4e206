//! What an italic letter asks of its neighbours: dots and hats over the middle of its top, exponents as low
//! as if it had none, and room for a letter that leans over its box.

use super::tree::{Element, Node};
use crate::read::font_coverage::italic;
use read_fonts::TableProvider;
use read_fonts::model::Font;

/// Browsers put an accent over the middle of a letter's box. The font knows better where an italic letter
/// has its top; margins move the accent there and leave it as wide as it is.
pub(super) fn centre(formula: &mut Element, font: &Font) {
    formula.visit(&mut |over| {
        if !over.is("mover") || over.attribute("accent").is_none() {
            return;
        }
        let Some(way) = over.elements().next().and_then(|letter| way(letter, font)) else { return };
        if let Some(accent) = over.element_mut(1) {
            accent.set("style", &format!("margin-left:{way:.2}em;margin-right:{:.2}em", -way));
        }
    });
}

/// The least that a letter leans over its box before one sees it, in ems.
const LEANING: f32 = 0.04;

/// A letter like *T* leans over the right edge of its box, and browsers set the next sign at that edge.
/// Typesetters leave room for it, unless something is lowered there.
pub(super) fn make_room(formula: &mut Element, font: &Font) {
    formula.visit(&mut |row| {
        let places = match &*row.name {
            "math" | "mrow" | "mtd" | "msqrt" | "mfrac" => usize::MAX,
            "msup" => 1,
            _ => 0,
        };
        for letter in row.elements_mut().take(places).filter(|child| child.is("mi")) {
            if let Some(room) = leaning(letter, font).filter(|room| *room >= LEANING) {
                letter.set("style", &format!("margin-right:{room:.2}em"));
            }
        }
    });
}

/// How far a letter leans over its box, in ems.
fn leaning(letter: &Element, font: &Font) -> Option<f32> {
    let glyph = font.charmap().map_unicode(shown(letter)?)?;
    let corrections =
        font.tables().math().ok()?.math_glyph_info().ok()?.math_italics_correction_info()?.ok()?;
    Some(corrections.correction(glyph)? as f32 / f32::from(font.units_per_em()))
}

/// Browsers raise an exponent by the height of what it stands at, accent and all; typesetters by that of the
/// letter. So a letter with an accent and an exponent says that it is no higher than without the accent.
pub(super) fn keep_exponents_low(formula: &mut Element, font: &Font) {
    formula.visit(&mut |power| {
        if !matches!(&*power.name, "msup" | "msubsup") {
            return;
        }
        let Some(base) = power.element_mut(0).filter(|base| base.is("mover")) else { return };
        let height = base.elements().next().and_then(|letter| height(letter, font));
        if let Some(height) = height {
            let letter = std::mem::take(base);
            *base = Element::around("mpadded", vec![Node::Element(letter)]);
            base.set("height", &format!("{height:.2}em"));
        }
    });
}

/// How high a letter is, in ems.
fn height(letter: &Element, font: &Font) -> Option<f32> {
    let glyph = font.charmap().map_unicode(shown(letter)?)?;
    Some(font.glyph_metrics().extents(glyph)?.y_bearing / f32::from(font.units_per_em()))
}

/// How far the top of a letter stands to the right of the middle of its box, in ems, if one sees it. (An
/// upright k has it on the left, but not its hat.)
fn way(letter: &Element, font: &Font) -> Option<f32> {
    let glyph = font.charmap().map_unicode(shown(letter)?)?;
    let tops = font.tables().math().ok()?.math_glyph_info().ok()?.math_top_accent_attachment()?.ok()?;
    let top = tops.attachment(glyph)? as f32;
    let way = (top - font.glyph_metrics().h_advance(glyph) / 2.0) / f32::from(font.units_per_em());
    (way >= 0.02).then_some(way)
}

/// The character that a browser shows for a letter or a digit; for more than one, nothing.
pub(super) fn shown(letter: &Element) -> Option<char> {
    let text = letter.text();
    let c =
        text.chars().next().filter(|_| matches!(&*letter.name, "mi" | "mn") && text.chars().count() == 1)?;
    Some(if letter.is("mi") && letter.attribute("mathvariant").is_none() { italic(c) } else { c })
}

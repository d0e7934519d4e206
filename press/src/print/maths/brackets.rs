//! Brackets of a chosen size, `\Bigl(`: no air beside them, and the same size when something is raised or
//! lowered behind them.

use super::tree::{Element, Node};
use read_fonts::TableProvider;
use read_fonts::model::Font;
use read_fonts::tables::math::StretchAxis;

/// In the middle of a row a browser takes such a bracket for a sign between two others, and gives it their air; and its
/// box may be as wide as that of the largest bracket there is. The font knows how wide it is.
pub(super) fn stand_close(formula: &mut Element, font: &Font) {
    formula.visit(&mut |bracket| {
        let Some(size) = bracket.attribute("minsize").filter(|_| bracket.is("mo")) else { return };
        let size = size.strip_suffix("em").and_then(|size| size.parse().ok());
        if let Some(width) = size.and_then(|size| width(&bracket.text(), size, font)) {
            bracket.set("style", &format!("width:{width:.3}em"));
        }
        bracket.set("lspace", "0");
        bracket.set("rspace", "0");
    });
}

/// How wide the smallest form of a bracket is that has at least this height, both in ems.
fn width(bracket: &str, height: f32, font: &Font) -> Option<f32> {
    let glyph = font.charmap().map_unicode(bracket.chars().next()?)?;
    let em = f32::from(font.units_per_em());
    let variants = font.tables().math().ok()?.math_variants().ok()?;
    let forms = variants.glyph_construction(glyph, StretchAxis::Vertical)?.math_glyph_variant_records();
    let form = forms.iter().find(|form| f32::from(form.advance_measurement().to_u16()) >= height * em)?;
    Some(font.glyph_metrics().h_advance(form.variant_glyph().into()) / em)
}

/// A browser gives `\Bigr)` its height only among other parts of a row. As the base of a power it is alone,
/// so it gets a row of its own.
pub(super) fn keep_their_height(formula: &mut Element) {
    formula.visit(&mut |scripts| {
        if !matches!(&*scripts.name, "msup" | "msub" | "msubsup") {
            return;
        }
        let Some(base) = scripts.element_mut(0).filter(|base| base.is("mo")) else { return };
        if base.attribute("minsize").is_some() || base.attribute("stretchy") == Some("true") {
            base.set("form", "postfix");
            let bracket = std::mem::take(base);
            *base = Element::around("mrow", vec![Node::Element(bracket)]);
        }
    });
}

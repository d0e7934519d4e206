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
        let Some(size) = bracket.attribute("minsize").filter(|_| bracket.is("mo")) else {
            return;
        };
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
        let Some(base) = scripts.element_mut(0).filter(|base| base.is("mo")) else {
            return;
        };
        if base.attribute("minsize").is_some() || base.attribute("stretchy") == Some("true") {
            base.set("form", "postfix");
            let bracket = std::mem::take(base);
            *base = Element::around("mrow", vec![Node::Element(bracket)]);
        }
    });
}

#[cfg(test)]
mod tests {
    use crate::print::maths::tests::plain;

    #[test]
    fn a_bracket_has_no_air_and_its_own_width() {
        let widths = |tex: &str| -> Vec<f32> {
            let mathml = plain().display(tex, "").unwrap();
            assert_eq!(mathml.matches(r#"lspace="0" rspace="0""#).count(), 2, "{mathml}");
            let widths = mathml.split("width:").skip(1).map(|rest| rest.split_once("em").unwrap().0);
            widths.map(|width| width.parse().unwrap()).collect()
        };
        let (big, bigger) = (widths(r"f\bigl(x\bigr) + (x)"), widths(r"f\Bigl(x\Bigr)"));
        assert_eq!((big.len(), bigger.len()), (2, 2));
        assert!(0.4 < big[0] && big[0] < bigger[0] && bigger[0] < 0.7, "{big:?} {bigger:?}");
    }

    #[test]
    fn a_bracket_with_a_power_stands_in_a_row() {
        for tex in [
            r"\Bigl(\tfrac{a}{b}\Bigr)^2",
            r"\bigl(a\bigr)_0",
            r"\biggl[a\biggr]_0^1",
            r"\Bigl|a\Bigr|_{x=0}",
            r"\left(\tfrac{a}{b}\right)^2",
        ] {
            let mathml = plain().display(tex, "").unwrap();
            let scripts = mathml.rsplit_once("<msup>").or_else(|| mathml.rsplit_once("<msub>"));
            let scripts = scripts.or_else(|| mathml.rsplit_once("<msubsup>")).unwrap().1;
            assert!(scripts.starts_with("<mrow>"), "{tex}: {mathml}");
        }
        assert!(plain().display("(a)^2", "").unwrap().contains("<msup><mo stretchy=\"false\">"));
    }
}

//! Brackets of a chosen size, `\Bigl(`: no air beside them, and the same size when something is raised or lowered behind them.

use super::tree::{Element, Node};

/// In the middle of a row a browser takes such a bracket for a sign between two others, and gives it their air.
pub(super) fn stand_close(formula: &mut Element) {
    formula.visit(&mut |bracket| {
        if bracket.is("mo") && bracket.attribute("minsize").is_some() {
            bracket.set("lspace", "0");
            bracket.set("rspace", "0");
        }
    });
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
    use crate::maths::tests::plain;

    #[test]
    fn a_bracket_has_no_air() {
        let mathml = plain().display(r"f\bigl(x\bigr) + (x)", "").unwrap();
        assert_eq!(mathml.matches(r#"lspace="0" rspace="0""#).count(), 2, "{mathml}");
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

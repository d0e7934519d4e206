//! A row of formulas that a narrow page may set below one another.

use super::tree::{Element, Node};

/// The space of `\qquad`, with which an author parts formulas in one equation.
const SPACE: &str = "2em";

/// A display formula, cut at each `\qquad` that is inside nothing else. A browser breaks no line within a formula, but between
/// two it does.
pub(super) fn cut(formula: Element) -> Vec<Element> {
    let Element { name, attributes, children } = formula;
    let parts = |child: &Node| match child {
        Node::Element(element) => element.is("mspace") && element.attribute("width") == Some(SPACE),
        Node::Text(_) => false,
    };
    let pieces = children.split(parts).filter(|piece| !piece.is_empty());
    let piece = |piece: &[Node]| Element {
        name: name.clone(),
        attributes: attributes.clone(),
        children: piece.to_vec(),
    };
    pieces.map(piece).collect()
}

#[cfg(test)]
mod tests {
    use crate::maths::tests::plain;

    #[test]
    fn a_row_of_formulas_can_be_broken_between_them() {
        let pieces =
            |tex: &str| plain().display(tex, "").unwrap().matches("<math display=\"block\">").count();
        assert_eq!(pieces(r"a = b , \qquad c = d , \qquad e"), 3);
        assert_eq!(pieces(r"a \quad b"), 1);
        assert_eq!(pieces(r"\begin{aligned} a &= b \qquad c \\ d &= e \end{aligned}"), 1);
    }
}

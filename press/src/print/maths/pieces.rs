//! Formulas of several lines: those that a narrow page may set below one another, and those that an author broke.

use super::tree::{Element, Node};

/// The space of `\qquad`, with which an author parts formulas in one equation.
const SPACE: &str = "2em";

/// A display formula, cut at each `\qquad` that is inside nothing else. A browser breaks no line within a
/// formula, but between two it does.
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

/// A line of `aligned` that goes on with a sum begins with its sign. Browsers take that for the sign of a
/// number and set it close; it stands between two terms.
pub(super) fn go_on(formula: &mut Element) {
    formula.visit(&mut |line| {
        if !line.is("mtr") || !line.elements().next().is_some_and(|cell| cell.text().is_empty()) {
            return;
        }
        let sign = line.element_mut(1).and_then(|cell| cell.element_mut(0));
        if let Some(sign) = sign.filter(|sign| sign.is("mo") && matches!(&*sign.text(), "+" | "−")) {
            sign.attributes.clear();
            sign.set("form", "infix");
        }
    });
}

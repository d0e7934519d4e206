//! Words in a formula.

use super::tree::{Element, Node};

/// Elements whose children are smaller than the formula around them: all, or all but the first.
const SMALLER: [(&str, usize); 8] = [
    ("mfrac", 0),
    ("mroot", 1),
    ("msub", 1),
    ("msup", 1),
    ("msubsup", 1),
    ("munder", 1),
    ("mover", 1),
    ("munderover", 1),
];

/// A word that is an index stands in a row. The style sheet gives words the face of the text, and Firefox prints what
/// has a face of its own at full size where it should make it smaller. It makes the row smaller, with all inside.
pub(super) fn be_small(formula: &mut Element) {
    formula.visit(&mut |element| {
        let Some((_, first)) = SMALLER.iter().find(|(name, _)| element.is(name)) else { return };
        for child in element.elements_mut().skip(*first).filter(|child| child.is("mtext")) {
            *child = Element::around("mrow", vec![Node::Element(std::mem::take(child))]);
        }
    });
}

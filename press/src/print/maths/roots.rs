//! Roots: the sign is drawn for a radicand as high as a line of text, however low its letters are.

use super::tree::{Element, Node};

/// A browser draws the smallest sign low and keeps the width of the largest for it, so that `√u` hangs below its line
/// and stands apart from the comma behind it. Larger signs have neither fault, and a strut of this height asks for one.
const STRUT: [(&str, &str); 2] = [("height", "0.8em"), ("depth", "0.25em")];

/// Puts a strut into the radicand of each root.
pub(super) fn have_struts(formula: &mut Element) {
    formula.visit(&mut |root| {
        let strut = Element {
            name: "mspace".to_owned(),
            attributes: STRUT.map(|(name, value)| (name.to_owned(), value.to_owned())).to_vec(),
            children: Vec::new(),
        };
        match root.name.as_str() {
            "msqrt" => root.children.push(Node::Element(strut)),
            "mroot" => {
                if let Some(radicand) = root.element_mut(0) {
                    let inside = std::mem::take(radicand);
                    *radicand = Element::around("mrow", vec![Node::Element(inside), Node::Element(strut)]);
                }
            }
            _ => {}
        }
    });
}

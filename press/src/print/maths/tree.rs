//! MathML as a tree that can be changed.

use html::escaped;
use roxmltree::{Document, ParsingOptions};

/// An element, or a text between elements.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Node {
    Element(Element),
    Text(String),
}

#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) attributes: Vec<(String, String)>,
    pub(super) children: Vec<Node>,
}

impl Element {
    /// Reads what the converter wrote.
    pub(super) fn read(mathml: &str) -> Result<Self, roxmltree::Error> {
        let document = Document::parse_with_options(mathml, ParsingOptions::default())?;
        Ok(Self::copy(document.root_element()))
    }

    fn copy(element: roxmltree::Node<'_, '_>) -> Self {
        let attributes = element.attributes().map(|a| (a.name().to_owned(), a.value().to_owned()));
        let children = element.children().filter_map(|child| match child.text() {
            Some(text) if child.is_text() => Some(Node::Text(text.to_owned())),
            _ => child.is_element().then(|| Node::Element(Self::copy(child))),
        });
        Self {
            name: element.tag_name().name().to_owned(),
            attributes: attributes.collect(),
            children: children.collect(),
        }
    }

    /// An element around others.
    pub(super) fn around(name: &str, children: Vec<Node>) -> Self {
        Self { name: name.to_owned(), attributes: Vec::new(), children }
    }

    pub(super) fn is(&self, name: &str) -> bool {
        self.name == name
    }

    pub(super) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
    }

    pub(super) fn set(&mut self, name: &str, value: &str) {
        match self.attributes.iter_mut().find(|(known, _)| known == name) {
            Some((_, old)) => value.clone_into(old),
            None => self.attributes.push((name.to_owned(), value.to_owned())),
        }
    }

    /// The child elements.
    pub(super) fn elements(&self) -> impl DoubleEndedIterator<Item = &Self> {
        self.children.iter().filter_map(|child| match child {
            Node::Element(element) => Some(element),
            Node::Text(_) => None,
        })
    }

    /// The child element at a place, to be changed.
    pub(super) fn element_mut(&mut self, place: usize) -> Option<&mut Self> {
        self.elements_mut().nth(place)
    }

    /// The child elements, to be changed.
    pub(super) fn elements_mut(&mut self) -> impl Iterator<Item = &mut Self> {
        self.children.iter_mut().filter_map(|child| match child {
            Node::Element(element) => Some(element),
            Node::Text(_) => None,
        })
    }

    /// All the text inside.
    pub(super) fn text(&self) -> String {
        let parts = self.children.iter().map(|child| match child {
            Node::Element(element) => element.text(),
            Node::Text(text) => text.clone(),
        });
        parts.collect()
    }

    /// Calls `change` on every element inside and at last on this.
    pub(super) fn visit(&mut self, change: &mut impl FnMut(&mut Self)) {
        for child in &mut self.children {
            if let Node::Element(element) = child {
                element.visit(change);
            }
        }
        change(self);
    }

    /// As MathML in one line.
    pub(super) fn write(&self, out: &mut String) {
        out.push('<');
        out.push_str(&self.name);
        for (name, value) in &self.attributes {
            out.push_str(&format!(" {name}=\"{}\"", escaped(value)));
        }
        if self.children.is_empty() && self.is("mspace") {
            out.push_str("/>");
            return;
        }
        out.push('>');
        for child in &self.children {
            match child {
                Node::Element(element) => element.write(out),
                Node::Text(text) => out.push_str(&escaped(text)),
            }
        }
        out.push_str(&format!("</{}>", self.name));
    }
}

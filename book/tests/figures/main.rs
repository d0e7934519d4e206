//! What holds for every figure of the book.

mod map;
mod size;

use drawing::{Drawing, Fill, Label, Piece, Point, Rect, Role, Shape, Stroke};
use figures::{Rendered, all};
use pages::figures::FIGURES;
use roxmltree::{Document, Node};
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// The most that an SVG file for slides may weigh, bytes.
const HEAVIEST_ALONE: usize = 400_000;

fn every_figure() -> &'static [Rendered] {
    static RENDERED: OnceLock<Vec<Rendered>> = OnceLock::new();
    let figures = RENDERED.get_or_init(|| all(FIGURES).expect("every figure can be drawn"));
    assert!(figures.len() >= 12, "only {} figures were found", figures.len());
    figures
}

/// The drawings of all figures in all their layouts.
fn every_part() -> impl Iterator<Item = (&'static Rendered, &'static Drawing)> {
    every_figure()
        .iter()
        .flat_map(|figure| figure.drawing.all_parts().into_iter().map(move |part| (figure, part)))
}

fn parsed(figure: &Rendered) -> Document<'_> {
    Document::parse(&figure.svg).unwrap_or_else(|error| panic!("{}: {error}", figure.id))
}

fn child<'a>(root: Node<'a, 'a>, name: &str) -> Option<Node<'a, 'a>> {
    root.children().find(|node| node.has_tag_name(name))
}

#[test]
fn every_figure_is_xml_with_title_and_description() {
    for figure in every_figure() {
        let document = parsed(figure);
        let mut drawn: Vec<_> = document.descendants().filter(|node| node.has_tag_name("svg")).collect();
        assert_eq!(drawn.len(), figure.drawing.all_parts().len(), "{}", figure.id);
        drawn.retain(|svg| svg.attribute("aria-hidden").is_none());
        assert!(!drawn.is_empty(), "{}", figure.id);
        let words = [figure.drawing.title(), figure.drawing.description()].map(str::len);
        assert!(words[0] >= 10 && words[1] >= 80, "{}: more words", figure.id);
        for root in drawn {
            assert_eq!(root.attribute("role"), Some("img"), "{}", figure.id);
            let named =
                root.attribute("aria-labelledby").expect("the figure is named for those who cannot see it");
            for (element, least) in [("title", 5), ("desc", 30)] {
                let node = child(root, element).unwrap_or_else(|| panic!("{} has no {element}", figure.id));
                assert!(
                    node.text().is_some_and(|text| text.len() >= least),
                    "{}: the {element} is too short",
                    figure.id
                );
                assert!(
                    named.split(' ').any(|id| Some(id) == node.attribute("id")),
                    "{}: {element} is not named",
                    figure.id
                );
            }
        }
        assert!(
            !figure.svg.contains("<?xml") && !figure.svg.lines().any(|line| line.trim().is_empty()),
            "{}",
            figure.id
        );
        Document::parse(&figure.standalone).unwrap_or_else(|error| panic!("{} alone: {error}", figure.id));
        assert!(figure.standalone.starts_with("<?xml"));
    }
}

#[test]
fn a_figure_that_stands_alone_needs_no_font_and_is_not_heavy() {
    for figure in every_figure() {
        let alone = &figure.standalone;
        assert!(!alone.contains("<text") && !alone.contains("font-"), "{} asks for a font", figure.id);
        assert!(alone.len() < HEAVIEST_ALONE, "{} weighs {} bytes alone", figure.id, alone.len());
    }
    assert!(every_figure().iter().any(|figure| figure.svg.contains("<text")), "on pages words are text");
}

#[test]
fn no_figure_holds_a_colour() {
    for figure in every_figure() {
        // A shaded body refers to its own gradient, whose stops are classes like everything else.
        let shade = |value: &str| value.starts_with("url(#") && value.contains("-shade-");
        let text = figure.svg.to_lowercase().replace(" fill=\"url(#", " shade=\"url(#");
        for word in ["rgb", "hsl", "fill=", "stroke=", "fill:", "stroke:", "color"] {
            assert!(!text.contains(word), "{} contains `{word}`", figure.id);
        }
        let document = parsed(figure);
        let attributes = document.descendants().flat_map(|node| node.attributes());
        assert!(
            attributes
                .into_iter()
                .all(|attribute| shade(attribute.value()) || !attribute.value().contains('#')),
            "{}",
            figure.id
        );
    }
}

#[test]
fn ids_are_unique_in_the_whole_book() {
    let mut seen = BTreeSet::new();
    for figure in every_figure() {
        let prefix = figure.id.replace(':', "-");
        for node in parsed(figure).descendants() {
            let Some(id) = node.attribute("id") else { continue };
            assert!(id.starts_with(&prefix), "{}: the id `{id}` does not begin with the figure's", figure.id);
            assert!(seen.insert(id.to_owned()), "the id `{id}` occurs twice");
        }
    }
    assert!(seen.len() > 24);
}

/// Whether a segment has a point in common with a rectangle.
fn crosses(rect: &Rect, start: Point, end: Point) -> bool {
    rect.contains(start) || rect.contains(end) || !drawing::clip(&[start, end], rect).is_empty()
}

/// Whether a shape with this role paints ink that a label must keep clear of.
fn is_ink(role: Role) -> bool {
    // The rim of a label parts it from the grid of a floor.
    matches!(role, Role::Line(stroke, _) if stroke != Stroke::Grid)
        || matches!(role, Role::Area(Fill::Solid, _))
}

#[test]
fn labels_touch_no_label_and_no_line() {
    let mut clashes = Vec::new();
    for (figure, part) in every_part() {
        let items = part.items();
        let labels = labels(part);
        // The names of the frontispiece's pictures are links beside them; the cover has the title above it.
        let named_beside = ["fig:frontispiece", "fig:cover"].contains(&&figure.id[..]);
        assert!(!labels.is_empty() || named_beside, "{} has no label", figure.id);
        for (index, label) in labels.iter().enumerate() {
            for other in &labels[..index] {
                if label.bounds.overlaps(&other.bounds) {
                    clashes.push(format!("{}: {:?} touches {:?}", figure.id, words(label), words(other)));
                }
            }
            for item in items.iter().filter(|item| is_ink(item.role)) {
                let points = item.shape.points();
                if points.windows(2).any(|pair| crosses(&label.bounds, pair[0], pair[1])) {
                    let name = item.name.as_deref().unwrap_or("a line without a name");
                    let (role, at) = (item.role.classes(), label.bounds.centre());
                    clashes.push(format!(
                        "{}: {:?} at {at:?} touches {name}, {role}",
                        figure.id,
                        words(label)
                    ));
                }
            }
        }
    }
    assert!(clashes.is_empty(), "{} clashes:\n{}", clashes.len(), clashes.join("\n"));
}

/// The labels of a drawing.
fn labels(part: &Drawing) -> Vec<&Label> {
    let shapes = part.items().iter().map(|item| &item.shape);
    let labels = shapes.filter_map(|shape| match shape {
        Shape::Label(label) => Some(label),
        _ => None,
    });
    labels.collect()
}

/// The words of a label, with a sign for each formula.
fn words(label: &Label) -> String {
    let word = |piece: &Piece| match piece {
        Piece::Words { text, .. } => text.clone(),
        Piece::Outline(_) => "…".into(),
    };
    label.pieces.iter().map(word).collect()
}

#[test]
fn two_renderings_are_equal_byte_for_byte() {
    for (first, second) in every_figure().iter().zip(all(FIGURES).expect("every figure can be drawn")) {
        assert_eq!(first.svg, second.svg, "{}", first.id);
        assert_eq!(first.standalone, second.standalone, "{}", first.id);
    }
}

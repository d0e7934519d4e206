//! How much room figures take, on a wide page and on a phone.

use super::{every_figure, every_part, labels, parsed};
use drawing::{Drawing, Fill, MARGIN, NARROW, PANEL, Rect, Role};
use figures::Rendered;

/// The room for a figure on a phone whose screen is 360 px wide, px.
const PHONE: f64 = 340.0;
/// The least size of type on any page, and of what is raised or lowered beside it, px.
const TYPE: f64 = 11.0;
const SCRIPT: f64 = 8.0;

/// What the SVG of a drawing shows.
fn view_box(figure: &Rendered, part: &Drawing) -> Rect {
    let place = figure.drawing.all_parts().iter().position(|other| other.id() == part.id());
    let document = parsed(figure);
    let mut drawn = document.descendants().filter(|node| node.has_tag_name("svg"));
    let numbers = place.and_then(|place| drawn.nth(place)?.attribute("viewBox")).expect("a viewBox");
    let numbers: Vec<f64> = numbers.split(' ').map(|number| number.parse().expect("a number")).collect();
    Rect::new(numbers[0], numbers[1], numbers[2], numbers[3])
}

#[test]
fn every_svg_is_cut_to_its_ink() {
    for (figure, part) in every_part() {
        let seen = view_box(figure, part);
        let inked = part.items().iter().filter(|item| !matches!(item.role, Role::Area(Fill::Page, _)));
        let (mut across, mut down) = ((f64::INFINITY, f64::NEG_INFINITY), (f64::INFINITY, f64::NEG_INFINITY));
        for point in inked.flat_map(|item| item.shape.points()) {
            across = (across.0.min(point.x), across.1.max(point.x));
            down = (down.0.min(point.y), down.1.max(point.y));
        }
        let margins = [across.0 - seen.left, seen.right - across.1, down.0 - seen.top, seen.bottom - down.1];
        // A whole pixel, and half a stroke of at most 2 px.
        let tight = |margin: f64| (MARGIN..=MARGIN + 2.0).contains(&margin);
        let is_level = figure.drawing.all_parts().len() > 1; // with another panel
        assert!(tight(margins[0]) && tight(margins[1]), "{}: {margins:?} of {seen:?}", part.id());
        let below = |margin: f64| if is_level { margin >= MARGIN } else { tight(margin) };
        assert!(below(margins[2]) && below(margins[3]), "{}: {margins:?} of {seen:?}", part.id());
    }
}

#[test]
fn no_figure_is_too_wide() {
    for figure in every_figure() {
        let widest = match figure.drawing.parts().len() {
            1 if figure.id == "fig:cover" => 1040.0, // the whole width
            1 => 700.0,
            _ => PANEL,
        };
        for part in figure.drawing.parts() {
            let width = view_box(figure, part).width();
            assert!(width <= widest, "{} is {width} px wide, more than {widest}", part.id());
        }
    }
}

/// What is too small to read when a drawing has this much room, px.
fn too_small(figure: &Rendered, part: &Drawing, room: f64) -> Option<String> {
    let width = view_box(figure, part).width();
    let scale = (room / width).min(1.0);
    let small = |least: f64, size: f64| scale * size < least - 1e-9;
    let label =
        labels(part).into_iter().find(|label| small(TYPE, label.size) || small(SCRIPT, label.smallest))?;
    let (size, smallest) = (scale * label.size, scale * label.smallest);
    Some(format!("{} is {width} px wide; type of {size:.1} px, scripts of {smallest:.1} px", part.id()))
}

#[test]
fn type_can_be_read_on_every_page() {
    let mut poor = Vec::new();
    for figure in every_figure() {
        let narrow = figure.drawing.narrow_parts();
        let on_phone = narrow.iter().find_map(|part| too_small(figure, part, PHONE));
        let wide = figure.drawing.parts().into_iter();
        let mut only_wide = wide.filter(|part| !narrow.iter().any(|other| other.id() == part.id()));
        poor.extend(on_phone.or(only_wide.find_map(|part| too_small(figure, part, NARROW))));
    }
    assert!(poor.is_empty(), "{}", poor.join("\n"));
}

//! Drawings as SVG.

use crate::drawing::Drawing;
use crate::flaw::Flaw;
use crate::label::{Label, Piece};
use crate::layout::{self, Pages};
use crate::point::{Point, Rect, at};
use crate::role::{Fill, OPAQUE, RIM, Role, STOPS};
use crate::shape::{Item, Shape};
use crate::trace::number;
use crate::{style, trace};
use std::fmt::Write as _;

/// The widest row of panels in a file of its own, px.
const ROW: f64 = 1040.0;

impl Drawing {
    /// The drawing as SVG to be put into a page: no colours, no blank lines; the page's style sheet gives
    /// roles their looks. Panels are an SVG each, and so is the layout for narrow pages.
    ///
    /// Each shows its ink and a margin of [`MARGIN`](crate::MARGIN) px around it; on a page that is narrower
    /// it shrinks.
    ///
    /// # Errors
    /// [`Flaw`] if a coordinate is no number, or something could not be added.
    pub fn to_svg(&self) -> Result<String, Flaw> {
        self.flaw().map_or(Ok(()), Err)?;
        let mut said = (false, false); // on a wide page, on a narrow one
        let svg = |(part, seen, pages): (&Self, Rect, Pages)| {
            // Parts without words of their own: the first speaks for the whole.
            let here = (pages != Pages::Narrow, pages != Pages::Wide);
            let words = if part.title().is_empty() { self } else { part };
            let speaks = !part.title().is_empty() || here.0 && !said.0 || here.1 && !said.1;
            if part.title().is_empty() {
                said = (said.0 || here.0, said.1 || here.1);
            }
            let class = match pages {
                Pages::All => "drawn",
                Pages::Wide => "drawn wide-only",
                Pages::Narrow => "drawn narrow",
            };
            let width = number(seen.width());
            let size = format!("{} style=\"max-width:{width}px;--own:{width}px\"", view_box(seen));
            let mut out = if speaks {
                opening(&part.id, class, &size, words.title(), words.description())
            } else {
                format!("<svg class=\"{class}\" {size} aria-hidden=\"true\">\n")
            };
            part.write_items::<true>(&mut out);
            out += "</svg>";
            match &part.link {
                Some(target) => format!(
                    "<a class=\"panel\" href=\"{}\">{out}<span aria-hidden=\"true\">{}</span></a>",
                    escaped(target),
                    escaped(part.title())
                ),
                None => out,
            }
        };
        Ok(self.leaves().into_iter().map(svg).collect::<Vec<_>>().join("\n"))
    }

    /// What stands inside of the SVG of a drawing without panels: an element a line, in the order in which they are
    /// painted.
    pub fn to_elements(&self) -> Result<String, Flaw> {
        self.flaw().map_or(Ok(()), Err)?;
        let mut out = String::new();
        self.write_items::<true>(&mut out);
        Ok(out)
    }

    /// The drawing as an SVG file of its own, in full size, with its style sheet for light and dark inside. Panels
    /// stand side by side, in rows. Its words are outlines, so that it looks the same wherever it is opened.
    pub fn to_standalone_svg(&self) -> Result<String, Flaw> {
        self.flaw().map_or(Ok(()), Err)?;
        let parts = self.parts();
        let seen = layout::seen(&parts);
        let (places, all) = rows(&seen);
        let (width, height) = (number(all.width()), number(all.height()));
        let size = format!(
            "xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" {}",
            view_box(all)
        );
        let mut out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n".to_owned();
        out += &opening(&self.id, "drawn", &size, self.title(), self.description());
        let _ = writeln!(out, "<style>\n{}</style>", style::standalone());
        for (part, place) in parts.into_iter().zip(places) {
            let (x, y) = (number(place.x), number(place.y));
            let _ = writeln!(out, "<g transform=\"translate({x} {y})\">");
            part.write_items::<false>(&mut out);
            out += "</g>\n";
        }
        Ok(out + "</svg>\n")
    }

    /// Writes an element a line. On a page, a tint, the colour of the page under it and the line about it are one element,
    /// whose colours the page's style sheet can mix; a file's cannot. In a file words are outlines: its reader may lack the
    /// font. (The letters are known at compile time not to be wanted on a page, and a module of live scenes does not carry
    /// them.)
    fn write_items<const IS_PAGE: bool>(&self, out: &mut String) {
        let id = self.id.replace(':', "-");
        let items = self.items();
        let (mut index, mut shades) = (0, 0);
        while let Some(item) = items.get(index) {
            if IS_PAGE && let Some(tint) = items.get(index + 1).filter(|tint| is_under(item, tint)) {
                let edge = items.get(index + 2).filter(|edge| is_edge(edge, tint));
                let line = edge.map_or(String::new(), |edge| edge.role.classes() + " ");
                let class = format!("{line}{OPAQUE} {}", tint.role.classes());
                write_item::<IS_PAGE>(out, &id, &mut shades, tint, &class);
                index += 2 + usize::from(edge.is_some());
                continue;
            }
            // A floor's grid, the ticks of an axis or the spokes of a wheel are one element: a page that moves pays for each.
            let alike = |place: &usize| {
                let covers = items.get(place + 1).is_some_and(|tint| is_under(&items[*place], tint));
                is_plain(&items[*place]) && items[*place].role == item.role && !covers
            };
            let count = (index..items.len()).take_while(alike).count();
            if count > 1 {
                let class = item.role.classes();
                let data = trace::all(items[index..index + count].iter().map(|item| &item.shape));
                let _ = writeln!(out, "<path class=\"{class}\" d=\"{data}\"/>");
            } else {
                write_item::<IS_PAGE>(out, &id, &mut shades, item, &item.role.classes());
            }
            index += count.max(1);
        }
    }
}

/// Whether an item is a line or a polygon that nobody asks for by its name. Glass is seen through glass, so each pane stays.
fn is_plain(item: &Item) -> bool {
    let is_plain = match item.shape {
        Shape::Polyline(_) => matches!(item.role, Role::Line(..)),
        Shape::Polygon(_) => !matches!(item.role, Role::Text(_) | Role::Area(Fill::Glass, _)),
        _ => false,
    };
    is_plain && item.name.is_none()
}

/// Whether an item is the colour of the page under nothing but a tint, to hide what lies behind it.
fn is_under(item: &Item, tint: &Item) -> bool {
    let areas = match (item.role, tint.role) {
        (Role::Area(Fill::Page, _), Role::Area(fill, _)) => fill.is_tint(),
        _ => false,
    };
    let alike = item.shape == tint.shape
        || matches!(tint.shape, Shape::Rounded { .. }) && item.shape == tint.shape.unshaded();
    areas && item.name.is_none() && alike
}

/// Whether an item is a line about an area, in its hue.
fn is_edge(item: &Item, area: &Item) -> bool {
    let alike = match (item.role, area.role) {
        (Role::Line(_, hue), Role::Area(_, own)) => hue == own,
        _ => false,
    };
    alike && item.name.is_none() && item.shape == area.shape
}

/// The tag that opens an SVG, with the words for those who cannot see it.
fn opening(id: &str, class: &str, size: &str, title: &str, description: &str) -> String {
    let (id, title, description) = (id.replace(':', "-"), escaped(title), escaped(description));
    format!(
        "<svg class=\"{class}\" {size} role=\"img\" aria-labelledby=\"{id}-title {id}-desc\">\n\
         <title id=\"{id}-title\">{title}</title>\n<desc id=\"{id}-desc\">{description}</desc>\n"
    )
}

fn view_box(seen: Rect) -> String {
    let [left, top, width, height] = [seen.left, seen.top, seen.width(), seen.height()].map(number);
    format!("viewBox=\"{left} {top} {width} {height}\"")
}

/// How far to move each drawing so that all stand in rows, and the rectangle of all. The first stays where it is.
fn rows(seen: &[Rect]) -> (Vec<Point>, Rect) {
    let first = seen.first().copied().unwrap_or_default();
    let (mut all, mut places) = (first, Vec::new());
    let (mut right, mut top) = (first.left - layout::GAP, first.top);
    for own in seen {
        if right + layout::GAP + own.width() > first.left + ROW.max(first.width()) {
            (right, top) = (first.left - layout::GAP, all.bottom + layout::GAP);
        }
        let step = at(right + layout::GAP - own.left, top - own.top);
        right += layout::GAP + own.width();
        all = all.union(&own.moved(step));
        places.push(step);
    }
    (places, all)
}

fn write_item<const IS_PAGE: bool>(out: &mut String, id: &str, shades: &mut u32, item: &Item, class: &str) {
    let name = item.name.as_ref().map_or(String::new(), |name| format!(" id=\"{id}-{}\"", escaped(name)));
    let element = match &item.shape {
        Shape::Label(label) => return write_label::<IS_PAGE>(out, &name, item.role, label),
        Shape::Circle { centre, radius } => {
            // Two halves: a circle that moves changes one attribute, where the centre of a <circle> is two.
            let [x, y, r, whole] = [centre.x + radius, centre.y, *radius, 2.0 * radius].map(number);
            let half = format!("{r} {r} 0 1 1");
            format!("<path{name} class=\"{class}\" d=\"M{x} {y}a{half}-{whole} 0 {half} {whole} 0z\"/>")
        }
        Shape::Polyline(points) => format!("<path{name} class=\"{class}\" d=\"{}\"/>", trace::lines(points)),
        Shape::Polygon(points) => format!("<path{name} class=\"{class}\" d=\"{}Z\"/>", trace::lines(points)),
        Shape::Arc { centre, radius, from, sweep } => {
            let [start, end] =
                [*from, from + sweep].map(|angle| pair(*centre + Point::polar(*radius, angle)));
            let (large, clockwise) = (u8::from(sweep.abs() > std::f64::consts::PI), u8::from(*sweep < 0.0));
            let r = number(*radius);
            format!("<path{name} class=\"{class}\" d=\"M{start}A{r},{r} 0 {large} {clockwise} {end}\"/>")
        }
        Shape::Ellipse { centre, radii, turn } => {
            format!("<path{name} class=\"{class}\" d=\"{}\"/>", ellipse(*centre, *radii, *turn))
        }
        Shape::Rounded { centre, radii, turn, light } => {
            let shade = format!("{id}-shade-{shades}");
            *shades += 1;
            let gradient = gradient(&shade, class, *centre, *radii, *turn, *light);
            let path = ellipse(*centre, *radii, *turn);
            format!("{gradient}\n<path{name} class=\"{class}\" fill=\"url(#{shade})\" d=\"{path}\"/>")
        }
    };
    out.push_str(&element);
    out.push('\n');
}

/// Two halves of an ellipse.
fn ellipse(centre: Point, radii: (f64, f64), turn: f64) -> String {
    let [start, end] = [1.0, -1.0].map(|end| pair(centre + Point::polar(radii.0 * end, turn)));
    let [first, second, slope] = [radii.0, radii.1, -turn.to_degrees()].map(number);
    let half = format!("A{first},{second} {slope} 0 0");
    format!("M{start}{half} {end}{half} {start}Z")
}

/// The shading of an ellipse: a gradient in coordinates in which it is the unit circle.
fn gradient(id: &str, class: &str, centre: Point, radii: (f64, f64), turn: f64, light: Point) -> String {
    let (first, second) = (Point::polar(1.0, turn), Point::polar(1.0, turn).quarter_turned());
    let step = light - centre;
    let dot = |axis: Point| step.x * axis.x + step.y * axis.y;
    let [x, y] = [dot(first) / radii.0, dot(second) / radii.1].map(number);
    let (first, second) = (first * radii.0, second * radii.1);
    let matrix = [first.x, first.y, second.x, second.y, centre.x, centre.y].map(number).join(" ");
    let stops: String = STOPS
        .iter()
        .zip(["0", ".5", "1"])
        .map(|(stop, offset)| format!("<stop class=\"{stop} {class}\" offset=\"{offset}\"/>"))
        .collect();
    format!(
        "<radialGradient id=\"{id}\" gradientUnits=\"userSpaceOnUse\" cx=\"0\" cy=\"0\" r=\"1\" fx=\"{x}\" fy=\"{y}\" \
         gradientTransform=\"matrix({matrix})\">{stops}</radialGradient>"
    )
}

/// On a page a label of one piece carries its own rim. Where several pieces stand side by side all rims come first, or
/// the rim of one would eat into its neighbour. In a file the rim comes first too, because some programs paint every
/// stroke over its fill.
fn write_label<const IS_PAGE: bool>(out: &mut String, name: &str, role: Role, label: &Label) {
    let outlined;
    let pieces = if IS_PAGE {
        &label.pieces[..]
    } else {
        outlined = [Piece::Outline(label.outline())];
        &outlined
    };
    let classes = match role {
        Role::Text(hue) if pieces.len() > 1 || !IS_PAGE => {
            vec![RIM.to_owned(), Role::PlainText(hue).classes()]
        }
        _ => vec![role.classes()],
    };
    if let ([piece], [class]) = (pieces, &classes[..]) {
        write_piece(out, name, class, piece);
    } else {
        let _ = write!(out, "<g{name}>");
        for class in &classes {
            pieces.iter().for_each(|piece| write_piece(out, "", class, piece));
        }
        out.push_str("</g>");
    }
    out.push('\n');
}

fn write_piece(out: &mut String, name: &str, class: &str, piece: &Piece) {
    let _ = match piece {
        Piece::Outline(segments) => {
            // A letter that moves stays the same letter, and is not read anew.
            let (start, data) = trace::outline(segments);
            let [x, y] = [start.x, start.y].map(number);
            write!(out, "<path{name} class=\"{class}\" transform=\"translate({x} {y})\" d=\"{data}\"/>")
        }
        Piece::Words { text, start, width, size } => {
            let [x, y, width, size] = [start.x, start.y, *width, *size].map(number);
            write!(
                out,
                "<text{name} class=\"{class}\" x=\"{x}\" y=\"{y}\" font-size=\"{size}\" textLength=\"{width}\" \
                 lengthAdjust=\"spacingAndGlyphs\">{}</text>",
                escaped(text)
            )
        }
    };
}

fn pair(point: Point) -> String {
    format!("{},{}", number(point.x), number(point.y))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

//! The curves of the figures, read back from the SVG, agree with formulas or the library at points that the
//! figure did not sample.
//!
//! What the places of a curve mean is read off the axes that its drawing carries, and that these are the axes
//! a reader sees is a test of its own: the numbers at the ticks stand where their values belong.

mod ball;
mod constrained;
mod free_tops;
mod hard_cases;
mod judged;
mod laundromat;
mod methods;
mod report;
mod top;
mod turning_plates;

use drawing::{Axes, Drawing, Fill, Hue, Piece, Point, Role, Shape, Stroke, at};
use figures::{Rendered, all};
use pages::figures::FIGURES;
use roxmltree::Document;
use std::sync::OnceLock;

/// Thinning and the cubic curves that are written may move a curve by 0.07 px; reading two decimals costs 0.005 px, the
/// coordinates 0.001 px, sampling the rest.
const PIXELS: f64 = 0.08;

fn figures() -> &'static [Rendered] {
    static RENDERED: OnceLock<Vec<Rendered>> = OnceLock::new();
    RENDERED.get_or_init(|| all(FIGURES).expect("every figure can be drawn"))
}

/// The figure with this id without its `fig:`.
fn find(figure: &str) -> &'static Rendered {
    let found = figures().iter().find(|other| other.id.strip_prefix("fig:") == Some(figure));
    found.unwrap_or_else(|| panic!("no figure {figure}"))
}

/// The drawings of a figure.
fn parts(figure: &str) -> Vec<&'static Drawing> {
    find(figure).drawing.parts()
}

/// The polylines of a drawing with this role, in the order in which they were painted.
fn lines(part: &Drawing, stroke: Stroke, hue: Hue) -> Vec<&[Point]> {
    let items = part.items().iter().filter(|item| item.role == Role::Line(stroke, hue));
    let points = items.filter_map(|item| match &item.shape {
        Shape::Polyline(points) => Some(&points[..]),
        _ => None,
    });
    points.collect()
}

/// A curve over the axes of its plot.
struct Curve {
    /// Where its lines and its cubic curves end, px.
    corners: Places,
    /// These, and many points on each cubic curve.
    points: Places,
    axes: Axes,
}

/// The curve with this name, of the figure with this id without its `fig:`.
fn curve(figure: &str, name: &str) -> Curve {
    let figure = find(figure);
    let carries = |axes: &&Axes| axes.curves.iter().any(|curve| curve == name);
    let parts = figure.drawing.parts();
    let (part, axes) = parts
        .into_iter()
        .find_map(|part| Some((part, part.axes().iter().find(carries)?)))
        .unwrap_or_else(|| panic!("{} has no curve {name}", figure.id));
    let document = Document::parse(&figure.svg).expect("valid XML");
    let id = format!("{}-{name}", part.id().replace(':', "-"));
    let node =
        document.descendants().find(|node| node.attribute("id") == Some(&id)).expect("a path of this id");
    let (corners, points) = traced(node.attribute("d").expect("a path"));
    Curve { corners, points, axes: axes.clone() }
}

/// Points of a page, px.
type Places = Vec<(f64, f64)>;

/// The ends of the steps of a path, `M48 90l2.08.14-3 1c1 0 2 1 3 1`, and these with many points on each of its cubic Bézier
/// curves.
fn traced(data: &str) -> (Places, Places) {
    let mut steps: Vec<(char, Vec<String>)> = Vec::new();
    let mut is_open = false;
    for sign in data.chars() {
        if sign.is_ascii_alphabetic() {
            steps.push((sign, Vec::new()));
        }
        let numbers = &mut steps.last_mut().expect("a path begins with a letter").1;
        let goes_on = match sign {
            '0'..='9' => is_open,
            '.' => is_open && numbers.last().is_some_and(|number| !number.contains('.')),
            _ => false,
        };
        is_open = matches!(sign, '0'..='9' | '.' | '-');
        match numbers.last_mut() {
            Some(number) if goes_on => number.push(sign),
            _ if is_open => numbers.push(sign.to_string()),
            _ => {}
        }
    }
    let (mut corners, mut points) = (vec![(0.0, 0.0)], Vec::new());
    for (letter, numbers) in steps {
        let numbers: Vec<f64> = numbers.iter().map(|number| number.parse().expect("a number")).collect();
        for step in numbers.chunks_exact(if letter == 'c' { 6 } else { 2 }) {
            let (x, y) = corners[corners.len() - 1];
            if letter == 'c' {
                let parts = (1..256).map(|n| f64::from(n) / 256.0);
                points.extend(parts.map(|part| (x + bezier(part, step), y + bezier(part, &step[1..]))));
            }
            let corner = (x + step[step.len() - 2], y + step[step.len() - 1]);
            corners.push(corner);
            points.push(corner);
        }
    }
    (corners.split_off(1), points)
}

/// A coordinate at a part of a cubic Bézier curve that begins at zero, from those of its other three points; between each
/// two stands one of the other direction.
fn bezier(part: f64, others: &[f64]) -> f64 {
    let rest = 1.0 - part;
    3.0 * part * rest * rest * others[0] + 3.0 * part * part * rest * others[2] + part.powi(3) * others[4]
}

impl Curve {
    /// How far from the curve a pair of values lies, px.
    fn distance(&self, pair: (f64, f64)) -> f64 {
        let Point { x, y } = self.axes.point(pair);
        let from = |pair: &[(f64, f64)]| {
            let [(x0, y0), (x1, y1)] = [pair[0], pair[1]];
            let (dx, dy) = (x1 - x0, y1 - y0);
            let part = (((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
            (x0 + part * dx - x).hypot(y0 + part * dy - y)
        };
        self.points.windows(2).map(from).fold(f64::INFINITY, f64::min)
    }

    /// Its points as values.
    fn values(&self) -> Vec<(f64, f64)> {
        self.points.iter().map(|&(x, y)| self.axes.values(at(x, y))).collect()
    }

    /// Its value at x, on the straight line between two corners.
    fn value(&self, x: f64) -> f64 {
        let across = self.axes.point((x, self.axes.y.to)).x;
        let holds = |pair: &&[(f64, f64)]| (pair[0].0 <= across) == (across <= pair[1].0);
        let pair = self.points.windows(2).find(holds);
        let Some(&[(x0, y0), (x1, y1)]) = pair else { panic!("the curve does not reach {x}") };
        let height = y0 + (y1 - y0) * (across - x0) / (x1 - x0);
        self.axes.values(at(across, height)).1
    }
}

/// The curve passes through all these pairs of values: how many they are.
fn passes(figure: &str, name: &str, pairs: impl IntoIterator<Item = (f64, f64)>) -> usize {
    let curve = curve(figure, name);
    let off = |pair| {
        let off = curve.distance(pair);
        assert!(off < PIXELS, "{figure} {name}: {off} px off at {pair:?}");
    };
    let checked = pairs.into_iter().map(off).count();
    assert!(checked > 0, "{figure} {name}: nothing is checked");
    checked
}

/// Wherever the formula is inside the frame, the curve passes there.
fn lies_on(figure: &str, name: &str, formula: impl Fn(f64) -> f64) {
    let axes = curve(figure, name).axes;
    let across = (1..400).map(|step| axes.x.value((f64::from(step) + 0.37) / 400.0));
    let inside = across.map(|x| (x, formula(x))).filter(|(_, y)| (0.0..1.0).contains(&axes.y.part(*y)));
    let checked = passes(figure, name, inside);
    assert!(checked > 100, "{figure} {name}: only {checked} points");
}

/// From the first point of a line to its last, to the right and upwards, px.
fn step(line: &[Point]) -> (f64, f64) {
    let [first, last] = [line[0], line[line.len() - 1]];
    (last.x - first.x, first.y - last.y)
}

/// The dots of a hue, in the order in which they were painted.
fn dots(part: &Drawing, hue: Hue) -> Vec<Point> {
    let items = part.items().iter().filter(|item| item.role == Role::Area(Fill::Solid, hue));
    let centres = items.filter_map(|item| match item.shape {
        Shape::Circle { centre, .. } => Some(centre),
        _ => None,
    });
    centres.collect()
}

/// The number that a label at a tick shows, and the label's middle, px.
fn tick(role: Role, shape: &Shape) -> Option<(f64, Point)> {
    let (Role::PlainText(_), Shape::Label(label)) = (role, shape) else { return None };
    let number = |piece: &Piece| match piece {
        Piece::Words { text, .. } => text.replace('−', "-").parse::<f64>().ok(),
        Piece::Outline(_) => None,
    };
    let shown = match &label.pieces[..] {
        [number_alone] => number(number_alone)?,
        [ten, power] => number(ten)?.powf(number(power)?),
        _ => return None,
    };
    Some((shown, label.bounds.centre()))
}

#[test]
fn the_numbers_at_ticks_stand_where_their_values_belong() {
    let mut checked = [0, 0];
    for part in figures().iter().flat_map(|figure| figure.drawing.all_parts()) {
        let items = part.items();
        let ticks: Vec<_> = items.iter().filter_map(|item| tick(item.role, &item.shape)).collect();
        for axes in part.axes() {
            let frame = axes.frame;
            for &(shown, middle) in &ticks {
                let Point { x, y } = axes.point((shown, shown));
                let (below, beside) = (middle.y - frame.bottom, frame.left - middle.x);
                let near = (frame.left - 9.0..frame.right + 9.0).contains(&middle.x)
                    && (10.0..20.0).contains(&below);
                if near {
                    assert!((middle.x - x).abs() < 1.5, "{}: {shown} stands at {middle:?}", part.id());
                    checked[0] += 1;
                }
                let near = (frame.top - 9.0..frame.bottom + 9.0).contains(&middle.y)
                    && (9.0..30.0).contains(&beside);
                if near {
                    assert!((middle.y - y).abs() < 3.0, "{}: {shown} stands at {middle:?}", part.id());
                    checked[1] += 1;
                }
            }
        }
    }
    assert!(checked[0] > 250 && checked[1] > 250, "{checked:?}");
}

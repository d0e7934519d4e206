//! The curves of the figures, read back from the SVG, agree with formulas or the library at points that the figure did not sample.
//!
//! The tests know where the axes of each plot stand, and nothing else of how it was drawn.

mod constrained;
mod free_tops;
mod hard_cases;
mod laundromat;
mod methods;
mod report;

use figures::{Figure, all};
use roxmltree::Document;
use std::sync::OnceLock;

/// Thinning may move a curve by 0.06 px; reading two decimals costs 0.005 px, the coordinates 0.001 px, sampling the rest.
const PIXELS: f64 = 0.08;

/// The points of the path with this name, of the figure with this id without its `fig:`.
fn path(figure: &str, name: &str) -> Vec<(f64, f64)> {
    static FIGURES: OnceLock<Vec<Figure>> = OnceLock::new();
    let figures = FIGURES.get_or_init(|| all().expect("every figure can be drawn"));
    let svg = &figures.iter().find(|other| other.id == format!("fig:{figure}")).expect("the figure").svg;
    let document = Document::parse(svg).expect("valid XML");
    let id = format!("fig-{figure}-{name}");
    let node = document.descendants().find(|node| node.attribute("id") == Some(&id));
    let data = node
        .unwrap_or_else(|| panic!("no path {id}"))
        .attribute("d")
        .expect("a path")
        .replace(['M', 'L'], " ");
    let number = |text: &str| text.parse::<f64>().expect("a number");
    data.split_whitespace()
        .map(|pair| pair.split_once(',').map(|(x, y)| (number(x), number(y))).expect("a pair"))
        .collect()
}

/// The least distance of a point from a polyline, px.
fn distance(polyline: &[(f64, f64)], (x, y): (f64, f64)) -> f64 {
    polyline
        .windows(2)
        .map(|pair| {
            let [(x0, y0), (x1, y1)] = [pair[0], pair[1]];
            let (dx, dy) = (x1 - x0, y1 - y0);
            let part = (((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
            (x0 + part * dx - x).hypot(y0 + part * dy - y)
        })
        .fold(f64::INFINITY, f64::min)
}

/// The range of an axis.
#[derive(Clone, Copy)]
enum Range {
    Linear(f64, f64),
    Log(f64, f64),
}

impl Range {
    /// The value at a part of the way from the first to the last.
    fn value(self, part: f64) -> f64 {
        match self {
            Self::Linear(from, to) => from + (to - from) * part,
            Self::Log(from, to) => from * (to / from).powf(part),
        }
    }

    /// Which part of the way a value is at.
    fn part(self, value: f64) -> f64 {
        match self {
            Self::Linear(from, to) => (value - from) / (to - from),
            Self::Log(from, to) => (value / from).ln() / (to / from).ln(),
        }
    }
}

/// The frame of a plot, px, left, top, width and height, and the ranges of its axes.
struct Frame {
    place: [f64; 4],
    x: Range,
    y: Range,
}

impl Frame {
    fn at(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let [left, top, width, height] = self.place;
        (left + width * self.x.part(x), top + height * (1.0 - self.y.part(y)))
    }
}

/// Wherever the formula is inside the frame, the curve passes there.
fn lies_on(figure: &str, name: &str, frame: &Frame, formula: impl Fn(f64) -> f64) {
    let curve = path(figure, name);
    let mut checked = 0;
    for step in 1..400 {
        let x = frame.x.value((f64::from(step) + 0.37) / 400.0);
        let y = formula(x);
        let part = frame.y.part(y);
        if part > 0.0 && part < 1.0 {
            let off = distance(&curve, frame.at((x, y)));
            assert!(off < PIXELS, "{figure} {name}: {off} px off at {x}");
            checked += 1;
        }
    }
    assert!(checked > 100, "{figure} {name}: only {checked} points");
}

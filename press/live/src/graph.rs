//! Plots in a scene, in the style of the figures.

use crate::Cause;
use drawing::{
    Axes, Axis, Drawing, Fill, Flaw, Hue, Label, Point, Rect, Role, Shape, Side, Stroke, at, clip, kit,
};

/// Lengths of ticks, px; the type sizes of their numbers and of titles.
const TICK: f64 = 5.0;
const NUMBERS: f64 = 13.0;
const TITLES: f64 = 14.0;

/// A plot in a rectangle of a drawing. Points are given as values, (x, y).
pub struct Graph<'a> {
    drawing: &'a mut Drawing,
    axes: Axes,
}

impl<'a> Graph<'a> {
    /// A plot whose axes run along the left and the lower edge of a rectangle, px, and are drawn at once.
    ///
    /// # Errors
    /// If an axis has no ticks or too many, or a title cannot be set.
    pub fn new(drawing: &'a mut Drawing, frame: Rect, x: Axis<'_>, y: Axis<'_>) -> Result<Self, Cause> {
        let axes = Axes::new(frame, x.scale, y.scale);
        drawing.add_axes(axes.clone());
        let Rect { left, top, right, bottom } = frame;
        let origin = at(left, bottom);
        let sides = [
            (x, at(right, bottom), at(0.0, TICK), Side::Below, TICK + 4.0),
            (y, at(left, top), at(-TICK, 0.0), Side::Left, TICK + 3.0),
        ];
        for (_, end, ..) in sides {
            drawing.line(origin, end, Stroke::Axis, Hue::Ink);
        }
        for (axis, end, tick, side, gap) in sides {
            for (part, text) in axis.ticks()? {
                let foot = origin + (end - origin) * part;
                drawing.line(foot, foot + tick, Stroke::Axis, Hue::Ink);
                if !text.is_empty() {
                    drawing.label_set(foot, side, gap, NUMBERS, &text, Role::Text(Hue::Ink))?;
                }
            }
        }
        let titles = [(x.title, true), (y.title, false)];
        for (title, is_x) in titles.into_iter().filter(|(title, _)| !title.is_empty()) {
            let label = Label::new(title, TITLES)?;
            let start = if is_x {
                at(right - label.width(), bottom + 40.0)
            } else {
                at((left - 34.0).max(2.0), top - 12.0)
            };
            drawing.push(Role::Text(Hue::Ink), Shape::Label(label.from_baseline(start)));
        }
        Ok(Self { drawing, axes })
    }

    /// The drawing beneath.
    pub fn drawing(&mut self) -> &mut Drawing {
        self.drawing
    }

    /// Where a pair of values lies in the drawing, px.
    pub fn at(&self, value: (f64, f64)) -> Point {
        self.axes.point(value)
    }

    /// A curve through values, cut at the frame; it ends where a value is no number.
    pub fn curve(&mut self, values: impl IntoIterator<Item = (f64, f64)>, stroke: Stroke, hue: Hue) {
        let points: Vec<Point> = values.into_iter().map(|value| self.at(value)).collect();
        for piece in clip(&points, &self.axes.frame) {
            self.drawing.polyline(&piece, stroke, hue);
        }
    }

    /// A filled area between values, cut at the frame.
    pub fn area(&mut self, values: impl IntoIterator<Item = (f64, f64)>, fill: Fill, hue: Hue) {
        let Rect { left, top, right, bottom } = self.axes.frame;
        let inside = |point: Point| at(point.x.clamp(left, right), point.y.clamp(top, bottom));
        let points = values.into_iter().map(|value| inside(self.at(value))).collect();
        self.drawing.polygon(points, fill, hue);
    }

    /// A dot of a radius, px, where its values lie inside the frame.
    pub fn dot(&mut self, value: (f64, f64), radius: f64, hue: Hue) {
        let point = self.at(value);
        if self.axes.frame.grown(0.5).contains(point) {
            self.drawing.dot(point, radius, hue);
        }
    }

    /// What a hand can take hold of, at a pair of values.
    pub fn grip(&mut self, value: (f64, f64), hue: Hue) {
        let point = self.at(value);
        kit::grip(self.drawing, point, hue);
    }

    /// Draws what answers the chapter's guess: the page covers it until the reader has guessed. There is one such part
    /// of a picture.
    ///
    /// # Errors
    /// Those of what draws it.
    pub fn answer(&mut self, draw: impl FnOnce(&mut Self) -> Result<(), Flaw>) -> Result<(), Flaw> {
        let before = self.drawing.items().len();
        draw(self)?;
        cover_from(self.drawing, before);
        Ok(())
    }

    /// A line across the plot at a value of y.
    pub fn level(&mut self, y: f64, stroke: Stroke, hue: Hue) {
        self.curve([(self.axes.x.from, y), (self.axes.x.to, y)], stroke, hue);
    }

    /// A line up the plot at a value of x.
    pub fn upright(&mut self, x: f64, stroke: Stroke, hue: Hue) {
        self.curve([(x, self.axes.y.from), (x, self.axes.y.to)], stroke, hue);
    }

    /// A label beside a pair of values.
    pub fn label(&mut self, value: (f64, f64), side: Side, text: &str, hue: Hue) -> Result<(), Flaw> {
        let point = self.at(value);
        self.drawing.label(point, side, text, hue)
    }
}

/// Has the page cover what has been drawn since there were so many items: see [`Graph::answer`].
pub fn cover_from(drawing: &mut Drawing, before: usize) {
    drawing.name_curve("answer", drawing.items().len() - before);
}

/// Where a plot stands in a drawing, px, and its axes: what is drawn there, and what can be held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plot<'a> {
    /// Its rectangle.
    pub frame: Rect,
    /// The axis to the right.
    pub x: Axis<'a>,
    /// The axis upwards.
    pub y: Axis<'a>,
}

impl Plot<'_> {
    /// Draws its axes.
    ///
    /// # Errors
    /// As for [`Graph::new`].
    pub fn on<'b>(&self, drawing: &'b mut Drawing) -> Result<Graph<'b>, Cause> {
        Graph::new(drawing, self.frame, self.x, self.y)
    }

    /// To draw more over axes that are drawn already.
    pub fn over<'b>(&self, drawing: &'b mut Drawing) -> Graph<'b> {
        Graph { drawing, axes: Axes::new(self.frame, self.x.scale, self.y.scale) }
    }

    /// Where a pair of values lies, px: where its grip is.
    pub fn point(&self, value: (f64, f64)) -> Point {
        Axes::new(self.frame, self.x.scale, self.y.scale).point(value)
    }

    /// The pair of values that lies at a point: what a drawn grip means.
    pub fn value(&self, point: Point) -> (f64, f64) {
        Axes::new(self.frame, self.x.scale, self.y.scale).values(point)
    }
}

/// A step for an axis that has to be about so long: the next 1, 2 or 5 times a power of ten.
pub fn nice_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.max(1e-9).log10().floor());
    [1.0, 2.0, 5.0].map(|times| times * power).into_iter().find(|&step| step >= least).unwrap_or(10.0 * power)
}

/// Of some values of a control, the one whose place in the picture is nearest to a hand: what a drawn grip means that
/// lies in no plot. A value without a place is passed over.
pub fn nearest(
    values: impl IntoIterator<Item = f64>,
    hand: Point,
    place: impl Fn(f64) -> Result<Point, Cause>,
) -> Option<f64> {
    let distances =
        values.into_iter().filter_map(|value| Some((value, (place(value).ok()? - hand).length())));
    distances.min_by(|one, other| one.1.total_cmp(&other.1)).map(|(value, _)| value)
}

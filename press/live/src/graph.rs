//! Plots in a scene, in the style of the figures.

use crate::Cause;
use drawing::{
    Drawing, Fill, Hue, Label, LabelError, Point, Rect, Role, Scale, Shape, Side, Stroke, at, clip,
};

/// Lengths of ticks, px; the type sizes of their numbers and of titles.
const TICK: f64 = 5.0;
const NUMBERS: f64 = 13.0;
const TITLES: f64 = 14.0;

/// An axis: its scale, its ticks and its title.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis<'a> {
    /// The value at its beginning, left or below.
    pub from: f64,
    /// The value at its end.
    pub to: f64,
    /// A tick every so much; on a logarithmic axis, every so many powers of ten.
    pub step: f64,
    /// Whether equal ways are equal ratios.
    pub is_logarithmic: bool,
    /// Its title; empty for none.
    pub title: &'a str,
    /// Whether numbers stand at the ticks.
    pub is_numbered: bool,
}

impl<'a> Axis<'a> {
    /// A linear axis from a value to a value, with a tick every `step`.
    pub const fn linear([from, to, step]: [f64; 3], title: &'a str) -> Self {
        Self { from, to, step, is_logarithmic: false, title, is_numbered: true }
    }

    /// A logarithmic axis from a value to a value, with a tick every `decades` powers of ten.
    pub const fn log([from, to, decades]: [f64; 3], title: &'a str) -> Self {
        Self { from, to, step: decades, is_logarithmic: true, title, is_numbered: true }
    }

    /// The axis without numbers, where those of a plot below serve.
    #[must_use]
    pub const fn unnumbered(self) -> Self {
        Self { is_numbered: false, ..self }
    }

    /// Where a value stands on the scale.
    fn place(&self, value: f64) -> f64 {
        if self.is_logarithmic { value.log10() } else { value }
    }

    fn scale(&self) -> Scale {
        Scale { from: self.from, to: self.to, logarithmic: self.is_logarithmic }
    }

    /// The part of the way along the axis at which a value stands.
    fn part(&self, value: f64) -> f64 {
        let [from, to] = [self.from, self.to].map(|end| self.place(end));
        (self.place(value) - from) / (to - from)
    }

    /// The value at a part of the way.
    fn value(&self, part: f64) -> f64 {
        let [from, to] = [self.from, self.to].map(|end| self.place(end));
        let place = from + part * (to - from);
        if self.is_logarithmic { 10_f64.powf(place) } else { place }
    }

    /// The values with ticks, and what stands beside them.
    fn ticks(&self) -> Result<Vec<(f64, String)>, Cause> {
        let [from, to] = [self.from, self.to].map(|end| self.place(end));
        let count = (to - from) / self.step;
        if !(count > 0.0 && count <= 100.0) {
            return Err(
                format!("an axis from {} to {} with a tick every {}", self.from, self.to, self.step).into()
            );
        }
        let slack = 1e-9 * count;
        let (first, last) =
            ((from / self.step - slack).ceil() as i64, (to / self.step + slack).floor() as i64);
        let digits = self.step.to_string().split_once('.').map_or(0, |(_, digits)| digits.len());
        let tick = |k: i64| {
            let place = k as f64 * self.step;
            let text = if self.is_logarithmic {
                match place as i64 {
                    0 => "1".into(),
                    1 => "10".into(),
                    power => format!("10^{{{power}}}"),
                }
            } else if k == 0 {
                "0".into()
            } else {
                format!("{place:.digits$}")
            };
            let value = if self.is_logarithmic { 10_f64.powf(place) } else { place };
            (value, text.replace('-', "−"))
        };
        Ok((first..=last).map(tick).collect())
    }
}

/// A plot in a rectangle of a drawing. Points are given as values, (x, y).
pub struct Graph<'a> {
    drawing: &'a mut Drawing,
    frame: Rect,
    x: Axis<'a>,
    y: Axis<'a>,
}

impl<'a> Graph<'a> {
    /// A plot whose axes run along the left and the lower edge of a rectangle, px, and are drawn at once.
    ///
    /// # Errors
    /// If an axis has no ticks or too many, or a title cannot be set.
    pub fn new(drawing: &'a mut Drawing, frame: Rect, x: Axis<'a>, y: Axis<'a>) -> Result<Self, Cause> {
        let mut graph = Self { drawing, frame, x, y };
        graph.draw_axes()?;
        Ok(graph)
    }

    fn draw_axes(&mut self) -> Result<(), Cause> {
        let Rect { left, top, right, bottom } = self.frame;
        let (x, y) = (self.x, self.y);
        let axes = drawing::Axes { frame: self.frame, x: x.scale(), y: y.scale(), curves: Vec::new() };
        self.drawing.add_axes(axes);
        self.drawing.line(at(left, bottom), at(right, bottom), Stroke::Axis, Hue::Ink);
        self.drawing.line(at(left, bottom), at(left, top), Stroke::Axis, Hue::Ink);
        for (value, text) in x.ticks()? {
            let foot = at(left + x.part(value) * (right - left), bottom);
            self.drawing.line(foot, foot + at(0.0, TICK), Stroke::Axis, Hue::Ink);
            if !x.is_numbered {
                continue;
            }
            self.drawing.label_set(foot, Side::Below, TICK + 4.0, NUMBERS, &text, Role::Text(Hue::Ink))?;
        }
        for (value, text) in y.ticks()? {
            let foot = at(left, bottom - y.part(value) * (bottom - top));
            self.drawing.line(foot, foot - at(TICK, 0.0), Stroke::Axis, Hue::Ink);
            if !y.is_numbered {
                continue;
            }
            self.drawing.label_set(foot, Side::Left, TICK + 3.0, NUMBERS, &text, Role::Text(Hue::Ink))?;
        }
        for (title, is_x) in [(x.title, true), (y.title, false)] {
            if title.is_empty() {
                continue;
            }
            let label = Label::new(title, TITLES)?;
            let start = if is_x {
                at(right - label.width(), bottom + 40.0)
            } else {
                at((left - 34.0).max(2.0), top - 12.0)
            };
            self.drawing.push(Role::Text(Hue::Ink), Shape::Label(label.from_baseline(start)));
        }
        Ok(())
    }

    /// The drawing beneath.
    pub fn drawing(&mut self) -> &mut Drawing {
        self.drawing
    }

    /// Where a pair of values lies in the drawing, px.
    pub fn at(&self, value: (f64, f64)) -> Point {
        point_at(self.frame, &self.x, &self.y, value)
    }

    /// The pair of values that lies at a point of the drawing.
    pub fn value(&self, point: Point) -> (f64, f64) {
        value_at(self.frame, &self.x, &self.y, point)
    }

    /// A curve through values, cut at the frame; it ends where a value is no number.
    pub fn curve(&mut self, values: impl IntoIterator<Item = (f64, f64)>, stroke: Stroke, hue: Hue) {
        let points: Vec<Point> = values.into_iter().map(|value| self.at(value)).collect();
        let is_sound = |point: &Point| point.x.is_finite() && point.y.is_finite();
        for part in points.split(|point| !is_sound(point)) {
            for piece in clip(part, &self.frame) {
                self.drawing.polyline(&piece, stroke, hue);
            }
        }
    }

    /// A filled area between values, cut at the frame.
    pub fn area(&mut self, values: impl IntoIterator<Item = (f64, f64)>, fill: Fill, hue: Hue) {
        let Rect { left, top, right, bottom } = self.frame;
        let inside = |point: Point| at(point.x.clamp(left, right), point.y.clamp(top, bottom));
        let points = values.into_iter().map(|value| inside(self.at(value))).collect();
        self.drawing.polygon(points, fill, hue);
    }

    /// A dot of a radius, px, where its values lie inside the frame.
    pub fn dot(&mut self, value: (f64, f64), radius: f64, hue: Hue) {
        let point = self.at(value);
        if self.frame.grown(0.5).contains(point) {
            self.drawing.dot(point, radius, hue);
        }
    }

    /// A ring at a pair of values: what a hand can take hold of.
    pub fn grip(&mut self, value: (f64, f64), hue: Hue) {
        let point = self.at(value);
        self.drawing.circle(point, 3.2, Role::Area(Fill::Page, hue));
        self.drawing.circle(point, 3.2, Role::Line(Stroke::Curve, hue));
    }

    /// A line across the plot at a value of y.
    pub fn level(&mut self, y: f64, stroke: Stroke, hue: Hue) {
        self.curve([(self.x.from, y), (self.x.to, y)], stroke, hue);
    }

    /// A line up the plot at a value of x.
    pub fn upright(&mut self, x: f64, stroke: Stroke, hue: Hue) {
        self.curve([(x, self.y.from), (x, self.y.to)], stroke, hue);
    }

    /// A label beside a pair of values.
    ///
    /// # Errors
    /// [`LabelError`] if the label cannot be set.
    pub fn label(&mut self, value: (f64, f64), side: Side, text: &str, hue: Hue) -> Result<(), LabelError> {
        let point = self.at(value);
        self.drawing.label(point, side, text, hue)
    }
}

/// Where a pair of values lies in a plot with this frame and these axes, px: where its grip is.
pub fn point_at(frame: Rect, x: &Axis<'_>, y: &Axis<'_>, value: (f64, f64)) -> Point {
    at(frame.left + x.part(value.0) * frame.width(), frame.bottom - y.part(value.1) * frame.height())
}

/// The pair of values that lies at a point of a plot with this frame and these axes: what a drawn grip means.
pub fn value_at(frame: Rect, x: &Axis<'_>, y: &Axis<'_>, point: Point) -> (f64, f64) {
    let part = (point.x - frame.left) / frame.width();
    (x.value(part), y.value((frame.bottom - point.y) / frame.height()))
}

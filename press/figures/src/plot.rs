//! The house plot style.
//!
//! Axes at the left and below, ticks outward, no grid, no frame; the y title stands horizontally above its
//! axis; curves carry their labels beside them.

use crate::Cause;
use crate::axis::Ticks;
use crate::canvas::{Canvas, point, units};
use drawing::kit::{self, Marker};
use drawing::{
    Axes, Axis, Drawing, Fill, Flaw, Hue, Label, Point, Rect, Role, Scale, Shape, Side, Stroke, at, clip,
};
use plotters::coord::cartesian::{Cartesian2d, MeshLine};
use plotters::prelude::{
    BLACK, ChartBuilder, CoordTranslate, DrawingBackend, IntoDrawingArea, LabelAreaPosition,
};

/// The type size of titles, px.
const TITLE_TYPE: f64 = 14.0;
/// Lengths of major and minor ticks, px.
const MAJOR: f64 = 5.0;
const MINOR: f64 = 3.0;
/// How far outside the frame a label may belong, px: beside the end of a curve, above a line that ends at the frame.
const BESIDE: f64 = 80.0;

/// A plot in a rectangle of a drawing. Points are given as values, (x, y).
pub struct Plot<'a> {
    drawing: &'a mut Drawing,
    frame: Rect,
    x: Scale,
    y: Scale,
    /// What leads from the parts of both scales to places in the drawing.
    parts: Cartesian2d<Ticks, Ticks>,
}

impl<'a> Plot<'a> {
    /// A plot whose axes run along the left and the lower edge of a rectangle of the drawing, px. The axes
    /// are drawn at once.
    ///
    /// # Errors
    /// [`Flaw`] for an axis that cannot be, and if a title or a tick's label cannot be set.
    pub fn new(drawing: &'a mut Drawing, frame: Rect, x: Axis<'_>, y: Axis<'_>) -> Result<Self, Cause> {
        draw_axes(drawing, frame, &x, &y)?;
        draw_title(drawing, x.title, |width| at(frame.right - width, frame.bottom + 40.0))?;
        draw_title(drawing, y.title, |_| at((frame.left - 34.0).max(2.0), frame.top - 15.0))?;
        Ok(Self::in_frame(drawing, frame, &x, &y)?)
    }

    /// A plot without axes: the same values along x and along y, one unit of them `scale` px, about the point `origin`.
    ///
    /// # Errors
    /// [`Flaw`] if the reach or the scale is not a positive number.
    pub fn plane(drawing: &'a mut Drawing, origin: Point, scale: f64, reach: f64) -> Result<Self, Flaw> {
        Axis::linear(0.0, scale, scale).ticks()?;
        let half = scale * reach;
        let axis = Axis::linear(-reach, reach, reach);
        let frame = Rect::new(origin.x - half, origin.y - half, 2.0 * half, 2.0 * half);
        Self::in_frame(drawing, frame, &axis, &axis)
    }

    fn in_frame(drawing: &'a mut Drawing, frame: Rect, x: &Axis<'_>, y: &Axis<'_>) -> Result<Self, Flaw> {
        let pixels = (units(frame.left)..units(frame.right), units(frame.bottom)..units(frame.top));
        let parts = Cartesian2d::new(Ticks::of(x)?, Ticks::of(y)?, pixels);
        drawing.add_axes(Axes::new(frame, x.scale, y.scale));
        Ok(Self { drawing, frame, x: x.scale, y: y.scale, parts })
    }

    /// The drawing beneath, for what is not given by values.
    pub fn drawing(&mut self) -> &mut Drawing {
        self.drawing
    }

    /// The rectangle of the plot in the drawing, px.
    pub fn frame(&self) -> Rect {
        self.frame
    }

    /// Where a pair of values lies in the drawing, px; NaN for what has no place on these axes.
    pub fn at(&self, value: (f64, f64)) -> Point {
        self.parts_to(value).map_or(at(f64::NAN, f64::NAN), |parts| self.place(parts))
    }

    /// The place in the drawing that parts of both scales lead to, px.
    fn place(&self, parts: Point) -> Point {
        point(self.parts.translate(&(parts.x, parts.y)))
    }

    /// The parts of both scales that lead to a pair of values; none for what has no place there. Values far outside,
    /// which would leave the range of the whole numbers, come nearer: the plot cuts them at its frame anyway.
    fn parts_to(&self, (x, y): (f64, f64)) -> Option<Point> {
        let [x, y] = [self.x.part(x), self.y.part(y)];
        (x.is_finite() && y.is_finite()).then(|| at(x.clamp(-100.0, 101.0), y.clamp(-100.0, 101.0)))
    }

    /// The parts of both scales that lead to a pair of values. The drawing is refused for one that has no place there.
    fn placed(&mut self, what: &str, value: (f64, f64)) -> Option<Point> {
        let parts = self.parts_to(value);
        if parts.is_none() {
            self.drawing.refuse(Flaw::nowhere(what, value));
        }
        parts
    }

    /// Draws a line through values in pieces, cut at the frame. How many pieces there are.
    fn line(&mut self, what: &str, values: &[(f64, f64)], stroke: Stroke, hue: Hue) -> usize {
        let parts: Vec<Point> = values.iter().filter_map(|&value| self.placed(what, value)).collect();
        let pieces = clip(&parts, &Rect::new(0.0, 0.0, 1.0, 1.0));
        for piece in &pieces {
            let points: Vec<Point> = piece.iter().map(|&parts| self.place(parts)).collect();
            self.drawing.polyline(&points, stroke, hue);
        }
        pieces.len()
    }

    /// A curve through values, cut at the frame and thinned to what can be seen. Its name becomes an id; if
    /// the frame cuts it into pieces, later ones get `-2`, `-3`.
    pub fn curve(
        &mut self,
        name: &str,
        values: impl IntoIterator<Item = (f64, f64)>,
        stroke: Stroke,
        hue: Hue,
    ) {
        let values: Vec<(f64, f64)> = values.into_iter().collect();
        let what = format!("the curve {name}");
        let pieces = self.line(&what, &values, stroke, hue);
        // A series may have a single point, or none, and then no curve.
        if pieces == 0 && values.len() > 1 {
            self.drawing.refuse(Flaw::new(format!("no part of {what} lies inside the frame")));
        }
        self.drawing.name_curve(name, pieces);
    }

    /// Values joined by a thin line, each with a marker.
    pub fn series(&mut self, name: &str, values: &[(f64, f64)], form: Marker, hue: Hue) {
        self.curve(name, values.iter().copied(), Stroke::Orbit, hue);
        self.markers(values, form, hue);
    }

    /// A marker at each pair of values inside the frame.
    pub fn markers(&mut self, values: &[(f64, f64)], form: Marker, hue: Hue) {
        for &value in values {
            let frame = self.frame.grown(0.5);
            if self.placed("a marker", value).is_some() && frame.contains(self.at(value)) {
                kit::marker(self.drawing, self.at(value), form, hue);
            }
        }
    }

    /// A reference line between two pairs of values, cut at the frame.
    pub fn reference(&mut self, from: (f64, f64), to: (f64, f64), stroke: Stroke) {
        self.line("a reference line", &[from, to], stroke, Hue::Muted);
    }

    /// A reference line at a value of y, across the whole plot.
    pub fn level(&mut self, y: f64, stroke: Stroke) {
        self.reference((self.x.from, y), (self.x.to, y), stroke);
    }

    /// A reference line at a value of x, from the axis to the top of the plot.
    pub fn upright(&mut self, x: f64, stroke: Stroke) {
        self.reference((x, self.y.from), (x, self.y.to), stroke);
    }

    /// A tinted region between two corners.
    pub fn region(&mut self, from: (f64, f64), to: (f64, f64), hue: Hue) {
        let [a, c] = [self.at(from), self.at(to)];
        self.drawing.polygon(vec![a, at(c.x, a.y), c, at(a.x, c.y)], Fill::Ground, hue);
    }

    /// A label beside a pair of values, in the frame or next to it.
    ///
    /// # Errors
    /// [`Flaw`] for a text that cannot be set, and for values that lie further than 80 px from the frame.
    pub fn label(&mut self, value: (f64, f64), side: Side, text: &str, hue: Hue) -> Result<(), Flaw> {
        let point = self.at(value);
        if !self.frame.grown(BESIDE).contains(point) {
            let (x, y) = value;
            return Err(Flaw::new(format!("the label `{text}` at ({x}, {y}) lies far outside the axes")));
        }
        self.drawing.label(point, side, text, hue)
    }
}

fn draw_axes(drawing: &mut Drawing, frame: Rect, x: &Axis<'_>, y: &Axis<'_>) -> Result<(), Cause> {
    let (ticks_x, ticks_y) = (Ticks::of(x)?, Ticks::of(y)?);
    let [right, below] = [drawing.width() - frame.right, drawing.height() - frame.bottom];
    let area = Canvas { drawing, stroke: Stroke::Axis }.into_drawing_area();
    let mut chart = ChartBuilder::on(&area)
        .margin_top(units(frame.top))
        .margin_right(units(right))
        .set_label_area_size(LabelAreaPosition::Left, units(frame.left))
        .set_label_area_size(LabelAreaPosition::Bottom, units(below))
        .build_cartesian_2d(ticks_x, ticks_y)?;
    chart.configure_mesh().disable_mesh().axis_style(BLACK).set_all_tick_mark_size(units(MAJOR)).draw()?;
    // Of minor ticks plotters knows the places only.
    let length = units(MINOR);
    let minor = |canvas: &mut Canvas<'_>, line: MeshLine<'_, Ticks, Ticks>| {
        let ends = match line {
            MeshLine::XMesh(foot, ..) => [foot, (foot.0, foot.1 + length)],
            MeshLine::YMesh(foot, ..) => [foot, (foot.0 - length, foot.1)],
        };
        canvas.stroke = Stroke::Tick;
        canvas.draw_path(ends, &BLACK)
    };
    Ok(chart.plotting_area().draw_mesh(minor, 0, 0)?)
}

/// Draws the title of an axis, if it has one; its baseline starts at a place that may depend on its width.
fn draw_title(drawing: &mut Drawing, title: &str, place: impl Fn(f64) -> Point) -> Result<(), Flaw> {
    if title.is_empty() {
        return Ok(());
    }
    let label = Label::new(title, TITLE_TYPE)?;
    let start = place(label.width());
    drawing.push(Role::Text(Hue::Ink), Shape::Label(label.from_baseline(start)));
    Ok(())
}

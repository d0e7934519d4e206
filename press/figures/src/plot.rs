//! The house plot style.
//!
//! Axes at the left and below, ticks outward, no grid, no frame; the y title stands horizontally above its
//! axis; curves carry their labels beside them.

use crate::Cause;
use crate::axis::Axis;
use crate::canvas::{Canvas, pen, point, units};
use drawing::kit::{self, Marker};
use drawing::{
    Axes, Drawing, Fill, Flaw, Hue, Label, LabelError, Point, Rect, Role, Shape, Side, Stroke, at, clip,
};
use plotters::coord::cartesian::{Cartesian2d, MeshLine};
use plotters::prelude::{
    ChartBuilder, CoordTranslate, DrawingBackend, IntoDrawingArea, LabelAreaPosition, PathElement,
};

/// The type size of titles, px.
const TITLE_TYPE: f64 = 14.0;
/// Lengths of major and minor ticks, px.
const MAJOR: f64 = 5.0;
const MINOR: f64 = 3.0;

/// A plot in a rectangle of a drawing. Points are given as values, (x, y).
pub struct Plot<'a> {
    drawing: &'a mut Drawing,
    frame: Rect,
    axes: Cartesian2d<Axis, Axis>,
}

impl<'a> Plot<'a> {
    /// A plot whose axes run along the left and the lower edge of a rectangle of the drawing, px. The axes
    /// are drawn at once.
    ///
    /// # Errors
    /// [`LabelError`] if a title or a tick's label cannot be set.
    pub fn new(drawing: &'a mut Drawing, frame: Rect, x: Axis, y: Axis) -> Result<Self, Cause> {
        draw_axes(drawing, frame, &x, &y)?;
        draw_title(drawing, x.title.as_deref(), |width| at(frame.right - width, frame.bottom + 40.0))?;
        draw_title(drawing, y.title.as_deref(), |_| at((frame.left - 34.0).max(2.0), frame.top - 15.0))?;
        Ok(Self::in_frame(drawing, frame, x, y))
    }

    /// A plot without axes: the same values along x and along y, one unit of them `scale` px, about the point `origin`.
    ///
    /// # Errors
    /// [`crate::InvalidAxis`] if the reach or the scale is not a positive number.
    pub fn plane(
        drawing: &'a mut Drawing,
        origin: Point,
        scale: f64,
        reach: f64,
    ) -> Result<Self, crate::InvalidAxis> {
        Axis::linear(0.0, scale, scale)?;
        let half = scale * reach;
        let axis = Axis::linear(-reach, reach, reach)?;
        let frame = Rect::new(origin.x - half, origin.y - half, 2.0 * half, 2.0 * half);
        Ok(Self::in_frame(drawing, frame, axis.clone(), axis))
    }

    fn in_frame(drawing: &'a mut Drawing, frame: Rect, x: Axis, y: Axis) -> Self {
        drawing.add_axes(Axes { frame, x: x.scale, y: y.scale, curves: Vec::new() });
        let pixels = (units(frame.left)..units(frame.right), units(frame.bottom)..units(frame.top));
        Self { drawing, frame, axes: Cartesian2d::new(x, y, pixels) }
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
        let place = self.place(value).map(|place| point(self.axes.translate(&(place.x, place.y))));
        place.unwrap_or(at(f64::NAN, f64::NAN))
    }

    /// Where a pair of values stands on the scales.
    fn place(&self, (x, y): (f64, f64)) -> Option<Point> {
        Some(at(self.axes.x_spec().place(x)?, self.axes.y_spec().place(y)?))
    }

    /// Where a pair of values stands on the scales. The drawing is refused for one that has no place there.
    fn placed(&mut self, what: &str, value: (f64, f64)) -> Option<Point> {
        let place = self.place(value);
        if place.is_none() {
            self.drawing.refuse(Flaw::NoNumber { what: what.to_owned(), place: value });
        }
        place
    }

    /// Draws a line through values in pieces, cut at the frame, along which plotters would go on. How many
    /// pieces there are.
    fn line(&mut self, what: &str, values: &[(f64, f64)], stroke: Stroke, hue: Hue) -> usize {
        let places: Vec<Point> = values.iter().filter_map(|&value| self.placed(what, value)).collect();
        let (x, y) = (self.axes.get_x_range(), self.axes.get_y_range());
        let pieces = clip(&places, &Rect { left: x.start, top: y.start, right: x.end, bottom: y.end });
        let area = Canvas(self.drawing).into_drawing_area().apply_coord_spec(&self.axes);
        let pairs = |piece: &[Point]| piece.iter().map(|place| (place.x, place.y)).collect::<Vec<_>>();
        let drawn =
            |piece: &&Vec<Point>| area.draw(&PathElement::new(pairs(piece), pen(stroke, hue))).is_ok();
        pieces.iter().filter(drawn).count()
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
            self.drawing.refuse(Flaw::NothingToSee { what });
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
        let x = self.axes.x_spec().scale;
        self.reference((x.from, y), (x.to, y), stroke);
    }

    /// A reference line at a value of x, from the axis to the top of the plot.
    pub fn upright(&mut self, x: f64, stroke: Stroke) {
        let y = self.axes.y_spec().scale;
        self.reference((x, y.from), (x, y.to), stroke);
    }

    /// A tinted region between two corners.
    pub fn region(&mut self, from: (f64, f64), to: (f64, f64), hue: Hue) {
        let [a, c] = [self.at(from), self.at(to)];
        self.drawing.polygon(vec![a, at(c.x, a.y), c, at(a.x, c.y)], Fill::Ground, hue);
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

fn draw_axes(drawing: &mut Drawing, frame: Rect, x: &Axis, y: &Axis) -> Result<(), Cause> {
    let [right, below] = [drawing.width() - frame.right, drawing.height() - frame.bottom];
    let area = Canvas(drawing).into_drawing_area();
    let mut chart = ChartBuilder::on(&area)
        .margin_top(units(frame.top))
        .margin_right(units(right))
        .set_label_area_size(LabelAreaPosition::Left, units(frame.left))
        .set_label_area_size(LabelAreaPosition::Bottom, units(below))
        .build_cartesian_2d(x.clone(), y.clone())?;
    chart
        .configure_mesh()
        .disable_mesh()
        .axis_style(pen(Stroke::Axis, Hue::Ink))
        .set_all_tick_mark_size(units(MAJOR))
        .draw()?;
    // Of minor ticks plotters knows the places only.
    let length = units(MINOR);
    let minor = |canvas: &mut Canvas<'_>, line: MeshLine<'_, Axis, Axis>| {
        let ends = match line {
            MeshLine::XMesh(foot, ..) => [foot, (foot.0, foot.1 + length)],
            MeshLine::YMesh(foot, ..) => [foot, (foot.0 - length, foot.1)],
        };
        canvas.draw_path(ends, &pen(Stroke::Tick, Hue::Ink))
    };
    Ok(chart.plotting_area().draw_mesh(minor, 0, 0)?)
}

/// Draws the title of an axis, if it has one; its baseline starts at a place that may depend on its width.
fn draw_title(
    drawing: &mut Drawing,
    title: Option<&str>,
    place: impl Fn(f64) -> Point,
) -> Result<(), LabelError> {
    let Some(title) = title else { return Ok(()) };
    let label = Label::new(title, TITLE_TYPE)?;
    let start = place(label.width());
    drawing.push(Role::Text(Hue::Ink), Shape::Label(label.from_baseline(start)));
    Ok(())
}

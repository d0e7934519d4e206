//! The house plot style.
//!
//! Axes at the left and below, ticks outward, no grid, no frame; the y title stands horizontally above its axis; curves carry
//! their labels beside them.

use crate::axis::Axis;
use drawing::kit::{self, Marker};
use drawing::{
    Drawing, Fill, Flaw, Hue, Label, LabelError, Point, Rect, Role, Shape, Side, Stroke, at, clip,
};

/// Type sizes of ticks, and of titles and labels, px.
const TICK_TYPE: f64 = 13.0;
const TITLE_TYPE: f64 = 14.0;
/// Lengths of major and minor ticks, px.
const MAJOR: f64 = 5.0;
const MINOR: f64 = 3.0;

/// A plot in a rectangle of a drawing. Points are given as values, (x, y).
#[derive(Debug)]
pub struct Plot<'a> {
    drawing: &'a mut Drawing,
    frame: Rect,
    x: Axis,
    y: Axis,
}

impl<'a> Plot<'a> {
    /// A plot whose axes run along the left and the lower edge of a rectangle of the drawing, px. The axes are drawn at once.
    ///
    /// # Errors
    /// [`LabelError`] if a title or tick cannot be set.
    pub fn new(drawing: &'a mut Drawing, frame: Rect, x: Axis, y: Axis) -> Result<Self, LabelError> {
        let mut plot = Self { drawing, frame, x, y };
        plot.draw_axes()?;
        Ok(plot)
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
        Ok(Self { drawing, frame, x: axis.clone(), y: axis })
    }

    /// The drawing beneath, for what is not given by values.
    pub fn drawing(&mut self) -> &mut Drawing {
        self.drawing
    }

    /// The rectangle of the plot in the drawing, px.
    pub fn frame(&self) -> Rect {
        self.frame
    }

    /// Where a pair of values lies in the drawing, px.
    pub fn at(&self, (x, y): (f64, f64)) -> Point {
        at(
            self.x.place(x, self.frame.left, self.frame.right),
            self.y.place(y, self.frame.bottom, self.frame.top),
        )
    }

    /// A curve through values, cut at the frame and thinned to what can be seen. Its name becomes an id; if the frame cuts it
    /// into pieces, later ones get `-2`, `-3`.
    pub fn curve(
        &mut self,
        name: &str,
        values: impl IntoIterator<Item = (f64, f64)>,
        stroke: Stroke,
        hue: Hue,
    ) {
        let values: Vec<(f64, f64)> = values.into_iter().collect();
        let what = format!("the curve {name}");
        let points = self.placed(&what, &values);
        let pieces = clip(&points, &self.frame);
        // A series may have a single point, or none, and then no curve.
        if pieces.is_empty() && points.len() > 1 {
            self.drawing.refuse(Flaw::NothingToSee { what });
        }
        for (index, piece) in pieces.iter().enumerate() {
            self.drawing.polyline(piece, stroke, hue);
            self.drawing.name_last(&if index == 0 {
                name.to_owned()
            } else {
                format!("{name}-{}", index + 1)
            });
        }
    }

    /// Values joined by a thin line, each with a marker.
    pub fn series(&mut self, name: &str, values: &[(f64, f64)], form: Marker, hue: Hue) {
        self.curve(name, values.iter().copied(), Stroke::Orbit, hue);
        self.markers(values, form, hue);
    }

    /// A marker at each pair of values inside the frame.
    pub fn markers(&mut self, values: &[(f64, f64)], form: Marker, hue: Hue) {
        for point in self.placed("a marker", values) {
            if self.frame.grown(0.5).contains(point) {
                kit::marker(self.drawing, point, form, hue);
            }
        }
    }

    /// Where values lie in the drawing, px. The drawing is refused for one that has no place on these axes.
    fn placed(&mut self, what: &str, values: &[(f64, f64)]) -> Vec<Point> {
        let points: Vec<Point> = values.iter().map(|&value| self.at(value)).collect();
        if let Some(at) = points.iter().position(|point| !(point.x.is_finite() && point.y.is_finite())) {
            self.drawing.refuse(Flaw::NoNumber { what: what.to_owned(), place: values[at] });
        }
        points
    }

    /// A reference line between two pairs of values, cut at the frame.
    pub fn reference(&mut self, from: (f64, f64), to: (f64, f64), stroke: Stroke) {
        let ends = self.placed("a reference line", &[from, to]);
        for piece in clip(&ends, &self.frame) {
            self.drawing.push(Role::Line(stroke, Hue::Muted), Shape::Polyline(piece));
        }
    }

    /// A reference line at a value of y, across the whole plot.
    pub fn level(&mut self, y: f64, stroke: Stroke) {
        self.reference((self.x.from(), y), (self.x.to(), y), stroke);
    }

    /// A reference line at a value of x, from the axis to the top of the plot.
    pub fn upright(&mut self, x: f64, stroke: Stroke) {
        self.reference((x, self.y.from()), (x, self.y.to()), stroke);
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

    fn draw_axes(&mut self) -> Result<(), LabelError> {
        let frame = self.frame;
        let corner = at(frame.left, frame.bottom);
        self.drawing.line(corner, at(frame.right, frame.bottom), Stroke::Axis, Hue::Ink);
        self.drawing.line(corner, at(frame.left, frame.top), Stroke::Axis, Hue::Ink);
        for tick in self.x.ticks() {
            let foot = at(self.x.place(tick.value, frame.left, frame.right), frame.bottom);
            self.draw_tick(foot, at(0.0, 1.0), Side::Below, tick.label.as_deref())?;
        }
        for tick in self.y.ticks() {
            let foot = at(frame.left, self.y.place(tick.value, frame.bottom, frame.top));
            self.draw_tick(foot, at(-1.0, 0.0), Side::Left, tick.label.as_deref())?;
        }
        if let Some(title) = self.x.title.clone() {
            let label = Label::new(&title, TITLE_TYPE)?;
            let start = at(frame.right - label.width(), frame.bottom + 40.0);
            self.drawing.push(Role::Text(Hue::Ink), Shape::Label(label.from_baseline(start)));
        }
        if let Some(title) = self.y.title.clone() {
            let label = Label::new(&title, TITLE_TYPE)?;
            let start = at((frame.left - 34.0).max(2.0), frame.top - 15.0);
            self.drawing.push(Role::Text(Hue::Ink), Shape::Label(label.from_baseline(start)));
        }
        Ok(())
    }

    fn draw_tick(
        &mut self,
        foot: Point,
        out: Point,
        side: Side,
        label: Option<&str>,
    ) -> Result<(), LabelError> {
        let (length, stroke) = if label.is_some() { (MAJOR, Stroke::Axis) } else { (MINOR, Stroke::Tick) };
        self.drawing.line(foot, foot + out * length, stroke, Hue::Ink);
        let Some(text) = label.filter(|text| !text.is_empty()) else { return Ok(()) };
        // Numbers below an axis stand on one baseline, whatever their ink.
        if side == Side::Below {
            let label = Label::new(text, TICK_TYPE)?;
            let start = foot + at(-0.5 * label.width(), 20.0);
            self.drawing.push(Role::PlainText(Hue::Ink), Shape::Label(label.from_baseline(start)));
            return Ok(());
        }
        self.drawing.label_set(foot, side, MAJOR + 4.0, TICK_TYPE, text, Role::PlainText(Hue::Ink))
    }
}

//! The display list.

use crate::axis::Axes;
use crate::flaw::{self, Flaw};
use crate::label::{Label, Side};
use crate::point::{Point, Rect, at};
use crate::role::{Fill, Hue, Role, Stroke};
use crate::shape::{Item, Shape};
use crate::simplify::{TOLERANCE, simplify};

/// The type size of a label, px, and its distance from its point, px, unless told otherwise.
const SIZE: f64 = 14.0;
const GAP: f64 = 6.0;

/// A figure: shapes with roles, in the order in which they are painted.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    pub(crate) id: String,
    width: f64,
    height: f64,
    title: String,
    description: String,
    items: Vec<Item>,
    axes: Vec<Axes>,
    flaw: Option<Flaw>,
    pub(crate) panels: Vec<Drawing>,
    pub(crate) narrow: Option<Box<Drawing>>,
    pub(crate) link: Option<String>,
    pub(crate) is_framed: bool,
}

impl Drawing {
    /// An empty figure with its id (`fig:orbit`) and its full size, px.
    pub fn new(id: &str, width: f64, height: f64) -> Self {
        Self { id: id.into(), width, height, ..Self::default() }
    }

    /// The figure with the words for readers who cannot see it: a short title, and what it shows.
    #[must_use]
    pub fn titled(mut self, title: &str, description: &str) -> Self {
        self.title = title.into();
        self.description = description.into();
        self
    }

    /// The figure with all of its frame in its SVG, whatever its ink: for what moves.
    #[must_use]
    pub fn framed(mut self) -> Self {
        self.is_framed = true;
        self
    }

    /// Its id.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// Its full width, px.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Its full height, px.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// Its title.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// What it shows, in words.
    pub fn description(&self) -> &str {
        &self.description
    }

    /// The shapes, in the order in which they are painted.
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// The axes of its plots.
    pub fn axes(&self) -> &[Axes] {
        &self.axes
    }

    /// Adds the axes of a plot.
    pub fn add_axes(&mut self, axes: Axes) {
        self.axes.push(axes);
    }

    /// The rectangle of the whole figure.
    pub fn frame(&self) -> Rect {
        Rect::new(0.0, 0.0, self.width, self.height)
    }

    /// Refuses the drawing for something that could not be added to it; the first reason stays.
    pub fn refuse(&mut self, flaw: Flaw) {
        self.flaw.get_or_insert(flaw);
    }

    /// Why the drawing cannot be shown, if it cannot.
    pub(crate) fn flaw(&self) -> Option<Flaw> {
        let beside =
            |item: &Item| Flaw::new(format!("{} lies in no panel of a figure of panels", flaw::what(item)));
        let astray = self.items.first().filter(|_| !self.panels.is_empty()).map(beside);
        let below = || self.panels.iter().chain(self.narrow.as_deref()).find_map(Self::flaw);
        self.flaw.clone().or_else(|| self.items.iter().find_map(flaw::of)).or(astray).or_else(below)
    }

    /// Adds a shape.
    pub fn push(&mut self, role: Role, shape: Shape) {
        self.items.push(Item { role, shape, name: None });
    }

    /// Names the shapes that were added last, the pieces of a curve, over the axes that were: the first with
    /// the curve's name, the others with `-2`, `-3` after it.
    pub fn name_curve(&mut self, name: &str, pieces: usize) {
        let first = self.items.len().saturating_sub(pieces);
        for (item, piece) in self.items[first..].iter_mut().zip(1..) {
            let name = if piece == 1 { name.to_owned() } else { format!("{name}-{piece}") };
            if let Some(axes) = self.axes.last_mut() {
                axes.curves.push(name.clone());
            }
            item.name = Some(name);
        }
    }

    /// Moves each label that stands on an earlier one up or down, by the shorter way that leads off all of them and stays
    /// on the page. One that has no such way stays. Labels before the item of index `first` are left out: they neither
    /// move nor push. This is for pictures that move, in which names meet.
    ///
    /// ```
    /// use drawing::{Drawing, Hue, Shape, Side, at};
    /// let mut drawing = Drawing::new("two-names", 100.0, 100.0);
    /// drawing.label(at(50.0, 50.0), Side::Over, "one", Hue::Ink)?;
    /// drawing.label(at(54.0, 54.0), Side::Over, "other", Hue::Ink)?;
    /// drawing.part_labels(0);
    /// let [Shape::Label(one), Shape::Label(other)] = [0, 1].map(|k| &drawing.items()[k].shape) else { panic!() };
    /// assert!(!one.bounds.overlaps(&other.bounds) && other.bounds.top >= one.bounds.bottom);
    /// # Ok::<(), drawing::Flaw>(())
    /// ```
    pub fn part_labels(&mut self, first: usize) {
        let page = self.frame();
        let mut placed: Vec<Rect> = Vec::new();
        for item in self.items.iter_mut().skip(first) {
            let Shape::Label(label) = &mut item.shape else { continue };
            let own = label.bounds;
            let mut best = 0.0_f64;
            for other in placed.iter().filter(|other| own.overlaps(other)) {
                for step in [other.top - own.bottom - 1.0, other.bottom - own.top + 1.0] {
                    let moved = own.moved(at(0.0, step));
                    let is_free = moved.union(&page) == page && !placed.iter().any(|one| moved.overlaps(one));
                    if is_free && (best == 0.0 || step.abs() < best.abs()) {
                        best = step;
                    }
                }
            }
            label.shift(at(0.0, best));
            placed.push(label.bounds);
        }
    }

    /// A straight line.
    pub fn line(&mut self, from: Point, to: Point, stroke: Stroke, hue: Hue) {
        self.push(Role::Line(stroke, hue), Shape::Polyline(vec![from, to]));
    }

    /// A polyline, thinned to what can be seen.
    pub fn polyline(&mut self, points: &[Point], stroke: Stroke, hue: Hue) {
        let sound = points.iter().all(|point| point.is_finite());
        let points = if sound { simplify(points, TOLERANCE) } else { points.to_vec() }; // which would lose the flaw
        self.push(Role::Line(stroke, hue), Shape::Polyline(points));
    }

    /// A filled polygon.
    pub fn polygon(&mut self, points: Vec<Point>, fill: Fill, hue: Hue) {
        self.push(Role::Area(fill, hue), Shape::Polygon(points));
    }

    /// A circle, drawn as a line or filled as its role says.
    pub fn circle(&mut self, centre: Point, radius: f64, role: Role) {
        self.push(role, Shape::Circle { centre, radius });
    }

    /// A circular body: it hides what lies behind, its face is tinted, its edge is an outline.
    pub fn disc(&mut self, centre: Point, radius: f64, hue: Hue) {
        for role in
            [Role::Area(Fill::Page, hue), Role::Area(Fill::Face, hue), Role::Line(Stroke::Outline, hue)]
        {
            self.circle(centre, radius, role);
        }
    }

    /// A small filled circle that marks a point.
    pub fn dot(&mut self, centre: Point, radius: f64, hue: Hue) {
        self.circle(centre, radius, Role::Area(Fill::Solid, hue));
    }

    /// A part of a circle; angles in rad, counter-clockwise on the page.
    pub fn arc(&mut self, centre: Point, radius: f64, from: f64, sweep: f64, stroke: Stroke, hue: Hue) {
        self.push(Role::Line(stroke, hue), Shape::Arc { centre, radius, from, sweep });
    }

    /// A label of 14 px beside a point, with a rim in the colour of the page.
    pub fn label(&mut self, point: Point, side: Side, text: &str, hue: Hue) -> Result<(), Flaw> {
        self.label_set(point, side, GAP, SIZE, text, Role::Text(hue))
    }

    /// A label of 14 px beside a point, without rim: for filled faces, and where it may touch nothing.
    pub fn label_on_face(&mut self, point: Point, side: Side, text: &str, hue: Hue) -> Result<(), Flaw> {
        self.label_set(point, side, GAP, SIZE, text, Role::PlainText(hue))
    }

    /// A label of 13 px at a point, with a rim in the colour of the page: beside a plot, or where a caption would stand.
    pub fn note(&mut self, point: Point, side: Side, text: &str, hue: Hue) -> Result<(), Flaw> {
        self.label_set(point, side, 0.0, 13.0, text, Role::Text(hue))
    }

    /// A label with its distance from the point, px, its type size, px, and its role.
    pub fn label_set(
        &mut self,
        point: Point,
        side: Side,
        gap: f64,
        size: f64,
        text: &str,
        role: Role,
    ) -> Result<(), Flaw> {
        let label = Label::new(text, size)?.placed(point, side, gap);
        self.push(role, Shape::Label(label));
        Ok(())
    }
}

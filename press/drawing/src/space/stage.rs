//! A scene and how it comes onto the page.

use super::camera::Camera;
use super::curve::Curve;
use super::ink::{Ink, Stroked};
use super::order::{Body, coats};
use super::pierce::{self, Junction};
use super::solid::{Finish, Solid};
use super::vector::{Place, Vec3};
use crate::drawing::Drawing;
use crate::flaw::Flaw;
use crate::kit::Heads;
use crate::label::Label;
use crate::role::{Fill, Hue, Role, Stroke};
use crate::shape::Shape;

/// A point that is marked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Dot {
    pub(super) point: Vec3,
    /// px
    pub(super) radius: f64,
    /// Whether it is seen whatever stands before it.
    pub(super) in_front: bool,
    pub(super) hue: Hue,
}

/// A scene: solids, lines and labels in space, seen by one camera.
///
/// Everything is checked when it is added. [`Stage::write`] paints it in the right order, whatever the order
/// in which it was added: the ground, the solids from back to front, patches on them, hidden lines, the lines
/// that are seen, points, labels.
///
/// ```
/// use drawing::space::{Camera, Solid, Stage, View};
/// use drawing::{Drawing, Flaw, Hue, Role, Stroke, at};
/// let view = View {
///     target: [0.0; 3], azimuth: 0.0, elevation: 0.0, distance: 6.0, centre: at(100.0, 100.0), scale: 50.0,
/// };
/// let mut stage = Stage::new(Camera::new(view)?);
/// stage.vector([-2.0, 0.0, 0.0], [-2.0, 0.0, 1.8], Hue::Orange)?; // begins behind the sphere, ends above it
/// stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
/// let mut drawing = Drawing::new("fig:eclipse", 200.0, 200.0);
/// stage.write(&mut drawing);
/// let drawn = |stroke: Stroke| drawing.items().iter().any(|item| item.role == Role::Line(stroke, Hue::Orange));
/// assert!(drawn(Stroke::Hidden) && drawn(Stroke::Vector));
/// # Ok::<(), Flaw>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Stage {
    pub(super) camera: Camera,
    pub(super) grounds: Vec<(Role, Shape)>,
    solids: Vec<(Solid, Hue)>,
    lines: Vec<Stroked>,
    pub(super) patches: Vec<(Role, Shape)>,
    pub(super) dots: Vec<Dot>,
    pub(super) labels: Vec<(Label, Hue)>,
}

impl Stage {
    /// An empty scene.
    pub fn new(camera: Camera) -> Self {
        let (grounds, solids, lines) = (Vec::new(), Vec::new(), Vec::new());
        let (patches, dots, labels) = (Vec::new(), Vec::new(), Vec::new());
        Self { camera, grounds, solids, lines, patches, dots, labels }
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Adds a solid, in tints of a hue.
    ///
    /// # Errors
    /// [`Flaw`] also if the eye is inside it.
    pub fn solid(&mut self, solid: Solid, hue: Hue) -> Result<(), Flaw> {
        let form = solid.form();
        if self.camera.eye().is_some_and(|eye| form.contains(eye)) {
            return Err(Flaw::new(format!("the eye is inside the {}", form.name())));
        }
        form.corners().into_iter().try_for_each(|corner| self.camera.check(corner))?;
        self.solids.push((solid, hue));
        Ok(())
    }

    /// Adds a curve.
    pub fn curve(&mut self, curve: Curve, stroke: Stroke, hue: Hue) -> Result<(), Flaw> {
        self.arrow(curve, stroke, Heads::None, hue)
    }

    /// Adds a curve with arrowheads of constant size on the page: smaller on thin lines than on thick ones. A
    /// head whose tip is hidden is drawn as a pale outline. On an arrow that is short on the page, as one
    /// that points at the eye, heads shrink with it.
    pub fn arrow(&mut self, curve: Curve, stroke: Stroke, heads: Heads, hue: Hue) -> Result<(), Flaw> {
        curve.track.points.iter().try_for_each(|&point| self.camera.check(point))?;
        self.lines.push(Stroked { curve, stroke, heads, hue });
        Ok(())
    }

    /// Adds a vector: an arrow from a point to a point. Where a solid hides it, the shaft is dashed.
    pub fn vector(&mut self, from: impl Place, to: impl Place, hue: Hue) -> Result<(), Flaw> {
        self.arrow(Curve::segment(from, to)?, Stroke::Vector, Heads::End, hue)
    }

    /// Paints the scene into a drawing.
    pub fn write(&self, drawing: &mut Drawing) {
        let add = |drawing: &mut Drawing, (role, shape): &(Role, Shape)| drawing.push(*role, shape.clone());
        self.grounds.iter().for_each(|ground| add(drawing, ground));
        let junctions: Vec<Vec<Vec<Junction>>> =
            (0..self.solids.len()).map(|index| self.junctions(index)).collect();
        self.paint(drawing, &junctions);
        self.patches.iter().for_each(|patch| add(drawing, patch));
        let hides = |solid: &Solid| solid.finish != Finish::Ghost;
        let forms = self.solids.iter().map(|(solid, _)| (solid.form(), hides(solid))).collect();
        let mut ink = Ink::new(&self.camera, forms);
        for (index, ((solid, hue), junctions)) in self.solids.iter().zip(&junctions).enumerate() {
            ink.solid(index, solid, junctions, *hue);
        }
        for line in &self.lines {
            ink.line(line);
        }
        let dot = |&Dot { point, radius, in_front, hue }: &Dot| {
            let is_seen = in_front || !ink.hidden(point);
            let role = if is_seen { Role::Area(Fill::Solid, hue) } else { Role::Line(Stroke::Hidden, hue) };
            (role, Shape::Circle { centre: self.camera.land(point), radius })
        };
        let dots: Vec<(Role, Shape)> = self.dots.iter().map(dot).collect();
        ink.write(drawing);
        dots.iter().for_each(|dot| add(drawing, dot));
        for (label, hue) in &self.labels {
            let ray = self.camera.ray(label.bounds.centre());
            let covers = |(solid, _): &(Solid, Hue)| {
                solid.finish != Finish::Glass && !solid.form().spans(&ray).is_empty()
            };
            let on_solid = self.solids.iter().any(covers);
            let role = if on_solid { Role::PlainText(*hue) } else { Role::Text(*hue) };
            drawing.push(role, Shape::Label(label.clone()));
        }
    }

    /// Where a solid, if it is a rod, pierces each of the others.
    fn junctions(&self, index: usize) -> Vec<Vec<Junction>> {
        let Some(rod) = self.solids[index].0.as_rod() else { return Vec::new() };
        let others = self.solids.iter().enumerate().filter(|&(other, _)| other != index);
        others.map(|(_, (solid, _))| pierce::junctions(rod, solid.form())).collect()
    }

    /// Paints the solids from back to front.
    fn paint(&self, drawing: &mut Drawing, junctions: &[Vec<Vec<Junction>>]) {
        let bodies: Vec<Body<'_>> = self
            .solids
            .iter()
            .zip(junctions)
            .map(|((solid, _), junctions)| {
                let form = solid.form();
                let cut = solid.as_rod().map(|_| pierce::parts(junctions));
                Body { form, parts: cut.unwrap_or_else(|| form.parts()) }
            })
            .collect();
        for coat in coats(&bodies, &self.camera) {
            let (solid, hue) = &self.solids[coat.body];
            for patch in coat.patches {
                if solid.finish != Finish::Glass {
                    drawing.push(Role::Area(Fill::Page, *hue), patch.shape.unshaded());
                }
                let flat = matches!(patch.fill, Fill::Face | Fill::Side);
                let (fill, shape) = match solid.finish {
                    Finish::Glass if flat => (Fill::Glass, patch.shape),
                    Finish::Ghost => (Fill::Ghost, patch.shape.unshaded()),
                    Finish::Opaque | Finish::Glass => (patch.fill, patch.shape),
                };
                drawing.push(Role::Area(fill, *hue), shape);
            }
        }
    }
}

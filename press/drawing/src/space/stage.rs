//! A scene and how it comes onto the page.

use super::camera::Camera;
use super::curve::Curve;
use super::error::SpaceError;
use super::ground::Ground;
use super::ink::{Ink, Stroked};
use super::order::{Body, coats};
use super::pierce::{self, Junction};
use super::solid::{Finish, Solid};
use super::vector::Vec3;
use crate::drawing::Drawing;
use crate::kit::Heads;
use crate::label::Label;
use crate::point::Point;
use crate::role::{Fill, Hue, Role, Stroke};
use crate::shape::Shape;

/// A point that is marked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Dot {
    Disc(f64),
    /// A disc that is seen whatever stands before it.
    InFront(f64),
}

/// A label where it stands on the page.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Caption {
    pub(super) label: Label,
    pub(super) hue: Hue,
}

impl Dot {
    pub(super) fn write(self, drawing: &mut Drawing, centre: Point, hidden: bool, hue: Hue) {
        match self {
            Self::Disc(radius) if hidden => drawing.circle(centre, radius, Role::Line(Stroke::Hidden, hue)),
            Self::Disc(radius) | Self::InFront(radius) => drawing.dot(centre, radius, hue),
        }
    }
}

/// A scene: solids, lines and labels in space, seen by one camera.
///
/// Everything is checked when it is added. [`Stage::write`] paints it in the right order, whatever the order
/// in which it was added: the ground, the solids from back to front, patches on them, hidden lines, the lines
/// that are seen, points, labels.
///
/// ```
/// use drawing::space::{Camera, Solid, SpaceError, Stage, View};
/// use drawing::{Drawing, Hue, Role, Stroke, at};
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
/// # Ok::<(), SpaceError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Stage {
    pub(super) camera: Camera,
    grounds: Vec<Ground>,
    solids: Vec<(Solid, Hue)>,
    lines: Vec<Stroked>,
    pub(super) patches: Vec<(Vec<Vec3>, Fill, Hue)>,
    pub(super) points: Vec<(Vec3, Dot, Hue)>,
    pub(super) captions: Vec<Caption>,
}

impl Stage {
    /// An empty scene.
    pub fn new(camera: Camera) -> Self {
        let (grounds, solids, lines, patches) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (points, captions) = (Vec::new(), Vec::new());
        Self { camera, grounds, solids, lines, patches, points, captions }
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Adds a solid, in tints of a hue.
    ///
    /// # Errors
    /// [`SpaceError`] if the eye is inside it, or a part of it behind the eye.
    pub fn solid(&mut self, solid: Solid, hue: Hue) -> Result<(), SpaceError> {
        let form = solid.form();
        if self.camera.eye().is_some_and(|eye| form.contains(eye)) {
            return Err(SpaceError::EyeInside { solid: form.name() });
        }
        form.corners().into_iter().try_for_each(|corner| self.camera.check(corner))?;
        self.solids.push((solid, hue));
        Ok(())
    }

    /// Adds a curve.
    ///
    /// # Errors
    /// [`SpaceError`] if a part of it is behind the eye.
    pub fn curve(&mut self, curve: Curve, stroke: Stroke, hue: Hue) -> Result<(), SpaceError> {
        self.arrow(curve, stroke, Heads::None, hue)
    }

    /// Adds a curve with arrowheads of constant size on the page: smaller on thin lines than on thick ones. A
    /// head whose tip is hidden is drawn as a pale outline. On an arrow that is short on the page, as one
    /// that points at the eye, heads shrink with it.
    ///
    /// # Errors
    /// [`SpaceError`] if a part of it is behind the eye.
    pub fn arrow(&mut self, curve: Curve, stroke: Stroke, heads: Heads, hue: Hue) -> Result<(), SpaceError> {
        curve.track.points.iter().try_for_each(|&point| self.camera.check(point))?;
        self.lines.push(Stroked { curve, stroke, heads, hue });
        Ok(())
    }

    /// Adds a vector: an arrow from a point to a point. Where a solid hides it, the shaft is dashed.
    ///
    /// # Errors
    /// [`SpaceError`] for points that are not finite, that coincide or lie behind the eye.
    pub fn vector(
        &mut self,
        from: impl Into<[f64; 3]>,
        to: impl Into<[f64; 3]>,
        hue: Hue,
    ) -> Result<(), SpaceError> {
        self.arrow(Curve::segment(from, to)?, Stroke::Vector, Heads::End, hue)
    }

    /// Adds a horizontal piece of ground, a rectangle between two opposite corners (x, y) at a height, with
    /// grid lines every `step` from the first corner. It is painted first and hides nothing.
    ///
    /// # Errors
    /// [`SpaceError`] for numbers that are not finite, corners that enclose no area, a step that is not
    /// positive or gives more lines than can be seen, and ground behind the eye.
    pub fn ground(&mut self, from: [f64; 2], to: [f64; 2], height: f64, step: f64) -> Result<(), SpaceError> {
        self.grounds.push(Ground::new(&self.camera, from, to, height, step)?);
        Ok(())
    }

    /// Paints the scene into a drawing.
    pub fn write(&self, drawing: &mut Drawing) {
        for ground in &self.grounds {
            ground.write(&self.camera, drawing);
        }
        let junctions: Vec<Vec<Vec<Junction>>> =
            (0..self.solids.len()).map(|index| self.junctions(index)).collect();
        self.paint(drawing, &junctions);
        for (corners, fill, hue) in &self.patches {
            let corners = corners.iter().map(|&corner| self.camera.land(corner)).collect();
            drawing.polygon(corners, *fill, *hue);
        }
        let hides = |solid: &Solid| solid.finish != Finish::Ghost;
        let forms = self.solids.iter().map(|(solid, _)| (solid.form(), hides(solid))).collect();
        let mut ink = Ink::new(&self.camera, forms);
        for (index, ((solid, hue), junctions)) in self.solids.iter().zip(&junctions).enumerate() {
            ink.solid(index, solid, junctions, *hue);
        }
        for line in &self.lines {
            ink.line(line);
        }
        let dots: Vec<_> =
            self.points.iter().map(|&(point, dot, hue)| (point, ink.hidden(point), dot, hue)).collect();
        ink.write(drawing);
        for (point, hidden, dot, hue) in dots {
            dot.write(drawing, self.camera.land(point), hidden, hue);
        }
        for Caption { label, hue } in &self.captions {
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

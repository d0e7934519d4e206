//! Round solids, painted one over the other.

use live::prelude::*;
use nalgebra::Vector3;

/// A painter of round solids, one over the other: each is its far end, its side and the end that faces the eye.
pub(super) struct Painter<'a> {
    pub camera: Camera,
    pub eye: Vector3<f64>,
    /// A unit of length, px.
    pub scale: f64,
    pub drawing: &'a mut Drawing,
}

impl Painter<'_> {
    /// A cylinder from the middle of one end to the middle of the other.
    pub(super) fn cylinder(&mut self, ends: [Vector3<f64>; 2], radius: f64, hue: Hue) -> Result<(), Cause> {
        let axis = (ends[1] - ends[0]).normalize();
        let beyond = (self.eye - ends[1]).dot(&axis) > 0.0;
        let [far, near] = if beyond { ends } else { [ends[1], ends[0]] };
        let sight = self.eye - far;
        let aside = sight - axis * sight.dot(&axis);
        let (first, second) = (aside.normalize(), axis.cross(&aside.normalize()));
        let on_rim = |middle: Vector3<f64>, angle: f64| {
            self.camera.on_page(middle + (first * angle.cos() + second * angle.sin()) * radius)
        };
        let rim = |middle: Vector3<f64>| {
            // So many corners that the circle is missed by a tenth of a pixel.
            let corners = (7.0 * (radius * self.scale).sqrt()).ceil().max(10.0) as u32;
            let angles = (0..corners).map(|step| TAU * f64::from(step) / f64::from(corners));
            angles.map(|angle| on_rim(middle, angle)).collect::<Result<Vec<Point>, _>>()
        };
        let mut faces = Vec::new();
        // The side ends on both hands where the line of sight touches it; from straight above it is not seen.
        if aside.norm() > radius {
            let touch = (radius / aside.norm()).acos();
            let [left, right] = [-touch, touch];
            faces.push((rim(far)?, Fill::Side));
            let corners =
                [on_rim(far, left)?, on_rim(near, left)?, on_rim(near, right)?, on_rim(far, right)?];
            faces.push((corners.to_vec(), Fill::Side));
        }
        let faces_eye = (self.eye - near).dot(&(near - far)) > 0.0;
        faces.push((rim(near)?, if faces_eye { Fill::Face } else { Fill::Side }));
        for (corners, fill) in faces {
            self.drawing.polygon(corners.clone(), Fill::Page, hue);
            self.drawing.polygon(corners.clone(), fill, hue);
            if let [from, to, other_to, other_from] = corners[..] {
                self.drawing.line(from, to, Stroke::Outline, hue);
                self.drawing.line(other_from, other_to, Stroke::Outline, hue);
            } else {
                self.drawing.push(Role::Line(Stroke::Outline, hue), Shape::Polygon(corners));
            }
        }
        Ok(())
    }
}

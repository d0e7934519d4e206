//! Round solids, painted one over the other.

use live::prelude::*;
use nalgebra::Vector3;

/// A painter of round solids, one over the other: each is what is seen of its side, and over it the end that faces the eye.
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
        // So many corners that a circle is missed by a tenth of a pixel.
        let corners = (7.0 * (radius * self.scale).sqrt()).ceil().max(10.0);
        let mut faces = Vec::new();
        // The side ends on both hands where the line of sight touches it; from straight above it is not seen. Its fourth
        // edge is a chord of the near end, which covers it.
        if aside.norm() > radius {
            let touch = (radius / aside.norm()).acos();
            let far_edge = linear_steps(-touch, touch, (corners * touch / PI).ceil() as u32);
            let side =
                far_edge.map(|angle| on_rim(far, angle)).chain([on_rim(near, touch), on_rim(near, -touch)]);
            faces.push((side.collect::<Result<Vec<Point>, _>>()?, Fill::Side));
        }
        let faces_eye = (self.eye - near).dot(&(near - far)) > 0.0;
        let rim = linear_steps(0.0, TAU, corners as u32).skip(1).map(|angle| on_rim(near, angle));
        faces.push((rim.collect::<Result<_, _>>()?, if faces_eye { Fill::Face } else { Fill::Side }));
        for (corners, fill) in faces {
            self.drawing.polygon(corners.clone(), Fill::Page, hue);
            self.drawing.polygon(corners.clone(), fill, hue);
            self.drawing.push(Role::Line(Stroke::Outline, hue), Shape::Polygon(corners));
        }
        Ok(())
    }
}

//! The ground of a scene.

use super::camera::Camera;
use super::error::{MOST_LINES, SpaceError, finite, positive};
use super::vector::Vec3;
use crate::drawing::Drawing;
use crate::role::{Fill, Hue, Stroke};

/// A rectangle with the lines of its grid.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ground {
    corners: [Vec3; 4],
    lines: Vec<(Vec3, Vec3)>,
}

impl Ground {
    /// See [`Stage::ground`](super::Stage::ground).
    pub(super) fn new(
        camera: &Camera,
        from: [f64; 2],
        to: [f64; 2],
        height: f64,
        step: f64,
    ) -> Result<Self, SpaceError> {
        let corner = |x: f64, y: f64| finite("corner of the ground", [x, y, height]);
        let corners = [
            corner(from[0], from[1])?,
            corner(to[0], from[1])?,
            corner(to[0], to[1])?,
            corner(from[0], to[1])?,
        ];
        let step = positive("step of the grid", step)?;
        let sides = [(to[0] - from[0]).abs(), (to[1] - from[1]).abs()];
        for side in sides {
            positive("side of the ground", side)?;
        }
        if (sides[0] + sides[1]) / step > MOST_LINES {
            return Err(SpaceError::GridTooFine { lines: ((sides[0] + sides[1]) / step).ceil() });
        }
        corners.into_iter().try_for_each(|corner| camera.check(corner))?;
        let mut lines = Vec::new();
        for (side, along, across) in [
            (sides[0], corners[1] - corners[0], corners[3] - corners[0]),
            (sides[1], corners[3] - corners[0], corners[1] - corners[0]),
        ] {
            let mut reached = 0.0;
            while reached < side * (1.0 + 1e-9) {
                let foot = corners[0] + along * (reached / side);
                lines.push((foot, foot + across));
                reached += step;
            }
        }
        Ok(Self { corners, lines })
    }

    pub(super) fn write(&self, camera: &Camera, drawing: &mut Drawing) {
        drawing.polygon(self.corners.map(|corner| camera.land(corner)).to_vec(), Fill::Floor, Hue::Ink);
        for &(from, to) in &self.lines {
            drawing.line(camera.land(from), camera.land(to), Stroke::Grid, Hue::Ink);
        }
    }
}

//! The station as a wheel: rim, hub and spokes, with what is hidden of them.

use live::prelude::*;
use nalgebra::{UnitQuaternion, Vector3};

/// In radii: inner radius and half the height of the rim, radius of the hub.
const INNER: f64 = 0.86;
const HALF_HEIGHT: f64 = 0.08;
pub(super) const HUB: f64 = 0.15;

/// The station as it is seen.
pub(super) struct Wheel {
    pub(super) attitude: UnitQuaternion<f64>,
    /// The direction to the eye.
    pub(super) sight: Vector3<f64>,
}

impl Wheel {
    pub(super) fn draw(&self, camera: &Camera, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut stage = Stage::new(*camera);
        let axis = self.attitude * Vector3::z();
        stage.solid(Solid::ring([0.0; 3], axis, 1.0, INNER, 2.0 * HALF_HEIGHT)?, Hue::Blue)?;
        stage.solid(Solid::sphere([0.0; 3], HUB)?, Hue::Blue)?;
        stage.write(drawing);
        let mut spokes = Vec::new();
        for quarter in 0..4 {
            let (sin, cos) = (0.25 * TAU * (f64::from(quarter) + 0.5)).sin_cos();
            let outwards = self.attitude * Vector3::new(cos, sin, 0.0);
            let Some((from, to)) = self.seen_part(&outwards) else { continue };
            let side = outwards.cross(&self.sight).normalize() * 0.03;
            let corner = |along: f64, sign: f64| camera.on_page(outwards * along + side * sign);
            spokes.push([corner(from, 1.0)?, corner(to, 1.0)?, corner(to, -1.0)?, corner(from, -1.0)?]);
        }
        // All spokes are one element of the page, and all their edges.
        for fill in [Fill::Page, Fill::Side] {
            for corners in &spokes {
                drawing.polygon(corners.to_vec(), fill, Hue::Blue);
            }
        }
        for [a, b, c, d] in spokes {
            drawing.line(a, b, Stroke::Outline, Hue::Blue);
            drawing.line(c, d, Stroke::Outline, Hue::Blue);
        }
        Ok(())
    }

    /// Which part of a spoke is seen: not what lies behind the hub, and not that from which the line of sight meets
    /// the rim on its way through the opening of the wheel.
    fn seen_part(&self, outwards: &Vector3<f64>) -> Option<(f64, f64)> {
        let axis = self.attitude * Vector3::z();
        let (through, along) = (self.sight.dot(&axis).abs(), self.sight.dot(outwards));
        let step = (self.sight - axis * self.sight.dot(&axis)) * (HALF_HEIGHT / through);
        let middle = -step.dot(outwards);
        let half = (middle * middle - step.norm_squared() + INNER * INNER).sqrt();
        let hub = if along > 0.0 { HUB } else { HUB / (1.0 - along * along).sqrt() };
        let (from, to) = (hub.max(middle - half), INNER.min(middle + half));
        (from < to).then_some((from, to))
    }
}

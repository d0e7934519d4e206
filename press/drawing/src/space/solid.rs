//! Solids.

use super::checks::{direction, finite, no_plane, perpendicular, positive};
use super::cone::Cone;
use super::ellipsoid::Ellipsoid;
use super::form::Form;
use super::rim::Round;
use super::tube::Tube;
use super::vector::{Place, Vec3};
use crate::flaw::Flaw;
use std::f64::consts::FRAC_PI_2;

/// What a solid does to what is painted behind it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Finish {
    /// It covers it.
    #[default]
    Opaque,
    /// It tints it. Lines behind it are dashed all the same.
    Glass,
    /// A body at another time, for stills of a motion: pale, with pale edges. It covers what is painted
    /// behind it and hides no line.
    Ghost,
}

/// A solid: it hides what lies behind it.
///
/// All lengths are in units of the world. Nothing about a solid depends on the camera.
///
/// ```
/// use drawing::{Flaw, space::Solid};
/// let coin = Solid::disc([0.0, 0.0, 1.0], [0.0, 0.3, 1.0], 0.5, 0.06)?;
/// // Of an axis only the direction matters.
/// assert_eq!(coin, Solid::disc([0.0, 0.0, 1.0], [0.0, 0.6, 2.0], 0.5, 0.06)?);
/// let hollow = Solid::ring([0.0; 3], [0.0, 0.0, 1.0], 1.0, 1.2, 0.1);
/// assert_eq!(hollow, Err(Flaw::new("the hole's radius 1.2 is not less than the ring's, 1")));
/// # Ok::<(), Flaw>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    body: Body,
    /// Whether edges are dashed where another solid hides them.
    pub(super) dashed: bool,
    pub(super) finish: Finish,
}

#[derive(Debug, Clone, PartialEq)]
enum Body {
    Tube(Tube),
    Cone(Cone),
    Ellipsoid(Ellipsoid),
}

impl Solid {
    fn new(body: Body) -> Self {
        Self { body, dashed: false, finish: Finish::default() }
    }

    fn tube(name: &'static str, round: Round, [outer, inner]: [f64; 2], half: f64) -> Self {
        Self::new(Body::Tube(Tube { name, round, outer, inner, half }))
    }

    /// A disc: a coin, a plate, a wheel. Its centre is half-way through its thickness.
    pub fn disc(centre: impl Place, axis: impl Place, radius: f64, thickness: f64) -> Result<Self, Flaw> {
        let (centre, axis) = (finite("centre", centre)?, direction("axis", axis)?);
        let (outer, half) = (positive("radius", radius)?, 0.5 * positive("thickness", thickness)?);
        Ok(Self::tube("disc", Round::new(centre, axis), [outer, 0.0], half))
    }

    /// A round rod from the middle of one end to the middle of the other: a shaft, a pencil, a piston.
    pub fn rod(from: impl Place, to: impl Place, radius: f64) -> Result<Self, Flaw> {
        let (from, to) = (finite("end of the rod", from)?, finite("end of the rod", to)?);
        let axis = direction("rod", (to - from).0)?;
        let (outer, half) = (positive("radius", radius)?, 0.5 * (to - from).length());
        Ok(Self::tube("rod", Round::new(from.towards(to, 0.5), axis), [outer, 0.0], half))
    }

    /// A ring: a disc of this height with a round hole.
    ///
    /// # Errors
    /// [`Flaw`] also for a hole as wide as the ring.
    pub fn ring(
        centre: impl Place,
        axis: impl Place,
        outer: f64,
        inner: f64,
        height: f64,
    ) -> Result<Self, Flaw> {
        let (centre, axis) = (finite("centre", centre)?, direction("axis", axis)?);
        let (outer, inner) = (positive("outer radius", outer)?, positive("inner radius", inner)?);
        if inner >= outer {
            let said = format!("the hole's radius {inner} is not less than the ring's, {outer}");
            return Err(Flaw::new(said));
        }
        let half = 0.5 * positive("height", height)?;
        Ok(Self::tube("ring", Round::new(centre, axis), [outer, inner], half))
    }

    /// The open shell of a cone, without thickness, from its apex along its axis. `half_angle` (rad, between
    /// 0 and π/2) is the angle between axis and side; `length` is measured along the side, so that two cones
    /// that roll on each other touch as far as their rims if they are of one length.
    ///
    /// # Errors
    /// [`Flaw`] also for a half-angle outside its interval.
    pub fn cone(apex: impl Place, axis: impl Place, half_angle: f64, length: f64) -> Result<Self, Flaw> {
        let (apex, axis) = (finite("apex", apex)?, direction("axis", axis)?);
        finite("half-angle", [half_angle, 0.0, 0.0])?;
        if half_angle <= 0.0 || half_angle >= FRAC_PI_2 {
            let said = format!("the cone's half-angle {half_angle} rad is not between 0 and π/2");
            return Err(Flaw::new(said));
        }
        let length = positive("length", length)?;
        Ok(Self::new(Body::Cone(Cone::new(Round::new(apex, axis), half_angle, length))))
    }

    /// The half of such a cone that lies away from a direction: the other half is cut away, so that one sees into it.
    ///
    /// # Errors
    /// [`Flaw`] also for a direction along the axis.
    pub fn half_cone(
        apex: impl Place,
        axis: impl Place,
        half_angle: f64,
        length: f64,
        open: impl Place,
    ) -> Result<Self, Flaw> {
        let open = direction("opening", open)?;
        let mut solid = Self::cone(apex, axis, half_angle, length)?;
        if let Body::Cone(cone) = &mut solid.body {
            cone.open = Some(open.across(cone.round.axis).unit().ok_or_else(no_plane)?);
        }
        Ok(solid)
    }

    /// A sphere.
    pub fn sphere(centre: impl Place, radius: f64) -> Result<Self, Flaw> {
        let (centre, radii) = (finite("centre", centre)?, [positive("radius", radius)?; 3]);
        let axes = [Vec3([1.0, 0.0, 0.0]), Vec3([0.0, 1.0, 0.0]), Vec3([0.0, 0.0, 1.0])];
        Ok(Self::new(Body::Ellipsoid(Ellipsoid { name: "sphere", centre, axes, radii })))
    }

    /// An ellipsoid with its semi-axes along three perpendicular directions.
    ///
    /// # Errors
    /// [`Flaw`] also for directions that are not perpendicular.
    pub fn ellipsoid(centre: impl Place, axes: [impl Place; 3], semi_axes: [f64; 3]) -> Result<Self, Flaw> {
        let (centre, axes) = (finite("centre", centre)?, perpendicular(axes)?);
        for semi_axis in semi_axes {
            positive("semi-axis", semi_axis)?;
        }
        Ok(Self::new(Body::Ellipsoid(Ellipsoid { name: "ellipsoid", centre, axes, radii: semi_axes })))
    }

    /// The solid with its edges drawn dashed where another solid hides them, as a shaft behind a plate, and not at its
    /// own back. Otherwise only what is seen is drawn.
    #[must_use]
    pub fn dashed(self) -> Self {
        Self { dashed: true, ..self }
    }

    /// The solid with another finish.
    #[must_use]
    pub fn finish(self, finish: Finish) -> Self {
        Self { finish, ..self }
    }

    pub(super) fn form(&self) -> &dyn Form {
        match &self.body {
            Body::Tube(tube) => tube,
            Body::Cone(cone) => cone,
            Body::Ellipsoid(ellipsoid) => ellipsoid,
        }
    }

    /// The solid as a rod: a cylinder without a hole.
    pub(super) fn as_rod(&self) -> Option<&Tube> {
        match &self.body {
            Body::Tube(tube) if tube.inner == 0.0 => Some(tube),
            _ => None,
        }
    }
}

//! Solids.

use super::cone::Cone;
use super::ellipsoid::Ellipsoid;
use super::error::{SpaceError, direction, finite, perpendicular, positive};
use super::form::Form;
use super::tube::Tube;
use std::f64::consts::FRAC_PI_2;

/// Which edges are drawn dashed where they cannot be seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Edges {
    /// None: only what is seen is drawn.
    #[default]
    Seen,
    /// Those that another solid hides, as a shaft behind a plate; not those at the solid's own back.
    BehindOthers,
}

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
/// use drawing::space::{Solid, SpaceError};
/// let coin = Solid::disc([0.0, 0.0, 1.0], [0.0, 0.3, 1.0], 0.5, 0.06)?;
/// // Of an axis only the direction matters.
/// assert_eq!(coin, Solid::disc([0.0, 0.0, 1.0], [0.0, 0.6, 2.0], 0.5, 0.06)?);
/// let hollow = Solid::ring([0.0; 3], [0.0, 0.0, 1.0], 1.0, 1.2, 0.1);
/// assert_eq!(hollow, Err(SpaceError::HoleTooWide { inner: 1.2, outer: 1.0 }));
/// # Ok::<(), SpaceError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    body: Body,
    pub(super) edges: Edges,
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
        Self { body, edges: Edges::default(), finish: Finish::default() }
    }

    /// A disc: a coin, a plate, a wheel. Its centre is half-way through its thickness.
    ///
    /// # Errors
    /// [`SpaceError`] for numbers that are not finite, an axis without length, a radius or thickness that is
    /// not positive.
    pub fn disc(
        centre: impl Into<[f64; 3]>,
        axis: impl Into<[f64; 3]>,
        radius: f64,
        thickness: f64,
    ) -> Result<Self, SpaceError> {
        let (centre, axis) = (finite("centre", centre)?, direction("axis", axis)?);
        let radii = [positive("radius", radius)?, 0.0];
        let half = 0.5 * positive("thickness", thickness)?;
        Ok(Self::new(Body::Tube(Tube::new("disc", centre, axis, radii, half))))
    }

    /// A round rod from the middle of one end to the middle of the other: a shaft, a pencil, a piston.
    ///
    /// # Errors
    /// [`SpaceError`] for numbers that are not finite, ends that coincide, a radius that is not positive.
    pub fn rod(from: impl Into<[f64; 3]>, to: impl Into<[f64; 3]>, radius: f64) -> Result<Self, SpaceError> {
        let (from, to) = (finite("end of the rod", from)?, finite("end of the rod", to)?);
        let axis = direction("rod", (to - from).0)?;
        let radii = [positive("radius", radius)?, 0.0];
        let half = 0.5 * (to - from).length();
        Ok(Self::new(Body::Tube(Tube::new("rod", from.towards(to, 0.5), axis, radii, half))))
    }

    /// A ring: a disc of this height with a round hole.
    ///
    /// # Errors
    /// [`SpaceError`] for numbers that are not finite, an axis without length, a radius or height that is not
    /// positive, and a hole as wide as the ring.
    pub fn ring(
        centre: impl Into<[f64; 3]>,
        axis: impl Into<[f64; 3]>,
        outer: f64,
        inner: f64,
        height: f64,
    ) -> Result<Self, SpaceError> {
        let (centre, axis) = (finite("centre", centre)?, direction("axis", axis)?);
        let (outer, inner) = (positive("outer radius", outer)?, positive("inner radius", inner)?);
        if inner >= outer {
            return Err(SpaceError::HoleTooWide { inner, outer });
        }
        let half = 0.5 * positive("height", height)?;
        Ok(Self::new(Body::Tube(Tube::new("ring", centre, axis, [outer, inner], half))))
    }

    /// The open shell of a cone, without thickness, from its apex along its axis. `half_angle` (rad, between
    /// 0 and π/2) is the angle between axis and side; `length` is measured along the side, so that two cones
    /// that roll on each other touch as far as their rims if they are of one length.
    ///
    /// # Errors
    /// [`SpaceError`] for numbers that are not finite, an axis without length, a half-angle outside its
    /// interval, a length that is not positive.
    pub fn cone(
        apex: impl Into<[f64; 3]>,
        axis: impl Into<[f64; 3]>,
        half_angle: f64,
        length: f64,
    ) -> Result<Self, SpaceError> {
        let (apex, axis) = (finite("apex", apex)?, direction("axis", axis)?);
        if !half_angle.is_finite() {
            return Err(SpaceError::NotFinite { what: "half-angle" });
        }
        if half_angle <= 0.0 || half_angle >= FRAC_PI_2 {
            return Err(SpaceError::HalfAngle { value: half_angle });
        }
        let length = positive("length", length)?;
        Ok(Self::new(Body::Cone(Cone::new(apex, axis, half_angle, length))))
    }

    /// The half of such a cone that lies away from a direction: the other half is cut away, so that one sees into it.
    ///
    /// # Errors
    /// [`SpaceError`] as for [`Solid::cone`], and for a direction along the axis.
    pub fn half_cone(
        apex: impl Into<[f64; 3]>,
        axis: impl Into<[f64; 3]>,
        half_angle: f64,
        length: f64,
        open: impl Into<[f64; 3]>,
    ) -> Result<Self, SpaceError> {
        let open = direction("opening", open)?;
        let mut solid = Self::cone(apex, axis, half_angle, length)?;
        if let Body::Cone(cone) = &mut solid.body {
            cone.open = Some(open.across(cone.axis).unit().ok_or(SpaceError::NoPlane)?);
        }
        Ok(solid)
    }

    /// A sphere.
    ///
    /// # Errors
    /// [`SpaceError`] for numbers that are not finite and a radius that is not positive.
    pub fn sphere(centre: impl Into<[f64; 3]>, radius: f64) -> Result<Self, SpaceError> {
        let radii = [positive("radius", radius)?; 3];
        let axes = perpendicular([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?;
        let centre = finite("centre", centre)?;
        Ok(Self::new(Body::Ellipsoid(Ellipsoid { name: "sphere", centre, axes, radii })))
    }

    /// An ellipsoid with its semi-axes along three perpendicular directions.
    ///
    /// # Errors
    /// [`SpaceError`] for numbers that are not finite, directions without length or not perpendicular, and a
    /// semi-axis that is not positive.
    pub fn ellipsoid(
        centre: impl Into<[f64; 3]>,
        axes: [impl Into<[f64; 3]>; 3],
        semi_axes: [f64; 3],
    ) -> Result<Self, SpaceError> {
        let (centre, axes) = (finite("centre", centre)?, perpendicular(axes)?);
        for semi_axis in semi_axes {
            positive("semi-axis", semi_axis)?;
        }
        Ok(Self::new(Body::Ellipsoid(Ellipsoid { name: "ellipsoid", centre, axes, radii: semi_axes })))
    }

    /// The solid with its hidden edges drawn dashed, or not.
    #[must_use]
    pub fn edges(self, edges: Edges) -> Self {
        Self { edges, ..self }
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

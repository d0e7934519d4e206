//! Bodies of even density and simple shape.

use super::moments::PrincipalMoments;
use super::tensor::InertiaTensor;
use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::Vector3;

/// A body: its mass, and its principal moments about its centre of mass. An axis of symmetry is axis 3.
/// One whose inertia is a matrix, with products of inertia, is made by [`InertiaTensor::new`].
///
/// ```
/// use mechanics::inertia::{Body, Cylinder};
/// // A flat disc is twice as hard to spin about its axis as to turn over (eq:perpendicular-axes) ...
/// let disc = Body::thin_disk(1.0, 0.2)?.moments().as_symmetric()?;
/// assert_eq!(disc.axial, 2.0 * disc.transverse);
/// // ... and a cylinder √3 times as long as its radius is like a ball: all its moments are equal.
/// let cylinder = Cylinder { radius: 0.2, height: 0.2 * 3_f64.sqrt() };
/// let round = Body::cylinder(1.0, cylinder)?.moments().as_symmetric()?;
/// assert!((round.transverse / round.axial - 1.0).abs() < 1e-15);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    mass: f64,
    moments: PrincipalMoments,
}

/// The size of a ring of rectangular section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// Radius of the hole, m, zero or more.
    pub inner_radius: f64,
    /// Radius, m, more than that of the hole.
    pub outer_radius: f64,
    /// Height along the axis, m, zero or more.
    pub height: f64,
}

/// The size of a round rod or a disc of any thickness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    /// Radius a, m, more than zero: a rod without thickness would have no moment about itself, and its spin no meaning.
    pub radius: f64,
    /// Height h along the axis, m, zero or more.
    pub height: f64,
}

/// The size of a spheroid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spheroid {
    /// Radius a of the equator, m, more than zero.
    pub equatorial_radius: f64,
    /// Distance b of the poles from the centre, m, more than zero.
    pub polar_radius: f64,
}

impl Body {
    /// A body with its mass, kg, and its principal moments about the centre of mass.
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless the mass is positive, finite and of a size that can be computed with.
    pub fn new(mass: f64, moments: PrincipalMoments) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check_positive("mass", mass, "kg")?;
        Ok(Self { mass, moments })
    }

    /// A thin hoop of mass, kg, and radius, m: `½ma²`, `½ma²`, `ma²`.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule, and so for every shape below.
    pub fn hoop(mass: f64, radius: f64) -> Result<Self, InvalidQuantity> {
        length("radius", radius)?;
        Self::symmetric(mass, 0.5 * radius * radius, radius * radius)
    }

    /// A ring of mass, kg: with the radii b and a and the height h `m((a² + b²)/4 + h²/12)` across its axis and
    /// `½m(a² + b²)` about it.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn ring(mass: f64, ring: Ring) -> Result<Self, InvalidQuantity> {
        let Ring { inner_radius, outer_radius, height } = ring;
        length("outer radius", outer_radius)?;
        InvalidQuantity::check_not_negative("inner radius", inner_radius, "m")?;
        InvalidQuantity::check_not_negative("height", height, "m")?;
        let rule = Rule::LessThan(outer_radius);
        InvalidQuantity::require(inner_radius < outer_radius, "inner radius", inner_radius, "m", rule)?;
        let squares = inner_radius * inner_radius + outer_radius * outer_radius;
        Self::symmetric(mass, 0.25 * squares + height * height / 12.0, 0.5 * squares)
    }

    /// A thin disc of mass, kg, and radius, m: `¼ma²`, `¼ma²`, `½ma²`.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn thin_disk(mass: f64, radius: f64) -> Result<Self, InvalidQuantity> {
        Self::cylinder(mass, Cylinder { radius, height: 0.0 })
    }

    /// A cylinder of mass, kg: `m(a²/4 + h²/12)` across its axis, `½ma²` about it.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn cylinder(mass: f64, Cylinder { radius, height }: Cylinder) -> Result<Self, InvalidQuantity> {
        length("radius", radius)?;
        InvalidQuantity::check_not_negative("height", height, "m")?;
        let square = radius * radius;
        Self::symmetric(mass, 0.25 * square + height * height / 12.0, 0.5 * square)
    }

    /// A ball of mass, kg, and radius, m: `⅖ma²` about every axis.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn sphere(mass: f64, radius: f64) -> Result<Self, InvalidQuantity> {
        length("radius", radius)?;
        Self::spheroid(mass, Spheroid { equatorial_radius: radius, polar_radius: radius })
    }

    /// A thin spherical shell of mass, kg, and radius, m: `⅔ma²` about every axis.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn shell(mass: f64, radius: f64) -> Result<Self, InvalidQuantity> {
        length("radius", radius)?;
        let square = radius * radius / 1.5;
        Self::symmetric(mass, square, square)
    }

    /// A block of mass, kg, with edges along axes 1, 2 and 3, m.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn cuboid(mass: f64, edges: [f64; 3]) -> Result<Self, InvalidQuantity> {
        for edge in edges {
            length("edge", edge)?;
        }
        let [a, b, c] = edges.map(|edge| edge * edge / 12.0);
        Self::per_mass(mass, [b + c, a + c, a + b])
    }

    /// A spheroid of even density and mass, kg: `⅕m(a² + b²)` across its axis, `⅖ma²` about it.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn spheroid(mass: f64, spheroid: Spheroid) -> Result<Self, InvalidQuantity> {
        let Spheroid { equatorial_radius, polar_radius } = spheroid;
        length("equatorial radius", equatorial_radius)?;
        length("polar radius", polar_radius)?;
        let [a, b] = [equatorial_radius * equatorial_radius, polar_radius * polar_radius];
        Self::symmetric(mass, (a + b) / 5.0, a / 2.5)
    }

    /// Mass, kg.
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Principal moments about the centre of mass.
    #[must_use]
    pub fn moments(&self) -> PrincipalMoments {
        self.moments
    }

    /// The inertia about the point at `displacement` from the centre of mass, m, both along the body's axes: Steiner's
    /// theorem (`eq:steiner`).
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the displacement is not finite or too large to compute with.
    pub fn about(&self, displacement: &Vector3<f64>) -> Result<InertiaTensor, InvalidQuantity> {
        for component in displacement {
            InvalidQuantity::check("displacement", *component, "m")?;
        }
        Ok(InertiaTensor::principal(self.moments).shifted(self.mass, displacement))
    }

    fn symmetric(mass: f64, transverse: f64, axial: f64) -> Result<Self, InvalidQuantity> {
        Self::per_mass(mass, [transverse, transverse, axial])
    }

    fn per_mass(mass: f64, squares: [f64; 3]) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check_positive("mass", mass, "kg")?;
        let [about_1, about_2, about_3] = squares.map(|square| mass * square);
        Self::new(mass, PrincipalMoments::new(about_1, about_2, about_3)?)
    }
}

fn length(quantity: &'static str, value: f64) -> Result<f64, InvalidQuantity> {
    InvalidQuantity::check_positive(quantity, value, "m")
}

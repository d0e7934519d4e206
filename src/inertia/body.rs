//! Bodies of even density and simple shape.

use super::moments::PrincipalMoments;
use super::tensor::InertiaTensor;
use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::{Rotation3, Vector3};

/// A body: its mass, and its principal moments about its centre of mass. Where it has an axis of symmetry, that is axis 3.
///
/// ```
/// use mechanics::inertia::Body;
/// // A flat disc is twice as hard to spin about its axis as to turn over (eq:perpendicular-axes) ...
/// let [across, _, along] = Body::thin_disk(1.0, 0.2)?.moments().to_array();
/// assert_eq!(along, 2.0 * across);
/// // ... and a cylinder √3 times as long as its radius is like a ball: all its moments are equal.
/// let [across, _, along] = Body::thick_disk(1.0, 0.2, 0.2 * 3_f64.sqrt())?.moments().to_array();
/// assert!((across / along - 1.0).abs() < 1e-15);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    mass: f64,
    moments: PrincipalMoments,
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
    /// [`InvalidQuantity`] unless both are positive, and so for every shape below.
    pub fn hoop(mass: f64, radius: f64) -> Result<Self, InvalidQuantity> {
        length("radius", radius)?;
        Self::symmetric(mass, 0.5 * radius * radius, radius * radius)
    }

    /// A ring of rectangular section: mass, kg, inner and outer radius, m, and height along the axis, m, which may be zero.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for bad numbers, and if the inner radius is not less than the outer.
    pub fn ring(
        mass: f64,
        inner_radius: f64,
        outer_radius: f64,
        height: f64,
    ) -> Result<Self, InvalidQuantity> {
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
        Self::thick_disk(mass, radius, 0.0)
    }

    /// A disc of mass, kg, radius, m, and thickness, m, which may be zero: `m(a²/4 + h²/12)` across, `½ma²` along.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn thick_disk(mass: f64, radius: f64, thickness: f64) -> Result<Self, InvalidQuantity> {
        length("radius", radius)?;
        InvalidQuantity::check_not_negative("thickness", thickness, "m")?;
        let square = radius * radius;
        Self::symmetric(mass, 0.25 * square + thickness * thickness / 12.0, 0.5 * square)
    }

    /// A ball of mass, kg, and radius, m: `⅖ma²` about every axis.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn sphere(mass: f64, radius: f64) -> Result<Self, InvalidQuantity> {
        Self::spheroid(mass, radius, radius)
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

    /// A round rod of mass, kg, length, m, and radius, m, all more than zero: a rod without thickness would have no moment
    /// about itself, and its spin no meaning.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn rod(mass: f64, rod_length: f64, radius: f64) -> Result<Self, InvalidQuantity> {
        length("length", rod_length)?;
        Self::thick_disk(mass, radius, rod_length)
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

    /// A spheroid of even density: mass, kg, equatorial radius a and polar radius c, m: `⅕m(a² + c²)` across, `⅖ma²` along.
    ///
    /// # Errors
    /// As [`Body::hoop`].
    pub fn spheroid(mass: f64, equatorial_radius: f64, polar_radius: f64) -> Result<Self, InvalidQuantity> {
        length("equatorial radius", equatorial_radius)?;
        length("polar radius", polar_radius)?;
        let [a, c] = [equatorial_radius * equatorial_radius, polar_radius * polar_radius];
        Self::symmetric(mass, (a + c) / 5.0, a / 2.5)
    }

    /// Mass, kg.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Principal moments about the centre of mass.
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

    /// The inertia about the centre of mass along other axes: `other_from_body` takes components along the body's axes to
    /// components along the others.
    pub fn along(&self, other_from_body: &Rotation3<f64>) -> InertiaTensor {
        InertiaTensor::principal(self.moments).rotated(other_from_body)
    }

    fn symmetric(mass: f64, across: f64, axial: f64) -> Result<Self, InvalidQuantity> {
        Self::per_mass(mass, [across, across, axial])
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

//! What rolls, and on what.

use crate::quantity::{InvalidQuantity, Rule};

/// The moments of inertia about the centre over mass times radius squared: I₁ = `transverse`·ma², I₃ = `axial`·ma².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MomentFactors {
    /// I₁, about any diameter: positive.
    pub transverse: f64,
    /// I₃, about the axle: positive, and at most twice the transverse one.
    pub axial: f64,
}

impl MomentFactors {
    /// A thin hoop.
    pub const HOOP: Self = Self::flat(1.0);
    /// A uniform thin disc.
    pub const DISK: Self = Self::flat(0.5);

    /// A body all in one plane, with this k about its axle and half of it about a diameter.
    #[must_use]
    pub const fn flat(k: f64) -> Self {
        Self { transverse: 0.5 * k, axial: k }
    }
}

/// A disk on a level table.
///
/// ```
/// use mechanics::rolling::{DiskParameters, MomentFactors};
/// use mechanics::scenes::rolling_wheel::Wheel;
/// // A coin of 7.5 g that stands still presses on the table with its weight.
/// let (mass, radius, gravity) = (0.0075, 0.0116, 9.81);
/// let coin = Wheel::new(DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity })?;
/// let weight = coin.normal_force(&mechanics::rolling::Rolling::UPRIGHT);
/// assert_eq!(format!("{:.1} mN", 1e3 * weight), "73.6 mN");
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiskParameters {
    /// The mass m, kg: positive.
    pub mass: f64,
    /// The radius a, m: positive.
    pub radius: f64,
    /// The moments of inertia over ma².
    pub moments: MomentFactors,
    /// g, m/s²: positive.
    pub gravity: f64,
}

/// A disk that can be, on a film of air or none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Disk {
    pub(crate) parameters: DiskParameters,
    /// K of `eq:film-torque`.
    pub(crate) film: f64,
}

impl Disk {
    /// A disk with the film's number K, zero for none.
    pub(crate) fn new(parameters: DiskParameters, film: f64) -> Result<Self, InvalidQuantity> {
        let DiskParameters { mass, radius, moments: MomentFactors { transverse, axial }, gravity } =
            parameters;
        InvalidQuantity::check_positive("mass", mass, "kg")?;
        InvalidQuantity::check_positive("radius", radius, "m")?;
        InvalidQuantity::check_positive("transverse moment factor", transverse, "")?;
        InvalidQuantity::check_positive("axial moment factor", axial, "")?;
        let flat = Rule::NotAbove { what: "twice the transverse one", limit: 2.0 * transverse };
        InvalidQuantity::require(axial <= 2.0 * transverse, "axial moment factor", axial, "", flat)?;
        InvalidQuantity::check_positive("gravity", gravity, "m/s²")?;
        InvalidQuantity::check_not_negative("film number K", film, "")?;
        Ok(Self { parameters, film })
    }

    /// √(a/g), s, in which the series count.
    pub(crate) fn unit_of_time(&self) -> f64 {
        (self.parameters.radius / self.parameters.gravity).sqrt()
    }
}

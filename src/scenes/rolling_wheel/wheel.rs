//! The wheel: what it is made of.

use crate::conical::Conical;
use crate::quantity::{InvalidQuantity, Rule};
use std::error::Error;
use std::fmt;

/// A thin, round wheel on a level table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wheel {
    pub(super) mass: f64,
    pub(super) radius: f64,
    pub(super) factor: f64,
    pub(super) gravity: f64,
    pub(super) conical: Conical,
}

impl Wheel {
    /// A wheel of mass, kg, and radius, m, with the moments `k m a²` about its axis and half of it about a diameter, under
    /// `gravity`, m/s²; `factor` is k, more than zero and at most one.
    ///
    /// # Errors
    /// [`InvalidWheel`] if a number breaks its rule.
    pub fn new(mass: f64, radius: f64, factor: f64, gravity: f64) -> Result<Self, InvalidWheel> {
        InvalidQuantity::check_positive("mass", mass, "kg")?;
        InvalidQuantity::check_positive("radius", radius, "m")?;
        InvalidQuantity::check_positive("moment factor k", factor, "")?;
        InvalidQuantity::require(factor <= 1.0, "moment factor k", factor, "", Rule::AtMost(1.0))?;
        InvalidQuantity::check_positive("gravity", gravity, "m/s²")?;
        let conical = Conical::new(2.0 / (1.0 + factor)); // eq:legendre
        Ok(Self { mass, radius, factor, gravity, conical })
    }

    /// A hoop, k = 1, of mass, kg, and radius, m, under 9.81 m/s².
    ///
    /// # Errors
    /// As [`Wheel::new`].
    pub fn hoop(mass: f64, radius: f64) -> Result<Self, InvalidWheel> {
        Self::new(mass, radius, 1.0, 9.81)
    }

    /// A uniform disc, k = ½, of mass, kg, and radius, m, under 9.81 m/s².
    ///
    /// # Errors
    /// As [`Wheel::new`].
    pub fn disk(mass: f64, radius: f64) -> Result<Self, InvalidWheel> {
        Self::new(mass, radius, 0.5, 9.81)
    }

    /// Mass, kg.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Radius a, m.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The moment factor k.
    pub fn factor(&self) -> f64 {
        self.factor
    }

    /// g, m/s².
    pub fn gravity(&self) -> f64 {
        self.gravity
    }
}

/// A wheel that cannot be, or a state of it that cannot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InvalidWheel(InvalidQuantity);

impl From<InvalidQuantity> for InvalidWheel {
    fn from(error: InvalidQuantity) -> Self {
        Self(error)
    }
}

impl fmt::Display for InvalidWheel {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(out)
    }
}

impl Error for InvalidWheel {}

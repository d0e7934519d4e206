//! Pistons round the shaft.

use crate::quantity::{InvalidQuantity, Rule};
use std::ops::RangeInclusive;

/// A sum over so many pistons takes less than a tenth of a millisecond.
const MOST_PISTONS: u32 = 1000;

/// Pistons of equal mass, evenly spaced round the shaft, their rods pressed against the plate.
///
/// Piston n of N stands at the azimuth `2πn/N − π/2`. They are numbered from 1 to N ([`Pistons::numbers`]), and as
/// their circle is closed N + 1 is the first again. A rod's end keeps its distance from the shaft and stays on the
/// plate's middle plane; a thick plate adds a constant length, which changes nothing.
///
/// ```
/// use mechanics::scenes::wobble_plate::{Engine, PistonParameters, Pistons, Plate, PlateParameters};
/// let pistons = Pistons::new(PistonParameters { count: 5, mass: 0.4, distance: 0.05, rod: 0.1 })?;
/// let plate = PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.01, tilt: 15_f64.to_radians() };
/// let engine = Engine::new(Plate::new(plate)?, pistons);
/// // At 100 rad/s the first piston is fastest where the rim of the plate is level: r ω tan α.
/// let fastest = (0..360).map(|degree| engine.velocity(1, f64::from(degree).to_radians(), 100.0)).fold(0.0, f64::max);
/// assert_eq!(format!("{fastest:.2} m/s"), "1.34 m/s");
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pistons(PistonParameters);

/// How many pistons there are, and where.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PistonParameters {
    /// How many, N, from one to a thousand.
    pub count: u32,
    /// The mass m of each, kg, zero or more.
    pub mass: f64,
    /// Their distance r from the shaft, m, more than zero.
    pub distance: f64,
    /// How far their centres lie below the rods' ends, ℓ, m, zero or more.
    pub rod: f64,
}

impl Pistons {
    /// The pistons.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: PistonParameters) -> Result<Self, InvalidQuantity> {
        let PistonParameters { count, mass, distance, rod } = parameters;
        let number =
            |holds, rule| InvalidQuantity::require(holds, "number of pistons", f64::from(count), "", rule);
        number(count >= 1, Rule::AtLeast(1.0))?;
        number(count <= MOST_PISTONS, Rule::AtMost(f64::from(MOST_PISTONS)))?;
        InvalidQuantity::check_not_negative("piston mass", mass, "kg")?;
        InvalidQuantity::check_positive("distance of the pistons", distance, "m")?;
        InvalidQuantity::check_not_negative("rod length", rod, "m")?;
        Ok(Self(parameters))
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> u32 {
        self.0.count
    }

    /// Their numbers, 1 to N.
    #[must_use]
    pub fn numbers(&self) -> RangeInclusive<u32> {
        1..=self.0.count
    }

    /// The mass of each, kg.
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.0.mass
    }

    /// Their distance from the shaft, m.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.0.distance
    }

    /// How far their centres lie below the rods' ends, m.
    #[must_use]
    pub fn rod(&self) -> f64 {
        self.0.rod
    }

    /// The same with another mass each, kg.
    ///
    /// # Errors
    /// As [`Pistons::new`].
    pub fn with_mass(self, mass: f64) -> Result<Self, InvalidQuantity> {
        Self::new(PistonParameters { mass, ..self.0 })
    }
}

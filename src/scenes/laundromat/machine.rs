//! The machine: six numbers, checked once, and the constants that follow from them.

use crate::quantity::Shown;
use crate::two_part::TwoPart;
use nalgebra::Complex;
use std::error::Error;
use std::fmt;
use std::ops::RangeInclusive;

/// What a washing machine is made of, in SI units.
///
/// The six numbers become a [`Machine`] through [`Machine::new`], which checks them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// Mass of the drum M, kg; zero or more.
    pub drum_mass: f64,
    /// Mass of the load m, kg; zero or more.
    pub load_mass: f64,
    /// Distance a of the load from the shaft, m; zero or more.
    pub load_radius: f64,
    /// Stiffness k of the suspension, N/m; more than zero.
    pub stiffness: f64,
    /// Damping γ of the suspension, kg/s, acting on the whole velocity of the shaft; zero or more.
    pub damping: f64,
    /// Angular velocity Ω of the drum, rad/s, counter-clockwise if positive. Any sign, or zero.
    pub spin: f64,
}

/// A washing machine that can exist.
///
/// Made by [`Machine::new`]. Both senses of spin are allowed, and so are no spin, no damping, no load and a
/// drum without mass (if there is a load).
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, Parameters};
/// let parameters = Parameters {
///     drum_mass: 28.0, load_mass: 2.0, load_radius: 0.25,
///     stiffness: 3000.0, damping: 90.0, spin: 30.0,
/// };
/// let machine = Machine::new(parameters)?;
/// // Moving mass from the drum to the load leaves the natural frequency alone and moves the centre of mass.
/// let heavier_load = Machine::new(Parameters { drum_mass: 26.0, load_mass: 4.0, ..parameters })?;
/// assert_eq!(heavier_load.natural_frequency(), machine.natural_frequency());
/// assert_eq!(heavier_load.offset(), 2.0 * machine.offset());
/// # Ok::<(), mechanics::scenes::laundromat::InvalidMachine>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Machine {
    parameters: Parameters,
    total_mass: TwoPart,
    stiffness_rate: TwoPart, // ω₀²
    damping_rate: TwoPart,   // Γ
    natural_frequency: f64,
    offset: f64,
}

/// Masses, frequencies, rates and lengths that the library computes with, in SI units. Squares, fourth powers
/// and products of such numbers neither overflow nor underflow.
const RANGE: RangeInclusive<f64> = 1e-50..=1e50;

impl Machine {
    /// Checks the parameters and derives the constants.
    ///
    /// # Errors
    /// [`InvalidMachine`] if a parameter is not finite, is negative where it may not be, if there is no mass or
    /// no stiffness, or if a mass, the radius, ω₀, b, Γ or |Ω| is outside 1e-50 to 1e50 in SI units without being zero.
    pub fn new(parameters: Parameters) -> Result<Self, InvalidMachine> {
        let Parameters { drum_mass, load_mass, load_radius, stiffness, damping, spin } = parameters;
        for (quantity, value, unit, either_sign) in [
            ("drum mass", drum_mass, "kg", false),
            ("load mass", load_mass, "kg", false),
            ("load radius", load_radius, "m", false),
            ("stiffness", stiffness, "N/m", false),
            ("damping", damping, "kg/s", false),
            ("spin", spin, "rad/s", true),
        ] {
            if !value.is_finite() {
                return Err(InvalidMachine::NotFinite { quantity, value, unit });
            }
            if value < 0.0 && !either_sign {
                return Err(InvalidMachine::Negative { quantity, value, unit });
            }
        }
        if stiffness == 0.0 {
            return Err(InvalidMachine::NoStiffness);
        }
        if drum_mass == 0.0 && load_mass == 0.0 {
            return Err(InvalidMachine::NoMass);
        }
        for (quantity, value, unit) in [
            ("drum mass", drum_mass, "kg"),
            ("load mass", load_mass, "kg"),
            ("load radius", load_radius, "m"),
        ] {
            if value > 0.0 {
                within_range(quantity, value, unit)?;
            }
        }
        let mass = drum_mass + load_mass;
        within_range("natural frequency ω₀", (stiffness / mass).sqrt(), "rad/s")?;
        if load_mass > 0.0 && load_radius > 0.0 {
            within_range("offset b of the centre of mass", load_mass / mass * load_radius, "m")?;
        }
        if damping > 0.0 {
            within_range("damping rate Γ", damping / mass, "1/s")?;
        }
        if spin != 0.0 {
            within_range("spin", spin, "rad/s")?;
        }

        // Now that nothing can overflow, the same to 32 digits.
        let total_mass = TwoPart::sum(drum_mass, load_mass);
        let stiffness_rate = TwoPart::from(stiffness) / total_mass;
        let natural_frequency = stiffness_rate.rounded().sqrt(); // eq:natural-frequency
        let offset = (TwoPart::from(load_mass) / total_mass * load_radius).rounded(); // eq:offset
        let damping_rate = TwoPart::from(damping) / total_mass; // eq:damping-rate
        Ok(Self { parameters, total_mass, stiffness_rate, damping_rate, natural_frequency, offset })
    }

    /// The same machine at another spin, rad/s.
    ///
    /// # Errors
    /// As [`Machine::new`].
    pub fn with_spin(self, spin: f64) -> Result<Self, InvalidMachine> {
        Self::new(Parameters { spin, ..self.parameters })
    }

    /// The same machine with other damping γ, kg/s.
    ///
    /// # Errors
    /// As [`Machine::new`].
    pub fn with_damping(self, damping: f64) -> Result<Self, InvalidMachine> {
        Self::new(Parameters { damping, ..self.parameters })
    }

    /// The parameters that the machine was made from.
    pub fn parameters(&self) -> Parameters {
        self.parameters
    }

    /// Angular velocity Ω of the drum, rad/s.
    pub fn spin(&self) -> f64 {
        self.parameters.spin
    }

    /// Mass of drum and load, kg.
    pub fn total_mass(&self) -> f64 {
        self.total_mass.rounded()
    }

    /// Natural frequency ω₀ of the suspended machine, rad/s (`eq:natural-frequency`).
    pub fn natural_frequency(&self) -> f64 {
        self.natural_frequency
    }

    /// Distance b from the shaft to the centre of mass of drum and load, m (`eq:offset`).
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// Damping rate Γ, 1/s (`eq:damping-rate`). Disturbances of a lightly damped machine decay as
    /// e<sup>−Γt/2</sup>.
    pub fn damping_rate(&self) -> f64 {
        self.damping_rate.rounded()
    }

    /// The direction e<sup>iΩt</sup> from the shaft to the load at time `t` in seconds.
    ///
    /// Sixteen digits at any time up to 1e150 s in size: the product Ωt is formed without rounding before whole turns are taken
    /// off. NaN for a time that is not finite, or so large that the product overflows.
    pub fn load_direction(&self, t: f64) -> Complex<f64> {
        let (sin, cos) = TwoPart::product(self.parameters.spin, t).sin_cos();
        Complex::new(cos, sin)
    }

    /// ω₀², 1/s², to 32 digits.
    pub(super) fn stiffness_rate(&self) -> TwoPart {
        self.stiffness_rate
    }

    /// Γ, 1/s, to 32 digits.
    pub(super) fn precise_damping_rate(&self) -> TwoPart {
        self.damping_rate
    }

    /// κ = ω₀² − Ω², 1/s², without loss near resonance.
    pub(super) fn detuning(&self) -> f64 {
        self.precise_detuning().rounded()
    }

    /// κ = ω₀² − Ω², 1/s², to 32 digits of ω₀².
    pub(super) fn precise_detuning(&self) -> TwoPart {
        self.stiffness_rate - TwoPart::product(self.spin(), self.spin())
    }
}

fn within_range(quantity: &'static str, value: f64, unit: &'static str) -> Result<(), InvalidMachine> {
    if RANGE.contains(&value.abs()) {
        return Ok(());
    }
    Err(InvalidMachine::OutOfRange { quantity, value, unit })
}

/// Why a set of parameters is not a machine of this world.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvalidMachine {
    /// A parameter is infinite or not a number.
    NotFinite {
        /// Which one.
        quantity: &'static str,
        /// What was given.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// A parameter that must be zero or more is negative.
    Negative {
        /// Which one.
        quantity: &'static str,
        /// What was given.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// Drum and load both have no mass.
    NoMass,
    /// The stiffness is zero.
    NoStiffness,
    /// A parameter or a constant that follows from them is too large or too small to compute with.
    OutOfRange {
        /// Which one.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
}

impl fmt::Display for InvalidMachine {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { quantity, value, unit } => {
                write!(out, "{quantity} {value} {unit} is not a finite number")
            }
            Self::Negative { quantity, value, unit } => {
                write!(out, "{quantity} {} {unit} is negative; it must be zero or more", Shown(value))
            }
            Self::NoMass => write!(out, "drum mass 0 kg and load mass 0 kg: a machine has mass"),
            Self::NoStiffness => {
                write!(out, "stiffness 0 N/m: without a spring nothing holds the machine in place")
            }
            Self::OutOfRange { quantity, value, unit } => write!(
                out,
                "{quantity} {} {unit} is outside the range from {:e} to {:e} {unit} in size that is computed with",
                Shown(value),
                RANGE.start(),
                RANGE.end()
            ),
        }
    }
}

impl Error for InvalidMachine {}

//! The machine: six numbers, checked once, and the constants that follow from them.

use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// What a washing machine is made of, in SI units.
///
/// The six numbers become a [`Machine`] through [`Machine::new`], which checks them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MachineParameters {
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

/// What is wrong with a damping, kg/s, whose rate, the damping over the mass, cannot be computed with.
pub(super) const DAMPING_RATE: &str =
    "over the mass of drum and load it gives a damping rate outside 1e-50 to 1e50 1/s";

/// A washing machine that can exist.
///
/// Made by [`Machine::new`]. Both senses of spin are allowed, and so are no spin, no damping, no load and a
/// drum without mass (if there is a load).
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, MachineParameters};
/// let parameters = MachineParameters {
///     drum_mass: 28.0, load_mass: 2.0, load_radius: 0.25,
///     stiffness: 3000.0, damping: 90.0, spin: 30.0,
/// };
/// let machine = Machine::new(parameters)?;
/// // Moving mass from the drum to the load leaves the natural frequency alone and moves the centre of mass.
/// let heavier_load = Machine::new(MachineParameters { drum_mass: 26.0, load_mass: 4.0, ..parameters })?;
/// assert_eq!(heavier_load.natural_frequency(), machine.natural_frequency());
/// assert_eq!(heavier_load.offset(), 2.0 * machine.offset());
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Machine {
    parameters: MachineParameters,
    total_mass: TwoPart,
    stiffness_rate: TwoPart, // ω₀²
    damping_rate: TwoPart,   // Γ
    natural_frequency: f64,
    offset: f64,
}

impl Machine {
    /// Checks the parameters and derives the constants.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a parameter is not finite, is negative where it may not be, if there is no mass or
    /// no stiffness, or if a mass, the radius, ω₀, b, Γ or |Ω| is outside 1e-50 to 1e50 in SI units without being zero.
    pub fn new(parameters: MachineParameters) -> Result<Self, InvalidQuantity> {
        let MachineParameters { drum_mass, load_mass, load_radius, stiffness, damping, spin } = parameters;
        InvalidQuantity::check_not_negative("drum mass", drum_mass, "kg")?;
        InvalidQuantity::check_not_negative("load mass", load_mass, "kg")?;
        InvalidQuantity::check_not_negative("load radius", load_radius, "m")?;
        InvalidQuantity::check("spin", spin, "rad/s")?;
        // Of stiffness and damping it is their ratios to the mass that must be in range.
        InvalidQuantity::require_finite("stiffness", stiffness, "N/m")?;
        InvalidQuantity::require(stiffness > 0.0, "stiffness", stiffness, "N/m", Rule::Positive)?;
        InvalidQuantity::require_finite("damping", damping, "kg/s")?;
        InvalidQuantity::require(damping >= 0.0, "damping", damping, "kg/s", Rule::NotNegative)?;
        let mass = drum_mass + load_mass;
        InvalidQuantity::require(mass > 0.0, "mass of drum and load", mass, "kg", Rule::Positive)?;
        let because =
            "over the mass of drum and load it gives a natural frequency ω₀ outside 1e-50 to 1e50 rad/s";
        let natural = (stiffness / mass).sqrt();
        InvalidQuantity::require_computable(natural, "stiffness", stiffness, "N/m", because)?;
        let because = "with these masses it gives an offset b of the centre of mass outside 1e-50 to 1e50 m";
        let computable = InvalidQuantity::is_computable(load_mass / mass * load_radius);
        InvalidQuantity::require(computable, "load radius", load_radius, "m", Rule::Because(because))?;
        InvalidQuantity::require_computable(damping / mass, "damping", damping, "kg/s", DAMPING_RATE)?;

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
    pub fn with_spin(self, spin: f64) -> Result<Self, InvalidQuantity> {
        Self::new(MachineParameters { spin, ..self.parameters })
    }

    /// The same machine with other damping γ, kg/s.
    ///
    /// # Errors
    /// As [`Machine::new`].
    pub fn with_damping(self, damping: f64) -> Result<Self, InvalidQuantity> {
        Self::new(MachineParameters { damping, ..self.parameters })
    }

    /// The parameters that the machine was made from.
    #[must_use]
    pub fn parameters(&self) -> MachineParameters {
        self.parameters
    }

    /// Angular velocity Ω of the drum, rad/s.
    #[must_use]
    pub fn spin(&self) -> f64 {
        self.parameters.spin
    }

    /// Mass of drum and load, kg.
    #[must_use]
    pub fn total_mass(&self) -> f64 {
        self.total_mass.rounded()
    }

    /// Natural frequency ω₀ of the suspended machine, rad/s (`eq:natural-frequency`).
    #[must_use]
    pub fn natural_frequency(&self) -> f64 {
        self.natural_frequency
    }

    /// Distance b from the shaft to the centre of mass of drum and load, m (`eq:offset`).
    #[must_use]
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// Damping rate Γ, 1/s (`eq:damping-rate`). Disturbances of a lightly damped machine decay as
    /// e<sup>−Γt/2</sup>.
    #[must_use]
    pub fn damping_rate(&self) -> f64 {
        self.damping_rate.rounded()
    }

    /// The direction e<sup>iΩt</sup> from the shaft to the load at `time`, s.
    ///
    /// Sixteen digits at any time: the product Ωt is formed without rounding before whole turns are taken off. NaN
    /// for a time that is not finite, or so large that the product overflows.
    #[must_use]
    pub fn load_direction(&self, time: f64) -> Complex<f64> {
        direction(TwoPart::product(self.parameters.spin, time))
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

/// e<sup>iφ</sup> of an angle of 32 digits.
pub(super) fn direction(angle: TwoPart) -> Complex<f64> {
    let (sin, cos) = angle.sin_cos();
    Complex::new(cos, sin)
}

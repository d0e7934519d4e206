//! Steady motion: the circle that remains when everything else has died out.

use super::machine::Machine;
use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// The steady motion z = Z e<sup>iΩt</sup>: the shaft goes round O once for each turn of the drum.
///
/// From [`Machine::steady`]. All quantities but the slope are accurate to eight units in the last place at
/// any spin, near resonance too; a torque or power beyond the largest `f64` is infinite.
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, MachineParameters};
/// let machine = Machine::new(MachineParameters {
///     drum_mass: 28.0, load_mass: 2.0, load_radius: 0.25,
///     stiffness: 3000.0, damping: 90.0, spin: 30.0,
/// })?;
/// // The suspension alone holds the centre of mass on its circle: (m + M) Ω² r_cm = r₀ |k + iγΩ|.
/// let steady = machine.steady()?;
/// let needed = 30.0 * 30.0_f64.powi(2) * steady.centre_of_mass_radius();
/// let given = steady.radius() * 3000.0_f64.hypot(90.0 * 30.0);
/// assert!((needed / given - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyMotion {
    amplitude: Complex<f64>,
    centre_of_mass_amplitude: Complex<f64>,
    radius: f64,
    phase: f64,
    centre_of_mass_radius: f64,
    motor_torque: f64,
    motor_torque_slope: f64,
    motor_power: f64,
}

/// The spin at which the steady circle is largest, and its radius there (`eq:peak`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// The spin Ω at the peak, rad/s, taken as positive.
    pub spin: f64,
    /// r₀ there, m.
    pub radius: f64,
}

impl Machine {
    /// The steady motion at this machine's spin.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if there is no damping and the spin is exactly the natural frequency
    /// √(k/(m+M)) of the parameters, compared to 32 digits: then the motion grows without end.
    pub fn steady(&self) -> Result<SteadyMotion, InvalidQuantity> {
        let endless = "the damping is 0 and this is the natural frequency, so the motion grows without end";
        let bounded = self.detuning() != 0.0 || self.damping_rate() != 0.0;
        InvalidQuantity::require(bounded, "spin", self.spin(), "rad/s", Rule::Because(endless))?;
        Ok(self.steady_circle())
    }

    /// As [`Machine::steady`], for a machine that is known to have a steady motion.
    pub(super) fn steady_circle(&self) -> SteadyMotion {
        let [spin, offset] = [self.spin(), self.offset()];
        if spin == 0.0 {
            return SteadyMotion::at_rest(offset);
        }
        // Every term is taken over Ω², so that none is out of range, and ω₀² − Ω² is formed from 32 digits.
        let spin_squared = TwoPart::product(spin, spin);
        let detuning = (self.precise_detuning() / spin_squared).rounded(); // (ω₀² − Ω²)/Ω²
        let stiffness = (self.stiffness_rate() / spin_squared).rounded(); // ω₀²/Ω²
        let drag = self.damping_rate() / spin; // ΓΩ/Ω²
        let size = detuning.hypot(drag); // D/Ω²
        let turned_back = Complex::new(detuning, -drag) / size; // e^{−iφ₀}, eq:steady-phase
        let radius = offset / size; // eq:steady-radius
        let motor_torque = self.parameters().damping * radius * radius * spin; // eq:steady-torque
        // eq:torque-slope, its fraction over Ω⁴ above and below.
        let fraction = (4.0 * detuning - 2.0 * drag * drag) / (size * size);
        SteadyMotion {
            amplitude: radius * turned_back, // eq:steady-amplitude
            centre_of_mass_amplitude: offset * (Complex::new(stiffness, drag) / size * turned_back),
            radius,
            phase: drag.atan2(detuning),
            centre_of_mass_radius: offset * (stiffness.hypot(drag) / size), // eq:centre-of-mass-radius
            motor_torque,
            motor_torque_slope: motor_torque / spin * (5.0 + fraction),
            motor_power: motor_torque * spin,
        }
    }

    /// The spin with the largest steady circle, and that circle's radius (`eq:peak`).
    ///
    /// `None` if there is no such spin: with Γ ≥ √2 ω₀ the radius grows with the spin towards b, and without damping
    /// it has no bound. The machine's own spin does not matter. Accurate to eight units in the last place, also
    /// where the peak moves off to infinite spin.
    #[must_use]
    pub fn peak(&self) -> Option<Peak> {
        let [natural, damping] = [self.natural_frequency(), self.damping_rate()];
        // 2ω₀² − Γ² to 32 digits, of which 16 are left when the peak moves off to infinite spin.
        let (square, rate) = (self.stiffness_rate(), self.precise_damping_rate());
        let below = (square * 2.0 - rate * rate).rounded();
        if damping == 0.0 || below <= 0.0 {
            return None;
        }
        let spin = square.rounded() * (2.0 / below).sqrt();
        let half_ratio = 0.5 * damping / natural;
        let radius = self.offset() * (natural / damping) / ((1.0 - half_ratio) * (1.0 + half_ratio)).sqrt();
        Some(Peak { spin, radius })
    }
}

impl SteadyMotion {
    /// A drum that does not turn: the shaft at O, the centre of mass where the load holds it.
    fn at_rest(offset: f64) -> Self {
        Self {
            amplitude: Complex::new(0.0, 0.0),
            centre_of_mass_amplitude: offset.into(),
            radius: 0.0,
            phase: 0.0,
            centre_of_mass_radius: offset,
            motor_torque: 0.0,
            motor_torque_slope: 0.0,
            motor_power: 0.0,
        }
    }

    /// Complex amplitude Z = r₀ e<sup>−iφ₀</sup> of the shaft, m (`eq:steady-amplitude`).
    #[must_use]
    pub fn amplitude(&self) -> Complex<f64> {
        self.amplitude
    }

    /// Complex amplitude Z + b of the centre of mass, m, computed without forming that sum.
    #[must_use]
    pub fn centre_of_mass_amplitude(&self) -> Complex<f64> {
        self.centre_of_mass_amplitude
    }

    /// Radius r₀ of the shaft's circle, m (`eq:steady-radius`).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Angle φ₀ by which the load leads the shaft, rad (`eq:steady-phase`): from 0 to π for positive spin, from −π to
    /// 0 for negative spin, of which everything is the mirror image.
    #[must_use]
    pub fn phase(&self) -> f64 {
        self.phase
    }

    /// Radius of the circle of the centre of mass, m (`eq:centre-of-mass-radius`), with full relative accuracy at
    /// high spin, where it tends to bΓ/Ω (`eq:high-spin`).
    #[must_use]
    pub fn centre_of_mass_radius(&self) -> f64 {
        self.centre_of_mass_radius
    }

    /// Torque that the motor must give, N·m (`eq:steady-torque`): constant, and in the sense of the spin.
    #[must_use]
    pub fn motor_torque(&self) -> f64 {
        self.motor_torque
    }

    /// How the torque changes with the spin, dτ/dΩ, N·m·s (`eq:torque-slope`), to twelve units in the last place of the
    /// largest of its three terms.
    #[must_use]
    pub fn motor_torque_slope(&self) -> f64 {
        self.motor_torque_slope
    }

    /// Power that the motor gives and the dampers turn into heat, W.
    #[must_use]
    pub fn motor_power(&self) -> f64 {
        self.motor_power
    }
}

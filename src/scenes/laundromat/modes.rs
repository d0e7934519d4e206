//! Small disturbances of the steady motion, in radius and angle.

use super::machine::Machine;
use super::oscillator::Oscillator;
use nalgebra::{Complex, Matrix4};

/// A disturbance ε = ε₀ e<sup>iωt</sup>, δ = δ₀ e<sup>iωt</sup> of r = r₀(1 + ε), θ = Ωt − φ₀ + δ (`eq:perturbation`,
/// `eq:mode-ansatz`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode {
    /// ω, rad/s: its real part is the frequency, its imaginary part the rate of decay (`eq:mode-frequencies`).
    pub frequency: Complex<f64>,
    /// δ₀/ε₀, which is +i or −i at any spin (`eq:mode-shape`).
    pub shape: Complex<f64>,
}

impl Machine {
    /// The four modes, in the order Ω + ω₁, Ω − ω₁, −Ω + ω₁, −Ω − ω₁ of the real parts of ω.
    ///
    /// With heavy damping ω₁ is +i√(Γ²/4 − ω₀²), so the first and third decay fast, the second and fourth slowly; the
    /// slow rate keeps its sixteen digits however heavy the damping (`eq:slow-root`). A mode and its mirror image
    /// ω → −ω* describe the same real motion. For negative spin the list is the same with that Ω.
    pub fn modes(&self) -> [Mode; 4] {
        let spin = self.spin();
        let free = Oscillator::new(self.precise_damping_rate(), self.stiffness_rate());
        // e^{iωt} with ω = ±Ω + ν, where e^{iνt} is a free motion of the suspension.
        let [upper, lower] = free.frequencies();
        let [ahead, behind] = [Complex::new(0.0, 1.0), Complex::new(0.0, -1.0)];
        [
            Mode { frequency: spin + upper, shape: ahead },
            Mode { frequency: spin + lower, shape: ahead },
            Mode { frequency: -spin + upper, shape: behind },
            Mode { frequency: -spin + lower, shape: behind },
        ]
    }

    /// The linearised polar equations as a matrix, d/dt (ε, ε̇, δ, δ̇) = A (ε, ε̇, δ, δ̇) (`eq:linear-radial`,
    /// `eq:linear-azimuthal`). Its eigenvalues are i times the frequencies of [`Machine::modes`]. SI units.
    ///
    /// Where the steady motion is rest at O, or there is none, ε and δ mean nothing and the matrix is the limit that
    /// it has as spin and load approach such a machine's.
    pub fn stability_matrix(&self) -> Matrix4<f64> {
        let [detuning, damping] = [self.detuning(), self.damping_rate()];
        let [coriolis, drag] = [2.0 * self.spin(), damping * self.spin()];
        Matrix4::new(
            0.0, 1.0, 0.0, 0.0, //
            -detuning, -damping, drag, coriolis, //
            0.0, 0.0, 0.0, 1.0, //
            -drag, -coriolis, -detuning, -damping,
        )
    }

    /// As [`Machine::stability_matrix`], for a machine whose damper resists only ṙ
    /// (`eq:radial-damping-quartic` is its characteristic polynomial).
    ///
    pub fn radial_damping_matrix(&self) -> Matrix4<f64> {
        let [detuning, damping] = [self.detuning(), self.damping_rate()];
        let coriolis = 2.0 * self.spin();
        Matrix4::new(
            0.0, 1.0, 0.0, 0.0, //
            -detuning, -damping, 0.0, coriolis, //
            0.0, 0.0, 0.0, 1.0, //
            0.0, -coriolis, -detuning, 0.0,
        )
    }
}

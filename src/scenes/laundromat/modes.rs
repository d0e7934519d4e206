//! Small disturbances of the steady motion, in radius and angle.

use super::machine::Machine;
use super::oscillator::Oscillator;
use nalgebra::{Complex, Matrix4};

/// A disturbance ε = ε₀ e<sup>iωt</sup>, δ = δ₀ e<sup>iωt</sup> of r = r₀(1 + ε), θ = Ωt − φ₀ + δ (`eq:perturbation`,
/// `eq:mode-ansatz`).
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, MachineParameters};
/// let (drum_mass, load_mass, load_radius) = (28.0, 2.0, 0.25);
/// let (stiffness, damping, spin) = (3000.0, 90.0, 30.0);
/// let made = MachineParameters { drum_mass, load_mass, load_radius, stiffness, damping, spin };
/// let machine = Machine::new(made)?; // 10 rad/s by itself, turned at 30
/// // Seen from the drum, the slowest disturbance swings with 30 − ω₁ and dies with half the damping rate.
/// let slow = machine.modes()[1].frequency;
/// assert_eq!(format!("{:.2} rad/s, {:.2} 1/s", slow.re, slow.im), "20.11 rad/s, 1.50 1/s");
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
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
    #[must_use]
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
    #[must_use]
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
    #[must_use]
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

    /// The largest real part of the eigenvalues of [`Machine::radial_damping_matrix`], 1/s: the rate at which a small
    /// disturbance grows in the end, or dies out if it is negative. Good to a ten-millionth of the fastest of the
    /// machine's rates.
    #[must_use]
    pub fn radial_damping_growth(&self) -> f64 {
        let [detuning, damping] = [self.detuning(), self.damping_rate()];
        let square = 2.0 * detuning + 4.0 * self.spin() * self.spin();
        // All eigenvalues lie left of a shift if the quartic of `eq:radial-damping-quartic`, shifted, has
        // only roots with negative real parts (Routh and Hurwitz).
        let all_lie_left_of = |s: f64| {
            let cubic = 4.0 * s + damping;
            let quadratic = (6.0 * s + 3.0 * damping) * s + square;
            let linear = ((4.0 * s + 3.0 * damping) * s + 2.0 * square) * s + damping * detuning;
            let constant = (((s + damping) * s + square) * s + damping * detuning) * s + detuning * detuning;
            cubic > 0.0
                && constant > 0.0
                && linear > 0.0
                && cubic * quadratic * linear > linear * linear + cubic * cubic * constant
        };
        // The mean of the real parts is −Γ/4; none exceeds twice the sum of the rates.
        let fastest = damping + self.spin().abs() + detuning.abs().sqrt();
        let [mut low, mut high] = [-0.25 * damping, 4.0 * fastest];
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if all_lie_left_of(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        0.5 * (low + high)
    }
}

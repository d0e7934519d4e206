//! The machine with friction on board: a damper that turns with the drum, beside the one that stands on the floor.

use super::machine::{DAMPING_RATE, Machine};
use super::oscillator::mean_exponential;
use super::shaft::Shaft;
use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::Complex;

/// A machine with a second damper that turns with the drum, about O: it resists what a rider on board sees of the
/// shaft's velocity, with the force −γᵢ(ż − iΩz).
///
/// From [`Machine::rotor`]. The equation of motion is `eq:whirl-motion`,
///
/// ```text
/// z̈ + (Γ + Γᵢ) ż + (ω₀² − i Γᵢ Ω) z = b Ω² e^{iΩt}
/// ```
///
/// The steady circle is that of the machine without this damper, [`Machine::steady`]: on board it is rest.
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, MachineParameters};
/// let machine = Machine::new(MachineParameters {
///     drum_mass: 28.0, load_mass: 2.0, load_radius: 0.25,
///     stiffness: 3000.0, damping: 90.0, spin: 30.0,
/// })?;
/// // Half as much friction on board as on the floor: at the threshold, ω₀(1 + 2), a whirl neither grows nor dies out.
/// let rotor = machine.rotor(45.0)?;
/// assert_eq!(rotor.whirl_spin(), Some(30.0));
/// assert_eq!(rotor.growth(), 0.0);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotor {
    machine: Machine,
    damping_on_board: f64,    // γᵢ
    on_board: f64,            // Γᵢ
    half_damping: f64,        // β = (Γ + Γᵢ)/2
    stiffness: Complex<f64>,  // ω₀² − iΓᵢΩ
    half_split: Complex<f64>, // q: the roots are −β ± q, Re q ≥ 0
}

impl Machine {
    /// The same machine with a damper on board of γᵢ, kg/s, beside its own.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if γᵢ is not finite or is negative, or Γᵢ is outside 1e-50 to 1e50 in SI units without being
    /// zero.
    pub fn rotor(&self, damping_on_board: f64) -> Result<Rotor, InvalidQuantity> {
        InvalidQuantity::check_not_negative("damping on board", damping_on_board, "kg/s")?;
        let rate = damping_on_board / self.total_mass();
        InvalidQuantity::require_computable(
            rate,
            "damping on board",
            damping_on_board,
            "kg/s",
            DAMPING_RATE,
        )?;
        let on_board = damping_on_board / self.total_mass();
        let natural = self.natural_frequency();
        let half_damping = 0.5 * (self.damping_rate() + on_board);
        let stiffness = Complex::new(natural * natural, -on_board * self.spin());
        // q² = β² − ω₀² + iΓᵢΩ, eq:whirl-roots. Of the two parts of q the larger comes first.
        let square = (half_damping - natural) * (half_damping + natural);
        let size = square.hypot(stiffness.im);
        let larger = (0.5 * (size + square.abs())).sqrt();
        let smaller = if larger > 0.0 { 0.5 * stiffness.im.abs() / larger } else { 0.0 };
        let (re, im) = if square > 0.0 { (larger, smaller) } else { (smaller, larger) };
        let half_split = Complex::new(re, im.copysign(self.spin()));
        Ok(Rotor { machine: *self, damping_on_board, on_board, half_damping, stiffness, half_split })
    }
}

impl Rotor {
    /// The machine without the damper on board.
    #[must_use]
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The same machine at another spin, rad/s.
    ///
    /// # Errors
    /// As [`Machine::new`] and [`Machine::rotor`].
    pub fn with_spin(&self, spin: f64) -> Result<Self, InvalidQuantity> {
        self.machine.with_spin(spin)?.rotor(self.damping_on_board)
    }

    /// The rate Γᵢ of the damper on board, 1/s.
    #[must_use]
    pub fn damping_rate_on_board(&self) -> f64 {
        self.on_board
    }

    /// The spin ω₀(1 + Γ/Γᵢ), rad/s, beyond which every disturbance grows, in either sense of turning
    /// (`eq:whirl-threshold`). `None` without friction on board: then there is none. The machine's own spin does not
    /// matter.
    #[must_use]
    pub fn whirl_spin(&self) -> Option<f64> {
        let natural = self.machine.natural_frequency();
        (self.on_board > 0.0).then(|| natural + natural * (self.machine.damping_rate() / self.on_board))
    }

    /// The rate at which a disturbance grows in the end, 1/s; negative if it dies out (`eq:whirl-growth`).
    ///
    /// Formed so that its sign is right near the threshold, where ρ and β are almost equal, and that it is zero there.
    #[must_use]
    pub fn growth(&self) -> f64 {
        let (drive, natural) =
            ((self.on_board * self.machine.spin()).abs(), self.machine.natural_frequency());
        let [drag, split] = [2.0 * self.half_damping, self.half_split.re];
        if drag == 0.0 {
            return 0.0;
        }
        // Γᵢ²Ω² − ω₀²(Γ + Γᵢ)², as a product.
        let excess = (drive - natural * drag) / (split + self.half_damping);
        0.25 * excess * ((drive + natural * drag) / (split * split + natural * natural))
    }

    /// The roots λ of the free motions e<sup>λt</sup>, 1/s: that of [`Rotor::growth`] first, which goes round with the
    /// drum, then the other (`eq:whirl-roots`).
    #[must_use]
    pub fn roots(&self) -> [Complex<f64>; 2] {
        let q = self.half_split;
        [Complex::new(self.growth(), q.im), Complex::new(-self.half_damping - q.re, -q.im)]
    }

    /// Rates of `[x, y, ẋ, ẏ]` at `time`, s (`eq:whirl-motion`). SI units, frame of the laboratory.
    #[must_use]
    pub fn cartesian_rates(&self, time: f64, state: &[f64; 4]) -> [f64; 4] {
        let (&[x, y, vx, vy], spin) = (state, self.machine.spin());
        let [_, _, ax, ay] = self.machine.cartesian_rates(time, state);
        [vx, vy, ax - self.on_board * (vx + spin * y), ay - self.on_board * (vy - spin * x)]
    }

    /// The motion that starts at time zero with the shaft as given and the load at azimuth zero.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a component of the start is not finite or is beyond 1e50 m or m/s.
    pub fn transient(&self, start: Shaft) -> Result<RotorMotion, InvalidQuantity> {
        start.check_start()?;
        let detuning = self.roots()[0] - Complex::new(0.0, self.machine.spin());
        if detuning.norm() < NEAR * self.machine.natural_frequency() {
            return Ok(RotorMotion { rotor: *self, circle: None, free: start });
        }
        let circle = self.machine.steady_circle().amplitude();
        let turning = Complex::new(0.0, self.machine.spin());
        let free = Shaft { position: start.position - circle, velocity: start.velocity - circle * turning };
        Ok(RotorMotion { rotor: *self, circle: Some(circle), free })
    }

    /// The free motion from a start, at a time, s.
    fn free(&self, start: &Shaft, time: f64) -> Shaft {
        let Shaft { position, velocity } = *start;
        // e^{−βt} cosh qt and e^{−βt} sinh(qt)/q, the growing exponential taken out.
        let left = mean_exponential(self.half_split * (-2.0 * time)); // of e^{−2qt'}
        let [root, _] = self.roots();
        let factor = Complex::from_polar((root.re * time).exp(), root.im * time);
        let slope = left * time;
        let even = 1.0 - self.half_split * slope;
        Shaft {
            position: factor * (position * even + (velocity + position * self.half_damping) * slope),
            velocity: factor
                * (velocity * even - (velocity * self.half_damping + position * self.stiffness) * slope),
        }
    }

    /// What the force has made of a shaft at rest by a time, s, with the load in this direction (`eq:build-up`).
    fn built_up(&self, load: Complex<f64>, time: f64) -> Shaft {
        let turning = Complex::new(0.0, self.machine.spin());
        let roots = self.roots();
        let done = roots.map(|root| load * mean_exponential((root - turning) * time) * time);
        let push = self.machine.offset() * self.machine.spin().powi(2) / (2.0 * self.half_split);
        Shaft {
            position: push * (done[0] - done[1]),
            velocity: push * (roots[0] * done[0] - roots[1] * done[1]),
        }
    }
}

/// How near to its resonance a machine counts from the start, as in `Transient`.
const NEAR: f64 = 0.25;

/// The motion of a [`Rotor`] from a given start, at any later time, in closed form: the steady circle and two
/// exponentials.
///
/// From [`Rotor::transient`]. Its error is at most 20 (1 + (|Ω| + ω₀ + Γ + Γᵢ) t) units in the last place
/// (`f64::EPSILON`) of the sum of the circle's radius, or near resonance what the circle has become by then, and of
/// what the growing root has made of the start and of the circle, both of which it finds at first: of their distances,
/// and of their velocities and Γ + Γᵢ times the distances, for as long as they last. That is the time, but not longer
/// than `(1 + e^{−ρt})/|d|`, where the two roots differ by d and their growth by ρ, and not less than 1/ω₀. A velocity's
/// error is at most |Ω| + ω₀ + Γ + Γᵢ times as large.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotorMotion {
    rotor: Rotor,
    /// Z, if the motion is reckoned from the steady circle.
    circle: Option<Complex<f64>>,
    /// The start of the free part.
    free: Shaft,
}

impl RotorMotion {
    /// Position and velocity of the shaft at a time, s, in the laboratory.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the time is not finite, negative or beyond 1e50 s, or the motion by then is beyond the
    /// largest number.
    pub fn at(&self, time: f64) -> Result<Shaft, InvalidQuantity> {
        InvalidQuantity::check_time(time)?;
        InvalidQuantity::require(time >= 0.0, "time", time, "s", Rule::NotNegative)?;
        let (rotor, machine) = (&self.rotor, &self.rotor.machine);
        let load = machine.load_direction(time);
        let free = rotor.free(&self.free, time);
        let forced = match self.circle {
            Some(circle) => Shaft::circling(circle * load, machine.spin()),
            None => rotor.built_up(load, time),
        };
        forced.plus(free).in_range(time)
    }

    /// The shaft at each of these times, s.
    ///
    /// # Errors
    /// As [`RotorMotion::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Shaft>, InvalidQuantity> {
        times.iter().map(|&time| self.at(time)).collect()
    }
}

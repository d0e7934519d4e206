//! Plate and pistons together: what they do to the frame.

use super::{Pistons, Plate, in_room};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// A plate with its pistons.
///
/// ```
/// use mechanics::scenes::wobble_plate::{Engine, PistonParameters, Pistons, Plate, PlateParameters};
/// let plate = Plate::new(PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.0, tilt: 0.4 })?;
/// let pistons = Pistons::new(PistonParameters { count: 4, mass: 0.0, distance: 0.07, rod: 0.2 })?;
/// let balanced = Engine::new(plate, pistons.with_mass(plate.balancing_mass(&pistons)?)?);
/// // Balanced means that the frame feels nothing, at any phase.
/// assert!(balanced.frame_torque(1.0, 100.0).norm() < 1e-14 * 100.0 * 100.0);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Engine {
    plate: Plate,
    pistons: Pistons,
    slope: f64, // tan α
}

impl Engine {
    /// The plate with its pistons.
    #[must_use]
    pub fn new(plate: Plate, pistons: Pistons) -> Self {
        Self { plate, pistons, slope: plate.tilt().tan() }
    }

    /// The plate.
    #[must_use]
    pub fn plate(&self) -> Plate {
        self.plate
    }

    /// The pistons.
    #[must_use]
    pub fn pistons(&self) -> Pistons {
        self.pistons
    }

    /// Sine and cosine of `2πn/N` for piston `n`.
    fn azimuth(&self, n: u32) -> (f64, f64) {
        (TAU * f64::from(n) / f64::from(self.pistons.count())).sin_cos()
    }

    /// Sine and cosine of `2πn/N − ωt` at a phase ωt, rad: by the addition theorems, so that every piston and the plate
    /// see the same rounded sine and cosine of the phase, and what balances does so to the last digit.
    fn behind_plate(&self, n: u32, phase: f64) -> (f64, f64) {
        let ((sin, cos), (sin_phase, cos_phase)) = (self.azimuth(n), phase.sin_cos());
        (sin * cos_phase - cos * sin_phase, cos * cos_phase + sin * sin_phase)
    }

    /// Where the rod of piston `n` touches the plate's middle plane at a phase ωt, rad, in the room, m (`eq:contact`).
    #[must_use]
    pub fn contact(&self, n: u32, phase: f64) -> Vector3<f64> {
        let ((sin, cos), (sin_behind, _)) = (self.azimuth(n), self.behind_plate(n, phase));
        Vector3::new(sin, -cos, self.slope * sin_behind) * self.pistons.distance() // eq:contact
    }

    /// The centre of piston `n` at a phase ωt, rad, in the room, m (`eq:piston-centre`).
    #[must_use]
    pub fn centre(&self, n: u32, phase: f64) -> Vector3<f64> {
        self.contact(n, phase) - Vector3::z() * self.pistons.rod()
    }

    /// The velocity of piston `n` along the shaft, m/s, at a phase, rad, and a spin, rad/s (`eq:piston-velocity`).
    #[must_use]
    pub fn velocity(&self, n: u32, phase: f64, spin: f64) -> f64 {
        let (_, cos_behind) = self.behind_plate(n, phase);
        -spin * self.pistons.distance() * self.slope * cos_behind // eq:piston-velocity
    }

    /// The acceleration of piston `n` along the shaft, m/s²: `−ω²` times its height above the middle.
    #[must_use]
    pub fn acceleration(&self, n: u32, phase: f64, spin: f64) -> f64 {
        -spin * spin * self.contact(n, phase).z
    }

    /// The angular momentum of the pistons about the plate's centre, in the room, kg·m²/s (`eq:piston-momentum`). It
    /// has no part along the shaft.
    #[must_use]
    pub fn piston_momentum(&self, phase: f64, spin: f64) -> Vector3<f64> {
        self.moment_of(|n| self.velocity(n, phase, spin))
    }

    /// The angular momentum of plate and pistons about the plate's centre, in the room, kg·m²/s.
    #[must_use]
    pub fn angular_momentum(&self, phase: f64, spin: f64) -> Vector3<f64> {
        in_room(&self.plate.angular_momentum_rotating(spin), phase) + self.piston_momentum(phase, spin)
    }

    /// The torque about the plate's centre that the frame gives plate and pistons, through bearings and cylinder walls
    /// together, in the room, N·m: the rate of [`Engine::angular_momentum`]. For three and more pistons its length is
    /// `eq:residual-torque`.
    ///
    /// At the balancing mass at most 2e-15 of the plate's own torque is left, up to ten pistons and a tilt of 89.99°;
    /// 1e-14 for more pistons.
    #[must_use]
    pub fn frame_torque(&self, phase: f64, spin: f64) -> Vector3<f64> {
        in_room(&self.plate.bearing_torque_rotating(spin), phase)
            + self.moment_of(|n| self.acceleration(n, phase, spin))
    }

    /// `Σ r × m v` for velocities, or accelerations, along the shaft: `m v (y, −x, 0)` each.
    fn moment_of(&self, rate: impl Fn(u32) -> f64) -> Vector3<f64> {
        let arms = self.pistons.numbers().map(|n| {
            let (sin, cos) = self.azimuth(n);
            let [x, y] = [sin, -cos];
            Vector3::new(y, -x, 0.0) * rate(n)
        });
        arms.sum::<Vector3<f64>>() * (self.pistons.mass() * self.pistons.distance())
    }

    /// The force along the shaft that moves the pistons, N; zero for two and more (`eq:shaking-force`).
    #[must_use]
    pub fn shaking_force(&self, phase: f64, spin: f64) -> f64 {
        let sum: f64 = self.pistons.numbers().map(|n| self.acceleration(n, phase, spin)).sum();
        self.pistons.mass() * sum
    }

    /// The kinetic energy of the pistons, J; `¼N m ω² r² tan²α`, constant, for three and more (`eq:piston-energy`).
    #[must_use]
    pub fn piston_energy(&self, phase: f64, spin: f64) -> f64 {
        let squares: f64 = self.pistons.numbers().map(|n| self.velocity(n, phase, spin).powi(2)).sum();
        0.5 * self.pistons.mass() * squares
    }

    /// The torque about the shaft that moves the pistons at constant spin, N·m; zero for three and more.
    #[must_use]
    pub fn drive_torque(&self, phase: f64, spin: f64) -> f64 {
        let power: f64 = self
            .pistons
            .numbers()
            .map(|n| self.velocity(n, phase, 1.0) * self.acceleration(n, phase, spin))
            .sum();
        self.pistons.mass() * power
    }
}

//! The equations of motion, and what follows from a state at once.

use super::{Disk, DiskParameters, MomentFactors, Rolling, sin_cos_lean};
use nalgebra::{Complex, Vector3};

impl Disk {
    /// The rates of the eight numbers of [`Rolling`]: 1/s, 1/s² and m/s.
    pub(crate) fn rates(&self, _time: f64, state: &[f64; 8]) -> [f64; 8] {
        let DiskParameters { radius: a, moments, gravity: g, .. } = self.parameters;
        let MomentFactors { transverse: i1, axial: i3 } = moments;
        let &[tilt, lean_rate, q, n, heading, ..] = state;
        let (sin, cos) = sin_cos_lean(tilt);
        let p = q * sin / cos;
        let drag = self.film * (g / a).sqrt() / (cos * cos * cos); // eq:film-torque
        // eq:lean-acceleration and eq:spin-rates, with the film: eq:film-rates
        let lean_acceleration =
            (g / a * sin - (1.0 + i3) * n * q - i1 * p * q - drag * lean_rate) / (1.0 + i1);
        let q_rate = (lean_rate * (i1 * p + i3 * n) - drag * q) / i1;
        let n_rate = lean_rate * q / (1.0 + i3);
        // eq:rolling-path: along axis 1 and, to its left, the level part of axis 3.
        let ahead = Complex::cis(heading);
        let level_3 = -Complex::<f64>::i() * ahead * cos;
        let velocity = (level_3 * lean_rate - ahead * n) * a;
        [-lean_rate, lean_acceleration, q_rate, n_rate, q / cos, n + p, velocity.re, velocity.im]
    }

    /// The energy, J, with the table as zero of height (`eq:rolling-energy`).
    pub(crate) fn energy(&self, state: &Rolling) -> f64 {
        let DiskParameters { mass: m, radius: a, moments, gravity: g } = self.parameters;
        let MomentFactors { transverse: i1, axial: i3 } = moments;
        let Rolling { omega_1: lean_rate, omega_2: q, omega_3: n, .. } = *state;
        let (_, cos) = sin_cos_lean(state.tilt);
        let squares = (1.0 + i1) * lean_rate * lean_rate + i1 * q * q + (1.0 + i3) * n * n;
        0.5 * m * a * a * squares + m * g * a * cos
    }

    /// The force of the table on the disk, N, along axes 1, 2, 3 (`eq:contact-force`).
    pub(crate) fn contact_force(&self, state: &Rolling) -> Vector3<f64> {
        let DiskParameters { mass: m, radius: a, gravity: g, .. } = self.parameters;
        let [_, lean_acceleration, _, n_rate, ..] = self.rates(0.0, &state.to_array());
        let Rolling { omega_1: lean_rate, omega_2: q, omega_3: n, .. } = *state;
        let (sin, cos) = sin_cos_lean(state.tilt);
        Vector3::new(
            m * a * (lean_rate * q - n_rate),
            m * a * (n * q * sin / cos - lean_rate * lean_rate) + m * g * cos,
            m * a * (lean_acceleration + n * q) - m * g * sin,
        )
    }

    /// The upright part of that force, N (`eq:normal-force`).
    pub(crate) fn normal_force(&self, state: &Rolling) -> f64 {
        let DiskParameters { mass: m, radius: a, gravity: g, .. } = self.parameters;
        let [_, lean_acceleration, ..] = self.rates(0.0, &state.to_array());
        let lean_rate = state.omega_1;
        let (sin, cos) = sin_cos_lean(state.tilt);
        m * (g - a * (lean_acceleration * sin + lean_rate * lean_rate * cos))
    }
}

//! What a plate and pistons that need not be alike leave unbalanced.

use super::Plate;
use crate::inertia::SymmetricMoments;
use crate::quantity::InvalidQuantity;
use nalgebra::{Complex, Vector3};

/// One piston, its rod pressed against the plate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piston {
    /// Its mass, kg, zero or more.
    pub mass: f64,
    /// Its distance from the shaft, m, zero or more.
    pub distance: f64,
    /// Its azimuth, rad, from the place under which the plate is high at phase zero.
    pub azimuth: f64,
}

/// What is left of the torques of a plate and any pistons, and of the forces of these along the shaft.
///
/// The torque on the frame runs round an ellipse, or to and fro on a line: a part of it turns with the plate and
/// another, as fast, the other way (`eq:unbalance-torque`). It is good to a few roundings of the largest of the terms
/// that it is the difference of.
///
/// ```
/// use mechanics::scenes::wobble_plate::{Piston, Plate, PlateParameters, Unbalance};
/// let tilt = 25_f64.to_radians();
/// let plate = Plate::new(PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.0, tilt })?;
/// // Three pistons that balance the plate, one of them a tenth too heavy: a torque to and fro along a line.
/// let pistons = [1.1, 1.0, 1.0].map(|part| part * 1.676 / 3.0).into_iter().zip([0.0, 120.0, 240.0]);
/// let pistons = pistons.map(|(mass, azimuth)| Piston { mass, distance: 0.07, azimuth: f64::to_radians(azimuth) });
/// let [least, greatest] = Unbalance::of(&plate, &pistons.collect::<Vec<_>>())?.torque_range(100.0);
/// assert!(least < 0.01 && (greatest - 0.2 / 3.0 * 19.15).abs() < 0.01);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unbalance {
    /// What turns with the plate, `ΔI cos²α − ½Σ m r²`, kg·m²; negative if the pistons are too heavy.
    pub forward: f64,
    /// `Σ m r² e^{2iφ}` of the pistons with azimuths φ, of which half turns backwards, kg·m².
    pub backward: Complex<f64>,
    /// `Σ m r e^{iφ}`, which shakes along the shaft, kg·m.
    pub along: Complex<f64>,
    slope: f64, // tan α
}

impl Unbalance {
    /// Of a plate, thick or thin, and pistons.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a mass or a distance that is negative, or a number that is not finite.
    pub fn of(plate: &Plate, pistons: &[Piston]) -> Result<Self, InvalidQuantity> {
        let SymmetricMoments { transverse, axial } = plate.moments().as_symmetric()?;
        let cosine = plate.tilt().cos();
        let mut left = Self {
            forward: (axial - transverse) * cosine * cosine,
            backward: Complex::default(),
            along: Complex::default(),
            slope: plate.tilt().tan(),
        };
        for &Piston { mass, distance, azimuth } in pistons {
            InvalidQuantity::check_not_negative("piston mass", mass, "kg")?;
            InvalidQuantity::check_not_negative("distance of the piston", distance, "m")?;
            InvalidQuantity::check("azimuth of the piston", azimuth, "rad")?;
            let place = Complex::from_polar(distance, azimuth);
            left.forward -= 0.5 * mass * distance * distance; // eq:unbalance-parts
            left.backward += mass * place * place;
            left.along += mass * place;
        }
        Ok(left)
    }

    /// The torque about the plate's centre that the frame gives plate and pistons, in the room, N·m, at a phase ωt,
    /// rad, and a spin, rad/s, as [`Engine::frame_torque`](super::Engine::frame_torque) has it
    /// (`eq:unbalance-torque`).
    #[must_use]
    pub fn torque(&self, phase: f64, spin: f64) -> Vector3<f64> {
        let turned = Complex::cis(phase);
        let sum = self.forward * turned - 0.5 * self.backward * turned.conj();
        let torque = Complex::new(0.0, -spin * spin * self.slope) * sum; // eq:unbalance-torque
        Vector3::new(torque.re, torque.im, 0.0)
    }

    /// The least and the greatest torque on the frame in a turn, N·m (`eq:unbalance-range`).
    #[must_use]
    pub fn torque_range(&self, spin: f64) -> [f64; 2] {
        let (with, against) = (self.forward.abs(), 0.5 * self.backward.norm());
        [(with - against).abs(), with + against].map(|part| part * spin * spin * self.slope)
    }

    /// The greatest force along the shaft in a turn, N.
    #[must_use]
    pub fn greatest_force(&self, spin: f64) -> f64 {
        self.along.norm() * spin * spin * self.slope
    }
}

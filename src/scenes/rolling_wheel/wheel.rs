//! The wheel, its equations of motion and the force that holds it.

use crate::conical::Conical;
use crate::quantity::InvalidQuantity;
use crate::rolling::{Disk, DiskParameters, MomentFactors, Rolling};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// A round wheel on a level table.
///
/// ```
/// use mechanics::rolling::{DiskParameters, MomentFactors};
/// use mechanics::scenes::rolling_wheel::Wheel;
/// let (mass, radius, gravity) = (1.0, 0.34, 9.81);
/// let hoop = Wheel::new(DiskParameters { mass, radius, moments: MomentFactors::HOOP, gravity })?;
/// // Up to this lean no circle is unstable; and a hoop that all but falls flat gets up on the far side, in π√3.
/// assert_eq!(format!("{:.1}°", hoop.safe_lean().to_degrees()), "19.2°");
/// assert_eq!(format!("{:.0}°", hoop.near_flat_turn().to_degrees()), "312°");
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wheel {
    pub(super) disk: Disk,
    pub(super) conical: Conical,
}

impl Wheel {
    /// The wheel of these parameters.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: DiskParameters) -> Result<Self, InvalidQuantity> {
        let disk = Disk::new(parameters, 0.0)?;
        let MomentFactors { transverse: i1, axial: i3 } = parameters.moments;
        let conical = Conical::new(i3 / i1 / (1.0 + i3)); // eq:legendre
        Ok(Self { disk, conical })
    }

    /// What it was made of.
    #[must_use]
    pub fn parameters(&self) -> DiskParameters {
        self.disk.parameters
    }

    /// The rates of the eight numbers of [`Rolling`], for [`crate::integrate::Dop853`] (`eq:lean-acceleration`,
    /// `eq:spin-rates`, `eq:rolling-path`): rad/s, rad/s² and m/s. Infinite or NaN for a flat wheel.
    #[must_use]
    pub fn rates(&self, time: f64, state: &[f64; 8]) -> [f64; 8] {
        self.disk.rates(time, state)
    }

    /// The rates of a wheel that something slows, air or a soft table, with the torque `−s ma² ω` on its turning about
    /// the centre; `slowing` s is in 1/s. Its energy then changes by `−s ma² |ω|²` in a second.
    pub fn slowed_rates(&self, slowing: f64) -> impl Fn(f64, &[f64; 8]) -> [f64; 8] + Copy + use<> {
        let disk = self.disk;
        let MomentFactors { transverse: i1, axial: i3 } = disk.parameters.moments;
        move |time, state| {
            let mut rates = disk.rates(time, state);
            // What eq:contact-force leaves of it: the foot at rest adds one to the moments about axes 1 and 3.
            for (k, moment) in [(1, 1.0 + i1), (2, i1), (3, 1.0 + i3)] {
                rates[k] -= slowing * state[k] / moment;
            }
            rates
        }
    }

    /// The energy of the motion, J, with the table as zero of height (`eq:rolling-energy`).
    #[must_use]
    pub fn energy(&self, state: &Rolling) -> f64 {
        self.disk.energy(state)
    }

    /// The force of the table on the wheel, along axes 1, 2, 3, N (`eq:contact-force`).
    #[must_use]
    pub fn contact_force(&self, state: &Rolling) -> Vector3<f64> {
        self.disk.contact_force(state)
    }

    /// The part of the contact force that holds the wheel up, N; negative where the wheel would leave the table
    /// (`eq:normal-force`).
    #[must_use]
    pub fn normal_force(&self, state: &Rolling) -> f64 {
        self.disk.normal_force(state)
    }

    /// The angle, rad, by which the contact runs round when the wheel is let go almost flat, falls, just misses lying
    /// flat and gets up again: `π√(1 + 1/I₁)`, in the limit of a near miss (`eq:near-flat-turn`). To 2 units in the
    /// last place.
    #[must_use]
    pub fn near_flat_turn(&self) -> f64 {
        PI * (1.0 + 1.0 / self.disk.parameters.moments.transverse).sqrt()
    }
}

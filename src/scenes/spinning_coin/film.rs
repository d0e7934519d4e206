//! Euler's disk: a coin that sinks as it squeezes a film of air.

use super::coin::SpinningCoin;
use crate::quantity::InvalidQuantity;
use crate::rolling::{Disk, DiskParameters, Rolling};
use std::f64::consts::PI;

/// A disk that rolls on its edge without slipping and is slowed by the film of air under it.
///
/// The film takes the torque `K m a² √(g/a) ω/sin³ α` about both axes in the plane of the disk, where α is its tilt
/// from lying flat (`eq:film-torque`). Nothing is assumed to be slow: it wobbles as it sinks.
///
/// In this model the disk never lies flat. The film's rate of damping, `K/(I₁ sin³ α)` in √(g/a), outgrows that of
/// steady rolling, `1/√(I₁ sin α)`; soon all turning has died out, and the disk creeps on as in glue, α̇ = −α³/K, for
/// ever. The motion is over when damping is a thousand times faster than rolling would be, at `sin α =
/// (K/1000√I₁)^(2/5)`: for the toy an eighth of a milliradian, with its high edge nine micrometres up.
///
/// ```
/// use mechanics::integrate::Taylor;
/// use mechanics::rolling::{DiskParameters, MomentFactors};
/// use mechanics::scenes::spinning_coin::EulersDisk;
/// // The steel disc of the toy shops, 0.4 kg and 37.5 mm, in air.
/// let (mass, radius, gravity) = (0.4, 0.0375, 9.81);
/// let steel = DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity };
/// let disk = EulersDisk::in_air(steel, 1.78e-5)?;
/// let sinking = disk.sinking(disk.steady(0.1)?, &Taylor::new(1e-13)?)?;
/// // On the average the cube of the tilt falls in proportion to the time: 95.4 s to the end.
/// let expected = 0.1 * (1.0 - 60.0 / 95.37_f64).cbrt();
/// assert!((sinking.at(60.0)?.tilt / expected - 1.0).abs() < 0.02);
/// # Ok::<(), mechanics::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulersDisk {
    pub(super) disk: Disk,
}

impl EulersDisk {
    /// A disk on a film with the number K, zero or more, which has no unit (`eq:film-torque`).
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: DiskParameters, film: f64) -> Result<Self, InvalidQuantity> {
        Ok(Self { disk: Disk::new(parameters, film)? })
    }

    /// A disk in a gas of `viscosity` μ, Pa·s, zero or more: the film's number is then `πμa/4m · √(a/g)`, for which a
    /// steadily sinking uniform disc loses the power `πμga²/α²` of Moffatt (2000).
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn in_air(parameters: DiskParameters, viscosity: f64) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check_not_negative("viscosity", viscosity, "Pa·s")?;
        let DiskParameters { mass: m, radius: a, gravity: g, .. } = Disk::new(parameters, 0.0)?.parameters;
        Self::new(parameters, PI * viscosity * a / (4.0 * m) * (a / g).sqrt())
    }

    /// What it was made of.
    #[must_use]
    pub fn parameters(&self) -> DiskParameters {
        self.disk.parameters
    }

    /// The film's number K.
    #[must_use]
    pub fn film(&self) -> f64 {
        self.disk.film
    }

    /// The steady motion about a centre at rest at this tilt from lying flat, rad, as it would be without the film: the
    /// state of [`SpinningCoin::state`].
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless the tilt is more than zero and less than π/2.
    pub fn steady(&self, tilt: f64) -> Result<Rolling, InvalidQuantity> {
        Ok(SpinningCoin::new(self.disk.parameters, tilt)?.state())
    }

    /// The rates of the eight numbers of [`Rolling`], for [`crate::integrate::Dop853`] (`eq:film-rates`): rad/s, rad/s²
    /// and m/s. Infinite or NaN for a flat disk.
    #[must_use]
    pub fn rates(&self, time: f64, state: &[f64; 8]) -> [f64; 8] {
        self.disk.rates(time, state)
    }

    /// The energy, J, with the table as zero of height (`eq:rolling-energy`).
    #[must_use]
    pub fn energy(&self, state: &Rolling) -> f64 {
        self.disk.energy(state)
    }

    /// The part of the contact force that holds the disk up, N; negative where it would leave the table
    /// (`eq:film-support`).
    #[must_use]
    pub fn normal_force(&self, state: &Rolling) -> f64 {
        self.disk.normal_force(state)
    }
}

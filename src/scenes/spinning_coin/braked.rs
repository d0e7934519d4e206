//! A disk that rolls on its edge and loses energy by any law, whatever the speed.

use super::coin::check_tilt;
use super::spin_down::Loss;
use crate::error::Error;
use crate::integrate::{Direction, Dop853, Outcome};
use crate::quantity::{InvalidQuantity, Rule};
use crate::rolling::{Disk, DiskParameters, Rolling};
use nalgebra::Vector3;

/// How long a disk is waited for, in √(a/g).
const LONGEST: f64 = 1e12;

/// A disk that rolls on its edge without slipping, against a torque that takes the power of a [`Loss`] from steady
/// rolling.
///
/// The torque is `−B m a² √(g/a) ω/sinᵖ⁺¹ α` about both axes in the plane of the disk, where α is its tilt from lying
/// flat (`eq:brake-torque`). Nothing is assumed to be slow: it wobbles as it sinks. With p = 2 it is the film of
/// [`EulersDisk`](super::EulersDisk), whose series are faster; this one is for an integrator.
///
/// ```
/// use mechanics::rolling::{DiskParameters, MomentFactors};
/// use mechanics::scenes::spinning_coin::{BrakedDisk, Loss, SpinningCoin};
/// // The table carries a disk that rolls steadily, and a brake changes nothing about that at once.
/// let (mass, radius, gravity) = (0.4, 0.0375, 9.81);
/// let steel = DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity };
/// let disk = BrakedDisk::new(steel, Loss::new(1e-4, 1.0)?)?;
/// let support = disk.support(&SpinningCoin::new(steel, 0.1)?.state());
/// assert!((support.z / (mass * gravity) - 1.0).abs() < 1e-12);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BrakedDisk {
    disk: Disk,
    exponent: f64,
    strength: f64,
}

impl BrakedDisk {
    /// A disk that in steady rolling loses this power.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: DiskParameters, loss: Loss) -> Result<Self, InvalidQuantity> {
        let disk = Disk::new(parameters, 0.0)?;
        let DiskParameters { mass, radius, moments, gravity } = parameters;
        // Of the power B ma²√(g/a) ω₂²/sinᵖ⁺¹ α, with ω₂ = Ω sin α and eq:coin-rate-moments, the factor of 1/sinᵖ α is
        // C.
        let unit = mass * gravity * radius / disk.unit_of_time();
        let strength = loss.coefficient() * moments.transverse / unit;
        let because = "for this disk it gives a brake of a strength B outside 1e-50 to 1e50";
        let name = "coefficient C of the loss";
        InvalidQuantity::require_computable(strength, name, loss.coefficient(), "W", because)?;
        Ok(Self { disk, exponent: loss.exponent(), strength })
    }

    /// What it was made of.
    #[must_use]
    pub fn parameters(&self) -> DiskParameters {
        self.disk.parameters
    }

    /// The strength B of the brake, which has no unit (`eq:brake-torque`).
    #[must_use]
    pub fn strength(&self) -> f64 {
        self.strength
    }

    /// The disk on a film that brakes it, at this tilt, as much.
    fn on_a_film(&self, tilt: f64) -> Disk {
        Disk { film: self.strength * tilt.sin().powf(2.0 - self.exponent), ..self.disk } // eq:brake-torque
    }

    /// The rates of the eight numbers of [`Rolling`], for [`crate::integrate::Dop853`] (`eq:film-rates` with the torque
    /// of `eq:brake-torque`): rad/s, rad/s² and m/s. Infinite or NaN for a flat disk.
    #[must_use]
    pub fn rates(&self, time: f64, state: &[f64; 8]) -> [f64; 8] {
        self.on_a_film(state[0]).rates(time, state)
    }

    /// The energy, J, with the table as zero of height (`eq:rolling-energy`).
    #[must_use]
    pub fn energy(&self, state: &Rolling) -> f64 {
        self.disk.energy(state)
    }

    /// The force of the table on the disk, N: friction along axis 1; friction across it, level, from the contact
    /// towards the centre; and upwards (`eq:contact-force`). Upwards it is negative where the disk would leave the
    /// table.
    #[must_use]
    pub fn support(&self, state: &Rolling) -> Vector3<f64> {
        let force = self.on_a_film(state.tilt).contact_force(state);
        let (sin, cos) = state.tilt.sin_cos();
        Vector3::new(force.x, force.y * cos + force.z * sin, force.y * sin - force.z * cos)
    }

    /// The disk at each of these tilts, rad, one lower than the other, on its way down from `start`.
    ///
    /// The solver's limit on the evaluations holds for all tilts together. Unless it is set it is ten million, some
    /// tens of thousands of turns and some seconds: that is how long a disk is waited for that hardly sinks.
    ///
    /// # Errors
    /// [`Error::Quantity`] if a tilt is not lower than the one before it, the first than that of the start, or the disk
    /// does not sink so far; [`Error::Integration`] if the solver fails, as it does where all turning has died out and
    /// the disk creeps.
    pub fn sink(&self, start: Rolling, tilts: &[f64], solver: &Dop853) -> Result<Vec<TiltReached>, Error> {
        start.check()?;
        let (mut time, mut state, mut evaluated) = (0.0, start.to_array(), 0);
        let end = LONGEST * self.disk.unit_of_time();
        let mut sunk = Vec::with_capacity(tilts.len());
        for &tilt in tilts {
            check_tilt(tilt)?;
            let lower = Rule::Because("it must be lower than the one before");
            InvalidQuantity::require(tilt < state[0], "tilt from lying flat", tilt, "rad", lower)?;
            let rates = |time: f64, state: &[f64; 8]| self.rates(time, state);
            let above = |_: f64, state: &[f64; 8]| state[0] - tilt;
            let left = solver.with_max_evaluations(solver.max_evaluations().saturating_sub(evaluated));
            let outcome = left.solve_until(rates, time, state, end, above, Direction::Falling);
            let Outcome::Event(there) = outcome.map_err(|failure| failure.after(evaluated))? else {
                let rule = Rule::Because("the disk does not sink so far");
                return Err(InvalidQuantity {
                    quantity: "tilt from lying flat",
                    value: tilt,
                    unit: "rad",
                    rule,
                }
                .into());
            };
            (time, state) = (there.time, there.state);
            evaluated += there.work.evaluations;
            sunk.push(TiltReached { time, state: Rolling::from_array(state) });
        }
        Ok(sunk)
    }
}

/// A disk on its way down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TiltReached {
    /// The time since the start, s.
    pub time: f64,
    /// The disk then.
    pub state: Rolling,
}

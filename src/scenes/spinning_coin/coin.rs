//! The coin at one tilt.

use crate::attitude::turn;
use crate::quantity::{InvalidQuantity, Rule};
use crate::rolling::{Disk, DiskParameters, Rolling};
use crate::two_part::TwoPart;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;

/// A coin, disc or hoop that rolls on its edge round a circle about its own centre.
///
/// ```
/// use mechanics::rolling::{DiskParameters, MomentFactors};
/// use mechanics::scenes::spinning_coin::SpinningCoin;
/// // A heavy steel disc of 37.5 mm, almost flat.
/// let (mass, radius, gravity) = (0.4, 0.0375, 9.81);
/// let steel = DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity };
/// let disc = SpinningCoin::new(steel, 0.05)?;
/// assert!(disc.turn_rate() > 140.0); // its contact runs round 23 times a second,
/// assert!(disc.figure_rate() < 0.2); // and its face turns once in half a minute.
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpinningCoin {
    parameters: DiskParameters,
    tilt: f64,
    pub(super) sin: f64, // of the tilt, the cosine of the lean
    pub(super) cos: f64,
    turn_rate: f64,
}

impl SpinningCoin {
    /// A coin tilted by `tilt`, rad, from lying flat, more than zero and less than π/2.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: DiskParameters, tilt: f64) -> Result<Self, InvalidQuantity> {
        let DiskParameters { radius: a, moments, gravity: g, .. } = Disk::new(parameters, 0.0)?.parameters;
        check_tilt(tilt)?;
        let (sin, cos) = tilt.sin_cos();
        let turn_rate = (g / (moments.transverse * a * sin)).sqrt(); // eq:coin-rate-moments
        Ok(Self { parameters, tilt, sin, cos, turn_rate })
    }

    /// What it was made of.
    #[must_use]
    pub fn parameters(&self) -> DiskParameters {
        self.parameters
    }

    /// The tilt α from lying flat, rad.
    #[must_use]
    pub fn tilt(&self) -> f64 {
        self.tilt
    }

    /// The rate Ω at which the point of contact goes round, rad/s (`eq:coin-rate-moments`).
    #[must_use]
    pub fn turn_rate(&self) -> f64 {
        self.turn_rate
    }

    /// The spin about the coin's axis relative to the frame that goes round, `Ω cos α`, rad/s (`eq:coin-spin`).
    #[must_use]
    pub fn relative_spin(&self) -> f64 {
        self.turn_rate * self.cos
    }

    /// The rate at which the figure on the face is seen to turn, `Ω(1 − cos α)`, rad/s (`eq:figure-rate`). To 9e-16 of
    /// itself at any tilt, as all rates here are.
    #[must_use]
    pub fn figure_rate(&self) -> f64 {
        2.0 * self.turn_rate * (0.5 * self.tilt).sin().powi(2)
    }

    /// The vertical component of the angular velocity at any instant, `Ω sin² α`, rad/s (`eq:instant-rate`). Twice the
    /// figure's rate when the coin is almost flat.
    #[must_use]
    pub fn vertical_rate(&self) -> f64 {
        self.turn_rate * self.sin * self.sin
    }

    /// The whole angular velocity along axes 1, 2, 3: `Ω sin α` along 2, from the contact to the centre, rad/s
    /// (`eq:coin-spin`).
    #[must_use]
    pub fn omega(&self) -> Vector3<f64> {
        Vector3::new(0.0, self.turn_rate * self.sin, 0.0)
    }

    /// The angular momentum about the centre, kg·m²/s, along axes 1, 2, 3 (`eq:coin-momentum`).
    #[must_use]
    pub fn angular_momentum(&self) -> Vector3<f64> {
        let DiskParameters { mass: m, radius: a, moments, .. } = self.parameters;
        self.omega() * (moments.transverse * m * a * a)
    }

    /// The energy, J, with the table as zero: `3/2 mga sin α` (`eq:coin-energy`).
    #[must_use]
    pub fn energy(&self) -> f64 {
        1.5 * self.weight_times_radius() * self.sin
    }

    /// mga, J.
    pub(super) fn weight_times_radius(&self) -> f64 {
        let DiskParameters { mass: m, radius: a, gravity: g, .. } = self.parameters;
        m * g * a
    }

    /// This motion as a state of a rolling disk, with the centre above the origin and axis 1 along x.
    #[must_use]
    pub fn state(&self) -> Rolling {
        Rolling { tilt: self.tilt, omega_2: self.turn_rate * self.sin, ..Rolling::UPRIGHT }
    }

    /// How fast the point of contact moves, m/s: `aΩ cos α` (`eq:contact-run`). It is a place, and no part of the coin.
    #[must_use]
    pub fn contact_speed(&self) -> f64 {
        self.parameters.radius * self.turn_rate * self.cos
    }

    /// The angular frequency of small wobbles about the steady motion, rad/s; real at every tilt (`eq:coin-nutation`).
    #[must_use]
    pub fn wobble_rate(&self) -> f64 {
        let i1 = self.parameters.moments.transverse;
        let square = self.sin * self.sin + 3.0 * i1 * self.cos * self.cos;
        self.turn_rate * (square / (1.0 + i1)).sqrt()
    }

    /// The attitude after `turns` turns of the contact, room from body, where at the start axis 1 lies along x and the
    /// coin's upward normal leans towards −y (`eq:coin-attitude`). Whole turns are taken off exactly; what is rounded
    /// is the angle through which the figure has turned, to 4.5e-16 of itself, so that beyond 1e16 turns of the figure
    /// nothing is left of it.
    #[must_use]
    pub fn attitude(&self, turns: f64) -> UnitQuaternion<f64> {
        // Of so many turns no digit of the figure's is left.
        let countable = turns.clamp(-1e200, 1e200);
        let (figure, rest) = TwoPart::product(countable, 2.0 * (0.5 * self.tilt).sin().powi(2)).parts();
        let figure = TwoPart::sum(figure % 1.0, rest % 1.0);
        let turns = turns % 1.0;
        let round = turn(&Vector3::z(), TwoPart::PI * 2.0 * turns);
        let lean = turn(&Vector3::x(), self.tilt.into());
        // About the upward normal the coin turns backwards by the relative spin, a turn less the figure's.
        let spun = turn(&Vector3::z(), TwoPart::PI * 2.0 * (figure - turns.into()));
        round * lean * spun
    }

    /// The tilt, rad, at which the contact of such a coin runs with the speed `sound`, m/s (`eq:contact-run`, solved
    /// for the tilt; `eq:mach-tilt` for small ones), to 9e-16 of itself.
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless the speed is positive.
    pub fn tilt_for_contact_speed(&self, sound: f64) -> Result<f64, InvalidQuantity> {
        InvalidQuantity::check_positive("speed", sound, "m/s")?;
        let DiskParameters { radius: a, moments, gravity: g, .. } = self.parameters;
        // The square of eq:contact-run with I₁ for ¼, ga/I₁ · cos²α/sin α = c²: a quadratic in sin α, solved without a
        // difference; and cos α from its square, since near upright the sine does not tell the tilt.
        let s = moments.transverse * sound * sound / (g * a);
        let sin = 2.0 / (s + s.hypot(2.0));
        Ok(sin.atan2((s * sin).sqrt()))
    }
}

/// Checks that a coin can have this tilt, rad.
pub(super) fn check_tilt(tilt: f64) -> Result<f64, InvalidQuantity> {
    InvalidQuantity::check_positive("tilt from lying flat", tilt, "rad")?;
    let rule = Rule::LessThan(FRAC_PI_2);
    InvalidQuantity::require(tilt < FRAC_PI_2, "tilt from lying flat", tilt, "rad", rule)
}

//! How a spinning coin goes down: a loss of energy that depends on the tilt, and the end at a definite time.
//!
//! The coin is taken to pass through its steady motions one after the other, which holds as long as it sinks little
//! within one round. Then the balance of energy is a law for the tilt alone, and it can be solved.

use super::coin::{SpinningCoin, check_tilt};
use crate::quantity::{InvalidQuantity, Rule};
use crate::rolling::DiskParameters;
use crate::two_part::TwoPart;
use std::f64::consts::PI;

/// The largest power of the tilt in a loss; the laws that have been proposed have powers up to two.
const LARGEST_EXPONENT: f64 = 10.0;

/// The power that a spinning coin loses, `C/sinᵖ α` (`eq:coin-loss`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loss {
    coefficient: f64,
    exponent: f64,
}

impl Loss {
    /// A loss with the coefficient C, W, and the exponent p, from 0 to 10.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(coefficient: f64, exponent: f64) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check_positive("coefficient of the loss", coefficient, "W")?;
        InvalidQuantity::check_not_negative("exponent of the loss", exponent, "")?;
        let rule = Rule::AtMost(LARGEST_EXPONENT);
        InvalidQuantity::require(exponent <= LARGEST_EXPONENT, "exponent of the loss", exponent, "", rule)?;
        Ok(Self { coefficient, exponent })
    }

    /// The loss to a layer of air of the given viscosity, Pa·s, between coin and table: `C = π μ g a²/4I₁`, for a
    /// uniform disc `π μ g a²`, and p = 2 (`eq:film-loss`; Moffatt, *Nature* **404** (2000) 833).
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the viscosity is not positive.
    pub fn air_film(coin: &SpinningCoin, viscosity: f64) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check_positive("viscosity", viscosity, "Pa·s")?;
        let DiskParameters { radius: a, moments, gravity: g, .. } = coin.parameters();
        Self::new(PI * viscosity * g * a * a / (4.0 * moments.transverse), 2.0)
    }

    /// C, W.
    pub(super) fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// p.
    pub(super) fn exponent(&self) -> f64 {
        self.exponent
    }

    /// The time, s, from a tilt with this sine to the end, for a coin whose energy is `weight`, J, times the sine
    /// (`eq:spin-down`).
    fn time(&self, weight: f64, sin: f64) -> f64 {
        // The power of the sine in two halves: as a whole it may be too small for f64 where the time is not.
        let half = sin.powf(0.5 * self.exponent);
        weight * sin / (self.coefficient * (self.exponent + 1.0)) * half * half
    }
}

/// A coin on its way down, from a start to the moment t₀ when, by this law, it lies flat (`eq:spin-down`).
///
/// ```
/// use mechanics::rolling::{DiskParameters, MomentFactors};
/// use mechanics::scenes::spinning_coin::{Loss, SpinDown, SpinningCoin};
/// // A steel disc of 0.4 kg, with the air under it as the only brake.
/// let (mass, radius, gravity) = (0.4, 0.0375, 9.81);
/// let steel = DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity };
/// let start = SpinningCoin::new(steel, 0.1)?;
/// let spin_down = SpinDown::new(start, Loss::air_film(&start, 1.78e-5)?)?;
/// assert!((spin_down.life() - 95.0).abs() < 1.0); // seconds
/// // Whenever the time that is left is divided by eight, the tilt is halved.
/// let [early, late] = [8e-20, 1e-20].map(|left| spin_down.with_time_left(left).map(|coin| coin.tilt()));
/// assert!((early? / late? - 2.0).abs() < 1e-14);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpinDown {
    start: SpinningCoin,
    loss: Loss,
    weight: f64, // 3/2 m g a, the energy over the sine of the tilt, J
    life: f64,
}

impl SpinDown {
    /// A coin that starts at its tilt at time zero and loses energy by this law.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the life is of a size that cannot be computed with.
    pub fn new(start: SpinningCoin, loss: Loss) -> Result<Self, InvalidQuantity> {
        let weight = 1.5 * start.weight_times_radius(); // eq:coin-energy
        let life = loss.time(weight, start.sin);
        InvalidQuantity::check_positive("life of the coin", life, "s")?;
        Ok(Self { start, loss, weight, life })
    }

    /// The coin at time zero.
    #[must_use]
    pub fn start(&self) -> SpinningCoin {
        self.start
    }

    /// The time t₀ from the start to the end, s (`eq:spin-down`).
    #[must_use]
    pub fn life(&self) -> f64 {
        self.life
    }

    /// The coin at `time`, s, from zero to t₀ (`eq:spin-down`).
    ///
    /// A time is rounded, and so is t₀: as the end comes near, their difference has fewer and fewer digits, and the
    /// tilt too. But for that it is good to 9e-16 of itself. From [`SpinDown::with_time_left`] it has all its digits.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the time is negative, not finite, or not before t₀.
    pub fn at(&self, time: f64) -> Result<SpinningCoin, InvalidQuantity> {
        InvalidQuantity::require(time >= 0.0 || time.is_nan(), "time", time, "s", Rule::NotNegative)?;
        InvalidQuantity::require_finite("time", time, "s")?;
        let end = Rule::NotAbove { what: "the end of this law, where the coin lies flat", limit: self.life };
        InvalidQuantity::require(time < self.life, "time", time, "s", end)?;
        self.coin(self.life - time, time)
    }

    /// The coin at `times`, s, in any order.
    ///
    /// # Errors
    /// As [`SpinDown::at`].
    pub fn sample(&self, times: &[f64]) -> Result<Vec<SpinningCoin>, InvalidQuantity> {
        times.iter().map(|&time| self.at(time)).collect()
    }

    /// The coin when so much time, s, is left (`eq:spin-down`): the tilt to 9e-16 of itself, however little it is.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the time left is not positive, more than t₀, less than 2.2e-308 t₀, or so little that the
    /// tilt is below 1e-50.
    pub fn with_time_left(&self, left: f64) -> Result<SpinningCoin, InvalidQuantity> {
        InvalidQuantity::require_finite("time left", left, "s")?;
        InvalidQuantity::require(left <= self.life, "time left", left, "s", Rule::AtMost(self.life))?;
        InvalidQuantity::require(left > 0.0, "time left", left, "s", Rule::Positive)?;
        let least = Rule::AtLeast(f64::MIN_POSITIVE * self.life);
        InvalidQuantity::require(left / self.life >= f64::MIN_POSITIVE, "time left", left, "s", least)?;
        self.coin(left, self.life - left)
    }

    /// The angle, rad, through which the contact has gone round from the start until so much time, s, is left: the
    /// integral of Ω, which is finite to the very end, `Ω₀t₀ (1 − (left/t₀)^(1 − s/2))/(1 − s/2)` with `s = 1/(p + 1)`.
    ///
    /// # Errors
    /// As [`SpinDown::with_time_left`].
    pub fn gone_round(&self, left: f64) -> Result<f64, InvalidQuantity> {
        self.with_time_left(left)?;
        let power = 1.0 - 0.5 / (self.loss.exponent + 1.0);
        Ok(-self.start.turn_rate() * self.life / power * (power * (left / self.life).ln()).exp_m1())
    }

    /// The time left, s, at which the centre would have to fall faster than g for the law to hold on: the height
    /// `a sin α ∝ leftˢ` then has `s(1 − s) a sin α/left² = g`. Zero if that is never, for a loss that does not grow.
    #[must_use]
    pub fn time_left_at_free_fall(&self) -> f64 {
        let DiskParameters { radius: a, gravity: g, .. } = self.start.parameters();
        let power = 1.0 / (self.loss.exponent + 1.0);
        // eq:sinking-fall at the start, in g
        let fall = power * (1.0 - power) * a * self.start.sin / (g * self.life * self.life);
        self.life * fall.powf(1.0 / (2.0 - power))
    }

    /// The coin when so much of its life, s, is left, and so much gone; the smaller of the two is the exact one.
    fn coin(&self, left: f64, gone: f64) -> Result<SpinningCoin, InvalidQuantity> {
        let SpinningCoin { sin: sin_start, cos: cos_start, .. } = self.start;
        let (part, gone) = (left / self.life, gone / self.life);
        let logarithm = if gone < 0.5 { (-gone).ln_1p() } else { part.ln() };
        let order = TwoPart::sum(self.loss.exponent, 1.0);
        let exact_power = TwoPart::from(1.0) / order;
        // The rounding of the power counts as often as the part of the life has e-foldings: put it back.
        let (power, rest) = exact_power.parts();
        let sin = sin_start * part.powf(power) * (1.0 + rest * logarithm); // eq:spin-down
        // cos² α = cos² α₀ + (sin² α₀ − sin² α), a sum of positive numbers: an upright start loses no digits.
        let gained = -(2.0 * power * logarithm).exp_m1();
        let cos = cos_start.hypot(sin_start * gained.sqrt());
        SpinningCoin::new(self.start.parameters(), sin.atan2(cos))
    }

    /// The time, s, that is left when the coin has this tilt, rad, at any tilt up to π/2: to `2.2e-16 (9 + p)` of
    /// itself.
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless the tilt is positive and less than π/2, and if the time is too short for a number.
    pub fn time_left(&self, tilt: f64) -> Result<f64, InvalidQuantity> {
        let sin = check_tilt(tilt)?.sin();
        let left = self.loss.time(self.weight, sin);
        let least = Rule::AtLeast(f64::MIN_POSITIVE);
        InvalidQuantity::require(left >= f64::MIN_POSITIVE, "time left", left, "s", least)
    }

    /// The time, s, from the start to this tilt, rad; negative for a tilt above that of the start. However near the
    /// start, to 1.4e-15 of itself; above it, where the law goes back by many e-foldings, that times one more than
    /// their number.
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless the tilt is positive and less than π/2.
    pub fn time_to(&self, tilt: f64) -> Result<f64, InvalidQuantity> {
        let start = self.start.tilt();
        // Of the sines, by the cosines: near upright the mean of two tilts has no digits to spare.
        let difference = (check_tilt(tilt)?.cos() + self.start.cos) * (0.5 * (tilt - start)).tan();
        let change = difference / self.start.sin;
        // Of the ratio of the sines: near the start by their difference, far from it by the ratio itself.
        let logarithm = if change.abs() < 0.5 { change.ln_1p() } else { (tilt.sin() / self.start.sin).ln() };
        Ok(-self.life * ((self.loss.exponent + 1.0) * logarithm).exp_m1())
    }
}

//! Where the shaft is and how it moves.

use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::Complex;

/// Position and velocity of the drum's shaft in the laboratory, as complex numbers x + iy.
///
/// ```
/// use mechanics::scenes::laundromat::{Polar, Shaft};
/// // Going round O at 2 m with 3 rad/s: no radial velocity, and 6 m/s.
/// let circling = Polar { radius: 2.0, azimuth: 0.5, radius_rate: 0.0, azimuth_rate: 3.0 };
/// let shaft = Shaft::from_polar(circling);
/// assert_eq!(shaft.velocity.norm(), 6.0);
/// assert!((shaft.to_polar().azimuth_rate - 3.0).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaft {
    /// Position z from the fixed point O, m.
    pub position: Complex<f64>,
    /// Velocity ż, m/s.
    pub velocity: Complex<f64>,
}

/// The shaft in polar coordinates about the fixed point O.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Polar {
    /// Distance r from O, m.
    pub radius: f64,
    /// Azimuth θ from the x axis, rad, counter-clockwise.
    pub azimuth: f64,
    /// Radial velocity ṙ, m/s.
    pub radius_rate: f64,
    /// Angular velocity θ̇ about O, rad/s.
    pub azimuth_rate: f64,
}

impl Polar {
    /// From `[r, θ, ṙ, θ̇]` in m, rad, m/s and rad/s, the state that integrators step with
    /// [`super::Machine::polar_rates`].
    #[must_use]
    pub fn from_array([radius, azimuth, radius_rate, azimuth_rate]: [f64; 4]) -> Self {
        Self { radius, azimuth, radius_rate, azimuth_rate }
    }

    /// To `[r, θ, ṙ, θ̇]` in m, rad, m/s and rad/s.
    #[must_use]
    pub fn to_array(&self) -> [f64; 4] {
        [self.radius, self.azimuth, self.radius_rate, self.azimuth_rate]
    }
}

impl Shaft {
    /// At rest at O, where every washing machine starts.
    pub const AT_REST: Self = Self { position: Complex::new(0.0, 0.0), velocity: Complex::new(0.0, 0.0) };

    /// From `[x, y, ẋ, ẏ]` in m and m/s, the state that integrators step with [`super::Machine::cartesian_rates`].
    #[inline]
    #[must_use]
    pub fn from_array([x, y, vx, vy]: [f64; 4]) -> Self {
        Self { position: Complex::new(x, y), velocity: Complex::new(vx, vy) }
    }

    /// To `[x, y, ẋ, ẏ]` in m and m/s.
    #[inline]
    #[must_use]
    pub fn to_array(&self) -> [f64; 4] {
        [self.position.re, self.position.im, self.velocity.re, self.velocity.im]
    }

    /// From polar coordinates and their rates: z = r e<sup>iθ</sup>, ż = (ṙ + irθ̇) e<sup>iθ</sup>.
    #[must_use]
    pub fn from_polar(polar: Polar) -> Self {
        let Polar { radius, azimuth, radius_rate, azimuth_rate } = polar;
        let outward = Complex::from_polar(1.0, azimuth);
        Self {
            position: radius * outward,
            velocity: Complex::new(radius_rate, radius * azimuth_rate) * outward,
        }
    }

    /// To polar coordinates and their rates; θ from −π to π.
    ///
    /// At O itself θ is the direction of the velocity and θ̇, which has no value there, is given as zero. Very
    /// close to O, θ̇ may be beyond the largest number and come back infinite: polar coordinates are like that.
    #[must_use]
    pub fn to_polar(&self) -> Polar {
        let radius = self.position.re.hypot(self.position.im);
        if radius == 0.0 {
            let speed = self.velocity.re.hypot(self.velocity.im);
            return Polar { radius, azimuth: self.velocity.arg(), radius_rate: speed, azimuth_rate: 0.0 };
        }
        let outward = self.position / radius;
        let turned_back = self.velocity * outward.conj(); // ṙ + irθ̇
        Polar {
            radius,
            azimuth: self.position.arg(),
            radius_rate: turned_back.re,
            azimuth_rate: turned_back.im / radius,
        }
    }

    /// Another motion of the suspension on top of this one: its equation is linear.
    #[inline(always)]
    pub(super) fn plus(self, other: Self) -> Self {
        Self { position: self.position + other.position, velocity: self.velocity + other.velocity }
    }

    /// So many times as far and as fast.
    pub(super) fn times(self, factor: f64) -> Self {
        Self { position: self.position * factor, velocity: self.velocity * factor }
    }

    /// A point at `position` that goes round O with this angular velocity, rad/s.
    #[inline(always)]
    pub(super) fn circling(position: Complex<f64>, spin: f64) -> Self {
        Self { position, velocity: Complex::new(-spin * position.im, spin * position.re) }
    }

    /// The same seen in a mirror that stands on the x axis.
    pub(super) fn mirror_image(self) -> Self {
        Self { position: self.position.conj(), velocity: self.velocity.conj() }
    }

    /// Whether all four numbers are finite.
    #[inline(always)]
    pub(super) fn is_finite(&self) -> bool {
        self.to_array().iter().all(|number| number.is_finite())
    }

    /// The shaft, or the refusal of a time at which its motion is beyond the largest number.
    pub(super) fn in_range(self, time: f64) -> Result<Self, InvalidQuantity> {
        if self.is_finite() { Ok(self) } else { Err(out_of_range(time)) }
    }

    /// Refuses a start that is not finite or further out or faster than the closed forms can follow.
    pub(super) fn check_start(&self) -> Result<(), InvalidQuantity> {
        check_start("x of the start", self.position.re, "m")?;
        check_start("y of the start", self.position.im, "m")?;
        check_start("velocity along x of the start", self.velocity.re, "m/s")?;
        check_start("velocity along y of the start", self.velocity.im, "m/s")
    }
}

/// Refuses a number of a start that is not finite or is beyond 1e50; a very small one is as good as zero.
pub(super) fn check_start(
    quantity: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<(), InvalidQuantity> {
    if value.abs() < 1.0 { Ok(()) } else { InvalidQuantity::check(quantity, value, unit).map(|_| ()) }
}

/// The refusal of a time at which a motion is beyond the largest number.
pub(super) fn out_of_range(time: f64) -> InvalidQuantity {
    let rule = Rule::Because("the motion there is beyond the largest number");
    InvalidQuantity { quantity: "time", value: time, unit: "s", rule }
}

//! The force of a drum that speeds up, and the motion that it makes.

use super::pair::Pair;
use super::root::Root;
use crate::scenes::laundromat::oscillator::{Oscillator, Roots};
use crate::two_part::TwoPart;
use crate::wide::functions::{ROUNDABLE, sin_cos_quarters};
use nalgebra::Complex;

/// The drum's turning, with α > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Drum {
    pub(super) spin: f64,
    pub(super) acceleration: f64,
    pub(super) offset: f64,
    damping: f64,
    spin_in_quarters: TwoPart,         // 2Ω/π
    acceleration_in_quarters: TwoPart, // α/π
}

/// Two roots apart may lose this factor of the digits, not more.
const MOST_LOST: f64 = 8.0;

#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a handful of ramps, each used for thousands of frames")]
pub(super) enum Forced {
    /// Two roots apart.
    Apart([Root; 2]),
    /// Two roots next to each other.
    Together(Pair),
}

impl Drum {
    pub(super) fn new(spin: f64, acceleration: f64, offset: f64, damping: f64) -> Self {
        Self {
            spin,
            acceleration,
            offset,
            damping,
            spin_in_quarters: TwoPart::from(2.0 * spin) / TwoPart::PI,
            acceleration_in_quarters: TwoPart::from(acceleration) / TwoPart::PI,
        }
    }

    /// The time at which the drum's angle has grown too large to be reduced.
    pub(super) fn reach(&self) -> f64 {
        let by_acceleration = (0.25 * ROUNDABLE / self.acceleration_in_quarters.rounded()).sqrt();
        by_acceleration.min(0.25 * ROUNDABLE / self.spin_in_quarters.rounded().abs())
    }

    /// φ in quarter turns, high and low part.
    #[inline(always)]
    fn angle(&self, time: f64) -> (f64, f64) {
        ((self.acceleration_in_quarters * time + self.spin_in_quarters) * time).parts()
    }

    pub(super) fn forced(&self, free: &Oscillator) -> Forced {
        let zero = TwoPart::from(0.0);
        let [one, other] = match free.roots() {
            Roots::Turning { frequency } => {
                let decay = 0.5 * self.damping;
                [(decay, frequency), (decay, -frequency)]
            }
            Roots::Real { slow, fast, .. } => [(slow, zero), (fast, zero)],
        };
        let half_difference = match free.roots() {
            Roots::Turning { frequency } => Complex::new(0.0, frequency.rounded()),
            Roots::Real { gap, .. } => Complex::new(0.5 * gap, 0.0),
        };
        let mean = -0.5 * self.damping;
        // What is lost when the difference of two roots is divided by that of what they do, which varies over this width.
        let width = self.acceleration.sqrt().max(-mean).max(half_difference.norm());
        let largest = mean.abs() + half_difference.norm();
        if largest * largest > MOST_LOST * half_difference.norm() * width {
            return Forced::Together(Pair::new(self, mean, half_difference));
        }
        let difference = half_difference * 2.0;
        Forced::Apart([Root::new(self, one, difference), Root::new(self, other, -difference)])
    }

    /// Position and velocity of the motion that the force makes, at one time.
    pub(super) fn motion(&self, forced: &Forced, time: f64) -> (Complex<f64>, Complex<f64>) {
        match forced {
            Forced::Apart(roots) => {
                let [[x], [y], [vx], [vy]] = self.driven(roots, &[time]);
                (Complex::new(x, y), Complex::new(vx, vy))
            }
            Forced::Together(pair) => {
                let (high, low) = self.angle(time);
                let (sin, cos) = sin_cos_quarters(high, low);
                let load = Complex::new(cos, sin);
                let rate = Complex::new(-self.damping, self.spin + self.acceleration * time);
                let [position, velocity] = pair.at(load, time);
                ((load + position) * -self.offset, (load * rate + velocity) * -self.offset)
            }
        }
    }

    /// x, y, ẋ, ẏ at several times: −b (g + Σ …) of `eq:ramp-motion`.
    #[inline(always)]
    pub(super) fn driven<const N: usize>(&self, roots: &[Root], times: &[f64; N]) -> [[f64; N]; 4] {
        let (mut g_cos, mut g_sin) = ([0.0; N], [0.0; N]);
        let mut sum = [[0.0; N]; 4];
        for n in 0..N {
            let (high, low) = self.angle(times[n]);
            let (sin, cos) = sin_cos_quarters(high, low);
            (g_cos[n], g_sin[n]) = (cos, sin);
            let rate = self.spin + self.acceleration * times[n];
            // g, and its rate with λ₁ + λ₂ = −Γ: (iφ̇ − Γ) g.
            sum[0][n] = cos;
            sum[1][n] = sin;
            sum[2][n] = -rate * sin - self.damping * cos;
            sum[3][n] = rate * cos - self.damping * sin;
        }
        for root in roots {
            root.add(times, &g_cos, &g_sin, &mut sum);
        }
        sum.map(|list| list.map(|value| -self.offset * value))
    }
}

//! The force of a drum that speeds up, and the motion that it makes.

use super::root::Root;
use crate::branchless::{ROUNDABLE, sin_cos_quarters};
use crate::faddeeva::faddeeva;
use crate::scenes::laundromat::oscillator::{Oscillator, Roots};
use crate::two_part::TwoPart;
use nalgebra::Complex;
use std::f64::consts::PI;

/// The drum's turning, with α > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Drum {
    pub(super) spin: f64,
    pub(super) acceleration: f64,
    offset: f64,
    damping: f64,
    spin_in_quarters: TwoPart,         // 2Ω/π
    acceleration_in_quarters: TwoPart, // α/π
}

#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a handful of ramps, each used for thousands of frames")]
pub(super) enum Forced {
    /// Two roots apart.
    Apart([Root; 2]),
    /// Two roots next to each other, as their mean and half their difference.
    Together { mean: f64, half_difference: Complex<f64> },
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
        if half_difference.norm() < 0.25 * self.circle(mean, 0.0) {
            return Forced::Together { mean, half_difference };
        }
        let difference = half_difference * 2.0;
        Forced::Apart([Root::new(self, one, difference), Root::new(self, other, -difference)])
    }

    /// The radius of a circle about the mean of two roots on which the motion as a function of the root is tame at a time since the
    /// start.
    fn circle(&self, mean: f64, time: f64) -> f64 {
        let tame = 0.4 * self.acceleration.sqrt();
        // The size of what the passing has left behind at the mean, as an exponent.
        let since = time + self.spin / self.acceleration;
        let exponent = mean * since;
        let spread = since.abs() + mean.abs() / self.acceleration;
        tame.min((-exponent).max(1.0) / spread)
    }

    /// Position and velocity of the motion that the force makes, at one time.
    pub(super) fn motion(&self, forced: &Forced, time: f64) -> (Complex<f64>, Complex<f64>) {
        match forced {
            Forced::Apart(roots) => {
                let [[x], [y], [vx], [vy]] = self.driven(roots, &[time]);
                (Complex::new(x, y), Complex::new(vx, vy))
            }
            Forced::Together { mean, half_difference } => self.together(*mean, *half_difference, time),
        }
    }

    /// x, y, ẋ, ẏ at several times: −b (g + Σ …) of `eq:ramp-motion`.
    #[inline(always)]
    pub(super) fn driven<const N: usize>(&self, roots: &[Root; 2], times: &[f64; N]) -> [[f64; N]; 4] {
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

    /// The same for two roots next to each other: the divided difference of λ²P(λ), and of λ³P(λ), as a mean over a circle around
    /// them (Cauchy's formula).
    fn together(&self, mean: f64, half_difference: Complex<f64>, time: f64) -> (Complex<f64>, Complex<f64>) {
        const POINTS: usize = 24;
        let radius = self.circle(mean, time).max(4.0 * half_difference.norm());
        let (high, low) = self.angle(time);
        let (sin, cos) = sin_cos_quarters(high, low);
        let g = Complex::new(cos, sin);
        let (mut position, mut velocity) = (Complex::new(0.0, 0.0), Complex::new(0.0, 0.0));
        for n in 0..POINTS {
            let aside = Complex::from_polar(radius, 2.0 * PI * (n as f64 + 0.5) / POINTS as f64);
            let root = aside + mean;
            let weight = aside / (aside * aside - half_difference * half_difference) / POINTS as f64;
            let part = root * root * self.through(root, g, time) * weight;
            position += part;
            velocity += part * root;
        }
        let rate = Complex::new(-self.damping, self.spin + self.acceleration * time);
        ((g + position) * -self.offset, (g * rate + velocity) * -self.offset)
    }

    /// P for any root.
    fn through(&self, root: Complex<f64>, g: Complex<f64>, time: f64) -> Complex<f64> {
        let width = self.acceleration.sqrt();
        let since = time + self.spin / self.acceleration;
        let past = since - (root.im - root.re) / self.acceleration;
        let argument = Complex::new(root.re / width - 0.5 * width * past, -0.5 * width * past);
        let kappa = Complex::new(1.0, 1.0) * (PI.sqrt() / (2.0 * width));
        let beside = if past < 0.0 { g * faddeeva(argument) } else { -g * faddeeva(-argument) };
        let late = (root.im - root.re - self.spin) / self.acceleration < 0.0;
        if (past < 0.0) != late {
            return kappa * beside;
        }
        // What the passing leaves behind; if it lay before the start, what would have to be taken away before it.
        let square = root * root - self.spin * self.spin;
        let left =
            (root * since + Complex::new(-square.im, square.re) * (0.5 / self.acceleration)).exp() * 2.0;
        kappa * if late { beside - left } else { beside + left }
    }
}

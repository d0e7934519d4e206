//! What the force of a drum that speeds up does through two roots of the suspension next to each other.

use super::drum::Drum;
use crate::faddeeva::faddeeva;
use crate::two_part::TwoPart;
use nalgebra::Complex;
use std::f64::consts::{PI, SQRT_2};

/// Points on a circle about the mean of the roots.
const POINTS: usize = 32;
/// Roots further apart than this part of the circle's radius are far enough apart for a plain difference; if they are nearer, the
/// mean over the circle is exact to `0.3^32`.
const APART: f64 = 0.3;
/// The radius, in units of 1/q, of a circle on which `e^{qλ}` is tame, and of one on which `e^{iλ²/2}` is: together their terms of
/// order 32 are below rounding. And of one on which Faddeeva's function is, in its argument.
const EXPONENTIAL: f64 = 2.0;
const GAUSSIAN: f64 = 0.7;
const FADDEEVA: f64 = 0.7;

/// The roots, and what is constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pair {
    mean: f64,
    half_difference: Complex<f64>,
    width: f64,                // √α
    reversal: TwoPart,         // −Ω/α, the time at which the drum stands still
    passing: TwoPart,          // the time at which Faddeeva's argument for the mean crosses the real axis
    left_behind: Complex<f64>, // twice e to the i times the phase (λ² − Ω²)/2α of what the passing leaves behind, for the mean
}

impl Pair {
    pub(super) fn new(drum: &Drum, mean: f64, half_difference: Complex<f64>) -> Self {
        let [spin, alpha] = [drum.spin, drum.acceleration].map(TwoPart::from);
        let square = TwoPart::product(mean, mean) - TwoPart::product(drum.spin, drum.spin);
        let (sin, cos) = (square / (alpha * 2.0)).sin_cos();
        Self {
            mean,
            half_difference,
            width: drum.acceleration.sqrt(),
            reversal: -(spin / alpha),
            passing: -((spin + TwoPart::from(mean)) / alpha),
            left_behind: Complex::new(cos, sin) * 2.0,
        }
    }

    /// The divided differences of `λ²P` and `λ³P` of `eq:ramp-motion`, for the load's direction at a time.
    pub(super) fn at(&self, load: Complex<f64>, time: f64) -> [Complex<f64>; 2] {
        let alpha = self.width * self.width;
        let from_passing = (TwoPart::from(time) - self.passing).rounded();
        let since = (TwoPart::from(time) - self.reversal).rounded();
        let kappa = Complex::new(1.0, 1.0) * (PI.sqrt() / (2.0 * self.width));

        let before = from_passing < 0.0;
        let at_mean = self.argument(from_passing, Complex::new(0.0, 0.0));
        let beside = self.divided_difference(SQRT_2 * self.width * radius(at_mean.norm()), |aside| {
            let argument = self.argument(from_passing, aside);
            load * if before { faddeeva(argument) } else { -faddeeva(-argument) }
        });
        // What the passing leaves behind. (If it lay before the start, the free motion that is added knows of it.)
        let mut left = [Complex::new(0.0, 0.0); 2];
        if !before {
            let (exponent, rate) = (self.mean * since, Complex::new(since, self.mean / alpha));
            left = self.divided_difference((EXPONENTIAL / rate.norm()).min(GAUSSIAN * self.width), |aside| {
                let square = Complex::<f64>::i() * aside * aside / (2.0 * alpha);
                self.left_behind * (aside * rate + square + exponent).exp()
            });
        }
        std::array::from_fn(|n| kappa * (beside[n] + left[n]))
    }

    /// Faddeeva's argument for a root beside the mean.
    fn argument(&self, from_passing: f64, aside: Complex<f64>) -> Complex<f64> {
        let slope = 0.5 * self.width * from_passing;
        Complex::new(self.mean / self.width - slope, -slope) + aside * Complex::new(0.5, -0.5) / self.width
    }

    /// The divided differences of `λ²f` and `λ³f` between the two roots: as the mean over a circle about them (Cauchy's formula) on
    /// which f is tame, or if they are not close enough for that, as they stand.
    fn divided_difference(&self, radius: f64, f: impl Fn(Complex<f64>) -> Complex<f64>) -> [Complex<f64>; 2] {
        let half = self.half_difference;
        let mut sum = [Complex::new(0.0, 0.0); 2];
        let mut add = |aside: Complex<f64>, weight: Complex<f64>| {
            let root = aside + self.mean;
            let part = root * root * f(aside) * weight;
            sum[0] += part;
            sum[1] += part * root;
        };
        if half.norm() > APART * radius {
            let weight = (half * 2.0).inv();
            add(half, weight);
            add(-half, -weight);
        } else {
            for n in 0..POINTS {
                let aside = Complex::from_polar(radius, 2.0 * PI * (n as f64 + 0.5) / POINTS as f64);
                add(aside, aside / ((aside - half) * (aside + half)) / POINTS as f64);
            }
        }
        sum
    }
}

/// The radius of a circle about an argument of this size on which Faddeeva's function is tame: there it is almost the algebraic i/√π z, of
/// the way to whose pole a part is near enough, and beside that as `e^{−z²}` on the real axis.
fn radius(size: f64) -> f64 {
    let gaussian = 1.8 * (size * size / POINTS as f64).exp() / size;
    (APART * size).min(gaussian).max(FADDEEVA)
}

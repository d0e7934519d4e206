//! What the force of a drum that speeds up does through two roots of the suspension next to each other
//! (`eq:ramp-together`).

use super::drum::Drum;
use crate::faddeeva::faddeeva;
use crate::scenes::laundromat::Shaft;
use crate::scenes::laundromat::machine::direction;
use crate::two_part::TwoPart;
use nalgebra::Complex;
use std::f64::consts::PI;

/// Points on the circle.
const POINTS: usize = 32;
/// Roots further apart than this part of the circle's radius are far enough apart for a plain difference; if they are
/// nearer, the mean over the circle is exact to `0.3^32`.
const APART: f64 = 0.3;
/// The radius, in units of 1/q, of a circle on which `e^{qλ}` is tame, and of one on which `e^{iλ²/2}` is: together
/// their terms of order 32 are below rounding. And of one on which Faddeeva's function is, in its argument.
const EXPONENTIAL: f64 = 2.0;
const GAUSSIAN: f64 = 0.7;
const FADDEEVA: f64 = 0.7;

/// The mean of the two roots, which is real, and half their difference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Together {
    mean: f64,
    half_difference: Complex<f64>,
    phase: TwoPart, // (λ² − Ω²)/2α for the mean
}

impl Together {
    pub(super) fn new(drum: &Drum, mean: f64, half_difference: Complex<f64>) -> Self {
        let square = TwoPart::product(mean, mean) - TwoPart::product(drum.spin, drum.spin);
        Self { mean, half_difference, phase: square / (TwoPart::from(drum.acceleration) * 2.0) }
    }

    /// (λ₁ⁿS₁ − λ₂ⁿS₂)/(λ₁ − λ₂) for n = 2 and 3, as position and velocity: each term of `eq:ramp-integral` by itself,
    /// as is tame for it. All λ of a circle take the case of the mean, so that S is one analytic function.
    pub(super) fn motion(&self, drum: &Drum, [[cos], [sin]]: [[f64; 1]; 2], time: f64) -> Shaft {
        let (load, slope, rate) = (Complex::new(cos, sin), drum.slope(), drum.rate(time));
        let x = slope * Complex::new(self.mean, -rate); // eq:ramp-arguments for the mean
        let after = x.im < 0.0;
        let side = if after { -1.0 } else { 1.0 };
        let mut quotients = self.divided(radius(x.norm()) / slope.norm(), |aside| {
            load * faddeeva((x + slope * aside) * side) * side
        });
        if after {
            // λT + i(λ² − Ω²)/2α, of which the imaginary part for the mean is taken from 32 digits. (If the passing
            // lies before the start, the free motion takes off again what it leaves behind.)
            let alpha = drum.acceleration;
            let turned = direction(self.phase);
            let since = rate / alpha; // T
            let linear = Complex::new(since, self.mean / alpha);
            let exponent = |aside: Complex<f64>| {
                linear * aside + Complex::new(0.0, 0.5 / alpha) * aside * aside + self.mean * since
            };
            let tame = (EXPONENTIAL / linear.norm()).min(GAUSSIAN * alpha.sqrt());
            let left = self.divided(tame, |aside| turned * exponent(aside).exp() * 2.0);
            quotients = [quotients[0] + left[0], quotients[1] + left[1]];
        }
        let [position, velocity] = quotients.map(|quotient| drum.scale() * quotient);
        Shaft { position, velocity }
    }

    /// The divided differences of λ²f and λ³f between the two roots: as the mean over a circle about them
    /// (`eq:ramp-together`), or if they are not close enough for that, as they stand. f takes λ less the mean.
    fn divided(&self, radius: f64, f: impl Fn(Complex<f64>) -> Complex<f64>) -> [Complex<f64>; 2] {
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

/// The radius of a circle about an argument of this size on which Faddeeva's function is tame: there it is almost the
/// algebraic i/√π x, of the way to whose pole a part is near enough, and beside that as `e^{−x²}` on the real axis.
fn radius(size: f64) -> f64 {
    let gaussian = 1.8 * (size * size / POINTS as f64).exp() / size;
    (APART * size).min(gaussian).max(FADDEEVA)
}

//! Many people with a coin: the part of tosses that show the same face, when no hand twists like another.

use super::steady_face_ratio;
use crate::faddeeva::faddeeva;
use crate::gauss::GAUSS;
use crate::inertia::PrincipalMoments;
use crate::quantity::InvalidQuantity;
use nalgebra::Complex;
use std::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2, FRAC_PI_2, TAU};

/// People who toss a coin, each with a ratio of twist to tumble, s = ω₃/ω₁, of his own: over the people it is spread
/// like a Gaussian.
///
/// ```
/// use mechanics::inertia::Body;
/// use mechanics::scenes::coin_toss::{Tossers, TossersParameters};
/// let moments = Body::thin_disk(0.0075, 0.0122)?.moments();
/// let tossers = Tossers::new(TossersParameters { moments, mean: 0.0, spread: 0.01 })?;
/// // The bias goes with the mean square of the twist (eq:people-mean).
/// let bias = tossers.same_face_probability() - 0.5;
/// assert!((bias / (4e-4 / std::f64::consts::PI) - 1.0).abs() < 1e-4);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tossers {
    threshold: f64, // I₁/I₃: with more twist the coin never shows its other face
    mean: f64,
    spread: f64,
}

/// A coin, and how twist over tumble is spread over those who toss it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TossersParameters {
    /// Principal moments of the coin, whose axis of symmetry is axis 3.
    pub moments: PrincipalMoments,
    /// The mean s₀ of twist over tumble, of either sign.
    pub mean: f64,
    /// Its standard deviation S over the people, more than zero.
    pub spread: f64,
}

/// How often a coin fell on the side that was up in the hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TossCount {
    /// Tosses that show the same face.
    pub same: u32,
    /// Tosses that show the other.
    pub other: u32,
}

impl TossCount {
    /// All tosses.
    #[must_use]
    pub fn tosses(&self) -> f64 {
        f64::from(self.same) + f64::from(self.other)
    }
}

/// By how much the logarithm of the integrand may vary within a panel, at most, for Gauss's rule.
const VARIATION: f64 = 2.0;

/// A panel counts for nothing if the logarithm of what it may add is so much less than that of all others.
const NEGLIGIBLE: f64 = 32.0;

/// No panel is narrower, as an angle, and no spread, as a part of I₁/I₃.
const NARROWEST: f64 = 1e-13;
const NARROWEST_SPREAD: f64 = 1e-9;

impl Tossers {
    /// The people. A spread below 1e-9 I₁/I₃ counts as so much: all people are alike then.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the coin has no axis of symmetry along 3, or a number breaks its rule.
    pub fn new(parameters: TossersParameters) -> Result<Self, InvalidQuantity> {
        let TossersParameters { moments, mean, spread } = parameters;
        let threshold = steady_face_ratio(moments)?;
        InvalidQuantity::check("mean of twist over tumble", mean, "")?;
        InvalidQuantity::check_positive("spread of twist over tumble", spread, "")?;
        Ok(Self { threshold, mean, spread: spread.max(NARROWEST_SPREAD * threshold) })
    }

    /// The probability that somebody's toss shows the same face, the mean of `eq:same-face` over the people
    /// (`eq:people-mean`); to 1e-8 if the spread is from a thousandth to a third.
    #[must_use]
    pub fn same_face_probability(&self) -> f64 {
        self.ln_mean(&TossCount { same: 1, other: 0 }).exp()
    }

    /// The natural logarithm of the likelihood of what was counted, a number of tosses for each of some people,
    /// compared with what it would be if each had exactly the probability that he shows (`eq:people-likelihood`).
    /// Never above zero but by rounding, and never infinite; to 1e-8 a person for up to a hundred thousand tosses of
    /// his, if the spread is from a thousandth to a third and the mean at most one in size.
    #[must_use]
    pub fn log_likelihood(&self, counts: &[TossCount]) -> f64 {
        let of = |counted: &TossCount| self.ln_mean(counted) - counted.ln_likelihood(counted.other_share());
        counts.iter().map(of).fold(0.0, |sum, person| sum + person)
    }

    /// The logarithm of the mean over the people of p^k (1 − p)^(n − k).
    ///
    /// The integral over the twist, to either side, is one over the angle v of s = (I₁/I₃) sin v, in which
    /// `eq:same-face` has no corner: `cot²θ_L = sin²v`. Halve panels until the integrand hardly varies in each. Both
    /// factors of it have one peak, so that their values at the ends of a panel, and at the peaks within, bound it
    /// there: no peak is missed.
    fn ln_mean(&self, counted: &TossCount) -> f64 {
        let Self { threshold, mean, spread } = *self;
        let mut sum = LnSum::ZERO;
        for mean in [mean, -mean] {
            if counted.other == 0 {
                sum.add(ln_beyond((threshold - mean) / spread));
            }
            let deviation = |v: f64| (threshold * v.sin() - mean) / spread;
            let ln_bell = |deviation: f64| -0.5 * deviation * deviation;
            let panel = |from: f64, to: f64| {
                let [[left, right], [more, less]] =
                    [[deviation(from), deviation(to)], [other_face(from), other_face(to)]];
                let likeliest = counted.other_share().max(less).min(more);
                let high = ln_bell(left.max(0.0).min(right)) + counted.ln_likelihood(likeliest);
                let low = ln_bell(left).min(ln_bell(right))
                    + counted.ln_likelihood(less).min(counted.ln_likelihood(more));
                Panel { from, to, low, high }
            };
            let mut panels = vec![panel(0.0, FRAC_PI_2)];
            while let Some(Panel { from, to, low, high }) = panels.pop() {
                let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
                if high + (threshold / spread * half).ln() < sum.ln() - NEGLIGIBLE {
                    continue;
                }
                if high - low > VARIATION && half > NARROWEST {
                    let [first, second] = [panel(from, middle), panel(middle, to)];
                    // The higher of the two comes first: beside it the other may count for nothing.
                    panels.extend(if first.high < second.high { [first, second] } else { [second, first] });
                    continue;
                }
                for (node, weight) in GAUSS {
                    for v in [middle - half * node, middle + half * node] {
                        let width = weight * half * threshold * v.cos() / (spread * TAU.sqrt()); // ds = (I₁/I₃) cos v dv
                        sum.add(width.ln() + ln_bell(deviation(v)) + counted.ln_likelihood(other_face(v)));
                    }
                }
            }
        }
        sum.ln()
    }
}

impl TossCount {
    fn other_share(&self) -> f64 {
        f64::from(self.other) / self.tosses()
    }

    /// The logarithm of (1 − q)^k q^(n − k), where 0 ln 0 is 0.
    fn ln_likelihood(&self, other_face: f64) -> f64 {
        let times = |count: u32, ln: f64| if count == 0 { 0.0 } else { f64::from(count) * ln };
        times(self.same, (-other_face).ln_1p()) + times(self.other, other_face.ln())
    }
}

/// Angles from one to another, and between which values the logarithm of the integrand lies there.
#[derive(Debug, Clone, Copy)]
struct Panel {
    from: f64,
    to: f64,
    low: f64,
    high: f64,
}

/// The probability 1 − p that a toss with s = (I₁/I₃) sin v shows the other face, arccos(sin²v)/π (`eq:same-face`).
fn other_face(v: f64) -> f64 {
    2.0 * FRAC_1_PI * (v.cos() * FRAC_1_SQRT_2).asin()
}

/// The logarithm of the part of a Gaussian beyond so many standard deviations.
fn ln_beyond(deviations: f64) -> f64 {
    let y = FRAC_1_SQRT_2 * deviations;
    let ln_half_erfc = |y: f64| (0.5 * faddeeva(Complex::new(0.0, y)).re).ln() - y * y; // for y ≥ 0
    if y < 0.0 { (-ln_half_erfc(-y).exp()).ln_1p() } else { ln_half_erfc(y) }
}

/// A sum of positive numbers of any size, which are given by their logarithms.
#[derive(Debug, Clone, Copy)]
struct LnSum {
    largest: f64,
    parts: f64, // the sum in units of the largest
}

impl LnSum {
    const ZERO: Self = Self { largest: f64::NEG_INFINITY, parts: 0.0 };

    fn add(&mut self, ln: f64) {
        if ln > self.largest {
            self.parts *= (self.largest - ln).exp();
            self.largest = ln;
        }
        self.parts += (ln - self.largest).exp();
    }

    fn ln(&self) -> f64 {
        self.largest + self.parts.ln()
    }
}

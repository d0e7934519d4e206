//! Many people with a coin: the part of tosses that show the same face, when no hand twists like another.

use super::steady_face_ratio;
use crate::inertia::PrincipalMoments;
use crate::quantity::InvalidQuantity;
use std::f64::consts::{FRAC_1_PI, TAU};

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
#[derive(Debug, Clone, PartialEq)]
pub struct Tossers {
    nodes: Vec<Node>,
    certain: f64, // the part of the people whose coin never shows its other face
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
pub struct Counted {
    /// Tosses that show the same face.
    pub same: u32,
    /// Tosses that show the other.
    pub other: u32,
}

impl Counted {
    /// All tosses.
    pub fn tosses(&self) -> f64 {
        f64::from(self.same) + f64::from(self.other)
    }
}

/// A part of the people, and what their coins do.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Node {
    part: f64,
    probability: f64,
    ln_same: f64,
    ln_other: f64,
}

/// Into how many steps the spread of the twist is divided, an even number.
const STEPS: u32 = 2000;

/// How many standard deviations of it are looked at, to either side.
const REACH: f64 = 9.0;

impl Tossers {
    /// The people.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the coin has no axis of symmetry along 3, or a number breaks its rule.
    pub fn new(parameters: TossersParameters) -> Result<Self, InvalidQuantity> {
        let TossersParameters { moments, mean, spread } = parameters;
        let threshold = steady_face_ratio(moments)?;
        InvalidQuantity::check("mean of twist over tumble", mean, "")?;
        InvalidQuantity::check_positive("spread of twist over tumble", spread, "")?;
        // Simpson's rule in the angle v of s = (I₁/I₃) sin v, in which eq:same-face has no corner: cot²ψ = sin²v.
        let end = |sign: f64| ((mean + sign * REACH * spread) / threshold).clamp(-1.0, 1.0).asin();
        let (from, to) = (end(-1.0), end(1.0));
        let step = (to - from) / f64::from(STEPS);
        let node = |n: u32| {
            let (sin, cos) = (from + f64::from(n) * step).sin_cos();
            let weight = match n {
                0 | STEPS => 1.0,
                _ if n.is_multiple_of(2) => 2.0,
                _ => 4.0,
            };
            let deviation = (threshold * sin - mean) / spread;
            let density = (-0.5 * deviation * deviation).exp() / (spread * TAU.sqrt());
            let bias = FRAC_1_PI * (sin * sin).asin();
            Node {
                part: weight * step / 3.0 * density * threshold * cos, // ds = (I₁/I₃) cos v dv
                probability: 0.5 + bias,
                ln_same: (0.5 + bias).ln(),
                ln_other: (0.5 - bias).ln(),
            }
        };
        let nodes: Vec<Node> = (0..=STEPS).map(node).collect();
        let flipping: f64 = nodes.iter().map(|node| node.part).sum();
        Ok(Self { nodes, certain: (1.0 - flipping).max(0.0) })
    }

    /// The probability that somebody's toss shows the same face, the mean of `eq:same-face` over the people
    /// (`eq:people-mean`); to 1e-8 if the spread is from a thousandth to a third.
    pub fn same_face_probability(&self) -> f64 {
        self.certain + self.nodes.iter().map(|node| node.part * node.probability).sum::<f64>()
    }

    /// The natural logarithm of the likelihood of what was counted, a number of tosses for each of some people,
    /// compared with what it would be if each had exactly the probability that he shows (`eq:people-likelihood`).
    /// Never above zero but by rounding; to 1e-6 for up to a hundred thousand tosses a person, if the spread is a
    /// hundredth or more.
    pub fn log_likelihood(&self, counts: &[Counted]) -> f64 {
        counts.iter().map(|counted| self.likelihood(counted).ln()).sum()
    }

    /// The mean over the people of p^k (1 − p)^(n − k), in units of its largest.
    fn likelihood(&self, counted: &Counted) -> f64 {
        let (same, other, all) = (f64::from(counted.same), f64::from(counted.other), counted.tosses());
        // 0 ln 0 is 0.
        let times_ln = |count: f64, ln: f64| if count == 0.0 { 0.0 } else { count * ln };
        let largest = times_ln(same, (same / all).ln()) + times_ln(other, (other / all).ln());
        let of =
            |node: &Node| (times_ln(same, node.ln_same) + times_ln(other, node.ln_other) - largest).exp();
        let certain = if other == 0.0 { self.certain } else { 0.0 };
        certain + self.nodes.iter().map(|node| node.part * of(node)).sum::<f64>()
    }
}

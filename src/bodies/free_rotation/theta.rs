//! The theta function that the heading of a free body's axis follows.

use nalgebra::Complex;
use std::f64::consts::{FRAC_PI_2, PI};

/// The factor `is ϑ₁(v − iη)` of `eq:beyond-steady`, up to a positive number, with `v = πu/2K` and `η = πy₀/2K`.
///
/// Its nome `q = e^{−πK'/K}` is small where K is not much larger than K'. Elsewhere Jacobi's imaginary transformation
/// gives the same direction from the nome `q' = e^{−πK/K'}` (`eq:theta-imaginary`). So the nome is never above e^−π.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Theta {
    pub(crate) side: Side,
    pub(crate) nome: f64,          // q or q'
    pub(crate) shift: f64,         // η or η' = πy₀/2K'
    pub(crate) sense: f64,         // s
    pub(crate) quarter: f64,       // K, infinite on the separatrix
    pub(crate) other_quarter: f64, // K'
}

/// Which of the two series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// `k² ≤ ½`: circular functions of u.
    Circular,
    /// `k² > ½`: hyperbolic functions of u.
    Hyperbolic,
}

impl Theta {
    /// From k², K, K', the sign s and the zero `y₀` of `eq:tip-zero`.
    pub(crate) fn new(parameter: f64, [quarter, other_quarter]: [f64; 2], sense: f64, zero: f64) -> Self {
        let (side, first, second) = if parameter <= 0.5 {
            (Side::Circular, quarter, other_quarter)
        } else {
            (Side::Hyperbolic, other_quarter, quarter)
        };
        let (nome, shift) = ((-PI * second / first).exp(), FRAC_PI_2 * zero / first);
        Self { side, nome, shift, sense, quarter, other_quarter }
    }

    /// The direction at `u` from −K to K: a complex number of any length whose real part is positive where u is zero.
    pub(crate) fn direction(&self, u: f64) -> Complex<f64> {
        let Self { nome, shift, sense: s, quarter, other_quarter, .. } = *self;
        match self.side {
            Side::Circular => {
                let v = FRAC_PI_2 * u / quarter;
                Complex::i() * s * theta_1(Complex::new(v, -shift), nome) // eq:tip-theta
            }
            Side::Hyperbolic => {
                // Further out tanh v' is one to rounding, and so are the ratios of the terms: the direction no longer
                // changes.
                let v = (FRAC_PI_2 * u / other_quarter).clamp(-FAR, FAR);
                s * Complex::cis(shift * u / quarter) * theta_1(Complex::new(shift, v), nome) // eq:theta-imaginary
            }
        }
    }
}

const FAR: f64 = 40.0;

/// `Σ (−1)^j q^{j(j+1)} sin (2j+1)z`, which is `ϑ₁(z, q)/2q^{1/4}` (`eq:theta-series`), for q up to e^−π and
/// `|Im z| ≤ ½ ln(1/q)`.
///
/// As `sin (2j+1)z / sin z` is a sum of 2j+1 powers of `e^{iz}`, none beyond `e^{2j|Im z|} ≤ q^{−j}`, term j is at
/// most `(2j+1) q^{j²}` of the first. Four terms leave out less than 2e-21.
fn theta_1(z: Complex<f64>, nome: f64) -> Complex<f64> {
    let first = z.sin();
    let twice_cos = 2.0 - 4.0 * first * first; // 2 cos 2z
    let (mut sum, mut before, mut term, mut power) = (first, first, first, 1.0);
    for _ in 1..4 {
        // From sin (2j+3)z = 2 cos 2z sin (2j+1)z − sin (2j−1)z, with the weights in it, so that nothing overflows.
        let next = power * nome * nome; // q^{2j+2}
        (before, term) = (term, -next * (twice_cos * term + power * before));
        power = next;
        sum += term;
    }
    sum
}

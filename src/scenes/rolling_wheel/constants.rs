//! What stays constant as a wheel rolls.

use super::wheel::Wheel;
use crate::conical::ConicalValues;
use crate::rolling::{MomentFactors, Rolling, sin_cos_lean};
use std::f64::consts::FRAC_PI_2;

/// What stays constant as a wheel rolls, with the energy: the coefficients of the two conical functions, rad/s
/// (`eq:chaplygin`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingConstants {
    /// The coefficient A of the even function.
    pub even: f64,
    /// The coefficient B of the odd function.
    pub odd: f64,
}

impl Wheel {
    /// The constants of a motion (`eq:chaplygin`, solved for A and B with Wronski's determinant, `(1 − X²)(n₊ n₋′ −
    /// n₊′ n₋) = 1`). With [`Wheel::at_tilt`] exact to 40 units in the last place of the sums of the closed form
    /// without their signs.
    #[must_use]
    pub fn constants(&self, state: &Rolling) -> RollingConstants {
        let Rolling { omega_2: q, omega_3: n, .. } = *state;
        let (_, cos) = sin_cos_lean(state.tilt);
        let ConicalValues { even, even_slope, odd, odd_slope } = self.conical_functions(state.tilt);
        let MomentFactors { axial: i3, .. } = self.disk.parameters.moments;
        let slope = q * cos / (1.0 + i3); // (1 − X²) dn/dX
        let square = cos * cos;
        RollingConstants {
            even: square * n * odd_slope - slope * odd,
            odd: slope * even - square * n * even_slope,
        }
    }

    /// The state at a tilt from lying flat, rad, of a motion with these constants whose lean turns there, ω₁ = 0, above
    /// the origin and with axis 1 along x (`eq:chaplygin`). Its ω₂ and ω₃ are sums of a part of the even and one of the
    /// odd constant, which lose digits where these nearly cancel.
    #[must_use]
    pub fn at_tilt(&self, constants: &RollingConstants, tilt: f64) -> Rolling {
        let &RollingConstants { even: a, odd: b } = constants;
        let (_, cos) = sin_cos_lean(tilt);
        let ConicalValues { even, even_slope, odd, odd_slope } = self.conical_functions(tilt);
        let MomentFactors { axial: i3, .. } = self.disk.parameters.moments;
        Rolling {
            tilt,
            omega_2: (1.0 + i3) * cos * (a * even_slope + b * odd_slope),
            omega_3: a * even + b * odd,
            ..Rolling::UPRIGHT
        }
    }

    /// The effective potential of the lean, J, at a tilt from lying flat, rad: the energy of [`Wheel::at_tilt`]
    /// (`eq:effective-potential`).
    #[must_use]
    pub fn potential(&self, constants: &RollingConstants, tilt: f64) -> f64 {
        self.energy(&self.at_tilt(constants, tilt))
    }

    /// The conical functions at X = sin θ, with 1 − |X| = 1 − |cos α| without a difference.
    fn conical_functions(&self, tilt: f64) -> ConicalValues {
        let half = 0.5 * tilt;
        let root = if tilt < FRAC_PI_2 { half.sin() } else { half.cos() };
        self.conical.at(sin_cos_lean(tilt).0, 2.0 * root * root)
    }
}

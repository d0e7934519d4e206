//! Which circles are stable.

use super::wheel::Wheel;
use crate::quantity::{InvalidQuantity, Rule};
use crate::rolling::MomentFactors;
use std::f64::consts::FRAC_PI_2;

impl Wheel {
    /// The lean, rad, from which on steady rolling is stable on every circle there is: the tip of the tongue of
    /// unstable motions (`eq:safe-lean`). It lies between 17.6° and 45°, whatever the moments. Exact to 4 units in the
    /// last place.
    #[must_use]
    pub fn safe_lean(&self) -> f64 {
        let MomentFactors { transverse: i1, axial: i3 } = self.parameters().moments;
        let rho = i3 / i1;
        let root = (3.0 * i3 * (1.0 + i3) + rho * (1.0 + 3.0 * i3 + rho)).sqrt();
        (0.5 * (1.0 + i3) / (1.0 + 2.0 * i3 + rho + root)).sqrt().asin()
    }

    /// The radii of the centre's circle, m, between which steady rolling with a lean θ, rad, is unstable, the smaller
    /// first (`eq:tongue-edges`); none where every circle is stable. Near the tip of the tongue, where the two meet,
    /// they have half of the digits.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the lean is not between upright and flat.
    pub fn unstable_circles(&self, lean: f64) -> Result<Option<[f64; 2]>, InvalidQuantity> {
        InvalidQuantity::check_positive("lean", lean, "rad")?;
        let flat = Rule::Because("a wheel rolls at less than π/2 from the upright");
        InvalidQuantity::require(lean < FRAC_PI_2, "lean", lean, "rad", flat)?;
        let parameters = self.parameters();
        let MomentFactors { transverse: i1, axial: i3 } = parameters.moments;
        let (s, c) = lean.sin_cos();
        let square = (i3 / i1) * (1.0 + i3);
        let h = ((1.0 + i3) * c * c - (1.0 + 3.0 * i3) * s * s) / s;
        let rest = c * c + 3.0 * i1 * s * s;
        let discriminant = h * h - 4.0 * square * rest;
        if h <= 0.0 || discriminant <= 0.0 {
            return Ok(None);
        }
        // The product of the two is rest/square: no difference for the smaller.
        let sum = h + discriminant.sqrt();
        Ok(Some([2.0 * rest / sum, sum / (2.0 * square)].map(|b| b * parameters.radius)))
    }
}

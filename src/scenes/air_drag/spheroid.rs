//! What slow, viscous air does to a spheroid that turns in it.

use super::Drag;
use crate::inertia::Spheroid;
use crate::quantity::InvalidQuantity;
use std::f64::consts::PI;

impl Drag {
    /// The drag of a spheroid that turns slowly in a fluid of viscosity μ, Pa·s, without bounds (`eq:spheroid-drag`,
    /// from Jeffery's paper of 1922). Each coefficient to 1e-14 of itself. "Slowly" means that the Reynolds number,
    /// density times rate times the square of the larger radius over the viscosity, is well below one.
    ///
    /// ```
    /// use mechanics::inertia::Spheroid;
    /// use mechanics::scenes::air_drag::Drag;
    /// // Stokes's ball, 8πμa³ about every axis.
    /// let ball = Spheroid { equatorial_radius: 2.0, polar_radius: 2.0 };
    /// let drag = Drag::of_spheroid(ball, 1.0)?;
    /// assert!((drag.axial / (64.0 * std::f64::consts::PI) - 1.0).abs() < 1e-15);
    /// assert_eq!(drag.axial, drag.transverse);
    /// # Ok::<(), mechanics::InvalidQuantity>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a radius or the viscosity is not positive, or of a size that cannot be computed with.
    pub fn of_spheroid(spheroid: Spheroid, viscosity: f64) -> Result<Self, InvalidQuantity> {
        let Spheroid { equatorial_radius, polar_radius } = spheroid;
        InvalidQuantity::check_positive("equatorial radius", equatorial_radius, "m")?;
        InvalidQuantity::check_positive("polar radius", polar_radius, "m")?;
        InvalidQuantity::check_positive("viscosity", viscosity, "Pa·s")?;
        let ratio = polar_radius / equatorial_radius;
        let because = "over the equatorial radius it gives a ratio outside 1e-50 to 1e50";
        InvalidQuantity::require_computable(ratio, "polar radius", polar_radius, "m", because)?;
        let (equatorial, polar) = integrals(ratio);
        // eq:spheroid-drag, in units of the equatorial radius.
        let scale = 16.0 / 3.0 * PI * viscosity * equatorial_radius.powi(3);
        let transverse = scale * (1.0 + ratio * ratio) / (equatorial + ratio * ratio * polar);
        let axial = scale / equatorial;
        for drag in [transverse, axial] {
            let because = "with these radii it gives a drag outside 1e-50 to 1e50 N·m·s";
            InvalidQuantity::require_computable(drag, "viscosity", viscosity, "Pa·s", because)?;
        }
        Ok(Self { transverse, axial })
    }
}

/// The integrals A and B of `eq:spheroid-integrals` for an equatorial radius of one and a polar radius η.
fn integrals(ratio: f64) -> (f64, f64) {
    // 1 − 1/η², written so that it keeps its digits.
    let square = (ratio - 1.0) * (ratio + 1.0);
    let m = square / (ratio * ratio);
    if m.abs() < 0.3 {
        // Nearly a ball: both integrands as powers of m, ∫ x² Σ (n+1) mⁿ x²ⁿ dx and ∫ x² Σ mⁿ x²ⁿ dx.
        let (mut power, mut sums) = (1.0, (0.0, 0.0));
        for n in 0..32 {
            let n = f64::from(n);
            let term = power / (2.0 * n + 3.0);
            sums = (sums.0 + (n + 1.0) * term, sums.1 + term);
            power *= m;
        }
        let scale = 2.0 / ratio.powi(3);
        return (scale * sums.0, scale * sums.1);
    }
    // eq:spheroid-arc
    let arc = if ratio > 1.0 { ratio.acosh() / square.sqrt() } else { ratio.acos() / (-square).sqrt() };
    ((ratio - arc) / square, 2.0 * (arc - 1.0 / ratio) / square)
}

//! A coin with an edge that lands without a bounce: heads, tails or edge.

use super::Toss;
use crate::inertia::Cylinder;
use crate::quantity::InvalidQuantity;
use std::f64::consts::FRAC_2_PI;

/// How often a coin lands on each of its three sides. Together they are one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Landings {
    /// The side that was up in the hand is up again.
    pub same: f64,
    /// The coin stands on its edge.
    pub edge: f64,
    /// The other side is up.
    pub other: f64,
}

impl Toss {
    /// How often a coin of this shape lands on each side, if the moment of the landing is as good as random and the
    /// coin stays on the side that then lies under its centre (`eq:edge-any`). The shape says what lies there; how the
    /// coin turns follows from the moments of the toss. Each to 2e-15, or to 2e-16/√((1 − sin β)d) if that is more,
    /// where d is how far the lowest height of the normal is from the nearer of the borders sin β and −sin β: a share
    /// beyond a border hangs on the root of d, and has half the digits where the normal just reaches it.
    ///
    /// ```
    /// use mechanics::inertia::{Body, Cylinder};
    /// use mechanics::scenes::coin_toss::{Toss, TossParameters};
    /// // As thick as its diameter, and tumbled: the edge lies below for half of the time.
    /// let coin = Cylinder { radius: 0.01, height: 0.02 };
    /// let moments = Body::cylinder(0.01, coin)?.moments();
    /// let toss = Toss::new(TossParameters { moments, omega_1: 40.0, omega_3: 0.0 })?;
    /// assert!((toss.landings(coin)?.edge - 0.5).abs() < 1e-15);
    /// # Ok::<(), mechanics::InvalidQuantity>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the radius is not positive, the height negative, or either of a size that cannot be
    /// computed with.
    pub fn landings(&self, coin: Cylinder) -> Result<Landings, InvalidQuantity> {
        let (sin, rest) = sine_of_edge(coin)?; // sin β and 1 − sin β
        let lowest = self.lowest_normal();
        // Half the angles Λt at which the normal has the heights sin β and −sin β (eq:edge-any), as in eq:edge-half.
        let [above, below] = [(sin - lowest).max(0.0).sqrt(), (-sin - lowest).max(0.0).sqrt()];
        let [near, far] = [rest.sqrt(), (1.0 + sin).sqrt()];
        // The difference of the two, without subtracting angles.
        let between = if below > 0.0 {
            let sine = 2.0 * sin * (1.0 - lowest) / (far * above + near * below);
            sine.atan2(below * above + near * far)
        } else {
            above.atan2(near)
        };
        let [same, edge, other] = [near.atan2(above), between, below.atan2(far)].map(|half| FRAC_2_PI * half);
        Ok(Landings { same, edge, other })
    }

    /// How often a coin of this shape lands on its edge in the limit of thin coins: `2 sin β/(π √(−cos 2θ_L))`
    /// (`eq:edge-thin`); `None` if the normal never crosses the horizon. It grows without bound towards `θ_L = 45°`, so
    /// that it is no probability there.
    ///
    /// ```
    /// use mechanics::inertia::{Body, Cylinder};
    /// use mechanics::scenes::coin_toss::{Toss, TossParameters};
    /// let nickel = Cylinder { radius: 10.605e-3, height: 1.95e-3 };
    /// let moments = Body::cylinder(5e-3, nickel)?.moments();
    /// let tumble = Toss::new(TossParameters { moments, omega_1: 40.0, omega_3: 0.0 })?;
    /// let thin = tumble.thin_edge(nickel)?.ok_or("it turns over")?;
    /// assert_eq!(format!("{:.2} %", 100.0 * thin), "5.83 %"); // and not 5.84, as for no thin coin
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Toss::landings`].
    pub fn thin_edge(&self, coin: Cylinder) -> Result<Option<f64>, InvalidQuantity> {
        let (sin, _) = sine_of_edge(coin)?;
        let lowest = self.lowest_normal(); // cos 2θ_L
        Ok((lowest < 0.0).then(|| FRAC_2_PI * sin / (-lowest).sqrt()))
    }
}

/// How often a coin of this shape stands on its edge if every attitude is as likely as every other: `sin β`
/// (`eq:edge-area`), to 5e-16 of itself.
///
/// # Errors
/// As [`Toss::landings`].
pub fn edge_at_random(coin: Cylinder) -> Result<f64, InvalidQuantity> {
    Ok(sine_of_edge(coin)?.0)
}

/// The sine of the angle under which half of the edge is seen from the centre, and what it lacks to one.
fn sine_of_edge(Cylinder { radius, height }: Cylinder) -> Result<(f64, f64), InvalidQuantity> {
    InvalidQuantity::check_positive("radius", radius, "m")?;
    InvalidQuantity::check_not_negative("height", height, "m")?;
    let ratio = 0.5 * height / radius; // tan β, eq:edge-angle
    let because = "over the diameter it gives a ratio outside 1e-50 to 1e50";
    InvalidQuantity::require_computable(ratio, "height", height, "m", because)?;
    let diagonal = ratio.hypot(1.0);
    Ok((ratio / diagonal, 1.0 / (diagonal * (diagonal + ratio))))
}

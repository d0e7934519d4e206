//! Where a slow loss carries a steady motion.

use super::steady::SteadyRolling;
use crate::rolling::{DiskParameters, MomentFactors};
use nalgebra::Vector3;

/// How steady rolling changes while a weak torque acts on the wheel.
///
/// ```
/// use mechanics::rolling::{DiskParameters, MomentFactors};
/// use mechanics::scenes::rolling_wheel::Wheel;
/// let (mass, radius, gravity) = (1.0, 0.34, 9.81);
/// let hoop = Wheel::new(DiskParameters { mass, radius, moments: MomentFactors::HOOP, gravity })?;
/// let steady = hoop.steady(20_f64.to_radians(), 2.0)?;
/// // Air takes 1 mN·m from the spin about the axle: the hoop leans over, and its circle shrinks.
/// let brake = nalgebra::Vector3::new(0.0, 0.0, -1e-3 * steady.omega().z.signum());
/// let sinking = steady.sinking(brake);
/// assert_eq!(format!("{:.2} °/min", 60.0 * sinking.lean_rate.to_degrees()), "0.25 °/min");
/// assert_eq!(format!("{:.2} mm/s", 1e3 * sinking.circle_rate), "-3.52 mm/s");
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SinkingRates {
    /// The rate of the lean θ, rad/s.
    pub lean_rate: f64,
    /// The rate of the radius b of the centre's circle, m/s.
    pub circle_rate: f64,
}

impl SteadyRolling {
    /// How the steady motion changes under a weak torque about the centre, N·m, along axes 1, 2, 3 (`eq:sinking`). What
    /// a brake takes has negative components. The component along axis 1 only shifts the lean by a little and does not
    /// matter here.
    ///
    /// This is the limit of a weak torque: the error is of its second order, as long as the lean and the circle change
    /// little in the time of a wobble. At the edge of the tongue, where the wobble's rate is zero, the rates are
    /// infinite; inside it they say nothing.
    #[must_use]
    pub fn sinking(&self, torque: Vector3<f64>) -> SinkingRates {
        let DiskParameters { mass: m, radius: a, moments, .. } = self.wheel.parameters();
        let MomentFactors { transverse: i1, axial: i3 } = moments;
        let (sin, cos) = self.lean.sin_cos();
        let (q, n) = (self.omega().y, self.omega().z);
        let taken = -torque / (m * a * a);
        let curvature = (1.0 + i1) * self.wobble_square();
        // eq:sinking
        let lean_rate = ((2.0 * q * sin / cos + (1.0 + i3) * n / i1) * taken.y + q * taken.z) / curvature;
        // eq:slowed-spins
        let q_rate = lean_rate * (q * sin / cos + i3 / i1 * n) - taken.y / i1;
        let n_rate = (lean_rate * q - taken.z) / (1.0 + i3);
        // b = a n cos θ / q, eq:true-spin
        let circle_rate = a * (cos * (n_rate * q - n * q_rate) / (q * q) - sin * lean_rate * n / q);
        SinkingRates { lean_rate, circle_rate }
    }
}

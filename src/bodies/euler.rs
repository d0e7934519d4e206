//! How any rigid body turns: Euler's equations, and the attitude that follows.
//!
//! The state of a turning body is its attitude and its angular velocity, seven numbers: four of a unit quaternion
//! `world_from_body`, in the order w, x, y, z, then three of `omega_body`, rad/s. [`Turning`] gives them names.

use crate::attitude::quaternion_rate;
use crate::inertia::PrincipalMoments;
use crate::integrate::{Expand, Series, TAYLOR_ORDER};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// The angular acceleration along the body's axes, rad/s², under a torque about the centre of mass (or about a fixed
/// point, with the moments about that point), N·m, along the same axes: `Iω̇ = τ − ω × Iω` (`eq:euler-rates`).
///
/// ```
/// use mechanics::{euler, inertia::PrincipalMoments};
/// use mechanics::nalgebra::Vector3;
/// // Left to itself, a body keeps spinning about a principal axis ...
/// let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
/// let at_rest = Vector3::zeros();
/// assert_eq!(euler::rates(&moments, &Vector3::new(0.0, 7.0, 0.0), &at_rest), at_rest);
/// // ... and about no other axis.
/// assert_ne!(euler::rates(&moments, &Vector3::new(0.1, 7.0, 0.0), &at_rest), at_rest);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[must_use]
pub fn rates(
    moments: &PrincipalMoments,
    omega_body: &Vector3<f64>,
    torque_body: &Vector3<f64>,
) -> Vector3<f64> {
    let [i1, i2, i3] = moments.to_array();
    let [w1, w2, w3]: [f64; 3] = (*omega_body).into();
    // The products of eq:euler-rates with the differences of the moments taken first: a sphere gives exactly nothing.
    let gyroscopic = Vector3::new((i2 - i3) * w2 * w3, (i3 - i1) * w3 * w1, (i1 - i2) * w1 * w2);
    (torque_body + gyroscopic).component_div(&Vector3::new(i1, i2, i3))
}

/// A turning body at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turning {
    /// The attitude.
    pub world_from_body: UnitQuaternion<f64>,
    /// Angular velocity along the body's axes, rad/s.
    pub omega_body: Vector3<f64>,
}

impl Turning {
    /// The seven numbers that an integrator steps.
    #[must_use]
    pub fn to_array(&self) -> [f64; 7] {
        let q = self.world_from_body;
        let w = self.omega_body;
        [q.w, q.i, q.j, q.k, w.x, w.y, w.z]
    }

    /// From an integrator's seven numbers. The quaternion is brought back to length one; one of length zero, which no
    /// integration of a rotation reaches, gives NaN.
    #[must_use]
    pub fn from_array([w, i, j, k, w1, w2, w3]: [f64; 7]) -> Self {
        let world_from_body = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
        Self { world_from_body, omega_body: Vector3::new(w1, w2, w3) }
    }

    /// Angular velocity along the axes of the room, rad/s.
    #[must_use]
    pub fn omega_world(&self) -> Vector3<f64> {
        self.world_from_body * self.omega_body
    }

    /// Angular momentum about the centre of mass along the axes of the room, kg·m²/s.
    #[must_use]
    pub fn angular_momentum_world(&self, moments: &PrincipalMoments) -> Vector3<f64> {
        self.world_from_body * moments.angular_momentum(&self.omega_body)
    }

    /// The direction of the body's axis 3 in the room.
    #[must_use]
    pub fn axis_3_world(&self) -> Vector3<f64> {
        self.world_from_body * Vector3::z()
    }
}

/// The rates of the seven numbers of [`Turning`] for a body of these moments under a torque that may depend on time,
/// attitude and angular velocity and is given along the body's axes, N·m (`eq:euler-rates`, `eq:quaternion-rate`).
///
/// The quaternion is used as it comes, without norming it, so the state may drift from length one within the error of
/// the method; [`Turning::from_array`] norms. To be given to [`crate::integrate::Dop853`].
///
/// ```
/// use mechanics::euler::{self, Turning};
/// use mechanics::{inertia::Body, integrate::Dop853};
/// use mechanics::nalgebra::{UnitQuaternion, Vector3};
/// let moments = Body::cuboid(1.0, [0.02, 0.1, 0.2])?.moments();
/// let start = Turning {
///     world_from_body: UnitQuaternion::identity(),
///     omega_body: Vector3::new(0.1, 20.0, 0.1), // almost about the middle axis
/// };
/// let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
/// let end = Dop853::new(1e-12)?.solve(free, 0.0, start.to_array(), 3.0)?;
/// let end = Turning::from_array(end.state);
/// let change = end.angular_momentum_world(&moments) - start.angular_momentum_world(&moments);
/// assert!(change.norm() < 1e-9 * start.angular_momentum_world(&moments).norm());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn turning_rates(
    moments: PrincipalMoments,
    mut torque_body: impl FnMut(f64, &Turning) -> Vector3<f64>,
) -> impl FnMut(f64, &[f64; 7]) -> [f64; 7] {
    move |time, state| {
        let &[w, i, j, k, w1, w2, w3] = state;
        let quaternion = Quaternion::new(w, i, j, k);
        let omega_body = Vector3::new(w1, w2, w3);
        let turning = Turning { world_from_body: UnitQuaternion::new_unchecked(quaternion), omega_body };
        let torque = torque_body(time, &turning);
        let turn = quaternion_rate(&quaternion, &omega_body);
        let spin = rates(&moments, &omega_body, &torque);
        [turn.w, turn.i, turn.j, turn.k, spin.x, spin.y, spin.z]
    }
}

/// The Taylor series of a free body's attitude and angular velocity, the seven numbers of [`Turning`], for
/// [`crate::integrate::Taylor`]: the rates of [`turning_rates`] without torque, coefficient by coefficient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeSeries {
    couplings: [f64; 3], // (I₂ − I₃)/I₁ and so on
}

impl FreeSeries {
    /// For a body with these moments.
    #[must_use]
    pub fn new(moments: &PrincipalMoments) -> Self {
        let [i1, i2, i3] = moments.to_array();
        Self { couplings: [(i2 - i3) / i1, (i3 - i1) / i2, (i1 - i2) / i3] }
    }
}

impl Expand<7> for FreeSeries {
    fn expand(&self, series: &mut Series<7>) {
        for n in 0..TAYLOR_ORDER {
            // The coefficients of the products ω₂ω₃, ω₃ω₁, ω₁ω₂ (eq:euler-rates) and of qω (eq:quaternion-rate).
            let (mut spins, mut turns) = ([0.0; 3], [0.0; 4]);
            for j in 0..=n {
                let [q0, q1, q2, q3, a1, a2, a3] = series[j];
                let [_, _, _, _, w1, w2, w3] = series[n - j];
                spins[0] += a2 * w3;
                spins[1] += a3 * w1;
                spins[2] += a1 * w2;
                turns[0] -= q1 * w1 + q2 * w2 + q3 * w3;
                turns[1] += q0 * w1 + q2 * w3 - q3 * w2;
                turns[2] += q0 * w2 + q3 * w1 - q1 * w3;
                turns[3] += q0 * w3 + q1 * w2 - q2 * w1;
            }
            let over = 1.0 / (n + 1) as f64;
            let [c1, c2, c3] = self.couplings;
            let [t0, t1, t2, t3] = turns.map(|turn| 0.5 * over * turn);
            series[n + 1] =
                [t0, t1, t2, t3, over * c1 * spins[0], over * c2 * spins[1], over * c3 * spins[2]];
        }
    }
}

//! The Lie-group method of order four without commutators.

use super::{check, exp, is_finite};
use crate::euler::{self, Turning};
use crate::inertia::PrincipalMoments;
use crate::integrate::Failure;
use nalgebra::Vector3;

/// Attitude and angular velocity at time `end`, s, of a body under a torque along its own axes, N·m, which may depend
/// on time and motion, by `steps` equal steps from `state` at time `start`.
///
/// The classical Runge–Kutta method, for the attitude with turns in place of sums (`eq:commutator-free`): the attitude
/// is a product of rotations and stays a unit quaternion to rounding. The angular velocity, which may be added, is
/// that of [`crate::integrate::rk4`], and neither energy nor angular momentum is kept. Four evaluations of the torque
/// a step, error of order four; that of the attitude of a brick that tumbles freely is 1.5 to 7 times smaller than
/// RK4's, but not that of any body at any time: of a pencil it was seen to be ten times larger. Works in either
/// direction of time.
///
/// Celledoni, Marthinsen & Owren, *Future Generation Computer Systems* **19** (2003) 341.
///
/// # Errors
/// [`Failure::Interval`], [`Failure::InitialState`] or [`Failure::NoSteps`] for bad input; [`Failure::NotFinite`] as
/// soon as a step leads to an infinity or NaN.
///
/// ```
/// use mechanics::{euler::Turning, geometric::commutator_free, inertia::Body};
/// use mechanics::nalgebra::{UnitQuaternion, Vector3};
/// let disc = Body::thin_disk(1.0, 0.2)?.moments();
/// let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(0.0, 0.0, 5.0) };
/// // A brake of 0.01 N·m about the axle stops 0.1 kg·m²/s in ten seconds, after 25 rad.
/// let brake = |_t: f64, _: &Turning| Vector3::new(0.0, 0.0, -0.01);
/// let end = commutator_free(&disc, brake, 0.0, start, 10.0, 50)?;
/// assert!(end.omega_body.norm() < 1e-13);
/// let expected = UnitQuaternion::from_scaled_axis(Vector3::new(0.0, 0.0, 25.0));
/// assert!(end.world_from_body.angle_to(&expected) < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn commutator_free(
    moments: &PrincipalMoments,
    mut torque_body: impl FnMut(f64, &Turning) -> Vector3<f64>,
    start: f64,
    state: Turning,
    end: f64,
    steps: usize,
) -> Result<Turning, Failure> {
    check(start, &state, end, steps)?;
    let h = (end - start) / steps as f64;
    let mut acceleration = |time: f64, turning: &Turning| {
        euler::rates(moments, &turning.omega_body, &torque_body(time, turning))
    };
    let mut now = state;
    for n in 0..steps {
        let time = start + n as f64 * h; // counted, not accumulated
        let next = step(&mut acceleration, time, &now, h);
        if !is_finite(&next) {
            return Err(Failure::NotFinite { time, state: now.to_array().to_vec(), step: h });
        }
        now = next;
    }
    Ok(now)
}

/// One step of `eq:commutator-free`, and of `eq:rk4` for the angular velocity.
fn step(
    acceleration: &mut impl FnMut(f64, &Turning) -> Vector3<f64>,
    time: f64,
    first: &Turning,
    h: f64,
) -> Turning {
    let Turning { world_from_body: q0, omega_body: w1 } = *first;
    let a1 = acceleration(time, first);
    let q2 = q0 * exp(&(w1 * (h / 2.0)));
    let w2 = w1 + a1 * (h / 2.0);
    let a2 = acceleration(time + h / 2.0, &Turning { world_from_body: q2, omega_body: w2 });
    let q3 = q0 * exp(&(w2 * (h / 2.0)));
    let w3 = w1 + a2 * (h / 2.0);
    let a3 = acceleration(time + h / 2.0, &Turning { world_from_body: q3, omega_body: w3 });
    let q4 = q2 * exp(&(w3 * h - w1 * (h / 2.0)));
    let w4 = w1 + a3 * h;
    let a4 = acceleration(time + h, &Turning { world_from_body: q4, omega_body: w4 });
    Turning {
        world_from_body: q0
            * exp(&((w1 * 3.0 + w2 * 2.0 + w3 * 2.0 - w4) * (h / 12.0)))
            * exp(&((-w1 + w2 * 2.0 + w3 * 2.0 + w4 * 3.0) * (h / 12.0))),
        omega_body: w1 + (a1 + a2 * 2.0 + a3 * 2.0 + a4) * (h / 6.0),
    }
}

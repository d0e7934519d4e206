//! The attitude of a body that spins down: the one thing here without a closed form.

use super::DraggedTop;
use crate::Error;
use crate::attitude::{check_attitude, quaternion_rate};
use crate::elementary::sin_cos_quarters;
use crate::euler::Turning;
use crate::integrate::Dop853;
use crate::quantity::InvalidQuantity;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A body that spins down, with its attitude: the angular velocity is the closed form, and only four numbers are
/// integrated, the attitude of a frame that shares the body's axis and in which the wobble keeps its direction. That
/// turns with **L**/I₁ (`eq:split`), so a long body's quick spin costs no steps.
///
/// ```
/// use mechanics::attitude::angle_between;
/// use mechanics::inertia::PrincipalMoments;
/// use mechanics::integrate::Dop853;
/// use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
/// use mechanics::nalgebra::{UnitQuaternion, Vector3};
/// // A flat disc, thrown with a wobble.
/// let (moments, drag) = (PrincipalMoments::symmetric(1.0, 2.0)?, Drag::isotropic(0.1));
/// let omega_body = Vector3::new(3.0, 0.0, 10.0);
/// let disc = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?;
/// let flight = disc.thrown(UnitQuaternion::identity(), &Dop853::new(1e-9)?)?;
/// let later = flight.at(20.0)?;
/// // Its angular momentum keeps its direction, and its axis goes there: 8.5° away at first, here after 20 s.
/// let momentum = Vector3::new(3.0, 0.0, 20.0);
/// let apart = |axis| angle_between(&axis, &momentum).to_degrees();
/// assert_eq!(format!("{:.1}°, {:.1}°", apart(Vector3::z()), apart(later.axis_3_world())), "8.5°, 3.2°");
/// # Ok::<(), mechanics::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThrownTop {
    top: DraggedTop,
    world_from_body: UnitQuaternion<f64>,
    solver: Dop853,
}

impl DraggedTop {
    /// The same motion as it is seen in the room, with the attitude `world_from_body` at time zero and a solver for it.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a quaternion that is not of length one to 1e-12.
    pub fn thrown(
        &self,
        world_from_body: UnitQuaternion<f64>,
        solver: &Dop853,
    ) -> Result<ThrownTop, InvalidQuantity> {
        check_attitude(&world_from_body)?;
        Ok(ThrownTop { top: *self, world_from_body, solver: *solver })
    }
}

impl ThrownTop {
    /// Attitude and angular velocity at `time`, s, zero or later. The attitude is as exact as the solver's tolerance
    /// makes it, and the whole way to that time is integrated: at most as many evaluations as the solver allows, ten
    /// million unless it is told otherwise, which are a second or two.
    ///
    /// # Errors
    /// [`Error`] for a time that [`DraggedTop::at`] refuses, and if the integration fails.
    pub fn at(&self, time: f64) -> Result<Turning, Error> {
        let omega_body = self.top.at(time)?;
        let end = self.solver.solve(|time, q| self.rates(time, q), 0.0, self.start(), time)?;
        Ok(self.turning(time, end.state, omega_body))
    }

    /// Attitudes and angular velocities at `times`, s, in ascending order, in one integration: the states of
    /// [`ThrownTop::at`] within the solver's tolerance.
    ///
    /// # Errors
    /// [`Error`] as for [`ThrownTop::at`], and for times that do not ascend.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Turning>, Error> {
        let omegas = self.top.sample(times)?;
        let (states, _) = self.solver.sample(|time, q| self.rates(time, q), 0.0, self.start(), times)?;
        let states = times.iter().zip(states).zip(omegas);
        Ok(states.map(|((time, q), omega_body)| self.turning(*time, q, omega_body)).collect())
    }

    /// The four numbers that the solver steps, at time zero.
    fn start(&self) -> [f64; 4] {
        let q = self.world_from_body;
        [q.w, q.i, q.j, q.k]
    }

    /// The rates of the frame's attitude.
    fn rates(&self, time: f64, &[w, i, j, k]: &[f64; 4]) -> [f64; 4] {
        let DraggedTop { start, transverse_decay, axial_decay, .. } = self.top;
        let [i1, _, i3] = self.top.moments.to_array();
        // L/I₁ by eq:spin-decay and eq:wobble-decay.
        let wobble = start.xy() * (-transverse_decay * time).exp();
        let omega_frame = Vector3::new(wobble.x, wobble.y, i3 / i1 * start.z * (-axial_decay * time).exp());
        let rate = quaternion_rate(&Quaternion::new(w, i, j, k), &omega_frame);
        [rate.w, rate.i, rate.j, rate.k]
    }

    /// The body in the frame that the solver has turned: the wobble goes round in it (`eq:wobble-phase`), so in the
    /// frame, where the wobble rests, it goes round the other way.
    fn turning(&self, time: f64, [w, i, j, k]: [f64; 4], omega_body: Vector3<f64>) -> Turning {
        let world_from_frame = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
        let (high, low) = self.top.body_turn.at(self.top.slowed(time).1);
        let (sin, cos) = sin_cos_quarters::<true>(0.5 * high, 0.5 * low);
        let frame_from_body = UnitQuaternion::new_unchecked(Quaternion::from_parts(cos, Vector3::z() * -sin));
        Turning { world_from_body: world_from_frame * frame_from_body, omega_body }
    }
}

//! Many frames of a body whose attitude is a steady turn about **L** and one about its own axis.

use crate::euler::Turning;
use crate::two_part::TwoPart;
use crate::wide::functions::{Clock, sin_cos_quarters};
use crate::wide::{Branchless, several_at_once};
use nalgebra::{Matrix4, Quaternion, UnitQuaternion, Vector3, Vector4};

/// The motion `q(t) = start · turn(first, Λt) · turn(second, −σt) · then`, in numbers that make a frame of few operations
/// (`eq:top-motion`, `eq:body-cone`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TwoTurns {
    about_first: Clock,  // half of Λt
    about_second: Clock, // half of σt
    /// Takes the products cc, sc, cs, ss of the cosines and sines of both to the quaternion, scalar last.
    attitude: Matrix4<f64>,
    /// ω along the body's axes: what stays, and what goes with cos σt and sin σt.
    omega: [Vector3<f64>; 3],
}

/// One of the two turns: about which axis, and at which rate, rad/s.
pub(super) type SteadyTurn = (Vector3<f64>, TwoPart);

impl TwoTurns {
    /// From the attitude that comes before both turns and that after them; ω is as in the field of this name.
    pub(super) fn new(
        start: &UnitQuaternion<f64>,
        (first, first_rate): SteadyTurn,
        (second, second_rate): SteadyTurn,
        then: &UnitQuaternion<f64>,
        omega: [Vector3<f64>; 3],
    ) -> Self {
        let [first, second] = [Quaternion::from_imag(first), Quaternion::from_imag(-second)];
        let (left, right) = (start.quaternion(), then.quaternion());
        let columns =
            [left * right, left * first * right, left * second * right, left * first * second * right];
        Self {
            about_first: Clock::from_rate(first_rate * 0.5),
            about_second: Clock::from_rate(second_rate * 0.5),
            attitude: Matrix4::from_columns(&columns.map(|column| column.coords)),
            omega,
        }
    }

    /// Fills the frames at times within reach and says how many, as [`several_at_once`] does.
    pub(super) fn fill(&self, times: &[f64], frames: &mut [Turning]) -> usize {
        let reach = self.about_first.reach().min(self.about_second.reach());
        several_at_once(*self, -reach..=reach, times, frames)
    }
}

impl Branchless for TwoTurns {
    type State = Turning;

    #[inline(always)]
    fn at(&self, time: f64) -> Turning {
        let (high, low) = self.about_first.at(time);
        let (s1, c1) = sin_cos_quarters(high, low);
        let (high, low) = self.about_second.at(time);
        let (s2, c2) = sin_cos_quarters(high, low);
        let q = self.attitude * Vector4::new(c1 * c2, s1 * c2, c1 * s2, s1 * s2);
        let [steady, with_cos, with_sin] = &self.omega;
        let (cos, sin) = (1.0 - 2.0 * s2 * s2, 2.0 * s2 * c2);
        Turning {
            world_from_body: UnitQuaternion::new_unchecked(Quaternion::from(q)),
            omega_body: steady + with_cos * cos + with_sin * sin,
        }
    }
}

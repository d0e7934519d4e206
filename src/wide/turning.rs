//! A body whose attitude is a steady turn about **L** and one about its own axis, and one that only turns steadily.

use super::functions::{Clock, sin_cos_quarters};
use super::{Branchless, several_at_once};
use crate::euler::Turning;
use crate::free_rotation::FreeSymmetricTop;
use crate::free_rotation::symmetric::renamed_back;
use crate::two_part::TwoPart;
use nalgebra::{Matrix4, Quaternion, UnitQuaternion, Vector3, Vector4};

/// The motion `q(t) = q₀ R(L̂, Λt) R(3̂, −σt) · then` (`eq:top-motion-in-body`) and ω (`eq:body-cone`), in numbers
/// that make a state of few operations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TwoTurns {
    about_first: Clock,  // half of Λt
    about_second: Clock, // half of σt
    /// Takes the products cc, sc, cs, ss of the cosines and sines of both to the quaternion, scalar last.
    attitude: Matrix4<f64>,
    /// ω along the body's axes: what stays, and what goes with cos σt and sin σt.
    omega: [Vector3<f64>; 3],
}

/// One of the two turns: about which axis, and at which rate, rad/s.
type SteadyTurn = (Vector3<f64>, TwoPart);

impl TwoTurns {
    /// The motion of a top for a body of which this top's axis 1 is the axis number `shift`, counted from 0.
    pub(crate) fn of_top(top: &FreeSymmetricTop, shift: usize, top_from_body: &UnitQuaternion<f64>) -> Self {
        let [w1, w2, w3]: [f64; 3] = top.start().omega_body.into();
        let omega = [[0.0, 0.0, w3], [w1, w2, 0.0], [-w2, w1, 0.0]];
        Self::new(
            &top.start().world_from_body,
            (top.momentum_direction_body, top.precession_rate),
            (Vector3::z(), top.body_rate),
            top_from_body,
            omega.map(|of_top| renamed_back(of_top, shift)),
        )
    }

    /// A rotation at a constant rate, rad/s, about an axis.
    pub(crate) fn steady(start: &Turning, axis_body: &Vector3<f64>, rate: TwoPart) -> Self {
        let (still, none) = ((Vector3::z(), TwoPart::from(0.0)), Vector3::zeros());
        let omega = [start.omega_body, none, none];
        Self::new(&start.world_from_body, (*axis_body, rate), still, &UnitQuaternion::identity(), omega)
    }

    fn new(
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

    /// Fills the states at times within reach and says how many, as [`several_at_once`] does.
    pub(crate) fn fill(&self, times: &[f64], states: &mut [Turning]) -> usize {
        let reach = self.about_first.reach().min(self.about_second.reach());
        several_at_once(*self, -reach..=reach, times, states)
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

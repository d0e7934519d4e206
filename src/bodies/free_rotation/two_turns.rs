//! A body whose attitude is a steady turn about **L** and one about its own axis, and one that only turns steadily.

use crate::clock::Clock;
use crate::euler::Turning;
use crate::lanes::{Branchless, sample_branchless};
use crate::quantity::InvalidQuantity;
use crate::two_part::TwoPart;
use nalgebra::{Matrix4, Quaternion, UnitQuaternion, Vector3, Vector4};

/// The motion `q(t) = q₀ R(L̂, Λt) R(3̂, −σt) · then` (`eq:top-motion-in-body`) and ω (`eq:body-cone`), in numbers
/// that make a state of few operations.
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
type SteadyTurn = (Vector3<f64>, TwoPart);

impl TwoTurns {
    /// A rotation at a constant rate, rad/s, about an axis.
    pub(super) fn steady(start: &Turning, axis_body: &Vector3<f64>, rate: TwoPart) -> Self {
        let (still, none) = ((Vector3::z(), TwoPart::from(0.0)), Vector3::zeros());
        let omega = [start.omega_body, none, none];
        Self::new(&start.world_from_body, (*axis_body, rate), still, &UnitQuaternion::identity(), omega)
    }

    /// From the attitude at the start, the two turns, what is done after them, and ω.
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

    /// Attitude and angular velocity at `time`, s.
    pub(super) fn at(&self, time: f64) -> Result<Turning, InvalidQuantity> {
        Ok(self.state::<true>(InvalidQuantity::check_time(time)?))
    }

    /// The same at many times.
    pub(super) fn sample(&self, times: &[f64]) -> Result<Vec<Turning>, InvalidQuantity> {
        let reach = self.about_first.reach().min(self.about_second.reach());
        let blank = Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::zeros() };
        sample_branchless(*self, [-reach, reach], times, blank, |time| self.at(time))
    }

    /// Sine and cosine of half the angle of the first turn at a time.
    pub(super) fn half_of_first(&self, time: f64) -> (f64, f64) {
        self.about_first.sin_cos::<true>(time)
    }
}

impl Branchless for TwoTurns {
    type State = Turning;

    #[inline(always)]
    fn state<const ONE: bool>(&self, time: f64) -> Turning {
        let (s1, c1) = self.about_first.sin_cos::<ONE>(time);
        let (s2, c2) = self.about_second.sin_cos::<ONE>(time);
        let q = self.attitude * Vector4::new(c1 * c2, s1 * c2, c1 * s2, s1 * s2); // eq:top-motion-in-body
        let [steady, with_cos, with_sin] = &self.omega;
        let (cos, sin) = (1.0 - 2.0 * s2 * s2, 2.0 * s2 * c2);
        Turning {
            world_from_body: UnitQuaternion::new_unchecked(Quaternion::from(q)),
            omega_body: steady + with_cos * cos + with_sin * sin, // eq:body-cone
        }
    }
}

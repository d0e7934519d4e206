//! Free rotation as a sequence of exact turns about principal axes.

use super::{check, exp, is_finite};
use crate::euler::Turning;
use crate::inertia::PrincipalMoments;
use crate::integrate::Failure;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A splitting method for a free body.
///
/// The energy is `L²/2I_b`, with the middle moment `I_b`, and one term `½(1/I_k − 1/I_b) L_k²` for each of the other
/// two axes (`eq:split-energy`). Each term alone would turn the body at a constant rate: the first about **L**, and as
/// it commutes with the others it is applied once, at the end; the others about their axis (`eq:split-turn`). A step
/// alternates between these two, with weights that make the method symmetric and of its order. Where two moments are
/// equal one term vanishes, and the result is exact at any step.
///
/// Kept to rounding: the angular momentum in the room and the unit length of the attitude, to three units in the last
/// place a turn at most; the volume of phase space; and the way back: the same steps backwards lead to the start. The
/// energy is off by a power of the step that does not grow with the time (`eq:modified-energy`); the phase along the
/// polhode is off in proportion to the time.
///
/// Touma & Wisdom, *Astronomical Journal* **107** (1994) 1189; McLachlan, *Physical Review Letters* **71** (1993) 3043.
///
/// ```
/// use mechanics::{euler::Turning, geometric::Splitting, inertia::Body};
/// use mechanics::nalgebra::{UnitQuaternion, Vector3};
/// let book = Body::cuboid(1.0, [0.03, 0.15, 0.22])?.moments();
/// let start = Turning {
///     world_from_body: UnitQuaternion::identity(),
///     omega_body: Vector3::new(0.01, 10.0, 0.0),
/// };
/// // Forward and back: the book is where it was, to rounding, whatever the errors on the way.
/// let there = Splitting::Strang.solve(&book, start, 5.0, 200)?;
/// let back = Splitting::Strang.solve(&book, there, -5.0, 200)?;
/// assert!((back.omega_body - start.omega_body).norm() < 1e-10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Splitting {
    /// Half a turn about one axis, the whole about the other, half about the first: order two, two turns a step
    /// (Strang, *SIAM Journal on Numerical Analysis* **5** (1968) 506).
    Strang,
    /// Order four with thirteen turns, twelve a step as the last of a step and the first of the next are one; at equal
    /// work its error is a small part of that of the composition of Strang steps by Suzuki's rule (Blanes & Moan,
    /// *Journal of Computational and Applied Mathematics* **142** (2002) 313, method S6 of order 4).
    BlanesMoan,
}

/// The weights of `Splitting::BlanesMoan`: of the first axis a₁, a₂, a₃, of the second b₁, b₂; the others follow from
/// their sums.
const A: [f64; 3] = [0.0792036964311957, 0.353172906049774, -0.0420650803577195];
const B: [f64; 2] = [0.209515106613362, -0.143851773179818];
const A_MIDDLE: f64 = 1.0 - 2.0 * (A[0] + A[1] + A[2]);
const B_LAST: f64 = 0.5 - (B[0] + B[1]);

impl Splitting {
    /// Parts of the step for which one turns about the first axis, the second, the first, …; the same from both ends.
    fn weights(self) -> &'static [f64] {
        match self {
            Self::Strang => &[0.5, 1.0, 0.5],
            Self::BlanesMoan => {
                &[A[0], B[0], A[1], B[1], A[2], B_LAST, A_MIDDLE, B_LAST, A[2], B[1], A[1], B[0], A[0]]
            }
        }
    }

    /// Turns about an axis of the body that one more step costs.
    #[must_use]
    pub fn turns_per_step(self) -> usize {
        self.weights().len() - 1 // the last and the next first are one
    }

    /// The motion of a free body of these moments after `duration`, s, of either sign, in so many equal steps.
    ///
    /// # Errors
    /// [`Failure::Interval`], [`Failure::InitialState`] or [`Failure::NoSteps`] for bad input; [`Failure::NotFinite`]
    /// if the momentum or an angle leaves the range of `f64`.
    pub fn solve(
        self,
        moments: &PrincipalMoments,
        state: Turning,
        duration: f64,
        steps: usize,
    ) -> Result<Turning, Failure> {
        check(0.0, &state, duration, steps)?;
        let h = duration / steps as f64;
        let split = Split::new(moments);
        let mut body = Body {
            world_from_body: state.world_from_body,
            momentum: moments.angular_momentum(&state.omega_body),
        };
        let weights = self.weights();
        let (outer, inner) = (weights[0], &weights[1..weights.len() - 1]);
        body.turn(split.first, outer * h);
        for step in 1..=steps {
            for (place, weight) in inner.iter().enumerate() {
                body.turn(if place % 2 == 0 { split.second } else { split.first }, weight * h);
            }
            // The last turn of a step and the first of the next are about the same axis.
            body.turn(split.first, if step == steps { outer } else { 2.0 * outer } * h);
        }
        // The part of the energy that depends on |L| alone turns the body about L (eq:split-energy).
        let about_momentum = exp(&(body.momentum / split.middle * duration));
        let end = Turning {
            world_from_body: body.world_from_body * about_momentum,
            omega_body: moments.angular_velocity(&body.momentum),
        };
        if !is_finite(&end) {
            return Err(Failure::NotFinite { time: 0.0, state: state.to_array().to_vec(), step: h });
        }
        Ok(end)
    }
}

/// How the energy of a body is split.
struct Split {
    middle: f64, // I_b, kg·m²
    first: Axis,
    second: Axis,
}

/// An axis of the body, and the rate of turn about it for each unit of momentum along it, `1/I_k − 1/I_b`, 1/(kg·m²).
#[derive(Clone, Copy)]
struct Axis {
    index: usize,
    rate: f64,
}

impl Split {
    fn new(moments: &PrincipalMoments) -> Self {
        let moments = moments.to_array();
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
        let [small, middle, large] = order;
        let middle = moments[middle];
        // The difference of the moments first: equal ones give exactly nothing.
        let axis = |index: usize| Axis { index, rate: (middle - moments[index]) / middle / moments[index] };
        Self { middle, first: axis(small), second: axis(large) }
    }
}

/// The body on its way: attitude without the turn about **L**, and momentum along the body's axes.
struct Body {
    world_from_body: UnitQuaternion<f64>,
    momentum: Vector3<f64>,
}

impl Body {
    /// Turns the body about one of its axes for a time, s; the momentum, which stands still in the room, goes back by
    /// the same angle as seen from the body (`eq:split-turn`).
    fn turn(&mut self, Axis { index, rate }: Axis, time: f64) {
        let angle = rate * self.momentum[index] * time;
        let (sin, cos) = (0.5 * angle).sin_cos();
        let mut axis = Vector3::zeros();
        axis[index] = sin;
        self.world_from_body *= UnitQuaternion::new_unchecked(Quaternion::from_parts(cos, axis));
        // R(k̂, −χ) L_body; sin χ and cos χ from those of the half angle.
        let (sin, cos) = (2.0 * sin * cos, (cos - sin) * (cos + sin));
        let (i, j) = ((index + 1) % 3, (index + 2) % 3);
        let (l_i, l_j) = (self.momentum[i], self.momentum[j]);
        self.momentum[i] = cos * l_i + sin * l_j;
        self.momentum[j] = cos * l_j - sin * l_i;
    }
}

//! Any free body.

use super::symmetric::FreeSymmetricTop;
use super::tumbling::Tumbling;
use super::two_turns::TwoTurns;
use crate::attitude::check_attitude;
use crate::euler::Turning;
use crate::inertia::PrincipalMoments;
use crate::quantity::InvalidQuantity;
use crate::two_part::TwoPart;
use nalgebra::{UnitQuaternion, Vector2, Vector3};

/// A body of any shape that turns with no torque about its centre of mass (or about a point held fixed, with the
/// moments about that point), in closed form, attitude included.
///
/// With three different moments the angular velocity is made of Jacobi's elliptic functions (`eq:free-jacobi`) and the
/// attitude of a steady turn about **L**, the shortest way to **L** and the direction of a theta function
/// (`eq:free-attitude`). All constants come from exact differences and are kept to 30 digits, and the parameter is the
/// complementary one, so that neither a motion next to the separatrix nor a hundred million periods cost digits
/// ([`FreeTop::at`] says how exact it is).
///
/// ```
/// use mechanics::{euler::Turning, free_rotation::FreeTop, inertia::Body};
/// use mechanics::nalgebra::{UnitQuaternion, Vector3};
/// // A book thrown almost about its middle axis.
/// let book = Body::cuboid(1.0, [0.03, 0.15, 0.22])?.moments();
/// let start = Turning {
///     world_from_body: UnitQuaternion::identity(),
///     omega_body: Vector3::new(0.01, 10.0, 0.0),
/// };
/// let top = FreeTop::new(book, start)?;
/// let half = 0.5 * top.period().expect("it flips");
/// let flipped = top.at(half)?;
/// assert!((flipped.omega_body.y + 10.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeTop {
    moments: PrincipalMoments,
    start: Turning,
    motion: Motion,
    period: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a motion is made once and asked many times")]
enum Motion {
    /// About one axis for ever (a principal axis, or any axis of a sphere), or with two equal moments.
    Turns(TwoTurns),
    /// Three different moments.
    Tumbling(Tumbling),
}

impl FreeTop {
    /// A body of these moments, and its attitude and angular velocity at time zero. A body at rest is allowed.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number of `start` is not finite or of a size that cannot be computed with, or if its
    /// quaternion is not of length one to 1e-12.
    pub fn new(moments: PrincipalMoments, start: Turning) -> Result<Self, InvalidQuantity> {
        for component in &start.omega_body {
            InvalidQuantity::check("angular velocity", *component, "rad/s")?;
        }
        check_attitude(&start.world_from_body)?;
        let (motion, period) = Self::motion(moments, start);
        Ok(Self { moments, start, motion, period })
    }

    /// The motion and its period.
    fn motion(moments: PrincipalMoments, start: Turning) -> (Motion, Option<f64>) {
        let omega = start.omega_body;
        let [i1, i2, i3] = moments.to_array();
        let steady = || {
            let [w1, w2, w3]: [f64; 3] = omega.into();
            let square = TwoPart::product(w1, w1) + TwoPart::product(w2, w2) + TwoPart::product(w3, w3);
            let axis_body = omega.try_normalize(0.0).unwrap_or_else(Vector3::z);
            (Motion::Turns(TwoTurns::steady(&start, &axis_body, square.sqrt())), None)
        };
        // Which cyclic renaming brings an axis of symmetry to 3: (2, 3, 1), (3, 1, 2) or none.
        let shift = [(i2 == i3, 1), (i3 == i1, 2), (i1 == i2, 0)].into_iter().find(|(equal, _)| *equal);
        if i1 == i2 && i2 == i3 {
            return steady();
        }
        let Some((_, shift)) = shift else {
            let tumbling = Tumbling::new(moments, &start);
            return tumbling.map_or_else(steady, |motion| (Motion::Tumbling(motion), motion.period()));
        };
        let top_from_body = cyclic(shift);
        let turning = Turning {
            world_from_body: start.world_from_body * top_from_body.inverse(),
            omega_body: Vector3::from_fn(|axis, _| omega[(axis + shift) % 3]),
        };
        let top = FreeSymmetricTop::from_checked(moments.renamed(shift), turning, shift, &top_from_body);
        let (rate, transverse) = (top.body_rate().abs(), turning.omega_body.xy());
        let wobbles = rate > 0.0 && transverse != Vector2::zeros();
        (Motion::Turns(top.motion()), wobbles.then(|| std::f64::consts::TAU / rate))
    }

    /// Attitude and angular velocity at `time`, s: to 4e-15 rad, and 4e-15 of the size of the angular velocity, until
    /// the body has turned by 1e15 rad (by its quickest motion). Then the 32 digits of the rates run out; each further
    /// decade costs one, and from 1e30 rad on only what is constant is known. Next to the separatrix, where the period
    /// hangs on a small difference, they run out at `1e17 k'²` rad if that is earlier.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is not finite or larger than 1e50 s in size.
    pub fn at(&self, time: f64) -> Result<Turning, InvalidQuantity> {
        match &self.motion {
            Motion::Turns(motion) => motion.at(time),
            Motion::Tumbling(motion) => motion.at(time),
        }
    }

    /// Attitude and angular velocity at each of `times`, s, as [`FreeTop::at`], several at once.
    ///
    /// # Errors
    /// As [`FreeTop::at`], of the first time that is refused.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Turning>, InvalidQuantity> {
        match &self.motion {
            Motion::Turns(motion) => motion.sample(times),
            Motion::Tumbling(motion) => motion.sample(times),
        }
    }

    /// The time after which the angular velocity, seen from the body, is the same again, s, with a relative error
    /// below 4e-16. `None` if it never changes, or, on the separatrix, never comes back.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.period
    }

    /// The moments of the body.
    #[must_use]
    pub fn moments(&self) -> PrincipalMoments {
        self.moments
    }

    /// Attitude and angular velocity at time zero.
    #[must_use]
    pub fn start(&self) -> Turning {
        self.start
    }
}

/// The rotation that gives axes 1, 2, 3 the names of the axes `shift` further on.
fn cyclic(shift: usize) -> UnitQuaternion<f64> {
    // A third of a turn about the diagonal for each step.
    let step = nalgebra::Quaternion::new(0.5, -0.5, -0.5, -0.5);
    UnitQuaternion::new_unchecked(match shift {
        0 => nalgebra::Quaternion::identity(),
        1 => step,
        _ => step.conjugate(),
    })
}

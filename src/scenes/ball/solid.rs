//! The ball itself, and its state.

use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::Vector3;

/// A ball whose moment of inertia is the same about every axis through its centre.
///
/// ```
/// use mechanics::scenes::ball::{Ball, BallParameters};
/// // What sliding leaves of the speed of a ball that did not spin: five sevenths, or three fifths of a hollow one.
/// let kept = |moment_factor| {
///     Ok::<_, mechanics::InvalidQuantity>(1.0 - Ball::new(BallParameters { radius: 0.03, moment_factor })?.share())
/// };
/// assert!((kept(Ball::SOLID)? - 5.0 / 7.0).abs() < 1e-15);
/// assert!((kept(Ball::SHELL)? - 3.0 / 5.0).abs() < 1e-15);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball(BallParameters);

/// What matters of a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallParameters {
    /// Radius a, m, more than zero.
    pub radius: f64,
    /// The moment of inertia about any axis through the centre, over ma²: more than zero, and at most 2/3.
    pub moment_factor: f64,
}

/// A ball at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallState {
    /// Where the centre is, m, in the room.
    pub centre: Vector3<f64>,
    /// The velocity of the centre, m/s, in the room.
    pub velocity: Vector3<f64>,
    /// Angular velocity, rad/s, along the axes of the room.
    pub omega: Vector3<f64>,
}

impl Ball {
    /// The moment of a uniform ball, in ma².
    pub const SOLID: f64 = 0.4;
    /// The moment of a thin shell, in ma²: no ball has more.
    pub const SHELL: f64 = 2.0 / 3.0;

    /// A ball.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: BallParameters) -> Result<Self, InvalidQuantity> {
        let BallParameters { radius, moment_factor } = parameters;
        InvalidQuantity::check_positive("radius of the ball", radius, "m")?;
        InvalidQuantity::check_positive("moment of the ball over ma²", moment_factor, "")?;
        let shell = Rule::NotAbove { what: "that of a thin shell", limit: Self::SHELL };
        let holds = moment_factor <= Self::SHELL;
        InvalidQuantity::require(holds, "moment of the ball over ma²", moment_factor, "", shell)?;
        Ok(Self(parameters))
    }

    /// The radius a, m.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.0.radius
    }

    /// The moment of inertia over ma², k.
    #[must_use]
    pub fn moment_factor(&self) -> f64 {
        self.0.moment_factor
    }

    /// The share `k/(1 + k)` of the slip that the centre pays when sliding ends (`eq:ball-share`): 2/7 for a solid ball.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.exact_share().rounded()
    }

    /// The height above the table, m, at which a level blow makes the ball roll at once: `(1 + k) a`
    /// (`eq:ball-cue`).
    #[must_use]
    pub fn rolling_height(&self) -> f64 {
        (1.0 + self.moment_factor()) * self.radius()
    }

    /// The kinetic energy over the mass, J/kg.
    #[must_use]
    pub fn kinetic_energy(&self, state: &BallState) -> f64 {
        let spin = state.omega * self.radius();
        0.5 * (state.velocity.norm_squared() + self.moment_factor() * spin.norm_squared())
    }

    /// The velocity, m/s in the room, of the point of the ball that is a radius away from the centre in this
    /// direction of length one: the slip, if it touches there what is at rest (`eq:ball-slip`).
    #[must_use]
    pub fn point_velocity(&self, state: &BallState, direction: &Vector3<f64>) -> Vector3<f64> {
        state.velocity + state.omega.cross(direction) * self.radius()
    }

    /// `k/(1 + k)` with all its digits.
    pub(super) fn exact_share(&self) -> TwoPart {
        TwoPart::from(self.moment_factor()) / TwoPart::sum(1.0, self.moment_factor())
    }
}

//! Three moments that a body can have.

use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::Vector3;

/// How much the largest moment of a flat body may exceed the sum of the others through rounding, relative.
const FLAT: f64 = 4.0 * f64::EPSILON;
/// How much the two moments of a symmetric body may differ through rounding, of the largest: twice what
/// `InertiaTensor::principal_axes` promises.
const EVEN: f64 = 1e-14;
/// What moments are given in.
pub(super) const UNIT: &str = "kg·m²";

/// The principal moments of inertia of a body, kg·m², about axes 1, 2 and 3 that are fixed in it.
///
/// All three are more than zero, and none exceeds the sum of the other two: `I₁ + I₂ = I₃ + 2∫z² dm` (`eq:triangle`).
///
/// ```
/// use mechanics::inertia::PrincipalMoments;
/// let refusal = PrincipalMoments::new(2.0, 3.0, 9.0).unwrap_err();
/// assert_eq!(
///     refusal.to_string(),
///     "largest principal moment 9 kg·m² exceeds the sum of the other two, 5 kg·m²"
/// );
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalMoments {
    moments: [f64; 3],
}

/// The moments of a body that is symmetric about its axis 3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SymmetricMoments {
    /// I₁, about every axis across the body's own, kg·m².
    pub transverse: f64,
    /// I₃, about the body's axis, kg·m².
    pub axial: f64,
}

impl PrincipalMoments {
    /// Checks three moments about three perpendicular axes, kg·m².
    ///
    /// # Errors
    /// [`InvalidQuantity`] if one is not finite, is zero or less, is outside 1e-50 to 1e50, or exceeds the sum of the
    /// other two by more than rounding.
    pub fn new(about_1: f64, about_2: f64, about_3: f64) -> Result<Self, InvalidQuantity> {
        let moments = [about_1, about_2, about_3];
        for moment in moments {
            InvalidQuantity::check_positive("principal moment", moment, UNIT)?;
        }
        let [a, b, c] = moments;
        let (smallest, largest) = (a.min(b).min(c), a.max(b).max(c));
        let middle = a.max(b).min(a.min(b).max(c));
        let others = smallest + middle;
        let rule = Rule::NotAbove { what: "the sum of the other two", limit: others };
        let is_body = largest <= others * (1.0 + FLAT); // eq:triangle
        InvalidQuantity::require(is_body, "largest principal moment", largest, UNIT, rule)?;
        Ok(Self { moments })
    }

    /// The moments of a body with an axis of symmetry, along axis 3: `transverse` about every axis across it, `axial`
    /// about it, kg·m².
    ///
    /// # Errors
    /// As [`PrincipalMoments::new`].
    pub fn symmetric(transverse: f64, axial: f64) -> Result<Self, InvalidQuantity> {
        Self::new(transverse, transverse, axial)
    }

    /// The three moments about axes 1, 2, 3, kg·m².
    #[must_use]
    pub fn to_array(self) -> [f64; 3] {
        self.moments
    }

    /// The two moments of a body that is symmetric about axis 3. [`PrincipalMoments::symmetric`] and the round shapes
    /// of [`super::Body`] have equal moments about axes 1 and 2; those of a body of parts differ by what rounding
    /// leaves, and it gets their mean. An axis of symmetry that is not axis 3 has to be renamed: see
    /// [`super::PrincipalAxes`].
    ///
    /// # Errors
    /// [`InvalidQuantity`] if I₂ differs from I₁ by more than 1e-14 of the largest moment.
    pub fn as_symmetric(self) -> Result<SymmetricMoments, InvalidQuantity> {
        let [one, other, axial] = self.moments;
        let is_even = (other - one).abs() <= EVEN * one.max(other).max(axial);
        InvalidQuantity::require(is_even, "transverse moment I₂", other, UNIT, Rule::EqualTo(one))?;
        Ok(SymmetricMoments { transverse: 0.5 * (one + other), axial })
    }

    /// The same body, which must be symmetric about axis 3 to rounding, with two moments that are equal.
    pub(crate) fn evened(self) -> Result<Self, InvalidQuantity> {
        let SymmetricMoments { transverse, axial } = self.as_symmetric()?;
        Ok(Self { moments: [transverse, transverse, axial] })
    }

    /// The same body with its axes renamed: its axis 1 is the present axis number `shift`, counted from 0.
    pub(crate) fn renamed(self, shift: usize) -> Self {
        Self { moments: std::array::from_fn(|axis| self.moments[(axis + shift) % 3]) }
    }

    /// The angular momentum `L = Iω` about the centre of mass, kg·m²/s, along the body's axes, for an angular velocity
    /// `omega_body` along the same axes, rad/s (`eq:spin-momentum`).
    #[must_use]
    pub fn angular_momentum(self, omega_body: &Vector3<f64>) -> Vector3<f64> {
        Vector3::from(self.moments).component_mul(omega_body)
    }

    /// The kinetic energy of rotation `½ ω·Iω`, J, for an angular velocity `omega_body` along the body's axes, rad/s
    /// (`eq:spin-energy`).
    #[must_use]
    pub fn kinetic_energy(self, omega_body: &Vector3<f64>) -> f64 {
        0.5 * omega_body.dot(&self.angular_momentum(omega_body))
    }

    /// How a small disturbance of a rotation about axis 1, 2, 3 goes on: its growth rate squared, over the square of
    /// that rotation's angular velocity (`eq:middle-growth`). It grows about the axis of the middle moment, where this
    /// is more than zero (and less than one); where it is less than zero, the disturbance swings, at the root of its
    /// size.
    /// Exact to rounding also where moments are nearly equal.
    ///
    /// ```
    /// use mechanics::inertia::Body;
    /// let book = Body::cuboid(1.0, [0.22, 0.15, 0.03])?.moments();
    /// let signs = book.growth_squared().map(f64::signum);
    /// assert_eq!(signs, [-1.0, 1.0, -1.0]);
    /// # Ok::<(), mechanics::InvalidQuantity>(())
    /// ```
    #[must_use]
    pub fn growth_squared(self) -> [f64; 3] {
        std::array::from_fn(|axis| {
            let [own, one, other] = self.renamed(axis).moments;
            (own - one) / one * ((other - own) / other)
        })
    }

    /// The angular velocity along the body's axes, rad/s, that belongs to an angular momentum along the same axes,
    /// kg·m²/s.
    #[must_use]
    pub fn angular_velocity(self, momentum_body: &Vector3<f64>) -> Vector3<f64> {
        momentum_body.component_div(&Vector3::from(self.moments))
    }
}

//! Inertia about any point, along any axes.

use super::moments::{PrincipalMoments, UNIT};
use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::{Matrix3, Rotation3, SymmetricEigen, Vector3};

/// What it costs to turn a matrix and to find its axes, of the largest moment.
const ROUNDING: f64 = 1e-14;

/// After so many sweeps without an answer the search for the axes is given up; half a dozen are common.
const SWEEPS: usize = 100;

/// The inertia tensor of a body about a point: a symmetric matrix, kg·m², along stated axes.
///
/// A tensor that you have, with products of inertia, becomes a [`super::Body`] with its principal axes as axes 1, 2, 3:
///
/// ```
/// use mechanics::inertia::{Body, InertiaTensor};
/// use mechanics::nalgebra::{Matrix3, Vector3};
/// let tensor = InertiaTensor::new(Matrix3::new(2.0, -0.5, 0.0, -0.5, 2.0, 0.0, 0.0, 0.0, 3.0))?; // kg·m²
/// let axes = tensor.principal_axes()?;
/// let body = Body::new(12.0, axes.moments)?; // kg; 1.5, 2.5 and 3 kg·m²
/// let axis_1 = axes.present_from_principal * Vector3::x(); // along the diagonal of the first two axes
/// # assert!((Vector3::from(body.moments().to_array()) - Vector3::new(1.5, 2.5, 3.0)).norm() < 1e-15);
/// # assert!((axis_1.x.abs() - 0.5_f64.sqrt()).abs() < 1e-15 && (axis_1.x - axis_1.y).abs() < 1e-15);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
///
/// And of a body that is known, [`super::Body::about`] gives the tensor about any point:
///
/// ```
/// use mechanics::inertia::Body;
/// use mechanics::nalgebra::Vector3;
/// // A hoop about a point of its rim: 3/2, 1/2 and 2 times ma² (tangent, diameter, normal).
/// let about_rim = Body::hoop(1.0, 1.0)?.about(&Vector3::new(0.0, 1.0, 0.0))?;
/// assert_eq!(about_rim.matrix().diagonal(), Vector3::new(1.5, 0.5, 2.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InertiaTensor {
    matrix: Matrix3<f64>,
}

/// The principal axes of an inertia tensor, in the order of their moments. So the axis of symmetry is axis 3 in a flat
/// round body, but axis 1 in a long one. [`crate::free_rotation::FreeTop`] takes any order; what asks for the axis of
/// symmetry as axis 3 takes the long body's axes 2, 3, 1 as its 1, 2, 3, which are right-handed too:
///
/// ```
/// use mechanics::inertia::{Body, InertiaTensor, PrincipalMoments};
/// use mechanics::nalgebra::Rotation3;
/// let mast = InertiaTensor::principal(Body::cuboid(1.0, [0.1, 2.0, 0.1])?.moments()); // kg, m
/// let axes = mast.principal_axes()?;
/// let [axial, one, other] = axes.moments.to_array();
/// let moments = PrincipalMoments::new(one, other, axial)?; // symmetric about axis 3
/// let columns = [1, 2, 0].map(|n| axes.present_from_principal.matrix().column(n).into_owned());
/// let present_from_body = Rotation3::from_basis_unchecked(&columns);
/// # assert!(axes.moments.as_symmetric().is_err() && moments.as_symmetric().is_ok());
/// # let back = InertiaTensor::principal(moments).rotated(&present_from_body);
/// # assert!((back.matrix() - mast.matrix()).norm() < 1e-15);
/// # assert!((present_from_body.matrix().determinant() - 1.0).abs() < 1e-15);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalAxes {
    /// The moments about them, smallest first.
    pub moments: PrincipalMoments,
    /// Takes components along them to components along the axes of the tensor.
    pub present_from_principal: Rotation3<f64>,
}

impl InertiaTensor {
    /// The tensor with this matrix, kg·m², about any point and along any axes. Off the diagonal stand the products of
    /// inertia with their minus, `−∫xy dm`: some drawing programs give them without.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if an entry is not finite, if two that should be equal differ by more than 1e-14 of the
    /// largest, or if no body has such a tensor, as [`InertiaTensor::principal_axes`] finds.
    pub fn new(matrix: Matrix3<f64>) -> Result<Self, InvalidQuantity> {
        for entry in &matrix {
            InvalidQuantity::require_finite("entry of the inertia tensor", *entry, UNIT)?;
        }
        for (name, row, column) in [
            ("product of inertia I₂₁", 1, 0),
            ("product of inertia I₃₁", 2, 0),
            ("product of inertia I₃₂", 2, 1),
        ] {
            let [entry, mirrored] = [matrix[(row, column)], matrix[(column, row)]];
            let is_even = (entry - mirrored).abs() <= ROUNDING * matrix.amax();
            InvalidQuantity::require(is_even, name, entry, UNIT, Rule::EqualTo(mirrored))?;
        }
        let tensor = Self { matrix: symmetrised(matrix) };
        tensor.principal_axes()?;
        Ok(tensor)
    }

    /// The tensor about the point that the moments are about, along their axes.
    #[must_use]
    pub fn principal(moments: PrincipalMoments) -> Self {
        Self { matrix: Matrix3::from_diagonal(&moments.to_array().into()) }
    }

    /// The matrix, kg·m².
    #[must_use]
    pub fn matrix(&self) -> &Matrix3<f64> {
        &self.matrix
    }

    /// The angular momentum about the point, kg·m²/s, of a body that turns about that point with `omega`, rad/s.
    #[must_use]
    pub fn angular_momentum(&self, omega: &Vector3<f64>) -> Vector3<f64> {
        self.matrix * omega
    }

    /// The tensor along other axes, `R I Rᵀ`: R takes components along the present axes to those along the others.
    #[must_use]
    pub fn rotated(&self, other_from_present: &Rotation3<f64>) -> Self {
        let turn = other_from_present.matrix();
        Self { matrix: symmetrised(turn * self.matrix * turn.transpose()) }
    }

    /// From the centre of mass of a body of mass `mass`, kg, to the point at `displacement` from it, m. From any other
    /// point it would be meaningless, so that only a body, which knows its centre of mass, may ask for it.
    pub(super) fn shifted(&self, mass: f64, displacement: &Vector3<f64>) -> Self {
        let square = Matrix3::from_diagonal_element(displacement.norm_squared());
        Self { matrix: self.matrix + (square - displacement * displacement.transpose()) * mass } // eq:steiner
    }

    /// The principal moments, smallest first, and the axes that they are about. Good to 5e-15 of the largest moment.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a moment is not more than zero, or exceeds the sum of the other two
    /// ([`PrincipalMoments::new`]), or if the search for the axes comes to no end.
    pub fn principal_axes(&self) -> Result<PrincipalAxes, InvalidQuantity> {
        if let Some(&bad) = self.matrix.iter().find(|entry| !entry.is_finite()) {
            PrincipalMoments::new(bad, bad, bad)?;
        }
        let rule = Rule::Because("its principal axes are not found");
        let missing = InvalidQuantity {
            quantity: "largest moment of inertia",
            value: self.matrix.amax(),
            unit: UNIT,
            rule,
        };
        let eigen = SymmetricEigen::try_new(self.matrix, f64::EPSILON, SWEEPS).ok_or(missing)?;
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
        let [first, second, _] = order.map(|i| eigen.eigenvectors.column(i).into_owned());
        let axes = Matrix3::from_columns(&[first, second, first.cross(&second)]); // right-handed
        let [about_1, about_2, largest] = order.map(|i| eigen.eigenvalues[i]);
        // A flat body's is not more than the sum of the others through rounding.
        let others = about_1 + about_2;
        let about_3 = if largest - others < ROUNDING * largest { largest.min(others) } else { largest };
        Ok(PrincipalAxes {
            moments: PrincipalMoments::new(about_1, about_2, about_3)?,
            present_from_principal: Rotation3::from_matrix_unchecked(axes),
        })
    }
}

fn symmetrised(matrix: Matrix3<f64>) -> Matrix3<f64> {
    (matrix + matrix.transpose()) * 0.5
}

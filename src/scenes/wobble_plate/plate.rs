//! The plate: how its angular momentum leans, and what that asks of the bearings.

use super::Pistons;
use crate::inertia::{Body, Cylinder, PrincipalMoments, SymmetricMoments};
use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// A round plate fixed to a shaft through its centre, its normal tilted by α.
///
/// ```
/// use mechanics::scenes::wobble_plate::{Plate, PlateParameters};
/// // Whatever its size, a thin plate's angular momentum never leans more than arcsin 1/3 = 19.47° from the shaft.
/// let mut steepest: f64 = 0.0;
/// for degrees in 1..90 {
///     let tilt = f64::from(degrees).to_radians();
///     let plate = Plate::new(PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.0, tilt })?;
///     steepest = steepest.max(plate.momentum_angle());
/// }
/// assert!(steepest < (1.0_f64 / 3.0).asin() && steepest.to_degrees() > 19.46);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    moments: PrincipalMoments,
    transverse: f64, // I₁
    axial: f64,      // I₃
    tilt: f64,
    sin: f64,
    cos: f64,
}

/// What a plate is made of, and how it is mounted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlateParameters {
    /// Mass M, kg, more than zero.
    pub mass: f64,
    /// Radius R, m, more than zero.
    pub radius: f64,
    /// Thickness h, m, zero or more.
    pub thickness: f64,
    /// Tilt α of the normal from the shaft, rad, from 0 to less than π/2.
    pub tilt: f64,
}

/// The plate's steepest angular momentum, and the tilt that has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LargestMomentumAngle {
    /// The angle β of largest size from the shaft to the angular momentum, rad, with the sign of
    /// [`Plate::momentum_angle`].
    pub momentum_angle: f64,
    /// The tilt α, rad, at which it is so large.
    pub tilt: f64,
}

impl Plate {
    /// The plate.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(parameters: PlateParameters) -> Result<Self, InvalidQuantity> {
        let PlateParameters { mass, radius, thickness, tilt } = parameters;
        InvalidQuantity::check_not_negative("tilt", tilt, "rad")?;
        InvalidQuantity::require(tilt < FRAC_PI_2, "tilt", tilt, "rad", Rule::LessThan(FRAC_PI_2))?;
        InvalidQuantity::check_not_negative("thickness", thickness, "m")?;
        let body = Body::cylinder(mass, Cylinder { radius, height: thickness })?;
        let moments = body.moments(); // eq:plate-moments
        let SymmetricMoments { transverse, axial } = moments.as_symmetric()?;
        let (sin, cos) = tilt.sin_cos();
        Ok(Self { moments, transverse, axial, tilt, sin, cos })
    }

    /// The tilt α, rad.
    #[must_use]
    pub fn tilt(&self) -> f64 {
        self.tilt
    }

    /// The principal moments; axis 3 is the normal.
    #[must_use]
    pub fn moments(&self) -> PrincipalMoments {
        self.moments
    }

    /// The angular velocity of the spin `spin`, rad/s, along the plate's principal axes (`eq:plate-spin`).
    #[must_use]
    pub fn spin_body(&self, spin: f64) -> Vector3<f64> {
        Vector3::new(self.sin, 0.0, self.cos) * spin
    }

    /// The angular momentum about the centre along the plate's principal axes, kg·m²/s (`eq:plate-momentum`).
    #[must_use]
    pub fn angular_momentum_body(&self, spin: f64) -> Vector3<f64> {
        self.moments.angular_momentum(&self.spin_body(spin))
    }

    /// The angular momentum about the centre along the rotating axes x', y', z, kg·m²/s (`eq:plate-transverse`).
    ///
    /// The part across the shaft is formed from the difference of the moments, and keeps its digits at every tilt. The
    /// difference itself has as many as the moments leave it: few for a plate of nearly √3 times its radius.
    #[must_use]
    pub fn angular_momentum_rotating(&self, spin: f64) -> Vector3<f64> {
        let Self { transverse: i1, axial: i3, sin, cos, .. } = *self;
        // eq:plate-transverse with I₁ and I₃ for ¼MR² and ½MR².
        Vector3::new(-(i3 - i1) * sin * cos, 0.0, i3 * cos * cos + i1 * sin * sin) * spin
    }

    /// The angle β from the shaft to the angular momentum, rad; positive on the side of the normal, negative for a
    /// plate that is thicker than √3 times its radius (`eq:momentum-tilt`).
    #[must_use]
    pub fn momentum_angle(&self) -> f64 {
        let momentum = self.angular_momentum_rotating(1.0);
        (-momentum.x).atan2(momentum.z) // eq:momentum-tilt before tan α, which has no bound, is divided out
    }

    /// The angle β of largest size of any tilt, and the tilt that has it: `sin β = (I₃ − I₁)/(I₃ + I₁)` at
    /// `tan² α = I₃/I₁` (`eq:largest-momentum-tilt` for a thin plate).
    #[must_use]
    pub fn largest_momentum_angle(&self) -> LargestMomentumAngle {
        let Self { transverse: i1, axial: i3, .. } = *self;
        LargestMomentumAngle { momentum_angle: ((i3 - i1) / (i3 + i1)).asin(), tilt: (i3 / i1).sqrt().atan() }
    }

    /// The torque that the bearings give the turning plate, along the rotating axes, N·m: `ω × L`
    /// (`eq:rate-on-board`, where the components are constant; `eq:bearing-torque` for a thin plate).
    #[must_use]
    pub fn bearing_torque_rotating(&self, spin: f64) -> Vector3<f64> {
        let omega = Vector3::new(0.0, 0.0, spin);
        omega.cross(&self.angular_momentum_rotating(spin)) // eq:rate-on-board
    }

    /// The mass of each piston, kg, with which the pistons balance the plate: `2ΔI cos²α/(N r²)` (`eq:many-pistons`,
    /// with `eq:thick-plate`; for four pistons and a thin plate `eq:balancing-mass`). The present mass of the pistons
    /// plays no part.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for fewer than three pistons, whose angular momentum swings to and fro instead of turning
    /// with the plate, and for a plate so thick that its own leans to the same side as that of pistons.
    pub fn balancing_mass(&self, pistons: &Pistons) -> Result<f64, InvalidQuantity> {
        let Self { transverse: i1, axial: i3, cos, .. } = *self;
        let (n, r) = (f64::from(pistons.count()), pistons.distance());
        let rule = Rule::AtLeast(3.0);
        InvalidQuantity::require(
            n >= 3.0,
            "number of pistons that are to balance a turning plate",
            n,
            "",
            rule,
        )?;
        let rule = Rule::NotAbove { what: "that about its axis", limit: i3 };
        InvalidQuantity::require(i1 <= i3, "transverse moment of a plate to be balanced", i1, "kg·m²", rule)?;
        Ok(2.0 * (i3 - i1) * cos * cos / (n * r * r)) // eq:many-pistons
    }
}

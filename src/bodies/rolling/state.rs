//! A rolling disk at one instant.

use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::Complex;
use std::f64::consts::{FRAC_PI_2, PI};

/// A rolling disk at one instant; axes 1, 2, 3 as at the top of [`crate::rolling`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling {
    /// The tilt α from lying flat, rad, between 0 and π; the right angle of `f64` is upright. Near π, which is flat on
    /// the other face, what it lacks has no digits below 4e-16.
    pub tilt: f64,
    /// The angular velocity about axis 1, rad/s: the rate θ̇ of the lean, −α̇.
    pub omega_1: f64,
    /// The angular velocity q about axis 2, rad/s.
    pub omega_2: f64,
    /// The angular velocity n about axis 3, the axle, rad/s: negative if the disk rolls along axis 1.
    pub omega_3: f64,
    /// The heading φ of axis 1 from x, rad, counter-clockwise from above.
    pub heading: f64,
    /// The angle through which the disk has turned about its axle relative to the frame, at the rate `ω_rel`, rad.
    pub roll_angle: f64,
    /// The place of the centre over the table, x + iy, m.
    pub centre: Complex<f64>,
}

impl Rolling {
    /// Upright and at rest above the origin, with axis 1 along x.
    pub const UPRIGHT: Self = Self {
        tilt: FRAC_PI_2,
        omega_1: 0.0,
        omega_2: 0.0,
        omega_3: 0.0,
        heading: 0.0,
        roll_angle: 0.0,
        centre: Complex::new(0.0, 0.0),
    };

    /// The lean θ from the upright, rad: π/2 less the tilt, to 1e-16.
    #[must_use]
    pub fn lean(&self) -> f64 {
        FRAC_PI_2 - self.tilt
    }

    /// The point of contact in the table, x + iy, m, of a disk of this radius, m.
    #[must_use]
    pub fn contact(&self, radius: f64) -> Complex<f64> {
        let (sin, _) = sin_cos_lean(self.tilt);
        let outward = Complex::<f64>::i() * Complex::cis(self.heading);
        self.centre + outward * (radius * sin)
    }

    /// The eight numbers that an integrator steps: α, ω₁, ω₂, ω₃, φ, the roll angle, x, y.
    #[must_use]
    pub fn to_array(&self) -> [f64; 8] {
        let Self { tilt, omega_1, omega_2, omega_3, heading, roll_angle, centre } = *self;
        [tilt, omega_1, omega_2, omega_3, heading, roll_angle, centre.re, centre.im]
    }

    /// From an integrator's eight numbers.
    #[must_use]
    pub fn from_array([tilt, omega_1, omega_2, omega_3, heading, roll_angle, x, y]: [f64; 8]) -> Self {
        Self { tilt, omega_1, omega_2, omega_3, heading, roll_angle, centre: Complex::new(x, y) }
    }

    /// Refuses a disk that lies flat, and numbers that cannot be computed with.
    pub(crate) fn check(&self) -> Result<(), InvalidQuantity> {
        InvalidQuantity::check_positive("tilt from lying flat", self.tilt, "rad")?;
        let rule = Rule::LessThan(PI);
        InvalidQuantity::require(self.tilt < PI, "tilt from lying flat", self.tilt, "rad", rule)?;
        for (name, value, unit) in [
            ("angular velocity ω₁", self.omega_1, "rad/s"),
            ("angular velocity ω₂", self.omega_2, "rad/s"),
            ("angular velocity ω₃", self.omega_3, "rad/s"),
            ("heading", self.heading, "rad"),
            ("roll angle", self.roll_angle, "rad"),
            ("position of the centre", self.centre.re, "m"),
            ("position of the centre", self.centre.im, "m"),
        ] {
            InvalidQuantity::check(name, value, unit)?;
        }
        Ok(())
    }
}

/// Sine and cosine of the lean, from the tilt: near flat the cosine has all its digits, and upright the sine is zero.
pub(crate) fn sin_cos_lean(tilt: f64) -> (f64, f64) {
    ((FRAC_PI_2 - tilt).sin(), tilt.sin())
}

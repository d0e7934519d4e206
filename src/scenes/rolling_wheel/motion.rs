//! The general motion without slipping.

use super::wheel::Wheel;
use nalgebra::Vector3;

/// A rolling wheel at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling {
    /// The lean θ, rad, between −π/2 and π/2. Of a wheel that is almost flat the tilt from lying flat, π/2 − |θ|, has fewer digits: none
    /// below 1e-16.
    pub lean: f64,
    /// Its rate, rad/s: the angular velocity about axis 1.
    pub lean_rate: f64,
    /// The angular velocity q about axis 2, rad/s.
    pub across: f64,
    /// The angular velocity n about axis 3, the axle, rad/s.
    pub along: f64,
    /// The heading φ of axis 1 from x, rad.
    pub heading: f64,
    /// The angle ψ through which the wheel has turned about its axle relative to the frame, rad.
    pub spin: f64,
    /// x and y of the centre, m.
    pub centre: [f64; 2],
}

/// What stays constant as a wheel rolls, with the energy: the coefficients of the two conical functions, rad/s
/// (`eq:chaplygin`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingConstants {
    /// The coefficient A of the even function.
    pub even: f64,
    /// The coefficient B of the odd function.
    pub odd: f64,
}

impl Rolling {
    /// The eight numbers that an integrator steps: θ, θ̇, q, n, φ, ψ, x, y.
    pub fn to_array(&self) -> [f64; 8] {
        let [x, y] = self.centre;
        [self.lean, self.lean_rate, self.across, self.along, self.heading, self.spin, x, y]
    }

    /// From an integrator's eight numbers.
    pub fn from_array([lean, lean_rate, across, along, heading, spin, x, y]: [f64; 8]) -> Self {
        Self { lean, lean_rate, across, along, heading, spin, centre: [x, y] }
    }
}

impl Wheel {
    /// The rates of the eight numbers of [`Rolling`], for [`crate::integrate::Dop853`] (`eq:lean-acceleration`,
    /// `eq:spin-rates`, `eq:rolling-path`).
    ///
    /// Infinite or NaN for a flat wheel; for one that is almost flat see [`Wheel::rates_by_tilt`].
    pub fn rates(&self, _time: f64, state: &[f64; 8]) -> [f64; 8] {
        let &[lean, lean_rate, q, n, heading, ..] = state;
        let (sin, cos) = lean.sin_cos();
        let (i1, i3) = (0.5 * self.factor, self.factor);
        let p = q * sin / cos;
        let lean_acceleration =
            (self.gravity / self.radius * sin - (1.0 + i3) * n * q - i1 * p * q) / (1.0 + i1);
        let (s, c) = heading.sin_cos();
        // v = a(θ̇ 3̂ − n 1̂), with 1̂ = (cos φ, sin φ, 0) and the level part of 3̂ along −cos θ (−sin φ, cos φ, 0).
        let (forward, outward) = (-self.radius * n, -self.radius * lean_rate * cos);
        [
            lean_rate,
            lean_acceleration,
            lean_rate * (p + n * i3 / i1),
            lean_rate * q / (1.0 + i3),
            q / cos,
            n + p,
            forward * c - outward * s,
            forward * s + outward * c,
        ]
    }

    /// The energy of the motion, J, with the table as zero of height (`eq:rolling-energy`).
    pub fn energy(&self, state: &Rolling) -> f64 {
        let (i1, i3) = (0.5 * self.factor, self.factor);
        let Rolling { lean, lean_rate, across, along, .. } = *state;
        let kinetic = 0.5
            * ((1.0 + i1) * lean_rate * lean_rate + i1 * across * across + (1.0 + i3) * along * along)
            * self.radius;
        self.mass * self.radius * (kinetic + self.gravity * lean.cos())
    }

    /// The force of the table on the wheel, along axes 1, 2, 3, N (`eq:contact-force`).
    pub fn contact_force(&self, state: &Rolling) -> Vector3<f64> {
        let rates = self.rates(0.0, &state.to_array());
        let Rolling { lean, lean_rate, across: q, along: n, .. } = *state;
        let (sin, cos) = lean.sin_cos();
        let (m, a, g) = (self.mass, self.radius, self.gravity);
        Vector3::new(
            m * a * (lean_rate * q - rates[3]),
            m * (a * (n * q * sin / cos - lean_rate * lean_rate) + g * cos),
            m * (a * (rates[1] + n * q) - g * sin),
        )
    }

    /// The part of the contact force that holds the wheel up, N; negative where the wheel would leave the table
    /// (`eq:normal-force`).
    pub fn normal_force(&self, state: &Rolling) -> f64 {
        let acceleration = self.rates(0.0, &state.to_array())[1];
        let (sin, cos) = state.lean.sin_cos();
        self.mass
            * (self.gravity - self.radius * (acceleration * sin + state.lean_rate * state.lean_rate * cos))
    }

    /// The point of contact, m, in the table.
    pub fn contact_point(&self, state: &Rolling) -> [f64; 2] {
        let (s, c) = state.heading.sin_cos();
        let out = self.radius * state.lean.sin();
        let [x, y] = state.centre;
        [x - s * out, y + c * out]
    }

    /// The constants of a motion (`eq:chaplygin`). With [`Wheel::at_lean`] exact to 40 units in the last place of the sums of the closed
    /// form without their signs.
    pub fn constants(&self, state: &Rolling) -> RollingConstants {
        let values = self.conical.at(state.lean.sin(), gap(state.lean));
        let cos = state.lean.cos();
        let slope = state.across * cos / (1.0 + self.factor); // (1 − X²) dn/dX
        let square = cos * cos;
        RollingConstants {
            even: square * state.along * values.odd_slope - slope * values.odd,
            odd: slope * values.even - square * state.along * values.even_slope,
        }
    }

    /// The angular velocities q and n, rad/s, that a motion with these constants has at a lean, rad (`eq:chaplygin`): sums of a part of
    /// the even and one of the odd constant, which lose digits where these nearly cancel.
    pub fn at_lean(&self, constants: &RollingConstants, lean: f64) -> [f64; 2] {
        let values = self.conical.at(lean.sin(), gap(lean));
        let RollingConstants { even, odd } = *constants;
        let slope = even * values.even_slope + odd * values.odd_slope;
        [(1.0 + self.factor) * lean.cos() * slope, even * values.even + odd * values.odd]
    }

    /// The effective potential of the lean, J: the energy of a motion with these constants that passes this lean, rad, with
    /// no rate of lean (`eq:effective-potential`).
    pub fn potential(&self, constants: &RollingConstants, lean: f64) -> f64 {
        let [across, along] = self.at_lean(constants, lean);
        self.energy(&Rolling {
            lean,
            lean_rate: 0.0,
            across,
            along,
            heading: 0.0,
            spin: 0.0,
            centre: [0.0; 2],
        })
    }
}

/// What π/2 has beyond its `f64`.
const REST_OF_RIGHT_ANGLE: f64 = 6.123_233_995_736_766e-17;

/// 1 − |sin θ| without loss near ±π/2.
fn gap(lean: f64) -> f64 {
    let half = 0.5 * ((std::f64::consts::FRAC_PI_2 - lean.abs()) + REST_OF_RIGHT_ANGLE);
    2.0 * half.sin() * half.sin()
}

//! A symmetric top on a fixed point, under its weight. Chapter "The top under gravity".
//!
//! Axis 3 of the body is its axis of symmetry, from the fixed point towards the centre of mass; axis 3 of the room is
//! upright. Euler's angles are the tilt θ from upright, φ about the vertical and ψ about the axis (z-x-z); the spin is the
//! component `ω₃ = ψ̇ + φ̇ cos θ` of the angular velocity along the axis, which is kept.

mod motion;
mod roots;
mod theta;

pub use motion::{TopAngles, TopMotion};

use crate::attitude::check_attitude;
use crate::euler::{Turning, turning_rates};
use crate::inertia::{Body, PrincipalMoments};
use crate::quantity::{InvalidQuantity, Rule};
use crate::two_part::TwoPart;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::f64::consts::PI;

/// A symmetric body on a fixed point of its axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopParameters {
    /// Mass m, kg, more than zero.
    pub mass: f64,
    /// Arm l, from the fixed point to the centre of mass, m, more than zero.
    pub arm: f64,
    /// Moment of inertia I₁ about every axis across the body's own through the *fixed point*, kg·m², at least
    /// `mass · arm² + ½ axial`. [`Top::on_a_point`] finds it from the one about the centre of mass.
    pub transverse: f64,
    /// Moment of inertia I₃ about the body's axis, kg·m².
    pub axial: f64,
    /// Gravity g, m/s², zero or more.
    pub gravity: f64,
}

/// How a top is let go, at azimuth and own turn zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Release {
    /// Tilt θ from upright, rad, from 0 to π.
    pub tilt: f64,
    /// Rate of the tilt, rad/s.
    pub tilt_rate: f64,
    /// Rate φ̇ of the azimuth, rad/s, positive counter-clockwise from above.
    pub precession: f64,
    /// Spin ω₃, the angular velocity along the axis, rad/s, of either sign.
    pub spin: f64,
}

/// The rates at which a top of a tilt can go round steadily.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyPrecession {
    /// The slow one, rad/s, for a fast top about `mgl/(I₃ω₃)`.
    pub slow: f64,
    /// The fast one, rad/s, for a fast top about `I₃ω₃/(I₁ cos θ)`. None for a level axis.
    pub fast: Option<f64>,
}

/// What the tip of the axis draws on a sphere about the fixed point (`eq:top-track`).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Track {
    /// The axis always goes round in one sense.
    Waves,
    /// It stops at the top of every nod.
    Cusps,
    /// It goes back at the top of every nod.
    Loops,
    /// It does not nod.
    Steady,
}

/// A top.
///
/// ```
/// use mechanics::scenes::top::{Release, Top, TopParameters, Track};
/// let toy = Top::new(TopParameters { mass: 0.1, arm: 0.04, transverse: 2e-4, axial: 5e-5, gravity: 9.81 })?;
/// assert_eq!(format!("{:.1} rad/s", toy.sleeping_spin()), "112.1 rad/s");
/// // Let go at a tilt, it falls a little, goes round and rises again, with a cusp at each top of its nod.
/// let released = Release { tilt: 30_f64.to_radians(), tilt_rate: 0.0, precession: 0.0, spin: 150.0 };
/// let motion = toy.let_go(released)?;
/// let lowest = motion.tilts()[1].to_degrees();
/// assert_eq!((motion.track(), format!("{lowest:.1}°")), (Track::Cusps, "42.3°".to_owned()));
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Top {
    parameters: TopParameters,
    moments: PrincipalMoments,
    weight_torque: TwoPart, // mgl
}

impl Top {
    /// A top with the moments about its fixed point.
    ///
    /// ```
    /// use mechanics::scenes::top::{Top, TopParameters};
    /// let about_centre = TopParameters { mass: 1.0, arm: 0.5, transverse: 0.04, axial: 0.02, gravity: 9.81 };
    /// let refusal = Top::new(about_centre).unwrap_err();
    /// assert_eq!(
    ///     refusal.to_string(),
    ///     "transverse moment about the fixed point 0.04 kg·m² is less than mass · arm² plus half the axial moment \
    ///      (`Top::on_a_point` takes the moments about the centre of mass), 0.26 kg·m²"
    /// );
    /// ```
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule, if the moment about an axis across is less than `mass · arm²`
    /// plus half the axial moment, which no body has (`eq:triangle` about its centre of mass, and `eq:steiner`), or if
    /// the weight's torque over a moment is of a size that cannot be computed with.
    pub fn new(parameters: TopParameters) -> Result<Self, InvalidQuantity> {
        let TopParameters { mass, arm, transverse, axial, gravity } = parameters;
        InvalidQuantity::check_positive("mass", mass, "kg")?;
        InvalidQuantity::check_positive("arm", arm, "m")?;
        InvalidQuantity::check_not_negative("gravity", gravity, "m/s²")?;
        let moments = PrincipalMoments::symmetric(transverse, axial)?;
        let least = mass * arm * arm + 0.5 * axial;
        let is_body = transverse * (1.0 + ROUNDING) >= least;
        let name = "transverse moment about the fixed point";
        let what = "mass · arm² plus half the axial moment \
                    (`Top::on_a_point` takes the moments about the centre of mass)";
        let rule = Rule::NotBelow { what, limit: least };
        InvalidQuantity::require(is_body, name, transverse, "kg·m²", rule)?;
        let weight_torque = TwoPart::product(mass, gravity) * arm;
        let because = "the weight's torque over the moment of inertia leaves the range of numbers";
        let beta = (weight_torque * 2.0 / TwoPart::from(transverse)).rounded();
        InvalidQuantity::require_computable(weight_torque.rounded(), "gravity", gravity, "m/s²", because)?;
        InvalidQuantity::require_computable(beta, "gravity", gravity, "m/s²", because)?;
        Ok(Self { parameters, moments, weight_torque })
    }

    /// A body that is symmetric about its axis 3, on a point of that axis at the distance `arm`, m, below its centre.
    ///
    /// # Errors
    /// As [`Top::new`], and if the moments of the body about its axes 1 and 2 differ by more than rounding.
    pub fn on_a_point(body: &Body, arm: f64, gravity: f64) -> Result<Self, InvalidQuantity> {
        let about_centre = body.moments().as_symmetric()?;
        InvalidQuantity::check_positive("arm", arm, "m")?;
        Self::new(TopParameters {
            mass: body.mass(),
            arm,
            transverse: about_centre.transverse + body.mass() * arm * arm, // eq:steiner
            axial: about_centre.axial,
            gravity,
        })
    }

    /// What the top is made of.
    #[must_use]
    pub fn parameters(&self) -> TopParameters {
        self.parameters
    }

    /// The principal moments about the fixed point.
    #[must_use]
    pub fn moments(&self) -> PrincipalMoments {
        self.moments
    }

    /// The torque `mgl` of the weight about the fixed point with a level axis, N·m.
    #[must_use]
    pub fn weight_torque(&self) -> f64 {
        self.weight_torque.rounded()
    }

    /// The torque of the weight about the fixed point, along the body's axes, N·m (`eq:top-torque`).
    #[must_use]
    pub fn torque_body(&self, state: &Turning) -> Vector3<f64> {
        let up = state.world_from_body.inverse_transform_vector(&Vector3::z());
        Vector3::new(up.y, -up.x, 0.0) * self.weight_torque()
    }

    /// The rates of the seven numbers of [`Turning`], for an integrator (`eq:euler-rates` with the weight's torque).
    pub fn rates(&self) -> impl FnMut(f64, &[f64; 7]) -> [f64; 7] + use<> {
        let top = *self;
        turning_rates(self.moments, move |_, state| top.torque_body(state))
    }

    /// The energy of a state, J, counted from a level axis at rest (`eq:top-energy`).
    #[must_use]
    pub fn energy(&self, state: &Turning) -> f64 {
        self.moments.kinetic_energy(&state.omega_body) + self.weight_torque() * state.axis_3_world().z
    }

    /// The state of a top at the moment of letting go: azimuth and own turn are zero (`eq:top-angle-rates`).
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn released(&self, release: Release) -> Result<Turning, InvalidQuantity> {
        let Release { tilt, tilt_rate, precession, spin } = release;
        check_tilt(tilt)?;
        InvalidQuantity::check("rate of the tilt", tilt_rate, "rad/s")?;
        InvalidQuantity::check("precession", precession, "rad/s")?;
        InvalidQuantity::check("spin", spin, "rad/s")?;
        let (sin, cos) = (0.5 * tilt).sin_cos();
        // The cosine of a rounded right angle is not that of a right angle: a hanging axis hangs.
        let cos = if tilt == PI { 0.0 } else { cos };
        Ok(Turning {
            world_from_body: UnitQuaternion::new_unchecked(Quaternion::new(cos, sin, 0.0, 0.0)),
            omega_body: Vector3::new(tilt_rate, precession * (2.0 * sin * cos), spin), // eq:top-angle-rates
        })
    }

    /// The motion of a top that is let go.
    ///
    /// # Errors
    /// As [`Top::released`].
    pub fn let_go(&self, release: Release) -> Result<TopMotion, InvalidQuantity> {
        Ok(TopMotion::new(self, &self.released(release)?))
    }

    /// The motion from any attitude and angular velocity.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number of `start` is not finite or of a size that cannot be computed with, or if its
    /// quaternion is not of length one to 1e-12.
    pub fn motion(&self, start: &Turning) -> Result<TopMotion, InvalidQuantity> {
        for component in &start.omega_body {
            InvalidQuantity::check("angular velocity", *component, "rad/s")?;
        }
        check_attitude(&start.world_from_body)?;
        Ok(TopMotion::new(self, start))
    }

    /// The spin from which on an upright top sleeps, `2√(I₁mgl)/I₃`, rad/s (`eq:sleeping-spin`), to 4e-16 of itself.
    #[must_use]
    pub fn sleeping_spin(&self) -> f64 {
        ((self.weight_torque * self.parameters.transverse).sqrt() * 2.0
            / TwoPart::from(self.parameters.axial))
        .rounded()
    }

    /// How fast a small tilt of an upright top grows, as `e^{λt}`, 1/s: zero for one that sleeps (`eq:waking-rate`).
    /// Without cancellation at the threshold: to 4e-16 of itself for the spin as it is given.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a spin, rad/s, that is not finite or of a size that cannot be computed with.
    pub fn growth_rate(&self, spin: f64) -> Result<f64, InvalidQuantity> {
        InvalidQuantity::check("spin", spin, "rad/s")?;
        let a = self.momentum_by_moment(spin);
        Ok(((self.beta() * 2.0 - a * a).sqrt() * 0.5).rounded())
    }

    /// The tilt at which a top goes round steadily that has slept, as its spin falls below [`Top::sleeping_spin`] `ω_s`
    /// slowly and with no torque about the vertical but that about its axis: `cos ½θ = √(ω₃/ω_s)`, rad
    /// (`eq:waking-tilt`). Zero for one that sleeps, π for one that does not turn.
    ///
    /// # Errors
    /// As [`Top::growth_rate`].
    pub fn waking_tilt(&self, spin: f64) -> Result<f64, InvalidQuantity> {
        Ok(2.0 * self.lost(spin)?.sqrt().asin())
    }

    /// How far a top tilts that leaves the upright with this spin, rad/s, below [`Top::sleeping_spin`] `ω_s`: `cos ½θ =
    /// ω₃/ω_s`, rad (`eq:waking-nod`). Zero for one that sleeps.
    ///
    /// # Errors
    /// As [`Top::growth_rate`].
    pub fn furthest_tilt(&self, spin: f64) -> Result<f64, InvalidQuantity> {
        let lost = self.lost(spin)?;
        Ok(2.0 * (lost * (2.0 - lost)).sqrt().atan2(1.0 - lost))
    }

    /// What is missing of the sleeping spin, as a part of it: `1 − |ω₃|/ω_s`, or zero.
    fn lost(&self, spin: f64) -> Result<f64, InvalidQuantity> {
        InvalidQuantity::check("spin", spin, "rad/s")?;
        let momentum = TwoPart::product(self.parameters.axial, spin.abs());
        let threshold = (self.weight_torque * self.parameters.transverse).sqrt() * 2.0;
        if momentum.rounded() == 0.0 && threshold.rounded() == 0.0 {
            return Ok(0.0);
        }
        Ok(((threshold - momentum) / threshold).rounded().max(0.0))
    }

    /// The rates at which the axis goes round at a steady tilt, rad, with a spin, rad/s: the solutions of `I₁Ω² cos θ −
    /// I₃ω₃Ω + mgl = 0` (`eq:steady-precession`), each to 1e-15 of itself but for a unit in the last place of the tilt; the
    /// worst that a search found is 4e-16. A tilt within 9e-16 rad of a right angle counts as one. `None` if there are
    /// none: an axis above level needs `(I₃ω₃)² ≥ 4I₁ mgl cos θ`.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the tilt is not from 0 to π, if the spin is zero with a level axis or without weight, or if
    /// one of the two cannot be computed with.
    pub fn steady_precession(
        &self,
        tilt: f64,
        spin: f64,
    ) -> Result<Option<SteadyPrecession>, InvalidQuantity> {
        check_tilt(tilt)?;
        InvalidQuantity::check("spin", spin, "rad/s")?;
        let moment = self.parameters.transverse;
        let momentum = TwoPart::product(self.parameters.axial, spin);
        let (sin, cos_half) = (0.5 * tilt).sin_cos();
        let is_level = (tilt - 0.5 * PI).abs() < ROUNDING;
        let cos = if is_level { 0.0 } else { (cos_half - sin) * (cos_half + sin) };
        // (I₃ω₃)² − 4I₁mgl cos θ, with 1 − cos θ = 2 sin² ½θ beside the upright.
        let threshold = self.weight_torque * moment * 4.0;
        let leaning = threshold * (2.0 * sin * sin);
        let square = momentum * momentum
            - if is_level {
                TwoPart::from(0.0)
            } else if cos > 0.5 {
                threshold - leaning
            } else {
                threshold * cos
            };
        if square.rounded() < 0.0 {
            return Ok(None);
        }
        let size = if spin < 0.0 { -momentum } else { momentum };
        let sum = size + square.sqrt(); // of two numbers that are not negative
        let rule = Rule::Because("nothing goes round a level axis, or without weight, that does not spin");
        InvalidQuantity::require(sum.rounded() > 0.0, "spin", spin, "rad/s", rule)?;
        let sense = if spin < 0.0 { -1.0 } else { 1.0 };
        // eq:steady-product: the product of the two is mgl/(I₁ cos θ), so neither is a difference.
        let slow = sense * (self.weight_torque * 2.0 / sum).rounded();
        let fast = (cos != 0.0).then(|| sense * (sum / (TwoPart::product(2.0 * moment, cos))).rounded());
        Ok(Some(SteadyPrecession { slow, fast }))
    }

    /// `a = I₃ω₃/I₁`, rad/s (`eq:top-abbreviations`).
    fn momentum_by_moment(&self, spin: f64) -> TwoPart {
        TwoPart::product(self.parameters.axial, spin) / TwoPart::from(self.parameters.transverse)
    }

    /// `ω₃ − a`.
    fn spin_less_momentum(&self, spin: f64) -> TwoPart {
        let TopParameters { transverse, axial, .. } = self.parameters;
        TwoPart::sum(transverse, -axial) * spin / TwoPart::from(transverse)
    }

    /// `β = 2mgl/I₁`, 1/s² (`eq:top-abbreviations`).
    fn beta(&self) -> TwoPart {
        self.weight_torque * 2.0 / TwoPart::from(self.parameters.transverse)
    }
}

/// By how much, beside one, a body or a level axis may be beyond its limit through rounding.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

fn check_tilt(tilt: f64) -> Result<f64, InvalidQuantity> {
    InvalidQuantity::check_not_negative("tilt", tilt, "rad")?;
    InvalidQuantity::require(tilt <= PI, "tilt", tilt, "rad", Rule::AtMost(PI))
}

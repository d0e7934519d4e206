//! The whole motion from any start, in closed form.

use super::frames::Frames;
use super::machine::Machine;
use super::oscillator::{InvalidTime, Oscillator, Roots, Scaled, check_time};
use super::shaft::{InvalidStart, Shaft};
use super::steady::SteadyMotion;
use crate::frames::{InvalidFrames, fill};
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// The motion of the shaft from a given start (`eq:transient`), at any time, before or after.
///
/// From [`Machine::transient`]. An evaluation costs two sine–cosine pairs and an exponential: phases are formed from 32 digits. Its error is at
/// most ten units in the last place (`f64::EPSILON`) of the sum of the circle's radius, or near resonance what the circle has become by then, of what the free motion has made
/// of the start, and of what a change of the time by such a unit makes of the motion; a velocity's, of the same for velocities. That
/// holds at any time, for light, critical and heavy damping, at high spin, and at resonance, where without damping the motion
/// grows in proportion to the time. Before the start a damped motion grows, and with it what a rounded start has become.
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, Parameters, Shaft};
/// let machine = Machine::new(Parameters {
///     drum_mass: 28.0, load_mass: 2.0, load_radius: 0.25,
///     stiffness: 3000.0, damping: 90.0, spin: 30.0,
/// })?;
/// // After many times 2/Γ only the steady circle is left.
/// let late = machine.transient(Shaft::AT_REST)?.at(100.0)?;
/// assert!((late.position.norm() / machine.steady()?.radius() - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transient {
    pub(super) spin: f64,
    offset: f64,
    pub(super) free: Oscillator,
    pub(super) form: Form,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Form {
    /// The steady circle, and a free motion from `displacement` and `velocity`.
    Circle {
        amplitude: Complex<f64>,
        centre_of_mass_amplitude: Complex<f64>,
        displacement: Complex<f64>,
        velocity: Complex<f64>,
    },
    /// Near resonance with little damping the circle may be huge and nearly cancelled by the free motion. Then: the
    /// free motion from the start, and what the rotating force adds from rest.
    BuildUp(BuildUp),
}

/// What a rotating force near resonance adds to a motion from rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BuildUp {
    start: Shaft,
    push: f64,          // bΩ²
    frequency: TwoPart, // ω₁ with the sign of Ω
    half_damping: f64,  // Γ/2
    near: Complex<f64>, // iΩ − λ for the root λ = −Γ/2 + iω₁, ω₁ with the sign of Ω
    far: Complex<f64>,  // and for −Γ/2 − iω₁
}

/// How near to resonance the second form is used: |iΩ − λ| below this part of ω₀. There the circle would be larger than
/// twice b, and the free motion that starts with it would take digits away.
const NEAR: f64 = 0.25;

impl Machine {
    /// The motion that starts at time zero with the shaft as given and the load at azimuth zero.
    ///
    /// # Errors
    /// [`InvalidStart`] if a component of the start is not finite or is beyond 1e50 m or m/s.
    pub fn transient(&self, start: Shaft) -> Result<Transient, InvalidStart> {
        start.check_start()?;
        let [spin, offset] = [self.spin(), self.offset()];
        let free = Oscillator::new(self.precise_damping_rate(), self.stiffness_rate());
        let form = match self.build_up(&free, start) {
            Some(build_up) => Form::BuildUp(build_up),
            None => circle(spin, offset, start, &self.steady_circle()),
        };
        Ok(Transient { spin, offset, free, form })
    }

    /// The form for light damping near resonance; `None` elsewhere.
    fn build_up(&self, free: &Oscillator, start: Shaft) -> Option<BuildUp> {
        let Roots::Turning { frequency } = free.roots() else {
            return None;
        };
        let spin = self.spin();
        let frequency = if spin < 0.0 { -frequency } else { frequency };
        let half_damping = 0.5 * self.damping_rate();
        let spin_parts = TwoPart::from(spin);
        let near = Complex::new(half_damping, (spin_parts - frequency).rounded());
        let far = Complex::new(half_damping, (spin_parts + frequency).rounded());
        let push = self.offset() * (spin * spin);
        (near.norm() < NEAR * self.natural_frequency()).then_some(BuildUp {
            start,
            push,
            frequency,
            half_damping,
            near,
            far,
        })
    }
}

fn circle(spin: f64, offset: f64, start: Shaft, steady: &SteadyMotion) -> Form {
    let turning = Complex::i() * spin;
    let amplitude = steady.amplitude();
    let centre_of_mass_amplitude = steady.centre_of_mass_amplitude();
    // The start less the circle's share, taken where the circle is small: for the shaft or for the centre of mass.
    let (position, velocity, share) = if steady.radius() <= steady.centre_of_mass_radius() {
        (start.position, start.velocity, amplitude)
    } else {
        (start.position + offset, start.velocity + turning * offset, centre_of_mass_amplitude)
    };
    Form::Circle {
        amplitude,
        centre_of_mass_amplitude,
        displacement: position - share,
        velocity: velocity - turning * share,
    }
}

impl Transient {
    /// Position and velocity of the shaft at time `t`, s, in the laboratory.
    ///
    /// Times before the start are allowed: they ask which earlier motion leads to it.
    ///
    /// # Errors
    /// [`InvalidTime`] if the time is not finite or is further than 1e150 s from the start, or if it lies so long before the
    /// start of a damped machine that the motion there is beyond the largest number.
    pub fn at(&self, t: f64) -> Result<Shaft, InvalidTime> {
        check_time(t)?;
        let load = self.load_direction(t);
        let shaft = match &self.form {
            Form::Circle { amplitude, displacement, velocity, .. } => {
                let circle = amplitude * load;
                let (s, s_dot) = self.free.at(*displacement, *velocity, t).multiplied();
                Shaft { position: circle + s, velocity: turned(circle, self.spin) + s_dot }
            }
            Form::BuildUp(build_up) => {
                let (position, velocity) = build_up.at(&self.free, self.spin, load, t).multiplied();
                Shaft { position, velocity }
            }
        };
        if shaft.is_finite() { Ok(shaft) } else { Err(InvalidTime::OutOfRange { time: t }) }
    }

    /// Position of the centre of mass of drum and load at time `t`, s, in the laboratory, m
    /// (`eq:centre-of-mass-motion`).
    ///
    /// Formed from its own circle and not from the shaft's, so that nothing cancels at high spin: its error is that of the
    /// shaft, with its own circle's radius for the shaft's if that is less.
    ///
    /// # Errors
    /// As [`Transient::at`].
    pub fn centre_of_mass(&self, t: f64) -> Result<Complex<f64>, InvalidTime> {
        check_time(t)?;
        let load = self.load_direction(t);
        let position = match &self.form {
            Form::Circle { centre_of_mass_amplitude, displacement, velocity, .. } => {
                centre_of_mass_amplitude * load + self.free.at(*displacement, *velocity, t).multiplied().0
            }
            Form::BuildUp(build_up) => {
                build_up.at(&self.free, self.spin, load, t).multiplied().0 + load * self.offset
            }
        };
        if position.is_finite() { Ok(position) } else { Err(InvalidTime::OutOfRange { time: t }) }
    }

    /// The shaft at each of `times`, s, written to `frames` without allocating.
    ///
    /// Lightly damped machines away from resonance take a form that the compiler turns into instructions for several frames
    /// at once; it differs from [`Transient::at`] in rounding only.
    ///
    /// # Errors
    /// [`InvalidFrames::Length`] if there are not as many frames as times, and then nothing is written;
    /// [`InvalidFrames::Time`] at the first time that [`Transient::at`] refuses.
    pub fn fill(&self, times: &[f64], frames: &mut [Shaft]) -> Result<(), InvalidFrames<InvalidTime>> {
        let quick = |times: &[f64], frames: &mut [Shaft]| {
            Frames::new(self).map_or(0, |quick| quick.fill(times, frames))
        };
        fill(times, frames, quick, |t| self.at(t))
    }

    fn load_direction(&self, t: f64) -> Complex<f64> {
        let (sin, cos) = TwoPart::product(self.spin, t).sin_cos();
        Complex::new(cos, sin)
    }
}

impl BuildUp {
    /// With λ = −Γ/2 ± iω₁ the force bΩ²e^{iΩt} makes, from rest, bΩ² times the second divided difference of e^{λt} at
    /// iΩ and the two λ. The first difference, of iΩ and the nearer λ, is the one that needs care.
    fn at(&self, free: &Oscillator, spin: f64, load: Complex<f64>, t: f64) -> Scaled {
        let free_part = free.at(self.start.position, self.start.velocity, t);
        // e^{iΩt} and e^{λt}, of which the factor that grows, before the start, is left to the end.
        let decay = (-self.half_damping * t.abs()).exp();
        let (sin, cos) = (self.frequency * t).sin_cos();
        let (forced, damped) = if t >= 0.0 { (load, decay) } else { (load * decay, 1.0) };
        let [near_root, far_root] = [Complex::new(cos, sin) * damped, Complex::new(cos, -sin) * damped];

        let exponent = self.near * t;
        let near = if exponent.norm_sqr() < 1.0 {
            forced * one_minus_exp_over(exponent) * t // (e^{iΩt} − e^{λt})/(iΩ − λ), without a difference
        } else {
            (forced - near_root) / self.near
        };
        let far = (forced - far_root) / self.far;
        let frequency = self.frequency.rounded();
        let response = (near - far) / Complex::new(0.0, 2.0 * frequency);
        let response_rate = turned(response, spin) + damped * (sin / frequency);

        let free_scale = if t >= 0.0 { free_part.exponent.exp() } else { 1.0 };
        Scaled {
            position: free_part.position * free_scale + response * self.push,
            velocity: free_part.velocity * free_scale + response_rate * self.push,
            exponent: if t >= 0.0 { 0.0 } else { free_part.exponent },
        }
    }
}

/// i times a rate times z.
fn turned(z: Complex<f64>, rate: f64) -> Complex<f64> {
    Complex::new(-rate * z.im, rate * z.re)
}

/// (1 − e^{−q})/q without cancellation, for |q| up to about 1; one at q = 0.
fn one_minus_exp_over(q: Complex<f64>) -> Complex<f64> {
    if q.norm_sqr() == 0.0 {
        return Complex::new(1.0, 0.0);
    }
    let half_sin = (0.5 * q.im).sin();
    let grown = (-q.re).exp();
    // 1 − e^{−x} cos y = −expm1(−x) + 2 e^{−x} sin²(y/2)
    let real = -(-q.re).exp_m1() + 2.0 * grown * half_sin * half_sin;
    Complex::new(real, grown * q.im.sin()) / q
}

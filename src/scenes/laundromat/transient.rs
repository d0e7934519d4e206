//! The whole motion from any start, in closed form.

use super::machine::{Machine, direction};
use super::oscillator::{FreeMotion, Oscillator, Roots, Scaled, Swing, mean_exponential};
use super::shaft::{Shaft, out_of_range};
use super::steady::SteadyMotion;
use crate::clock::Clock;
use crate::lanes::{Branchless, sample_branchless};
use crate::quantity::InvalidQuantity;
use crate::two_part::TwoPart;
use nalgebra::Complex;

/// The motion of the shaft from a given start (`eq:transient`), at any time, before or after.
///
/// From [`Machine::transient`]. An evaluation costs two sine–cosine pairs and an exponential: phases are formed from 32
/// digits. Its error is at most ten units in the last place (`f64::EPSILON`) of the sum of the circle's radius, or near
/// resonance what the circle has become by then, of what the free motion has made of the start, and of what a change of
/// the time by such a unit makes of the motion; a velocity's, of the same for velocities. That holds at any time, for
/// light, critical and heavy damping, at high spin, and at resonance, where without damping the motion grows in
/// proportion to the time. Before the start a damped motion grows, and with it what a rounded start has become.
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
/// let machine = Machine::new(MachineParameters {
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
    spin: f64,
    load: Clock, // Ωt
    offset: f64,
    form: Form,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    Circle(Circle),
    BuildUp(BuildUp),
}

/// The two terms of `eq:transient`: the steady circle, and a free motion that begins with what it leaves of the start.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Circle {
    amplitude: Complex<f64>,                // Z
    centre_of_mass_amplitude: Complex<f64>, // Z + b
    free: FreeMotion,                       // from s₀ and ṡ₀
}

/// The two terms where damping is light, for many times at once.
#[derive(Debug, Clone, Copy)]
struct Light {
    spin: f64,
    load: Clock,
    amplitude: Complex<f64>,
    swing: Swing,
}

/// Near resonance, with little damping, the circle is huge and nearly cancelled by the free motion at first. So
/// there: the free motion from the start, and what the force adds from rest (`eq:build-up`).
#[derive(Debug, Clone, Copy, PartialEq)]
struct BuildUp {
    free: FreeMotion,
    push: f64,          // bΩ²
    frequency: TwoPart, // ω₁ with the sign of Ω: the nearer root is −Γ/2 + iω₁
    half_damping: f64,  // Γ/2
    near: Complex<f64>, // iΩ − λ for the nearer root
    far: Complex<f64>,  // and for the other
}

/// How near to resonance the second form is used: |iΩ − λ| below this part of ω₀. There the circle would be larger than
/// twice b, and the free motion that starts with it would take digits away.
const NEAR: f64 = 0.25;

impl Machine {
    /// The motion that starts at time zero with the shaft as given and the load at azimuth zero.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a component of the start is not finite or is beyond 1e50 m or m/s.
    pub fn transient(&self, start: Shaft) -> Result<Transient, InvalidQuantity> {
        start.check_start()?;
        let [spin, offset] = [self.spin(), self.offset()];
        let free = Oscillator::new(self.precise_damping_rate(), self.stiffness_rate());
        let form = match BuildUp::new(self, &free, start) {
            Some(build_up) => Form::BuildUp(build_up),
            None => Form::Circle(Circle::new(&free, spin, offset, start, &self.steady_circle())),
        };
        Ok(Transient { spin, load: Clock::from_rate(TwoPart::from(spin)), offset, form })
    }
}

impl Transient {
    /// Position and velocity of the shaft at a time, s, in the laboratory.
    ///
    /// Times before the start are allowed: they ask which earlier motion leads to it.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if the time is not finite or beyond 1e50 s, or if it lies so long before the start of a
    /// damped machine that the motion there is beyond the largest number.
    pub fn at(&self, time: f64) -> Result<Shaft, InvalidQuantity> {
        InvalidQuantity::check_time(time)?;
        let load = self.load_direction(time);
        let shaft = match &self.form {
            Form::Circle(Circle { amplitude, free, .. }) => {
                Shaft::circling(amplitude * load, self.spin).plus(free.at(time).multiplied())
            }
            Form::BuildUp(build_up) => build_up.at(self.spin, load, time).multiplied(),
        };
        shaft.in_range(time)
    }

    /// The shaft at each of these times, s: as [`Transient::at`], to rounding, and several times as quick for lightly
    /// damped machines away from resonance.
    ///
    /// # Errors
    /// As [`Transient::at`], for the first time that it refuses.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Shaft>, InvalidQuantity> {
        let at = |time: f64| self.at(time);
        let Form::Circle(Circle { amplitude, free: FreeMotion::Turning(swing), .. }) = self.form else {
            return times.iter().map(|&time| at(time)).collect();
        };
        let light = Light { spin: self.spin, load: self.load, amplitude, swing };
        let reach = self.load.reach().min(swing.reach());
        sample_branchless(light, [-reach, reach], times, Shaft::AT_REST, at)
    }

    /// Position of the centre of mass of drum and load at a time, s, in the laboratory, m
    /// (`eq:centre-of-mass-motion`).
    ///
    /// Formed from its own circle and not from the shaft's, so that nothing cancels at high spin: its error is that
    /// of the shaft, with its own circle's radius for the shaft's if that is less.
    ///
    /// # Errors
    /// As [`Transient::at`].
    pub fn centre_of_mass(&self, time: f64) -> Result<Complex<f64>, InvalidQuantity> {
        InvalidQuantity::check_time(time)?;
        let load = self.load_direction(time);
        let position = match &self.form {
            Form::Circle(Circle { centre_of_mass_amplitude, free, .. }) => {
                centre_of_mass_amplitude * load + free.at(time).multiplied().position
            }
            Form::BuildUp(build_up) => {
                build_up.at(self.spin, load, time).multiplied().position + load * self.offset
            }
        };
        if position.is_finite() { Ok(position) } else { Err(out_of_range(time)) }
    }

    /// e^{iΩt}, the phase formed from 32 digits.
    fn load_direction(&self, time: f64) -> Complex<f64> {
        let (sin, cos) = self.load.sin_cos::<true>(time);
        Complex::new(cos, sin)
    }
}

impl Branchless for Light {
    type State = Shaft;

    #[inline(always)]
    fn state<const ONE: bool>(&self, time: f64) -> Shaft {
        let (sin, cos) = self.load.sin_cos::<ONE>(time);
        Shaft::circling(self.amplitude * Complex::new(cos, sin), self.spin)
            .plus(Shaft::from_array(self.swing.at(time)))
    }

    #[inline(always)]
    fn is_finite(state: &Shaft) -> bool {
        state.is_finite()
    }
}

impl Circle {
    fn new(free: &Oscillator, spin: f64, offset: f64, start: Shaft, steady: &SteadyMotion) -> Self {
        let turning = Complex::i() * spin;
        let (amplitude, centre_of_mass_amplitude) = (steady.amplitude(), steady.centre_of_mass_amplitude());
        // s₀ and ṡ₀ of eq:transient, for the shaft or for the centre of mass, whichever has the smaller circle to be
        // taken off.
        let (position, velocity, circle) = if steady.radius() <= steady.centre_of_mass_radius() {
            (start.position, start.velocity, amplitude)
        } else {
            (start.position + offset, start.velocity + turning * offset, centre_of_mass_amplitude)
        };
        let rest = Shaft { position: position - circle, velocity: velocity - turning * circle };
        Self { amplitude, centre_of_mass_amplitude, free: free.from(rest) }
    }
}

impl BuildUp {
    /// `None` for heavy damping and away from resonance.
    fn new(machine: &Machine, free: &Oscillator, start: Shaft) -> Option<Self> {
        let Roots::Turning { frequency } = free.roots() else {
            return None;
        };
        let spin = machine.spin();
        let frequency = if spin < 0.0 { -frequency } else { frequency };
        let half_damping = 0.5 * machine.damping_rate();
        let near = Complex::new(half_damping, (TwoPart::from(spin) - frequency).rounded());
        let far = Complex::new(half_damping, (TwoPart::from(spin) + frequency).rounded());
        let push = machine.offset() * (spin * spin);
        (near.norm() < NEAR * machine.natural_frequency()).then_some(Self {
            free: free.from(start),
            push,
            frequency,
            half_damping,
            near,
            far,
        })
    }

    /// The free motion from the start and `eq:build-up`.
    fn at(&self, spin: f64, load: Complex<f64>, time: f64) -> Scaled {
        let Scaled { shaft: free, exponent } = self.free.at(time);
        // e^{iΩt} and e^{λt}, of which the factor that grows, before the start, is left to the end.
        let decay = (-self.half_damping * time.abs()).exp();
        let turned = direction(self.frequency * time);
        let (forced, damped) = if time >= 0.0 { (load, decay) } else { (load * decay, 1.0) };
        let [near_root, far_root] = [turned * damped, turned.conj() * damped];

        let passed = self.near * time;
        let near = if passed.norm_sqr() < 1.0 {
            forced * mean_exponential(-passed) * time // the same quotient without a difference
        } else {
            (forced - near_root) / self.near
        };
        let far = (forced - far_root) / self.far;
        let frequency = self.frequency.rounded();
        let response = (near - far) / Complex::new(0.0, 2.0 * frequency);
        // The rate of (e^{iΩt} − e^{λt})/(iΩ − λ) is iΩ times it and e^{λt}.
        let response_rate = Complex::new(0.0, spin) * response + damped * (turned.im / frequency);

        let forced = Shaft { position: response * self.push, velocity: response_rate * self.push };
        if time >= 0.0 {
            Scaled { shaft: free.times(exponent.exp()).plus(forced), exponent: 0.0 }
        } else {
            Scaled { shaft: free.plus(forced), exponent }
        }
    }
}

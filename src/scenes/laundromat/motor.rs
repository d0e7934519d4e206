//! A motor that is not infinitely strong: its torque falls as the drum turns faster, and the drum turns as fast as
//! motor and shaking let it (the page *A motor of limited torque*, Sommerfeld's effect).

use super::machine::Machine;
use crate::quantity::{InvalidQuantity, Rule};
use nalgebra::{Complex, Matrix5, Schur, Vector5};

/// The largest entry of a matrix whose roots are sought.
const LARGEST_ENTRY: f64 = 1e150;
/// After so many sweeps without an answer the search for the roots is given up; a dozen are common.
const SWEEPS: usize = 100;

/// A motor with a straight characteristic, and the drum that it turns.
///
/// Its torque at the spin φ̇ is `τ_stall (1 − φ̇/Ω_idle)`, `eq:motor-line`, also beyond the idle spin, where it brakes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motor {
    /// Torque `τ_stall` on a drum that stands still, N·m; more than zero.
    pub stall_torque: f64,
    /// Spin `Ω_idle` at which the torque is zero, rad/s; more than zero.
    pub idle_spin: f64,
    /// Moment of inertia I of the drum, without the load, about its shaft, kg·m²; zero or more.
    pub drum_inertia: f64,
}

/// A machine that a motor turns. Made by [`Machine::driven`]; the spin in the machine's parameters plays no part.
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, Motor, MachineParameters};
/// let machine = Machine::new(MachineParameters {
///     drum_mass: 28.0, load_mass: 2.0, load_radius: 0.25,
///     stiffness: 3000.0, damping: 90.0, spin: 0.0,
/// })?;
/// let drive = machine.driven(Motor { stall_torque: 3.0, idle_spin: 40.0, drum_inertia: 0.5 })?;
/// // Three speeds, and the drum leaves the middle one.
/// let [stuck, middle, fast] = drive.steady_spins()[..] else { panic!("there are three") };
/// assert!(drive.growth_rate(stuck)? < 0.0 && drive.growth_rate(fast)? < 0.0);
/// assert!(drive.growth_rate(middle)? > 0.0);
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrivenMachine {
    machine: Machine,
    motor: Motor,
    inertia: f64, // I_cm
}

/// The state of a driven machine, seen from axes that turn with the drum, the first of which points to the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrivenState {
    /// Position of the shaft from O along the drum's axes, z e<sup>−iφ</sup>, m.
    pub position: Complex<f64>,
    /// Velocity of the shaft *in the room*, its components along the drum's axes, ż e<sup>−iφ</sup>, m/s.
    pub velocity: Complex<f64>,
    /// Spin of the drum φ̇, rad/s.
    pub spin: f64,
}

/// A steady speed at which two others meet and vanish.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fold {
    /// The spin, rad/s.
    pub spin: f64,
    /// The stall torque, N·m.
    pub stall_torque: f64,
}

/// Both folds of a driven machine, from [`DrivenMachine::folds`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Folds {
    /// Where a drum that is stuck below the resonance breaks through as the stall torque is raised.
    pub up: Fold,
    /// Where a fast drum falls back as the stall torque is lowered.
    pub down: Fold,
}

impl Machine {
    /// This machine with a motor of limited torque.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number of the motor is out of its range, if there is no damping (then the shaking asks
    /// for no torque), or if nothing resists a change of spin: drum, load and tub have I + mMa²/(m + M) = 0.
    pub fn driven(self, motor: Motor) -> Result<DrivenMachine, InvalidQuantity> {
        let Motor { stall_torque, idle_spin, drum_inertia } = motor;
        InvalidQuantity::check_positive("stall torque", stall_torque, "N·m")?;
        InvalidQuantity::check_positive("idle spin", idle_spin, "rad/s")?;
        InvalidQuantity::check_not_negative("moment of inertia of the drum", drum_inertia, "kg·m²")?;
        let parameters = self.parameters();
        InvalidQuantity::require(self.damping_rate() > 0.0, "damping", 0.0, "kg/s", Rule::Positive)?;
        // I + mMa²/(m + M): mab is ma² m/(m + M).
        let inertia = drum_inertia + parameters.drum_mass * self.offset() * parameters.load_radius;
        InvalidQuantity::require(inertia > 0.0, "moment of inertia", inertia, "kg·m²", Rule::Positive)?;
        Ok(DrivenMachine { machine: self, motor, inertia })
    }
}

impl DrivenMachine {
    /// The motor.
    #[must_use]
    pub fn motor(&self) -> Motor {
        self.motor
    }

    /// The same with another stall torque, N·m.
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless it is more than zero.
    pub fn with_stall_torque(self, stall_torque: f64) -> Result<Self, InvalidQuantity> {
        self.machine.driven(Motor { stall_torque, ..self.motor })
    }

    /// Torque of the motor at a spin in rad/s, N·m (`eq:motor-line`).
    #[must_use]
    pub fn motor_torque(&self, spin: f64) -> f64 {
        self.motor.stall_torque * (1.0 - spin / self.motor.idle_spin)
    }

    /// Moment of inertia `I_cm` = I + mMa²/(m + M) of what turns, about the common centre of mass, kg·m².
    #[must_use]
    pub fn inertia(&self) -> f64 {
        self.inertia
    }

    /// Rates of the state ([`DrivenState::to_array`]) for an integrator (`eq:driven-shaft`, `eq:driven-spin`). They do
    /// not contain the time.
    #[must_use]
    pub fn rates(&self, _time: f64, state: &[f64; 5]) -> [f64; 5] {
        let DrivenState { position, velocity, spin } = DrivenState::from_array(*state);
        let turn = Complex::i() * spin;
        let pull = self.pull(position, velocity);
        let acceleration = self.spin_acceleration(self.motor_torque(spin), pull);
        DrivenState {
            position: velocity - turn * position,
            velocity: self.machine.offset() * Complex::new(spin * spin, -acceleration)
                - pull
                - turn * velocity,
            spin: acceleration,
        }
        .to_array()
    }

    /// All spins that can go on for ever, rad/s, in rising order: one, or three between the torques of the two folds
    /// (`eq:steady-speeds`), accurate to some units in the last place away from the folds.
    ///
    /// None is missed if Γ is more than 1e-14 ω₀: between 0, the folds and the idle spin the stall torque that a spin
    /// takes only rises or only falls. With less damping the resonance is so narrow that its peak lies between two
    /// neighbouring numbers, and two of three are missed if the stall torque is above what [`DrivenMachine::folds`]
    /// finds there.
    #[must_use]
    pub fn steady_spins(&self) -> Vec<f64> {
        let folds = self.folds().map(|folds| [folds.up.spin, folds.down.spin]);
        let mut ends = vec![0.0];
        ends.extend(folds.into_iter().flatten());
        ends.push(self.motor.idle_spin);
        let lacking = |spin: f64| self.shaking_torque(spin) - self.motor_torque(spin);
        ends.windows(2).filter_map(|piece| root(lacking, piece[0], piece[1])).collect()
    }

    /// The two folds, or `None` if there is one steady spin for any stall torque. The stall torque of this motor plays
    /// no part. If Γ is 1e-14 ω₀ or less, the stall torque of the upper one comes out too small: no number is so near
    /// to its spin.
    #[must_use]
    pub fn folds(&self) -> Option<Folds> {
        // eq:motor-folds, in units of ω₀.
        let natural = self.machine.natural_frequency();
        let (idle, damping) = (self.motor.idle_spin / natural, self.machine.damping_rate() / natural);
        let h = 2.0 - damping * damping;
        let quartic = |x: f64| idle * (5.0 - 3.0 * h * x * x + x.powi(4)) - 2.0 * x * (2.0 - h * x * x);
        let slope = |x: f64| idle * (4.0 * x.powi(3) - 6.0 * h * x) - 4.0 + 6.0 * h * x * x;
        // For x > 0 the slope changes its sign once, from below: the signs of its coefficients change once.
        let lowest = root(slope, 0.0, idle).filter(|&lowest| h > 0.0 && quartic(lowest) < 0.0)?;
        let fold = |x: f64| {
            let spin = x * natural;
            Fold { spin, stall_torque: self.stall_torque_for(spin) }
        };
        let up = fold(root(quartic, 0.0, lowest)?);
        let down = fold(root(quartic, lowest, idle)?);
        Some(Folds { up, down })
    }

    /// The stall torque at which this spin can go on for ever, N·m (`eq:steady-speeds`).
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless the spin is between zero and the idle spin.
    pub fn required_stall_torque(&self, spin: f64) -> Result<f64, InvalidQuantity> {
        InvalidQuantity::require_finite("spin", spin, "rad/s")?;
        let rule = Rule::Because("only between standstill and its idle spin does the motor drive");
        let drives = 0.0 < spin && spin < self.motor.idle_spin;
        InvalidQuantity::require(drives, "spin", spin, "rad/s", rule)?;
        Ok(self.stall_torque_for(spin))
    }

    /// The state of the steady motion at a spin in rad/s.
    ///
    /// # Errors
    /// As [`Machine::with_spin`].
    pub fn steady_state(&self, spin: f64) -> Result<DrivenState, InvalidQuantity> {
        let position = self.machine.with_spin(spin)?.steady_circle().amplitude();
        Ok(DrivenState { position, velocity: Complex::i() * spin * position, spin })
    }

    /// What the rates do to a small change of the state beside the steady motion at this spin, with the stall torque
    /// that it takes.
    ///
    /// # Errors
    /// As [`DrivenMachine::required_stall_torque`].
    pub fn stability_matrix(&self, spin: f64) -> Result<Matrix5<f64>, InvalidQuantity> {
        let motor_slope = -self.required_stall_torque(spin)? / self.motor.idle_spin;
        let steady = self.steady_state(spin)?;
        let turn = Complex::i() * spin;
        let columns = [0, 1, 2, 3, 4].map(|column| {
            let mut unit = [0.0; 5];
            unit[column] = 1.0;
            let change = DrivenState::from_array(unit);
            let pull = self.pull(change.position, change.velocity);
            let acceleration = self.spin_acceleration(motor_slope * change.spin, pull);
            let swing = Complex::i() * change.spin;
            let push = self.machine.offset() * Complex::new(2.0 * spin * change.spin, -acceleration);
            let rates = DrivenState {
                position: change.velocity - turn * change.position - swing * steady.position,
                velocity: push - pull - turn * change.velocity - swing * steady.velocity,
                spin: acceleration,
            };
            rates.to_array().into()
        });
        Ok(Matrix5::from_columns(&columns))
    }

    /// Rate at which the fastest small disturbance of the steady motion at this spin grows, 1/s; negative if all of
    /// them die out.
    ///
    /// If Γ is at least 1e-5 ω₀, its error is what a change of the machine's numbers, and of the entries of
    /// [`DrivenMachine::stability_matrix`] in units in which rows and columns are alike in size, by 250 units in the
    /// last place (`f64::EPSILON`, of the largest root) makes. That is 1e-13 of the largest root or less, but only half
    /// of the digits are left where two roots meet, as at critical damping. With less damping 1e-6 of the largest root
    /// stands in place of what the entries make. A rate nearer to zero than that may have the wrong sign.
    ///
    /// # Errors
    /// As [`DrivenMachine::required_stall_torque`], or if the rates of a disturbance are too large to be computed with.
    pub fn growth_rate(&self, spin: f64) -> Result<f64, InvalidQuantity> {
        let matrix = self.stability_matrix(spin)?;
        let rule = Rule::Because("the rates of a disturbance there are too large to be computed with");
        let computable = matrix.iter().all(|entry| entry.abs() < LARGEST_ENTRY);
        InvalidQuantity::require(computable, "spin", spin, "rad/s", rule)?;
        let matrix = balanced(matrix);
        // Now and then the sweeps go round in a circle, and from other axes they do not.
        let schur = (0..16).find_map(|n| {
            let axis = Vector5::from_fn(|row, _| f64::from(n * (row as i32 + 1)).sin());
            let mirror = Matrix5::identity() - axis * axis.transpose() * (2.0 / axis.norm_squared().max(1.0));
            Schur::try_new(mirror * matrix * mirror, f64::EPSILON, SWEEPS)
        });
        let schur = schur.ok_or(InvalidQuantity { quantity: "spin", value: spin, unit: "rad/s", rule })?;
        Ok(schur.complex_eigenvalues().iter().map(|root| root.re).fold(f64::NEG_INFINITY, f64::max))
    }

    /// Γż + ω₀²z, from position and velocity along any axes.
    fn pull(&self, position: Complex<f64>, velocity: Complex<f64>) -> Complex<f64> {
        let natural = self.machine.natural_frequency();
        self.machine.damping_rate() * velocity + natural * natural * position
    }

    /// φ̈ for a torque of the motor and a pull of the suspension along the drum's axes (`eq:driven-spin`).
    fn spin_acceleration(&self, torque: f64, pull: Complex<f64>) -> f64 {
        let unbalance = self.machine.total_mass() * self.machine.offset(); // ma
        (torque + unbalance * pull.im) / self.inertia
    }

    /// What shaking takes at constant spin, N·m (`eq:steady-torque`).
    fn shaking_torque(&self, spin: f64) -> f64 {
        // A spin that is too small for a machine takes no torque.
        self.machine.with_spin(spin).map_or(0.0, |machine| machine.steady_circle().motor_torque())
    }

    fn stall_torque_for(&self, spin: f64) -> f64 {
        self.shaking_torque(spin) / (1.0 - spin / self.motor.idle_spin)
    }
}

impl DrivenState {
    /// Everything at rest, the shaft at O.
    pub const AT_REST: Self =
        Self { position: Complex::new(0.0, 0.0), velocity: Complex::new(0.0, 0.0), spin: 0.0 };

    /// Position, velocity, spin, as an integrator wants them.
    #[must_use]
    pub fn to_array(&self) -> [f64; 5] {
        [self.position.re, self.position.im, self.velocity.re, self.velocity.im, self.spin]
    }

    /// The way back from [`DrivenState::to_array`].
    #[must_use]
    pub fn from_array([x, y, vx, vy, spin]: [f64; 5]) -> Self {
        Self { position: Complex::new(x, y), velocity: Complex::new(vx, vy), spin }
    }
}

/// The same matrix in units, powers of two, in which each row is about as large as its column, the diagonal left out.
/// Without them the search for the roots takes for nothing what is small beside the largest entries.
fn balanced(mut matrix: Matrix5<f64>) -> Matrix5<f64> {
    for n in 0..100 {
        let i = n % 5;
        let others =
            |entry: &dyn Fn(usize) -> f64| (0..5).filter(|&j| j != i).map(|j| entry(j).abs()).sum::<f64>();
        let [row, column] = [others(&|j| matrix[(i, j)]), others(&|j| matrix[(j, i)])];
        if row > 0.0 && column > 0.0 {
            let unit = 2_f64.powi((0.5 * (row / column).log2()).round() as i32);
            matrix.column_mut(i).scale_mut(unit);
            matrix.row_mut(i).unscale_mut(unit);
        }
    }
    matrix
}

/// Where a function changes its sign between `low` and `high`, if it does so at most once, to the last place.
fn root(function: impl Fn(f64) -> f64, low: f64, high: f64) -> Option<f64> {
    let rises = function(low) < 0.0;
    if rises == (function(high) < 0.0) {
        return None;
    }
    let (mut low, mut high) = (low, high);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return Some(middle);
        }
        if (function(middle) < 0.0) == rises { low = middle } else { high = middle }
    }
}

//! How the shaft moves: parts between the moments at which the drum stops speeding up or the machine is kicked.

use super::{ACCELERATION, DRUM_INERTIA, GAUSS, LARGEST_SWING, LASTS, WEAK_LASTS, steady};
use live::prelude::*;
use mechanics::integrate::{Dop853, rk4_step};
use mechanics::scenes::laundromat::{
    DrivenMachine, DrivenState, Machine, Motor, Ramp, Rotor, RotorMotion, Shaft, Transient,
};
use nalgebra::Complex;

/// The machine at a time: its shaft, the azimuth of the load and the spin of the drum.
pub(super) struct State {
    pub shaft: Shaft,
    pub azimuth: f64,
    pub spin: f64,
}

impl State {
    /// The direction from the shaft to the load.
    pub(super) fn load(&self) -> Complex<f64> {
        Complex::from_polar(1.0, self.azimuth)
    }

    /// The angle by which the load leads the shaft, from −π/2 to 3π/2; none with the shaft at O.
    pub(super) fn lead(&self) -> f64 {
        let position = self.shaft.position;
        if position.norm() < 1e-9 {
            return f64::NAN;
        }
        let lead = (self.load() * position.conj()).arg();
        if lead < -FRAC_PI_2 { lead + TAU } else { lead }
    }
}

/// What the drum does of itself.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Drive {
    KeepsItsSpin,
    SpeedsUp,
    /// By a motor with so much torque at a standstill, N·m, that idles at the spin.
    WeakMotor(f64),
}

/// How the shaft moves through a part of the course, in a frame in which the load starts at azimuth zero.
enum Way {
    Steady(Transient),
    Ramp(Box<Ramp>),
    OnBoard(Box<RotorMotion>),
    /// With the damper that feels only the radius there is no closed form, nor with friction on board while the drum
    /// speeds up: states at equal steps.
    Stepped {
        rotor: Rotor,
        is_radial: bool,
        step: f64,
        states: Vec<[f64; 4]>,
    },
    /// By a weak motor: the numbers of a driven machine and the azimuth, at equal steps.
    DrivenMachine {
        driven: DrivenMachine,
        step: f64,
        states: Vec<[f64; 6]>,
    },
}

/// Rates of a driven machine's state and of the azimuth of its load (`eq:driven-shaft`, `eq:driven-spin`).
fn driven_rates(driven: &DrivenMachine, state: &[f64; 6]) -> [f64; 6] {
    let &[x, y, of_x, of_y, spin, _] = state;
    let [x, y, of_x, of_y, of_spin] = driven.rates(0.0, &[x, y, of_x, of_y, spin]);
    [x, y, of_x, of_y, of_spin, spin]
}

/// A part of the course: from a time on, with the drum at an azimuth, a spin (by a weak motor, more than it reaches)
/// and an angular acceleration.
struct Part {
    from: f64,
    azimuth: f64,
    spin: f64,
    acceleration: f64,
    way: Way,
}

/// Rates of a shaft with friction on board while the drum speeds up (`eq:ramp-equation`, `eq:whirl-motion`); if its
/// damper feels only the radius, with that in the place of the other.
fn stepped_rates(rotor: &Rotor, is_radial: bool, acceleration: f64, time: f64, state: &[f64; 4]) -> [f64; 4] {
    let machine = rotor.machine();
    let mut rates = machine.ramp_rates(acceleration)(time, state);
    if is_radial {
        let (radial, whole) =
            (machine.radial_damping_rates(time, state), machine.cartesian_rates(time, state));
        rates[2] += radial[2] - whole[2];
        rates[3] += radial[3] - whole[3];
    }
    let ([x, y, of_x, of_y], spin) = (*state, machine.spin() + acceleration * time);
    rates[2] -= rotor.damping_rate_on_board() * (of_x + spin * y);
    rates[3] -= rotor.damping_rate_on_board() * (of_y - spin * x);
    rates
}

/// A shaft as it is seen by who has turned by the angle of a complex number of length one.
fn turned(shaft: &Shaft, by: Complex<f64>) -> Shaft {
    Shaft { position: shaft.position * by, velocity: shaft.velocity * by }
}

impl Part {
    fn new(
        rotor: Rotor,
        is_radial: bool,
        before: &State,
        acceleration: f64,
        span: [f64; 2],
    ) -> Result<Self, Cause> {
        let State { azimuth, spin, .. } = *before;
        let rotor = rotor.with_spin(spin)?;
        let (machine, on_board) = (rotor.machine(), rotor.damping_rate_on_board() > 0.0);
        let start = turned(&before.shaft, before.load().conj());
        let way = if is_radial || (on_board && acceleration > 0.0) {
            let length = span[1] - span[0];
            let fastest = (spin + acceleration * length).max(machine.natural_frequency());
            let steps = (length * fastest / 0.1).ceil().max(1.0);
            let times: Vec<f64> = linear_steps(0.0, length, steps as u32).collect();
            let rates = |t: f64, state: &[f64; 4]| stepped_rates(&rotor, is_radial, acceleration, t, state);
            let solver = Dop853::with_tolerances(1e-8, 1e-9)?;
            let (states, _) = solver.sample(rates, 0.0, start.to_array(), &times)?;
            Way::Stepped { rotor, is_radial, step: length / steps, states }
        } else if on_board {
            Way::OnBoard(Box::new(rotor.transient(start)?))
        } else if acceleration == 0.0 {
            Way::Steady(machine.transient(start)?)
        } else {
            Way::Ramp(Box::new(machine.ramp(acceleration, start)?))
        };
        Ok(Self { from: span[0], azimuth, spin, acceleration, way })
    }

    /// The part of a course in which a weak motor turns the drum.
    fn driven(driven: DrivenMachine, before: &State, span: [f64; 2]) -> Result<Self, Cause> {
        let length = span[1] - span[0];
        let fastest = driven.motor().idle_spin.max(1.0) + 10.0;
        let steps = (length * fastest / 0.1).ceil().max(1.0);
        let times: Vec<f64> = linear_steps(0.0, length, steps as u32).collect();
        let Shaft { position, velocity } = turned(&before.shaft, before.load().conj());
        let [x, y, of_x, of_y, spin] = DrivenState { position, velocity, spin: before.spin }.to_array();
        let start = [x, y, of_x, of_y, spin, before.azimuth];
        let solver = Dop853::with_tolerances(1e-11, 1e-12)?;
        let (states, _) =
            solver.sample(|_, state: &[f64; 6]| driven_rates(&driven, state), 0.0, start, &times)?;
        let way = Way::DrivenMachine { driven, step: length / steps, states };
        Ok(Self { from: span[0], azimuth: before.azimuth, spin: fastest, acceleration: 0.0, way })
    }

    fn at(&self, time: f64) -> Result<State, Cause> {
        let since = time - self.from;
        let shaft = match &self.way {
            Way::DrivenMachine { driven, step, states } => {
                let index = ((since / step) as usize).min(states.len() - 1);
                let mut rates = |_: f64, state: &[f64; 6]| driven_rates(driven, state);
                let begun = *step * index as f64;
                let [x, y, of_x, of_y, spin, azimuth] =
                    rk4_step(&mut rates, begun, &states[index], since - begun);
                let DrivenState { position, velocity, spin } =
                    DrivenState::from_array([x, y, of_x, of_y, spin]);
                let shaft = turned(&Shaft { position, velocity }, Complex::from_polar(1.0, azimuth));
                return Ok(State { shaft, azimuth, spin });
            }
            Way::Steady(motion) => motion.at(since)?,
            Way::Ramp(motion) => motion.at(since)?,
            Way::OnBoard(motion) => motion.at(since)?,
            Way::Stepped { rotor, is_radial, step, states } => {
                let index = ((since / step) as usize).min(states.len() - 1);
                let begun = *step * index as f64;
                let mut rates =
                    |t: f64, state: &[f64; 4]| stepped_rates(rotor, *is_radial, self.acceleration, t, state);
                Shaft::from_array(rk4_step(&mut rates, begun, &states[index], since - begun))
            }
        };
        let shaft = turned(&shaft, Complex::from_polar(1.0, self.azimuth));
        let azimuth = self.azimuth + (self.spin + 0.5 * self.acceleration * since) * since;
        Ok(State { shaft, azimuth, spin: self.spin + self.acceleration * since })
    }
}

/// When the machine is kicked, s, and by how much that changes the velocity of its shaft, m/s.
pub(super) type Kick = (f64, Complex<f64>);

/// The motion from its beginning to its end, and what comes of it.
pub(super) struct Course {
    pub machine: Machine,
    /// The same with its friction on board.
    pub rotor: Rotor,
    /// The same machine while its drum does not turn.
    pub still: Machine,
    pub is_radial: bool,
    /// Whether it begins at rest and is turned faster.
    pub speeds_up: bool,
    /// With its motor, if that is a weak one.
    pub driven: Option<DrivenMachine>,
    /// The times of the kicks, s, in their order, each with the change of the shaft's velocity, m/s.
    pub kicks: Vec<Kick>,
    /// The azimuth of the load at the beginning.
    pub phase: f64,
    /// When it ends, s, and whether it does because the tub strikes its housing.
    pub end: f64,
    pub strikes: bool,
    /// Times, and how far the shaft is from O, m; the time and size of the largest distance.
    pub swings: Vec<(f64, f64)>,
    pub widest: (f64, f64),
    parts: Vec<Part>,
    /// Times, and what the floor has been given until then, N·s.
    given: Vec<(f64, Complex<f64>)>,
}

impl Course {
    /// From rest if the drum has to speed up or there is no steady motion in the housing, from the steady motion
    /// otherwise.
    pub(super) fn new(
        still: Machine,
        on_board: f64,
        spin: f64,
        is_radial: bool,
        drive: Drive,
        (phase, kicks): (f64, Vec<Kick>),
    ) -> Result<Self, Cause> {
        let machine = still.with_spin(spin)?;
        let (run_up, end, driven) = match drive {
            Drive::KeepsItsSpin => (0.0, LASTS, None),
            Drive::SpeedsUp => (spin / ACCELERATION, spin / ACCELERATION + LASTS, None),
            Drive::WeakMotor(_) if is_radial || on_board > 0.0 => {
                return Err("With a weak motor the scene knows dampers on the floor alone, which feel the whole velocity.".into());
            }
            Drive::WeakMotor(_) if spin == 0.0 => {
                return Err(
                    "The spin is that at which the weak motor idles: at 0 rad/s it turns nothing.".into()
                );
            }
            Drive::WeakMotor(stall_torque) => {
                let motor = Motor { stall_torque, idle_spin: spin, drum_inertia: DRUM_INERTIA };
                (0.0, WEAK_LASTS, Some(still.driven(motor)?))
            }
        };
        let mut course = Self {
            machine,
            rotor: machine.rotor(on_board)?,
            still,
            is_radial,
            speeds_up: run_up > 0.0 || driven.is_some(),
            driven,
            kicks: kicks.into_iter().filter(|(time, _)| *time < end).collect(),
            phase,
            end,
            strikes: false,
            swings: Vec::new(),
            widest: (0.0, 0.0),
            parts: Vec::new(),
            given: Vec::new(),
        };
        course.move_on(run_up)?;
        course.keep_book()?;
        Ok(course)
    }

    fn move_on(&mut self, run_up: f64) -> Result<(), Cause> {
        let (machine, kicks) = (self.machine, self.kicks.clone());
        let largest = (LARGEST_SWING - 1.0) * machine.offset();
        let mut now = State { shaft: Shaft::AT_REST, azimuth: self.phase, spin: 0.0 };
        if let Some(steady) =
            steady(&machine, self.is_radial).filter(|steady| !self.speeds_up && steady.radius() < largest)
        {
            let position = steady.amplitude() * now.load();
            now.shaft = Shaft { position, velocity: Complex::new(0.0, machine.spin()) * position };
        }
        let mut cuts: Vec<f64> = [0.0, run_up].into_iter().chain(kicks.iter().map(|kick| kick.0)).collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        cuts.push(self.end);
        for span in cuts.windows(2) {
            let from = span[0];
            if let Some(part) = self.parts.last() {
                now = part.at(from)?;
            }
            now.shaft.velocity +=
                kicks.iter().filter(|kick| kick.0 == from).map(|kick| kick.1).sum::<Complex<_>>();
            if let Some(driven) = self.driven {
                self.parts.push(Part::driven(driven, &now, [from, span[1]])?);
                continue;
            }
            if from == run_up {
                now.spin = machine.spin();
            }
            let acceleration = if from < run_up { ACCELERATION } else { 0.0 };
            self.parts.push(Part::new(self.rotor, self.is_radial, &now, acceleration, [from, span[1]])?);
        }
        Ok(())
    }

    /// Writes down how far the shaft swings and what the floor is given, until the tub strikes its housing.
    fn keep_book(&mut self) -> Result<(), Cause> {
        let mut given = Complex::new(0.0, 0.0);
        for (index, part) in self.parts.iter().enumerate() {
            let until = self.parts.get(index + 1).map_or(self.end, |next| next.from);
            let mut from = part.from;
            while from < until {
                // Two radians of drum and spring together: there Gauss's rule has eleven digits.
                let spin = part.spin + part.acceleration * (from - part.from);
                let mut to = until.min(from + 2.0 / (spin + self.machine.natural_frequency()));
                if self.is_radial {
                    // The force turns with the radius, and quickly as the shaft passes O.
                    let Shaft { position, velocity } = part.at(from)?.shaft;
                    to = to.min(from + (1.5 * position.norm() / velocity.norm().max(1e-9)).max(2e-3));
                }
                self.given.push((from, given));
                for (place, weight) in GAUSS {
                    let time = from + place * (to - from);
                    let state = part.at(time)?;
                    let distance = state.shaft.position.norm();
                    if distance > LARGEST_SWING * self.machine.offset() {
                        (self.end, self.strikes) = (time, true);
                        return Ok(());
                    }
                    // A swing that only comes nearer to its last size has no largest one but by rounding.
                    if distance > self.widest.1 * (1.0 + 1e-6) {
                        self.widest = (time, distance);
                    }
                    self.swings.push((time, distance));
                    given += self.force(&state) * (weight * (to - from));
                }
                from = to;
            }
        }
        Ok(())
    }

    pub(super) fn at(&self, time: f64) -> Result<State, Cause> {
        let part = self.parts.iter().rev().find(|part| part.from <= time).unwrap_or(&self.parts[0]);
        part.at(time.min(self.end))
    }

    /// Whether the machine has been kicked by a time.
    pub(super) fn is_kicked(&self, time: f64) -> bool {
        self.kicks.first().is_some_and(|kick| kick.0 <= time)
    }

    /// The force of springs and dampers on the floor, N: minus what they do to a drum that does not turn, and what the
    /// dampers on board give to what turns them.
    pub(super) fn force(&self, state: &State) -> Complex<f64> {
        let shaft = &state.shaft;
        let rates = if self.is_radial { Machine::radial_damping_rates } else { Machine::cartesian_rates };
        let [_, _, x, y] = rates(&self.still, 0.0, &shaft.to_array());
        let seen_on_board = shaft.velocity - shaft.position * Complex::new(0.0, state.spin);
        (seen_on_board * self.rotor.damping_rate_on_board() - Complex::new(x, y)) * self.machine.total_mass()
    }

    /// What has been gained in momentum, less what floor and kick gave, by a time, N·s: rounding.
    pub(super) fn imbalance(&self, time: f64) -> Result<f64, Cause> {
        let index = self.given.partition_point(|(from, _)| *from <= time).saturating_sub(1);
        let (from, mut left) = self.given[index];
        for (place, weight) in GAUSS {
            left += self.force(&self.at(from + place * (time - from))?) * (weight * (time - from));
        }
        left += self.momentum(&self.at(time)?) - self.momentum(&self.at(0.0)?);
        let kicks = self.kicks.iter().filter(|kick| (f64::MIN_POSITIVE..=time).contains(&kick.0));
        left -= kicks.map(|kick| kick.1).sum::<Complex<_>>() * self.machine.total_mass();
        Ok(left.norm())
    }

    /// The momentum of tub, drum and load, N·s: that of their mass at its centre.
    fn momentum(&self, state: &State) -> Complex<f64> {
        let turning = Complex::new(0.0, state.spin * self.machine.offset()) * state.load();
        (state.shaft.velocity + turning) * self.machine.total_mass()
    }
}

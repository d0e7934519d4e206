//! The whole motion of a top from a start: its axis, its azimuth and its own turn.
//!
//! With Euler's angles θ from upright, φ about the vertical and ψ about the axis (z-x-z) the quaternion of the attitude is
//! two complex numbers, `cos ½θ e^{i(φ+ψ)/2}` and `sin ½θ e^{i(φ−ψ)/2}`. They and `ω₁ + iω₂` are each a quotient of theta
//! functions that turns at a constant rate besides (`eq:top-thetas`). No pole of Euler's angles is left in them.

use super::roots::{Roots, Start};
use super::theta::{Sides, Thetas, Values};
use super::{Top, Track};
use crate::clock::Clock;
use crate::elementary::sin_cos_quarters;
use crate::elliptic::{carlson_rf, carlson_rf_in_two_parts, complete_integral, quarter_period};
use crate::euler::Turning;
use crate::lanes::{Branchless, sample_branchless};
use crate::quantity::InvalidQuantity;
use crate::two_part::TwoPart;
use nalgebra::{Complex, Quaternion, UnitQuaternion, Vector3, Vector4};
use std::f64::consts::{FRAC_PI_2, TAU};

/// A quarter of a nod in the other measure of the theta functions of the fast side.
const HALF: f64 = 0.5;
/// Later than any start on the separatrix, in the unit of its argument.
const FOR_EVER: f64 = 1e6;
/// A tilt or a rate across the axis whose square is below this, beside one, is none.
const NONE: f64 = 1e-60;
/// A momentum about the vertical at the top of a nod that is below this, beside its size, makes a cusp.
const CUSP: f64 = 1e-14;

/// The motion of a top, in closed form at any time; made by [`Top::motion`] and [`Top::let_go`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopMotion {
    top: Top,
    start: Turning,
    constants: Constants,
    sides: Sides,
    numbers: Numbers,
}

/// What a state is made of beside the theta functions.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Constants {
    argument: Clock,
    first_argument: TwoPart,
    turns: [Clock; 3],
    senses: [f64; 3],
    amplitudes: [[f64; 2]; 3], // complex
    spin: f64,                 // ω₃, rad/s
}

/// What is said of the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Numbers {
    tilts: [f64; 2],
    nod: Option<f64>,
    turns_a_nod: Option<[f64; 2]>, // of the azimuth and of the own turn, rad
    track: Track,
    phases: [TwoPart; 2], // of α and β at time zero, less the sense times v
    rates: [TwoPart; 2],  // rad/s
    clock: TwoPart,       // dv/dt
    first: TwoPart,       // v at time zero
}

/// The motion with the theta functions of one side.
#[derive(Debug, Clone, Copy)]
struct OneSide<P> {
    constants: Constants,
    thetas: P,
}

/// Azimuth and own turn of a top, which go on counting from turn to turn, and its tilt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopAngles {
    /// θ from upright, rad, from 0 to π.
    pub tilt: f64,
    /// φ about the vertical, rad: of the line of nodes. The axis leans to where a quarter turn less points.
    pub azimuth: f64,
    /// ψ about the axis, rad.
    pub own_turn: f64,
}

fn number(value: f64) -> TwoPart {
    TwoPart::from(value)
}

fn power_of_two(size: f64) -> f64 {
    2_f64.powi(size.log2().floor() as i32)
}

/// The sense of a residue.
fn sense(residue: TwoPart) -> f64 {
    if residue.rounded() < 0.0 { -1.0 } else { 1.0 }
}

/// A rate of two thirds of the numbers, `½N/X` in the mean less the winding of the theta function, which is `sπ` a nod:
/// over κ/K, in units of half an angle (`eq:top-rates`).
struct Third {
    residue: TwoPart,
    near: [TwoPart; 2], // X₁, X₂
    span: TwoPart,      // X₁ − X₂
    far: TwoPart,       // p H
    gain: TwoPart,      // X₁ times this is 1 − p
}

impl TopMotion {
    pub(super) fn new(top: &Top, turning: &Turning) -> Self {
        let spin = turning.omega_body.z;
        let a = top.momentum_by_moment(spin);
        let beta = top.beta();
        let sizes = [turning.omega_body.xy().amax(), a.rounded().abs(), beta.rounded().sqrt()];
        let size = sizes.into_iter().fold(0.0, f64::max);
        let unit = if size > 0.0 { power_of_two(size) } else { 1.0 };
        let over = unit.recip();
        let scaled = Turning {
            world_from_body: turning.world_from_body,
            omega_body: turning.omega_body.map(|rate| rate * over),
        };
        let (a, beta) = (a * over, beta * over * over);
        let spin_less_a = top.spin_less_momentum(spin) * over; // ω₃ − a
        let mut start = Start::new(&scaled, a, beta);
        let mut values = cayley_klein(&scaled);
        if start.below.rounded() < NONE && start.across.rounded() < NONE {
            let none = number(0.0);
            start =
                Start { above: number(2.0), below: none, across: none, rise: none, momentum: none, ..start };
            values[1] = Complex::default();
            values[2] = Complex::default();
        }
        if start.above.rounded() < NONE && start.across.rounded() < NONE {
            let none = number(0.0);
            start =
                Start { above: none, below: number(2.0), across: none, rise: none, momentum: none, ..start };
            values[0] = Complex::default();
            values[2] = Complex::default();
        }
        // What turns all three besides.
        let bases = [spin_less_a * HALF, -(spin_less_a * HALF), a * HALF - spin_less_a - a];
        let about = |angle: TwoPart| angle * unit;
        if start.is_steady() {
            return Self::steady(top, turning, &start, values, bases, unit);
        }
        let roots = start.roots();
        if roots.nod.rounded() <= 0.0 || !roots.whole.rounded().is_finite() {
            return Self::steady(top, turning, &start, values, bases, unit);
        }

        let one = number(1.0);
        let whole = roots.whole;
        let complement = roots.gap / whole; // k'²
        let complement = if complement.rounded() > 0.0 { complement } else { number(0.0) };
        let square = beta * roots.nod / whole; // k²
        let parameter = square.rounded().clamp(0.0, 1.0);
        let root = complement.sqrt();
        let quarter = (complement.rounded() > 0.0).then(|| complete_integral(root, one, one, one));
        let kappa = whole.sqrt() * HALF;

        let thirds = [
            Third {
                residue: roots.residues[1],
                near: roots.below,
                span: roots.nod,
                far: roots.below_third,
                gain: beta / whole,
            },
            Third {
                residue: roots.residues[2],
                near: roots.across,
                span: beta * roots.nod,
                far: roots.across_third,
                gain: one / whole,
            },
        ];
        let senses = roots.residues.map(sense);
        let zeros =
            [lowest_zero(&roots), thirds[0].zero(whole, complement), thirds[1].zero(whole, complement)];
        let quarters = [quarter.map_or(f64::INFINITY, TwoPart::rounded), quarter_period(parameter)];
        let sides = Sides::new(parameter, quarters, zeros);
        let (per, quarter_nod) = match (&sides, quarter) {
            (Sides::Slow(_), Some(quarter)) => (quarter, 1.0),
            (Sides::Fast(_), Some(quarter)) => (quarter * 2.0, HALF),
            (_, None) => (one, FOR_EVER),
        };

        // Mean rates less the windings.
        let p = roots.above_third / whole;
        let lowest = beta / whole * roots.residues[0];
        let elliptic = [
            quarter.map_or(lowest / p, |quarter| {
                lowest * complete_integral(root, p, number(0.0), one) / quarter
            }),
            quarter.map_or(number(0.0), |quarter| thirds[0].rate(root, whole, quarter, kappa)),
            quarter.map_or(number(0.0), |quarter| thirds[1].rate(root, whole, quarter, kappa)),
        ];
        let rates: [TwoPart; 3] = std::array::from_fn(|n| bases[n] + elliptic[n] * HALF);

        let (first, edge) = start_argument(&start, &roots, quarter);
        let argument_rate = kappa * unit;
        let mut constants = Constants {
            argument: Clock::from_quarters(argument_rate / per),
            first_argument: first / per,
            turns: rates.map(|rate| Clock::from_rate(about(rate))),
            senses,
            amplitudes: [[1.0, 0.0]; 3],
            spin,
        };
        // How large each is: α at the top of a nod, the others at its lowest point.
        let sizes = [
            (roots.above[1] * HALF).sqrt().rounded(),
            (roots.below[0] * HALF).sqrt().rounded(),
            roots.across[0].sqrt().rounded() * unit,
        ];
        let (at_start, [lowest, highest]) = match &sides {
            Sides::Slow(thetas) => (constants.at_first(thetas), ends(thetas, quarter_nod)),
            Sides::Fast(thetas) => (constants.at_first(thetas), ends(thetas, quarter_nod)),
        };
        let measured = [highest[0], lowest[1], lowest[2]];
        let directions = directions(values);
        for n in 0..3 {
            // Where a number is zero at the start, the direction is that of the theta function's slope; beside it the
            // distances from the zero have more digits than the argument.
            let slope = edge.beside_zero(n, senses[n] * zeros[n]);
            let direction = match slope {
                _ if values[n].norm() == 0.0 => directions[n],
                Some(slope) => directions[n] / slope,
                None => directions[n] / at_start[n],
            };
            let direction = direction / direction.norm();
            let size = sizes[n] / measured[n].norm();
            constants.amplitudes[n] = [direction.re * size, direction.im * size];
        }

        let v_rate = quarter.map_or(number(0.0), |quarter| TwoPart::PI * HALF * argument_rate / quarter);
        let v_first = quarter.map_or(number(0.0), |quarter| TwoPart::PI * HALF * first / quarter);
        let nod = quarter.map(|quarter| (quarter * 2.0 / argument_rate).rounded());
        let turns_a_nod = quarter.map(|quarter| {
            let nod = quarter * 2.0 / kappa;
            let [one, other] = [0, 1].map(|n| rates[n] * nod + TwoPart::PI * senses[n]);
            [(one + other).rounded(), (one - other).rounded()]
        });
        // The argument of ϑ₁ is never a quarter turn from v − π/2, that of ϑ₂ from v.
        let phase = |n: usize, less: f64| {
            let [re, im] = constants.amplitudes[n];
            let about = number(im.atan2(re)) - number(less * senses[n]);
            if values[n].norm() == 0.0 {
                return about;
            }
            let first = about + v_first * senses[n];
            let counted = first + number(beyond(values[n], first));
            about + TwoPart::PI * (2.0 * ((values[n].arg() - counted.rounded()) / TAU).round())
        };
        let tilt = |n: usize| 2.0 * roots.below[n].sqrt().rounded().atan2(roots.above[n].sqrt().rounded());
        let numbers = Numbers {
            tilts: [tilt(1), tilt(0)],
            nod,
            turns_a_nod,
            track: track(&roots, &start),
            phases: [phase(0, FRAC_PI_2), phase(1, 0.0)],
            rates: [about(rates[0]), about(rates[1])],
            clock: v_rate,
            first: v_first,
        };
        Self { top: *top, start: *turning, constants, sides, numbers }
    }

    /// A top whose tilt stays.
    fn steady(
        top: &Top,
        turning: &Turning,
        start: &Start,
        values: [Complex<f64>; 3],
        bases: [TwoPart; 3],
        unit: f64,
    ) -> Self {
        let residues = start.residues();
        let distances = [start.above, start.below, start.across];
        let rates: [TwoPart; 3] = std::array::from_fn(|n| {
            let own = distances[n].rounded() > 0.0;
            let more = if own { residues[n] / distances[n] * HALF } else { number(0.0) };
            (bases[n] + more) * unit
        });
        // The first theta function of `Sides::still` is i.
        let own = [values[0] * Complex::new(0.0, -1.0), values[1], values[2] * unit];
        let amplitudes = own.map(|value| [value.re, value.im]);
        let none = number(0.0);
        let [_, _, second] = start.cubic();
        let tilt = 2.0 * values[1].norm().atan2(values[0].norm());
        // A nod that is infinitely small.
        let nod = (second.rounded() < 0.0).then(|| TwoPart::PI * 2.0 / (-second).sqrt() / number(unit));
        let turns_a_nod =
            nod.map(|nod| [(rates[0] + rates[1]) * nod, (rates[0] - rates[1]) * nod].map(TwoPart::rounded));
        let [first, second, _] = values.map(Complex::arg);
        Self {
            top: *top,
            start: *turning,
            constants: Constants {
                argument: Clock::from_quarters(none),
                first_argument: none,
                turns: rates.map(Clock::from_rate),
                senses: [1.0; 3],
                amplitudes,
                spin: turning.omega_body.z,
            },
            sides: Sides::still(),
            numbers: Numbers {
                tilts: [tilt; 2],
                nod: nod.map(TwoPart::rounded),
                turns_a_nod,
                track: Track::Steady,
                phases: [number(first), number(second)],
                rates: [rates[0], rates[1]],
                clock: none,
                first: none,
            },
        }
    }

    /// Attitude and angular velocity at `time`, s: to 4e-15 rad, and 4e-15 of the largest of the rates and of `√(2mgl/I₁)`,
    /// wherever the axis points, until the body has turned by 1e15 rad. Then the 32 digits of the rates run out. Beside a
    /// top that comes to rest upright, where the nod hangs on a small difference, they run out at `1e17 k'²` rad if that
    /// is earlier. A tilt whose square is below 1e-60 counts as none.
    ///
    /// # Errors
    /// [`InvalidQuantity`] for a time that is not finite or larger than 1e50 s in size.
    pub fn at(&self, time: f64) -> Result<Turning, InvalidQuantity> {
        let time = InvalidQuantity::check_time(time)?;
        Ok(match &self.sides {
            Sides::Slow(thetas) => self.constants.state::<true>(thetas, time),
            Sides::Fast(thetas) => self.constants.state::<true>(thetas, time),
        })
    }

    /// Attitude and angular velocity at each of `times`, s, as [`TopMotion::at`], several at once.
    ///
    /// # Errors
    /// As [`TopMotion::at`], of the first time that is refused.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Turning>, InvalidQuantity> {
        let Self { constants, sides, .. } = *self;
        let reach = constants.turns.iter().map(Clock::reach).fold(constants.argument.reach(), f64::min);
        let (reach, blank) = ([-reach, reach], self.start);
        let at = |time: f64| self.at(time);
        match sides {
            Sides::Slow(thetas) => sample_branchless(OneSide { constants, thetas }, reach, times, blank, at),
            Sides::Fast(thetas) => sample_branchless(OneSide { constants, thetas }, reach, times, blank, at),
        }
    }

    /// Tilt, azimuth and own turn at `time`, s. Azimuth and own turn count on from turn to turn, and start between −π
    /// and π, or two turns beyond. Upright and hanging only their sum or their difference has a meaning.
    ///
    /// # Errors
    /// As [`TopMotion::at`].
    pub fn angles(&self, time: f64) -> Result<TopAngles, InvalidQuantity> {
        let state = self.at(time)?;
        let [first, second, _] = cayley_klein(&state);
        let Numbers { phases, rates, clock, first: start, .. } = &self.numbers;
        let v = (*clock * time) + *start;
        let turned = |n: usize, value: Complex<f64>| {
            if value.norm() == 0.0 {
                return number(0.0);
            }
            let about = rates[n] * time + phases[n] + v * self.constants.senses[n];
            about + number(beyond(value, about))
        };
        let [one, other] = [turned(0, first), turned(1, second)];
        Ok(TopAngles {
            tilt: 2.0 * second.norm().atan2(first.norm()),
            azimuth: (one + other).rounded(),
            own_turn: (one - other).rounded(),
        })
    }

    /// The top that moves.
    #[must_use]
    pub fn top(&self) -> &Top {
        &self.top
    }

    /// Attitude and angular velocity at time zero.
    #[must_use]
    pub fn start(&self) -> Turning {
        self.start
    }

    /// The least and the greatest tilt, rad, each with a relative error below 1e-15 (`eq:top-cubic`); the worst that a
    /// search found is 3e-16. How near to the vertical a top comes hangs on small differences: `b − a`; how far its
    /// energy is from that of rest upright, and how far that is from `½I₁ a(b − a)`; and how far its spin is from the one
    /// that it needs to sleep. Where one of them vanishes to 15 digits or more, it has as many digits fewer than 32 itself,
    /// and the tilt no more than that.
    #[must_use]
    pub fn tilts(&self) -> [f64; 2] {
        self.numbers.tilts
    }

    /// How long a nod takes, from one greatest tilt to the next, s: `2K/κ` (`eq:top-nod`), with a relative error below
    /// 4e-16; the worst that a search found is 1.2e-16. Beside a top that stands upright with just the spin that it needs
    /// to sleep, the nod hangs on small differences and keeps the digits of those, as [`TopMotion::tilts`]. In steady
    /// precession that of a nod which is infinitely small. `None` where the top comes to rest upright after an infinite time,
    /// or stands there where it cannot stay.
    #[must_use]
    pub fn nod_period(&self) -> Option<f64> {
        self.numbers.nod
    }

    /// By how much the axis has gone round the vertical after a nod, rad, positive counter-clockwise from above
    /// (`eq:top-swing`). A plumb pass below or above the point counts as a half turn, of the sign of `b + a` and `b − a`,
    /// positive where that is zero. `None` as [`TopMotion::nod_period`].
    #[must_use]
    pub fn swing_per_nod(&self) -> Option<f64> {
        self.numbers.turns_a_nod.map(|[swing, _]| swing)
    }

    /// By how much the body has turned about its axis after a nod, relative to the line of nodes, rad.
    #[must_use]
    pub fn own_turn_per_nod(&self) -> Option<f64> {
        self.numbers.turns_a_nod.map(|[_, turn]| turn)
    }

    /// The potential energy of the tilt alone at a tilt, rad: the weight's and that of the turning which the two kept
    /// momenta ask for there, J (`eq:top-well`). The tilt moves in it like a marble in a well. Infinite upright and
    /// hanging, unless the momenta allow them.
    #[must_use]
    pub fn well(&self, tilt: f64) -> f64 {
        let [sum, difference] = self.momenta();
        let (sin, cos) = (0.5 * tilt).sin_cos();
        // eq:top-well, where b − au = ½(b + a)(1 − u) + ½(b − a)(1 + u).
        let part =
            |momentum: f64, up: f64, down: f64| if momentum == 0.0 { 0.0 } else { momentum * up / down };
        let around = 0.5 * (part(sum, sin, cos) + part(difference, cos, sin));
        let moment = self.top.parameters().transverse;
        0.5 * moment * around * around + self.top.weight_torque() * (cos * cos - sin * sin)
    }

    /// The energy of the tilt in its well, J: constant.
    #[must_use]
    pub fn well_energy(&self) -> f64 {
        let across = self.start.omega_body.xy().norm_squared();
        let height = self.start.axis_3_world().z;
        0.5 * self.top.parameters().transverse * across + self.top.weight_torque() * height
    }

    /// `b + a` and `b − a`, rad/s.
    fn momenta(&self) -> [f64; 2] {
        let moments = self.top.moments();
        let own = moments.angular_momentum(&self.start.omega_body).z;
        let upright = (self.start.angular_momentum_world(&moments)).z;
        [upright + own, upright - own].map(|momentum| momentum / self.top.parameters().transverse)
    }

    /// What the tip draws.
    #[must_use]
    pub fn track(&self) -> Track {
        self.numbers.track
    }
}

impl<P: Thetas> Branchless for OneSide<P> {
    type State = Turning;

    #[inline(always)]
    fn state<const ONE: bool>(&self, time: f64) -> Turning {
        self.constants.state::<ONE>(&self.thetas, time)
    }
}

impl Constants {
    #[inline(always)]
    fn state<const ONE: bool>(&self, thetas: &impl Thetas, time: f64) -> Turning {
        let (high, low) = self.argument.at(time);
        let (first, first_low) = self.first_argument.parts();
        let (argument, argument_low) = (TwoPart::sum(high, first) + (low + first_low)).parts();
        let Values { thetas: values, flip, rest } = thetas.at::<ONE>(argument, argument_low);
        let drift = thetas.drift();
        let turned = |value: f64| f64::from_bits(value.to_bits() ^ flip);
        let number = |n: usize| {
            let (high, low) = self.turns[n].at(time);
            let (turn, turn_low) = (TwoPart::sum(high, self.senses[n] * drift[n] * rest) + low).parts();
            let (sin, cos) = sin_cos_quarters::<ONE>(turn, turn_low);
            let [[re, im], [x, y]] = [values[n], self.amplitudes[n]];
            let (re, im) = (turned(re), turned(self.senses[n] * im));
            let (re, im) = (re * cos - im * sin, re * sin + im * cos);
            [re * x - im * y, re * y + im * x]
        };
        let [[w, k], [i, j], [w1, w2]] = [number(0), number(1), number(2)]; // eq:top-thetas
        let q = Vector4::new(i, j, k, w);
        Turning {
            world_from_body: UnitQuaternion::new_unchecked(Quaternion::from(q * q.norm().recip())),
            omega_body: Vector3::new(w1, w2, self.spin),
        }
    }

    /// The theta functions with their drift at time zero.
    fn at_first(&self, thetas: &impl Thetas) -> [Complex<f64>; 3] {
        let (high, low) = self.first_argument.parts();
        let Values { thetas: values, flip, rest } = thetas.at::<true>(high, low);
        let drift = thetas.drift();
        std::array::from_fn(|n| {
            let [re, im] = values[n];
            let turn = Complex::from_polar(1.0, self.senses[n] * drift[n] * rest * FRAC_PI_2);
            let value = Complex::new(re, self.senses[n] * im) * turn;
            if flip == 0 { value } else { -value }
        })
    }
}

/// By how much the argument of a number is beyond an angle, rad, from −π to π.
fn beyond(value: Complex<f64>, angle: TwoPart) -> f64 {
    let (sin, cos) = angle.sin_cos();
    (value * Complex::new(cos, -sin)).arg()
}

/// The theta functions at the lowest and at the highest point.
fn ends(thetas: &impl Thetas, quarter_nod: f64) -> [[Complex<f64>; 3]; 2] {
    [0.0, quarter_nod]
        .map(|argument| thetas.at::<true>(argument, 0.0).thetas.map(|[re, im]| Complex::new(re, im)))
}

/// `cos ½θ e^{i(φ+ψ)/2}`, `sin ½θ e^{i(φ−ψ)/2}` and `ω₁ + iω₂`.
fn cayley_klein(turning: &Turning) -> [Complex<f64>; 3] {
    let (q, omega) = (turning.world_from_body, turning.omega_body);
    [Complex::new(q.w, q.k), Complex::new(q.i, q.j), Complex::new(omega.x, omega.y)]
}

/// The directions of the three; of one that is zero that of its rate, as far as it makes the theta function grow: α
/// comes up through zero, the others go down through it at the top.
fn directions([alpha, beta, omega]: [Complex<f64>; 3]) -> [Complex<f64>; 3] {
    let zero = |value: &Complex<f64>| value.norm() == 0.0;
    // eq:cayley-klein-rates, and eq:euler-rates with the weight.
    let first = if zero(&alpha) { -beta * omega.conj() } else { alpha };
    let second = if zero(&beta) { -alpha * omega } else { beta };
    let third = if zero(&omega) { -alpha.conj() * beta } else { omega };
    [first, second, third]
}

/// `y₁` with `sc²(y₁, k') = (1 + u₁)/(u₂ − u₁)`.
fn lowest_zero(roots: &Roots) -> f64 {
    let nod = roots.nod;
    let [first, second] = roots.above;
    let p = roots.above_third / roots.whole;
    first.sqrt().rounded() * carlson_rf(nod.rounded(), (nod * p).rounded(), second.rounded())
}

/// How far the start is from an end of the nod, in the measure of u.
#[derive(Debug, Clone, Copy)]
enum Edge {
    /// From the lowest point, negative while it falls.
    Bottom(f64),
    /// From the highest, and whether it falls from there.
    Top(f64, bool),
}

impl Edge {
    /// The theta function of a number, with its zero iy away, if the start is so near that only the distance counts.
    fn beside_zero(self, n: usize, y: f64) -> Option<Complex<f64>> {
        let distance = match (self, n) {
            (Self::Bottom(distance), 0) => Complex::new(distance, -y),
            (Self::Top(distance, false), 1 | 2) => Complex::new(distance, y),
            (Self::Top(distance, true), 1 | 2) => Complex::new(distance, -y),
            _ => return None,
        };
        (distance.norm() < SMALL).then_some(distance)
    }
}

/// The square of a distance below this is lost beside one.
const SMALL: f64 = 1e-9;

/// The argument u of the start: from the lowest point, or by how far it is from the highest, whichever is nearer.
fn start_argument(start: &Start, roots: &Roots, quarter: Option<TwoPart>) -> (TwoPart, Edge) {
    let one = number(1.0);
    let [down, up] = roots.under;
    let falls = start.rise.rounded() < 0.0;
    let speed = if falls { -start.rise } else { start.rise };
    let dn_square = roots.over / roots.whole;
    let [sn_square, cn_square] = [down, up].map(|distance| distance / roots.nod);
    // The nearer of the two is what the speed leaves of the product: u̇² = β(u − u₁)(u₂ − u)(u₃ − u).
    let near = |other: TwoPart| speed / (other * roots.over * roots.nod).sqrt();
    let (argument, edge) = match quarter {
        Some(quarter) if down.rounded() > up.rounded() => {
            // Of K − u the sine is cn/dn, the cosine k' sn/dn and the third k'/dn.
            let sine = near(down) / dn_square.sqrt();
            let third = roots.gap / roots.whole / dn_square;
            let left = sine * carlson_rf_in_two_parts([sn_square * third, third, one]);
            (quarter - left, Edge::Top(left.rounded(), falls))
        }
        None if down.rounded() > up.rounded() => {
            let cn = near(down);
            let argument = sn_square.sqrt() * carlson_rf_in_two_parts([cn * cn, cn * cn, one]);
            (argument, Edge::Bottom(f64::INFINITY))
        }
        _ => {
            let argument = near(up) * carlson_rf_in_two_parts([cn_square, dn_square, one]);
            (argument, Edge::Bottom(if falls { -argument.rounded() } else { argument.rounded() }))
        }
    };
    (if falls { -argument } else { argument }, edge)
}

impl Third {
    /// y with `dn²(y, k') = (X₁ − X₂)/X₁`.
    fn zero(&self, whole: TwoPart, complement: TwoPart) -> f64 {
        let [first, second] = self.near;
        if complement.rounded() == 0.0 || second.rounded() <= 0.0 {
            return 0.0;
        }
        let p = self.far / whole;
        let squares = [self.span * p, self.span * complement, first * complement];
        let [x, y, z] = squares.map(|square| square.rounded().max(0.0));
        second.sqrt().rounded() * carlson_rf(x, y, z)
    }

    /// `⟨N/X⟩` less the winding, over 1 (to be halved).
    fn rate(&self, root: TwoPart, whole: TwoPart, quarter: TwoPart, kappa: TwoPart) -> TwoPart {
        let (none, one) = (number(0.0), number(1.0));
        let p = self.far / whole;
        let rest = self.near[1] / self.near[0]; // 1 − n
        if p.rounded() >= rest.rounded() {
            -(self.residue * self.gain * complete_integral(root, p, none, one) / quarter)
        } else {
            let mean = self.residue / self.near[0] * complete_integral(root, rest, one, one) / quarter;
            mean - TwoPart::PI * kappa / quarter * sense(self.residue)
        }
    }
}

/// What the tip draws, from the sense of the precession at the lowest and at the highest point. An axis that passes the
/// vertical itself goes on across it.
fn track(roots: &Roots, start: &Start) -> Track {
    let [low, high] = roots.momentum.map(TwoPart::rounded);
    let size = start.momentum.rounded().abs().max((start.a * roots.nod).rounded().abs());
    let [most, least] = roots.across.map(TwoPart::rounded);
    let is_vertical = roots.below[1].rounded() == 0.0 || roots.above[0].rounded() == 0.0;
    if high.abs() <= CUSP * size && least <= CUSP * most {
        Track::Cusps
    } else if low * high < 0.0 && !is_vertical {
        Track::Loops
    } else {
        Track::Waves
    }
}

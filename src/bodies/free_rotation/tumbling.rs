//! A free body with three different moments: Jacobi's functions for the angular velocity, a theta function for the
//! attitude.
//!
//! The page "The attitude of any free body" of the chapter "The pinned hoop" derives it. As there, axes 1, 2, 3 are
//! the body's own, renamed: 2 has the middle moment, 3 is the one that ω circles, and at the start `ω₁ ≥ 0` and
//! `ω₃ > 0`. C. G. J. Jacobi, *Journal für die reine und angewandte Mathematik* **39** (1850) 293; R. van Zon & J.
//! Schofield, *Journal of Computational Physics* **225** (2007) 145.
//!
//! A state follows from two phases that grow at a constant rate: the argument u, which gives sn, cn, dn and the
//! direction of `eq:beyond-steady`, and half the steady angle about **L**. Of the angle beyond the steady one the half
//! is found without the angle: a complex number Z has the direction of the square of `|Z| + Z`.

use super::theta::{Polynomials, Theta, Values};
use crate::clock::Clock;
use crate::elementary::sin_cos_quarters;
use crate::elliptic::{carlson_rf, carlson_rf_in_two_parts, complete_integral, quarter_period};
use crate::euler::Turning;
use crate::inertia::PrincipalMoments;
use crate::lanes::{Branchless, sample_branchless};
use crate::quantity::InvalidQuantity;
use crate::two_part::TwoPart;
use nalgebra::{Matrix3, Matrix4, Quaternion, Rotation3, UnitQuaternion, Vector3, Vector4};

/// The motion of a body with three different moments, about which no two components of ω vanish.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tumbling {
    constants: Constants,
    theta: Theta,
    period: Option<f64>,
}

/// What a state is made of beside the theta functions.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Constants {
    argument: Clock, // u as the theta functions count it
    first_argument: TwoPart,
    half_turn: Clock,           // half the steady angle (Λ − σ)t about L
    sense: f64,                 // s
    ratio: f64,                 // |I₂W₂/I₁W₁| = √(1 + n)
    amplitudes: Vector3<f64>,   // W₁, W₂, W₃, rad/s
    moments_by_l: Vector3<f64>, // I₁/L, I₂/L, I₃/L, s
    /// Takes the quaternion of the renamed axes in upright ones, scalar last, to the attitude's.
    attitude: Matrix4<f64>,
    /// A permutation with signs, which is exact.
    body_from_renamed: Matrix3<f64>,
}

/// The motion with the theta functions of one side.
#[derive(Debug, Clone, Copy)]
struct OneSide<P> {
    constants: Constants,
    theta: P,
}

impl Tumbling {
    /// The motion from a start whose numbers have been checked; `None` if the rotation is steady. No two moments may
    /// be equal.
    ///
    /// All constants come from exact differences, and those that time multiplies keep 30 digits: what is rounded in
    /// them is late for ever.
    pub(super) fn new(moments: PrincipalMoments, start: &Turning) -> Option<Self> {
        if start.omega_body.iter().filter(|&&component| component != 0.0).count() < 2 {
            return None;
        }
        // In units in which the largest numbers are about one; powers of two change no digit.
        let unit_rate = power_of_two(start.omega_body.amax());
        let omega = start.omega_body / unit_rate;
        let moments = moments.to_array();
        let unit_moment = power_of_two(moments.into_iter().fold(0.0, f64::max));
        let moments = moments.map(|moment| moment / unit_moment);
        let axes = order(moments, &omega);
        let [i1, i2, i3] = axes.map(|axis| moments[axis]);
        let renaming = rename(axes, &omega);
        let [w1, w2, w3]: [f64; 3] = (renaming * omega).into();

        let product = TwoPart::product;
        let minus = |x: f64, y: f64| TwoPart::sum(x, -y);
        // L² − 2TI_k is the sum of I_j (I_j − I_k) ω_j², which has the differences of the moments before they are lost.
        let term = |i: f64, w: f64, less: f64| product(w, w) * minus(i, less) * i;
        let d1 = term(i2, w2, i1) + term(i3, w3, i1); // L² − 2TI₁
        let d2 = term(i1, w1, i2) + term(i3, w3, i2); // L² − 2TI₂
        let d3 = -(term(i1, w1, i3) + term(i2, w2, i3)); // 2TI₃ − L²

        // eq:free-modulus
        let p = (minus(i3, i2) * d1 / (product(i1, i2) * i3)).sqrt();
        if p.rounded() == 0.0 {
            return None;
        }
        let parameter = (minus(i2, i1) * d3 / (minus(i3, i2) * d1)).rounded().clamp(0.0, 1.0); // k²
        let complement = minus(i3, i1) * d2 / (minus(i3, i2) * d1); // k'²
        let complement = if complement.rounded() > 0.0 { complement } else { TwoPart::from(0.0) };

        // eq:free-amplitudes
        let s = (i3 - i1).signum();
        let a = (d3 / (minus(i3, i1) * i1)).sqrt();
        let b = (d3 / (minus(i3, i2) * i2)).sqrt() * s;
        let c = (d1 / (minus(i3, i1) * i3)).sqrt();

        // The inverse of sn by Carlson's integral, DLMF 19.25.5 multiplied by sn².
        let [cn, sn, dn] = [(w1, a), (w2, b), (w3, c)].map(|(w, amplitude)| TwoPart::from(w) / amplitude);
        let one = TwoPart::from(1.0);
        let first_argument = sn * carlson_rf_in_two_parts([cn * cn, dn * dn, one]);

        let square = |i: f64, w: f64| product(i, w) * product(i, w);
        let l = (square(i1, w1) + square(i2, w2) + square(i3, w3)).sqrt();
        let n = minus(i2, i1) * i3 / (minus(i3, i2) * i1); // eq:tip-radius
        let one_and_n = minus(i3, i1) * i2 / (minus(i3, i2) * i1);
        let (quarter, steady_rate) = if complement.rounded() == 0.0 {
            (None, l / TwoPart::from(i2)) // the limit of the other
        } else {
            let k = complement.sqrt();
            let quarter = complete_integral(k, one, one, one);
            // eq:mean-rates
            let ratio = minus(i3, i1) / minus(i3, i2);
            let heading = l / (p * i1) * complete_integral(k, one_and_n, one, ratio); // Λ K/p
            let circling = TwoPart::PI * (0.5 * s); // σ K/p
            (Some(quarter), (heading - circling) * p / quarter)
        };
        let zero = s * carlson_rf(n.rounded(), n.rounded() + parameter, one_and_n.rounded()); // eq:tip-zero
        let quarters = [quarter.map_or(f64::INFINITY, TwoPart::rounded), quarter_period(parameter)];
        let theta = Theta::new(parameter, quarters, zero);
        let per = match (&theta, quarter) {
            (Theta::Slow(_), Some(quarter)) => quarter, // quarter turns of v = πu/2K
            (Theta::Fast(_), Some(quarter)) => quarter * 2.0, // half periods
            (_, None) => one,
        };

        let argument_rate = p * unit_rate;
        let renamed_from_body =
            UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(renaming));
        let identity = UnitQuaternion::identity();
        let constants = Constants {
            argument: Clock::from_quarters(argument_rate / per),
            first_argument: first_argument / per,
            half_turn: Clock::from_rate(steady_rate * (0.5 * unit_rate)),
            sense: s,
            ratio: (b * i2 / (a * i1)).rounded().abs(),
            amplitudes: Vector3::new(a, b, c).map(|amplitude| amplitude.rounded() * unit_rate),
            moments_by_l: Vector3::new(i1, i2, i3) / (l.rounded() * unit_rate),
            attitude: both_sides(&identity, &renamed_from_body),
            body_from_renamed: renaming.transpose(),
        };
        let period = quarter.map(|quarter| (quarter * 4.0 / argument_rate).rounded());
        let mut motion = Self { constants, theta, period };
        let upright_from_body = motion.state(0.0).world_from_body;
        let world_from_upright = start.world_from_body * upright_from_body.inverse();
        motion.constants.attitude = both_sides(&world_from_upright, &renamed_from_body);
        Some(motion)
    }

    /// Attitude and angular velocity at `time`, s.
    pub(super) fn at(&self, time: f64) -> Result<Turning, InvalidQuantity> {
        Ok(self.state(InvalidQuantity::check_time(time)?))
    }

    fn state(&self, time: f64) -> Turning {
        match &self.theta {
            Theta::Slow(slow) => self.constants.state::<true>(slow, time),
            Theta::Fast(fast) => self.constants.state::<true>(fast, time),
        }
    }

    /// The same at many times.
    pub(super) fn sample(&self, times: &[f64]) -> Result<Vec<Turning>, InvalidQuantity> {
        let Self { constants, theta, .. } = *self;
        let reach = constants.argument.reach().min(constants.half_turn.reach());
        let (reach, blank) = ([-reach, reach], self.state(0.0));
        let at = |time: f64| self.at(time);
        match theta {
            Theta::Slow(theta) => sample_branchless(OneSide { constants, theta }, reach, times, blank, at),
            Theta::Fast(theta) => sample_branchless(OneSide { constants, theta }, reach, times, blank, at),
        }
    }

    /// The time after which the angular velocity is the same again, `4K/p`, s; none on the separatrix.
    pub(super) fn period(&self) -> Option<f64> {
        self.period
    }
}

impl<P: Polynomials + Copy> Branchless for OneSide<P> {
    type State = Turning;

    #[inline(always)]
    fn state<const ONE: bool>(&self, time: f64) -> Turning {
        self.constants.state::<ONE>(&self.theta, time)
    }
}

impl Constants {
    #[inline(always)]
    fn state<const ONE: bool>(&self, theta: &impl Polynomials, time: f64) -> Turning {
        let ((high, low), (turn_high, turn_low)) = (self.argument.at(time), self.half_turn.at(time));
        let (first, first_low) = self.first_argument.parts();
        let (argument, argument_low) = (TwoPart::sum(high, first) + (low + first_low)).parts();
        let Values { jacobi: [cn, sn, dn], theta: [re, im], flip, drift } =
            theta.at::<ONE>(argument, argument_low);
        // Z of eq:beyond-steady (where axis 3 heads in the room, less where L heads in the body, eq:tip) without the
        // factor e^{iη'u/K}, and |Z| + Z, without a difference.
        let (x, y) = (re * cn + im * self.ratio * sn, im * cn - re * self.ratio * sn);
        // x is a sum of two products of numbers with the same sign.
        let half_x = (x * x + y * y).sqrt() + x.abs();
        let half_y = self.sense * y;
        let (turn, turn_low) = (TwoPart::sum(turn_high, self.sense * drift) + turn_low).parts();
        let (sin, cos) = sin_cos_quarters::<ONE>(turn, turn_low);
        let (c, s) = (cos * half_x - sin * half_y, sin * half_x + cos * half_y);

        let turned = |value: f64| f64::from_bits(value.to_bits() ^ flip);
        let [size_1, size_2, size_3]: [f64; 3] = self.amplitudes.into();
        let omega = [turned(size_1 * cn), turned(size_2 * sn), size_3 * dn]; // eq:free-jacobi
        // L̂ along the renamed axes (eq:momentum-direction); the shortest rotation that takes it upright (eq:upright);
        // then the turn about the upright (eq:free-attitude).
        let [l1, l2, l3]: [f64; 3] = std::array::from_fn(|n| self.moments_by_l[n] * omega[n]);
        let (w, i, j) = (1.0 + l3, l2, -l1);
        let q = self.attitude * Vector4::new(c * i - s * j, c * j + s * i, s * w, c * w);
        Turning {
            world_from_body: UnitQuaternion::new_unchecked(Quaternion::from(q * q.norm().recip())),
            omega_body: self.body_from_renamed * Vector3::from(omega),
        }
    }
}

/// The matrix that multiplies a quaternion, as a column with the scalar last, by one from the left and one from the
/// right.
fn both_sides(left: &UnitQuaternion<f64>, right: &UnitQuaternion<f64>) -> Matrix4<f64> {
    let column = |n: usize| {
        let unit = Quaternion::from(Vector4::from_fn(|i, _| if i == n { 1.0 } else { 0.0 }));
        (left.quaternion() * unit * right.quaternion()).coords
    };
    Matrix4::from_columns(&[column(0), column(1), column(2), column(3)])
}

/// The largest power of two that is at most `size`.
fn power_of_two(size: f64) -> f64 {
    2_f64.powi(size.log2().floor() as i32)
}

/// Which of the body's axes are 1, 2, 3: 2 has the middle moment, 3 is the extreme one that ω circles.
fn order(moments: [f64; 3], omega: &Vector3<f64>) -> [usize; 3] {
    let mut axes = [0, 1, 2];
    axes.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
    let [small, middle, large] = axes;
    let term = |axis: usize| {
        TwoPart::product(omega[axis], omega[axis])
            * TwoPart::sum(moments[axis], -moments[middle])
            * moments[axis]
    };
    // The sign of L² − 2TI₂.
    if (term(small) + term(large)).rounded() >= 0.0 { [small, middle, large] } else { [large, middle, small] }
}

/// The rotation from the body's axes to 1, 2, 3 with signs such that `ω₁ ≥ 0` and `ω₃ > 0`.
fn rename([first, _, third]: [usize; 3], omega: &Vector3<f64>) -> Matrix3<f64> {
    let unit = |axis: usize| {
        let sign = if omega[axis] < 0.0 { -1.0 } else { 1.0 };
        Vector3::from_fn(|i, _| if i == axis { sign } else { 0.0 })
    };
    let [first, third] = [first, third].map(unit);
    Matrix3::from_rows(&[first.transpose(), third.cross(&first).transpose(), third.transpose()])
}

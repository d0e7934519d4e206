//! A free body with three different moments: Jacobi's functions for the angular velocity, a theta function for the
//! attitude.
//!
//! The page "The attitude of any free body" of the chapter "The pinned hoop" derives it. As there, axes 1, 2, 3 are
//! the body's own, renamed: 2 has the middle moment, 3 is the one that ω circles, and at the start `ω₁ ≥ 0` and
//! `ω₃ > 0`. C. G. J. Jacobi, *Journal für die reine und angewandte Mathematik* **39** (1850) 293; R. van Zon & J.
//! Schofield, *Journal of Computational Physics* **225** (2007) 145.

use super::theta::Theta;
use crate::attitude::turn;
use crate::elliptic::{carlson_rf, carlson_rf_in_two_parts, complete_integral, jacobi, quarter_period};
use crate::euler::Turning;
use crate::inertia::PrincipalMoments;
use crate::two_part::TwoPart;
use nalgebra::{Complex, Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

/// The motion of a body with three different moments, about which no two components of ω vanish.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Asymmetric {
    pub(crate) argument_rate: TwoPart,     // p, 1/s
    pub(crate) first_argument: TwoPart,    // u₀
    pub(crate) quarter: Option<TwoPart>,   // K; none, as it is infinite, on the separatrix
    pub(crate) complement: f64,            // k'²
    pub(crate) amplitudes: Vector3<f64>,   // W₁, W₂, W₃, rad/s
    pub(crate) moments_by_l: Vector3<f64>, // I₁/L, I₂/L, I₃/L, s
    pub(crate) steady_rate: TwoPart,       // Λ − σ, rad/s
    pub(crate) theta: Theta,
    /// From axes of which the third lies along **L**.
    pub(crate) world_from_upright: UnitQuaternion<f64>,
    pub(crate) renamed_from_body: UnitQuaternion<f64>,
    /// The inverse as a matrix, a permutation with signs, which is exact.
    pub(crate) body_from_renamed: Matrix3<f64>,
}

impl Asymmetric {
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

        let renamed_from_body =
            UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(renaming));
        let motion = Self {
            argument_rate: p * unit_rate,
            first_argument,
            quarter,
            complement: complement.rounded(),
            amplitudes: Vector3::new(a, b, c).map(|amplitude| amplitude.rounded() * unit_rate),
            moments_by_l: Vector3::new(i1, i2, i3) / (l.rounded() * unit_rate),
            steady_rate: steady_rate * unit_rate,
            theta: Theta::new(parameter, quarters, s, zero),
            world_from_upright: UnitQuaternion::identity(),
            renamed_from_body,
            body_from_renamed: renaming.transpose(),
        };
        let upright_from_body = motion.at(0.0).world_from_body;
        Some(Self { world_from_upright: start.world_from_body * upright_from_body.inverse(), ..motion })
    }

    /// Attitude and angular velocity at `time`, s, which has been checked.
    pub(super) fn at(&self, time: f64) -> Turning {
        let (u, sign) = self.argument(time);
        let [sn, cn, dn] = jacobi(u, self.complement);
        let omega = self.amplitudes.component_mul(&Vector3::new(sign * cn, sign * sn, dn)); // eq:free-jacobi
        let momentum_direction = self.moments_by_l.component_mul(&omega); // eq:momentum-direction

        // eq:beyond-steady: where axis 3 heads in the room, less where L heads in the body (eq:tip)
        let [l1, l2, _]: [f64; 3] = momentum_direction.into();
        let beyond = (sign * self.theta.direction(u) * Complex::new(l1, -l2)).arg();
        let angle = self.steady_rate * time + TwoPart::from(beyond);

        // eq:free-attitude
        let about_momentum = turn(&Vector3::z(), angle);
        let upright_from_body = about_momentum * upright(&momentum_direction) * self.renamed_from_body;
        Turning {
            world_from_body: self.world_from_upright * upright_from_body,
            omega_body: self.body_from_renamed * omega,
        }
    }

    /// The argument `u = pt + u₀` less whole half periods, from −K to K, and the sign that cn and sn take for them.
    fn argument(&self, time: f64) -> (f64, f64) {
        let (mut u, mut sign) = (self.argument_rate * time + self.first_argument, 1.0);
        if let Some(quarter) = self.quarter {
            // Twice, as their number may be too large for a single one to count them.
            for _ in 0..2 {
                let whole = (u.rounded() / (2.0 * quarter.rounded())).round();
                u = u - quarter * (2.0 * whole);
                sign *= if whole % 2.0 == 0.0 { 1.0 } else { -1.0 };
            }
        }
        (u.rounded(), sign)
    }

    /// The time after which the angular velocity is the same again, `4K/p`, s; none on the separatrix.
    pub(super) fn period(&self) -> Option<f64> {
        self.quarter.map(|quarter| (quarter * 4.0 / self.argument_rate).rounded())
    }
}

/// The shortest rotation that takes a unit vector with a third component above zero to the third axis (`eq:upright`).
fn upright(direction: &Vector3<f64>) -> UnitQuaternion<f64> {
    let [l1, l2, l3]: [f64; 3] = (*direction).into();
    UnitQuaternion::from_quaternion(Quaternion::new(1.0 + l3, l2, -l1, 0.0))
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

//! A free body with three different moments: Jacobi's functions for the angular velocity, theta functions for the attitude.

use crate::elliptic::{carlson_rf, complete_integral, jacobi, quarter_period};
use crate::euler::Turning;
use crate::inertia::PrincipalMoments;
use crate::two_part::TwoPart;
use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// Terms of the theta series. The nome is below 0.0433 on either side, and its sixteenth power times the growth of the
/// hyperbolic functions below 1e-17.
const TERMS: usize = 4;

/// The motion of a body with three different moments, about which no two components of ω vanish.
///
/// Axes a, b, c are the body's own, renamed: b is the middle one, c the one that ω circles, with `ω_a ≥ 0` and `ω_c > 0` at the
/// start. Then `ω = (A cn u, σB sn u, C dn u)`, and the angle about **L** is a steady turn and an angle of theta functions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Asymmetric {
    start: UnitQuaternion<f64>,
    renamed_from_body: Matrix3<f64>, // a permutation with signs, exact
    renaming: UnitQuaternion<f64>,   // the same as a quaternion
    fixed_from_renamed_at_start: UnitQuaternion<f64>,
    moments: [f64; 3], // of a, b, c over their largest
    amplitudes: [f64; 3],
    momentum: f64,
    complement: f64, // k'²
    sense: f64,      // σ
    rate: f64,       // p, per unit of scaled time
    scale: f64,      // scaled time is seconds times this power of two
    first_argument: f64,
    half_period: TwoPart, // 2K/p in scaled time; infinite on the separatrix
    quarter: f64,         // K
    turn_rate: TwoPart,   // Λ, per unit of scaled time
    theta: Theta,
    tilt: f64, // √(1 + n)
}

/// The theta series of one side.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Theta {
    /// k² ≤ ½: nome of K'/K; `π/2K` and the hyperbolic functions of `(2j + 1)πζ/2K`, with the powers of the nome.
    Slow { scale: f64, sinh: [f64; TERMS], cosh: [f64; TERMS] },
    /// k² > ½: nome of K/K'; `π/2K'`, `πζ/2K'`, and the circular functions of `(2j + 1)πζ/2K'`, with the powers of the nome.
    Fast { scale: f64, angle: f64, sin: [f64; TERMS], cos: [f64; TERMS] },
}

impl Asymmetric {
    /// The motion from a start whose numbers have been checked; `None` if the rotation is steady. No two moments may be
    /// equal.
    pub(super) fn new(moments: PrincipalMoments, start: &Turning) -> Option<Self> {
        let largest = start.omega_body.amax();
        if start.omega_body.iter().filter(|&&component| component != 0.0).count() < 2 {
            return None;
        }
        // Powers of two change no digit.
        let scale = power_of_two(largest);
        let unit = power_of_two(moments.to_array().into_iter().fold(0.0, f64::max));
        let body_moments = moments.to_array().map(|moment| moment / unit);
        let omega = start.omega_body / scale;

        let [ia, ib, ic] = order(body_moments, &omega);
        let renamed_from_body = rename([ia, ib, ic], &omega);
        let [wa, wb, wc]: [f64; 3] = (renamed_from_body * omega).into();
        let [a, b, c] = [ia, ib, ic].map(|axis| body_moments[axis]);
        let sense = (c - a).signum();

        let weighted =
            |moment: f64, w: f64, difference: TwoPart| TwoPart::product(w, w) * difference * moment;
        let minus = |x: f64, y: f64| TwoPart::sum(x, -y);
        let da = weighted(b, wb, minus(b, a)) + weighted(c, wc, minus(c, a));
        let db = weighted(a, wa, minus(a, b)) + weighted(c, wc, minus(c, b));
        let dc = weighted(a, wa, minus(a, c)) + weighted(b, wb, minus(b, c));
        let product = TwoPart::product(a, b) * c;
        let rate = (da * minus(c, b) / product).sqrt();
        if rate.rounded() == 0.0 {
            return None;
        }
        let complement = db * minus(c, a) / (minus(c, b) * da);
        let complement = if complement.rounded() > 0.0 { complement } else { TwoPart::from(0.0) };
        let parameter = (dc * minus(b, a) / (minus(b, c) * da)).rounded().clamp(0.0, 1.0);
        let n = minus(a, b) * c / (minus(b, c) * a);
        let one_and_n = minus(a, c) * b / (minus(b, c) * a);

        let amplitude = |numerator: TwoPart, moment: f64, difference: TwoPart| {
            (numerator / (difference * moment)).sqrt().rounded()
        };
        let amplitudes =
            [amplitude(dc, a, minus(a, c)), amplitude(dc, b, minus(b, c)), amplitude(da, c, minus(c, a))];
        let momentum = (TwoPart::product(a, wa) * TwoPart::product(a, wa)
            + TwoPart::product(b, wb) * TwoPart::product(b, wb)
            + TwoPart::product(c, wc) * TwoPart::product(c, wc))
        .sqrt();
        let [cn, sn, dn] =
            [wa / amplitudes[0], sense * wb / amplitudes[1], wc / amplitudes[2]].map(|x| x.clamp(-1.0, 1.0));
        let first_argument = sn * carlson_rf(cn * cn, dn * dn, 1.0);

        let (half_period, quarter, turn_rate) = if complement.rounded() == 0.0 {
            (TwoPart::from(f64::INFINITY), f64::INFINITY, momentum / TwoPart::from(b))
        } else {
            let root = complement.sqrt();
            let one = TwoPart::from(1.0);
            let quarter = complete_integral(root, one, one, one);
            let slope = minus(c, a) / minus(c, b);
            let angle = momentum / (rate * a) * complete_integral(root, one_and_n, one, slope);
            let turned = angle - TwoPart::PI * (0.5 * sense);
            (quarter * 2.0 / rate, quarter.rounded(), turned * rate / quarter)
        };
        let zeta = carlson_rf(n.rounded(), n.rounded() + parameter, one_and_n.rounded());
        let mut motion = Self {
            start: start.world_from_body,
            renamed_from_body,
            renaming: UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(
                renamed_from_body,
            )),
            fixed_from_renamed_at_start: UnitQuaternion::identity(),
            moments: [a, b, c],
            amplitudes,
            momentum: momentum.rounded(),
            complement: complement.rounded(),
            sense,
            rate: rate.rounded(),
            scale,
            first_argument,
            half_period,
            quarter,
            turn_rate,
            theta: Theta::new(parameter, quarter, zeta),
            tilt: one_and_n.rounded().sqrt(),
        };
        motion.fixed_from_renamed_at_start = motion.renamed(0.0).0;
        Some(motion)
    }

    /// Attitude and angular velocity at `time`, s, which has been checked.
    pub(super) fn at(&self, time: f64) -> Turning {
        let (fixed_from_renamed, omega) = self.renamed(time * self.scale);
        let since_start = self.fixed_from_renamed_at_start.inverse() * fixed_from_renamed;
        let world_from_body = self.start * (self.renaming.inverse() * since_start * self.renaming);
        let omega_body = self.renamed_from_body.transpose() * omega * self.scale;
        Turning { world_from_body, omega_body }
    }

    /// The time after which the angular velocity is the same again, s; infinite on the separatrix.
    pub(super) fn period(&self) -> f64 {
        (self.half_period * 2.0).rounded() / self.scale
    }

    /// The rotation from the renamed axes to axes of which the third lies along **L**, and ω along the renamed axes, at a
    /// scaled time.
    fn renamed(&self, time: f64) -> (UnitQuaternion<f64>, Vector3<f64>) {
        let argument = self.rate * time + self.first_argument;
        let halves = if self.quarter.is_finite() { (argument / (2.0 * self.quarter)).round() } else { 0.0 };
        let u = if halves == 0.0 {
            argument
        } else {
            let rest = TwoPart::from(time) - self.half_period * halves;
            self.rate * rest.rounded() + self.first_argument
        };
        let [sn, cn, dn] = jacobi(u, self.complement);
        let flip = if halves.rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 };
        let [size_a, size_b, size_c] = self.amplitudes;
        let omega = Vector3::new(flip * size_a * cn, flip * self.sense * size_b * sn, size_c * dn);

        let (re, im) = self.theta.at(u);
        let extra = (im * cn - re * self.tilt * sn).atan2(re * cn + im * self.tilt * sn);
        let slow = match self.theta {
            Theta::Slow { .. } => 0.0,
            Theta::Fast { angle, .. } => angle * u / self.quarter,
        };
        let turned = self.turn_rate * time + TwoPart::from(self.sense * (slow + extra));
        let (sin, cos) = (turned * 0.5).sin_cos();
        // L along the renamed axes; the rotation that takes it upright; then the turn about the upright.
        let [la, lb, lc]: [f64; 3] =
            (Vector3::from(self.moments).component_mul(&omega) / self.momentum).into();
        let upright = UnitQuaternion::from_quaternion(Quaternion::new(1.0 + lc, lb, -la, 0.0));
        let turn = UnitQuaternion::new_unchecked(Quaternion::new(cos, 0.0, 0.0, sin));
        (turn * upright, omega)
    }
}

impl Theta {
    fn new(parameter: f64, quarter: f64, zeta: f64) -> Self {
        let other_quarter = quarter_period(parameter); // K', whose complementary parameter is k²
        let odd = |j: usize| (2 * j + 1) as f64;
        // (−1)^j q^{(j+½)² − ¼}: a common factor does not change an angle.
        let weight = |nome: f64, j: usize| {
            let sign = if j.is_multiple_of(2) { 1.0 } else { -1.0 };
            sign * nome.powi((j * (j + 1)) as i32)
        };
        if parameter <= 0.5 {
            let nome = (-PI * other_quarter / quarter).exp();
            let scale = FRAC_PI_2 / quarter;
            let side = |function: fn(f64) -> f64| {
                std::array::from_fn(|j| {
                    let w = weight(nome, j);
                    if w == 0.0 { 0.0 } else { w * function(odd(j) * scale * zeta) }
                })
            };
            Self::Slow { scale, sinh: side(f64::sinh), cosh: side(f64::cosh) }
        } else {
            let nome = (-PI * quarter / other_quarter).exp();
            let scale = FRAC_PI_2 / other_quarter;
            let angle = scale * zeta;
            let side = |function: fn(f64) -> f64| {
                std::array::from_fn(|j| weight(nome, j) * function(odd(j) * angle))
            };
            Self::Fast { scale, angle, sin: side(f64::sin), cos: side(f64::cos) }
        }
    }

    /// The theta function at `u`, up to a positive factor: real and imaginary part.
    fn at(&self, u: f64) -> (f64, f64) {
        match self {
            Self::Slow { scale, sinh, cosh } => {
                let (sin, cos) = (scale * u).sin_cos();
                odd_sums(cos, sin, 4.0 * cos * cos - 2.0, sinh, cosh)
            }
            Self::Fast { scale, sin, cos, .. } => {
                let w = scale * u.abs();
                let (mut re, mut im) = (0.0, 0.0);
                for (j, (sin, cos)) in sin.iter().zip(cos).enumerate() {
                    // cosh and sinh of (2j + 1)w over e^w.
                    let (grow, fall) = ((2 * j) as f64 * w, -((2 * j + 2) as f64) * w);
                    if *sin == 0.0 && *cos == 0.0 {
                        break;
                    }
                    let (grow, fall) = (grow.exp(), fall.exp());
                    re += sin * 0.5 * (grow + fall);
                    im += cos * 0.5 * (grow - fall);
                }
                (re, im * u.signum())
            }
        }
    }
}

/// `Σ cos(2j+1)v aⱼ` and `Σ sin(2j+1)v bⱼ` from cosine and sine of v; the factor is 2 cos 2v.
fn odd_sums(cos: f64, sin: f64, factor: f64, a: &[f64; TERMS], b: &[f64; TERMS]) -> (f64, f64) {
    let (mut cos_before, mut sin_before) = (cos, -sin); // of −v
    let (mut cos_now, mut sin_now) = (cos, sin);
    let (mut re, mut im) = (0.0, 0.0);
    for (a, b) in a.iter().zip(b) {
        re += a * cos_now;
        im += b * sin_now;
        (cos_before, cos_now) = (cos_now, factor * cos_now - cos_before);
        (sin_before, sin_now) = (sin_now, factor * sin_now - sin_before);
    }
    (re, im)
}

/// The largest power of two that is at most `size`.
fn power_of_two(size: f64) -> f64 {
    2_f64.powi(size.log2().floor() as i32)
}

/// The axes a, b, c: b has the middle moment, c is the extreme one that ω circles.
fn order(moments: [f64; 3], omega: &Vector3<f64>) -> [usize; 3] {
    let mut axes = [0, 1, 2];
    axes.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
    let [small, middle, large] = axes;
    let part = |axis: usize| {
        TwoPart::product(omega[axis], omega[axis])
            * TwoPart::sum(moments[axis], -moments[middle])
            * moments[axis]
    };
    if (part(small) + part(large)).rounded() >= 0.0 { [small, middle, large] } else { [large, middle, small] }
}

/// The rotation from the body's axes to a, b, c with signs such that `ω_a ≥ 0` and `ω_c > 0`.
fn rename(axes: [usize; 3], omega: &Vector3<f64>) -> Matrix3<f64> {
    let sign = |axis: usize| if omega[axis] < 0.0 { -1.0 } else { 1.0 };
    let unit = |axis: usize, sign: f64| Vector3::from_fn(|i, _| if i == axis { sign } else { 0.0 });
    let [a, c] = [unit(axes[0], sign(axes[0])), unit(axes[2], sign(axes[2]))];
    let b = c.cross(&a);
    Matrix3::from_rows(&[a.transpose(), b.transpose(), c.transpose()])
}

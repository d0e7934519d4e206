//! A free body with three different moments: Jacobi's functions for the angular velocity, theta functions for the attitude.
//!
//! Here the constants of a motion are found; [`wave`] computes its frames.

mod wave;

use crate::elliptic::{carlson_rf, carlson_rf_in_two_parts, complete_integral, quarter_period};
use crate::euler::Turning;
use crate::inertia::PrincipalMoments;
use crate::quantity::InvalidQuantity;
use crate::two_part::TwoPart;
use crate::wide::{BLOCK, in_blocks};
use nalgebra::{Matrix3, Matrix4, Quaternion, Rotation3, UnitQuaternion, Vector3, Vector4};
use wave::{Constants, Wave};

/// The motion of a body with three different moments, about which no two components of ω vanish.
///
/// Axes a, b, c are the body's own, renamed: b is the middle one, c the one that ω circles, with `ω_a ≥ 0` and `ω_c > 0` at the
/// start. Then `ω = (A cn u, σB sn u, C dn u)`, and the angle about **L** is a steady turn and an angle of theta functions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Asymmetric {
    wave: Wave,
    world_from_wave: Matrix4<f64>, // takes the wave's quaternion (scalar last) to the attitude's
    body_from_renamed: Matrix3<f64>, // a permutation with signs, exact
    period: f64,
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

        let amplitude =
            |numerator: TwoPart, moment: f64, difference: TwoPart| (numerator / (difference * moment)).sqrt();
        let amplitudes =
            [amplitude(dc, a, minus(a, c)), amplitude(dc, b, minus(b, c)), amplitude(da, c, minus(c, a))];
        let momentum = (TwoPart::product(a, wa) * TwoPart::product(a, wa)
            + TwoPart::product(b, wb) * TwoPart::product(b, wb)
            + TwoPart::product(c, wc) * TwoPart::product(c, wc))
        .sqrt();
        // What is rounded here is late for ever, and where two moments nearly agree a small lateness is a large angle.
        let [cn, sn, dn] =
            [(wa, 0), (sense * wb, 1), (wc, 2)].map(|(w, axis)| TwoPart::from(w) / amplitudes[axis]);
        let first_argument = sn * carlson_rf_in_two_parts([cn * cn, dn * dn, TwoPart::from(1.0)]);

        let (half_period, quarter, turn_rate) = if complement.rounded() == 0.0 {
            (TwoPart::from(f64::INFINITY), TwoPart::from(f64::INFINITY), momentum / TwoPart::from(b))
        } else {
            let root = complement.sqrt();
            let one = TwoPart::from(1.0);
            let quarter = complete_integral(root, one, one, one);
            let slope = minus(c, a) / minus(c, b);
            let angle = momentum / (rate * a) * complete_integral(root, one_and_n, one, slope);
            let turned = angle - TwoPart::PI * (0.5 * sense);
            (quarter * 2.0 / rate, quarter, turned * rate / quarter)
        };
        let wave = Wave::new(&Constants {
            moments: [a, b, c],
            amplitudes: amplitudes.map(TwoPart::rounded),
            momentum: momentum.rounded(),
            sense,
            rate,
            scale,
            first_argument,
            half_period,
            quarter,
            other_quarter: quarter_period(parameter), // K', whose complementary parameter is k²
            parameter,
            turn_rate,
            zeta: carlson_rf(n.rounded(), n.rounded() + parameter, one_and_n.rounded()),
            tilt: one_and_n.rounded().sqrt(),
        });
        let renaming =
            UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(renamed_from_body));
        let [i, j, k, w, ..] = wave.at(0.0);
        let at_start = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
        let before = start.world_from_body * renaming.inverse() * at_start.inverse();
        Some(Self {
            wave,
            world_from_wave: both_sides(&before, &renaming),
            body_from_renamed: renamed_from_body.transpose(),
            period: (half_period * 2.0).rounded() / scale,
        })
    }

    /// Attitude and angular velocity at `time`, s, which has been checked.
    pub(super) fn at(&self, time: f64) -> Turning {
        self.turning(self.wave.at(time))
    }

    /// Fills the frames at times within reach and says how many, as [`in_blocks`] does.
    pub(super) fn fill(&self, times: &[f64], frames: &mut [Turning]) -> usize {
        let mut block = [[0.0; BLOCK]; 7];
        let reached =
            |time: f64| time.abs() <= self.wave.reach() && InvalidQuantity::check_time(time).is_ok();
        in_blocks(times, frames, reached, |times, frames| {
            self.wave.fill(times, &mut block);
            for (n, frame) in frames.iter_mut().enumerate() {
                *frame = self.turning(std::array::from_fn(|i| block[i][n]));
            }
            true
        })
    }

    /// The time after which the angular velocity is the same again, s; infinite on the separatrix.
    pub(super) fn period(&self) -> f64 {
        self.period
    }

    fn turning(&self, [i, j, k, w, wa, wb, wc]: [f64; 7]) -> Turning {
        let q = self.world_from_wave * Vector4::new(i, j, k, w);
        Turning {
            world_from_body: UnitQuaternion::new_unchecked(Quaternion::from(q / q.norm())),
            omega_body: self.body_from_renamed * Vector3::new(wa, wb, wc),
        }
    }
}

/// The matrix that multiplies a quaternion, as a column with the scalar last, by one from the left and one from the right.
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

//! A free body with three different moments, by polynomials in the theta series' own variables.
//!
//! A state follows from two phases that grow at a constant rate: the argument u, which gives sn, cn, dn and the
//! direction of `eq:beyond-steady`, and half the steady angle about **L**. Of the angle beyond the steady one the half
//! is found without the angle: a complex number Z has the direction of the square of `|Z| + Z`.

mod theta;

use self::theta::{Fast, Polynomials, Slow, Values};
use super::functions::{Clock, at_full_width, sin_cos_quarters};
use super::{BLOCK, in_blocks};
use crate::euler::Turning;
use crate::free_rotation::asymmetric::Asymmetric;
use crate::free_rotation::theta::Side;
use crate::quantity::InvalidQuantity;
use crate::two_part::TwoPart;
use nalgebra::{Matrix3, Matrix4, Quaternion, UnitQuaternion, Vector3, Vector4};

/// The motion, ready to be evaluated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tumbling {
    argument: Clock, // u in quarter turns of v, or in half periods, or as it is: see `Series`
    first_argument: TwoPart,
    half_turn: Clock, // half the steady angle about L
    sense: f64,       // s
    ratio: f64,       // |I₂W₂/I₁W₁| = √(1 + n)
    amplitudes: Vector3<f64>,
    moments_by_l: Vector3<f64>,
    series: Series,
    /// Takes the quaternion of the renamed axes in upright ones, scalar last, to the attitude's.
    attitude: Matrix4<f64>,
    body_from_renamed: Matrix3<f64>,
}

/// The theta functions of one side, as polynomials.
#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "one for thousands of states")]
enum Series {
    /// Circular functions of v = πu/2K, polynomials in cos 2v.
    Slow(Slow),
    /// Hyperbolic functions of w = πu/2K'.
    Fast(Fast),
}

impl Tumbling {
    pub(crate) fn new(motion: &Asymmetric) -> Self {
        let (argument_rate, first_argument, theta) =
            (motion.argument_rate, motion.first_argument, &motion.theta);
        let (series, per) = match (theta.side, motion.quarter) {
            (Side::Circular, Some(quarter)) => (Series::Slow(Slow::new(theta)), quarter), // v in quarter turns is u/K
            (_, Some(quarter)) => (Series::Fast(Fast::new(theta)), quarter * 2.0),
            (_, None) => (Series::Fast(Fast::new(theta)), TwoPart::from(1.0)),
        };
        let [a, b, _]: [f64; 3] = motion.amplitudes.component_mul(&motion.moments_by_l).into();
        let [left, right] = [&motion.world_from_upright, &motion.renamed_from_body];
        Self {
            argument: Clock::from_quarters(argument_rate / per),
            first_argument: first_argument / per,
            half_turn: Clock::from_rate(motion.steady_rate * 0.5),
            sense: theta.sense,
            ratio: (b / a).abs(),
            amplitudes: motion.amplitudes,
            moments_by_l: motion.moments_by_l,
            series,
            attitude: both_sides(left, right),
            body_from_renamed: motion.body_from_renamed,
        }
    }

    /// Fills the states at times within reach and says how many, as [`in_blocks`] does.
    pub(crate) fn fill(&self, times: &[f64], states: &mut [Turning]) -> usize {
        let reach = self.argument.reach().min(self.half_turn.reach());
        let reached = |time: f64| time.abs() <= reach && InvalidQuantity::check_time(time).is_ok();
        let mut block = [[0.0; BLOCK]; 7];
        in_blocks(times, states, reached, |times, states| {
            let mut padded = [0.0; BLOCK];
            padded[..times.len()].copy_from_slice(times);
            at_full_width(
                #[inline(always)]
                || match &self.series {
                    Series::Slow(slow) => self.fill_block(slow, &padded, &mut block),
                    Series::Fast(fast) => self.fill_block(fast, &padded, &mut block),
                },
            );
            for (n, state) in states.iter_mut().enumerate() {
                *state = self.turning(std::array::from_fn(|i| block[i][n]));
            }
            true
        })
    }

    #[inline(always)]
    fn fill_block(&self, series: &impl Polynomials, times: &[f64; BLOCK], block: &mut [[f64; BLOCK]; 7]) {
        let [i, j, k, w, w1, w2, w3] = block;
        for n in 0..BLOCK {
            [i[n], j[n], k[n], w[n], w1[n], w2[n], w3[n]] = self.numbers(series, times[n]);
        }
    }

    /// The quaternion of the renamed axes in upright ones (i, j, k, scalar, not of length one), and ω along the
    /// renamed axes, rad/s.
    #[inline(always)]
    fn numbers(&self, series: &impl Polynomials, time: f64) -> [f64; 7] {
        let ((high, low), (turn_high, turn_low)) = (self.argument.at(time), self.half_turn.at(time));
        let (first, first_low) = self.first_argument.parts();
        let (argument, argument_low) = (TwoPart::sum(high, first) + (low + first_low)).parts();
        let Values { jacobi: [cn, sn, dn], theta: [re, im], flip, drift } = series.at(argument, argument_low);
        // Z of eq:beyond-steady without the factor e^{iη'u/K}, and |Z| + Z, without a difference.
        let (x, y) = (re * cn + im * self.ratio * sn, im * cn - re * self.ratio * sn);
        // x is a sum of two products of numbers with the same sign.
        let half_x = (x * x + y * y).sqrt() + x.abs();
        let half_y = self.sense * y;
        let (turn, turn_low) = (TwoPart::sum(turn_high, self.sense * drift) + turn_low).parts();
        let (sin, cos) = sin_cos_quarters(turn, turn_low);
        let (c, s) = (cos * half_x - sin * half_y, sin * half_x + cos * half_y);

        let turned = |value: f64| f64::from_bits(value.to_bits() ^ flip);
        let [size_1, size_2, size_3]: [f64; 3] = self.amplitudes.into();
        let omega = [turned(size_1 * cn), turned(size_2 * sn), size_3 * dn];
        // L̂ along the renamed axes; the rotation that takes it upright; then the turn about the upright.
        let [l1, l2, l3]: [f64; 3] = std::array::from_fn(|n| self.moments_by_l[n] * omega[n]);
        let (w, i, j) = (1.0 + l3, l2, -l1);
        [c * i - s * j, c * j + s * i, s * w, c * w, omega[0], omega[1], omega[2]]
    }

    fn turning(&self, [i, j, k, w, w1, w2, w3]: [f64; 7]) -> Turning {
        let q = self.attitude * Vector4::new(i, j, k, w);
        Turning {
            world_from_body: UnitQuaternion::new_unchecked(Quaternion::from(q / q.norm())),
            omega_body: self.body_from_renamed * Vector3::new(w1, w2, w3),
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

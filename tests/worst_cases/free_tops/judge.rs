//! Euler's equations and the quaternion's by series of 32 digits.

use crate::long::{Long, long};
use crate::search::worse;
use crate::taylor::System;
use mechanics::euler::Turning;
use nalgebra::UnitQuaternion;

/// A quaternion, scalar first.
pub(super) type Quat = [Long; 4];

pub(super) fn times(a: &Quat, b: &Quat) -> Quat {
    let [aw, ax, ay, az] = *a;
    let [bw, bx, by, bz] = *b;
    [
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by + ay * bw + az * bx - ax * bz,
        aw * bz + az * bw + ax * by - ay * bx,
    ]
}

pub(super) fn unit(q: Quat) -> Quat {
    let length = q.iter().map(|&x| x * x).sum::<Long>().sqrt();
    q.map(|x| x / length)
}

pub(super) fn inverse([w, x, y, z]: Quat) -> Quat {
    [w, -x, -y, -z]
}

/// A quaternion of length one taken so many times.
pub(super) fn power(turn: Quat, count: u64) -> Quat {
    let (mut whole, mut square, mut count) = ([1.0, 0.0, 0.0, 0.0].map(long), turn, count);
    while count > 0 {
        if count % 2 == 1 {
            whole = unit(times(&whole, &square));
        }
        square = unit(times(&square, &square));
        count /= 2;
    }
    whole
}

/// A body, and its state after a time, as the judge knows it: ω along the body's axes, and the attitude relative to
/// that at the start.
pub(super) struct Judge {
    system: System,
    pub(super) start: [Long; 7],
    pub(super) couplings: [Long; 3],
}

impl Judge {
    pub(super) fn new(moments: [f64; 3], omega: [f64; 3]) -> Self {
        let (mut system, [w1, w2, w3, q0, q1, q2, q3]) = System::new();
        let [a, b, c] = moments.map(long);
        let couplings = [(b - c) / a, (c - a) / b, (a - b) / c];
        let products = [(w2, w3), (w3, w1), (w1, w2)].map(|(x, y)| system.product(x, y));
        for ((state, product), coupling) in [w1, w2, w3].into_iter().zip(products).zip(couplings) {
            system.rate(state, &[(coupling, product)]);
        }
        system.turn([q0, q1, q2, q3], [w1, w2, w3]);
        let [x, y, z] = omega.map(long);
        let [zero, one] = [0.0, 1.0].map(long);
        Self { system, start: [x, y, z, one, zero, zero, zero], couplings }
    }

    pub(super) fn after(&self, state: &[Long; 7], time: Long) -> [Long; 7] {
        self.system.sample(state, &[time]).remove(0).try_into().unwrap()
    }

    fn omega_rate(&self, [w1, w2, w3, ..]: &[Long; 7]) -> [Long; 3] {
        let [a, b, c] = self.couplings;
        [a * *w2 * *w3, b * *w3 * *w1, c * *w1 * *w2]
    }

    /// The period to 30 digits from a guess, with the turn of the attitude in it, and how uncertain it is.
    pub(super) fn period(&self, guess: f64) -> (Long, Quat, f64) {
        let mut period = long(guess);
        let mut state = self.after(&self.start, period);
        for _ in 0..2 {
            let rate = self.omega_rate(&state);
            let off = (0..3).map(|n| (state[n] - self.start[n]) * rate[n]).sum::<Long>();
            let late = off / rate.iter().map(|&r| r * r).sum::<Long>();
            period = period - late;
            state = self.after(&state, -late);
        }
        let gap = (0..3).map(|n| (state[n] - self.start[n]).abs().rounded()).fold(0.0, f64::max);
        let [_, _, _, q @ ..] = state;
        let speed = self.omega_rate(&self.start).iter().map(|rate| rate.abs().rounded()).fold(0.0, f64::max);
        (period, unit(q), gap / speed)
    }
}

/// The errors of a state: ω beside the largest, and the angle of the attitude, rad. The judge's attitude is that
/// relative to the start.
pub(super) fn errors(found: &Turning, start: &Turning, truth: &[Long; 7]) -> (f64, f64) {
    let [w1, w2, w3, q @ ..] = *truth;
    let size = start.omega_body.norm();
    let omega =
        [w1, w2, w3].iter().zip(&found.omega_body).map(|(&w, &f)| (w - f).abs().rounded()).fold(0.0, worse);
    let quaternion = |q: &UnitQuaternion<f64>| [q.w, q.i, q.j, q.k].map(long);
    let expected = unit(times(&quaternion(&start.world_from_body), &q));
    let [w, x, y, z] = times(&inverse(expected), &quaternion(&found.world_from_body));
    let off = (x * x + y * y + z * z).sqrt() / w.abs();
    if !found.to_array().iter().all(|number| number.is_finite()) {
        return (f64::INFINITY, f64::INFINITY);
    }
    (if size > 0.0 { omega / size } else { omega }, 2.0 * off.rounded())
}

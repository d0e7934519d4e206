//! Very many turns. The judge follows one period, which turns the body about **L**, and then takes that turn as often
//! as there are periods, in 32 digits.

use super::PROMISE;
use super::bodies::{Motion, attitude, motion, scales};
use super::judge::{Judge, errors, inverse, power, times, unit};
use crate::long::{Long, long};
use crate::search::{Case, keeps_its_promise, worse};
use mechanics::euler::Turning;
use mechanics::free_rotation::{FreeSymmetricTop, FreeTop};
use mechanics::inertia::PrincipalMoments;
use nalgebra::Vector3;

/// What is promised of the period, relative.
const PERIOD: f64 = 4e-16;

/// Up to so many radians the promise holds; beyond, the 32 digits of the rates run out, and a decade costs a digit.
/// Next to the separatrix the period hangs on k'², a small difference of large numbers, and they run out earlier.
const LONG: f64 = 1e15;
const LONG_NEXT_TO_THE_SEPARATRIX: f64 = 1e17;
/// Where states are no longer computed several at once: 2^47 quarter turns of half the angle.
const REACH: f64 = 5e14;

#[test]
fn it_is_followed_to_rounding_for_a_million_billion_radians() {
    let ways = [
        "about the largest, slow",
        "about the largest, fast",
        "about the smallest, slow",
        "about the smallest, fast",
        "beyond reach",
    ];
    keeps_its_promise("long run", 60, &ways, |draw| {
        let motion = motion(draw)?;
        let size = motion.start.omega_body.norm() / motion.rate;
        let guess = motion.top.period()? * motion.rate;
        let quickest = size * motion.judge.couplings.iter().map(|c| c.rounded().abs()).fold(1.0, f64::max);
        if guess * quickest > 60.0 || motion.way.starts_with("symmetric") {
            return None;
        }
        let beyond = draw.below(3) == 0;
        let radians = if beyond { draw.decades(REACH, 100.0 * LONG) } else { draw.decades(1e2, LONG) };
        let time = draw.one_of(&[-1.0, 1.0]) * radians / quickest;
        if (time / motion.rate).abs() > 1e50 {
            return None;
        }
        // What is not known of the period must not count.
        let (period, turn, gap) = motion.judge.period(guess);
        let long_enough = LONG.min(LONG_NEXT_TO_THE_SEPARATRIX * motion.complement);
        let allowed = (radians / long_enough).max(1.0);
        if gap * quickest * time.abs() / guess > 1e-16 * allowed {
            return None;
        }
        let count = (long(time) / period).rounded().floor();
        let [w1, w2, w3, q @ ..] = motion.judge.after(&motion.judge.start, long(time) - period * count);
        let whole = power(if count < 0.0 { inverse(turn) } else { turn }, count.abs() as u64);
        let [q0, q1, q2, q3] = times(&whole, &unit(q));
        let case = motion.case(time, &[w1, w2, w3, q0, q1, q2, q3]);
        let off = period.off(guess);
        let ratio = worse(case.ratio / allowed, off / PERIOD);
        let way = if radians > REACH { "beyond reach" } else { case.way };
        let said = format!("{radians:e} rad, k'² {:e}: {}; period {off:e}", motion.complement, case.said);
        Some(Case { ratio, way, said })
    });
}

#[test]
fn a_symmetric_top_is_followed_to_rounding_for_a_million_billion_radians() {
    keeps_its_promise("symmetric long run", 1500, &["symmetric", "sphere", "beyond reach"], |draw| {
        let ratio = match draw.below(4) {
            0 => draw.beside(1.0),
            1 => draw.beside(2.0).min(2.0),
            _ => draw.decades(1e-8, 2.0),
        };
        let [heavy, rate] = scales(draw);
        let [w1, w2, w3] = std::array::from_fn(|_| draw.signed(1e-12, 1.0));
        let size = f64::hypot(w1, w2).hypot(w3).max(1e-12);
        let radians = draw.decades(1e-3, 100.0 * LONG);
        let time = draw.one_of(&[-1.0, 1.0]) * radians / size;
        if (time / rate).abs() > 1e50 {
            return None;
        }
        // q = turn(L, Λt) turn(3, −σt) and ω goes round 3 with σ, in 32 digits; that this is the motion is judged
        // above.
        let [a, c, x, y, z] = [1.0, ratio, w1, w2, w3].map(long);
        let momentum = [x, y, z * c / a];
        let length = momentum.iter().map(|&l| l * l).sum::<Long>().sqrt();
        let spin = z * (c - a) / a;
        let half = |angle: Long| (angle * 0.5).sin_cos();
        let ((sin, cos), (sin_2, cos_2)) = (half(length * time), half(spin * time));
        let over = if length > long(0.0) { sin / length } else { long(0.0) };
        let about = [cos, momentum[0] * over, momentum[1] * over, momentum[2] * over];
        let [q0, q1, q2, q3] = times(&about, &[cos_2, long(0.0), long(0.0), -sin_2]);
        let (sin, cos) = (spin * time).sin_cos();
        let truth = [x * cos - y * sin, x * sin + y * cos, z, q0, q1, q2, q3];

        let moments = PrincipalMoments::symmetric(heavy, heavy * ratio).ok()?;
        let start = Turning { world_from_body: attitude(draw), omega_body: Vector3::new(w1, w2, w3) * rate };
        let top = FreeSymmetricTop::new(moments, start).ok()?;
        let motion = Motion {
            top: FreeTop::new(moments, start).ok()?,
            start,
            judge: Judge::new([1.0, 1.0, ratio], [w1, w2, w3]),
            way: match (radians > REACH, ratio == 1.0) {
                (true, _) => "beyond reach",
                (false, true) => "sphere",
                (false, false) => "symmetric",
            },
            complement: 1.0,
            rate,
        };
        let case = motion.case(time, &truth);
        // The same top by its own name, and its axis alone.
        let single = top.at(time / rate).ok()?;
        let many = top.sample(&[time / rate; 33]).ok()?;
        let scaled = |turning: &Turning| Turning { omega_body: turning.omega_body / rate, ..*turning };
        let (omega, angle) = errors(&scaled(&single), &scaled(&start), &truth);
        let (omega_of_many, angle_of_many) = errors(&scaled(&many[17]), &scaled(&start), &truth);
        let axis = (top.axis_world(time / rate).ok()? - single.axis_3_world()).norm();
        let worst = [omega, angle, omega_of_many, angle_of_many, axis].into_iter().fold(0.0, worse);
        Some(Case { ratio: worse(case.ratio, worst / PROMISE) / (radians / LONG).max(1.0), ..case })
    });
}

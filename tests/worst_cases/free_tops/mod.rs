//! Free rotation, against Euler's equations and the quaternion's by series of 32 digits.

mod bodies;
mod judge;
mod long_runs;

use self::bodies::{WAYS, motion};
use self::judge::{Judge, errors};
use crate::long::long;
use crate::search::keeps_its_promise;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};

/// What the documentation promises, of the largest angular velocity and in radians.
const PROMISE: f64 = 4e-15;

#[test]
fn any_free_body_is_followed_to_rounding_for_some_turns() {
    keeps_its_promise("free top", 600, &WAYS, |draw| {
        let motion = motion(draw)?;
        let size = (motion.start.omega_body.norm() / motion.rate).max(1e-3);
        // A needle turns about itself far more quickly than ω along its other axes says.
        let quickest =
            size * motion.judge.couplings.iter().map(|c| c.rounded().abs()).fold(1.0, f64::max).min(1e4);
        // A hair from the middle axis the first flip is far away; and in the midst of it not even 32 digits tell when
        // the next one comes.
        let part = if motion.complement < 1e-12 { 0.27 } else { 1.0 };
        let flips = motion.top.period().map(|period| period * motion.rate).filter(|p| *p * quickest < 800.0);
        let time = match (draw.below(30), flips) {
            (0, _) => 0.0,
            (1..10, Some(period)) => period * part * draw.between(-1.0, 1.0),
            _ => draw.signed(1e-3, 30.0) / quickest,
        };
        if (time / motion.rate).abs() > 1e50 {
            return None;
        }
        let truth = motion.judge.after(&motion.judge.start, long(time));
        Some(motion.case(time, &truth))
    });
}

#[test]
fn the_worst_that_was_found_is_mended() {
    let found: [([f64; 3], [f64; 3], f64); 3] = [
        // Two moments that nearly agree: the sine of the argument is small there and has to keep its digits. The
        // attitude was off by 4e-11.
        (
            [1.0000000000006035, 0.7659721327542592, 1.0],
            [-1.0, -1.6349954481148863e-6, 0.0],
            0.5020355012055109,
        ),
        // Needles next to the middle axis: the argument is 26 and 12 at the start, and its rounding cost 1e-14.
        (
            [9.623438046429504e-28, 2.1390545818855778e-23, 2.1391508162660422e-23],
            [-9.876158190518929, 1099511627776.0, 2.3938295630435393e-18],
            -2.362199016458602e-11,
        ),
        (
            [6.921898572894947e-15, 6.922451050687343e-15, 5.524777923966799e-19],
            [-1.2037062152420224e-35, -2.9843292388516674e-40, -6.4756391443773326e-43],
            9.971437968587083e35,
        ),
    ];
    for (moments, omega, time) in found {
        let [i1, i2, i3] = moments;
        // In units in which ω is about one; a power of two changes no digit.
        let rate = 2_f64.powi(omega.iter().map(|w| w.abs()).fold(0.0, f64::max).log2() as i32);
        let scaled = |omega_body: Vector3<f64>| omega_body / rate;
        let mut start = Turning { world_from_body: UnitQuaternion::identity(), omega_body: omega.into() };
        let mut end =
            FreeTop::new(PrincipalMoments::new(i1, i2, i3).unwrap(), start).unwrap().at(time).unwrap();
        let judge = Judge::new(moments, omega.map(|w| w / rate));
        let truth = judge.after(&judge.start, long(time * rate));
        (start.omega_body, end.omega_body) = (scaled(start.omega_body), scaled(end.omega_body));
        let (omega, angle) = errors(&end, &start, &truth);
        assert!(omega < PROMISE && angle < PROMISE, "{moments:?}: {omega:e} {angle:e}");
    }
}

#[test]
fn the_flip_comes_on_time_from_however_small_a_hair() {
    // At the start the argument is near K, two hundred for a hair of 1e-90. Rounded to one number it would make the
    // flip late by 2e-14.
    let moments = [1.0, 2.0, 2.7];
    for hair in [1e-10, 1e-30, 1e-50, 3e-70, 1e-90] {
        let omega = [hair, 1.0, 0.37 * hair].map(|w| w * 2_f64.powi(160));
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body: omega.into() };
        let [i1, i2, i3] = moments;
        let top = FreeTop::new(PrincipalMoments::new(i1, i2, i3).unwrap(), start).unwrap();
        let scale =
            |turning: Turning| Turning { omega_body: turning.omega_body / 2_f64.powi(160), ..turning };
        let judge = Judge::new(moments, [hair, 1.0, 0.37 * hair]);
        for late in [-1.5, -0.5, 0.0, 0.5, 1.5] {
            let time = 0.25 * top.period().unwrap() + late / 2_f64.powi(160);
            let truth = judge.after(&judge.start, long(time * 2_f64.powi(160)));
            let (omega, angle) = errors(&scale(top.at(time).unwrap()), &scale(start), &truth);
            assert!(omega < PROMISE && angle < PROMISE, "{hair:e}, {late}: {omega:e} {angle:e}");
        }
    }
}

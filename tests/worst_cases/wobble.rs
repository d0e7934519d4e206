//! The rolling wheel at any time, from half a wobble.

use crate::long::long;
use crate::rolling::{Disc, numbers, parameters, placed, rolling};
use crate::search::{Case, Draw, keeps_its_promise};
use mechanics::integrate::Taylor;
use mechanics::nalgebra::Complex;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::{Wheel, Wobble};
use mechanics::{Error, Rule};
use std::f64::consts::FRAC_PI_2;

/// A start, and what kind.
fn start(draw: &mut Draw<'_>, wheel: &Wheel) -> Option<(Rolling, &'static str)> {
    let DiskParameters { radius, moments, gravity, .. } = wheel.parameters();
    let rate = (gravity / radius).sqrt();
    let any = |draw: &mut Draw<'_>| Rolling {
        tilt: FRAC_PI_2 + draw.between(-1.4, 1.4),
        omega_1: rate * draw.signed(1e-3, 3.0),
        omega_2: rate * draw.signed(1e-3, 3.0),
        omega_3: rate * draw.signed(1e-3, 10.0),
        ..Rolling::UPRIGHT
    };
    let (state, way) = match draw.below(5) {
        0 => (any(draw), "anything"),
        1 => (Rolling { omega_1: 0.0, ..any(draw) }, "from a turn of the lean"),
        2 => {
            let steady = wheel.steady(draw.between(-1.4, 1.4), radius * draw.signed(1e-2, 10.0)).ok()?;
            let pushed = rate * draw.decades(1e-9, 1e-1);
            (Rolling { omega_1: pushed, ..steady.state() }, "near a steady motion")
        }
        3 => {
            let drop = Rolling {
                tilt: draw.decades(1e-2, 1.0),
                omega_1: rate * draw.signed(1e-3, 0.3),
                omega_2: rate * draw.signed(1e-7, 1e-2),
                omega_3: rate * draw.signed(1e-6, 1e-3),
                ..any(draw)
            };
            (drop, "nearly flat on the way")
        }
        _ => {
            // Below it an upright wheel falls.
            let MomentFactors { transverse, axial } = moments;
            let critical = (transverse / ((1.0 + axial) * axial)).sqrt();
            let push = |draw: &mut Draw<'_>| draw.signed(1e-12, 1e-2);
            let upright = Rolling {
                tilt: FRAC_PI_2 - push(draw),
                omega_1: rate * push(draw),
                omega_2: rate * push(draw),
                omega_3: rate * draw.beside(critical),
                ..any(draw)
            };
            (upright, "all but upright")
        }
    };
    Some((placed(draw, radius, state), way))
}

fn wobble(wheel: &Wheel, start: Rolling, tolerance: f64) -> Result<Wobble, Error> {
    wheel.wobble(start, &Taylor::new(tolerance).expect("a tolerance"))
}

#[test]
fn a_wobble_is_as_good_as_its_start_and_its_time() {
    let ways = [
        "all but upright",
        "anything",
        "from a turn of the lean",
        "near a steady motion",
        "nearly flat on the way",
    ];
    keeps_its_promise("wobble", 50, &ways, |draw| {
        let parameters = parameters(draw, 1e-4);
        let wheel = Wheel::new(parameters).ok()?;
        let rate = (parameters.gravity / parameters.radius).sqrt();
        let (start, way) = start(draw, &wheel)?;
        if start.omega_2 == 0.0 && start.omega_3 == 0.0 {
            return None; // it falls flat
        }
        let tolerance = if draw.below(2) == 0 { 1e-16 } else { draw.decades(1e-16, 1e-4) };
        let wobble = match wobble(&wheel, start, tolerance) {
            Ok(wobble) => wobble,
            Err(Error::Quantity(refused))
                if matches!(refused.rule, Rule::Because(_)) && way != "anything" =>
            {
                return None; // steady
            }
            Err(error) => {
                let said = format!("{error}: {parameters:?}, {start:?}");
                return Some(Case { ratio: f64::INFINITY, way, said });
            }
        };
        let period = wobble.period();
        if period * rate > 100.0 {
            return None; // too far for the judge
        }
        let part = match draw.below(4) {
            0 => 0.5 * draw.below(5) as f64 - 1.0,
            1 => draw.beside(0.5),
            _ => draw.between(-2.0, 2.0),
        };
        let time = part * period;
        let disc = Disc::new(&parameters, 0.0);
        let ours = wobble.at(time).ok()?;
        let judged = disc.worst_part(&parameters, [&start, &ours], time, tolerance, false);
        if judged.is_none() && tolerance > f64::EPSILON {
            return None; // with another start it falls flat
        }
        let (ratio, number) = judged.expect("the judge follows it");
        let said = format!(
            "tolerance {tolerance:?}, {parameters:?}, {start:?}, t {time:?} of {period:?}: {ours:?}, number {number}"
        );
        Some(Case { ratio, way, said })
    });
}

#[test]
fn a_loose_tolerance_is_kept_where_a_wheel_is_about_to_get_up_again() {
    // Half a wobble on it lies flat for a moment, which the tolerance does not tell.
    let (transverse, axial) = (0.004_641_761_168_695_769_5, 5.713_850_315_720_573e-8);
    let moments = MomentFactors { transverse, axial };
    let parameters = DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 };
    let start = Rolling {
        tilt: 0.212_474_084_228_909_12,
        omega_1: 0.0,
        omega_2: -4.051_957_908_866_689_3e-7,
        omega_3: 8.839_238_215_916_064e-5,
        ..Rolling::UPRIGHT
    };
    let wheel = Wheel::new(parameters).expect("a wheel");
    for tolerance in [1e-4, 1e-6, 1e-9, 1e-16] {
        let wobble = wobble(&wheel, start, tolerance).unwrap();
        for part in [0.4, 0.5, 0.6] {
            let time = part * wobble.period();
            let ours = wobble.at(time).unwrap();
            let disc = Disc::new(&parameters, 0.0);
            let judged = disc.worst_part(&parameters, [&start, &ours], time, tolerance, false);
            let (ratio, number) = judged.expect("a motion");
            assert!(
                ratio < 1.0,
                "{tolerance:e}, {part}: {ratio} of the promise in number {number}: {ours:?}"
            );
        }
    }
}

#[test]
fn a_whirl_still_to_come_costs_nothing() {
    // Half a wobble on, which is before the wheel whirls round by 500 rad: the whirl behind it and the wobble ahead
    // cancelled, and left their rounding.
    let wheel = flat(0.000_295_951_263_879_914_37);
    let start = Rolling {
        tilt: FRAC_PI_2 - 1.557_474_623_397_495_9,
        omega_1: -0.022_301_885_998_349_98,
        omega_2: 0.001_447_823_044_165_518,
        omega_3: 1.825_669_971_365_197e-5,
        heading: 1.967_423_880_494_653_3,
        roll_angle: -0.192_582_809_537_713_56,
        centre: Complex::new(-2.555_215_467_618_634, -1.586_187_026_037_724_2),
    };
    let wobble = wobble(&wheel, start, 1e-16).unwrap();
    assert!(wobble.heading_advance() > 250.0);
    let disc = Disc::new(&wheel.parameters(), 0.0);
    for part in [0.1, 0.3, 0.5] {
        let time = part * wobble.period();
        let truth = rolling(&disc.motion(&numbers(&start, 1.0), &[long(time)]).expect("a motion")[0]);
        for (truth, found) in truth.into_iter().zip(wobble.at(time).unwrap().to_array()) {
            assert!((truth - found).abs().rounded() < 2e-15, "{part}: {found} and {truth:?}");
        }
    }
}

/// A flat wheel of mass, radius and gravity one.
fn flat(k: f64) -> Wheel {
    let moments = MomentFactors::flat(k);
    Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 }).expect("a wheel")
}

/// A wheel let go upright with hardly a turn: at a tilt of 1e-13 or less, some sixteen √(a/g) later, a step is shorter
/// than the last digit of the time.
fn falling(omega_2: f64, lean: f64) -> (Wheel, Rolling) {
    let (tilt, omega_1) = (FRAC_PI_2 - lean, 2.971_545_220_354_780_6e-7);
    (flat(0.000_284_465_837_554_280_46), Rolling { tilt, omega_1, omega_2, ..Rolling::UPRIGHT })
}

#[test]
fn a_wheel_that_falls_from_upright_goes_through_steps_shorter_than_the_rounding_of_the_time() {
    let (wheel, start) = falling(1e-12, 1.430_521_111_712_536_7e-12);
    let wobble = wobble(&wheel, start, 1e-16).unwrap();
    // The whirl is that of the limit, and the wheel gets up again with the energy with which it fell.
    let times: Vec<f64> = (0..2000).map(|n| wobble.period() * f64::from(n) / 2000.0).collect();
    let energy = wheel.energy(&start);
    let states = wobble.sample(&times).unwrap();
    for state in &states {
        let change = (wheel.energy(state) / energy - 1.0).abs();
        assert!(state.tilt.sin() < 1e-9 || change < 1e-9, "{state:?}");
    }
    let turned = states.windows(2).map(|pair| (pair[1].heading - pair[0].heading).abs()).fold(0.0, f64::max);
    assert!((turned / wheel.near_flat_turn() - 1.0).abs() < 1e-8, "{turned} of {}", wheel.near_flat_turn());
}

#[test]
fn within_a_whirl_shorter_than_the_rounding_of_the_time_the_motion_keeps_its_energy() {
    let mut random = fastrand::Rng::with_seed(16);
    for _ in 0..40 {
        let (wheel, start) = falling(2e-15, 1e-9 * random.f64());
        let wobble = wobble(&wheel, start, 1e-16).unwrap();
        let (mut before, mut after) = (10.0, 0.5 * wobble.period());
        assert!(wobble.at(before).unwrap().omega_1 > 0.0 && wobble.at(after).unwrap().omega_1 < 0.0);
        while 0.5 * (before + after) > before && 0.5 * (before + after) < after {
            let middle = 0.5 * (before + after);
            if wobble.at(middle).unwrap().omega_1 > 0.0 { before = middle } else { after = middle }
        }
        // These two times lie next to each other, with the whirl in between or at one of them.
        for time in [before, after] {
            let state = wobble.at(time).unwrap();
            let transverse = wheel.parameters().moments.transverse;
            let kinetic = state.omega_1.powi(2) + transverse * state.omega_2.powi(2);
            assert!(kinetic < 2.1, "{time}: {state:?}");
        }
    }
}

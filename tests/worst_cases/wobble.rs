//! The rolling wheel at any time, from half a wobble.

use crate::long::{Long, PI, long};
use crate::rolling::{Disc, Numbers};
use crate::search::{Case, Draw, search};
use mechanics::scenes::rolling_wheel::{NoWobble, Rolling, Wheel};
use std::f64::consts::FRAC_PI_2;

/// Units in the last place, and how many times what such a unit makes of start and time; for a looser tolerance in its place.
const PROMISE: f64 = 30.0;

/// A wheel, and numbers in its units √(g/a) and a.
struct Units {
    wheel: Wheel,
    radius: f64,
    rate: f64,
}

fn units(draw: &mut Draw<'_>) -> Option<Units> {
    let k = if draw.below(2) == 0 { draw.one_of(&[0.5, 1.0]) } else { draw.decades(1e-4, 1.0) };
    let (radius, gravity) =
        if draw.below(2) == 0 { (1.0, 1.0) } else { (draw.decades(1e-2, 1e2), draw.decades(1e-1, 1e3)) };
    let wheel = Wheel::new(1.0, radius, k, gravity).ok()?;
    Some(Units { wheel, radius, rate: (gravity / radius).sqrt() })
}

/// A start, and what kind.
fn start(draw: &mut Draw<'_>, units: &Units) -> Option<(Rolling, &'static str)> {
    let rate = units.rate;
    let any = |draw: &mut Draw<'_>| Rolling {
        lean: draw.between(-1.4, 1.4),
        lean_rate: rate * draw.signed(1e-3, 3.0),
        across: rate * draw.signed(1e-3, 3.0),
        along: rate * draw.signed(1e-3, 10.0),
        heading: 0.0,
        spin: 0.0,
        centre: [0.0; 2],
    };
    let (state, way) = match draw.below(5) {
        0 => (any(draw), "anything"),
        1 => (Rolling { lean_rate: 0.0, ..any(draw) }, "from a turn of the lean"),
        2 => {
            let steady =
                units.wheel.steady(draw.between(-1.4, 1.4), units.radius * draw.signed(1e-2, 10.0)).ok()?;
            let pushed = rate * draw.decades(1e-9, 1e-1);
            (Rolling { lean_rate: pushed, ..steady.state() }, "near a steady motion")
        }
        3 => {
            let drop = Rolling {
                lean: FRAC_PI_2 - draw.decades(1e-2, 1.0),
                lean_rate: rate * draw.signed(1e-3, 0.3),
                across: rate * draw.signed(1e-7, 1e-2),
                along: rate * draw.signed(1e-6, 1e-3),
                ..any(draw)
            };
            (drop, "nearly flat on the way")
        }
        _ => {
            let critical = (2.0 * (1.0 + units.wheel.factor())).sqrt().recip(); // below it an upright wheel falls
            let push = |draw: &mut Draw<'_>| draw.signed(1e-12, 1e-2);
            let upright = Rolling {
                lean: push(draw),
                lean_rate: rate * push(draw),
                across: rate * push(draw),
                along: rate * draw.beside(critical),
                ..any(draw)
            };
            (upright, "all but upright")
        }
    };
    let placed = Rolling {
        heading: draw.between(-4.0, 4.0),
        spin: draw.between(-4.0, 4.0),
        centre: [0, 1].map(|_| units.radius * draw.between(-3.0, 3.0)),
        ..state
    };
    Some((placed, way))
}

/// The disc's numbers of a wheel's start. Axes 1 and 3 are the other way round.
fn numbers(wheel: &Wheel, start: &Rolling) -> Numbers {
    let half = PI * 0.5;
    let ((s, c), lean) = (long(start.heading).sin_cos(), long(start.lean));
    let out = lean.sin_cos().0;
    let [x, y] = start.centre.map(|x| long(x) / wheel.radius());
    [
        half - lean,
        -long(start.lean_rate),
        long(start.across),
        -long(start.along),
        long(start.heading) + PI,
        -long(start.spin),
        x - s * out,
        y + c * out,
    ]
}

/// And back: the numbers of [`Rolling`], the centre over the radius.
fn rolling(n: &Numbers) -> [Long; 8] {
    let (s, c) = n[4].sin_cos();
    let cos = n[0].sin_cos().1;
    [PI * 0.5 - n[0], -n[1], n[2], -n[3], n[4] - PI, -n[5], n[6] - s * cos, n[7] + c * cos]
}

#[test]
fn a_wobble_is_as_good_as_its_start_and_its_time() {
    let worst = search("wobble", 30, |draw| {
        let units = units(draw)?;
        let (start, way) = start(draw, &units)?;
        let Units { wheel, radius, rate } = units;
        if start.across == 0.0 && start.along == 0.0 {
            return None; // it falls flat
        }
        let tolerance = if draw.below(2) == 0 { 1e-16 } else { draw.decades(1e-16, 1e-4) };
        let wobble = match wheel.wobble(start, tolerance) {
            Ok(wobble) => wobble,
            Err(NoWobble::Steady) if way != "anything" => return None,
            Err(error) => {
                return Some(Case {
                    ratio: f64::INFINITY,
                    way,
                    said: format!("{error}: k {}, {start:?}", wheel.factor()),
                });
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
        let disc = Disc {
            k: wheel.factor(),
            gravity_over_radius: long(wheel.gravity()) / wheel.radius(),
            film: long(0.0),
        };
        let (truth, change) =
            disc.with_conditioning(&numbers(&wheel, &start), time, [0.0; 4]).expect("the judge follows it");
        let truth = rolling(&truth);
        let ours = wobble.at(time).ok()?;
        let given = start.to_array();
        let scale = [1.0, rate, rate, rate, 1.0, 1.0, radius, radius];
        let turned = (truth[4] - start.heading).abs().rounded();
        let way_gone = change[6].max(change[7]) + change[4];
        let mut worst = (0.0, 0);
        for (i, found) in ours.to_array().into_iter().enumerate() {
            let unit = scale[i];
            let true_value = if i < 6 { truth[i] } else { truth[i] * radius };
            let size = unit.max(given[i].abs()).max(true_value.abs().rounded());
            // A place has the rounding of the heading that led there.
            let (size, change) =
                if i < 6 { (size, change[i]) } else { (size + radius * turned, radius * way_gone) };
            let allowed = (size + change / f64::EPSILON) * tolerance.max(f64::EPSILON);
            let ratio = (true_value - found).abs().rounded() / allowed;
            if ratio.is_nan() || ratio > worst.0 {
                worst = (ratio, i);
            }
        }
        Some(Case {
            ratio: worst.0 / PROMISE,
            way,
            said: format!(
                "tolerance {tolerance:?}, k {:?}, a {radius:?}, g {:?}, {start:?}, t {time:?} of {period:?}: {ours:?}, number {}",
                wheel.factor(),
                wheel.gravity(),
                worst.1
            ),
        })
    });
    worst.keeps_its_promise(&[
        "all but upright",
        "anything",
        "from a turn of the lean",
        "near a steady motion",
        "nearly flat on the way",
    ]);
}

#[test]
fn a_whirl_still_to_come_costs_nothing() {
    // Half a wobble on, which is before the wheel whirls round by 500 rad: the whirl behind it and the wobble ahead cancelled, and left
    // their rounding.
    let wheel = Wheel::new(1.0, 1.0, 0.000_295_951_263_879_914_37, 1.0).unwrap();
    let start = Rolling {
        lean: 1.557_474_623_397_495_9,
        lean_rate: -0.022_301_885_998_349_98,
        across: 0.001_447_823_044_165_518,
        along: 1.825_669_971_365_197e-5,
        heading: 1.967_423_880_494_653_3,
        spin: -0.192_582_809_537_713_56,
        centre: [-2.555_215_467_618_634, -1.586_187_026_037_724_2],
    };
    let wobble = wheel.wobble(start, 1e-16).unwrap();
    assert!(wobble.heading_advance() > 250.0);
    let disc = Disc { k: wheel.factor(), gravity_over_radius: long(1.0), film: long(0.0) };
    for part in [0.1, 0.3, 0.5] {
        let time = part * wobble.period();
        let truth = rolling(&disc.motion(&numbers(&wheel, &start), &[long(time)]).expect("a motion")[0]);
        for (truth, found) in truth.into_iter().zip(wobble.at(time).unwrap().to_array()) {
            assert!((truth - found).abs().rounded() < 2e-15, "{part}: {found} and {truth:?}");
        }
    }
}

/// A wheel let go upright with hardly a turn: at a tilt of 1e-13 or less, some sixteen √(a/g) later, a step is shorter than the last digit
/// of the time.
fn falling(across: f64, lean: f64) -> (Wheel, Rolling) {
    let wheel = Wheel::new(1.0, 1.0, 0.000_284_465_837_554_280_46, 1.0).expect("a wheel");
    let lean_rate = 2.971_545_220_354_780_6e-7;
    (wheel, Rolling { lean, lean_rate, across, along: 0.0, heading: 0.0, spin: 0.0, centre: [0.0; 2] })
}

#[test]
fn a_wheel_that_falls_from_upright_goes_through_steps_shorter_than_the_rounding_of_the_time() {
    let (wheel, start) = falling(1e-12, 1.430_521_111_712_536_7e-12);
    let wobble = wheel.wobble(start, 1e-16).unwrap();
    // The whirl is that of the limit, and the wheel gets up again with the energy with which it fell.
    let times: Vec<f64> = (0..2000).map(|n| wobble.period() * f64::from(n) / 2000.0).collect();
    let energy = wheel.energy(&start);
    let frames = wobble.sample(&times).unwrap();
    for frame in &frames {
        let change = (wheel.energy(frame) / energy - 1.0).abs();
        assert!(frame.lean.cos() < 1e-9 || change < 1e-9, "{frame:?}");
    }
    let turned = frames.windows(2).map(|pair| (pair[1].heading - pair[0].heading).abs()).fold(0.0, f64::max);
    assert!((turned / wheel.near_flat_turn() - 1.0).abs() < 1e-8, "{turned} of {}", wheel.near_flat_turn());
}

#[test]
fn within_a_whirl_shorter_than_the_rounding_of_the_time_the_motion_keeps_its_energy() {
    let mut random = fastrand::Rng::with_seed(16);
    for _ in 0..40 {
        let (wheel, start) = falling(2e-15, 1e-9 * random.f64());
        let wobble = wheel.wobble(start, 1e-16).unwrap();
        let (mut before, mut after) = (10.0, 0.5 * wobble.period());
        assert!(wobble.at(before).unwrap().lean_rate > 0.0 && wobble.at(after).unwrap().lean_rate < 0.0);
        while 0.5 * (before + after) > before && 0.5 * (before + after) < after {
            let middle = 0.5 * (before + after);
            if wobble.at(middle).unwrap().lean_rate > 0.0 { before = middle } else { after = middle }
        }
        // These two times lie next to each other, with the whirl in between or at one of them.
        for time in [before, after] {
            let frame = wobble.at(time).unwrap();
            let kinetic = frame.lean_rate.powi(2) + 0.5 * wheel.factor() * frame.across.powi(2);
            assert!(kinetic < 2.1, "{time}: {frame:?}");
        }
    }
}

//! Which circles are stable, and how a disc falls: judged by the whole body with its force at the contact, and by
//! eigenvalues of its equations.

use super::whole_body::{State, axle, frame, placed, solve};
use super::{GRAVITY, MASS, RADIUS, parameters, wheel};
use crate::common::any;
use approx::assert_relative_eq;
use mechanics::integrate::{Dop853, Taylor};
use mechanics::rolling::{MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::{InvalidQuantity, Rule};
use nalgebra::{Complex, Matrix4, Vector3, Vector4};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Disc, hoop, a ball with an edge, weights far out on the axle, and nearly all mass in two beads on it.
const MOMENTS: [MomentFactors; 5] = [
    MomentFactors::DISK,
    MomentFactors::HOOP,
    MomentFactors { transverse: 0.4, axial: 0.4 },
    MomentFactors { transverse: 2.0, axial: 0.5 },
    MomentFactors { transverse: 0.1, axial: 0.002 },
];

/// The rates of lean, lean rate, q and n, from the forces on the whole body.
fn rates(moments: MomentFactors, [lean, lean_rate, q, n]: [f64; 4]) -> Vector4<f64> {
    let state = placed(lean, 0.0, [lean_rate, q, n], Complex::new(0.0, 0.0));
    let (rates, _) = solve(moments, &state);
    let axes = frame(lean, 0.0);
    let omega = axes * Vector3::new(lean_rate, q, n);
    let axes_turn = axes.column(0) * lean_rate + Vector3::z() * (q / lean.cos());
    let found = axes.transpose() * (Vector3::from_column_slice(&rates[10..13]) - axes_turn.cross(&omega));
    Vector4::new(lean_rate, found.x, found.y, found.z)
}

/// The square of the rate Ω at which the forces balance: the lean's acceleration is linear in it.
fn balance(moments: MomentFactors, lean: f64, b: f64) -> f64 {
    let acceleration = |square: f64| {
        let turn = square.sqrt();
        rates(moments, [lean, 0.0, turn * lean.cos(), turn * b / RADIUS])[1]
    };
    let [none, one] = [0.0, 1.0].map(acceleration);
    none / (none - one)
}

/// The sum of the squares of the four eigenvalues of the motions near a steady one, over Ω²: two of them are zero, for
/// the two constants, so it is twice the square of the others.
fn eigenvalues(moments: MomentFactors, lean: f64, b: f64) -> f64 {
    let square = balance(moments, lean, b);
    let turn = square.sqrt();
    let steady = [lean, 0.0, turn * lean.cos(), turn * b / RADIUS];
    let step = 1e-4;
    let jacobian = Matrix4::from_columns(&std::array::from_fn::<_, 4, _>(|k| {
        let [more, less] = [step, -step].map(|step| {
            let mut state = steady;
            state[k] += step * if k == 0 { 1.0 } else { turn };
            rates(moments, state)
        });
        (more - less) / (2.0 * step * if k == 0 { 1.0 } else { turn })
    }));
    (jacobian * jacobian).trace() / square
}

/// Halves between a place where something holds and one where it does not.
fn border(mut holds: f64, mut fails: f64, is_so: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..45 {
        let middle = 0.5 * (holds + fails);
        *(if is_so(middle) { &mut holds } else { &mut fails }) = middle;
    }
    0.5 * (holds + fails)
}

fn of(moments: MomentFactors) -> Wheel {
    Wheel::new(parameters(moments)).expect("a wheel")
}

#[test]
fn the_tongue_ends_where_no_circle_has_a_growing_eigenvalue() {
    for moments in MOMENTS {
        // The circle with the largest square, by golden section in the logarithm of b.
        let worst = |lean: f64| {
            let value = |logarithm: f64| eigenvalues(moments, lean, RADIUS * logarithm.exp());
            let (mut low, mut high, golden) = (-4.0, 6.0, 0.5 * (5_f64.sqrt() - 1.0));
            for _ in 0..60 {
                let [left, right] = [high - golden * (high - low), low + golden * (high - low)];
                if value(left) > value(right) { high = right } else { low = left }
            }
            value(0.5 * (low + high))
        };
        let tip = border(0.2, 0.9, |lean| worst(lean) > 0.0);
        assert_relative_eq!(of(moments).safe_lean(), tip, max_relative = 1e-6);
        assert!(of(moments).unstable_circles(tip + 1e-5).unwrap().is_none());
        // Above it also a centre beyond the axis is stable, down to the bound.
        for lean in [tip + 0.01, 0.5, 0.7, FRAC_PI_2 / 2.0, 0.9, 1.2, 1.5] {
            let bound = -moments.transverse * RADIUS * lean.sin() / (1.0 + moments.axial);
            if lean > tip {
                for part in [0.99, 0.9, 0.5, 0.1, -0.1, -1.0, -10.0, -100.0] {
                    assert!(eigenvalues(moments, lean, part * bound) < 0.0, "{moments:?}, {lean}, {part}");
                }
            }
        }
    }
}

#[test]
fn the_edges_of_the_tongue_are_where_an_eigenvalue_begins_to_grow() {
    for moments in MOMENTS {
        let wheel = of(moments);
        for part in [0.2, 0.6, 0.9, 0.99] {
            let lean = part * wheel.safe_lean();
            let [inner, outer] = wheel.unstable_circles(lean).unwrap().expect("a tongue");
            let middle = (inner * outer).sqrt();
            let grows = |b: f64| eigenvalues(moments, lean, b) > 0.0;
            assert_relative_eq!(border(middle, 0.0, grows), inner, max_relative = 1e-5);
            assert_relative_eq!(border(middle, 10.0 * outer, grows), outer, max_relative = 1e-5);
            let stable = [0.999, 1.001].map(|part| wheel.steady(lean, part * inner).unwrap().is_stable());
            assert_eq!(stable, [true, false]);
        }
    }
}

#[test]
fn disc_and_hoop_have_tips_with_roots_of_five_and_of_two() {
    // eq:tongue-tip
    for (k, square, degrees) in
        [(0.5, (24.0 - 9.0 * 5_f64.sqrt()) / 38.0, 18.624), (1.0, (5.0 - 3.0 * 2_f64.sqrt()) / 7.0, 19.204)]
    {
        let tip = wheel(k).safe_lean();
        assert_relative_eq!(tip.sin().powi(2), square, max_relative = 1e-13);
        assert!((tip.to_degrees() - degrees).abs() < 5e-4);
        let unstable = |lean: f64| {
            let circles = (1..=4000).map(|n| wheel(k).steady(lean, 1e-3 * RADIUS * f64::from(n)).unwrap());
            circles.filter(|steady| !steady.is_stable()).count()
        };
        assert_eq!(unstable(tip + 1e-5), 0);
        assert!(unstable(tip - 1e-5) > 0);
    }
}

#[test]
fn the_tip_lies_between_that_of_a_point_and_half_a_right_angle() {
    let least = ((3.0 - 6_f64.sqrt()) / 6.0).sqrt().asin();
    let mut random = fastrand::Rng::with_seed(18);
    let (mut lowest, mut highest) = (f64::INFINITY, 0.0_f64);
    for _ in 0..20_000 {
        let transverse = 10_f64.powf(14.0 * random.f64() - 10.0);
        let axial = transverse * 2.0 * 10_f64.powf(-9.0 * random.f64().powi(2));
        let tip = of(MomentFactors { transverse, axial }).safe_lean();
        (lowest, highest) = (lowest.min(tip), highest.max(tip));
    }
    assert!(lowest >= least && lowest < least + 1e-3, "{}", lowest.to_degrees());
    assert!(highest <= 0.25 * PI && highest > 0.25 * PI - 1e-2, "{}", highest.to_degrees());
}

#[test]
fn the_mouth_of_the_tongue_has_the_speeds_of_the_upright_wheel() {
    for moments in MOMENTS {
        let MomentFactors { transverse: i1, axial: i3 } = moments;
        let (wheel, lean) = (of(moments), 1e-5);
        let [inner, outer] = wheel.unstable_circles(lean).unwrap().unwrap();
        let turn = wheel.steady(lean, inner).unwrap().turn_rate();
        assert_relative_eq!(turn * turn * RADIUS / GRAVITY, 1.0 / (1.0 + i1), max_relative = 1e-6);
        let spin = wheel.steady(lean, outer).unwrap().true_spin();
        assert_relative_eq!(spin * spin * RADIUS / GRAVITY, i1 / (i3 * (1.0 + i3)), max_relative = 1e-6);
    }
}

/// The lean, and the support in weights, while the whole body falls from rest at a small lean, until it is flat or its
/// support is used up.
fn fall(moments: MomentFactors) -> Vec<(f64, f64)> {
    let first: f64 = 1e-3;
    let start = placed(first, 0.0, [0.0; 3], Complex::new(0.0, 0.0));
    let times: Vec<f64> = (1..=4000).map(|k| 1e-3 * f64::from(k)).collect();
    let solver = Dop853::new(1e-11).unwrap();
    let mut state = start;
    let mut path = Vec::new();
    for pair in times.windows(2) {
        let end = solver.solve(any(|_, state: &State| solve(moments, state).0), pair[0], state, pair[1]);
        state = end.unwrap().state;
        let lean = (-axle(&state).z).asin();
        path.push((lean, solve(moments, &state).1.z / (MASS * GRAVITY)));
        if lean > 1.45 || path[path.len() - 1].1 < 0.0 {
            break;
        }
    }
    path
}

#[test]
fn a_wheel_that_falls_from_upright_leaves_the_table_if_its_moment_is_below_a_third() {
    for i1 in [0.05_f64, 0.25, 0.3] {
        let path = fall(MomentFactors::flat(2.0 * i1));
        let &[.., (before, held), (after, pulled)] = &path[..] else { panic!("no fall") };
        assert!(held > 0.0 && pulled < 0.0, "{i1}: {held}, {pulled}");
        let lifts = before + (after - before) * held / (held - pulled);
        let expected = ((1.0 + (1.0 - 3.0 * i1).sqrt()) / 3.0).acos(); // eq:lift-off
        assert!((lifts - expected).abs() < 5e-5, "{i1}: {lifts}, {expected}");
    }
    let least = fall(MomentFactors::HOOP).into_iter().map(|(_, support)| support).fold(1.0, f64::min);
    assert_relative_eq!(least, 1.0 / 9.0, max_relative = 1e-4);
}

#[test]
fn the_contact_of_a_disc_that_is_dropped_almost_flat_runs_round_as_the_whole_body_has_it() {
    let unit = (RADIUS / GRAVITY).sqrt();
    for (k, q, near) in [(0.5, 0.05, 0.08), (1.0, 0.05, 0.08), (0.5, 0.005, 0.02), (1.0, 0.005, 0.02)] {
        let tilt = 0.1;
        let start = Rolling { tilt, omega_2: q / unit, ..Rolling::UPRIGHT };
        let wobble = wheel(k).wobble(start, &Taylor::new(1e-15).unwrap()).unwrap();
        let times: Vec<f64> = (1..=20_000).map(|n| wobble.period() * f64::from(n) / 20_000.0).collect();
        let whole = placed(FRAC_PI_2 - tilt, 0.0, [0.0, q / unit, 0.0], Complex::new(0.0, 0.0));
        let moments = MomentFactors::flat(k);
        let solver = Dop853::with_tolerances(1e-12, 1e-15).unwrap();
        let (path, _) = solver.sample(any(|_, s: &State| solve(moments, s).0), 0.0, whole, &times).unwrap();
        // The azimuth of the axle, which the contact follows.
        let mut run = 0.0;
        let mut last = FRAC_PI_2;
        for state in &path {
            let up = -axle(state);
            let now = up.y.atan2(up.x);
            run += (now - last + PI).rem_euclid(TAU) - PI;
            last = now;
        }
        assert_relative_eq!(run, wobble.heading_advance(), epsilon = 1e-5);
        assert_relative_eq!(run, wheel(k).near_flat_turn(), max_relative = near);
        assert!(
            (run / wheel(k).near_flat_turn()) > 1.0 && run / wheel(k).near_flat_turn() < 2.0 / 3_f64.sqrt()
        );
    }
}

#[test]
fn a_lean_that_is_none_has_no_unstable_circles() {
    for lean in [0.0, -0.1, FRAC_PI_2, f64::NAN] {
        assert!(matches!(wheel(0.5).unstable_circles(lean), Err(InvalidQuantity { quantity: "lean", .. })));
    }
    let upright = wheel(0.5).unstable_circles(0.0).unwrap_err();
    assert!(matches!(upright.rule, Rule::Positive), "{upright}");
}

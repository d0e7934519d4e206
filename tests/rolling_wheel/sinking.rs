//! A flywheel in the wheel, and where a slow loss carries a circle: against the whole body with its force at the
//! contact, against the balance of energy, and against limits.

use super::general::{as_the_whole_body, start};
use super::whole_body::{State, axle, placed, solve_with};
use super::{GRAVITY, MASS, RADIUS, parameters};
use crate::common::any;
use approx::assert_relative_eq;
use mechanics::integrate::Dop853;
use mechanics::rolling::{MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::{SteadyRolling, Wheel};
use nalgebra::{Complex, Vector3};
use std::f64::consts::FRAC_PI_2;

/// Disc, hoop, the front wheel of a bicycle, and a disc with weights on its axle.
const MOMENTS: [MomentFactors; 4] = [
    MomentFactors::DISK,
    MomentFactors::HOOP,
    MomentFactors { transverse: 0.382, axial: 0.762 },
    MomentFactors { transverse: 2.0, axial: 0.5 },
];
const UNIT: f64 = MASS * RADIUS * RADIUS;

fn of(moments: MomentFactors) -> Wheel {
    Wheel::new(parameters(moments)).expect("a wheel")
}

/// √(g/a), rad/s.
fn rate() -> f64 {
    (GRAVITY / RADIUS).sqrt()
}

/// The brakes: against all turning, and felt, which pushes ahead of the lowest point, by `size` radii.
type Brake = fn(f64, &State) -> Vector3<f64>;
fn against_all(size: f64, state: &State) -> Vector3<f64> {
    Vector3::new(state[10], state[11], state[12]) * (-size * UNIT * rate())
}
fn on_felt(size: f64, state: &State) -> Vector3<f64> {
    // The push mg ahead of the contact: a torque about the level line across the way.
    let across = Vector3::new(axle(state).x, axle(state).y, 0.0).normalize();
    let spin = across.dot(&Vector3::new(state[10], state[11], state[12]));
    across * (-spin.signum() * size * MASS * GRAVITY * RADIUS)
}

/// The same torque on a steady motion, along its axes.
fn on(brake: Brake, size: f64, steady: &SteadyRolling, lean: f64) -> Vector3<f64> {
    let omega = steady.omega();
    let state = placed(lean, 0.0, omega.into(), Complex::new(0.0, 0.0));
    super::whole_body::frame(lean, 0.0).transpose() * brake(size, &state)
}

/// Lean and b/a of the whole body at times, from a steady start.
fn whole(moments: MomentFactors, brake: (Brake, f64), [lean, b]: [f64; 2], times: &[f64]) -> Vec<[f64; 2]> {
    let steady = of(moments).steady(lean, b * RADIUS).expect("a circle");
    let start = placed(lean, 0.0, steady.omega().into(), Complex::new(0.0, 0.0));
    let rates = |_: f64, s: &State| solve_with(moments, 0.0, brake.0(brake.1, s), s).0;
    let (path, _) = Dop853::new(1e-11).unwrap().sample(any(rates), 0.0, start, times).unwrap();
    let place = |state: &State| {
        let n = axle(state);
        let lean = (-n.z).asin();
        let omega = Vector3::new(state[10], state[11], state[12]);
        // The steepest line, from the lowest point to the centre.
        let second = (Vector3::z() - n * n.z).normalize();
        [lean, omega.dot(&n) * lean.cos() / omega.dot(&second)]
    };
    path.iter().map(place).collect()
}

/// The same by the law for weak torques.
fn drifted(moments: MomentFactors, brake: (Brake, f64), start: [f64; 2], times: &[f64]) -> Vec<[f64; 2]> {
    let wheel = of(moments);
    let rates = |_: f64, &[lean, b]: &[f64; 2]| {
        let Ok(steady) = wheel.steady(lean, b * RADIUS) else { return [f64::NAN; 2] };
        let sinking = steady.sinking(on(brake.0, brake.1, &steady, lean));
        [sinking.lean_rate, sinking.circle_rate / RADIUS]
    };
    Dop853::new(1e-10).unwrap().sample(any(rates), 0.0, start, times).unwrap().0
}

#[test]
fn a_weak_brake_carries_the_whole_body_along_steady_circles() {
    for (moments, lean, b) in
        [(0, 0.15, 8.0), (1, 0.15, 8.0), (2, 0.3, 3.0), (3, 0.55, 2.0), (0, 0.4, 0.05), (1, 0.5, -0.05)]
            .map(|(which, lean, b): (usize, f64, f64)| (MOMENTS[which], lean, b))
    {
        for brake in [against_all as Brake, on_felt as Brake] {
            let mut errors = Vec::new();
            for size in [2e-3, 5e-4] {
                // To the same place on the way, however weak the brake is.
                let times: Vec<f64> = (1..=6).map(|k| 0.05 * f64::from(k) / size / rate()).collect();
                let found = whole(moments, (brake, size), [lean, b], &times);
                let law = drifted(moments, (brake, size), [lean, b], &times);
                let last = law[5];
                assert!(last[0] > lean + 0.01, "{moments:?}, {lean}, {b}: it sinks to {last:?}");
                let error = found.iter().zip(&law).map(|(found, law)| {
                    (found[0] - law[0]).abs() + (found[1] - law[1]).abs() / (1.0 + law[1].abs())
                });
                errors.push(error.fold(0.0, f64::max));
            }
            // The error shrinks with the brake.
            assert!(errors[1] < 8e-3 && errors[1] < 0.45 * errors[0], "{moments:?}, {lean}, {b}: {errors:?}");
        }
    }
}

#[test]
fn on_the_way_the_energy_of_the_circles_is_what_the_brake_leaves() {
    let mut random = fastrand::Rng::with_seed(61);
    let mut checked = 0;
    while checked < 200 {
        let moments = MOMENTS[checked % 4];
        let (lean, b) = (0.05 + 1.3 * random.f64(), 5.0 * random.f64());
        let wheel = of(moments);
        let steady = wheel.steady(lean, b * RADIUS).unwrap();
        // Not near the edge of the tongue, where the rates are huge.
        if steady.wobble_square() < 0.05 * rate() * rate() {
            continue;
        }
        let torque = Vector3::new(0.0, -random.f64(), -random.f64()) * 1e-3;
        let sinking = steady.sinking(torque);
        assert!(sinking.lean_rate > 0.0, "every brake makes it sink");
        let h = 1e-4 / (sinking.lean_rate.abs() + sinking.circle_rate.abs() / RADIUS);
        let energy = |time: f64| {
            let (lean, b) = (lean + time * sinking.lean_rate, b * RADIUS + time * sinking.circle_rate);
            wheel.energy(&wheel.steady(lean, b).unwrap().state())
        };
        let power = (energy(h) - energy(-h)) / (2.0 * h);
        assert_relative_eq!(power, torque.dot(&steady.omega()), max_relative = 1e-4);
        checked += 1;
    }
}

#[test]
fn gentle_loss_leads_away_from_the_edge_of_the_tongue() {
    // Just above the edge, on either side, the wobbles become quicker on the way: for all wheels and brakes.
    let mut random = fastrand::Rng::with_seed(62);
    for n in 0..400 {
        let transverse = 10_f64.powf(3.0 * random.f64() - 2.0);
        let moments = MomentFactors { transverse, axial: 2.0 * transverse * (0.02 + 0.98 * random.f64()) };
        let wheel = of(moments);
        let lean = wheel.safe_lean() * (0.02 + 0.97 * random.f64());
        let [inner, outer] = wheel.unstable_circles(lean).unwrap().expect("a tongue");
        let b = if n % 2 == 0 { inner * (1.0 - 1e-4) } else { outer * (1.0 + 1e-4) };
        let steady = wheel.steady(lean, b).unwrap();
        let share = random.f64();
        let sinking = steady.sinking(Vector3::new(0.0, -share, share - 1.0) * 1e-6);
        let h = 1e-7 * b / (sinking.circle_rate.abs() + b * sinking.lean_rate);
        let after = wheel.steady(lean + h * sinking.lean_rate, b + h * sinking.circle_rate).unwrap();
        let [before, after] = [steady, after].map(|steady| steady.wobble_square());
        assert!(before > 0.0 && after > before, "{moments:?}, {lean}, {b}: {before:e}, {after:e}");
    }
}

#[test]
fn nearly_straight_the_lean_grows_as_a_power_before_the_wheel_is_too_slow() {
    for moments in MOMENTS {
        let MomentFactors { transverse: i1, axial: i3 } = moments;
        let slowest = (i1 / (i3 * (1.0 + i3))).sqrt() * rate();
        let (first, lean) = (2.0 * slowest, 1e-6);
        // A steady motion of that spin: θ̇ = 0 and V' = 0, eq:well-slope.
        let q = GRAVITY / RADIUS * lean / ((1.0 + i3) * first);
        let start = placed(lean, 0.0, [0.0, q, first], Complex::new(0.0, 0.0));
        let size = 2e-4;
        let rates = |_: f64, s: &State| solve_with(moments, 0.0, against_all(size, s), s).0;
        let time = (1.0 + i3) / (size * rate()) * (first / (1.25 * slowest)).ln();
        let solver = Dop853::with_tolerances(1e-11, 1e-13).unwrap();
        let end = solver.solve(any(rates), 0.0, start, time).unwrap().state;
        let n = Vector3::new(end[10], end[11], end[12]).dot(&axle(&end));
        assert_relative_eq!(n, 1.25 * slowest, max_relative = 1e-3);
        // eq:straight-lean
        let part = |n: f64| 1.0 - (slowest / n).powi(2);
        let law = (part(first) / part(n)).powf(0.5 + 0.5 * (1.0 + i3) / i1);
        assert_relative_eq!((-axle(&end).z).asin() / lean, law, max_relative = 0.02);
    }
}

#[test]
fn on_felt_the_lean_grows_less_if_the_friction_moves_ahead_with_the_push() {
    for moments in MOMENTS {
        let MomentFactors { transverse: i1, axial: i3 } = moments;
        let slowest = (i1 / (i3 * (1.0 + i3))).sqrt() * rate();
        let (first, last, lean, ahead) = (2.0 * slowest, 1.1 * slowest, 1e-6, 3e-4);
        let q = GRAVITY / RADIUS * lean / ((1.0 + i3) * first);
        let start = placed(lean, 0.0, [0.0, q, first], Complex::new(0.0, 0.0));
        // The force at the contact is found, and then moved ahead: so much of its level part, and the upright one.
        let grown = |level: f64| {
            let rates = |_: f64, s: &State| {
                let way = Vector3::new(s[7], s[8], 0.0).normalize();
                let moved = |force: Vector3<f64>| {
                    let force = Vector3::new(level * force.x, level * force.y, force.z);
                    (way * (ahead * RADIUS)).cross(&force)
                };
                let before = solve_with(moments, 0.0, Vector3::zeros(), s).1;
                solve_with(moments, 0.0, moved(before), s).0
            };
            let time = (first - last) * (1.0 + i3) * RADIUS / (ahead * GRAVITY);
            let solver = Dop853::with_tolerances(1e-11, 1e-13).unwrap();
            let end = solver.solve(any(rates), 0.0, start, time).unwrap().state;
            let n = Vector3::new(end[10], end[11], end[12]).dot(&axle(&end));
            assert_relative_eq!(n, last, max_relative = 1e-3);
            (-axle(&end).z).asin() / lean
        };
        let law = |power: f64| last / first * (3.0 / (last * last / (slowest * slowest) - 1.0)).powf(power);
        assert_relative_eq!(grown(0.0), law((1.0 + 2.0 * i3) / (2.0 * i3)), max_relative = 0.03);
        assert_relative_eq!(grown(1.0), law(1.0), max_relative = 0.03);
    }
}

#[test]
fn felt_takes_the_less_from_a_coin_on_the_spot_the_flatter_it_lies() {
    // Its price of a length of way goes like the sine of the tilt, and the power like Ω sin α cos α, so like 1/Ω.
    let price = |tilt: f64| {
        let steady = of(MomentFactors::DISK).steady(FRAC_PI_2 - tilt, 0.0).unwrap();
        let power = -on(on_felt, 0.01, &steady, FRAC_PI_2 - tilt).dot(&steady.omega());
        power / (steady.turn_rate() * RADIUS * tilt.cos())
    };
    for tilt in [1.2, 0.3, 0.01, 1e-4] {
        assert_relative_eq!(price(tilt), 0.01 * MASS * GRAVITY * tilt.sin(), max_relative = 1e-9);
    }
}

/// The rates of a wheel with a flywheel whose momentum is `flywheel` ma², from those of one without.
fn with_flywheel(wheel: &Wheel, flywheel: f64, time: f64, state: &[f64; 8]) -> [f64; 8] {
    let MomentFactors { transverse: i1, .. } = wheel.parameters().moments;
    let mut rates = wheel.rates(time, state);
    rates[1] -= flywheel * state[2] / (1.0 + i1); // eq:flywheel-rates
    rates[2] += flywheel * state[1] / i1;
    rates
}

#[test]
fn a_wheel_with_a_flywheel_moves_as_the_whole_body_with_it() {
    let mut random = fastrand::Rng::with_seed(63);
    let mut compared = 0;
    for n in 0..40 {
        let moments = MOMENTS[n % 4];
        let wheel = of(moments);
        let (state, flywheel) = (start(&mut random), 24.0 * random.f64() - 12.0);
        let rates = |t: f64, y: &[f64; 8]| with_flywheel(&wheel, flywheel, t, y);
        let judge = |_: f64, s: &State| solve_with(moments, flywheel * UNIT, Vector3::zeros(), s).0;
        compared += i32::from(as_the_whole_body(&state, rates, judge).is_some());
    }
    assert!(compared > 25, "{compared}");
}

/// The widest lean, rad, of the whole body with a flywheel, nudged upright with a spin, in thirty times √(a/g).
fn widest(moments: MomentFactors, flywheel: f64, spin: f64) -> f64 {
    let start = placed(0.0, 0.0, [1e-5 * rate(), 0.0, spin], Complex::new(0.0, 0.0));
    let times: Vec<f64> = (1..=300).map(|k| 0.1 / rate() * f64::from(k)).collect();
    let rates = |_: f64, s: &State| solve_with(moments, flywheel * UNIT, Vector3::zeros(), s).0;
    // What falls flat stops the solver; it has fallen.
    let Ok((path, _)) = Dop853::new(1e-10).unwrap().sample(any(rates), 0.0, start, &times) else {
        return 1.0;
    };
    path.iter().map(|state| (-axle(state).z).asin().abs()).fold(0.0, f64::max)
}

#[test]
fn a_strong_flywheel_holds_a_wheel_up_at_rest_and_not_one_that_rolls_the_other_way() {
    for moments in MOMENTS {
        let MomentFactors { transverse: i1, axial: i3 } = moments;
        let least = i1.sqrt() * rate(); // eq:flywheel-needed
        for (part, stands) in [(0.9, false), (1.1, true)] {
            assert_eq!(widest(moments, part * least, 0.0) < 1e-4, stands, "{moments:?}, {part}");
        }
        // Between the roots of eq:flywheel-upright it falls; outside, and rolling on, it does not.
        let g = 1.2 * least;
        let [square, linear, rest] = [i3 * (1.0 + i3), (1.0 + 2.0 * i3) * g, g * g - least * least];
        let root = (linear * linear - 4.0 * square * rest).sqrt();
        let [low, high] = [-1.0, 1.0].map(|sign| (-linear + sign * root) / (2.0 * square));
        for (spin, stands) in [
            (high + 0.12 * rate(), true),
            (high - 0.12 * rate(), false),
            (0.5 * (low + high), false),
            (low + 0.12 * rate(), false),
            (low - 0.12 * rate(), true),
            (rate(), true),
        ] {
            assert_eq!(widest(moments, g, spin) < 1e-3, stands, "{moments:?}: {spin}, {low}, {high}");
        }
    }
}

#[test]
fn the_wheels_of_the_table_need_the_speeds_and_have_the_tips_that_it_says() {
    // Moments, slowest v and q in √(ga) and √(g/a), and the tip in degrees, as printed.
    let bicycle = 3.0 * 0.35 * 0.35;
    for ([transverse, axial], [roll, spin, tip]) in [
        ([0.5, 1.0], [0.50, 0.82, 19.2]),
        ([0.1405 / bicycle, 0.28 / bicycle], [0.53, 0.85, 19.0]),
        ([0.25, 0.5], [0.58, 0.89, 18.6]),
        ([0.05, 0.1], [0.67, 0.98, 17.9]),
        ([1.0 / 3.0, 0.5], [0.67, 0.87, 20.1]),
        ([0.4, 0.4], [0.85, 0.85, 22.0]),
        ([2.0, 0.5], [1.63, 0.58, 25.8]),
    ] {
        let moments = MomentFactors { transverse, axial };
        let tall = of(moments).safe_lean().to_degrees();
        assert!((tall - tip).abs() < 0.0501, "{moments:?}: {tall}");
        // On the hair of a lean the circles at the edges of the tongue have the speeds, and an upright body beside them
        // stays or falls.
        let [inner, outer] = of(moments).unstable_circles(1e-5).unwrap().expect("a tongue");
        let [inner, outer] = [inner, outer].map(|b| of(moments).steady(1e-5, b).unwrap());
        assert!((outer.true_spin() / rate() - roll).abs() < 0.00501, "{moments:?}");
        assert!((inner.turn_rate() / rate() - spin).abs() < 0.00501, "{moments:?}");
        assert!(widest(moments, 0.0, 1.07 * roll * rate()) < 1e-3, "{moments:?}");
        assert!(widest(moments, 0.0, 0.93 * roll * rate()) > 1e-3, "{moments:?}");
    }
}

#[test]
fn the_straighter_a_disc_ran_the_wider_it_swings_when_it_is_too_slow() {
    let wheel = of(MomentFactors::DISK);
    let mut before = 0.0;
    for exponent in [2, 3, 4] {
        let lean = 10_f64.powi(-exponent);
        // Steady with the true spin √(g/a): V' = 0, eq:well-slope, at a small lean.
        let start = Rolling {
            tilt: std::f64::consts::FRAC_PI_2 - lean,
            omega_2: lean * rate() / 1.5,
            omega_3: rate(),
            ..Rolling::UPRIGHT
        };
        let rates = wheel.slowed_rates(0.05 * rate());
        let times: Vec<f64> = (1..=1000).map(|k| 0.05 / rate() * f64::from(k)).collect();
        let solver = Dop853::with_tolerances(1e-10, 1e-13).unwrap();
        let (path, _) = solver.sample(any(rates), 0.0, start.to_array(), &times).unwrap();
        let (mut highest, mut back) = (0.0_f64, 0.0_f64);
        for lean in path.iter().map(|state| Rolling::from_array(*state).lean()).take_while(|lean| *lean < 1.3)
        {
            highest = highest.max(lean);
            back = back.max(highest - lean);
        }
        assert!(back > 0.005 + 1.5 * before, "{lean}: it swings back by {back} rad");
        before = back;
    }
    assert!(before > 0.2, "{before}");
}

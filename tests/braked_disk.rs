//! A disk that loses energy by any law, with nothing assumed to be slow: against equations of motion written out here,
//! what is left of them at small tilts, and a bound on what the table carries.

use mechanics::integrate::{Dop853, Failure, rk4_step};
use mechanics::nalgebra::Vector3;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::spinning_coin::{BrakedDisk, EulersDisk, Loss, SpinDown, SpinningCoin};
use mechanics::{Error, InvalidQuantity};
use std::f64::consts::SQRT_2;

const G: f64 = 9.81;
const SOUND: f64 = 343.0;
/// The toy of the shops.
const TOY: DiskParameters =
    DiskParameters { mass: 0.4, radius: 0.0375, moments: MomentFactors::DISK, gravity: G };
const POWERS: [f64; 4] = [2.0, 1.25, 1.0, 0.5];

/// The loss with which the toy lives for a hundred seconds from a tilt of 0.1, by slow sinking.
fn loss(power: f64) -> Loss {
    let start = SpinningCoin::new(TOY, 0.1).unwrap();
    let unit = SpinDown::new(start, Loss::new(1.0, power).unwrap()).unwrap().life();
    Loss::new(unit / 100.0, power).unwrap()
}

/// By slow sinking: the way down, and where it asks for a fall with g.
fn law(power: f64) -> (SpinDown, SpinningCoin) {
    let down = SpinDown::new(SpinningCoin::new(TOY, 0.1).unwrap(), loss(power)).unwrap();
    (down, down.with_time_left(down.time_left_at_free_fall()).unwrap())
}

fn toy(power: f64) -> (BrakedDisk, Rolling) {
    (BrakedDisk::new(TOY, loss(power)).unwrap(), SpinningCoin::new(TOY, 0.1).unwrap().state())
}

fn solver() -> Dop853 {
    Dop853::with_tolerances(1e-10, 1e-13).unwrap()
}

/// Tilts from one to another, each so much lower than the one before.
fn tilts(from: f64, to: f64, ratio: f64) -> Vec<f64> {
    (0..).map(|n| from / f64::powi(ratio, n)).take_while(|tilt| *tilt > to).collect()
}

/// One Runge-Kutta step.
fn step<const N: usize>(rates: impl Fn([f64; N]) -> [f64; N], y: [f64; N], h: f64) -> [f64; N] {
    rk4_step(&mut |_, y: &[f64; N]| rates(*y), 0.0, &y, h)
}

/// How a disk of such moments goes down against a brake that depends on its tilt, in units of m, a and g: rates of
/// tilt, sinking, ω₂ and ω₃, and the support. On ice the centre moves only up and down.
fn written_out(
    [i1, i3]: [f64; 2],
    brake: impl Fn(f64) -> f64,
    on_ice: bool,
) -> impl Fn([f64; 4]) -> ([f64; 4], f64) {
    move |[tilt, rising, across, axle]| {
        let (sin, cos) = tilt.sin_cos();
        let drag = brake(tilt);
        let held = i1 * across * across * cos / sin - drag * rising;
        let (bend, axle_rate) = if on_ice {
            let torque = -cos + sin * cos * rising * rising + i3 * across * axle + held;
            (torque / (i1 + cos * cos), 0.0)
        } else {
            ((-cos + (1.0 + i3) * across * axle + held) / (1.0 + i1), -rising * across / (1.0 + i3))
        };
        let across_rate = (-rising * (i1 * across * cos / sin + i3 * axle) - drag * across) / i1;
        ([rising, bend, across_rate, axle_rate], 1.0 + bend * cos - rising * rising * sin)
    }
}

#[test]
fn in_steady_rolling_it_loses_the_power_of_its_law() {
    for moments in [MomentFactors::DISK, MomentFactors::HOOP, MomentFactors { transverse: 0.3, axial: 0.45 }]
    {
        for power in [0.0, 0.5, 1.25, 2.0, 3.0] {
            for tilt in [1.0_f64, 0.1, 0.003] {
                let parameters = DiskParameters { moments, ..TOY };
                let disk = BrakedDisk::new(parameters, Loss::new(2e-5, power).unwrap()).unwrap();
                let state = SpinningCoin::new(parameters, tilt).unwrap().state().to_array();
                let rates = disk.rates(0.0, &state);
                let h = 1e-5 * tilt / rates.iter().fold(0.0_f64, |most, rate| most.max(rate.abs()));
                let energy = |h: f64| {
                    disk.energy(&Rolling::from_array(std::array::from_fn(|n| state[n] + h * rates[n])))
                };
                // The acceleration takes part as the sinking begins: about 1e-9 of the energy remains of it.
                let lost = (energy(-h) - energy(h)) / (2.0 * h);
                let expected = 2e-5 / tilt.sin().powf(power);
                let rounding = 1e-15 * energy(0.0) / h;
                assert!(
                    (lost - expected).abs() < 1e-5 * expected + rounding,
                    "{power} {tilt}: {lost} {expected}"
                );
            }
        }
    }
}

/// The force of the table along axis 1, towards the centre's side and up, N. It follows from the rates of a disk on which
/// a torque −`drag` times its angular velocity across the axle acts, by the whole body's equations of motion about the
/// contact, in vectors of the room, which must hold.
fn pushed(
    parameters: DiskParameters,
    rates: impl Fn(&[f64; 8]) -> [f64; 8],
    start: Rolling,
    drag: f64,
) -> Vector3<f64> {
    let DiskParameters { mass: m, radius: a, moments: MomentFactors { transverse, axial }, .. } = parameters;
    let axes = |s: &Rolling| {
        let first = Vector3::new(s.heading.cos(), s.heading.sin(), 0.0);
        let left = Vector3::new(-s.heading.sin(), s.heading.cos(), 0.0);
        let second = Vector3::z() * s.tilt.sin() - left * s.tilt.cos();
        [first, second, first.cross(&second)]
    };
    let parts = |s: &Rolling, weights: [f64; 3]| {
        let [e1, e2, e3] = axes(s);
        e1 * (s.omega_1 * weights[0]) + e2 * (s.omega_2 * weights[1]) + e3 * (s.omega_3 * weights[2])
    };
    let omega = parts(&start, [1.0; 3]);
    let centre = |s: &Rolling| Vector3::new(s.centre.re, s.centre.im, a * s.tilt.sin());
    let velocity = |s: &Rolling| parts(s, [1.0; 3]).cross(&(axes(s)[1] * a));
    let spin = |s: &Rolling| parts(s, [transverse, transverse, axial]) * (m * a * a);
    let rates = rates(&start.to_array());
    let moved = |h: f64| Rolling::from_array(std::array::from_fn(|i| start.to_array()[i] + h * rates[i]));
    let h = 1e-6;
    let [before, after] = [-h, h].map(moved);
    // The centre moves as rolling says, the plane turns with ω.
    assert!(((centre(&after) - centre(&before)) / (2.0 * h) - velocity(&start)).norm() < 1e-7);
    let third = (axes(&after)[2] - axes(&before)[2]) / (2.0 * h);
    assert!((third - omega.cross(&axes(&start)[2])).norm() < 1e-7);
    // dL/dt = −a e₂ × R + the torque, with R = m(v̇ + g).
    let force = ((velocity(&after) - velocity(&before)) / (2.0 * h) + Vector3::z() * G) * m;
    let [e1, e2, _] = axes(&start);
    let torque = (e2 * -a).cross(&force) - parts(&start, [drag, drag, 0.0]);
    let rate = (spin(&after) - spin(&before)) / (2.0 * h);
    assert!((rate - torque).norm() < 1e-6 * m * a * G, "{parameters:?}: {rate} for {torque}");
    Vector3::new(force.dot(&e1), force.dot(&e1.cross(&Vector3::z())), force.z)
}

#[test]
fn brake_and_film_take_momentum_about_the_contact_and_the_table_pushes_as_it_must() {
    let start =
        Rolling { tilt: 0.8, omega_1: -3.0, omega_2: 9.0, omega_3: 14.0, heading: 0.7, ..Rolling::UPRIGHT };
    let (mass, radius, sine) = (0.3, 0.04, start.tilt.sin());
    for (transverse, axial) in [(0.25, 0.5), (0.5, 1.0), (0.6, 0.4), (0.3, 0.45)] {
        let moments = MomentFactors { transverse, axial };
        let parameters = DiskParameters { mass, radius, moments, gravity: G };
        for power in [0.5, 1.25, 3.0] {
            let disk = BrakedDisk::new(parameters, Loss::new(0.5, power).unwrap()).unwrap();
            // C/sinᵖ α is the power in steady rolling, where ω₂² = g sin α/(I₁a).
            let drag = 0.5 * transverse * radius / (G * sine.powf(power + 1.0));
            let seen = pushed(parameters, |state| disk.rates(0.0, state), start, drag);
            assert!((disk.support(&start) - seen).norm() < 1e-6 * mass * G, "{power}");
        }
        let disk = EulersDisk::new(parameters, 0.02).unwrap();
        let drag = 0.02 * mass * radius * radius * (G / radius).sqrt() / sine.powi(3);
        let seen = pushed(parameters, |state| disk.rates(0.0, state), start, drag);
        assert!((disk.normal_force(&start) - seen.z).abs() < 1e-6 * mass * G);
    }
}

#[test]
fn four_exponents_come_out_with_nothing_assumed_to_be_slow() {
    let unit = (TOY.radius / G).sqrt();
    for power in POWERS {
        let (disk, start) = toy(power);
        let (_, last) = law(power);
        let wanted = tilts(0.09, 8.0 * last.tilt(), SQRT_2);
        let sunk = disk.sink(start, &wanted, &solver()).unwrap();
        // A second integration, of the equations above.
        let strength = disk.strength();
        let rates = written_out([0.25, 0.5], |tilt| strength / tilt.sin().powf(power + 1.0), false);
        let mut state = [0.1, 0.0, 2.0 * 0.1_f64.sin().sqrt(), 0.0];
        let (mut time, mut next) = (0.0, 0);
        while next < wanted.len() {
            let h = 0.05 * state[0].sqrt();
            let after = step(|y| rates(y).0, state, h);
            if after[0] < wanted[next] {
                let part = (state[0] - wanted[next]) / (state[0] - after[0]);
                let there = (time + part * h) * unit;
                let found = sunk[next].time;
                assert!((found - there).abs() < 1e-5 * there, "{power}, {}: {found} {there}", wanted[next]);
                next += 1;
                continue;
            }
            (time, state) = (time + h, after);
        }
        // Three tilts in proportion tell the exponent, whatever the end.
        for three in sunk.windows(3).skip(1) {
            let [first, second] = [three[1].time - three[0].time, three[2].time - three[1].time];
            let exponent = SQRT_2.ln() / (first / second).ln();
            let expected = 1.0 / (power + 1.0);
            assert!((exponent / expected - 1.0).abs() < 0.01, "{power}: {exponent} for {expected}");
        }
        assert!(sunk.len() > 4);
    }
}

/// What the support is at the least, and how fast the contact runs at the most, in speeds of sound; and where.
fn extremes(power: f64) -> [f64; 3] {
    let (disk, start) = toy(power);
    let last = law(power).1.tilt();
    let wanted = tilts(5.0 * last, 0.5 * last, 1.01);
    let (mut least, mut most, mut place) = (f64::INFINITY, 0.0, 0.0);
    for there in disk.sink(start, &wanted, &solver()).unwrap() {
        least = least.min(disk.support(&there.state).z / (TOY.mass * G));
        let mach = TOY.radius * there.state.omega_2 / there.state.tilt.tan() / SOUND;
        if mach > most {
            (most, place) = (mach, there.state.tilt);
        }
    }
    [least, most, place]
}

#[test]
fn the_table_of_the_page_is_that_of_the_full_motion() {
    // Where the exponent is a twentieth off; where the law falls with g, and the gap there; the least support; the
    // contact, and what the law said of it.
    let rows = [
        (2.0, 5.4e-3, 2.4e-3, 91e-6, 0.73, 0.057, 0.072),
        (1.25, 1.5e-3, 5.1e-4, 19e-6, 0.78, 0.117, 0.157),
        (1.0, 6.8e-4, 2.1e-4, 7.9e-6, 0.80, 0.175, 0.243),
        (0.5, 4.5e-5, 9.2e-6, 0.34e-6, 0.88, 0.737, 1.166),
    ];
    for (power, off, fall, gap, least, most, by_the_law) in rows {
        let (_, last) = law(power);
        assert!(
            (last.tilt() / fall - 1.0).abs() < 0.02 && (TOY.radius * last.tilt() / gap - 1.0).abs() < 0.02
        );
        assert!((last.contact_speed() / SOUND / by_the_law - 1.0).abs() < 0.005);
        let [found_least, found_most, _] = extremes(power);
        println!("{power}: {found_least} {found_most}");
        assert!((found_least - least).abs() < 5e-3, "{power}: {found_least}");
        assert!((found_most - most).abs() < 6e-4, "{power}: {found_most}");
        let (disk, start) = toy(power);
        let three = [SQRT_2 * off, off, off / SQRT_2];
        let times: Vec<f64> =
            disk.sink(start, &three, &solver()).unwrap().iter().map(|there| there.time).collect();
        let exponent = SQRT_2.ln() / ((times[1] - times[0]) / (times[2] - times[1])).ln();
        let part = exponent * (power + 1.0);
        assert!((1.045..1.055).contains(&part), "{power}: {part}");
    }
}

/// At small tilts, in units in which the brake has the strength one, all motions are one.
#[test]
fn what_is_left_at_small_tilts_knows_no_strength() {
    for power in POWERS {
        let i1 = 0.25;
        // α, its rate, and αω₂, which only the brake changes.
        let rates = |[tilt, rising, level]: [f64; 3]| {
            let drag = tilt.powf(-power - 1.0);
            let bend = (-1.0 + i1 * level * level / tilt.powi(3) - drag * rising) / (1.0 + i1);
            [rising, bend, -drag / i1 * level]
        };
        let begin = 60.0_f64;
        let mut state = [begin, -2.0 / (3.0 * i1 * begin.powf(power)), (begin.powi(3) / i1).sqrt()];
        let (mut least, mut quickest) = (f64::INFINITY, 0.0_f64);
        while state[0] > 0.5 {
            least = least.min(1.0 + rates(state)[1]);
            quickest = quickest.max(state[2] / (state[0] * state[0]));
            state = step(rates, state, 0.01 * state[0].sqrt().min(state[0].powf(power + 1.0)));
            assert!(state[1] < 0.0, "it rises");
        }
        let strength = toy(power).0.strength();
        let mach = (G * TOY.radius).sqrt() * quickest * strength.powf(-1.0 / (2.0 * power + 1.0)) / SOUND;
        let [found_least, found_most, _] = extremes(power);
        println!("{power}: {least} {mach}");
        assert!((found_least / least - 1.0).abs() < 0.005, "{power}: {found_least} for {least}");
        assert!((found_most / mach - 1.0).abs() < 0.01, "{power}: {found_most} for {mach}");
    }
}

#[test]
fn a_disk_that_sinks_is_held_by_a_fifth_of_its_weight_at_least() {
    let mut random = fastrand::Rng::with_seed(16);
    let mut closest = f64::INFINITY;
    for _ in 0..300 {
        let i1 = 0.05 + 0.7 * random.f64();
        let i3 = 2.0 * i1 * random.f64();
        let begin = 0.02 + 0.5 * random.f64();
        // Any brake: two powers of the tilt, of any strength, and gusts.
        let [b1, b2] = [0, 1].map(|_| 10_f64.powf(-8.0 + 9.0 * random.f64()));
        let [p1, p2] = [0, 1].map(|_| 5.0 * random.f64());
        let gusts = 300.0 * random.f64();
        let brake = |tilt: f64| (b1 * tilt.powf(-p1) + b2 * tilt.powf(-p2)) * (1.0 + (gusts * tilt).sin());
        let bound = (i1 - 0.75 * begin.sin().powi(2)) / (1.0 + i1);
        let rates = written_out([i1, i3], brake, false);
        let mut state = [begin, 0.0, (begin.sin() / i1).sqrt(), 0.0];
        for _ in 0..20_000 {
            let (_, support) = rates(state);
            if state[1] > 0.0 || state[0] < 1e-4 {
                break;
            }
            assert!(support > bound - 1e-9, "{support} below {bound}");
            closest = closest.min(support - bound);
            let held = brake(state[0]) / i1;
            state = step(|y| rates(y).0, state, (0.05 * state[0].sqrt()).min(0.5 / held));
        }
    }
    println!("closest: {closest}");
    // A brake that stops the turning at once leaves a disk that tips over freely, which comes near the bound.
    for (i1, i3, begin) in [(0.25, 0.5, 0.1_f64), (0.5, 1.0, 0.05)] {
        let (_, support) = written_out([i1, i3], |_| 0.0, false)([begin, 0.0, 0.0, 0.0]);
        assert!((support - (i1 + begin.sin().powi(2)) / (1.0 + i1)).abs() < 1e-12);
    }
}

#[test]
fn ice_changes_next_to_nothing() {
    for power in [2.0, 1.0] {
        let strength = toy(power).0.strength();
        let rates = written_out([0.25, 0.5], |tilt| strength / tilt.sin().powf(power + 1.0), true);
        let mut state = [0.1, 0.0, 2.0 * 0.1_f64.sin().sqrt(), 0.0];
        let (mut least, mut quickest) = (f64::INFINITY, 0.0_f64);
        let last = law(power).1.tilt();
        while state[0] > 0.5 * last {
            let support = rates(state).1;
            let fall = 1.0 - state[1] * state[1] * state[0].sin();
            assert!(support > 0.25 / (0.25 + state[0].cos().powi(2)) * fall - 1e-12);
            least = least.min(support);
            quickest = quickest.max(state[2] / state[0].tan());
            let held = 4.0 * strength / state[0].powf(power + 1.0);
            state = step(|y| rates(y).0, state, (0.05 * state[0].sqrt()).min(0.5 / held));
            assert!(state[1] <= 0.0);
        }
        let mach = (G * TOY.radius).sqrt() * quickest / SOUND;
        let [found_least, found_most, _] = extremes(power);
        println!("{power}: {least} {mach}");
        assert!((found_least - least).abs() < 0.005, "{power}: {found_least} for {least}");
        assert!((found_most / mach - 1.0).abs() < 0.01, "{power}: {found_most} for {mach}");
    }
}

#[test]
fn sinking_feeds_a_spin_that_asks_for_ever_more_friction() {
    let needed = |tilt: f64| 16.0 / 9.0 * (0.1_f64.powf(1.5) / tilt.sqrt() - tilt);
    for power in POWERS {
        let (disk, start) = toy(power);
        for there in disk.sink(start, &tilts(0.07, 0.015, 1.2), &solver()).unwrap() {
            let support = disk.support(&there.state);
            let found = support.x.hypot(support.y) / support.z;
            let tilt = there.state.tilt;
            assert!(
                (found / needed(tilt) - 1.0).abs() < 0.02,
                "{power} {tilt}: {found} for {}",
                needed(tilt)
            );
            // It is what holds the centre on its circle: bΩ²/g, with b = aω₃/Ω.
            let (turn, spin) = (there.state.omega_2 / tilt.sin(), there.state.omega_3);
            assert!((found / (TOY.radius * spin * turn / G) - 1.0).abs() < 0.02);
        }
    }
    for (coefficient, tilt) in [(0.1, 0.066), (0.2, 0.0423), (0.3, 0.0262)] {
        assert!((needed(tilt) - coefficient).abs() < 0.005, "{coefficient}: {}", needed(tilt));
    }
}

#[test]
fn less_than_a_quarter_of_a_round_is_left_where_a_law_falls_with_g() {
    for power in [0.05, 0.5, 1.0, 1.25, 2.0, 9.0] {
        let s = 1.0 / (power + 1.0);
        let (down, last) = law(power);
        let left = down.time_left_at_free_fall();
        let product = last.turn_rate() * left;
        assert!((product - 2.0 * (s * (1.0 - s)).sqrt()).abs() < 1e-6, "{power}: {product}");
        let round = down.gone_round(1e-9 * left).unwrap() - down.gone_round(left).unwrap();
        assert!(round < SQRT_2 + 1e-6, "{power}: {round}");
        assert!((round - product / (1.0 - 0.5 * s)).abs() < 1e-4 * round, "{power}: {round}");
    }
}

#[test]
fn what_does_not_sink_is_refused() {
    let (disk, start) = toy(1.0);
    let refused = |start: Rolling, tilts: &[f64]| match disk.sink(start, tilts, &solver()) {
        Err(Error::Quantity(InvalidQuantity { value, .. })) => value,
        other => panic!("{other:?}"),
    };
    assert_eq!(refused(start, &[0.1]), 0.1);
    assert_eq!(refused(start, &[0.09, 0.09]), 0.09);
    assert_eq!(refused(start, &[-0.1]), -0.1);
    assert!(refused(start, &[f64::NAN]).is_nan());
    assert_eq!(refused(Rolling { tilt: 0.0, ..start }, &[0.1]), 0.0);
    assert_eq!(disk.sink(start, &[], &solver()).unwrap(), []);
    assert!(BrakedDisk::new(DiskParameters { mass: -1.0, ..TOY }, loss(1.0)).is_err());
    // Where all turning has died out it creeps, in ever stiffer equations.
    let few = solver().with_max_evaluations(100_000);
    assert!(matches!(disk.sink(start, &[1e-7], &few), Err(Error::Integration(_))));
    // The limit is one for the whole list, wherever in it the work is done.
    let tilt = start.tilt;
    let work = |tilts: &[f64], most: usize| {
        let solver = solver().with_max_evaluations(most);
        match disk.sink(start, tilts, &solver) {
            Err(Error::Integration(Failure::TooMuchWork { evaluations, counted: "evaluations", .. })) => {
                Some(evaluations)
            }
            Ok(_) => None,
            Err(other) => panic!("{other}"),
        }
    };
    let list: Vec<f64> = (1..=20).map(|n| tilt * (1.0 - 0.02 * f64::from(n))).collect();
    let enough = (10..).map(|power| 1 << power).find(|&most| work(&list, most).is_none()).unwrap();
    let stopped = work(&list, enough / 4).unwrap();
    assert!((enough / 4..enough / 4 + 100).contains(&stopped), "{stopped} of {}", enough / 4);
    assert!(work(&list[..1], enough / 4).is_none());
}

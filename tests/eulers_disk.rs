//! Euler's disk on a film of air: the Taylor series against the rates, the rates against Newton's and Euler's laws, and
//! what is lost.

use crate::common::any;
use mechanics::integrate::{Dop853, Failure, Taylor};
use mechanics::nalgebra::Complex;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::spinning_coin::{EulersDisk, Loss, Sinking, SpinDown, SpinningCoin};
use mechanics::{Error, InvalidQuantity, Rule};
use std::f64::consts::TAU;

const A: f64 = 0.04;
const G: f64 = 9.81;
const MASS: f64 = 0.3;

fn parameters(moments: MomentFactors) -> DiskParameters {
    DiskParameters { mass: MASS, radius: A, moments, gravity: G }
}

fn disk(film: f64) -> EulersDisk {
    EulersDisk::new(parameters(MomentFactors::DISK), film).expect("a disk")
}

fn sinking(disk: &EulersDisk, start: Rolling, tolerance: f64) -> Sinking {
    disk.sinking(start, &Taylor::new(tolerance).expect("a tolerance")).expect("a motion")
}

/// A disk that wobbles strongly as it rolls.
fn rough() -> Rolling {
    Rolling {
        tilt: 0.8,
        omega_1: -3.0,
        omega_2: 9.0,
        omega_3: 14.0,
        heading: 0.7,
        roll_angle: 0.4,
        centre: Complex::new(0.1, -0.3),
    }
}

fn largest_difference(a: &Rolling, b: &Rolling) -> f64 {
    let scale = (G / A).sqrt();
    let units = [1.0, scale, scale, scale, 1.0, 1.0, A, A];
    let pairs = a.to_array().into_iter().zip(b.to_array()).zip(units);
    pairs.map(|((a, b), unit)| ((a - b) / unit).abs()).fold(0.0, f64::max)
}

#[test]
fn the_energy_that_is_lost_is_the_work_of_the_film() {
    let disk = disk(0.01);
    let rate = (G / A).sqrt();
    // With the film's power as a ninth variable.
    let rates = |t: f64, y: &[f64; 9]| {
        let state: [f64; 8] = std::array::from_fn(|i| y[i]);
        let dot = disk.rates(t, &state);
        let torque = 0.01 * MASS * A * A * rate / y[0].sin().powi(3);
        let power = torque * (y[1] * y[1] + y[2] * y[2]);
        std::array::from_fn(|i| if i < 8 { dot[i] } else { power })
    };
    let start = rough();
    let begin: [f64; 9] = std::array::from_fn(|i| if i < 8 { start.to_array()[i] } else { 0.0 });
    let end = Dop853::new(1e-13).unwrap().solve(any(rates), 0.0, begin, 2.0).unwrap().state;
    let ours = sinking(&disk, start, 1e-16).at(2.0).unwrap();
    let lost = disk.energy(&start) - disk.energy(&ours);
    assert!(lost > 0.05 * MASS && (lost / end[8] - 1.0).abs() < 1e-10, "{lost} {}", end[8]);
    // And without a film none is.
    let free = self::disk(0.0);
    let late = sinking(&free, start, 1e-16).at(50.0).unwrap();
    let change = free.energy(&late) / free.energy(&start) - 1.0;
    assert!(change.abs() < 1e-13, "{change:e}");
}

#[test]
fn the_cube_of_the_tilt_falls_in_proportion_to_the_time() {
    // Moffatt's law: the energy 3/2 g a sin α is lost at the rate 4K ga√(g/a)/α². The law leaves out what is of the
    // order of α²: the difference of α and sin α, and the spin about the axle (below).
    let mut departures = Vec::new();
    for tilt in [0.2, 0.1, 0.05] {
        let film = 1e-3 * tilt * tilt * tilt;
        let disk = disk(film);
        let start = disk.steady(tilt).unwrap();
        let end = tilt.powi(3) / (8.0 * film) * (A / G).sqrt();
        let times: Vec<f64> = (0..=8).map(|n| 0.1 * f64::from(n) * end).collect();
        let states = sinking(&disk, start, 1e-14).sample(&times).unwrap();
        let departure = |(state, t): (&Rolling, &f64)| state.tilt / (tilt * (1.0 - t / end).cbrt()) - 1.0;
        departures.push(states.iter().zip(&times).map(departure).fold(0.0, |a: f64, b| a.max(b.abs())));
    }
    println!("{departures:?}");
    let [far, near, nearest] = departures[..] else { panic!("three tilts") };
    assert!(
        far < 0.05 && (3.0..5.0).contains(&(far / near)) && (3.0..5.0).contains(&(near / nearest)),
        "{departures:?}"
    );
}

/// Radius of the circle that the centre draws in the next round of the contact, from its places alone.
fn circle(disk: &EulersDisk, begin: Rolling) -> f64 {
    let round = TAU * begin.tilt.sin() / begin.omega_2; // 2π/Ω, since ω₂ = Ω sin α
    let times: Vec<f64> = (0..64).map(|n| round * f64::from(n) / 64.0).collect();
    let states = sinking(disk, begin, 1e-14).sample(&times).unwrap();
    let middle = states.iter().map(|state| state.centre).sum::<Complex<f64>>() / 64.0;
    states.iter().map(|state| (state.centre - middle).norm()).sum::<f64>() / 64.0
}

#[test]
fn the_circle_of_a_sinking_disk_opens_and_closes_again() {
    // Sinking slowly through steady motions: (1 + I₃) dω₃ = −ω₂ dα with ω₂ = 2√α, and b = aω₃/Ω with Ω = 2/√α, in units
    // of g and a.
    for (tilt, film) in [(0.1_f64, 1e-7), (0.05, 1e-8)] {
        let disk = disk(film);
        let start = disk.steady(tilt).unwrap();
        let life = tilt.powi(3) / (8.0 * film) * (A / G).sqrt();
        let times: Vec<f64> = (4..=38).rev().map(|n| (1.0 - (0.025 * f64::from(n)).powi(3)) * life).collect();
        let (mut widest, mut at, mut last) = (0.0, 0.0, (0.0, 0.0));
        for state in sinking(&disk, start, 1e-14).sample(&times).unwrap() {
            let (now, radius) = (state.tilt, circle(&disk, state));
            let law = 4.0 / 9.0 * A * (tilt.powf(1.5) * now.sqrt() - now * now);
            assert!((radius / law - 1.0).abs() < 0.03, "{radius} m for {law} m at {now}");
            if radius > widest {
                (widest, at) = (radius, now / tilt);
            }
            last = (radius, now / tilt);
        }
        // It opens until two fifths of the tilt are left, 4^{−2/3}, and closes from there on.
        assert!((at - 0.397).abs() < 0.03, "{at}");
        assert!((widest / (0.21 * A * tilt * tilt) - 1.0).abs() < 0.03, "{widest}");
        assert!(last.0 < 0.85 * widest && last.1 < 0.2, "{last:?} after {widest} m");
    }
}

#[test]
fn a_disk_that_sinks_has_the_turn_that_its_spin_asks_for() {
    let disk = disk(1e-5);
    let start = disk.steady(0.2).unwrap();
    let times: Vec<f64> = (1..=9).map(|n| 10.0 * f64::from(n) * (A / G).sqrt()).collect();
    for state in sinking(&disk, start, 1e-14).sample(&times).unwrap() {
        // Sinking turns some of the spin into the axle. With that spin the steady balance, I₁ cot α ω₂² + (1 + I₃) ω₃ω₂
        // = (g/a) cos α, gives ω₂.
        let (sin, cos) = state.tilt.sin_cos();
        let (a, b) = (0.25 * cos / sin, 1.5 * state.omega_3);
        let steady = (-b + (b * b + 4.0 * a * cos * G / A).sqrt()) / (2.0 * a);
        assert!((state.omega_2 / steady - 1.0).abs() < 0.003, "{} {steady}", state.omega_2);
        assert!(state.omega_3 > 0.0);
    }
}

#[test]
fn the_viscosity_of_air_takes_the_power_that_moffatt_found() {
    let (mass, radius, viscosity) = (0.4, 0.0375, 1.78e-5);
    let tilt: f64 = 1e-3;
    // A uniform disc, and rounder ones, whose contact runs slower at the same tilt.
    for (transverse, axial) in [(0.25, 0.5), (0.4, 0.5), (0.5, 1.0)] {
        let moments = MomentFactors { transverse, axial };
        let parameters = DiskParameters { mass, radius, moments, gravity: G };
        let disk = EulersDisk::in_air(parameters, viscosity).unwrap();
        let s = disk.steady(tilt).unwrap();
        let rate = (G / radius).sqrt();
        let power = disk.film() * mass * radius * radius * rate * s.omega_2 * s.omega_2 / tilt.sin().powi(3);
        let moffatt =
            0.25 / transverse * std::f64::consts::PI * viscosity * G * radius * radius / (tilt * tilt);
        assert!((power / moffatt - 1.0).abs() < 1e-5, "{power} W for {moffatt} W");
        // The law of slow sinking loses the same power: its time falls with E = 3/2 mga sin α.
        let coin = SpinningCoin::new(parameters, tilt).unwrap();
        let law = SpinDown::new(coin, Loss::air_film(&coin, viscosity).unwrap()).unwrap();
        let sunk = 1.0 - 1e-6;
        let lost = coin.energy() - SpinningCoin::new(parameters, sunk * tilt).unwrap().energy();
        assert!((lost / law.time_to(sunk * tilt).unwrap() / power - 1.0).abs() < 1e-5);
    }
}

#[test]
fn times_may_come_in_any_order_and_of_either_sign() {
    let motion = sinking(&disk(0.003), rough(), 1e-16);
    let times = [0.3, -0.2, 0.0, 1.1, 0.3, -0.05, 0.7];
    let states = motion.sample(&times).unwrap();
    assert_eq!((states[2], states[0]), (rough(), states[4]));
    for (time, state) in times.into_iter().zip(&states) {
        assert!(largest_difference(state, &motion.at(time).unwrap()) < 1e-14, "{time} s");
    }
}

#[test]
fn the_table_never_lets_go_in_this_model() {
    // Sinking to a fraction of the tilt, where the steady law has long given up; the second is the toy of the shops.
    let unit = (A / G).sqrt();
    for (film, tilt, share) in [(1e-5, 0.1, 0.02), (8.1e-8, 0.02, 0.02), (1e-3, 0.4, 0.02)] {
        let disk = disk(film);
        let start = disk.steady(tilt).unwrap();
        let life = f64::powi(tilt, 3) / (8.0 * film) * unit;
        let (mut least, mut lowest, mut time) = (f64::INFINITY, tilt, 0.0);
        let mut now = start;
        while lowest > share * tilt && time < 4.0 * life {
            // Steps as short as the motion is fast.
            let step = 0.02 / (G / (A * now.tilt.sin())).sqrt();
            let times = [0.999 * step, step, 1.001 * step];
            let states = sinking(&disk, now, 1e-14).sample(&times).unwrap();
            let [before, here, after] = <[Rolling; 3]>::try_from(states).unwrap();
            // The table carries the weight and what lifts the centre, whose height is a sin α.
            let heights = [before, here, after].map(|s| A * s.tilt.sin());
            let lift = (heights[0] - 2.0 * heights[1] + heights[2]) / (1e-3 * step).powi(2);
            let support = disk.normal_force(&here) / (MASS * G);
            assert!((support - 1.0 - lift / G).abs() < 0.02, "{support} and {}", 1.0 + lift / G);
            (now, least, lowest, time) = (here, least.min(support), lowest.min(here.tilt), time + step);
        }
        assert!(lowest < share * tilt, "the disk has sunk to {lowest}");
        assert!((0.7..0.8).contains(&least), "{least}");
    }
}

#[test]
fn shear_fills_the_gap_of_the_toy_only_below_a_two_hundredth() {
    // Through a gap of height aα shear spreads in (aα)²ρ/μ, which is as long as 1/Ω where α^{3/2} = μ/(2ρ√(ga³)).
    let (radius, spread) = (0.0375_f64, 1.5e-5); // m, and μ/ρ of air, m²/s
    let parameters = DiskParameters { mass: 0.4, radius, moments: MomentFactors::DISK, gravity: G };
    let too_slow = |tilt: f64| {
        let rate = SpinningCoin::new(parameters, tilt).unwrap().turn_rate();
        (radius * tilt).powi(2) / spread > 1.0 / rate
    };
    assert!(!too_slow(4.7e-3) && too_slow(4.8e-3));
    let law = (spread / (2.0 * (G * radius.powi(3)).sqrt())).powf(2.0 / 3.0);
    assert!((4.7e-3..4.8e-3).contains(&law), "{law}");
}

#[test]
fn the_centre_of_a_steady_disk_rests_above_the_origin() {
    let disk = disk(0.0);
    for tilt in [0.05, 0.7, 1.4] {
        let start = disk.steady(tilt).unwrap();
        for state in sinking(&disk, start, 1e-16).sample(&[0.0, 0.1, 0.33]).unwrap() {
            assert!(state.centre.norm() < 1e-13 * A, "tilt {tilt}: {}", state.centre);
            // The contact lies a cos α from it, to the left of axis 1.
            let left = Complex::new(-state.heading.sin(), state.heading.cos());
            assert!((state.contact(A) - left * A * tilt.cos()).norm() < 1e-13 * A, "tilt {tilt}");
        }
    }
}

#[test]
fn what_lies_past_the_end_is_refused_at_once() {
    // At once: in less than the hundred thousand series after which it would be `Integration`, a fraction of a second.
    let (mass, radius) = (0.4, 0.0375);
    let steel = DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity: G };
    let toy = EulersDisk::in_air(steel, 1.78e-5).unwrap();
    let start = toy.steady(0.1).unwrap();
    let motion = sinking(&toy, start, 1e-13);
    let before = motion.at(95.8).unwrap();
    let refused = motion.sample(&[95.8, 1e9, 96.0]).unwrap_err();
    let Error::Quantity(InvalidQuantity {
        quantity: "time",
        value,
        rule: Rule::NotAbove { limit: end, .. },
        ..
    }) = refused
    else {
        panic!("{refused}")
    };
    // Moffatt's law gives it 95.37 s; near the end it is the slower, as the disk falls no faster than g lets it.
    assert!(value == 96.0 && (95.8..96.0).contains(&end), "{refused}");
    assert!(
        refused
            .to_string()
            .starts_with("time 96 s exceeds the end of the motion, where the film holds the disk fast, 95.8"),
        "{refused}"
    );
    // All turning has died out by then.
    assert!(before.omega_2.abs() < 1e-8);
    // Right after the end there is nothing, right before there is; it does not hang on the tolerance.
    let last = sinking(&toy, start, 1e-16).at(end - 1e-3).unwrap();
    assert!(last.tilt < before.tilt);
    assert!((last.tilt.sin() / (toy.film() / 500.0).powf(0.4) - 1.0).abs() < 0.1, "{}", last.tilt);
    assert!(matches!(sinking(&toy, start, 1e-9).at(end + 1e-3), Err(Error::Quantity(_))));

    // Films as thick as glue, and as thin as nothing; disks held from the start, and from rest.
    for film in [1e-30, 1e-6, 1e-3, 1.0, 1e30] {
        for tilt in [1e-4, 1.5] {
            let disk = disk(film);
            for start in [disk.steady(tilt).unwrap(), Rolling { tilt, ..Rolling::UPRIGHT }] {
                let motion = sinking(&disk, start, 1e-13);
                let refused = motion.at(1e20).unwrap_err();
                let held = film > 500.0 * tilt.sin().powf(2.5);
                match refused {
                    Error::Quantity(InvalidQuantity { rule: Rule::NotAbove { limit, .. }, .. }) => {
                        assert_eq!(limit == 0.0, held, "{film} {tilt}: {refused}");
                    }
                    Error::Integration(Failure::TooMuchWork { evaluations, .. }) => {
                        assert!(evaluations == 100_000 && film < 1e-3 && !held, "{film} {tilt}: {refused}");
                    }
                    _ => panic!("{refused}"),
                }
                assert_eq!(motion.at(0.0).unwrap(), start);
            }
        }
    }
}

#[test]
fn a_motion_is_given_up_after_so_many_series_as_the_caller_says() {
    let disk = disk(0.0);
    let start = disk.steady(0.01).unwrap();
    let by = |most: usize| {
        let solver = Taylor::new(1e-13).unwrap().with_max_expansions(most);
        disk.sinking(start, &solver).unwrap().at(100.0)
    };
    let refused = by(1000).unwrap_err();
    assert!(
        matches!(refused, Error::Integration(Failure::TooMuchWork { evaluations: 1000, .. })),
        "{refused}"
    );
    assert!((by(1_000_000).unwrap().tilt - 0.01).abs() < 1e-9);
    for tolerance in [2.0, 1e300] {
        let refused = disk.sinking(start, &Taylor::new(tolerance).unwrap()).unwrap_err();
        assert_eq!((refused.quantity, refused.rule), ("tolerance", Rule::AtMost(1.0)));
    }
}

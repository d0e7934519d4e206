//! The coin toss: equations (46) and (47), which face shows when, and the bias of a tossed coin.

use crate::common::any;
use approx::assert_relative_eq;
use mechanics::euler::{self, Turning};
use mechanics::inertia::{Body, Cylinder, PrincipalMoments};
use mechanics::integrate::Dop853;
use mechanics::scenes::coin_toss::{
    Face, Toss, TossCount, TossParameters, Tossers, TossersParameters, angle_for_probability, edge_at_random,
    ratio_for_probability, steady_face_ratio,
};
use nalgebra::{UnitQuaternion, Vector3};
use serde_json::Value;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

/// A thin coin; mass and radius drop out of everything.
fn coin() -> PrincipalMoments {
    Body::thin_disk(0.0075, 0.0122).expect("a coin").moments()
}

fn tossed(moments: PrincipalMoments, omega_1: f64, omega_3: f64) -> Toss {
    Toss::new(TossParameters { moments, omega_1, omega_3 }).expect("a coin that turns")
}

/// A body with I₃/I₁ from a pencil's to a plate's.
fn moments(random: &mut fastrand::Rng) -> PrincipalMoments {
    PrincipalMoments::symmetric(1.0, 0.05 + 1.95 * random.f64())
        .expect("an axial moment up to twice the other")
}

/// The same toss by Euler's equations, with no precession and no closed form.
fn simulated_turnings(moments: PrincipalMoments, omega_1: f64, omega_3: f64, times: &[f64]) -> Vec<Turning> {
    let start = Turning {
        world_from_body: UnitQuaternion::identity(),
        omega_body: Vector3::new(omega_1, 0.0, omega_3),
    };
    let free = euler::turning_rates(moments, |_, _| Vector3::zeros());
    let (states, _) = Dop853::new(1e-13).unwrap().sample(any(free), 0.0, start.to_array(), times).unwrap();
    states.into_iter().map(Turning::from_array).collect()
}

/// The normals of that toss.
fn simulated(moments: PrincipalMoments, omega_1: f64, omega_3: f64, times: &[f64]) -> Vec<Vector3<f64>> {
    simulated_turnings(moments, omega_1, omega_3, times).iter().map(Turning::axis_3_world).collect()
}

/// The angular momentum in the room of a thin disc of `mass` and `radius`, added up over its mass: twelve points of
/// equal weight have the disc's moments.
fn summed_momentum(mass: f64, radius: f64, turning: &Turning) -> Vector3<f64> {
    let omega = turning.omega_world();
    (0..12)
        .map(|n| {
            let (sin, cos) = (TAU * f64::from(n) / 12.0).sin_cos();
            let r = turning.world_from_body * Vector3::new(cos, sin, 0.0) * (radius / 2_f64.sqrt());
            r.cross(&omega.cross(&r)) * (mass / 12.0)
        })
        .sum()
}

#[test]
fn eq46_angular_momentum_stays_where_the_hand_left_it() {
    let mut random = fastrand::Rng::with_seed(46);
    let (mass, radius) = (0.0075, 0.0122_f64);
    let quarter = 0.25 * mass * radius * radius;
    for _ in 0..50 {
        let (omega_1, omega_3) = (random.f64() * 200.0 + 1.0, random.f64() * 100.0 + 1.0);
        let toss = tossed(coin(), omega_1, omega_3);
        // At the start, along axes that are the room's as well as the coin's.
        let stated = Vector3::new(omega_1, 0.0, 2.0 * omega_3) * quarter;
        let start = summed_momentum(mass, radius, &toss.at(0.0).unwrap());
        assert_relative_eq!(start, stated, max_relative = 1e-13);
        assert_relative_eq!(toss.momentum_angle().tan(), omega_1 / (2.0 * omega_3), max_relative = 1e-13);
        // And in the room it is still there when the coin stands quite differently: in the simulation and in the closed
        // form.
        let times = [0.05, 0.21, 0.45];
        for (time, simulated) in times.into_iter().zip(simulated_turnings(coin(), omega_1, omega_3, &times)) {
            for turning in [simulated, toss.at(time).unwrap()] {
                let now = summed_momentum(mass, radius, &turning);
                assert_relative_eq!(now, stated, epsilon = 1e-10 * stated.norm());
            }
        }
    }
}

#[test]
fn eq46_the_normal_of_a_simulated_coin_goes_round_the_angular_momentum() {
    let mut random = fastrand::Rng::with_seed(4646);
    for _ in 0..30 {
        let moments = moments(&mut random);
        let [transverse, _, axial] = moments.to_array();
        let (omega_1, omega_3) = (100.0 * random.f64() + 1.0, 100.0 * random.f64() - 50.0);
        let times: Vec<f64> = (1..=40).map(|n| 0.01 * f64::from(n)).collect();
        let toss = tossed(moments, omega_1, omega_3);
        let momentum = Vector3::new(transverse * omega_1, 0.0, axial * omega_3).normalize();
        let samples = toss.sample(&times).unwrap();
        let normals = simulated(moments, omega_1, omega_3, &times);
        for ((&time, normal), sample) in times.iter().zip(normals).zip(samples) {
            assert_relative_eq!(toss.normal(time).unwrap(), normal, epsilon = 2e-11);
            assert_relative_eq!(sample.axis_3_world(), normal, epsilon = 2e-11);
            assert_relative_eq!(normal.dot(&momentum), toss.momentum_angle().cos(), epsilon = 2e-11);
            let (sin, cos) = toss.momentum_angle().sin_cos();
            let height = cos * cos + sin * sin * (toss.precession_rate() * time).cos();
            assert_relative_eq!(normal.z, height, epsilon = 2e-11);
        }
    }
}

#[test]
fn eq47_a_simulated_coin_shows_its_other_face_below_the_threshold_only() {
    let mut random = fastrand::Rng::with_seed(47);
    for n in 0..40 {
        // The coin of the source, then bodies of every kind, two hundredths to either side of the threshold.
        let moments = if n == 0 { coin() } else { moments(&mut random) };
        let threshold = steady_face_ratio(moments).unwrap();
        if n == 0 {
            assert_eq!(threshold, 0.5);
        }
        for factor in [0.98, 1.02] {
            let toss = tossed(moments, 1.0, factor * threshold);
            let times: Vec<f64> = (0..=400).map(|n| 0.025 * f64::from(n)).collect();
            let lowest = simulated(moments, 1.0, factor * threshold, &times)
                .iter()
                .map(|normal| normal.z)
                .fold(1.0, f64::min);
            assert_eq!(lowest < 0.0, factor < 1.0, "lowest normal {lowest} at {factor} of the threshold");
            assert_eq!(toss.keeps_its_face(), factor > 1.0);
            assert!(lowest >= toss.lowest_normal() - 1e-10 && lowest < toss.lowest_normal() + 1e-3);
        }
    }
}

#[test]
fn eq47_at_the_threshold_the_angle_is_half_a_right_angle() {
    let toss = tossed(coin(), 2.0, 1.0);
    assert_relative_eq!(toss.momentum_angle(), FRAC_PI_4, max_relative = 1e-15);
    assert_eq!(toss.lowest_normal(), 0.0);
    assert!(toss.keeps_its_face() && toss.first_edge().is_none());
    assert_eq!(toss.same_face_probability(), 1.0);
    // A hair below it shows the other face, for as short a time as the hair is thin.
    for exponent in [-15, -10, -5] {
        let hair = 10_f64.powi(exponent);
        let toss = tossed(coin(), 2.0 * (1.0 + hair), 1.0);
        assert!(!toss.keeps_its_face());
        let missing = 1.0 - toss.same_face_probability();
        assert_relative_eq!(missing, 2.0 / PI * hair.sqrt(), max_relative = 0.12);
    }
}

#[test]
fn the_reference_toss_is_met_to_its_last_digits() {
    let file: Value = serde_json::from_str(include_str!("data/coin-toss.json")).expect("a valid file");
    assert_eq!(file["inputs"]["omega1"], "2 pi 38 rad/s");
    let value = |name: &str| file["values"][name].as_str().unwrap().parse::<f64>().unwrap();
    let toss = tossed(coin(), TAU * 38.0, TAU * 4.0);
    let normal = toss.normal(0.45).unwrap();
    // The phase is 110 rad; TAU·38 and 0.45 are rounded before the library sees them, which turns it by up to 3e-14.
    for (found, name) in [(normal.x, "n_x"), (normal.y, "n_y"), (normal.z, "n_z")] {
        assert_relative_eq!(found, value(name), epsilon = 3e-14);
    }
    assert_relative_eq!(toss.momentum_angle(), value("psi"), max_relative = 4e-16);
    assert_relative_eq!(toss.same_face_probability(), value("p_same"), max_relative = 4e-16);
    assert_relative_eq!(
        angle_for_probability(0.508).unwrap(),
        value("psi_for_p_0p508"),
        max_relative = 1e-15
    );
    let ratio = ratio_for_probability(coin(), 0.508).unwrap();
    assert_relative_eq!(ratio, value("omega3_over_omega1_for_0p508"), max_relative = 1e-14);
}

#[test]
fn the_same_face_is_up_for_that_part_of_a_simulated_precession() {
    let mut random = fastrand::Rng::with_seed(7);
    for _ in 0..20 {
        let moments = moments(&mut random);
        let threshold = steady_face_ratio(moments).unwrap();
        let toss = tossed(moments, 50.0, 50.0 * threshold * random.f64());
        let period = TAU / toss.precession_rate();
        let times: Vec<f64> = (0..2000).map(|n| period * (f64::from(n) + 0.5) / 2000.0).collect();
        let omega_3 = toss.at(0.0).unwrap().omega_body.z;
        let up = simulated(moments, 50.0, omega_3, &times).iter().filter(|normal| normal.z > 0.0).count();
        let p = toss.same_face_probability();
        assert!(
            (up as f64 / 2000.0 - p).abs() < 1.01 / 2000.0,
            "p = {p}, and {up} of 2000 moments show the face"
        );
        // On edge at the time that the closed form names, and not before.
        let edge = toss.first_edge().unwrap();
        let around = simulated(moments, 50.0, omega_3, &[0.999 * edge, edge, 1.001 * edge]);
        assert!(around[0].z > 0.0 && around[1].z.abs() < 1e-9 && around[2].z < 0.0);
        assert_eq!(toss.face(0.9 * edge).unwrap(), Face::Same);
        assert_eq!(toss.face(1.1 * edge).unwrap(), Face::Other);
    }
}

#[test]
fn a_coin_that_keeps_its_face_shows_no_other_at_any_time() {
    // At the threshold, half a precession after the start, the height is zero: a rounding below would be the other
    // face.
    let mut random = fastrand::Rng::with_seed(10);
    for _ in 0..300 {
        let spin = f64::from(random.u32(1..1000));
        let toss = tossed(coin(), 2.0 * spin, spin);
        assert!(toss.keeps_its_face());
        let half = PI / toss.precession_rate();
        for n in 0..20 {
            let time = half * f64::from(2 * n + 1) * (1.0 + f64::EPSILON * f64::from(n % 5 - 2));
            assert_ne!(toss.face(time).unwrap(), Face::Other, "{spin}, {n}");
        }
    }
}

#[test]
fn a_little_twist_makes_a_bias_that_goes_with_its_square() {
    // eq:small-twist; the next term of the arcsine is its argument, 4s², cubed and over six.
    for exponent in 1..=40 {
        let twist = 10_f64.powf(-0.1 * f64::from(exponent));
        let bias = tossed(coin(), 1.0, 0.4 * twist).same_face_probability() - 0.5;
        let square = 4.0 / PI * (0.4 * twist).powi(2);
        let next = (0.64 * twist * twist).powi(2) / 6.0;
        let rounding = f64::EPSILON / bias;
        assert!(
            bias > square * (1.0 + 0.9 * next) - rounding * square,
            "twist {twist}: {bias}, not above {square}"
        );
        assert!(
            bias < square * (1.0 + 1.5 * next) + rounding * square,
            "twist {twist}: {bias}, far above {square}"
        );
    }
}

#[test]
fn a_window_of_catches_is_off_by_no_more_than_a_part_over_its_length() {
    // eq:catch-window, by a count of moments in windows of every length and at every place.
    let mut random = fastrand::Rng::with_seed(11);
    let mut nearest = 0.0_f64;
    for n in 0..400 {
        let toss = tossed(coin(), 240.0, 120.0 * random.f64());
        let (p, period) = (toss.same_face_probability(), TAU / toss.precession_rate());
        // Every other window ends with just the part that shows the face, which is the worst it can.
        let whole = f64::from(random.u32(0..5));
        let (start, length) =
            if n % 2 == 0 { (-0.5 * p, whole + p) } else { (random.f64(), 5.0 * random.f64()) };
        let length = length.max(0.05);
        let moments = 20_000;
        let part = |k: i32| start + length * (f64::from(k) + 0.5) / f64::from(moments);
        let same = (0..moments).filter(|&k| toss.normal_height(part(k) * period).unwrap() > 0.0).count();
        let off = (same as f64 / f64::from(moments) - p).abs();
        let most = p * (1.0 - p) / length;
        assert!(off < most + 1e-3, "{off} with {length} precessions, and not {most}");
        nearest = nearest.max(off / most);
        if n % 2 == 0 {
            assert!(off > most - 1e-3, "the worst window is off by {off}, and not by {most}");
        }
    }
    assert!(nearest > 0.99);
}

/// The counts of 48 people, as they are kept: tosses that began with heads and with tails up, and how many of each
/// showed the same face.
fn counted() -> Vec<[u32; 4]> {
    let rows = include_str!("../book/coin-toss/flips.csv").lines();
    let rows = rows.filter(|line| !line.starts_with('#')).skip(1);
    let number = |cell: &str| cell.parse::<u32>().expect("a count");
    let rows: Vec<[u32; 4]> =
        rows.map(|row| row.split(',').map(number).collect::<Vec<_>>().try_into().expect("four")).collect();
    assert_eq!(rows.len(), 48);
    rows
}

fn people() -> Vec<TossCount> {
    let sum = |&[heads, heads_same, tails, tails_same]: &[u32; 4]| TossCount {
        same: heads_same + tails_same,
        other: heads + tails - heads_same - tails_same,
    };
    counted().iter().map(sum).collect()
}

fn tossers(mean: f64, spread: f64) -> Tossers {
    Tossers::new(TossersParameters { moments: coin(), mean, spread }).expect("a spread")
}

#[test]
fn one_angle_for_everybody_is_refuted_in_integers() {
    // Σ (kN − nK)²/(n K (N − K)) is eq:people-chi with p = K/N, and each numerator and denominator is a whole number.
    let people = people();
    let counts = people.iter().map(|counted| [counted.same, counted.other].map(i128::from));
    let (same, other) = counts.fold((0, 0), |sum, [same, other]| (sum.0 + same, sum.1 + other));
    let all = same + other;
    assert_eq!((same, all), (178_078, 350_757));
    let square = |counted: &TossCount| {
        let k = i128::from(counted.same);
        let n = k + i128::from(counted.other);
        let off = k * all - n * same;
        // To millionths.
        1_000_000 * off * off / (n * same * (all - same))
    };
    let millionths: i128 = people.iter().map(square).sum();
    assert_eq!(millionths / 100_000, 2652);
    assert_eq!(people.iter().filter(|counted| counted.same < counted.other).count(), 10);
    // One hand is alike with heads and with tails up.
    let differ: f64 = counted()
        .iter()
        .map(|&row| {
            let [n1, k1, n2, k2] = row.map(f64::from);
            let p = (k1 + k2) / (n1 + n2);
            (k1 / n1 - k2 / n2).powi(2) / (p * (1.0 - p) * (1.0 / n1 + 1.0 / n2))
        })
        .sum();
    assert_relative_eq!(differ, 47.86, max_relative = 1e-3);
}

#[test]
fn the_mean_over_people_is_that_of_a_count_and_of_its_series() {
    // Quadrature against people who are drawn.
    let mut random = fastrand::Rng::with_seed(48);
    for (mean, spread) in [(0.0, 0.09), (0.1, 0.05), (0.3, 0.2), (-0.45, 0.02), (0.0, 1.5)] {
        let count = 200_000;
        let drawn: f64 = (0..count)
            .map(|_| {
                let (radius, turn) = ((-2.0 * (1.0 - random.f64()).ln()).sqrt(), TAU * random.f64());
                tossed(coin(), 1.0, mean + spread * radius * turn.cos()).same_face_probability()
            })
            .sum::<f64>()
            / f64::from(count);
        assert_relative_eq!(tossers(mean, spread).same_face_probability(), drawn, epsilon = 2e-3);
    }
    // And against a plain sum over the twist, which knows of no corner.
    for (mean, spread) in [(0.0, 0.09), (0.2, 0.3_f64)] {
        let steps = 4_000_000;
        let width = 6.0 / f64::from(steps);
        let sum: f64 = (0..steps)
            .map(|n| {
                let s = width * (f64::from(n) + 0.5) - 3.0;
                let p = 0.5 + (4.0 * s * s).min(1.0).asin() / PI;
                (-0.5 * ((s - mean) / spread).powi(2)).exp() * p * width
            })
            .sum();
        let plain = sum / (spread * TAU.sqrt());
        assert_relative_eq!(tossers(mean, spread).same_face_probability(), plain, epsilon = 1e-8);
    }
    // asin x = x + x³/6 + …, and the mean of s⁶ is 15 S⁶.
    for spread in [0.001_f64, 0.003, 0.01, 0.03] {
        let x = 4.0 * spread * spread;
        let series = 0.5 + (x + 15.0 * x.powi(3) / 6.0) / PI;
        let next = 3.0 / 40.0 * 945.0 * x.powi(5);
        assert_relative_eq!(tossers(0.0, spread).same_face_probability(), series, epsilon = 1e-9 + next);
    }
}

/// The likelihood of eq:people-likelihood as a plain sum over the twist, by the formula for the bias.
fn plain_log_likelihood(
    people: &[TossCount],
    density: impl Fn(f64) -> f64,
    bias: impl Fn(f64) -> f64,
) -> f64 {
    let steps = 40_000;
    let nodes: Vec<(f64, f64)> = (0..steps)
        .map(|n| 2.0 * (f64::from(n) + 0.5) / f64::from(steps) - 1.0)
        .map(|s| (density(s), bias(s)))
        .collect();
    let total: f64 = nodes.iter().map(|node| node.0).sum();
    let of = |counted: &TossCount| {
        let (k, n) = (f64::from(counted.same), f64::from(counted.same) + f64::from(counted.other));
        let times = |p: f64| k * p.ln() + (n - k) * (1.0 - p).ln();
        let sum: f64 = nodes.iter().map(|(w, b)| w * (times(0.5 + b) - times(k / n)).exp()).sum();
        (sum / total).ln()
    };
    people.iter().map(of).sum()
}

#[test]
fn the_counts_want_a_bell_of_twists_about_zero_and_no_bell_of_probabilities() {
    let people = people();
    let bell = |x: f64| (-0.5 * x * x).exp();
    let arcsine = |s: f64| (4.0 * s * s).min(1.0).asin() / PI;
    for (mean, spread) in [(0.0, 0.09), (0.05, 0.078), (0.0, 0.04), (-0.02, 0.12)] {
        let plain = plain_log_likelihood(&people, |s| bell((s - mean) / spread), arcsine);
        let ours = tossers(mean, spread).log_likelihood(&people);
        assert_relative_eq!(ours, plain, epsilon = 1e-5);
    }
    let at = |spread: f64| tossers(0.0, spread).log_likelihood(&people);
    let best = at(0.0904);
    assert!(best > at(0.0894) && best > at(0.0914));
    assert_relative_eq!(best, -55.08, epsilon = 0.01);
    // Within two of the best from 0.073 to 0.114.
    assert!(at(0.0730) < best - 2.0 && at(0.0740) > best - 2.0);
    assert!(at(0.1135) > best - 2.0 && at(0.1145) < best - 2.0);
    // A mean other than zero gains nothing.
    for hundredth in 0..=10 {
        for spread in (50..=110).step_by(5) {
            let mean = 0.01 * f64::from(hundredth);
            assert!(tossers(mean, 0.001 * f64::from(spread)).log_likelihood(&people) < best + 0.001);
        }
    }
    let best_about = |mean: f64| {
        let of = |n: u32| tossers(mean, 0.002 * f64::from(n)).log_likelihood(&people);
        (25..=50).map(of).fold(f64::NEG_INFINITY, f64::max)
    };
    assert_relative_eq!(best - best_about(0.06), 0.7, epsilon = 0.05);
    assert_relative_eq!(best - best_about(0.08), 2.7, epsilon = 0.05);
    // Without the boldest, and with a bell whose tails fall exponentially.
    let without = |spread: f64| tossers(0.0, spread).log_likelihood(&people[..47]);
    assert!(without(0.0807) > without(0.0797) && without(0.0807) > without(0.0817));
    let exponential = plain_log_likelihood(&people, |s| (-s.abs() / 0.0647).exp(), arcsine);
    assert_relative_eq!(exponential - best, 0.28, epsilon = 0.03);
    // One probability for all, and a bell of probabilities at its best: the variable is p − 1/2 itself.
    let common = 178_078.0 / 350_757.0 - 0.5;
    let one = plain_log_likelihood(&people, |_| 1.0, |_| common);
    assert_relative_eq!(one, -133.08, epsilon = 0.01);
    let of = |middle: f64, width: f64| {
        plain_log_likelihood(&people, |b| bell((b - middle) / width), |b| b.clamp(-0.49, 0.49))
    };
    let best_bell = of(0.00996, 0.01562);
    assert_relative_eq!(best_bell, -72.76, epsilon = 0.01);
    assert!(best_bell > of(0.0109, 0.0156) && best_bell > of(0.0089, 0.0156));
    assert!(best_bell > of(0.00996, 0.0166) && best_bell > of(0.00996, 0.0146));
}

#[test]
fn a_person_whose_coin_never_flips_is_certain_to_show_the_same_face() {
    let surely = tossers(5.0, 0.1);
    assert_eq!(surely.same_face_probability(), 1.0);
    assert_eq!(surely.log_likelihood(&[TossCount { same: 7, other: 0 }]), 0.0);
    // By mpmath with 30 digits: somebody 45 standard deviations from the rest did it.
    let hardly = surely.log_likelihood(&[TossCount { same: 6, other: 1 }]);
    assert_relative_eq!(hardly, -1_017.924_073_687_279_4, epsilon = 1e-8);
    let message = |mean, spread| {
        Tossers::new(TossersParameters { moments: coin(), mean, spread }).unwrap_err().to_string()
    };
    assert!(message(f64::NAN, 0.1).contains("mean of twist over tumble"));
    assert!(message(0.0, 0.0).contains("spread of twist over tumble"));
}

/// Which side of a coin lies under its centre: 0 the one that was up, which is up, 1 the edge, 2 the other. The plumb
/// line from the centre leaves the coin through the side that it meets first.
fn side_below(coin: Cylinder, world_from_body: &UnitQuaternion<f64>) -> usize {
    let down = world_from_body.inverse() * -Vector3::z();
    let through_face = 0.5 * coin.height / down.z.abs();
    let through_edge = coin.radius / down.xy().norm();
    if through_edge < through_face {
        1
    } else if down.z < 0.0 {
        0
    } else {
        2
    }
}

#[test]
fn a_thick_coin_lands_on_the_side_that_a_simulation_finds_under_its_centre() {
    for (height, omega_1, omega_3) in
        [(0.2, 5.0, 0.0), (0.5, 5.0, 0.7), (1.2, 5.0, 1.5), (0.3, 5.0, 2.5), (0.2, 5.0, 4.0), (3.0, 5.0, 5.0)]
    {
        let coin = Cylinder { radius: 1.0, height };
        let moments = Body::cylinder(1.0, coin).unwrap().moments();
        let toss = tossed(moments, omega_1, omega_3);
        // Very many times within a long flight; how long a precession takes is nothing that this needs.
        let times: Vec<f64> = (0..200_000).map(|n| 1e-3 * f64::from(n)).collect();
        let mut counts = [0.0; 3];
        for state in simulated_turnings(moments, omega_1, omega_3, &times) {
            counts[side_below(coin, &state.world_from_body)] += 1.0 / 200_000.0;
        }
        let found = toss.landings(coin).unwrap();
        // A part of a precession is left over in 200 s, of some two hundred of them.
        for (found, counted) in [found.same, found.edge, found.other].into_iter().zip(counts) {
            assert_relative_eq!(found, counted, epsilon = 3e-3);
        }
        assert_relative_eq!(found.same + found.edge + found.other, 1.0, epsilon = 4e-16);
    }
}

#[test]
fn a_thin_coin_lands_on_its_edge_as_often_as_its_simulated_normal_is_within_the_band() {
    let shape = |ratio: f64| Cylinder { radius: 1.0, height: 2.0 * ratio };
    for omega_3 in [0.0, 0.3, 0.45] {
        let toss = tossed(coin(), 1.0, omega_3);
        // From one height to the next the normal moves straight on: how long is it inside the band |n| < sin β?
        let times: Vec<f64> =
            (0..=100_000).map(|n| f64::from(n) * TAU / toss.precession_rate() / 1e5).collect();
        let heights: Vec<f64> =
            simulated(coin(), 1.0, omega_3, &times).iter().map(|normal| normal.z).collect();
        let mut missed = Vec::new();
        for ratio in [1e-2_f64, 1e-3] {
            let border = ratio.atan().sin();
            let inside = heights.windows(2).map(|pair| {
                let [low, high] = [pair[0].min(pair[1]), pair[0].max(pair[1])];
                (high.min(border) - low.max(-border)).max(0.0) / (high - low).max(f64::MIN_POSITIVE)
            });
            let share = inside.sum::<f64>() / 1e5;
            missed.push((toss.thin_edge(shape(ratio)).unwrap().unwrap() / share - 1.0).abs());
        }
        // The limit is approached as the square of the thickness, the faster the farther the toss is from 45°.
        assert!(missed[0] < 5e-3 && missed[1] < 5e-5, "{missed:?} at a twist of {omega_3}");
    }
    // From 45° on it has none: ω₁ = 2 ω₃ for a thin disc.
    assert!(tossed(coin(), 1.0, 0.499).thin_edge(shape(0.01)).unwrap().is_some());
    assert_eq!(tossed(coin(), 1.0, 0.501).thin_edge(shape(0.01)).unwrap(), None);
    assert!(tossed(coin(), 1.0, 0.0).thin_edge(shape(f64::NAN)).is_err());
}

#[test]
fn a_coin_of_any_attitude_stands_on_its_edge_as_often_as_the_band_is_high() {
    let mut random = fastrand::Rng::with_seed(20);
    for height in [0.1, 2.0 / 8_f64.sqrt(), 3.0] {
        let coin = Cylinder { radius: 1.0, height };
        let mut edges = 0.0;
        for _ in 0..200_000 {
            // Four Gaussian numbers are a direction without preference in four dimensions.
            let [a, b] = [0, 1].map(|_| {
                let size = (-2.0 * (1.0 - random.f64()).ln()).sqrt();
                let (sin, cos) = (TAU * random.f64()).sin_cos();
                (size * cos, size * sin)
            });
            let attitude = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(a.0, a.1, b.0, b.1));
            edges += f64::from(u8::from(side_below(coin, &attitude) == 1)) / 200_000.0;
        }
        let expected = edge_at_random(coin).unwrap();
        let deviation = (expected * (1.0 - expected) / 200_000.0).sqrt();
        assert!((edges - expected).abs() < 3.5 * deviation, "{edges} against {expected}");
    }
    let third = edge_at_random(Cylinder { radius: 1.0, height: 2.0 / 8_f64.sqrt() }).unwrap();
    assert_relative_eq!(third, 1.0 / 3.0, epsilon = 1e-15);
}

#[test]
fn a_coin_without_thickness_never_stands_and_one_that_keeps_its_face_has_no_other_end() {
    let thin = Cylinder { radius: 1.0, height: 0.0 };
    let toss = tossed(coin(), 8.0, 1.0);
    assert_relative_eq!(toss.landings(thin).unwrap().same, toss.same_face_probability(), epsilon = 3e-16);
    assert_eq!(toss.landings(thin).unwrap().edge, 0.0);
    let steady = tossed(coin(), 1.0, 2.0).landings(Cylinder { radius: 1.0, height: 0.2 }).unwrap();
    assert_eq!((steady.same, steady.edge, steady.other), (1.0, 0.0, 0.0));
}

#[test]
fn the_edge_is_likeliest_for_the_toss_whose_normal_just_comes_so_low() {
    // A nickel, 21.21 mm by 1.95 mm, with the moments of a thin coin.
    let nickel = Cylinder { radius: 10.605, height: 1.95 };
    let sine = edge_at_random(nickel).unwrap();
    let edge_at = |lowest: f64| {
        let double: f64 = lowest.acos(); // 2θ_L
        let toss = tossed(coin(), 2.0 * (0.5 * double).sin(), (0.5 * double).cos());
        toss.landings(nickel).unwrap().edge
    };
    let best = edge_at(-sine);
    assert_relative_eq!(best, 0.268_641_071_646_464_8, epsilon = 1e-7);
    assert_relative_eq!(best, 2.0 / PI * (2.0 * sine / (1.0 - sine)).sqrt().atan(), epsilon = 1e-7);
    for n in 1..100 {
        let lowest = -1.0 + 0.02 * f64::from(n);
        assert!(edge_at(lowest) < best || (lowest + sine).abs() < 1e-9);
    }
}

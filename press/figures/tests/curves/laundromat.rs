//! The washing machine, held to formulas written out and to the library.

use crate::{PIXELS, distance, path};
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{Machine, Parameters};
use nalgebra::Complex;

fn machine(damping: f64, spin: f64) -> Machine {
    let damping = damping * 300.0;
    Machine::new(Parameters {
        drum_mass: 28.0,
        load_mass: 2.0,
        load_radius: 0.25,
        stiffness: 3000.0,
        damping,
        spin: spin * 10.0,
    })
    .expect("a machine")
}

/// A linear axis: two values and where they stand, px.
fn scale(from: (f64, f64), to: (f64, f64), value: f64) -> f64 {
    from.1 + (to.1 - from.1) * (value - from.0) / (to.0 - from.0)
}

#[test]
fn steady_curves_lie_on_the_formula() {
    let mut checked = 0;
    for damping in [0.2, 0.4, 0.7, 1.4] {
        let radius = path("steady", &format!("radius-{damping}"));
        let lead = path("steady", &format!("lead-{damping}"));
        for step in 1..500 {
            let ratio = 3.0 * f64::from(step) / 500.0 + 1e-4;
            let x = scale((0.0, 58.0), (3.0, 658.0), ratio);
            // eq:steady-radius and eq:steady-phase, written out here and not taken from the library.
            let detuning = 1.0 - ratio * ratio;
            let r = ratio * ratio / detuning.hypot(damping * ratio);
            let phase = (damping * ratio).atan2(detuning).to_degrees();
            assert!(distance(&radius, (x, scale((0.0, 296.0), (5.5, 34.0), r))) < PIXELS, "r at {ratio}");
            assert!(
                distance(&lead, (x, scale((0.0, 508.0), (180.0, 356.0), phase))) < PIXELS,
                "φ at {ratio}"
            );
            checked += 2;
        }
    }
    assert_eq!(checked, 4 * 499 * 2);
}

#[test]
fn torque_curves_lie_on_the_library() {
    for damping in [0.2, 0.4, 0.7, 1.4] {
        let curve = path("torque", &format!("torque-{damping}"));
        for step in 1..300 {
            let ratio = 3.0 * f64::from(step) / 300.0 - 1e-3;
            let torque = machine(damping, ratio).steady().expect("damped").motor_torque();
            let point = (scale((0.0, 58.0), (3.0, 658.0), ratio), scale((0.0, 278.0), (4.5, 34.0), torque));
            assert!(
                distance(&curve, point) < PIXELS,
                "Γ = {damping} ω₀, Ω = {ratio} ω₀: {}",
                distance(&curve, point)
            );
        }
    }
}

#[test]
fn all_curves_of_self_centring_pass_the_common_point() {
    let common = (scale((0.0, 58.0), (3.0, 658.0), 2.0_f64.sqrt()), scale((0.0, 264.0), (3.4, 34.0), 1.0));
    for name in ["radius-0.2-2", "radius-0.4", "radius-0.7", "radius-1.4"] {
        let curve = path("centring", name);
        assert!(distance(&curve, common) < PIXELS, "{name}");
    }
    for damping in ["0.4", "1.4"] {
        let printed = path("centring", &format!("printed-{damping}"));
        assert!(distance(&printed, common) > 3.0, "the source's formula misses it");
    }
}

#[test]
fn one_mode_fills_its_ring_and_no_more() {
    // 112 px are the steady radius; a disturbance of 0.3 leaves the ring from 0.7 to 1.3 of it.
    for (name, centre, swings) in
        [("path-0", 170.0, 7.0 * (1.0 + 1.0 / 3.3)), ("path-1", 510.0, 7.0 * (1.0 - 1.0 / 3.3))]
    {
        let radii: Vec<f64> =
            path("annulus", name).iter().map(|(x, y)| (x - centre).hypot(y - 166.0) / 112.0).collect();
        let (least, most) =
            radii.iter().fold((f64::MAX, 0.0_f64), |(low, high), &r| (low.min(r), high.max(r)));
        assert!((least - 0.7).abs() < 2e-3 && (most - 1.3).abs() < 2e-3, "{name}: {least} to {most}");
        // The radius swings with |Ω ± ω₁|: more often than the drum turns if the centre goes backwards, less often if
        // forwards.
        let maxima = radii.windows(3).filter(|r| r[1] > r[0] && r[1] >= r[2] && r[1] > 1.25).count() as f64;
        assert!((maxima - swings).abs() < 1.0, "{name}: {maxima} swings for {swings}");
    }
}

#[test]
fn the_ramps_lie_on_an_integration_of_their_equation() {
    for per_square in [0.1, 0.01, 0.001] {
        let curve = path("ramp", &format!("ramp-{per_square}"));
        // With ω₀ = b = 1 and Γ = 0.02: z̈ + Γż + z = (φ̇² − iφ̈) e^{iφ}, written out here.
        let rates = |t: f64, &[x, y, vx, vy]: &[f64; 4]| {
            let (spin, angle) = (per_square * t, Complex::new(0.0, 0.5 * per_square * t * t).exp());
            let push = Complex::new(spin * spin, -per_square) * angle;
            [vx, vy, push.re - x - 0.02 * vx, push.im - y - 0.02 * vy]
        };
        let times: Vec<f64> = (1..=400).map(|n| f64::from(n) * 2.49 / 400.0 / per_square).collect();
        let (states, _) = Dop853::new(1e-10).unwrap().sample(rates, 0.0, [0.0; 4], &times).unwrap();
        for (t, [x, y, ..]) in times.iter().zip(states) {
            let spin = scale((0.0, 58.0), (2.5, 658.0), per_square * t);
            let point = (spin, scale((0.0, 346.0), (30.0, 34.0), x.hypot(y)));
            assert!(distance(&curve, point) < PIXELS, "{per_square} at {t}: {}", distance(&curve, point));
        }
    }
}

#[test]
fn on_a_line_of_the_map_the_largest_swing_of_an_integrated_ramp_is_the_same() {
    let mut checked = 0;
    for level in [2.0, 3.0, 5.0, 10.0, 20.0, 50.0] {
        let line = path("ramp-map", &format!("swing-{level}"));
        for &(x, y) in line.iter().step_by(line.len() / 5) {
            let per_square = 10_f64.powf(scale((58.0, -4.0), (658.0, 0.0), x));
            let damping = 10_f64.powf(scale((418.0, -2.0), (34.0, 0.0), y));
            // With ω₀ = b = 1: z̈ + Γż + z = (φ̇² − iφ̈) e^{iφ}, written out here, until the spin is far beyond the
            // resonance.
            let rates = |t: f64, &[x, y, vx, vy]: &[f64; 4]| {
                let (spin, angle) = (per_square * t, Complex::new(0.0, 0.5 * per_square * t * t).exp());
                let push = Complex::new(spin * spin, -per_square) * angle;
                [vx, vy, push.re - x - damping * vx, push.im - y - damping * vy]
            };
            let end = (1.6 + 6.0 * per_square.sqrt()) / per_square;
            let times: Vec<f64> = (1..=4000).map(|n| f64::from(n) * end / 4000.0).collect();
            let (states, _) = Dop853::new(1e-9).unwrap().sample(rates, 0.0, [0.0; 4], &times).unwrap();
            let largest = states.iter().map(|[x, y, ..]| x.hypot(*y)).fold(0.0, f64::max);
            assert!((largest / level - 1.0).abs() < 4e-3, "{per_square} {damping}: {largest} for {level}");
            checked += 1;
        }
    }
    assert!(checked > 30, "{checked}");
}

#[test]
fn the_displaced_circle_shrinks_towards_o_as_its_mode_decays() {
    let centre = path("displaced", "centre");
    let distance = |point: Option<&(f64, f64)>| {
        point.map(|(x, y)| (x - 246.0).hypot(y - 166.0) / 116.0).expect("a point")
    };
    let (first, last) = (distance(centre.first()), distance(centre.last()));
    // e^(−Γt/2) over two turns of the drum at Ω = 20 ω₀ with Γ = 0.3 ω₀: t = 4π/Ω.
    let decay = (-0.15 * 2.0 * std::f64::consts::TAU / 20.0).exp();
    assert!((first - 0.4).abs() < 2e-3 && (last / first - decay).abs() < 2e-3, "{first} {last}");
}

#[test]
fn eigenvalues_end_where_the_polynomials_vanish() {
    let real = |x: f64, left: f64| scale((left, -0.4), (left + 262.0, 0.2), x);
    let imaginary = |y: f64| scale((368.0, -4.2), (34.0, 4.2), y);
    let (mut growing, mut through_zero) = (0, 0);
    for index in 0..4 {
        for (x, _) in path("eigenvalues", &format!("path-whole-{index}")) {
            assert!((real(x, 58.0) + 0.15).abs() < 2e-4, "all decay as e^(−Γt/2)");
        }
        let points = path("eigenvalues", &format!("path-radial-{index}"));
        let s = points.last().map(|&(x, y)| Complex::new(real(x, 398.0), imaginary(y))).expect("a path");
        // eq:radial-damping-quartic at Ω = 3 ω₀ with Γ = 0.3 ω₀, in units of ω₀.
        let (kappa, spin, damping) = (1.0 - 9.0, 3.0, 0.3);
        let value = s.powi(4)
            + s.powi(3) * damping
            + s.powi(2) * (2.0 * kappa + 4.0 * spin * spin)
            + s * (damping * kappa)
            + kappa * kappa;
        let slope = s.powi(3) * 4.0
            + s.powi(2) * (3.0 * damping)
            + s * (2.0 * (2.0 * kappa + 4.0 * spin * spin))
            + damping * kappa;
        assert!((value / slope).norm() < 5e-4, "{s} is no root: off by {}", (value / slope).norm());
        growing += i32::from(s.re > 0.0);
        through_zero += i32::from(distance(&points, (398.0 + 262.0 * 0.4 / 0.6, 201.0)) < 0.2);
    }
    assert_eq!((growing, through_zero), (2, 2));
}

#[test]
fn what_the_descriptions_say_in_numbers_is_so() {
    let torque = path("torque", "torque-0.2");
    let value = |y: f64| scale((278.0, 0.0), (34.0, 4.5), y);
    let peak = torque.iter().map(|point| value(point.1)).fold(0.0, f64::max);
    let valley =
        torque.iter().filter(|point| point.0 > 300.0).map(|point| value(point.1)).fold(9.0, f64::min);
    assert!((peak - 4.3).abs() < 0.05 && valley < 0.6, "{peak} {valley}");

    let leaves = path("locked", "locked").last().map(|point| scale((58.0, 0.0), (658.0, 2.5), point.0));
    assert!(leaves.is_some_and(|time| (time - 0.25).abs() < 0.02), "{leaves:?}");
    let rest = path("locked", "free").last().map(|point| scale((268.0, 0.0), (34.0, 5.0), point.1));
    let steady = machine(0.3, 1.5).steady().expect("damped");
    assert!(
        rest.is_some_and(|r| (r - steady.radius() * 60.0).abs() < 0.05 && (r - 1.7).abs() < 0.05),
        "{rest:?}"
    );

    let radius = |point: &(f64, f64)| (point.0 - 266.0).hypot(point.1 - 162.0) / 78.0;
    assert!(path("start", "steady").iter().all(|point| (radius(point) - 1.118).abs() < 2e-3));
    let furthest = path("start", "loops").iter().map(radius).fold(0.0, f64::max);
    assert!((3.7..4.0).contains(&furthest), "{furthest}");

    let exponent = |point: &(f64, f64)| scale((308.0, -12.0), (34.0, 0.0), point.1);
    let polar = path("polar-fault", "polar");
    let [first, last] = [polar.first(), polar.last()].map(|point| point.expect("a point"));
    let nearest = 10_f64.powf(scale((66.0, -5.0), (658.0, -1.0), first.0));
    assert!((nearest - 5e-4).abs() < 1e-4, "the last number comes at half a millimetre, not {nearest}");
    assert!(exponent(first) > -2.3 && exponent(last) < -9.0);
    let cartesian = path("polar-fault", "cartesian");
    assert!(cartesian.iter().all(|point| (exponent(point) - 3e-11_f64.log10()).abs() < 0.15));
}

#[test]
fn the_measurements_say_what_the_figure_claims() {
    // Rows of: problem, contestant, method, setting, error, evaluations, ...
    let rows: Vec<Vec<&str>> = include_str!("../../../../book/speed-and-accuracy/measured.csv")
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>())
        .filter(|row| row[0] == "washer" && row[1] == "mechanics")
        .collect();
    assert!(rows.len() > 15);
    let value = |row: &[&str], column: usize| row[column].parse::<f64>().expect("a number");
    let find =
        |setting: &str| rows.iter().find(|row| row[3] == setting).unwrap_or_else(|| panic!("{setting}"));
    let (closed, others): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row[2] == "closed form");
    let [closed] = closed[..] else { panic!("one line for the closed form") };
    assert!(others.iter().all(|row| value(row, 4) > value(closed, 4)), "the closed form is the most exact");
    // Timings vary from machine to machine, and nothing asserts on them; evaluations do not.
    let dop853 = value(find("tolerance 1e-10"), 5) / value(find("tolerance 1e-6"), 5);
    assert!((2.7..3.3).contains(&dop853), "{dop853} times the evaluations for four digits");
    let (coarse, fine) = (find("50 steps a sample"), find("400 steps a sample"));
    let digits = (value(coarse, 4) / value(fine, 4)).log10();
    let rk4 = (value(fine, 5) / value(coarse, 5)).powf(4.0 / digits);
    assert!((9.0..11.0).contains(&rk4), "{rk4} times the evaluations for four digits");
}

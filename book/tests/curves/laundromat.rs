//! The washing machine: what the library says of it where no figure samples it, and what the page says of the curves.

use crate::{curve, lies_on, passes};
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use nalgebra::Complex;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_4, TAU};

fn machine(damping: f64, spin: f64) -> Machine {
    Machine::new(MachineParameters {
        drum_mass: 28.0,
        load_mass: 2.0,
        load_radius: 0.25,
        stiffness: 3000.0,
        damping: damping * 300.0,
        spin: spin * 10.0,
    })
    .expect("a machine")
}

#[test]
fn steady_curves_and_growths_lie_on_the_library() {
    for damping in [0.1, 1.0] {
        let steady = |ratio| machine(damping, ratio).steady().expect("damped");
        lies_on("steady", &format!("radius-{damping}"), |ratio| 60.0 * steady(ratio).radius());
        lies_on("steady", &format!("lead-{damping}"), |ratio| steady(ratio).phase().to_degrees());
        lies_on("torque", &format!("torque-{damping}"), |ratio| steady(ratio).motor_torque());
    }
    for (name, floor, board) in
        [("floor", 0.3, 0.0), ("third", 0.3, 0.1), ("equal", 0.3, 0.3), ("board", 0.0, 0.3)]
    {
        lies_on("whirl-growth", name, |ratio| {
            machine(floor, ratio).rotor(300.0 * board).expect("a rotor").growth() / 10.0
        });
    }
    lies_on("whirl-growth", "radial", |ratio| {
        let roots = machine(0.3, ratio).radial_damping_matrix().complex_eigenvalues();
        roots.iter().map(|root| root.re).fold(f64::MIN, f64::max) / 10.0
    });
}

#[test]
fn all_curves_of_self_centring_pass_the_common_point() {
    let common = (2.0_f64.sqrt(), 1.0);
    for name in ["radius-0.1-2", "radius-0.3", "radius-1"] {
        passes("centring", name, [common]);
    }
    assert!(curve("centring", "spring").distance(common) > 3.0, "the spring's force alone misses it");
}

#[test]
fn one_mode_fills_its_ring_and_no_more() {
    // A disturbance of 0.3 leaves the ring from 0.7 to 1.3 of the steady radius, eq:steady-radius without damping.
    let steady = 3.3 * 3.3 / (3.3 * 3.3 - 1.0) / 60.0;
    for (name, swings) in [("path-0", 7.0 * (1.0 + 1.0 / 3.3)), ("path-1", 7.0 * (1.0 - 1.0 / 3.3))] {
        let path = curve("annulus", name).values();
        let radii: Vec<f64> = path.iter().map(|(x, y)| x.hypot(*y) / steady).collect();
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
fn two_circles_as_large_make_hearts_or_petals() {
    for (name, sense) in [("hearts", 1.0), ("petals", -1.0)] {
        let sum = (0..200).map(|step| {
            let angle = TAU * f64::from(step) / 200.0;
            let [(one, up), (other, aside)] = [(3.0 * angle).sin_cos(), (sense * angle).sin_cos()];
            (up + aside, one + other)
        });
        passes("petals", name, sum);
    }
}

#[test]
fn the_ramps_lie_on_their_closed_form() {
    for per_square in [0.1, 0.01, 0.001] {
        let machine = machine(0.02, 0.0);
        let motion = machine.ramp(100.0 * per_square, Shaft::AT_REST).expect("a ramp");
        let spins = (1..=400).map(|n| 2.49 * f64::from(n) / 400.0);
        passes(
            "ramp",
            &format!("ramp-{per_square}"),
            spins.map(|spin| {
                let shaft = motion.at(0.1 * spin / per_square).expect("a time").position.norm();
                (spin, shaft / machine.offset())
            }),
        );
    }
}

#[test]
fn the_drum_that_speeds_up_goes_out_and_in() {
    let motion = machine(0.3, 0.0).ramp(2.5, Shaft::AT_REST).expect("a ramp");
    let centimetres = |time: f64| motion.at(time).expect("a time").position * 100.0;
    let times = |from: u32, to: u32| (from..to).map(|n| f64::from(n) / 100.0);
    for (path, trace, from, to) in [("outwards", "swells", 1, 501), ("inwards", "shrinks", 501, 1300)] {
        passes("start", path, times(from, to).map(|time| (centimetres(time).re, centimetres(time).im)));
        passes("start", trace, times(from, to).map(|time| (time, centimetres(time).re)));
    }
    let swing = |time: f64| centimetres(time).norm();
    let widest = times(1, 1300).max_by(|a, b| swing(*a).total_cmp(&swing(*b))).expect("times");
    assert!((5.0..6.0).contains(&swing(widest)) && (4.9..5.1).contains(&widest), "{widest} s");
    assert!((2.5 * widest * 60.0 / TAU - 120.0).abs() < 2.0, "turns a minute at {widest} s");
    let last = times(1281, 1300).map(swing).fold(0.0, f64::max);
    assert!((last - 1.85).abs() < 0.05, "{last}");
}

#[test]
fn the_floor_feels_spring_and_damper_at_right_angles() {
    let force = |damping: f64, spin: f64| {
        let steady = machine(damping, spin / 10.0).steady().expect("damped");
        steady.radius() * 3000_f64.hypot(damping * 300.0 * spin)
    };
    for (damping, name) in [(0.1, "0.1"), (0.3, "0.3"), (1.0, "1")] {
        let spins = (0..100).map(|step| 12.0 + 63.0 * f64::from(step) / 100.0);
        passes("floor-force", &format!("force-{name}"), spins.map(|spin| (spin, force(damping, spin))));
    }
    passes("floor-force", "rigid", [(20.0, 200.0)]);
    // What page and description say.
    let spins = |from: u32, to: u32| (from..to).map(|step| f64::from(step) / 100.0);
    let most = |damping: f64, to| spins(100, to).map(|spin| force(damping, spin)).fold(0.0, f64::max);
    assert!((most(0.1, 1200) - 510.0).abs() < 8.0 && (most(0.3, 1200) - 176.0).abs() < 1.0);
    assert!(most(1.0, 12_500) > 400.0);
    let least = spins(1201, 12_500).min_by(|a, b| force(0.3, *a).total_cmp(&force(0.3, *b))).expect("spins");
    assert!((least - 25.0).abs() < 0.5 && (force(0.3, least) - 74.0).abs() < 0.5, "{least}");
    assert!((force(0.3, 125.0) - 195.0).abs() < 3.0 && force(0.1, 125.0) < 85.0);
}

#[test]
fn one_kick_is_a_swing_in_the_room_and_a_rosette_on_the_drum() {
    let machine = machine(0.2, 2.2);
    let steady = machine.steady().expect("damped").amplitude();
    let kick = Complex::from(10.0 * steady.norm());
    let velocity = steady * Complex::new(0.0, machine.spin()) + kick;
    let motion = machine.transient(Shaft { position: steady, velocity }).expect("a motion");
    let apart = |time: f64| motion.at(time).expect("a time").position - steady * machine.load_direction(time);
    let pair = |z: Complex<f64>| (z.re, z.im);
    let times = || (1..=200).map(|n| f64::from(n) * 0.02);
    passes("frames", "room", times().map(|time| pair(apart(time))));
    let on_the_drum = times().map(|time| pair(apart(time) * machine.load_direction(time).conj()));
    passes("frames", "turning", on_the_drum);
}

#[test]
fn on_a_line_of_the_map_the_largest_swing_of_the_ramp_is_the_same() {
    let mut checked = 0;
    for level in [2.0, 3.0, 5.0, 10.0, 20.0, 50.0] {
        let line = curve("ramp-map", &format!("swing-{level}")).values();
        for &(per_square, damping) in line.iter().step_by(line.len() / 5) {
            let machine = machine(damping, 0.0);
            let motion = machine.ramp(100.0 * per_square, Shaft::AT_REST).expect("a ramp");
            // Until the spin is far beyond the resonance.
            let end = 0.1 * (1.6 + 6.0 * per_square.sqrt()) / per_square;
            let times: Vec<f64> = (1..=4000).map(|n| f64::from(n) * end / 4000.0).collect();
            let shafts = motion.sample(&times).expect("times");
            let largest =
                shafts.iter().map(|shaft| shaft.position.norm()).fold(0.0, f64::max) / machine.offset();
            assert!((largest / level - 1.0).abs() < 4e-3, "{per_square} {damping}: {largest} for {level}");
            checked += 1;
        }
    }
    assert!(checked > 30, "{checked}");
}

#[test]
fn eigenvalues_are_where_the_polynomials_vanish() {
    let (damping, mut growing) = (0.3, 0);
    for spin in [0.37, 0.83, 1.21, 1.9, 2.7] {
        for which in ["least", "most"] {
            let growth = curve("eigenvalues", &format!("growth-whole-{which}")).value(spin);
            assert!((growth + 0.15).abs() < 1e-3, "all decay as e^(−Γt/2)");
            let part = |what: &str| curve("eigenvalues", &format!("{what}-radial-{which}")).value(spin);
            let s = Complex::new(part("growth"), part("frequency"));
            let kappa = 1.0 - spin * spin;
            // s⁴ + γs³ + (2κ + 4Ω²)s² + γκs + κ², and its slope.
            let middle = 2.0 * kappa + 4.0 * spin * spin;
            let value = (((s + damping) * s + middle) * s + damping * kappa) * s + kappa * kappa;
            let slope = ((s * 4.0 + 3.0 * damping) * s + 2.0 * middle) * s + damping * kappa;
            assert!((value / slope).norm() < 4e-3, "{s} is no root: off by {}", (value / slope).norm());
            growing += i32::from(s.re > 0.0);
        }
    }
    assert_eq!(growing, 3, "one grows at each spin above the natural frequency");
}

/// The stall torque, N·m, at which a spin can last: γ b² Ω⁵/D² over 1 − Ω/40, for the chapter's machine with half its
/// damper.
fn stall_torque(spin: f64) -> f64 {
    let d = (100.0 - spin * spin).hypot(1.5 * spin);
    45.0 / 3600.0 * spin.powi(5) / (d * d) / (1.0 - spin / 40.0)
}

#[test]
fn the_motor_meets_the_shaking_and_jumps_where_the_formula_says() {
    let spins = |from: u32, to: u32| (from..=to).map(|n| 0.1 * f64::from(n));
    passes(
        "motor-line",
        "shaking",
        spins(3, 399).map(|spin| (spin, stall_torque(spin) * (1.0 - spin / 40.0))),
    );
    // The broken lines end at 40 and touch: the least torque above the valley, the largest on the hill.
    let hill = spins(1, 130).map(stall_torque).fold(0.0, f64::max);
    let valley = spins(131, 397).map(stall_torque).fold(f64::MAX, f64::min);
    for (name, torque) in [("line-up", hill), ("line", 4.0), ("line-down", valley)] {
        passes("motor-line", name, [(0.0, torque), (20.0, 0.5 * torque)]);
    }
    for (name, from, to) in [("stuck", 50, 100), ("middle", 102, 177), ("fast", 178, 374)] {
        passes("motor-hysteresis", name, spins(from, to).map(|spin| (stall_torque(spin), spin)));
    }
    // The simulated points: on the formula, and above the middle branch or below it as the knob's past wants.
    for (name, ends) in [("up", 7.53), ("down", 0.84)] {
        let points = curve("motor-hysteresis", name).values();
        assert!(points.len() > 8, "{}", points.len());
        for &(torque, spin) in &points {
            assert!((stall_torque(spin) / torque - 1.0).abs() < 0.05, "{name}: {torque} {spin}");
            assert_eq!(spin > 14.0, torque > ends, "{name}: {torque} {spin}");
        }
    }
}

#[test]
fn what_the_descriptions_say_in_numbers_is_so() {
    let end = |figure: &str, name: &str| curve(figure, name).values().last().copied().expect("a point");
    let (leaves, _) = end("locked", "locked");
    assert!((leaves - 0.25).abs() < 0.02, "{leaves}");
    let (_, rest) = end("locked", "free");
    assert!((rest - 1.7).abs() < 0.05, "{rest}");

    let polar = curve("polar-fault", "polar").values();
    let [(nearest, first), (_, last)] = [polar[0], polar[polar.len() - 1]];
    assert!((nearest - 5e-4).abs() < 1e-4, "the last number comes at half a millimetre, not {nearest}");
    assert!(first.log10() > -2.3 && last.log10() < -9.0);
    let cartesian = curve("polar-fault", "cartesian").values();
    assert!(cartesian.iter().all(|point| (point.1 / 3e-11).log10().abs() < 0.15));
}

/// The integral of e^{iu²/2} from long ago to `end` over the whole, by the middle-point rule.
fn cornu(end: f64) -> Complex<f64> {
    let steps = 4000;
    let h = end / f64::from(steps);
    let sum: Complex<f64> =
        (0..steps).map(|n| Complex::from_polar(h, 0.5 * (h * (f64::from(n) + 0.5)).powi(2))).sum();
    Complex::from_polar(0.5, FRAC_PI_4) + sum / TAU.sqrt()
}

#[test]
fn a_slow_passage_goes_along_cornus_spiral_and_overshoots() {
    let places = (0..300).map(|step| cornu(-6.9 + 15.8 * f64::from(step) / 300.0));
    passes("cornu", "spiral", places.map(|place| (place.re, place.im)));
    let spiral = curve("cornu", "spiral").values();
    let farthest = spiral.into_iter().map(|(x, y)| x.hypot(y)).fold(0.0, f64::max);
    assert!((farthest - 1.1707).abs() < 2e-3, "{farthest}");

    // The largest swing over what the passage leaves, b√(π/2α) with ω₀ = b = 1.
    let overshoot = curve("overshoot", "overshoot");
    for root in [0.05_f64, 0.1, 0.15] {
        let rate = root * root;
        let machine = machine(0.0, 0.0);
        let motion = machine.ramp(100.0 * rate, Shaft::AT_REST).expect("a ramp");
        let times: Vec<f64> = (0..2000).map(|n| 0.1 / rate + 0.4 / root * f64::from(n) / 2000.0).collect();
        let shafts = motion.sample(&times).expect("times");
        let largest = shafts.iter().map(|shaft| shaft.position.norm()).fold(0.0, f64::max) / machine.offset();
        let factor = largest * root * FRAC_2_PI.sqrt();
        // Between two of the computed accelerations the small waves are a little higher or lower.
        assert!(overshoot.distance((root, factor)) < 1.0, "{root}: {factor}");
        passes("overshoot", "line", [(root, 1.170_659 + 0.598_41 * root)]);
    }
}

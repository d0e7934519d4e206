//! The washing machine: what the library says of it where no figure samples it.

use crate::{PIXELS, curve};
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use nalgebra::Complex;
use std::f64::consts::TAU;

fn machine(damping: f64, spin: f64) -> Machine {
    let damping = damping * 300.0;
    Machine::new(MachineParameters {
        drum_mass: 28.0,
        load_mass: 2.0,
        load_radius: 0.25,
        stiffness: 3000.0,
        damping,
        spin: spin * 10.0,
    })
    .expect("a machine")
}

#[test]
fn steady_curves_lie_on_the_library() {
    for damping in [0.2, 0.4, 0.7, 1.4] {
        let [radius, lead] = ["radius", "lead"].map(|name| curve("steady", &format!("{name}-{damping}")));
        let torque = curve("torque", &format!("torque-{damping}"));
        for step in 1..300 {
            let ratio = 3.0 * f64::from(step) / 300.0 - 1e-3;
            let machine = machine(damping, ratio);
            let steady = machine.steady().expect("damped");
            for (drawn, value) in [
                (&radius, steady.radius() / machine.offset()),
                (&lead, steady.phase().to_degrees()),
                (&torque, steady.motor_torque()),
            ] {
                let off = drawn.distance((ratio, value));
                assert!(off < PIXELS, "Γ = {damping} ω₀, Ω = {ratio} ω₀: {off}");
            }
        }
    }
}

#[test]
fn all_curves_of_self_centring_pass_the_common_point() {
    let common = (2.0_f64.sqrt(), 1.0);
    for name in ["radius-0.2-2", "radius-0.4", "radius-0.7", "radius-1.4"] {
        assert!(curve("centring", name).distance(common) < PIXELS, "{name}");
    }
    for damping in ["0.4", "1.4"] {
        let spring = curve("centring", &format!("spring-{damping}"));
        assert!(spring.distance(common) > 3.0, "the spring's force alone misses it");
    }
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
fn the_ramps_lie_on_their_closed_form() {
    for per_square in [0.1, 0.01, 0.001] {
        let curve = curve("ramp", &format!("ramp-{per_square}"));
        let machine = machine(0.02, 0.0);
        let motion = machine.ramp(100.0 * per_square, Shaft::AT_REST).expect("a ramp");
        for n in 1..=400 {
            let spin = 2.49 * f64::from(n) / 400.0;
            let shaft = motion.at(0.1 * spin / per_square).expect("a time").position.norm();
            let off = curve.distance((spin, shaft / machine.offset()));
            assert!(off < PIXELS, "{per_square} at {spin}: {off}");
        }
    }
}

#[test]
fn the_drum_that_speeds_up_goes_out_and_in() {
    let motion = machine(0.3, 0.0).ramp(2.5, Shaft::AT_REST).expect("a ramp");
    let centimetres = |time: f64| motion.at(time).expect("a time").position * 100.0;
    let times: Vec<f64> = (1..1300).map(|n| f64::from(n) / 100.0).collect();
    let names = ["outwards", "inwards", "swells", "shrinks"];
    let [outwards, inwards, swells, shrinks] = names.map(|name| curve("start", name));
    for &t in &times {
        let z = centimetres(t);
        let (path, trace) = if t <= 5.0 { (&outwards, &swells) } else { (&inwards, &shrinks) };
        assert!(path.distance((z.re, z.im)) < PIXELS && trace.distance((t, z.re)) < PIXELS, "at {t} s");
    }
    let swing = |t: &f64| centimetres(*t).norm();
    let widest = times.iter().max_by(|a, b| swing(a).total_cmp(&swing(b))).expect("times");
    assert!((5.0..6.0).contains(&swing(widest)) && (4.9..5.1).contains(widest), "{widest} s");
    assert!((2.5 * widest * 60.0 / TAU - 120.0).abs() < 2.0, "turns a minute at {widest} s");
    let last = times.iter().filter(|t| **t > 12.8).map(swing).fold(0.0, f64::max);
    assert!((last - 1.85).abs() < 0.05, "{last}");
}

#[test]
fn the_floor_feels_spring_and_damper_at_right_angles() {
    let force = |damping: f64, spin: f64| {
        let steady = machine(damping, spin / 10.0).steady().expect("damped");
        steady.radius() * 3000_f64.hypot(damping * 300.0 * spin)
    };
    for (damping, name) in [(0.1, "0.1-2"), (0.3, "0.3"), (1.0, "1")] {
        let drawn = curve("floor-force", &format!("force-{name}"));
        for step in 0..100 {
            let spin = 12.0 + 63.0 * f64::from(step) / 100.0;
            let off = drawn.distance((spin, force(damping, spin)));
            assert!(off < PIXELS, "Γ = {damping} ω₀ at {spin}: {off}");
        }
    }
    let rigid = curve("floor-force", "rigid");
    assert!(rigid.distance((20.0, 200.0)) < PIXELS);
    // What page and description say.
    let spins = || (100..12_500).map(|step| f64::from(step) / 100.0);
    let most =
        |damping: f64| spins().map(|spin| force(damping, spin)).take_while(|_| true).fold(0.0, f64::max);
    let peak = |damping: f64| spins().take(1100).map(|spin| force(damping, spin)).fold(0.0, f64::max);
    assert!((peak(0.1) - 510.0).abs() < 8.0 && (peak(0.3) - 176.0).abs() < 1.0 && most(1.0) > 400.0);
    let least =
        spins().filter(|&spin| spin > 12.0).min_by(|a, b| force(0.3, *a).total_cmp(&force(0.3, *b))).unwrap();
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
    let [room, turning] = ["room", "turning"].map(|name| curve("frames", name));
    for t in (1..=200).map(|n| f64::from(n) * 0.02) {
        let direction = machine.load_direction(t);
        let apart = motion.at(t).expect("a time").position - steady * direction;
        let on_the_drum = apart * direction.conj();
        assert!(room.distance((apart.re, apart.im)) < PIXELS, "in the room at {t} s");
        assert!(turning.distance((on_the_drum.re, on_the_drum.im)) < PIXELS, "on the drum at {t} s");
    }
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
fn eigenvalues_end_where_the_polynomials_vanish() {
    let (mut growing, mut through_zero) = (0, 0);
    for index in 0..4 {
        for (real, _) in curve("eigenvalues", &format!("path-whole-{index}")).values() {
            assert!((real + 0.15).abs() < 2e-4, "all decay as e^(−Γt/2)");
        }
        let path = curve("eigenvalues", &format!("path-radial-{index}"));
        let s = path.values().last().map(|&(re, im)| Complex::new(re, im)).expect("a path");
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
        through_zero += i32::from(path.distance((0.0, 0.0)) < 0.2);
    }
    assert_eq!((growing, through_zero), (2, 2));
}

/// The stall torque, N·m, at which a spin can last: γ b² Ω⁵/D² over 1 − Ω/40, for the chapter's machine with half its
/// damper.
fn stall_torque(spin: f64) -> f64 {
    let d = (100.0 - spin * spin).hypot(1.5 * spin);
    45.0 / 3600.0 * spin.powi(5) / (d * d) / (1.0 - spin / 40.0)
}

#[test]
fn the_motor_meets_the_shaking_where_the_formula_says() {
    let shaking = curve("motor-line", "shaking");
    for spin in (3..400).map(|n| 0.1 * f64::from(n)) {
        let off = shaking.distance((spin, stall_torque(spin) * (1.0 - spin / 40.0)));
        assert!(off < PIXELS, "{spin}: {off}");
    }
    // The broken lines end at 40 and touch: the least torque above the valley, the largest on the hill.
    let torques: Vec<f64> = (1..398).map(|n| stall_torque(0.1 * f64::from(n))).collect();
    let hill = torques[..130].iter().copied().fold(0.0, f64::max);
    let valley = torques[130..].iter().copied().fold(f64::MAX, f64::min);
    for (name, torque) in [("line-up", hill), ("line", 4.0), ("line-down", valley)] {
        let line = curve("motor-line", name);
        assert!(
            line.distance((0.0, torque)) < PIXELS && line.distance((20.0, 0.5 * torque)) < PIXELS,
            "{name}"
        );
    }
}

#[test]
fn the_knob_goes_along_the_steady_speeds_and_jumps_at_their_ends() {
    for (name, from, to) in [("stuck", 50, 100), ("middle", 102, 177), ("fast", 178, 374)] {
        let branch = curve("motor-hysteresis", name);
        for spin in (from..=to).map(|n| 0.1 * f64::from(n)) {
            let off = branch.distance((stall_torque(spin), spin));
            assert!(off < PIXELS, "{name} at {spin}: {off}");
        }
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
    let torque = curve("torque", "torque-0.2").values();
    let peak = torque.iter().map(|point| point.1).fold(0.0, f64::max);
    let valley = torque.iter().filter(|point| point.0 > 1.21).map(|point| point.1).fold(9.0, f64::min);
    assert!((peak - 4.3).abs() < 0.05 && valley < 0.6, "{peak} {valley}");

    let end = |figure: &str, name: &str| curve(figure, name).values().last().copied().expect("a point");
    let (leaves, _) = end("locked", "locked");
    assert!((leaves - 0.25).abs() < 0.02, "{leaves}");
    let (_, rest) = end("locked", "free");
    let steady = machine(0.3, 1.5).steady().expect("damped");
    assert!((rest - steady.radius() * 60.0).abs() < 0.05 && (rest - 1.7).abs() < 0.05, "{rest}");

    let polar = curve("polar-fault", "polar").values();
    let [(nearest, first), (_, last)] = [polar[0], polar[polar.len() - 1]];
    assert!((nearest - 5e-4).abs() < 1e-4, "the last number comes at half a millimetre, not {nearest}");
    assert!(first.log10() > -2.3 && last.log10() < -9.0);
    let cartesian = curve("polar-fault", "cartesian").values();
    assert!(cartesian.iter().all(|point| (point.1 / 3e-11).log10().abs() < 0.15));
}

#[test]
fn growth_with_friction_on_board_is_that_of_the_roots() {
    for (name, floor, board) in
        [("floor", 0.3, 0.0), ("third", 0.3, 0.1), ("equal", 0.3, 0.3), ("board", 0.0, 0.3)]
    {
        let curve = curve("whirl-growth", name);
        for step in 1..300 {
            let spin = 6.0 * f64::from(step) / 300.0 - 3e-3;
            let machine = machine(floor, spin);
            let growth = machine.rotor(300.0 * board).expect("a rotor").growth() / 10.0;
            let off = curve.distance((spin, growth));
            assert!(off < PIXELS, "{name} at {spin}: {off}");
        }
    }
    let radial = curve("whirl-growth", "radial");
    for spin in [0.5, 1.0, 1.7, 3.1, 5.9] {
        let machine = machine(0.3, spin);
        let growth = machine.radial_damping_matrix().complex_eigenvalues();
        let growth = growth.iter().map(|root| root.re).fold(f64::MIN, f64::max) / 10.0;
        assert!(radial.distance((spin, growth)) < PIXELS, "{spin}: {growth}");
    }
    let [at_first, last] = ["equal", "board"].map(|name| curve("whirl-growth", name).values());
    assert!((at_first[0].1 + 0.3).abs() < 5e-3 && (last[last.len() - 1].1 - 0.58).abs() < 5e-3);
}

/// The integral of e^{iu²/2} from long ago to `end` over the whole, by the middle-point rule.
fn cornu(end: f64) -> Complex<f64> {
    let steps = 4000;
    let h = end / f64::from(steps);
    let sum: Complex<f64> =
        (0..steps).map(|n| Complex::from_polar(h, 0.5 * (h * (f64::from(n) + 0.5)).powi(2))).sum();
    Complex::from_polar(0.5, std::f64::consts::FRAC_PI_4) + sum / std::f64::consts::TAU.sqrt()
}

#[test]
fn a_slow_passage_goes_along_cornus_spiral_and_overshoots() {
    let spiral = curve("cornu", "spiral");
    for step in 0..300 {
        let place = cornu(-6.9 + 15.8 * f64::from(step) / 300.0);
        let off = spiral.distance((place.re, place.im));
        assert!(off < PIXELS, "{place}: {off}");
    }
    let farthest = spiral.values().into_iter().map(|(x, y)| x.hypot(y)).fold(0.0, f64::max);
    assert!((farthest - 1.1707).abs() < 2e-3, "{farthest}");

    // The largest swing over what the passage leaves, b√(π/2α) with ω₀ = b = 1.
    let overshoot = curve("cornu", "overshoot");
    let line = curve("cornu", "line");
    for root in [0.05_f64, 0.1, 0.15] {
        let rate = root * root;
        let machine = machine(0.0, 0.0);
        let motion = machine.ramp(100.0 * rate, Shaft::AT_REST).expect("a ramp");
        let times: Vec<f64> = (0..2000).map(|n| 0.1 / rate + 0.4 / root * f64::from(n) / 2000.0).collect();
        let shafts = motion.sample(&times).expect("times");
        let largest = shafts.iter().map(|shaft| shaft.position.norm()).fold(0.0, f64::max) / machine.offset();
        let factor = largest * root * (2.0 / std::f64::consts::PI).sqrt();
        // Between two of the computed accelerations the small waves are a little higher or lower.
        assert!(overshoot.distance((root, factor)) < 1.0, "{root}: {factor}");
        let off = line.distance((root, 1.170_659 + 0.598_41 * root));
        assert!(off < PIXELS, "{root}: {off}");
    }
}

#[test]
fn the_forces_on_a_whirl_are_to_scale() {
    // Γᵢ/Γ = 1/2: at 2 ω₀ the drum pushes half as hard as the floor, at 5 ω₀ twice as hard.
    for (ratio, push) in [(2.0, 0.5), (5.0, 2.0)] {
        let machine = machine(0.3, ratio);
        let rotor = machine.rotor(0.5 * machine.parameters().damping).expect("a rotor");
        let found = rotor.damping_rate_on_board() * 10.0 * (ratio - 1.0) / (machine.damping_rate() * 10.0);
        assert!((found - push).abs() < 1e-12);
        assert_eq!(rotor.growth() > 0.0, push > 1.0);
    }
}

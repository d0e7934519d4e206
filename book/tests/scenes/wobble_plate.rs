//! The scene of the chapter "The wobble plate": its numbers by the momenta of specks, and what is drawn of the plate.

use crate::hand::Hand;
use drawing::{Fill, Hue, Role, Room, Stroke};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, TAU};

const TORQUE: &str = "torque";

fn played(settings: &[(&str, f64)]) -> Hand {
    Hand::with("wobble-plate", settings)
}

/// The angular momentum at a time, from specks of the plate that turn with the shaft, and pistons whose ends lie in
/// the plane of the plate.
fn momentum([tilt, count, mass, spin]: [f64; 4], time: f64) -> Vector3<f64> {
    let (rings, around, phase) = (30, 120, spin * time);
    let place = |x: f64, y: f64| {
        let (x, z) = (x * tilt.cos(), x * tilt.sin());
        Vector3::new(x * phase.cos() - y * phase.sin(), x * phase.sin() + y * phase.cos(), z)
    };
    let mut sum = Vector3::zeros();
    for k in 0..rings * around {
        let radius = 0.1 * ((f64::from(k / around) + 0.5) / f64::from(rings)).sqrt();
        let angle = TAU * f64::from(k % around) / f64::from(around);
        let speck = place(radius * angle.cos(), radius * angle.sin());
        sum += speck.cross(&(Vector3::z() * spin).cross(&speck)) * (2.0 / f64::from(rings * around));
    }
    for n in 0..count as u32 {
        let angle = TAU * f64::from(n) / count - 0.25 * TAU;
        let (x, y) = (0.07 * angle.cos(), 0.07 * angle.sin());
        let height = |phase: f64| tilt.tan() * (x * phase.cos() + y * phase.sin());
        let step = 1e-4;
        let speed = spin * (height(phase + step) - height(phase - step)) / (2.0 * step);
        sum += Vector3::new(x, y, 0.0).cross(&(Vector3::z() * speed)) * (mass / count);
    }
    sum
}

#[test]
fn the_torque_is_the_rate_of_the_momentum_of_specks_and_pistons() {
    let mut random = fastrand::Rng::with_seed(14);
    for _ in 0..40 {
        let tilt = 0.5 * f64::from(random.u32(0..=90));
        let (count, mass) = (f64::from(random.u32(1..=7)), 0.004 * f64::from(random.u32(0..=850)));
        let spin = f64::from(random.u32(10..=150));
        let hand = played(&[("tilt", tilt), ("pistons", count), ("mass", mass), ("spin", spin)]);
        let (time, step) = (random.f64() * hand.duration(), 1e-4 / spin);
        let at = |time| momentum([tilt.to_radians(), count, mass, spin], time);
        let rate = (at(time + step) - at(time - step)) / (2.0 * step);
        let shown = hand.reading(time, TORQUE);
        assert!((shown - rate.norm()).abs() < 0.006 + 1e-3 * rate.norm(), "{shown} for {}", rate.norm());
    }
}

#[test]
fn the_frame_leans_as_the_momentum_that_it_lacks_makes_it() {
    for (count, spin) in [(4.0, 100.0), (2.0, 60.0), (1.0, 145.0)] {
        let settings = [25_f64.to_radians(), count, 0.8, spin];
        let hand = played(&[("pistons", count), ("mass", 0.8), ("spin", spin)]);
        // Frame and engine have no momentum across the shaft together: the frame turns by minus its integral over the
        // moment of the frame, 0.02 kg·m², about a middle where it stands when nothing shakes.
        let steps = 200;
        let step = TAU / spin / f64::from(steps);
        let mut leans = vec![Vector3::zeros()];
        for k in 0..steps {
            let momentum = momentum(settings, (f64::from(k) + 0.5) * step);
            let rate = Vector3::new(momentum.x, momentum.y, 0.0) / -0.02;
            leans.push(leans[leans.len() - 1] + rate * step);
        }
        let middle = leans[1..].iter().sum::<Vector3<f64>>() / f64::from(steps);
        for k in [0, 31, 90, 177] {
            let expected = (leans[k] - middle).norm().to_degrees();
            let shown = hand.reading(k as f64 * step, "lean");
            assert!((shown - expected).abs() < 0.02, "{shown}° for {expected}°");
        }
    }
    assert_eq!(played(&[("spin", 0.0)]).reading(0.1, "lean"), 0.0);
}

#[test]
fn three_do_what_two_cannot() {
    for count in 1..=7 {
        for spin in [20.0, 100.0, 150.0] {
            let hand = played(&[("pistons", f64::from(count)), ("mass", 1.676), ("spin", spin)]);
            let (torque, alone) = (hand.reading(0.0013, TORQUE), hand.reading(0.0, "without"));
            let left = if count < 3 { alone } else { 0.0 };
            assert!((torque - left).abs() < 0.02, "{torque} of {alone} with {count}");
        }
    }
}

#[test]
fn a_long_plate_is_pulled_as_pistons_pull() {
    // ΔI by the formula of a cylinder: none at a thickness of root three radii.
    let difference = |thickness: f64| 2.0 * (0.01 / 4.0 - thickness * thickness / 12.0);
    for tilt in [10.0, 25.0, 45.0] {
        for (thickness, mass) in [(17.32, 0.0), (5.0, 0.4), (17.32, 1.0), (22.0, 0.6)] {
            let settings = [("tilt", tilt), ("mass", mass), ("thickness", thickness), ("spin", 60.0)];
            let (sin, cos) = f64::to_radians(tilt).sin_cos();
            let pistons = 0.5 * mass * 0.07 * 0.07 * sin / cos;
            let expected = (difference(0.01 * thickness) * sin * cos - pistons).abs() * 3600.0;
            assert!((played(&settings).reading(0.002, TORQUE) - expected).abs() < 0.006, "{settings:?}");
        }
    }
}

#[test]
fn the_floor_is_never_cut_off() {
    for thickness in [0.0, 17.32] {
        let mut hand = played(&[("thickness", thickness)]);
        for (step, room) in (0..=72).flat_map(|step| [(step, Room::Wide), (step, Room::Narrow)]) {
            let view = [0.1 * f64::from(step), FRAC_PI_2 * (f64::from(step) / 36.0 - 1.0)];
            let drawing = hand.draw_from(view, 0.006, room);
            let floors = drawing.items().iter().filter(|item| item.role == Role::Area(Fill::Floor, Hue::Ink));
            let corners: Vec<_> = floors.flat_map(|item| item.shape.points()).collect();
            let page = drawing.frame();
            let is_whole = corners.len() > 3 && corners.iter().all(|corner| page.contains(*corner));
            assert!(is_whole, "{corners:?} from {view:?}, {room:?}, {thickness} cm");
        }
    }
}

#[test]
fn the_arrow_of_the_momentum_comes_out_of_a_thick_plate() {
    // Seen from the side of a tall cylinder, nothing of it is drawn over the middle.
    let mut hand = played(&[("thickness", 24.0), ("tilt", 0.0), ("mass", 0.0)]);
    let mut shaft = |elevation: f64| {
        let drawing = hand.draw_from([0.0, elevation], 0.0, Room::Wide);
        let arrows = drawing.items().iter().enumerate();
        let arrows = arrows.filter(|(_, item)| item.role == Role::Line(Stroke::Vector, Hue::Green));
        let feet = arrows.map(|(place, item)| (place, item.shape.points()[0].y));
        let (place, foot) = feet.max_by(|one, other| one.1.total_cmp(&other.1)).expect("an arrow");
        let is_plate = |role: Role| role == Role::Area(Fill::Side, Hue::Blue);
        let plate = drawing.items().iter().rposition(|item| is_plate(item.role)).expect("a plate");
        // The second grip is at the high end of the plate's middle plane, at the height of its centre for no tilt.
        (foot, hand.grips()[1].y, place < plate)
    };
    let (foot, centre, is_behind) = shaft(0.3);
    assert!(!is_behind && foot < centre - 20.0, "{foot} and {centre}");
    assert!(shaft(-0.3).2, "from below the plate hides its foot");
}

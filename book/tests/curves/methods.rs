//! The chapter on methods: factors by formulas, errors by the library's methods, slopes where the text claims them.

use crate::{PIXELS, curve, lies_on};
use mechanics::attitude::rotation_between;
use mechanics::euler::{Turning, turning_rates};
use mechanics::free_rotation::FreeTop;
use mechanics::geometric::Splitting;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::rk4;
use mechanics::scenes::pinned_hoop::{Pin, Pinning, PinningParameters, Shape};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::SQRT_2;

/// The book of the chapter.
fn book() -> (PrincipalMoments, Turning) {
    let omega_body = Vector3::new(0.7, 0.9, 0.5);
    let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
    (PrincipalMoments::new(1.0, 1.6, 2.1).expect("moments"), start)
}

/// The book after a duration, s, in so many steps of the method with this name.
fn after(method: &str, start: Turning, duration: f64, steps: usize) -> Turning {
    let (moments, _) = book();
    if method == "strang" {
        return Splitting::Strang.solve(&moments, start, duration, steps).expect("steps");
    }
    let free = turning_rates(moments, |_, _| Vector3::zeros());
    Turning::from_array(rk4(free, 0.0, start.to_array(), duration, steps).expect("steps"))
}

#[test]
fn the_factors_of_the_amplitude_are_those_of_their_polynomials() {
    lies_on("method-amplitude", "rk4", |z| (1.0 - z.powi(6) / 72.0 + z.powi(8) / 576.0).sqrt());
    let euler = curve("method-amplitude", "euler");
    for z in [0.1, 0.37, 0.71, 1.13] {
        assert!(euler.distance((z, f64::hypot(1.0, z))) < PIXELS, "Euler at {z}");
    }
    // The product of DOP853's stages agrees with e^{iz} to z⁸: no loss to be seen below 2, and one again at 5.96.
    let dop853 = curve("method-amplitude", "dop853");
    for at in [(1.0, 1.0), (1.9, 1.0), (5.9604, 1.0)] {
        assert!(dop853.distance(at) < PIXELS, "DOP853 at {at:?}");
    }
    // The mark stands where the curve of RK4 passes one.
    let rk4 = curve("method-amplitude", "rk4");
    assert!(rk4.distance((2.0 * SQRT_2, 1.0)) < PIXELS);
}

#[test]
fn the_errors_of_rk4_and_of_the_splitting_stand_at_their_steps() {
    let (moments, start) = book();
    let exact = FreeTop::new(moments, start).expect("a top").at(30.0).expect("a state");
    for steps in (7..=15).map(|n| (10.0 * 3000_f64.powf(f64::from(n) / 24.0)).round()) {
        for name in ["rk4", "strang"] {
            let found = after(name, start, 30.0, steps as usize);
            let error = rotation_between(&found.world_from_body, &exact.world_from_body);
            let off = curve("method-order", name).distance((30.0 / steps, error));
            assert!(off < PIXELS, "{name}, {steps} steps: {error:e}");
        }
    }
}

#[test]
fn energy_and_attitude_begin_with_the_errors_of_single_rounds() {
    let (moments, start) = book();
    let top = FreeTop::new(moments, start).expect("a top");
    let part = top.period().expect("a round") / 5.0;
    let energy = |body: &Turning| moments.kinetic_energy(&body.omega_body);
    for (name, steps) in [("rk4", 24), ("strang", 48)] {
        let (mut body, mut worst) = (start, [0.0_f64; 2]);
        for look in 1..=15 {
            body = after(name, body, part, steps);
            let exact = top.at(f64::from(look) * part).expect("a state");
            let attitude = rotation_between(&body.world_from_body, &exact.world_from_body);
            worst = [worst[0].max((energy(&body) / energy(&start) - 1.0).abs()), worst[1].max(attitude)];
            if look % 5 == 0 {
                for (figure, error) in ["method-energy", "method-attitude"].into_iter().zip(worst) {
                    let off = curve(figure, name).distance((f64::from(look / 5), error));
                    assert!(off < PIXELS, "{figure} {name}: {off} px off after {look} fifths of a round");
                }
            }
        }
    }
}

#[test]
fn errors_grow_as_the_text_says() {
    let slope = |figure, name, from: f64, to: f64| {
        let curve = curve(figure, name);
        (curve.value(to) / curve.value(from)).ln() / (to / from).ln()
    };
    for (name, expected) in [("rk4", 1.0), ("dop853", 1.0), ("strang", 0.0), ("blanes-moan", 0.0)] {
        let found = slope("method-energy", name, 50.0, 9000.0);
        assert!((found - expected).abs() < 0.03, "energy of {name}: {found}");
    }
    for (name, to, expected) in
        [("rk4", 300.0, 2.0), ("dop853", 9000.0, 2.0), ("strang", 90.0, 1.0), ("blanes-moan", 9000.0, 1.0)]
    {
        let found = slope("method-attitude", name, to / 5.0, to);
        assert!((found - expected).abs() < 0.15, "attitude of {name}: {found}");
    }
    // Hundreds of times better at the beginning, worse at the end.
    let [first, last] = [1.5, 9000.0].map(|x| {
        curve("method-attitude", "blanes-moan").value(x) / curve("method-attitude", "dop853").value(x)
    });
    assert!(first > 200.0 && last < 0.3, "{first} {last}");
}

#[test]
fn the_steps_of_the_hoop_tile_the_time_and_follow_its_tumbles() {
    let pin = Pin::Angle(89.9_f64.to_radians());
    let hoop = Pinning::new(PinningParameters { shape: Shape::Hoop, mass: 1.0, radius: 1.0, spin: 1.0, pin });
    let top = hoop.expect("a hoop").free_motion().expect("free");
    lies_on("method-steps", "tangent", |time| top.at(time).expect("a state").omega_body.x);
    // A marker stands at the middle of its step, as high as the step is long: neighbours touch.
    let steps = curve("method-steps", "steps").values();
    let touching = steps.windows(2).filter(|pair| {
        let gap = pair[1].0 - pair[0].0 - 0.5 * (pair[0].1 + pair[1].1);
        gap.abs() < 0.02
    });
    // Thinning takes a few points out of the line.
    assert!(touching.count() * 10 > steps.len() * 8, "{steps:?}");
    let shortest = |from: f64, to: f64| {
        let within = steps.iter().filter(|(time, _)| (from..to).contains(time));
        within.map(|step| step.1).fold(f64::INFINITY, f64::min)
    };
    assert!(shortest(10.0, 20.0) > 2.0 && shortest(24.0, 34.0) < 1.5 && shortest(50.0, 70.0) > 2.5);
    // About one in each flip, and four times as long at most, as its description says.
    let longest = steps.iter().map(|step| step.1).fold(0.0, f64::max);
    assert!((shortest(24.0, 34.0) - 1.15).abs() < 0.1 && (longest - 4.4).abs() < 0.2, "{longest}");
}

#[test]
fn the_steps_on_a_circle_go_by_their_factors() {
    // One step multiplies by 1 + iz, or 1 + iz − z²/2.
    let h = std::f64::consts::TAU / 16.0;
    for (name, real) in [("euler", 1.0), ("midpoint", 1.0 - 0.5 * h * h)] {
        let path = curve("method-circle", name);
        let (mut x, mut y) = (1.0, 0.0);
        for step in 1..=16 {
            (x, y) = (real * x - h * y, real * y + h * x);
            assert!(path.distance((x, y)) < PIXELS, "{name}, step {step}");
        }
        let radius = f64::hypot(x, y);
        let expected = if name == "euler" { 3.15 } else { 1.05 }; // what the caption says
        assert!((radius - expected).abs() < 0.01, "{name} ends at {radius}");
    }
}

#[test]
fn every_method_of_the_library_has_a_look() {
    for method in mechanics::integrate::METHODS {
        assert!(figures::Look::of(method.name).is_some(), "{} has no look", method.name);
    }
}

//! The chapter on methods: factors by formulas, errors by the library's methods, slopes where the text claims them.

use crate::{curve, lies_on, passes};
use drawing::at;
use mechanics::attitude::rotation_between;
use mechanics::euler::{Turning, turning_rates};
use mechanics::free_rotation::FreeTop;
use mechanics::geometric::Splitting;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::rk4;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{SQRT_2, TAU};

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
    passes("method-amplitude", "euler", [0.1, 0.37, 0.71, 1.13].map(|z| (z, f64::hypot(1.0, z))));
    // The product of DOP853's stages agrees with e^{iz} to z⁸: no loss to be seen below 2, and one again at 5.96.
    passes("method-amplitude", "dop853", [(1.0, 1.0), (1.9, 1.0), (5.9604, 1.0)]);
    // The mark stands where the curve of RK4 passes one.
    passes("method-amplitude", "rk4", [(2.0 * SQRT_2, 1.0)]);
    // One step on a circle multiplies by 1 + iz, or 1 + iz − z²/2.
    let h = TAU / 16.0;
    for (name, real, end) in [("euler", 1.0, 3.15), ("midpoint", 1.0 - 0.5 * h * h, 1.05)] {
        let path: Vec<(f64, f64)> = (0..16)
            .scan((1.0, 0.0), |place, _| {
                *place = (real * place.0 - h * place.1, real * place.1 + h * place.0);
                Some(*place)
            })
            .collect();
        passes("method-circle", name, path.iter().copied());
        let radius = path[15].0.hypot(path[15].1);
        assert!((radius - end).abs() < 0.01, "{name} ends at {radius}, and the caption says {end}");
    }
}

#[test]
fn the_errors_of_rk4_and_of_the_splitting_stand_at_their_steps() {
    let (moments, start) = book();
    let exact = FreeTop::new(moments, start).and_then(|top| top.at(30.0)).expect("a state");
    for name in ["rk4", "strang"] {
        let counts = (7..=15).map(|n| (10.0 * 3000_f64.powf(f64::from(n) / 24.0)).round());
        passes(
            "method-order",
            name,
            counts.map(|steps| {
                let found = after(name, start, 30.0, steps as usize);
                (30.0 / steps, rotation_between(&found.world_from_body, &exact.world_from_body))
            }),
        );
    }
    // In attitude the splitting is hundreds of times better at the beginning, and worse at the end.
    let [first, last] = [1.5, 9000.0].map(|x| {
        curve("method-long-run", "blanes-moan-attitude").value(x)
            / curve("method-long-run", "dop853-attitude").value(x)
    });
    assert!(first > 200.0 && last < 0.3, "{first} {last}");
}

#[test]
fn the_steps_of_the_hoop_tile_the_time_and_follow_its_tumbles() {
    // A marker stands at the middle of its step, as high as the step is long: neighbours touch.
    let drawn = curve("method-steps", "steps");
    let steps: Vec<_> = drawn.corners.iter().map(|&(x, y)| drawn.axes.values(at(x, y))).collect();
    let touching = steps.windows(2).filter(|pair| {
        let gap = pair[1].0 - pair[0].0 - 0.5 * (pair[0].1 + pair[1].1);
        gap.abs() < 0.02
    });
    // Where the line hardly bends, a few points are not its corners.
    assert!(touching.count() * 10 > steps.len() * 8, "{steps:?}");
    let shortest = |from: f64, to: f64| {
        let within = steps.iter().filter(|(time, _)| (from..to).contains(time));
        within.map(|step| step.1).fold(f64::INFINITY, f64::min)
    };
    assert!(shortest(10.0, 20.0) > 2.0 && shortest(50.0, 70.0) > 2.5);
    // About one in each flip, and four times as long at most, as its description says.
    let longest = steps.iter().map(|step| step.1).fold(0.0, f64::max);
    assert!((shortest(24.0, 34.0) - 1.15).abs() < 0.1 && (longest - 4.4).abs() < 0.2, "{longest}");
}

#[test]
fn every_method_of_the_library_has_a_look() {
    for method in mechanics::integrate::METHODS {
        assert!(figures::Look::of(method.name).is_some(), "{} has no look", method.name);
    }
}

//! Tops under gravity.

use super::Sign::{Any, NotNegative, Positive};
use super::{Setter, every_number_is_checked, message};
use mechanics::euler::Turning;
use mechanics::inertia::Body;
use mechanics::scenes::top::{Release, Top, TopParameters};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

const TOY: TopParameters =
    TopParameters { mass: 0.1, arm: 0.04, transverse: 2e-4, axial: 5e-5, gravity: 9.81 };
const START: Release = Release { tilt: 0.5, tilt_rate: 1.0, precession: 2.0, spin: 150.0 };

#[test]
fn a_top_has_mass_arm_and_moments_of_a_body() {
    let numbers: [Setter<TopParameters>; 5] = [
        (|p| &mut p.mass, "mass", "kg", Positive),
        (|p| &mut p.arm, "arm", "m", Positive),
        (|p| &mut p.transverse, "principal moment", "kg·m²", Positive),
        (|p| &mut p.axial, "principal moment", "kg·m²", Positive),
        (|p| &mut p.gravity, "gravity", "m/s²", NotNegative),
    ];
    every_number_is_checked(TOY, &numbers, Top::new);
    let heavy = message(Top::new(TopParameters { axial: 9e-5, ..TOY }));
    let rule = "kg·m² is less than mass · arm² plus half the axial moment (`Top::on_a_point` takes";
    assert!(
        heavy.starts_with("transverse moment about the fixed point 0.0002 ") && heavy.contains(rule),
        "{heavy}"
    );
    // A flat body reaches the limit, and no moment below it is that of a body.
    for (transverse, is_body) in [(0.34, true), (0.34 * (1.0 - 1e-14), false), (0.18, false)] {
        let found = Top::new(TopParameters { mass: 1.0, arm: 0.4, transverse, axial: 0.36, gravity: 9.81 });
        let said = "mass · arm² plus half the axial moment";
        assert!(found.is_ok() == is_body && (is_body || message(found).contains(said)), "{transverse}");
    }
    assert!(message(Top::new(TopParameters { gravity: 1e50, ..TOY })).contains("range of numbers"));
    let brick = Body::cuboid(1.0, [0.1, 0.2, 0.3]).unwrap();
    assert!(message(Top::on_a_point(&brick, 0.1, 9.81)).starts_with("transverse moment I₂"));
    assert!(message(Top::on_a_point(&Body::sphere(1.0, 0.1).unwrap(), -0.1, 9.81)).starts_with("arm -0.1 m"));
}

#[test]
fn a_release_has_a_tilt_and_rates() {
    let top = Top::new(TOY).unwrap();
    let numbers: [Setter<Release>; 4] = [
        (|p| &mut p.tilt, "tilt", "rad", NotNegative),
        (|p| &mut p.tilt_rate, "rate of the tilt", "rad/s", Any),
        (|p| &mut p.precession, "precession", "rad/s", Any),
        (|p| &mut p.spin, "spin", "rad/s", Any),
    ];
    every_number_is_checked(START, &numbers, |release| top.let_go(release));
    let beyond = message(top.let_go(Release { tilt: 3.2, ..START }));
    assert_eq!(beyond, format!("tilt 3.2 rad is too large; it must be at most {} rad", std::f64::consts::PI));
    for tilt in [-0.1, 3.2, f64::NAN] {
        assert!(message(top.steady_precession(tilt, 1.0)).starts_with("tilt"));
    }
    assert!(message(top.steady_precession(std::f64::consts::FRAC_PI_2, 0.0)).contains("level axis"));
    for spin in [f64::NAN, 1e60] {
        assert!(message(top.growth_rate(spin)).starts_with("spin"));
        assert!(message(top.waking_tilt(spin)).starts_with("spin"));
        assert!(message(top.furthest_tilt(spin)).starts_with("spin"));
        assert!(message(top.steady_precession(0.3, spin)).starts_with("spin"));
    }
    let long = UnitQuaternion::new_unchecked(Quaternion::new(1.0, 1e-3, 0.0, 0.0));
    let start = Turning { world_from_body: long, omega_body: Vector3::zeros() };
    assert!(message(top.motion(&start)).starts_with("length of the quaternion"));
    let start =
        Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(f64::NAN, 0.0, 0.0) };
    assert!(message(top.motion(&start)).starts_with("angular velocity"));
    let motion = top.let_go(START).unwrap();
    for time in [f64::NAN, f64::INFINITY, 1e60] {
        assert!(
            message(motion.at(time)).starts_with("time") && message(motion.angles(time)).starts_with("time")
        );
    }
}

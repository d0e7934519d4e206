//! The free body of any shape in closed form: where it has no period, and where it has that of a symmetric body. That it is
//! exact everywhere else `worst_cases` holds.

use approx::assert_relative_eq;
use mechanics::attitude::rotation_between;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

#[test]
fn on_the_separatrix_the_body_comes_to_the_middle_axis_and_stays() {
    // Exactly on it: for I = (3, 5, 6) that is ω₁ = ω₃.
    let moments = PrincipalMoments::new(3.0, 5.0, 6.0).unwrap();
    let omega_body = Vector3::new(0.5, 0.1, 0.5);
    let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
    let top = FreeTop::new(moments, start).unwrap();
    assert_eq!(top.period(), None);
    let late = top.at(200.0).unwrap();
    let total = start.angular_momentum_world(&moments).norm() / 5.0;
    assert_relative_eq!(late.omega_body.y.abs(), total, max_relative = 1e-6);
}

#[test]
fn rotation_about_a_principal_axis_is_steady() {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5).unwrap();
    for axis in 0..3 {
        let mut omega_body = Vector3::zeros();
        omega_body[axis] = -1.7;
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
        let top = FreeTop::new(moments, start).unwrap();
        assert_eq!((top.at(1e5).unwrap().omega_body, top.period()), (omega_body, None));
        let expected = UnitQuaternion::from_scaled_axis(omega_body * 2.0);
        assert!(rotation_between(&top.at(2.0).unwrap().world_from_body, &expected) < 1e-14);
    }
}

#[test]
fn the_period_of_a_symmetric_body_is_that_of_its_wobble_whatever_the_sense() {
    // I₃ = 2 I₁: ω goes round the axis at σ = ω₃, whichever axis it is.
    for axis in 0..3 {
        let mut moments = [1.0; 3];
        moments[axis] = 2.0;
        let [i1, i2, i3] = moments;
        let moments = PrincipalMoments::new(i1, i2, i3).unwrap();
        let period = |spin: f64, wobble: f64, next: usize| {
            let mut omega_body = Vector3::zeros();
            omega_body[axis] = spin;
            omega_body[(axis + next) % 3] = wobble;
            FreeTop::new(moments, Turning { world_from_body: UnitQuaternion::identity(), omega_body })
                .unwrap()
                .period()
        };
        for spin in [5.0, -5.0, 0.3] {
            assert_eq!(period(spin, 0.0, 1), None, "steady about its axis");
            for (wobble, next) in [(0.3, 1), (-0.3, 1), (0.3, 2), (1e-50, 2)] {
                let expected = TAU / f64::abs(spin);
                assert_relative_eq!(period(spin, wobble, next).unwrap(), expected, max_relative = 4e-16);
            }
        }
        assert_eq!(period(0.0, 1.0, 1), None, "steady across its axis");
    }
}

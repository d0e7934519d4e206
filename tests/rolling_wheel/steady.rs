//! Steady rolling, equations (72) to (90) and (5).

use super::whole_body::{arm, axle, frame, placed, solve};
use super::{GRAVITY, MASS, RADIUS, wheel};
use crate::common::any;
use crate::printed::corrected_holds_and_printed_fails;
use approx::assert_relative_eq;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use mechanics::rolling::MomentFactors;
use mechanics::scenes::rolling_wheel::SteadyRolling;
use mechanics::{InvalidQuantity, Rule};
use nalgebra::{Complex, Quaternion, Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::TAU;

const ROUNDING: f64 = 1e-12;

/// Steady motions of hoop, disc and something between, on either side and with the centre at rest: k, θ, b.
const CASES: [(f64, f64, f64); 10] = [
    (1.0, 0.3, 1.2),
    (1.0, 0.8, 0.25),
    (0.5, 0.5, 0.6),
    (0.5, 1.2, 0.1),
    (0.5, 0.9, -0.02),
    (1.0, 1.0, -0.05),
    (0.7, -0.6, -0.4),
    (0.5, -1.1, 0.03),
    (0.5, 0.7, 0.0),
    (1.0, 1.3, 0.0),
];

fn cases() -> impl Iterator<Item = (f64, f64, f64, SteadyRolling)> {
    CASES.into_iter().map(|(k, lean, b)| (k, lean, b, wheel(k).steady(lean, b).expect("a steady motion")))
}

/// The three axes and the room's y (outward) and z in the moment of the source's figure: heading along x.
fn axes(lean: f64) -> [Vector3<f64>; 3] {
    let frame = frame(lean, 0.0);
    [0, 1, 2].map(|i| frame.column(i).into_owned())
}

#[test]
fn eq72_and_eq73_the_material_point_of_contact_stands_still() {
    for (_, lean, b, steady) in cases() {
        let [_, second, third] = axes(lean);
        let turn = Vector3::z() * steady.turn_rate();
        // The whole angular velocity is the turn of the frame and the spin about the axle relative to it.
        let omega = turn + third * steady.relative_spin();
        let centre = Vector3::new(0.0, b, 0.0);
        let velocity = turn.cross(&centre) + omega.cross(&(second * -RADIUS));
        assert!(velocity.norm() < ROUNDING, "the contact slips with {velocity}");
        // (72): the contact goes round with Ω on the circle of radius b + a sin θ.
        let contact = centre - second * RADIUS;
        assert_relative_eq!(steady.contact_radius(), contact.y, epsilon = ROUNDING);
        assert_relative_eq!(steady.true_spin(), omega.dot(&third), epsilon = ROUNDING);
        assert_relative_eq!(steady.true_spin(), steady.turn_rate() * b / RADIUS, max_relative = 1e-14);
    }
}

#[test]
fn eq74_the_torque_is_that_of_friction_and_support() {
    for (_, lean, b, steady) in cases() {
        let [first, second, third] = axes(lean);
        let force = Vector3::new(0.0, -MASS * steady.turn_rate().powi(2) * b, MASS * GRAVITY);
        let torque = (second * -RADIUS).cross(&force);
        assert_relative_eq!(torque, first * steady.torque(), epsilon = ROUNDING * force.norm());
        // ẑ along the axes, as printed and as it is.
        let (sin, cos) = lean.sin_cos();
        assert_relative_eq!(second * cos - third * sin, Vector3::z(), epsilon = 1e-15);
        assert!((third * cos - first * sin - Vector3::z()).norm() > 0.1);
    }
}

/// The angular momentum of a steadily rolling wheel at a time, in the room, added up over its mass: twelve points at
/// the distance √k a from the axle have the moments of a wheel with the factor k.
fn momentum(k: f64, lean: f64, steady: &SteadyRolling, time: f64) -> Vector3<f64> {
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), steady.turn_rate() * time);
    let [first, second, third] = axes(lean);
    let omega = Vector3::z() * steady.turn_rate() + third * steady.relative_spin();
    let sum: Vector3<f64> = (0..12)
        .map(|n| {
            let (sin, cos) = (TAU * f64::from(n) / 12.0).sin_cos();
            let r = (first * cos + second * sin) * (RADIUS * k.sqrt());
            r.cross(&omega.cross(&r)) * (MASS / 12.0)
        })
        .sum();
    turn * sum
}

#[test]
fn eq75_eq76_and_eq77_eulers_equations_hold_in_body_axes_and_the_printed_third_does_not() {
    for (k, lean, _, steady) in cases() {
        // Components of ω along axes fixed in the wheel, which turn about axis 3 with the relative spin.
        let components = |time: f64| {
            let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), steady.turn_rate() * time);
            let spun = Rotation3::from_axis_angle(&Vector3::z_axis(), steady.relative_spin() * time);
            let frame = frame(lean, 0.0) * spun;
            let omega = Vector3::z() * steady.turn_rate() + axes(lean)[2] * steady.relative_spin();
            frame.transpose() * (turn.inverse() * (turn * omega))
        };
        let h = 1e-5;
        let rate = (components(h) - components(-h)) / (2.0 * h);
        let omega = components(0.0);
        let unit = k * MASS * RADIUS * RADIUS;
        let [i1, i2, i3] = [0.5 * unit, 0.5 * unit, unit];
        let torque = [
            i1 * rate.x + (i3 - i2) * omega.y * omega.z,
            i2 * rate.y + (i1 - i3) * omega.x * omega.z,
            i3 * rate.z + (i2 - i1) * omega.x * omega.y,
        ];
        let size = unit * omega.norm_squared();
        assert_relative_eq!(torque[0], steady.torque(), epsilon = 1e-8 * size);
        assert!(torque[1].abs() < 1e-8 * size && torque[2].abs() < 1e-8 * size);
    }
    // (77) prints (I₁ − I₂)ω₂ω₃ for (I₂ − I₁)ω₁ω₂, which is zero for a wheel either way. A body with three moments
    // tells them apart: ω̇₃ of its free rotation in closed form, by differences.
    let moments = PrincipalMoments::new(1.0, 1.5, 2.0).unwrap();
    let [i1, i2, i3] = moments.to_array();
    let start =
        Turning { world_from_body: UnitQuaternion::identity(), omega_body: Vector3::new(0.9, -0.7, 1.1) };
    let top = FreeTop::new(moments, start).unwrap();
    let cases = (1..=40).map(|n| {
        let (time, h) = (0.37 * f64::from(n), 1e-4);
        let [before, omega, after] = [time - h, time, time + h].map(|t| top.at(t).unwrap().omega_body);
        let rate = (after.z - before.z) / (2.0 * h);
        let corrected = i3 * rate + (i2 - i1) * omega.x * omega.y;
        let printed = i3 * rate + (i1 - i2) * omega.y * omega.z;
        (corrected.abs(), printed.abs())
    });
    corrected_holds_and_printed_fails(cases, 1e-7, 0.01);
}

#[test]
fn eq78_and_eq79_the_angular_velocity_changes_by_the_turn_in_both_frames() {
    for (k, lean, b, steady) in cases() {
        // The whole body, moved by gravity and by the force that keeps its contact at rest: nothing in it goes round by
        // itself.
        let start = placed(lean, 0.0, steady.omega().into(), Complex::new(0.0, b));
        let (rates, _) = solve(MomentFactors::flat(k), &start);
        let rate = Vector3::new(rates[10], rates[11], rates[12]);
        let expected = axes(lean)[0] * (steady.relative_spin() * steady.turn_rate() * lean.cos());
        let size = steady.omega().norm_squared();
        assert_relative_eq!(rate, expected, epsilon = 1e-11 * size);
        // Along axes fixed in the body its components change at the same rate: ω × ω adds nothing.
        let seen = |time: f64| {
            let end = Dop853::new(1e-13)
                .unwrap()
                .solve(any(|_, state: &[f64; 13]| solve(MomentFactors::flat(k), state).0), 0.0, start, time)
                .unwrap()
                .state;
            let body = UnitQuaternion::from_quaternion(Quaternion::new(end[3], end[4], end[5], end[6]));
            body.inverse() * Vector3::new(end[10], end[11], end[12])
        };
        let h = 1e-4 / size.sqrt();
        let difference = (seen(h) - seen(-h)) / (2.0 * h);
        assert_relative_eq!(frame(lean, 0.0) * difference, rate, epsilon = 1e-6 * size);
    }
}

#[test]
fn eq80_eq81_and_eq90_the_turn_rate_balances_torque_and_momentum() {
    for (k, lean, b, steady) in cases() {
        let h = 1e-5;
        let rate = (momentum(k, lean, &steady, h) - momentum(k, lean, &steady, -h)) / (2.0 * h);
        let size = MASS * GRAVITY * RADIUS;
        assert_relative_eq!(rate, axes(lean)[0] * steady.torque(), epsilon = 1e-7 * size);
        let square = 2.0 * GRAVITY * lean.tan() / (2.0 * (1.0 + k) * b + k * RADIUS * lean.sin());
        assert_relative_eq!(steady.turn_rate().powi(2), square, max_relative = 1e-13);
    }
}

#[test]
fn eq82_eq83_and_eq05_hoop_and_disc_and_the_printed_hoop_without_its_radius() {
    let cases = [(0.7_f64, 0.3), (0.2, 1.5), (1.2, 0.05), (0.9, -0.02), (1.4, 2.0)].map(|(lean, b)| {
        let r = b + RADIUS * lean.sin();
        let hoop = wheel(1.0).steady(lean, b).unwrap().turn_rate().powi(2);
        let twice = 2.0 * GRAVITY * lean.tan();
        assert_relative_eq!(hoop, twice / (4.0 * b + RADIUS * lean.sin()), max_relative = 1e-13); // (5)
        let disc = wheel(0.5).steady(lean, b).unwrap().turn_rate().powi(2);
        assert_relative_eq!(disc, 2.0 * twice / (6.0 * b + RADIUS * lean.sin()), max_relative = 1e-13);
        assert_relative_eq!(disc, 2.0 * twice / (6.0 * r - 5.0 * RADIUS * lean.sin()), max_relative = 1e-12);
        // By the contact's circle: 3a sin θ, printed without the a.
        let corrected = twice / (4.0 * r - 3.0 * RADIUS * lean.sin());
        let printed = twice / (4.0 * r - 3.0 * lean.sin());
        ((corrected / hoop - 1.0).abs(), (printed / hoop - 1.0).abs())
    });
    corrected_holds_and_printed_fails(cases, 1e-12, 0.05);
}

#[test]
fn eq84_eq85_eq86_and_eq88_momentum_in_the_frame_that_does_not_roll() {
    for (k, lean, _, steady) in cases() {
        let omega = frame(lean, 0.0).transpose()
            * (Vector3::z() * steady.turn_rate() + axes(lean)[2] * steady.relative_spin());
        assert_relative_eq!(steady.omega(), omega, epsilon = 1e-13 * omega.norm());
        let l = momentum(k, lean, &steady, 0.0);
        assert_relative_eq!(frame(lean, 0.0) * steady.angular_momentum(), l, epsilon = 1e-13 * l.norm());
        let torque = (Vector3::z() * steady.turn_rate()).cross(&l);
        let size = l.norm() * steady.turn_rate();
        assert_relative_eq!(torque, axes(lean)[0] * steady.torque(), epsilon = 1e-11 * size);
    }
    // (85) as printed lacks k, which is one for a hoop: the other wheels tell.
    let cases = cases().filter(|(k, ..)| *k != 1.0).map(|(k, lean, _, steady)| {
        let found = frame(lean, 0.0).transpose() * momentum(k, lean, &steady, 0.0);
        let (turn, spin) = (steady.turn_rate(), steady.relative_spin());
        let unit = Vector3::new(0.0, turn * lean.cos(), 2.0 * (spin - turn * lean.sin()))
            * (0.5 * MASS * RADIUS * RADIUS);
        let (corrected, printed) = (unit * k, unit);
        ((corrected - found).norm() / found.norm(), (printed - found).norm() / found.norm())
    });
    corrected_holds_and_printed_fails(cases, 1e-12, 0.1);
}

#[test]
fn eq87_and_eq89_momentum_along_y_and_z_with_the_sine_that_is_printed_as_a_cosine() {
    let cases = cases().map(|(k, lean, b, steady)| {
        let (sin, cos) = lean.sin_cos();
        let (turn, spin) = (steady.turn_rate(), steady.relative_spin());
        let half = 0.5 * k * MASS * RADIUS * RADIUS;
        let l = momentum(k, lean, &steady, 0.0);
        assert_relative_eq!(frame(lean, 0.0) * steady.angular_momentum(), l, epsilon = 1e-13 * l.norm());
        assert_relative_eq!(l.y, half * (turn * cos * sin - 2.0 * spin * cos), epsilon = 1e-13 * l.norm());
        let corrected = half * (turn * (cos * cos + 2.0 * sin * sin) - 2.0 * spin * sin);
        let printed = half * (turn * (cos * cos + 2.0 * sin * sin) - 2.0 * spin * cos);
        // (89): the balance with ω put in.
        let left = 2.0 * (GRAVITY * sin - turn * turn * b * cos);
        let right = 2.0 * k * turn * turn * (b + RADIUS * sin) * cos - k * RADIUS * turn * turn * cos * sin;
        assert_relative_eq!(left, right, epsilon = 1e-11 * GRAVITY);
        ((l.z - corrected).abs() / l.norm(), (l.z - printed).abs() / l.norm())
    });
    corrected_holds_and_printed_fails(cases, 1e-12, 0.02);
}

#[test]
fn stable_steady_motions_hold_for_a_hundred_turns_and_an_unstable_one_does_not() {
    let held = |k: f64, lean: f64, b: f64, turns: f64| {
        let steady = wheel(k).steady(lean, b).unwrap();
        let omega = steady.omega();
        let start = placed(lean, 0.0, omega.into(), Complex::new(0.0, b));
        let time = turns * std::f64::consts::TAU / steady.turn_rate();
        let end = Dop853::new(1e-11)
            .unwrap()
            .solve(any(|_, state: &[f64; 13]| solve(MomentFactors::flat(k), state).0), 0.0, start, time)
            .unwrap()
            .state;
        let n = axle(&end);
        let radius = end[0].hypot(end[1]);
        ((-n.z).asin() - lean).abs().max((radius - b.abs()).abs() / RADIUS)
    };
    for (k, lean, b) in CASES {
        let steady = wheel(k).steady(lean, b).unwrap();
        assert!(steady.is_stable(), "{k} {lean} {b}");
        assert!(held(k, lean, b, 100.0) < 2e-6, "{k} {lean} {b}: {}", held(k, lean, b, 100.0));
    }
    let tongue = wheel(1.0).steady(0.2, 0.4 * RADIUS).unwrap();
    assert!(!tongue.is_stable());
    assert!(held(1.0, 0.2, 0.4 * RADIUS, 30.0) > 0.05);
}

#[test]
fn friction_and_support_are_those_of_the_whole_body() {
    for (k, lean, b, steady) in cases() {
        let start = placed(lean, 0.0, steady.omega().into(), Complex::new(0.0, b));
        let (_, force) = solve(MomentFactors::flat(k), &start);
        assert_relative_eq!(force.z, MASS * GRAVITY, max_relative = 1e-8);
        assert_relative_eq!(force.xy().norm() / force.z, steady.friction_needed(), epsilon = 1e-8);
        assert!(arm(&axle(&start)).z < 0.0);
    }
}

#[test]
fn steady_rolling_exists_on_one_side_of_its_bound_only() {
    let disc = wheel(0.5);
    let bound = -0.5 * RADIUS * 0.7_f64.sin() / 3.0;
    assert!(disc.steady(0.7, bound + 1e-9).is_ok());
    let error = disc.steady(0.7, bound - 1e-9).unwrap_err();
    let Rule::MoreThan(found) = error.rule else { panic!("{error}") };
    assert_relative_eq!(found, bound, max_relative = 1e-14);
    assert!(error.to_string().contains("it must be more than -0.0429"));
    let mirrored = disc.steady(-0.7, 1e-9 - bound).unwrap_err();
    assert_eq!(mirrored.rule, Rule::LessThan(-found));
    let message = |lean: f64| disc.steady(lean, 1.0).unwrap_err().to_string();
    assert!(message(0.0).starts_with("lean 0 rad: an upright wheel goes round on no circle"));
    for lean in [std::f64::consts::FRAC_PI_2, -2.0] {
        assert_eq!(
            message(lean),
            format!("lean {lean} rad: a wheel rolls at less than π/2 from the upright")
        );
    }
    assert!(matches!(
        disc.steady(f64::NAN, 1.0),
        Err(InvalidQuantity { quantity: "lean", rule: Rule::Finite, .. })
    ));
    // (b, θ) and (−b, −θ) are the same motion seen from the other end.
    let (a, b) = (disc.steady(0.4, 0.3).unwrap(), disc.steady(-0.4, -0.3).unwrap());
    assert_eq!(a.turn_rate(), b.turn_rate());
}

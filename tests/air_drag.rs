//! Spinning down in air: equations (53) to (58), (3) and (4), and where the axis goes.

use crate::common::{any, between};
use crate::printed::corrected_holds_and_printed_fails;
use approx::assert_relative_eq;
use mechanics::attitude::rotation_between;
use mechanics::euler::{self, Turning};
use mechanics::inertia::{Body, PrincipalMoments, Spheroid, SymmetricMoments};
use mechanics::integrate::{Dop853, rk4};
use mechanics::scenes::air_drag::{AxisTrend, Drag, DraggedTop, DraggedTopParameters, ThrownTop};
use nalgebra::{UnitQuaternion, Vector3};
use num_dual::{Dual64, DualNum};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const ROUNDING: f64 = 1e-13;

/// What a simulation to 1e-13 a step leaves after some ten turns.
const SIMULATED: f64 = 1e-10;

/// Moments, drag and angular velocity of bodies from pencils to plates; `isotropic` gives one coefficient for all axes.
fn body(random: &mut fastrand::Rng, isotropic: bool) -> (PrincipalMoments, Drag, Vector3<f64>) {
    let transverse = between(random, 0.1, 10.0);
    let moments = PrincipalMoments::symmetric(transverse, transverse * between(random, 0.05, 2.0)).unwrap();
    let drag = Drag { transverse: between(random, 0.01, 0.3), axial: between(random, 0.01, 0.3) };
    let drag = if isotropic { Drag::isotropic(drag.transverse) } else { drag };
    (moments, drag, Vector3::from_fn(|_, _| 4.0 * random.f64() - 2.0))
}

fn dragged(moments: PrincipalMoments, drag: Drag, omega_body: Vector3<f64>) -> DraggedTop {
    DraggedTop::new(DraggedTopParameters { moments, drag, omega_body }).expect("a body that turns")
}

/// That body with its attitude, integrated as closely as the simulations.
fn thrown(top: &DraggedTop, world_from_body: UnitQuaternion<f64>) -> ThrownTop {
    top.thrown(world_from_body, &Dop853::new(1e-13).expect("a tolerance")).expect("an attitude")
}

/// Euler's equations written out with one drag coefficient an axis, as the source has them in (54) and (55); for any
/// numbers.
fn written_out<D: DualNum<Primitive = f64> + Copy>(
    moments: PrincipalMoments,
    drag: Drag,
    [w1, w2, w3]: [D; 3],
) -> [D; 3] {
    let SymmetricMoments { transverse: i1, axial: i3 } = moments.as_symmetric().unwrap();
    let Drag { transverse, axial } = drag;
    [
        (-w1 * transverse - w2 * w3 * (i3 - i1)) / i1,
        (-w2 * transverse - w3 * w1 * (i1 - i3)) / i1,
        -w3 * (axial / i3),
    ]
}

fn simulated(moments: PrincipalMoments, drag: Drag, start: Vector3<f64>, time: f64) -> Vector3<f64> {
    let rates = |_: f64, omega: &[f64; 3]| written_out(moments, drag, *omega);
    Vector3::from(Dop853::new(1e-13).unwrap().solve(any(rates), 0.0, start.into(), time).unwrap().state)
}

#[test]
fn eq53_drag_is_a_torque_against_the_angular_velocity() {
    let mut random = fastrand::Rng::with_seed(53);
    for _ in 0..100 {
        let (moments, drag, omega) = body(&mut random, true);
        let top = dragged(moments, drag, omega);
        let torque = top.torque_body(&omega);
        assert_relative_eq!(torque, -drag.axial * omega, max_relative = ROUNDING);
        // eq03: it takes energy, and takes angular momentum in the room at the rate −Cω.
        let thrown = thrown(&top, UnitQuaternion::identity());
        let at = |time: f64| thrown.at(time).unwrap();
        let (time, h) = (1.3, 1e-3);
        let [before, now, after] = [time - h, time, time + h].map(at);
        let change =
            (after.angular_momentum_world(&moments) - before.angular_momentum_world(&moments)) / (2.0 * h);
        assert_relative_eq!(change, -drag.axial * now.omega_world(), epsilon = 1e-5);
        let energy = |turning: &Turning| moments.kinetic_energy(&turning.omega_body);
        let loss = (energy(&after) - energy(&before)) / (2.0 * h);
        assert_relative_eq!(loss, -drag.axial * now.omega_body.norm_squared(), epsilon = 1e-5);
    }
}

/// A point of the body, and a force against its velocity in proportion to it.
type Resistance = (f64, Vector3<f64>);

/// Torque and power of the air on a body that turns with ω, added up over its points.
fn torque_and_power(points: &[Resistance], omega: &Vector3<f64>) -> (Vector3<f64>, f64) {
    points.iter().fold((Vector3::zeros(), 0.0), |(torque, power), (resistance, r)| {
        let velocity = omega.cross(r);
        let force = -velocity * *resistance;
        (torque + r.cross(&force), power + force.dot(&velocity))
    })
}

#[test]
fn eq03_air_that_resists_every_point_gives_a_ball_one_coefficient_and_a_disc_two() {
    let mut random = fastrand::Rng::with_seed(3);
    // Six points on three axes stand for a ball, twelve on a ring for a disc, with resistances that add up to one.
    let radius = 0.3;
    let ball: Vec<Resistance> = [Vector3::x(), Vector3::y(), Vector3::z()]
        .into_iter()
        .flat_map(|axis| [(1.0 / 6.0, axis * radius), (1.0 / 6.0, -axis * radius)])
        .collect();
    let disc: Vec<Resistance> = (0..12)
        .map(|n| (TAU * f64::from(n) / 12.0).sin_cos())
        .map(|(sin, cos)| (1.0 / 12.0, Vector3::new(cos, sin, 0.0) * radius))
        .collect();
    for (points, drag) in [
        (ball, Drag::isotropic(2.0 / 3.0 * radius * radius)),
        (disc, Drag { transverse: 0.5 * radius * radius, axial: radius * radius }),
    ] {
        for _ in 0..100 {
            let omega = Vector3::from_fn(|_, _| 4.0 * random.f64() - 2.0);
            let (torque, power) = torque_and_power(&points, &omega);
            let top = dragged(PrincipalMoments::symmetric(1.0, 1.2).unwrap(), drag, omega);
            assert_relative_eq!(top.torque_body(&omega), torque, epsilon = ROUNDING);
            assert_relative_eq!(top.torque_body(&omega).dot(&omega), power, max_relative = 1e-12);
            // (3) as printed, −Cω: the ball obeys it. On the disc no one C does, as soon as it neither rolls nor spins
            // alone.
            let c = torque.norm() / omega.norm();
            let askew = (torque + omega * c).norm() / torque.norm();
            assert_eq!(askew < 1e-12, drag.transverse == drag.axial, "{askew}");
        }
    }
}

#[test]
fn eq54_eq55_and_eq57_spin_and_wobble_decay_as_eulers_equations_say() {
    let mut random = fastrand::Rng::with_seed(55);
    for n in 0..200 {
        let (moments, drag, start) = body(&mut random, n % 2 == 0);
        let top = dragged(moments, drag, start);
        let (time, h) = (between(&mut random, 0.1, 10.0), 1e-4);
        let omega = top.at(time).unwrap();
        // (55): the derivative of the closed form, against the equations of the library for any body.
        let slope = (top.at(time + h).unwrap() - top.at(time - h).unwrap()) / (2.0 * h);
        assert_relative_eq!(slope, euler::rates(&moments, &omega, &top.torque_body(&omega)), epsilon = 1e-5);
        assert_relative_eq!(omega, simulated(moments, drag, start, time), epsilon = SIMULATED);
        // (54) and (57)
        let SymmetricMoments { transverse, axial } = moments.as_symmetric().unwrap();
        assert_relative_eq!(omega.z * (drag.axial * time / axial).exp(), start.z, max_relative = ROUNDING);
        let wobble = start.xy().norm_squared() * (-2.0 * drag.transverse * time / transverse).exp();
        assert_relative_eq!(omega.xy().norm_squared(), wobble, max_relative = ROUNDING);
    }
}

#[test]
fn eq56_the_cross_terms_cancel_in_the_sum_of_squares() {
    let mut random = fastrand::Rng::with_seed(56);
    for _ in 0..1000 {
        let (moments, drag, omega) = body(&mut random, true);
        let i1 = moments.as_symmetric().unwrap().transverse;
        // d/dt of ω₁² + ω₂² along the motion, by dual numbers: the state moves with its own rates.
        let rates = written_out::<f64>(moments, drag, omega.into());
        let moving: [Dual64; 3] = std::array::from_fn(|i| Dual64::new(omega[i], rates[i]));
        let squares = moving[0] * moving[0] + moving[1] * moving[1];
        assert_relative_eq!(
            0.5 * i1 * squares.eps,
            -drag.transverse * squares.re,
            max_relative = 1e-12,
            epsilon = 1e-14
        );
    }
}

#[test]
fn eq58_the_tangent_of_the_angle_is_that_of_a_simulation() {
    let mut random = fastrand::Rng::with_seed(58);
    let cases: Vec<(f64, f64)> = (0..100)
        .map(|_| {
            // One coefficient, the source's law, or two: the library knows both.
            for isotropic in [true, false] {
                let (moments, drag, start) = body(&mut random, isotropic);
                let time = between(&mut random, 0.1, 10.0);
                let judge = simulated(moments, drag, start, time);
                let found = dragged(moments, drag, start).axis_angle(time).unwrap();
                assert_relative_eq!(found, judge.xy().norm().atan2(judge.z), max_relative = 1e-8);
            }
            // The middle of (58), while there is spin left: the root belongs to the start. Printed without its index 0
            // it is that of now, and the decay is counted twice.
            let (moments, drag, start) = body(&mut random, true);
            let SymmetricMoments { transverse: i1, axial: i3 } = moments.as_symmetric().unwrap();
            let time = between(&mut random, 0.25, 3.0) * i1.min(i3) / drag.axial;
            let judge = simulated(moments, drag, start, time);
            let tangent = judge.xy().norm() / judge.z;
            let decays = (-drag.axial * time / i1).exp() / (-drag.axial * time / i3).exp();
            let corrected = start.xy().norm() * decays / start.z;
            let printed = judge.xy().norm() * decays / start.z;
            ((corrected / tangent - 1.0).abs(), (printed / tangent - 1.0).abs())
        })
        .collect();
    corrected_holds_and_printed_fails(cases, 1e-6, 0.01);
}

#[test]
fn eq04_and_eq58_the_angle_follows_the_law_of_the_source_for_one_drag_coefficient() {
    let mut random = fastrand::Rng::with_seed(4);
    for _ in 0..200 {
        let (moments, drag, start) = body(&mut random, true);
        let SymmetricMoments { transverse: i1, axial: i3 } = moments.as_symmetric().unwrap();
        let top = dragged(moments, drag, start);
        let time = between(&mut random, 0.1, 10.0);
        let exponent = -drag.axial * (i3 - i1) * time / (i1 * i3);
        let tangent = start.xy().norm() / start.z * exponent.exp();
        let angle = (start.xy().norm() * exponent.exp()).atan2(start.z);
        assert_relative_eq!(top.axis_angle(time).unwrap(), angle, max_relative = 1e-13);
        // The same law without the time: tan θ goes as a power of the spin that is left.
        let left = (top.at(time).unwrap().z / start.z).powf(i3 / i1 - 1.0);
        assert_relative_eq!(tangent, start.xy().norm() / start.z * left, max_relative = 1e-12);
    }
}

#[test]
fn the_axis_goes_where_the_decay_rates_send_it() {
    let omega = Vector3::new(1.0, 0.0, 1.0);
    let trend = |i1: f64, i3: f64, c1: f64, c3: f64| {
        let moments = PrincipalMoments::symmetric(i1, i3).unwrap();
        let top = dragged(moments, Drag { transverse: c1, axial: c3 }, omega);
        // Late in the motion the angle has gone where the name says.
        let late = 60.0 / top.alignment_rate().abs().max(1e-3);
        let angle = top.axis_angle(late).unwrap();
        match top.axis_trend() {
            AxisTrend::Aligning => assert!(angle < 1e-25),
            AxisTrend::Tumbling => assert!(angle == FRAC_PI_2),
            AxisTrend::Unchanged => {
                assert_relative_eq!(angle, 0.25 * std::f64::consts::PI, max_relative = 1e-15);
            }
        }
        top.axis_trend()
    };
    assert_eq!(trend(1.0, 2.0, 0.1, 0.1), AxisTrend::Aligning); // a plate
    assert_eq!(trend(2.0, 0.1, 0.1, 0.1), AxisTrend::Tumbling); // a pencil
    assert_eq!(trend(1.0, 1.0, 0.1, 0.1), AxisTrend::Unchanged); // a ball
    assert_eq!(trend(1.0, 2.0, 0.1, 0.3), AxisTrend::Tumbling); // a plate with rough rim: the verdict turns round
    assert_eq!(trend(2.0, 0.1, 0.1, 0.001), AxisTrend::Aligning); // a pencil with a fin
    assert_eq!(trend(1.0, 2.0, 0.1, 0.2), AxisTrend::Unchanged);
    // Equal decay rates that are not equal when rounded would decide by noise; C₁/I₁ = C₃/I₃ exactly decides nothing.
    assert_eq!(trend(3.0, 1.5, 0.3, 0.15), AxisTrend::Unchanged);
}

#[test]
fn the_wobble_goes_round_a_finite_number_of_times() {
    let mut random = fastrand::Rng::with_seed(9);
    for _ in 0..30 {
        let (moments, drag, start) = body(&mut random, true);
        let SymmetricMoments { transverse: i1, axial: i3 } = moments.as_symmetric().unwrap();
        let top = dragged(moments, drag, start);
        // Turn of ω₁ + iω₂ in a simulation of the logarithm: its imaginary part has the rate σ(t).
        let rates = |_: f64, &[w3, _]: &[f64; 2]| [-drag.axial / i3 * w3, w3 * (i3 - i1) / i1];
        let late = 40.0 * i3 / drag.axial;
        let end = Dop853::new(1e-13).unwrap().solve(any(rates), 0.0, [start.z, 0.0], late).unwrap();
        assert_relative_eq!(
            top.total_body_turns(),
            (end.state[1] / TAU).abs(),
            max_relative = 1e-10,
            epsilon = 1e-12
        );
    }
    let undamped = dragged(
        Body::thin_disk(1.0, 1.0).unwrap().moments(),
        Drag { transverse: 0.1, axial: 0.0 },
        Vector3::new(0.1, 0.0, 1.0),
    );
    assert_eq!(undamped.total_body_turns(), f64::INFINITY);
}

#[test]
fn the_attitude_is_that_of_eulers_equations_with_seven_numbers() {
    let mut random = fastrand::Rng::with_seed(11);
    for n in 0..20 {
        let (moments, drag, start) = body(&mut random, n % 2 == 0);
        let top = dragged(moments, drag, start);
        let world_from_body = UnitQuaternion::from_euler_angles(0.3, -0.8, 1.9);
        let times = [0.0, 0.5, 0.5, 4.0, 15.0];
        let thrown = thrown(&top, world_from_body);
        let samples = thrown.sample(&times).unwrap();
        let rates = euler::turning_rates(moments, |_, turning| top.torque_body(&turning.omega_body));
        let begin = Turning { world_from_body, omega_body: start };
        let (states, _) =
            Dop853::new(1e-13).unwrap().sample(any(rates), 0.0, begin.to_array(), &times).unwrap();
        for (sample, state) in samples.iter().zip(states) {
            let judge = Turning::from_array(state);
            assert!(rotation_between(&sample.world_from_body, &judge.world_from_body) < 1e-10);
            assert_relative_eq!(sample.omega_body, judge.omega_body, epsilon = SIMULATED);
        }
        for (sample, time) in samples.iter().zip(times) {
            let single = thrown.at(time).unwrap();
            assert!(rotation_between(&single.world_from_body, &sample.world_from_body) < SIMULATED);
        }
        assert_eq!(samples[0].world_from_body, world_from_body);
    }
}

#[test]
fn a_long_bodys_quick_spin_costs_no_steps() {
    let moments = PrincipalMoments::symmetric(1.0, 2e-3).unwrap();
    let top = dragged(moments, Drag { transverse: 0.05, axial: 1e-4 }, Vector3::new(3.0, 0.0, 3000.0));
    // In ten seconds it turns by 24,000 rad about itself and its axis by some 60 rad about L.
    let solver = Dop853::new(1e-12).unwrap().with_max_evaluations(6000);
    let thrown = top.thrown(UnitQuaternion::identity(), &solver).unwrap();
    assert!(thrown.at(10.0).is_ok());
    let rates = euler::turning_rates(moments, |_, turning| top.torque_body(&turning.omega_body));
    let begin = Turning { world_from_body: UnitQuaternion::identity(), omega_body: top.at(0.0).unwrap() };
    let end = Dop853::new(1e-13).unwrap().solve(any(rates), 0.0, begin.to_array(), 1.0).unwrap();
    let judge = Turning::from_array(end.state);
    assert!(rotation_between(&thrown.at(1.0).unwrap().world_from_body, &judge.world_from_body) < 1e-9);
}

#[test]
fn the_angle_is_known_long_after_the_spin_has_left_the_numbers() {
    let moments = PrincipalMoments::symmetric(2.0, 1.0).unwrap();
    let top = dragged(moments, Drag::isotropic(1.0), Vector3::new(1.0, 0.0, 1.0));
    assert_eq!(top.at(5000.0).unwrap(), Vector3::zeros()); // e^{−2500}
    assert_eq!(top.axis_angle(5000.0).unwrap(), FRAC_PI_2);
    let plate = PrincipalMoments::symmetric(1.0, 2.0).unwrap();
    let top = dragged(plate, Drag::isotropic(1.0), Vector3::new(1.0, 0.0, 1.0));
    assert_relative_eq!(top.axis_angle(1200.0).unwrap(), (-600.0_f64).exp(), max_relative = 1e-13);
}

#[test]
fn a_body_that_turns_exactly_along_or_across_its_axis_keeps_doing_so() {
    for ratio in [0.1, 1.0, 2.0] {
        let moments = PrincipalMoments::symmetric(1.0, ratio).unwrap();
        for omega in [Vector3::new(3.0, -1.0, 0.0), Vector3::new(0.0, 2.0, 0.0), Vector3::new(0.0, 0.0, -5.0)]
        {
            let top = dragged(moments, Drag::isotropic(0.1), omega);
            assert_eq!(top.axis_trend(), AxisTrend::Unchanged);
            assert_eq!(top.axis_angle(7.0).unwrap(), top.axis_angle(0.0).unwrap());
        }
        // A hair to the side it does not.
        let top = dragged(moments, Drag::isotropic(0.1), Vector3::new(1.0, 0.0, 1e-50));
        assert_eq!(top.axis_trend() == AxisTrend::Unchanged, ratio == 1.0);
    }
}

/// Jeffery's coefficients across and about the axis, in units of the viscosity, for an equatorial radius of one and the
/// other radius `eta`: his integrals over all ξ by the trapezium rule, with ξ = exp(sinh v) to bring both ends in.
fn jeffery(eta: f64) -> [f64; 2] {
    let (mut equatorial, mut polar) = (0.0, 0.0);
    let step = 0.01;
    for n in -500..=500 {
        let v = step * f64::from(n);
        let xi = v.sinh().exp();
        let weight = xi * v.cosh() * step / ((1.0 + xi) * (eta * eta + xi).sqrt());
        if weight.is_finite() {
            equatorial += weight / (1.0 + xi);
            polar += weight / (eta * eta + xi);
        }
    }
    let square = eta * eta;
    [(1.0 + square) / (equatorial + square * polar), 1.0 / equatorial].map(|part| 16.0 / 3.0 * PI * part)
}

/// A spheroid of an equatorial radius of one.
fn spheroid(eta: f64) -> Spheroid {
    Spheroid { equatorial_radius: 1.0, polar_radius: eta }
}

#[test]
fn the_drag_of_a_spheroid_is_that_of_jefferys_integrals() {
    let mut random = fastrand::Rng::with_seed(1922);
    let drawn = (0..300).map(|_| between(&mut random, 1e-3, 1e3));
    let near = (-40..=40).map(|n| 1.0 + 0.01 * f64::from(n));
    for eta in drawn.collect::<Vec<_>>().into_iter().chain(near) {
        let drag = Drag::of_spheroid(spheroid(eta), 1.0).unwrap();
        let [transverse, axial] = jeffery(eta);
        assert_relative_eq!(drag.transverse, transverse, max_relative = 1e-12);
        assert_relative_eq!(drag.axial, axial, max_relative = 1e-12);
    }
    // By mpmath with 40 digits.
    for (eta, transverse, axial) in [
        (0.015625, 10.670_539_540_313_26, 10.879_186_384_262_766),
        (0.25, 11.580_616_569_595_598, 14.134_199_006_271_245),
        (0.875, 21.637_387_202_050_125, 23.254_770_578_914_402),
        (0.890625, 22.044_736_703_721_887, 23.488_727_866_753_337),
        (1.0009765625, 25.162_210_713_990_8, 25.147_467_855_053_876),
        (1.125, 29.186_872_405_613_182, 27.024_194_786_743_15),
        (1.25, 33.828_852_839_354_06, 28.927_775_365_043_902),
        (2.0, 75.645_843_377_484_77, 40.547_993_478_379_845),
        (25.0, 38_368.635_602_771_72, 420.844_821_591_725_25),
    ] {
        let drag = Drag::of_spheroid(spheroid(eta), 1.0).unwrap();
        assert_relative_eq!(drag.transverse, transverse, max_relative = 1e-14);
        assert_relative_eq!(drag.axial, axial, max_relative = 1e-14);
    }
    // Known ends: Stokes's ball, and the disc, 32/3 about every axis.
    let ball = Drag::of_spheroid(spheroid(1.0), 1.0).unwrap();
    assert_relative_eq!(ball.transverse, 8.0 * PI, max_relative = 1e-15);
    let disc = Drag::of_spheroid(spheroid(1e-9), 1.0).unwrap();
    assert_relative_eq!(disc.transverse, 32.0 / 3.0, max_relative = 1e-8);
    assert_relative_eq!(disc.axial, 32.0 / 3.0, max_relative = 1e-8);
    let message = |eta, viscosity| Drag::of_spheroid(spheroid(eta), viscosity).unwrap_err().to_string();
    assert!(message(0.0, 1.0).contains("polar radius 0 m"));
    assert!(message(1.0, -1.0).contains("viscosity -1 Pa·s"));
}

#[test]
fn of_even_spheroids_the_flat_settle_and_the_long_tumble_as_the_closed_form_says() {
    let mut random = fastrand::Rng::with_seed(4);
    for _ in 0..40 {
        let eta = between(&mut random, 0.05, 20.0);
        let moments = Body::spheroid(1.0, spheroid(eta)).unwrap().moments();
        let drag = Drag::of_spheroid(spheroid(eta), 1e-4).unwrap();
        // Euler's equations by RK4, until the spin is nearly a half: the power is that of eq:spheroid-clocks.
        let start = [0.3, 0.0, 1.0];
        let axial = moments.as_symmetric().unwrap().axial;
        let end = 0.6 * axial / drag.axial;
        let [w1, w2, w3] =
            rk4(|_, omega| written_out(moments, drag, *omega), 0.0, start, end, 20_000).unwrap();
        let power = (w1.hypot(w2) / w3 / 0.3).ln() / w3.ln();
        let f = if eta < 1.0 {
            eta.acos() / (1.0 - eta * eta).sqrt()
        } else {
            eta.acosh() / (eta * eta - 1.0).sqrt()
        };
        let clocks = 2.0 * (eta - f) / ((2.0 * eta * eta - 1.0) * f - eta);
        assert_relative_eq!(power, clocks - 1.0, epsilon = 1e-6);
        let omega_body = Vector3::from(start);
        let trend = dragged(moments, drag, omega_body).axis_trend();
        assert_eq!(trend, if eta < 1.0 { AxisTrend::Aligning } else { AxisTrend::Tumbling }, "{eta}");
    }
}

#[test]
fn lentils_that_equal_coefficients_would_settle_tumble_up_to_a_ratio_of_their_shape() {
    // 1.26 for the shape with the least C₁/C₃, 0.41; 1.11 for one of a tenth.
    let border = |eta: f64| {
        let [transverse, axial] = jeffery(eta);
        axial / transverse
    };
    assert!((border(0.41) - 1.256).abs() < 5e-4 && (border(0.1) - 1.113).abs() < 5e-4);
    assert!([0.39, 0.43].map(border).iter().all(|other| *other < border(0.41)));
}

#[test]
fn in_slow_air_a_grain_stops_before_it_has_turned_once_and_a_steel_ball_in_thin_air_does_not() {
    // How far a ball turns until it stands still, by steps: a fifteenth of the densities' ratio times ωa²ρ/μ.
    let viscosity = 1.8e-5;
    let turned = |radius: f64, density: f64, air: f64, slow: f64| {
        let ball = Spheroid { equatorial_radius: radius, polar_radius: radius };
        let mass = density * 4.0 / 3.0 * PI * radius.powi(3);
        let moments = Body::spheroid(mass, ball).unwrap().moments();
        let drag = Drag::of_spheroid(ball, viscosity).unwrap();
        let spin = slow * viscosity / (air * radius * radius);
        let rates = |_: f64, state: &[f64; 4]| {
            let [x, y, z] = written_out(moments, drag, [state[0], state[1], state[2]]);
            [x, y, z, state[2]]
        };
        let time = 20.0 * moments.as_symmetric().unwrap().axial / drag.axial;
        let [.., angle] = rk4(rates, 0.0, [0.0, 0.0, spin, 0.0], time, 4000).unwrap();
        assert_relative_eq!(angle, density / air * slow / 15.0, max_relative = 1e-6);
        angle / TAU
    };
    assert!(turned(1e-5, 1000.0, 1.2, 0.1) < 1.0);
    assert!(turned(0.01, 7800.0, 0.012, 0.1) > 500.0);
}

#[test]
fn on_either_side_of_the_border_rk4_finds_the_fate_that_the_clocks_say() {
    let mut random = fastrand::Rng::with_seed(5);
    for _ in 0..60 {
        let ratio = between(&mut random, 0.05, 2.0);
        let moments = PrincipalMoments::symmetric(1.0, ratio).unwrap();
        for (factor, falls) in [(1.2, true), (1.0 / 1.2, false)] {
            // eq:fate-border with a fifth to one side of it or the other.
            let drag = Drag { transverse: 0.1 * factor / ratio, axial: 0.1 };
            let rates = |_: f64, omega: &[f64; 3]| written_out(moments, drag, *omega);
            let [w1, w2, w3] = rk4(rates, 0.0, [0.5, 0.2, 1.0], 5.0 * ratio, 4000).unwrap();
            assert_eq!(w1.hypot(w2) / w3 < 0.5_f64.hypot(0.2), falls);
        }
    }
}

#[test]
fn the_rounds_that_are_done_are_those_of_a_simulation() {
    // eq:rounds-done, counted from the direction of the transverse part.
    for (ratio, clocks) in [(2.0, 3.0), (1.5, 1.4), (0.4, 0.7)] {
        let moments = PrincipalMoments::symmetric(1.0, ratio).unwrap();
        let drag = Drag { transverse: 0.02 * clocks / ratio, axial: 0.02 };
        let top = dragged(moments, drag, Vector3::new(0.3, 0.0, 1.0));
        let wanted = if clocks > 1.0 { 0.5_f64 } else { 1.5 };
        let end = -wanted.ln() / top.alignment_rate();
        let (mut turned, mut state, steps) = (0.0, [0.3, 0.0, 1.0], 2000);
        for _ in 0..steps {
            let rates = |_: f64, omega: &[f64; 3]| written_out(moments, drag, *omega);
            let next = rk4(rates, 0.0, state, end / f64::from(steps), 20).unwrap();
            let [a, b] = [state, next].map(|w| w[1].atan2(w[0]));
            turned += (b - a + PI).rem_euclid(TAU) - PI;
            state = next;
        }
        let [w1, w2, w3] = state;
        assert_relative_eq!(w1.hypot(w2) / w3, 0.3 * wanted, max_relative = 1e-8);
        let done = top.total_body_turns() * (1.0 - wanted.powf(1.0 / (clocks - 1.0)));
        assert_relative_eq!(turned.abs() / TAU, done, max_relative = 1e-6);
    }
}

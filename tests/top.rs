//! The top under gravity: every formula by a route that shares no code with it, and the reference values.

use crate::common::any;
use mechanics::attitude::rotation_between;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, Cylinder};
use mechanics::integrate::{Dop853, Expand, Series, TAYLOR_ORDER, Taylor};
use mechanics::scenes::top::{Release, Top, TopMotion, TopParameters, Track};
use nalgebra::{Matrix2, UnitQuaternion, Vector3};
use num_dual::{DualNum, second_derivative};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Of the quadratures and of what a Taylor integrator with a tolerance of 1e-17 leaves.
const CLOSE: f64 = 1e-12;
/// A few units in the last place.
const ROUNDING: f64 = 2e-15;

const TOY: TopParameters =
    TopParameters { mass: 0.1, arm: 0.04, transverse: 2e-4, axial: 5e-5, gravity: 9.81 };

fn toy() -> Top {
    Top::new(TOY).unwrap()
}

fn release(degrees: f64, tilt_rate: f64, precession: f64, spin: f64) -> Release {
    Release { tilt: degrees.to_radians(), tilt_rate, precession, spin }
}

fn relative(found: f64, truth: f64) -> f64 {
    ((found - truth) / truth).abs()
}

/// The equations of motion in the body, written out anew: quaternion, ω₁, ω₂, ω₃.
struct Whole(TopParameters);

impl Expand<7> for Whole {
    fn expand(&self, series: &mut Series<7>) {
        let TopParameters { mass, arm, transverse, axial, gravity } = self.0;
        let (weight, gyroscopic) = (mass * gravity * arm / transverse, 1.0 - axial / transverse);
        for n in 0..TAYLOR_ORDER {
            let mut rates = [0.0; 6];
            for j in 0..=n {
                let [q0, q1, q2, q3, _, _, _] = series[j];
                let [r0, r1, _, r3, w1, w2, w3] = series[n - j];
                rates[0] -= 0.5 * (q1 * w1 + q2 * w2 + q3 * w3);
                rates[1] += 0.5 * (q0 * w1 + q2 * w3 - q3 * w2);
                rates[2] += 0.5 * (q0 * w2 + q3 * w1 - q1 * w3);
                rates[3] += 0.5 * (q0 * w3 + q1 * w2 - q2 * w1);
                rates[4] += gyroscopic * series[j][5] * w3 + 2.0 * weight * (q2 * r3 + q0 * r1);
                rates[5] -= gyroscopic * series[j][6] * w1 + 2.0 * weight * (r1 * q3 - r0 * q2);
            }
            let [a, b, c, d, e, f] = rates.map(|rate| rate / (n + 1) as f64);
            series[n + 1] = [a, b, c, d, e, f, 0.0];
        }
    }
}

fn stepped(top: &TopParameters, start: Turning, time: f64) -> Turning {
    let end = Taylor::new(1e-17).unwrap().solve(&Whole(*top), 0.0, start.to_array(), time).unwrap();
    Turning::from_array(end.state)
}

#[test]
fn reference_values_of_three_releases() {
    // By quadrature with thirty digits; the two states beside them by a Taylor integration.
    type Row = (f64, Track, f64, f64, f64, [[f64; 4]; 2]);
    let rows: [Row; 2] = [
        (
            0.0,
            Track::Cusps,
            0.739_638_418_717_725,
            0.222_047_481_491_608_1,
            1.316_629_982_301_374,
            [
                [0.05, 0.620_477_026_832_762_4, 0.115_292_683_804_981_05, 7.403_765_663_169_201],
                [1.0, 0.738_239_420_337_230_2, 5.933_062_906_288_155, 145.395_824_911_549_8],
            ],
        ),
        (
            -3.0,
            Track::Loops,
            0.669_663_607_041_051_3,
            0.216_306_619_105_191_25,
            1.255_420_391_374_850_6,
            [
                [0.7, 0.678_364_336_490_671_7, 3.814_890_018_628_053_4, 102.296_538_174_138_32],
                [2.0, 0.688_078_409_366_034, 11.361_738_649_126_163, 291.951_522_050_780_55],
            ],
        ),
    ];
    for (precession, track, lowest, nod, swing, states) in rows {
        let motion = toy().let_go(release(30.0, 0.0, precession, 150.0)).unwrap();
        assert_eq!(motion.track(), track);
        assert!(relative(motion.tilts()[1].cos(), lowest) < ROUNDING);
        assert!(relative(motion.nod_period().unwrap(), nod) < ROUNDING);
        assert!(relative(motion.swing_per_nod().unwrap(), swing) < ROUNDING);
        for [time, tilt, azimuth, own_turn] in states {
            let angles = motion.angles(time).unwrap();
            // The values are of θ₀ = 30° itself; the release has it rounded.
            assert!((angles.tilt - tilt).abs() < ROUNDING, "{angles:?}");
            assert!((angles.azimuth - azimuth).abs() < 4e-15 * (1.0 + azimuth), "{angles:?}");
            assert!((angles.own_turn - own_turn).abs() < 4e-15 * (1.0 + own_turn), "{angles:?}");
        }
    }
    let waves = toy().let_go(release(30.0, 0.0, 3.0, 150.0)).unwrap();
    assert_eq!(waves.track(), Track::Waves);
    assert!(relative(waves.tilts()[1].cos(), 0.805_247_446_931_773) < ROUNDING);
    assert!(relative(waves.nod_period().unwrap(), 0.227_236_270_828_996_56) < ROUNDING);
    assert!(relative(waves.swing_per_nod().unwrap(), 1.369_454_678_121_177_5) < ROUNDING);
    assert!(relative(toy().sleeping_spin(), 112.057_128_287_316_02) < 4e-16);
    let steady = toy().steady_precession(30_f64.to_radians(), 150.0).unwrap().unwrap();
    assert!(relative(steady.slow, 6.087_931_140_285_071) < ROUNDING);
    assert!(relative(steady.fast.unwrap(), 37.213_339_048_936_86) < ROUNDING);
}

/// Tops and starts of every kind.
fn kinds() -> Vec<(TopParameters, Release)> {
    let flat = TopParameters { mass: 0.3, arm: 0.02, transverse: 3e-4, axial: 3.5e-4, gravity: 9.81 };
    let far = TopParameters { gravity: 0.0, ..TOY };
    vec![
        (TOY, release(30.0, 0.0, 0.0, 150.0)),
        (TOY, release(30.0, -1.5, 3.0, 20.0)),
        (TOY, release(70.0, 2.0, -4.0, -90.0)),
        (TOY, release(1.0, 0.0, 0.0, 80.0)),
        (TOY, release(0.0, 1.0, 0.0, 80.0)),
        (TOY, release(180.0, 3.0, 0.0, 80.0)),
        (TOY, release(100.0, 0.0, 12.0, 0.0)),
        (TOY, release(0.0, 0.0, 0.0, 200.0)),
        (flat, release(60.0, 1.0, 2.0, 40.0)),
        (flat, release(120.0, 1.0, -20.0, 40.0)),
        (far, release(60.0, 1.0, 2.0, 40.0)),
    ]
}

#[test]
fn the_whole_body_stepped_with_its_weight_goes_the_same_way() {
    for (parameters, release) in kinds() {
        let top = Top::new(parameters).unwrap();
        let motion = top.let_go(release).unwrap();
        for time in [-0.7, 0.0, 0.013, 0.31, 1.0] {
            let (found, truth) = (motion.at(time).unwrap(), stepped(&parameters, motion.start(), time));
            let apart = rotation_between(&found.world_from_body, &truth.world_from_body);
            assert!(apart < CLOSE, "{release:?} {time}: {apart:e}");
            let size = truth.omega_body.norm().max(20.0);
            assert!((found.omega_body - truth.omega_body).norm() < CLOSE * size, "{release:?} {time}");
        }
        // Another integrator, on the rates that the library gives.
        let end =
            Dop853::new(1e-13).unwrap().solve(any(top.rates()), 0.0, motion.start().to_array(), 1.0).unwrap();
        let (found, truth) = (motion.at(1.0).unwrap(), Turning::from_array(end.state));
        assert!(rotation_between(&found.world_from_body, &truth.world_from_body) < 3e-9, "{release:?}");
    }
}

#[test]
fn momenta_and_energy_are_kept() {
    for (parameters, release) in kinds() {
        let top = Top::new(parameters).unwrap();
        let motion = top.let_go(release).unwrap();
        let start = motion.start();
        let upright = |state: &Turning| state.angular_momentum_world(&top.moments()).z;
        for n in 0..200 {
            let state = motion.at(0.05 * f64::from(n)).unwrap();
            let size = top.moments().angular_momentum(&start.omega_body).norm() + 1e-3;
            assert!((upright(&state) - upright(&start)).abs() < 1e-14 * size);
            assert_eq!(state.omega_body.z, release.spin);
            let energy = top.energy(&start);
            let size = top.moments().kinetic_energy(&start.omega_body) + top.weight_torque();
            assert!((top.energy(&state) - energy).abs() < 1e-14 * size, "{release:?}");
            // The rest of the energy lies in the well, whose slope the tilt feels.
            let tilt = motion.angles(0.05 * f64::from(n)).unwrap().tilt;
            let axial = 0.5 * parameters.axial * release.spin * release.spin;
            assert!((motion.well_energy() + axial - energy).abs() < 1e-14 * size);
            if (0.3..2.8).contains(&tilt) {
                assert!(motion.well(tilt) <= motion.well_energy() + 1e-13 * size);
            }
        }
        let [least, greatest] = motion.tilts();
        if least > 0.3 && greatest < 2.8 && motion.track() != Track::Steady {
            for tilt in [least, greatest] {
                let off = (motion.well(tilt) - motion.well_energy()).abs();
                assert!(off < 1e-13 * top.weight_torque().max(motion.well_energy().abs()), "{off:e}");
            }
        }
    }
}

/// Integrates from −1 to 1 by Gauss–Chebyshev: `∫ f(x)/√(1 − x²) dx`.
fn chebyshev(f: impl Fn(f64) -> f64) -> f64 {
    const COUNT: i32 = 400;
    let places = (0..COUNT).map(|n| (PI * (f64::from(n) + 0.5) / f64::from(COUNT)).cos());
    places.map(f).sum::<f64>() * PI / f64::from(COUNT)
}

#[test]
fn nod_and_swing_are_their_quadratures() {
    for (parameters, release) in kinds() {
        let motion = Top::new(parameters).unwrap().let_go(release).unwrap();
        let [least, greatest] = motion.tilts();
        // Without weight, near a pole and where it does not nod the quadrature needs another variable.
        if least < 0.1 || greatest > 3.0 || motion.track() == Track::Steady || parameters.gravity == 0.0 {
            continue;
        }
        let TopParameters { mass, arm, transverse, axial, gravity } = parameters;
        let beta = 2.0 * mass * gravity * arm / transverse;
        let a = axial * release.spin / transverse;
        let [u1, u2] = [greatest.cos(), least.cos()];
        // b from the start; the third root from the sum of all three, (α + a²)/β.
        let (sin, cos) = release.tilt.sin_cos();
        let b = release.precession * sin * sin + a * cos;
        let alpha = release.tilt_rate.powi(2) + (release.precession * sin).powi(2) + beta * cos;
        let u3 = (alpha + a * a) / beta - u1 - u2;
        let place = |x: f64| 0.5 * ((u1 + u2) + (u2 - u1) * x);
        let nod = chebyshev(|x| 2.0 / (beta * (u3 - place(x))).sqrt());
        let swing = chebyshev(|x| {
            let u = place(x);
            2.0 * (b - a * u) / (1.0 - u * u) / (beta * (u3 - u)).sqrt()
        });
        assert!(relative(motion.nod_period().unwrap(), nod) < CLOSE, "{release:?}");
        let found = motion.swing_per_nod().unwrap();
        assert!((found - swing).abs() < 1e-10, "{release:?}: {found} {swing}");
        // And the angles count as much from a nod to the next, with the own turn that belongs to ω₃.
        let angles = [0.0, 1.0, 7.0].map(|nods| motion.angles(nods * nod).unwrap());
        for (n, count) in [(1, 1.0), (2, 7.0)] {
            assert!((angles[n].azimuth - angles[0].azimuth - count * swing).abs() < 1e-9);
            let turned = angles[n].own_turn - angles[0].own_turn;
            assert!((turned - count * motion.own_turn_per_nod().unwrap()).abs() < 1e-9);
        }
    }
}

#[test]
fn without_weight_it_is_a_free_top() {
    let far = TopParameters { gravity: 0.0, ..TOY };
    let top = Top::new(far).unwrap();
    for release in
        [release(60.0, 1.0, 2.0, 40.0), release(60.0, 0.0, -7.0, 40.0), release(3.0, 1.0, 0.0, -4.0)]
    {
        let motion = top.let_go(release).unwrap();
        let free = FreeSymmetricTop::new(top.moments(), motion.start()).unwrap();
        for time in [-3.0, 0.2, 1.7, 400.0] {
            let [found, truth] = [motion.at(time).unwrap(), free.at(time).unwrap()];
            assert!(rotation_between(&found.world_from_body, &truth.world_from_body) < 4e-15);
            assert!((found.omega_body - truth.omega_body).norm() < 4e-14);
        }
    }
}

#[test]
fn without_spin_the_axis_is_a_spherical_pendulum() {
    // A bead on a sphere whose length is I₁/(ml): Newton's law with the constraint, in the room.
    let top = toy();
    let release = release(100.0, 1.0, 12.0, 0.0);
    let motion = top.let_go(release).unwrap();
    let pull = top.weight_torque() / TOY.transverse;
    let bead = |_: f64, state: &[f64; 6]| {
        let &[x, y, z, vx, vy, vz] = state;
        let (e, v) = (Vector3::new(x, y, z), Vector3::new(vx, vy, vz));
        let acceleration = -Vector3::z() * pull;
        let a = acceleration - e * (acceleration.dot(&e) + v.norm_squared());
        [vx, vy, vz, a.x, a.y, a.z]
    };
    let start = motion.start();
    let (e, v) = (start.axis_3_world(), start.omega_world().cross(&start.axis_3_world()));
    let end =
        Dop853::new(1e-13).unwrap().solve(any(bead), 0.0, [e.x, e.y, e.z, v.x, v.y, v.z], 2.0).unwrap().state;
    let found = motion.at(2.0).unwrap().axis_3_world();
    assert!((found - Vector3::new(end[0], end[1], end[2])).norm() < 1e-9);
}

/// The slope of the kinetic less the potential energy, as Lagrange has them, by dual numbers.
#[test]
fn steady_precession_balances_the_slope_of_the_lagrangian() {
    for (degrees, spin) in
        [(30.0, 150.0), (30.0, -150.0), (80.0, 90.0), (150.0, 60.0), (150.0, 0.0), (120.0, -3.0)]
    {
        let top = toy();
        let tilt = f64::to_radians(degrees);
        let steady = top.steady_precession(tilt, spin).unwrap().unwrap();
        for rate in [steady.slow, steady.fast.unwrap()] {
            let own = spin - rate * tilt.cos();
            let slope = |theta: num_dual::Dual2<f64>| {
                let (sin, cos) = (theta.sin(), theta.cos());
                let axial = cos * rate + own;
                sin * sin * (0.5 * TOY.transverse * rate * rate) + axial * axial * (0.5 * TOY.axial)
                    - cos * top.weight_torque()
            };
            let (_, slope, _) = second_derivative(slope, tilt);
            let size = TOY.transverse * rate * rate + top.weight_torque();
            assert!(slope.abs() < 1e-14 * size, "{degrees} {spin} {rate}: {slope:e}");
            // And the whole motion keeps its tilt, with the nod that is left of order of the rounding.
            let motion = top.let_go(release(degrees, 0.0, rate, spin)).unwrap();
            let [least, greatest] = motion.tilts();
            assert!(greatest - least < 1e-14, "{least} {greatest}");
            let azimuth = motion.angles(3.0).unwrap().azimuth;
            assert!((azimuth - 3.0 * rate).abs() < 1e-13 * (1.0 + azimuth.abs()), "{azimuth} {rate}");
        }
        let product = top.weight_torque() / (TOY.transverse * tilt.cos());
        assert!(relative(steady.slow * steady.fast.unwrap(), product) < ROUNDING);
    }
    // Where there are none, and where the two are one.
    let top = toy();
    assert_eq!(top.steady_precession(0.5, 100.0).unwrap(), None);
    let level = top.steady_precession(FRAC_PI_2, 100.0).unwrap().unwrap();
    assert!(level.fast.is_none() && relative(level.slow, top.weight_torque() / (TOY.axial * 100.0)) < 4e-16);
    let at_threshold = top.steady_precession(0.0, top.sleeping_spin() * (1.0 + 1e-14)).unwrap().unwrap();
    assert!(relative(at_threshold.fast.unwrap(), at_threshold.slow) < 1e-6);
}

#[test]
fn a_very_fast_top_keeps_the_digits_of_its_slow_precession() {
    // The difference of the two roots has lost all but three digits here.
    let (tilt, spin) = (0.4, 1e8);
    let slow = toy().steady_precession(tilt, spin).unwrap().unwrap().slow;
    let truth = toy().weight_torque() / (TOY.axial * spin); // to 1e-13 of itself
    assert!(relative(slow, truth) < 1e-12);
    let momentum: f64 = TOY.axial * spin;
    let double = 2.0 * TOY.transverse * tilt.cos();
    let naive = (momentum - (momentum * momentum - 2.0 * double * toy().weight_torque()).sqrt()) / double;
    assert!(relative(naive, truth) > 1e-6);
}

#[test]
fn the_upright_grows_as_its_linear_equations_say() {
    // Of a small leaning x + iy of the axis: ë = i a ė + ½βe in the room, for small angles.
    let top = toy();
    let beta = 2.0 * top.weight_torque() / TOY.transverse;
    for part in [0.0, 0.3, 0.9, 0.999, 1.001, 2.0] {
        let spin = part * top.sleeping_spin();
        let a = TOY.axial * spin / TOY.transverse;
        // e = exp(λt): λ² − iaλ − ½β = 0, so that λ is i times the eigenvalues of this matrix.
        let eigenvalues = Matrix2::new(0.0, 1.0, -0.5 * beta, a).complex_eigenvalues();
        let growth = eigenvalues.iter().map(|value| value.im.abs()).fold(0.0, f64::max);
        let found = top.growth_rate(spin).unwrap();
        assert!((found - growth).abs() < 1e-7 * beta.sqrt(), "{part}: {found} {growth}");
        // And a hair grows so.
        if part < 0.99 {
            let motion = top.let_go(Release { tilt: 1e-9, tilt_rate: 0.0, precession: 0.0, spin }).unwrap();
            let [early, late] = [0.5, 0.6].map(|time| motion.angles(time).unwrap().tilt);
            if late < 1e-3 && found > 5.0 {
                assert!(((late / early).ln() / 0.1 - found).abs() < 0.05 * found, "{part}");
            }
        }
    }
    assert_eq!(top.growth_rate(top.sleeping_spin() * (1.0 + 1e-15)).unwrap(), 0.0);
}

#[test]
fn a_sleeper_wakes_gently() {
    let top = toy();
    let sleeping = top.sleeping_spin();
    for part in [0.2, 0.7, 0.99, 1.0 - 1e-9] {
        let spin = part * sleeping;
        // The least of its well lies where it can stand.
        let motion = top.let_go(Release { tilt: 0.0, tilt_rate: 0.0, precession: 0.0, spin }).unwrap();
        let resting = top.waking_tilt(spin).unwrap();
        if part < 0.995 {
            let [below, here, above] = [0.999, 1.0, 1.001].map(|part| motion.well(part * resting));
            assert!(below > here && above > here, "{part}");
        }
        assert!((resting.cos() - (2.0 * part - 1.0)).abs() < 1e-15, "{part}");
        // It goes round there steadily, with the momentum about the vertical that it had upright.
        let steady = top.steady_precession(resting, spin).unwrap().unwrap();
        let spun = TOY.transverse * resting.sin().powi(2);
        let needed = TOY.axial * spin * (1.0 - resting.cos());
        let near = [steady.slow, steady.fast.unwrap()]
            .map(|rate| (spun * rate - needed).abs())
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        // Near the threshold both rates are nearly one, and hang on the rounding of the tilt by its root.
        let rounding = if part < 0.995 { 1e-12 } else { 1e-12 / resting };
        assert!(near < rounding * TOY.axial * spin, "{part}: {near:e}");
        // From upright, by the least push, it nods out to twice as far in cos θ, and back.
        let pushed = top.let_go(Release { tilt: 0.0, tilt_rate: 1e-12, precession: 0.0, spin }).unwrap();
        let furthest = top.furthest_tilt(spin).unwrap();
        assert!((pushed.tilts()[1] - furthest).abs() < 1e-10, "{part}");
        assert!((furthest.cos() - (2.0 * part * part - 1.0)).abs() < 1e-15);
        assert_eq!(pushed.tilts()[0], 0.0);
    }
    for spin in [sleeping * 1.01, 2.0 * sleeping] {
        assert_eq!([top.waking_tilt(spin).unwrap(), top.furthest_tilt(spin).unwrap()], [0.0; 2]);
    }
    // The lean is the root of what is missing.
    let lean = top.waking_tilt(sleeping * (1.0 - 1e-8)).unwrap();
    assert!((lean - 2e-4).abs() < 1e-10, "{lean}");
}

/// The benchmark of integrators on rotations: a top that passes beside straight down.
#[test]
fn the_benchmark_top_misses_the_vertical_by_less_than_a_microradian() {
    let body = Body::new(15.0, mechanics::inertia::PrincipalMoments::symmetric(0.234_375, 0.468_75).unwrap())
        .unwrap();
    let top = Top::on_a_point(&body, 1.0, 9.81).unwrap();
    assert_eq!(top.parameters().transverse, 15.234_375);
    let level = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), FRAC_PI_2);
    let start = Turning { world_from_body: level, omega_body: Vector3::new(0.0, -4.615_38, 150.0) };
    let motion = top.motion(&start).unwrap();
    let missed = PI - motion.tilts()[1];
    assert!((missed - 7.24e-7).abs() < 1e-9, "{missed:e}");
    for time in [0.3, 1.0, 2.0] {
        let (found, truth) = (motion.at(time).unwrap(), stepped(&top.parameters(), start, time));
        assert!(rotation_between(&found.world_from_body, &truth.world_from_body) < CLOSE);
    }
}

#[test]
fn a_million_nods_later_it_is_where_the_mean_rates_say() {
    let motion = toy().let_go(release(30.0, 0.0, 0.0, 150.0)).unwrap();
    let nod = motion.nod_period().unwrap();
    let swing = motion.swing_per_nod().unwrap();
    let late = motion.angles(1e6 * nod).unwrap();
    // The period is rounded: so much of a nod is missing or over.
    assert!((late.tilt - 30_f64.to_radians()).abs() < 1e-12);
    assert!((late.azimuth - 1e6 * swing).abs() < 3e-9, "{}", late.azimuth - 1e6 * swing);
}

#[test]
fn what_a_fast_top_does() {
    // Fast precession of the mean mgl/(I₃ω₃), a nod of 2πI₁/(I₃ω₃), a drop of 2I₁ mgl sin θ/(I₃ω₃)².
    let top = toy();
    let spin = 3e4;
    let momentum = TOY.axial * spin;
    let motion = top.let_go(release(40.0, 0.0, 0.0, spin)).unwrap();
    let nod = motion.nod_period().unwrap();
    let drop = motion.tilts()[1] - motion.tilts()[0];
    let sin = 40_f64.to_radians().sin();
    assert!(relative(nod, TAU * TOY.transverse / momentum) < 1e-4);
    assert!(relative(drop, 2.0 * TOY.transverse * top.weight_torque() * sin / momentum.powi(2)) < 1e-4);
    assert!(relative(motion.swing_per_nod().unwrap() / nod, top.weight_torque() / momentum) < 1e-4);
}

#[test]
fn tracks_are_waves_cusps_and_loops() {
    let track = |release| toy().let_go(release).unwrap().track();
    assert_eq!(track(release(30.0, 0.0, 1e-6, 150.0)), Track::Waves);
    assert_eq!(track(release(30.0, 0.0, 0.0, 150.0)), Track::Cusps);
    assert_eq!(track(release(30.0, 0.0, -1e-6, 150.0)), Track::Loops);
    assert_eq!(track(release(30.0, 0.0, 1e-6, -150.0)), Track::Loops);
    assert_eq!(track(release(0.0, 0.0, 0.0, 150.0)), Track::Steady);
    assert_eq!(track(release(0.0, 1.0, 0.0, 150.0)), Track::Waves);
    let still: TopMotion = toy().let_go(release(180.0, 0.0, 0.0, 3.0)).unwrap();
    assert_eq!((still.track(), still.tilts()), (Track::Steady, [PI; 2]));
}

#[test]
fn a_cylinder_on_its_end_has_moments_about_the_end() {
    let body = Body::cylinder(0.5, Cylinder { radius: 0.02, height: 0.1 }).unwrap();
    let top = Top::on_a_point(&body, 0.05, 9.81).unwrap();
    let about_end = body.about(&Vector3::new(0.0, 0.0, 0.05)).unwrap();
    let [transverse, other, axial] = top.moments().to_array();
    assert!(relative(transverse, about_end.matrix()[(0, 0)]) < 4e-16 && other == transverse);
    assert_eq!(axial, about_end.matrix()[(2, 2)]);
}

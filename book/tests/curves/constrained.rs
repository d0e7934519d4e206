//! The pinned hoop, the rolling wheel and the spinning coin: what the library says of them where no figure samples it.

use crate::{curve, lies_on, passes};
use mechanics::integrate::{Direction, Dop853, Outcome, Taylor, rk4};
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::pinned_hoop::{Pin, Pinning, PinningParameters, Shape};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::spinning_coin::{BrakedDisk, EulersDisk, Loss, SpinDown, SpinningCoin};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

fn pinned(shape: Shape, pin: Pin) -> Pinning {
    Pinning::new(PinningParameters { shape, mass: 1.0, radius: 1.0, spin: 1.0, pin }).expect("a pinned body")
}

fn hoop(degrees: f64) -> Pinning {
    pinned(Shape::Hoop, Pin::Angle(degrees.to_radians()))
}

fn wheel(transverse: f64, axial: f64) -> Wheel {
    let moments = MomentFactors { transverse, axial };
    Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 }).expect("a wheel")
}

fn toy(tilt: f64) -> SpinningCoin {
    let moments = MomentFactors::DISK;
    let parameters = DiskParameters { mass: 0.4, radius: 0.0375, moments, gravity: 9.81 };
    SpinningCoin::new(parameters, tilt).expect("a coin")
}

#[test]
fn the_speeds_of_b_are_a_difference_a_sum_and_a_root() {
    let parts = |degrees: f64| (degrees.to_radians().sin() / 3.0, degrees.to_radians().cos());
    lies_on("speed-of-b", "plus", |degrees| (parts(degrees).0 - parts(degrees).1).abs());
    lies_on("speed-of-b", "minus", |degrees| parts(degrees).0 + parts(degrees).1);
    lies_on("speed-of-b", "stated", |degrees| parts(degrees).0.hypot(parts(degrees).1));
}

#[test]
fn the_portrait_is_that_of_a_pendulum_let_go_at_the_angle_of_each_pin() {
    // χ̈ = ¼ W² sin 2χ keeps χ̇² − ½ W² sin² χ: nought at a start at rest, 0.45² for the two that turn over.
    let rate = |degrees: f64, kept: f64| (kept + 0.5 * degrees.to_radians().sin().powi(2)).sqrt();
    for theta in [60.0_f64, 80.0, 89.0] {
        let start = (3.0 / theta.to_radians().tan()).atan();
        let angles = (0..=200).map(|n| start.to_degrees() * (1.0 - 0.01 * f64::from(n)) + 0.9 * f64::from(n));
        let rates = angles.map(|degrees| (degrees, rate(degrees, -0.5 * start.sin().powi(2)).max(0.0)));
        passes("hoop-pendulum", &format!("pin-{theta}"), rates);
    }
    lies_on("hoop-pendulum", "over-above", |degrees| rate(degrees, 0.45 * 0.45));
    lies_on("hoop-pendulum", "over-below", |degrees| -rate(degrees, 0.45 * 0.45));
}

#[test]
fn the_swing_at_sixty_degrees_is_that_of_the_pendulum_step_by_step() {
    let hoop = hoop(60.0);
    let (rate, period) = (hoop.omega_after().norm(), hoop.free_motion().unwrap().period().unwrap());
    let pendulum = |_t: f64, &[chi, turn]: &[f64; 2]| [turn, 0.25 * rate * rate * (2.0 * chi).sin()];
    let chi = |part: f64| {
        let start = [60_f64.to_radians(), 0.0];
        rk4(pendulum, 0.0, start, part * period, 400).expect("it swings")[0]
    };
    lies_on("swing-at-sixty", "angle", |part| chi(part).to_degrees());
    lies_on("swing-at-sixty", "tangent", |part| chi(part).cos());
    lies_on("swing-at-sixty", "diameter", |part| -chi(part).sin());
}

#[test]
fn the_hoop_flips_and_waits_as_the_library_has_it() {
    let top = hoop(89.9).free_motion().expect("free");
    lies_on("flip", "diameter", |time| top.at(time).expect("a state").omega_body.y);
    lies_on("waits", "disc", |gap| {
        let pin = Pin::Point { from_axis: (1.0 - gap * gap).sqrt(), height: gap };
        pinned(Shape::Disk, pin).wait().expect("a body").expect("a wait")
    });
}

#[test]
fn the_plateau_is_half_as_wide_as_the_logarithm_of_its_gap() {
    for decades in [2, 4, 8] {
        let gap = 0.1_f64.powi(decades);
        let up = |zeta: f64| {
            ((zeta.exp().powi(2) * gap + 1.0) * ((-zeta).exp().powi(2) * gap + 1.0)).sqrt().recip()
        };
        lies_on("wait-plateau", &format!("gap-{decades}"), up);
    }
}

#[test]
fn the_tip_of_a_free_body_goes_round_as_its_quadrature_says() {
    // eq:tip-heading for I = (1, 2, 2.5) and ω = (0.6, 0, 1), stepped along with Euler's equations.
    let momentum = Vector3::new(0.6, 0.0, 2.5);
    let rates = |_: f64, [x, y, z, _]: &[f64; 4]| {
        let across = x * x + 4.0 * y * y;
        [-0.5 * y * z, 0.75 * z * x, -0.4 * x * y, momentum.norm() * (x * x + 2.0 * y * y) / across]
    };
    let steps = Dop853::new(1e-12).unwrap();
    let place = |time: f64| {
        let [x, y, _, heading] = steps.solve(rates, 0.0, [0.6, 0.0, 1.0, PI], time).expect("a motion").state;
        let radius = (x * x + 4.0 * y * y).sqrt() / momentum.norm();
        (radius * heading.cos(), radius * heading.sin())
    };
    passes("tip-path", "first-period", (1..60).map(|n| place(0.1 * f64::from(n))));
}

#[test]
fn the_tip_of_the_spin_draws_the_rosette() {
    let hoop = hoop(60.0);
    let top = hoop.free_motion().expect("free");
    let upright = UnitQuaternion::rotation_between(&hoop.angular_momentum(), &Vector3::z()).expect("a turn");
    let period = top.period().expect("it swings");
    passes(
        "herpolhode",
        "rosette",
        (0..430).map(|n| {
            let room =
                upright * top.at((1.0 + 5.0 * f64::from(n) / 430.0) * period).expect("a state").omega_world();
            (room.x, room.y)
        }),
    );
    // In its first period ω goes round by 279°, as the page says: in which sense, and over the top, a reader sees.
    let first = curve("herpolhode", "first-period").values();
    let [from, to] = [first[0], first[first.len() - 1]].map(|(x, y)| y.atan2(x).to_degrees());
    assert!(((to - from).rem_euclid(360.0) - 278.59).abs() < 0.1, "from {from} to {to}");
}

#[test]
fn the_turn_rate_and_the_potential_of_a_disc_are_those_of_the_library() {
    let disc = wheel(0.25, 0.5);
    for degrees in [20.0_f64, 45.0, 70.0] {
        lies_on("turn-rate", &format!("lean-{degrees}"), |b| {
            disc.steady(degrees.to_radians(), b).map_or(f64::NAN, |steady| steady.turn_rate().powi(-2))
        });
    }
    let start = Rolling { tilt: FRAC_PI_2 - 0.3, omega_2: 0.45, omega_3: 0.9, ..Rolling::UPRIGHT };
    let constants = disc.constants(&start);
    lies_on("potential", "potential", |lean| disc.potential(&constants, FRAC_PI_2 - lean.to_radians()));
}

#[test]
fn the_slow_coin_turns_back_where_its_potential_is_as_high_as_the_upright() {
    let disc = wheel(0.25, 0.5);
    let curve_of = |name| curve("two-wells", name);
    // Nudged, it leans as far as this, step by step.
    let start = Rolling { omega_1: 1e-4, omega_3: 0.5, ..Rolling::UPRIGHT };
    let times: Vec<f64> = (1..=6000).map(|k| 0.01 * f64::from(k)).collect();
    let rates = |t: f64, state: &[f64; 8]| disc.rates(t, state);
    let (path, _) = Dop853::new(1e-12).unwrap().sample(rates, 0.0, start.to_array(), &times).unwrap();
    let farthest =
        path.iter().map(|state| Rolling::from_array(*state).lean().to_degrees()).fold(0.0, f64::max);
    assert!((farthest - 32.4).abs() < 0.05, "{farthest}");
    for lean in [-farthest, 0.0, farthest] {
        assert!(curve_of("slow").distance((lean, 0.0)) < 0.5, "{lean}");
    }
    // And where its lean changes quickest, the well is as deep as this costs.
    let deepest = path
        .iter()
        .map(|state| Rolling::from_array(*state))
        .max_by(|one, other| one.omega_1.abs().total_cmp(&other.omega_1.abs()))
        .expect("states");
    // The energy of the lean, ½ (I₁ + m a²) ω₁².
    let depth = 1e3 * 0.5 * 1.25 * deepest.omega_1.powi(2);
    assert!(curve_of("slow").distance((deepest.lean().to_degrees(), -depth)) < 0.5, "{deepest:?} {depth}");
    let fast = curve_of("fast");
    let ground = fast.axes.point((0.0, 0.0)).y;
    assert!(fast.points.iter().all(|(_, y)| *y < ground + 0.08));
}

#[test]
fn the_ledge_and_its_hollow_are_the_energy_of_the_spins_and_of_the_height() {
    let disc = wheel(0.25, 0.5);
    let [_, edge] = disc.unstable_circles(15_f64.to_radians()).expect("a lean").expect("below the tip");
    let steady = disc.steady(15_f64.to_radians(), edge).expect("rolls").omega();
    let solver = Dop853::new(1e-11).unwrap();
    // How both spins go with the lean (eq:spins-of-lean), from 15° to another lean.
    let energy = |part: f64, degrees: f64| {
        let way = (degrees - 15.0).to_radians();
        let rates = |done: f64, [q, n]: &[f64; 2]| {
            let lean = 15_f64.to_radians() + done * way;
            [way * (q * lean.tan() + 2.0 * n), way * q / 1.5]
        };
        let [q, n] = solver.solve(rates, 0.0, [part * steady.y, part * steady.z], 1.0).expect("spins").state;
        0.5 * (0.25 * q * q + 1.5 * n * n) + degrees.to_radians().cos()
    };
    let level = energy(1.0, 15.0);
    lies_on("ledge", "level", |lean| 1e3 * (energy(1.0, lean) - level));
    lies_on("ledge", "tilted", |lean| 1e3 * (energy(0.97, lean) - level));
}

#[test]
fn the_tongues_are_bounded_by_the_unstable_circles() {
    for (figure, name, wheel) in [
        ("tongue-tips", "hoop", wheel(0.5, 1.0)),
        ("tongue-tips", "disc", wheel(0.25, 0.5)),
        ("tongue-tips", "weights", wheel(2.0, 0.5)),
        ("tongue-tips", "beads", wheel(0.1, 0.002)),
    ] {
        let most = curve(figure, name).axes.x.to;
        let leans = (1..300).map(|step| wheel.safe_lean() * (f64::from(step) + 0.37) / 301.0);
        let checked = passes(
            figure,
            name,
            leans.flat_map(|lean| {
                let edges = wheel.unstable_circles(lean).expect("a lean").expect("below the tip");
                edges.into_iter().filter(|b| (0.01..most).contains(b)).map(move |b| (b, lean.to_degrees()))
            }),
        );
        assert!(checked > 300, "{figure}, {name}: only {checked}");
    }
}

#[test]
fn wheels_are_joined_that_are_safe_from_the_same_lean_on() {
    for degrees in [20.0_f64, 25.0, 30.0] {
        let values = curve("tip-of-shape", &format!("tip-{degrees}")).values();
        assert!(values.len() > 8, "{degrees}: {}", values.len());
        for (transverse, axial) in values {
            let tip = wheel(transverse, axial).safe_lean().to_degrees();
            assert!((tip - degrees).abs() < 0.1, "{transverse}, {axial}: {tip}°");
        }
    }
}

#[test]
fn the_contact_of_a_wheel_runs_as_its_wobble_says() {
    let (tilt, solver) = (0.05, Taylor::new(1e-13).unwrap());
    let disc = wheel(0.25, 0.5);
    for (wheel, name) in [(disc, "disc"), (wheel(0.5, 1.0), "hoop")] {
        let steady = wheel.steady(FRAC_PI_2 - tilt, 0.0).expect("rolls").state().omega_2;
        lies_on("near-flat-turn", name, |part| {
            let start = Rolling { tilt, omega_2: part * steady, ..Rolling::UPRIGHT };
            wheel.wobble(start, &solver).map_or(f64::NAN, |wobble| wobble.heading_advance().to_degrees())
        });
    }
    let start = Rolling { omega_1: 0.3, ..disc.steady(0.55, 1.6).expect("rolls").state() };
    let wobble = disc.wobble(start, &solver).expect("a wobble");
    passes(
        "contact-track",
        "all",
        (0..500).map(|n| {
            let contact =
                wobble.at((0.5 + 0.02 * f64::from(n)) * wobble.period()).expect("a state").contact(1.0);
            (contact.re, contact.im)
        }),
    );
}

#[test]
fn the_ways_down_are_those_of_a_disc_with_a_very_weak_brake() {
    let disc = wheel(0.25, 0.5);
    let rates = disc.slowed_rates(5e-4);
    let fallen = |_: f64, state: &[f64; 8]| 1.3 - Rolling::from_array(*state).lean();
    let solver = Dop853::new(1e-9).unwrap();
    for name in ["straight-1", "straight-10", "spin-1", "spin-30", "edge-10", "edge-13", "edge-18"] {
        let drawn = curve("ways-down", name);
        // Well above the edge, where a wobble is quick beside the loss.
        let values = drawn.values();
        let &(b, degrees) = values.iter().find(|value| value.1 > values[0].1 + 9.0).expect("a way up");
        let start = disc.steady(degrees.to_radians(), b).expect("rolls").state().to_array();
        let outcome = solver.solve_until(rates, 0.0, start, 1e5, fallen, Direction::Falling).unwrap();
        let Outcome::Event(end) = outcome else { panic!("{name} does not come down") };
        let times: Vec<f64> = (1..400).map(|n| end.time * f64::from(n) / 400.0).collect();
        for state in solver.sample(rates, 0.0, start, &times).unwrap().0.into_iter().map(Rolling::from_array)
        {
            let pair = (state.omega_3 * state.lean().cos() / state.omega_2, state.lean().to_degrees());
            let off = drawn.distance(pair);
            assert!(off < 0.95, "{name}: {pair:?}: {off}"); // the brake is weak, and not nothing
        }
    }
}

/// The toy on its way down by a law of loss with which it lives for 100 s.
fn going_down(power: f64) -> (SpinDown, Loss) {
    let life = SpinDown::new(toy(0.1), Loss::new(1.0, power).unwrap()).unwrap().life();
    let loss = Loss::new(life / 100.0, power).unwrap();
    (SpinDown::new(toy(0.1), loss).unwrap(), loss)
}

#[test]
fn the_circle_of_the_centre_opens_as_the_film_has_it() {
    let disk = EulersDisk::in_air(toy(0.1).parameters(), 1.78e-5).expect("a disk");
    let start = disk.steady(0.1).expect("steady");
    let sinking = disk.sinking(start, &Taylor::new(1e-12).unwrap()).expect("it sinks");
    let drawn = curve("circle-opens", "motion");
    for n in 0..60 {
        let state = sinking.at(1.57 * f64::from(n)).expect("a state");
        let off = drawn.distance((state.tilt, 1e3 * state.omega_3 * state.tilt.sin() / state.omega_2));
        assert!(off < 0.3, "{n}: {off}"); // the wobbles on the way are narrower than the line
    }
}

#[test]
fn the_disk_ends_as_its_motion_with_each_loss_does() {
    lies_on("table-holds", "steady", |tilt| toy(tilt).contact_speed() / 343.0);
    for power in [2.0, 1.25, 1.0, 0.5] {
        let (down, loss) = going_down(power);
        let tilt = |left: f64| down.with_time_left(left).map_or(f64::NAN, |coin| coin.tilt());
        lies_on("spin-down", &format!("law-{power}"), |time| tilt(100.0 - time));
        lies_on("spin-down", &format!("end-{power}"), tilt);

        let last = down.with_time_left(down.time_left_at_free_fall()).expect("a coin").tilt();
        // From above all curves to below, in steps that no figure takes; seven of them are a root of two.
        let tilts: Vec<f64> =
            (1..).map(|n| 0.09 / SQRT_2.powf(f64::from(n) / 7.0)).take_while(|t| *t > 0.38 * last).collect();
        let disk = BrakedDisk::new(toy(0.1).parameters(), loss).expect("a disk");
        let omega_1 = 0.1_f64.tan() / ((power + 1.0) * down.life());
        let start = Rolling { omega_1, ..toy(0.1).state() };
        let sunk = disk.sink(start, &tilts, &Dop853::new(1e-10).unwrap()).expect("it sinks");
        let exponents = sunk.windows(15).map(|those| {
            let [high, middle, low] = [those[0].time, those[7].time, those[14].time];
            (those[7].state.tilt, SQRT_2.ln() / ((middle - high) / (low - middle)).ln())
        });
        let exponents = exponents.filter(|(_, exponent)| (0.0..0.85).contains(exponent));
        passes("four-exponents", &format!("exponent-{power}"), exponents);
        let states = || sunk.iter().map(|there| &there.state).filter(|state| state.tilt < 0.089);
        let carried = states().filter(|state| (0.46..9.9).contains(&(state.tilt / last)));
        let weights = carried.map(|state| (state.tilt / last, disk.support(state).z / (0.4 * 9.81)));
        passes("table-holds", &format!("support-{power}"), weights);
        let mach = states().map(|state| (state.tilt, 0.0375 * state.omega_2 / state.tilt.tan() / 343.0));
        let checked =
            passes("table-holds", &format!("contact-{power}"), mach.filter(|(_, mach)| *mach > 0.0101));
        assert!(checked > 50, "{power}: {checked}");
    }
}

#[test]
fn the_light_of_a_lamp_on_the_rim_is_rolled_off_the_smaller_circle() {
    // Seen from above the contact is at the angle θ on the circle of radius ¾, and the lamp by ¾ of the way behind it on the rim.
    let lamp = |turned: f64| {
        let ((sin, cos), (behind, near)) = ((turned - FRAC_PI_2).sin_cos(), (0.75 * turned).sin_cos());
        (0.75 * near * cos + behind * sin, 0.75 * near * sin - behind * cos)
    };
    passes("rim-lamp", "light", (0..500).map(|n| lamp(0.0501 * f64::from(n))));
    let turn = |n: u32| f64::from(n) / 100.0 * 2.0 * PI;
    passes("rim-lamp", "stops", (0..100).map(|n| (0.75 * turn(n).cos(), 0.75 * turn(n).sin())));
    passes("rim-lamp", "rim", (0..100).map(|n| (turn(n).cos(), turn(n).sin())));
}

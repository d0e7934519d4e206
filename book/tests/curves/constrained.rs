//! The pinned hoop, the rolling wheel and the spinning coin: what the library says of them where no figure samples it.

use crate::{PIXELS, curve, lies_on};
use mechanics::integrate::{Direction, Dop853, Outcome, Taylor};
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::pinned_hoop::{Pin, Pinning, PinningParameters, Shape};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::spinning_coin::{BrakedDisk, EulersDisk, Loss, SpinDown, SpinningCoin};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

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
fn the_hoop_flips_as_its_free_motion_does() {
    let top = hoop(89.9).free_motion().expect("free");
    for (axis, name) in [(0, "tangent"), (1, "diameter")] {
        lies_on("flip", name, |time| top.at(time).expect("a state").omega_body[axis]);
    }
}

#[test]
fn the_portrait_is_that_of_a_pendulum_let_go_at_the_angle_of_each_pin() {
    // χ̈ = ¼ W² sin 2χ, with time in 1/W.
    let rates = |_: f64, [angle, rate]: &[f64; 2]| [*rate, 0.25 * (2.0 * angle).sin()];
    let times: Vec<f64> = (1..4000).map(|n| 0.005 * f64::from(n)).collect();
    for theta in [60.0_f64, 80.0, 89.0] {
        let drawn = curve("hoop-pendulum", &format!("pin-{theta}"));
        let start = (3.0 / theta.to_radians().tan()).atan();
        let (states, _) = Dop853::new(1e-10).unwrap().sample(rates, 0.0, [start, 0.0], &times).unwrap();
        for [angle, rate] in &states {
            let off = drawn.distance((angle.to_degrees(), *rate));
            assert!(off < PIXELS, "{theta}: {angle} {rate}: {off}");
        }
        let widest = states.iter().map(|state| state[0]).fold(0.0, f64::max).to_degrees();
        assert!((widest + start.to_degrees() - 180.0).abs() < 0.01, "{theta}: it swings to {widest}");
    }
    // Energies: that of the balance, and that of a start at χ = 0 with a rate of 0.45 W.
    for (name, sign) in [("above", 1.0), ("below", -1.0)] {
        let rate = |degrees: f64, start: f64| sign * start.hypot(degrees.to_radians().sin() / SQRT_2);
        lies_on("hoop-pendulum", &format!("over-{name}"), |degrees| rate(degrees, 0.45));
        let outside = |degrees: f64| if (0.0..180.0).contains(&degrees) { 1.0 } else { -1.0 };
        lies_on("hoop-pendulum", &format!("separatrix-{name}"), |degrees| {
            outside(degrees) * rate(degrees, 0.0)
        });
    }
}

#[test]
fn waits_are_those_of_the_library() {
    let wait = |shape: Shape, gap: f64| {
        let pin = Pin::Point { from_axis: (1.0 - gap * gap).sqrt(), height: gap };
        pinned(shape, pin).wait().expect("a body").expect("a wait")
    };
    lies_on("waits", "hoop", |gap| wait(Shape::Hoop, gap));
    lies_on("waits", "disc", |gap| wait(Shape::Disk, gap));
    let ball = curve("waits", "ball");
    for step in 0..200 {
        let gap = 0.0076 * 120_f64.powf(f64::from(step) / 200.0);
        assert!(ball.distance((gap, wait(Shape::Sphere, gap))) < PIXELS, "{gap}");
    }
}

#[test]
fn the_tips_of_spin_and_momentum_draw_the_rosette() {
    let hoop = hoop(60.0);
    let (top, moments) = (hoop.free_motion().expect("free"), hoop.moments_about_pin());
    let upright = UnitQuaternion::rotation_between(&hoop.angular_momentum(), &Vector3::z()).expect("a turn");
    let [late, first] = ["rosette", "first-period"].map(|name| curve("herpolhode", name));
    let [omega, momentum] = ["omega-in-hoop", "momentum-in-hoop"].map(|name| curve("herpolhode", name));
    for n in 0..430 {
        let state = top.at(0.185 * f64::from(n)).expect("a state");
        let (spin, about_pin) = (state.omega_body, moments.angular_momentum(&state.omega_body));
        assert!(omega.distance((spin.x, spin.z)) < PIXELS, "{spin}");
        assert!(momentum.distance((about_pin.x, about_pin.z)) < PIXELS, "{spin}");
        let room = upright * state.omega_world();
        let off = late.distance((room.x, room.y)).min(first.distance((room.x, room.y)));
        assert!(off < PIXELS, "{room}: {off}");
    }
    // In its first period ω goes round by 279°, as the page says: in which sense, and over the top, a reader sees.
    let ends = [0, first.points.len() - 1].map(|n| first.values()[n]).map(|(x, y)| y.atan2(x).to_degrees());
    assert!(((ends[1] - ends[0]).rem_euclid(360.0) - 278.59).abs() < 0.1, "{ends:?}");
}

#[test]
fn the_turn_rate_of_a_disc_is_that_of_steady_rolling() {
    for degrees in [20.0_f64, 45.0, 70.0] {
        lies_on("turn-rate", &format!("lean-{degrees}"), |b| {
            let steady = wheel(0.25, 0.5).steady(degrees.to_radians(), b);
            steady.map_or(f64::NAN, |steady| steady.turn_rate().powi(2))
        });
    }
}

#[test]
fn the_potential_keeps_the_constants_of_the_text() {
    let disc = wheel(0.25, 0.5);
    let start = Rolling { tilt: FRAC_PI_2 - 0.3, omega_2: 0.45, omega_3: 0.9, ..Rolling::UPRIGHT };
    let constants = disc.constants(&start);
    lies_on("potential", "potential", |lean| disc.potential(&constants, FRAC_PI_2 - lean.to_radians()));
}

#[test]
fn the_tongues_are_bounded_by_the_unstable_circles() {
    for (figure, name, wheel) in [
        ("tongue", "hoop", wheel(0.5, 1.0)),
        ("tongue", "disc", wheel(0.25, 0.5)),
        ("tongue-tips", "hoop", wheel(0.5, 1.0)),
        ("tongue-tips", "disc", wheel(0.25, 0.5)),
        ("tongue-tips", "weights", wheel(2.0, 0.5)),
        ("tongue-tips", "beads", wheel(0.1, 0.002)),
    ] {
        let drawn = curve(figure, name);
        let mut checked = 0;
        for step in 1..300 {
            let lean = wheel.safe_lean() * (f64::from(step) + 0.37) / 301.0;
            let edges = wheel.unstable_circles(lean).expect("a lean").expect("below the tip");
            for b in edges.into_iter().filter(|b| (0.01..drawn.axes.x.to).contains(b)) {
                let off = drawn.distance((b, lean.to_degrees()));
                assert!(off < PIXELS, "{figure}, {name}: b = {b}, {}°: {off} px", lean.to_degrees());
                checked += 1;
            }
        }
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
fn the_contact_of_a_wheel_that_is_almost_flat_runs_round_as_its_wobble_says() {
    let (tilt, solver) = (0.05, Taylor::new(1e-13).unwrap());
    for (wheel, name) in [(wheel(0.25, 0.5), "disc"), (wheel(0.5, 1.0), "hoop")] {
        let steady = wheel.steady(FRAC_PI_2 - tilt, 0.0).expect("rolls").state().omega_2;
        lies_on("near-flat-turn", name, |part| {
            let start = Rolling { tilt, omega_2: part * steady, ..Rolling::UPRIGHT };
            wheel.wobble(start, &solver).map_or(f64::NAN, |wobble| wobble.heading_advance().to_degrees())
        });
    }
}

#[test]
fn the_track_of_the_contact_is_that_of_all_wobbles() {
    let disc = wheel(0.25, 0.5);
    let start = Rolling { omega_1: 0.3, ..disc.steady(0.55, 1.6).expect("rolls").state() };
    let wobble = disc.wobble(start, &Taylor::new(1e-14).unwrap()).expect("a wobble");
    let state = |turns: f64| wobble.at(turns * wobble.period()).expect("a state");
    let contact = |turns: f64| (state(turns).contact(1.0).re, state(turns).contact(1.0).im);
    let [all, half] = ["all", "half"].map(|name| curve("contact-track", name));
    for n in 0..500 {
        let turns = 0.5 + 10.0 * f64::from(n) / 500.0;
        assert!(all.distance(contact(turns)) < PIXELS, "{turns}");
    }
    // The heavy half goes from one turn of the lean to the next.
    let ends = [0, half.points.len() - 1].map(|n| half.points[n]);
    let lean_turns = (0..20_000).map(|n| 1e-4 * f64::from(n)).filter(|turns| {
        state(turns - 5e-5).omega_1.is_sign_positive() != state(turns + 5e-5).omega_1.is_sign_positive()
    });
    for (turns, end) in lean_turns.zip(ends) {
        let place = half.axes.point(contact(turns));
        assert!((place.x - end.0).hypot(place.y - end.1) < 0.2, "{turns}: {place:?} {end:?}");
    }
}

#[test]
fn the_ways_down_are_those_of_a_disc_with_a_very_weak_brake() {
    let disc = wheel(0.25, 0.5);
    let rates = disc.slowed_rates(5e-4);
    let fallen = |_: f64, state: &[f64; 8]| 1.3 - Rolling::from_array(*state).lean();
    let solver = Dop853::new(1e-9).unwrap();
    for name in [
        "straight-1",
        "straight-3",
        "straight-10",
        "spin-1",
        "spin-10",
        "spin-30",
        "edge-10",
        "edge-13",
        "edge-15",
        "edge-18",
    ] {
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
            assert!(off < 0.7, "{name}: {pair:?}: {off}");
        }
    }
}

/// The toy on its way down by a law of loss with which it lives for 100 s.
fn going_down(power: f64) -> (SpinDown, Loss) {
    let life = SpinDown::new(toy(0.1), Loss::new(1.0, power).unwrap()).unwrap().life();
    let loss = Loss::new(life / 100.0, power).unwrap();
    (SpinDown::new(toy(0.1), loss).unwrap(), loss)
}

const POWERS: [f64; 4] = [2.0, 1.25, 1.0, 0.5];

#[test]
fn the_tilt_goes_to_zero_as_each_law_of_loss_has_it() {
    for power in POWERS {
        let (down, _) = going_down(power);
        let tilt = |left: f64| down.with_time_left(left).map_or(f64::NAN, |coin| coin.tilt());
        lies_on("spin-down", &format!("law-{power}"), |time| tilt(100.0 - time));
        lies_on("spin-down", &format!("end-{power}"), tilt);
    }
}

#[test]
fn the_circle_of_the_centre_opens_as_the_film_has_it() {
    lies_on("circle-opens", "law", |tilt| 4000.0 / 9.0 * (0.1_f64.powf(1.5) * tilt.sqrt() - tilt * tilt));
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
    for power in POWERS {
        let (down, loss) = going_down(power);
        let last = down.with_time_left(down.time_left_at_free_fall()).expect("a coin").tilt();
        // From above all curves to below, in steps that no figure takes; seven of them are a root of two.
        let tilts: Vec<f64> =
            (1..).map(|n| 0.09 / SQRT_2.powf(f64::from(n) / 7.0)).take_while(|t| *t > 0.38 * last).collect();
        let disk = BrakedDisk::new(toy(0.1).parameters(), loss).expect("a disk");
        let omega_1 = 0.1_f64.tan() / ((power + 1.0) * down.life());
        let start = Rolling { omega_1, ..toy(0.1).state() };
        let sunk = disk.sink(start, &tilts, &Dop853::new(1e-10).unwrap()).expect("it sinks");
        let [exponents, support, contact] =
            [("four-exponents", "exponent"), ("table-holds", "support"), ("table-holds", "contact")]
                .map(|(figure, name)| curve(figure, &format!("{name}-{power}")));
        for those in sunk.windows(15) {
            let [high, middle, low] = [those[0].time, those[7].time, those[14].time];
            let exponent = SQRT_2.ln() / ((middle - high) / (low - middle)).ln();
            if exponent > 0.0 && exponent < 0.85 {
                let off = exponents.distance((those[7].state.tilt, exponent));
                assert!(off < PIXELS, "{power}, {:e}: {exponent}, {off} px", those[7].state.tilt);
            }
        }
        for there in &sunk {
            let state = &there.state;
            let weights = disk.support(state).z / (0.4 * 9.81);
            if state.tilt > 0.46 * last && state.tilt < 9.9 * last && state.tilt < 0.089 {
                assert!(support.distance((state.tilt / last, weights)) < PIXELS, "{power}: {weights}");
            }
            let mach = 0.0375 * state.omega_2 / state.tilt.tan() / 343.0;
            if mach > 0.0101 && state.tilt < 0.089 {
                assert!(contact.distance((state.tilt, mach)) < PIXELS, "{power}: Mach {mach}");
            }
        }
        assert!(sunk.len() > 50);
        lies_on("table-holds", &format!("law-support-{power}"), |part| 1.0 - part.powf(-2.0 * power - 1.0));
    }
    lies_on("table-holds", "steady", |tilt| toy(tilt).contact_speed() / 343.0);
}

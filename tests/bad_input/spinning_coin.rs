//! Wheels, and coins that spin down.

use mechanics::integrate::Taylor;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::spinning_coin::{EulersDisk, Loss, SpinDown, SpinningCoin};
use mechanics::{InvalidQuantity, Rule};
use std::fmt;

fn message<T: fmt::Debug>(result: Result<T, impl fmt::Display>) -> String {
    result.map(|value| format!("{value:?} was taken")).map_err(|error| error.to_string()).unwrap_err()
}

/// The toy of the shops.
const TOY: DiskParameters =
    DiskParameters { mass: 0.4, radius: 0.0375, moments: MomentFactors::DISK, gravity: 9.81 };

fn coin() -> SpinningCoin {
    SpinningCoin::new(TOY, 0.1).unwrap()
}

#[test]
fn a_loss_is_positive_and_its_exponent_from_zero_to_ten() {
    assert_eq!(
        message(Loss::new(0.0, 2.0)),
        "coefficient of the loss 0 W is not positive; it must be more than zero"
    );
    assert_eq!(
        message(Loss::new(1.0, -0.5)),
        "exponent of the loss -0.5 is negative; it must be zero or more"
    );
    assert_eq!(
        message(Loss::new(1.0, 10.5)),
        "exponent of the loss 10.5 is too large; it must be at most 10"
    );
    assert_eq!(message(Loss::new(1.0, f64::NAN)), "exponent of the loss NaN is not a finite number");
    assert_eq!(
        message(Loss::air_film(&coin(), -1.0)),
        "viscosity -1 Pa·s is not positive; it must be more than zero"
    );
}

#[test]
fn a_coin_that_spins_down_has_mass_time_and_tilt() {
    let loss = Loss::air_film(&coin(), 1.78e-5).unwrap();
    let tiny = SpinningCoin::new(TOY, 1e-40).unwrap();
    assert!(message(SpinDown::new(tiny, Loss::new(1.0, 10.0).unwrap())).starts_with("life of the coin 0 s"));
    let spin_down = SpinDown::new(coin(), loss).unwrap();
    assert_eq!(message(spin_down.at(-1.0)), "time -1 s is negative; it must be zero or more");
    assert_eq!(message(spin_down.at(f64::NAN)), "time NaN s is not a finite number");
    assert_eq!(message(spin_down.at(f64::INFINITY)), "time inf s is not a finite number");
    let late = message(spin_down.sample(&[1.0, 100.0]));
    assert!(
        late.starts_with("time 100 s exceeds the end of this law, where the coin lies flat, 94.89"),
        "{late}"
    );
    assert!(message(spin_down.with_time_left(100.0)).starts_with("time left 100 s is too large"));
    assert_eq!(message(spin_down.with_time_left(f64::NAN)), "time left NaN s is not a finite number");
    assert_eq!(
        message(spin_down.with_time_left(-1.0)),
        "time left -1 s is not positive; it must be more than zero"
    );
    assert!(message(spin_down.with_time_left(1e-200)).contains("is outside the range"));
    for tilt in [0.0, -0.1, 1.6, f64::NAN] {
        assert!(message(spin_down.time_left(tilt)).starts_with("tilt from lying flat"));
        assert!(message(spin_down.time_to(tilt)).starts_with("tilt from lying flat"));
    }
}

#[test]
fn a_time_of_a_tilt_is_a_number_or_an_error() {
    // Far below the start the difference of the two sines was more than all of the first: the logarithm of a negative
    // number.
    let start = SpinningCoin::new(TOY, 0.06).unwrap();
    let spin_down = SpinDown::new(start, Loss::new(1e-6, 2.0).unwrap()).unwrap();
    assert_eq!(spin_down.time_to(1e-20), Ok(spin_down.life()));
    for tilt in [1e-50, 1e-20, 1e-10, 1e-3, 0.02, 0.03, 0.06, 0.09, 1.57] {
        for exponent in [0.0, 1.0, 2.0, 3.3, 10.0] {
            let spin_down = SpinDown::new(start, Loss::new(1e-6, exponent).unwrap()).unwrap();
            let time = spin_down.time_to(tilt).unwrap();
            assert!(time.is_finite() && (time <= 0.0) == (tilt >= 0.06), "{tilt:e}, {exponent}: {time}");
        }
    }
    // Too short for a number, and as long as any.
    let steep = SpinDown::new(start, Loss::new(1e-6, 10.0).unwrap()).unwrap();
    assert!(
        message(steep.time_left(1e-50))
            .starts_with("time left 0 s is too small; it must be at least 2.2250738585072014e-308 s")
    );
    let short = SpinningCoin::new(DiskParameters { mass: 1e50, radius: 1.0, ..TOY }, 1e-40).unwrap();
    let short = SpinDown::new(short, Loss::new(1e-50, 2.0).unwrap()).unwrap();
    assert!(short.time_to(1.5).is_ok_and(|time| time < -1e100));
    assert_eq!(
        message(spin_down.with_time_left(1e-320)).split(';').next(),
        Some("time left 1e-320 s is too small")
    );
}

#[test]
fn no_speed_of_the_contact_is_beyond_all_tilts() {
    let coin = coin();
    for speed in [1e-50, 1e-9, 343.0, 1e42, 1e50] {
        let tilt = coin.tilt_for_contact_speed(speed).unwrap();
        assert!(tilt > 0.0 && tilt <= std::f64::consts::FRAC_PI_2, "{speed:e}: {tilt:e}");
    }
    assert!(coin.tilt_for_contact_speed(1e60).is_err());
}

/// The toy with one of its five numbers another, and what that is called.
fn with(number: usize, value: f64) -> (DiskParameters, &'static str) {
    let MomentFactors { transverse, axial } = TOY.moments;
    match number {
        0 => (DiskParameters { mass: value, ..TOY }, "mass"),
        1 => (DiskParameters { radius: value, ..TOY }, "radius"),
        2 => {
            let moments = MomentFactors { transverse: value, axial };
            (DiskParameters { moments, ..TOY }, "transverse moment factor")
        }
        3 => {
            let moments = MomentFactors { transverse, axial: value };
            (DiskParameters { moments, ..TOY }, "axial moment factor")
        }
        _ => (DiskParameters { gravity: value, ..TOY }, "gravity"),
    }
}

#[test]
fn wheel_coin_and_disk_are_made_of_positive_numbers() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e60] {
        for number in 0..5 {
            let (parameters, name) = with(number, bad);
            for refused in [
                message(Wheel::new(parameters)),
                message(SpinningCoin::new(parameters, 0.1)),
                message(EulersDisk::new(parameters, 1e-5)),
                message(EulersDisk::in_air(parameters, 1.78e-5)),
            ] {
                assert!(refused.starts_with(name), "{bad}: {refused}");
            }
        }
        let wheel = Wheel::new(TOY).unwrap();
        if !(bad.is_finite() && bad.abs() < 1e50) {
            assert!(message(wheel.steady(0.3, bad)).starts_with("radius of the centre's circle"), "{bad}");
        }
        if bad != 0.0 {
            assert!(message(EulersDisk::new(TOY, bad)).starts_with("film number K"), "{bad}");
            assert!(message(EulersDisk::in_air(TOY, bad)).starts_with("viscosity"), "{bad}");
        }
    }
    let (long, _) = with(3, 0.5_f64.next_up());
    assert!(matches!(Wheel::new(long), Err(InvalidQuantity { rule: Rule::NotAbove { limit: 0.5, .. }, .. })));
}

#[test]
fn a_sinking_disk_starts_from_finite_numbers() {
    let hoop = EulersDisk::new(DiskParameters { moments: MomentFactors::HOOP, ..TOY }, 1e-5).unwrap();
    let solver = Taylor::new(1e-13).unwrap();
    let start = hoop.steady(0.1).unwrap();
    for number in 0..8 {
        for bad in [f64::NAN, f64::INFINITY] {
            let mut numbers = start.to_array();
            numbers[number] = bad;
            let refused = message(hoop.sinking(Rolling::from_array(numbers), &solver));
            assert!(refused.contains("finite") || refused.contains("tilt"), "{number} {bad}: {refused}");
        }
    }
    let flat = Rolling { tilt: std::f64::consts::PI, ..start };
    assert!(message(hoop.sinking(flat, &solver)).starts_with("tilt from lying flat"));
}

//! Wheels, and coins that spin down.

use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::spinning_coin::{EulersDisk, InvalidSpinDown, Loss, Sinking, SpinDown, SpinningCoin};
use std::fmt;

fn message<T: fmt::Debug>(result: Result<T, impl fmt::Display>) -> String {
    result.map(|value| format!("{value:?} was taken")).map_err(|error| error.to_string()).unwrap_err()
}

fn coin() -> SpinningCoin {
    SpinningCoin::new(0.0375, 0.5, 9.81, 0.1).unwrap()
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
        "viscosity -1 Pa s is not positive; it must be more than zero"
    );
}

#[test]
fn a_coin_that_spins_down_has_mass_time_and_tilt() {
    let loss = Loss::air_film(&coin(), 1.78e-5).unwrap();
    assert_eq!(
        message(SpinDown::new(coin(), 0.0, loss)),
        "mass 0 kg is not positive; it must be more than zero"
    );
    let tiny = SpinningCoin::new(0.0375, 0.5, 9.81, 1e-40).unwrap();
    assert!(
        message(SpinDown::new(tiny, 0.4, Loss::new(1.0, 10.0).unwrap())).starts_with("life of the coin 0 s")
    );
    let spin_down = SpinDown::new(coin(), 0.4, loss).unwrap();
    assert_eq!(message(spin_down.at(-1.0)), "time -1 s is negative; it must be zero or more");
    assert_eq!(message(spin_down.at(f64::NAN)), "time NaN s is not a finite number");
    assert_eq!(message(spin_down.at(f64::INFINITY)), "time inf s is not a finite number");
    assert!(
        message(spin_down.at(100.0))
            .starts_with("time 100 s is too late: by this law the coin lies flat after 94.89")
    );
    assert!(message(spin_down.with_time_left(100.0)).starts_with("time left 100 s is too large"));
    assert_eq!(message(spin_down.with_time_left(f64::NAN)), "time left NaN s is not a finite number");
    assert!(matches!(spin_down.with_time_left(-1.0), Err(InvalidSpinDown::Over { .. })));
    assert!(message(spin_down.with_time_left(1e-200)).contains("is outside the range"));
    for tilt in [0.0, -0.1, 1.6, f64::NAN] {
        assert!(message(spin_down.time_left(tilt)).starts_with("tilt from lying flat"));
        assert!(message(spin_down.time_to(tilt)).starts_with("tilt from lying flat"));
    }
}

#[test]
fn a_time_of_a_tilt_is_a_number_or_an_error() {
    // Far below the start the difference of the two sines was more than all of the first: the logarithm of a negative number.
    let start = SpinningCoin::new(0.0375, 0.5, 9.81, 0.06).unwrap();
    let spin_down = SpinDown::new(start, 0.4, Loss::new(1e-6, 2.0).unwrap()).unwrap();
    assert_eq!(spin_down.time_to(1e-20), Ok(spin_down.life()));
    for tilt in [1e-50, 1e-20, 1e-10, 1e-3, 0.02, 0.03, 0.06, 0.09, 1.57] {
        for exponent in [0.0, 1.0, 2.0, 3.3, 10.0] {
            let spin_down = SpinDown::new(start, 0.4, Loss::new(1e-6, exponent).unwrap()).unwrap();
            let time = spin_down.time_to(tilt).unwrap();
            assert!(time.is_finite() && (time <= 0.0) == (tilt >= 0.06), "{tilt:e}, {exponent}: {time}");
        }
    }
    // Too short for a number, and as long as any.
    let steep = SpinDown::new(start, 0.4, Loss::new(1e-6, 10.0).unwrap()).unwrap();
    assert!(
        message(steep.time_left(1e-50))
            .starts_with("time left 0 s is too small; it must be at least 2.2250738585072014e-308 s")
    );
    let short = SpinningCoin::new(1.0, 0.5, 9.81, 1e-40).unwrap();
    let short = SpinDown::new(short, 1e50, Loss::new(1e-50, 2.0).unwrap()).unwrap();
    assert!(short.time_to(1.5).is_ok_and(|time| time < -1e100));
    assert_eq!(
        message(spin_down.with_time_left(1e-320)).split(';').next(),
        Some("time left 1e-320 s is too small")
    );
    assert!(
        message(spin_down.with_time_left(-3.0))
            .starts_with(&format!("time {} s is too late", spin_down.life() + 3.0))
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

#[test]
fn a_wheel_and_a_coin_are_made_of_positive_numbers() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e60] {
        for (number, name) in ["mass", "radius", "moment factor k", "gravity"].into_iter().enumerate() {
            let mut numbers = [1.5, 0.5, 0.5, 9.81];
            numbers[number] = bad;
            let [mass, radius, factor, gravity] = numbers;
            let refused = message(Wheel::new(mass, radius, factor, gravity));
            assert!(refused.starts_with(name), "{bad}: {refused}");
            if number > 0 {
                let refused = message(SpinningCoin::new(radius, factor, gravity, 0.1));
                assert!(refused.starts_with(name), "{bad}: {refused}");
            }
        }
        let wheel = Wheel::new(1.5, 0.5, 0.5, 9.81).unwrap();
        if !(bad.is_finite() && bad.abs() < 1e50) {
            assert!(message(wheel.steady(0.3, bad)).starts_with("radius of the centre's circle"), "{bad}");
        }
    }
}

#[test]
fn a_sinking_disk_is_made_of_positive_numbers_and_starts_from_finite_ones() {
    for bad in [-1.0, f64::NAN, f64::INFINITY, 1e60] {
        for (number, name) in ["mass", "radius", "gravity", "viscosity"].into_iter().enumerate() {
            let mut numbers = [0.4, 0.0375, 9.81, 1.78e-5];
            numbers[number] = bad;
            let [mass, radius, gravity, viscosity] = numbers;
            let refused = message(EulersDisk::in_air(mass, radius, gravity, viscosity));
            assert!(refused.starts_with(name), "{bad}: {refused}");
        }
        for (number, name) in
            ["radius", "moment factor k", "gravity", "film number K"].into_iter().enumerate()
        {
            let mut numbers = [0.0375, 0.5, 9.81, 1e-5];
            numbers[number] = bad;
            let [radius, factor, gravity, film] = numbers;
            let refused = message(EulersDisk::new(radius, factor, gravity, film));
            assert!(refused.starts_with(name), "{bad}: {refused}");
        }
    }
    let hoop = EulersDisk::new(0.0375, 1.0, 9.81, 1e-5).unwrap();
    assert!(message(EulersDisk::new(0.0375, 1.0_f64.next_up(), 9.81, 1e-5)).contains("at most 1"));
    let start = hoop.steady(0.1).unwrap();
    assert_eq!(hoop.sample(&start, &[0.0, 0.0], 1e-13).unwrap(), [start; 2]);
    for number in 0..8 {
        for bad in [f64::NAN, f64::INFINITY] {
            let mut numbers = start.to_array();
            numbers[number] = bad;
            let refused = message(hoop.sample(&Sinking::from_array(numbers), &[1.0], 1e-13));
            assert!(refused.contains("finite") || refused.contains("tilt"), "{number} {bad}: {refused}");
        }
    }
    let flat = Sinking { tilt: std::f64::consts::PI, ..start };
    assert!(message(hoop.sample(&flat, &[1.0], 1e-13)).starts_with("tilt from lying flat"));
}

//! Wheels, and coins that spin down.

use super::Sign::{NotNegative, Positive};
use super::{Setter, every_number_is_checked, message};
use mechanics::integrate::Taylor;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::spinning_coin::{EulersDisk, Loss, SpinDown, SpinningCoin};

/// The toy of the shops.
const TOY: DiskParameters =
    DiskParameters { mass: 0.4, radius: 0.0375, moments: MomentFactors::DISK, gravity: 9.81 };

fn coin() -> SpinningCoin {
    SpinningCoin::new(TOY, 0.1).unwrap()
}

#[test]
fn a_loss_is_positive_and_its_exponent_from_zero_to_ten() {
    let numbers: [Setter<[f64; 2]>; 2] = [
        (|p| &mut p[0], "coefficient of the loss", "W", Positive),
        (|p| &mut p[1], "exponent of the loss", "", NotNegative),
    ];
    every_number_is_checked([1.0, 2.0], &numbers, |[coefficient, exponent]| Loss::new(coefficient, exponent));
    let steep = message(Loss::new(1.0, 10.5));
    assert_eq!(steep, "exponent of the loss 10.5 is too large; it must be at most 10");
    let viscosity: [Setter<f64>; 1] = [(|p| p, "viscosity", "Pa·s", Positive)];
    every_number_is_checked(1e-5, &viscosity, |viscosity| Loss::air_film(&coin(), viscosity));
    let none_too: [Setter<f64>; 1] = [(|p| p, "viscosity", "Pa·s", NotNegative)];
    every_number_is_checked(1e-5, &none_too, |viscosity| EulersDisk::in_air(TOY, viscosity));
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
    assert!(spin_down.at(spin_down.life()).is_err() && spin_down.at(spin_down.life().next_down()).is_ok());
    assert!(coin().tilt_for_contact_speed(0.0).is_err() && coin().tilt_for_contact_speed(1e60).is_err());
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
fn wheel_coin_and_disk_are_made_of_positive_numbers() {
    let numbers: [Setter<DiskParameters>; 5] = [
        (|p| &mut p.mass, "mass", "kg", Positive),
        (|p| &mut p.radius, "radius", "m", Positive),
        (|p| &mut p.moments.transverse, "transverse moment factor", "", Positive),
        (|p| &mut p.moments.axial, "axial moment factor", "", Positive),
        (|p| &mut p.gravity, "gravity", "m/s²", Positive),
    ];
    every_number_is_checked(TOY, &numbers, Wheel::new);
    every_number_is_checked(TOY, &numbers, |toy| SpinningCoin::new(toy, 0.1));
    every_number_is_checked(TOY, &numbers, |toy| EulersDisk::new(toy, 1e-5));
    let film: [Setter<f64>; 1] = [(|p| p, "film number K", "", NotNegative)];
    every_number_is_checked(1e-5, &film, |film| EulersDisk::new(TOY, film));
    for bad in [f64::NAN, f64::INFINITY, 1e60] {
        let refused = message(Wheel::new(TOY).unwrap().steady(0.3, bad));
        assert!(refused.starts_with("radius of the centre's circle"), "{bad}");
    }
    for (tilt, rule) in [
        (0.0, "0 rad is not positive; it must be more than zero"),
        (-0.1, "-0.1 rad is not positive; it must be more than zero"),
        (1.6, "1.6 rad is too large; it must be less than 1.5707963267948966 rad"),
    ] {
        let refused = message(SpinningCoin::new(TOY, tilt));
        assert_eq!(refused, format!("tilt from lying flat {rule}"));
    }
    let moments = MomentFactors { transverse: 0.25, axial: 0.5_f64.next_up() };
    let refused = message(Wheel::new(DiskParameters { moments, ..TOY }));
    assert_eq!(refused, "axial moment factor 0.5000000000000001 exceeds twice the transverse one, 0.5");
    // Mass beyond the rim, or far out on the axle.
    let moments = MomentFactors { transverse: 3.0, axial: 1.2 };
    assert!(Wheel::new(DiskParameters { moments, ..TOY }).is_ok());
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

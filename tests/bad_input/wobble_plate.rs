//! Plates, pistons and masses that balance nothing.

use mechanics::scenes::wobble_plate::{Pistons, Plate};
use std::fmt::Display;

fn message<T, E: Display>(result: Result<T, E>) -> String {
    result.err().expect("this should be refused").to_string()
}

#[test]
fn plates_and_pistons_that_cannot_be_say_why() {
    let cases = [
        (message(Plate::thin(2.0, 0.1, -0.1)), "tilt -0.1 rad is negative; it must be zero or more"),
        (
            message(Plate::thin(2.0, 0.1, 1.6)),
            "tilt 1.6 rad is too large; it must be less than 1.5707963267948966 rad",
        ),
        (message(Plate::thin(2.0, 0.1, f64::NAN)), "tilt NaN rad is not a finite number"),
        (message(Plate::thin(-2.0, 0.1, 0.4)), "mass -2 kg is not positive; it must be more than zero"),
        (message(Plate::thick(2.0, 0.1, -1.0, 0.4)), "thickness -1 m is negative; it must be zero or more"),
        (message(Pistons::new(0, 1.0, 0.1, 0.1)), "0 pistons: an engine has at least one"),
        (
            message(Pistons::new(1001, 1.0, 0.1, 0.1)),
            "1001 pistons: an engine has at most 1000, as sums run over all of them",
        ),
        (message(Pistons::new(3, -1.0, 0.1, 0.1)), "piston mass -1 kg is negative; it must be zero or more"),
        (
            message(Pistons::new(3, 1.0, 0.0, 0.1)),
            "distance of the pistons 0 m is not positive; it must be more than zero",
        ),
        (message(Pistons::new(3, 1.0, 0.1, f64::NAN)), "rod length NaN m is not a finite number"),
    ];
    assert!(Pistons::new(1000, 1.0, 0.1, 0.1).is_ok());
    for (found, expected) in cases {
        assert_eq!(found, expected);
    }
}

#[test]
fn pistons_that_balance_nothing_say_why() {
    let plate = Plate::thin(2.0, 0.1, 0.4).unwrap();
    for (count, words) in [(1, "1 piston"), (2, "2 pistons")] {
        let refusal = message(plate.balancing_mass(&Pistons::new(count, 1.0, 0.1, 0.1).unwrap()));
        assert_eq!(refusal, format!("{words} cannot balance a turning plate; it takes at least 3"));
    }
    let three = Pistons::new(3, 1.0, 0.1, 0.1).unwrap();
    let drum = Plate::thick(12.0, 2.0, 6.0, 0.4).unwrap();
    assert_eq!(
        message(drum.balancing_mass(&three)),
        "the plate's moment across its axis, 48 kg·m², exceeds that along it, 24 kg·m²; no mass of pistons balances it"
    );
}

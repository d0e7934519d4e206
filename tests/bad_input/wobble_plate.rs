//! Plates, pistons and masses that balance nothing.

use mechanics::InvalidQuantity;
use mechanics::scenes::wobble_plate::{PistonParameters, Pistons, Plate, PlateParameters};

const PLATE: PlateParameters = PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.0, tilt: 0.4 };
const PISTONS: PistonParameters = PistonParameters { count: 3, mass: 1.0, distance: 0.1, rod: 0.1 };

fn message<T>(result: Result<T, InvalidQuantity>) -> String {
    result.err().expect("this should be refused").to_string()
}

#[test]
fn plates_and_pistons_that_cannot_be_say_why() {
    let plate = |parameters: PlateParameters| message(Plate::new(parameters));
    let pistons = |parameters: PistonParameters| message(Pistons::new(parameters));
    let cases = [
        (
            plate(PlateParameters { tilt: -0.1, ..PLATE }),
            "tilt -0.1 rad is negative; it must be zero or more",
        ),
        (
            plate(PlateParameters { tilt: 1.6, ..PLATE }),
            "tilt 1.6 rad is too large; it must be less than 1.5707963267948966 rad",
        ),
        (plate(PlateParameters { tilt: f64::NAN, ..PLATE }), "tilt NaN rad is not a finite number"),
        (
            plate(PlateParameters { mass: -2.0, ..PLATE }),
            "mass -2 kg is not positive; it must be more than zero",
        ),
        (
            plate(PlateParameters { radius: 0.0, ..PLATE }),
            "radius 0 m is not positive; it must be more than zero",
        ),
        (
            plate(PlateParameters { thickness: -1.0, ..PLATE }),
            "thickness -1 m is negative; it must be zero or more",
        ),
        (
            pistons(PistonParameters { count: 0, ..PISTONS }),
            "number of pistons 0 is too small; it must be at least 1",
        ),
        (
            pistons(PistonParameters { count: 1001, ..PISTONS }),
            "number of pistons 1001 is too large; it must be at most 1000",
        ),
        (
            pistons(PistonParameters { mass: -1.0, ..PISTONS }),
            "piston mass -1 kg is negative; it must be zero or more",
        ),
        (
            pistons(PistonParameters { distance: 0.0, ..PISTONS }),
            "distance of the pistons 0 m is not positive; it must be more than zero",
        ),
        (pistons(PistonParameters { rod: f64::NAN, ..PISTONS }), "rod length NaN m is not a finite number"),
    ];
    assert!(Pistons::new(PistonParameters { count: 1000, ..PISTONS }).is_ok());
    for (found, expected) in cases {
        assert_eq!(found, expected);
    }
}

#[test]
fn pistons_that_balance_nothing_say_why() {
    let plate = Plate::new(PLATE).unwrap();
    for count in [1, 2] {
        let refusal =
            message(plate.balancing_mass(&Pistons::new(PistonParameters { count, ..PISTONS }).unwrap()));
        let name = "number of pistons that are to balance a turning plate";
        assert_eq!(refusal, format!("{name} {count} is too small; it must be at least 3"));
    }
    let three = Pistons::new(PISTONS).unwrap();
    let drum = Plate::new(PlateParameters { mass: 12.0, radius: 2.0, thickness: 6.0, tilt: 0.4 }).unwrap();
    assert_eq!(
        message(drum.balancing_mass(&three)),
        "transverse moment of a plate to be balanced 48 kg·m² exceeds that about its axis, 24 kg·m²"
    );
}

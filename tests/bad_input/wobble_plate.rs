//! Plates, pistons and masses that balance nothing.

use super::Sign::{Any, NotNegative, Positive};
use super::{every_number_is_checked, message};
use mechanics::scenes::wobble_plate::{Piston, PistonParameters, Pistons, Plate, PlateParameters, Unbalance};

const PLATE: PlateParameters = PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.0, tilt: 0.4 };
const PISTONS: PistonParameters = PistonParameters { count: 3, mass: 1.0, distance: 0.1, rod: 0.1 };

#[test]
fn plates_and_pistons_that_cannot_be_say_why() {
    every_number_is_checked(
        PLATE,
        &[
            (|p| &mut p.tilt, "tilt", "rad", NotNegative),
            (|p| &mut p.mass, "mass", "kg", Positive),
            (|p| &mut p.radius, "radius", "m", Positive),
            (|p| &mut p.thickness, "thickness", "m", NotNegative),
        ],
        Plate::new,
    );
    every_number_is_checked(
        PISTONS,
        &[
            (|p| &mut p.mass, "piston mass", "kg", NotNegative),
            (|p| &mut p.distance, "distance of the pistons", "m", Positive),
            (|p| &mut p.rod, "rod length", "m", NotNegative),
        ],
        Pistons::new,
    );
    every_number_is_checked(
        Piston { mass: 1.0, distance: 0.1, azimuth: 0.0 },
        &[
            (|p| &mut p.mass, "piston mass", "kg", NotNegative),
            (|p| &mut p.distance, "distance of the piston", "m", NotNegative),
            (|p| &mut p.azimuth, "azimuth of the piston", "rad", Any),
        ],
        |piston| Unbalance::of(&Plate::new(PLATE).unwrap(), &[piston]),
    );
    let steep = message(Plate::new(PlateParameters { tilt: 1.6, ..PLATE }));
    assert_eq!(steep, "tilt 1.6 rad is too large; it must be less than 1.5707963267948966 rad");
    for (count, rule) in
        [(0, "0 is too small; it must be at least 1"), (1001, "1001 is too large; it must be at most 1000")]
    {
        let refused = message(Pistons::new(PistonParameters { count, ..PISTONS }));
        assert_eq!(refused, format!("number of pistons {rule}"));
    }
    assert!(Pistons::new(PistonParameters { count: 1000, ..PISTONS }).is_ok());
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

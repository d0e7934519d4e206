//! Every input that is not of this world gives the documented error, whose message holds the value, the unit
//! and the rule broken.

mod free_tops;
mod laundromat;
mod methods;
mod spinning_coin;
mod top;
mod wobble_plate;

use mechanics::euler::Turning;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};
use std::fmt::{Debug, Display};

fn message<T: Debug, E: Display>(result: Result<T, E>) -> String {
    result.map(|value| format!("{value:?}")).expect_err("this should be refused").to_string()
}

fn brick() -> PrincipalMoments {
    PrincipalMoments::new(1.0, 1.5, 2.0).expect("a brick")
}

fn turning(omega_body: Vector3<f64>) -> Turning {
    Turning { world_from_body: UnitQuaternion::identity(), omega_body }
}

/// What a number must be besides finite and of a size that is computed with.
#[derive(Clone, Copy, PartialEq)]
enum Sign {
    Positive,
    NotNegative,
    NotZero,
    Any,
}
use Sign::{Any, NotNegative, NotZero, Positive};

/// What a parameter is set by, called and measured in, and the rule for its sign.
type Setter<P> = (fn(&mut P) -> &mut f64, &'static str, &'static str, Sign);

/// Of these it is the ratio to a mass that must be of a size that is computed with.
const OF_ANY_SIZE: [&str; 2] = ["stiffness", "damping"];

/// Each of the numbers of some parameters is refused where it breaks a rule, by its name, its value, its unit and the
/// rule; and taken where it breaks none.
fn every_number_is_checked<P: Copy, T: Debug, E: Display + Debug>(
    valid: P,
    setters: &[Setter<P>],
    new: impl Fn(P) -> Result<T, E>,
) {
    for &(set, name, unit, sign) in setters {
        let with = |value: f64| {
            let mut parameters = valid;
            *set(&mut parameters) = value;
            new(parameters)
        };
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(message(with(bad)), format!("{name} {bad}{unit} is not a finite number"));
        }
        if !OF_ANY_SIZE.contains(&name) {
            let range =
                format!("is outside the range from 1e-50 to 1e50{unit} in size that is computed with");
            assert_eq!(message(with(1e60)), format!("{name} 1e60{unit} {range}"));
        }
        let (bad, rule): (&[f64], _) = match sign {
            Positive => (&[0.0, -2.5], "is not positive; it must be more than zero"),
            NotNegative => (&[-2.5], "is negative; it must be zero or more"),
            NotZero => (&[0.0], "must not be zero"),
            Any => (&[], ""),
        };
        for bad in bad {
            assert_eq!(message(with(*bad)), format!("{name} {bad}{unit} {rule}"));
        }
        if sign == NotNegative || sign == Any {
            assert!(with(0.0).is_ok(), "{name} may be zero");
        }
    }
}

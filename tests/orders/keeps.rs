//! Every method keeps, of a free body, what the table says, and nothing else that the table knows of.

use super::{Run, brick, run};
use mechanics::euler::Turning;
use mechanics::integrate::METHODS;
use mechanics::integrate::methods::Kept;
use nalgebra::{Matrix3, Quaternion, Vector3};

/// A step so long, s, that every method makes an error that shows: some three radians.
const LONG_STEP: f64 = 2.5;

/// What is kept is off by no more than the rounding of some fifty turns ...
const ROUNDING: f64 = 1e-13;

/// ... a volume by no more than the difference quotients ...
const QUOTIENTS: f64 = 1e-8;

/// ... and what is not kept by at least this.
const VISIBLE: f64 = 1e-6;

/// How far a quantity is from what it should be after some long steps, and how far it may be if it is kept.
fn departure(kept: Kept, run: Run) -> (f64, f64) {
    let (moments, start) = brick();
    let steps = 4;
    let numbers = run(start, LONG_STEP * steps as f64, steps);
    let end = Turning::from_array(numbers);
    match kept {
        Kept::UnitLength => {
            let [w, i, j, k, ..] = numbers;
            ((Quaternion::new(w, i, j, k).norm() - 1.0).abs(), ROUNDING)
        }
        Kept::AngularMomentum => {
            let before = start.angular_momentum_world(&moments);
            ((end.angular_momentum_world(&moments) - before).norm() / before.norm(), ROUNDING)
        }
        Kept::WayBack => {
            let back = Turning::from_array(run(end, -LONG_STEP * steps as f64, steps));
            ((back.omega_body - start.omega_body).norm() / start.omega_body.norm(), ROUNDING)
        }
        Kept::Volume => {
            // The determinant of the derivatives of ω after one step by ω before.
            let after = |change: Vector3<f64>| {
                let start = Turning { omega_body: start.omega_body + change, ..start };
                Turning::from_array(run(start, LONG_STEP, 1)).omega_body
            };
            let change = 1e-5;
            let columns = [0, 1, 2].map(|axis| {
                let by = Vector3::ith(axis, change);
                (after(by) - after(-by)) / (2.0 * change)
            });
            ((Matrix3::from_columns(&columns).determinant() - 1.0).abs(), QUOTIENTS)
        }
        other => panic!("the table knows {other}, which is not tested"),
    }
}

#[test]
fn every_method_keeps_what_the_table_says_and_nothing_else() {
    for method in METHODS {
        let (run, _) = run(method.name);
        for kept in [Kept::UnitLength, Kept::AngularMomentum, Kept::Volume, Kept::WayBack] {
            let (found, rounding) = departure(kept, run);
            println!("{} {kept}: {found:e}", method.name);
            if method.keeps.contains(&kept) {
                assert!(found < rounding, "{} loses {kept}: {found:e}", method.name);
            } else {
                assert!(
                    found > VISIBLE,
                    "{} keeps {kept}: {found:e}, and the table does not say so",
                    method.name
                );
            }
        }
    }
}

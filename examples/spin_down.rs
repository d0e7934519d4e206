//! A body spins down in air: does its wobble die before its spin?
//!
//! ```text
//! the flat cylinder, Aligning:
//!   after 0 s 50.990 rad/s, 11.31° from its axis
//!   after 1 s 30.368 rad/s,  2.98° from its axis
//!   after 2 s 18.396 rad/s,  0.78° from its axis
//! the long cylinder, Tumbling:
//!   after 0 s 50.990 rad/s, 11.31° from its axis
//!   after 1 s 10.418 rad/s, 49.49° from its axis
//!   after 2 s  6.341 rad/s, 81.70° from its axis
//! ```

use mechanics::inertia::{Body, Cylinder};
use mechanics::nalgebra::Vector3;
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let drag = Drag { transverse: 2e-5, axial: 1e-5 }; // N m s, torque over angular velocity
    let omega_body = Vector3::new(10.0, 0.0, 50.0); // rad/s; axis 3 is the axis of symmetry
    for (name, radius, height) in [("flat", 0.02, 0.01), ("long", 0.01, 0.1)] {
        let moments = Body::cylinder(0.1, Cylinder { radius, height })?.moments(); // kg, m
        let body = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?;
        println!("the {name} cylinder, {:?}:", body.axis_trend());
        for time in [0.0, 1.0, 2.0] {
            let [speed, angle] = [body.at(time)?.norm(), body.axis_angle(time)?.to_degrees()];
            println!("  after {time} s {speed:6.3} rad/s, {angle:5.2}° from its axis");
        }
    }
    Ok(())
}

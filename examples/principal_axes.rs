//! The principal axes of a body about a point that is not its centre: a plate on a hinge at its corner.
//!
//! ```text
//!  9.031 g m², 30.473° from the edge
//! 77.669 g m², 120.473° from the edge
//! 86.667 g m², across the plate
//! turned about its edge it has an angular momentum 48.35° off
//! ```

use mechanics::inertia::Body;
use mechanics::nalgebra::Vector3;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let plate = Body::cuboid(2.0, [0.3, 0.2, 0.01])?; // kg, m
    let corner = plate.about(&Vector3::new(0.15, 0.1, 0.0))?;
    let axes = corner.principal_axes()?;
    for (n, moment) in axes.moments.to_array().into_iter().enumerate() {
        let axis = axes.present_from_principal * Vector3::ith(n, 1.0);
        let angle = axis.y.atan2(axis.x).to_degrees().rem_euclid(180.0); // both directions are the same axis
        let where_to = if axis.z.abs() > 0.9 {
            "across the plate".to_owned()
        } else {
            format!("{angle:.3}° from the edge")
        };
        println!("{:6.3} g m², {where_to}", 1e3 * moment);
    }
    let omega = Vector3::x() * 10.0; // rad/s, about the long edge
    let angle = mechanics::attitude::angle_between(&omega, &corner.angular_momentum(&omega));
    println!("turned about its edge it has an angular momentum {:.2}° off", angle.to_degrees());
    Ok(())
}

//! A body with these moments, left to itself: how does it stand in the room after ten seconds?
//!
//! ```text
//! it comes back to the same angular velocity every 11.6595 s
//! after 10 s its axis 3 points along [-0.3242, 0.4279, -0.8437]
//! its angular momentum has changed by less than 1e-14 of itself
//! ```

use mechanics::nalgebra::{UnitQuaternion, Vector3};
use mechanics::{euler::Turning, free_rotation::FreeTop, inertia::PrincipalMoments};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let moments = PrincipalMoments::new(2.0, 3.0, 4.0)?; // kg m², about axes 1, 2 and 3
    let start = Turning {
        world_from_body: UnitQuaternion::identity(),
        omega_body: Vector3::new(0.1, 5.0, 0.1), // rad/s, nearly about the middle axis
    };
    let body = FreeTop::new(moments, start)?;
    if let Some(period) = body.period() {
        println!("it comes back to the same angular velocity every {period:.4} s");
    }
    let later = body.at(10.0)?; // in closed form: an hour later costs no more
    let [x, y, z]: [f64; 3] = later.axis_3_world().into();
    println!("after 10 s its axis 3 points along [{x:.4}, {y:.4}, {z:.4}]");
    let [before, after] = [start, later].map(|state| state.angular_momentum_world(&moments));
    assert!((after - before).norm() < 1e-14 * before.norm());
    println!("its angular momentum has changed by less than 1e-14 of itself");
    Ok(())
}

//! A coin is tossed with a tumble and a twist, and caught: which side is up?
//!
//! ```text
//! caught after 0.489 s, with a tumble of 240 rad/s
//! twist   0 rad/s: Other side, 111.7° over; caught at random, Same in 50.0 %
//! twist  60 rad/s: Same side, 33.4° over; caught at random, Same in 58.0 %
//! twist 130 rad/s: Same side, 83.9° over; caught at random, Same in 100.0 %
//! ```

use mechanics::inertia::Body;
use mechanics::scenes::coin_toss::{Flight, FlightParameters, Toss, TossParameters};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let moments = Body::thin_disk(0.0075, 0.0116)?.moments(); // kg, m
    let flight = Flight::new(FlightParameters { speed: 2.4, gravity: 9.81, catch_height: 0.0 })?; // m/s, m/s², m
    let caught = flight.duration();
    println!("caught after {caught:.3} s, with a tumble of 240 rad/s");
    for omega_3 in [0.0, 60.0, 130.0] {
        let toss = Toss::new(TossParameters { moments, omega_1: 240.0, omega_3 })?; // rad/s
        let face = toss.face(caught)?;
        let tilt = toss.normal_height(caught)?.acos().to_degrees();
        let percent = 100.0 * toss.same_face_probability();
        println!(
            "twist {omega_3:3} rad/s: {face:?} side, {tilt:.1}° over; caught at random, Same in {percent:.1} %"
        );
    }
    Ok(())
}

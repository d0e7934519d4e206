//! A motion at many times, as a table for another program: a top under gravity nods.
//! `cargo run --example motion_to_csv >top.csv`
//!
//! ```text
//! time/s,x,y,z
//! 0.00,0.000000,-0.500000,0.866025
//! 0.01,0.000867,-0.504542,0.863387
//! 0.02,0.006724,-0.517087,0.855907
//! 0.03,0.021556,-0.534613,0.844822
//! 0.04,0.047521,-0.552767,0.831980
//! 0.05,0.084480,-0.566764,0.819538
//! 0.06,0.129992,-0.572401,0.809605
//! 0.07,0.179782,-0.566973,0.803878
//! 0.08,0.228617,-0.549888,0.803341
//! 0.09,0.271400,-0.522817,0.808087
//! 0.10,0.304236,-0.489348,0.817299
//! ```

use mechanics::inertia::{Body, Cylinder};
use mechanics::scenes::top::{Release, Top};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let disc = Body::cylinder(0.1, Cylinder { radius: 0.03, height: 0.01 })?; // kg, m
    let top = Top::on_a_point(&disc, 0.04, 9.81)?; // m from its point to its centre, m/s²
    let tilt = 30_f64.to_radians();
    let motion = top.let_go(Release { tilt, tilt_rate: 0.0, precession: 0.0, spin: 200.0 })?; // rad/s
    let times: Vec<f64> = (0..=10).map(|n| 0.01 * f64::from(n)).collect();
    println!("time/s,x,y,z");
    for (time, state) in times.iter().zip(motion.sample(&times)?) {
        let axis = state.axis_3_world();
        println!("{time:.2},{:.6},{:.6},{:.6}", axis.x, axis.y, axis.z);
    }
    Ok(())
}

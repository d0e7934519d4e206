//! A motion without a closed form: give the integrator the rates, and ask when something happens.
//!
//! ```text
//! at the bottom after 1.004570 s, at -5.759404 rad/s
//! after 1 s  0.026422 rad, -5.804053 rad/s
//! after 2 s  0.644495 rad,  1.616824 rad/s
//! after 3 s -0.466489 rad,  1.391235 rad/s
//! after 4 s -0.086746 rad, -1.763034 rad/s
//! 2103 evaluations of the rates
//! ```

use mechanics::integrate::{Direction, Dop853, Outcome};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let (gravity, length, drag) = (9.81, 0.5, 0.3); // m/s², m, 1/rad: a pendulum in air
    let rates = |_time: f64, &[angle, rate]: &[f64; 2]| {
        [rate, -gravity / length * angle.sin() - drag * rate * rate.abs()]
    };
    let solver = Dop853::new(1e-12)?;
    let start = [3.0, 0.0]; // rad, rad/s: nearly upside down
    let bottom = |_time: f64, &[angle, _]: &[f64; 2]| angle;
    if let Outcome::Event(first) = solver.solve_until(rates, 0.0, start, 60.0, bottom, Direction::Falling)? {
        println!("at the bottom after {:.6} s, at {:.6} rad/s", first.time, first.state[1]);
    }
    let times: Vec<f64> = (1..=4).map(f64::from).collect();
    let (states, work) = solver.sample(rates, 0.0, start, &times)?;
    for (time, [angle, rate]) in times.iter().zip(states) {
        println!("after {time} s {angle:9.6} rad, {rate:9.6} rad/s");
    }
    println!("{} evaluations of the rates", work.evaluations);
    Ok(())
}

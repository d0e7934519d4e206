//! A coin rolls round a circle, leaning inwards: how fast, and does it stay up?
//!
//! ```text
//! from a lean of 18.62° on every circle is stable
//! at 10° those of 1.53 to 29.19 mm are not
//! 50 mm: goes round at 4.786 rad/s, wobbles with 20.30 1/s
//! 10 mm: goes round at 10.563 rad/s, falls with 17.99 1/s
//! 1 mm: goes round at 29.383 rad/s, wobbles with 15.10 1/s
//! ```

use mechanics::rolling::{DiskParameters, MomentFactors};
use mechanics::scenes::rolling_wheel::Wheel;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let (mass, radius, gravity) = (0.0075, 0.0116, 9.81); // kg, m, m/s²: a coin
    let coin = Wheel::new(DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity })?;
    println!("from a lean of {:.2}° on every circle is stable", coin.safe_lean().to_degrees());
    let lean = 10_f64.to_radians();
    if let Some([least, most]) = coin.unstable_circles(lean)? {
        println!("at 10° those of {:.2} to {:.2} mm are not", 1e3 * least, 1e3 * most);
    }
    for centre_radius in [0.05, 0.01, 0.001] {
        let steady = coin.steady(lean, centre_radius)?;
        let (rate, square) = (steady.turn_rate(), steady.wobble_square());
        let fate = if steady.is_stable() { "wobbles with" } else { "falls with" };
        let [millimetres, size] = [1e3 * centre_radius, square.abs().sqrt()];
        println!("{millimetres} mm: goes round at {rate:.3} rad/s, {fate} {size:.2} 1/s");
    }
    Ok(())
}

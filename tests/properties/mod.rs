//! Properties that hold for every system, tried on seeded random ones, the extreme among them: `fastrand`,
//! because the cases are numbers over a hundred decades and a failing one is printed whole; there is nothing
//! to shrink.

mod free_tops;
mod laundromat;

use crate::common::between;

/// A number of any size and sign that `f64` has, zero and the ends of the range more often than fair.
fn any(random: &mut fastrand::Rng) -> f64 {
    let size = match random.u8(0..12) {
        0 => 0.0,
        1 => f64::MIN_POSITIVE * random.f64(),
        2 => f64::MAX,
        3 => 1e50,
        4 => 1e-50,
        5..8 => 10.0_f64.powf(600.0 * random.f64() - 300.0),
        _ => 10.0_f64.powf(12.0 * random.f64() - 6.0),
    };
    if random.bool() { size } else { -size }
}

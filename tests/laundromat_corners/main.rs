//! The laundromat where naive programs fail: critical and heavy damping, resonance, high spin, late times, the origin
//! of polar coordinates; and a drum that speeds up, which meets most of them. Each test has a judge of its own, and
//! shows the failure where there is a naive form.

mod damping;
mod polar;
mod ramp;
mod resonance;
mod spin_and_time;

use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use nalgebra::Complex;

/// A few units in the last place, after a dozen operations.
const FEW_ULPS: f64 = 4e-15;

/// ω₀ = 1 rad/s, b = 1 m, with the rest as given: one kilogram, all of it the load.
fn machine(damping: f64, spin: f64) -> Machine {
    Machine::new(MachineParameters {
        drum_mass: 0.0,
        load_mass: 1.0,
        load_radius: 1.0,
        stiffness: 1.0,
        damping,
        spin,
    })
    .expect("a valid machine")
}

fn start() -> Shaft {
    Shaft { position: Complex::new(0.7, -0.4), velocity: Complex::new(-0.3, 0.9) }
}

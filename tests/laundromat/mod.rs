//! The laundromat chapter: one test for every numbered equation, (6) to (33), by a route that shares no code with it.
//!
//! Where the source is wrong the same test shows that the printed form fails.

mod jacobi;
mod linear;
mod motion;
mod orbit;
mod passage;
mod radial;
mod stability;
mod steady;
mod whirl;

use mechanics::scenes::laundromat::{Machine, MachineParameters};
use nalgebra::Complex;

/// The machine of the chapter: ω₀ = 10 rad/s, Γ = 3 s⁻¹, b = 1/60 m, Ω = 30 rad/s.
const WASHER: MachineParameters = MachineParameters {
    drum_mass: 28.0,
    load_mass: 2.0,
    load_radius: 0.25,
    stiffness: 3000.0,
    damping: 90.0,
    spin: 30.0,
};

/// What a few dozen operations in `f64` may cost, relative to the largest term.
const ROUNDING: f64 = 1e-13;

fn washer() -> Machine {
    Machine::new(WASHER).expect("the chapter's machine is valid")
}

/// A seeded stream of machines of every kind: slow and fast, light and heavy damping, either sense of spin.
fn machines(seed: u64, count: usize) -> impl Iterator<Item = Machine> {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut between = move |low: f64, high: f64| low * (high / low).powf(random.f64());
    (0..count).map(move |n| {
        let drum_mass = between(1.0, 100.0);
        let load_mass = between(0.01, 10.0);
        let stiffness = between(10.0, 1e5);
        let natural = (stiffness / (drum_mass + load_mass)).sqrt();
        let sense = if n % 3 == 0 { -1.0 } else { 1.0 };
        Machine::new(MachineParameters {
            drum_mass,
            load_mass,
            load_radius: between(0.05, 1.0),
            stiffness,
            damping: between(1e-3, 10.0) * natural * (drum_mass + load_mass),
            spin: sense * between(0.03, 30.0) * natural,
        })
        .expect("random machines are valid")
    })
}

/// Newton's law (6) for two bodies, by the raw parameters alone: `M r̈ + m (r̈ + ä) = −k r − γ ṙ`, where the load
/// goes round the shaft with `ä = −Ω²a`. Rates of [x, y, ẋ, ẏ].
fn newton(p: &MachineParameters, t: f64, &[x, y, vx, vy]: &[f64; 4]) -> [f64; 4] {
    let a = Complex::from_polar(p.load_radius, p.spin * t);
    let suspension = -Complex::new(x, y) * p.stiffness - Complex::new(vx, vy) * p.damping;
    let acceleration = (suspension + a * (p.load_mass * p.spin * p.spin)) / (p.drum_mass + p.load_mass);
    [vx, vy, acceleration.re, acceleration.im]
}

/// The constants of a machine by their letters on the page: ω₀, b, Γ, Ω.
fn letters(machine: &Machine) -> (f64, f64, f64, f64) {
    (machine.natural_frequency(), machine.offset(), machine.damping_rate(), machine.spin())
}

/// ω₀ = 1 rad/s, b = 1 m: one kilogram, all of it the load.
fn unit_machine(damping: f64, spin: f64) -> Machine {
    let (drum_mass, load_mass, load_radius, stiffness) = (0.0, 1.0, 1.0, 1.0);
    let parameters = MachineParameters { drum_mass, load_mass, load_radius, stiffness, damping, spin };
    Machine::new(parameters).expect("a valid machine")
}

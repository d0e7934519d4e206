//! The figures of the chapter "Physics in the laundromat".
//!
//! Each function draws one claim from what the library computes. Captions stand on the pages. They lie by what they
//! show in `figures/`; here is what they share.

#[path = "figures/disturbed.rs"]
pub(crate) mod disturbed;
#[path = "figures/motor.rs"]
pub(crate) mod motor;
#[path = "figures/parts.rs"]
pub(crate) mod parts;
#[path = "figures/polar.rs"]
pub(crate) mod polar;
#[path = "figures/ramp.rs"]
pub(crate) mod ramp;
#[path = "figures/steady.rs"]
pub(crate) mod steady;
#[path = "figures/whirl.rs"]
pub(crate) mod whirl;

use drawing::{Drawing, Hue, Point, Stroke, at};
use figures::{Cause, Figure, figures, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::scenes::laundromat::{Machine, MachineParameters};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    disturbed::locked,
    disturbed::frames,
    disturbed::annulus,
    disturbed::landscape,
    disturbed::petals,
    motor::motor_line,
    motor::motor_hysteresis,
    parts::machine,
    parts::phases,
    polar::polar_fault,
    polar::eigenvalues,
    ramp::start,
    ramp::ramp,
    ramp::ramp_map,
    ramp::cornu,
    ramp::overshoot,
    steady::steady,
    steady::centring,
    steady::floor_force,
    steady::torque,
    whirl::whirl_forces,
    whirl::whirl_growth
];

/// Points of a curve, (x, y).
type Values = Vec<(f64, f64)>;

/// The natural frequency of the chapter's machine, rad/s.
const NATURAL: f64 = 10.0;

/// The chapter's machine, with other damping and spin, both in natural frequencies.
fn washing_machine(damping: f64, spin: f64) -> Result<Machine, InvalidQuantity> {
    let (drum_mass, load_mass) = (28.0, 2.0);
    Machine::new(MachineParameters {
        drum_mass,
        load_mass,
        load_radius: 0.25,
        stiffness: 3000.0,
        damping: damping * NATURAL * (drum_mass + load_mass),
        spin: spin * NATURAL,
    })
}

/// A quantity of the chapter's machine against Ω/ω₀, for one damping Γ/ω₀.
fn over_spin(
    damping: f64,
    from: f64,
    to: f64,
    quantity: impl Fn(&Machine) -> Result<f64, InvalidQuantity>,
) -> Result<Values, Cause> {
    linear_steps(from, to, 1200)
        .map(|ratio| Ok((ratio, quantity(&washing_machine(damping, ratio)?)?)))
        .collect()
}

/// A fixed point seen from above.
fn cross(drawing: &mut Drawing, centre: Point, reach: f64) {
    for arm in [at(reach, 0.0), at(0.0, reach)] {
        drawing.line(centre - arm, centre + arm, Stroke::Axis, Hue::Ink);
    }
}

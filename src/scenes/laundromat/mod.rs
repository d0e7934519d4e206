//! The unbalanced washing machine: a drum with a load on one side, turned at constant angular velocity
//! about a vertical shaft that a spring and a damper hold near a fixed point.
//!
//! The chapter *Physics in the laundromat* derives every formula; its labels are cited here. Positions
//! are complex numbers in the frame of the laboratory, z = x + iy, in metres from the fixed point O;
//! the load is at azimuth φ = Ωt, counter-clockwise for positive Ω. The equation of motion,
//! `eq:cartesian-motion`, is
//!
//! ```text
//! z̈ + Γ ż + ω₀² z = b Ω² e^{iΩt}
//! ```
//!
//! Functions of a time that return plain numbers let a time that is not finite through, as NaN; those that return a
//! `Result` refuse it.
//!
//! | to find | call |
//! |---|---|
//! | the three constants ω₀, b, Γ | [`Machine::natural_frequency`], [`Machine::offset`], [`Machine::damping_rate`] |
//! | the motion that remains in the end | [`Machine::steady`] |
//! | whether and how disturbances die out | [`Machine::modes`], [`Machine::stability_matrix`] |
//! | the whole motion from any start, at any time | [`Machine::transient`] |
//! | the same while the drum speeds up or slows down | [`Machine::ramp`] |
//! | rates for an integrator | [`Machine::cartesian_rates`], [`Machine::polar_rates`] |
//! | what the motor must do | [`Machine::motor_torque`], [`SteadyMotion::motor_torque`] |
//! | what the drum does with a motor of limited torque | [`Machine::driven`] |
//! | what a damper does that turns with the drum | [`Machine::rotor`] |

mod energy;
mod locked;
mod machine;
mod modes;
mod motion;
mod motor;
mod oscillator;
mod ramp;
mod shaft;
mod steady;
mod transient;
mod whirl;

pub use locked::{LockedMotion, LockedState};
pub use machine::{Machine, MachineParameters};
pub use modes::Mode;
pub use motor::{DrivenMachine, DrivenState, Fold, Folds, Motor};
pub use ramp::Ramp;
pub use shaft::{Polar, Shaft};
pub use steady::{Peak, SteadyMotion};
pub use transient::Transient;
pub use whirl::{Rotor, RotorMotion};

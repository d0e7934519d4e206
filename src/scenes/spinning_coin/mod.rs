//! A coin that spins down on a table, its centre at rest. Chapter "The spinning coin".
//!
//! The steady rolling of a wheel with b = 0; axes and states are those of [`crate::rolling`]. The coin's tilt from
//! lying flat, `α = π/2 − θ`, is the variable, because everything interesting happens as it goes to zero: `1 − sin θ`
//! has no digits left at α = 1e-8, `2 sin²(α/2)` has all.
//!
//! [`SpinningCoin`] is the coin at one tilt, [`SpinDown`] how it gets from one tilt to the next while it loses energy
//! slowly, and [`EulersDisk`] how it does so on a film of air, whatever the speed: its motion is [`Sinking`].

mod braked;
mod coin;
mod film;
mod sinking;
mod spin_down;

pub use braked::{BrakedDisk, TiltReached};
pub use coin::SpinningCoin;
pub use film::EulersDisk;
pub use sinking::Sinking;
pub use spin_down::{Loss, SpinDown};

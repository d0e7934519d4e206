//! A wheel that rolls on a table without slipping. Chapter "The rolling wheel".
//!
//! Axes and states are those of [`crate::rolling`]: with negative ω₃ the wheel rolls along axis 1. The lean θ is the angle of
//! the wheel's plane from the upright, positive if the top leans towards the axis of the circle for a steady motion with
//! positive b.
//!
//! | to find | call |
//! |---|---|
//! | steady rolling on a circle | [`Wheel::steady`] |
//! | which circles are stable | [`Wheel::safe_lean`], [`Wheel::unstable_circles`] |
//! | rates of the general motion, energy, contact force | [`Wheel::rates`], [`Wheel::energy`], [`Wheel::contact_force`] |
//! | rates of a wheel that slows down | [`Wheel::slowed_rates`] |
//! | where a slow loss carries a circle | [`SteadyRolling::sinking`] |
//! | the two constants of the motion, and what follows from them | [`Wheel::constants`], [`Wheel::at_tilt`] |
//! | the motion at any time from half a wobble | [`Wheel::wobble`] |

mod constants;
mod sinking;
mod stability;
mod steady;
mod swing;
mod wheel;
mod wobble;

pub use constants::RollingConstants;
pub use sinking::SinkingRates;
pub use steady::SteadyRolling;
pub use wheel::Wheel;
pub use wobble::Wobble;

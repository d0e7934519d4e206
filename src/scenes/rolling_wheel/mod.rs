//! A wheel that rolls on a table without slipping. Chapter "The rolling wheel".
//!
//! Axes: x, y in the table, z up. Axis 1 of the wheel's frame is horizontal, in its plane; axis 2 runs up the steepest line of
//! its plane, from the contact to the centre; axis 3 = 1 × 2 is its normal, inward and down when it leans inward. The
//! frame follows the wheel's heading and lean and does not roll with it. The lean θ is the angle of the plane from the upright, positive
//! if the top leans towards the axis of the circle for a steady motion with positive b. (Axes 1 and 3 of
//! [`crate::scenes::spinning_coin::EulersDisk`] are the other way round: n, the spin and the rate of the lean have the opposite signs
//! there, and the heading differs by half a turn.)
//!
//! | to find | call |
//! |---|---|
//! | steady rolling on a circle | [`Wheel::steady`] |
//! | rates of the general motion, energy, contact force | [`Wheel::rates`], [`Wheel::energy`], [`Wheel::contact_force`] |
//! | the two constants of the motion, and what follows from them | [`Wheel::constants`], [`Wheel::at_lean`] |
//! | rates for a wheel that is almost flat | [`Wheel::rates_by_tilt`] |
//! | the motion at any time from half a wobble | [`Wheel::wobble`] |

mod motion;
mod near_flat;
mod steady;
mod swing;
mod wheel;
mod wobble;

pub use motion::{Rolling, RollingConstants};
pub use steady::{NoSteadyRolling, SteadyRolling};
pub use wheel::{InvalidWheel, Wheel};
pub use wobble::{NoWobble, Wobble};

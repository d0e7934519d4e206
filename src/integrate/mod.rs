//! Stepping methods: how a motion is computed when no closed form exists, and the judge of those that do exist.
//!
//! A system is given by its rates: a function of the time and of the state `[f64; N]` that returns the
//! derivative of the state. States live on the stack; no method allocates while it steps.
//!
//! | method | for |
//! |---|---|
//! | [`rk4`] | programs that show what goes wrong, and smooth problems where a fixed step will do |
//! | [`Dop853`] | everything else: order eight, step control, dense output, events |
//! | [`Taylor`] | motions that give their own series, as `Wheel::wobble`: exact to rounding, `Taylor::new(1e-15)` |
//! | [`crate::geometric`] | rotations: methods that only ever turn |
//!
//! [`METHODS`] states what each promises; `tests/orders` measures it.

mod control;
mod dop853;
mod event;
mod failure;
pub mod methods;
mod rk4;
mod step;
mod tableau;
mod taylor;

pub use dop853::{Dop853, End, Work};
pub use event::{Direction, Outcome};
pub use failure::Failure;
pub use methods::METHODS;
pub use rk4::{rk4, rk4_step};
pub use step::Step;
pub(crate) use taylor::increment;
pub use taylor::{Expand, Series, TAYLOR_ORDER, Taylor, TaylorStep};

/// The rates of a system with `N` state variables: `(time, state) -> d(state)/d(time)`.
///
/// Every function or closure of that form is one.
pub trait Rates<const N: usize>: FnMut(f64, &[f64; N]) -> [f64; N] {}

impl<const N: usize, F: FnMut(f64, &[f64; N]) -> [f64; N]> Rates<N> for F {}

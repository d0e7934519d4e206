//! Stepping methods: how a motion is computed when no closed form exists, and the judge of those that do exist.
//!
//! A system is given by its rates: a function of the time and of the state `[f64; N]` that returns the
//! derivative of the state. States live on the stack; no method allocates while it steps.
//!
//! | method | for |
//! |---|---|
//! | [`rk4`] | programs that show what goes wrong, and smooth problems where a fixed step will do |
//! | [`Dop853`] | everything else: order eight, step control, dense output, events |
//!
//! [`METHODS`] states their orders; `tests/orders.rs` measures them.

mod control;
mod dop853;
mod event;
mod failure;
mod rk4;
mod step;
mod tableau;
mod taylor;

pub use dop853::{Dop853, End, Work};
pub use event::{Direction, Outcome};
pub use failure::{Failure, InvalidTolerance};
pub use rk4::{rk4, rk4_step};
pub use step::Step;
pub use taylor::{Expand, Series, TAYLOR_ORDER, Taylor, TaylorStep};

/// The rates of a system with `N` state variables: `(time, state) -> d(state)/d(time)`.
///
/// Every function or closure of that form is one.
pub trait Rates<const N: usize>: FnMut(f64, &[f64; N]) -> [f64; N] {}

impl<const N: usize, F: FnMut(f64, &[f64; N]) -> [f64; N]> Rates<N> for F {}

/// What a method promises.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Method {
    /// Its usual name.
    pub name: &'static str,
    /// The error at a fixed time shrinks as this power of the step.
    pub order: u32,
    /// The order of the dense output: its error within one step shrinks as this power of the step plus one, like that of a
    /// step by a method of this order. `None` without dense output.
    pub dense_order: Option<u32>,
    /// Evaluations of the rates for one accepted step (without those of the dense output).
    pub evaluations_per_step: u32,
    /// Whether the step adapts to a tolerance.
    pub adaptive: bool,
}

/// The stepping methods of this library. The order tests and the documentation read this table.
pub const METHODS: [Method; 2] = [
    Method { name: "RK4", order: 4, dense_order: None, evaluations_per_step: 4, adaptive: false },
    Method { name: "DOP853", order: 8, dense_order: Some(7), evaluations_per_step: 12, adaptive: true },
];

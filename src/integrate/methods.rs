//! The one table of stepping methods: what each promises.
//!
//! [`METHODS`] is the table, and the book prints it. `tests/orders` measures every entry; a method that is
//! added needs a line there that says how it is run.
//!
//! ```
//! use mechanics::integrate::{METHODS, rk4};
//! let promised = METHODS.iter().find(|method| method.name == "RK4").expect("it is in the table").order;
//! // A pendulum of 1 rad/s for 10 s, in 1000 steps and in 2000: order 4 makes the error 2⁴ times smaller.
//! let swing = |_: f64, &[x, v]: &[f64; 2]| [v, -x];
//! let end = |steps| rk4(swing, 0.0, [1.0, 0.0], 10.0, steps);
//! let [coarse, fine] = [end(1000)?[0], end(2000)?[0]].map(|x| x - 10_f64.cos());
//! assert_eq!(promised, 4);
//! assert_eq!(format!("{:.1}", (coarse / fine).log2()), "4.0");
//! # Ok::<(), mechanics::integrate::Failure>(())
//! ```

use super::TAYLOR_ORDER;
use Kept::{AngularMomentum, UnitLength, Volume, WayBack};
use std::fmt;

/// What a method promises.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Method {
    /// Its usual name.
    pub name: &'static str,
    /// The error at a fixed time shrinks as this power of the step.
    pub order: u32,
    /// The order of the dense output: its error within one step shrinks as this power of the step plus one,
    /// like that of a step by a method of this order. `None` without dense output.
    pub dense_order: Option<u32>,
    /// What one accepted step costs (without the dense output, and in a long row of steps).
    pub cost: Cost,
    /// Whether the step adapts to a tolerance.
    pub adaptive: bool,
    /// What it keeps to rounding, at any step, when it turns a free body.
    pub keeps: &'static [Kept],
}

/// The work of one step, in the unit of its method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Cost {
    /// Evaluations of the rates.
    Evaluations(u32),
    /// Taylor series of the motion, up to the order of the method.
    Series(u32),
    /// Exact turns about an axis of the body.
    Turns(u32),
}

/// What the exact motion of a free body has and a method may keep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kept {
    /// The length one of the quaternion.
    UnitLength,
    /// The angular momentum in the room.
    AngularMomentum,
    /// The volume of a set of angular velocities that are stepped together.
    Volume,
    /// The way back: as many steps backwards lead to the start.
    WayBack,
}

impl fmt::Display for Cost {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Evaluations(count) => write!(out, "{count} evaluations"),
            Self::Series(count) => write!(out, "{count} series"),
            Self::Turns(count) => write!(out, "{count} turns"),
        }
    }
}

impl fmt::Display for Kept {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::UnitLength => "unit length",
            Self::AngularMomentum => "angular momentum",
            Self::Volume => "volume",
            Self::WayBack => "reversibility",
        })
    }
}

/// The stepping methods of this library. The order tests and the documentation read this table.
pub const METHODS: [Method; 6] = [
    Method {
        name: "RK4",
        order: 4,
        dense_order: None,
        cost: Cost::Evaluations(4),
        adaptive: false,
        keeps: &[],
    },
    Method {
        name: "DOP853",
        order: 8,
        dense_order: Some(7),
        cost: Cost::Evaluations(12),
        adaptive: true,
        keeps: &[],
    },
    Method {
        name: "Taylor",
        order: TAYLOR_ORDER as u32,
        dense_order: Some(TAYLOR_ORDER as u32),
        cost: Cost::Series(1),
        adaptive: true,
        keeps: &[],
    },
    Method {
        name: "CF4",
        order: 4,
        dense_order: None,
        cost: Cost::Evaluations(4),
        adaptive: false,
        keeps: &[UnitLength],
    },
    Method {
        name: "Strang",
        order: 2,
        dense_order: None,
        cost: Cost::Turns(2),
        adaptive: false,
        keeps: &[UnitLength, AngularMomentum, Volume, WayBack],
    },
    Method {
        name: "Blanes–Moan",
        order: 4,
        dense_order: None,
        cost: Cost::Turns(12),
        adaptive: false,
        keeps: &[UnitLength, AngularMomentum, Volume, WayBack],
    },
];

#![doc = include_str!("README.md")]
//!
//! # From chapter to module
//!
//! | chapter | module |
//! |---|---|
//! | Physics in the laundromat | [`scenes::laundromat`], [`faddeeva`] |
//! | How a body turns | [`inertia`], [`attitude`], [`euler`], [`free_rotation`] |
//! | The top under gravity | [`scenes::top`] |
//! | The wobble plate | [`scenes::wobble_plate`] |
//! | The coin toss | [`scenes::coin_toss`] |
//! | The struck space station | [`scenes::space_station`] |
//! | Frisbee and pencil | [`scenes::air_drag`] |
//! | The pinned hoop | [`scenes::pinned_hoop`], [`elliptic`] |
//! | The rolling wheel | [`scenes::rolling_wheel`], [`rolling`], [`conical`] |
//! | The spinning coin | [`scenes::spinning_coin`], [`rolling`] |
//! | The ball | [`scenes::ball`] |
//! | Methods | [`integrate`], [`geometric`] |
//! | Speed and accuracy | [`measure`], [`sweep`] |
//! | Hard cases | all of them, where digits get lost |
//!
//! Each module of [`scenes`] models one problem with the smallest state that it needs, in closed form where there is
//! one. [`integrate`] holds the stepping methods and [`measure`] the one definition of error that tests, benchmarks and
//! book share.
//!
//! Results are the same to the last bit from run to run, but not from processor to processor: sines and exponentials
//! come from the platform, which may round them differently.
//!
//! Labels such as `eq:steady-radius` in comments are those of the book's equations.

#![warn(clippy::must_use_candidate, clippy::return_self_not_must_use)]

pub mod integrate;
pub mod measure;
pub mod scenes;
pub mod sweep;

mod bodies;
mod error;
mod motion;
mod numbers;
mod special;

pub use bodies::{attitude, euler, free_rotation, geometric, inertia, rolling};
pub use error::Error;
pub use motion::Motion;
pub use nalgebra;
pub use numbers::quantity::{InvalidQuantity, Rule};
pub use special::{conical, elliptic, faddeeva};

use numbers::{clock, elementary, lanes, quantity, two_part};
use special::gauss;

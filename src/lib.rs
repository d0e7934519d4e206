//! Rigid-body mechanics, checked equation by equation: the library behind the book *Things That Spin*.
//!
//! | chapter | module |
//! |---|---|
//! | Physics in the laundromat | [`scenes::laundromat`], [`faddeeva`] |
//! | How a body turns | [`inertia`], [`attitude`], [`euler`], [`free_rotation`] |
//! | The wobble plate | [`scenes::wobble_plate`] |
//! | The coin toss | [`scenes::coin_toss`] |
//! | The struck space station | [`scenes::space_station`] |
//! | Frisbee and pencil | [`scenes::air_drag`] |
//! | The pinned hoop | [`scenes::pinned_hoop`], [`elliptic`] |
//! | The rolling wheel | [`scenes::rolling_wheel`], [`conical`] |
//! | The spinning coin | [`scenes::spinning_coin`] |
//! | Methods | [`integrate`], [`geometric`] |
//! | Speed and accuracy | [`measure`], [`sweep`] |
//! | Hard cases | all of them, where digits get lost |
//!
//! Each module of [`scenes`] models one problem with the smallest state that it needs, in closed form where there is
//! one. [`integrate`] holds the stepping methods and [`measure`] the one definition of error that tests, benchmarks and
//! book share.
//!
//! SI units and radians throughout. Labels such as `eq:steady-radius` in comments are those of the book's equations.

pub mod attitude;
pub mod conical;
pub mod elliptic;
pub mod euler;
pub mod faddeeva;
pub mod free_rotation;
pub mod geometric;
pub mod inertia;
pub mod integrate;
pub mod measure;
pub mod scenes;
pub mod sweep;

mod error;
mod frames;
mod quantity;
mod rolling;
mod two_part;
mod wide;

pub use error::Error;
pub use frames::InvalidFrames;
pub use nalgebra;
pub use quantity::{InvalidQuantity, Rule};

/// Every page of the book, so that rustdoc tests its snippets. The press refuses a page of `book/SUMMARY.md` that is not here,
/// and a page here that is not there.
#[cfg(doctest)]
mod pages {
    #[doc = include_str!("../README.md")]
    mod readme {}
    #[doc = include_str!("../book/preface.md")]
    mod preface {}
    #[doc = include_str!("../book/conventions.md")]
    mod conventions {}
    #[doc = include_str!("../book/laundromat/index.md")]
    mod laundromat {}
    #[doc = include_str!("../book/laundromat/exercises.md")]
    mod laundromat_exercises {}
    #[doc = include_str!("../book/laundromat/solutions.md")]
    mod laundromat_solutions {}
    #[doc = include_str!("../book/turning/index.md")]
    mod turning {}
    #[doc = include_str!("../book/turning/exercises.md")]
    mod turning_exercises {}
    #[doc = include_str!("../book/turning/solutions.md")]
    mod turning_solutions {}
    #[doc = include_str!("../book/wobble-plate/index.md")]
    mod wobble_plate {}
    #[doc = include_str!("../book/wobble-plate/exercises.md")]
    mod wobble_plate_exercises {}
    #[doc = include_str!("../book/wobble-plate/solutions.md")]
    mod wobble_plate_solutions {}
    #[doc = include_str!("../book/coin-toss/index.md")]
    mod coin_toss {}
    #[doc = include_str!("../book/coin-toss/exercises.md")]
    mod coin_toss_exercises {}
    #[doc = include_str!("../book/coin-toss/solutions.md")]
    mod coin_toss_solutions {}
    #[doc = include_str!("../book/space-station/index.md")]
    mod space_station {}
    #[doc = include_str!("../book/space-station/exercises.md")]
    mod space_station_exercises {}
    #[doc = include_str!("../book/space-station/solutions.md")]
    mod space_station_solutions {}
    #[doc = include_str!("../book/air-drag/index.md")]
    mod air_drag {}
    #[doc = include_str!("../book/air-drag/exercises.md")]
    mod air_drag_exercises {}
    #[doc = include_str!("../book/air-drag/solutions.md")]
    mod air_drag_solutions {}
    #[doc = include_str!("../book/pinned-hoop/index.md")]
    mod pinned_hoop {}
    #[doc = include_str!("../book/pinned-hoop/exercises.md")]
    mod pinned_hoop_exercises {}
    #[doc = include_str!("../book/pinned-hoop/solutions.md")]
    mod pinned_hoop_solutions {}
    #[doc = include_str!("../book/rolling-wheel/index.md")]
    mod rolling_wheel {}
    #[doc = include_str!("../book/rolling-wheel/exercises.md")]
    mod rolling_wheel_exercises {}
    #[doc = include_str!("../book/rolling-wheel/solutions.md")]
    mod rolling_wheel_solutions {}
    #[doc = include_str!("../book/spinning-coin/index.md")]
    mod spinning_coin {}
    #[doc = include_str!("../book/spinning-coin/exercises.md")]
    mod spinning_coin_exercises {}
    #[doc = include_str!("../book/spinning-coin/solutions.md")]
    mod spinning_coin_solutions {}
    #[doc = include_str!("../book/methods/index.md")]
    mod methods {}
    #[doc = include_str!("../book/methods/exercises.md")]
    mod methods_exercises {}
    #[doc = include_str!("../book/methods/solutions.md")]
    mod methods_solutions {}
    #[doc = include_str!("../book/speed-and-accuracy/index.md")]
    mod speed_and_accuracy {}
    #[doc = include_str!("../book/hard-cases/index.md")]
    mod hard_cases {}
    #[doc = include_str!("../book/hard-cases/exercises.md")]
    mod hard_cases_exercises {}
    #[doc = include_str!("../book/hard-cases/solutions.md")]
    mod hard_cases_solutions {}
    #[doc = include_str!("../book/errata.md")]
    mod errata {}
    #[doc = include_str!("../book/ledger.md")]
    mod ledger {}
    #[doc = include_str!("../book/bibliography.md")]
    mod bibliography {}
}

//! The scenes of the book, one module a problem. Each models only what its scene needs.

pub mod air_drag;
pub mod ball;
pub mod coin_toss;
pub mod laundromat;
pub mod pinned_hoop;
pub mod rolling_wheel;
pub mod space_station;
pub mod spinning_coin;
pub mod top;
pub mod wobble_plate;

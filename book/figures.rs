//! The figures of every chapter, and in `front` those of the pages without a number.

#[path = "air-drag/figures.rs"]
mod air_drag;
#[path = "ball/figures.rs"]
mod ball;
#[path = "coin-toss/figures.rs"]
mod coin_toss;
#[path = "front/figures.rs"]
mod front;
#[path = "hard-cases/figures.rs"]
mod hard_cases;
#[path = "judged/figures.rs"]
mod judged;
#[path = "laundromat/figures.rs"]
mod laundromat;
#[path = "methods/figures.rs"]
mod methods;
#[path = "pinned-hoop/figures.rs"]
mod pinned_hoop;
#[path = "rolling-wheel/figures.rs"]
mod rolling_wheel;
#[path = "space-station/figures.rs"]
mod space_station;
#[path = "speed-and-accuracy/figures.rs"]
mod speed_and_accuracy;
#[path = "spinning-coin/figures.rs"]
mod spinning_coin;
#[path = "top/figures.rs"]
mod top;
#[path = "turning/figures.rs"]
mod turning;
#[path = "wobble-plate/figures.rs"]
mod wobble_plate;

use figures::Figure;

/// All figures, chapter by chapter.
pub const FIGURES: &[&[Figure]] = &[
    front::FIGURES,
    laundromat::FIGURES,
    turning::FIGURES,
    wobble_plate::FIGURES,
    coin_toss::FIGURES,
    space_station::FIGURES,
    air_drag::FIGURES,
    pinned_hoop::FIGURES,
    top::FIGURES,
    rolling_wheel::FIGURES,
    spinning_coin::FIGURES,
    ball::FIGURES,
    methods::FIGURES,
    speed_and_accuracy::FIGURES,
    judged::FIGURES,
    hard_cases::FIGURES,
];

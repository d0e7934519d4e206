//! The live scenes.

#[path = "air-drag/scene.rs"]
mod air_drag;
#[path = "ball/scene.rs"]
mod ball;
#[path = "coin-toss/scene.rs"]
mod coin_toss;
#[path = "laundromat/scene.rs"]
mod laundromat;
#[path = "pinned-hoop/scene.rs"]
mod pinned_hoop;
#[path = "rolling-wheel/scene.rs"]
mod rolling_wheel;
#[path = "space-station/scene.rs"]
mod space_station;
#[path = "spinning-coin/scene.rs"]
mod spinning_coin;
#[path = "top/scene.rs"]
mod top;
#[path = "turning/scene.rs"]
mod turning;
#[path = "wobble-plate/scene.rs"]
mod wobble_plate;

use live::Scene;

/// All live scenes, each with the folder of its chapter.
pub const SCENES: &[(&str, &Scene)] = &[
    ("laundromat", &laundromat::SCENE),
    ("turning", &turning::SCENE),
    ("wobble-plate", &wobble_plate::SCENE),
    ("coin-toss", &coin_toss::SCENE),
    ("space-station", &space_station::SCENE),
    ("air-drag", &air_drag::SCENE),
    ("pinned-hoop", &pinned_hoop::SCENE),
    ("top", &top::SCENE),
    ("rolling-wheel", &rolling_wheel::SCENE),
    ("spinning-coin", &spinning_coin::SCENE),
    ("ball", &ball::SCENE),
];

/// The scene of this name, if there is one: `coin-toss`.
pub fn named(name: &str) -> Option<&'static Scene> {
    SCENES.iter().map(|(_, scene)| *scene).find(|scene| scene.name == name)
}

//! The live scenes.

#[path = "air-drag/scene.rs"]
mod air_drag;
#[path = "ball/scene.rs"]
mod ball;
#[path = "spinning-coin/cap.rs"]
mod cap;
#[path = "air-drag/clocks.rs"]
mod clocks;
#[path = "coin-toss/scene.rs"]
mod coin_toss;
#[path = "coin-toss/edge.rs"]
mod edge;
#[path = "laundromat/hill.rs"]
mod hill;
#[path = "laundromat/motor.rs"]
mod knob;
#[path = "laundromat/scene.rs"]
mod laundromat;
#[path = "spinning-coin/loss.rs"]
mod loss;
#[path = "methods/scene.rs"]
mod methods;
#[path = "turning/middle-axis.rs"]
pub(crate) mod middle_axis;
#[path = "rolling-wheel/stability.rs"]
mod near_flat;
#[path = "pinned-hoop/scene.rs"]
mod pinned_hoop;
#[path = "rolling-wheel/scene.rs"]
mod rolling_wheel;
#[path = "space-station/scene.rs"]
mod space_station;
#[path = "laundromat/speeds.rs"]
mod speeds;
#[path = "spinning-coin/scene.rs"]
mod spinning_coin;
#[path = "space-station/star.rs"]
mod star;
#[path = "top/scene.rs"]
mod top;
#[path = "turning/scene.rs"]
mod turning;
#[path = "wobble-plate/scene.rs"]
mod wobble_plate;

use live::Scene;

/// All live scenes, each with where it stands: the folder of the chapter that it opens, or a page of one.
pub const SCENES: &[(&str, &Scene)] = &[
    ("laundromat", &laundromat::SCENE),
    ("laundromat/index", &speeds::SCENE),
    ("laundromat/index", &hill::SCENE),
    ("laundromat/motor", &knob::SCENE),
    ("turning", &turning::SCENE),
    ("turning/middle-axis", &middle_axis::SCENE),
    ("wobble-plate", &wobble_plate::SCENE),
    ("coin-toss", &coin_toss::SCENE),
    ("coin-toss/edge", &edge::SCENE),
    ("space-station", &space_station::SCENE),
    ("space-station/index", &star::SCENE),
    ("air-drag", &air_drag::SCENE),
    ("air-drag/index", &clocks::SCENE),
    ("pinned-hoop", &pinned_hoop::SCENE),
    ("top", &top::SCENE),
    ("rolling-wheel", &rolling_wheel::SCENE),
    ("rolling-wheel/index", &rolling_wheel::tongue::SCENE),
    ("rolling-wheel/index", &rolling_wheel::closing::SCENE),
    ("rolling-wheel/stability", &near_flat::SCENE),
    ("spinning-coin", &spinning_coin::SCENE),
    ("spinning-coin/index", &cap::SCENE),
    ("spinning-coin/loss", &loss::SCENE),
    ("ball", &ball::SCENE),
    ("methods", &methods::SCENE),
];

/// The scene of this name, if there is one: `coin-toss`.
pub fn named(name: &str) -> Option<&'static Scene> {
    SCENES.iter().map(|(_, scene)| *scene).find(|scene| scene.name == name)
}

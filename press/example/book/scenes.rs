//! The live scenes.

#[path = "pendulum/scene.rs"]
mod pendulum;

/// All live scenes, each with the folder of its chapter.
pub const SCENES: &[(&str, &live::Scene)] = &[("pendulum", &pendulum::SCENE)];

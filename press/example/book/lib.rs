//! The code of the pages: what is listed here is drawn, and what is not, is not.

pub mod pendulum {
    #[cfg(feature = "figures")]
    pub mod figures;
    pub mod scene;
}
#[cfg(feature = "figures")]
pub mod tables;

/// All live scenes, each with the folder of its chapter.
pub const SCENES: &[(&str, &live::Scene)] = &[("pendulum", &pendulum::scene::SCENE)];

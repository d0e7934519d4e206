//! The figures of every chapter.

#[path = "pendulum/figures.rs"]
mod pendulum;

/// All figures, chapter by chapter.
pub const FIGURES: &[&[figures::Figure]] = &[pendulum::FIGURES];

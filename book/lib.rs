//! The code of the pages. Each chapter keeps its figures and its live scenes in its own folder, beside its text; the
//! files of this folder name them.

#[cfg(feature = "figures")]
pub mod figures;
pub mod scenes;
#[cfg(feature = "figures")]
pub mod tables;

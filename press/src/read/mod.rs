//! Reads: which pages there are, and what stands on them, in the dialect that the crate describes.

pub mod disk;
pub mod exercise_times;

pub(crate) mod control_characters;
pub(crate) mod folded_assertions;
pub(crate) mod font_coverage;
pub(crate) mod items;
pub(crate) mod label_syntax;
pub(crate) mod labels;
pub(crate) mod margin_notes;
pub(crate) mod outline;
pub(crate) mod raw_html;
pub(crate) mod references;
pub(crate) mod scan;
pub(crate) mod snippets;
pub(crate) mod summary;
pub(crate) mod tables;

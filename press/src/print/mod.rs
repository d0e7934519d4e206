//! Prints: what mdBook is to read in the place of a page.

pub mod symbols;

pub(crate) mod code_links;
pub(crate) mod live_numbers_panel;
pub(crate) mod maths;
pub(crate) mod nonbreaking;
pub(crate) mod render;
pub(crate) mod scenes;

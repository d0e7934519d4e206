//! Makes the site: before mdBook renders the pages, and after it has.

pub mod check;

pub(crate) mod exercises;
pub(crate) mod licence;
pub(crate) mod links;
pub(crate) mod look;
pub(crate) mod not_found_page;
pub(crate) mod package;
pub(crate) mod page_metadata;
pub(crate) mod postprocess;
pub(crate) mod preprocess;
pub(crate) mod publish;
pub(crate) mod rustdoc;
pub(crate) mod scripts;
pub(crate) mod search;
pub(crate) mod sidebar;
pub(crate) mod solutions;
pub(crate) mod theme;
pub(crate) mod trails;
pub(crate) mod version_stamp;
pub(crate) mod wasm;

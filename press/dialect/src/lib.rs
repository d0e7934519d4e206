//! What of a page is code, for the press and for the build scripts of books: which pages there are, the numbers that a
//! snippet prints, and those that a reader may change.

pub mod expected_output;
pub mod live_numbers;
pub mod markdown;
pub mod pages;
mod snippets;

pub use snippets::write_snippets;

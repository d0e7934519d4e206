//! The snippets of the README and of every page of the book, which `cargo test --doc -p snippets` runs: the
//! build script reads the list of the pages from `book/SUMMARY.md`.

#[cfg(doctest)]
include!(concat!(env!("OUT_DIR"), "/pages.rs"));

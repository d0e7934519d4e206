//! Rigid-body mechanics, checked equation by equation: the library behind the book *Things That Spin*.
//!
//! | chapter | module |
//! |---|---|
//! | Physics in the laundromat | [`scenes::laundromat`] |
//!
//! Each module of [`scenes`] models one problem with the smallest state that it needs, in closed form where there is
//! one. [`integrate`] holds the stepping methods and [`measure`] the one definition of error that tests, benchmarks and
//! book share.
//!
//! SI units and radians throughout. Labels such as `eq:steady-radius` in comments are those of the book's equations.

pub mod integrate;
pub mod measure;
pub mod scenes;

mod two_part;

/// Every page of the book, so that rustdoc tests its snippets. `tests/book.rs` holds this list equal to
/// `book/SUMMARY.md`.
#[cfg(doctest)]
mod pages {
    #[doc = include_str!("../README.md")]
    mod readme {}
    #[doc = include_str!("../book/preface.md")]
    mod preface {}
    #[doc = include_str!("../book/conventions.md")]
    mod conventions {}
    #[doc = include_str!("../book/laundromat/index.md")]
    mod laundromat {}
    #[doc = include_str!("../book/laundromat/exercises.md")]
    mod laundromat_exercises {}
    #[doc = include_str!("../book/laundromat/solutions.md")]
    mod laundromat_solutions {}
    #[doc = include_str!("../book/bibliography.md")]
    mod bibliography {}
}

//! The scenes of the book, one module a problem. Each models only what its scene needs.

pub mod laundromat;

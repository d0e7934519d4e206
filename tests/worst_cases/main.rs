//! The worst cases of the closed forms, searched for.
//!
//! A closed form has branches, and the branch that is wrong is the one that no test enters. So nothing here
//! is a grid: each test draws parameters over the whole range that is documented, with a liking for edges and
//! for the borders between branches, judges each case by [`taylor`] or another route of twice the working
//! precision that shares no code with the library, and then walks from the worst cases to where they are
//! worse still. The promise it holds is the one in the library's documentation.
//!
//! `WORST_CASES=50 cargo test --test worst_cases` looks fifty times as long, and draws also what no scene can show:
//! units of measurement at the ends of what is computed with, and machines of any numbers at all.

mod attitude;
mod ball;
mod blows;
mod chaplygin;
mod coin_toss;
mod conical;
mod drag;
mod elliptic;
mod faddeeva;
mod film;
mod free_tops;
mod linear;
mod long;
mod motor;
mod nods;
mod people;
mod ramp;
mod rolling;
mod search;
mod spin_down;
mod steady;
mod steady_wheel;
mod taylor;
mod top;
mod transient;
mod turning;
mod whirl;
mod wobble;

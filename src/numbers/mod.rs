//! Numbers: those that users give, with a name, a unit and a rule, those with more digits than a `f64` has, and many at
//! once, with the functions that serve one and many.

pub(crate) mod clock;
pub(crate) mod elementary;
pub(crate) mod lanes;
pub(crate) mod quantity;
pub(crate) mod two_part;

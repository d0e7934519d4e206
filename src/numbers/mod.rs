//! Numbers: those that users give, with a name, a unit and a rule, and those with more digits than a `f64` has.

pub(crate) mod quantity;
pub(crate) mod two_part;

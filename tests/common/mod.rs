//! What several groups of tests draw.

/// A number between `low` and `high`, even on a logarithmic scale.
pub(crate) fn between(random: &mut fastrand::Rng, low: f64, high: f64) -> f64 {
    low * (high / low).powf(random.f64())
}

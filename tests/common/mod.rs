//! What several groups of tests share.

use mechanics::integrate::Rates;

/// A number between `low` and `high`, even on a logarithmic scale.
pub(crate) fn between(random: &mut fastrand::Rng, low: f64, high: f64) -> f64 {
    low * (high / low).powf(random.f64())
}

/// Rates of any kind as one type. So an integrator is compiled once for each number of components and not once for each
/// test, which halves the time that compiling the tests takes.
pub(crate) fn any<'a, const N: usize>(rates: impl Rates<N> + 'a) -> Box<dyn Rates<N> + 'a> {
    Box::new(rates)
}

//! One question, many cases: thousands of machines, tosses or starts.

/// The answer for each case, in the order of the cases.
///
/// With the feature `parallel` all cores of the processor share the cases (through the crate rayon); without it, and
/// where there are no threads, as in a web page, they are taken one after the other. The answers are the same either
/// way, to the last bit.
///
/// ```
/// use mechanics::scenes::laundromat::{Machine, MachineParameters};
/// use mechanics::sweep::sweep;
/// // The largest circle of each of a thousand machines, from a soft to a stiff suspension.
/// let stiffnesses: Vec<f64> = (1..=1000).map(|n| 10.0 * f64::from(n)).collect(); // N/m
/// let peaks = sweep(&stiffnesses, |&stiffness| {
///     let machine = Machine::new(MachineParameters {
///         drum_mass: 28.0, load_mass: 2.0, load_radius: 0.25, stiffness, damping: 90.0, spin: 30.0,
///     })?;
///     Ok(machine.peak().map(|peak| peak.radius))
/// });
/// let peaks: Vec<Option<f64>> = peaks.into_iter().collect::<Result<_, mechanics::InvalidQuantity>>()?;
/// assert!(peaks[0].is_none() && peaks[999] > peaks[500]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sweep<T: Sync, R: Send>(cases: &[T], answer: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        cases.par_iter().map(answer).collect()
    }
    #[cfg(not(feature = "parallel"))]
    cases.iter().map(answer).collect()
}

//! What the test of a corrected equation must show: its own form holds, and the one that the source prints does not.

/// The part of the cases in which the printed form must fail: a slip that shows in one case of a thousand is none.
const SHARE: f64 = 0.9;

/// Takes for each case by how much the corrected form misses and by how much the printed one does, in the same measure.
/// Every corrected form must be within `tolerance`; nine in ten of the printed ones must be off by more than `by`.
pub(crate) fn corrected_holds_and_printed_fails(
    cases: impl IntoIterator<Item = (f64, f64)>,
    tolerance: f64,
    by: f64,
) {
    assert!(by >= 10.0 * tolerance, "a miss of {by} is not told from a hit within {tolerance}");
    let (mut count, mut failed) = (0, 0);
    for (corrected, printed) in cases {
        assert!(corrected <= tolerance, "the corrected form misses by {corrected} in case {count}");
        assert!(printed >= 0.0, "the printed form misses by {printed}, which is no measure");
        count += 1;
        failed += u32::from(printed > by);
    }
    assert!(count >= 3, "{count} cases prove nothing");
    assert!(
        f64::from(failed) >= SHARE * f64::from(count),
        "the printed form fails by more than {by} in {failed} of {count} cases only"
    );
}

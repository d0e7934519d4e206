//! The judge of the corrected equations accepts what it should, and nothing else.

use crate::printed::corrected_holds_and_printed_fails;
use std::panic::catch_unwind;

#[test]
fn a_printed_form_must_fail_in_nine_cases_of_ten_and_the_corrected_one_in_none() {
    let judged = |cases: Vec<(f64, f64)>, by: f64| {
        catch_unwind(|| corrected_holds_and_printed_fails(cases, 1e-9, by)).is_ok()
    };
    let with = |odd: (f64, f64), count: usize| {
        let mut cases = vec![(1e-12, 0.5); 100 - count];
        cases.extend(vec![odd; count]);
        cases
    };
    assert!(judged(with((0.0, 1.0), 0), 0.1));
    assert!(judged(with((0.0, 0.0), 10), 0.1));
    assert!(!judged(with((0.0, 0.0), 11), 0.1), "it may not hold in more than a tenth");
    assert!(!judged(with((1e-8, 0.5), 1), 0.1), "the corrected form may not miss once");
    assert!(!judged(with((f64::NAN, 0.5), 1), 0.1));
    assert!(!judged(with((0.0, f64::NAN), 1), 0.1));
    assert!(!judged(with((0.0, 0.5), 0), 5e-9), "a miss must be told from a hit");
    assert!(!judged(vec![(0.0, 0.5); 2], 0.1) && !judged(Vec::new(), 0.1), "two cases are none");
}

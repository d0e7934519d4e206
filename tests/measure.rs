//! The definitions of error, drift, order and work say what they should of cases worked out by hand.

use mechanics::measure::{Counter, drift, max_error, observed_order};

#[test]
fn error_is_the_largest_difference_of_all_times_and_components() {
    let computed = [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]];
    let reference = [[1.0, 2.5], [3.0, 4.0], [5.25, 6.0]];
    assert_eq!(max_error(&computed, &reference), 0.5);
    assert_eq!(max_error(&computed, &computed), 0.0);
    let empty: [[f64; 2]; 0] = [];
    assert!(max_error(&empty, &empty).is_nan() && max_error(&computed, &computed[..1]).is_nan());
}

#[test]
fn error_of_what_is_not_a_number_is_not_a_number() {
    // Not the largest of the others, which is what f64::max would say.
    for place in 0..3 {
        let mut computed = [[1.0], [2.0], [3.0]];
        computed[place] = [f64::NAN];
        assert!(max_error(&computed, &[[1.0], [2.0], [9.0]]).is_nan(), "NaN in place {place}");
    }
    assert!(drift(&[1.0, f64::NAN, 1.0], 1.0).is_nan());
}

#[test]
fn drift_is_measured_from_the_first_value_and_in_units_of_the_scale() {
    assert_eq!(drift(&[2.0, 2.5, 1.0, 2.25], 4.0), 0.25);
    assert_eq!(drift(&[7.0], 1.0), 0.0);
    assert_eq!(drift(&[], 1.0), 0.0);
}

#[test]
fn order_leaves_out_the_plateau_and_the_useless_steps() {
    // Error 5 h³ above a plateau of 1e-12, and nonsense at the longest step.
    let steps: Vec<f64> = (0..20).map(|n| 0.5_f64.powi(n)).collect();
    let pairs: Vec<(f64, f64)> =
        steps.iter().map(|&h| (h, if h == 1.0 { 40.0 } else { (5.0 * h.powi(3)).max(1e-12) })).collect();
    let found = observed_order(&pairs, 2e-12).expect("enough points");
    assert!((found.slope - 3.0).abs() < 1e-10, "slope {}", found.slope);
    // 5 h³ is between 2e-12 and 1 for h = 1/2 to 1/8192.
    assert_eq!(found.points, 13);
    // Without the plateau left out, the slope is wrong and says so.
    assert!((observed_order(&pairs, 0.0).unwrap().slope - 3.0).abs() > 0.3);
}

#[test]
fn order_needs_three_points() {
    let two = [(0.1, 1e-3), (0.05, 1e-4)];
    assert_eq!(observed_order(&two, 0.0), None);
    assert_eq!(observed_order(&[(0.1, 1e-3), (0.05, 1e-4), (0.025, 1e-16)], 1e-15), None);
    assert_eq!(observed_order(&[(0.1, 1e-3); 4], 0.0), None); // one step, four times
    let nothing = [(0.1, f64::NAN), (0.05, f64::NAN), (0.025, f64::NAN), (0.0, 1e-3), (f64::NAN, 1e-3)];
    assert_eq!(observed_order(&nothing, 0.0), None);
}

#[test]
fn counter_counts_through_several_integrations() {
    let counter = Counter::new();
    let rates = |_t: f64, y: &[f64; 1]| [-y[0]];
    mechanics::integrate::rk4(counter.count(rates), 0.0, [1.0], 1.0, 3).unwrap();
    mechanics::integrate::rk4(counter.count(rates), 0.0, [1.0], 1.0, 4).unwrap();
    assert_eq!(counter.evaluations(), 28);
}

#[test]
fn an_order_is_not_read_from_errors_that_are_not_numbers() {
    let pairs = [(0.1, 1e-2), (0.05, 1e-3), (0.025, 1e-4), (0.0125, f64::NAN)];
    assert!(observed_order(&pairs, 0.0).is_none());
    assert!(observed_order(&pairs[..3], 0.0).is_some());
    // Nor from a step that is not one, though the others would do.
    let steps = [(0.1, 1e-2), (0.05, 1e-3), (0.025, 1e-4), (f64::NAN, 1e-5)];
    assert!(observed_order(&steps, 0.0).is_none());
}

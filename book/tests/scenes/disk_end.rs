//! The small scene of "How Euler's disk ends": its support against Newton's law for its centre.

use crate::hand::{Hand, number_behind};

const FILM: f64 = 10.0;
const STEPS: f64 = 120.0;

#[test]
fn the_table_carries_what_the_fall_of_the_centre_leaves_to_it() {
    for power in [0.5, 1.0, 1.25, 2.0] {
        let hand = Hand::with("disk-end", &[("power", power)]);
        // The height of the centre at each picture of the film, and the time.
        let at = |k: f64| {
            let moment = FILM * k / STEPS;
            (hand.reading(moment, "time"), 0.0375 * hand.reading(moment, "tilt").sin())
        };
        for k in 2..118 {
            let k = f64::from(k);
            let [before, now, after] = [k - 1.0, k, k + 1.0].map(at);
            let slope = |one: (f64, f64), other: (f64, f64)| (other.1 - one.1) / (other.0 - one.0);
            let acceleration = 2.0 * (slope(now, after) - slope(before, now)) / (after.0 - before.0);
            let support = hand.reading(FILM * k / STEPS, "support");
            // A step of the film is a fiftieth of all that is left.
            assert!(
                (support - 1.0 - acceleration / 9.81).abs() < 0.02,
                "{power}, {k}: {support}, {acceleration}"
            );
        }
    }
}

#[test]
fn it_leans_on_the_table_as_the_page_says() {
    for (power, least) in [(2.0, 0.73), (1.25, 0.78), (1.0, 0.80), (0.5, 0.88)] {
        let words = Hand::with("disk-end", &[("power", power)]).words();
        let said = number_behind(&words, "on the table with");
        assert!((said - least).abs() < 0.0051, "{power}: {words}");
    }
}

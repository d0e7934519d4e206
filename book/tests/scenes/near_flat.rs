//! The small scene of "Which circles last, and how a disc falls" against the equation of a point that a constant force pulls.

use crate::hand::{Hand, number_behind};
use mechanics::integrate::Dop853;

/// How far the contact runs round until the tilt is back, degrees, by eq:near-flat-fall with a and g for units.
fn round(moment: f64, turn: f64) -> f64 {
    let tilt: f64 = 0.05;
    let kept = turn * (tilt / moment).sqrt() * tilt; // q₀α₀, in that of steady rolling
    let rates = |_: f64, &[alpha, falls, _]: &[f64; 3]| {
        [falls, (moment * kept * kept / alpha.powi(3) - 1.0) / (1.0 + moment), kept / (alpha * alpha)]
    };
    let times: Vec<f64> = (0..=40_000).map(|k| 5e-5 * f64::from(k)).collect();
    let (states, _) = Dop853::new(1e-11).unwrap().sample(rates, 0.0, [tilt, 0.0, 0.0], &times).unwrap();
    // It falls first, then rises until its rate changes sign once more.
    let low = states.iter().position(|state| state[1] > 0.0).unwrap();
    let back = low + states[low..].iter().position(|state| state[1] < 0.0).unwrap();
    states[back][2].to_degrees()
}

#[test]
fn the_contact_runs_round_as_a_point_that_is_pulled() {
    for (which, moment) in [(0.0, 0.25), (1.0, 0.5)] {
        for turn in [0.02, 0.1, 0.4, 0.8] {
            let hand = Hand::with("near-flat", &[("turn", turn), ("wheel", which)]);
            let (end, whole) = (hand.reading(8.0, "run round"), round(moment, turn));
            assert!((end / whole - 1.0).abs() < 3e-3, "{moment}, {turn}: {end}, not {whole}");
            assert!((hand.reading(8.0, "tilt") - 0.05).abs() < 1e-9 && hand.reading(4.0, "tilt") < 0.05);
        }
    }
}

#[test]
fn the_slightest_turn_gives_the_angle_of_the_page() {
    for (which, least) in [(0.0, 402.5), (1.0, 311.8)] {
        let hand = Hand::with("near-flat", &[("turn", 1e-4), ("wheel", which)]);
        assert!((hand.reading(8.0, "run round") - least).abs() < 0.1);
        assert!((number_behind(&hand.words(), "turn by") - least).abs() < 0.06, "{}", hand.words());
    }
}

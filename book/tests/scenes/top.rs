//! The scene of "The top under gravity" against the whole body, stepped.

use crate::hand::{Hand, number_behind};
use fastrand::Rng;
use mechanics::integrate::Dop853;

/// I₁, I₃ and mgl of the toy.
const ACROSS: f64 = 2e-4;
const ALONG: f64 = 5e-5;
const WEIGHT: f64 = 0.1 * 0.04 * 9.81;

fn scene(settings: &[(&str, f64)]) -> Hand {
    Hand::with("top", settings)
}

#[test]
fn tilt_and_azimuth_are_those_of_lagranges_equations_stepped() {
    let mut random = Rng::with_seed(17);
    for _ in 0..12 {
        let spin = (30.0 + 200.0 * random.f64()).round();
        let degrees = (10.0 * (20.0 + 80.0 * random.f64())).round() / 10.0;
        let push = (10.0 * (12.0 * random.f64() - 6.0)).round() / 10.0;
        let hand = scene(&[("spin", spin), ("tilt", degrees), ("push", push)]);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let upright = ALONG * spin * cos + ACROSS * push * sin * sin;
        let rates = move |_: f64, [tilt, rate, _]: &[f64; 3]| {
            let (sin, cos) = tilt.sin_cos();
            let round = (upright - ALONG * spin * cos) / (ACROSS * sin * sin);
            let pull = ACROSS * round * round * sin * cos - ALONG * spin * round * sin + WEIGHT * sin;
            [*rate, pull / ACROSS, round]
        };
        let solver = Dop853::new(1e-12).expect("a solver");
        for time in [0.1, 0.7, 1.9] {
            let start = [degrees.to_radians(), 0.0, 0.0];
            let [tilt, _, round] = solver.solve(rates, 0.0, start, time).expect("a motion").state;
            assert!(
                (hand.reading(time, "tilt") - tilt.to_degrees()).abs() < 0.051,
                "{spin} {degrees} {push}"
            );
            let found = hand.reading(time, "round the vertical");
            assert!((found - round.to_degrees()).abs() < 0.051, "{spin} {degrees} {push}: {found}");
            assert!(hand.reading(time, "change of the energy").abs() < 1e-13);
            assert!(hand.reading(time, "change of $L_z").abs() < 1e-13);
        }
    }
}

#[test]
fn its_words_have_the_nod_and_the_sleeping_spin() {
    let words = scene(&[]).words_at(0.0);
    assert!((number_behind(&words, "once in") - 0.222).abs() < 5e-4, "{words}");
    assert!((number_behind(&words, "carries it") - 75.4).abs() < 0.5, "{words}");
    let asleep = scene(&[("spin", 113.0), ("tilt", 1.0)]).words_at(0.0);
    let awake = scene(&[("spin", 111.0), ("tilt", 1.0)]).words_at(0.0);
    assert!(asleep.contains("It sleeps") && !awake.contains("It sleeps"), "{asleep} {awake}");
}

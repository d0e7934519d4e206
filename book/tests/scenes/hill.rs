//! The small scene of the landscape against the rider's own equation of motion, eq:turning-motion with each damper.

use crate::hand::{Hand, number_behind};
use mechanics::integrate::Dop853;
use nalgebra::Complex;

/// ω₀, Γ and b of the scene's machine, rad/s, 1/s, m.
const NATURAL: f64 = 10.0;
const DAMPING: f64 = 1.5;
const OFFSET: f64 = 0.5 / 30.0;

/// The rider's ζ and its rate at some times after the kick, stepped on the drum.
fn ridden(spin: f64, damper: usize, place: Complex<f64>, times: &[f64]) -> Vec<[Complex<f64>; 2]> {
    let i = Complex::i();
    let rates = |_: f64, &[x, y, vx, vy]: &[f64; 4]| {
        let (at, rate) = (Complex::new(x, y), Complex::new(vx, vy));
        let damping = match damper {
            0 => at * (at.conj() * rate).re / at.norm_sqr() * DAMPING,
            1 => (rate + i * spin * at) * DAMPING,
            _ => Complex::default(),
        };
        let force = OFFSET * spin * spin - 2.0 * i * spin * rate - at * (NATURAL * NATURAL - spin * spin);
        let change = force - damping;
        [vx, vy, change.re, change.im]
    };
    let start = [place.re, place.im, 0.0, 0.25];
    let (states, _) = Dop853::new(1e-12).unwrap().sample(rates, 0.0, start, times).unwrap();
    states.into_iter().map(|[x, y, vx, vy]| [Complex::new(x, y), Complex::new(vx, vy)]).collect()
}

#[test]
fn the_rider_sees_what_the_rotating_frame_says() {
    let times = [0.0, 0.3, 0.77, 1.0];
    for (spin, damper) in [(22.0, 0), (22.0, 1), (22.0, 2), (6.0, 0), (6.0, 1), (30.0, 0), (12.5, 2)] {
        let square = NATURAL * NATURAL - spin * spin;
        let resisted = if damper == 1 { DAMPING } else { 0.0 };
        let place = OFFSET * spin * spin / Complex::new(square, resisted * spin);
        let height = |[at, rate]: [Complex<f64>; 2]| {
            0.5 * (rate.norm_sqr() + square * at.norm_sqr()) - OFFSET * spin * spin * at.re
        };
        let hand = Hand::with("hill", &[("spin", spin), ("damper", damper as f64)]);
        for (time, state) in times.into_iter().zip(ridden(spin, damper, place, &times)) {
            let (away, more) =
                (1e3 * (state[0] - place).norm(), 1e3 * (height(state) - height([place, 0.0.into()])));
            let [read, excess] = [hand.reading(time, "distance"), hand.reading(time, "$J$")];
            let of = format!("{spin} rad/s, damper {damper}, at {time} s");
            assert!((read - away).abs() < 1e-3, "{of}: {read} mm, not {away}");
            assert!((excess - more).abs() < 1e-2, "{of}: {excess} mJ/kg, not {more}");
        }
    }
}

#[test]
fn the_words_say_which_damper_brings_it_home() {
    let words = |settings: &[(&str, f64)]| Hand::with("hill", settings).words();
    assert!(words(&[]).contains("top of a hill") && words(&[]).contains("runs down"), "{}", words(&[]));
    let floor = words(&[("damper", 1.0)]);
    assert!(
        floor.contains("comes home") && (number_behind(&floor, "factor e in") - 1.33).abs() < 1e-9,
        "{floor}"
    );
    assert!(words(&[("damper", 2.0)]).contains("neither"));
    let bowl = words(&[("spin", 6.0)]);
    assert!(bowl.contains("bottom of a bowl") && bowl.contains("comes home"), "{bowl}");
    // At resonance a circle without a damper has no radius.
    assert!(!Hand::refusal("hill", &[("spin", 10.0)]).is_empty());
    assert!(words(&[("spin", 10.0), ("damper", 1.0)]).contains("comes home"));
}

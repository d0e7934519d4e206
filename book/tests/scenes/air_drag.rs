//! The scene of "Frisbee and pencil" against the decay of spin and wobble, each by itself.

use crate::hand::Hand;
use fastrand::Rng;

/// The quicker of the two decays, 1/s, as the scene chooses it.
const QUICKER: f64 = 0.125;

fn any(random: &mut Rng) -> [f64; 3] {
    let power = |from: f64, to: f64, part: f64| from * (to / from).powf(part);
    let [ratio, drag] = [power(0.002, 2.0, random.f64()), power(0.05, 2000.0, random.f64())];
    [ratio, drag, 0.5 * f64::from(random.u8(1..180))]
}

fn thrown([ratio, drag, lean]: [f64; 3]) -> Hand {
    Hand::with("air-drag", &[("ratio", ratio), ("drag", drag), ("lean", lean)])
}

#[test]
fn spin_and_wobble_decay_each_by_its_own_clock() {
    let mut random = Rng::with_seed(54);
    for _ in 0..60 {
        let settings = any(&mut random);
        let hand = thrown(settings);
        let ([ratio, drag, lean], time) = (settings, random.f64() * hand.duration());
        // C₁/I₁ over C₃/I₃; the larger of the two is fixed.
        let [wobble, spin] = [QUICKER * (drag * ratio).min(1.0), QUICKER * (drag * ratio).recip().min(1.0)];
        let across = lean.to_radians().sin() * (-wobble * time).exp();
        let along = lean.to_radians().cos() * (-spin * time).exp();
        // The frame that goes with the wobble turns slowly; the wobble goes round the body this much.
        let turns =
            1.2 * lean.to_radians().cos() * (1.0 / ratio - 1.0).abs() * (1.0 - (-spin * time).exp()) / spin;
        for (words, expected, slack) in [
            ("spin that is left", 100.0 * (-spin * time).exp(), 0.051),
            ("lean of the axis", across.atan2(along).to_degrees(), 0.051),
            ("rate at which the wobble", wobble, 6e-4),
            ("rate at which the spin", spin, 6e-4),
            ("turns of", turns, 0.051 + 1e-9 * turns),
            ("energy lost", 0.0, 1e-9),
        ] {
            let found = hand.reading(time, words);
            assert!((found - expected).abs() < slack, "{settings:?}, {time} s, {words}: {found}, {expected}");
        }
    }
}

#[test]
fn the_words_say_which_dies_first_and_what_is_left_by_then() {
    let mut random = Rng::with_seed(4);
    let mut sides = [0; 2];
    for _ in 0..300 {
        let [ratio, drag, lean] = any(&mut random);
        if lean == 90.0 || (ratio * drag - 1.0).abs() < 0.1 {
            continue;
        }
        let words = thrown([ratio, drag, lean]).words();
        let settles = ratio * drag > 1.0;
        sides[usize::from(settles)] += 1;
        assert_eq!(words.starts_with("The wobble dies first"), settles, "{words}");
        assert_eq!(words.starts_with("The spin dies first"), !settles, "{words}");
        // While tan θ changes tenfold the spin falls by ten to the power of this (eq:tangent-power, with two drags).
        let left = 100.0 * 0.1_f64.powf((ratio * drag - 1.0).abs().recip());
        let plain = words.replace('\u{a0}', " ");
        let said = plain
            .split_once(" % of the spin")
            .and_then(|(before, _)| before.rsplit(' ').next()?.parse::<f64>().ok());
        let slack = if left < 1.0 { 0.006 } else { 0.51 };
        let is_right = said.map_or(left < 0.0101 && words.contains("next to nothing"), |found| {
            (found - left).abs() <= slack
        });
        assert!(is_right && (settles || left <= 10.0), "{left}: {words}");
    }
    assert!(sides.iter().all(|count| *count > 50), "{sides:?}");
}

#[test]
fn what_turns_about_one_axis_alone_keeps_to_it() {
    for settings in [[0.0024, 1.0, 0.0], [2.0, 1.0, 90.0], [1.0, 1.0, 20.0]] {
        let hand = thrown(settings);
        let lean = |time: f64| hand.reading(time, "lean of the axis");
        assert!((lean(0.0) - lean(hand.duration())).abs() < 1e-9, "{settings:?}");
    }
}

//! The scene of "Frisbee and pencil" against the decay of spin and wobble, each by itself.

use drawing::{Point, at};
use fastrand::Rng;
use live::{Moment, Player, Room};

/// The quicker of the two decays, 1/s, as the scene chooses it.
const QUICKER: f64 = 0.125;

fn scene(settings: &[(&str, f64)]) -> Player {
    let found = pages::scenes::named("air-drag");
    Player::new(found.expect("it is there")).and_then(|scene| scene.changed(settings)).expect("settings")
}

fn number(reading: &str) -> f64 {
    let plain =
        reading.replace('−', "-").replace("·10<sup>", "e").replace("10<sup>", "1e").replace("</sup>", "");
    let end = plain.find(|sign: char| !"0123456789.-e".contains(sign)).unwrap_or(plain.len());
    plain[..end].parse().unwrap_or_else(|_| panic!("{reading}"))
}

/// The percentage in the words.
fn percentage(words: &str) -> Option<f64> {
    words.replace('\u{a0}', " ").split(" % of the spin").next()?.rsplit(' ').next()?.parse().ok()
}

fn any(random: &mut Rng) -> [f64; 3] {
    let power = |from: f64, to: f64, part: f64| from * (to / from).powf(part);
    let [ratio, drag] = [power(0.002, 2.0, random.f64()), power(0.05, 2000.0, random.f64())];
    [ratio, drag, 0.5 * f64::from(random.u8(1..180))]
}

#[test]
fn spin_and_wobble_decay_each_by_its_own_clock() {
    let mut random = Rng::with_seed(54);
    for _ in 0..60 {
        let [ratio, drag, lean] = any(&mut random);
        let player = scene(&[("ratio", ratio), ("drag", drag), ("lean", lean)]);
        let run = player.run();
        let time = random.f64() * run.duration;
        let found: Vec<f64> =
            player.readings(time).expect("readings").iter().map(|text| number(text)).collect();
        // C₁/I₁ over C₃/I₃; the larger of the two is fixed.
        let [wobble, spin] = [QUICKER * (drag * ratio).min(1.0), QUICKER * (drag * ratio).recip().min(1.0)];
        let across = lean.to_radians().sin() * (-wobble * time).exp();
        let along = lean.to_radians().cos() * (-spin * time).exp();
        let expected = [100.0 * (-spin * time).exp(), across.atan2(along).to_degrees(), wobble, spin];
        for (found, (expected, rounding)) in
            found.iter().zip(expected.into_iter().zip([0.051, 0.051, 6e-4, 6e-4]))
        {
            assert!((found - expected).abs() < rounding, "{ratio} {drag} {lean} {time}: {found}, {expected}");
        }
        assert!(found[5].abs() < 1e-9, "{ratio} {drag} {lean} {time}: energy {}", found[5]);
        // The frame that goes with the wobble turns slowly; the wobble goes round the body this much.
        let turns =
            1.2 * lean.to_radians().cos() * (1.0 / ratio - 1.0).abs() * (1.0 - (-spin * time).exp()) / spin;
        assert!((found[4] - turns).abs() < 0.051 + 1e-9 * turns, "{ratio} {drag}: {} {turns}", found[4]);
    }
}

#[test]
fn the_words_say_who_wins_and_what_is_left_by_then() {
    let mut random = Rng::with_seed(4);
    let mut sides = [0; 2];
    for _ in 0..300 {
        let [ratio, drag, lean] = any(&mut random);
        if lean == 90.0 || (ratio * drag - 1.0).abs() < 0.1 {
            continue;
        }
        let words = scene(&[("ratio", ratio), ("drag", drag), ("lean", lean)]).words(0.0);
        let settles = ratio * drag > 1.0;
        sides[usize::from(settles)] += 1;
        assert_eq!(words.starts_with("The wobble dies first"), settles, "{words}");
        assert_eq!(words.starts_with("The spin dies first"), !settles, "{words}");
        // While tan θ changes tenfold the spin falls by ten to the power of this (eq:tangent-power, with two drags).
        let left = 100.0 * 0.1_f64.powf((ratio * drag - 1.0).abs().recip());
        match percentage(&words) {
            Some(found) => {
                assert!((found - left).abs() <= if left < 1.0 { 0.006 } else { 0.51 }, "{left}: {words}");
            }
            None => assert!(left < 0.0101 && words.contains("next to nothing"), "{left}: {words}"),
        }
        assert!(settles || left <= 10.0);
    }
    assert!(sides.iter().all(|count| *count > 50), "{sides:?}");
}

#[test]
fn what_turns_about_one_axis_alone_keeps_to_it() {
    for (settings, said) in [
        (vec![("lean", 0.0), ("ratio", 0.0024)], "exactly about its axis"),
        (vec![("lean", 90.0), ("ratio", 2.0)], "exactly across"),
        (vec![("ratio", 1.0), ("drag", 1.0), ("lean", 20.0)], "stays at 20°"),
    ] {
        let player = scene(&settings);
        assert!(player.words(0.0).contains(said), "{}", player.words(0.0));
        let lean = |time: f64| number(&player.readings(time).expect("readings")[1]);
        assert!((lean(0.0) - lean(player.run().duration)).abs() < 1e-9);
    }
}

#[test]
fn a_hand_moves_the_body_over_the_map_and_leans_it() {
    for room in [Room::Wide, Room::Narrow] {
        let mut player = scene(&[("ratio", 0.5), ("drag", 3.0), ("lean", 40.0)]);
        let moment = Moment { time: 3.0, azimuth: -1.0, elevation: 0.3, room };
        player.draw(moment).expect("a picture");
        for (grip, step) in
            [(0, at(-20.0, 15.0)), (0, at(11.0, -23.0)), (1, at(12.0, 0.0)), (1, at(-40.0, -9.0))]
        {
            let from = player.grips()[grip];
            let values = player.drag(grip, from + step).expect("a drag");
            let mut after = Player::with(player.scene(), values).expect("settings");
            after.draw(moment).expect("a picture");
            let found = after.grips()[grip];
            let expected: Point = match grip {
                0 => from + step,
                // The arrow's tip stays on its circle: it goes where the hand points.
                _ => {
                    let others = scene(&[("lean", 0.0)]);
                    let mut upright = others;
                    upright.draw(moment).expect("a picture");
                    let mut level = scene(&[("lean", 90.0)]);
                    level.draw(moment).expect("a picture");
                    let (top, right) = (upright.grips()[1], level.grips()[1]);
                    let middle = at(top.x, right.y);
                    middle + (from + step - middle).unit() * (top - middle).length()
                }
            };
            assert!((found - expected).length() < 1.0, "{grip}: {found:?}, {expected:?}");
        }
    }
}

//! The scene of "The pinned hoop" against Euler's equations, stepped, and the laws of the snap.

use drawing::{Fill, Hue, Point, Role, Shape, at};
use fastrand::Rng;
use live::{Moment, Player, Room};

/// Moments of a hoop and a disc of mass and radius one about a point of their rims.
const MOMENTS: [[f64; 3]; 2] = [[1.5, 0.5, 2.0], [1.25, 0.25, 1.5]];

fn scene(settings: &[(&str, f64)]) -> Player {
    let found = pages::scenes::named("pinned-hoop");
    Player::new(found.expect("it is there")).and_then(|scene| scene.changed(settings)).expect("settings")
}

fn number(reading: &str) -> f64 {
    let plain =
        reading.replace('−', "-").replace("·10<sup>", "e").replace("10<sup>", "1e").replace("</sup>", "");
    let end = plain.find(|sign: char| !"0123456789.-e".contains(sign)).unwrap_or(plain.len());
    plain[..end].parse().unwrap_or_else(|_| panic!("{reading}"))
}

/// The number of seconds behind a word.
fn seconds(words: &str, behind: &str) -> f64 {
    let rest = words.split_once(behind).unwrap_or_else(|| panic!("{words}")).1;
    rest.trim_start()
        .split(char::is_whitespace)
        .next()
        .and_then(|text| text.parse().ok())
        .unwrap_or_else(|| panic!("{words}"))
}

/// Steps Euler's equations after the snap until ω₁ vanishes: the time of that.
fn first_tumble([i1, i2, i3]: [f64; 3], degrees_to_go: f64) -> f64 {
    let (height, from_axis) = degrees_to_go.to_radians().sin_cos();
    let rates = |[w1, w2, w3]: [f64; 3]| {
        [(i2 - i3) / i1 * w2 * w3, (i3 - i1) / i2 * w3 * w1, (i1 - i2) / i3 * w1 * w2]
    };
    let moved = |omega: [f64; 3], rate: [f64; 3], step: f64| [0, 1, 2].map(|k| omega[k] + step * rate[k]);
    // What is left of the rotation about the tangent is I_d/I₁, and I_d = I₂.
    let (mut omega, mut time, step) = ([i2 / i1 * from_axis, -height, 0.0], 0.0, 1e-3);
    loop {
        let a = rates(omega);
        let b = rates(moved(omega, a, 0.5 * step));
        let c = rates(moved(omega, b, 0.5 * step));
        let d = rates(moved(omega, c, step));
        let next = [0, 1, 2].map(|k| omega[k] + step / 6.0 * (a[k] + 2.0 * (b[k] + c[k]) + d[k]));
        if next[0] <= 0.0 {
            return time + step * omega[0] / (omega[0] - next[0]);
        }
        (omega, time) = (next, time + step);
    }
}

#[test]
fn it_waits_as_long_as_eulers_equations_do() {
    let mut random = Rng::with_seed(89);
    for n in 0..24 {
        let (shape, gap) = (n % 2, 1e-3 * 3e4_f64.powf(random.f64()));
        let player = scene(&[("gap", gap), ("shape", shape as f64)]);
        let wait = first_tumble(MOMENTS[shape], gap);
        // It keeps its answer to itself until it has turned over.
        assert!(player.words(0.99 * wait).contains("For how long?"), "{}", player.words(0.99 * wait));
        let words = player.words(1.01 * wait);
        assert!((seconds(&words, "turns over after") - wait).abs() < 0.0501, "{wait}: {words}");
        assert!((seconds(&words, "then every") - 2.0 * wait).abs() < 0.0502, "{wait}: {words}");
        let later = first_tumble(MOMENTS[shape], 0.1 * gap) - wait;
        assert!((seconds(&words, "it would wait") - later).abs() < 0.0502, "{later}: {words}");
        for (time, turned) in [(0.99 * wait, 0.0), (1.01 * wait, 1.0), (2.99 * wait, 1.0), (3.01 * wait, 2.0)]
        {
            let readings = player.readings(time).expect("readings");
            assert_eq!(number(&readings[0]), turned, "{gap}: {time} of {wait}");
            assert!(number(&readings[3]).abs() < 1e-13 && number(&readings[4]) < 1e-13, "{readings:?}");
        }
        // After half the period it is upside down, as far as it was upright.
        let angle = |time: f64| number(&player.readings(time).expect("readings")[1]);
        assert!((angle(0.0) + angle(2.0 * wait) - 180.0).abs() < 0.21, "{gap}");
    }
}

#[test]
fn the_snap_takes_the_energy_that_its_law_says() {
    for (shape, kept) in [(0.0, 1.0 / 3.0), (1.0, 0.2), (2.0, 2.0 / 7.0)] {
        for gap in [0.01, 30.0, 60.0, 90.0_f64] {
            let readings = scene(&[("gap", gap), ("shape", shape)]).readings(1.0).expect("readings");
            let expected = 100.0 * gap.to_radians().cos().powi(2) * (1.0 - kept);
            assert!((number(&readings[2]) - expected).abs() < 0.0501, "{shape} {gap}: {readings:?}");
        }
    }
}

#[test]
fn what_never_turns_over_says_so() {
    for (settings, said) in [
        (vec![("exact", 1.0)], "for ever"),
        (vec![("gap", 90.0)], "as if nothing had happened"),
        (vec![("shape", 2.0)], "it never turns over"),
        (vec![("gap", 70.0)], "only nods"),
    ] {
        let player = scene(&settings);
        assert!(player.words(0.0).contains(said), "{}", player.words(0.0));
    }
    // The ball's centre goes round the momentum at two sevenths of ω₀.
    assert!(scene(&[("shape", 2.0)]).words(0.0).contains("once in 22\u{a0}s"));
    let exact = scene(&[("exact", 1.0)]);
    assert_eq!(number(&exact.readings(exact.run().duration).expect("readings")[1]), 0.0);
}

#[test]
fn a_hand_moves_the_pin_round_the_rim_and_along_the_plot() {
    for room in [Room::Wide, Room::Narrow] {
        let moment = Moment { time: 5.0, azimuth: -0.9, elevation: 0.3, room };
        let mut player = scene(&[("gap", 30.0)]);
        player.draw(moment).expect("a picture");
        let after = |grip: usize, to| {
            let values = player.drag(grip, to).expect("a drag");
            let mut after = Player::with(player.scene(), values).expect("settings");
            after.draw(moment).expect("a picture");
            after.grips()[grip]
        };
        let mut level = scene(&[("gap", 1e-4)]);
        level.draw(moment).expect("a picture");
        let mut upright = scene(&[("gap", 90.0)]);
        upright.draw(moment).expect("a picture");
        let centre = at(upright.grips()[0].x, level.grips()[0].y);
        let radius = (level.grips()[0] - centre).length();
        for angle in [0.01_f64, 0.4, 1.1, 1.5] {
            let to = centre + drawing::Point::polar(radius, angle);
            assert!((after(0, to) - to).length() < 1.0, "{angle}");
        }
        for step in [-60.0, -20.0, 10.0] {
            let from = player.grips()[1];
            assert!((after(1, from + at(step, 0.0)).x - from.x - step).abs() < 1.0, "{step}");
        }
        // A touch changes nothing, even where a hand could not have put the pin.
        level.draw(moment).expect("a picture");
        assert_eq!(level.drag(0, level.grips()[0]).expect("a drag"), level.values());
    }
}

#[test]
fn the_plot_keeps_what_the_reader_has_waited_for() {
    let places = |player: &mut Player, time: f64| -> Vec<Point> {
        let moment = Moment { time, azimuth: -0.9, elevation: 0.3, room: Room::Wide };
        let drawing = player.draw(moment).expect("a picture");
        let plot = drawing.axes()[0].frame.grown(1.0);
        let dots = drawing.items().iter().filter(|item| item.role == Role::Area(Fill::Solid, Hue::Pink));
        let dots = dots.filter_map(|item| match item.shape {
            Shape::Circle { centre, .. } if plot.contains(centre) => Some(centre),
            _ => None,
        });
        dots.collect()
    };
    let mut player = scene(&[("gap", 10.0)]);
    let wait = first_tumble(MOMENTS[0], 10.0);
    assert_eq!(places(&mut player, 0.0).len(), 1, "the pin, which begins to climb");
    assert_eq!(places(&mut player, 0.9 * wait).len(), 1, "nothing is measured yet");
    let reached = places(&mut player, 1.1 * wait)[0];
    // At another angle the place that it has reached stays; without waiting, nothing comes to it.
    let mut nearer = player.changed(&[("gap", 1.0)]).expect("a motion");
    assert!(places(&mut nearer, 0.0).contains(&reached));
    let mut player = nearer.changed(&[("gap", 0.1)]).expect("a motion");
    assert_eq!(places(&mut player, 300.0).len(), 2);
    let mut player = player.changed(&[("gap", 0.01)]).expect("a motion");
    assert_eq!(places(&mut player, 0.0).len(), 2, "a leap through time measures nothing");
    // A disc waits otherwise.
    let mut disc = player.changed(&[("shape", 1.0)]).expect("a motion");
    assert_eq!(places(&mut disc, 0.0).len(), 1);
}

//! The scene of the laundromat against small steps of Newton's equations, and formulas.

use crate::hand::{Hand, number_behind};
use drawing::{Hue, Role, Shape, Stroke, at};
use fastrand::Rng;
use live::Room;
use mechanics::integrate::rk4;
use nalgebra::Matrix4;
use std::f64::consts::TAU;

/// The chapter's machine: m + M, b, ω₀ and the scene's kick and acceleration, in SI units.
const MASS: f64 = 30.0;
const OFFSET: f64 = 1.0 / 60.0;
const NATURAL: f64 = 10.0;
const KICK: f64 = 0.4;
const ACCELERATION: f64 = 2.5;

fn washer(settings: &[(&str, f64)]) -> Hand {
    Hand::with("laundromat", settings)
}

fn close(found: f64, expected: f64, slack: f64, of: &str) {
    assert!((found - expected).abs() <= slack, "{of}: {found}, and {expected} by the other route");
}

/// A drum: its spin, rad/s, its acceleration up to that, rad/s², or none, and its dampers, 1/s.
#[derive(Clone, Copy, Default)]
struct Drum {
    spin: f64,
    acceleration: f64,
    /// On the whole velocity, on the radius only, and on board.
    floor: f64,
    radial: f64,
    board: f64,
}

impl Drum {
    /// Radius of the shaft and lead of the load in the steady motion, eq:steady-radius and eq:steady-phase.
    fn steady(&self) -> (f64, f64) {
        let (stiff, drag) = (NATURAL * NATURAL - self.spin * self.spin, self.floor * self.spin);
        (OFFSET * self.spin * self.spin / stiff.hypot(drag), drag.atan2(stiff))
    }

    /// [x, y, ẋ, ẏ] in the steady motion, at the time 0.
    fn start(&self) -> [f64; 4] {
        let (radius, lead) = self.steady();
        let (x, y) = (radius * lead.cos(), -radius * lead.sin());
        [x, y, -self.spin * y, self.spin * x]
    }

    fn rates(&self, time: f64, &[x, y, vx, vy]: &[f64; 4]) -> [f64; 4] {
        // −b d²/dt² of the direction of the load.
        let run_up = if self.acceleration > 0.0 { self.spin / self.acceleration } else { 0.0 };
        let (angle, rate, change) = if time < run_up {
            (0.5 * self.acceleration * time * time, self.acceleration * time, self.acceleration)
        } else {
            (self.spin * (time - 0.5 * run_up), self.spin, 0.0)
        };
        let (sin, cos) = angle.sin_cos();
        let along = self.radial * (x * vx + y * vy) / (x * x + y * y).max(1e-30);
        let slower = |place: f64, speed: f64, on_board: f64| {
            -NATURAL * NATURAL * place - self.floor * speed - along * place - self.board * on_board
        };
        [
            vx,
            vy,
            OFFSET * (rate * rate * cos + change * sin) + slower(x, vx, vx + self.spin * y),
            OFFSET * (rate * rate * sin - change * cos) + slower(y, vy, vy - self.spin * x),
        ]
    }

    /// [x, y, ẋ, ẏ] by small steps, with a kick on the way.
    fn after(&self, start: [f64; 4], kick: f64, end: f64) -> [f64; 4] {
        let stepped = |from: f64, state: [f64; 4], to: f64| {
            rk4(|time, state: &[f64; 4]| self.rates(time, state), from, state, to, 20_000).expect("steps")
        };
        let mut state = stepped(0.0, start, kick);
        state[2] += KICK;
        stepped(kick, state, end)
    }
}

#[test]
fn the_steady_numbers_are_those_of_the_formulas() {
    let mut random = Rng::with_seed(1);
    for _ in 0..100 {
        let spin = (1.0 + 590.0 * random.f64()).round() / 10.0;
        let damping = (15.0 + 235.0 * random.f64()).round() / 100.0;
        let hand = washer(&[("spin", spin), ("damping", damping)]);
        let drum = Drum { spin, floor: damping * NATURAL, ..Drum::default() };
        let (radius, lead) = drum.steady();
        let spring = (NATURAL * NATURAL).hypot(drum.floor * spin);
        let time = 8.0 * random.f64();
        for (words, expected, slack) in [
            ("turns a minute", spin * 60.0 / TAU, 0.51),
            ("lead", lead.to_degrees(), 0.51),
            ("shaft", 1e3 * radius, 0.051),
            ("centre of mass", 1e3 * radius / (spin * spin) * spring, 0.051),
            ("force", MASS * radius * spring, 0.51),
            ("drift", 0.0, 1e-9),
        ] {
            close(hand.reading(time, words), expected, slack, &format!("{spin} rad/s, {damping}: {words}"));
        }
    }
}

#[test]
fn a_run_up_with_a_kick_is_what_small_steps_give() {
    for (spin, damping, kick, end) in [(25.0, 0.3, 3.0, 5.0), (20.0, 0.05, 9.0, 11.0), (12.0, 2.2, 1.0, 2.0)]
    {
        let settings = [("spin", spin), ("damping", damping), ("motor", 1.0), ("kick", kick)];
        let hand = washer(&settings);
        let floor = damping * NATURAL;
        let drum = Drum { spin, floor, acceleration: ACCELERATION, ..Drum::default() };
        let [x, y, vx, vy] = drum.after([0.0; 4], kick, end);
        let of = format!("{settings:?}");
        close(hand.reading(end, "shaft"), 1e3 * x.hypot(y), 0.052, &of);
        let force = (100.0 * x + floor * vx).hypot(100.0 * y + floor * vy);
        close(hand.reading(end, "force"), MASS * force, 0.6, &of);
        close(hand.reading(end, "drift"), 0.0, 1e-8, &of);
    }
}

#[test]
fn a_tub_that_is_pulled_and_let_go_swings_out_as_far_as_the_hand_drew_it() {
    // Of a drum that stands still, without damping: a quarter of a swing later.
    for room in [Room::Wide, Room::Narrow] {
        for (from, to) in [(at(3.0, -5.0), at(40.0, 12.0)), (at(-9.0, 0.0), at(-31.0, -17.0))] {
            let mut hand = washer(&[("spin", 0.0), ("damping", 0.0)]);
            hand.draw(1.0, room);
            let rest = hand.body();
            assert!(hand.pull(rest + from, rest + from + at(0.1, -0.1)), "nothing is held");
            assert_eq!(hand.value("kick"), -1.0, "a hand that trembles kicks nothing");
            assert!(hand.pull(rest + from, rest + from + to), "nothing is held");
            assert_eq!(hand.value("kick"), 1.0);
            assert!((hand.body() - rest).length() < 1e-9, "it has its velocity, and is still there");
            hand.draw(1.0 + 0.25 * TAU / NATURAL, room);
            let off = (hand.body() - rest - to).length();
            assert!(off < 1.5, "{room:?}: {off} px from where the hand has been");
        }
    }
}

#[test]
fn a_load_that_is_drawn_round_takes_the_whole_picture_along() {
    for room in [Room::Wide, Room::Narrow] {
        let drawn = |settings: &[(&str, f64)]| {
            let mut hand = washer(settings);
            hand.draw(2.0, room);
            hand
        };
        let (mut hand, there) = (drawn(&[("spin", 10.0)]), drawn(&[("spin", 10.0), ("phase", 2.5)]));
        let (from, to) = (hand.bodies()[1], there.bodies()[1]);
        assert!((from - to).length() > 30.0 && hand.pull(from, to));
        assert!((hand.bodies()[1] - to).length() < 1.0, "the load is not where it was drawn");
        assert!((hand.reading(2.0, "shaft") - there.reading(2.0, "shaft")).abs() < 0.11);
        assert_eq!(hand.value("kick"), -1.0, "nobody has kicked it");
    }
}

#[test]
fn a_radial_damper_holds_until_it_is_kicked() {
    let settings = [("spin", 22.0), ("damping", 0.3), ("damper", 1.0)];
    let free = Drum { spin: 22.0, ..Drum::default() };
    let quiet = washer(&settings);
    for time in [0.0, 2.0, 7.9] {
        close(quiet.reading(time, "shaft"), 1e3 * free.steady().0, 0.051, "a pencil on its point");
        close(quiet.reading(time, "lead"), 180.0, 0.51, "a pencil on its point");
    }
    let kicked = washer(&[&settings[..], &[("kick", 0.5)]].concat());
    for end in [0.9, 1.6, 3.0] {
        let [x, y, ..] = Drum { radial: 3.0, ..free }.after(free.start(), 0.5, end);
        close(kicked.reading(end, "shaft"), 1e3 * x.hypot(y), 0.1, &format!("after {end} s"));
        close(kicked.reading(end, "drift"), 0.0, 1e-2, "the balance of momentum");
    }
}

#[test]
fn what_is_kept_to_compare_is_the_motion_with_its_own_settings() {
    let kick = [("spin", 22.0), ("kick", 0.5)];
    let radial = [&kick[..], &[("damper", 1.0)]].concat();
    let (alone, present) = (washer(&kick), washer(&radial));
    let mut both = washer(&[&radial[..], &[("kept", 1.0), ("kept.damper", 0.0)]].concat());
    let (drawing, mut scale) = (both.draw(1.0, Room::Wide), None);
    for (other, stroke) in [(&alone, Stroke::Pale), (&present, Stroke::Outline)] {
        let curves = drawing.items().iter().filter(|item| item.role == Role::Line(stroke, Hue::Blue));
        let points = curves.filter_map(|item| match &item.shape {
            Shape::Polyline(points) if points.iter().all(|point| point.y > 325.0 && point.x > 437.0) => {
                Some(points)
            }
            _ => None,
        });
        let points = points.max_by_key(|points| points.len()).expect("the curve of swings");
        assert!(points.len() > 100, "{} points", points.len());
        // The plot is 188 px long and 66 px high, and its foot at 392; the axes are one for both.
        let scales: Vec<f64> = (points.iter().step_by(7))
            .map(|point| {
                let time = (point.x - 438.0) / 188.0 * both.duration();
                (392.0 - point.y) / other.reading(time, "shaft")
            })
            .collect();
        let first = *scale.get_or_insert(scales[0]);
        for found in scales {
            close(found / first, 1.0, 0.02, "a swing of the present or of the kept motion");
        }
    }
    assert_eq!(both.words(), present.words());
    assert_eq!(both.reading(2.0, "shaft"), present.reading(2.0, "shaft"));
}

#[test]
fn the_drum_hums_eight_times_a_turn_as_loud_as_the_floor_feels() {
    for (spin, time) in [(10.0, 1.0), (24.9, 3.0), (0.0, 0.0)] {
        let hand = washer(&[("spin", spin), ("kick", 0.5)]);
        let sound = hand.sound(time).expect("a sound");
        close(sound.frequency, 8.0 * spin / TAU, 1e-12, "its pitch");
        close(400.0 * sound.loudness, hand.reading(time, "force"), 0.51, "its loudness");
    }
}

#[test]
fn a_second_kick_acts_on_the_motion_as_it_is() {
    let drum = Drum { spin: 22.0, floor: 3.0, ..Drum::default() };
    let controls = [("spin", 22.0), ("kick", 1.1), ("push", 0.3), ("way", 90.0)];
    let twice = washer(&controls).pressed("kick", &[[0.4, KICK, 0.0]]);
    for end in [0.9_f64, 1.6] {
        let mut state = drum.after(drum.start(), 0.4, end.min(1.1));
        if end > 1.1 {
            state[3] += 0.3;
            state = rk4(|time, state: &[f64; 4]| drum.rates(time, state), 1.1, state, end, 20_000)
                .expect("steps");
        }
        let shaft = 1e3 * state[0].hypot(state[1]);
        close(twice.reading(end, "shaft"), shaft, 0.02, &format!("after {end} s"));
        close(twice.reading(end, "drift"), 0.0, 1e-6, "the balance of momentum");
    }
}

#[test]
fn a_drum_whose_spin_is_changed_goes_on_from_where_it_is() {
    let moved = washer(&[("spin", 10.0)]).moved("spin", 11.3, 6.0);
    close(moved.value("phase"), (6.0 * (10.0 - 11.3_f64)).rem_euclid(TAU), 1e-5, "the load at the beginning");
    let again = moved.moved("spin", 9.0, 2.0);
    close(again.value("phase"), (moved.value("phase") + 2.0 * 2.3).rem_euclid(TAU), 2e-5, "and again");
    close(
        moved.moved("damping", 0.5, 3.0).value("phase"),
        moved.value("phase"),
        0.0,
        "the damping turns nothing",
    );
}

#[test]
fn the_words_say_how_a_kick_fares() {
    for spin in [3.0, 8.0, 9.5, 10.5, 15.0, 22.0, 40.0, 60.0] {
        for damping in [0.1, 0.3, 1.0, 2.4] {
            let [rate, stiff] = [damping * NATURAL, NATURAL * NATURAL - spin * spin];
            let words = washer(&[("spin", spin), ("damping", damping), ("damper", 1.0)]).words();
            // The roots of s⁴ + Γs³ + (2κ + 4Ω²)s² + Γκs + κ² are the eigenvalues of its companion.
            let [a, b, c, d] = [rate, 2.0 * stiff + 4.0 * spin * spin, rate * stiff, stiff * stiff];
            #[rustfmt::skip]
            let companion = Matrix4::new(
                -a, -b, -c, -d,
                1.0, 0.0, 0.0, 0.0,
                0.0, 1.0, 0.0, 0.0,
                0.0, 0.0, 1.0, 0.0,
            );
            let roots = companion.complex_eigenvalues();
            let growth = roots.iter().map(|root| root.re).fold(f64::MIN, f64::max);
            assert_eq!(words.contains("Unstable"), spin > NATURAL, "{spin}, {damping}: {words}");
            assert_eq!(growth > 0.0, spin > NATURAL, "{spin}, {damping}");
            let time = number_behind(&words, "a factor e in ");
            close(time, 1.0 / growth.abs(), 0.01 + 1e-3 / growth.abs(), &words);

            let words = washer(&[("spin", spin), ("damping", damping)]).words();
            let square: f64 = 0.25 * rate * rate - NATURAL * NATURAL;
            let slowest = 0.5 * rate - square.max(0.0).sqrt();
            assert!(words.contains("Stable"), "{words}");
            close(number_behind(&words, "a factor e in "), 1.0 / slowest, 0.0051, &words);
        }
    }
}

#[test]
fn a_kick_with_friction_on_board_is_what_small_steps_give_and_the_words_say_what_becomes_of_it() {
    let mut struck = 0;
    for (spin, damping, board) in
        [(40.0, 0.2, 0.15), (20.0, 0.2, 0.15), (32.0, 0.3, 0.15), (10.3, 0.1, 0.3), (60.0, 0.3, 0.5)]
    {
        let settings = [("spin", spin), ("damping", damping), ("board", board), ("kick", 0.5)];
        let (hand, of) = (washer(&settings), format!("{settings:?}"));
        let drum = Drum { spin, floor: damping * NATURAL, board: board * NATURAL, ..Drum::default() };
        let end = hand.duration();
        for part in [0.3, 0.9] {
            let time = 0.5 + part * (end - 0.5);
            let [x, y, ..] = drum.after(drum.start(), 0.5, time);
            close(hand.reading(time, "shaft"), 1e3 * x.hypot(y), 0.06, &of);
            close(hand.reading(time, "drift"), 0.0, 1e-9, &of);
        }
        let words = hand.words();
        let limit = NATURAL * (1.0 + damping / board);
        assert_eq!(words.contains("Unstable"), spin > limit, "{of}: {words}");
        assert!(words.contains(&format!("beyond {limit:.1}\u{a0}rad/s")), "{of}: {words}");
        if words.contains("strikes its housing") {
            struck += 1;
            assert!(spin > limit);
            close(hand.reading(end, "shaft"), 12e3 * OFFSET, 4.0, "the housing");
        }
    }
    assert_eq!(struck, 2, "the drum swings wide where it whirls");
    // Without damping the swing grows by πb a turn, so it is 12 b wide after 24/ω₀.
    for damper in [0.0, 1.0] {
        let endless = washer(&[("damping", 0.0), ("damper", damper)]);
        close(endless.duration(), 24.0 / NATURAL, 0.1, "the end");
        close(endless.reading(endless.duration(), "shaft"), 12e3 * OFFSET, 4.0, "the housing");
    }
    // Nothing kicked, nothing whirls: the steady circle knows nothing of the friction on board.
    let quiet = washer(&[("spin", 60.0), ("damping", 0.1), ("board", 0.5)]);
    let (radius, _) = Drum { spin: 60.0, floor: 1.0, ..Drum::default() }.steady();
    close(quiet.reading(7.9, "shaft"), 1e3 * radius, 0.051, "a pencil on its point");
    // While it speeds up through its limit there is no closed form.
    let rising = washer(&[("spin", 30.0), ("damping", 0.2), ("board", 0.2), ("motor", 1.0)]);
    close(rising.reading(rising.duration(), "drift"), 0.0, 1e-4, "the balance of momentum");
}

/// Turns a minute and the shaft from O, mm, of a drum that a weak motor turns from rest: Lagrange's equations for the
/// shaft and the angle of the drum in the room, solved for their accelerations at each small step.
fn driven_from_rest([stall, idle, damping]: [f64; 3], end: f64) -> [f64; 2] {
    let (load, arm, inertia) = (2.0, 0.25, 0.5);
    let rates = |_: f64, &[x, y, angle, vx, vy, spin]: &[f64; 6]| {
        let (sin, cos) = angle.sin_cos();
        // (m + M) ẍ − ma sin φ φ̈ = px, (m + M) ÿ + ma cos φ φ̈ = py, (I + ma²) φ̈ + ma (cos φ ÿ − sin φ ẍ) = τ.
        let swing = load * arm * spin * spin;
        let px = -damping * vx - MASS * NATURAL * NATURAL * x + swing * cos;
        let py = -damping * vy - MASS * NATURAL * NATURAL * y + swing * sin;
        let torque = stall * (1.0 - spin / idle);
        let whole = inertia + load * arm * arm - (load * arm).powi(2) / MASS;
        let faster = (torque - load * arm * (cos * py - sin * px) / MASS) / whole;
        let [ax, ay] = [(px + load * arm * sin * faster) / MASS, (py - load * arm * cos * faster) / MASS];
        [vx, vy, spin, ax, ay, faster]
    };
    let state = rk4(rates, 0.0, [0.0; 6], end, 20_000).expect("steps");
    [state[5] * 60.0 / TAU, 1e3 * state[0].hypot(state[1])]
}

#[test]
fn a_weak_motor_is_caught_or_gets_through_as_small_steps_have_it() {
    for (torque, says) in [(4.5, "is caught at its resonance"), (6.0, "gets through its resonance")] {
        let hand = washer(&[("motor", 2.0), ("torque", torque), ("spin", 40.0), ("damping", 0.15)]);
        assert!(hand.words().contains(says), "{}", hand.words());
        for time in [1.3, 4.0, 9.7, 21.0] {
            let [turns, shaft] = driven_from_rest([torque, 40.0, 45.0], time);
            close(hand.reading(time, "turns a minute"), turns, 1.0, "turns a minute");
            close(hand.reading(time, "shaft"), shaft, 0.3, "the shaft");
            close(hand.reading(time, "drift"), 0.0, 1e-6, "the balance of momentum");
        }
    }
}

//! The scene of the laundromat: what it shows, by routes that share no code with it.

use drawing::at;
use fastrand::Rng;
use live::{Moment, Player, Room};
use std::f64::consts::{PI, TAU};

/// The chapter's machine: m + M, b, ω₀ and the scene's kick and acceleration, in SI units.
const MASS: f64 = 30.0;
const OFFSET: f64 = 1.0 / 60.0;
const NATURAL: f64 = 10.0;
const KICK: f64 = 0.4;
const ACCELERATION: f64 = 2.5;

fn washer(settings: &[(&str, f64)]) -> Player {
    let scene = pages::scenes::named("laundromat").expect("a scene");
    Player::new(scene).and_then(|player| player.changed(settings)).expect("the settings have an answer")
}

/// The numbers beside the picture: turns a minute, lead, shaft, centre of mass, force, what is left of the balance.
fn readings(player: &Player, time: f64) -> Vec<f64> {
    let number = |text: &String| {
        let plain =
            text.replace('−', "-").replace("·10<sup>", "e").replace("10<sup>", "1e").replace("</sup>", "");
        let number = plain.trim_end_matches(|c: char| !c.is_ascii_digit());
        number.parse().unwrap_or(f64::NAN)
    };
    player.readings(time).expect("readings").iter().map(number).collect()
}

fn close(found: f64, expected: f64, slack: f64, of: &str) {
    assert!((found - expected).abs() <= slack, "{of}: {found}, and {expected} by the other route");
}

/// How the damper acts: on the whole velocity or on the radius only.
#[derive(Clone, Copy, PartialEq)]
enum Damper {
    Whole,
    Radial,
}

/// [x, y, ẋ, ẏ] after small steps of a method of order two, with the drum speeding up to its spin or at it, and a
/// kick.
fn stepped(
    damper: Damper,
    [spin, damping, acceleration]: [f64; 3],
    mut state: [f64; 4],
    kick: f64,
    end: f64,
) -> [f64; 4] {
    let run_up = if acceleration > 0.0 { spin / acceleration } else { 0.0 };
    let rates = |t: f64, [x, y, vx, vy]: [f64; 4]| {
        // −b d²/dt² of the direction of the load.
        let (angle, rate, change) = if t < run_up {
            (0.5 * acceleration * t * t, acceleration * t, acceleration)
        } else {
            (0.5 * spin * run_up + spin * (t - run_up), spin, 0.0)
        };
        let push = [
            OFFSET * (rate * rate * angle.cos() + change * angle.sin()),
            OFFSET * (rate * rate * angle.sin() - change * angle.cos()),
        ];
        let along = (x * vx + y * vy) / (x * x + y * y).max(1e-30);
        let [dx, dy] = if damper == Damper::Whole { [vx, vy] } else { [along * x, along * y] };
        let square = NATURAL * NATURAL;
        [vx, vy, push[0] - square * x - damping * dx, push[1] - square * y - damping * dy]
    };
    let steps = 400_000;
    let h = end / f64::from(steps);
    let mut kicked = false;
    for n in 0..steps {
        let t = h * f64::from(n);
        if !kicked && t + 0.5 * h >= kick {
            state[2] += KICK;
            kicked = true;
        }
        let k1 = rates(t, state);
        let middle = std::array::from_fn(|i| state[i] + 0.5 * h * k1[i]);
        let k2 = rates(t + 0.5 * h, middle);
        state = std::array::from_fn(|i| state[i] + h * k2[i]);
    }
    state
}

#[test]
fn the_steady_numbers_are_those_of_the_formulas() {
    let mut random = Rng::with_seed(1);
    for _ in 0..100 {
        let spin = (1.0 + 590.0 * random.f64()).round() / 10.0;
        let damping = (15.0 + 235.0 * random.f64()).round() / 100.0;
        let player = washer(&[("spin", spin), ("damping", damping)]);
        let rate = damping * NATURAL;
        let (stiff, drag) = (NATURAL * NATURAL - spin * spin, rate * spin);
        let radius = OFFSET * spin * spin / stiff.hypot(drag);
        let mass = OFFSET * (NATURAL * NATURAL).hypot(drag) / stiff.hypot(drag);
        let found = readings(&player, 8.0 * random.f64());
        let of = format!("{spin} rad/s, {damping}");
        close(found[0], spin * 60.0 / TAU, 0.51, &of);
        close(found[1], drag.atan2(stiff).to_degrees(), 0.51, &of);
        close(found[2], 1e3 * radius, 0.051, &of);
        close(found[3], 1e3 * mass, 0.051, &of);
        close(found[4], MASS * radius * (NATURAL * NATURAL).hypot(drag), 0.51, &of);
        assert!(found[5] < 1e-9, "{of}: {}", found[5]);
    }
}

#[test]
fn a_run_up_with_a_kick_is_what_small_steps_give() {
    for (spin, damping, kick, end) in [(25.0, 0.3, 3.0, 5.0), (20.0, 0.05, 9.0, 11.0), (12.0, 2.2, 1.0, 2.0)]
    {
        let settings = [("spin", spin), ("damping", damping), ("motor", 1.0), ("kick", kick)];
        let player = washer(&settings);
        let [x, y, vx, vy] =
            stepped(Damper::Whole, [spin, damping * NATURAL, ACCELERATION], [0.0; 4], kick, end);
        let found = readings(&player, end);
        let of = format!("{settings:?}");
        close(found[2], 1e3 * x.hypot(y), 0.052, &of);
        let force = (100.0 * x + damping * NATURAL * vx).hypot(100.0 * y + damping * NATURAL * vy);
        close(found[4], MASS * force, 0.6, &of);
        assert!(found[5] < 1e-8, "{of}: {}", found[5]);
    }
}

#[test]
fn a_radial_damper_holds_until_it_is_kicked() {
    let settings = [("spin", 22.0), ("damping", 0.3), ("damper", 1.0)];
    let radius = OFFSET * 22.0 * 22.0 / (22.0 * 22.0 - 100.0);
    let quiet = washer(&settings);
    for time in [0.0, 2.0, 7.9] {
        let found = readings(&quiet, time);
        close(found[2], 1e3 * radius, 0.051, "a pencil on its point");
        close(found[1], 180.0, 0.51, "a pencil on its point");
    }
    let kicked = washer(&[&settings[..], &[("kick", 0.5)]].concat());
    for end in [0.9, 1.6, 3.0] {
        let start = [-radius, 0.0, 0.0, -22.0 * radius];
        let [x, y, ..] = stepped(Damper::Radial, [22.0, 3.0, 0.0], start, 0.5, end);
        let found = readings(&kicked, end);
        close(found[2], 1e3 * x.hypot(y), 0.1, &format!("after {end} s"));
        assert!(found[5] < 1e-2, "{}", found[5]);
    }
}

/// The largest real part of the roots of a polynomial with the leading coefficient 1, by the method of Durand and
/// Kerner.
fn largest_real_part(coefficients: [f64; 4]) -> f64 {
    use nalgebra::Complex;
    let value = |s: Complex<f64>| coefficients.iter().fold(Complex::new(1.0, 0.0), |sum, c| sum * s + c);
    let size = 1.0 + coefficients.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
    let mut roots: [Complex<f64>; 4] =
        std::array::from_fn(|n| Complex::from_polar(size.powf(0.4), 0.4 + TAU * n as f64 / 4.0));
    for _ in 0..500 {
        for n in 0..4 {
            let others: Complex<f64> = (0..4).filter(|m| *m != n).map(|m| roots[n] - roots[m]).product();
            roots[n] -= value(roots[n]) / others;
        }
    }
    roots.iter().map(|s| s.re).fold(f64::MIN, f64::max)
}

/// The time in which a kick changes by a factor e, as the words say it.
fn time_in_words(words: &str) -> f64 {
    let (_, rest) = words.split_once("a factor e in ").unwrap_or_else(|| panic!("{words}"));
    rest.split_whitespace().next().and_then(|text| text.parse().ok()).unwrap_or_else(|| panic!("{words}"))
}

#[test]
fn the_words_say_how_a_kick_fares() {
    for spin in [3.0, 8.0, 9.5, 10.5, 15.0, 22.0, 40.0, 60.0] {
        for damping in [0.1, 0.3, 1.0, 2.4] {
            let [rate, stiff] = [damping * NATURAL, NATURAL * NATURAL - spin * spin];
            let settings = [("spin", spin), ("damping", damping), ("damper", 1.0)];
            let words = washer(&settings).words(0.0);
            let quartic = [rate, 2.0 * stiff + 4.0 * spin * spin, rate * stiff, stiff * stiff];
            let growth = largest_real_part(quartic);
            assert_eq!(words.contains("Unstable"), spin > NATURAL, "{settings:?}: {words}");
            assert_eq!(growth > 0.0, spin > NATURAL, "{settings:?}");
            close(
                time_in_words(&words),
                1.0 / growth.abs(),
                0.01 + 1e-3 / growth.abs(),
                &format!("{settings:?}"),
            );

            let words = washer(&[("spin", spin), ("damping", damping)]).words(0.0);
            let square: f64 = 0.25 * rate * rate - NATURAL * NATURAL;
            let slowest = 0.5 * rate - square.max(0.0).sqrt();
            assert!(words.contains("Stable"), "{words}");
            close(time_in_words(&words), 1.0 / slowest, 0.0051, &words);
        }
    }
}

#[test]
fn the_words_name_the_quietest_spin_and_the_extremes() {
    let words = washer(&[("spin", 30.0)]).words(0.0);
    assert!(words.contains("resonance 25\u{a0}rad/s would be quietest, with 74\u{a0}N"), "{words}");
    let words = washer(&[("spin", 0.0)]).words(0.0);
    assert!(words.contains("stands still"), "{words}");
    // The swing grows by πb a turn, so it is 12 b wide after 24/ω₀.
    for damper in [0.0, 1.0] {
        let endless = washer(&[("damping", 0.0), ("damper", damper)]);
        let words = endless.words(0.0);
        assert!(words.contains("no steady motion") && words.contains("strikes its housing"), "{words}");
        close(endless.run().duration, 24.0 / NATURAL, 0.1, "the end");
        close(readings(&endless, endless.run().duration)[2], 12e3 * OFFSET, 4.0, "the housing");
    }
    assert!(!washer(&[("damping", 2.5), ("spin", 60.0)]).words(0.0).contains("quietest"));
}

#[test]
fn grips_follow_the_hand() {
    for room in [Room::Wide, Room::Narrow] {
        let moment = Moment { time: 2.0, azimuth: -0.5 * PI, elevation: 1.0, room };
        let mut player = washer(&[("spin", 17.3), ("kick", 1.234)]);
        for (grip, control, dx) in
            [(0, "spin", 40.0), (0, "spin", -31.0), (1, "kick", 35.0), (1, "kick", -9.0)]
        {
            player.draw(moment).expect("a picture");
            let grips = player.grips();
            assert_eq!(grips.len(), 2);
            assert_eq!(player.drag(grip, grips[grip]).expect("a touch"), player.values());
            let values = player.drag(grip, grips[grip] + at(dx, 3.0)).expect("a drag");
            let place = player.scene().controls.iter().position(|c| c.name == control).expect("a control");
            for (other, (now, before)) in values.iter().zip(player.values()).enumerate() {
                assert_eq!(now == before, other != place, "{control}");
            }
            let mut drawn = Player::with(player.scene(), values).expect("a scene");
            drawn.draw(moment).expect("a picture");
            close(drawn.grips()[grip].x, grips[grip].x + dx, 1.0, control);
        }
    }
}

/// The distance of the shaft from its steady circle, mm, by small steps of a method of order two for the difference,
/// with friction on board.
fn whirled([spin, floor, board]: [f64; 3], time: f64) -> [f64; 2] {
    let rates = |[x, y, vx, vy]: [f64; 4]| {
        let square = NATURAL * NATURAL;
        [
            vx,
            vy,
            -square * x - floor * vx - board * (vx + spin * y),
            -square * y - floor * vy - board * (vy - spin * x),
        ]
    };
    let mut state = [0.0, 0.0, KICK, 0.0];
    let steps = 200_000;
    let h = time / f64::from(steps);
    for _ in 0..steps {
        let k1 = rates(state);
        let middle = std::array::from_fn(|i| state[i] + 0.5 * h * k1[i]);
        let k2 = rates(middle);
        state = std::array::from_fn(|i| state[i] + h * k2[i]);
    }
    [state[0], state[1]]
}

#[test]
fn a_kick_with_friction_on_board_is_what_small_steps_give_and_the_words_say_what_becomes_of_it() {
    let mut struck = 0;
    for (spin, damping, board) in
        [(40.0, 0.2, 0.15), (20.0, 0.2, 0.15), (32.0, 0.3, 0.15), (10.3, 0.1, 0.3), (60.0, 0.3, 0.5)]
    {
        let settings = [("spin", spin), ("damping", damping), ("board", board), ("kick", 0.5)];
        let player = washer(&settings);
        let of = format!("{settings:?}");
        let [floor, inner] = [damping, board].map(|part| part * NATURAL);
        let (stiff, drag) = (NATURAL * NATURAL - spin * spin, floor * spin);
        let (radius, lead) = (OFFSET * spin * spin / stiff.hypot(drag), drag.atan2(stiff));
        let end = player.run().duration;
        for part in [0.3, 0.9] {
            let time = 0.5 + part * (end - 0.5);
            let [x, y] = whirled([spin, floor, inner], time - 0.5);
            let angle = spin * time - lead;
            let distance = (x + radius * angle.cos()).hypot(y + radius * angle.sin());
            close(readings(&player, time)[2], 1e3 * distance, 0.06, &of);
            assert!(readings(&player, time)[5] < 1e-9, "{of}");
        }
        let words = player.words(0.0);
        let limit = NATURAL * (1.0 + damping / board);
        assert_eq!(words.contains("Unstable"), spin > limit, "{of}: {words}");
        assert!(words.contains(&format!("beyond {limit:.1}\u{a0}rad/s")), "{of}: {words}");
        if words.contains("strikes its housing") {
            struck += 1;
            assert!(spin > limit);
            close(readings(&player, end)[2], 12e3 * OFFSET, 4.0, "the housing");
        }
    }
    assert_eq!(struck, 2, "the drum swings wide where it whirls");
    // Nothing kicked, nothing whirls: the steady circle knows nothing of the friction on board.
    for board in [0.0, 0.5] {
        let quiet = washer(&[("spin", 60.0), ("damping", 0.1), ("board", board)]);
        let radius = OFFSET * 3600.0 / 3500.0_f64.hypot(60.0);
        close(readings(&quiet, 7.9)[2], 1e3 * radius, 0.051, "a pencil on its point");
    }
    // While it speeds up through its limit there is no closed form.
    let settings = [("spin", 30.0), ("damping", 0.2), ("board", 0.2), ("motor", 1.0)];
    let rising = washer(&settings);
    assert!(readings(&rising, rising.run().duration)[5] < 1e-4);
    assert!(washer(&[&settings[..], &[("damper", 1.0)]].concat()).words(0.0).contains("No friction here"));
}

/// Turns a minute and the shaft from O, mm, of a drum that a weak motor turns from rest: Lagrange's equations for the
/// shaft and the angle of the drum in the room, solved for their accelerations at each small step.
fn driven_from_rest([stall, idle, damping]: [f64; 3], end: f64) -> [f64; 2] {
    let (load, arm, inertia) = (2.0, 0.25, 0.5);
    let rates = |[x, y, angle, vx, vy, spin]: [f64; 6]| {
        let (sin, cos) = angle.sin_cos();
        // (m + M) ẍ − ma sin φ φ̈ = px, (m + M) ÿ + ma cos φ φ̈ = py, (I + ma²) φ̈ + ma (cos φ ÿ − sin φ ẍ) = τ.
        let swing = load * arm * spin * spin;
        let px = -damping * vx - MASS * NATURAL * NATURAL * x + swing * cos;
        let py = -damping * vy - MASS * NATURAL * NATURAL * y + swing * sin;
        let torque = stall * (1.0 - spin / idle);
        let whole = inertia + load * arm * arm - (load * arm).powi(2) / MASS;
        let faster = (torque - load * arm * (cos * py - sin * px) / MASS) / whole;
        [
            vx,
            vy,
            spin,
            (px + load * arm * sin * faster) / MASS,
            (py - load * arm * cos * faster) / MASS,
            faster,
        ]
    };
    let mut state = [0.0; 6];
    let steps = (end / 2e-4).round();
    let h = end / steps;
    for _ in 0..steps as u64 {
        let slope = rates(state);
        let middle = rates(std::array::from_fn(|i| state[i] + 0.5 * h * slope[i]));
        state = std::array::from_fn(|i| state[i] + h * middle[i]);
    }
    [state[5] * 60.0 / TAU, 1e3 * state[0].hypot(state[1])]
}

#[test]
fn a_weak_motor_is_caught_or_gets_through_as_small_steps_have_it() {
    for (torque, says) in [(4.5, "is caught at its resonance"), (6.0, "gets through its resonance")] {
        let settings = [("motor", 2.0), ("torque", torque), ("spin", 40.0), ("damping", 0.15)];
        let player = washer(&settings);
        assert!(player.words(0.0).contains(says), "{}", player.words(0.0));
        for time in [1.3, 4.0, 9.7, 21.0] {
            let [turns, shaft] = driven_from_rest([torque, 40.0, 45.0], time);
            let found = readings(&player, time);
            close(found[0], turns, 1.0, "turns a minute");
            close(found[2], shaft, 0.3, "the shaft");
            assert!(found[5] < 1e-6, "the balance of momentum: {}", found[5]);
        }
    }
    let one = washer(&[("motor", 2.0), ("torque", 0.3), ("spin", 40.0), ("damping", 0.15)]);
    assert!(one.words(0.0).contains("rad/s only"), "{}", one.words(0.0));
    for other in [("damper", 1.0), ("board", 0.1), ("spin", 0.0), ("damping", 0.0)] {
        let scene = pages::scenes::named("laundromat").expect("a scene");
        let settings = [("motor", 2.0), ("spin", 40.0), ("damping", 0.3), other];
        let refused = Player::new(scene).and_then(|player| player.changed(&settings));
        assert!(refused.is_err_and(|why| !why.to_string().is_empty()), "{other:?}");
    }
}

#[test]
fn the_quietest_spin_is_not_told_that_another_is_quieter() {
    let scene = pages::scenes::named("laundromat").expect("a scene");
    let preset = scene.presets.iter().find(|preset| preset.words == "quietest").expect("a preset");
    let words = washer(preset.settings).words(0.0);
    assert!(
        words.contains("beyond the resonance no spin is quieter") && !words.contains("would be"),
        "{words}"
    );
    // Steady, the tub goes round at b Ω²/|ω₀² − Ω² + iΓΩ| and the centre of mass with it: the least force beyond ω₀.
    let force = |spin: f64| {
        let (own, damped) = (NATURAL * NATURAL, 0.3 * NATURAL * spin);
        MASS * OFFSET * spin * spin * own.hypot(damped) / (own - spin * spin).hypot(damped)
    };
    let least = (150..=600).map(|tenth| force(0.1 * f64::from(tenth))).fold(f64::INFINITY, f64::min);
    let words = washer(&[("spin", 50.0)]).words(0.0);
    assert!(words.contains(&format!("would be quietest, with {least:.0}\u{a0}N")), "{words}");
}

#[test]
fn a_motor_that_idles_at_rest_is_refused_in_the_words_of_the_scene() {
    let scene = pages::scenes::named("laundromat").expect("a scene");
    let start = Player::new(scene).expect("it begins");
    let said = start.changed(&[("spin", 0.0), ("motor", 2.0)]).err().expect("no motion").to_string();
    assert!(said.contains("turns nothing") && !said.contains("must be"), "{said}");
}

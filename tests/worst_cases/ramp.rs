//! A drum that speeds up or slows down steadily.

use crate::long::long;
use crate::search::{Case, is_long, keeps_its_promise, worse};
use crate::taylor::System;
use crate::transient::{Truth, Units, agreement, damping, hostile, start};
use mechanics::scenes::laundromat::{Ramp, Shaft};

/// The documented error, in units in the last place of what the documentation names.
const UNITS: f64 = 40.0 * f64::EPSILON;

fn truth(damping: f64, spin: f64, acceleration: f64, start: Shaft, time: f64) -> Truth {
    let (mut system, [x, y, vx, vy, c, s, p, p_rate, q, q_rate, turning]) = System::new();
    let [none, one, damping, acceleration] = [0.0, 1.0, damping, acceleration].map(long);
    for (place, rate) in [(x, vx), (y, vy), (p, p_rate), (q, q_rate)] {
        system.rate(place, &[(one, rate)]);
    }
    let [turned_c, turned_s] = [system.product(turning, c), system.product(turning, s)];
    let [inward_c, inward_s] = [system.product(turning, turned_c), system.product(turning, turned_s)];
    system.rate(vx, &[(one, inward_c), (acceleration, s), (-one, x), (-damping, vx)]);
    system.rate(vy, &[(one, inward_s), (-acceleration, c), (-one, y), (-damping, vy)]);
    for (place, rate) in [(p, p_rate), (q, q_rate)] {
        system.rate(rate, &[(-one, place), (-damping, rate)]);
    }
    system.rate(c, &[(-one, turned_s)]);
    system.rate(s, &[(one, turned_c)]);
    let unit = system.constant(one);
    system.rate(turning, &[(acceleration, unit)]);
    let [a, b, d, e] = start.to_array().map(long);
    let from = [a, b, d, e, one, none, one, none, none, one, long(spin)];
    let end = system.sample(&from, &[long(time)]).remove(0);
    let size = |i: usize| end[i].abs().rounded();
    Truth {
        state: [end[0], end[1], end[2], end[3]],
        of_place: [size(6), size(7)],
        of_rate: [size(8), size(9)],
    }
}

#[test]
fn the_ramp_is_exact_to_units_of_the_offset_the_motion_and_what_the_start_makes_of_itself() {
    let ways = [
        "early, after",
        "early, before",
        "real, after",
        "real, before",
        "together, after",
        "together, before",
        "turning, after",
        "turning, before",
    ];
    keeps_its_promise("ramp", 1500, &ways, |draw| {
        let damping = damping(draw);
        let spin = match draw.below(3) {
            0 => draw.beside(1.0),
            1 => -draw.beside(1.0),
            _ => draw.signed(1e-3, 1e2),
        };
        // Where two roots begin to count as next to each other; what is near resonance; anything.
        let half_difference = (1.0 - 0.25 * damping * damping).abs().sqrt();
        let together = (0.5 * damping + half_difference).powi(4) / (8.0 * half_difference).powi(2);
        let size = match draw.below(4) {
            0 => draw.beside(together),
            1 => draw.beside(0.0625),
            _ => draw.decades(1e-12, 1e6),
        };
        let acceleration = size.clamp(1e-12, 1e12) * draw.one_of(&[-1.0, 1.0]);
        let start = start(draw);
        // About the passing of a resonance or of standing still, or a few turns of what is quickest.
        let quickest = 1.0 + spin.abs() + damping + acceleration.abs().sqrt();
        let drift = (spin.abs() - half_difference).hypot(0.5 * damping).max(acceleration.abs().sqrt());
        let side = draw.one_of(&[-1.0, 1.0]);
        let time = match draw.below(6) {
            0 => draw.beside(-spin / acceleration),
            1 => draw.beside((1.0 - spin) / acceleration),
            2 => draw.beside((-1.0 - spin) / acceleration),
            3 => draw.beside(side / drift),
            4 => draw.signed(1e-3, 30.0),
            _ => draw.signed(1e-3, 30.0) / quickest,
        };
        let turned = (spin.abs() + (spin + acceleration * time).abs()) * time.abs();
        if turned + time.abs() > 200.0 || damping * time.abs() > 100.0 {
            return None; // too long for the judge
        }
        Some(case(Units::drawn(draw), damping, spin, acceleration, start, time))
    });
}

/// One motion at one time beside the judge.
fn case(units: Units, damping: f64, spin: f64, acceleration: f64, start: Shaft, time: f64) -> Case {
    let truth = truth(damping, spin, acceleration, start, time);
    let (then, rate) = (time * units.time, acceleration / (units.time * units.time));
    let motion = units.machine(damping, spin).ramp(rate, units.si(start)).expect("a motion");
    let said = |what: &str, ours: Shaft| {
        format!(
            "{units:?}, Γ {damping:?}, Ω {spin:?}, α {acceleration:?}, {start:?}, t {time:?}: {what}, {ours:?}"
        )
    };
    let way = way(damping, spin, acceleration, time);
    let Ok(ours) = motion.at(then) else {
        return Case { ratio: f64::INFINITY, way, said: said("refused", start) };
    };
    let sampled = motion.sample(&[then]).expect("an answer")[0];
    let (ours, sampled) = (units.own(ours), units.own(sampled));

    let fastest = 1.0 + damping + spin.abs() + (spin + acceleration * time).abs() + acceleration.abs().sqrt();
    let [place, rate] = [start.position.norm() + 1.0, start.velocity.norm() + fastest];
    let ([carried, carried_rate], [later, later_rate]) =
        (truth.carried([place, rate]), truth.later(time, damping));
    let sizes = [1.0 + carried + later, fastest + carried_rate + later_rate];
    let (ratio, what) = truth.worst([ours, sampled], sizes, UNITS);
    Case { ratio, way, said: said(what, ours) }
}

#[test]
fn what_was_wrong_once_is_right() {
    let start = Shaft::from_array([0.3, -0.2, 0.1, 0.4]);
    for (damping, spin, acceleration, time) in [
        // Roots next to each other, of which some points of the circle around them count as passed and others do not.
        (2.0, 1.0, 1.0, 0.5),
        (2.0, 1.0, 0.03, 1.0),
        (2.0, 1.0, 0.1, 1.0),
        (0.0, 0.0, 99.0, 0.2),
        (0.0, 0.0, 101.0, 0.2),
        (2.0, 0.0, 4.0, -1.5),
        // A circle too large for what the passing leaves behind.
        (2.0, -0.9999987635375124, -188.31281433609968, 0.23049927375860316),
        // A slow ramp that starts in its resonance.
        (0.0, 1.0, 1e-12, 10.0),
        (1e-6, -0.9999, -1e-9, -20.0),
    ] {
        for start in [Shaft::AT_REST, start] {
            let case = case(Units::SI, damping, spin, acceleration, start, time);
            assert!(case.ratio < 1.0, "{:.3} of the promise: {}", case.ratio, case.said);
        }
    }
}

/// Which form the library takes.
fn way(damping: f64, spin: f64, acceleration: f64, time: f64) -> &'static str {
    let half_difference = (1.0 - 0.25 * damping * damping).abs().sqrt();
    let drift = (spin.abs() - half_difference).hypot(0.5 * damping).max(acceleration.abs().sqrt());
    if damping < 2.0 && drift <= 0.25 && time.abs() < 1.0 / drift {
        return if time < 0.0 { "early, before" } else { "early, after" };
    }
    let largest = 0.5 * damping + half_difference;
    let width = acceleration.abs().sqrt().max(0.5 * damping).max(half_difference);
    match (largest * largest > 8.0 * half_difference * width, damping < 2.0, time < 0.0) {
        (true, _, false) => "together, after",
        (true, _, true) => "together, before",
        (false, true, false) => "turning, after",
        (false, true, true) => "turning, before",
        (false, false, false) => "real, after",
        (false, false, true) => "real, before",
    }
}

#[test]
fn the_ramp_is_as_exact_where_no_integrator_comes() {
    let cases: serde_json::Value = serde_json::from_str(include_str!("../data/ramp.json")).unwrap();
    let mut worst = (0.0, String::new());
    let cases = cases.as_array().unwrap();
    assert_eq!(cases.len(), 240);
    for case in cases {
        let number = |name: &str| case[name].as_f64().unwrap();
        let numbers = |name: &str| -> [f64; 4] {
            std::array::from_fn(|i| {
                let value = &case[name][i];
                value.as_f64().unwrap_or_else(|| value.as_str().unwrap().parse().unwrap())
            })
        };
        let [damping, spin, acceleration, time] = ["damping", "spin", "acceleration", "time"].map(number);
        let (state, free, start) = (numbers("state"), numbers("free"), Shaft::from_array(numbers("start")));
        let ours = Units::SI.machine(damping, spin).ramp(acceleration, start).unwrap().at(time);
        let ours = ours.unwrap_or_else(|error| panic!("{error}: {case}"));
        let fastest =
            1.0 + damping + spin.abs() + (spin + acceleration * time).abs() + acceleration.abs().sqrt();
        let [place, rate] = [start.position.norm() + 1.0, start.velocity.norm() + fastest];
        let places = 1.0 + state[0].hypot(state[1]) + place * free[0] + rate * free[2];
        let rates = fastest + state[2].hypot(state[3]) + place * free[1] + rate * free[3];
        for (i, size) in [places, places, rates, rates].into_iter().enumerate() {
            let ratio = (ours.to_array()[i] - state[i]).abs() / size / UNITS;
            if worse(ratio, worst.0) > worst.0 {
                worst = (worse(ratio, worst.0), format!("{i} of {case}: {ours:?}"));
            }
        }
    }
    println!("ramp, far away: {:.3} of the promise at {}", worst.0, worst.1);
    assert!(worst.0 < 1.0, "{worst:?}");
}

#[test]
fn every_ramp_answers_at_its_start() {
    keeps_its_promise("start of a ramp", 20_000, &["any"], |draw| {
        let damping = if draw.below(2) == 0 { draw.unit(49) } else { damping(draw) };
        let spin = draw.unit(49) * draw.one_of(&[-1.0, 0.0, 1.0]);
        let acceleration = draw.decades(1e-12, 1e12) * draw.one_of(&[-1.0, 1.0]);
        let start = start(draw);
        let ours = Units::SI.machine(damping, spin).ramp(acceleration, start).expect("a motion").at(0.0);
        let size = 1.0 + start.position.norm();
        let ratio = ours.map_or(f64::INFINITY, |ours| (ours.position - start.position).norm() / size / UNITS);
        let said = format!("Γ {damping:?}, Ω {spin:?}, α {acceleration:?}: {ours:?}");
        Some(Case { ratio, way: "any", said })
    });
}

#[test]
fn no_ramp_answers_with_what_is_no_number_and_a_sample_refuses_what_one_does() {
    if !is_long() {
        return; // machines of no scene: for the night
    }
    keeps_its_promise("hostile ramp", 10_000, &["answered", "refused"], |draw| {
        let (machine, start, times) = hostile(draw)?;
        let acceleration = machine.natural_frequency().powi(2) * draw.decades(1e-12, 1e12);
        let motion = machine.ramp(acceleration * draw.one_of(&[-1.0, 1.0]), start).ok()?;
        let (ratio, way) = agreement(&motion, &times);
        Some(Case { ratio, way, said: format!("{machine:?}, {acceleration:?}, {start:?}, {times:?}") })
    });
}

#[test]
fn times_beyond_reach_are_refused_one_by_one_and_many_at_once() {
    let refused = |ramp: &Ramp, t: f64| {
        let alone = ramp.at(t).map(|_| ());
        assert_eq!(ramp.sample(&[t]).map(|_| ()), alone, "{t}");
        alone.is_err()
    };
    // Without damping every time has an answer.
    for (spin, acceleration) in [(1.5, 0.02), (1.5, -0.02), (1e3, 1e-12)] {
        let ramp = Units::SI
            .machine(0.0, spin)
            .ramp(acceleration, Shaft::from_array([0.7, -0.4, -0.3, 0.9]))
            .unwrap();
        for t in [1e7, -1e7, 2e8, 1e12, -1e20] {
            assert!(!refused(&ramp, t), "{t}");
        }
    }
    // With it, before the start, as long as what has grown backwards is a number. There |v + ½Γz|² + ω₁²|z|² grows by
    // e a second.
    let size = |shaft: Shaft| {
        let [z, v] = [shaft.position, shaft.velocity].map(|part| part * 1e-280);
        ((v + z * 0.5).norm_sqr() + 0.75 * z.norm_sqr()).ln()
    };
    for (spin, acceleration) in [(0.0, 0.5), (3.0, 0.5), (3.0, 0.01)] {
        let ramp = Units::SI
            .machine(1.0, spin)
            .ramp(acceleration, Shaft::from_array([0.7, -0.4, -0.3, 0.9]))
            .unwrap();
        let mut last = size(ramp.at(-1200.0).unwrap());
        let mut answered = 0;
        for t in 1201..2000 {
            if refused(&ramp, -f64::from(t)) {
                continue;
            }
            assert_eq!(t, 1201 + answered, "an answer behind a refusal");
            answered += 1;
            let now = size(ramp.at(-f64::from(t)).unwrap());
            assert!((now - last - 1.0).abs() < 1e-9, "{t}: {now} after {last}");
            last = now;
        }
        assert!((90..250).contains(&answered), "{answered}");
    }
}

//! A drum that speeds up: the closed form against integration, its own symmetries, and what theory says of slow sweeps.

use crate::{machine, start};
use mechanics::integrate::Dop853;
use mechanics::scenes::laundromat::{InvalidRamp, Machine, Shaft};
use mechanics::{InvalidFrames, InvalidQuantity};
use nalgebra::Complex;
use std::f64::consts::PI;

/// The largest difference from an integration to 1e-13 a step, over the size of the motion, at times after or before the start.
fn departure(machine: &Machine, acceleration: f64, times: &[f64]) -> f64 {
    let ramp = machine.ramp(acceleration, start()).unwrap();
    let rates = |t: f64, y: &[f64; 4]| machine.ramp_rates(acceleration, t, y);
    let (judge, _) = Dop853::new(1e-13).unwrap().sample(rates, 0.0, start().to_array(), times).unwrap();
    let mut worst = 0.0_f64;
    for (&t, judge) in times.iter().zip(judge) {
        let ours = ramp.at(t).unwrap().to_array();
        // A velocity of the drum's spin times b is the scale of velocities.
        let size = 1.0 + ramp.spin(t).abs() + judge.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let difference = ours.iter().zip(judge).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size;
        worst = worst.max(difference);
    }
    worst
}

const DAMPINGS: [f64; 11] = [0.0, 1e-4, 0.01, 0.3, 1.5, 1.999, 2.0 - 1e-9, 2.0, 2.0 + 1e-6, 2.1, 8.0];

#[test]
fn the_closed_form_is_the_integrated_motion() {
    let after: Vec<f64> = (0..=30).map(|n| 1.7 * f64::from(n)).collect();
    let before: Vec<f64> = (0..=8).map(|n| -0.5 * f64::from(n)).collect();
    let mut runs = 0;
    for damping in DAMPINGS {
        for spin in [0.0, 0.6, -2.0, 3.0] {
            for acceleration in [0.003, 0.02, 0.5, -0.05, -0.7] {
                for times in [&after, &before] {
                    let error = departure(&machine(damping, spin), acceleration, times);
                    assert!(error < 4e-11, "Γ {damping}, Ω {spin}, α {acceleration}: {error:e}");
                    runs += 1;
                }
            }
        }
    }
    assert_eq!(runs, 440);
}

#[test]
fn frames_at_once_are_the_frames_one_by_one() {
    let mut random = fastrand::Rng::with_seed(93);
    for damping in DAMPINGS {
        for (spin, acceleration) in [(0.0, 0.01), (3.0, 0.01), (0.2, -0.5), (0.0, 1e-4), (-1.0, 7.0)] {
            let ramp = machine(damping, spin).ramp(acceleration, start()).unwrap();
            let mut times: Vec<f64> = (0..75).map(|_| 120.0 * random.f64() - 3.0).collect();
            times[40] = 3e4; // after any but the lightest damping
            let mut frames = vec![Shaft::AT_REST; times.len()];
            ramp.fill(&times, &mut frames).unwrap();
            for (frame, &t) in frames.iter().zip(&times) {
                let single = ramp.at(t).unwrap();
                let size = 1.0 + ramp.spin(t).abs() + single.position.norm() + single.velocity.norm();
                let away =
                    (frame.position - single.position).norm() + (frame.velocity - single.velocity).norm();
                assert!(away < 1e-14 * size, "Γ {damping}, Ω {spin}, α {acceleration}, t {t}: {away:e}");
            }
        }
    }
}

#[test]
fn the_motion_goes_through_its_start() {
    for damping in DAMPINGS {
        for (spin, acceleration) in [(0.0, 0.01), (0.99, 1e-5), (50.0, -0.01), (0.0, 1e-9), (3.0, 1e9)] {
            let begin = machine(damping, spin).ramp(acceleration, start()).unwrap().at(0.0).unwrap();
            let away =
                (begin.position - start().position).norm() + (begin.velocity - start().velocity).norm();
            assert!(away < 1e-13 * (1.0 + spin), "Γ {damping}, Ω {spin}, α {acceleration}: {away:e}");
        }
    }
}

#[test]
fn a_slow_sweep_without_damping_leaves_the_amplitude_of_lewis_behind() {
    // Long after resonance the shaft circles the place where the load has centred itself, with b ω₀ √(π/2α); on the way it
    // overshoots by Fresnel's 1.1706, at ω₀ + 2.157 √α, both in the limit of slow sweeps.
    let (mut overshoots, mut places) = (Vec::new(), Vec::new());
    for acceleration in [2e-2, 1e-3, 1e-5] {
        let machine = machine(0.0, 0.0);
        let ramp = machine.ramp(acceleration, Shaft::AT_REST).unwrap();
        let left = (PI / (2.0 * acceleration)).sqrt();
        let late = 60.0 / acceleration;
        // Two frames a quarter of a free period apart give the amplitude of the free circle.
        let swing = |t: f64| {
            let angle = Complex::new(0.0, 0.5 * acceleration * t * t).exp();
            ramp.at(t).unwrap().position + angle
        };
        let amplitude = 0.5 * (swing(late) - swing(late + PI)).norm();
        assert!((amplitude / left - 1.0).abs() < 3e-3, "{acceleration}: {amplitude} for {left}");
        let excursion = |spin: f64| ramp.at(spin / acceleration).unwrap().position.norm();
        let spins = (0..40_000).map(|n| 1.0 + 6.0 * acceleration.sqrt() * f64::from(n) / 40_000.0);
        let (spin, largest) =
            spins.map(|spin| (spin, excursion(spin))).fold((0.0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
        overshoots.push(largest / left);
        places.push((spin - 1.0) / acceleration.sqrt());
    }
    println!("{overshoots:?} {places:?}");
    assert!((overshoots[0] - 1.257).abs() < 1e-3, "{overshoots:?}");
    assert!((overshoots[2] - 1.1706).abs() < 3e-3, "{overshoots:?}");
    assert!((places[2] - 2.157).abs() < 0.02, "{places:?}");
}

#[test]
fn a_drum_at_full_speed_runs_down_as_it_ran_up() {
    // The same motion told backwards: from the state at a late time, with the signs of velocity and spin reversed.
    let (acceleration, late) = (0.04, 70.0);
    let up = machine(0.0, 0.0).ramp(acceleration, start()).unwrap();
    let top = up.at(late).unwrap();
    // The load's direction at that time is the new x axis.
    let turn = Complex::from_polar(1.0, 0.5 * acceleration * late * late);
    let begin = Shaft { position: top.position / turn, velocity: -top.velocity / turn };
    let down = machine(0.0, -acceleration * late).ramp(acceleration, begin).unwrap();
    for back in [1.0, 20.0, 45.0, 70.0] {
        let (a, b) = (up.at(late - back).unwrap(), down.at(back).unwrap());
        assert!((a.position - b.position * turn).norm() < 2e-12, "{back}");
        assert!((a.velocity + b.velocity * turn).norm() < 2e-12, "{back}");
    }
}

#[test]
fn the_spin_is_the_rate_of_the_loads_angle() {
    for spin in [0.0, 0.6, -2.0] {
        for acceleration in [0.5, -0.05] {
            let machine = machine(0.3, spin);
            let ramp = machine.ramp(acceleration, start()).unwrap();
            for t in [-3.0, 0.0, 0.7, 40.0] {
                assert!(
                    (ramp.spin(t) - (spin + acceleration * t)).abs() < 1e-15 * (1.0 + t.abs()),
                    "{spin} {t}"
                );
            }
        }
    }
}

#[test]
fn a_speed_that_hardly_changes_is_a_steady_one() {
    for (damping, spin) in [(0.2, 0.7), (0.01, 3.0), (3.0, 1.0), (2.0, 0.5)] {
        let steady = machine(damping, spin).transient(start()).unwrap();
        let ramp = machine(damping, spin).ramp(1e-12, start()).unwrap();
        for t in [0.0, 3.0, 20.0] {
            let (a, b) = (steady.at(t).unwrap(), ramp.at(t).unwrap());
            // The angle differs by αt²/2, 2e-10 at the last time.
            assert!((a.position - b.position).norm() < 2e-9, "{damping} {spin} {t}: {a:?} {b:?}");
        }
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let machine = machine(0.1, 1.0);
    for (acceleration, message) in [
        (f64::NAN, "angular acceleration NaN rad/s² is not a finite number"),
        (
            0.0,
            "angular acceleration over the square of the natural frequency 0 is too small; it must be at least 1e-12",
        ),
        (
            1e-13,
            "angular acceleration over the square of the natural frequency 1e-13 is too small; it must be at least 1e-12",
        ),
        (
            -1e13,
            "angular acceleration over the square of the natural frequency 1e13 is too large; it must be at most 1e12",
        ),
    ] {
        let error = machine.ramp(acceleration, Shaft::AT_REST).unwrap_err();
        assert!(matches!(error, InvalidRamp::Acceleration(InvalidQuantity { .. })));
        assert_eq!(error.to_string(), message);
    }
    let lost = Shaft { position: Complex::new(f64::INFINITY, 0.0), ..Shaft::AT_REST };
    assert!(matches!(machine.ramp(1.0, lost), Err(InvalidRamp::Start(_))));
    let ramp = machine.ramp(0.01, Shaft::AT_REST).unwrap();
    assert!(ramp.at(f64::NAN).is_err() && ramp.at(1e12).is_err() && ramp.at(-1e6).is_err());
    let mut frames = [Shaft::AT_REST; 2];
    assert!(matches!(ramp.fill(&[1.0], &mut frames), Err(InvalidFrames::Length { times: 1, frames: 2 })));
    assert!(matches!(ramp.fill(&[1.0, f64::NAN], &mut frames), Err(InvalidFrames::Time { index: 1, .. })));
}

#[test]
fn times_beyond_reach_are_refused_one_by_one_and_many_at_once() {
    let refused = |ramp: &mechanics::scenes::laundromat::Ramp, t: f64| {
        let alone = ramp.at(t).is_err();
        assert_eq!(ramp.fill(&[t], &mut [Shaft::AT_REST]).is_err(), alone, "{t}");
        alone
    };
    // Without damping as long as the load's angle can be reduced.
    for acceleration in [0.02, -0.02] {
        let ramp = machine(0.0, 1.5).ramp(acceleration, start()).unwrap();
        for t in [1e7, -1e7] {
            assert!(!refused(&ramp, t) && refused(&ramp, 20.0 * t), "{t}");
        }
    }
    let turning = machine(0.0, 1e3).ramp(1e-12, start()).unwrap();
    assert!(refused(&turning, 1e12));
    let message = "at time 1e12 s the drum has made more turns than can be told apart, some 1e13";
    assert_eq!(turning.at(1e12).unwrap_err().to_string(), message);
    // With it, before the start, as long as what has grown backwards is a number. There |v + ½Γz|² + ω₁²|z|² grows by e a second.
    let size = |shaft: Shaft| {
        let [z, v] = [shaft.position, shaft.velocity].map(|part| part * 1e-280);
        ((v + z * 0.5).norm_sqr() + 0.75 * z.norm_sqr()).ln()
    };
    for (spin, acceleration) in [(0.0, 0.5), (3.0, 0.5), (3.0, 0.01)] {
        let ramp = machine(1.0, spin).ramp(acceleration, start()).unwrap();
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

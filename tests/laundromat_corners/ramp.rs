//! A drum that speeds up: its symmetries, what theory says of slow sweeps, and what is refused.

use crate::{machine, start};
use mechanics::scenes::laundromat::{Ramp, Shaft};
use nalgebra::Complex;
use std::f64::consts::PI;

#[test]
fn a_slow_sweep_without_damping_leaves_the_amplitude_of_lewis_behind() {
    // Long after resonance the shaft circles the place where the load has centred itself, with b ω₀ √(π/2α); on the
    // way it overshoots by Fresnel's 1.1706, at ω₀ + 2.157 √α, both in the limit of slow sweeps.
    let (mut overshoots, mut places) = (Vec::new(), Vec::new());
    for acceleration in [2e-2, 1e-3, 1e-5] {
        let machine = machine(0.0, 0.0);
        let ramp = machine.ramp(acceleration, Shaft::AT_REST).unwrap();
        let left = (PI / (2.0 * acceleration)).sqrt();
        let late = 60.0 / acceleration;
        // Two states half a free period apart give the amplitude of the free circle.
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
        assert_eq!(error.to_string(), message);
    }
    let lost = Shaft { position: Complex::new(f64::INFINITY, 0.0), ..Shaft::AT_REST };
    assert_eq!(machine.ramp(1.0, lost).unwrap_err().quantity, "x of the start");
    let ramp = machine.ramp(0.01, Shaft::AT_REST).unwrap();
    assert!(ramp.at(f64::NAN).is_err() && ramp.at(1e51).is_err() && ramp.at(-1e6).is_err());
    assert!(ramp.sample(&[]).unwrap().is_empty() && ramp.sample(&[1.0, f64::NAN]).is_err());
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
        let ramp = machine(0.0, spin).ramp(acceleration, start()).unwrap();
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

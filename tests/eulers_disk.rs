//! Euler's disk on a film of air: the Taylor series against the rates, the rates against a rolling wheel's, and what is lost.

use mechanics::InvalidFrames;
use mechanics::integrate::{Dop853, Failure, InvalidTolerance, Taylor};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::spinning_coin::{EulersDisk, NoSinking, Sinking};
use std::f64::consts::{FRAC_PI_2, TAU};

const A: f64 = 0.04;
const G: f64 = 9.81;
/// Let go from rest.
const REST: Sinking = Sinking {
    tilt: 0.5,
    tilt_rate: 0.0,
    across: 0.0,
    along: 0.0,
    heading: 0.0,
    spin: 0.0,
    contact: [0.0; 2],
};

fn disk(film: f64) -> EulersDisk {
    EulersDisk::new(A, 0.5, G, film).expect("a disk")
}

/// A disk that wobbles strongly as it rolls.
fn rough() -> Sinking {
    Sinking {
        tilt: 0.8,
        tilt_rate: 3.0,
        across: 9.0,
        along: -14.0,
        heading: 0.7,
        spin: -0.4,
        contact: [0.1, -0.3],
    }
}

fn largest_difference(a: &Sinking, b: &Sinking) -> f64 {
    let scale = (G / A).sqrt();
    let units = [1.0, scale, scale, scale, 1.0, 1.0, A, A];
    let pairs = a.to_array().into_iter().zip(b.to_array()).zip(units);
    pairs.map(|((a, b), unit)| ((a - b) / unit).abs()).fold(0.0, f64::max)
}

#[test]
fn the_series_is_the_integration_of_the_rates() {
    let times: Vec<f64> = (0..=40).map(|n| 0.05 * f64::from(n)).collect();
    for (film, start) in [(0.0, rough()), (0.02, rough()), (1e-4, disk(0.0).steady(0.3).unwrap())] {
        let disk = disk(film);
        let ours = disk.sample(&start, &times, 1e-16).unwrap();
        let rates = |t: f64, y: &[f64; 8]| disk.rates(t, y);
        let (judge, _) = Dop853::with_tolerances(1e-14, 1e-15)
            .unwrap()
            .sample(rates, 0.0, start.to_array(), &times)
            .unwrap();
        for (n, judge) in judge.into_iter().enumerate() {
            let error = largest_difference(&ours[n], &Sinking::from_array(judge));
            // Headings reach a hundred radians, of which the judge keeps twelve digits.
            assert!(error < 2e-11, "film {film}, time {}: {error:e}", times[n]);
        }
    }
}

#[test]
fn a_tighter_tolerance_gives_a_smaller_error_down_to_rounding() {
    let disk = disk(1e-4);
    let start = disk.steady(0.3).unwrap();
    let times = [1.0, 2.0, 2.9]; // it ends at 2.95 s
    let exact = disk.sample(&start, &times, 1e-17).unwrap();
    let error = |tolerance: f64| {
        let frames = disk.sample(&start, &times, tolerance).unwrap();
        (0..3).map(|n| largest_difference(&frames[n], &exact[n])).fold(0.0, f64::max)
    };
    let errors = [1e-5, 1e-8, 1e-11].map(error);
    assert!(errors[0] > 30.0 * errors[1] && errors[1] > 30.0 * errors[2], "{errors:?}");
    assert!(errors[0] < 1e-2 && errors[2] < 1e-9, "{errors:?}");
}

#[test]
fn without_a_film_the_disk_is_the_rolling_wheel() {
    // The wheel's axes 1 and 3 are the disk's, reversed; its lean is measured from the upright and its place by the centre.
    let (disk, wheel) = (disk(0.0), Wheel::new(2.0, A, 0.5, G).unwrap());
    let s = rough();
    let [_, w1, w2, w3, ..] = s.to_array();
    let ours = disk.rates(0.0, &s.to_array());
    let theirs = wheel.rates(0.0, &[FRAC_PI_2 - s.tilt, -w1, w2, -w3, s.heading + TAU / 2.0, 0.0, 0.0, 0.0]);
    for (ours, theirs) in [
        (ours[0], -theirs[0]),
        (ours[1], -theirs[1]),
        (ours[2], theirs[2]),
        (ours[3], -theirs[3]),
        (ours[4], theirs[4]),
        (ours[5], -theirs[5]),
    ] {
        assert!((ours - theirs).abs() < 1e-12 * theirs.abs().max(1.0), "{ours} {theirs}");
    }
}

#[test]
fn the_contact_keeps_a_radius_from_the_centre_along_the_slope() {
    // The centre, found from the wheel's own equations, and the contact, found from ours, stay a radius apart.
    let (disk, wheel) = (disk(0.0), Wheel::new(2.0, A, 0.5, G).unwrap());
    let start = rough();
    let [_, w1, w2, w3, ..] = start.to_array();
    let [x, y] = centre(&start);
    let begin = [FRAC_PI_2 - start.tilt, -w1, w2, -w3, start.heading + TAU / 2.0, 0.0, x, y];
    let judge =
        Dop853::new(1e-14).unwrap().solve(|t, y: &[f64; 8]| wheel.rates(t, y), 0.0, begin, 3.0).unwrap();
    let ours = centre(&disk.sample(&start, &[3.0], 1e-16).unwrap()[0]);
    assert!(
        (ours[0] - judge.state[6]).abs() < 1e-11 && (ours[1] - judge.state[7]).abs() < 1e-11,
        "{ours:?} {judge:?}"
    );
}

#[test]
fn the_energy_that_is_lost_is_the_work_of_the_film() {
    let disk = disk(0.01);
    let rate = (G / A).sqrt();
    // With the film's power as a ninth variable.
    let rates = |t: f64, y: &[f64; 9]| {
        let state: [f64; 8] = std::array::from_fn(|i| y[i]);
        let dot = disk.rates(t, &state);
        let torque = 0.01 * A * A * rate / y[0].sin().powi(3);
        let power = torque * (y[1] * y[1] + y[2] * y[2]);
        std::array::from_fn(|i| if i < 8 { dot[i] } else { power })
    };
    let start = rough();
    let begin: [f64; 9] = std::array::from_fn(|i| if i < 8 { start.to_array()[i] } else { 0.0 });
    let end = Dop853::new(1e-13).unwrap().solve(rates, 0.0, begin, 2.0).unwrap().state;
    let ours = disk.sample(&start, &[2.0], 1e-16).unwrap()[0];
    let lost = disk.energy_over_mass(&start) - disk.energy_over_mass(&ours);
    assert!(lost > 0.05 && (lost / end[8] - 1.0).abs() < 1e-10, "{lost} {}", end[8]);
    // And without a film none is.
    let free = self::disk(0.0);
    let late = free.sample(&start, &[50.0], 1e-16).unwrap()[0];
    let change = free.energy_over_mass(&late) / free.energy_over_mass(&start) - 1.0;
    assert!(change.abs() < 1e-13, "{change:e}");
}

#[test]
fn the_cube_of_the_tilt_falls_in_proportion_to_the_time() {
    // Moffatt's law: the energy 3/2 g a sin β is lost at the rate 4K ga√(g/a)/β².
    // The law leaves out what is of the order of β²: the difference of β and sin β, and the spin about the axle (below).
    let mut departures = Vec::new();
    for tilt in [0.2, 0.1, 0.05] {
        let film = 1e-3 * tilt * tilt * tilt;
        let disk = disk(film);
        let start = disk.steady(tilt).unwrap();
        let end = tilt.powi(3) / (8.0 * film) * (A / G).sqrt();
        let times: Vec<f64> = (0..=8).map(|n| 0.1 * f64::from(n) * end).collect();
        let frames = disk.sample(&start, &times, 1e-14).unwrap();
        let departure = |(frame, t): (&Sinking, &f64)| frame.tilt / (tilt * (1.0 - t / end).cbrt()) - 1.0;
        departures.push(frames.iter().zip(&times).map(departure).fold(0.0, |a: f64, b| a.max(b.abs())));
    }
    println!("{departures:?}");
    let [far, near, nearest] = departures[..] else { panic!("three tilts") };
    assert!(
        far < 0.05 && (3.0..5.0).contains(&(far / near)) && (3.0..5.0).contains(&(near / nearest)),
        "{departures:?}"
    );
}

/// Where the centre is over the table.
fn centre(s: &Sinking) -> [f64; 2] {
    let ((sin, cos), level) = (s.heading.sin_cos(), A * s.tilt.cos());
    [s.contact[0] - sin * level, s.contact[1] + cos * level]
}

/// Radius of the circle that the centre draws in the next round of the contact, from its places alone.
fn circle(disk: &EulersDisk, begin: &Sinking) -> f64 {
    let round = TAU * begin.tilt.sin() / begin.across; // 2π/Ω, since ω₂ = Ω sin β
    let times: Vec<f64> = (0..64).map(|n| round * f64::from(n) / 64.0).collect();
    let places: Vec<[f64; 2]> = disk.sample(begin, &times, 1e-14).unwrap().iter().map(centre).collect();
    let mean = |i: usize| places.iter().map(|place| place[i]).sum::<f64>() / 64.0;
    let middle = [mean(0), mean(1)];
    let radius = |place: &[f64; 2]| (place[0] - middle[0]).hypot(place[1] - middle[1]);
    places.iter().map(radius).sum::<f64>() / 64.0
}

#[test]
fn the_circle_of_a_sinking_disk_opens_and_closes_again() {
    // Sinking slowly through steady motions: (1 + C) dω₃ = ω₂ dβ with ω₂ = 2√β, and b = aω₃/Ω with Ω = 2/√β, in units of g and a.
    for (tilt, film) in [(0.1_f64, 1e-7), (0.05, 1e-8)] {
        let disk = disk(film);
        let start = disk.steady(tilt).unwrap();
        let life = tilt.powi(3) / (8.0 * film) * (A / G).sqrt();
        let times: Vec<f64> = (4..=38).rev().map(|n| (1.0 - (0.025 * f64::from(n)).powi(3)) * life).collect();
        let (mut widest, mut at, mut last) = (0.0, 0.0, (0.0, 0.0));
        for frame in disk.sample(&start, &times, 1e-14).unwrap() {
            let (now, radius) = (frame.tilt, circle(&disk, &frame));
            let law = 4.0 / 9.0 * A * (tilt.powf(1.5) * now.sqrt() - now * now);
            assert!((radius / law - 1.0).abs() < 0.03, "{radius} m for {law} m at {now}");
            if radius > widest {
                (widest, at) = (radius, now / tilt);
            }
            last = (radius, now / tilt);
        }
        // It opens until two fifths of the tilt are left, 4^{−2/3}, and closes from there on.
        assert!((at - 0.397).abs() < 0.03, "{at}");
        assert!((widest / (0.21 * A * tilt * tilt) - 1.0).abs() < 0.03, "{widest}");
        assert!(last.0 < 0.85 * widest && last.1 < 0.2, "{last:?} after {widest} m");
    }
}

#[test]
fn a_disk_that_sinks_has_the_turn_that_its_spin_asks_for() {
    let disk = disk(1e-5);
    let start = disk.steady(0.2).unwrap();
    let times: Vec<f64> = (1..=9).map(|n| 10.0 * f64::from(n) * (A / G).sqrt()).collect();
    let frames = disk.sample(&start, &times, 1e-14).unwrap();
    for frame in &frames {
        // Sinking turns some of the spin into the axle. With that spin the steady balance, A cot β ω₂² − (1 + C) ω₃ω₂ = (g/a)
        // cos β, gives ω₂.
        let (sin, cos) = frame.tilt.sin_cos();
        let (a, b) = (0.25 * cos / sin, -1.5 * frame.along);
        let steady = (-b + (b * b + 4.0 * a * cos * G / A).sqrt()) / (2.0 * a);
        assert!((frame.across / steady - 1.0).abs() < 0.003, "{} {steady}", frame.across);
        assert!(frame.along < 0.0);
    }
}

#[test]
fn the_viscosity_of_air_takes_the_power_that_moffatt_found() {
    let (mass, radius, viscosity) = (0.4, 0.0375, 1.78e-5);
    let disk = EulersDisk::in_air(mass, radius, G, viscosity).unwrap();
    let tilt: f64 = 1e-3;
    let s = disk.steady(tilt).unwrap();
    let rate = (G / radius).sqrt();
    let power = disk.film() * mass * radius * radius * rate * s.across * s.across / tilt.sin().powi(3);
    let moffatt = std::f64::consts::PI * viscosity * G * radius * radius / (tilt * tilt);
    assert!((power / moffatt - 1.0).abs() < 1e-5, "{power} W for {moffatt} W");
}

#[test]
fn the_disk_can_be_followed_back() {
    let disk = disk(0.003);
    let start = rough();
    let ahead = disk.sample(&start, &[1.5], 1e-16).unwrap()[0];
    let back = disk.sample(&ahead, &[-0.7, -1.5], 1e-16).unwrap();
    assert!(largest_difference(&back[1], &start) < 1e-10);
    let between = disk.sample(&start, &[0.8], 1e-16).unwrap()[0];
    assert!(largest_difference(&back[0], &between) < 1e-10);
}

#[test]
fn the_table_never_lets_go_in_this_model() {
    // Sinking to a fraction of the tilt, where the steady law has long given up; the second is the toy of the shops.
    let unit = (A / G).sqrt();
    for (film, tilt, share) in [(1e-5, 0.1, 0.02), (8.1e-8, 0.02, 0.02), (1e-3, 0.4, 0.02)] {
        let disk = disk(film);
        let start = disk.steady(tilt).unwrap();
        let life = f64::powi(tilt, 3) / (8.0 * film) * unit;
        let (mut least, mut lowest, mut time) = (f64::INFINITY, tilt, 0.0);
        let mut now = start;
        while lowest > share * tilt && time < 4.0 * life {
            // Steps as short as the motion is fast.
            let step = 0.02 / (G / (A * now.tilt.sin())).sqrt();
            let [before, here, after] = <[Sinking; 3]>::try_from(
                disk.sample(&now, &[0.999 * step, step, 1.001 * step], 1e-14).unwrap(),
            )
            .unwrap();
            // The table carries the weight and what lifts the centre, whose height is a sin β.
            let heights = [before, here, after].map(|s| A * s.tilt.sin());
            let lift = (heights[0] - 2.0 * heights[1] + heights[2]) / (1e-3 * step).powi(2);
            let support = disk.support_over_weight(&here);
            assert!((support - 1.0 - lift / G).abs() < 0.02, "{support} and {}", 1.0 + lift / G);
            (now, least, lowest, time) = (here, least.min(support), lowest.min(here.tilt), time + step);
        }
        assert!(lowest < share * tilt, "the disk has sunk to {lowest}");
        assert!((0.7..0.8).contains(&least), "{least}");
    }
}

#[test]
fn the_centre_of_a_steady_disk_rests_above_the_origin() {
    let disk = disk(0.0);
    for tilt in [0.05, 0.7, 1.4] {
        let start = disk.steady(tilt).unwrap();
        for s in disk.sample(&start, &[0.0, 0.1, 0.33], 1e-16).unwrap() {
            // From the contact the centre lies a cos β to the left of axis 1.
            let (sin, cos) = s.heading.sin_cos();
            let [x, y] = [s.contact[0] - sin * A * s.tilt.cos(), s.contact[1] + cos * A * s.tilt.cos()];
            assert!(x.hypot(y) < 1e-13 * A, "tilt {tilt}: {x} {y}");
        }
    }
}

#[test]
fn the_table_carries_what_lifts_the_centre() {
    // N/mg = 1 + z̈/g with the height z = a sin β, from three moments of the motion.
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for film in [0.0, 0.02] {
        let disk = disk(film);
        let h = 3e-4 * (A / G).sqrt();
        for n in 1..40 {
            let t = 0.002 * f64::from(n);
            let frames = disk.sample(&rough(), &[t - h, t, t + h], 1e-17).unwrap();
            let [before, now, after] = [0, 1, 2].map(|i| A * frames[i].tilt.sin());
            let lifted = 1.0 + (after - 2.0 * now + before) / (h * h) / G;
            let found = disk.support_over_weight(&frames[1]);
            assert!(
                (found - lifted).abs() < 1e-5 * (1.0 + found.abs()),
                "film {film}, {t} s: {found}, {lifted}"
            );
            let centrifugal = A / G * frames[1].tilt_rate.powi(2) * frames[1].tilt.sin();
            (least, most) = (least.min(centrifugal), most.max(centrifugal));
        }
    }
    assert!(least < 1e-3 && most > 0.03, "the square of the rate takes part: {least} to {most}");
}

#[test]
fn what_lies_past_the_end_is_refused_at_once() {
    // At once: in less than the hundred thousand series after which it would be `Integration`, a fraction of a second.
    let toy = EulersDisk::in_air(0.4, 0.0375, G, 1.78e-5).unwrap();
    let start = toy.steady(0.1).unwrap();
    let mut frames = [start; 3];
    let refused = toy.fill(&start, &[95.8, 96.0, 1e9], 1e-13, &mut frames).unwrap_err();
    let InvalidFrames::Time { index: 1, error: NoSinking::Over { time, tilt } } = refused else {
        panic!("{refused}")
    };
    // Moffatt's law gives it 95.37 s; near the end it is the slower, as the disk falls no faster than g lets it.
    assert!((95.8..96.0).contains(&time), "{refused}");
    assert!((tilt.sin() / (toy.film() / 500.0).powf(0.4) - 1.0).abs() < 0.1, "{refused}");
    // All turning has died out by then.
    assert!(frames[0].across.abs() < 1e-8 && frames[0].tilt > tilt);
    assert!(refused.to_string().contains("the motion ends at 95.8"), "{refused}");
    // Right after the end there is nothing, right before there is; it does not hang on the tolerance.
    assert!(toy.sample(&start, &[time - 1e-3], 1e-16).is_ok());
    assert!(matches!(toy.sample(&start, &[time + 1e-3], 1e-9), Err(NoSinking::Over { .. })));

    // Films as thick as glue, and as thin as nothing; disks held from the start, and from rest.
    for film in [1e-30, 1e-6, 1e-3, 1.0, 1e30] {
        for tilt in [1e-4, 1.5] {
            let disk = disk(film);
            for start in [disk.steady(tilt).unwrap(), Sinking { tilt, ..REST }] {
                let refused = disk.sample(&start, &[1e20], 1e-13).unwrap_err();
                let held = film > 500.0 * tilt.sin().powf(2.5);
                match refused {
                    NoSinking::Over { time, .. } => assert_eq!(time == 0.0, held, "{film} {tilt}: {refused}"),
                    NoSinking::Integration(Failure::TooMuchWork { evaluations, .. }) => {
                        assert!(evaluations == 100_000 && film < 1e-3 && !held, "{film} {tilt}: {refused}");
                    }
                    _ => panic!("{refused}"),
                }
                assert_eq!(disk.sample(&start, &[0.0], 1e-13).unwrap(), [start]);
            }
        }
    }
}

#[test]
fn a_motion_is_given_up_after_so_many_series_as_the_caller_says() {
    let disk = disk(0.0);
    let (start, mut frame) = (disk.steady(0.01).unwrap(), [REST]);
    let by = |most: usize, frame: &mut [Sinking]| {
        disk.fill_by(&start, &[100.0], &Taylor::new(1e-13).unwrap().with_max_expansions(most), frame)
    };
    let refused = by(1000, &mut frame).unwrap_err();
    assert!(
        matches!(refused, InvalidFrames::Time { index: 0, error: NoSinking::Integration(_) }),
        "{refused}"
    );
    assert!(by(1_000_000, &mut frame).is_ok() && (frame[0].tilt - 0.01).abs() < 1e-9);
    for tolerance in [2.0, 1e300] {
        let refused = disk.sample(&start, &[1.0], tolerance).unwrap_err();
        assert!(matches!(refused, NoSinking::Tolerance(InvalidTolerance::TooLoose { .. })), "{refused}");
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let message = |error: &dyn std::fmt::Display| error.to_string();
    let new = EulersDisk::new;
    assert_eq!(
        message(&new(0.0, 0.5, G, 0.0).unwrap_err()),
        "radius 0 m is not positive; it must be more than zero"
    );
    assert_eq!(
        message(&new(A, 1.5, G, 0.0).unwrap_err()),
        "moment factor k 1.5 is too large; it must be at most 1"
    );
    assert_eq!(
        message(&new(A, 0.5, G, -1e-5).unwrap_err()),
        "film number K -1e-5 is negative; it must be zero or more"
    );
    assert!(EulersDisk::in_air(0.0, A, G, 1e-5).is_err() && EulersDisk::in_air(1.0, A, G, -1.0).is_err());
    let disk = disk(1e-3);
    assert!(disk.steady(0.0).is_err() && disk.steady(2.0).is_err() && disk.steady(f64::NAN).is_err());
    let start = disk.steady(0.1).unwrap();
    let flat = Sinking { tilt: 0.0, ..start };
    assert!(matches!(disk.sample(&flat, &[1.0], 1e-12), Err(NoSinking::Quantity(_))));
    assert!(matches!(disk.sample(&start, &[1.0], 0.0), Err(NoSinking::Tolerance(_))));
    assert!(matches!(disk.sample(&start, &[0.2, 0.1], 1e-12), Err(NoSinking::Time { time: 0.1 })));
    assert!(matches!(disk.sample(&start, &[f64::NAN], 1e-12), Err(NoSinking::Time { .. })));
    assert_eq!(
        message(&disk.sample(&start, &[0.1, -0.1], 1e-12).unwrap_err()),
        "time 0.1 s must be finite, and the times must run from 0 s in one direction"
    );
    let mut frames = [start; 3];
    assert!(matches!(
        disk.fill(&start, &[0.1, 0.2], 1e-12, &mut frames),
        Err(InvalidFrames::Length { times: 2, frames: 3 })
    ));
    assert_eq!(disk.sample(&start, &[0.0, 0.0], 1e-12).unwrap(), vec![start; 2]);
    assert_eq!(disk.sample(&start, &[], 1e-12).unwrap(), vec![]);
}

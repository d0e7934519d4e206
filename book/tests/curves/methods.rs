//! The chapter on methods: factors by formulas, errors by methods written out here, slopes where the text claims them.

use crate::constrained::step;
use crate::{PIXELS, curve, lies_on};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// Attitude as w, x, y, z, and angular velocity along the body's axes.
type Book = [f64; 7];

const MOMENTS: [f64; 3] = [1.0, 1.6, 2.1];
const START: Book = [1.0, 0.0, 0.0, 0.0, 0.7, 0.9, 0.5];

fn rates(_: f64, [w, x, y, z, a, b, c]: Book) -> Book {
    let [i1, i2, i3] = MOMENTS;
    let turn = [-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a];
    let [p, q, r, s] = turn.map(|part| 0.5 * part);
    [p, q, r, s, (i2 - i3) / i1 * b * c, (i3 - i1) / i2 * c * a, (i1 - i2) / i3 * a * b]
}

fn rk4(start: Book, duration: f64, steps: u32) -> Book {
    (0..steps).fold(start, |book, _| step(rates, 0.0, book, duration / f64::from(steps)))
}

/// A turn about axis 1, 2 or 3 (0, 1, 2) as if only that axis' part of the energy were there: the plain
/// splitting's turn.
fn turn([w, x, y, z, a, b, c]: Book, axis: usize, rate: f64, time: f64) -> Book {
    let mut momentum = [MOMENTS[0] * a, MOMENTS[1] * b, MOMENTS[2] * c];
    let angle = rate * momentum[axis] * time;
    let (sin, cos) = (0.5 * angle).sin_cos();
    let mut n = [0.0; 3];
    n[axis] = sin;
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let (p, q) = (momentum[j], momentum[k]);
    momentum[j] = angle.cos() * p + angle.sin() * q;
    momentum[k] = angle.cos() * q - angle.sin() * p;
    [
        w * cos - x * n[0] - y * n[1] - z * n[2],
        x * cos + w * n[0] + y * n[2] - z * n[1],
        y * cos + w * n[1] + z * n[0] - x * n[2],
        z * cos + w * n[2] + x * n[1] - y * n[0],
        momentum[0] / MOMENTS[0],
        momentum[1] / MOMENTS[1],
        momentum[2] / MOMENTS[2],
    ]
}

/// Strang’s splitting with the turn about the momentum inside each step.
fn strang(start: Book, duration: f64, steps: u32) -> Book {
    let h = duration / f64::from(steps);
    let [i1, i2, i3] = MOMENTS;
    (0..steps).fold(start, |book, _| {
        let book = turn(book, 0, 1.0 / i1 - 1.0 / i2, 0.5 * h);
        let book = turn(book, 2, 1.0 / i3 - 1.0 / i2, h);
        let [w, x, y, z, a, b, c] = turn(book, 0, 1.0 / i1 - 1.0 / i2, 0.5 * h);
        // About L at the rate L/I₂.
        let spin = [i1 * a / i2, b, i3 * c / i2];
        let size = (spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2]).sqrt();
        let (sin, cos) = (0.5 * size * h).sin_cos();
        let n = spin.map(|part| part / size * sin);
        [
            w * cos - x * n[0] - y * n[1] - z * n[2],
            x * cos + w * n[0] + y * n[2] - z * n[1],
            y * cos + w * n[1] + z * n[0] - x * n[2],
            z * cos + w * n[2] + x * n[1] - y * n[0],
            a,
            b,
            c,
        ]
    })
}

/// The book after a duration, s, in so many steps.
type Program = fn(Book, f64, u32) -> Book;

/// The angle between two attitudes, rad, by the chord of their quaternions after norming; small angles only.
fn attitude_error(a: Book, b: Book) -> f64 {
    let norm = |q: Book| q[..4].iter().map(|part| part * part).sum::<f64>().sqrt();
    let (size_a, size_b) = (norm(a), norm(b));
    let chord = (0..4).map(|i| (a[i] / size_a - b[i] / size_b).powi(2)).sum::<f64>().sqrt();
    4.0 * (0.5 * chord).asin()
}

fn energy([.., a, b, c]: Book) -> f64 {
    MOMENTS[0] * a * a + MOMENTS[1] * b * b + MOMENTS[2] * c * c
}

/// Time of a round of the polhode, s, which goes about axis 1: Landau & Lifshitz, *Mechanics*, §37, with `K`
/// by the arithmetic-geometric mean.
fn round() -> f64 {
    let [i1, i2, i3] = MOMENTS;
    let [.., a, b, c] = START;
    let square = (i1 * a).powi(2) + (i2 * b).powi(2) + (i3 * c).powi(2);
    let twice = energy(START);
    assert!(square < twice * i2);
    let rate = ((i2 - i1) * (i3 * twice - square) / (i1 * i2 * i3)).sqrt();
    let parameter = (i3 - i2) * (square - twice * i1) / ((i2 - i1) * (i3 * twice - square));
    let (mut mean, mut geometric) = (1.0_f64, (1.0 - parameter).sqrt());
    for _ in 0..40 {
        (mean, geometric) = (0.5 * (mean + geometric), (mean * geometric).sqrt());
    }
    4.0 * FRAC_PI_2 / mean / rate
}

#[test]
fn the_factors_of_the_amplitude_are_those_of_their_polynomials() {
    lies_on("method-amplitude", "rk4", |z| (1.0 - z.powi(6) / 72.0 + z.powi(8) / 576.0).sqrt());
    let euler = curve("method-amplitude", "euler");
    for z in [0.1, 0.37, 0.71, 1.13] {
        assert!(euler.distance((z, f64::hypot(1.0, z))) < PIXELS, "Euler at {z}");
    }
    // The product of DOP853's stages agrees with e^{iz} to z⁸: no loss to be seen below 2, and one again at 5.96.
    let dop853 = curve("method-amplitude", "dop853");
    for at in [(1.0, 1.0), (1.9, 1.0), (5.9604, 1.0)] {
        assert!(dop853.distance(at) < PIXELS, "DOP853 at {at:?}");
    }
    // The mark stands where the curve of RK4 passes one.
    let rk4 = curve("method-amplitude", "rk4");
    assert!(rk4.distance((2.0 * SQRT_2, 1.0)) < PIXELS);
}

#[test]
fn the_errors_of_rk4_and_of_the_splitting_are_those_of_programs_written_twice() {
    let exact = rk4(START, 30.0, 12_000);
    let mut checked = 0;
    for n in 7..=15 {
        let steps = (10.0 * 3000_f64.powf(f64::from(n) / 24.0)).round() as u32;
        for (name, found) in [("rk4", rk4(START, 30.0, steps)), ("strang", strang(START, 30.0, steps))] {
            let error = attitude_error(found, exact);
            let off = curve("method-order", name).distance((30.0 / f64::from(steps), error));
            assert!(off < PIXELS, "{name}, {steps} steps: {error:e}");
            checked += 1;
        }
    }
    assert_eq!(checked, 18);
}

#[test]
fn energy_and_attitude_begin_as_programs_written_twice_say() {
    let part = round() / 5.0;
    let run: [(&str, Program, u32); 2] = [("rk4", rk4, 24), ("strang", strang, 48)];
    for (name, method, steps) in run {
        let (mut book, mut exact) = (START, START);
        let mut worst = (0.0_f64, 0.0_f64);
        for look in 1..=15 {
            book = method(book, part, steps);
            exact = rk4(exact, part, 2000);
            worst.0 = worst.0.max((energy(book) / energy(START) - 1.0).abs());
            worst.1 = worst.1.max(attitude_error(book, exact));
            if look % 5 == 0 {
                let rounds = f64::from(look / 5);
                for (figure, error) in [("method-energy", worst.0), ("method-attitude", worst.1)] {
                    let off = curve(figure, name).distance((rounds, error));
                    assert!(off < PIXELS, "{figure} {name}: {off} px off after {rounds} rounds");
                }
            }
        }
    }
}

#[test]
fn errors_grow_as_the_text_says() {
    let slope = |figure, name, from: f64, to: f64| {
        let curve = curve(figure, name);
        (curve.value(to) / curve.value(from)).ln() / (to / from).ln()
    };
    for (name, expected) in [("rk4", 1.0), ("dop853", 1.0), ("strang", 0.0), ("blanes-moan", 0.0)] {
        let found = slope("method-energy", name, 50.0, 9000.0);
        assert!((found - expected).abs() < 0.03, "energy of {name}: {found}");
    }
    for (name, to, expected) in
        [("rk4", 300.0, 2.0), ("dop853", 9000.0, 2.0), ("strang", 90.0, 1.0), ("blanes-moan", 9000.0, 1.0)]
    {
        let found = slope("method-attitude", name, to / 5.0, to);
        assert!((found - expected).abs() < 0.15, "attitude of {name}: {found}");
    }
    // Hundreds of times better at the beginning, worse at the end.
    let [first, last] = [1.5, 9000.0].map(|x| {
        curve("method-attitude", "blanes-moan").value(x) / curve("method-attitude", "dop853").value(x)
    });
    assert!(first > 200.0 && last < 0.3, "{first} {last}");
}

#[test]
fn the_steps_of_the_hoop_tile_the_time_and_follow_its_tumbles() {
    let h = 0.005;
    let hoop = |_: f64, [a, b, c]: [f64; 3]| [-b * c, c * a, 0.5 * a * b];
    let angle = 89.9_f64.to_radians();
    let mut motion = vec![[angle.sin() / 3.0, -angle.cos(), 0.0]];
    for n in 0..30_000 {
        motion.push(step(hoop, 0.0, motion[n], h));
    }
    lies_on("method-steps", "tangent", |time| {
        let n = (time / h) as usize;
        step(hoop, 0.0, motion[n], time - h * n as f64)[0]
    });
    // A marker stands at the middle of its step, as high as the step is long: neighbours touch.
    let steps = curve("method-steps", "steps").values();
    let touching = steps.windows(2).filter(|pair| {
        let gap = pair[1].0 - pair[0].0 - 0.5 * (pair[0].1 + pair[1].1);
        gap.abs() < 0.02
    });
    // Thinning takes a few points out of the line.
    assert!(touching.count() * 10 > steps.len() * 8, "{steps:?}");
    let shortest = |from: f64, to: f64| {
        let within = steps.iter().filter(|(time, _)| (from..to).contains(time));
        within.map(|step| step.1).fold(f64::INFINITY, f64::min)
    };
    assert!(shortest(10.0, 20.0) > 2.0 && shortest(24.0, 34.0) < 1.5 && shortest(50.0, 70.0) > 2.5);
    // About one in each flip, and four times as long at most, as its description says.
    let longest = steps.iter().map(|step| step.1).fold(0.0, f64::max);
    assert!((shortest(24.0, 34.0) - 1.15).abs() < 0.1 && (longest - 4.4).abs() < 0.2, "{longest}");
}

#[test]
fn the_steps_on_a_circle_go_by_their_factors() {
    // One step multiplies by 1 + iz, or 1 + iz − z²/2.
    let h = std::f64::consts::TAU / 16.0;
    for (name, real) in [("euler", 1.0), ("midpoint", 1.0 - 0.5 * h * h)] {
        let path = curve("method-circle", name);
        let (mut x, mut y) = (1.0, 0.0);
        for step in 1..=16 {
            (x, y) = (real * x - h * y, real * y + h * x);
            assert!(path.distance((x, y)) < PIXELS, "{name}, step {step}");
        }
        let radius = f64::hypot(x, y);
        let expected = if name == "euler" { 3.15 } else { 1.05 }; // what the caption says
        assert!((radius - expected).abs() < 0.01, "{name} ends at {radius}");
    }
}

#[test]
fn every_method_of_the_library_has_a_look() {
    for method in mechanics::integrate::METHODS {
        assert!(figures::Look::of(method.name).is_some(), "{} has no look", method.name);
    }
}

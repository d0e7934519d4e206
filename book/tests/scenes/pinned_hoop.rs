//! The scene of "The pinned hoop" against Euler's equations, stepped, and the laws of the snap.

use crate::hand::{Hand, number_behind};
use drawing::{Fill, Hue, Point, Role, Room, Shape};
use fastrand::Rng;
use mechanics::integrate::{Direction, Dop853, Outcome};

/// Moments of a hoop and a disc of mass and radius one about a point of their rims.
const MOMENTS: [[f64; 3]; 2] = [[1.5, 0.5, 2.0], [1.25, 0.25, 1.5]];

fn scene(settings: &[(&str, f64)]) -> Hand {
    Hand::with("pinned-hoop", settings)
}

/// When ω₁ vanishes after the snap, by Euler's equations.
fn first_tumble([i1, i2, i3]: [f64; 3], degrees_to_go: f64) -> f64 {
    let (height, from_axis) = degrees_to_go.to_radians().sin_cos();
    let rates = |_: f64, [w1, w2, w3]: &[f64; 3]| {
        [(i2 - i3) / i1 * w2 * w3, (i3 - i1) / i2 * w3 * w1, (i1 - i2) / i3 * w1 * w2]
    };
    // What is left of the rotation about the tangent is I_d/I₁, and I_d = I₂.
    let start = [i2 / i1 * from_axis, -height, 0.0];
    let solver = Dop853::new(1e-12).expect("a solver");
    let end = solver.solve_until(rates, 0.0, start, 1e4, |_, omega| omega[0], Direction::Falling);
    let Ok(Outcome::Event(end)) = end else { panic!("it never tumbles from {degrees_to_go}°") };
    end.time
}

#[test]
fn it_waits_as_long_as_eulers_equations_do() {
    let mut random = Rng::with_seed(89);
    for n in 0..24 {
        let (shape, gap) = (n % 2, 1e-3 * 3e4_f64.powf(random.f64()));
        let hand = scene(&[("gap", gap), ("shape", shape as f64)]);
        let wait = first_tumble(MOMENTS[shape], gap);
        // It keeps its answer to itself until it has turned over.
        assert!(hand.words_at(0.99 * wait).contains("For how long?"), "{}", hand.words_at(0.99 * wait));
        let words = hand.words_at(1.01 * wait);
        let later = first_tumble(MOMENTS[shape], 0.1 * gap) - wait;
        for (behind, expected) in
            [("turns over after", wait), ("then every", 2.0 * wait), ("it would wait", later)]
        {
            assert!(
                (number_behind(&words, behind) - expected).abs() < 0.0502,
                "{behind} {expected}: {words}"
            );
        }
        for (part, turned) in [(0.99, 0.0), (1.01, 1.0), (2.99, 1.0), (3.01, 2.0)] {
            let reading = |words: &str| hand.reading(part * wait, words);
            assert_eq!(reading("times"), turned, "{gap}: {part} of {wait}");
            assert!(
                reading("drift of the energy").abs() < 1e-13 && reading(r"drift of $\boldsymbol{L}") < 1e-13
            );
        }
        // After half the period it is upside down, as far as it was upright.
        let angle = |time: f64| hand.reading(time, "angle");
        assert!((angle(0.0) + angle(2.0 * wait) - 180.0).abs() < 0.21, "{gap}");
    }
    let exact = scene(&[("exact", 1.0)]);
    assert_eq!(exact.reading(exact.duration(), "angle"), 0.0);
}

#[test]
fn the_snap_takes_the_energy_that_its_law_says() {
    for (shape, kept) in [(0.0, 1.0 / 3.0), (1.0, 0.2), (2.0, 2.0 / 7.0)] {
        for gap in [0.01, 30.0, 60.0, 90.0_f64] {
            let found = scene(&[("gap", gap), ("shape", shape)]).reading(1.0, "energy");
            let expected = 100.0 * gap.to_radians().cos().powi(2) * (1.0 - kept);
            assert!((found - expected).abs() < 0.0501, "{shape} {gap}: {found}");
        }
    }
}

#[test]
fn the_plot_keeps_what_the_reader_has_waited_for() {
    let places = |hand: &mut Hand, time: f64| -> Vec<Point> {
        let drawing = hand.draw(time, Room::Wide);
        let plot = drawing.axes()[0].frame.grown(1.0);
        let dots = drawing.items().iter().filter(|item| item.role == Role::Area(Fill::Solid, Hue::Pink));
        let dots = dots.filter_map(|item| match item.shape {
            Shape::Circle { centre, .. } if plot.contains(centre) => Some(centre),
            _ => None,
        });
        dots.collect()
    };
    let mut hand = scene(&[("gap", 10.0)]);
    let wait = first_tumble(MOMENTS[0], 10.0);
    assert_eq!(places(&mut hand, 0.0).len(), 1, "the pin, which begins to climb");
    assert_eq!(places(&mut hand, 0.9 * wait).len(), 1, "nothing is measured yet");
    let reached = places(&mut hand, 1.1 * wait)[0];
    // At another angle the place that it has reached stays; without waiting, nothing comes to it.
    let mut nearer = hand.changed(&[("gap", 1.0)]);
    assert!(places(&mut nearer, 0.0).contains(&reached));
    let mut hand = nearer.changed(&[("gap", 0.1)]);
    assert_eq!(places(&mut hand, 300.0).len(), 2);
    let mut hand = hand.changed(&[("gap", 0.01)]);
    assert_eq!(places(&mut hand, 0.0).len(), 2, "a leap through time measures nothing");
    // A disc waits otherwise.
    assert_eq!(places(&mut hand.changed(&[("shape", 1.0)]), 0.0).len(), 1);
}

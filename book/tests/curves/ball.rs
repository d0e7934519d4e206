//! The ball: curves lie on formulas that are written out here.

use crate::{curve, lies_on};
use std::f64::consts::{PI, TAU};

const G: f64 = 9.81;

#[test]
fn a_masse_is_a_parabola_and_then_a_straight_line() {
    // v₀ = (3, 0), w₀ = (−4, 3): u₀ = (7, −3).
    let (speed, brake) = (58_f64.sqrt(), 0.2 * G);
    let end = 2.0 * speed / (7.0 * brake);
    let [push_x, push_y] = [-7.0 / speed * brake, 3.0 / speed * brake];
    let time = |x: f64| (-3.0 + (9.0 + 2.0 * push_x * x).sqrt()) / push_x;
    let (x1, y1) = (3.0 * end + 0.5 * push_x * end * end, 0.5 * push_y * end * end);
    let slope = push_y * end / (3.0 + push_x * end);
    lies_on("ball-masse", "slides", |x| if x < x1 { 0.5 * push_y * time(x).powi(2) } else { f64::NAN });
    // The picture ends after 2.2 s.
    let last = x1 + (3.0 + push_x * end) * (2.2 - end);
    lies_on("ball-masse", "rolls", |x| if x > x1 && x < last { y1 + slope * (x - x1) } else { f64::NAN });
}

#[test]
fn the_circles_have_one_size_and_one_point_in_common() {
    for n in 0..5 {
        let circle = curve("ball-circles", &format!("circle-{n}"));
        let (sin, cos) = (TAU * f64::from(n) / 5.0 + 0.3).sin_cos();
        // Round r₀ + ẑ × v₀/λ, with λ = 2 rad/s and v₀ = 0.5 m/s.
        for k in 0..40 {
            let (s, c) = (TAU * f64::from(k) / 40.0).sin_cos();
            let place = (0.3 - 0.25 * sin + 0.25 * c, 0.1 + 0.25 * cos + 0.25 * s);
            assert!(circle.distance(place) < 0.15, "{n}: {place:?}");
        }
    }
}

#[test]
fn the_drift_is_a_cycloid() {
    let path = curve("ball-drifts", "path");
    let rate = 12.0 / 7.0;
    let drift = 2.5 * G * 2_f64.to_radians().sin() / 6.0;
    for k in 0..60 {
        let angle = 6.0 * PI * f64::from(k) / 60.0;
        let place = (drift / rate * (angle - angle.sin()), -drift / rate * (1.0 - angle.cos()));
        assert!(path.distance(place) < 0.15, "{place:?}");
    }
}

#[test]
fn a_ball_in_a_hole_swings_as_a_cosine() {
    let rate = 1.0 / (0.054 - 0.021_35);
    let share = (2.0_f64 / 7.0).sqrt();
    let middle = 100.0 * 2.5 * G / (rate * rate);
    lies_on("ball-swing", "level", |rounds| -middle * (1.0 - (share * TAU * rounds).cos()));
    let push = 100.0 * 0.3 / (share * rate);
    lies_on("ball-swing", "pushed", |rounds| {
        let angle = share * TAU * rounds;
        let height = -middle * (1.0 - angle.cos()) - push * angle.sin();
        // It ends where it is up at the rim.
        if angle < TAU && height < 0.0 { height } else { f64::NAN }
    });
}

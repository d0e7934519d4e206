//! A pendulum: a mass on a rod, which swings as widely as you like.

use std::f64::consts::{FRAC_PI_2, TAU};

/// A mass on a rod that weighs nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pendulum {
    /// The length of the rod, m.
    pub length: f64,
    /// The strength of gravity, m/s².
    pub gravity: f64,
}

/// The steps of an arithmetic–geometric mean: the last mean, and of each step half the difference over the mean.
fn means(mut one: f64, mut other: f64) -> (f64, Vec<f64>) {
    let mut steps = Vec::new();
    while (one - other).abs() > 1e-15 * one {
        let difference = 0.5 * (one - other);
        (one, other) = (0.5 * (one + other), (one * other).sqrt());
        steps.push(difference / one);
    }
    (one, steps)
}

impl Pendulum {
    /// How fast the phase of small swings runs, rad/s: eq:pendulum-small.
    pub fn rate(&self) -> f64 {
        (self.gravity / self.length).sqrt()
    }

    /// The period of swings of an amplitude below π, rad: eq:pendulum-period.
    pub fn period(&self, amplitude: f64) -> f64 {
        TAU / (self.rate() * means(1.0, (0.5 * amplitude).cos()).0)
    }

    /// The angle at a time after the turning point, rad: the sine of half of it is an elliptic function.
    pub fn angle(&self, amplitude: f64, time: f64) -> f64 {
        let (mean, steps) = means(1.0, (0.5 * amplitude).cos());
        let phase = f64::exp2(steps.len() as f64) * (mean * self.rate() * time + FRAC_PI_2);
        let phase = steps.iter().rev().fold(phase, |phase, step| 0.5 * (phase + (step * phase.sin()).asin()));
        2.0 * ((0.5 * amplitude).sin() * phase.sin()).asin()
    }
}

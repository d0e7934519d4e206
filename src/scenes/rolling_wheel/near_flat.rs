//! A wheel that is almost flat.
//!
//! There the lean is all but π/2, and its last digit is larger than the changes that matter. So the tilt from lying flat,
//! `α = π/2 − θ`, takes its place.

use super::wheel::Wheel;
use std::f64::consts::PI;

impl Wheel {
    /// The rates of `[α, α̇, q, n, φ, ψ, x, y]`: the numbers of [`super::Rolling`] with the tilt α from lying flat, rad, between 0 and
    /// π, and its rate in place of the lean and its rate (`eq:lean-acceleration`, `eq:spin-rates`, `eq:rolling-path`).
    ///
    /// The same motion as by [`Wheel::rates`], and the way to step it near flat: with the lean an integrator gets lost in the
    /// rounding of π/2 when the least tilt is below about a millionth. Infinite or NaN for a flat wheel.
    pub fn rates_by_tilt(&self, _time: f64, state: &[f64; 8]) -> [f64; 8] {
        let &[tilt, tilt_rate, q, n, heading, ..] = state;
        let (sin, cos) = tilt.sin_cos();
        let (i1, i3) = (0.5 * self.factor, self.factor);
        let turn_rate = q / sin;
        let p = turn_rate * cos;
        let fall = self.gravity / self.radius * cos - (1.0 + i3) * n * q - i1 * p * q;
        let (s, c) = heading.sin_cos();
        let (forward, outward) = (-self.radius * n, self.radius * tilt_rate * sin);
        [
            tilt_rate,
            -fall / (1.0 + i1),
            -tilt_rate * (p + n * i3 / i1),
            -tilt_rate * q / (1.0 + i3),
            turn_rate,
            n + p,
            forward * c - outward * s,
            forward * s + outward * c,
        ]
    }

    /// The angle, rad, by which the contact runs round when the wheel is let go almost flat, falls, just misses lying flat and
    /// gets up again: `π√(1 + 2/k)`, in the limit of a near miss (`eq:near-flat-turn`). To 2 units in the last place.
    pub fn near_flat_turn(&self) -> f64 {
        PI * (1.0 + 2.0 / self.factor).sqrt()
    }
}

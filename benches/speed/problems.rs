//! The problems of the report "Speed and accuracy": their equations, their reference values and what "error" means.
//!
//! The bench, its peers and the tests share this file. It knows nothing of `mechanics`: what it says is the
//! judge. All numbers are without units; parameters, starts and times are exact doubles.

use serde_json::Value;

/// A problem with `N` numbers in its state: where it starts, when samples are wanted, and what they should be.
#[derive(Debug, Clone)]
pub(crate) struct Problem<const N: usize> {
    /// Its name in the data.
    pub name: &'static str,
    /// The state at time zero.
    pub start: [f64; N],
    /// The times of the samples, the first of them zero.
    pub times: Vec<f64>,
    norm: Norm,
    kept: Vec<Kept<N>>,
}

/// A sample with a reference value: its place, and the value as an unevaluated sum.
#[derive(Debug, Clone)]
struct Kept<const N: usize> {
    index: usize,
    high: [f64; N],
    low: [f64; N],
}

/// How a state is compared.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Norm {
    /// The largest absolute difference of a component.
    Largest,
    /// Angular velocity and quaternion: the larger of `|δω|` and the angle of the rotation between the attitudes.
    Turning,
}

/// The names of all problems, in the order of the report.
pub(crate) const NAMES: [&str; 10] =
    ["washer", "ramp", "hoop", "separatrix", "disk", "rest", "toss", "station", "drag", "top"];

/// The washing machine, ω₀ = b = 1, Γ = 0.01, Ω = 3, from rest; x, y, ẋ, ẏ of the shaft at the end of each of
/// 200 turns.
pub(crate) fn washer() -> Problem<4> {
    read("washer", Norm::Largest, include_str!("../../tests/data/two-hundred-turns.json"))
}

/// The same machine, speeding up with φ = t²/200 from rest through its resonance; 200 samples.
pub(crate) fn ramp() -> Problem<4> {
    read("ramp", Norm::Largest, include_str!("../../tests/data/through-resonance.json"))
}

/// A hoop pinned at 60°: ω along its axes, then the quaternion; 1000 samples, a little more than a period of ω apart.
pub(crate) fn hoop() -> Problem<7> {
    read("hoop", Norm::Turning, include_str!("../../tests/data/thousand-periods.json"))
}

/// The hoop pinned at 89.999°, next to the separatrix; otherwise as [`hoop`].
pub(crate) fn separatrix() -> Problem<7> {
    read("separatrix", Norm::Turning, include_str!("../../tests/data/near-separatrix.json"))
}

/// A rolling disk that wobbles, for 200 precessions: β, ω₁, ω₂, ω₃, heading, x, y of the contact, spin.
pub(crate) fn disk() -> Problem<8> {
    read("disk", Norm::Largest, include_str!("../../tests/data/rolling-two-hundred.json"))
}

/// The disk that rolls to rest over a film of air, from a tilt of 0.3 to 0.03; otherwise as [`disk`].
pub(crate) fn rest() -> Problem<8> {
    read("rest", Norm::Largest, include_str!("../../tests/data/rolling-to-rest.json"))
}

/// A tossed coin, ω = (3, 0, 1); 1000 samples, a little more than one nod apart.
pub(crate) fn toss() -> Problem<7> {
    read("toss", Norm::Turning, include_str!("../../tests/data/tossed-coin.json"))
}

/// A ring with spin 1 whose blow adds 0.1 across; otherwise as [`toss`].
pub(crate) fn station() -> Problem<7> {
    read("station", Norm::Turning, include_str!("../../tests/data/struck-station.json"))
}

/// A disc that spins down in air, ω along its axes through some 700 of its own nutations; 1000 samples.
pub(crate) fn drag() -> Problem<3> {
    read("drag", Norm::Largest, include_str!("../../tests/data/spun-down.json"))
}

/// A top under its weight, with its axis level at first, that draws loops; otherwise as [`toss`].
pub(crate) fn top() -> Problem<7> {
    read("top", Norm::Turning, include_str!("../../tests/data/thousand-nods.json"))
}

/// Rates of [`washer`].
#[inline]
pub(crate) fn washer_rates(t: f64, &[x, y, vx, vy]: &[f64; 4]) -> [f64; 4] {
    let (sin, cos) = (3.0 * t).sin_cos();
    [vx, vy, 9.0 * cos - x - 0.01 * vx, 9.0 * sin - y - 0.01 * vy]
}

/// Rates of [`ramp`].
#[inline]
pub(crate) fn ramp_rates(t: f64, &[x, y, vx, vy]: &[f64; 4]) -> [f64; 4] {
    let spin = 0.01 * t;
    let (sin, cos) = (0.5 * spin * t).sin_cos();
    let square = spin * spin;
    [vx, vy, square * cos + 0.01 * sin - x - 0.01 * vx, square * sin - 0.01 * cos - y - 0.01 * vy]
}

/// Rates of a quaternion, ½ q ω.
#[inline]
fn quaternion_rates([w1, w2, w3]: [f64; 3], [q0, q1, q2, q3]: [f64; 4]) -> [f64; 4] {
    let [a, b, c] = [0.5 * w1, 0.5 * w2, 0.5 * w3];
    [
        -(q1 * a + q2 * b + q3 * c),
        q0 * a + q2 * c - q3 * b,
        q0 * b + q3 * a - q1 * c,
        q0 * c + q1 * b - q2 * a,
    ]
}

/// Rates of [`hoop`] and [`separatrix`], whose moments are 3/2, 1/2 and 2.
#[inline]
pub(crate) fn hoop_rates(_t: f64, &[w1, w2, w3, q0, q1, q2, q3]: &[f64; 7]) -> [f64; 7] {
    let [a, b, c, d] = quaternion_rates([w1, w2, w3], [q0, q1, q2, q3]);
    [-w2 * w3, w3 * w1, 0.5 * w1 * w2, a, b, c, d]
}

/// Rates of [`toss`] and [`station`]: the moment about axis 3 is twice each of the others.
#[inline]
pub(crate) fn flat_rates(_t: f64, &[w1, w2, w3, q0, q1, q2, q3]: &[f64; 7]) -> [f64; 7] {
    let [a, b, c, d] = quaternion_rates([w1, w2, w3], [q0, q1, q2, q3]);
    [-w2 * w3, w3 * w1, 0.0, a, b, c, d]
}

/// Rates of [`top`]: moments 1, 1 and ½ about the fixed point, and a weight whose torque is 1 with a level axis.
#[inline]
pub(crate) fn top_rates(_t: f64, &[w1, w2, w3, q0, q1, q2, q3]: &[f64; 7]) -> [f64; 7] {
    let [a, b, c, d] = quaternion_rates([w1, w2, w3], [q0, q1, q2, q3]);
    [0.5 * w2 * w3 + 2.0 * (q2 * q3 + q0 * q1), -0.5 * w3 * w1 - 2.0 * (q1 * q3 - q0 * q2), 0.0, a, b, c, d]
}

/// Rates of [`drag`], with the moments 1/4, 1/4, 1/2 and the coefficient 1e-4 about each axis.
#[inline]
pub(crate) fn drag_rates(_t: f64, &[w1, w2, w3]: &[f64; 3]) -> [f64; 3] {
    const ACROSS: f64 = 1e-4 / 0.25;
    const ALONG: f64 = 1e-4 / 0.5;
    [-w2 * w3 - ACROSS * w1, w3 * w1 - ACROSS * w2, -ALONG * w3]
}

/// Moments of the disk, mass and radius being one.
const A: f64 = 0.25;
const C: f64 = 0.5;
/// The film of air of [`rest`].
const FILM: f64 = 1e-5;

/// Rates of [`disk`].
#[inline]
pub(crate) fn disk_rates(t: f64, state: &[f64; 8]) -> [f64; 8] {
    rolling_rates(0.0, t, state)
}

/// Rates of [`rest`].
#[inline]
pub(crate) fn rest_rates(t: f64, state: &[f64; 8]) -> [f64; 8] {
    rolling_rates(FILM, t, state)
}

#[inline]
fn rolling_rates(film: f64, _t: f64, &[beta, w1, w2, w3, psi, _, _, _]: &[f64; 8]) -> [f64; 8] {
    let (sin, cos) = beta.sin_cos();
    let turn = w2 / sin;
    let o3 = turn * cos;
    let (mut torque1, mut torque2) = (A * w2 * o3 - (C + 1.0) * w2 * w3 - cos, C * w1 * w3 - A * w1 * o3);
    if film != 0.0 {
        let drag = film / (sin * sin * sin);
        torque1 -= drag * w1;
        torque2 -= drag * w2;
    }
    let forward = o3 - w3;
    let (s, c) = psi.sin_cos();
    [w1, torque1 / (A + 1.0), torque2 / A, w1 * w2 / (C + 1.0), turn, forward * c, forward * s, -forward]
}

impl<const N: usize> Problem<N> {
    /// The error of a list of samples, one for each time: the largest over all samples with a reference
    /// value. NaN if a number is, or if there are not as many samples as times.
    pub(crate) fn error(&self, samples: &[[f64; N]]) -> f64 {
        if samples.len() != self.times.len() {
            return f64::NAN;
        }
        let errors = self.kept.iter().map(|kept| kept.error(&samples[kept.index], self.norm));
        errors.fold(0.0, |a: f64, b| if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) })
    }

    /// The time between samples.
    pub(crate) fn dt(&self) -> f64 {
        self.times[1]
    }

    /// The time of the last sample.
    pub(crate) fn end(&self) -> f64 {
        self.times[self.times.len() - 1]
    }
}

impl<const N: usize> Kept<N> {
    fn error(&self, state: &[f64; N], norm: Norm) -> f64 {
        let parts: [f64; N] = std::array::from_fn(|i| (state[i] - self.high[i]) - self.low[i]);
        match norm {
            Norm::Largest => {
                parts.iter().fold(0.0, |a: f64, b| if b.is_nan() { f64::NAN } else { a.max(b.abs()) })
            }
            Norm::Turning => {
                let omega = parts[0].hypot(parts[1]).hypot(parts[2]);
                // The vector part of q_ref⁻¹ q is that of q_ref⁻¹ (q − q_ref); its length is that of q times
                // sin of half the angle.
                let [a, b, c, d] = [3, 4, 5, 6].map(|i| self.high[i]);
                let [e, f, g, h] = [3, 4, 5, 6].map(|i| {
                    if a * state[3] + b * state[4] + c * state[5] + d * state[6] < 0.0 {
                        (-state[i] - self.high[i]) - self.low[i]
                    } else {
                        parts[i]
                    }
                });
                let vector = [
                    a * f - b * e - c * h + d * g,
                    a * g + b * h - c * e - d * f,
                    a * h - b * g + c * f - d * e,
                ];
                let scalar = 1.0 + a * e + b * f + c * g + d * h;
                let angle = 2.0 * vector[0].hypot(vector[1]).hypot(vector[2]).atan2(scalar);
                if omega.is_nan() || angle.is_nan() { f64::NAN } else { omega.max(angle) }
            }
        }
    }
}

/// A problem from its file in `tests/data`.
///
/// # Panics
/// If the file is not of the form that its README describes.
fn read<const N: usize>(name: &'static str, norm: Norm, text: &str) -> Problem<N> {
    let file: Value = serde_json::from_str(text).expect("a file of reference values is valid JSON");
    let row = |value: &Value| -> [f64; N] { std::array::from_fn(|i| value[i].as_f64().expect("a number")) };
    let rows = |key: &str| file[key].as_array().expect("a list of states");
    let samples = file["n"].as_u64().expect("the number of samples") as usize;
    let dt = file["dt"].as_f64().expect("the time between samples");
    let index: Vec<usize> = match file["index"].as_array() {
        Some(list) => list.iter().map(|i| i.as_u64().expect("an index") as usize).collect(),
        None => (0..=samples).collect(),
    };
    let (high, low) = (rows("grid_hi"), rows("grid_lo"));
    assert!(index.len() == high.len() && index.len() == low.len() && index.last() == Some(&samples));
    let kept = index.into_iter().zip(high.iter().zip(low));
    let kept = kept.map(|(index, (high, low))| Kept { index, high: row(high), low: row(low) }).collect();
    let times = (0..=samples).map(|i| i as f64 * dt).collect();
    Problem { name, start: row(&file["y0"]), times, norm, kept }
}

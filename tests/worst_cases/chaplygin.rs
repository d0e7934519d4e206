//! The two constants of a rolling wheel, and the angular velocities that follow from them at another tilt.

use crate::conical;
use crate::long::{Long, long};
use crate::search::{Case, Draw, keeps_its_promise};
use crate::taylor::System;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use std::f64::consts::FRAC_PI_2;

/// Units in the last place of the sums without their signs.
const PROMISE: f64 = 40.0;

/// Sine and cosine of the lean of a tilt, whose right angle is that of `f64`.
fn sin_cos_lean(tilt: f64) -> (Long, Long) {
    ((long(FRAC_PI_2) - tilt).sin_cos().0, long(tilt).sin_cos().0)
}

/// ω₂ and ω₃ at another tilt: dω₃/dθ = ω₂/(1 + I₃), dω₂/dθ = ω₂ tan θ + (I₃/I₁)ω₃, by series in y = artanh sin θ, in
/// which nothing is singular.
fn judge(moments: MomentFactors, from: &Rolling, other: f64) -> [Long; 2] {
    let (mut system, [omega_2, omega_3, sin, cos]) = System::new();
    let [one, transverse, axial] = [1.0, moments.transverse, moments.axial].map(long);
    let (cos_2, cos_3, sin_2) =
        (system.product(omega_2, cos), system.product(omega_3, cos), system.product(omega_2, sin));
    let (square, both) = (system.product(cos, cos), system.product(sin, cos));
    system.rate(omega_3, &[(one / (one + axial), cos_2)]);
    system.rate(omega_2, &[(one, sin_2), (axial / transverse, cos_3)]);
    system.rate(sin, &[(one, square)]);
    system.rate(cos, &[(-one, both)]);
    let (s, c) = sin_cos_lean(from.tilt);
    let way = artanh_sin_lean(other) - artanh_sin_lean(from.tilt);
    let end = system.sample(&[long(from.omega_2), long(from.omega_3), s, c], &[way]).remove(0);
    [end[0], end[1]]
}

fn artanh_sin_lean(tilt: f64) -> Long {
    let (sin, cos) = sin_cos_lean(tilt);
    let sign = if sin < long(0.0) { -1.0 } else { 1.0 };
    ((sin.abs() + 1.0) / cos).ln() * sign
}

/// Sizes of the even and the odd function at a tilt, and of their slopes times the cosine squared.
fn sizes(a: f64, tilt: f64) -> [f64; 4] {
    let (sin, cos) = sin_cos_lean(tilt);
    let gap = cos * cos / (sin.abs() + 1.0);
    let [e, de, o, d_o] = conical::judge(a, artanh_sin_lean(tilt).abs(), gap).map(Long::rounded);
    let square = (cos * cos).rounded();
    [e, de * square, o, d_o * square].map(f64::abs)
}

fn tilt(draw: &mut Draw<'_>) -> f64 {
    let sign = draw.one_of(&[-1.0, 1.0]);
    match draw.below(3) {
        0 => FRAC_PI_2 + sign * draw.between(0.0, 1.57),
        1 => FRAC_PI_2 + sign * draw.beside(std::f64::consts::FRAC_PI_6).min(1.57), // X = ½
        _ if sign > 0.0 => draw.decades(1e-12, 1.0),
        _ => std::f64::consts::PI - draw.decades(1e-12, 1.0),
    }
}

#[test]
fn the_constants_give_the_angular_velocities_at_any_other_tilt() {
    let ways = ["about the upright", "between upright and end", "from end to end", "near one end"];
    keeps_its_promise("constants", 300, &ways, |draw| {
        let transverse = draw.decades(1e-6, 10.0);
        let ratio = if draw.below(2) == 0 { 2.0 } else { draw.decades(1e-6, 2.0) };
        let moments = MomentFactors { transverse, axial: ratio * transverse };
        let wheel = Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 }).ok()?;
        let (from, to) = (tilt(draw), tilt(draw));
        let [omega_2, omega_3] = [draw.signed(1e-3, 10.0), draw.signed(1e-3, 10.0)];
        if omega_2 == 0.0 && omega_3 == 0.0 {
            return None;
        }
        let state = Rolling { tilt: from, omega_2, omega_3, ..Rolling::UPRIGHT };
        let ours = wheel.at_tilt(&wheel.constants(&state), to);
        let truth = judge(moments, &state, to);
        // The sums of the closed form without their signs: of each constant, and then of ω₃ and ω₂.
        let (rolling, a) = (1.0 + moments.axial, ratio / (1.0 + moments.axial));
        let ([e, de, o, d_o], slope) = (sizes(a, from), omega_2.abs() * from.sin() / rolling);
        let (even, odd) = (omega_3.abs() * d_o + slope * o, slope * e + omega_3.abs() * de);
        let [e, de, o, d_o] = sizes(a, to);
        let size = [rolling / to.sin() * (even * de + odd * d_o), even * e + odd * o];
        let error = |i: usize| (truth[i] - [ours.omega_2, ours.omega_3][i]).abs().rounded() / size[i];
        let near = |tilt: f64| tilt.cos().abs() > 0.5;
        let way = match (near(from), near(to), from.cos() * to.cos() > 0.0) {
            (true, true, true) => "near one end",
            (true, true, false) => "from end to end",
            (false, false, _) => "about the upright",
            _ => "between upright and end",
        };
        let said = format!("{moments:?}, from {state:?} to the tilt {to:?}: {ours:?}");
        Some(Case { ratio: error(0).max(error(1)) / (PROMISE * f64::EPSILON), way, said })
    });
}

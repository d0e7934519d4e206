//! Closed forms without a time: steady rolling, the turn of a wheel that is almost flat, the tilt for a speed, the
//! balanced engine.

use crate::long::{Long, PI, long};
use crate::search::{Case, keeps_its_promise, worse};
use mechanics::rolling::{DiskParameters, MomentFactors};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::wobble_plate::{Engine, PistonParameters, Pistons, Plate, PlateParameters};
use std::f64::consts::FRAC_PI_2;

/// Units in the last place.
const FEW: f64 = 4.0 * f64::EPSILON;

#[test]
fn steady_rolling_balances_torque_and_momentum_and_wobbles_as_the_motion_does() {
    keeps_its_promise("steady rolling", 4000, &["any circle", "near the bound"], |draw| {
        let moments = match draw.below(3) {
            0 => draw.one_of(&[MomentFactors::DISK, MomentFactors::HOOP]),
            1 => MomentFactors::flat(draw.decades(1e-10, 1.0)),
            _ => {
                let transverse = draw.decades(1e-10, 10.0);
                MomentFactors { transverse, axial: transverse * draw.decades(1e-6, 2.0) }
            }
        };
        let MomentFactors { transverse, axial } = moments;
        let (radius, gravity) = (draw.decades(1e-3, 1e3), draw.decades(1e-3, 1e3));
        let sign = draw.one_of(&[-1.0, 1.0]);
        let lean = sign
            * match draw.below(3) {
                0 => draw.between(1e-6, FRAC_PI_2 - 1e-6),
                1 => draw.decades(1e-40, 1.0),
                _ => FRAC_PI_2 - draw.decades(1e-15, 1.0),
            };
        let bound = -transverse * radius * lean.sin() / (1.0 + axial);
        let (b, way) = match draw.below(2) {
            0 => (draw.beside(bound), "near the bound"),
            _ => (radius * draw.signed(1e-6, 1e6), "any circle"),
        };
        let wheel = Wheel::new(DiskParameters { mass: 1.0, radius, moments, gravity }).ok()?;
        let steady = wheel.steady(lean, b).ok()?;
        // Per mass and square of the radius, along axis 1: Ωẑ × L with L₂ = I₁Ω cos θ, L₃ = I₃Ωb/a, and r × F with the
        // force −Ω²b inward and g upward.
        let ((s, c), ratio) = (long(lean).sin_cos(), long(b) / radius);
        let [i1, i3] = [transverse, axial].map(long);
        let momentum = i3 * ratio * c + i1 * s * c;
        let forces = ratio * c;
        let square = long(gravity) / radius * s / (momentum + forces);
        let parts = (momentum.abs() + forces.abs()) / (momentum + forces).abs();
        let lost =
            (i3 * (ratio * c).abs() + i1 * (s * c).abs() + (ratio * c).abs()) / (momentum + forces).abs();
        let lost = lost.rounded().max(parts.rounded());
        if lost > 0.1 / f64::EPSILON {
            return None; // the bound itself, to rounding, and nothing is left
        }
        let turn = square.sqrt();
        let turn_error = turn.off(steady.turn_rate()) / (1.0 + lost);
        let spin_error = (turn * (ratio + s) - steady.relative_spin()).abs().rounded()
            / (turn * (ratio.abs() + s.abs())).rounded()
            / (1.0 + lost);
        // −dθ̈/dθ along the motions of the same two constants, whose q and n change by dq/dθ = q tan θ + (I₃/I₁)n and
        // dn/dθ = q/(1 + I₃).
        let (q, n, tan) = (turn * c, turn * ratio, s / c);
        let (dq, dn) = (q * tan + n * i3 / i1, q / (i3 + 1.0));
        let terms = [
            -(long(gravity) / radius * c),
            (i3 + 1.0) * dn * q,
            (i3 + 1.0) * n * dq,
            i1 * 2.0 * q * dq * tan,
            i1 * q * q,
            i1 * q * q * tan * tan,
        ]
        .map(|term| term / (i1 + 1.0));
        let sum: Long = terms.into_iter().sum();
        // The largest term of the formula.
        let size = [
            c * c + i1 * s * s * 3.0,
            ratio * (i3 * 3.0 + 1.0) * s,
            ratio * (i3 + 1.0) * c * c / s,
            (i3 + 1.0) * i3 / i1 * ratio * ratio,
        ]
        .map(|term| (square * term / (i1 + 1.0)).abs().rounded())
        .into_iter()
        .fold(0.0, f64::max);
        let wobble_error = (sum - steady.wobble_square()).abs().rounded() / size / (1.0 + lost);
        let said = format!(
            "{moments:?}, a {radius:?}, g {gravity:?}, lean {lean:?}, b {b:?}: {turn_error:e} {spin_error:e} {wobble_error:e}, {lost}"
        );
        // And twice as much of the wobble.
        Some(Case { ratio: worse(worse(turn_error, spin_error), 0.5 * wobble_error) / FEW, way, said })
    });
}

#[test]
fn the_turn_of_a_wheel_that_is_almost_flat_has_all_its_digits() {
    keeps_its_promise("near-flat turn", 1000, &["any wheel"], |draw| {
        let transverse = draw.decades(1e-50, 10.0);
        let turn = PI * (long(1.0) / transverse + 1.0).sqrt();
        let moments = MomentFactors { transverse, axial: transverse };
        let wheel = Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 }).ok()?;
        let found = wheel.near_flat_turn();
        let error = turn.off(found);
        let said = format!("I₁ {transverse:?}: {found:?}");
        Some(Case { ratio: error / (2.0 * f64::EPSILON), way: "any wheel", said })
    });
}

#[test]
fn the_lean_from_which_on_all_circles_are_stable_has_all_its_digits() {
    keeps_its_promise("safe lean", 2000, &["any wheel"], |draw| {
        let transverse = draw.decades(1e-10, 10.0);
        let axial = transverse * draw.decades(1e-6, 2.0);
        let moments = MomentFactors { transverse, axial };
        let wheel = Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments, gravity: 1.0 }).ok()?;
        let found = wheel.safe_lean();
        // The quadratic for sin²θ, and one step of Newton's method.
        let [i1, i3] = [transverse, axial].map(long);
        let (s, c) = long(found).sin_cos();
        let square = s * s;
        let bracket = (square * 2.0 - 1.0) * (i3 + 1.0) + i3 * square * 2.0;
        let rest = (square * (i1 * 3.0 - 1.0) + 1.0) * square;
        let value = bracket * bracket - i3 / i1 * (i3 + 1.0) * rest * 4.0;
        let slope = bracket * (i3 * 2.0 + 1.0) * 4.0
            - i3 / i1 * (i3 + 1.0) * ((i1 * 3.0 - 1.0) * square * 2.0 + 1.0) * 4.0;
        let error = (value / (slope * s * c * 2.0)).abs().rounded() / found;
        Some(Case { ratio: error / FEW, way: "any wheel", said: format!("{moments:?}: {found:?}") })
    });
}

#[test]
fn a_balanced_engine_shakes_by_rounding_only() {
    keeps_its_promise("balanced engine", 1000, &["few", "many"], |draw| {
        let tilt = match draw.below(3) {
            0 => draw.between(0.01, 1.5),
            1 => draw.decades(1e-20, 1.0),
            _ => FRAC_PI_2 - draw.decades(1.75e-4, 1.0), // 89.99°
        };
        let radius = draw.decades(1e-3, 1e3);
        let mass = draw.decades(1e-3, 1e3);
        let thickness = radius * draw.signed(1e-3, 1.7).abs();
        let plate = Plate::new(PlateParameters { mass, radius, thickness, tilt }).ok()?;
        let (count, way) =
            if draw.below(2) == 0 { (3 + draw.below(8), "few") } else { (3 + draw.below(998), "many") };
        let (count, distance) = (u32::try_from(count).ok()?, draw.decades(1e-3, 1e3));
        let pistons = Pistons::new(PistonParameters { count, mass: 1.0, distance, rod: 0.1 }).ok()?;
        let engine = Engine::new(plate, pistons.with_mass(plate.balancing_mass(&pistons).ok()?).ok()?);
        let (phase, spin) = (draw.between(-10.0, 10.0), draw.decades(1e-3, 1e3));
        let own = plate.bearing_torque_rotating(spin).norm();
        let error = engine.frame_torque(phase, spin).norm() / own;
        let promise = if count <= 10 { 2e-15 } else { 1e-14 };
        let said = format!("{count} pistons, tilt {tilt:?}, phase {phase:?}: {engine:?}");
        Some(Case { ratio: error / promise, way, said })
    });
}

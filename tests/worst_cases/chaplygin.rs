//! The two constants of a rolling wheel, and the angular velocities that follow from them at another lean.

use crate::conical;
use crate::long::{Long, long};
use crate::search::{Case, Draw, search};
use crate::taylor::System;
use mechanics::scenes::rolling_wheel::{Rolling, Wheel};
use std::f64::consts::FRAC_PI_2;

/// Units in the last place of the sums without their signs.
const PROMISE: f64 = 40.0;

/// q and n at another lean: dn/dθ = q/(1 + k), dq/dθ = q tan θ + 2n, by series in y = artanh sin θ, in which nothing is singular.
fn judge(k: f64, lean: f64, [q, n]: [f64; 2], other: f64) -> [Long; 2] {
    let (mut system, [across, along, sin, cos]) = System::new();
    let one = long(1.0);
    let (q_cos, n_cos, q_sin) =
        (system.product(across, cos), system.product(along, cos), system.product(across, sin));
    let (square, both) = (system.product(cos, cos), system.product(sin, cos));
    system.rate(along, &[(one / (one + k), q_cos)]);
    system.rate(across, &[(one, q_sin), (long(2.0), n_cos)]);
    system.rate(sin, &[(one, square)]);
    system.rate(cos, &[(-one, both)]);
    let (s, c) = long(lean).sin_cos();
    let end = system.sample(&[long(q), long(n), s, c], &[artanh_sin(other) - artanh_sin(lean)]).remove(0);
    [end[0], end[1]]
}

fn artanh_sin(lean: f64) -> Long {
    let (sin, cos) = long(lean.abs()).sin_cos();
    ((sin + 1.0) / cos).ln() * lean.signum()
}

/// Sizes of the even and the odd function at a lean, and of their slopes times the cosine squared.
fn sizes(k: f64, lean: f64) -> [f64; 4] {
    let (sin, cos) = long(lean.abs()).sin_cos();
    let gap = cos * cos / (sin + 1.0);
    let [e, de, o, d_o] = conical::judge(2.0 / (1.0 + k), artanh_sin(lean.abs()), gap).map(Long::rounded);
    let square = (cos * cos).rounded();
    [e, de * square, o, d_o * square].map(f64::abs)
}

fn lean(draw: &mut Draw<'_>) -> f64 {
    let sign = draw.one_of(&[-1.0, 1.0]);
    let size = match draw.below(3) {
        0 => draw.between(0.0, 1.57),
        1 => draw.beside(std::f64::consts::FRAC_PI_6).min(1.57), // X = ½
        _ => FRAC_PI_2 - draw.decades(1e-12, 1.0),
    };
    sign * size
}

#[test]
fn the_constants_give_the_angular_velocities_at_any_other_lean() {
    let worst = search("constants", 300, |draw| {
        let k = draw.decades(1e-6, 1.0);
        let wheel = Wheel::new(1.0, 1.0, k, 1.0).ok()?;
        let (from, to) = (lean(draw), lean(draw));
        let [q, n] = [draw.signed(1e-3, 10.0), draw.signed(1e-3, 10.0)];
        if q == 0.0 && n == 0.0 {
            return None;
        }
        let state = Rolling {
            lean: from,
            lean_rate: 0.0,
            across: q,
            along: n,
            heading: 0.0,
            spin: 0.0,
            centre: [0.0; 2],
        };
        let ours = wheel.at_lean(&wheel.constants(&state), to);
        let truth = judge(k, from, [q, n], to);
        // The sums of the closed form without their signs: of each constant, and then of n and q.
        let ([e, de, o, d_o], q_part) = (sizes(k, from), q.abs() * from.cos() / (1.0 + k));
        let (even, odd) = (n.abs() * d_o + q_part * o, q_part * e + n.abs() * de);
        let [e, de, o, d_o] = sizes(k, to);
        let size = [(1.0 + k) / to.cos() * (even * de + odd * d_o), even * e + odd * o];
        let error = |i: usize| (truth[i] - ours[i]).abs().rounded() / size[i];
        let near = |lean: f64| lean.abs() > std::f64::consts::FRAC_PI_6;
        let way = match (near(from), near(to), from * to > 0.0) {
            (true, true, true) => "near one end",
            (true, true, false) => "from end to end",
            (false, false, _) => "about the upright",
            _ => "between upright and end",
        };
        Some(Case {
            ratio: error(0).max(error(1)) / (PROMISE * f64::EPSILON),
            way,
            said: format!("k {k:?}, from lean {from:?} with q, n {:?} to {to:?}: {ours:?}", [q, n]),
        })
    });
    worst.keeps_its_promise(&[
        "about the upright",
        "between upright and end",
        "from end to end",
        "near one end",
    ]);
}
